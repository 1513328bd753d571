/* plane_touch.c - the largest circle through a point that holds nothing of a
 * set, and the distance from a set.
 *
 * Both are the largest value of a quotient b / a, a >= 0, over all spans: a =
 * |P - c w|^2 and b = 2 n.(P - c w) w, or b = w^2. A value k is the largest
 * when g = k a - b is nowhere negative. A span is halved until g has no
 * negative Bernstein coefficient, or is convex: then its least value gives the
 * next k (Dinkelbach 1967, quadratic convergence). The control points are
 * halved, not a and b: near c their rounding is that of a difference of
 * coordinates, not that of its square. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "ops/plane.h"

/* Spans are halved no more often: 2^-44 of a span is below the rounding of a
 * coordinate. */
enum { MAX_HALVINGS = 44 };
/* A step at least doubles a k that is far too small. */
enum { MAX_STEPS = 100 };
/* Parts that are larger than this many radii are not searched: g would carry
 * more rounding than the depth that is looked for. */
#define MAX_RADII 16.0
#define ROUNDING  1e-15
/* What the search for a distance may begin with is as much less, squared, than
 * that of a point that was seen. */
#define SEEN_LESS 1e-9

typedef struct {
    const ix__span *sp;
    int d, span; /* degree and index of the span */
    double c[2], n[2];
    bool distance; /* b = w^2 */
    bool any;      /* one better value is enough */
    double tol;    /* of g, relative to the weight squared */
    double limit;  /* of g on this part */
    double k;
    int found; /* span of the best value, -1: none */
    double u;
    int known; /* span of a place where g is about 0 and stationary, -1: none */
    double known_u;
    const double *bin, *bin2;  /* binomials of d and 2 d */
    double *a, *b, *g, *t, *q; /* [2 d + 1]; q is [4][d + 1] */
    double *room;              /* [3][d + 1] for each depth */
} search;

static bool done(const search *s)
{
    return s->any && s->found >= 0;
}

/* --- polynomials -----------------------------------------------------------
 */

/* sum c_i B_i at v. */
static double value(int n, const double *c, double v)
{
    double room[2 * IX_MAX_ORDER], w = 1.0 - v, p = 1.0, s;
    const double *bin = ix__binom(n, room);

    if (v > 0.5) { /* from the other end */
        s = c[n];
        for (int i = 1; i <= n; i++) {
            p *= w;
            s = s * v + bin[i] * p * c[n - i];
        }
        return s;
    }
    s = c[0];
    for (int i = 1; i <= n; i++) {
        p *= v;
        s = s * w + bin[i] * p * c[i];
    }
    return s;
}

/* out += factor f h, all scaled by binomials. */
static void mul_add(int d, double factor, const double *f, const double *h,
                    double *out)
{
    for (int i = 0; i <= d; i++)
        for (int j = 0; j <= d; j++)
            out[i + j] += factor * f[i] * h[j];
}

/* The left half into left, the right half in place. */
static void halve(int n, double *c, double *left)
{
    for (int j = 0; j <= n; j++) {
        left[j] = c[0];
        for (int i = 0; i < n - j; i++)
            c[i] = 0.5 * (c[i] + c[i + 1]);
    }
}

/* --- boxes -----------------------------------------------------------------
 */

/* False if the box, as seen from c, is outside the circle or half plane of the
 * present k. */
static bool box_in_reach(const search *s, const double lo[2],
                         const double hi[2])
{
    double d2 = 0.0, far = 0.0, k = s->k;

    for (int i = 0; i < 2; i++) {
        double n = s->distance ? 0.0 : s->n[i], gap;

        far += n * (n > 0.0 ? hi[i] : lo[i]);
        if (s->distance)
            gap = fmax(lo[i], -hi[i]);
        else
            gap = fmax(k * lo[i] - n, n - k * hi[i]);
        gap = fmax(gap, 0.0);
        d2 += gap * gap;
    }
    if (s->distance)
        return k * d2 <= 1.0 + 1e-12;
    return far > 0.0 && d2 <= 1.0 + 1e-12;
}

