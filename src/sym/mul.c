/* mul.c - products: coordinate by coordinate, and by a scalar. */
#include "sym/frac.h"

static ix_status mul_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    int na = f[0].x.nrows, nb = f[1].x.nrows, n = na < nb ? na : nb;
    ix_form a = ix__form_rows(&f[0].x, 0, n), b = ix__form_rows(&f[1].x, 0, n);

    (void)sign;
    IX_TRY(ix__frac_weights(ctx, &f[0], &f[1], out));
    IX_TRY(ix__form_mul(ctx, &a, &b, &out->x));
    return ix__frac_pad(ctx, out, na > nb ? na : nb);
}

ix_status ix_sym_mul(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[2] = {a, b};

    return ix__frac_run(ctx, 2, m, mul_fracs, 1, o, out);
}

static ix_status scale_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    (void)sign;
    IX_TRY(ix__frac_weights(ctx, &f[0], &f[1], out));
    return ix__form_mul(ctx, &f[0].x, &f[1].x, &out->x);
}

ix_status ix_sym_scale(ix_ctx *ctx, const ix_mv *a, const ix_mv *s,
                       const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[2] = {a, s};

    *out = NULL;
    if (s->ncoords != 1)
        return IX_FAIL(ctx, IX_EARG, "the factor has %d coordinates, not 1",
                       s->ncoords);
    return ix__frac_run(ctx, 2, m, scale_fracs, 1, o, out);
}
