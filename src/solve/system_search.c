/* system_search.c - subdivision of one patch with preconditioning.
 *
 * A box is examined in local coordinates [0, 1]^n: discarded by signs,
 * shrunk by the preconditioned equations, proven to hold at most one solution
 * (then Newton finds it or shows that it lies elsewhere), or halved. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "solve/system_impl.h"

#define UNIT      (DBL_EPSILON / 2)
#define MAX_DEPTH 400
#define SHRUNK    0.7 /* a round that leaves more of every edge has stalled */
#define NOISE     4   /* errors that a value may have and be called noise */
#define THIN                                                                \
    1e-3 /* a box is not shrunk to less than this in one round, nor to      \
            less than this part of its longest edge: a thin box, or one as  \
            small as the rounding errors, leaves no room for the proof that \
            the solution in it is the only one */

typedef struct ix__search {
    ix__system *sys;
    ix__found *found;
    ix__box *stack; /* [MAX_DEPTH] */
    int top, made;  /* boxes of the stack that have tensors */
    double *g;      /* [n][size]: the preconditioned equations */
    double *work;   /* [2 size] */
    double *copy;   /* [n][size]: for the inflated box */
} search;

static double *tensor(const ix__system *s, const ix__box *b, int i)
{
    return b->c + (size_t)i * s->shape.size;
}

/* A de Casteljau pass of m layers commits at most 3 m roundings relative to
 * the largest coefficient. */
static void add_rounding(const ix__system *s, ix__box *b, int j)
{
    for (int i = 0; i < s->nall; i++) {
        double lo, hi;

        ix__tensor_range(&s->shape, tensor(s, b, i), &lo, &hi);
        b->err[i] += 3 * s->shape.dims[j] * UNIT * fmax(-lo, hi);
    }
}

static void shrink(const ix__system *s, ix__box *b, int j, double a, double e)
{
    double w = b->hi[j] - b->lo[j], lo = b->lo[j];

    add_rounding(s, b, j);
    for (int i = 0; i < s->nall; i++)
        ix__tensor_restrict(&s->shape, tensor(s, b, i), j, a, e);
    b->hi[j] = e < 1 ? lo + e * w : b->hi[j];
    b->lo[j] = lo + a * w;
}

/* False if the signs of some relation exclude the box. */
static bool signs_allow(const ix__system *s, const ix__box *b)
{
    for (int i = 0; i < s->nall; i++) {
        double lo, hi;

        ix__tensor_range(&s->shape, tensor(s, b, i), &lo, &hi);
        if (hi < -b->err[i] || (i < s->neq && lo > b->err[i]))
            return false;
    }
    return true;
}

static void mean_jacobian(const ix__system *s, const ix__box *b, ix__mat jac)
{
    for (int i = 0; i < s->n; i++)
        ix__tensor_mean_gradient(&s->shape, tensor(s, b, i), jac[i]);
}

/* g = m f for the first n equations; err[n] bounds its coefficients' error. */
static void combine(search *q, const ix__box *b, ix__mat m, double *err)
{
    const ix__system *s = q->sys;
    size_t size = s->shape.size;

    for (int i = 0; i < s->n; i++) {
        double *g = q->g + (size_t)i * size;

        memset(g, 0, size * sizeof *g);
        err[i] = 0;
        for (int k = 0; k < s->n; k++) {
            const double *f = tensor(s, b, k);
            double w = m[i][k], lo, hi;

            if (w == 0)
                continue;
            for (size_t t = 0; t < size; t++)
                g[t] += w * f[t];
            ix__tensor_range(&s->shape, f, &lo, &hi);
            err[i] += fabs(w) * (b->err[k] + s->n * UNIT * fmax(-lo, hi));
        }
    }
}

static double part_of_domain(const ix__system *s, const ix__box *b, int j)
{
    return (b->hi[j] - b->lo[j]) / s->edge[j];
}

/* Widens [*a, *e] within [0, 1] to at least `least`, or THIN. */
static void keep_room(double *a, double *e, double least)
{
    double c = 0.5 * (*a + *e), half = 0.5 * fmax(least, THIN);

    if (*e - *a >= 2 * half)
        return;
    *a = fmax(0, c - half);
    *e = fmin(1, c + half);
}

/* Shrinks the box by equation g_i in direction j (its own when the
 * preconditioner is the inverse, else every one). False: no solution in it. */
