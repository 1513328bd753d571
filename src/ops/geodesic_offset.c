/* geodesic_offset.c - geodesic offsets of a curve on a surface, at a constant
 * or variable distance.
 *
 * Each point is a geodesic of its own, integrated from the curve; its Jacobi
 * field gives the derivative dO/dt = d'(t) dO/ds + y E. The curve's parameters
 * are cut at its knots and those of the distance, and where geodesics begin or
 * cease to stay in the domain. */
#include <math.h>
#include <string.h>

#include "bsp/basis.h"
#include "geom/vec3.h"
#include "mv/mv.h"
#include "ops/geo.h"

enum { MEASURED = 33 }; /* geodesics shot back */

typedef struct {
    ix__geo *g;
    double dist; /* scaled */
    const ix_mv *variable;
    double *w; /* weights of its window */
} offset;

/* --- one point ------------------------------------------------------------ */

/* The distance and its derivative by the polynomial around mid, scaled. */
static void distance_at(const offset *o, double t, double mid, double d[2])
{
    const ix__geo_crv *c = &o->g->c[0];
    const ix_mv *m = o->variable;
    double h[2][2] = {{1, 0}, {0, 0}};
    int first;

    d[0] = o->dist;
    d[1] = 0;
    if (!m)
        return;
    first = ix__basis_first(m->dirs, c->lo + c->len * mid);
    for (int k = 0; k < 2; k++) {
        ix__basis_derive(m->dirs, first, c->lo + c->len * t, k, o->w);
        for (int a = 0; a < 1 + m->rational; a++) {
            const double *p = m->pts + (size_t)a * m->npts + first;
            double x = 0;

            for (int i = 0; i < m->dirs[0].order; i++)
                x += o->w[i] * p[i];
            h[a + !m->rational][k] = x;
        }
    }
    d[0] += h[1][0] / h[0][0] / o->g->s.size;
    d[1] = (h[1][1] - h[0][1] * h[1][0] / h[0][0]) / h[0][0] * c->len /
           o->g->s.size;
}

static ix_status shoot(const offset *o, double t, double lo, double hi,
                       ix__geo_shot *shot, double d[2])
{
    const ix__geo_way way = {0};
    const ix__geo_crv *c = &o->g->c[0];

    distance_at(o, t, 0.5 * (lo + hi), d);
    return ix__geo_shoot(o->g, c, ix__geo_crv_span_in(c, t, lo, hi), t, d[0],
                         &way, shot);
}

static ix_status sample(void *ud, double t, double lo, double hi,
                        ix__geo_sample *out, bool *ok, ix_geo_stop *why)
{
    const offset *o = ud;
    ix__geo_shot shot;
    double d[2], duv[2];

    IX_TRY(shoot(o, t, lo, hi, &shot, d));
    *ok = shot.stop == IX_GEO_END;
    *why = shot.stop;
    if (!*ok)
        return IX_OK;
    for (int i = 0; i < 2; i++)
        duv[i] = (shot.sign * d[1] * shot.q[2 + i] + shot.q[4] * shot.side[i]) /
                 o->g->c[0].len;
    memcpy(out->state, shot.q, 6 * sizeof(double));
    out->state[7] = d[0];
    out->cell[0] = shot.cell.at[0];
    out->cell[1] = shot.cell.at[1];
    *ok = ix__geo_fill(o->g, shot.cell, shot.q, duv, out);
    return IX_OK;
}

/* (t, u, v, y, distance). */
static void row(const void *ud, const ix__geo_sample *a, double *out)
{
    const offset *o = ud;

    out[0] = a->x;
    out[1] = a->p[0];
    out[2] = a->p[1];
    out[3] = a->state[4] * o->g->s.size / o->g->c[0].len;
    out[4] = a->state[7] * o->g->s.size;
}

