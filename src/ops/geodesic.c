/* geodesic.c - geodesics from a point and at a right angle to a curve, and the
 * geodesic curvature of curves. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/geo.h"

/* --- recording ------------------------------------------------------------ */

typedef struct {
    ix__geo *g;
    ix__geo_trace t;
    double side;
    double tlen; /* of the domain that y is a derivative over */
} record;

static ix_status add(record *r, double s, const double *q, bool kink)
{
    ix__geo_sample x = {.x = s * r->g->s.size, .kink = kink};

    for (int i = 0; i < 2; i++) {
        x.state[i] = q[i];
        x.cell[i] = r->g->cell.at[i];
    }
    memcpy(x.state + 2, q + 2, 4 * sizeof *q);
    x.state[6] = s;
    /* scaled per length to per user's length */
    if (!ix__geo_fill(
            r->g, r->g->cell, q,
            (const double[2]){q[2] / r->g->s.size, q[3] / r->g->s.size}, &x))
        return IX_OK;
    return ix__geo_trace_add(r->g->ctx, &r->t, &x);
}

static ix_status on_step(void *ud, double s, const double *q, ix__geo_event e)
{
    record *r = ud;

    if (e == IX_GEO_STEP && s - r->t.at[r->t.n - 1].state[6] < IX_GEO_SPACING)
        return IX_OK;
    return add(r, s, q, e == IX_GEO_KINK);
}

/* From the nearer sample: integration again, but only over one step. */
static ix_status mid(const void *ud, const ix__geo_sample *a,
                     const ix__geo_sample *b, double x, ix__geo_sample *out)
{
    const record *r = ud;
    const ix__geo_way way = {.margin = true};
    double s = a->state[6];
    ix__geo_state q;
    ix_geo_stop stop;
    record one = {.g = r->g};

    (void)b;
    memcpy(q, a->state, 6 * sizeof *q);
    r->g->cell = (ix__geo_cell){{a->cell[0], a->cell[1]}};
    IX_TRY(ix__geo_run(r->g, &way, r->side, x / r->g->s.size, &s, q, &stop));
    IX_TRY(add(&one, s, q, false));
    if (one.t.n != 1)
        return IX_FAIL(r->g->ctx, IX_EUNABLE,
                       "the surface cannot be evaluated at distance %g", x);
    *out = one.t.at[0];
    return IX_OK;
}

/* Back from the last sample: how far the start is missed. */
static ix_status shoot_back(const record *r, double *miss)
{
    const ix__geo_sample *first = &r->t.at[0], *last = &r->t.at[r->t.n - 1];
    double x[3];

    IX_TRY(ix__geo_back(r->g, last->state, last->cell, last->state[6], x));
    for (int i = 0; i < 3; i++)
        x[i] *= r->g->s.size;
    *miss = ix__dist3(x, first->p + 2);
    return IX_OK;
}

/* The first zero of y, by integration from the sample before it. */
static ix_status find_conjugate(record *r, double *out)
{
    const ix__geo_way way = {.margin = true, .stop_at_focal = true};

    *out = NAN;
    for (int i = 1; i < r->t.n; i++) {
        const ix__geo_sample *a = &r->t.at[i - 1], *b = &r->t.at[i];
        double s = a->state[6];
        ix__geo_state q;
        ix_geo_stop stop;

        if (!(a->state[4] > 0 && b->state[4] <= 0))
            continue;
        memcpy(q, a->state, 6 * sizeof *q);
        r->g->cell = (ix__geo_cell){{a->cell[0], a->cell[1]}};
        IX_TRY(ix__geo_run(r->g, &way, r->side, b->state[6], &s, q, &stop));
        *out = s * r->g->s.size;
        return IX_OK;
    }
    return IX_OK;
}

