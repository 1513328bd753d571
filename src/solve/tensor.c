/* tensor.c - Bernstein tensors on a box. */
#include "solve/tensor.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "bern/clones.h"

void ix__shape_init(ix__shape *s, int n, const int *dims)
{
    s->n = n;
    s->size = 1;
    for (int j = 0; j < n; j++) {
        s->dims[j] = dims[j];
        s->stride[j] = s->size;
        s->size *= (size_t)dims[j];
    }
    s->sum = false;
}

void ix__shape_init_sum(ix__shape *s, int n, const int *dims)
{
    s->n = n;
    s->size = 0;
    for (int j = 0; j < n; j++) {
        s->dims[j] = dims[j];
        s->stride[j] = s->size;
        s->size += (size_t)dims[j];
    }
    s->sum = true;
}

/* The layers along j: m of inner numbers each, block after block. */
typedef struct {
    size_t inner, m, block, from, to;
} along;

static along layers_along(const ix__shape *s, int j)
{
    along l = {.inner = s->stride[j], .m = (size_t)s->dims[j], .to = s->size};

    if (s->sum) {
        l.inner = 1;
        l.from = s->stride[j];
        l.to = l.from + l.m;
    }
    l.block = l.inner * l.m;
    return l;
}

/* w[i] = (1 - a) w[i] + a w[i + inner] for m - 1 layers of inner numbers; four
 * at a time, all of them read before the first is written. */
static void blend(double *w, size_t layers, size_t inner, double a)
{
    double q = 1 - a;
    size_t n = layers * inner, i = 0;

    for (; inner >= 8 && i + 4 <= n; i += 4)
        *ix__vec(w + i) = q * *ix__cvec(w + i) + a * *ix__cvec(w + i + inner);
    for (; i < n; i++)
        w[i] = q * w[i] + a * w[i + inner];
}

/* The same from the far end: w[i + inner] = (1 - a) w[i] + a w[i + inner]. */
static void blend_back(double *w, size_t layers, size_t inner, double a)
{
    double q = 1 - a;
    size_t i = layers * inner;

    for (; inner >= 8 && i >= 4; i -= 4)
        *ix__vec(w + i - 4 + inner) = q * *ix__cvec(w + i - 4) +
                                      a * *ix__cvec(w + i - 4 + inner);
    while (i-- > 0)
        w[i + inner] = q * w[i] + a * w[i + inner];
}

/* The same of a line. */
static void cut_line(double *w, size_t m, double a, bool low)
{
    double q = 1 - a;

    for (size_t k = 1; k < m; k++) {
        if (low)
            for (size_t i = 0; i < m - k; i++)
                w[i] = q * w[i] + a * w[i + 1];
        else
            for (size_t i = m - 1; i >= k; i--)
                w[i] = q * w[i - 1] + a * w[i];
    }
}

void ix__tensor_cut(const ix__shape *s, double *c, int j, double a, bool low)
{
    along l = layers_along(s, j);

    for (double *p = c + l.from; p < c + l.to; p += l.block) {
        if (l.inner == 1)
            cut_line(p, l.m, a, low);
        for (size_t k = 1; k < l.m && l.inner > 1; k++) {
            if (low)
                blend(p, l.m - k, l.inner, a);
            else
                blend_back(p + (k - 1) * l.inner, l.m - k, l.inner, a);
        }
    }
}

void ix__tensor_restrict(const ix__shape *s, double *c, int j, double a,
                         double b)
{
    if (b < 1 || b > 1)
        ix__tensor_cut(s, c, j, b, false);
    if (a < 0 || a > 0)
        ix__tensor_cut(s, c, j, a / b, true);
}

#define MAX_LAYERS 64

/* Widens [*lo, *hi] to hold c[n]. */
static inline void widen(const double *c, size_t n, double *lo, double *hi)
{
    double a = *lo, b = *hi;

    for (size_t i = 0; i < n; i++) {
        a = c[i] < a ? c[i] : a;
        b = c[i] > b ? c[i] : b;
    }
    *lo = a;
    *hi = b;
}

/* The range of n numbers: of many by four running extremes, so that they need
 * not wait for each other. */
