/* srf_curvature.c - fundamental forms, Gauss, mean and normal curvatures of a
 * surface as scalar fields. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "iritx/sym.h"
#include "ops/srf_naive.h"

/* w^k x, or x itself for polynomial surfaces. */
static ix_status times_weight(ix_ctx *ctx, const ix_surface *s, int k,
                              const ix_form *x, ix_form *out)
{
    ix_form wk;

    if (!s->rational) {
        *out = *x;
        return IX_OK;
    }
    IX_TRY(ix__form_power(ctx, &s->w, k, &wk));
    return ix__form_mul(ctx, x, &wk, out);
}

/* --- fundamental forms ------------------------------------------------------
 */

static ix_status store_frac(ix_ctx *ctx, const ix_frac *x, int exp,
                            const ix_op_opts *o, ix_mv **out)
{
    ix__field f = {x->rational ? &x->w : NULL, &x->x, exp, NULL};

    return ix__field_store(ctx, &f, o, out);
}

static ix_status third_form(ix_ctx *ctx, const ix_surface *s, ix_frac x[3])
{
    ix_form a[2], den;

    IX_TRY(ix__surface_gauss_map(ctx, s, a));
    IX_TRY(ix__form_mul(ctx, &s->mm, &s->mm, &den));
    for (int k = 0; k < 3; k++) {
        IX_TRY(ix__form_dot(ctx, &a[k / 2], &a[(k + 1) / 2], &x[k].x));
        x[k].w = den;
        x[k].rational = true;
    }
    return IX_OK;
}

static ix_status minimal_forms(ix_ctx *ctx, const ix_surface *s, int k,
                               ix_frac x[3])
{
    ix_form den;

    if (k == 3)
        return third_form(ctx, s, x);
    IX_TRY(ix__form_power(ctx, &s->w, 4, &den));
    for (int i = 0; i < 3; i++)
        x[i] = (ix_frac){k == 1 ? s->g[i] : s->b[i], den, s->rational};
    return IX_OK;
}

static ix_status naive_forms(ix_ctx *ctx, const ix_surface *s, int k, bool irit,
                             ix_frac x[3])
{
    ix_srf_naive n;

    IX_TRY(ix__naive_surface(ctx, s, irit, &n));
    if (k == 3)
        return ix__naive_third(ctx, &n, x);
    memcpy(x, k == 1 ? n.g : n.l, sizeof n.g);
    return IX_OK;
}

static ix_status forms(ix_ctx *ctx, const ix_mv *m, int k, const ix_op_opts *o,
                       ix_mv *out[3])
{
    ix_frac x[3];
    ix_surface s;

    IX_TRY(ix__surface_load(ctx, m, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    if (ix__naive_wanted(o))
        IX_TRY(naive_forms(ctx, &s, k, o->form == IX_FORM_IRIT, x));
    else
        IX_TRY(minimal_forms(ctx, &s, k, x));
    for (int i = 0; i < 3; i++)
        IX_TRY(store_frac(ctx, &x[i], k == 3 ? 0 : (k + 1) * s.frame.exp, o,
                          &out[i]));
    return IX_OK;
}

ix_status ix_srf_forms(ix_ctx *ctx, const ix_mv *s, int k, const ix_op_opts *o,
                       ix_mv *out[3])
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    out[0] = out[1] = out[2] = NULL;
    if (k < 1 || k > 3)
        return IX_FAIL(ctx, IX_EARG, "fundamental form %d; there are 1, 2, 3",
                       k);
    st = forms(ctx, s, k, o, out);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK)
        return IX_OK;
    for (int i = 0; i < 3; i++) {
        ix_mv_unref(ctx, out[i]);
        out[i] = NULL;
    }
    return st;
}

/* --- what the fields should be
 * ------------------------------------------------ */

enum {
    GAUSS,
    MEAN_SQR,
    ALONG_U,
    ALONG_V,
    TOTAL,
    GAUSS_NUMERATOR,
    MEAN_NUMERATOR
};

static void value(const ix_srf_jet *j, int which, double *v)
{
    double g = j->g[0] * j->g[2] - j->g[1] * j->g[1];
    double k = (j->b[0] * j->b[2] - j->b[1] * j->b[1]) / g;
    double h = (j->g[0] * j->b[2] + j->g[2] * j->b[0] -
                2.0 * j->g[1] * j->b[1]) /
               (2.0 * g);
    double a = j->b[0] / j->g[0], b = j->b[2] / j->g[2];

    v[0] = which == GAUSS      ? k
           : which == MEAN_SQR ? h * h
           : which == ALONG_U  ? a * a
           : which == ALONG_V  ? b * b
                               : 4.0 * h * h - 2.0 * k;
}

/* --- numerators
 * ----------------------------------------------------------------- */

/* *m scaled so that its largest control value is 1 or -1. */
static ix_status unit_scale(ix_ctx *ctx, ix_mv **m)
{
    double big = ix__bern_largest((*m)->npts, ix_mv_coord(*m, 0)), f;
    ix_mv *t;
    ix_status st;

    if (!(big > 0.0))
        return IX_OK;
    f = 1.0 / big;
    st = ix_sym_dot_vector(ctx, *m, &f, &t);
    ix_mv_unref(ctx, *m);
    *m = st == IX_OK ? t : NULL;
    return st;
}

/* A numerator has nothing to be measured against but its zeros. */
static void report_numerator(const ix_op_opts *o, const ix_mv *out,
                             ix_report *rep)
{
    if (!rep)
        return;
    *rep = (ix_report){.form = o ? o->form : IX_FORM_MINIMAL,
                       .ndirs = 2,
                       .orders = {ix_mv_order(out, 0), ix_mv_order(out, 1)},
                       .residual = NAN,
                       .how = "a numerator is not measured"};
}

