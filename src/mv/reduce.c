/* reduce.c - lower order and fewer knots, by the nearest spline of the smaller
 * space, with a bound of the change. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bsp/spans.h"
#include "mv/mv.h"

/* One direction as Bernstein pieces. */
typedef struct {
    const ix_mv *m;
    int dir;
    ix__mv_extent s;
    ix_spans sp;
    double *bern; /* [outer][nspans * order][inner] */
} pieces;

static ix_status cut(ix_ctx *ctx, const ix_mv *m, int dir, pieces *p)
{
    const ix_dir *d = m->dirs + dir;

    p->m = m;
    p->dir = dir;
    p->s = ix__mv_shape(m, dir);
    IX_TRY(ix__spans_of(ctx, d, &p->sp));
    IX_SCRATCH(ctx, p->bern,
               p->s.outer * (size_t)p->sp.nspans * (size_t)d->order *
                   p->s.inner);
    return ix__spans_extract(ctx, d, &p->sp, p->s.outer, p->s.inner, m->pts,
                             p->bern);
}

/* Largest and smallest absolute value on one axis. */
static void range(const ix_mv *m, int axis, double *least, double *most)
{
    const double *x = ix_mv_axis(m, axis);

    *least = HUGE_VAL;
    *most = 0;
    for (size_t i = 0; i < m->npts; i++) {
        *least = fmin(*least, fabs(x[i]));
        *most = fmax(*most, fabs(x[i]));
    }
}

/* Bound of the change of any Euclidean coordinate, from those of the axes
 * (err[outer], axis after axis): |x/w - x'/w'| <= (|x - x'| + |x/w| |w - w'|)
 * / |w'|. Without a lower bound for the weight: HUGE_VAL. */
static double change(const ix_mv *m, size_t outer, const double *err)
{
    size_t each = outer / (size_t)m->naxes;
    double axis[IX_MAX_COORDS + 1] = {0}, worst = 0, wmin, w, most, least;

    for (int a = 0; a < m->naxes; a++) {
        for (size_t i = 0; i < each; i++)
            axis[a] = fmax(axis[a], err[(size_t)a * each + i]);
    }
    for (int a = m->rational; a < m->naxes; a++)
        worst = fmax(worst, axis[a]);
    if (!m->rational)
        return worst;
    range(m, 0, &wmin, &w);
    if (ix_mv_has_poles(m) || !(wmin > axis[0]))
        return worst > 0 || axis[0] > 0 ? HUGE_VAL : 0;
    worst = 0;
    for (int a = 1; a < m->naxes; a++) {
        range(m, a, &least, &most);
        worst = fmax(worst,
                     (axis[a] + most / wmin * axis[0]) / (wmin - axis[0]));
    }
    return worst;
}

/* m with direction dir replaced by the nearest spline in nd. */
static ix_status fit(ix_ctx *ctx, const pieces *p, const ix_dir *nd,
                     double *err, ix_mv **out)
{
    double *each;
    ix_mv *r;
    ix_status st;

    IX_SCRATCH(ctx, each, p->s.outer);
    IX_TRY(ix__mv_alloc_like(ctx, p->m, p->dir, nd, &r));
    st = ix__spans_fit(ctx, &p->sp, nd, p->s.outer, p->s.inner, p->bern, r->pts,
                       each);
    if (st == IX_OK)
        *err = change(p->m, p->s.outer, each);
    return ix__mv_finish(ctx, st, r, out);
}

/* --- order ---------------------------------------------------------------- */

static ix_status reduce(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                        double *err, ix_mv **out)
{
    bool bezier = m->dirs[dir].basis == IX_BEZIER;
    ix_spans lower;
    pieces p;
    int *cont;
    ix_dir nd;

    IX_TRY(cut(ctx, m, dir, &p));
    lower = p.sp;
    lower.degree = order - 1;
    IX_SCRATCH(ctx, cont, p.sp.nspans);
    for (int j = 0; j < p.sp.nspans - 1; j++) /* every break stays */
        cont[j] = p.sp.cont[j] < order - 2 ? p.sp.cont[j] : order - 2;
    lower.cont = cont;
    IX_TRY(ix__spans_target(ctx, &lower, INT_MAX, bezier, &nd));
    return fit(ctx, &p, &nd, err, out);
}

