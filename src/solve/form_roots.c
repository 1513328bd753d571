/* form_roots.c - the roots of a univariate form. */
#include "solve/form_roots.h"

#include <float.h>
#include <math.h>

#include "solve/roots.h"

ix_status ix__form_sizes(ix_ctx *ctx, const ix_form *f, double *out)
{
    const ix_spans *sp = &f->dirs[0];
    size_t m = (size_t)sp->degree + 1;
    const double *b;

    IX_TRY(ix__form_bernstein(ctx, f, &b));
    for (int j = 0; j < sp->nspans; j++) {
        out[j] = 0;
        for (int r = 0; r < f->nrows; r++)
            for (size_t k = 0; k < m; k++)
                out[j] = fmax(out[j],
                              fabs(b[(size_t)r * f->n + (size_t)j * m + k]));
    }
    return IX_OK;
}

ix_status ix__form_roots(ix_ctx *ctx, const ix_form *f, const double *scale,
                         ix_root **roots, int *n)
{
    const ix_spans *sp = &f->dirs[0];
    ix_form one = ix__form_rows(f, 0, 1);
    const double *b;
    double *band;

    IX_SCRATCH(ctx, band, sp->nspans);
    IX_TRY(ix__form_sizes(ctx, &one, band));
    for (int j = 0; j < sp->nspans; j++)
        band[j] = 4 * DBL_EPSILON * (sp->degree + 1) *
                  (scale ? fmax(scale[j], band[j]) : band[j]);
    IX_TRY(ix__form_bernstein(ctx, &one, &b));
    return ix__spans_roots(ctx, sp, b, band, roots, n);
}
