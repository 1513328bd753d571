/* raise.c - a higher order for the same map. Bezier directions by the raising
 * matrix, B-splines span by span, composed with the continuity they had. */
#include <limits.h>

#include "bsp/spans.h"
#include "mv/mv.h"

static ix_status raise_bezier(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                              ix_mv **out)
{
    ix_dir nd = {IX_BEZIER, order, order, false, NULL};
    ix_rows rows;

    IX_TRY(ix__rows_raise(ctx, m->dirs[dir].order - 1, order - 1, &rows));
    return ix__mv_map(ctx, m, dir, &rows, &nd, out);
}

static ix_status raise_bspline(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                               ix_mv **out)
{
    const ix_dir *old = m->dirs + dir;
    ix__mv_extent s = ix__mv_shape(m, dir);
    size_t pieces, low, high;
    double *bern, *more;
    ix_status st;
    ix_spans sp;
    ix_mv *r;
    ix_rows rows;
    ix_dir nd;

    IX_TRY(ix__spans_of(ctx, old, &sp));
    pieces = s.outer * (size_t)sp.nspans;
    low = (size_t)old->order * s.inner;
    high = (size_t)order * s.inner;
    IX_SCRATCH(ctx, bern, pieces * low);
    IX_SCRATCH(ctx, more, pieces * high);
    IX_TRY(ix__spans_extract(ctx, old, &sp, s.outer, s.inner, m->pts, bern));
    IX_TRY(ix__rows_raise(ctx, old->order - 1, order - 1, &rows));
    ix__rows_apply(ctx, &rows, old->order, pieces, s.inner, bern, more);
    sp.degree = order - 1;
    IX_TRY(ix__spans_target(ctx, &sp, INT_MAX, false, &nd));
    IX_TRY(ix__mv_alloc_like(ctx, m, dir, &nd, &r));
    st = ix__spans_compose(ctx, &sp, &nd, s.outer, s.inner, more, r->pts);
    return ix__mv_finish(ctx, st, r, out);
}

static ix_status raise_dir(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                           ix_mv **out)
{
    if (m->dirs[dir].basis == IX_BEZIER)
        return raise_bezier(ctx, m, dir, order, out);
    return raise_bspline(ctx, m, dir, order, out);
}

ix_status ix_mv_raise(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                      ix_mv **out)
{
    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (m->dirs[dir].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "direction %d: power basis", dir);
    if (order < m->dirs[dir].order || order > IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EARG,
                       "direction %d: order %d to order %d (at most %d)", dir,
                       m->dirs[dir].order, order, IX_MAX_ORDER);
    if (order == m->dirs[dir].order) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_RETURN_SCOPED(ctx, raise_dir(ctx, m, dir, order, out));
}
