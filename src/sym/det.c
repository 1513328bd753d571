/* det.c - determinants and maximal minors of rows that are multivariates. */
#include "sym/form.h"

static ix_status check_rows(ix_ctx *ctx, int n, const ix_mv *const *rows,
                            int cols)
{
    if (n < 1 || cols > IX_MAX_COORDS)
        return IX_FAIL(ctx, IX_EARG, "%d rows, at least 1 and %d columns", n,
                       IX_MAX_COORDS);
    for (int i = 0; i < n; i++) {
        if (rows[i]->rational)
            return IX_FAIL(ctx, IX_EARG, "row %d is rational", i + 1);
        if (rows[i]->ncoords != cols)
            return IX_FAIL(ctx, IX_EARG, "row %d has %d coordinates, not %d",
                           i + 1, rows[i]->ncoords, cols);
    }
    return IX_OK;
}

typedef ix_status (*reduction)(ix_ctx *ctx, int n, const ix_form *const *m,
                               ix_form *out);

static ix_status body(ix_ctx *ctx, int n, const ix_mv *const *rows,
                      reduction fn, const ix_sym_opts *o, ix_mv **out)
{
    ix_form f[IX_MAX_COORDS], res;
    const ix_form *p[IX_MAX_COORDS];

    IX_TRY(ix__forms_load(ctx, n, rows, NULL, f));
    for (int i = 0; i < n; i++)
        p[i] = &f[i];
    IX_TRY(fn(ctx, n, p, &res));
    return ix__form_store(ctx, &res, false, o, out);
}

static ix_status run(ix_ctx *ctx, int n, const ix_mv *const *rows, reduction fn,
                     const ix_sym_opts *o, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = body(ctx, n, rows, fn, o, out);

    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_sym_det(ix_ctx *ctx, int n, const ix_mv *const *rows,
                     const ix_sym_opts *o, ix_mv **out)
{
    *out = NULL;
    IX_TRY(check_rows(ctx, n, rows, n));
    return run(ctx, n, rows, ix__form_det, o, out);
}

ix_status ix_sym_minors(ix_ctx *ctx, int n, const ix_mv *const *rows,
                        const ix_sym_opts *o, ix_mv **out)
{
    *out = NULL;
    IX_TRY(check_rows(ctx, n, rows, n + 1));
    return run(ctx, n, rows, ix__form_minors, o, out);
}
