/* system_search.c - subdivision of one patch with preconditioning.
 *
 * A box is examined in local coordinates [0, 1]^n: discarded by signs,
 * shrunk by the preconditioned equations, proven to hold at most one solution
 * (then Newton finds it or shows that it lies elsewhere), or halved. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "solve/common.h"
#include "solve/contract.h"
#include "solve/system_impl.h"

#define UNIT   (DBL_EPSILON / 2)
#define SHRUNK 0.7 /* a round that leaves more of every edge has stalled */
#define NOISE  4   /* errors that a value may have and be called noise */
#define THIN                                                                \
    1e-3 /* a box is not shrunk to less than this in one round, nor to      \
            less than this part of its longest edge: a thin box, or one as  \
            small as the rounding errors, leaves no room for the proof that \
            the solution in it is the only one */

typedef struct ix__search {
    ix__system *sys;
    const ix__box *patch;
    ix__found *found;
    ix__stack stack;
    ix__combined g[IX_MAX_UNKNOWNS]; /* the preconditioned equations */
    ix__combined second;             /* the weakest one, improved */
    double *work;                    /* [2 size] of second's shape */
    double *copy;                    /* [n][size]: for the inflated box */
    double margin;                   /* see margin_for */
    size_t stalled; /* boxes that could only be halved although small */
} search;

static double *tensor(const ix__system *s, const ix__box *b, int i)
{
    return b->c + (size_t)i * s->t.shape.size;
}

static void mean_jacobian(const ix__system *s, const ix__box *b, ix__mat jac)
{
    for (int i = 0; i < s->n; i++)
        ix__tensor_mean_gradient(&s->t.shape, tensor(s, b, i), jac[i]);
}

/* g = m f for the first n equations: n products and sums for each. */
static void combine(search *q, const ix__box *b, ix__mat m)
{
    const ix__system *s = q->sys;
    size_t size = s->t.shape.size;

    for (int i = 0; i < s->n; i++) {
        ix__combined *g = &q->g[i];

        g->shape = s->t.shape;
        memset(g->c, 0, size * sizeof *g->c);
        g->err = g->mag = 0;
        for (int k = 0; k < s->n; k++) {
            const double *f = tensor(s, b, k);
            double w = m[i][k];

            if (w == 0)
                continue;
            for (size_t t = 0; t < size; t++)
                g->c[t] += w * f[t];
            g->err += fabs(w) * (b->err[k] + (s->n + 2) * UNIT * b->mag[k]);
            g->mag += fabs(w) * b->mag[k];
        }
    }
}

/* Widens [*a, *e] within [0, 1] to at least `least`, or THIN. */
static void keep_room(double *a, double *e, double least)
{
    double c = 0.5 * (*a + *e), half = 0.5 * ix__larger(least, THIN);

    if (*e - *a >= 2 * half)
        return;
    *a = ix__larger(0, c - half);
    *e = ix__smaller(1, c + half);
}

/* Cuts the part [a, e] of the box that is left, where that is worth it. */
static void cut_down(const ix__system *s, ix__box *b, double *a, double *e,
                     bool *shrunk)
{
    double longest = 0;

    for (int j = 0; j < s->n; j++)
        longest = ix__larger(longest,
                             (e[j] - a[j]) * ix__box_part(&s->t, b, j));
    *shrunk = false;
    for (int j = 0; j < s->n; j++) {
        keep_room(a + j, e + j, THIN * longest / ix__box_part(&s->t, b, j));
        if (e[j] - a[j] > SHRUNK)
            continue;
        ix__box_cut(&s->t, b, j, a[j], e[j]);
        *shrunk = true;
    }
}

/* Shrinks the box by equation g_i in direction j (its own when the
 * preconditioner is the inverse, else every one). False: no solution in it. */
static bool reduce(search *q, ix__box *b, int ng, const ix__combined *g,
                   bool diagonal, bool *shrunk)
{
    const ix__system *s = q->sys;
    double a[IX_MAX_UNKNOWNS] = {0}, e[IX_MAX_UNKNOWNS];

    for (int j = 0; j < s->n; j++)
        e[j] = 1;
    for (int i = 0; i < ng; i++)
        for (int j = 0; j < s->n; j++) {
            double x, y;

            if (diagonal && i != j)
                continue;
            if (!ix__tensor_clip(&g[i].shape, g[i].c, g[i].err, j, &x, &y))
                return false;
            a[j] = ix__larger(a[j], x);
            e[j] = ix__smaller(e[j], y);
        }
    for (int j = 0; j < s->n; j++)
        if (a[j] > e[j])
            return false;
    cut_down(s, b, a, e, shrunk);
    return true;
}

