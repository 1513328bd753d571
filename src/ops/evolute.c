/* evolute.c - the centres of curvature of planar and space curves.
 *
 * With x' = D / w^2 and x' x x'' = V / w^3 (ops/curve.h) the radius vector
 * N / kappa = |x'|^2 / |x' x x''|^2 (x' x x'') x x' is Q V x D / (w^3 |V|^2);
 * in the plane one factor V cancels. All terms of x + N / kappa over one
 * denominator have the degree of the last one: nothing is to be reduced. */
#include <math.h>
#include <string.h>

#include "geom/crvs.h"
#include "geom/vec3.h"
#include "iritx/ops_crv.h"
#include "ops/published.h"
#include "ops/ratio.h"
#include "ops/report.h"

/* Numerators and denominator of the result, in the frame. */
typedef struct {
    ix_form x, w;
} fraction;

/* a b + c d. */
static ix_status sum_of_products(ix_ctx *ctx, const ix_form *a,
                                 const ix_form *b, const ix_form *c,
                                 const ix_form *d, ix_form *out)
{
    IX_TRY(ix__form_mul(ctx, a, b, out));
    return ix__form_mul_add(ctx, c, 1, d, out);
}

/* (w^2 v p + r) / (w^3 v), v = V in the plane, |V|^2 in space. */
static ix_status over_weight(ix_ctx *ctx, const ix_curve *c, const ix_form *v,
                             const ix_form *r, fraction *out)
{
    static const double one = 1.0;
    ix_form w2, vw2, unit;

    IX_TRY(ix__form_constant(ctx, v, 1, &one, &unit));
    IX_TRY(ix__form_mul(ctx, &c->w, &c->w, &w2));
    IX_TRY(ix__form_mul(ctx, v, &w2, &vw2));
    IX_TRY(ix__form_mul(ctx, &vw2, &c->w, &out->w));
    return sum_of_products(ctx, &c->p, &vw2, r, &unit, &out->x);
}

/* The longest of the vectors of Bernstein coefficients double[3][n], its length
 * made 1; false if all are 0. */
static bool longest(const double *b, size_t n, double out[3])
{
    double most = 0.0;

    for (size_t i = 0; i < n; i++) {
        const double v[3] = {b[i], b[n + i], b[2 * n + i]};

        if (ix__len3(v) > most) {
            most = ix__len3(v);
            memcpy(out, v, sizeof v);
        }
    }
    return most > 0.0 && ix__unit3(out, out) > 0.0;
}

/* Whether V has one direction throughout, within its error: a planar curve in
 * space, and the normal of its plane. */
static ix_status in_plane(ix_ctx *ctx, const ix_curve *c, double normal[3],
                          bool *yes)
{
    size_t n = c->v.n, m = (size_t)c->v.dirs[0].degree + 1;
    const double *b;

    IX_TRY(ix__form_bernstein(ctx, &c->v, &b));
    *yes = longest(b, n, normal);
    for (size_t i = 0; *yes && i < n; i++) {
        const double v[3] = {b[i], b[n + i], b[2 * n + i]};
        double off[3];

        ix__cross3(v, normal, off);
        *yes = ix__len3(off) <= c->ev[i / m].error;
    }
    return IX_OK;
}

/* V = K n with constant n: one factor K cancels, as in the plane. */
static ix_status minimal_in_plane(ix_ctx *ctx, const ix_curve *c,
                                  const double normal[3], fraction *out)
{
    ix_form n, k, r;

    IX_TRY(ix__form_constant(ctx, &c->p, 3, normal, &n));
    IX_TRY(ix__form_dot(ctx, &c->v, &n, &k));
    IX_TRY(ix__form_cross(ctx, &n, &c->d, &r));
    IX_TRY(ix__form_mul(ctx, &r, &c->q, &r));
    return over_weight(ctx, c, &k, &r, out);
}

/* Which formula, decided for the curve as a whole. */
typedef struct {
    ix_degree_form form;
    bool planar; /* a space curve in a plane with this normal */
    double normal[3];
} choice;

static ix_status minimal(ix_ctx *ctx, const ix_curve *c, const choice *how,
                         fraction *out)
{
    ix_form r, v;

    if (c->dim == 2) {
        IX_TRY(ix__form_turned(ctx, &c->q, &c->d, &r));
        return over_weight(ctx, c, &c->v, &r, out);
    }
    if (how->planar)
        return minimal_in_plane(ctx, c, how->normal, out);
    IX_TRY(ix__form_cross(ctx, &c->v, &c->d, &r));
    IX_TRY(ix__form_mul(ctx, &r, &c->q, &r));
    IX_TRY(ix__form_dot(ctx, &c->v, &c->v, &v));
    return over_weight(ctx, c, &v, &r, out);
}

