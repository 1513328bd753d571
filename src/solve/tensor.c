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

void ix__tensor_cut(const ix__shape *s, double *c, int j, double a, bool low)
{
    size_t inner = s->stride[j], m = (size_t)s->dims[j];
    size_t block = inner * m;

    for (double *p = c; p < c + s->size; p += block)
        for (size_t k = 1; k < m; k++) {
            if (low)
                blend(p, m - k, inner, a);
            else
                blend_back(p + (k - 1) * inner, m - k, inner, a);
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
    size_t inner = s->stride[j], m = line.size;
    double w[MAX_LAYERS] = {0}, lo, hi;

    if (m > MAX_LAYERS) {
        ix__tensor_range(s, c, &lo, &hi);
        return ix__larger(-lo, hi);
    }
    for (const double *p = c; p < c + s->size; p += inner * m)
        for (size_t k = 0; k < m; k++)
            for (size_t i = 0; i < inner; i++)
                w[k] = fabs(p[k * inner + i]) > w[k] ? fabs(p[k * inner + i])
                                                     : w[k];
    ix__tensor_restrict(&line, w, 0, a, b);
    ix__tensor_range(&line, w, &lo, &hi);
    return hi * (1 + 8 * MAX_LAYERS * DBL_EPSILON);
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
    double b[MAX_LAYERS];

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
static void gradient_by_layers(const ix__shape *s, const double *c,
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
}

void ix__tensor_gradient(const ix__shape *s, const double *c, const double *x,
                         double *grad, double *work)
{
    double b[IX_MAX_UNKNOWNS][MAX_LAYERS], d[MAX_LAYERS];
    double *w = work + s->size;

    if (!few_layers(s)) {
        gradient_by_layers(s, c, x, grad, work);
        return;
    }
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
}

void ix__tensor_mean_gradient(const ix__shape *s, const double *c, double *grad)
{
    for (int j = 0; j < s->n; j++) {
        size_t inner = s->stride[j], m = (size_t)s->dims[j];
        double sum = 0;

        for (const double *p = c; p < c + s->size; p += inner * m)
            for (size_t i = 0; i < inner; i++)
                sum += p[(m - 1) * inner + i] - p[i];
        /* the mean of Bernstein coefficients is the mean of the function */
        grad[j] = sum * (double)m / (double)s->size;
    }
}

/* Four running extremes, so that they need not wait for each other. */
void ix__tensor_range(const ix__shape *s, const double *c, double *lo,
                      double *hi)
{
    double a[4] = {c[0], c[0], c[0], c[0]}, b[4] = {c[0], c[0], c[0], c[0]};
    size_t i = 0;

    for (; i + 4 <= s->size; i += 4)
        for (int k = 0; k < 4; k++) {
            a[k] = c[i + (size_t)k] < a[k] ? c[i + (size_t)k] : a[k];
            b[k] = c[i + (size_t)k] > b[k] ? c[i + (size_t)k] : b[k];
        }
    for (; i < s->size; i++) {
        a[0] = c[i] < a[0] ? c[i] : a[0];
        b[0] = c[i] > b[0] ? c[i] : b[0];
    }
    for (int k = 1; k < 4; k++) {
        a[0] = a[k] < a[0] ? a[k] : a[0];
        b[0] = b[k] > b[0] ? b[k] : b[0];
    }
    *lo = a[0];
    *hi = b[0];
}

void ix__tensor_slope_range(const ix__shape *s, const double *c, int j,
                            double *lo, double *hi)
{
    size_t inner = s->stride[j], m = (size_t)s->dims[j];
    double a = HUGE_VAL, b = -HUGE_VAL;

    if (m == 1) {
        *lo = *hi = 0;
        return;
    }
    for (const double *p = c; p < c + s->size; p += inner * m)
        for (size_t i = 0; i < (m - 1) * inner; i++) {
            double v = p[i + inner] - p[i];

            a = v < a ? v : a;
            b = v > b ? v : b;
        }
    *lo = a * (double)(m - 1);
    *hi = b * (double)(m - 1);
}

/* Range of each layer k along direction j. */
static void layer_ranges(const ix__shape *s, const double *c, int j, double *lo,
                         double *hi)
{
    size_t inner = s->stride[j], m = (size_t)s->dims[j];

    for (size_t k = 0; k < m; k++) {
        lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
    }
    for (const double *p = c; p < c + s->size; p += inner * m)
        for (size_t k = 0; k < m; k++)
            for (size_t i = 0; i < inner; i++) {
                double v = p[k * inner + i];

                lo[k] = v < lo[k] ? v : lo[k];
                hi[k] = v > hi[k] ? v : hi[k];
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