static void range_of(const double *c, size_t n, double *lo, double *hi)
{
    double a[4], b[4];
    size_t i = 0;

    *lo = *hi = c[0];
    if (n >= 8) {
        for (int k = 0; k < 4; k++)
            a[k] = b[k] = c[k];
        for (i = 4; i + 4 <= n; i += 4)
            for (int k = 0; k < 4; k++) {
                a[k] = c[i + (size_t)k] < a[k] ? c[i + (size_t)k] : a[k];
                b[k] = c[i + (size_t)k] > b[k] ? c[i + (size_t)k] : b[k];
            }
        widen(a, 4, lo, hi);
        widen(b, 4, lo, hi);
    }
    widen(c + i, n - i, lo, hi);
}

/* Range and size (see ix__tensor_size) of a sum without line j; j < 0: of all.
 */
static void measure_without(const ix__shape *s, const double *c, int j,
                            double *lo, double *hi, double *size)
{
    *lo = *hi = *size = 0;
    for (int i = 0; i < s->n; i++) {
        double a, b;

        if (i == j)
            continue;
        range_of(c + s->stride[i], (size_t)s->dims[i], &a, &b);
        *lo += a;
        *hi += b;
        *size += ix__larger(-a, b);
    }
}

void ix__tensor_measure(const ix__shape *s, const double *c, double *lo,
                        double *hi, double *size)
{
    if (s->sum) {
        measure_without(s, c, -1, lo, hi, size);
    } else {
        range_of(c, s->size, lo, hi);
        *size = ix__larger(-*lo, *hi);
    }
}

void ix__tensor_range(const ix__shape *s, const double *c, double *lo,
                      double *hi)
{
    double size;

    ix__tensor_measure(s, c, lo, hi, &size);
}

double ix__tensor_size(const ix__shape *s, const double *c)
{
    double lo, hi, size;

    ix__tensor_measure(s, c, &lo, &hi, &size);
    return size;
}

void ix__tensor_center(const ix__shape *s, double *c)
{
    double moved = 0, *last = c + s->stride[s->n - 1];

    for (int j = 0; s->sum && j + 1 < s->n; j++) {
        double *p = c + s->stride[j], v = p[0];

        for (int i = 0; i < s->dims[j]; i++)
            p[i] -= v;
        moved += v;
    }
    for (int i = 0; s->sum && i < s->dims[s->n - 1]; i++)
        last[i] += moved;
}

void ix__tensor_expand(const ix__shape *sum, const double *c, double *out)
{
    size_t size = 1;

    out[0] = 0;
    for (int j = 0; j < sum->n; j++) {
        const double *p = c + sum->stride[j];

        for (size_t k = (size_t)sum->dims[j]; k-- > 0;)
            for (size_t i = 0; i < size; i++)
                out[k * size + i] = out[i] + p[k];
        size *= (size_t)sum->dims[j];
    }
}

/* The layers along j are bounded by numbers, which go through the same passes
 * as the layers do: each coefficient of a part is a convex combination of
 * coefficients, with the same weights in every line. */
double ix__tensor_restrict_size(const ix__shape *s, const double *c, int j,
                                double a, double b)
{
    const ix__shape line = {.n = 1,
                            .dims = {s->dims[j]},
                            .stride = {1},
                            .size = (size_t)s->dims[j]};
    double w[MAX_LAYERS] = {0}, lo, hi, from, to, rest = 0;
    along l = layers_along(s, j);

    if (l.m > MAX_LAYERS)
        return ix__tensor_size(s, c);
    for (const double *p = c + l.from; p < c + l.to; p += l.block)
        for (size_t k = 0; k < l.m; k++)
            for (size_t i = 0; i < l.inner; i++)
                w[k] = fabs(p[k * l.inner + i]) > w[k]
                           ? fabs(p[k * l.inner + i])
                           : w[k];
    ix__tensor_restrict(&line, w, 0, a, b);
    ix__tensor_range(&line, w, &lo, &hi);
    if (s->sum)
        measure_without(s, c, j, &from, &to, &rest);
    return (hi + rest) * (1 + 8 * MAX_LAYERS * DBL_EPSILON);
}

/* Contracts the last direction of size dims[n-1] at x by de Casteljau. */
static void contract(double *w, size_t inner, int m, double x)
{
    for (int k = 1; k < m; k++)
        blend(w, (size_t)(m - k), inner, x);
}

/* The m Bernstein polynomials of degree m - 1 at x, and their derivatives if d
 * is not NULL: those of degree m - 2, which come on the way, differenced. */
