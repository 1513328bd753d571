/* poly_roots.c - the roots of one polynomial in Bernstein form.
 *
 * A piece is the polynomial on a subinterval with both end values decided
 * (outside their error band). Its number of sign variations v bounds its
 * number of roots: v = 0 none, v = 1 exactly one. Other pieces are split at
 * points where the value is decided again. What stays undecided down to the
 * resolution of the arithmetic is a cluster. Invariant: |true coefficient -
 * stored coefficient| <= err for every coefficient of a piece. */
#include "solve/poly_roots.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/dd.h"

#define UNIT         (DBL_EPSILON / 2)
#define BLOCK        4 /* pieces that get their arrays together */
#define DEPTH_DOUBLE 64
#define DEPTH_DD     120 /* both multiples of BLOCK */

/* h, or h + l in double-double when l is not NULL. */
typedef struct {
    int degree;
    double *h, *l;
    double err;
    double lo, hi; /* the interval in [0, 1] */
} piece;

typedef struct {
    ix_ctx *ctx;
    ix__poly_roots *out;
    piece *stack; /* [depth]: pieces still to be looked at, leftmost on top */
    int top, depth;
    int made;     /* pieces of the stack that have arrays */
    int cap;      /* room in out->root */
    bool precise; /* double-double */
} search;

/* --- signs ------------------------------------------------------------------
 */

static int sign_of(const piece *p, int i)
{
    double v = p->h[i];

    if (v > p->err)
        return 1;
    if (v < -p->err)
        return -1;
    return 0;
}

/* Sign variations if no coefficient is inside its band, else -1. */
static int decided_variations(const piece *p)
{
    const double *h = p->h;
    int n = 0;

    for (int i = 0; i <= p->degree; i++)
        if (!(h[i] > p->err || h[i] < -p->err))
            return -1;
    for (int i = 0; i < p->degree; i++)
        n += (h[i] > 0) != (h[i + 1] > 0);
    return n;
}

/* Fewest and most sign variations that coefficients inside the bands allow. */
static void variations(const piece *p, int *fewest, int *most)
{
    int last = 0, few = 0, plus = 0, minus = 0;

    *fewest = *most = decided_variations(p);
    if (*most >= 0)
        return;
    for (int i = 0; i <= p->degree; i++) {
        int s = sign_of(p, i);
        int if_plus = plus > minus + 1 ? plus : minus + 1;
        int if_minus = minus > plus + 1 ? minus : plus + 1;

        if (i == 0)
            if_plus = if_minus = 0;
        plus = s >= 0 ? if_plus : -p->degree - 2;
        minus = s <= 0 ? if_minus : -p->degree - 2;
        if (s && last && s != last)
            few++;
        if (s)
            last = s;
    }
    *fewest = few;
    *most = plus > minus ? plus : minus;
}

static double largest(const piece *p)
{
    double m = 0;

    for (int i = 0; i <= p->degree; i++)
        m = fabs(p->h[i]) > m ? fabs(p->h[i]) : m;
    return m;
}

/* --- splitting ---------------------------------------------------------------
 */

static void split_double(double *w, int d, double r, double *left)
{
    double q = 1 - r;

    left[0] = w[0];
    for (int k = 1; k <= d; k++) {
        for (int i = 0; i <= d - k; i++)
            w[i] = q * w[i] + r * w[i + 1];
        left[k] = w[0];
    }
}

static void split_dd(piece *right, int d, double r, piece *left)
{
    ix_dd rr = {r, 0}, qq = ix__two_sum(1, -r);

    left->h[0] = right->h[0];
    left->l[0] = right->l[0];
    for (int k = 1; k <= d; k++) {
        for (int i = 0; i <= d - k; i++) {
            ix_dd a = {right->h[i], right->l[i]};
            ix_dd b = {right->h[i + 1], right->l[i + 1]};
            ix_dd v = ix__dd_add(ix__dd_mul(qq, a), ix__dd_mul(rr, b));

            right->h[i] = v.hi;
            right->l[i] = v.lo;
        }
        left->h[k] = right->h[0];
        left->l[k] = right->l[0];
    }
}

static double value_at(const piece *p, double r, double *work)
{
    double q = 1 - r;

    memcpy(work, p->h, ((size_t)p->degree + 1) * sizeof *work);
    for (int k = 1; k <= p->degree; k++)
        for (int i = 0; i <= p->degree - k; i++)
            work[i] = q * work[i] + r * work[i + 1];
    return work[0];
}

/* p becomes its right part, left (with its own arrays) the left one. Each de
 * Casteljau step commits 3 roundings relative to the largest coefficient. */
