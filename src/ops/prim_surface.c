/* prim_surface.c - primitives as rational surfaces. All but the plane are
 * curves of the local xz plane turned about z. */
#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "ops/prim.h"

ix_status ix__prim_axes(ix_ctx *ctx, const ix_prim *p, ix_prim_axes *out)
{
    IX_TRY(ix__direction(ctx, "the direction", p->dir, out->z));
    ix__perp3(out->z, out->x);
    ix__cross3(out->z, out->x, out->y);
    return IX_OK;
}

ix_status ix__prim_place(ix_ctx *ctx, const ix_prim *p, const ix_mv *local,
                         ix_mv **out)
{
    ix_prim_axes a = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double m[16] = {0};

    if (p->kind != IX_PRIM_SPHERE)
        IX_TRY(ix__prim_axes(ctx, p, &a));
    for (int k = 0; k < 3; k++) {
        m[k] = a.x[k];
        m[4 + k] = a.y[k];
        m[8 + k] = a.z[k];
        m[12 + k] = p->pos[k];
    }
    m[15] = 1;
    return ix_mv_transform(ctx, local, m, out);
}

static ix_status segment(ix_ctx *ctx, double x0, double z0, double x1,
                         double z1, ix_mv **out)
{
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    const double pts[6] = {x0, x1, 0, 0, z0, z1};

    return ix_mv_new(ctx, 1, &d, 3, false, pts, out);
}

/* From (0, 0, -r) over (r, 0, 0) to (0, 0, r). */
static ix_status half_circle(ix_ctx *ctx, double r, ix_mv **out)
{
    static const double kv[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    const ix_dir d = {IX_BSPLINE, 3, 5, false, kv};
    const double s = sqrt(0.5), q = s * r;
    const double pts[20] = {1, s, 1, s, 1, 0,  q,  r, q, 0,
                            0, 0, 0, 0, 0, -r, -q, 0, q, r};

    return ix_mv_new(ctx, 1, &d, 3, true, pts, out);
}

/* Around (major, 0, 0) in the xz plane. */
static ix_status upright_circle(ix_ctx *ctx, double major, double r,
                                ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    const double m[16] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, major, 0, 0, 1};
    ix_mv *c;
    ix_status st;

    IX_TRY(ix_circle(ctx, zero, r, &c));
    st = ix_mv_transform(ctx, c, m, out);
    ix_mv_unref(ctx, c);
    return st;
}

static ix_status square(ix_ctx *ctx, double h, ix_mv **out)
{
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    const double pts[12] = {-h, h, -h, h, -h, -h, h, h, 0, 0, 0, 0};

    return ix_mv_new(ctx, 2, d, 3, false, pts, out);
}

static ix_status generator(ix_ctx *ctx, const ix_prim *p, double size,
                           ix_mv **out)
{
    double t;

    switch (p->kind) {
    case IX_PRIM_CYLINDER:
        return segment(ctx, p->radius, -size, p->radius, size, out);
    case IX_PRIM_CONE:
        t = tan(IX__RADIANS(p->degrees));
        return segment(ctx, 0, 0, size * t, size, out);
    case IX_PRIM_SPHERE:
        return half_circle(ctx, p->radius, out);
    default:
        return upright_circle(ctx, p->major, p->radius, out);
    }
}

ix_status ix__prim_surface(ix_ctx *ctx, const ix_prim *p, double size,
                           ix_mv **out)
{
    ix_mv *g, *s;
    ix_status st;

    if (p->kind == IX_PRIM_PLANE) {
        IX_TRY(square(ctx, size, &s));
    } else {
        IX_TRY(generator(ctx, p, size, &g));
        st = ix_srf_revolve(ctx, g, IX_TURN_RATIONAL, &s);
        ix_mv_unref(ctx, g);
        IX_TRY(st);
    }
    st = ix__prim_place(ctx, p, s, out);
    ix_mv_unref(ctx, s);
    return st;
}
