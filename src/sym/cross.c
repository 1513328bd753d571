/* cross.c - vector products and the determinant of three vectors. */
#include "sym/frac.h"

static ix_status cross_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    int n = f[0].x.nrows > f[1].x.nrows ? f[0].x.nrows : f[1].x.nrows;

    (void)sign;
    for (int i = 0; i < 2; i++) /* two coordinates suffice for z alone */
        IX_TRY(ix__frac_pad(ctx, &f[i], n > 2 ? 3 : 2));
    IX_TRY(ix__frac_weights(ctx, &f[0], &f[1], out));
    return ix__form_cross(ctx, &f[0].x, &f[1].x, &out->x);
}

ix_status ix_sym_cross(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                       const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[2] = {a, b};

    *out = NULL;
    if (a->ncoords > 3 || b->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "a vector product of %d and %d coordinates, at most 3",
                       a->ncoords, b->ncoords);
    return ix__frac_run(ctx, 2, m, cross_fracs, 1, o, out);
}

static ix_status triple_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    const ix_form *rows[3] = {&f[0].x, &f[1].x, &f[2].x};
    ix_frac w = {.rational = false};

    (void)sign;
    IX_TRY(ix__frac_weights(ctx, &f[0], &f[1], &w));
    IX_TRY(ix__frac_weights(ctx, &w, &f[2], out));
    return ix__form_det(ctx, 3, rows, &out->x);
}

ix_status ix_sym_triple(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        const ix_mv *c, const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[3] = {a, b, c};

    *out = NULL;
    for (int i = 0; i < 3; i++)
        if (m[i]->ncoords != 3)
            return IX_FAIL(ctx, IX_EARG, "operand %d has %d coordinates, not 3",
                           i + 1, m[i]->ncoords);
    return ix__frac_run(ctx, 3, m, triple_fracs, 1, o, out);
}
