/* srf_naive.c - curvatures of surfaces by fractions, step by step. Weights of
 * fractions are powers of the surface's; only sums look at them. */
#include "ops/srf_naive.h"

bool ix__naive_wanted(const ix_op_opts *o)
{
    return o && (o->form == IX_FORM_NAIVE || o->form == IX_FORM_IRIT);
}

static ix_status times(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                       ix_frac *out)
{
    return ix__ratio_product(ctx, ix__form_mul, a, b, out);
}

static ix_status dot(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                     ix_frac *out)
{
    return ix__ratio_product(ctx, ix__form_dot, a, b, out);
}

/* --- the fundamental forms --------------------------------------------------
 */

ix_status ix__naive_surface(ix_ctx *ctx, const ix_surface *of, bool irit,
                            ix_srf_naive *out)
{
    ix_srf_naive r = {
        .of = of, .irit = irit, .s = {of->p, of->w, of->rational}};
    ix_frac d[2], dd;

    for (int i = 0; i < 2; i++)
        IX_TRY(ix__ratio_partial(ctx, &r.s, i, &d[i]));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[1], &d[0], &r.n));
    for (int k = 0; k < 3; k++) {
        int i = k / 2, j = (k + 1) / 2; /* 00, 01, 11 */

        IX_TRY(dot(ctx, &d[i], &d[j], &r.g[k]));
        IX_TRY(ix__ratio_partial(ctx, &d[i], j, &dd));
        IX_TRY(dot(ctx, &dd, &r.n, &r.l[k]));
        if (ix__form_is_zero(&of->b[k]))
            ix__form_clear(&r.l[k].x);
    }
    *out = r;
    return IX_OK;
}

/* f_0 f_2 - f_1^2. */
static ix_status determinant(ix_ctx *ctx, const ix_frac f[3], ix_frac *out)
{
    ix_frac a, b;

    IX_TRY(times(ctx, &f[0], &f[2], &a));
    IX_TRY(times(ctx, &f[1], &f[1], &b));
    return ix__ratio_sum(ctx, &a, -1, &b, out);
}

ix_status ix__naive_k(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_form k;

    IX_TRY(ix__surface_k(ctx, s->of, &k));
    IX_TRY(determinant(ctx, s->l, out));
    if (ix__form_is_zero(&k))
        ix__form_clear(&out->x);
    return IX_OK;
}

ix_status ix__naive_h(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_frac a, b, c;
    ix_form h;

    IX_TRY(ix__surface_h(ctx, s->of, &h));
    IX_TRY(times(ctx, &s->g[0], &s->l[2], &a));
    IX_TRY(times(ctx, &s->g[2], &s->l[0], &b));
    IX_TRY(times(ctx, &s->g[1], &s->l[1], &c));
    ix__form_times(&c.x, 2.0);
    IX_TRY(ix__ratio_sum(ctx, &a, 1, &b, &a));
    IX_TRY(ix__ratio_sum(ctx, &a, -1, &c, out));
    if (ix__form_is_zero(&h))
        ix__form_clear(&out->x);
    return IX_OK;
}

/* --- curvatures -------------------------------------------------------------
 */

/* (L11 L22 - L12^2) / (|n|^2 |G|). */
ix_status ix__naive_gauss(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_frac k, g, nn;

    IX_TRY(ix__naive_k(ctx, s, &k));
    IX_TRY(determinant(ctx, s->g, &g));
    IX_TRY(dot(ctx, &s->n, &s->n, &nn));
    IX_TRY(times(ctx, &nn, &g, &g));
    return ix__ratio_over(ctx, &k, &g, out);
}

/* n |G| / h, of length 1 / (2H). */
static ix_status radius(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_frac g, h;

    IX_TRY(determinant(ctx, s->g, &g));
    IX_TRY(ix__naive_h(ctx, s, &h));
    IX_TRY(times(ctx, &s->n, &g, &g));
    return ix__ratio_over(ctx, &g, &h, out);
}

/* 1 / (4 e.e) for the radius vector e. */
ix_status ix__naive_mean_sqr(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_frac e;

    IX_TRY(radius(ctx, s, &e));
    IX_TRY(dot(ctx, &e, &e, &e));
    ix__form_times(&e.x, 4.0);
    *out = (ix_frac){.x = e.w, .w = e.x, .rational = true};
    return IX_OK;
}

