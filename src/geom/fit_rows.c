/* fit_rows.c - see the header: one banded system, all rows of data as right
 * hand sides. */
#include "geom/fit_rows.h"

#include <limits.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"

static ix_status add_rows(ix_ctx *ctx, const ix__fit *f, const double *data,
                          ix_band *b)
{
    double *w, *rhs;

    IX_SCRATCH(ctx, w, f->dir->order);
    IX_SCRATCH(ctx, rhs, f->outer * f->inner);
    for (int k = 0; k < f->n; k++) {
        int first = ix__basis_first(f->dir, f->tau[k]);

        ix__basis_derive(f->dir, first, f->tau[k], 0, w);
        for (size_t o = 0; o < f->outer; o++)
            memcpy(rhs + o * f->inner,
                   data + (o * (size_t)f->n + (size_t)k) * f->inner,
                   f->inner * sizeof *rhs);
        ix__band_add(b, first % f->dir->length, f->dir->order, w, rhs);
    }
    return IX_OK;
}

ix_status ix__fit_rows(ix_ctx *ctx, const ix__fit *f, const double *data,
                       double *out)
{
    size_t n = (size_t)f->dir->length, nrhs = f->outer * f->inner;
    ix_band b;
    double *x;

    if (nrhs > INT_MAX)
        return IX_FAIL(ctx, IX_EARG, "%zu numbers in a row are too many", nrhs);
    IX_TRY(ix__band_new(ctx, (int)n, f->dir->order, f->dir->periodic, (int)nrhs,
                        &b));
    IX_TRY(add_rows(ctx, f, data, &b));
    IX_SCRATCH(ctx, x, nrhs * n);
    IX_TRY(ix__band_solve(ctx, &b, x));
    for (size_t o = 0; o < f->outer; o++)
        for (size_t j = 0; j < n; j++)
            for (size_t i = 0; i < f->inner; i++)
                out[(o * n + j) * f->inner + i] = x[(o * f->inner + i) * n + j];
    return IX_OK;
}

ix_status ix__fit_check(ix_ctx *ctx, int ndirs, const int *count,
                        const int *order, const int *size)
{
    for (int d = 0; d < ndirs; d++)
        if (order[d] < 1 || order[d] > IX_MAX_ORDER || size[d] < order[d] ||
            (count && size[d] > count[d]))
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d: order %d <= control points %d <= "
                           "data %d is not so",
                           d + 1, order[d], size[d],
                           count ? count[d] : size[d]);
    return IX_OK;
}