ix_status ix_mv_reduce(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                       double *err, ix_mv **out)
{
    double unused;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (m->dirs[dir].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "direction %d: power basis", dir);
    if (order < 1 || order >= m->dirs[dir].order)
        return IX_FAIL(ctx, IX_EARG, "direction %d: order %d to order %d", dir,
                       m->dirs[dir].order, order);
    IX_RETURN_SCOPED(ctx, reduce(ctx, m, dir, order, err ? err : &unused, out));
}

/* --- knots ---------------------------------------------------------------- */

/* One copy of an interior knot: how much it matters. */
typedef struct {
    double weight;
    int brk, copy;
} candidate;

static int compare(const void *pa, const void *pb)
{
    const candidate *a = pa, *b = pb;

    if (a->weight != b->weight)
        return a->weight < b->weight ? -1 : 1;
    if (a->brk != b->brk)
        return a->brk < b->brk ? -1 : 1;
    return (a->copy > b->copy) - (a->copy < b->copy);
}

/* Jumps of the derivatives 0 .. degree of one lane at the break between spans
 * with Bernstein coefficients b and b + order, relative to the shorter span:
 * differences of the left one's end and of the right one's start. Raises
 * jump[k] to what is larger. buf[2 (degree + 1)]. */
static void raise_jumps(int degree, const double *b, size_t step,
                        const double h[2], double *buf, double *jump)
{
    double *l = buf, *r = buf + degree + 1, sl = 1, sr = 1;
    double shorter = fmin(h[0], h[1]);

    for (int i = 0; i <= degree; i++) {
        l[i] = b[(size_t)i * step];
        r[i] = b[(size_t)(degree + 1 + i) * step];
    }
    for (int k = 0; k <= degree; k++) {
        jump[k] = fmax(jump[k], fabs(sl * l[degree] - sr * r[0]));
        sl *= shorter / h[0];
        sr *= shorter / h[1];
        for (int i = degree; i > k; i--)
            l[i] -= l[i - 1];
        for (int i = 0; i < degree - k; i++)
            r[i] = r[i + 1] - r[i];
    }
}

/* The copies of the knot at break j (1 ..): removing the first one asks for
 * one more continuous derivative, and so on. */
static int add_candidates(const pieces *p, int j, double *buf, candidate *out)
{
    int degree = p->sp.degree, c = p->sp.cont[j - 1], n = 0;
    size_t span = (size_t)degree + 1, all = (size_t)p->sp.nspans * span;
    double *jump = buf + 2 * span, worst = 0;
    double h[2] = {p->sp.breaks[j] - p->sp.breaks[j - 1],
                   p->sp.breaks[j + 1] - p->sp.breaks[j]};

    memset(jump, 0, span * sizeof *jump);
    for (size_t o = 0; o < p->s.outer; o++)
        for (size_t l = 0; l < p->s.inner; l++)
            raise_jumps(degree,
                        p->bern +
                            (o * all + (size_t)(j - 1) * span) * p->s.inner + l,
                        p->s.inner, h, buf, jump);
    for (int k = c + 1; k <= degree; k++) {
        worst = fmax(worst, jump[k]);
        out[n] = (candidate){worst, j, n};
        n++;
    }
    return n;
}

typedef struct {
    pieces p;
    candidate *cand;
    int ncand;
    int *cont; /* room for the continuity of a trial */
    double tol;
} removal;

