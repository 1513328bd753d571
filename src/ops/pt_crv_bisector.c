/* pt_crv_bisector.c - the untrimmed bisector of a point and a planar curve.
 *
 * Two linear equations for B - Q (pt_crv.h) solved by minors. The degree forms
 * differ in what stands for the tangent, and in factors of w that are left in.
 */
#include <limits.h>

#include "iritx/ops_bisect.h"
#include "ops/pt_crv.h"
#include "ops/published.h"
#include "ops/ratio.h"

typedef struct {
    ix_form x, w;
} fraction;

/* With a tangent of any degree: Q + (rr turned D - r.D turned r) / (w det). */
static ix_status solved(ix_ctx *ctx, const ix_pt_crv *c, const ix_form *d,
                        fraction *out)
{
    ix_form rd, det, a, b;

    IX_TRY(ix__form_det2(ctx, d, &c->r, &det));
    IX_TRY(ix__pt_crv_check(ctx, c, &det));
    IX_TRY(ix__form_dot(ctx, &c->r, d, &rd));
    IX_TRY(ix__form_turned(ctx, &c->rr, d, &a));
    IX_TRY(ix__form_turned(ctx, &rd, &c->r, &b));
    IX_TRY(ix__form_add(ctx, &a, -1, &b, &a));
    IX_TRY(ix__pt_crv_weigh(ctx, c, &det, &out->w));
    return ix__pt_crv_from_point(ctx, c, &a, &out->w, &out->x);
}

static ix_status published(ix_ctx *ctx, const ix_pt_crv *c, fraction *out)
{
    ix_published p;

    IX_TRY(ix__published_of(ctx, &c->c, &p));
    return solved(ctx, c, &p.d1, out);
}

/* Cramer's rule on fractions, the elements of a row over one denominator:
 * x'.b = x'.y, y.b = (1 - alpha) |y|^2 with y = x - Q. IRIT has the determinant
 * of the same rows below, so that the denominators cancel. */
static ix_status naive(ix_ctx *ctx, const ix_pt_crv *c, bool irit,
                       fraction *out)
{
    ix_frac y = {c->r, c->c.w, c->c.rational}, d, rows[2], right[2], det, b;
    ix_form s, t;

    IX_TRY(ix__ratio_derive(ctx, &y, &d));
    IX_TRY(ix__ratio_product(ctx, ix__form_det2, &d, &y, &det));
    IX_TRY(ix__pt_crv_check(ctx, c, &det.x));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d, &y, &right[0]));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &y, &y, &right[1]));
    right[1].x = c->rr;
    rows[0] = d;
    rows[1] = y;
    for (int i = 0; i < 2 && c->c.rational; i++)
        IX_TRY(ix__form_mul(ctx, &rows[i].x, &c->c.w, &rows[i].x));
    IX_TRY(ix__form_turned(ctx, &right[1].x, &rows[0].x, &s));
    IX_TRY(ix__form_turned(ctx, &right[0].x, &rows[1].x, &t));
    IX_TRY(ix__frac_weights(ctx, &right[0], &right[1], &b));
    IX_TRY(ix__form_add(ctx, &s, -1, &t, &b.x));
    if (irit)
        IX_TRY(ix__form_det2(ctx, &rows[0].x, &rows[1].x, &b.w));
    else
        IX_TRY(ix__ratio_over(ctx, &b, &det, &b));
    out->w = b.w;
    return ix__pt_crv_from_point(ctx, c, &b.x, &out->w, &out->x);
}

static ix_status build(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                       double alpha, const ix_op_opts *o, ix_mv **out)
{
    ix_join_rule rule = ix__join_rule(o);
    ix_pt_crv c;
    fraction f;
    const ix_form *parts[2] = {&f.w, &f.x};
    ix_form all;

    IX_TRY(ix__pt_crv_load(ctx, crv, IX__CURVE_FLAT, q, alpha,
                           o->form == IX_FORM_MINIMAL, &c));
    if (o->form == IX_FORM_MINIMAL)
        IX_TRY(solved(ctx, &c, &c.c.d, &f));
    else if (o->form == IX_FORM_PUBLISHED)
        IX_TRY(published(ctx, &c, &f));
    else
        IX_TRY(naive(ctx, &c, o->form == IX_FORM_IRIT, &f));
    IX_TRY(ix__form_join(ctx, 2, parts, &all));
    rule.max_cont = o->max_cont; /* IRIT keeps continuity here */
    return ix__curve_store(ctx, &c.c, &all, 2, rule, out);
}

static ix_status compare(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    const ix_pt_crv_probe *a = arg;
    ix_probe flat = *at;
    double b[3] = {0, 0, 0};
    ix_status st = ix_mv_point(ctx, a->m, &at->t, b);

    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    flat.x[0][2] = flat.x[1][2] = 0.0;
    ix__pt_crv_residual(&flat, b, a, worst);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                     double alpha, ix_op_opts o, ix_report *rep, ix_mv **out)
{
    const double at[3] = {q[0], q[1], 0.0};
    ix_pt_crv_probe arg = {NULL, at, alpha};
    ix_mv *m;

    IX_TRY(build(ctx, crv, q, alpha, &o, &m));
    arg.m = m;
    return ix__report_probed(ctx, crv, o.form, compare, &arg,
                             "distance from normal and dividing line at nine "
                             "parameters, relative",
                             rep, m, out);
}

ix_status ix_pt_crv_bisector(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                             double alpha, const ix_op_opts *o, ix_report *rep,
                             ix_mv **out)
{
    ix_op_opts own = {.max_cont = o ? o->max_cont : INT_MAX};

    *out = NULL;
    IX_TRY(ix__form_of_opts(ctx, o, &own.form));
    IX_RETURN_SCOPED(ctx, run(ctx, crv, q, alpha, own, rep, out));
}
