/* srf_jet.c - derivatives of a surface at one point, by the quotient rule, and
 * results measured against them. Independent of the forms of surface.c. */
#include <math.h>

#include "geom/vec3.h"
#include "ops/report.h"
#include "ops/surface.h"

/* Homogeneous derivatives (i, j): weight, then three coordinates. */
static ix_status hom_partial(ix_ctx *ctx, const ix_mv *s, const double t[2],
                             int i, int j, double out[4])
{
    double x[4] = {0};
    int k[2] = {i, j}, r = s->rational ? 1 : 0;

    IX_TRY(ix_mv_partial(ctx, s, t, k, x));
    out[0] = r ? x[0] : (double)(i + j == 0);
    for (int c = 0; c < 3; c++)
        out[c + 1] = c < s->ncoords ? x[c + r] : 0.0;
    return IX_OK;
}

static void divide(double h[6][4], ix_srf_jet *o)
{
    double w = h[0][0];

    for (int c = 0; c < 3; c++) {
        double x = h[0][c + 1] / w, a, b;

        o->s[c] = x;
        a = o->su[c] = (h[1][c + 1] - x * h[1][0]) / w;
        b = o->sv[c] = (h[2][c + 1] - x * h[2][0]) / w;
        o->suu[c] = (h[3][c + 1] - x * h[3][0] - 2.0 * a * h[1][0]) / w;
        o->suv[c] = (h[4][c + 1] - x * h[4][0] - a * h[2][0] - b * h[1][0]) / w;
        o->svv[c] = (h[5][c + 1] - x * h[5][0] - 2.0 * b * h[2][0]) / w;
    }
}

ix_status ix__srf_jet(ix_ctx *ctx, const ix_mv *s, double u, double v,
                      ix_srf_jet *o)
{
    static const int ij[6][2] = {{0, 0}, {1, 0}, {0, 1},
                                 {2, 0}, {1, 1}, {0, 2}};
    double h[6][4], t[2] = {u, v}, len, size;

    if (s->ndirs != 2 || s->ncoords < 2 || s->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates: a surface with 2 or "
                       "3 coordinates is needed",
                       s->ndirs, s->ncoords);
    for (int i = 0; i < 6; i++)
        IX_TRY(hom_partial(ctx, s, t, ij[i][0], ij[i][1], h[i]));
    if (h[0][0] == 0.0)
        return IX_FAIL(ctx, IX_EDOMAIN, "a pole at (%g, %g)", u, v);
    divide(h, o);
    ix__cross3(o->sv, o->su, o->n);
    len = sqrt(ix__dot3(o->n, o->n));
    size = sqrt(ix__dot3(o->su, o->su) * ix__dot3(o->sv, o->sv));
    /* as ix_srf_normal: half of the digits are left */
    if (!(len > 1e-10 * size))
        return IX_FAIL(ctx, IX_EDOMAIN, "no normal at (%g, %g)", u, v);
    o->g[0] = ix__dot3(o->su, o->su);
    o->g[1] = ix__dot3(o->su, o->sv);
    o->g[2] = ix__dot3(o->sv, o->sv);
    o->b[0] = ix__dot3(o->suu, o->n) / len;
    o->b[1] = ix__dot3(o->suv, o->n) / len;
    o->b[2] = ix__dot3(o->svv, o->n) / len;
    return IX_OK;
}

/* --- reports
 * ------------------------------------------------------------------- */

typedef struct {
    const ix_mv *s, *out;
    ix__srf_value fn;
    int which;
    double gap, size;
} comparison;

static ix_status compare_at(ix_ctx *ctx, comparison *c, const double t[2])
{
    double have[IX_MAX_COORDS], want[IX_MAX_COORDS];
    ix_srf_jet j;
    ix_status st = ix__srf_jet(ctx, c->s, t[0], t[1], &j);

    if (st == IX_OK)
        st = ix_mv_point(ctx, c->out, t, have);
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    c->fn(&j, c->which, want);
    for (int k = 0; k < c->out->ncoords; k++) {
        if (!isfinite(want[k]))
            return IX_OK;
        c->size = fmax(c->size, fabs(want[k]));
        c->gap = fmax(c->gap, fabs(have[k] - want[k]));
    }
    return IX_OK;
}

ix_status ix__srf_measure(ix_ctx *ctx, const ix_mv *s, const ix_mv *out,
                          ix__srf_value fn, int which, const ix_op_opts *o,
                          ix_report *rep)
{
    comparison c = {s, out, fn, which, 0.0, 0.0};
    ix_frame frame;

    if (!rep)
        return IX_OK;
    *rep = (ix_report){
        .form = o ? o->form : IX_FORM_MINIMAL,
        .ndirs = 2,
        .residual = NAN,
        .how = "against derivatives on a 5 x 5 grid, relative "
               "to the largest value or the size of the surface"};
    IX_TRY(ix__frame_of(ctx, 1, &s, &frame));
    c.size = ldexp(1.0, out->ncoords == 1 ? -2 * frame.exp : frame.exp);
    for (int i = 0; i < 2; i++)
        rep->orders[i] = ix_mv_order(out, i);
    for (int i = 0; i < IX__PLACES; i++) {
        double t[2];

        ix__report_place(s, i, t);
        IX_TRY(compare_at(ctx, &c, t));
    }
    rep->residual = c.gap / fmax(c.size, c.gap);
    return IX_OK;
}