static double contraction(const search *q, const double *f, const double *err,
                          const double *mag, ix__mat m, ix__mat d)
{
    static const int dir[IX_MAX_UNKNOWNS] = {0, 1, 2, 3, 4, 5};

    return ix__contraction(&q->sys->t.shape, q->sys->n, dir, f, err, mag, m, d);
}

/* step = m v. */
static void times(int n, ix__mat m, const double *v, double *step)
{
    for (int i = 0; i < n; i++) {
        step[i] = 0;
        for (int k = 0; k < n; k++)
            step[i] += m[i][k] * v[k];
    }
}

static void values_at(search *q, const double *f, const double *x, double *v)
{
    const ix__system *s = q->sys;

    for (int i = 0; i < s->n; i++)
        v[i] = ix__tensor_value(&s->t.shape, f + (size_t)i * s->t.shape.size, x,
                                q->work);
}

/* step = m f(x), err the bounds of its errors by those of the values (ferr,
 * evaluation included) and the roundings of the n products. */
static void newton_step(search *q, const double *f, const double *ferr,
                        ix__mat m, const double *x, double *step, double *err)
{
    const ix__system *s = q->sys;
    double v[IX_MAX_UNKNOWNS] = {0};

    values_at(q, f, x, v);
    times(s->n, m, v, step);
    for (int i = 0; i < s->n; i++) {
        err[i] = 0;
        for (int k = 0; k < s->n; k++)
            err[i] += fabs(m[i][k]) *
                      (ferr[k] + (s->n + 1) * UNIT * fabs(v[k]));
    }
}

static double largest_abs(const double *v, int n)
{
    double m = 0;

    for (int i = 0; i < n; i++)
        m = ix__larger(m, fabs(v[i]));
    return m;
}

static void jacobian_at(search *q, const double *f, const double *x, double *v,
                        ix__mat jac)
{
    const ix__system *s = q->sys;

    for (int i = 0; i < s->n; i++)
        v[i] = ix__tensor_gradient(&s->t.shape, f + (size_t)i * s->t.shape.size,
                                   x, jac[i], q->work);
}

#define SETTLED                                                                \
    0x1p-32 /* of the box: the next step of Newton's method is as small as the \
               square of that */

/* Newton's method from x, to which a step of size last has led; where the
 * Jacobian is singular, or to begin with, m stands for its inverse (which
 * contracts for sure, but slowly). */
static void newton(search *q, const double *f, ix__mat m, double last,
                   double *x)
{
    double v[IX_MAX_UNKNOWNS] = {0}, d[IX_MAX_UNKNOWNS];
    int n = q->sys->n;

    for (int it = 0; it < 60; it++) {
        ix__mat jac, inv;
        bool own = false;
        double size;

        if (last < 0.1) {
            jacobian_at(q, f, x, v, jac);
            own = ix__small_invert(n, jac, inv);
        } else {
            values_at(q, f, x, v);
        }
        times(n, own ? inv : m, v, d);
        size = largest_abs(d, n);
        if (!(size < 4) || (last < 1e-7 && !(size < 0.5 * last)))
            break;
        for (int i = 0; i < n; i++)
            x[i] -= d[i];
        last = size;
        if (size <= (own ? SETTLED : UNIT))
            break;
    }
}

/* By which a box is inflated on each side: 1/8, less for high degrees, as the
 * bound of what extrapolation makes of errors grows exponentially with margin
 * times degree. */
static double margin_for(const ix__shape *s)
{
    int degrees = 0;

    for (int j = 0; j < s->n; j++)
        degrees += s->dims[j] - 1;
    return 1.0 / (degrees > 8 ? degrees : 8);
}

