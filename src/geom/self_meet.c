/* self_meet.c - self-intersections of a planar curve, without the diagonal.
 *
 * F_k(t, r) = x_k(t) w(r) - x_k(r) w(t) vanishes for t = r. On one span the
 * factor t - r is divided out exactly: the quotient is the Bezoutian of x_k and
 * w, which has a stable recursion in Bernstein form. Two spans that share a
 * point meet there trivially: blowing the point up, (a, b) = (s, s m) and (s m,
 * s) with a, b measured from it, makes s a factor, which is divided out by an
 * index shift. All other pairs of spans are ordinary systems. */
#include <math.h>
#include <string.h>

#include "bsp/spans.h"
#include "iritx/distance.h"
#include "mv/mv.h"
#include "solve/system_impl.h"

#define MAX_BOXES 20000 /* of one pair of spans, see meet.c */

typedef struct {
    ix_ctx *ctx;
    ix_spans sp;
    int d;        /* degree */
    double *b[3]; /* Bernstein coefficients of w, x, y on sp */
    ix__found found;
    bool complete;
    size_t boxes;
} self;

/* How a pair's own parameters map to (t, r). */
typedef void (*map_fn)(const self *s, int i, int j, const double *own,
                       double *tr);

static const double *span(const self *s, int axis, int i)
{
    return s->b[axis] + (size_t)i * (size_t)(s->d + 1);
}

static double at(const self *s, int i, double u)
{
    const double *br = s->sp.breaks;

    return u >= 1 ? br[i + 1] : br[i] + u * (br[i + 1] - br[i]);
}

/* --- tensors
 * -------------------------------------------------------------------- */

/* (p(t) q(r) - p(r) q(t)) / (t - r) of degree n - 1 in both, p and q of degree
 * n >= 1; out[n][n]. Bini and Gemignani 2004, eq. (3.3). */
static void bezoutian(const double *p, const double *q, int n, double *out)
{
    double f = n;

    for (int i = 1; i <= n; i++)
        out[i - 1] = f / i * (p[i] * q[0] - p[0] * q[i]);
    for (int j = 1; j < n; j++)
        for (int i = 1; i <= n; i++) {
            double g = f * f / (i * (f - j));
            double h = i < n ? j * (f - i) / (i * (f - j)) : 0;

            out[i - 1 + j * n] = g * (p[i] * q[j] - p[j] * q[i]) +
                                 (i < n ? h * out[i + (j - 1) * n] : 0);
        }
}

/* F on span i (as t) and span j (as r): out[d+1][d+1]. */
static void difference(const self *s, int axis, int i, int j, double *out)
{
    const double *xi = span(s, axis, i), *wi = span(s, 0, i);
    const double *xj = span(s, axis, j), *wj = span(s, 0, j);
    int m = s->d + 1;

    for (int l = 0; l < m; l++)
        for (int k = 0; k < m; k++)
            out[k + l * m] = xi[k] * wj[l] - xj[l] * wi[k];
}

/* The tensor with direction 1 reversed: r is then measured from its end. */
static void reverse_second(double *c, int m)
{
    for (int l = 0; l < m / 2; l++)
        for (int k = 0; k < m; k++) {
            double t = c[k + l * m];

            c[k + l * m] = c[k + (m - 1 - l) * m];
            c[k + (m - 1 - l) * m] = t;
        }
}

static void transpose(double *c, int m)
{
    for (int l = 0; l < m; l++)
        for (int k = 0; k < l; k++) {
            double t = c[k + l * m];

            c[k + l * m] = c[l + k * m];
            c[l + k * m] = t;
        }
}

static double binomial(int n, int k)
{
    double r = 1;

    for (int i = 1; i <= k; i++)
        r = r * (n - k + i) / i;
    return r;
}

/* F(s, s m) / s for F of degree d in both with F(0, 0) = 0: degree 2d - 1 in s,
 * d in m. With 1 - s m = (1 - s) + s (1 - m) every term is a positive multiple
 * of a scaled Bernstein function. out[2d][d+1]. */
static void blow_up(const double *c, int d, double *out)
{
    int ns = 2 * d;

    memset(out, 0, (size_t)ns * (size_t)(d + 1) * sizeof *out);
    for (int j = 0; j <= d; j++)
        for (int i = 0; i <= d; i++) {
            double v = c[i + j * (d + 1)] * binomial(d, i) * binomial(d, j);

            if (i + j == 0)
                continue;
            for (int k = 0; k <= d - j; k++) {
                /* m^j (1-m)^k, raised to degree d */
                int up = d - j - k;
                double w = v * binomial(d - j, k);

                for (int e = 0; e <= up; e++)
                    out[i + j + k - 1 + (j + e) * ns] += w * binomial(up, e);
            }
        }
    for (int q = 0; q <= d; q++)
        for (int p = 0; p < ns; p++)
            out[p + q * ns] /= binomial(ns - 1, p) * binomial(d, q);
}

