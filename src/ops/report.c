/* report.c - reports, and derivatives of a curve at a few parameters, against
 * which results are measured. */
#include "ops/report.h"

#include <math.h>
#include <string.h>

#include "mv/mv.h"

enum { PROBES = 9, DERIVS = 3 };

void ix__report_init(ix_report *rep, ix_degree_form form, const ix_mv *result)
{
    if (!rep)
        return;
    *rep = (ix_report){.form = form, .ndirs = ix_mv_ndirs(result)};
    for (int i = 0; i < rep->ndirs; i++)
        rep->orders[i] = ix_mv_order(result, i);
    rep->residual = (double)NAN;
    rep->how = "not measured";
}

ix_status ix__form_of_opts(ix_ctx *ctx, const ix_op_opts *o,
                           ix_degree_form *out)
{
    *out = o ? o->form : IX_FORM_MINIMAL;
    if (*out < IX_FORM_MINIMAL || *out > IX_FORM_IRIT)
        return IX_FAIL(ctx, IX_EARG, "degree form %d is not in 0 .. 3",
                       (int)*out);
    return IX_OK;
}

void ix__report_place(const ix_mv *srf, int i, double t[2])
{
    const int at[2] = {i % 5, i / 5};
    double dom[2];

    for (int k = 0; k < 2; k++) {
        ix_mv_domain(srf, k, dom);
        t[k] = dom[0] + (dom[1] - dom[0]) * (at[k] + 0.5) / 5;
    }
}

/* The weight and derivatives at t; false at a pole. */
static ix_status probe_at(ix_ctx *ctx, const ix_mv *crv, double t,
                          ix_probe *out, bool *ok)
{
    double axes[IX_MAX_COORDS + 1], d[(DERIVS + 1) * IX_MAX_COORDS];
    int nc = ix_mv_ncoords(crv);
    ix_status st;

    *out = (ix_probe){.t = t, .w = 1.0};
    IX_TRY(ix_mv_eval(ctx, crv, &t, axes));
    if (ix_mv_rational(crv))
        out->w = axes[0];
    st = ix_mv_curve_derivs(ctx, crv, t, DERIVS, d);
    *ok = st == IX_OK;
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    for (int k = 0; k <= DERIVS; k++)
        memcpy(out->x[k], d + k * nc,
               (size_t)(nc < 3 ? nc : 3) * sizeof(double));
    return IX_OK;
}

ix_status ix__probe(ix_ctx *ctx, const ix_mv *crv, ix__probe_fn fn,
                    const void *arg, double *worst)
{
    double dom[2];

    ix_mv_domain(crv, 0, dom);
    for (int i = 0; i < PROBES; i++) {
        /* not at fractions where knots like to be */
        double u = (i + 0.4375) / PROBES;
        ix_probe at;
        bool ok;

        IX_TRY(probe_at(ctx, crv, dom[0] + u * (dom[1] - dom[0]), &at, &ok));
        if (ok)
            IX_TRY(fn(ctx, &at, arg, worst));
    }
    return IX_OK;
}

ix_status ix__report_probed(ix_ctx *ctx, const ix_mv *crv, ix_degree_form form,
                            ix__probe_fn fn, const void *arg, const char *how,
                            ix_report *rep, ix_mv *m, ix_mv **out)
{
    ix_status st = IX_OK;

    ix__report_init(rep, form, m);
    if (rep) {
        rep->residual = 0.0;
        rep->how = how;
        st = ix__probe(ctx, crv, fn, arg, &rep->residual);
    }
    if (st == IX_OK)
        *out = m;
    else
        ix_mv_unref(ctx, m);
    return st;
}