/* Tensors of the n equations on the box inflated by the margin, their errors
 * and sizes. Two passes of dims - 1 layers in each direction extrapolate, which
 * multiplies errors by (1 + 2 margin)^degree at most in each of them; 5
 * roundings for each degree are for the evaluation at a point. */
static void inflate(search *q, const ix__box *b, double *ferr, double *mag)
{
    const ix__shape *s = &q->sys->t.shape;
    double grow = 1, layers = 0;

    for (int j = 0; j < s->n; j++) {
        for (int d = 1; d < s->dims[j]; d++)
            grow *= (1 + 2 * q->margin) * (1 + 2 * q->margin);
        layers += (2 * 3 + 5) * (s->dims[j] - 1);
    }
    memcpy(q->copy, b->c, (size_t)s->n * s->size * sizeof *q->copy);
    for (int k = 0; k < s->n; k++) {
        double *f = q->copy + (size_t)k * s->size;

        for (int j = 0; j < s->n; j++)
            ix__tensor_restrict(s, f, j, -q->margin, 1 + q->margin);
        mag[k] = ix__larger(ix__tensor_size(s, f), b->mag[k]);
        ferr[k] = (b->err[k] + layers * UNIT * mag[k]) * grow;
    }
}

typedef enum { UNDECIDED, NONE, ONE } verdict;

/* Whether the remaining relations hold at x, known to within radius (or cannot
 * be excluded). 1e-12 of its size is what an equation counts as met with. */
static bool checks_hold(search *q, const ix__box *b, const double *x,
                        const double *radius)
{
    const ix__system *s = q->sys;

    for (int i = s->n; i < s->t.nall; i++) {
        double v = ix__tensor_value(&s->t.shape, tensor(s, b, i), x, q->work);
        double band = b->err[i] + 1e-12;

        for (int j = 0; j < s->n; j++)
            band += 2 * (s->t.shape.dims[j] - 1) * (radius[j] + 2 * UNIT) *
                    b->mag[i];
        if (v < -band || (i < s->t.neq && v > band))
            return false;
    }
    return true;
}

