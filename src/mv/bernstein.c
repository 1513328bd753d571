/* bernstein.c - a whole multivariate as Bernstein coefficients. */
#include "mv/bernstein.h"

ix_status ix__bernstein_of(ix_ctx *ctx, const ix_mv *m, ix__bernstein *b)
{
    const double *in = m->pts;
    size_t inner = 1, outer = (size_t)m->naxes * m->npts;

    b->m = m;
    for (int d = 0; d < m->ndirs; d++) {
        size_t n, rows, total;

        IX_TRY(ix__spans_of(ctx, m->dirs + d, b->sp + d));
        n = (size_t)b->sp[d].nspans * (size_t)m->dirs[d].order;
        outer /= (size_t)m->dirs[d].length;
        if (__builtin_mul_overflow(outer, n, &rows) ||
            __builtin_mul_overflow(rows, inner, &total))
            return IX_FAIL(ctx, IX_ENOMEM, "too many Bezier pieces");
        IX_SCRATCH(ctx, b->coefs, total);
        IX_TRY(ix__spans_extract(ctx, m->dirs + d, b->sp + d, outer, inner, in,
                                 b->coefs));
        b->stride[d] = inner;
        inner *= n;
        in = b->coefs;
    }
    b->axis = inner;
    return IX_OK;
}

size_t ix__bernstein_row(const ix__bernstein *b, const int *at, const int *q)
{
    const ix_dir *dirs = b->m->dirs;
    size_t from = (size_t)at[0] * (size_t)dirs[0].order;

    for (int d = 1; d < b->m->ndirs; d++)
        from += (size_t)(at[d] * dirs[d].order + q[d]) * b->stride[d];
    return from;
}

bool ix__bernstein_next(const ix_mv *m, int *q)
{
    for (int d = 1; d < m->ndirs; d++) {
        if (++q[d] < m->dirs[d].order)
            return true;
        q[d] = 0;
    }
    return false;
}
