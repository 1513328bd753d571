/* frac.c - loading, padding and storing fractions of forms. */
#include "sym/frac.h"

ix_status ix__fracs_load(ix_ctx *ctx, int n, const ix_mv *const *m,
                         ix_frac *out)
{
    ix_form f[3];

    IX_TRY(ix__forms_load(ctx, n, m, NULL, f));
    for (int i = 0; i < n; i++) {
        int r = m[i]->rational;

        out[i].rational = m[i]->rational;
        out[i].x = ix__form_rows(&f[i], r, f[i].nrows - r);
        out[i].w = ix__form_rows(&f[i], 0, 1);
    }
    return IX_OK;
}

ix_status ix__frac_pad(ix_ctx *ctx, ix_frac *f, int nc)
{
    static const double zeros[IX_MAX_COORDS];
    const ix_form *parts[2];
    ix_form x = f->x, z;

    if (f->x.nrows >= nc)
        return IX_OK;
    IX_TRY(ix__form_constant(ctx, &x, nc - x.nrows, zeros, &z));
    z.exp = x.exp;
    parts[0] = &x;
    parts[1] = &z;
    return ix__form_join(ctx, 2, parts, &f->x);
}

ix_status ix__frac_weights(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                           ix_frac *out)
{
    out->rational = a->rational || b->rational;
    if (a->rational && b->rational)
        return ix__form_mul(ctx, &a->w, &b->w, &out->w);
    if (out->rational)
        out->w = a->rational ? a->w : b->w;
    return IX_OK;
}

ix_status ix__frac_store(ix_ctx *ctx, const ix_frac *f, const ix_sym_opts *o,
                         ix_mv **out)
{
    const ix_form *parts[2] = {&f->w, &f->x};
    ix_form all;

    if (!f->rational)
        return ix__form_store(ctx, &f->x, false, o, out);
    IX_TRY(ix__form_join(ctx, 2, parts, &all));
    return ix__form_store(ctx, &all, true, o, out);
}

static ix_status run(ix_ctx *ctx, int n, const ix_mv *const *m,
                     ix__frac_body body, int sign, const ix_sym_opts *o,
                     ix_mv **out)
{
    ix_frac f[3], res = {.rational = false};

    IX_TRY(ix__fracs_load(ctx, n, m, f));
    IX_TRY(body(ctx, f, sign, &res));
    return ix__frac_store(ctx, &res, o, out);
}

ix_status ix__frac_run(ix_ctx *ctx, int n, const ix_mv *const *m,
                       ix__frac_body body, int sign, const ix_sym_opts *o,
                       ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, run(ctx, n, m, body, sign, o, out));
}
