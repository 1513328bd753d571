/* geo_shoot.c - geodesics and what happens along them.
 *
 *   (u, v)'' = -g^-1 (A.S_u, A.S_v),  A = S_uu u'^2 + 2 S_uv u'v' + S_vv v'^2
 *   y'' = -K y
 *   z'' = -K z - (dK/dt) y,   z = dy/dt,  dK/dt = grad K . dO/dt,  dO/dt = y E
 *
 * (Rausch et al. (2.6), (3.9), (5.2)). The integration stays within one cell of
 * the spline, where everything is analytic, and is taken up again in the next:
 * the direction is carried over in space, so that the joint may be smooth in
 * the geometric sense only. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/geo.h"

enum { NSTATE = 6, NVARIED = 8, EVENT_FOCAL = 4, NEVENTS = 5 };
enum { MAX_CELLS = 100000 }; /* crossed by one geodesic */

/* --- right side ---------------------------------------------------------- */

/* E: the unit vector across the direction, y E = dO/dt. */
static void across(const ix__geo_metric *m, const double *q, double side,
                   double ab[2])
{
    /* N x (a S_u + b S_v), turned the other way for side 1 */
    ab[0] = side * (m->f * q[2] + m->g * q[3]) / m->w;
    ab[1] = -side * (m->e * q[2] + m->f * q[3]) / m->w;
}

bool ix__geo_across(const ix__geo *g, const double *q, double side,
                    double ab[2])
{
    ix__geo_metric m;
    ix__geo_jet j;

    if (!ix__geo_eval(&g->s, g->cell, q[0], q[1], 1, j) ||
        !ix__geo_metric_of(j, &m))
        return false;
    across(&m, q, side, ab);
    return true;
}

static bool right_side(void *ud, double s, const double *q, double *dq)
{
    const ix__geo *g = ud;
    double acc[3], ab[2], k[3], e[2];
    ix__geo_metric m;
    ix__geo_jet j;

    (void)s;
    if (!ix__geo_eval(&g->s, g->cell, q[0], q[1], g->variation ? 3 : 2, j) ||
        !ix__geo_metric_of(j, &m))
        return false;
    for (int c = 0; c < 3; c++)
        acc[c] = j[IX_GEO_SUU][c] * q[2] * q[2] +
                 2 * j[IX_GEO_SUV][c] * q[2] * q[3] +
                 j[IX_GEO_SVV][c] * q[3] * q[3];
    ix__geo_parts(j, &m, acc, ab);
    ix__geo_gauss(j, g->variation, k);
    dq[0] = q[2];
    dq[1] = q[3];
    dq[2] = -ab[0];
    dq[3] = -ab[1];
    dq[4] = q[5];
    dq[5] = -k[0] * q[4];
    if (!g->variation)
        return true;
    across(&m, q, g->side, e);
    dq[6] = q[7];
    dq[7] = -k[0] * q[6] - (k[1] * e[0] + k[2] * e[1]) * q[4] * q[4];
    return true;
}

/* --- events -------------------------------------------------------------- */

/* The edges of the cell, and of the domain, in direction d. */
static void bounds(const ix__geo *g, int d, double b[2])
{
    double slack = g->margin ? IX_GEO_MARGIN : IX_GEO_SLACK;
    const ix__geo_dir *dir = &g->s.d[d];
    int at = g->cell.at[d];

    b[0] = -slack;
    b[1] = 1 + slack;
    if (!g->s.mv)
        return;
    if (at > 0)
        b[0] = fmax(b[0], dir->breaks[at] - IX_GEO_SLACK);
    if (at < dir->nspans - 1)
        b[1] = fmin(b[1], dir->breaks[at + 1] + IX_GEO_SLACK);
}

static void events(void *ud, double s, const double *q, double *e)
{
    const ix__geo *g = ud;

    (void)s;
    for (int d = 0; d < 2; d++) {
        double b[2];

        bounds(g, d, b);
        e[2 * d] = q[d] - b[0];
        e[2 * d + 1] = b[1] - q[d];
    }
    e[EVENT_FOCAL] = g->stop_at_focal ? q[4] : 1;
}

