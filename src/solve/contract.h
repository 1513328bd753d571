/* contract.h - the test behind every proof of the solvers. */
#ifndef SOLVE_CONTRACT_H
#define SOLVE_CONTRACT_H

#include "solve/small.h"
#include "solve/tensor.h"

/* A bound of the largest row sum of |I - m J| over the box of n tensors
 * f[n][size], J their derivatives in the directions dir[n]. err[n] bounds the
 * errors of the coefficients, mag[n] their size: errors and the roundings of
 * the test itself are in the bound. Below 1, x -> x - m f(x) contracts. */
double ix__contraction(const ix__shape *s, int n, const int *dir,
                       const double *f, const double *err, const double *mag,
                       ix__mat m);

#endif
