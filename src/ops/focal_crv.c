/* focal_crv.c - the centres of the osculating spheres of a space curve.
 *
 * y = c - x satisfies y.x' = 0, y.x'' = |x'|^2, y.x''' = 3 x'.x''. By Cramer's
 * rule, with B = x' x x'',
 *
 *   y = (3/2 (|x'|^2)' B - |x'|^2 B') / det(x', x'', x''')
 *
 * which is rational, and with |x'|^2 = Q / w^4, B = V / w^3, det = T / w^4 it
 * is minus the slope of ops/curve.h, for V in place of the curvature, over w^4
 * T. */
#include <limits.h>
#include <math.h>

#include "geom/vec3.h"
#include "iritx/ops_crv.h"
#include "ops/published.h"
#include "ops/ratio.h"
#include "ops/report.h"

/* (a p + y) / b with b = a w. */
static ix_status add_point(ix_ctx *ctx, const ix_curve *c, const ix_form *a,
                           int sign, const ix_form *y, ix_frac *out)
{
    ix_form ap;

    IX_TRY(ix__form_mul(ctx, &c->p, a, &ap));
    IX_TRY(ix__form_add(ctx, &ap, sign, y, &out->x));
    return ix__form_mul(ctx, a, &c->w, &out->w);
}

static ix_status minimal(ix_ctx *ctx, const ix_curve *c, ix_frac *out)
{
    ix_form y, w3, a;

    IX_TRY(ix__curve_slope(ctx, c, &c->v, 1, &y));
    IX_TRY(ix__form_power(ctx, &c->w, 3, &w3));
    IX_TRY(ix__form_mul(ctx, &c->t, &w3, &a));
    return add_point(ctx, c, &a, -1, &y, out);
}

/* w (3/2 Q'B - Q B') - 2 w'Q B over w^3 det(D1, D2, D3), B = D1 x D2. */
static ix_status published(ix_ctx *ctx, const ix_curve *c, ix_frac *out)
{
    ix_form dq, db, dw, y, z, t, a;
    ix_published p;

    IX_TRY(ix__published_of(ctx, c, &p));
    IX_TRY(ix__published_torsion(ctx, &p, &t));
    IX_TRY(ix__form_derive(ctx, &p.q, 0, &dq));
    IX_TRY(ix__form_derive(ctx, &p.b, 0, &db));
    IX_TRY(ix__form_derive(ctx, &c->w, 0, &dw));
    IX_TRY(ix__form_mul(ctx, &p.b, &dq, &y));
    ix__form_times(&y, 1.5);
    IX_TRY(ix__form_mul_add(ctx, &db, -1, &p.q, &y));
    IX_TRY(ix__form_mul(ctx, &y, &c->w, &y));
    if (c->rational) {
        IX_TRY(ix__form_mul(ctx, &p.b, &p.q, &z));
        ix__form_times(&z, 2.0);
        IX_TRY(ix__form_mul_add(ctx, &z, -1, &dw, &y));
    }
    IX_TRY(ix__form_mul(ctx, &c->w, &c->w, &a));
    IX_TRY(ix__form_mul(ctx, &t, &a, &a));
    return add_point(ctx, c, &a, 1, &y, out);
}

/* x + (3 (x'.x'') B - |x'|^2 x' x x''') / (B.x'''). */
static ix_status naive(ix_ctx *ctx, const ix_curve *c, ix_frac *out)
{
    ix_frac x = ix__ratio_of(c), d[3], b, s, y, z;

    IX_TRY(ix__ratio_derive(ctx, &x, &d[0]));
    IX_TRY(ix__ratio_derive(ctx, &d[0], &d[1]));
    IX_TRY(ix__ratio_derive(ctx, &d[1], &d[2]));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[1], &b));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[1], &s));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &b, &s, &y));
    ix__form_times(&y.x, 3.0);
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &s));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[2], &z));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &z, &s, &z));
    IX_TRY(ix__ratio_add(ctx, &y, -1, &z, &y));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &d[2], &b));
    IX_TRY(ix__ratio_over(ctx, &y, &b, &y));
    return ix__ratio_add(ctx, &x, 1, &y, out);
}

static const ix__curve_frac builders[] = {[IX_FORM_MINIMAL] = minimal,
                                          [IX_FORM_PUBLISHED] = published,
                                          [IX_FORM_NAIVE] = naive,
                                          [IX_FORM_IRIT] = minimal};

static ix_status check_torsion(ix_ctx *ctx, const ix_curve *c)
{
    const ix_spans *sp = &c->p.dirs[0];

    for (int j = 0; j < sp->nspans; j++)
        if (ix__extent_is_zero(c->et[j]))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "the curve lies in a plane over [%g, %g]: the "
                           "centres of its osculating spheres are at infinity",
                           sp->breaks[j], sp->breaks[j + 1]);
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_mv *crv, ix_degree_form form,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_op_opts own = {form, o ? o->max_cont : INT_MAX};
    ix__curve_frac build_by = builders[form];
    ix_form f;
    ix_curve c;

    IX_TRY(
        ix__curve_load(ctx, crv, IX__CURVE_SPACE, form == IX_FORM_MINIMAL, &c));
    IX_TRY(ix__curve_torsion(ctx, &c, &c.t, &c.et));
    IX_TRY(check_torsion(ctx, &c));
    IX_TRY(ix__curve_forms(ctx, &c, ix__ratio_forms, &build_by, &f));
    return ix__curve_store(ctx, &c, &f, 3, ix__join_rule(&own), out);
}

/* The three equations, each relative to the largest of its terms. */
static ix_status contact(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    const ix_mv *f = arg;
    double c[3], r[3], len, q = ix__dot3(at->x[1], at->x[1]);
    double want[4] = {0, 0, q, 3 * ix__dot3(at->x[1], at->x[2])};

    IX_TRY(ix_mv_point(ctx, f, &at->t, c));
    ix__sub3(c, at->x[0], r);
    len = ix__len3(r);
    if (!(len <= 1e6 * (1.0 + ix__len3(at->x[0])))) /* a pole */
        return IX_OK;
    len = fmax(len, 1e-4 * ix__len3(c));
    for (int k = 1; k < 4; k++)
        *worst = fmax(*worst,
                      fabs(ix__dot3(r, at->x[k]) - want[k]) /
                          fmax(fabs(want[k]), len * ix__len3(at->x[k])));
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out)
{
    ix_degree_form form;
    ix_mv *f;

    IX_TRY(ix__form_of_opts(ctx, o, &form));
    if (form == IX_FORM_IRIT)
        form = IX_FORM_MINIMAL;
    IX_TRY(build(ctx, crv, form, o, &f));
    return ix__report_probed(
        ctx, crv, form, contact, f,
        "contact of third order at nine parameters, relative", rep, f, out);
}

ix_status ix_focal_crv(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                       ix_report *rep, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, run(ctx, crv, o, rep, out));
}
