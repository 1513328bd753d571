/* dot.c - scalar products. A constant vector keeps knots and points as they
 * are; two functions meet as forms. */
#include <string.h>

#include "sym/frac.h"

static ix_status dot_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    int na = f[0].x.nrows, nb = f[1].x.nrows, n = na < nb ? na : nb;
    ix_form a = ix__form_rows(&f[0].x, 0, n), b = ix__form_rows(&f[1].x, 0, n);

    (void)sign;
    IX_TRY(ix__frac_weights(ctx, &f[0], &f[1], out));
    return ix__form_dot(ctx, &a, &b, &out->x);
}

ix_status ix_sym_dot(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[2] = {a, b};

    return ix__frac_run(ctx, 2, m, dot_fracs, 1, o, out);
}

ix_status ix_sym_dot_vector(ix_ctx *ctx, const ix_mv *a, const double *v,
                            ix_mv **out)
{
    double *x;
    ix_mv *m;

    *out = NULL;
    IX_TRY(ix__mv_alloc(ctx, a->ndirs, a->dirs, 1, a->rational, &m));
    x = m->pts;
    if (a->rational) {
        memcpy(x, a->pts, a->npts * sizeof *x);
        x += a->npts;
    }
    for (size_t i = 0; i < a->npts; i++)
        x[i] = v[0] * ix_mv_coord(a, 0)[i];
    for (int k = 1; k < a->ncoords; k++) {
        const double *c = ix_mv_coord(a, k);

        for (size_t i = 0; i < a->npts; i++)
            x[i] += v[k] * c[i];
    }
    *out = m;
    return IX_OK;
}
