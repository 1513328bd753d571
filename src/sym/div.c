/* div.c - quotients: numerators and weights are multiplied crosswise. */
#include <string.h>

#include "sym/frac.h"

static bool all_zero(size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++)
        if (x[i] != 0.0)
            return false;
    return true;
}

/* (xa / wa) / (xb / wb) = xa wb / (wa xb). */
static ix_status div_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    (void)sign;
    out->rational = true;
    out->x = f[0].x;
    out->w = f[1].x;
    if (f[1].rational)
        IX_TRY(ix__form_mul(ctx, &f[0].x, &f[1].w, &out->x));
    if (f[0].rational)
        IX_TRY(ix__form_mul(ctx, &f[0].w, &f[1].x, &out->w));
    return IX_OK;
}

static ix_status check_scalar(ix_ctx *ctx, const ix_mv *b)
{
    if (b->ncoords != 1)
        return IX_FAIL(ctx, IX_EARG, "the divisor has %d coordinates, not 1",
                       b->ncoords);
    if (all_zero(b->npts, ix_mv_coord(b, 0)))
        return IX_FAIL(ctx, IX_EDOMAIN, "the divisor is zero everywhere");
    return IX_OK;
}

ix_status ix_sym_div(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[2] = {a, b};

    *out = NULL;
    IX_TRY(check_scalar(ctx, b));
    return ix__frac_run(ctx, 2, m, div_fracs, 1, o, out);
}

ix_status ix_sym_invert(ix_ctx *ctx, const ix_mv *a, ix_mv **out)
{
    const double *x = ix_mv_coord(a, 0), *w = ix_mv_weights(a);
    ix_mv *m;

    *out = NULL;
    IX_TRY(check_scalar(ctx, a));
    IX_TRY(ix__mv_alloc(ctx, a->ndirs, a->dirs, 1, true, &m));
    for (size_t i = 0; i < a->npts; i++) {
        m->pts[i] = x[i];
        m->pts[a->npts + i] = w ? w[i] : 1.0;
    }
    *out = m;
    return IX_OK;
}