/* --- from cell to cell ---------------------------------------------------- */

/* Is there a cell beyond the edge 0 .. 3 in the domain? */
static bool next_cell(const ix__geo *g, int edge, ix__geo_cell *c)
{
    int d = edge / 2, up = edge % 2;
    const ix__geo_dir *dir = &g->s.d[d];

    *c = g->cell;
    if (!g->s.mv)
        return false;
    c->at[d] += up ? 1 : -1;
    if (c->at[d] < 0 || c->at[d] >= dir->nspans)
        return false;
    return up ? dir->breaks[c->at[d]] < 1 : dir->breaks[c->at[d] + 1] > 0;
}

/* z'' holds a jump of K at the edge, which moves with t: the integral of
 * -(dK/dt) y over it is (K+ - K-) y ds/dt, ds/dt = -(dO/dt)_d / (dO/ds)_d. */
static void cross_variation(ix__geo *g, int d, const double *q,
                            const double e[2], double jump, double *dz)
{
    if (g->variation && fabs(q[2 + d]) > 0)
        *dz -= jump * q[4] * (q[4] * e[d] / q[2 + d]);
}

/* The state carried over the edge; false: a crease. */
static bool cross(ix__geo *g, int edge, ix__geo_cell next, double *q,
                  bool *kink)
{
    double x[3], e[2], ab[2], k0[3], k1[3], turn[3];
    ix__geo_metric m0, m1;
    ix__geo_jet j0, j1;

    if (!ix__geo_eval(&g->s, g->cell, q[0], q[1], 2, j0) ||
        !ix__geo_eval(&g->s, next, q[0], q[1], 2, j1) ||
        !ix__geo_metric_of(j0, &m0) || !ix__geo_metric_of(j1, &m1))
        return false;
    ix__cross3(m0.n, m1.n, turn);
    if (!(ix__len3(turn) <= IX_GEO_SHARP && ix__dot3(m0.n, m1.n) > 0) ||
        !(ix__dist3(j0[0], j1[0]) <= 1e-9))
        return false;
    ix__geo_vector(j0, q + 2, x);
    ix__geo_parts(j1, &m1, x, ab);
    *kink = fabs(ab[0] - q[2]) + fabs(ab[1] - q[3]) >
            1e-9 * (fabs(q[2]) + fabs(q[3]));
    across(&m0, q, g->side, e);
    ix__geo_gauss(j0, false, k0);
    ix__geo_gauss(j1, false, k1);
    cross_variation(g, edge / 2, q, e, k1[0] - k0[0], &q[7]);
    memcpy(q + 2, ab, sizeof ab);
    g->cell = next;
    return true;
}

/* --- the edge of the domain ---------------------------------------------- */

static double edge_distance(const double *uv)
{
    return fmin(fmin(uv[0], 1 - uv[0]), fmin(uv[1], 1 - uv[1]));
}

/* The least distance between two states h apart: their own, and those where the
 * cubic of a coordinate is stationary, 3 a t^2 + 2 b t + c = 0. */
static double least_between(const double *p, const double *q, double h)
{
    double least = fmin(edge_distance(p), edge_distance(q));

    for (int d = 0; d < 2; d++) {
        double dx = q[d] - p[d], c = h * p[2 + d], e = h * q[2 + d];
        double a = c + e - 2 * dx, b = 3 * dx - 2 * c - e;
        double root = b * b - 3 * a * c;

        if (!(c * e < 0) || !(root >= 0))
            continue; /* it does not turn round */
        for (int k = -1; k <= 1; k += 2) {
            double t = -c / (b + k * sqrt(root)), x;

            if (!(t > 0 && t < 1))
                continue;
            x = p[d] + t * (c + t * (b + t * a));
            least = fmin(least, fmin(x, 1 - x));
        }
    }
    return least;
}

/* --- straight lines in a plane -------------------------------------------- */