/* The fit without the first k candidates; *out NULL if it changes too much. */
static ix_status try_removal(ix_ctx *ctx, const removal *r, int k, ix_mv **out)
{
    ix_spans sp = r->p.sp;
    double err;
    ix_dir nd;

    *out = NULL;
    for (int j = 0; j < sp.nspans - 1; j++)
        r->cont[j] = sp.cont[j];
    for (int i = 0; i < k; i++)
        r->cont[r->cand[i].brk - 1]++;
    sp.cont = r->cont;
    IX_TRY(ix__poll(ctx));
    IX_TRY(ix__spans_target(ctx, &sp, INT_MAX, false, &nd));
    IX_TRY(fit(ctx, &r->p, &nd, &err, out));
    if (!(err <= r->tol)) {
        ix_mv_unref(ctx, *out);
        *out = NULL;
    }
    return IX_OK;
}

static ix_status try_scoped(ix_ctx *ctx, const removal *r, int k, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, try_removal(ctx, r, k, out));
}

/* Most candidates that can go: from the guess in growing steps, then halving.
 * *best is the result for good candidates, NULL for none. */
static ix_status search(ix_ctx *ctx, const removal *r, int guess, ix_mv **best)
{
    int good = 0, bad = r->ncand + 1, step = 1, k = guess;

    while (bad - good > 1) {
        ix_mv *m;

        k = k <= good ? good + 1 : k >= bad ? bad - 1 : k;
        IX_TRY(try_scoped(ctx, r, k, &m));
        if (m) {
            ix_mv_unref(ctx, *best);
            *best = m;
            good = k;
            k = bad > r->ncand ? good + step : good + (bad - good) / 2;
        } else {
            bad = k;
            k = good == 0 ? bad - step : good + (bad - good) / 2;
        }
        step *= 2;
    }
    return IX_OK;
}

/* What counts as no change at all: rounding of extraction and fit. */
static double rounding(const ix_mv *m)
{
    double size = 0, least, most, wmin = 1;

    for (int a = m->rational; a < m->naxes; a++) {
        range(m, a, &least, &most);
        size = fmax(size, most);
    }
    if (m->rational)
        range(m, 0, &wmin, &most);
    return wmin > 0 ? size / wmin : size;
}

static ix_status remove_from(ix_ctx *ctx, const ix_mv *m, int dir, double tol,
                             ix_mv **best)
{
    int order = m->dirs[dir].order, guess = 0;
    removal r = {.tol = fmax(tol, 64 * order * DBL_EPSILON * rounding(m))};
    double *buf;

    IX_TRY(cut(ctx, m, dir, &r.p));
    IX_SCRATCH(ctx, r.cand, m->dirs[dir].length);
    IX_SCRATCH(ctx, r.cont, r.p.sp.nspans);
    IX_SCRATCH(ctx, buf, 3 * order);
    for (int j = 1; j < r.p.sp.nspans; j++)
        r.ncand += add_candidates(&r.p, j, buf, r.cand + r.ncand);
    qsort(r.cand, (size_t)r.ncand, sizeof *r.cand, compare);
    while (guess < r.ncand && r.cand[guess].weight <= r.tol)
        guess++;
    return search(ctx, &r, guess, best);
}

static ix_status remove_scoped(ix_ctx *ctx, const ix_mv *m, int dir, double tol,
                               ix_mv **best)
{
    IX_RETURN_SCOPED(ctx, remove_from(ctx, m, dir, tol, best));
}

ix_status ix_mv_remove_knots(ix_ctx *ctx, const ix_mv *m, int dir, double tol,
                             ix_mv **out)
{
    ix_mv *open, *best = NULL;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (!(tol >= 0))
        return IX_FAIL(ctx, IX_EARG, "tolerance %g", tol);
    if (m->dirs[dir].basis != IX_BSPLINE) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix__mv_open_dir(ctx, m, dir, &open));
    st = remove_scoped(ctx, open, dir, tol, &best);
    ix_mv_unref(ctx, open);
    if (st != IX_OK)
        ix_mv_unref(ctx, best);
    else
        *out = best ? best : ix_mv_ref(m);
    return st;
}
