/* arclen.c - length of curves and curves by arc length.
 *
 * The reparametrised curve is a spline in the arc length s, fitted to pairs
 * (s(t), C(t)) on knots that are bisected until the error, measured between
 * the nodes of the fit, is small enough. Corners of the curve are C0 knots. */
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

double ix__path_at_length(const ix_path *p, double t0, double t1, double s)
{
    int last = ix__path_span(p, t1);

    for (int i = ix__path_span(p, t0); i <= last; i++) {
        double a = fmax(t0, p->breaks[i]), b = fmin(t1, p->breaks[i + 1]);
        double len = b > a ? ix__span_length(p, i, a, b) : 0;

        if (s < len)
            return ix__span_at_length(p, i, a, b, len, s);
        s -= len;
    }
    return t1;
}

/* --- by arc length
 * ------------------------------------------------------------
 */

/* One knot interval of the fit, and what is known of the curve there. */
typedef struct {
    int span;
    double t0, t1; /* parameters of the curve, within the span */
    double s0, s1; /* arc lengths */
    int cont;      /* continuity wanted at s1 */
    double err;
    double *tab; /* [nodes][1 + ncoords]: arc length, point */
} cell;

typedef struct {
    const ix_path *p;
    double tol;
    int order, n;
    cell *cells;
    ix_dir dir;
    double *coef;        /* [ncoords][length] */
    int nodes;           /* in a cell, in rising order: */
    double *x, *w;       /* place in [0, 1]; weight in the fit, 0: a check */
    double gx[5], gw[5]; /* quadrature between two of them */
    double *basis;       /* [order] */
} fit;

/* order + 2 Gauss nodes for the fit and twice as many even ones for checks,
 * merged. */
static ix_status make_nodes(ix_ctx *ctx, fit *f)
{
    int g = f->order + 2, m = 2 * g + 1, i = 0, j = 0;
    double *x, *w;

    IX_SCRATCH(ctx, x, g);
    IX_SCRATCH(ctx, w, g);
    ix__gauss(g, x, w);
    ix__gauss(5, f->gx, f->gw);
    f->nodes = g + m + 1;
    IX_SCRATCH(ctx, f->x, f->nodes);
    IX_SCRATCH(ctx, f->w, f->nodes);
    for (int k = 0; k < f->nodes; k++) {
        bool fitted = i < g && x[i] < (double)j / m;

        f->x[k] = fitted ? x[i] : (double)j / m;
        f->w[k] = fitted ? w[i] : 0;
        i += fitted;
        j += !fitted;
    }
    return IX_OK;
}

/* Continuity at the break after span s: known, unless there is a corner. */
static int join_cont(const ix_path *p, int s, int order)
{
    int cont = p->cont[s];

    if (cont < 0)
        return -1;
    if (cont < order && ix__path_is_corner(p, s + 1))
        return 0;
    return cont > 1 ? cont : 1; /* no corner: tangents agree */
}

/* Length between two neighbouring nodes. */
static double short_length(const fit *f, int span, double a, double b)
{
    double s = 0;

    for (int i = 0; i < 5; i++)
        s += f->gw[i] * speed(f->p, span, a + (b - a) * f->gx[i]);
    return s * (b - a);
}

/* Arc lengths and points at the nodes of a cell whose length is known. */
static ix_status tabulate(ix_ctx *ctx, const fit *f, cell *c)
{
    int row = 1 + f->p->ncoords;
    double h = c->t1 - c->t0, len = c->s1 - c->s0, sum = 0;

    IX_SCRATCH(ctx, c->tab, f->nodes * row);
    for (int exact = 0; exact < 2; exact++) {
        sum = 0;
        for (int i = 0; i < f->nodes; i++) {
            double t = c->t0 + h * f->x[i];
            double a = c->t0 + h * f->x[i ? i - 1 : 0];

            if (i)
                sum += exact ? ix__span_length(f->p, c->span, a, t)
                             : short_length(f, c->span, a, t);
            c->tab[i * row] = sum;
        }
        if (fabs(sum - len) <= 1e-11 * len) /* the short rule will do */
            break;
    }
    for (int i = 0; i < f->nodes; i++) {
        double *r = c->tab + i * row;

        r[0] = i == f->nodes - 1 ? c->s1 : c->s0 + r[0] * (len / sum);
        ix__path_derivs(f->p, c->span, c->t0 + h * f->x[i], 0, r + 1);
    }
    return IX_OK;
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
        IX_TRY(tabulate(ctx, f, &c));
        f->cells[f->n++] = c;
    }
    if (f->n == 0)
        return IX_FAIL(ctx, IX_EDOMAIN, "the curve has length 0");
    return IX_OK;
}

static int multiplicity(const fit *f, int i)
{
    int mult = f->order - 1 - f->cells[i].cont;

    return mult > 1 ? mult : 1;
}