/* (s, u, v, y, y'). */
static void row(const void *ud, const ix__geo_sample *a, double *out)
{
    const record *r = ud;

    out[0] = a->x;
    out[1] = a->p[0];
    out[2] = a->p[1];
    out[3] = a->state[4] * r->g->s.size / r->tlen;
    out[4] = a->state[5] / r->tlen;
}

/* The geodesic from the state q in g->cell, scaled. */
static ix_status follow(record *r, const double *start, double len,
                        bool stop_at_focal, ix_geo_curve *out)
{
    ix__geo *g = r->g;
    const ix__geo_way way = {
        .stop_at_focal = stop_at_focal, .step = on_step, .ud = r};
    double s = 0;
    ix__geo_state q;

    memcpy(q, start, 6 * sizeof *q);
    IX_TRY(add(r, 0, q, false));
    IX_TRY(ix__geo_run(g, &way, r->side, len, &s, q, &out->stop[1]));
    IX_TRY(add(r, s, q, false));
    IX_TRY(ix__geo_fit(g->ctx, &r->t, mid, r, g->fit * g->s.size, out));
    IX_TRY(shoot_back(r, &out->miss));
    return ix__geo_states(g->ctx, &r->t, 5, row, r, &out->states);
}

/* What was made of out is released unless st is IX_OK. */
static ix_status finish(ix__geo *g, ix_status st, ix_geo_curve *out)
{
    ix__geo_close(g);
    if (st != IX_OK)
        ix_geo_curve_free(g->ctx, out);
    return st;
}

/* --- from a point --------------------------------------------------------- */

/* The unit direction at a point as a state with y = 0, y' = 1. */
static ix_status start_at(ix__geo *g, const double uv[2], const double dir[2],
                          double *q)
{
    double x[3], len;
    ix__geo_metric m;
    ix__geo_jet j;

    for (int i = 0; i < 2; i++) {
        q[i] = (uv[i] - g->s.lo[i]) / g->s.len[i];
        q[2 + i] = dir[i] / g->s.len[i];
        if (!(q[i] >= -1e-9 && q[i] <= 1 + 1e-9))
            return IX_FAIL(g->ctx, IX_EARG,
                           "the start (%g, %g) is outside the surface's domain",
                           uv[0], uv[1]);
    }
    g->cell = ix__geo_cell_of(&g->s, q[0], q[1]);
    if (!ix__geo_eval(&g->s, g->cell, q[0], q[1], 1, j) ||
        !ix__geo_metric_of(j, &m))
        return IX_FAIL(g->ctx, IX_EDOMAIN,
                       "the surface has no normal at (%g, %g)", uv[0], uv[1]);
    ix__geo_vector(j, q + 2, x);
    len = ix__len3(x);
    if (!(len > 0) || !isfinite(len))
        return IX_FAIL(g->ctx, IX_EARG, "the direction (%g, %g) is none",
                       dir[0], dir[1]);
    q[2] /= len;
    q[3] /= len;
    q[4] = 0;
    q[5] = 1;
    return IX_OK;
}

static ix_status check_length(ix_ctx *ctx, double len)
{
    if (!isfinite(len) || len == 0)
        return IX_FAIL(ctx, IX_EARG, "the length is %g", len);
    return IX_OK;
}

static ix_status geodesic(ix__geo *g, const double uv[2], const double dir[2],
                          double len, double *conjugate, ix_geo_curve *out)
{
    record r = {.g = g, .side = 1, .tlen = 1};
    const double back[2] = {-dir[0], -dir[1]};
    ix__geo_state q;

    IX_TRY(check_length(g->ctx, len));
    IX_TRY(start_at(g, uv, len > 0 ? dir : back, q));
    IX_TRY(follow(&r, q, fabs(len) / g->s.size, false, out));
    return conjugate ? find_conjugate(&r, conjugate) : IX_OK;
}

