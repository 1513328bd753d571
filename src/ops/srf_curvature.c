/* srf_curvature.c - fundamental forms, Gauss, mean and normal curvatures of a
 * surface as scalar fields. */
#include <math.h>

#include "geom/vec3.h"
#include "iritx/sym.h"
#include "ops/surface.h"

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

static ix_status store_over(ix_ctx *ctx, const ix_surface *s,
                            const ix_form *den, int exp, const ix_form *x,
                            const ix_op_opts *o, ix_mv **out)
{
    ix__field f = {den, x, exp, NULL};

    return ix__field_store(ctx, s, &f, (ix__irit_rule){0, 0, 0, 0}, o, out);
}

static ix_status third_form(ix_ctx *ctx, const ix_surface *s, ix_form x[3],
                            ix_form *den)
{
    ix_form a[2];

    IX_TRY(ix__surface_gauss_map(ctx, s, a));
    for (int k = 0; k < 3; k++)
        IX_TRY(ix__form_dot(ctx, &a[k / 2], &a[(k + 1) / 2], &x[k]));
    return ix__form_mul(ctx, &s->mm, &s->mm, den);
}

static ix_status forms(ix_ctx *ctx, const ix_mv *m, int k, const ix_op_opts *o,
                       ix_mv *out[3])
{
    bool over = m->rational || k == 3;
    ix_form x[3], den;
    ix_surface s;
    int exp;

    IX_TRY(ix__surface_load(ctx, m, NULL, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    exp = k == 3 ? 0 : (k + 1) * s.frame.exp;
    for (int i = 0; i < 3; i++)
        x[i] = k == 1 ? s.g[i] : s.b[i];
    if (k == 3)
        IX_TRY(third_form(ctx, &s, x, &den));
    else if (over)
        IX_TRY(ix__form_power(ctx, &s.w, 4, &den));
    for (int i = 0; i < 3; i++)
        IX_TRY(store_over(ctx, &s, over ? &den : NULL, exp, &x[i], o, &out[i]));
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

enum { GAUSS, MEAN_SQR, ALONG_U, ALONG_V, TOTAL };

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

static ix_status store_numerator(ix_ctx *ctx, const ix_surface *s,
                                 const ix_form *x, ix__irit_rule rule,
                                 const ix_op_opts *o, ix_mv **out)
{
    ix__field f = {NULL, x, 0, NULL};
    ix_form den;

    if (s->rational && o && o->form == IX_FORM_IRIT) {
        IX_TRY(ix__form_power(ctx, &s->w, 8, &den));
        f.den = &den;
    }
    IX_TRY(ix__field_store(ctx, s, &f, rule, o, out));
    return unit_scale(ctx, out);
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

static ix_status gauss(ix_ctx *ctx, const ix_surface *s, const ix_op_opts *o,
                       ix_mv **out)
{
    ix_form k, x, den;
    ix__field f = {&den, &x, -2 * s->frame.exp, NULL};

    IX_TRY(ix__surface_k(ctx, s, &k));
    IX_TRY(times_weight(ctx, s, 4, &k, &x));
    IX_TRY(ix__form_mul(ctx, &s->mm, &s->mm, &den));
    return ix__field_store(ctx, s, &f, (ix__irit_rule){8, 4, 32, 0}, o, out);
}

static ix_status gauss_numerator(ix_ctx *ctx, const ix_surface *s,
                                 const ix_op_opts *o, ix_mv **out)
{
    ix_form k;

    IX_TRY(ix__surface_k(ctx, s, &k));
    return store_numerator(ctx, s, &k, (ix__irit_rule){6, 4, 16, 3}, o, out);
}

static ix_status mean_numerator(ix_ctx *ctx, const ix_surface *s,
                                const ix_op_opts *o, ix_mv **out)
{
    ix_form h;

    IX_TRY(ix__surface_h(ctx, s, &h));
    return store_numerator(ctx, s, &h, (ix__irit_rule){5, 3, 12, 3}, o, out);
}

/* w^2 h^2 over |m|^6. */
static ix_status mean_parts(ix_ctx *ctx, const ix_surface *s, ix_form *x,
                            ix_form *den)
{
    ix_form h, hh;

    IX_TRY(ix__surface_h(ctx, s, &h));
    IX_TRY(ix__form_mul(ctx, &h, &h, &hh));
    IX_TRY(times_weight(ctx, s, 2, &hh, x));
    return ix__form_power(ctx, &s->mm, 3, den);
}

static ix_status mean(ix_ctx *ctx, const ix_surface *s, const ix_op_opts *o,
                      ix_mv **out)
{
    ix_form x, den;
    ix__field f = {&den, &x, -2 * s->frame.exp, NULL};

    IX_TRY(mean_parts(ctx, s, &x, &den));
    f.exp -= 2; /* a quarter */
    return ix__field_store(ctx, s, &f, (ix__irit_rule){12, 6, 48, 0}, o, out);
}

/* w^2 h^2 - 2 w^4 k M over M^3. */
static ix_status total(ix_ctx *ctx, const ix_surface *s, const ix_op_opts *o,
                       ix_mv **out)
{
    ix_form x, den, k, wk, twice;
    ix__field f = {&den, &x, -2 * s->frame.exp, NULL};

    IX_TRY(mean_parts(ctx, s, &x, &den));
    IX_TRY(ix__surface_k(ctx, s, &k));
    IX_TRY(times_weight(ctx, s, 4, &k, &wk));
    IX_TRY(ix__form_copy(ctx, &s->mm, &twice));
    ix__form_times(&twice, 2.0);
    IX_TRY(ix__form_mul_add(ctx, &wk, -1, &twice, &x));
    return ix__field_store(ctx, s, &f, (ix__irit_rule){12, 6, 24, 0}, o, out);
}

/* w^6 b^2 over g^2 M. */
static ix_status along(ix_ctx *ctx, const ix_surface *s, int dir,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_form bb, gg, x, den;
    ix__field f = {&den, &x, -2 * s->frame.exp, NULL};

    IX_TRY(ix__form_mul(ctx, &s->b[2 * dir], &s->b[2 * dir], &bb));
    IX_TRY(times_weight(ctx, s, 6, &bb, &x));
    IX_TRY(ix__form_mul(ctx, &s->g[2 * dir], &s->g[2 * dir], &gg));
    IX_TRY(ix__form_mul(ctx, &gg, &s->mm, &den));
    return ix__field_store(ctx, s, &f, (ix__irit_rule){0, 0, 0, 0}, o, out);
}

/* --- entries
 * ----------------------------------------------------------------------- */

typedef ix_status (*field_fn)(ix_ctx *ctx, const ix_surface *s,
                              const ix_op_opts *o, ix_mv **out);

static ix_status along_u(ix_ctx *ctx, const ix_surface *s, const ix_op_opts *o,
                         ix_mv **out)
{
    return along(ctx, s, 0, o, out);
}

static ix_status along_v(ix_ctx *ctx, const ix_surface *s, const ix_op_opts *o,
                         ix_mv **out)
{
    return along(ctx, s, 1, o, out);
}

static ix_status build(ix_ctx *ctx, const ix_mv *m, field_fn fn,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_surface s;

    IX_TRY(ix__surface_load(ctx, m, NULL, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    return fn(ctx, &s, o, out);
}

/* which < 0: a numerator. */
static ix_status field(ix_ctx *ctx, const ix_mv *m, field_fn fn, int which,
                       const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    st = build(ctx, m, fn, o, out);
    ix__scratch_release(ctx, mk);
    IX_TRY(st);
    if (which < 0) {
        report_numerator(o, *out, rep);
        return IX_OK;
    }
    st = ix__srf_measure(ctx, m, *out, value, which, o, rep);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}

ix_status ix_srf_gauss(ix_ctx *ctx, const ix_mv *s, bool numerator,
                       const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return numerator ? field(ctx, s, gauss_numerator, -1, o, rep, out)
                     : field(ctx, s, gauss, GAUSS, o, rep, out);
}

ix_status ix_srf_mean(ix_ctx *ctx, const ix_mv *s, bool numerator,
                      const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return numerator ? field(ctx, s, mean_numerator, -1, o, rep, out)
                     : field(ctx, s, mean, MEAN_SQR, o, rep, out);
}

ix_status ix_srf_curvature(ix_ctx *ctx, const ix_mv *s,
                           ix_srf_curvature_kind kind, const ix_op_opts *o,
                           ix_report *rep, ix_mv **out)
{
    static const field_fn fns[3] = {along_u, along_v, total};

    *out = NULL;
    if (kind < IX_SRF_ALONG_U || kind > IX_SRF_TOTAL)
        return IX_FAIL(ctx, IX_EARG, "kind of curvature %d", (int)kind);
    return field(ctx, s, fns[kind], ALONG_U + (int)kind, o, rep, out);
}
