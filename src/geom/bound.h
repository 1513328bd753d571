/* bound.h - pieces of a path as Bernstein polynomials, and how large such
 * polynomials can become: bounds, not samples. */
#ifndef GEOM_BOUND_H
#define GEOM_BOUND_H

#include "geom/path.h"

/* Bernstein coefficients of the axes over [t0, t1] of one span, on [0, 1]:
 * out[naxes][degree + 1]. */
void ix__path_restrict(const ix_path *p, int span, double t0, double t1,
                       double *out);

/* Coefficients of one polynomial over [a, b] of [0, 1]; out may be c. */
void ix__bernstein_restrict(int d, double a, double b, const double *c,
                            double *out);

/* Product of Bernstein polynomials, out[p + q + 1]; work[2 (p + q) + 64]. */
void ix__bernstein_mul(int p, const double *a, int q, const double *b,
                       double *work, double *out);
/* The same polynomial of degree d + e: out[d + e + 1]; work[2 (d + e) + 64]. */
void ix__bernstein_raise(int d, const double *a, int e, double *work,
                         double *out);

/* Bound of |(c_0(u), .., c_{n-1}(u))| over [0, 1]: the largest control vector
 * over eight equal parts; too large by a few percent for smooth ones.
 * c[n][d + 1], work[n][d + 1]. */
double ix__bernstein_max(int n, int d, const double *c, double *work);

/* Size of the work arrays for degree d. */
size_t ix__bernstein_work(int d);

#endif
