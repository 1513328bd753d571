/* meet.c - intersections of two planar curves as a system in (t, r). */
#include "geom/outer_mv.h"
#include "iritx/distance.h"

#define MAX_BOXES                                                \
    200000 /* overlapping curves have no isolated solutions: the \
              search is stopped when it has become pointless */

static ix_status check(ix_ctx *ctx, const ix_mv *c, int which)
{
    if (c->ndirs != 1 || c->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "curve %d has %d directions and %d coordinates; a "
                       "curve of 2 or more is wanted",
                       which, c->ndirs, c->ncoords);
    if (c->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "curve %d is in power basis: convert it to Bezier",
                       which);
    return IX_OK;
}

ix_status ix_crv_crv_meet(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          const ix_solve_opts *o, ix_solutions *out)
{
    ix_solve_opts own = {.max_boxes = MAX_BOXES};
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    ix_status st;
    ix_mv *x, *y;

    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, a, 1));
    IX_TRY(check(ctx, b, 2));
    IX_TRY(ix__outer_difference(ctx, a, b, 0, &x));
    st = ix__outer_difference(ctx, a, b, 1, &y);
    if (st == IX_OK) {
        eq[0].f = x;
        eq[1].f = y;
        st = ix_solve(ctx, 2, eq, o ? o : &own, out);
        ix_mv_unref(ctx, y);
    }
    ix_mv_unref(ctx, x);
    return st;
}