/* --- one pair of spans
 * ---------------------------------------------------------------- */

static void map_plain(const self *s, int i, int j, const double *own,
                      double *tr)
{
    tr[0] = at(s, i, own[0]);
    tr[1] = at(s, j, own[1]);
}

static void map_wide(const self *s, int i, int j, const double *own, double *tr)
{
    tr[0] = at(s, i, own[0]);
    tr[1] = at(s, j, 1 - own[0] * own[1]);
}

static void map_narrow(const self *s, int i, int j, const double *own,
                       double *tr)
{
    tr[0] = at(s, i, own[0] * own[1]);
    tr[1] = at(s, j, 1 - own[0]);
}

static ix_status solve_pair(ix_ctx *ctx, int m, int n, const double *x,
                            const double *y, ix_solutions *out)
{
    const ix_dir dirs[2] = {{.basis = IX_BEZIER, .order = m, .length = m},
                            {.basis = IX_BEZIER, .order = n, .length = n}};
    const ix_solve_opts o = {.max_boxes = MAX_BOXES};
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    ix_status st;
    ix_mv *f, *g;

    IX_TRY(ix_mv_new(ctx, 2, dirs, 1, false, x, &f));
    st = ix_mv_new(ctx, 2, dirs, 1, false, y, &g);
    if (st == IX_OK) {
        eq[0].f = f;
        eq[1].f = g;
        st = ix_solve(ctx, 2, eq, &o, out);
        ix_mv_unref(ctx, g);
    }
    ix_mv_unref(ctx, f);
    return st;
}

/* Keeps solutions with t < r; a cusp (t = r) is no crossing. */
static ix_status keep(self *s, const ix_solutions *sol, map_fn map, int i,
                      int j)
{
    double len = s->sp.breaks[s->sp.nspans] - s->sp.breaks[0];

    for (int k = 0; k < sol->n; k++) {
        ix_solution r = sol->sol[k];
        double pad = 0;

        for (int e = 0; e < 2; e++)
            pad = fmax(pad, r.hi[e] - r.lo[e]);
        map(s, i, j, sol->sol[k].x, r.x);
        if (r.x[0] > r.x[1]) {
            double t = r.x[0];

            r.x[0] = r.x[1];
            r.x[1] = t;
        }
        if (!(r.x[1] - r.x[0] > 1e-9 * len))
            continue;
        for (int e = 0; e < 2; e++) {
            r.lo[e] = r.x[e] - pad * len;
            r.hi[e] = r.x[e] + pad * len;
        }
        IX_TRY(ix__found_add(&s->found, &r));
    }
    return IX_OK;
}

static ix_status run_pair(self *s, int m, int n, const double *x,
                          const double *y, map_fn map, int i, int j)
{
    ix_solutions sol;
    ix_status st;

    IX_TRY(solve_pair(s->ctx, m, n, x, y, &sol));
    s->boxes += sol.boxes;
    s->complete = s->complete && sol.complete;
    st = keep(s, &sol, map, i, j);
    ix_solutions_free(s->ctx, &sol);
    return st;
}

/* Both projected control boxes overlap, or a weight is not positive. */
static bool may_meet(const self *s, int i, int j)
{
    for (int axis = 1; axis <= 2; axis++) {
        double lo[2] = {HUGE_VAL, HUGE_VAL}, hi[2] = {-HUGE_VAL, -HUGE_VAL};

        for (int e = 0; e < 2; e++)
            for (int k = 0; k <= s->d; k++) {
                double w = span(s, 0, e ? j : i)[k];
                double x = span(s, axis, e ? j : i)[k] / w;

                if (!(w > 0))
                    return true;
                lo[e] = fmin(lo[e], x);
                hi[e] = fmax(hi[e], x);
            }
        if (lo[0] > hi[1] || lo[1] > hi[0])
            return false;
    }
    return true;
}

static ix_status same_span(self *s, int i, double *x, double *y)
{
    if (s->d < 2)
        return IX_OK; /* a straight piece */
    bezoutian(span(s, 1, i), span(s, 0, i), s->d, x);
    bezoutian(span(s, 2, i), span(s, 0, i), s->d, y);
    return run_pair(s, s->d, s->d, x, y, map_plain, i, i);
}

/* The start of span i is the end of span j. */
static ix_status touching(self *s, int i, int j, double *x, double *y,
                          double *f)
{
    int m = s->d + 1;

    for (int narrow = 0; narrow <= 1; narrow++) {
        for (int axis = 1; axis <= 2; axis++) {
            difference(s, axis, i, j, f);
            reverse_second(f, m);
            if (narrow)
                transpose(f, m);
            blow_up(f, s->d, axis == 1 ? x : y);
        }
        IX_TRY(run_pair(s, 2 * s->d, m, x, y, narrow ? map_narrow : map_wide, i,
                        j));
    }
    return IX_OK;
}