static void bernstein(int m, double x, double *b, double *d)
{
    double q = 1 - x;

    b[0] = 1;
    if (d && m == 1)
        d[0] = 0;
    for (int k = 1; k < m; k++) {
        if (d && k == m - 1) {
            d[0] = -k * b[0];
            for (int i = 1; i < k; i++)
                d[i] = k * (b[i - 1] - b[i]);
            d[k] = k * b[k - 1];
        }
        b[k] = x * b[k - 1];
        for (int i = k - 1; i > 0; i--)
            b[i] = q * b[i] + x * b[i - 1];
        b[0] *= q;
    }
}

/* out[inner] = sum f[k] w[k][inner]; out may be w. */
static void weigh(size_t inner, int m, const double *f, const double *w,
                  double *out)
{
    for (size_t i = 0; i < inner; i++) {
        double sum = f[0] * w[i];

        for (int k = 1; k < m; k++)
            sum += f[k] * w[(size_t)k * inner + i];
        out[i] = sum;
    }
}

/* Value at x of a line of m numbers, *d its derivative; work has m. */
static double line_at(const double *c, int m, double x, double *d, double *work)
{
    double q = 1 - x;

    if (m == 1) {
        *d = 0;
        return c[0];
    }
    for (int k = m - 1; k > 1; k--) {
        for (int i = 0; i < k; i++)
            work[i] = q * c[i] + x * c[i + 1];
        c = work;
    }
    *d = (m - 1) * (c[1] - c[0]);
    return q * c[0] + x * c[1];
}

static double sum_at(const ix__shape *s, const double *c, const double *x,
                     double *grad, double *work)
{
    double sum = 0;

    for (int j = 0; j < s->n; j++)
        sum += line_at(c + s->stride[j], s->dims[j], x[j], &grad[j], work);
    return sum;
}

static bool few_layers(const ix__shape *s)
{
    for (int j = 0; j < s->n; j++)
        if (s->dims[j] > MAX_LAYERS)
            return false;
    return true;
}

double ix__tensor_value(const ix__shape *s, const double *c, const double *x,
                        double *work)
{
    double b[MAX_LAYERS], grad[IX_MAX_UNKNOWNS];

    if (s->sum)
        return sum_at(s, c, x, grad, work);
    if (!few_layers(s)) {
        memcpy(work, c, s->size * sizeof *c);
        for (int j = s->n - 1; j >= 0; j--)
            contract(work, s->stride[j], s->dims[j], x[j]);
        return work[0];
    }
    for (int j = s->n - 1; j >= 0; j--) {
        bernstein(s->dims[j], x[j], b, NULL);
        weigh(s->stride[j], s->dims[j], b, c, work);
        c = work;
    }
    return work[0];
}

/* By de Casteljau, for any number of layers. */
static double gradient_by_layers(const ix__shape *s, const double *c,
                                 const double *x, double *grad, double *work)
{
    double *w = work + s->size;
    size_t left = s->size;

    /* work: contracted in all directions above j; w: also in those below */
    memcpy(work, c, s->size * sizeof *c);
    for (int j = s->n - 1; j >= 0; j--) {
        size_t inner = s->stride[j];
        int m = s->dims[j];

        memcpy(w, work, left * sizeof *w);
        if (m > 1) {
            for (size_t i = 0; i < (size_t)(m - 1) * inner; i++)
                w[i] = (m - 1) * (w[i + inner] - w[i]);
            contract(w, inner, m - 1, x[j]);
        } else {
            memset(w, 0, inner * sizeof *w);
        }
        for (int k = j - 1; k >= 0; k--)
            contract(w, s->stride[k], s->dims[k], x[k]);
        grad[j] = w[0];
        contract(work, inner, m, x[j]);
        left = inner;
    }
    return work[0];
}

double ix__tensor_gradient(const ix__shape *s, const double *c, const double *x,
                           double *grad, double *work)
{
    double b[IX_MAX_UNKNOWNS][MAX_LAYERS], d[MAX_LAYERS];
    double *w = work + s->size;

    if (s->sum)
        return sum_at(s, c, x, grad, work);
    if (!few_layers(s))
        return gradient_by_layers(s, c, x, grad, work);
    for (int j = 0; j + 1 < s->n; j++)
        bernstein(s->dims[j], x[j], b[j], NULL);
    for (int j = s->n - 1; j >= 0; j--) {
        bernstein(s->dims[j], x[j], b[j], d);
        weigh(s->stride[j], s->dims[j], d, c, w);
        for (int k = j - 1; k >= 0; k--)
            weigh(s->stride[k], s->dims[k], b[k], w, w);
        grad[j] = w[0];
        weigh(s->stride[j], s->dims[j], b[j], c, work);
        c = work;
    }
    return work[0];
}

