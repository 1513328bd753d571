/* srf_focal_crv.c - the focal points of a curve on a surface.
 *
 * For each t the first zero s of the Jacobi field y along the geodesic at a
 * right angle is located as an event. With z = dy/dt, integrated beside it,
 * ds/dt = -z / y' (Rausch et al. (5.5)): this is the derivative that the
 * result interpolates, and its integral over t is what s is measured against.
 */
#include <math.h>
#include <string.h>

#include "ops/geo.h"

enum { MEASURED = 12 }; /* steps over which the integral of ds/dt is compared */

typedef struct {
    ix__geo *g;
    double side;
    double lo, hi; /* while ds/dt is integrated */
    ix_status st;
} focal;

/* Of a sample: u, v, u', v', s, ds/dt, t. */
enum { AT_S = 4, AT_SLOPE = 5, AT_T = 6 };

static ix_status sample(void *ud, double t, double lo, double hi,
                        ix__geo_sample *out, bool *ok, ix_geo_stop *why)
{
    const ix__geo_way way = {.variation = true, .stop_at_focal = true};
    const focal *f = ud;
    const ix__geo_crv *c = &f->g->c[0];
    ix__geo_shot shot;
    double slope, duv[2];

    IX_TRY(ix__geo_shoot(f->g, c, ix__geo_crv_span_in(c, t, lo, hi), t,
                         f->side * f->g->reach, &way, &shot));
    *ok = shot.stop == IX_GEO_FOCAL;
    *why = shot.stop == IX_GEO_END ? IX_GEO_REACH : shot.stop;
    if (!*ok)
        return IX_OK;
    slope = -shot.q[6] / shot.q[5];
    for (int i = 0; i < 2; i++)
        duv[i] = shot.q[2 + i] * slope / c->len;
    memcpy(out->state, shot.q, 4 * sizeof(double));
    out->state[AT_S] = shot.s;
    out->state[AT_SLOPE] = slope;
    *ok = ix__geo_fill(f->g, shot.cell, shot.q, duv, out);
    return IX_OK;
}

/* (t, s, u, v, ds/dt). */
static void row(const void *ud, const ix__geo_sample *a, double *out)
{
    const ix__geo *g = ((const focal *)ud)->g;

    out[0] = a->x;
    out[1] = a->state[AT_S] * g->s.size;
    out[2] = a->p[0];
    out[3] = a->p[1];
    out[4] = a->state[AT_SLOPE] * g->s.size / g->c[0].len;
}

/* --- the integral of ds/dt ------------------------------------------------ */

static bool slope_at(void *ud, double t, const double *s, double *ds)
{
    const ix__geo_way way = {.variation = true, .margin = true};
    focal *f = ud;
    const ix__geo_crv *c = &f->g->c[0];
    ix__geo_shot shot;

    if (f->st == IX_OK)
        f->st = ix__geo_shoot(f->g, c, ix__geo_crv_span_in(c, t, f->lo, f->hi),
                              t, f->side * s[0], &way, &shot);
    if (f->st != IX_OK || shot.stop != IX_GEO_END)
        return false;
    ds[0] = -shot.q[6] / shot.q[5];
    return true;
}

/* From one sample to the next: the difference from the distance there. */
static ix_status integrate(focal *f, ix__ode *ode, const ix__geo_sample *a,
                           const ix__geo_sample *b, double *miss)
{
    double s = a->state[AT_S], t = a->state[AT_T];
    ix__ode_result result;
    int event;

    f->lo = t;
    f->hi = b->state[AT_T];
    IX_TRY(ix__ode_start(ode, t, &s, b->state[AT_T]));
    IX_TRY(ix__ode_run(ode, &t, &s, &event, &result));
    IX_TRY(f->st);
    if (result != IX_ODE_END)
        *miss = NAN;
    if (!(fabs(s - b->state[AT_S]) <= *miss))
        *miss = fabs(s - b->state[AT_S]);
    return IX_OK;
}

static ix_status integrate_some(focal *f, ix__ode *ode, const ix__geo_trace *t,
                                double *miss)
{
    int step = 1 + (t->n - 1) / MEASURED;

    *miss = 0;
    for (int i = 1; i < t->n; i += step)
        if (t->at[i].x > t->at[i - 1].x)
            IX_TRY(integrate(f, ode, &t->at[i - 1], &t->at[i], miss));
    *miss *= f->g->s.size;
    return IX_OK;
}

static ix_status measure(void *ud, const ix__geo_trace *t, double *miss)
{
    focal *f = ud;
    /* well above what the geodesics are exact to: no step follows noise */
    const ix__ode_problem p = {
        .n = 1, .f = slope_at, .ud = f, .tol = fmax(1e-3 * f->g->fit, 1e-12)};
    ix__ode *ode = NULL;
    ix_status st;

    IX_TRY(ix__ode_open(f->g->ctx, &p, &ode));
    st = integrate_some(f, ode, t, miss);
    ix__ode_close(ode);
    return st;
}

/* --- public --------------------------------------------------------------- */

static ix_status focal_crv(ix__geo *g, int side, ix__geo_found *found)
{
    focal f = {.g = g, .side = side};
    const ix__geo_along along = {.g = g,
                                 .sample = sample,
                                 .measure = measure,
                                 .row = row,
                                 .nrow = 5,
                                 .ud = &f};
    double *breaks;
    int n;

    if (side != 1 && side != -1)
        return IX_FAIL(g->ctx, IX_EARG,
                       "side %d: 1 is the left one of the curve, -1 the right",
                       side);
    IX_TRY(ix__geo_crv_rough(g->ctx, &g->c[0], &n, &breaks));
    return ix__geo_along_run(&along, n, breaks, found);
}

static ix_status open_focal(ix_ctx *ctx, const ix_geo_surface *s,
                            const ix_mv *crv, int side, const ix_geo_opts *o,
                            ix_geo_curves *out)
{
    ix__geo g;
    ix__geo_found f = {0};
    ix_status st = ix__geo_open(ctx, s, 1, &crv, o, &g);

    if (st == IX_OK)
        st = focal_crv(&g, side, &f);
    ix__geo_close(&g);
    return ix__geo_found_end(ctx, &f, st, out);
}

ix_status ix_srf_focal_crv(ix_ctx *ctx, const ix_geo_surface *s,
                           const ix_mv *crv, int side, const ix_geo_opts *o,
                           ix_geo_curves *out)
{
    IX_RETURN_SCOPED(ctx, open_focal(ctx, s, crv, side, o, out));
}
