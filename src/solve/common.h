/* common.h - whether a system's equations share a curve. */
#ifndef SOLVE_COMMON_H
#define SOLVE_COMMON_H

#include "solve/tensor.h"

/* x[n] moves to a point near it, if there is one, in which the n tensors
 * f[n][size] vanish and their gradients are dependent. work: 2 size. */
bool ix__common_point(const ix__shape *s, const double *f, double *x,
                      double *work);

/* Whether such points lie at both sides of x, where the null vector of the
 * Jacobian points: then they are a curve. By samples, not a proof: what is
 * told from it is only how finely the curve's boxes are worth halving. */
bool ix__common_curve(const ix__shape *s, const double *f, const double *x,
                      double *work);

#endif