static void split(piece *p, double r, piece *left)
{
    double unit = p->l ? 0x1p-100 : 3 * UNIT;
    double err = p->err + p->degree * unit * largest(p);

    left->degree = p->degree;
    if (p->l)
        split_dd(p, p->degree, r, left);
    else
        split_double(p->h, p->degree, r, left->h);
    left->err = p->err = err;
    left->lo = p->lo;
    left->hi = p->lo = p->lo + r * (p->hi - p->lo);
}

/* A ratio near the middle at which the value is outside its band, or 0. */
static double split_ratio(const piece *p, double *work)
{
    static const double ratios[] = {0.5,     0.453125, 0.546875, 0.40625,
                                    0.59375, 0.296875, 0.703125};
    double band = p->err + 4 * p->degree * UNIT * largest(p);

    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++)
        if (fabs(value_at(p, ratios[i], work)) > band)
            return ratios[i];
    return 0;
}

/* In the middle; false (p unchanged up to rounding) if the value there is
 * inside its band. keep has room for the coefficients. */
static bool split_middle(piece *p, double *keep, piece *left)
{
    size_t bytes = ((size_t)p->degree + 1) * sizeof *keep;
    double err = p->err, lo = p->lo, mid = lo + 0.5 * (p->hi - lo);

    if (p->l || !(mid > lo && mid < p->hi))
        return false;
    memcpy(keep, p->h, bytes);
    split(p, 0.5, left);
    if (fabs(p->h[0]) > p->err)
        return true;
    memcpy(p->h, keep, bytes);
    p->err = err;
    p->lo = lo;
    return false;
}

/* --- reporting
 * ---------------------------------------------------------------- */

static void report(search *s, double t, double lo, double hi, int count)
{
    ix__poly_roots *o = s->out;

    if (o->n < s->cap)
        o->root[o->n++] = (ix__poly_root){
            .s = t, .lo = lo, .hi = hi, .count = count};
}

/* Value and derivative at r of degree >= 1; Horner in Bernstein form would be
 * faster, de Casteljau keeps the relative accuracy near clustered roots. */
static double value_and_slope(const piece *p, double r, double *work,
                              double *slope)
{
    double q = 1 - r;
    int d = p->degree;

    memcpy(work, p->h, ((size_t)d + 1) * sizeof *work);
    for (int k = 1; k < d; k++)
        for (int i = 0; i <= d - k; i++)
            work[i] = q * work[i] + r * work[i + 1];
    *slope = d * (work[1] - work[0]);
    return q * work[0] + r * work[1];
}

/* The root of a piece with one sign change, by Newton inside the shrinking
 * bracket [a, b], halving where Newton leaves it or is slow. */
static double polish(const piece *p, double *work, double *slope)
{
    double a = 0, b = 1, fa = p->h[0];
    double r = p->h[0] / (p->h[0] - p->h[p->degree]);

    *slope = 0;
    for (int it = 0; it < 200; it++) {
        double f = value_and_slope(p, r, work, slope), next;

        if (f == 0 || b - a <= 2 * UNIT * b)
            break;
        if ((f > 0) == (fa > 0))
            a = r;
        else
            b = r;
        next = r - f / *slope;
        if (!(next > a && next < b))
            next = (it & 1) ? 0.5 * (a + b)
                            : r + 0.5 * ((f > 0) == (fa > 0) ? b - r : a - r);
        if (fabs(next - r) <= UNIT * fabs(r))
            break;
        r = next;
    }
    return r;
}

/* One simple root in the piece: its place and an enclosing interval whose ends
 * have decided, opposite signs. */
static void report_simple(search *s, piece *p, double *work)
{
    double slope, w = p->hi - p->lo;
    double r = polish(p, work, &slope);
    double band = p->err + 4 * p->degree * UNIT * largest(p);
    double half = fmax(2 * band / fabs(slope), 4 * UNIT);
    double lo, hi, t = p->lo + r * w;

    for (;;) {
        lo = fmax(r - half, 0);
        hi = fmin(r + half, 1);
        if ((lo <= 0 || fabs(value_at(p, lo, work)) > band) &&
            (hi >= 1 || fabs(value_at(p, hi, work)) > band))
            break;
        half += half;
    }
    lo = lo <= 0 ? p->lo : p->lo + lo * w;
    hi = hi >= 1 ? p->hi : p->lo + hi * w;
    report(s, t, fmin(nextafter(lo, -1), t), fmax(nextafter(hi, 2), t), 1);
}

/* --- the search
 * ------------------------------------------------------------------ */

