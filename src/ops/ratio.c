/* ratio.c - arithmetic of fractions without any cancellation. */
#include "ops/ratio.h"

#include <float.h>
#include <math.h>

#include "bern/bern.h"

ix_status ix__ratio_even(ix_ctx *ctx, ix_frac *f)
{
    int d[IX_MAX_DIRS];

    if (!f->rational)
        return IX_OK;
    for (int i = 0; i < f->x.ndirs; i++) {
        int a = f->x.dirs[i].degree, b = f->w.dirs[i].degree;

        d[i] = a > b ? a : b;
    }
    IX_TRY(ix__form_elevate(ctx, &f->x, d, &f->x));
    return ix__form_elevate(ctx, &f->w, d, &f->w);
}

ix_frac ix__ratio_of(const ix_curve *c)
{
    return (ix_frac){c->p, c->w, c->rational};
}

ix_status ix__ratio_forms(ix_ctx *ctx, const ix_curve *c, void *arg,
                          ix_form *out)
{
    const ix__curve_frac *fn = arg;
    ix_frac f = {.rational = true};

    IX_TRY((*fn)(ctx, c, &f));
    out[0] = f.w;
    out[1] = f.x;
    return IX_OK;
}

ix_status ix__ratio_partial(ix_ctx *ctx, const ix_frac *f, int dir,
                            ix_frac *out)
{
    ix_frac r = {.rational = f->rational};
    ix_form dx, dw;

    IX_TRY(ix__form_derive(ctx, &f->x, dir, &dx));
    if (!f->rational) {
        r.x = dx;
        *out = r;
        return IX_OK;
    }
    IX_TRY(ix__form_derive(ctx, &f->w, dir, &dw));
    IX_TRY(ix__form_mul(ctx, &dx, &f->w, &r.x));
    IX_TRY(ix__form_mul_add(ctx, &f->x, -1, &dw, &r.x));
    IX_TRY(ix__form_mul(ctx, &f->w, &f->w, &r.w));
    IX_TRY(ix__ratio_even(ctx, &r));
    *out = r;
    return IX_OK;
}

ix_status ix__ratio_derive(ix_ctx *ctx, const ix_frac *f, ix_frac *out)
{
    return ix__ratio_partial(ctx, f, 0, out);
}

ix_status ix__ratio_product(ix_ctx *ctx, ix__form_product product,
                            const ix_frac *a, const ix_frac *b, ix_frac *out)
{
    ix_frac r = {.rational = false};

    IX_TRY(product(ctx, &a->x, &b->x, &r.x));
    IX_TRY(ix__frac_weights(ctx, a, b, &r));
    *out = r;
    return IX_OK;
}

ix_status ix__ratio_over(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                         ix_frac *out)
{
    ix_frac r = {.x = a->x, .w = b->x, .rational = true};

    if (b->rational)
        IX_TRY(ix__form_mul(ctx, &a->x, &b->w, &r.x));
    if (a->rational)
        IX_TRY(ix__form_mul(ctx, &b->x, &a->w, &r.w));
    *out = r;
    return IX_OK;
}

ix_status ix__ratio_add(ix_ctx *ctx, const ix_frac *a, int sign,
                        const ix_frac *b, ix_frac *out)
{
    ix_form l = a->x, r = b->x, x;
    ix_frac sum = {.rational = false};

    if (b->rational)
        IX_TRY(ix__form_mul(ctx, &l, &b->w, &l));
    if (a->rational)
        IX_TRY(ix__form_mul(ctx, &r, &a->w, &r));
    IX_TRY(ix__form_add(ctx, &l, sign, &r, &x));
    IX_TRY(ix__frac_weights(ctx, a, b, &sum));
    sum.x = x;
    *out = sum;
    return IX_OK;
}

ix_status ix__ratio_common(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                           ix_form *xa, ix_form *xb, ix_form *w)
{
    static const double one = 1.0;
    ix_frac both;

    *xa = a->x;
    *xb = b->x;
    if (b->rational)
        IX_TRY(ix__form_mul(ctx, xa, &b->w, xa));
    if (a->rational)
        IX_TRY(ix__form_mul(ctx, xb, &a->w, xb));
    IX_TRY(ix__frac_weights(ctx, a, b, &both));
    *w = both.w;
    return both.rational ? IX_OK : ix__form_constant(ctx, &a->x, 1, &one, w);
}

bool ix__ratio_alike(const ix_frac *a, const ix_frac *b)
{
    double size, gap = 0.0;
    int degrees = 8;

    if (a->rational != b->rational || (a->rational && a->w.n != b->w.n))
        return false;
    if (!a->rational || a->w.c == b->w.c)
        return true;
    for (int i = 0; i < a->w.ndirs; i++) {
        if (a->w.dirs[i].degree != b->w.dirs[i].degree)
            return false;
        degrees += a->w.dirs[i].degree;
    }
    size = ix__bern_largest(a->w.n, a->w.c);
    for (size_t i = 0; i < a->w.n; i++)
        gap = fmax(gap, fabs(a->w.c[i] - b->w.c[i]));
    /* rounding of two sums of products in these degrees */
    return a->w.exp == b->w.exp && gap <= 8.0 * DBL_EPSILON * degrees * size;
}

ix_status ix__ratio_sum(ix_ctx *ctx, const ix_frac *a, int sign,
                        const ix_frac *b, ix_frac *out)
{
    ix_frac r = *a;

    if (!ix__ratio_alike(a, b))
        return ix__ratio_add(ctx, a, sign, b, out);
    IX_TRY(ix__form_add(ctx, &a->x, sign, &b->x, &r.x));
    *out = r;
    return IX_OK;
}

ix_status ix__form_det2(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                        ix_form *out)
{
    static const ix_form_term t[2] = {{0, 0, 1, 1}, {0, 1, 0, -1}};

    return ix__form_bilinear(ctx, a, b, 1, 2, t, out);
}

ix_status ix__form_turned(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                          ix_form *out)
{
    static const ix_form_term t[2] = {{0, 0, 1, -1}, {1, 0, 0, 1}};

    return ix__form_bilinear(ctx, a, b, 2, 2, t, out);
}
