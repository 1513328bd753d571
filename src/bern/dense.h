/* dense.h - small dense matrices by columns: Householder QR, singular values.
 *
 * A matrix m x n is double[n][m], one column after the other. Nothing is
 * allocated; nothing can fail. */
#ifndef BERN_DENSE_H
#define BERN_DENSE_H

/* a = QR in place, m >= n: R in and above the diagonal, the reflectors
 * (v_0 = 1) below, their factors in tau[n]. */
void ix__dense_qr(int m, int n, double *a, double *tau);

/* b[m] = transposed Q times b. */
void ix__dense_apply(int m, int n, const double *a, const double *tau,
                     double *b);

/* Solves R x = b in place, b[n]; false if R is singular to the last bit. */
int ix__dense_solve(int m, int n, const double *a, double *b);

/* Smallest singular value of R, to about 10 %, by inverse iteration; x has
 * room for n. */
double ix__dense_smallest(int m, int n, const double *a, double *x);

/* Singular values s[n], decreasing, and right singular vectors v double[n][n]
 * of a (m x n), by Jacobi rotations of its columns; a becomes U times S. */
void ix__dense_singular(int m, int n, double *a, double *s, double *v);

#endif
