/* small.h - linear algebra on matrices of at most 6 x 6, row-major with rows
 * of IX_MAX_UNKNOWNS. Kernels: no allocation. */
#ifndef SOLVE_SMALL_H
#define SOLVE_SMALL_H

#include "iritx/solve.h"

typedef double ix__mat[IX_MAX_UNKNOWNS][IX_MAX_UNKNOWNS];

/* Inverse by Gauss-Jordan elimination with full row pivoting after scaling of
 * the rows; false if the smallest pivot is below 1e-9 of the largest: then a
 * preconditioner from it would do harm. */
bool ix__small_invert(int n, ix__mat a, ix__mat inv);

/* Orthogonal rows that span what a's rows span, the most degenerate combination
 * last: u = transposed left singular vectors of a (one-sided Jacobi). */
void ix__small_left_vectors(int n, ix__mat a, ix__mat u);

#endif