/* Newton's method for the parameters of a point of the plane near q. */
static bool invert(const ix__geo *g, const double x[3], double *uv,
                   ix__geo_cell *cell)
{
    for (int i = 0; i < 30; i++) {
        double r[3], ab[2], step;
        ix__geo_metric m;
        ix__geo_jet j;

        *cell = ix__geo_cell_of(&g->s, uv[0], uv[1]);
        if (!ix__geo_eval(&g->s, *cell, uv[0], uv[1], 1, j) ||
            !ix__geo_metric_of(j, &m))
            return false;
        ix__sub3(x, j[0], r);
        ix__geo_parts(j, &m, r, ab);
        step = fmax(fabs(ab[0]), fabs(ab[1]));
        if (!(step < 0.25))
            return false;
        uv[0] += ab[0];
        uv[1] += ab[1];
        if (step <= 1e-9) /* quadratic: the next is below rounding */
            return true;
    }
    return false;
}

/* q[0 .. 3] of the point at the distance h along the line x + h dir. */
static bool line_point(ix__geo *g, const double x[3], const double dir[3],
                       double h, const double *near, double *q)
{
    double p[3];
    ix__geo_cell cell;
    ix__geo_metric m;
    ix__geo_jet j;

    memcpy(q, near, 2 * sizeof *q);
    ix__axpy3(x, h, dir, p);
    if (!invert(g, p, q, &cell) ||
        !ix__geo_eval(&g->s, cell, q[0], q[1], 1, j) ||
        !ix__geo_metric_of(j, &m))
        return false;
    ix__geo_parts(j, &m, dir, q + 2);
    g->cell = cell;
    return true;
}

static double inside(const ix__geo *g, const double *uv)
{
    double slack = g->margin ? IX_GEO_MARGIN : IX_GEO_SLACK;

    return fmin(fmin(uv[0], 1 - uv[0]), fmin(uv[1], 1 - uv[1])) + slack;
}

/* Between lo (inside) and hi (outside) the distance at the edge: Newton's
 * method on the coordinate that leaves, guarded by bisection. */
static double line_edge(ix__geo *g, const double x[3], const double dir[3],
                        double lo, double hi, double *q)
{
    double r[IX_ODE_UNKNOWNS];

    for (int i = 0; i < 100 && hi - lo > 4 * DBL_EPSILON * hi; i++) {
        double mid = 0.5 * (lo + hi);

        if (line_point(g, x, dir, mid, q, r) && inside(g, r) >= 0) {
            lo = mid;
            memcpy(q, r, 4 * sizeof *q);
        } else {
            hi = mid;
        }
    }
    return lo;
}

typedef struct {
    double x[3], dir[3], y[4]; /* place, direction, y, y', z, z' at s */
    double s;
} straight;

static void line_fields(const ix__geo *g, const straight *l, double s,
                        double *q)
{
    double h = s - l->s;

    q[4] = l->y[0] + h * l->y[1];
    q[5] = l->y[1];
    if (g->variation) {
        q[6] = l->y[2] + h * l->y[3];
        q[7] = l->y[3];
    }
}

static bool line_start(const ix__geo *g, const double *q, double s, straight *l)
{
    ix__geo_metric m;
    ix__geo_jet j;

    if (!ix__geo_eval(&g->s, g->cell, q[0], q[1], 1, j) ||
        !ix__geo_metric_of(j, &m))
        return false;
    memcpy(l->x, j[0], sizeof l->x);
    ix__geo_vector(j, q + 2, l->dir);
    memcpy(l->y, q + 4, (g->variation ? 4 : 2) * sizeof(double));
    l->s = s;
    return true;
}

/* In a plane K = 0: straight lines, y and z are linear. A step moves the
 * parameters by a tenth of the domain at most. */