/* Whether span j ends where span i begins, to 1e-9 of the curve's size. */
static bool joined(const self *s, int i, int j)
{
    double gap = 0, size = 0;

    for (int axis = 1; axis <= 2; axis++) {
        const double *p = span(s, axis, i), *q = span(s, axis, j);
        double a = p[0] / span(s, 0, i)[0], b = q[s->d] / span(s, 0, j)[s->d];

        gap = fmax(gap, fabs(a - b));
        for (int k = 0; k <= s->d; k++)
            size = fmax(size, fmax(fabs(p[k]), fabs(q[k])));
    }
    return gap <= 1e-9 * size;
}

static ix_status all_pairs(self *s)
{
    size_t room = (size_t)(2 * s->d + 2) * (size_t)(s->d + 2);
    double *x, *y, *f;
    int n = s->sp.nspans;

    IX_SCRATCH(s->ctx, x, room);
    IX_SCRATCH(s->ctx, y, room);
    IX_SCRATCH(s->ctx, f, room);
    for (int j = 0; j < n; j++) {
        IX_TRY(same_span(s, j, x, y));
        for (int i = j + 1; i < n; i++) {
            bool next = i == j + 1 && joined(s, i, j);
            bool seam = j == 0 && i == n - 1 && joined(s, j, i);

            if (!may_meet(s, i, j))
                continue;
            if (seam && n == 2)
                seam = false; /* both ends are shared: one blow-up each */
            if (next || seam) {
                IX_TRY(touching(s, next ? i : j, next ? j : i, x, y, f));
                continue;
            }
            difference(s, 1, i, j, x);
            difference(s, 2, i, j, y);
            IX_TRY(run_pair(s, s->d + 1, s->d + 1, x, y, map_plain, i, j));
        }
    }
    return IX_OK;
}

/* --- the call
 * ----------------------------------------------------------------------------
 */

static ix_status load(self *s, const ix_mv *c)
{
    size_t n;

    IX_TRY(ix__spans_of(s->ctx, &c->dirs[0], &s->sp));
    s->d = s->sp.degree;
    n = (size_t)s->sp.nspans * (size_t)(s->d + 1);
    for (int k = 0; k < 3; k++) {
        IX_SCRATCH(s->ctx, s->b[k], n);
        if (k == 0 && !c->rational) {
            for (size_t i = 0; i < n; i++)
                s->b[0][i] = 1;
            continue;
        }
        IX_TRY(ix__spans_extract(s->ctx, &c->dirs[0], &s->sp, 1, 1,
                                 k ? ix_mv_coord(c, k - 1) : ix_mv_weights(c),
                                 s->b[k]));
    }
    return IX_OK;
}

/* The trivial meeting of the two ends of a closed curve goes. */
static void drop_seam(self *s, const double dom[2])
{
    double tie = 1e-9 * (dom[1] - dom[0]);
    int n = 0;

    for (int i = 0; i < s->found.n; i++) {
        const ix_solution *r = &s->found.sol[i];

        if (!(r->x[0] - dom[0] <= tie && dom[1] - r->x[1] <= tie))
            s->found.sol[n++] = *r;
    }
    s->found.n = n;
}

static ix_status find(ix_ctx *ctx, const ix_mv *c, ix_solutions *out)
{
    self s = {.ctx = ctx, .found = {.ctx = ctx}, .complete = true};
    double dom[2], edge[2];

    IX_TRY(load(&s, c));
    if (s.d < 1)
        return IX_OK;
    IX_TRY(all_pairs(&s));
    ix_mv_domain(c, 0, dom);
    drop_seam(&s, dom);
    edge[0] = edge[1] = dom[1] - dom[0];
    IX_TRY(ix__found_merge(&s.found, 2, edge));
    out->unknowns = 2;
    out->boxes = s.boxes;
    out->complete = s.complete;
    if (s.found.n == 0)
        return IX_OK;
    out->bytes = (size_t)s.found.n * sizeof *out->sol;
    out->sol = ix__alloc(ctx, out->bytes);
    if (!out->sol)
        return IX_ENOMEM;
    memcpy(out->sol, s.found.sol, out->bytes);
    out->n = s.found.n;
    return IX_OK;
}

ix_status ix_crv_self_meet(ix_ctx *ctx, const ix_mv *c, ix_solutions *out)
{
    ix_mark mk;
    ix_status st;

    *out = (ix_solutions){.n = 0};
    if (c->ndirs != 1 || c->ncoords < 2 || c->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates%s; a Bezier or "
                       "B-spline curve of 2 or more is wanted",
                       c->ndirs, c->ncoords,
                       c->dirs[0].basis == IX_POWER ? ", power basis" : "");
    mk = ix__scratch_mark(ctx);
    st = find(ctx, c, out);
    ix__scratch_release(ctx, mk);
    return st;
}