static ix_status open_geodesic(ix_ctx *ctx, const ix_geo_surface *s,
                               const double uv[2], const double dir[2],
                               double len, const ix_geo_opts *o,
                               double *conjugate, ix_geo_curve *out)
{
    ix__geo g;
    ix_status st = ix__geo_open(ctx, s, 0, NULL, o, &g);

    *out = (ix_geo_curve){0};
    if (st == IX_OK)
        st = geodesic(&g, uv, dir, len, conjugate, out);
    return finish(&g, st, out);
}

ix_status ix_geodesic(ix_ctx *ctx, const ix_geo_surface *s, const double uv[2],
                      const double dir[2], double len, const ix_geo_opts *o,
                      double *conjugate, ix_geo_curve *out)
{
    IX_RETURN_SCOPED(ctx,
                     open_geodesic(ctx, s, uv, dir, len, o, conjugate, out));
}

/* --- from a curve --------------------------------------------------------- */

static ix_status curve_parameter(ix__geo *g, double t, double *scaled)
{
    const ix__geo_crv *c = &g->c[0];

    *scaled = (t - c->lo) / c->len;
    if (!(*scaled >= -1e-9 && *scaled <= 1 + 1e-9))
        return IX_FAIL(g->ctx, IX_EARG,
                       "parameter %g is outside the curve's domain [%g, %g]", t,
                       c->lo, c->lo + c->len);
    return IX_OK;
}

static ix_status place_at(ix__geo *g, double t, ix__geo_place *p)
{
    double x;

    IX_TRY(curve_parameter(g, t, &x));
    if (!ix__geo_place_at(&g->c[0], ix__geo_crv_span(&g->c[0], x), x, true, p))
        return IX_FAIL(g->ctx, IX_EDOMAIN,
                       "at parameter %g the curve stands still or the surface "
                       "has no normal",
                       t);
    return IX_OK;
}

static ix_status geodesic_normal(ix__geo *g, double t, double len,
                                 bool stop_at_focal, ix_geo_curve *out)
{
    record r = {.g = g, .side = len < 0 ? -1 : 1, .tlen = g->c[0].len};
    ix__geo_state q;
    ix__geo_place p;

    IX_TRY(check_length(g->ctx, len));
    IX_TRY(place_at(g, t, &p));
    ix__geo_start(&p, r.side, q);
    g->cell = p.cell;
    return follow(&r, q, fabs(len) / g->s.size, stop_at_focal, out);
}

static ix_status open_normal(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *crv, double t, double len,
                             bool stop_at_focal, const ix_geo_opts *o,
                             ix_geo_curve *out)
{
    ix__geo g;
    ix_status st = ix__geo_open(ctx, s, 1, &crv, o, &g);

    *out = (ix_geo_curve){0};
    if (st == IX_OK)
        st = geodesic_normal(&g, t, len, stop_at_focal, out);
    return finish(&g, st, out);
}

ix_status ix_geodesic_normal(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *crv, double t, double len,
                             bool stop_at_focal, const ix_geo_opts *o,
                             ix_geo_curve *out)
{
    IX_RETURN_SCOPED(ctx,
                     open_normal(ctx, s, crv, t, len, stop_at_focal, o, out));
}

static ix_status open_curvature(ix_ctx *ctx, const ix_geo_surface *s,
                                const ix_mv *crv, double t, double kg[2])
{
    ix__geo g;
    ix__geo_place p = {.kg = NAN};
    ix_status st = ix__geo_open(ctx, s, 1, &crv, NULL, &g);

    if (st == IX_OK)
        st = place_at(&g, t, &p);
    kg[0] = p.kg / g.s.size;
    kg[1] = p.dkg / g.s.size / g.c[0].len;
    ix__geo_close(&g);
    return st;
}

ix_status ix_geodesic_curvature(ix_ctx *ctx, const ix_geo_surface *s,
                                const ix_mv *crv, double t, double kg[2])
{
    IX_RETURN_SCOPED(ctx, open_curvature(ctx, s, crv, t, kg));
}