static bool reduce(search *q, ix__box *b, const double *err, bool diagonal,
                   bool *shrunk)
{
    const ix__system *s = q->sys;
    double a[IX_MAX_UNKNOWNS] = {0}, e[IX_MAX_UNKNOWNS], longest = 0;

    for (int j = 0; j < s->n; j++)
        e[j] = 1;
    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < s->n; j++) {
            double x, y;

            if (diagonal && i != j)
                continue;
            if (!ix__tensor_clip(&s->shape, q->g + (size_t)i * s->shape.size,
                                 err[i], j, &x, &y))
                return false;
            a[j] = fmax(a[j], x);
            e[j] = fmin(e[j], y);
        }
    for (int j = 0; j < s->n; j++) {
        if (a[j] > e[j])
            return false;
        longest = fmax(longest, (e[j] - a[j]) * part_of_domain(s, b, j));
    }
    *shrunk = false;
    for (int j = 0; j < s->n; j++) {
        keep_room(a + j, e + j, THIN * longest / part_of_domain(s, b, j));
        if (e[j] - a[j] > SHRUNK)
            continue;
        shrink(s, b, j, a[j], e[j]);
        *shrunk = true;
    }
    return true;
}

/* Bound of the rows of |I - m f'| over the box whose tensors are f[n][size]:
 * the largest row sum. Below 1, m f is one-to-one there. */
static double contraction(search *q, const double *f, ix__mat m)
{
    const ix__system *s = q->sys;
    ix__mat low, high;
    double worst = 0;

    for (int k = 0; k < s->n; k++)
        for (int j = 0; j < s->n; j++)
            ix__tensor_slope_range(&s->shape, f + (size_t)k * s->shape.size, j,
                                   &low[k][j], &high[k][j]);
    for (int i = 0; i < s->n; i++) {
        double row = 0;

        for (int j = 0; j < s->n; j++) {
            double a = i == j, c = i == j; /* range of (I - m f')_ij */

            for (int k = 0; k < s->n; k++) {
                double w = m[i][k];

                a -= w > 0 ? w * high[k][j] : w * low[k][j];
                c -= w > 0 ? w * low[k][j] : w * high[k][j];
            }
            row += fmax(fabs(a), fabs(c));
        }
        worst = fmax(worst, row);
    }
    return worst;
}

/* step = m f(x); returns the bound of its error by the coefficients' errors. */
static double newton_step(search *q, const double *f, const double *ferr,
                          ix__mat m, const double *x, double *step)
{
    const ix__system *s = q->sys;
    double v[IX_MAX_UNKNOWNS], err = 0;

    for (int k = 0; k < s->n; k++)
        v[k] = ix__tensor_value(&s->shape, f + (size_t)k * s->shape.size, x,
                                q->work);
    for (int i = 0; i < s->n; i++) {
        double e = 0;

        step[i] = 0;
        for (int k = 0; k < s->n; k++) {
            step[i] += m[i][k] * v[k];
            e += fabs(m[i][k]) * ferr[k];
        }
        err = fmax(err, e);
    }
    return err;
}

static double largest_abs(const double *v, int n)
{
    double m = 0;

    for (int i = 0; i < n; i++)
        m = fmax(m, fabs(v[i]));
    return m;
}

static void jacobian_at(search *q, const double *f, const double *x,
                        ix__mat jac)
{
    const ix__system *s = q->sys;

    for (int i = 0; i < s->n; i++)
        ix__tensor_gradient(&s->shape, f + (size_t)i * s->shape.size, x, jac[i],
                            q->work);
}

/* Newton's method; where the Jacobian is singular, or to begin with, m stands
 * for its inverse (which contracts for sure, but slowly). Returns the bound of
 * |m f(x)| at the end, rounding included. */
static double newton(search *q, const double *f, const double *ferr, ix__mat m,
                     double *x)
{
    double d[IX_MAX_UNKNOWNS], last = HUGE_VAL, err;
    int n = q->sys->n;
    ix__mat jac, inv;

    memcpy(inv, m, sizeof inv);
    for (int it = 0; it < 60; it++) {
        double size;

        if (last < 0.1) {
            jacobian_at(q, f, x, jac);
            if (!ix__small_invert(n, jac, inv))
                memcpy(inv, m, sizeof inv);
        }
        (void)newton_step(q, f, ferr, inv, x, d);
        size = largest_abs(d, n);
        if (!(size < 4) || (last < 1e-7 && !(size < 0.5 * last)))
            break;
        for (int i = 0; i < n; i++)
            x[i] -= d[i];
        last = size;
        if (size == 0)
            break;
    }
    err = newton_step(q, f, ferr, m, x, d);
    return largest_abs(d, n) + err;
}

#define MARGIN 0.125 /* by which a box is inflated on each side */