/* The same for the part with control points p. */
static bool part_in_reach(const search *s, const double *p)
{
    double lo[2], hi[2];
    int d = s->d;

    if (!s->sp->boxed)
        return true;
    for (int k = 0; k < 2; k++) {
        const double *x = p + (k + 1) * (d + 1);

        lo[k] = hi[k] = x[0] / p[0];
        for (int i = 1; i <= d; i++) {
            double v = x[i] / p[i];

            lo[k] = v < lo[k] ? v : lo[k];
            hi[k] = v > hi[k] ? v : hi[k];
        }
    }
    return box_in_reach(s, lo, hi);
}

/* --- one part of a span ----------------------------------------------------
 */

/* a and b of the part with control points p[3][d + 1] of w, x - c w. */
static void load(search *s, const double *p)
{
    int d = s->d, n = 2 * d;
    double *w = s->q, *x = w + d + 1, *y = x + d + 1, *h = y + d + 1;

    for (int i = 0; i <= d; i++) {
        w[i] = s->bin[i] * p[i];
        x[i] = s->bin[i] * p[d + 1 + i];
        y[i] = s->bin[i] * p[2 * (d + 1) + i];
        h[i] = s->n[0] * x[i] + s->n[1] * y[i];
    }
    memset(s->a, 0, (size_t)(n + 1) * sizeof(double));
    memset(s->b, 0, (size_t)(n + 1) * sizeof(double));
    mul_add(d, 1.0, x, x, s->a);
    mul_add(d, 1.0, y, y, s->a);
    mul_add(d, s->distance ? 1.0 : 2.0, s->distance ? w : h, w, s->b);
    for (int i = 0; i <= n; i++) {
        s->a[i] /= s->bin2[i];
        s->b[i] /= s->bin2[i];
    }
}

/* Size of the part in radii of k. */
static double radii(const search *s, const double *p, double value_k)
{
    double big = 0.0;

    for (int i = s->d + 1; i < 3 * (s->d + 1); i++)
        big = fmax(big, fabs(p[i]));
    return (s->distance ? sqrt(value_k) : value_k) * big / s->sp->weight;
}

static double fill(search *s)
{
    double low = (double)INFINITY;

    for (int i = 0; i <= 2 * s->d; i++) {
        s->g[i] = s->k * s->a[i] - s->b[i];
        low = fmin(low, s->g[i]);
    }
    return low;
}

/* Can nothing better be on this part? */
static bool hopeless(search *s, double size)
{
    double weight = s->sp->weight;

    return fill(s) >=
           (size > MAX_RADII ? ROUNDING * size * weight * weight : -s->limit);
}

static void offer(search *s, double a, double b, double u)
{
    if (!(s->k * a - b < -s->limit))
        return;
    s->k = a > 0 ? b / a : (double)INFINITY;
    s->found = s->span;
    s->u = u;
}

static bool convex(const search *s)
{
    for (int i = 1; i < 2 * s->d; i++)
        if (!(s->g[i + 1] - s->g[i] >= s->g[i] - s->g[i - 1]))
            return false;
    return true;
}

/* First and second derivative of g at v. */
static void slopes(const search *s, double v, double *d1, double *d2)
{
    int n = 2 * s->d;

    for (int i = 0; i < n; i++)
        s->t[i] = n * (s->g[i + 1] - s->g[i]);
    *d1 = value(n - 1, s->t, v);
    for (int i = 0; i + 1 < n; i++)
        s->t[i] = (n - 1) * (s->t[i + 1] - s->t[i]);
    *d2 = value(n - 2, s->t, v);
}

/* Where the convex g is least; negative: at an end. */
static double least(const search *s)
{
    const double *g = s->g;
    int n = 2 * s->d;
    double lo = 0.0, hi = 1.0, v, d1, d2;

    if (!(g[1] < g[0]) || !(g[n] > g[n - 1]))
        return -1.0;
    v = (g[0] - g[1]) / (g[0] - g[1] + g[n] - g[n - 1]);
    for (int i = 0; i < 60; i++) {
        double next;

        slopes(s, v, &d1, &d2);
        if (d1 == 0.0)
            return v;
        if (d1 < 0.0)
            lo = v;
        else
            hi = v;
        next = v - d1 / d2;
        if (!(next > lo && next < hi))
            next = 0.5 * (lo + hi);
        /* the next step would be its square */
        if (fabs(next - v) <= 1e-9 || next <= lo || next >= hi)
            return next;
        v = next;
    }
    return v;
}

