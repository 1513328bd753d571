/* truth.h - de Boor's rule and vectors in long double, by which definitions are
 * evaluated beside the library. */
#ifndef UNIT_OPS_TRUTH_H
#define UNIT_OPS_TRUTH_H

#include <string.h>

#include "mv/mv.h"

typedef long double real;

enum { MAX_DEGREE = 7 };

/* Homogeneous control points around one parameter, w first. */
typedef struct {
    int degree, dim;
    real knots[2 * MAX_DEGREE + 2], pts[MAX_DEGREE + 1][4];
} local;

/* The last knot of the span that holds t, by index. */
static inline int span_of(const ix_dir *d, double t)
{
    int j = d->order - 1;

    while (d->basis == IX_BSPLINE && j + 1 < d->length && d->knots[j + 1] <= t)
        j++;
    return j;
}

/* Knots around t; the index of the first control point. */
static inline int load_knots(const ix_dir *d, double t, local *o)
{
    int p = d->order - 1, j = span_of(d, t);

    o->degree = p;
    for (int i = 0; i < 2 * p + 2; i++)
        o->knots[i] = d->basis == IX_BSPLINE ? d->knots[j - p + i] : i > p;
    return j - p;
}

/* The n-th derivative of the homogeneous curve at t. */
static inline void derive_local(const local *c, int n, double t, real out[4])
{
    real q[MAX_DEGREE + 1][4];
    int p = c->degree;

    memset(out, 0, 4 * sizeof *out);
    if (n > p)
        return;
    memcpy(q, c->pts, sizeof q);
    for (int k = 0; k < n; k++) /* q becomes the points of the derivative */
        for (int i = p; i > k; i--)
            for (int a = 0; a < 4; a++)
                q[i][a] = (p - k) * (q[i][a] - q[i - 1][a]) /
                          (c->knots[i + p - k] - c->knots[i]);
    for (int k = n; k < p; k++)
        for (int i = p; i > k; i--) {
            real lo = c->knots[i], hi = c->knots[i + p - k];
            real u = (t - lo) / (hi - lo);

            for (int a = 0; a < 4; a++)
                q[i][a] = u * q[i][a] + (1 - u) * q[i - 1][a];
        }
    memcpy(out, q[p], 4 * sizeof *out);
}

static inline real dot(const real *a, const real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const real *a, const real *b, real *out)
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] -
                 a[(k + 2) % 3] * b[(k + 1) % 3];
}

static inline double largest(const double *v, int n)
{
    double big = 0;

    for (int i = 0; i < n; i++)
        big = fmax(big, v[i]);
    return big;
}

#endif
