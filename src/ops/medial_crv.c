/* medial_crv.c - medial curves of two curves on a surface.
 *
 * (4.4) of Rausch et al. is a differential equation for s and t2 over t1,
 * singular at focal points of the second border. Multiplied by its determinant
 * it is one for (t1, t2, s) over the length in this space, which is regular
 * there: so that focal points can be approached and located. After each step
 * the point is moved onto the curve by Newton's method; errors do not add up.
 */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/medial.h"

enum {
    EDGE = 0,  /* 2: of the surface's domain, for each geodesic */
    RANGE = 2, /* 4: of a group of spans of the borders */
    FOCAL = 6, /* 2 */
    REACH = 8,
    NEVENTS = 9,
    MEASURED = 33,
    MAX_STEPS = 20000
};

typedef struct {
    ix__medial m;
    ix__geo_trace t;
    double x[3]; /* of the point evaluated last */
    ix__medial_point at;
    bool known, ok;
    ix_status st; /* of an evaluation inside the integrator */
} trace;

/* --- the differential equation -------------------------------------------- */

/* The point at x; the last one is kept, as events follow right sides. */
static bool evaluate(trace *r, const double *x)
{
    if (r->known && memcmp(x, r->x, sizeof r->x) == 0)
        return r->ok;
    memcpy(r->x, x, sizeof r->x);
    r->ok = false;
    if (r->st == IX_OK)
        r->st = ix__medial_eval(&r->m, x, &r->at, &r->ok);
    r->known = true;
    return r->ok;
}

static bool right_side(void *ud, double l, const double *x, double *dx)
{
    trace *r = ud;

    (void)l;
    if (!evaluate(r, x) || !r->at.regular)
        return false;
    for (int i = 0; i < 3; i++)
        dx[i] = r->m.along * r->at.tangent[i];
    return true;
}

static void events(void *ud, double l, const double *x, double *e)
{
    trace *r = ud;
    const ix__geo_shot *a = r->at.shot;

    (void)l;
    for (int i = 0; i < NEVENTS; i++)
        e[i] = 1;
    if (!evaluate(r, x))
        return;
    for (int d = 0; d < 2; d++) {
        const ix__geo_crv *c = &r->m.g->c[d];
        const int *group = c->group[r->m.span[d]];

        e[EDGE + d] = a[d].inside + IX_GEO_SLACK;
        e[RANGE + 2 * d] = x[d] - c->d.breaks[group[0]] + IX_GEO_SLACK;
        e[RANGE + 2 * d + 1] = c->d.breaks[group[1]] + IX_GEO_SLACK - x[d];
        e[FOCAL + d] = a[d].q[4] / a[d].len;
    }
    e[REACH] = r->m.g->reach - fabs(x[2]);
}

static void project(void *ud, double l, double *x)
{
    trace *r = ud;
    double y[3] = {x[0], x[1], x[2]};
    ix__medial_point p;
    bool ok = false;

    (void)l;
    if (r->st == IX_OK)
        r->st = ix__medial_newton(&r->m, -1, y, &p, &ok);
    if (r->st == IX_OK && ok)
        memcpy(x, y, sizeof y);
}

/* --- samples -------------------------------------------------------------- */

/* dO/dl = O1' s' + y1 E1 t1'; state: x, dx. */
static bool fill(trace *r, const ix__medial_point *p, const double x[3],
                 double l, ix__geo_sample *out)
{
    const ix__geo *g = r->m.g;
    const ix__geo_shot *a = &p->shot[0];
    double duv[2];

    *out = (ix__geo_sample){.x = l * g->s.size};
    for (int i = 0; i < 2; i++) {
        duv[i] = (r->m.side[0] * a->sign * a->q[2 + i] * p->tangent[2] +
                  a->q[4] * a->side[i] * p->tangent[0]) /
                 g->s.size;
        out->cell[2 + i] = r->m.span[i];
    }
    memcpy(out->state, x, 3 * sizeof *x);
    memcpy(out->state + 3, p->tangent, sizeof p->tangent);
    return ix__geo_fill(g, a->cell, a->q, duv, out);
}

