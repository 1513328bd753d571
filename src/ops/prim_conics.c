/* prim_conics.c - a torus and what has its axis: surfaces of revolution of
 * conics.
 *
 * In the half plane of radius and height the torus is a circle with the centre
 * F and the radius r. Its distances are those of F less r, and so
 *
 *   a line n.X = h       |XF| = |n.X - h -+ r|   a parabola for each side
 *   a circle F2, r2      |XF| - |XF2| = r - r2   a branch of a hyperbola
 *                        |XF| + |XF2| = r + r2   an ellipse
 *
 * of which the parts of positive radius are turned. */
#include <math.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "ops/prim.h"

/* --- parts of positive radius ----------------------------------------------
 */

/* The zeros in (0, 1) of the quadratic with the Bernstein coefficients b, in
 * order. */
static int zeros_of(const double b[3], double t[2])
{
    double a2 = b[0] - 2.0 * b[1] + b[2], a1 = b[1] - b[0],
           disc = b[1] * b[1] - b[0] * b[2], q, x[2];
    int n = 0;

    if (!(disc > 0.0))
        return 0;
    q = a1 < 0.0 ? -a1 + sqrt(disc) : -a1 - sqrt(disc);
    x[0] = q / a2;
    x[1] = b[0] / q;
    for (int k = 0; k < 2; k++)
        if (x[k] > 0.0 && x[k] < 1.0)
            t[n++] = x[k];
    if (n == 2 && t[0] > t[1]) {
        t[0] = x[1];
        t[1] = x[0];
    }
    return n;
}

static double value_at(const double b[3], double t)
{
    double u = 1.0 - t;

    return u * u * b[0] + 2.0 * u * t * b[1] + t * t * b[2];
}

static ix_status turn_part(ix_ctx *ctx, const ix_prim *axis, const ix_mv *arc,
                           double lo, double hi, ix__prim_set *s)
{
    ix_mv *part;
    ix_status st;

    IX_TRY(ix_mv_region(ctx, arc, 0, lo, hi, &part));
    st = ix__prim_turned(ctx, axis, part, s);
    ix_mv_unref(ctx, part);
    return st;
}

/* The arc with positive weights, w, radius and height by Bernstein coefficients
 * on [0, 1]. */
static ix_status turn_arc(ix_ctx *ctx, const ix_prim *axis, double q[3][3],
                          ix__prim_set *s)
{
    const ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    double pts[12] = {0}, t[4] = {0.0};
    int n = 1 + zeros_of(q[1], t + 1);
    ix_status st = IX_OK;
    ix_mv *arc;

    t[n] = 1.0;
    for (int i = 0; i < 3; i++) {
        pts[i] = q[0][i];
        pts[3 + i] = q[1][i];
        pts[9 + i] = q[2][i];
    }
    IX_TRY(ix_mv_new(ctx, 1, &d, 3, true, pts, &arc));
    for (int i = 0; i < n && st == IX_OK; i++)
        if (t[i + 1] - t[i] > IX__ONE_POINT &&
            value_at(q[1], 0.5 * (t[i] + t[i + 1])) > 0.0)
            st = turn_part(ctx, axis, arc, t[i], t[i + 1], s);
    ix_mv_unref(ctx, arc);
    return st;
}

static ix_status check_any(ix_ctx *ctx, const ix__prim_set *s, double size)
{
    if (s->n > 0)
        return IX_OK;
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "no point of the bisector within %g of the torus: a larger "
                   "size is needed",
                   size);
}

/* --- a line -----------------------------------------------------------------
 */

/* The points as far from f as from the line n.X = n.f - p: f + t m + y n with
 * 2 p y = t^2 - p^2, |t| <= size; p = 0: the line along n through f. */
static ix_status parabola(ix_ctx *ctx, const ix_prim *axis, const double f[2],
                          const double n[2], double p, double size,
                          ix__prim_set *s)
{
    const double m[2] = {-n[1], n[0]}, y[3] = {0.5 * (size * size / p - p),
                                               -0.5 * (size * size / p + p),
                                               0.5 * (size * size / p - p)};
    double q[3][3];

    for (int i = 0; i < 3; i++) {
        double t = (i - 1) * size, up = p == 0.0 ? t : y[i];

        q[0][i] = 1.0;
        for (int k = 0; k < 2; k++)
            q[k + 1][i] = f[k] + (p == 0.0 ? 0.0 : t * m[k]) + up * n[k];
    }
    return turn_arc(ctx, axis, q, s);
}

ix_status ix__prim_torus_line(ix_ctx *ctx, const ix_prim *torus,
                              const ix_prim *b, double size, ix__prim_set *s)
{
    const double f[2] = {torus->major, 0.0};
    double n[3], at, tie;

    ix__prim_profile(torus, b, n);
    at = n[0] * f[0] - n[2];
    tie = IX__ONE_POINT * (size + torus->major + fabs(n[2]));
    for (int side = 1; side >= -1; side -= 2) {
        double p = at + side * torus->radius;

        /* beyond, only the far side of the torus is as far as the line */
        if (torus->radius > tie ? side * p < -tie : side < 0)
            continue;
        IX_TRY(parabola(ctx, torus, f, n, fabs(p) > tie ? p : 0.0, size, s));
    }
    return check_any(ctx, s, size);
}