/* ([D1 D2] w p + |D1|^2 D1_r) / ([D1 D2] w^2) and in space, from (4.4),
 * (|D1 x D2|^2 w p + |D1|^2 (D1 x D2) x D1) / (|D1 x D2|^2 w^2). */
static ix_status published(ix_ctx *ctx, const ix_curve *c, fraction *out)
{
    ix_form r, v, vw;
    ix_published p;

    IX_TRY(ix__published_of(ctx, c, &p));
    if (c->dim == 2) {
        IX_TRY(ix__form_turned(ctx, &p.q, &p.d1, &r));
        v = p.b;
    } else {
        IX_TRY(ix__form_cross(ctx, &p.b, &p.d1, &r));
        IX_TRY(ix__form_mul(ctx, &r, &p.q, &r));
        IX_TRY(ix__form_dot(ctx, &p.b, &p.b, &v));
    }
    IX_TRY(ix__form_mul(ctx, &v, &c->w, &vw));
    IX_TRY(ix__form_mul(ctx, &vw, &c->w, &out->w));
    IX_TRY(ix__form_mul(ctx, &c->p, &vw, &out->x));
    return ix__form_add(ctx, &out->x, 1, &r, &out->x);
}

/* N / kappa in the plane: |x'|^2 / det(x', x'') x'_r. */
static ix_status naive_planar(ix_ctx *ctx, const ix_frac *d, ix_frac *out)
{
    ix_frac q, b;

    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_det2, &d[0], &d[1], &b));
    IX_TRY(ix__ratio_over(ctx, &q, &b, &q));
    return ix__ratio_product(ctx, ix__form_turned, &q, &d[0], out);
}

/* In space: (x' x x'') x x' |x'|^2 / |x' x x''|^2. */
static ix_status naive_space(ix_ctx *ctx, const ix_frac *d, ix_frac *out)
{
    ix_frac q, b, n;

    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[1], &b));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &b, &d[0], &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &n, &q, &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &b, &b));
    return ix__ratio_over(ctx, &n, &b, out);
}

static ix_status naive(ix_ctx *ctx, const ix_curve *c, bool irit, fraction *out)
{
    ix_frac f = ix__ratio_of(c), d[2], r;

    IX_TRY(ix__ratio_derive(ctx, &f, &d[0]));
    IX_TRY(ix__ratio_derive(ctx, &d[0], &d[1]));
    if (c->dim == 2)
        IX_TRY(naive_planar(ctx, d, &r));
    else
        IX_TRY(naive_space(ctx, d, &r));
    if (irit)
        IX_TRY(ix__ratio_even(ctx, &r));
    IX_TRY(ix__ratio_add(ctx, &f, 1, &r, &r));
    out->x = r.x;
    out->w = r.w;
    return IX_OK;
}

static ix_status centres(ix_ctx *ctx, const ix_curve *c, void *arg,
                         ix_form *out)
{
    const choice *how = arg;
    fraction f;

    if (how->form == IX_FORM_MINIMAL)
        IX_TRY(minimal(ctx, c, how, &f));
    else if (how->form == IX_FORM_PUBLISHED)
        IX_TRY(published(ctx, c, &f));
    else
        IX_TRY(naive(ctx, c, how->form == IX_FORM_IRIT, &f));
    out[0] = f.w;
    out[1] = f.x;
    return IX_OK;
}

/* --- degenerate input --------------------------------------------------- */

static ix_status check_curved(ix_ctx *ctx, const ix_curve *c)
{
    const ix_spans *sp = &c->p.dirs[0];

    for (int j = 0; j < sp->nspans; j++)
        if (ix__extent_is_zero(c->ev[j]))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "the curve is straight over [%g, %g]: its evolute "
                           "is at infinity there",
                           sp->breaks[j], sp->breaks[j + 1]);
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_mv *crv, ix_degree_form form,
                       const ix_op_opts *o, ix_mv **out)
{
    bool irit = form == IX_FORM_IRIT;
    choice how = {.form = form};
    ix_form f;
    ix_curve c;

    IX_TRY(ix__curve_load(ctx, crv, irit ? IX__CURVE_SPACE : IX__CURVE,
                          form == IX_FORM_MINIMAL, &c));
    IX_TRY(check_curved(ctx, &c));
    if (form == IX_FORM_MINIMAL && c.dim == 3)
        IX_TRY(in_plane(ctx, &c, how.normal, &how.planar));
    IX_TRY(ix__curve_forms(ctx, &c, centres, &how, &f));
    return ix__curve_store(ctx, &c, &f, irit ? 3 : c.ncoords, ix__join_rule(o),
                           out);
}