/* The first BLOCK pieces of the stack that have no arrays get them. */
static ix_status new_pieces(search *s, int degree)
{
    size_t n = (size_t)degree + 1;
    double *room;

    IX_SCRATCH(s->ctx, room, BLOCK * n * (s->precise ? 2 : 1));
    for (int i = 0; i < BLOCK; i++) {
        piece *p = &s->stack[s->made++];

        p->degree = degree;
        p->h = room;
        room += n;
        p->l = s->precise ? room : NULL;
        room += s->precise ? n : 0;
    }
    return IX_OK;
}

/* The middle of what cannot be decided further. A multiple root of
 * multiplicity m is a simple root of the derivative of order m - 1. */
static void report_cluster(search *s, const piece *p, int most, double *work)
{
    int m = most, d = p->degree;
    double r = 0.5;

    if (m >= 2 && m <= d) {
        memcpy(work, p->h, ((size_t)d + 1) * sizeof *work);
        for (int k = 1; k < m; k++)
            for (int i = 0; i <= d - k; i++)
                work[i] = work[i + 1] - work[i];
        d -= m - 1;
        if ((work[0] > 0) != (work[d] > 0)) {
            piece q = {.degree = d, .h = work};
            double slope;

            r = polish(&q, work + d + 1, &slope);
        }
    }
    report(s, p->lo + r * (p->hi - p->lo), p->lo, p->hi, m);
}

/* Splits the top piece where its value is decided, or reports a cluster. */
static ix_status split_or_report(search *s, int most, double *work)
{
    piece *p = &s->stack[s->top], *left = p + 1;
    double r, m;

    if (s->top + 1 < s->depth) {
        if (s->top + 1 == s->made)
            IX_TRY(new_pieces(s, p->degree));
        if (split_middle(p, work, left)) {
            s->top++;
            return IX_OK;
        }
    }
    r = s->top + 1 < s->depth ? split_ratio(p, work) : 0;
    m = p->lo + r * (p->hi - p->lo);
    if (r == 0 || !(m > p->lo && m < p->hi)) {
        report_cluster(s, p, most, work);
        s->top--;
        return IX_OK;
    }
    split(p, r, left);
    s->top++;
    return IX_OK;
}

/* The work array has room for twice the coefficients. */
static ix_status search_all(search *s, double *work)
{
    while (s->top >= 0) {
        piece *p = &s->stack[s->top];
        int few, most;

        variations(p, &few, &most);
        if (most == 0 || (few == 1 && most == 1)) {
            if (most == 1)
                report_simple(s, p, work);
            s->top--;
            continue;
        }
        IX_TRY(split_or_report(s, most, work));
        IX_TRY(ix__poll(s->ctx));
    }
    return IX_OK;
}

/* --- ends
 * ------------------------------------------------------------------------- */

/* Divides out u^k and v^m where k leading and m trailing coefficients are
 * zero within the band: b_i C(d,i) / C(d-k-m, i-k) is the quotient. */
static void deflate(int degree, const double *b, int k, int m, double *out,
                    double *gain)
{
    int d = degree - k - m;
    double ratio = 1; /* C(degree, i+k) / C(d, i), starting at i = 0 */

    *gain = 1;
    if (d == degree) {
        memcpy(out, b, ((size_t)d + 1) * sizeof *out);
        return;
    }
    for (int j = 1; j <= k; j++)
        ratio = ratio * (degree - j + 1) / j;
    for (int i = 0; i <= d; i++) {
        out[i] = b[i + k] * ratio;
        *gain = fmax(*gain, ratio);
        ratio = ratio * (degree - i - k) / (i + k + 1);
        if (i < d)
            ratio = ratio * (i + 1) / (d - i);
    }
}

static void count_end_zeros(int degree, const double *b, double band,
                            ix__poly_roots *out)
{
    int k = 0, m = 0;

    while (k <= degree && fabs(b[k]) <= band)
        k++;
    if (k > degree) {
        out->vanishes = true;
        return;
    }
    while (fabs(b[degree - m]) <= band)
        m++;
    out->zeros0 = k;
    out->zeros1 = m;
    out->sign0 = b[k] > 0 ? 1 : -1;
    out->sign1 = b[degree - m] > 0 ? 1 : -1;
}

static ix_status start(search *s, ix_ctx *ctx, const piece *whole, bool precise)
{
    size_t bytes = ((size_t)whole->degree + 1) * sizeof *whole->h;

    *s = (search){.ctx = ctx,
                  .precise = precise,
                  .depth = precise ? DEPTH_DD : DEPTH_DOUBLE};
    IX_SCRATCH(ctx, s->stack, s->depth);
    IX_TRY(new_pieces(s, whole->degree));
    memcpy(s->stack[0].h, whole->h, bytes);
    if (precise)
        memset(s->stack[0].l, 0, bytes);
    s->stack[0].err = whole->err;
    s->stack[0].lo = 0;
    s->stack[0].hi = 1;
    return IX_OK;
}

