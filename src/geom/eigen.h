/* eigen.h - eigenvalues of small symmetric matrices. */
#ifndef GEOM_EIGEN_H
#define GEOM_EIGEN_H

/* Jacobi rotations (Golub and Van Loan 8.5). a: double[n][n] symmetric, is
 * destroyed; values[n] falling, vectors[n][n] with vector k in row k, of unit
 * length, its largest component positive. n <= 32. */
void ix__eigen_symmetric(int n, double *a, double *values, double *vectors);

#endif