/* a / b. */
static ix_status quotient(ix_ctx *ctx, const ix_srf_naive *s, const ix_frac *a,
                          const ix_frac *b, ix_frac *out)
{
    if (!s->irit || !ix__ratio_alike(a, b))
        return ix__ratio_over(ctx, a, b, out);
    *out = (ix_frac){.x = a->x, .w = b->x, .rational = true};
    return IX_OK;
}

/* L_ii^2 / (G_ii^2 |n|^2). */
static ix_status along(ix_ctx *ctx, const ix_srf_naive *s, int dir,
                       ix_frac *out)
{
    ix_frac l, g, nn;

    IX_TRY(times(ctx, &s->l[2 * dir], &s->l[2 * dir], &l));
    IX_TRY(times(ctx, &s->g[2 * dir], &s->g[2 * dir], &g));
    IX_TRY(dot(ctx, &s->n, &s->n, &nn));
    IX_TRY(times(ctx, &g, &nn, &g));
    return quotient(ctx, s, &l, &g, out);
}

ix_status ix__naive_along_u(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    return along(ctx, s, 0, out);
}

ix_status ix__naive_along_v(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    return along(ctx, s, 1, out);
}

/* (h^2 - 2 |G| (L11 L22 - L12^2)) / (|G|^2 |n|^2). */
ix_status ix__naive_total(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_frac h, k, g, x, nn;

    IX_TRY(ix__naive_h(ctx, s, &h));
    IX_TRY(ix__naive_k(ctx, s, &k));
    IX_TRY(determinant(ctx, s->g, &g));
    IX_TRY(times(ctx, &h, &h, &h));
    IX_TRY(times(ctx, &k, &g, &x));
    ix__form_times(&x.x, 2.0);
    IX_TRY(ix__ratio_sum(ctx, &h, -1, &x, &x));
    IX_TRY(dot(ctx, &s->n, &s->n, &nn));
    IX_TRY(times(ctx, &g, &g, &g));
    IX_TRY(times(ctx, &g, &nn, &g));
    return quotient(ctx, s, &x, &g, out);
}

/* ((n_i.n_j) (n.n) - (n.n_i) (n.n_j)) / (n.n)^2. */
ix_status ix__naive_third(ix_ctx *ctx, const ix_srf_naive *s, ix_frac out[3])
{
    ix_frac d[2], nd[2], nn, den, a, b;

    IX_TRY(dot(ctx, &s->n, &s->n, &nn));
    IX_TRY(times(ctx, &nn, &nn, &den));
    for (int i = 0; i < 2; i++) {
        IX_TRY(ix__ratio_partial(ctx, &s->n, i, &d[i]));
        IX_TRY(dot(ctx, &s->n, &d[i], &nd[i]));
    }
    for (int k = 0; k < 3; k++) {
        int i = k / 2, j = (k + 1) / 2;

        IX_TRY(dot(ctx, &d[i], &d[j], &a));
        IX_TRY(times(ctx, &a, &nn, &a));
        IX_TRY(times(ctx, &nd[i], &nd[j], &b));
        IX_TRY(ix__ratio_sum(ctx, &a, -1, &b, &a));
        IX_TRY(ix__ratio_over(ctx, &a, &den, &out[k]));
    }
    return IX_OK;
}

/* --- centres ----------------------------------------------------------------
 */

/* S + e. */
static ix_status place(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *e,
                       ix_frac *out)
{
    if (s->irit)
        IX_TRY(ix__ratio_even(ctx, e));
    return ix__ratio_add(ctx, &s->s, 1, e, out);
}

ix_status ix__naive_evolute(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
{
    ix_frac e;

    IX_TRY(radius(ctx, s, &e));
    return place(ctx, s, &e, out);
}

ix_status ix__naive_focal(ix_ctx *ctx, const ix_srf_naive *s, int dir,
                          ix_frac *out)
{
    ix_frac e;

    IX_TRY(times(ctx, &s->n, &s->g[2 * dir], &e));
    IX_TRY(ix__ratio_over(ctx, &e, &s->l[2 * dir], &e));
    return place(ctx, s, &e, out);
}