/* Tensors of the n equations on the box inflated by MARGIN. */
static void inflate(search *q, const ix__box *b, double *ferr)
{
    const ix__system *s = q->sys;
    size_t size = s->shape.size;

    memcpy(q->copy, b->c, (size_t)s->n * size * sizeof *q->copy);
    for (int k = 0; k < s->n; k++) {
        double *f = q->copy + (size_t)k * size, lo, hi, grow = 1;

        for (int j = 0; j < s->n; j++) {
            ix__tensor_restrict(&s->shape, f, j, -MARGIN, 1 + MARGIN);
            /* extrapolation enlarges errors by (1 + 2 MARGIN)^(2 degree) */
            grow *= pow(1 + 2 * MARGIN, 2.0 * (s->shape.dims[j] - 1));
        }
        ix__tensor_range(&s->shape, f, &lo, &hi);
        ferr[k] = (b->err[k] +
                   6 * s->shape.dims[0] * s->n * UNIT * fmax(-lo, hi)) *
                  grow;
    }
}

typedef enum { UNDECIDED, NONE, ONE } verdict;

/* Whether the remaining relations hold at x (or cannot be excluded). */
static bool checks_hold(search *q, const ix__box *b, const double *x)
{
    const ix__system *s = q->sys;

    for (int i = s->n; i < s->nall; i++) {
        const double *c = tensor(s, b, i);
        double v = ix__tensor_value(&s->shape, c, x, q->work), lo, hi, band;

        ix__tensor_range(&s->shape, c, &lo, &hi);
        band = b->err[i] + 1e-12 + 8 * UNIT * fmax(-lo, hi);
        if (v < -band || (i < s->neq && v > band))
            return false;
    }
    return true;
}

static ix_status report_root(search *q, const ix__box *b, const double *x,
                             double radius)
{
    const ix__system *s = q->sys;
    ix_solution r = {.certified = true};

    for (int j = 0; j < s->n; j++) {
        double w = b->hi[j] - b->lo[j];
        double pad = radius * w +
                     2 * DBL_EPSILON * (fabs(b->lo[j]) + fabs(b->hi[j]));

        r.x[j] = b->lo[j] + x[j] * w;
        r.lo[j] = r.x[j] - pad;
        r.hi[j] = r.x[j] + pad;
    }
    return ix__found_add(q->found, &r);
}

/* Whether y (local coordinates) lies in the box up to its own uncertainty and
 * the rounding of the box's ends: a solution on a face belongs to both sides.
 */
static bool in_box(const ix__system *s, const ix__box *b, double *y,
                   double radius)
{
    for (int j = 0; j < s->n; j++) {
        double ends = fmax(fabs(b->lo[j]), fabs(b->hi[j]));
        double slack = radius + 4 * UNIT * (1 + ends / (b->hi[j] - b->lo[j]));

        if (!(y[j] >= -slack && y[j] <= 1 + slack))
            return false;
        y[j] = fmin(fmax(y[j], 0), 1);
    }
    return true;
}

/* Krawczyk's test on the inflated box with preconditioner m (for its own
 * coordinates) and contraction factor lip < 1: it holds at most one solution.
 * With x -> x - m f(x) mapping the box into a ball of radius lip / 2 around
 * c - m f(c), a first step beyond (1 + lip) / 2 proves that there is none. */
static ix_status find_the_one(search *q, const ix__box *b, const double *ferr,
                              ix__mat m, double lip, verdict *v)
{
    const ix__system *s = q->sys;
    double x[IX_MAX_UNKNOWNS], step[IX_MAX_UNKNOWNS], rest, size;

    for (int i = 0; i < s->n; i++)
        x[i] = 0.5;
    rest = newton_step(q, q->copy, ferr, m, x, step);
    size = largest_abs(step, s->n);
    if (size > 0.5 * (1 + lip) + rest) {
        *v = NONE;
        return IX_OK;
    }
    rest = newton(q, q->copy, ferr, m, x) / (1 - lip);
    for (int i = 0; i < s->n; i++) {
        if (!(x[i] - rest > 0 && x[i] + rest < 1))
            return IX_OK;
        x[i] = x[i] * (1 + 2 * MARGIN) - MARGIN;
    }
    *v = NONE;
    rest *= 1 + 2 * MARGIN;
    if (!in_box(s, b, x, rest) || !checks_hold(q, b, x))
        return IX_OK;
    *v = ONE;
    return report_root(q, b, x, rest);
}

/* One solution at most in the inflated box? Then find it. inv: the inverse of
 * the mean Jacobian. */
static ix_status unique(search *q, const ix__box *b, ix__mat inv, verdict *v)
{
    const ix__system *s = q->sys;
    double ferr[IX_MAX_UNKNOWNS], lip;
    ix__mat m;

    if (!(contraction(q, b->c, inv) < 0.9))
        return IX_OK;
    memcpy(m, inv, sizeof m);
    inflate(q, b, ferr);
    for (int i = 0; i < s->n; i++)
        for (int k = 0; k < s->n; k++)
            m[i][k] /= 1 + 2 * MARGIN; /* for the inflated box's coordinates */
    lip = contraction(q, q->copy, m);
    return lip < 0.9 ? find_the_one(q, b, ferr, m, lip, v) : IX_OK;
}