static bool all_simple(const ix__poly_roots *o)
{
    for (int i = 0; i < o->n; i++)
        if (o->root[i].count != 1)
            return false;
    return true;
}

/* Sign variations of the polynomial (b, exact up to band) on [lo, hi], or -1
 * if its bands leave them open there. */
static int count_on(search *s, const piece *whole, double lo, double hi)
{
    piece p = s->stack[0], left = s->stack[1];
    int few, most;

    memcpy(p.h, whole->h, ((size_t)p.degree + 1) * sizeof *p.h);
    memset(p.l, 0, ((size_t)p.degree + 1) * sizeof *p.l);
    p.err = whole->err;
    p.lo = 0;
    p.hi = 1;
    if (lo > 0)
        split(&p, lo, &left);
    else
        lo = 0;
    if (hi < 1) {
        split(&p, (hi - lo) / (1 - lo), &left);
        variations(&left, &few, &most);
    } else {
        variations(&p, &few, &most);
    }
    return few == most ? few : -1;
}

/* The number of roots in a cluster: the interval is widened, within its
 * neighbours, until the variations on it are decided. */
static void count_cluster(search *s, const piece *whole, double lo, double hi,
                          ix__poly_root *r)
{
    double w = fmax(r->hi - r->lo, 4 * UNIT);

    for (int k = 0; k < 50; k++, w *= 2) {
        double a = fmax(lo, r->lo - w), b = fmin(hi, r->hi + w);
        int n = count_on(s, whole, a, b);

        if (n >= 0) {
            r->count = n;
            return;
        }
        if (a <= lo && b >= hi)
            return;
    }
}

static ix_status count_clusters(search *s, const piece *whole)
{
    ix__poly_roots *o = s->out;
    int n = 0;

    for (int i = 0; i < o->n; i++) {
        ix__poly_root *r = &o->root[i];

        if (r->count != 1)
            count_cluster(s, whole, i > 0 ? o->root[i - 1].hi : 0,
                          i + 1 < o->n ? o->root[i + 1].lo : 1, r);
        if (r->count > 0)
            o->root[n++] = *r;
    }
    o->n = n;
    return IX_OK;
}

/* Clusters that touch each other are one; pieces between were decided. */
static void join_clusters(ix__poly_roots *o)
{
    int n = 0;

    for (int i = 0; i < o->n; i++) {
        ix__poly_root *a = n > 0 ? &o->root[n - 1] : NULL, *b = &o->root[i];

        if (a && a->count > 1 && b->count > 1 && a->hi >= b->lo) {
            a->hi = b->hi;
            a->s = 0.5 * (a->lo + a->hi);
            a->count += b->count;
        } else {
            o->root[n++] = *b;
        }
    }
    o->n = n;
}

/* The polynomial without its roots at the ends, its coefficients in h, and the
 * bound of their errors. */
static piece inner_part(int degree, const double *b, double band,
                        const ix__poly_roots *o, double *h)
{
    piece whole = {.degree = degree - o->zeros0 - o->zeros1, .h = h};
    double gain;

    deflate(degree, b, o->zeros0, o->zeros1, h, &gain);
    whole.err = band * gain;
    if (whole.degree < degree) /* at most 3 roundings in each of the ratios */
        whole.err += 3 * degree * UNIT * largest(&whole);
    return whole;
}

ix_status ix__poly_roots_find(ix_ctx *ctx, int degree, const double *b,
                              double band, ix__poly_roots *out)
{
    const piece given = {
        .degree = degree, .h = (double *)(uintptr_t)b, .err = band};
    size_t n = (size_t)degree + 1;
    double *room;
    piece whole;
    search s;

    *out = (ix__poly_roots){.n = 0};
    count_end_zeros(degree, b, band, out);
    if (out->vanishes || decided_variations(&given) == 0)
        return IX_OK;
    IX_SCRATCH(ctx, room, 3 * n + 2);
    whole = inner_part(degree, b, band, out, room);
    IX_SCRATCH(ctx, out->root, n);
    for (int precise = 0; precise <= 1; precise++) {
        IX_TRY(start(&s, ctx, &whole, precise != 0));
        s.out = out;
        s.cap = degree + 1;
        out->n = 0;
        IX_TRY(search_all(&s, room + n));
        if (all_simple(out))
            return IX_OK;
    }
    join_clusters(out);
    return count_clusters(&s, &whole);
}
