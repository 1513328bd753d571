/* contract.h - the test behind every proof of the solvers. */
#ifndef SOLVE_CONTRACT_H
#define SOLVE_CONTRACT_H

#include "solve/small.h"
#include "solve/tensor.h"

/* d[n][n]: bounds of the entries of |I - m J| over the box of n tensors
 * f[n][size], J their derivatives in the directions dir[n]; returns the
 * largest row sum. err[n] bounds the errors of the coefficients, mag[n] their
 * size: errors and the roundings of the test itself are in the bounds. Below
 * 1, x -> x - m f(x) contracts. */
double ix__contraction(const ix__shape *s, int n, const int *dir,
                       const double *f, const double *err, const double *mag,
                       ix__mat m, ix__mat d);

#endif