/* From O back to C. */
static ix_status shoot_back(const offset *o, const ix__geo_sample *a,
                            double *miss)
{
    const ix__geo_crv *c = &o->g->c[0];
    double t = a->state[6], x[3];
    ix__geo_place p;

    IX_TRY(ix__geo_back(o->g, a->state, a->cell, fabs(a->state[7]), x));
    *miss = NAN;
    if (ix__geo_place_at(c, ix__geo_crv_span(c, t), t, false, &p))
        *miss = ix__dist3(p.pos, x) * o->g->s.size;
    return IX_OK;
}

static ix_status measure(void *ud, const ix__geo_trace *t, double *miss)
{
    const offset *o = ud;
    int step = 1 + (t->n - 1) / MEASURED;

    *miss = 0;
    for (int i = 0; i < t->n; i += step) {
        double one;

        IX_TRY(shoot_back(o, &t->at[i], &one));
        if (!(one <= *miss))
            *miss = one;
    }
    return IX_OK;
}

/* Breaks of the curve and of the distance, scaled: both increase. */
static ix_status all_breaks(const offset *o, int *n, const double **out)
{
    const ix__geo_crv *c = &o->g->c[0];
    ix_spans v = {.nspans = 0};
    double *t, *rough;
    int count, a = 0, b = 1, k = 0;

    IX_TRY(ix__geo_crv_rough(o->g->ctx, c, &count, &rough));
    if (o->variable)
        IX_TRY(ix__spans_of(o->g->ctx, o->variable->dirs, &v));
    IX_SCRATCH(o->g->ctx, t, count + v.nspans);
    while (a < count) {
        double x = b < v.nspans ? (v.breaks[b] - c->lo) / c->len : HUGE_VAL;

        if (x < rough[a] - 1e-9) {
            t[k++] = x;
            b++;
        } else {
            b += fabs(x - rough[a]) <= 1e-9;
            t[k++] = rough[a++];
        }
    }
    *out = t;
    *n = k;
    return IX_OK;
}

/* --- cusps ---------------------------------------------------------------- */

/* The zero of y between a and b, (t, y) with y of both signs: regula falsi and
 * bisection in turns. */
static ix_status refine_cusp(const offset *o, const double a[2],
                             const double b[2], double *out)
{
    double lo = a[0], hi = b[0], ylo = a[1], yhi = b[1];

    for (int i = 0; i < 200 && hi - lo > 1e-15; i++) {
        double t = i % 3 == 2 ? 0.5 * (lo + hi)
                              : lo + (hi - lo) * ylo / (ylo - yhi);
        ix__geo_shot shot;
        double d[2];

        IX_TRY(shoot(o, t, a[0], b[0], &shot, d));
        if (shot.q[4] == 0 || t <= lo || t >= hi) {
            lo = hi = t;
        } else if ((shot.q[4] > 0) == (ylo > 0)) {
            lo = t;
            ylo = shot.q[4];
        } else {
            hi = t;
            yhi = shot.q[4];
        }
    }
    *out = o->g->c[0].lo + o->g->c[0].len * 0.5 * (lo + hi);
    return IX_OK;
}

/* Changes of sign of y between neighbouring states of all curves. */
static ix_status find_cusps(const offset *o, const ix__geo_found *f, int *n,
                            double **out)
{
    const ix__geo_crv *c = &o->g->c[0];
    size_t room = 0;
    double *v;

    for (int i = 0; i < f->n; i++)
        room += ix_mv_npts(f->crv[i].states);
    IX_SCRATCH(o->g->ctx, v, room);
    *n = 0;
    for (int i = 0; i < f->n; i++) {
        const double *t = ix_mv_coord(f->crv[i].states, 0);
        const double *y = ix_mv_coord(f->crv[i].states, 3);

        for (size_t k = 1; k < ix_mv_npts(f->crv[i].states); k++) {
            const double a[2] = {(t[k - 1] - c->lo) / c->len, y[k - 1]};
            const double b[2] = {(t[k] - c->lo) / c->len, y[k]};

            if (a[1] != 0 && (b[1] > 0) != (a[1] > 0))
                IX_TRY(refine_cusp(o, a, b, &v[(*n)++]));
        }
    }
    if (*n == 0)
        return IX_OK;
    *out = ix__alloc(o->g->ctx, (size_t)*n * sizeof **out);
    if (!*out)
        return IX_ENOMEM;
    memcpy(*out, v, (size_t)*n * sizeof **out);
    return IX_OK;
}

