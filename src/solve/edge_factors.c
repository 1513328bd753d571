/* edge_factors.c - powers of an edge divided out of a patch.
 *
 * A field that vanishes along an edge of its patch to the order k, as normals
 * do where a surface has a pole, is v^k g there: its zero set has the edge as a
 * multiple component, which no subdivision can decide. v g has the same zeros.
 *
 * Coefficients: v^k g with g of degree d - k has c_(i+k) = g_i C(d-k, i) /
 * C(d, i+k); one v given back, h_(i+1) = g_i C(d-k, i) / C(d-k+1, i+1). */
#include <math.h>

#include "bern/bern.h"
#include "solve/patches.h"

/* How many layers along j from the given end are zero to within err. */
static int zero_layers(const ix__shape *s, const double *c, int j, bool high,
                       double err)
{
    size_t inner = s->stride[j], m = (size_t)s->dims[j];

    for (size_t k = 0; k < m; k++)
        for (const double *p = c; p < c + s->size; p += inner * m)
            for (size_t i = 0; i < inner; i++)
                if (!(fabs(p[(high ? m - 1 - k : k) * inner + i]) <= err))
                    return (int)k;
    return (int)m;
}

/* The line of d + 1 coefficients at distance `step` from each other, seen from
 * the edge, by v^(k - 1), at the same degree. f[i] = C(d, i) / C(d - k + 1, i
 * - k + 1) for i >= k. */
static void divide_line(double *c, ptrdiff_t step, int d, int k,
                        const double *f)
{
    int n = d - k + 1;

    for (int i = k; i <= d; i++)
        c[(i - k + 1) * step] = f[i] * c[i * step];
    c[0] = 0;
    for (; n < d; n++) { /* raised by one degree */
        c[(n + 1) * step] = c[n * step];
        for (int i = n; i > 0; i--) {
            double t = (double)i / (n + 1);

            c[i * step] = t * c[(i - 1) * step] + (1 - t) * c[i * step];
        }
    }
}

/* The factors of divide_line; the largest, which multiplies errors. */
static double factors(int d, int k, double *f)
{
    double room[2][IX_MAX_ORDER], big = 1;
    const double *up = ix__binom(d, room[0]);
    const double *down = ix__binom(d - k + 1, room[1]);

    for (int i = k; i <= d; i++) {
        f[i] = up[i] / down[i - k + 1];
        big = ix__larger(big, f[i]);
    }
    return big;
}

static void divide(const ix__shape *s, double *c, int j, bool high, int k,
                   double *err)
{
    size_t inner = s->stride[j], m = (size_t)s->dims[j];
    ptrdiff_t step = high ? -(ptrdiff_t)inner : (ptrdiff_t)inner;
    double f[IX_MAX_ORDER];

    *err *= factors((int)m - 1, k, f);
    for (double *p = c; p < c + s->size; p += inner * m)
        for (size_t i = 0; i < inner; i++)
            divide_line(p + (high ? (m - 1) * inner : 0) + i, step, (int)m - 1,
                        k, f);
}

void ix__patch_simple_edges(const ix__shape *s, int neq, ix__box *b)
{
    for (int i = 0; i < neq; i++)
        for (int j = 0; j < s->n; j++)
            for (int high = 0; high <= 1; high++) {
                double *c = b->c + (size_t)i * s->size;
                int k = zero_layers(s, c, j, high != 0, b->err[i]);

                if (k > 1 && k < s->dims[j] && s->dims[j] <= IX_MAX_ORDER)
                    divide(s, c, j, high != 0, k, &b->err[i]);
            }
}
