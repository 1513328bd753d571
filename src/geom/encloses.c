/* encloses.c - point in a closed planar curve, by counting turns: a ray to the
 * right of the point is crossed upwards or downwards at roots of y. */
#include <math.h>

#include "geom/crvs.h"
#include "iritx/distance.h"
#include "mv/mv.h"

ix_status ix__check_closed(ix_ctx *ctx, const ix_mv *c)
{
    double dom[2], a[3] = {0}, b[3] = {0}, gap = 0, size = 0;

    if (c->ndirs != 1 || c->ncoords < 2 || c->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a planar curve is "
                       "wanted",
                       c->ndirs, c->ncoords);
    ix_mv_domain(c, 0, dom);
    IX_TRY(ix_mv_point(ctx, c, &dom[0], a));
    IX_TRY(ix_mv_point(ctx, c, &dom[1], b));
    for (int k = 0; k < 2; k++) {
        const double *x = ix_mv_coord(c, k);

        gap = fmax(gap, fabs(a[k] - b[k]));
        for (size_t i = 0; i < c->npts; i++)
            size = fmax(size, fabs(x[i]));
    }
    /* end points that agree to the tolerance of point identity */
    if (!(gap <= 1e-6 * size))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curve is not closed: its ends are %g apart", gap);
    return IX_OK;
}

/* Up (1), down (-1) or no (0) crossing of the ray at a root; the domain's two
 * ends are one point. */
static ix_status crossing(ix_ctx *ctx, const ix_mv *c, const ix_root *r, int n,
                          int i, const double p[3], int *turn)
{
    int before = r[i].before, after = r[i].after;
    double x[3];

    *turn = 0;
    if (!before && i == 0)
        before = r[n - 1].after ? 0 : r[n - 1].before;
    if (!after && i == n - 1 && i > 0)
        return IX_OK; /* counted at the first root */
    if (!before || !after || before == after)
        return IX_OK;
    IX_TRY(ix_mv_point(ctx, c, &r[i].t, x));
    if (x[0] > p[0])
        *turn = after > before ? 1 : -1;
    return IX_OK;
}

ix_status ix_crv_encloses(ix_ctx *ctx, const ix_mv *c, const double p[3],
                          double eps, int *where)
{
    ix_root_opts o = {.lo = 1, .hi = 0, .level = p[1]};
    double t, d, foot[3] = {p[0], p[1], 0};
    int n, turns = 0;
    ix_status st = IX_OK;
    ix_mv *flat;
    ix_root *r;

    *where = -1;
    IX_TRY(ix__check_closed(ctx, c));
    IX_TRY(ix_mv_coerce(ctx, c, 2, c->rational, &flat));
    st = ix_crv_nearest(ctx, flat, foot, NULL, false, &t, &d);
    ix_mv_unref(ctx, flat);
    IX_TRY(st);
    if (d <= eps) {
        *where = 0;
        return IX_OK;
    }
    IX_TRY(ix_roots(ctx, c, c->rational ? 2 : 1, &o, &r, &n));
    for (int i = 0; st == IX_OK && i < n; i++) {
        int turn;

        st = crossing(ctx, c, r, n, i, p, &turn);
        turns += turn;
    }
    ix_roots_free(ctx, r, n);
    *where = turns ? 1 : -1;
    return st;
}