void ix_geo_numbers_free(ix_ctx *ctx, double *v, int n)
{
    ix__free(ctx, v, (size_t)n * sizeof *v);
}

/* --- public --------------------------------------------------------------- */

static ix_status check_variable(ix__geo *g, const ix_mv *m)
{
    double dom[2], slack = 1e-9 * g->c[0].len;

    if (!m)
        return IX_OK;
    if (ix_mv_ndirs(m) != 1 || ix_mv_has_poles(m) ||
        m->dirs[0].basis == IX_POWER || m->dirs[0].periodic)
        return IX_FAIL(g->ctx, IX_EARG,
                       "the distance must be a number or a scalar curve "
                       "(Bezier or B-spline, no poles)");
    ix_mv_domain(m, 0, dom);
    if (!(fabs(dom[0] - g->c[0].lo) <= slack &&
          fabs(dom[1] - g->c[0].lo - g->c[0].len) <= slack))
        return IX_FAIL(g->ctx, IX_EARG,
                       "the distance is given over [%g, %g], the curve over "
                       "[%g, %g]",
                       dom[0], dom[1], g->c[0].lo, g->c[0].lo + g->c[0].len);
    return IX_OK;
}

static ix_status geodesic_offset(ix__geo *g, double dist, const ix_mv *variable,
                                 int *ncusps, double **cusps, ix__geo_found *f)
{
    offset o = {.g = g, .dist = dist / g->s.size, .variable = variable};
    const ix__geo_along along = {.g = g,
                                 .sample = sample,
                                 .measure = measure,
                                 .row = row,
                                 .nrow = 5,
                                 .ud = &o};
    const double *breaks;
    int n;

    if (!isfinite(dist))
        return IX_FAIL(g->ctx, IX_EARG, "the distance is %g", dist);
    IX_TRY(check_variable(g, variable));
    if (variable)
        IX_SCRATCH(g->ctx, o.w, variable->dirs[0].order);
    IX_TRY(all_breaks(&o, &n, &breaks));
    IX_TRY(ix__geo_along_run(&along, n, breaks, f));
    if (f->n == 0)
        return IX_FAIL(g->ctx, IX_EDOMAIN,
                       "no geodesic of length %g from the curve stays in the "
                       "surface's domain",
                       dist);
    return ncusps ? find_cusps(&o, f, ncusps, cusps) : IX_OK;
}

static ix_status open_offset(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *crv, double dist,
                             const ix_mv *variable, const ix_geo_opts *o,
                             int *ncusps, double **cusps, ix_geo_curves *out)
{
    ix__geo g;
    ix__geo_found f = {0};
    ix_status st = ix__geo_open(ctx, s, 1, &crv, o, &g);

    if (st == IX_OK)
        st = geodesic_offset(&g, dist, variable, ncusps, cusps, &f);
    ix__geo_close(&g);
    return ix__geo_found_end(ctx, &f, st, out);
}

ix_status ix_geodesic_offset(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *crv, double dist,
                             const ix_mv *variable, const ix_geo_opts *o,
                             int *ncusps, double **cusps, ix_geo_curves *out)
{
    if (ncusps)
        *ncusps = 0;
    if (cusps)
        *cusps = NULL;
    IX_RETURN_SCOPED(
        ctx, open_offset(ctx, s, crv, dist, variable, o, ncusps, cusps, out));
}