static ix_status record(trace *r, const double *x, double l)
{
    ix__geo_sample s;

    if (!evaluate(r, x) || !r->at.regular ||
        !fill(r, &r->at, x, r->m.along * l, &s))
        return r->st;
    return ix__geo_trace_add(r->m.g->ctx, &r->t, &s);
}

/* The cubic between two samples, moved onto the curve. */
static ix_status mid(const void *ud, const ix__geo_sample *a,
                     const ix__geo_sample *b, double l, ix__geo_sample *out)
{
    trace r = *(const trace *)ud;
    double h = (b->x - a->x) / r.m.g->s.size, u = (l - a->x) / (b->x - a->x);
    double v = 1 - u, x[3];
    ix__medial_point p;
    bool ok;

    for (int i = 0; i < 3; i++)
        x[i] = v * v * (1 + 2 * u) * a->state[i] +
               u * u * (1 + 2 * v) * b->state[i] +
               h * u * v * (v * a->state[3 + i] - u * b->state[3 + i]);
    r.m.span[0] = a->cell[2];
    r.m.span[1] = a->cell[3];
    IX_TRY(ix__medial_newton(&r.m, -1, x, &p, &ok));
    if (!ok || !p.regular || !fill(&r, &p, x, l / r.m.g->s.size, out))
        return IX_FAIL(r.m.g->ctx, IX_EUNABLE,
                       "the medial curve cannot be followed between t1 = %g "
                       "and %g",
                       a->state[0], b->state[0]);
    return IX_OK;
}

/* --- tracing in one direction --------------------------------------------- */

/* At the end of a group of spans: the next one, unless the border ends or has a
 * corner there. */
static ix_geo_stop next_span(trace *r, int event, const double *x)
{
    int k = (event - RANGE) / 2, up = event % 2;
    const ix__geo_crv *c = &r->m.g->c[k];
    const int *group = c->group[r->m.span[k]];
    int last = up ? group[1] - 1 : group[0], next = up ? last + 1 : last - 1;
    ix__geo_place a, b;
    double turn[3];

    if (next < 0 || next >= c->d.nspans)
        return IX_GEO_END;
    if (!ix__geo_place_at(c, last, x[k], false, &a) ||
        !ix__geo_place_at(c, next, x[k], false, &b))
        return IX_GEO_SINGULAR;
    ix__cross3(a.tangent, b.tangent, turn);
    if (!(ix__len3(turn) <= IX_GEO_SHARP) ||
        ix__dot3(a.tangent, b.tangent) < 0 || ix__dist3(a.pos, b.pos) > 1e-9)
        return IX_GEO_CORNER;
    r->m.span[k] = next;
    r->known = false;
    return IX_GEO_CLOSED; /* nothing stops it here */
}

static ix_geo_stop reason(trace *r, ix__ode_result result, int event,
                          const double *x)
{
    if (result == IX_ODE_STUCK)
        return r->m.why;
    if (event < RANGE)
        return IX_GEO_DOMAIN;
    if (event < FOCAL)
        return next_span(r, event, x);
    return event == REACH   ? IX_GEO_REACH
           : event == FOCAL ? IX_GEO_FOCAL
                            : IX_GEO_FOCAL2;
}

/* At a break of a border: what is there seen from the next span. A kink if the
 * derivatives differ, for either direction of tracing. */
static ix_status record_after(trace *r, const double *x, double l)
{
    ix__geo_sample *a, *b;
    double turn = 0, size = 0;
    int n = r->t.n;

    IX_TRY(record(r, x, l));
    if (n == 0 || r->t.n == n)
        return IX_OK;
    a = &r->t.at[n - 1];
    b = &r->t.at[n];
    b->x = a->x;
    for (int i = 0; i < 5; i++) {
        turn = fmax(turn, fabs(a->dp[i] - b->dp[i]));
        size = fmax(size, fabs(a->dp[i]));
    }
    a->kink = b->kink = turn > 1e-9 * size;
    return IX_OK;
}

static bool far_enough(const trace *r, double l)
{
    return r->t.n == 0 ||
           fabs(r->m.along * l - r->t.at[r->t.n - 1].x / r->m.g->s.size) >=
               IX_GEO_SPACING;
}