static ix_status run_straight(ix__geo *g, const ix__geo_way *w, double end,
                              double *s, double *q, ix_geo_stop *stop)
{
    straight l;

    *stop = IX_GEO_SINGULAR;
    if (!line_start(g, q, *s, &l))
        return IX_OK;
    *stop = IX_GEO_END;
    if (w->stop_at_focal && q[5] < 0 && *s - q[4] / q[5] < end) {
        end = *s - q[4] / q[5];
        *stop = IX_GEO_FOCAL;
    }
    while (*s < end) {
        double h = 0.1 / fmax(fabs(q[2]), fabs(q[3]));
        double to = *s + h < end ? *s + h : end;
        double from[4] = {q[0], q[1], q[2], q[3]};
        ix__geo_state r;

        if (!line_point(g, l.x, l.dir, to - l.s, q, r) || inside(g, r) < 0) {
            to = l.s + line_edge(g, l.x, l.dir, *s - l.s, to - l.s, q);
            *stop = IX_GEO_DOMAIN;
            end = to;
        } else {
            memcpy(q, r, 4 * sizeof *q);
        }
        g->inside = fmin(g->inside, least_between(from, q, to - *s));
        *s = to;
        line_fields(g, &l, to, q);
        if (w->step)
            IX_TRY(w->step(w->ud, *s, q, IX_GEO_STEP));
    }
    return IX_OK;
}

/* --- running -------------------------------------------------------------- */

static ix_status integrator(ix__geo *g, const ix__geo_way *w, ix__ode **out)
{
    ix__geo *ud = g;
    ix__ode **slot = w->variation ? &g->varied : w->check ? &g->check : &g->ode;
    ix__ode_problem p = {.n = w->variation ? NVARIED : NSTATE,
                         .nevents = NEVENTS,
                         .f = right_side,
                         .g = events,
                         .ud = ud,
                         .tol = w->check ? 1e-13 : g->tol,
                         /* so that no edge is crossed twice in a step */
                         .max_step = 0.25,
                         .check = w->check};

    if (!*slot)
        IX_TRY(ix__ode_open(g->ctx, &p, slot));
    *out = *slot;
    return IX_OK;
}

/* After a step or an event: *done when the geodesic ends. */
static ix_status happened(ix__geo *g, const ix__geo_way *w,
                          ix__ode_result result, int event, double s, double *q,
                          ix_geo_stop *stop, bool *done)
{
    ix__geo_cell next;
    bool kink = false;

    *done = result != IX_ODE_STEP;
    *stop = IX_GEO_END;
    if (result == IX_ODE_STUCK) {
        *stop = IX_GEO_SINGULAR;
    } else if (result == IX_ODE_EVENT && event == EVENT_FOCAL) {
        *stop = IX_GEO_FOCAL;
    } else if (result == IX_ODE_EVENT) {
        *stop = IX_GEO_DOMAIN;
        if (next_cell(g, event, &next)) {
            if (w->step)
                IX_TRY(w->step(w->ud, s, q, IX_GEO_EDGE));
            *stop = IX_GEO_CREASE;
            *done = !cross(g, event, next, q, &kink);
            return !*done && w->step && kink ? w->step(w->ud, s, q, IX_GEO_KINK)
                                             : IX_OK;
        }
    }
    return w->step ? w->step(w->ud, s, q, IX_GEO_STEP) : IX_OK;
}

static ix_status run_curved(ix__geo *g, const ix__geo_way *w, double end,
                            double *s, double *q, ix_geo_stop *stop)
{
    ix__ode *ode;
    bool done = false;

    IX_TRY(integrator(g, w, &ode));
    *stop = IX_GEO_END;
    for (int cells = 0; !done && *s < end; cells++) {
        ix__ode_result result = IX_ODE_STEP;
        int event;

        if (cells > MAX_CELLS)
            return IX_FAIL(g->ctx, IX_EUNABLE,
                           "a geodesic crosses more than %d spans", MAX_CELLS);
        IX_TRY(ix__ode_start(ode, *s, q, end));
        while (result == IX_ODE_STEP && !done) {
            double from[4] = {q[0], q[1], q[2], q[3]}, at = *s;

            IX_TRY(ix__ode_step(ode, s, q, &event, &result));
            g->inside = fmin(g->inside, least_between(from, q, *s - at));
            IX_TRY(happened(g, w, result, event, *s, q, stop, &done));
        }
    }
    return IX_OK;
}

ix_status ix__geo_run(ix__geo *g, const ix__geo_way *w, double side, double end,
                      double *s, double *q, ix_geo_stop *stop)
{
    g->side = side;
    g->variation = w->variation;
    g->margin = w->margin;
    g->stop_at_focal = w->stop_at_focal;
    g->inside = edge_distance(q);
    if (g->s.planar)
        return run_straight(g, w, end, s, q, stop);
    return run_curved(g, w, end, s, q, stop);
}

