/* eval_grid.c - values on a grid, one direction after the other. The last one
 * works on long neighbouring rows: that is where nearly all the work is. */
#include <string.h>

#include "mv/mv.h"

/* Parameters of one direction, checked and clamped. */
static ix_status params(ix_ctx *ctx, const ix_mv *m, int d, int n,
                        const double *t, double **out)
{
    IX_SCRATCH(ctx, *out, n);
    memcpy(*out, t, (size_t)n * sizeof *t);
    for (int i = 0; i < n; i++)
        IX_TRY(ix__mv_param(ctx, m, d, *out + i));
    return IX_OK;
}

static ix_status eval_grid(ix_ctx *ctx, const ix_mv *m, const int *counts,
                           const double *const *t, double *out)
{
    size_t inner = 1, outer = (size_t)m->naxes * m->npts;
    const double *in = m->pts;

    for (int d = 0; d < m->ndirs; d++) {
        size_t n = (size_t)counts[d], total;
        double *to = out, *own;
        ix_rows rows;

        outer /= (size_t)m->dirs[d].length;
        if (__builtin_mul_overflow(outer * inner, n, &total))
            return IX_FAIL(ctx, IX_ENOMEM, "the grid is too large");
        if (d < m->ndirs - 1)
            IX_SCRATCH(ctx, to, total);
        IX_TRY(params(ctx, m, d, counts[d], t[d], &own));
        IX_TRY(ix__rows_sample(ctx, m->dirs + d, counts[d], own, &rows));
        ix__rows_apply(ctx, &rows, m->dirs[d].length, outer, inner, in, to);
        inner *= n;
        in = to;
    }
    return IX_OK;
}

ix_status ix_mv_eval_grid(ix_ctx *ctx, const ix_mv *m, const int *counts,
                          const double *const *params, double *out)
{
    for (int d = 0; d < m->ndirs; d++)
        if (counts[d] < 1)
            return IX_FAIL(ctx, IX_EARG, "%d parameters in direction %d",
                           counts[d], d);
    IX_RETURN_SCOPED(ctx, eval_grid(ctx, m, counts, params, out));
}
