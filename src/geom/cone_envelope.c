/* cone_envelope.c - see the header. */
#include "geom/cone_envelope.h"

#include <math.h>

#include "geom/angle.h"
#include "geom/matrix.h"
#include "geom/parts.h"
#include "iritx/geom_srf.h"
#include "iritx/offset.h"

/* The planar curve in space, at height z. */
static ix_status lifted(ix_ctx *ctx, const ix_mv *c, double z, ix_mv **out)
{
    const double up[3] = {0, 0, z};
    double mat[16];
    ix_mv *wide;
    ix_status st;

    ix__mat_translate(up, mat);
    IX_TRY(ix_mv_coerce(ctx, c, 3, c->rational, &wide));
    st = ix_mv_transform(ctx, wide, mat, out);
    ix_mv_unref(ctx, wide);
    return st;
}

/* The side at distance d (to the right); reversed on demand. c is planar. */
static ix_status side(ix_ctx *ctx, const ix_mv *c, double d, double tol,
                      bool reversed, ix_mv *t[4], ix_mv **out)
{
    const ix_offset_opts o = {.distance = d, .tol = tol};

    IX_TRY(ix_crv_offset(ctx, c, &o, NULL, &t[0]));
    IX_TRY(lifted(ctx, t[0], fabs(d), &t[1]));
    IX_TRY(lifted(ctx, c, 0, &t[2]));
    IX_TRY(ix_srf_ruled(ctx, t[2], t[1], &t[3]));
    if (reversed)
        return ix_mv_reverse(ctx, t[3], 0, out);
    *out = ix_mv_ref(t[3]);
    return IX_OK;
}

static ix_status make_side(ix_ctx *ctx, const ix_mv *c, double d, double tol,
                           bool reversed, ix_mv **out)
{
    ix_mv *t[4] = {NULL};
    ix_status st = side(ctx, c, d, tol, reversed, t, out);

    ix__mv_unref_all(ctx, t, 4);
    return st;
}

/* The half cone from the right side to the left at the end of c, or from left
 * to right at its start. */
static ix_status half_cone(ix_ctx *ctx, const ix_mv *c, bool end, double h,
                           ix_mv *t[3], ix_mv **out)
{
    double dom[2], p[IX_MAX_COORDS] = {0}, dir[3], a, zero[16] = {[15] = 1};
    double center[3];

    ix_mv_domain(c, 0, dom);
    IX_TRY(ix_mv_point(ctx, c, &dom[end], p));
    IX_TRY(ix_tangent(ctx, c, dom[end], true, dir));
    a = IX__DEG(atan2(dir[1], dir[0])) + (end ? -90 : 90);
    center[0] = p[0];
    center[1] = p[1];
    center[2] = h;
    IX_TRY(ix_arc_angles(ctx, center, h, a, a + 180, &t[0]));
    zero[12] = p[0]; /* every point to the apex */
    zero[13] = p[1];
    IX_TRY(ix_mv_transform(ctx, t[0], zero, &t[1]));
    return ix_srf_ruled(ctx, t[1], t[0], out);
}

static ix_status open_parts(ix_ctx *ctx, const ix_mv *c, double h, double tol,
                            ix_mv *part[4], ix_mv *t[6])
{
    IX_TRY(make_side(ctx, c, h, tol, false, &part[0]));
    IX_TRY(half_cone(ctx, c, true, h, t, &part[1]));
    IX_TRY(make_side(ctx, c, -h, tol, true, &part[2]));
    return half_cone(ctx, c, false, h, t + 3, &part[3]);
}

static ix_status open_envelope(ix_ctx *ctx, const ix_mv *c, double h,
                               double tol, ix_mv **out)
{
    ix_mv *part[4] = {NULL}, *t[6] = {NULL}, *sum[4] = {NULL};
    ix_status st = open_parts(ctx, c, h, tol, part, t);

    if (st == IX_OK)
        sum[0] = ix_mv_ref(part[0]);
    for (int i = 1; st == IX_OK && i < 4; i++)
        st = ix_mv_merge(ctx, sum[i - 1], part[i], 0, IX_JOIN_SHARED, &sum[i]);
    if (st == IX_OK)
        *out = ix_mv_ref(sum[3]);
    ix__mv_unref_all(ctx, part, 4);
    ix__mv_unref_all(ctx, t, 6);
    ix__mv_unref_all(ctx, sum, 4);
    return st;
}

static ix_status is_closed(ix_ctx *ctx, const ix_mv *c, bool *out)
{
    double dom[2], p[2][IX_MAX_COORDS], lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

    ix_mv_domain(c, 0, dom);
    for (int e = 0; e < 2; e++)
        IX_TRY(ix_mv_point(ctx, c, &dom[e], p[e]));
    IX_TRY(ix_mv_bbox(ctx, c, lo, hi));
    *out = hypot(p[1][0] - p[0][0], p[1][1] - p[0][1]) <=
           1e-10 * hypot(hi[0] - lo[0], hi[1] - lo[1]);
    return IX_OK;
}

static ix_status envelope(ix_ctx *ctx, const ix_mv *c, double h, double tol,
                          ix_mv **out, ix_mv **right)
{
    bool closed;

    IX_TRY(is_closed(ctx, c, &closed));
    if (!closed)
        return open_envelope(ctx, c, h, tol, out);
    IX_TRY(make_side(ctx, c, -h, tol, false, out));
    return make_side(ctx, c, h, tol, false, right);
}

ix_status ix__cone_envelope(ix_ctx *ctx, const ix_mv *c, double height,
                            double tol, ix_mv **out, ix_mv **right)
{
    ix_mv *flat, *b = NULL;
    ix_status st;

    *out = *right = NULL;
    if (c->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d directions; a planar curve is wanted",
                       c->ndirs);
    if (!(height > 0))
        return IX_FAIL(ctx, IX_EARG, "a height of %g; it must be positive",
                       height);
    IX_TRY(ix_mv_coerce(ctx, c, 2, c->rational, &flat));
    st = ix_mv_to_bspline(ctx, flat, &b);
    if (st == IX_OK)
        st = envelope(ctx, b, height, tol, out, right);
    ix_mv_unref(ctx, flat);
    ix_mv_unref(ctx, b);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}
