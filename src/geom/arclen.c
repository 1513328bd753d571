/* arclen.c - length of curves and curves by arc length.
 *
 * The reparametrised curve is a spline in the arc length s, fitted to C(t(s))
 * on knots that are bisected until the error, measured between the nodes of
 * the fit, is small enough. Corners of the curve are C0 knots. */
#include "geom/arclen.h"

#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/gauss.h"
#include "geom/quad.h"
#include "iritx/geom.h"

#define RTOL 1e-13 /* of quadrature; the promise is 1e-12 */

typedef struct {
    const ix_path *p;
    int span;
} on_span;

static double speed(const ix_path *p, int span, double t)
{
    double d[2 * IX_MAX_COORDS], s = 0;

    ix__path_derivs(p, span, t, 1, d);
    for (int c = 0; c < p->ncoords; c++)
        s += d[p->ncoords + c] * d[p->ncoords + c];
    return sqrt(s);
}

static void speed_at(void *arg, double t, double *f)
{
    const on_span *o = arg;

    f[0] = speed(o->p, o->span, t);
}

double ix__span_length(const ix_path *p, int span, double a, double b)
{
    on_span o = {p, span};
    double s;

    ix__quad(speed_at, &o, 1, a, b, RTOL, &s);
    return s;
}

double ix__path_length(const ix_path *p, double t0, double t1)
{
    double s = 0;

    for (int i = ix__path_span(p, t0); i < p->nspans && p->breaks[i] < t1; i++)
        s += ix__span_length(p, i, fmax(t0, p->breaks[i]),
                             fmin(t1, p->breaks[i + 1]));
    return s;
}

double ix__span_at_length(const ix_path *p, int span, double a, double b,
                          double total, double s)
{
    double lo = a, hi = b, t = a + (b - a) * (s / total), at = 0, from = a;

    if (!(s > 0))
        return a;
    if (s >= total)
        return b;
    for (int i = 0; i < 100; i++) { /* Newton, kept inside a bracket */
        double v, next;

        at += ix__span_length(p, span, from, t);
        from = t;
        if (fabs(at - s) <= 1e-14 * total)
            break;
        if (at < s)
            lo = t;
        else
            hi = t;
        v = speed(p, span, t);
        next = v > 0 ? t - (at - s) / v : lo;
        t = next > lo && next < hi ? next : lo + (hi - lo) / 2;
        if (t == from)
            break;
    }
    return t;
}

/* --- by arc length
 * ------------------------------------------------------------ */

/* One knot interval of the fit. */
typedef struct {
    int span;
    double t0, t1; /* parameters of the curve, within the span */
    double s0, s1; /* arc lengths */
    int cont;      /* continuity wanted at s1 */
    double err;
} cell;

typedef struct {
    const ix_path *p;
    double tol;
    int order, n;
    cell *cells;
    ix_dir dir;
    double *coef;  /* [ncoords][length] */
    double *x, *w; /* Gauss nodes in a cell */
    int nodes;
    double *basis; /* [order] */
} fit;

/* Continuity at the break after span s: known, unless there is a corner. */
static int join_cont(const ix_path *p, int s, int order)
{
    int cont = p->cont[s];

    if (cont < 0)
        return -1;
    /* a turn of 1e-6 is a corner, less is rounding of control points */
    if (cont < order && ix__path_corner(p, s + 1, cos(1e-6)) == s + 1)
        return 0;
    return cont > 1 ? cont : 1; /* no corner: tangents agree */
}

/* A cell for each span that has length. */
static ix_status first_cells(ix_ctx *ctx, fit *f)
{
    double s = 0;

    IX_SCRATCH(ctx, f->cells, f->p->nspans);
    f->n = 0;
    for (int i = 0; i < f->p->nspans; i++) {
        cell c = {.span = i, .t0 = f->p->breaks[i], .t1 = f->p->breaks[i + 1]};
        double len = ix__span_length(f->p, i, c.t0, c.t1);

        if (!isfinite(len))
            return IX_FAIL(ctx, IX_EDOMAIN, "the length of [%g, %g] is %g",
                           c.t0, c.t1, len);
        if (!(len > 0))
            continue;
        c.s0 = s;
        c.s1 = s += len;
        if (i + 1 < f->p->nspans)
            c.cont = join_cont(f->p, i, f->order);
        f->cells[f->n++] = c;
    }
    if (f->n == 0)
        return IX_FAIL(ctx, IX_EDOMAIN, "the curve has length 0");
    return IX_OK;
}

