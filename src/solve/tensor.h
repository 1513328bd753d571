/* tensor.h - Bernstein tensors on a box: what the subdivision solvers do with
 * them. A tensor of n directions has dims[j] = degree + 1 coefficients in
 * direction j, direction 0 fastest. Kernels: no allocation, cannot fail.
 *
 * A sum of functions of one unknown each, such as x(t) - y(r), is kept as such:
 * its coefficients would be sums of one coefficient of each line of dims[j]
 * numbers. Ranges, sizes and errors are those of these sums, which of two lines
 * are rounded once: their signs are exact. */
#ifndef SOLVE_TENSOR_H
#define SOLVE_TENSOR_H

#include <stddef.h>

#include "iritx/solve.h"

/* For numbers that are no NaN; unlike fmax and fmin no calls. */
static inline double ix__larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double ix__smaller(double a, double b)
{
    return a < b ? a : b;
}

typedef struct {
    int n; /* directions */
    int dims[IX_MAX_UNKNOWNS];
    size_t stride[IX_MAX_UNKNOWNS]; /* of a sum: where line j begins */
    size_t size; /* numbers: the product of dims, of a sum their sum */
    bool sum;
} ix__shape;

void ix__shape_init(ix__shape *s, int n, const int *dims);
/* Of at most two lines. */
void ix__shape_init_sum(ix__shape *s, int n, const int *dims);

/* The part over [a, 1] (low = false: [0, a]) of direction j, in place. */
void ix__tensor_cut(const ix__shape *s, double *c, int j, double a, bool low);
/* The part over [a, b], which may reach beyond [0, 1], in place. */
void ix__tensor_restrict(const ix__shape *s, double *c, int j, double a,
                         double b);
/* A bound of what restricting |c| to [a, b] within [0, 1] gives, at least as
 * large as the restricted c: times 3 (dims - 1) roundings for each of its two
 * passes it bounds the error that ix__tensor_restrict commits. */
double ix__tensor_restrict_size(const ix__shape *s, const double *c, int j,
                                double a, double b);
/* Value at x (in [0,1]^n or near), the other one with the gradient; work has
 * 2 size doubles. */
double ix__tensor_value(const ix__shape *s, const double *c, const double *x,
                        double *work);
double ix__tensor_gradient(const ix__shape *s, const double *c, const double *x,
                           double *grad, double *work);
/* The mean of the gradient over the box: exact, from the faces alone. */
void ix__tensor_mean_gradient(const ix__shape *s, const double *c,
                              double *grad);
/* Range of the coefficients. */
void ix__tensor_range(const ix__shape *s, const double *c, double *lo,
                      double *hi);
/* A bound of |coefficients|, of a sum also of what they are made of. */
double ix__tensor_size(const ix__shape *s, const double *c);
/* Both. */
void ix__tensor_measure(const ix__shape *s, const double *c, double *lo,
                        double *hi, double *size);
/* Moves constants from line to line of a sum until all but the last begin with
 * 0: as small as the function is. Nothing to do otherwise. */
void ix__tensor_center(const ix__shape *s, double *c);
/* The tensor that a sum is; out of the shape of ix__shape_init. */
void ix__tensor_expand(const ix__shape *sum, const double *c, double *out);
/* Range of the coefficients of the partial derivative in direction j. */
void ix__tensor_slope_range(const ix__shape *s, const double *c, int j,
                            double *lo, double *hi);
/* The part [*a, *b] of [0, 1] in direction j outside of which the function
 * (each coefficient known to within err) has no zero: the convex hull of the
 * control points seen along j, cut with zero. False: no zero at all. */
bool ix__tensor_clip(const ix__shape *s, const double *c, double err, int j,
                     double *a, double *b);

#endif