void ix__tensor_mean_gradient(const ix__shape *s, const double *c, double *grad)
{
    for (int j = 0; j < s->n; j++) {
        along l = layers_along(s, j);
        double sum = 0;

        for (const double *p = c + l.from; p < c + l.to; p += l.block)
            for (size_t i = 0; i < l.inner; i++)
                sum += p[(l.m - 1) * l.inner + i] - p[i];
        /* the mean of Bernstein coefficients is the mean of the function */
        grad[j] = sum * (double)l.m / (double)(l.to - l.from);
    }
}

void ix__tensor_slope_range(const ix__shape *s, const double *c, int j,
                            double *lo, double *hi)
{
    double a = HUGE_VAL, b = -HUGE_VAL;
    along l = layers_along(s, j);

    if (l.m == 1) {
        *lo = *hi = 0;
        return;
    }
    for (const double *p = c + l.from; p < c + l.to; p += l.block)
        for (size_t i = 0; i < (l.m - 1) * l.inner; i++) {
            double v = p[i + l.inner] - p[i];

            a = v < a ? v : a;
            b = v > b ? v : b;
        }
    *lo = a * (double)(l.m - 1);
    *hi = b * (double)(l.m - 1);
}

/* Range of each layer k along direction j. */
static void layer_ranges(const ix__shape *s, const double *c, int j, double *lo,
                         double *hi)
{
    along l = layers_along(s, j);
    double a = 0, b = 0, size;

    for (size_t k = 0; k < l.m; k++) {
        lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
    }
    for (const double *p = c + l.from; p < c + l.to; p += l.block)
        for (size_t k = 0; k < l.m; k++)
            for (size_t i = 0; i < l.inner; i++) {
                double v = p[k * l.inner + i];

                lo[k] = v < lo[k] ? v : lo[k];
                hi[k] = v > hi[k] ? v : hi[k];
            }
    if (s->sum)
        measure_without(s, c, j, &a, &b, &size);
    for (size_t k = 0; s->sum && k < l.m; k++) {
        lo[k] += a;
        hi[k] += b;
    }
}

/* Where the lower hull of the points (k / (m-1), v[k]) is <= 0; sign -1 asks
 * for the upper hull >= 0. Widened by 4 ulp for the rounding of the cut. */
static bool hull_cut(const double *v, int m, double sign, double *a, double *b)
{
    int first = -1, last = -1;
    double lo = 1, hi = 0, d = m - 1;

    for (int k = 0; k < m; k++)
        if (sign * v[k] <= 0) {
            first = first < 0 ? k : first;
            last = k;
        }
    if (first < 0)
        return false;
    lo = first == 0 ? 0 : first / d;
    hi = last == m - 1 ? 1 : last / d;
    for (int i = 0; i < m; i++)
        for (int k = first; k <= last; k++) {
            double f = sign * v[i], g = sign * v[k], x;

            if (!(f > 0) || g > 0 || i == k)
                continue;
            x = (i + (k - i) * (f / (f - g))) / d;
            if (i < k)
                lo = ix__smaller(lo, x);
            else
                hi = ix__larger(hi, x);
        }
    *a = ix__larger(*a, lo - 0x1p-50);
    *b = ix__smaller(*b, hi + 0x1p-50);
    return *a <= *b;
}

bool ix__tensor_clip(const ix__shape *s, const double *c, double err, int j,
                     double *a, double *b)
{
    double lo[MAX_LAYERS], hi[MAX_LAYERS];
    int m = s->dims[j];

    *a = 0;
    *b = 1;
    if (m == 1 || m > MAX_LAYERS) {
        double l, h;

        ix__tensor_range(s, c, &l, &h);
        return !(l > err) && !(h < -err);
    }
    layer_ranges(s, c, j, lo, hi);
    for (int k = 0; k < m; k++) {
        lo[k] -= err;
        hi[k] += err;
    }
    return hull_cut(lo, m, 1, a, b) && hull_cut(hi, m, -1, a, b);
}
