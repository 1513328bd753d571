/* gauss.h - Gauss-Legendre quadrature. */
#ifndef GEOM_GAUSS_H
#define GEOM_GAUSS_H

/* Nodes x[n] rising in [0, 1] and weights w[n], which add up to 1: exact for
 * polynomials of degree 2n - 1, to about 2 eps each. n >= 1. */
void ix__gauss(int n, double *x, double *w);

#endif