static ix_status report_root(search *q, const ix__box *b, const double *x,
                             const double *radius)
{
    const ix__system *s = q->sys;
    ix_solution r = {.certified = true};

    for (int j = 0; j < s->n; j++) {
        double w = b->hi[j] - b->lo[j];
        double pad = radius[j] * w + ix__box_drift(&s->t, b, j);

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
                   const double *radius)
{
    for (int j = 0; j < s->n; j++) {
        double ends = ix__larger(fabs(b->lo[j]), fabs(b->hi[j]));
        double slack = radius[j] +
                       4 * UNIT * (1 + ends / (b->hi[j] - b->lo[j]));

        if (!(y[j] >= -slack && y[j] <= 1 + slack))
            return false;
        y[j] = ix__smaller(ix__larger(y[j], 0), 1);
    }
    return true;
}

/* The error of each coordinate is at most rest + d error, d[n][n] bounding
 * |I - m J|; it begins with the ball that all have in common. */
static void enclose(int n, const double *rest, ix__mat d, double ball,
                    double *radius)
{
    for (int i = 0; i < n; i++)
        radius[i] = ball;
    for (int round = 0; round < 3; round++)
        for (int i = 0; i < n; i++) {
            double e = rest[i];

            for (int j = 0; j < n; j++)
                e += d[i][j] * radius[j];
            radius[i] = ix__smaller(radius[i],
                                    e * (1 + 2 * IX_MAX_UNKNOWNS * UNIT));
        }
}

/* rest[n] bounds |m f(x)|, rounding included, x and m being in the inflated
 * box's coordinates, by the box itself, whose coefficients have not been
 * extrapolated: outside by o, a value's error grows by (1 + 2 o) for each
 * degree. */
static void rest_at(search *q, const ix__box *b, ix__mat m, const double *x,
                    double *rest)
{
    const ix__system *s = q->sys;
    double y[IX_MAX_UNKNOWNS], d[IX_MAX_UNKNOWNS], e[IX_MAX_UNKNOWNS];
    double ferr[IX_MAX_UNKNOWNS], layers = 0, grow = 1;

    for (int j = 0; j < s->n; j++) {
        y[j] = x[j] * (1 + 2 * q->margin) - q->margin;
        for (int k = 1; k < s->t.shape.dims[j]; k++)
            grow *= 1 + 2 * ix__larger(0, ix__larger(-y[j], y[j] - 1));
        layers += 3 * (s->t.shape.dims[j] - 1);
    }
    for (int k = 0; k < s->n; k++) /* y is rounded: a slope times 2 u */
        ferr[k] = (b->err[k] + 3 * layers * UNIT * b->mag[k]) * grow;
    newton_step(q, b->c, ferr, m, y, d, e);
    for (int i = 0; i < s->n; i++)
        rest[i] = fabs(d[i]) + e[i];
}

#define SLACK 0.3     /* contraction above which enclosures are sharpened */
#define NEAR  0x1p-20 /* half an edge of the box that sharpen looks at */

/* radius from the inverse of the Jacobian at x, which is better there than m,
 * and the derivatives close to x. Uses up the tensors of the inflated box. */
static void sharpen(search *q, const ix__box *b, double *ferr, double *mag,
                    const double *x, double ball, double *radius)
{
    const ix__system *s = q->sys;
    double rest[IX_MAX_UNKNOWNS], better[IX_MAX_UNKNOWNS], layers = 0;
    double v[IX_MAX_UNKNOWNS];
    ix__mat jac, m, d;

    jacobian_at(q, q->copy, x, v, jac);
    if (!(ball < NEAR) || !ix__small_invert(s->n, jac, m))
        return;
    rest_at(q, b, m, x, rest);
    for (int j = 0; j < s->n; j++) {
        layers += 2 * 3 * (s->t.shape.dims[j] - 1);
        for (int k = 0; k < s->n; k++)
            ix__tensor_restrict(&s->t.shape,
                                q->copy + (size_t)k * s->t.shape.size, j,
                                x[j] - NEAR, x[j] + NEAR);
    }
    for (int k = 0; k < s->n; k++) {
        ferr[k] += layers * UNIT * mag[k];
        for (int i = 0; i < s->n; i++)
            m[i][k] /= 2 * NEAR;
    }
    (void)contraction(q, q->copy, ferr, mag, m, d);
    enclose(s->n, rest, d, ball, better);
    for (int i = 0; i < s->n; i++)
        radius[i] = ix__smaller(radius[i], better[i]);
}

/* Krawczyk's test on the inflated box with preconditioner m (for its own
 * coordinates), bounds d and contraction factor lip < 1: it holds at most one
 * solution. With x -> x - m f(x) mapping the box into a ball of radius lip / 2
 * around c - m f(c), a first step beyond (1 + lip) / 2 proves that there is
 * none. */
static ix_status find_the_one(search *q, const ix__box *b, double *ferr,
                              double *mag, ix__mat m, ix__mat d, double lip,
                              verdict *v)
{
    const ix__system *s = q->sys;
    double x[IX_MAX_UNKNOWNS], step[IX_MAX_UNKNOWNS], e[IX_MAX_UNKNOWNS];
    double radius[IX_MAX_UNKNOWNS], ball;
    int n = s->n;

    for (int i = 0; i < n; i++)
        x[i] = 0.5;
    newton_step(q, q->copy, ferr, m, x, step, e);
    if (largest_abs(step, n) > 0.5 * (1 + lip) + largest_abs(e, n)) {
        *v = NONE;
        return IX_OK;
    }
    for (int i = 0; i < n; i++)
        x[i] -= step[i];
    newton(q, q->copy, m, largest_abs(step, n), x);
    rest_at(q, b, m, x, e);
    ball = largest_abs(e, n) / (1 - lip);
    if (!(ball < q->margin / 4)) /* could not be told from a neighbour's */
        return IX_OK;
    for (int i = 0; i < n; i++)
        if (!(x[i] - ball > 0 && x[i] + ball < 1))
            return IX_OK;
    enclose(n, e, d, ball, radius);
    if (lip > SLACK)
        sharpen(q, b, ferr, mag, x, ball, radius);
    for (int i = 0; i < n; i++) {
        x[i] = x[i] * (1 + 2 * q->margin) - q->margin;
        radius[i] = radius[i] * (1 + 2 * q->margin) + 2 * UNIT;
    }
    *v = NONE;
    if (!in_box(s, b, x, radius) || !checks_hold(q, b, x, radius))
        return IX_OK;
    *v = ONE;
    return report_root(q, b, x, radius);
}

/* One solution at most in the inflated box? Then find it. inv: the inverse of
 * the mean Jacobian. */
static ix_status unique(search *q, const ix__box *b, ix__mat inv, verdict *v)
{
    const ix__system *s = q->sys;
    double ferr[IX_MAX_UNKNOWNS], mag[IX_MAX_UNKNOWNS], lip;
    ix__mat m, d;

    if (!(contraction(q, b->c, b->err, b->mag, inv, d) < 0.9))
        return IX_OK;
    memcpy(m, inv, sizeof m);
    inflate(q, b, ferr, mag);
    for (int i = 0; i < s->n; i++)
        for (int k = 0; k < s->n; k++)
            m[i][k] /= 1 +
                       2 * q->margin; /* for the inflated box's coordinates */
    lip = contraction(q, q->copy, ferr, mag, m, d);
    return lip < 0.9 ? find_the_one(q, b, ferr, mag, m, d, lip, v) : IX_OK;
}

/* Whether a combination of the equations is, on all of the box, as small as
 * its own error: then smaller boxes will not decide more. */
static bool below_noise(int ng, const ix__combined *g)
{
    for (int i = 0; i < ng; i++) {
        double lo, hi;

        ix__tensor_range(&g[i].shape, g[i].c, &lo, &hi);
        if (ix__larger(-lo, hi) <= NOISE * g[i].err)
            return true;
    }
    return false;
}

/* The row of the shortest of n gradients. */
static int weakest(int n, ix__mat grad)
{
    double least = HUGE_VAL;
    int best = 0;

    for (int i = 0; i < n; i++) {
        double sum = 0;

        for (int j = 0; j < n; j++)
            sum += grad[i][j] * grad[i][j];
        if (sum < least) {
            least = sum;
            best = i;
        }
    }
    return best;
}

/* Sums become tensors: a sum times a linear function is none. */
static void expand(search *q)
{
    const ix__shape *s = &q->sys->t.shape;

    for (int i = 0; s->sum && i < s->n; i++) {
        memcpy(q->work, q->g[i].c, s->size * sizeof *q->work);
        ix__tensor_expand(s, q->work, q->g[i].c);
        q->g[i].err += s->n * UNIT * q->g[i].mag;
        ix__shape_init(&q->g[i].shape, s->n, s->dims);
    }
}

/* The system near a singular point: the equations rotated until their mean
 * gradients are orthogonal, and the weakest freed of second-order terms. */
static void resolve(search *q, const ix__box *b, ix__mat jac)
{
    const ix__system *s = q->sys;
    ix__mat u, grad;

    ix__small_left_vectors(s->n, jac, u);
    combine(q, b, u);
    expand(q);
    for (int i = 0; i < s->n; i++)
        ix__tensor_mean_gradient(&q->g[i].shape, q->g[i].c, grad[i]);
    ix__second_order(s->n, q->g, weakest(s->n, grad), grad, q->work,
                     &q->second);
}

/* What one round leaves of the box. */
typedef enum { GONE, SMALLER, STALLED, NOISY } outcome;

/* Where the preconditioned equations do not shrink the box. */
static outcome look_closer(search *q, ix__box *b, ix__mat jac)
{
    bool shrunk;

    resolve(q, b, jac);
    if (!reduce(q, b, 1, &q->second, false, &shrunk))
        return GONE;
    if (shrunk)
        return SMALLER;
    return below_noise(1, &q->second) ? NOISY : STALLED;
}

#define CLOSE 0x1p-5 /* boxes smaller than this are worth a closer look */

static ix_status shrink_round(search *q, ix__box *b, outcome *out)
{
    ix__system *s = q->sys;
    verdict v = UNDECIDED;
    bool regular, shrunk;
    ix__mat jac, m;
    double len;

    *out = GONE;
    s->t.boxes++;
    ix__box_refresh(&s->t, q->patch, b);
    if (!ix__box_signs_allow(&s->t, b))
        return IX_OK;
    mean_jacobian(s, b, jac);
    regular = ix__small_invert(s->n, jac, m);
    if (regular)
        IX_TRY(unique(q, b, m, &v));
    if (v != UNDECIDED)
        return IX_OK;
    if (!regular)
        ix__small_left_vectors(s->n, jac, m);
    combine(q, b, m);
    if (!reduce(q, b, s->n, q->g, regular, &shrunk))
        return IX_OK;
    *out = shrunk ? SMALLER : STALLED;
    if (!shrunk && below_noise(s->n, q->g))
        *out = NOISY;
    (void)ix__box_longest(&s->t, b, &len);
    if (*out == STALLED && len < CLOSE && s->n > 1)
        *out = look_closer(q, b, jac);
    return IX_OK;
}

#define SMALL  0x1p-6 /* of the domain: such boxes should shrink or vanish */
#define COARSE 0x1p-4 /* fine enough for a curve that the equations share */

/* Whether halving b is useless, as it is one of the boxes that cover a curve
 * which all equations share. It is looked for when 4, 8, 16, ... small boxes
 * have stalled. */
static bool on_common_curve(search *q, const ix__box *b, double len)
{
    ix__task *t = &q->sys->t;
    const ix__box *p = q->patch;
    double x[IX_MAX_UNKNOWNS];

    if (len > COARSE || q->sys->n < 2)
        return false;
    for (int j = 0; j < q->sys->n; j++)
        x[j] = (0.5 * (b->lo[j] + b->hi[j]) - p->lo[j]) / (p->hi[j] - p->lo[j]);
    if (!t->crowded && len < SMALL && ++q->stalled >= 4 &&
        (q->stalled & (q->stalled - 1)) == 0)
        t->crowded = ix__common_curve(&t->shape, p->c, x, q->work);
    if (!t->crowded || !ix__common_point(&t->shape, p->c, x, q->work))
        return false;
    for (int j = 0; j < q->sys->n; j++) {
        double w = p->hi[j] - p->lo[j], at = p->lo[j] + x[j] * w;

        if (!(at >= b->lo[j] - len * w && at <= b->hi[j] + len * w))
            return false;
    }
    return true;
}

#define MAX_ROUNDS 20

/* Rounds of preconditioning and shrinking on the top box, then a decision. */
static ix_status examine(void *self)
{
    search *q = self;
    ix__box *b = &q->stack.box[q->stack.top];
    ix__task *t = &q->sys->t;
    outcome out = SMALLER;
    double len;
    int j;

    for (int round = 0; out == SMALLER && round < MAX_ROUNDS; round++)
        IX_TRY(shrink_round(q, b, &out));
    if (out == GONE) {
        q->stack.top--;
        return IX_OK;
    }
    j = ix__box_longest(t, b, &len);
    if (out == NOISY || len <= t->cell || q->stack.top + 1 >= IX__MAX_DEPTH ||
        on_common_curve(q, b, len)) {
        q->stack.top--;
        return ix__open_box(t, b, q->found);
    }
    return ix__stack_halve(t, &q->stack, j, 0.5);
}

static ix_status make_search(ix__system *sys)
{
    size_t size = sys->t.shape.size, more = 1;
    search *q;

    for (int j = 0; j < sys->n; j++)
        more *= (size_t)sys->t.shape.dims[j] + 1;
    IX_SCRATCH_ZERO(sys->t.ctx, q, 1);
    IX_TRY(ix__stack_make(&sys->t, &q->stack));
    for (int i = 0; i < sys->n; i++)
        IX_SCRATCH(sys->t.ctx, q->g[i].c, sys->t.shape.sum ? more : size);
    IX_SCRATCH(sys->t.ctx, q->copy, (size_t)sys->n * size);
    IX_SCRATCH(sys->t.ctx, q->second.c, more);
    IX_SCRATCH(sys->t.ctx, q->work, 2 * more);
    q->sys = sys;
    q->margin = margin_for(&sys->t.shape);
    sys->search = q;
    return IX_OK;
}

ix_status ix__system_search(ix__system *sys, const ix__box *b, ix__found *found)
{
    search *q;

    if (!sys->search)
        IX_TRY(make_search(sys));
    q = sys->search;
    q->found = found;
    q->patch = b;
    ix__stack_start(&sys->t, &q->stack, b);
    return ix__stack_run(&sys->t, &q->stack, examine, q, found);
}