static ix_status make_dir(ix_ctx *ctx, fit *f)
{
    int k = f->order, n = k;
    double *knots;

    for (int i = 0; i + 1 < f->n; i++) {
        int mult = k - 1 - f->cells[i].cont;

        n += mult > 1 ? mult : 1;
    }
    IX_SCRATCH(ctx, knots, n + k);
    n = 0;
    for (int i = 0; i < k; i++)
        knots[n++] = f->cells[0].s0;
    for (int i = 0; i + 1 < f->n; i++) {
        int mult = k - 1 - f->cells[i].cont;

        for (int j = 0; j < (mult > 1 ? mult : 1); j++)
            knots[n++] = f->cells[i].s1;
    }
    f->dir = (ix_dir){
        .basis = IX_BSPLINE, .order = k, .length = n, .knots = knots};
    for (int i = 0; i < k; i++)
        knots[n++] = f->cells[f->n - 1].s1;
    return IX_OK;
}

/* C(t(s)) for a fraction x of the cell's length. */
static void target(const fit *f, const cell *c, double x, double *out)
{
    double len = c->s1 - c->s0;
    double t = ix__span_at_length(f->p, c->span, c->t0, c->t1, len, x * len);

    ix__path_derivs(f->p, c->span, t, 0, out);
}

static double error_at(const fit *f, const cell *c, double x)
{
    double want[IX_MAX_COORDS], s = c->s0 + x * (c->s1 - c->s0), sum = 0;
    int first = ix__basis_first(&f->dir, s);

    target(f, c, x, want);
    ix__basis_derive(&f->dir, first, s, 0, f->basis);
    for (int k = 0; k < f->p->ncoords; k++) {
        const double *q = f->coef + k * f->dir.length + first;
        double d = -want[k];

        for (int i = 0; i < f->order; i++)
            d += f->basis[i] * q[i];
        sum += d * d;
    }
    return sqrt(sum);
}

static void add_cell(const fit *f, const cell *c, ix_band *band)
{
    double rhs[IX_MAX_COORDS];

    for (int g = 0; g < f->nodes; g++) {
        double s = c->s0 + f->x[g] * (c->s1 - c->s0);
        double root = sqrt(f->w[g] * (c->s1 - c->s0));
        int first = ix__basis_first(&f->dir, s);

        ix__basis_derive(&f->dir, first, s, 0, f->basis);
        target(f, c, f->x[g], rhs);
        for (int i = 0; i < f->order; i++)
            f->basis[i] *= root;
        for (int k = 0; k < f->p->ncoords; k++)
            rhs[k] *= root;
        ix__band_add(band, first, f->order, f->basis, rhs);
    }
}

/* Fits on the present cells; the ends are made exact. */
static ix_status solve(ix_ctx *ctx, fit *f)
{
    const cell *last = &f->cells[f->n - 1];
    double ends[2][IX_MAX_COORDS];
    ix_band band;
    int n;

    IX_TRY(make_dir(ctx, f));
    n = f->dir.length;
    IX_SCRATCH(ctx, f->coef, (size_t)n * (size_t)f->p->ncoords);
    IX_TRY(ix__band_new(ctx, n, f->order, false, f->p->ncoords, &band));
    for (int i = 0; i < f->n; i++) {
        IX_TRY(ix__poll(ctx));
        add_cell(f, &f->cells[i], &band);
    }
    IX_TRY(ix__band_solve(ctx, &band, f->coef));
    ix__path_derivs(f->p, f->cells[0].span, f->cells[0].t0, 0, ends[0]);
    ix__path_derivs(f->p, last->span, last->t1, 0, ends[1]);
    for (int k = 0; k < f->p->ncoords && f->order > 1; k++) {
        f->coef[k * n] = ends[0][k];
        f->coef[k * n + n - 1] = ends[1][k];
    }
    for (int i = 0; i < f->n; i++) { /* between the nodes, and at the ends */
        cell *c = &f->cells[i];
        int m = 2 * f->nodes + 1;

        c->err = 0;
        for (int j = 0; j <= m; j++)
            c->err = fmax(c->err, error_at(f, c, (double)j / m));
    }
    return IX_OK;
}