static int longest_edge(const ix__system *s, const ix__box *b, double *len)
{
    int best = 0;

    *len = 0;
    for (int j = 0; j < s->n; j++) {
        double w = (b->hi[j] - b->lo[j]) / s->edge[j];

        if (w > *len) {
            *len = w;
            best = j;
        }
    }
    return best;
}

static ix_status report_open(search *q, const ix__box *b)
{
    const ix__system *s = q->sys;
    ix_solution r = {.certified = false};

    for (int j = 0; j < s->n; j++) {
        r.lo[j] = b->lo[j];
        r.hi[j] = b->hi[j];
        r.x[j] = 0.5 * (b->lo[j] + b->hi[j]);
    }
    return ix__found_add(q->found, &r);
}

/* Whether some combination of the equations is, on all of the box, as small
 * as its own error: then smaller boxes will not decide more. */
static bool below_noise(const search *q, const double *err)
{
    const ix__system *s = q->sys;

    for (int i = 0; i < s->n; i++) {
        double lo, hi;

        ix__tensor_range(&s->shape, q->g + (size_t)i * s->shape.size, &lo, &hi);
        if (fmax(-lo, hi) <= NOISE * err[i])
            return true;
    }
    return false;
}

static ix_status push_halves(search *q)
{
    const ix__system *s = q->sys;
    ix__box *b = &q->stack[q->top], *c = b + 1;
    size_t n = (size_t)s->nall * s->shape.size;
    double len, *keep;
    int j = longest_edge(s, b, &len);

    if (len <= s->cell || q->top + 1 >= MAX_DEPTH) {
        q->top--;
        return report_open(q, b);
    }
    if (q->top + 1 == q->made) {
        IX_SCRATCH(s->ctx, c->c, n);
        q->made++;
    }
    keep = c->c;
    *c = *b;
    c->c = keep;
    memcpy(c->c, b->c, n * sizeof *keep);
    shrink(s, b, j, 0.5, 1);
    shrink(s, c, j, 0, 0.5);
    q->top++;
    return IX_OK;
}

/* Rounds of preconditioning and shrinking on the top box, then a decision. */
static ix_status examine(search *q)
{
    ix__box *b = &q->stack[q->top];
    const ix__system *s = q->sys;
    double err[IX_MAX_UNKNOWNS];

    for (int round = 0; round < 20; round++) {
        ix__mat jac, m;
        bool regular, shrunk;
        verdict v;

        q->sys->boxes++;
        if (!signs_allow(s, b)) {
            q->top--;
            return IX_OK;
        }
        mean_jacobian(s, b, jac);
        regular = ix__small_invert(s->n, jac, m);
        v = UNDECIDED;
        if (regular)
            IX_TRY(unique(q, b, m, &v));
        if (v != UNDECIDED) {
            q->top--;
            return IX_OK;
        }
        if (!regular)
            ix__small_left_vectors(s->n, jac, m);
        combine(q, b, m, err);
        if (!reduce(q, b, err, regular, &shrunk)) {
            q->top--;
            return IX_OK;
        }
        if (!shrunk)
            break;
    }
    if (below_noise(q, err)) {
        q->top--;
        return report_open(q, b);
    }
    return push_halves(q);
}

static ix_status make_search(ix__system *sys)
{
    size_t size = sys->shape.size;
    search *q;

    IX_SCRATCH_ZERO(sys->ctx, q, 1);
    IX_SCRATCH(sys->ctx, q->stack, MAX_DEPTH);
    IX_SCRATCH(sys->ctx, q->stack[0].c, (size_t)sys->nall * size);
    q->made = 1;
    IX_SCRATCH(sys->ctx, q->g, (size_t)sys->n * size);
    IX_SCRATCH(sys->ctx, q->copy, (size_t)sys->n * size);
    IX_SCRATCH(sys->ctx, q->work, 2 * size);
    q->sys = sys;
    sys->search = q;
    return IX_OK;
}

ix_status ix__system_search(ix__system *sys, const ix__box *b, ix__found *found)
{
    search *q;
    double *c;

    if (!sys->search)
        IX_TRY(make_search(sys));
    q = sys->search;
    q->found = found;
    q->top = 0;
    c = q->stack[0].c;
    memcpy(c, b->c, (size_t)sys->nall * sys->shape.size * sizeof *c);
    q->stack[0] = *b;
    q->stack[0].c = c;
    while (q->top >= 0) {
        if (sys->boxes >= sys->max_boxes) {
            for (; q->top >= 0; q->top--)
                IX_TRY(report_open(q, &q->stack[q->top]));
            break;
        }
        IX_TRY(examine(q));
        IX_TRY(ix__poll(sys->ctx));
    }
    return IX_OK;
}
