/* geo_along.c - results with one point for each parameter of a border curve:
 * where they exist, and the curves that they form there. */
#include <math.h>

#include "geom/vec3.h"
#include "ops/geo.h"

enum {
    PROBES = 64,
    MOST = 16,
    LEAST = 4
}; /* of existence: of the border, at
      most and least between breaks */

typedef struct {
    const ix__geo_along *a;
    ix__geo_found *f;
    ix__geo_trace t;
    ix_geo_stop first; /* what is at the start of the trace */
    int probes;        /* between two breaks */
} tracer;

static ix_status sample_at(const ix__geo_along *a, double t, double lo,
                           double hi, ix__geo_sample *out, bool *ok,
                           ix_geo_stop *why)
{
    *out = (ix__geo_sample){.x = a->g->c[0].lo + a->g->c[0].len * t};
    IX_TRY(a->sample(a->ud, t, lo, hi, out, ok, why));
    out->state[6] = t;
    return IX_OK;
}

static ix_status mid(const void *ud, const ix__geo_sample *a,
                     const ix__geo_sample *b, double x, ix__geo_sample *out)
{
    const ix__geo_along *l = ud;
    const ix__geo_crv *c = &l->g->c[0];
    ix_geo_stop why;
    bool ok;

    IX_TRY(sample_at(l, (x - c->lo) / c->len, a->state[6], b->state[6], out,
                     &ok, &why));
    if (!ok)
        return IX_FAIL(l->g->ctx, IX_EUNABLE,
                       "between parameters %g and %g of the curve some "
                       "geodesics end early (%s)",
                       a->x, b->x, ix_geo_stop_name(why));
    return IX_OK;
}

/* The sample nearest to bad, seen from good, that exists. */
static ix_status last_good(const tracer *r, double good, double bad, double lo,
                           double hi, ix__geo_sample *out, ix_geo_stop *why)
{
    while (fabs(bad - good) > 1e-13) {
        double t = 0.5 * (good + bad);
        ix__geo_sample s;
        ix_geo_stop w;
        bool ok;

        IX_TRY(sample_at(r->a, t, lo, hi, &s, &ok, &w));
        if (ok) {
            good = t;
            *out = s;
        } else {
            bad = t;
            *why = w;
        }
    }
    return IX_OK;
}

/* What was traced becomes a curve; nothing if it is a point. */
static ix_status end_curve(tracer *r, ix_geo_stop last)
{
    ix_ctx *ctx = r->a->g->ctx;
    ix_geo_curve c = {.stop = {r->first, last}};
    ix_status st;

    r->first = last;
    if (r->t.n < 2 || !(r->t.at[r->t.n - 1].x > r->t.at[0].x)) {
        r->t.n = 0;
        return IX_OK;
    }
    st = ix__geo_fit(ctx, &r->t, mid, r->a, r->a->g->fit * r->a->g->s.size, &c);
    if (st == IX_OK)
        st = ix__geo_states(ctx, &r->t, r->a->nrow, r->a->row, r->a->ud,
                            &c.states);
    if (st == IX_OK)
        st = r->a->measure(r->a->ud, &r->t, &c.miss);
    if (st == IX_OK)
        st = ix__geo_keep(ctx, r->f, &c);
    if (st != IX_OK)
        ix_geo_curve_free(ctx, &c);
    r->t = (ix__geo_trace){0};
    return st;
}

/* The first sample after a break: one at the same place with another
 * derivative is a kink, one elsewhere (the border has a corner) ends a curve.
 */
static ix_status add_after_break(tracer *r, ix__geo_sample *s)
{
    const ix__geo_sample *last = r->t.n ? &r->t.at[r->t.n - 1] : NULL;
    double turn = 0, size = 0;

    if (last && ix__dist3(last->p + 2, s->p + 2) > 1e-9 * r->a->g->s.size) {
        IX_TRY(end_curve(r, IX_GEO_CORNER));
        last = NULL;
    }
    for (int i = 0; last && i < 5; i++) {
        turn = fmax(turn, fabs(s->dp[i] - last->dp[i]));
        size = fmax(size, fabs(s->dp[i]));
    }
    s->kink = turn > 1e-9 * size;
    return ix__geo_trace_add(r->a->g->ctx, &r->t, s);
}

/* From one probe of [lo, hi] to the next: the place where results begin or
 * cease. */
static ix_status change(tracer *r, double before, double t, double lo,
                        double hi, const ix__geo_sample *now, bool ok,
                        ix_geo_stop why)
{
    ix__geo_sample edge;

    edge = ok ? *now : r->t.at[r->t.n - 1];
    if (ok) {
        IX_TRY(last_good(r, t, before, lo, hi, &edge, &r->first));
    } else {
        IX_TRY(last_good(r, before, t, lo, hi, &edge, &why));
    }
    if (edge.x != (ok ? now->x : r->t.at[r->t.n - 1].x))
        IX_TRY(ix__geo_trace_add(r->a->g->ctx, &r->t, &edge));
    return ok ? IX_OK : end_curve(r, why);
}

static ix_status scan(tracer *r, double lo, double hi)
{
    double before = lo;

    for (int i = 0; i <= r->probes; i++) {
        double t = i == r->probes ? hi : lo + (hi - lo) * i / r->probes;
        bool was = r->t.n > 0, ok;
        ix_geo_stop why;
        ix__geo_sample s;

        IX_TRY(sample_at(r->a, t, lo, hi, &s, &ok, &why));
        if (i == 0 && ok) {
            IX_TRY(add_after_break(r, &s));
        } else if (i == 0) {
            IX_TRY(end_curve(r, why));
        } else {
            if (was != ok)
                IX_TRY(change(r, before, t, lo, hi, &s, ok, why));
            if (ok)
                IX_TRY(ix__geo_trace_add(r->a->g->ctx, &r->t, &s));
        }
        before = t;
    }
    return IX_OK;
}

ix_status ix__geo_along_run(const ix__geo_along *a, int n, const double *breaks,
                            ix__geo_found *f)
{
    tracer r = {.a = a, .f = f, .first = IX_GEO_END};

    r.probes = PROBES / n < LEAST  ? LEAST
               : PROBES / n > MOST ? MOST
                                   : PROBES / n;
    for (int i = 0; i < n - 1; i++)
        IX_TRY(scan(&r, breaks[i], breaks[i + 1]));
    return end_curve(&r, IX_GEO_END);
}
