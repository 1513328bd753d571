/* prim_coaxial.c - surfaces around one axis. In the half plane of radius and
 * height a cylinder, a cone, a plane at a right angle to the axis is a line
 * n.X = h, and of cylinders and cones the lines of equal distances (n1 - n2).X
 * = h1 - h2, (n1 + n2).X = h1 + h2 turn into cones. */
#include <assert.h>
#include <math.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "ops/prim.h"

double ix__prim_height(const ix_prim *a, const ix_prim *p)
{
    double e[3];

    ix__sub3(p->pos, a->pos, e);
    return ix__dot3(e, a->dir);
}

void ix__prim_profile(const ix_prim *a, const ix_prim *p, double n[3])
{
    double t = IX__RADIANS(p->degrees),
           up = ix__dot3(a->dir, p->dir) < 0 ? -1.0 : 1.0;

    switch (p->kind) {
    case IX_PRIM_PLANE:
        n[0] = 0.0;
        n[1] = up;
        n[2] = up * ix__prim_height(a, p);
        break;
    case IX_PRIM_CONE:
        n[0] = cos(t);
        n[1] = -up * sin(t);
        n[2] = n[1] * ix__prim_height(a, p);
        break;
    default:
        n[0] = 1.0;
        n[1] = 0.0;
        n[2] = p->radius;
    }
}

/* The part of the line m.X = h within size of its point next to (0, z), and of
 * positive radius; false if there is none. */
static bool clip(const double m[3], double z, double size, double x[2][2])
{
    double len = hypot(m[0], m[1]), h, lo = -size, hi = size, at;

    if (!(len > IX__PARALLEL))
        return false;
    h = (m[2] - m[1] * z) / len;
    /* X = (0, z) + h m + t (m1, -m0), m of length 1 */
    if (fabs(m[1]) > IX__PARALLEL * len) {
        at = -h * m[0] / m[1];
        if (m[1] > 0)
            lo = fmax(lo, at);
        else
            hi = fmin(hi, at);
    } else if (!(h * m[0] > IX__ONE_POINT * size * len)) {
        return false;
    }
    if (!(lo < hi))
        return false;
    for (int k = 0; k < 2; k++) {
        double t = k ? hi : lo;

        x[k][0] = fmax(0.0, (h * m[0] + t * m[1]) / len);
        x[k][1] = z + (h * m[1] - t * m[0]) / len;
    }
    return true;
}

ix_status ix__prim_turned(ix_ctx *ctx, const ix_prim *axis,
                          const ix_mv *profile, ix__prim_set *s)
{
    ix_mv *local;
    ix_status st;

    IX_TRY(ix_srf_revolve(ctx, profile, IX_TURN_RATIONAL, &local));
    st = ix__prim_place(ctx, axis, local, &s->srf[s->n]);
    ix_mv_unref(ctx, local);
    IX_TRY(st);
    s->n++;
    return IX_OK;
}

static ix_status turned(ix_ctx *ctx, const ix_prim *axis, double x[2][2],
                        ix__prim_set *s)
{
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    const double pts[6] = {x[0][0], x[1][0], 0, 0, x[0][1], x[1][1]};
    ix_mv *g;
    ix_status st;

    IX_TRY(ix_mv_new(ctx, 1, &d, 3, false, pts, &g));
    st = ix__prim_turned(ctx, axis, g, s);
    ix_mv_unref(ctx, g);
    return st;
}

bool ix__prim_is_coaxial(const ix_prim *a, const ix_prim *b, double size)
{
    double e[3];

    ix__prim_offset(a, b->pos, e);
    return ix__prim_parallel(a->dir, b->dir) &&
           ix__prim_touch(ix__len3(e), a->pos, b->pos, size);
}

ix_status ix__prim_coaxial(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                           double size, ix__prim_set *s)
{
    double n1[3], n2[3], m[3], x[2][2], same = 0.0;

    ix__prim_profile(a, a, n1);
    ix__prim_profile(a, b, n2);
    for (int k = 0; k < 3; k++)
        same = fmax(same, fabs(n1[k] - n2[k]));
    if (!(same > IX__ONE_POINT * (1.0 + size)))
        return IX_FAIL(ctx, IX_EDOMAIN, "both are one surface");
    for (int sign = -1; sign <= 1; sign += 2) {
        ix__axpy3(n1, sign, n2, m);
        if (clip(m, 0.5 * ix__prim_height(a, b), size, x))
            IX_TRY(turned(ctx, a, x, s));
    }
    /* of the points next to the middle of both apexes one has a radius that is
     * not negative */
    assert(s->n > 0);
    return IX_OK;
}

/* The points of the half plane next to two others: the line halfway. */
ix_status ix__prim_halfway(ix_ctx *ctx, const ix_prim *axis, const double f1[2],
                           const double f2[2], double size, ix__prim_set *s)
{
    double m[3] = {f2[0] - f1[0], f2[1] - f1[1], 0.0}, x[2][2];

    for (int k = 0; k < 2; k++)
        m[2] += 0.5 * m[k] * (f1[k] + f2[k]);
    return clip(m, 0.5 * (f1[1] + f2[1]), size, x) ? turned(ctx, axis, x, s)
                                                   : IX_OK;
}
