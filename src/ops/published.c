/* published.c - D1, D2, D3, D21 in their formal degrees 2d-1, 2d-2, 2d-3. */
#include "ops/published.h"

#include "ops/ratio.h"

/* a b - x y for rows a, x and scalars b, y. */
static ix_status difference(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                            const ix_form *x, const ix_form *y, ix_form *out)
{
    IX_TRY(ix__form_mul(ctx, a, b, out));
    return ix__form_mul_add(ctx, x, -1, y, out);
}

static ix_status rational_ds(ix_ctx *ctx, const ix_curve *c, ix_published *out)
{
    ix_form p[4] = {c->local}, w[4] = {c->w};
    ix_form *d[3] = {&out->d1, &out->d2, &out->d3};

    for (int i = 1; i < 4; i++) {
        IX_TRY(ix__form_derive(ctx, &p[i - 1], 0, &p[i]));
        IX_TRY(ix__form_derive(ctx, &w[i - 1], 0, &w[i]));
        IX_TRY(difference(ctx, &p[i], &w[0], &p[0], &w[i], d[i - 1]));
    }
    return difference(ctx, &p[2], &w[1], &p[1], &w[2], &out->d21);
}

ix_status ix__published_of(ix_ctx *ctx, const ix_curve *c, ix_published *out)
{
    ix_published r;

    if (c->rational) {
        IX_TRY(rational_ds(ctx, c, &r));
    } else {
        IX_TRY(ix__form_derive(ctx, &c->p, 0, &r.d1));
        IX_TRY(ix__form_derive(ctx, &r.d1, 0, &r.d2));
        IX_TRY(ix__form_derive(ctx, &r.d2, 0, &r.d3));
    }
    if (c->dim == 2)
        IX_TRY(ix__form_det2(ctx, &r.d1, &r.d2, &r.b));
    else
        IX_TRY(ix__form_cross(ctx, &r.d1, &r.d2, &r.b));
    IX_TRY(ix__form_dot(ctx, &r.d1, &r.d1, &r.q));
    *out = r;
    return IX_OK;
}

ix_status ix__published_torsion(ix_ctx *ctx, const ix_published *p,
                                ix_form *out)
{
    return ix__form_dot(ctx, &p->b, &p->d3, out);
}