/* Steps until something happens: *stop, or IX_GEO_CLOSED to go on. */
static ix_status until_event(trace *r, ix__ode *ode, double *l, double *x,
                             ix_geo_stop *stop)
{
    /* long enough: each border, and there and back */
    double end = *l + 1e3 + 4 * r->m.g->reach;
    ix__ode_result result = IX_ODE_STEP;
    int event = -1;

    IX_TRY(ix__ode_start(ode, *l, x, end));
    for (int i = 0; result == IX_ODE_STEP; i++) {
        IX_TRY(ix__ode_step(ode, l, x, &event, &result));
        IX_TRY(r->st);
        if (result != IX_ODE_STEP || far_enough(r, *l))
            IX_TRY(record(r, x, *l));
        if (i > MAX_STEPS)
            return IX_FAIL(r->m.g->ctx, IX_EUNABLE,
                           "the medial curve has more than %d steps",
                           MAX_STEPS);
    }
    *stop = result == IX_ODE_END ? IX_GEO_REACH : reason(r, result, event, x);
    return IX_OK;
}

/* From x along r->m.along; r->t then holds the samples from there. */
static ix_status follow(trace *r, const double start[3], ix_geo_stop *stop)
{
    const ix__ode_problem problem = {.n = 3,
                                     .nevents = NEVENTS,
                                     .f = right_side,
                                     .g = events,
                                     .project = project,
                                     .ud = r,
                                     /* steps end on the curve anyway */
                                     .tol = 1e-6,
                                     .max_step = 0.25};
    double x[3] = {start[0], start[1], start[2]}, l = 0;
    ix__ode *ode;
    ix_status st;

    ix__medial_spans(&r->m, x, r->m.along > 0);
    r->known = false;
    IX_TRY(record(r, x, 0));
    IX_TRY(ix__ode_open(r->m.g->ctx, &problem, &ode));
    do {
        st = until_event(r, ode, &l, x, stop);
        if (st == IX_OK && *stop == IX_GEO_CLOSED)
            st = record_after(r, x, l);
    } while (st == IX_OK && *stop == IX_GEO_CLOSED);
    ix__ode_close(ode);
    return st;
}

/* --- a whole curve -------------------------------------------------------- */

/* The sign of the tangent that makes t1 grow; *ok false: no tangent. */
static ix_status orient(trace *r, const double x[3], bool *ok)
{
    ix__medial_point p;

    ix__medial_spans(&r->m, x, true);
    IX_TRY(ix__medial_eval(&r->m, x, &p, ok));
    *ok = *ok && p.regular;
    if (*ok)
        r->m.orient = p.tangent[0] < 0 ? -1 : 1;
    return IX_OK;
}

/* Both directions of a start; the first one turned round. */
static ix_status both_ways(trace *r, const double x[3], ix_geo_stop stop[2])
{
    ix__geo_trace back;
    double first;
    bool ok;

    IX_TRY(orient(r, x, &ok));
    if (!ok)
        return IX_OK;
    r->m.along = -1;
    IX_TRY(follow(r, x, &stop[0]));
    back = r->t;
    r->t = (ix__geo_trace){0};
    for (int i = back.n - 1; i > 0; i--)
        IX_TRY(ix__geo_trace_add(r->m.g->ctx, &r->t, &back.at[i]));
    r->m.along = 1;
    IX_TRY(follow(r, x, &stop[1]));
    if (r->t.n == 0)
        return IX_OK;
    first = r->t.at[0].x;
    for (int i = 0; i < r->t.n; i++)
        r->t.at[i].x -= first;
    return IX_OK;
}

/* (t1, s, t2, |s|). */
static void row(const void *ud, const ix__geo_sample *a, double *out)
{
    const ix__geo *g = ((const trace *)ud)->m.g;

    out[0] = g->c[0].lo + g->c[0].len * a->state[0];
    out[1] = a->state[2] * g->s.size;
    out[2] = g->c[1].lo + g->c[1].len * a->state[1];
    out[3] = fabs(out[1]);
}

