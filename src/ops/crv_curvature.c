/* crv_curvature.c - the curvature at a parameter, and the vector of curvature
 * as a curve. */
#include <math.h>

#include "geom/vec3.h"
#include "iritx/ops_crv.h"
#include "ops/published.h"
#include "ops/ratio.h"
#include "ops/report.h"

/* --- at a parameter ----------------------------------------------------- */

static ix_status curvature_at(ix_ctx *ctx, const ix_mv *crv, double t,
                              double *out)
{
    double d[3 * IX_MAX_COORDS], x[2][3] = {{0}}, b[3], speed;
    int nc = ix_mv_ncoords(crv);

    if (crv->ndirs != 1 || nc < 2 || nc > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, %d coordinates: a curve with 2 or 3 "
                       "is needed",
                       crv->ndirs, nc);
    IX_TRY(ix_mv_curve_derivs(ctx, crv, t, 2, d));
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < nc; k++)
            x[i][k] = d[(i + 1) * nc + k];
    speed = ix__unit3(x[0], x[0]);
    if (!(speed > 0))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no curvature at %g: the derivative vanishes", t);
    ix__cross3(x[0], x[1], b);
    *out = ix__len3(b) / speed / speed;
    return IX_OK;
}

ix_status ix_crv_curvature(ix_ctx *ctx, const ix_mv *crv, double t, double *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = curvature_at(ctx, crv, t, out);

    ix__scratch_release(ctx, mk);
    return st;
}

/* --- kappa N ------------------------------------------------------------ */

/* w^3 V x D / Q^2. */
static ix_status minimal(ix_ctx *ctx, const ix_curve *c, ix_frac *out)
{
    ix_form n, w;

    IX_TRY(ix__form_cross(ctx, &c->v, &c->d, &n));
    IX_TRY(ix__form_power(ctx, &c->w, 3, &w));
    IX_TRY(ix__form_mul(ctx, &n, &w, &out->x));
    return ix__form_mul(ctx, &c->q, &c->q, &out->w);
}

/* w^2 (D1 x D2) x D1 / |D1|^4. */
static ix_status published(ix_ctx *ctx, const ix_curve *c, ix_frac *out)
{
    ix_published p;
    ix_form n, w;

    IX_TRY(ix__published_of(ctx, c, &p));
    IX_TRY(ix__form_cross(ctx, &p.b, &p.d1, &n));
    IX_TRY(ix__form_mul(ctx, &c->w, &c->w, &w));
    IX_TRY(ix__form_mul(ctx, &n, &w, &out->x));
    return ix__form_mul(ctx, &p.q, &p.q, &out->w);
}

static ix_status naive(ix_ctx *ctx, const ix_curve *c, ix_frac *out)
{
    ix_frac f = ix__ratio_of(c), d[2], n, q;

    IX_TRY(ix__ratio_derive(ctx, &f, &d[0]));
    IX_TRY(ix__ratio_derive(ctx, &d[0], &d[1]));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[1], &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &n, &d[0], &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &q, &q, &q));
    IX_TRY(ix__ratio_over(ctx, &n, &q, out));
    return ix__ratio_even(ctx, out);
}

static const ix__curve_frac builders[] = {[IX_FORM_MINIMAL] = minimal,
                                          [IX_FORM_PUBLISHED] = published,
                                          [IX_FORM_NAIVE] = naive,
                                          [IX_FORM_IRIT] = naive};

static ix_status build(ix_ctx *ctx, const ix_mv *crv, ix_degree_form form,
                       const ix_op_opts *o, ix_mv **out)
{
    ix__curve_frac build_by = builders[form];
    ix_form f;
    ix_curve c;

    IX_TRY(
        ix__curve_load(ctx, crv, IX__CURVE_SPACE, form == IX_FORM_MINIMAL, &c));
    for (int j = 0; j < c.p.dirs[0].nspans; j++)
        if (ix__extent_is_zero(c.ed[j]))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "the curve is a point over [%g, %g]",
                           c.p.dirs[0].breaks[j], c.p.dirs[0].breaks[j + 1]);
    IX_TRY(ix__curve_forms(ctx, &c, ix__ratio_forms, &build_by, &f));
    return ix__rows_store(ctx, &f, true, -c.frame.exp, ix__join_rule(o), out);
}

/* |f - kappa N| relative to kappa (to 1 / |x| where that is larger). */
static ix_status compare(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    const ix_mv *f = arg;
    double b[3], n[3], v[3], q = ix__dot3(at->x[1], at->x[1]);

    ix__cross3(at->x[1], at->x[2], b);
    ix__cross3(b, at->x[1], n);
    for (int i = 0; i < 3; i++)
        n[i] /= q * q;
    IX_TRY(ix_mv_point(ctx, f, &at->t, v));
    *worst = fmax(*worst,
                  ix__dist3(n, v) / fmax(ix__len3(n), ix__len3(at->x[2]) / q));
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out)
{
    ix_degree_form form;
    ix_mv *f;

    IX_TRY(ix__form_of_opts(ctx, o, &form));
    IX_TRY(build(ctx, crv, form, o, &f));
    return ix__report_probed(ctx, crv, form, compare, f,
                             "against derivatives at nine parameters, relative",
                             rep, f, out);
}

ix_status ix_crv_normal_field(ix_ctx *ctx, const ix_mv *crv,
                              const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, run(ctx, crv, o, rep, out));
}