static ix_status make_dir(ix_ctx *ctx, fit *f)
{
    int k = f->order, n = k;
    double *knots;

    for (int i = 0; i + 1 < f->n; i++)
        n += multiplicity(f, i);
    IX_SCRATCH(ctx, knots, n + k);
    n = 0;
    for (int i = 0; i < k; i++)
        knots[n++] = f->cells[0].s0;
    for (int i = 0; i + 1 < f->n; i++)
        for (int j = 0; j < multiplicity(f, i); j++)
            knots[n++] = f->cells[i].s1;
    f->dir = (ix_dir){
        .basis = IX_BSPLINE, .order = k, .length = n, .knots = knots};
    for (int i = 0; i < k; i++)
        knots[n++] = f->cells[f->n - 1].s1;
    return IX_OK;
}

/* First control point that counts in cell i, given that of cell i - 1. */
static int first_point(const fit *f, int i, int before)
{
    return i ? before + multiplicity(f, i - 1) : 0;
}

static double error_at(const fit *f, int first, const double *row)
{
    double sum = 0;

    ix__basis_derive(&f->dir, first, row[0], 0, f->basis);
    for (int k = 0; k < f->p->ncoords; k++) {
        const double *q = f->coef + k * f->dir.length + first;
        double d = -row[1 + k];

        for (int i = 0; i < f->order; i++)
            d += f->basis[i] * q[i];
        sum += d * d;
    }
    return sqrt(sum);
}

static void add_row(const fit *f, int first, const double *row, double weight,
                    ix_band *band)
{
    double rhs[IX_MAX_COORDS], root = sqrt(weight);

    ix__basis_derive(&f->dir, first, row[0], 0, f->basis);
    for (int i = 0; i < f->order; i++)
        f->basis[i] *= root;
    for (int k = 0; k < f->p->ncoords; k++)
        rhs[k] = root * row[1 + k];
    ix__band_add(band, first, f->order, f->basis, rhs);
}

/* The largest error of each cell: between the nodes, and at the ends. */
static void measure(fit *f)
{
    int first = 0, step = 1 + f->p->ncoords;

    for (int i = 0; i < f->n; i++) {
        cell *c = &f->cells[i];

        first = first_point(f, i, first);
        c->err = 0;
        for (int j = 0; j < f->nodes; j++)
            if (f->w[j] == 0)
                c->err = fmax(c->err, error_at(f, first, c->tab + j * step));
    }
}

/* Fits on the present cells; the ends are made exact. */
static ix_status solve(ix_ctx *ctx, fit *f)
{
    int n, nc = f->p->ncoords, first = 0, step = 1 + nc;
    const double *start = f->cells[0].tab;
    const double *end = f->cells[f->n - 1].tab + (f->nodes - 1) * step;
    ix_band band;

    IX_TRY(make_dir(ctx, f));
    n = f->dir.length;
    IX_SCRATCH(ctx, f->coef, (size_t)n * (size_t)nc);
    IX_TRY(ix__band_new(ctx, n, f->order, false, nc, &band));
    for (int i = 0; i < f->n; i++) {
        const cell *c = &f->cells[i];

        first = first_point(f, i, first);
        for (int j = 0; j < f->nodes; j++)
            if (f->w[j] > 0)
                add_row(f, first, c->tab + j * step, f->w[j] * (c->s1 - c->s0),
                        &band);
    }
    IX_TRY(ix__band_solve(ctx, &band, f->coef));
    for (int k = 0; k < nc; k++) {
        f->coef[k * n] = start[1 + k];
        f->coef[k * n + n - 1] = end[1 + k];
    }
    measure(f);
    return IX_OK;
}

/* Halves the cells whose error is too large; done: none is. */
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
        c.t1 = d.t0 = c.t0 + (c.t1 - c.t0) / 2;
        c.s1 = d.s0 = c.s0 + ix__span_length(f->p, c.span, c.t0, c.t1);
        c.cont = f->order - 2;
        IX_TRY(tabulate(ctx, f, &c));
        IX_TRY(tabulate(ctx, f, &d));
        out[n - 1] = c;
        out[n++] = d;
    }
    f->cells = out;
    f->n = n;
    return ix__poll(ctx);
}

static ix_status arclen(ix_ctx *ctx, const ix_mv *crv, double tol, int order,
                        double *err, ix_mv **out)
{
    fit f = {.tol = tol, .order = order};
    const int most = 1 << 16; /* cells; a cubic would reach 1e-18 with them */
    bool done = false;
    ix_path p;

    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__path_no_poles(ctx, &p));
    f.p = &p;
    /* points themselves are good to some 1e-16 of the size */
    if (!(tol > 1e-15 * ix__path_size(&p)))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "tolerance %g is below the rounding of a curve of size "
                       "%g",
                       tol, ix__path_size(&p));
    IX_SCRATCH(ctx, f.basis, order);
    IX_TRY(make_nodes(ctx, &f));
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