/* Is the convex g nowhere deep, its tangent at the known place, if that is
 * here, being above that? */
static bool shallow(const search *s, double u0, double u1)
{
    int n = 2 * s->d;
    double v = (s->known_u - u0) / (u1 - u0);

    if (s->known != s->span || !(v > 0.0 && v < 1.0))
        return false;
    for (int i = 0; i < n; i++)
        s->t[i] = n * (s->g[i + 1] - s->g[i]);
    return value(n, s->g, v) - fabs(value(n - 1, s->t, v)) * fmax(v, 1.0 - v) >=
           -s->limit;
}

/* The best value on a part where g is convex; false if g is not, or the part
 * turns out to be too large. */
static bool solve_convex(search *s, const double *p, double u0, double u1)
{
    int n = 2 * s->d;

    for (int i = 0; i < MAX_STEPS; i++) {
        double v, k, va;
        bool more;

        if (fill(s) >= -s->limit && i == 0)
            return true;
        if (!convex(s))
            return false;
        if (i == 0 && shallow(s, u0, u1))
            return true;
        v = least(s);
        if (!(v > 0.0) || (i == 0 && !(value(n, s->g, v) < -s->limit)))
            return true; /* at an end, or not deep enough to be more than
                            rounding; later steps only sharpen the first */
        va = value(n, s->a, v);
        k = va > 0.0 ? value(n, s->b, v) / va : (double)INFINITY;
        if (!(radii(s, p, k) <= MAX_RADII))
            return false;          /* a is rounding there */
        more = i == 0 || k > s->k; /* else: all digits */
        if (more)
            s->k = k;
        s->found = s->span;
        s->u = u0 + v * (u1 - u0);
        if (done(s) || !more)
            return true;
    }
    return false;
}

/* What of g is as deep as the tolerance on a part: by the part's own weights,
 * but those of the span leave rounding. */
static double limit_of(const search *s, const double *p)
{
    double w = ix__bern_largest((size_t)s->d + 1, p);

    return s->tol * w * fmax(w, 0.1 * s->sp->weight);
}

static void part(search *s, double *p, double u0, double u1, int depth)
{
    int d = s->d;
    double *left = s->room + (size_t)depth * 3 * (size_t)(d + 1);
    double um = 0.5 * (u0 + u1);

    if (done(s) || !isfinite(s->k) || !part_in_reach(s, p))
        return;
    load(s, p);
    s->limit = limit_of(s, p);
    if (hopeless(s, radii(s, p, s->k)))
        return;
    offer(s, s->a[0], s->b[0], u0);
    offer(s, s->a[2 * d], s->b[2 * d], u1);
    if (done(s) || !isfinite(s->k) || d == 0 || depth == MAX_HALVINGS)
        return;
    if (radii(s, p, s->k) <= MAX_RADII && solve_convex(s, p, u0, u1))
        return;
    for (int k = 0; k < 3; k++)
        halve(d, p + k * (d + 1), left + k * (d + 1));
    part(s, left, u0, um, depth + 1);
    part(s, p, um, u1, depth + 1);
}

/* --- one span --------------------------------------------------------------
 */

/* The arrays of set->work: five of 2 d + 1, one of 4 (d + 1), binomials of d
 * and 2 d, the control points, and those of each depth. */
static void lay_out(search *s, double *work)
{
    int d = s->d, n = 2 * d + 1;
    double *at = work;

    s->a = at;
    s->b = at + n;
    s->g = at + 2 * n;
    s->t = at + 3 * n;
    s->q = at + 4 * n;
    at = s->q + 4 * (d + 1);
    s->bin = ix__binom(d, at);
    s->bin2 = ix__binom(2 * d, at + d + 1);
    s->room = at + d + 1 + n;
}

