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

/* The spans of a B-spline direction and, with the new degree, its knots. */
static ix_status plan(ix_ctx *ctx, const ix_dir *old, int order, ix_spans *sp,
                      ix_dir *nd)
{
    IX_TRY(ix__spans_of(ctx, old, sp));
    sp->degree = order - 1;
    return ix__spans_target(ctx, sp, INT_MAX, false, nd);
}

/* Span by span: linear in the number of spans and of orders. */
static ix_status raise_spans(ix_ctx *ctx, const ix_mv *m, int dir,
                             const ix_spans *sp, const ix_dir *nd, ix_mv **out)
{
    const ix_dir *old = m->dirs + dir;
    ix__mv_extent s = ix__mv_shape(m, dir);
    size_t n = s.outer * (size_t)sp->nspans * s.inner;
    double *bern, *more;
    ix_rows rows;
    ix_status st;
    ix_mv *r;

    IX_SCRATCH(ctx, bern, n * (size_t)old->order);
    IX_SCRATCH(ctx, more, n * (size_t)nd->order);
    IX_TRY(ix__spans_extract(ctx, old, sp, s.outer, s.inner, m->pts, bern));
    IX_TRY(ix__rows_raise(ctx, old->order - 1, nd->order - 1, &rows));
    ix__rows_apply(ctx, &rows, old->order, s.outer * (size_t)sp->nspans,
                   s.inner, bern, more);
    IX_TRY(ix__mv_alloc_like(ctx, m, dir, nd, &r));
    st = ix__spans_compose(ctx, sp, nd, s.outer, s.inner, more, r->pts);
    return ix__mv_finish(ctx, st, r, out);
}

/* One order more, by convex combinations; m is open in direction dir. */
static ix_status raise_one(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    const ix_dir *old = m->dirs + dir;
    ix_rows rows;
    ix_spans sp;
    ix_dir nd;

    IX_TRY(ix__poll(ctx));
    IX_TRY(plan(ctx, old, old->order + 1, &sp, &nd));
    IX_TRY(ix__rows_raise_one(ctx, old, nd.length, nd.knots, &rows));
    return ix__mv_map(ctx, m, dir, &rows, &nd, out);
}

static ix_status raise_one_scoped(ix_ctx *ctx, const ix_mv *m, int dir,
                                  ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, raise_one(ctx, m, dir, out));
}

/* Order by order: slower, but stable where many smooth spans meet. */
static ix_status raise_steps(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                             ix_mv **out)
{
    ix_mv *cur, *next;

    IX_TRY(ix__mv_open_dir(ctx, m, dir, &cur));
    while (cur->dirs[dir].order < order)
        IX_TRY(ix__mv_step(ctx, &cur, &next,
                           raise_one_scoped(ctx, cur, dir, &next)));
    *out = cur;
    return IX_OK;
}

/* Composing may multiply rounding errors by this much, no more: three digits
 * are what raising order by order loses at the orders concerned. */
#define MOST_AMPLIFIED 1e3

static ix_status raise_dir(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                           ix_mv **out)
{
    double worst;
    ix_spans sp;
    ix_dir nd;

    if (m->dirs[dir].basis == IX_BEZIER)
        return raise_bezier(ctx, m, dir, order, out);
    IX_TRY(plan(ctx, m->dirs + dir, order, &sp, &nd));
    IX_TRY(ix__spans_amplification(ctx, &sp, &nd, &worst));
    if (worst <= MOST_AMPLIFIED)
        return raise_spans(ctx, m, dir, &sp, &nd, out);
    return raise_steps(ctx, m, dir, order, out);
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