/* The ends of both geodesics, shot by the other method. */
static ix_status miss_at(trace *r, const ix__geo_sample *a, double *miss)
{
    const ix__geo_way way = {.margin = true, .check = true};
    ix__geo *g = r->m.g;
    double p[2][3];

    *miss = NAN;
    for (int k = 0; k < 2; k++) {
        ix__geo_shot shot;
        ix__geo_jet j;

        r->m.span[k] = a->cell[2 + k];
        IX_TRY(ix__geo_shoot(
            g, &g->c[k], ix__medial_span(&r->m, k, a->state[k]), a->state[k],
            r->m.side[k] * a->state[2], &way, &shot));
        if (!ix__geo_eval(&g->s, shot.cell, shot.q[0], shot.q[1], 0, j))
            return IX_OK;
        memcpy(p[k], j[0], sizeof p[k]);
    }
    *miss = ix__dist3(p[0], p[1]) * g->s.size;
    return IX_OK;
}

static ix_status measure(trace *r, double *miss)
{
    int step = 1 + (r->t.n - 1) / MEASURED;

    *miss = 0;
    for (int i = 0; i < r->t.n; i += step) {
        double one;

        IX_TRY(miss_at(r, &r->t.at[i], &one));
        if (!(one <= *miss))
            *miss = one;
    }
    return IX_OK;
}

static ix_status build(trace *r, ix_geo_curve *c)
{
    ix__geo *g = r->m.g;

    IX_TRY(ix__geo_fit(g->ctx, &r->t, mid, r, g->fit * g->s.size, c));
    IX_TRY(ix__geo_states(g->ctx, &r->t, 4, row, r, &c->states));
    return measure(r, &c->miss);
}

/* --- all of them ---------------------------------------------------------- */

/* The t1 where s is 0 between two samples, or the samples themselves, against
 * that of a meeting; and ends against a point at an end. */
static bool passes(const ix__geo_trace *t, const ix__medial_seed *s, double f)
{
    for (int i = 0; i < t->n; i++) {
        const double *b = t->at[i].state;
        double u = 0, tol = 1e-6;
        const double *a = b;

        if (s->fixed < 0 && i > 0) {
            a = t->at[i - 1].state;
            if (a[2] * b[2] > 0 || a[2] == b[2])
                continue;
            u = a[2] / (a[2] - b[2]);
            tol = 0.25 * (fabs(a[0] - b[0]) + fabs(a[1] - b[1])) + 1e-6;
        } else if (s->fixed >= 0 && i > 0 && i < t->n - 1) {
            continue;
        }
        if (fabs(a[0] + u * (b[0] - a[0]) - s->x[0]) +
                fabs(a[1] + u * (b[1] - a[1]) - s->x[1]) +
                fabs(a[2] + u * (b[2] - a[2]) - f * s->x[2]) <=
            tol)
            return true;
    }
    return false;
}

/* The curve through a start; the other starts that it passes are struck out
 * (their sides become 0). */
static ix_status one_curve(ix__geo *g, ix__medial_seeds *seeds, int i,
                           ix__geo_found *f)
{
    ix__medial_seed *s = &seeds->at[i];
    trace r = {.m = {.g = g, .side = {s->side[0], s->side[1]}}};
    ix_geo_curve c = {0};
    ix_status st = both_ways(&r, s->x, c.stop);

    IX_TRY(st);
    for (int k = i + 1; k < seeds->n; k++) {
        ix__medial_seed *e = &seeds->at[k];

        if (e->side[0] * e->side[1] == s->side[0] * s->side[1] &&
            passes(&r.t, e, e->side[0] == s->side[0] ? 1 : -1))
            e->side[0] = 0;
    }
    if (r.t.n < 2 || !(r.t.at[r.t.n - 1].x > r.t.at[0].x))
        return IX_OK;
    st = build(&r, &c);
    if (st == IX_OK)
        st = ix__geo_keep(g->ctx, f, &c);
    if (st != IX_OK)
        ix_geo_curve_free(g->ctx, &c);
    return st;
}

/* Only the start with the least distance stays. */
static void nearest(ix__medial_seeds *s)
{
    int best = 0;

    for (int i = 1; i < s->n; i++)
        if (s->at[i].x[2] < s->at[best].x[2])
            best = i;
    if (s->n > 1) {
        s->at[0] = s->at[best];
        s->n = 1;
    }
}