/* --- the report --------------------------------------------------------- */

/* (E - x).x' = 0 relative to |E - x| |x'|, (E - x).x'' = |x'|^2 relative to
 * |E - x| |x''| (at least |x'|^2); poles, farther away than a million times
 * the coordinates, are left out. */
static ix_status contact(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    const ix_mv *e = arg;
    double c[3] = {0, 0, 0}, r[3], len, q = ix__dot3(at->x[1], at->x[1]);

    IX_TRY(ix_mv_point(ctx, e, &at->t, c));
    ix__sub3(c, at->x[0], r);
    len = ix__len3(r);
    if (!(len <= 1e6 * (1.0 + ix__len3(at->x[0]))))
        return IX_OK;
    /* the centre itself cannot be known better than its coordinates */
    len = fmax(len, 1e-4 * ix__len3(c));
    *worst = fmax(*worst, fabs(ix__dot3(r, at->x[1])) / (len * sqrt(q)));
    *worst = fmax(*worst, fabs(ix__dot3(r, at->x[2]) - q) /
                              fmax(q, len * ix__len3(at->x[2])));
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out)
{
    ix_degree_form form;
    ix_mv *e;

    IX_TRY(ix__form_of_opts(ctx, o, &form));
    IX_TRY(build(ctx, crv, form, o, &e));
    return ix__report_probed(
        ctx, crv, form, contact, e,
        "contact of second order at nine parameters, relative to "
        "the radius",
        rep, e, out);
}

ix_status ix_evolute(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, run(ctx, crv, o, rep, out));
}

/* --- pieces ------------------------------------------------------------- */

/* The maximal runs of spans that are not straight: double[n][2]. */
static ix_status curved_runs(ix_ctx *ctx, const ix_curve *c, int *n,
                             double **out)
{
    const ix_spans *sp = &c->p.dirs[0];
    bool open = false;
    double *t;

    *n = 0;
    IX_SCRATCH(ctx, t, 2 * (size_t)sp->nspans);
    for (int j = 0; j < sp->nspans; j++) {
        bool flat = ix__extent_is_zero(c->ev[j]);

        if (!flat && !open)
            t[2 * (*n)++] = sp->breaks[j];
        if (!flat)
            t[2 * *n - 1] = sp->breaks[j + 1];
        open = !flat;
    }
    *out = t;
    return IX_OK;
}

static ix_status one_piece(ix_ctx *ctx, const ix_mv *crv, const double *t,
                           bool whole, const ix_op_opts *o, ix_mv **out)
{
    ix_mv *part;
    ix_status st;

    if (whole)
        return ix_evolute(ctx, crv, o, NULL, out);
    IX_TRY(ix_mv_region(ctx, crv, 0, t[0], t[1], &part));
    st = ix_evolute(ctx, part, o, NULL, out);
    ix_mv_unref(ctx, part);
    return st;
}

static ix_status pieces(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                        ix_crvs *out)
{
    double *t, dom[2];
    ix_curve c;
    ix_status st;
    int n;

    IX_TRY(ix__curve_load(ctx, crv, IX__CURVE, true, &c));
    IX_TRY(curved_runs(ctx, &c, &n, &t));
    ix_mv_domain(crv, 0, dom);
    IX_TRY(ix__crvs_new(ctx, n, out));
    st = IX_OK;
    for (int i = 0; st == IX_OK && i < n; i++) {
        bool whole = n == 1 && t[0] == dom[0] && t[1] == dom[1];

        st = one_piece(ctx, crv, t + 2 * i, whole, o, &out->crv[i]);
        memcpy(out->t + 2 * i, t + 2 * i, 2 * sizeof *t);
    }
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    return st;
}

ix_status ix_evolute_pieces(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                            ix_crvs *out)
{
    *out = (ix_crvs){.n = 0};
    IX_RETURN_SCOPED(ctx, pieces(ctx, crv, o, out));
}
