/* measure.c - the size of long rows of numbers. */
#include <limits.h>
#include <math.h>

#include "bern/bern.h"
#include "bern/clones.h"

typedef long long v4i __attribute__((vector_size(32), aligned(8), may_alias));

/* The larger of each pair into y; a NaN in x is passed over. */
IX__INLINE void take_larger(const ix__v4 *x, ix__v4 *y)
{
    v4i take = *x > *y;

    *y = (ix__v4)(((v4i)*x & take) | ((v4i)*y & ~take));
}

IX__CLONES double ix__bern_largest(size_t n, const double *x)
{
    const v4i abs = {LLONG_MAX, LLONG_MAX, LLONG_MAX, LLONG_MAX};
    ix__v4 a = {0}, b = {0};
    double big = 0.0;
    size_t i = 0;

    for (; i + 8 <= n; i += 8) {
        const v4i *y = (const v4i *)(const void *)(x + i);
        ix__v4 p = (ix__v4)(y[0] & abs), q = (ix__v4)(y[1] & abs);

        take_larger(&p, &a);
        take_larger(&q, &b);
    }
    take_larger(&b, &a);
    for (int k = 0; k < 4; k++)
        big = a[k] > big ? a[k] : big;
    for (; i < n; i++)
        big = fabs(x[i]) > big ? fabs(x[i]) : big;
    return big;
}

IX__CLONES bool ix__bern_finite(size_t n, const double *x)
{
    ix__v4 a = {0}, b = {0}; /* 0 x is 0, or NaN */
    double s = 0.0;
    size_t i = 0;

    for (; i + 8 <= n; i += 8) {
        const ix__v4 *y = ix__cvec(x + i);

        a += 0.0 * y[0];
        b += 0.0 * y[1];
    }
    a += b;
    for (; i < n; i++)
        s += 0.0 * x[i];
    return a[0] + a[1] + a[2] + a[3] + s == 0.0;
}

double ix__bern_weight_factor(size_t n, const double *w)
{
    double sum = 0.0;
    int e;

    for (size_t i = 0; i < n; i++)
        sum += w[i];
    (void)frexp(ix__bern_largest(n, w), &e);
    return ldexp(sum < 0.0 ? -1.0 : 1.0, -e);
}