/* --- from a curve --------------------------------------------------------- */

void ix__geo_start(const ix__geo_place *p, double sign, double *q)
{
    q[0] = p->uv[0];
    q[1] = p->uv[1];
    q[2] = sign * p->side_ab[0];
    q[3] = sign * p->side_ab[1];
    q[4] = p->len;
    q[5] = -sign * p->kg * p->len;
    q[6] = p->dlen;
    q[7] = -sign * (p->dkg * p->len + p->kg * p->dlen);
}

ix_status ix__geo_shoot(ix__geo *g, const ix__geo_crv *c, int span, double t,
                        double x, const ix__geo_way *w, ix__geo_shot *out)
{
    ix__geo_place p;

    *out = (ix__geo_shot){.sign = x < 0 ? -1 : 1, .stop = IX_GEO_SINGULAR};
    if (!ix__geo_place_at(c, span, t, w->variation, &p))
        return IX_OK;
    ix__geo_start(&p, out->sign, out->q);
    g->cell = p.cell;
    out->stop = IX_GEO_END;
    out->len = p.len;
    g->inside = edge_distance(out->q);
    if (x != 0)
        IX_TRY(
            ix__geo_run(g, w, out->sign, fabs(x), &out->s, out->q, &out->stop));
    out->cell = g->cell;
    out->inside = g->inside;
    if (!ix__geo_across(g, out->q, out->sign, out->side))
        out->stop = IX_GEO_SINGULAR;
    return IX_OK;
}

ix_status ix__geo_back(ix__geo *g, const double *state, const int cell[2],
                       double len, double x[3])
{
    const ix__geo_way way = {.margin = true, .check = true};
    double s = 0;
    ix__geo_state q;
    ix_geo_stop stop;
    ix__geo_jet j;

    memcpy(q, state, 6 * sizeof *q);
    q[2] = -q[2];
    q[3] = -q[3];
    g->cell = (ix__geo_cell){{cell[0], cell[1]}};
    if (len > 0)
        IX_TRY(ix__geo_run(g, &way, 1, len, &s, q, &stop));
    x[0] = x[1] = x[2] = NAN;
    if (ix__geo_eval(&g->s, g->cell, q[0], q[1], 0, j))
        memcpy(x, j[IX_GEO_S], sizeof j[IX_GEO_S]);
    return IX_OK;
}

/* --- opening -------------------------------------------------------------- */

ix_status ix__geo_open(ix_ctx *ctx, const ix_geo_surface *s, int n,
                       const ix_mv *const *crvs, const ix_geo_opts *o,
                       ix__geo *g)
{
    static const char *const what[3][2] = {
        {"", ""}, {"the curve", ""}, {"curve 1", "curve 2"}};
    double tol = o ? o->tol : 0, reach = o ? o->reach : 0;

    *g = (ix__geo){.ctx = ctx};
    if (!(tol >= 0) || !(reach >= 0))
        return IX_FAIL(ctx, IX_EARG,
                       "tolerance %g, reach %g: both must be positive, or 0 "
                       "for the default",
                       tol, reach);
    IX_TRY(ix__geo_srf_open(ctx, s, &g->s, &g->keep[0]));
    g->fit = tol > 0 ? fmin(fmax(tol / g->s.size, 1e-12), 0.1) : 1e-8;
    g->tol = fmin(fmax(1e-2 * g->fit, 1e-13), 1e-8);
    g->reach = reach > 0 ? reach / g->s.size : 4;
    for (int i = 0; i < n; i++)
        IX_TRY(ix__geo_crv_open(ctx, &g->s, crvs[i], what[n][i], &g->c[i],
                                &g->keep[i + 1]));
    return IX_OK;
}

void ix__geo_close(ix__geo *g)
{
    ix__ode_close(g->ode);
    ix__ode_close(g->varied);
    ix__ode_close(g->check);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(g->ctx, g->keep[i]);
}
