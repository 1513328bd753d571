/* basis.h - the weights with which control points enter a value.
 *
 * At one parameter at most order points of a direction matter: the window.
 * Its weights are B-spline (or Bernstein, or power) basis values, their
 * derivatives, or more generally the weights of a blossom value. */
#ifndef BSP_BASIS_H
#define BSP_BASIS_H

#include "bsp/knots.h"

/* First point (before wrapping) of the window that counts at t. */
int ix__basis_first(const ix_dir *dir, double t);

/* Weights of the points first .. first + order - 1 in the blossom value at
 * args[order - 1]: w[order]. Convex if every argument lies where de Boor's
 * algorithm has it, as when all equal a parameter of the window's span.
 * Not for the power basis. */
void ix__basis_blossom(const ix_dir *dir, int first, const double *args,
                       double *w);

/* k-th derivative (0: the value) of the window's basis at t: w[order]. */
void ix__basis_derive(const ix_dir *dir, int first, double t, int k, double *w);

/* All derivatives 0 .. k at once: w[k + 1][order]; the same bits, one pass. Not
 * for the power basis. */
void ix__basis_derivs(const ix_dir *dir, int first, double t, int k, double *w);

/* The same core on bare knots: weights of c[mu - d .. mu] in the blossom of
 * the span [knots[mu], knots[mu + 1]] (not empty) at args[d]: w[d + 1]. */
void ix__blossom_weights(const double *knots, int mu, int d, const double *args,
                         double *w);

#endif