static void run(search *s, const ix__set *set, int index)
{
    const ix__span *sp = &set->span[index];
    int d = sp->degree;
    double *p;

    s->sp = sp;
    s->d = d;
    s->span = index;
    lay_out(s, set->work);
    p = s->room;
    s->room += 3 * (d + 1);
    for (int i = 0; i <= d; i++) {
        double w = sp->p[i] / s->bin[i];

        p[i] = w;
        for (int k = 0; k < 2; k++)
            p[(k + 1) * (d + 1) + i] = sp->p[(k + 1) * (d + 1) + i] /
                                           s->bin[i] -
                                       s->c[k] * w;
    }
    part(s, p, 0.0, 1.0, 0);
}

static search prepare(const double c[2], double k, double tol)
{
    search s = {.tol = tol, .k = k, .found = -1, .known = -1};

    memcpy(s.c, c, sizeof s.c);
    return s;
}

/* --- circles ---------------------------------------------------------------
 */

static bool in_reach(const search *s, const ix__span *sp)
{
    double lo[2], hi[2];

    for (int i = 0; i < 2; i++) {
        lo[i] = sp->box[0][i] - s->c[i];
        hi[i] = sp->box[1][i] - s->c[i];
    }
    return !sp->boxed || box_in_reach(s, lo, hi);
}

/* k at u and the step to where it is stationary; h is |v|^4 / 2 times its
 * derivative. False where it has no maximum near. */
static bool stationary(const ix__set *set, const search *s, int span, double u,
                       double *k, double *vv, double *step)
{
    double d[3][2], v[2], nv, dv, h, dh;

    ix__span_at(set, &set->span[span], u, d);
    for (int j = 0; j < 2; j++)
        v[j] = d[0][j] - s->c[j];
    *vv = v[0] * v[0] + v[1] * v[1];
    nv = s->n[0] * v[0] + s->n[1] * v[1];
    dv = d[1][0] * v[0] + d[1][1] * v[1];
    h = (s->n[0] * d[1][0] + s->n[1] * d[1][1]) * *vv - 2.0 * nv * dv;
    dh = (s->n[0] * d[2][0] + s->n[1] * d[2][1]) * *vv -
         2.0 * nv *
             (d[2][0] * v[0] + d[2][1] * v[1] + d[1][0] * d[1][0] +
              d[1][1] * d[1][1]);
    *k = 2.0 * nv / *vv;
    *step = -h / dh;
    return dh < 0.0 && fabs(*step) <= 1e-3;
}

int ix__next_span(const ix__set *set, int span, int e)
{
    const ix__span *sp = &set->span[span];
    const ix__strand *st;
    int i;

    if (sp->vertex[e] >= 0 || sp->strand < 0)
        return -1;
    st = &set->strand[sp->strand];
    i = span - st->first + (e ? 1 : -1);
    if (!st->closed && (i < 0 || i >= st->count))
        return -1;
    return st->first + (i + st->count) % st->count;
}

/* Moves a foot that is no vertex to where k is stationary: the search stops
 * where nothing is deeper than can be told from nothing, which leaves the foot
 * within the square root of that. */
static void sharpen(const ix__set *set, search *s)
{
    int span = s->found;
    double u = s->u;

    if ((u <= 0.0 && ix__next_span(set, span, 0) < 0) ||
        (u >= 1.0 && ix__next_span(set, span, 1) < 0))
        return;
    for (int i = 0; i < 8; i++) {
        double k, vv, step;
        bool maximum = stationary(set, s, span, u, &k, &vv, &step);

        if (i > 0 && (s->k - k) * vv <= s->tol) {
            s->k = fmax(s->k, k);
            s->found = span;
            s->u = u;
        }
        if (!maximum)
            return;
        u += step;
        if (u < 0.0 || u > 1.0) {
            int e = u > 1.0;

            span = ix__next_span(set, span, e);
            if (span < 0)
                return;
            u = e ? 0.0 : 1.0;
        }
    }
}