/* Halves (in length) the cells whose error is too large; false: none is. */
static ix_status refine(ix_ctx *ctx, fit *f, bool *done)
{
    cell *out;
    int n = 0;

    *done = true;
    IX_SCRATCH(ctx, out, 2 * f->n);
    for (int i = 0; i < f->n; i++) {
        cell c = f->cells[i], d = c;

        out[n++] = c;
        /* 0.8: room for what sampling misses */
        if (c.err <= 0.8 * f->tol)
            continue;
        *done = false;
        out[n - 1].s1 = d.s0 = (c.s0 + c.s1) / 2;
        out[n - 1].t1 = d.t0 = ix__span_at_length(
            f->p, c.span, c.t0, c.t1, c.s1 - c.s0, (c.s1 - c.s0) / 2);
        out[n - 1].cont = f->order - 2;
        out[n++] = d;
    }
    f->cells = out;
    f->n = n;
    return IX_OK;
}

static ix_status arclen(ix_ctx *ctx, const ix_mv *crv, double tol, int order,
                        double *err, ix_mv **out)
{
    fit f = {.tol = tol, .order = order, .nodes = order + 2};
    const int most = 1 << 16; /* cells; a cubic would reach 1e-18 with them */
    bool done = false;
    ix_path p;

    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__path_no_poles(ctx, &p));
    f.p = &p;
    IX_SCRATCH(ctx, f.x, f.nodes);
    IX_SCRATCH(ctx, f.w, f.nodes);
    IX_SCRATCH(ctx, f.basis, order);
    ix__gauss(f.nodes, f.x, f.w);
    IX_TRY(first_cells(ctx, &f));
    while (!done) {
        if (f.n > most)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "%g not reached with %d spans of order %d", tol,
                           f.n / 2, order);
        IX_TRY(solve(ctx, &f));
        IX_TRY(refine(ctx, &f, &done));
    }
    *err = 0;
    for (int i = 0; i < f.n; i++)
        *err = fmax(*err, f.cells[i].err);
    return ix_mv_new(ctx, 1, &f.dir, p.ncoords, false, f.coef, out);
}

ix_status ix_arclen(ix_ctx *ctx, const ix_mv *crv, double tol, int order,
                    double *err, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    double worst;
    ix_status st;

    *out = NULL;
    if (!(tol > 0 && isfinite(tol)))
        return IX_FAIL(ctx, IX_EARG, "tolerance %g is not positive", tol);
    if (order < 2 || order > 32)
        return IX_FAIL(ctx, IX_EARG, "order %d is not within 2 .. 32", order);
    st = arclen(ctx, crv, tol, order, &worst, out);
    if (err && st == IX_OK)
        *err = worst;
    ix__scratch_release(ctx, mk);
    return st;
}

static ix_status length(ix_ctx *ctx, const ix_mv *crv, const double *range,
                        double *out)
{
    double t0, t1;
    ix_path p;

    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__path_no_poles(ctx, &p));
    t0 = range ? range[0] : p.breaks[0];
    t1 = range ? range[1] : p.breaks[p.nspans];
    if (!(t0 <= t1 && t0 >= p.breaks[0] && t1 <= p.breaks[p.nspans]))
        return IX_FAIL(ctx, IX_EDOMAIN, "[%g, %g] is not within [%g, %g]", t0,
                       t1, p.breaks[0], p.breaks[p.nspans]);
    *out = ix__path_length(&p, t0, t1);
    return IX_OK;
}

ix_status ix_length(ix_ctx *ctx, const ix_mv *crv, const double *range,
                    double *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = length(ctx, crv, range, out);

    ix__scratch_release(ctx, mk);
    return st;
}