/* --- fields
 * ------------------------------------------------------------------------ */

/* w^4 k over |m|^4. */
static ix_status gauss(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    ix_form k;

    IX_TRY(ix__surface_k(ctx, s, &k));
    IX_TRY(times_weight(ctx, s, 4, &k, &out->x));
    return ix__form_mul(ctx, &s->mm, &s->mm, &out->w);
}

static ix_status gauss_numerator(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    out->rational = false;
    return ix__surface_k(ctx, s, &out->x);
}

static ix_status mean_numerator(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    out->rational = false;
    return ix__surface_h(ctx, s, &out->x);
}

/* w^2 h^2 over |m|^6. */
static ix_status mean_parts(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    ix_form h, hh;

    IX_TRY(ix__surface_h(ctx, s, &h));
    IX_TRY(ix__form_mul(ctx, &h, &h, &hh));
    IX_TRY(times_weight(ctx, s, 2, &hh, &out->x));
    return ix__form_power(ctx, &s->mm, 3, &out->w);
}

static ix_status mean(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    IX_TRY(mean_parts(ctx, s, out));
    ix__form_times(&out->w, 4.0);
    return IX_OK;
}

/* w^2 h^2 - 2 w^4 k M over M^3. */
static ix_status total(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    ix_form k, wk, twice;

    IX_TRY(mean_parts(ctx, s, out));
    IX_TRY(ix__surface_k(ctx, s, &k));
    IX_TRY(times_weight(ctx, s, 4, &k, &wk));
    IX_TRY(ix__form_copy(ctx, &s->mm, &twice));
    ix__form_times(&twice, 2.0);
    return ix__form_mul_add(ctx, &wk, -1, &twice, &out->x);
}

/* w^6 b^2 over g^2 M. */
static ix_status along(ix_ctx *ctx, const ix_surface *s, int dir, ix_frac *out)
{
    ix_form bb, gg;

    IX_TRY(ix__form_mul(ctx, &s->b[2 * dir], &s->b[2 * dir], &bb));
    IX_TRY(times_weight(ctx, s, 6, &bb, &out->x));
    IX_TRY(ix__form_mul(ctx, &s->g[2 * dir], &s->g[2 * dir], &gg));
    return ix__form_mul(ctx, &gg, &s->mm, &out->w);
}

static ix_status along_u(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    return along(ctx, s, 0, out);
}

static ix_status along_v(ix_ctx *ctx, const ix_surface *s, ix_frac *out)
{
    return along(ctx, s, 1, out);
}

/* --- entries
 * ----------------------------------------------------------------------- */

/* A fraction in both ways; which is the value it should have. */
typedef struct {
    ix_status (*minimal)(ix_ctx *ctx, const ix_surface *s, ix_frac *out);
    ix__naive_fn naive;
    int which;
} kind;

static const kind kinds[] = {
    [GAUSS] = {gauss, ix__naive_gauss, GAUSS},
    [MEAN_SQR] = {mean, ix__naive_mean_sqr, MEAN_SQR},
    [ALONG_U] = {along_u, ix__naive_along_u, ALONG_U},
    [ALONG_V] = {along_v, ix__naive_along_v, ALONG_V},
    [TOTAL] = {total, ix__naive_total, TOTAL},
    [GAUSS_NUMERATOR] = {gauss_numerator, ix__naive_k, -1},
    [MEAN_NUMERATOR] = {mean_numerator, ix__naive_h, -1}};

static ix_status build(ix_ctx *ctx, const ix_mv *m, const kind *k,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_frac f = {.rational = true};
    ix_surface s;
    ix_srf_naive n;

    IX_TRY(ix__surface_load(ctx, m, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    if (ix__naive_wanted(o)) {
        IX_TRY(ix__naive_surface(ctx, &s, o->form == IX_FORM_IRIT, &n));
        IX_TRY(k->naive(ctx, &n, &f));
    } else {
        IX_TRY(k->minimal(ctx, &s, &f));
    }
    if (k->which >= 0)
        return store_frac(ctx, &f, -2 * s.frame.exp, o, out);
    IX_TRY(store_frac(ctx, &f, 0, o, out));
    return unit_scale(ctx, out);
}

static ix_status field(ix_ctx *ctx, const ix_mv *m, const kind *k,
                       const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    st = build(ctx, m, k, o, out);
    ix__scratch_release(ctx, mk);
    IX_TRY(st);
    if (k->which < 0) {
        report_numerator(o, *out, rep);
        return IX_OK;
    }
    st = ix__srf_measure(ctx, m, *out, value, k->which, o, rep);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}

ix_status ix_srf_gauss(ix_ctx *ctx, const ix_mv *s, bool numerator,
                       const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return field(ctx, s, &kinds[numerator ? GAUSS_NUMERATOR : GAUSS], o, rep,
                 out);
}

ix_status ix_srf_mean(ix_ctx *ctx, const ix_mv *s, bool numerator,
                      const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return field(ctx, s, &kinds[numerator ? MEAN_NUMERATOR : MEAN_SQR], o, rep,
                 out);
}

ix_status ix_srf_curvature(ix_ctx *ctx, const ix_mv *s, ix_srf_curvature_kind k,
                           const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    *out = NULL;
    if (k < IX_SRF_ALONG_U || k > IX_SRF_TOTAL)
        return IX_FAIL(ctx, IX_EARG, "kind of curvature %d", (int)k);
    return field(ctx, s, &kinds[ALONG_U + (int)k], o, rep, out);
}
