/* form.c - scaling, elevation, partials and restriction of blocks of
 * homogeneous forms. Each kernel walks the rows of one block, inner numbers
 * at a time, so that tensors of any shape share the loops. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "bern/clones.h"

/* Four products or quotients at a time. */
#define BY_FOUR(n, op_four, op_one)      \
    do {                                 \
        size_t i = 0;                    \
                                         \
        for (; i + 4 <= (n); i += 4)     \
            *ix__vec(out + i) = op_four; \
        for (; i < (n); i++)             \
            out[i] = op_one;             \
    } while (0)

IX__CLONES void ix__bern_scale(size_t count, int d, size_t inner,
                               const double *row, const double *in, double *out)
{
    size_t n = (size_t)d + 1;

    if (d < 2) {
        if (in != out)
            memcpy(out, in, count * n * inner * sizeof *out);
        return;
    }
    for (size_t b = 0; b < count && inner == 1; b++, in += n, out += n)
        BY_FOUR(n, *ix__cvec(row + i) * *ix__cvec(in + i), row[i] * in[i]);
    for (size_t b = 0; b < count && inner > 1; b++)
        for (size_t k = 0; k < n; k++, in += inner, out += inner)
            BY_FOUR(inner, row[k] * *ix__cvec(in + i), row[k] * in[i]);
}

IX__CLONES void ix__bern_unscale(size_t count, int d, size_t inner,
                                 const double *row, const double *in,
                                 double *out)
{
    size_t n = (size_t)d + 1;

    if (d < 2) {
        if (in != out)
            memcpy(out, in, count * n * inner * sizeof *out);
        return;
    }
    for (size_t b = 0; b < count && inner == 1; b++, in += n, out += n)
        BY_FOUR(n, *ix__cvec(in + i) / *ix__cvec(row + i), in[i] / row[i]);
    for (size_t b = 0; b < count && inner > 1; b++)
        for (size_t k = 0; k < n; k++, in += inner, out += inner)
            BY_FOUR(inner, *ix__cvec(in + i) / row[k], in[i] / row[k]);
}

static inline void add_multiple(size_t n, double f, const double *x,
                                double *out)
{
    BY_FOUR(n, *ix__cvec(out + i) + f * *ix__cvec(x + i), out[i] + f * x[i]);
}

IX__CLONES void ix__bern_elevate(int d, int e, const double *row, size_t inner,
                                 const double *in, double *out)
{
    memset(out, 0, (size_t)(d + e + 1) * inner * sizeof *out);
    for (int k = 0; k <= d && inner == 1; k++)
        add_multiple((size_t)e + 1, in[k], row, out + k);
    for (int k = 0; k <= d && inner > 1; k++, in += inner, out += inner)
        for (int j = 0; j <= e; j++)
            add_multiple(inner, row[j], in, out + (size_t)j * inner);
}

void ix__bern_partial_u(int d, double f, size_t inner, const double *in,
                        double *out)
{
    for (int k = 0; k < d; k++)
        for (size_t i = 0; i < inner; i++)
            out[(size_t)k * inner + i] = f * (k + 1) *
                                         in[(size_t)(k + 1) * inner + i];
}

void ix__bern_partial_v(int d, double f, size_t inner, const double *in,
                        double *out)
{
    for (int k = 0; k < d; k++)
        for (size_t i = 0; i < inner; i++)
            out[(size_t)k * inner + i] = f * (d - k) *
                                         in[(size_t)k * inner + i];
}

void ix__bern_derive(int d, double f, size_t inner, const double *in,
                     double *out)
{
    for (int k = 0; k < d; k++) {
        const double *a = in + (size_t)k * inner;

        for (size_t i = 0; i < inner; i++)
            out[(size_t)k * inner + i] = f * ((k + 1) * a[inner + i] -
                                              (d - k) * a[i]);
    }
}

void ix__bern_integrate(int d, double f, const double *row, const double *row1,
                        size_t inner, const double *in, double *start,
                        double *out)
{
    memcpy(out, start, inner * sizeof *out);
    for (int k = 0; k <= d; k++) {
        const double *a = in + (size_t)k * inner;
        double *o = out + (size_t)(k + 1) * inner;

        for (size_t i = 0; i < inner; i++) {
            start[i] += f * (a[i] / row[k]) / (d + 1);
            o[i] = row1[k + 1] * start[i];
        }
    }
}

/* (1 - t) x + t y from the nearer of both, so that equal x and y give exactly
 * that: a constant stays what it is. */
static double mix(double x, double y, double t)
{
    return t <= 0.5 ? x + t * (y - x) : y + (1.0 - t) * (x - y);
}

/* b_k = sum over i <= k of C(k,i) / C(d,i) a_i: divide, then add d times. */
void ix__bern_from_power(int d, size_t inner, double *a)
{
    double binom = 1.0;

    for (int i = 1; i <= d; i++) {
        binom = binom * (d - i + 1) / i;
        for (size_t l = 0; l < inner; l++)
            a[(size_t)i * inner + l] /= binom;
    }
    for (int r = d; r >= 1; r--)
        for (int i = r; i <= d; i++)
            for (size_t l = 0; l < inner; l++)
                a[(size_t)i * inner + l] += a[(size_t)(i - 1) * inner + l];
}

/* One sweep of de Casteljau's rule over the rows 0 .. d, at parameter t:
 * row k becomes the blossom with t in k places (from below), or with t in
 * d - k places (from above). */
static void subdivide_low(int d, double t, size_t inner, double *x)
{
    for (int r = 1; r <= d; r++)
        for (int k = d; k >= r; k--) {
            double *p = x + (size_t)k * inner;

            for (size_t i = 0; i < inner; i++)
                p[i] = mix((p - inner)[i], p[i], t);
        }
}

static void subdivide_high(int d, double t, size_t inner, double *x)
{
    for (int r = 1; r <= d; r++)
        for (int k = 0; k <= d - r; k++) {
            double *p = x + (size_t)k * inner;

            for (size_t i = 0; i < inner; i++)
                p[i] = mix(p[i], (p + inner)[i], t);
        }
}

void ix__bern_restrict(int d, double a, double b, size_t inner,
                       const double *in, double *out)
{
    if (in != out)
        memcpy(out, in, (size_t)(d + 1) * inner * sizeof *out);
    if (fabs(b) >= fabs(1.0 - a)) {
        if (b != 1.0)
            subdivide_low(d, b, inner, out);
        if (a != 0.0)
            subdivide_high(d, a / b, inner, out);
    } else {
        subdivide_high(d, a, inner, out);
        if (b != 1.0)
            subdivide_low(d, (b - a) / (1.0 - a), inner, out);
    }
}

double ix__bern_value(int d, const double *c, double u, double v)
{
    double r = c[0], pw = 1.0;

    for (int k = 1; k <= d; k++) {
        pw *= u;
        r = r * v + c[k] * pw;
    }
    return r;
}

int ix__bern_variations(int n, const double *c, double band, bool *undecided)
{
    double last = 0.0;
    int count = 0;

    if (undecided)
        *undecided = false;
    for (int k = 0; k < n; k++) {
        if (!(fabs(c[k]) > band)) {
            if (undecided)
                *undecided = true;
            continue;
        }
        count += last != 0.0 && (c[k] > 0.0) != (last > 0.0);
        last = c[k];
    }
    return count;
}