static ix_status near_guess(ix__medial *m, const double guess[3],
                            ix__medial_seeds *out)
{
    const ix__geo *g = m->g;
    double x[3] = {(guess[0] - g->c[0].lo) / g->c[0].len,
                   (guess[1] - g->c[1].lo) / g->c[1].len, guess[2] / g->s.size};
    ix__medial_point p;
    bool ok = x[0] >= 0 && x[0] <= 1;

    ix__medial_spans(m, x, true);
    if (ok)
        IX_TRY(ix__medial_newton(m, 0, x, &p, &ok));
    if (!ok || !(x[1] >= -1e-9 && x[1] <= 1 + 1e-9) || !p.regular)
        return IX_FAIL(g->ctx, IX_EDOMAIN,
                       "Newton's method finds no medial point from t1 %g, t2 "
                       "%g, distance %g for the sides %d, %d",
                       guess[0], guess[1], guess[2], m->side[0], m->side[1]);
    return ix__medial_seed_add(m, out, x, 0);
}

/* The combinations of sides to look at: their number. */
static int combinations(const ix_medial_opts *o, bool meeting, int s[4][2])
{
    static const int all[4][2] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};

    if (o->sides[0] != 0) {
        memcpy(s[0], o->sides, sizeof s[0]);
        return 1;
    }
    memcpy(s, all, sizeof all);
    return meeting ? 2 : 4; /* (a, b) at s is (-a, -b) at -s */
}

static ix_status find_seeds(ix__geo *g, const ix_medial_opts *o, bool meeting,
                            ix__medial_seeds *seeds)
{
    ix__medial m = {.g = g};
    int s[4][2], n = combinations(o, meeting, s);

    for (int i = 0; i < n; i++) {
        memcpy(m.side, s[i], sizeof m.side);
        if (o->start == IX_MEDIAL_GUESS)
            IX_TRY(near_guess(&m, o->guess, seeds));
        else if (meeting)
            IX_TRY(ix__medial_meetings(&m, seeds));
        else
            IX_TRY(ix__medial_ends(&m, seeds));
    }
    return IX_OK;
}

static ix_status medial(ix__geo *g, const ix_medial_opts *o, ix__geo_found *f)
{
    ix__medial_seeds seeds = {0};

    for (int i = 0; i < 2; i++)
        if (o->sides[i] * o->sides[i] != (o->sides[1 - i] != 0))
            return IX_FAIL(g->ctx, IX_EARG,
                           "sides %d, %d: 1 (left) or -1 (right) for both "
                           "curves, or 0, 0 for all",
                           o->sides[0], o->sides[1]);
    IX_TRY(find_seeds(g, o, o->start == IX_MEDIAL_AUTO, &seeds));
    if (o->start == IX_MEDIAL_AUTO && seeds.n == 0) {
        IX_TRY(find_seeds(g, o, false, &seeds));
        nearest(&seeds);
    }
    for (int i = 0; i < seeds.n; i++)
        if (seeds.at[i].side[0] != 0)
            IX_TRY(one_curve(g, &seeds, i, f));
    return IX_OK;
}

static ix_status open_medial(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *const c[2], const ix_medial_opts *m,
                             const ix_geo_opts *o, ix_geo_curves *out)
{
    static const ix_medial_opts usual;
    ix__geo g;
    ix__geo_found f = {0};
    ix_status st = ix__geo_open(ctx, s, 2, c, o, &g);

    if (st == IX_OK)
        st = medial(&g, m ? m : &usual, &f);
    ix__geo_close(&g);
    return ix__geo_found_end(ctx, &f, st, out);
}

ix_status ix_medial_crv(ix_ctx *ctx, const ix_geo_surface *s, const ix_mv *c1,
                        const ix_mv *c2, const ix_medial_opts *m,
                        const ix_geo_opts *o, ix_geo_curves *out)
{
    const ix_mv *const c[2] = {c1, c2};

    IX_RETURN_SCOPED(ctx, open_medial(ctx, s, c, m, o, out));
}
