/* quad.h - adaptive quadrature of smooth functions with several components. */
#ifndef GEOM_QUAD_H
#define GEOM_QUAD_H

#include "base/ctx.h"

#define IX_QUAD_MAX 16 /* components */

/* Sets f[nf]; component 0 is non-negative and sets the scale of the error. */
typedef void (*ix__integrand)(void *arg, double t, double *f);

/* out[nf] = integral over [a, b], to rtol of component 0's (the others: in
 * proportion to their sizes). Integrable kinks are closed in upon, down to
 * intervals of 2^-48, and 10000 of them at most: where rounding makes rtol
 * impossible, the result is as good as the values are. Values that are not
 * finite make the result so. */
void ix__quad(ix__integrand f, void *arg, int nf, double a, double b,
              double rtol, double *out);

#endif