/* Begins with a point of the set that is near foot, if it is as deep in the
 * circle that came in as others have to be: circles that hold it need not be
 * searched. */
static void begin_near(const ix__set *set, const ix__touch *foot, search *s)
{
    double u = foot->u, k, vv, step;

    for (int i = 0; i < 3; i++) {
        bool maximum = stationary(set, s, foot->span, u, &k, &vv, &step);

        if ((k - s->k) * vv > (s->found < 0 ? s->tol : 0.0)) {
            s->k = k;
            s->found = s->known = foot->span;
            s->u = s->known_u = u;
        }
        if (!maximum || !(u + step > 0.0 && u + step < 1.0))
            return;
        u += step;
    }
}

static void run_all(const ix__set *set, search *s)
{
    for (int i = 0; i < set->nspans && !done(s) && isfinite(s->k); i++)
        if (in_reach(s, &set->span[i]))
            run(s, set, i);
}

/* A value that is a little less than that of the best point that was seen: the
 * search has to find that and better ones itself, so that the same point wins
 * wherever it begins. */
static double seen_least(const ix__set *set, const search *s)
{
    double best = s->k;

    for (int i = 0; i < set->nspans; i++)
        for (int j = 0; j < IX__SEEN; j++) {
            const double *x = set->span[i].seen[j];
            double v[2] = {x[0] - s->c[0], x[1] - s->c[1]};
            double a = v[0] * v[0] + v[1] * v[1];
            double b = s->distance ? 1.0 - SEEN_LESS
                                   : 2.0 * (s->n[0] * v[0] + s->n[1] * v[1]) -
                                         4.0 * s->tol;

            if (b > best * a && a > 0.0 && isfinite(b / a))
                best = b / a;
        }
    return best;
}

static void run_from_seen(const ix__set *set, search *s)
{
    double k = s->k;

    s->k = seen_least(set, s);
    run_all(set, s);
    if (s->found >= 0 || s->k == k)
        return;
    s->k = k; /* rounding, or weights */
    run_all(set, s);
}

static bool touch(const ix__set *set, const ix__touch *foot, search *s,
                  ix__touch *io)
{
    if (foot)
        begin_near(set, foot, s);
    if (s->any || s->found >= 0)
        run_all(set, s);
    else
        run_from_seen(set, s);
    if (s->found < 0)
        return false;
    if (!s->any && isfinite(s->k))
        sharpen(set, s);
    *io = (ix__touch){s->k, s->found, s->u};
    return true;
}

void ix__set_touch_near(const ix__set *s, const double c[2], const double n[2],
                        double depth, const ix__touch *foot, ix__touch *io)
{
    search q = prepare(c, io->kappa, 2.0 * depth);

    memcpy(q.n, n, sizeof q.n);
    (void)touch(s, foot, &q, io);
}

void ix__set_touch(const ix__set *s, const double c[2], const double n[2],
                   double depth, ix__touch *io)
{
    ix__set_touch_near(s, c, n, depth, NULL, io);
}

bool ix__set_blocks(const ix__set *s, const double c[2], const double n[2],
                    double depth, ix__touch *io)
{
    search q = prepare(c, io->kappa, 2.0 * depth);

    memcpy(q.n, n, sizeof q.n);
    q.any = true;
    q.known = io->span;
    q.known_u = io->u;
    return touch(s, NULL, &q, io);
}

/* --- distance --------------------------------------------------------------
 */

double ix__set_distance(const ix__set *set, const double x[2], ix__touch *at)
{
    search s = prepare(x, 0.0, ROUNDING);

    s.distance = true;
    run_from_seen(set, &s);
    if (at)
        *at = (ix__touch){s.k, s.found, s.u};
    return s.found < 0 ? (double)INFINITY : 1.0 / sqrt(s.k);
}

bool ix__set_near(const ix__set *set, const double x[2], double d)
{
    search s = prepare(x, 1.0 / (d * d), ROUNDING);

    s.distance = s.any = true;
    run_all(set, &s);
    return s.found >= 0;
}