/* --- a circle ---------------------------------------------------------------
 */

/* Two points of the half plane: o between them, x from the first to the second,
 * each at the distance f from o. */
typedef struct {
    double f1[2], f2[2], o[2], x[2], f;
} foci;

static void foci_of(const ix_prim *a, const ix_prim *b, double tie, foci *k)
{
    double e[2];

    *k = (foci){.f1 = {a->major, 0.0},
                .f2 = {b->major, ix__prim_height(a, b)},
                .x = {1.0, 0.0}};
    for (int i = 0; i < 2; i++) {
        k->o[i] = 0.5 * (k->f1[i] + k->f2[i]);
        e[i] = k->f2[i] - k->f1[i];
    }
    k->f = 0.5 * hypot(e[0], e[1]);
    if (!(k->f > tie))
        k->f = 0.0;
    for (int i = 0; i < 2 && k->f > 0.0; i++)
        k->x[i] = 0.5 * e[i] / k->f;
}

/* x = a sqrt(1 + y^2 / b^2), |y| <= size, as in prim_parallel.c. */
static ix_status hyperbola(ix_ctx *ctx, const ix_prim *axis, const foci *k,
                           double a, double size, ix__prim_set *s)
{
    double b = sqrt((k->f - fabs(a)) * (k->f + fabs(a))),
           e = hypot(1.0, size / b);
    const double w[3] = {1.0, e, 1.0}, x[3] = {a * e, a, a * e},
                 y[3] = {-size, 0.0, size};
    double q[3][3];

    for (int i = 0; i < 3; i++) {
        q[0][i] = w[i];
        q[1][i] = w[i] * k->o[0] + x[i] * k->x[0] - y[i] * k->x[1];
        q[2][i] = w[i] * k->o[1] + x[i] * k->x[1] + y[i] * k->x[0];
    }
    return turn_arc(ctx, axis, q, s);
}

/* The ellipse by the unit circle, from the point of least radius on: e[0] and
 * e[1] are the images of both axes, turned by the angle of (c, d). */
static double ellipse_matrix(const foci *k, double a, double m[16])
{
    double b = sqrt((a - k->f) * (a + k->f)),
           e[2][2] = {{a * k->x[0], a * k->x[1]}, {-b * k->x[1], b * k->x[0]}},
           reach = hypot(e[0][0], e[1][0]), c = -e[0][0] / reach,
           d = -e[1][0] / reach;

    for (int i = 0; i < 16; i++)
        m[i] = 0.0;
    for (int i = 0; i < 2; i++) {
        m[2 * i] = c * e[0][i] + d * e[1][i];
        m[4 + 2 * i] = c * e[1][i] - d * e[0][i];
        m[12 + 2 * i] = k->o[i];
    }
    m[15] = 1.0;
    return reach;
}

static ix_status ellipse(ix_ctx *ctx, const ix_prim *axis, const foci *k,
                         double a, ix__prim_set *s)
{
    static const double zero[3] = {0, 0, 0};
    double m[16], reach = ellipse_matrix(k, a, m),
                  lo = k->o[0] < reach ? IX__DEG(acos(k->o[0] / reach)) : 0.0;
    ix_mv *circle, *curve;
    ix_status st;

    IX_TRY(ix_circle(ctx, zero, 1.0, &circle));
    st = ix_mv_transform(ctx, circle, m, &curve);
    ix_mv_unref(ctx, circle);
    IX_TRY(st);
    st = lo > 0.0 ? turn_part(ctx, axis, curve, ix_circle_param(lo),
                              ix_circle_param(360.0 - lo), s)
                  : ix__prim_turned(ctx, axis, curve, s);
    ix_mv_unref(ctx, curve);
    return st;
}

ix_status ix__prim_coaxial_tori(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                                double size, ix__prim_set *s)
{
    double half_gap = 0.5 * (a->radius - b->radius),
           half_sum = 0.5 * (a->radius + b->radius),
           tie = IX__ONE_POINT * (size + ix__len3(a->pos) + ix__len3(b->pos) +
                                  a->major + b->major);
    foci k;

    foci_of(a, b, tie, &k);
    if (k.f == 0.0 && !(fabs(half_gap) > tie))
        return IX_FAIL(ctx, IX_EDOMAIN, "both are one torus");
    if (fabs(half_gap) < k.f - tie)
        IX_TRY(fabs(half_gap) > tie
                   ? hyperbola(ctx, a, &k, half_gap, size, s)
                   : ix__prim_halfway(ctx, a, k.f1, k.f2, size, s));
    if (half_sum > k.f + tie)
        IX_TRY(ellipse(ctx, a, &k, half_sum, s));
    return check_any(ctx, s, size);
}
