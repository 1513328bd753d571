/* distance_bounds.h - how far the spans of a curve or the patches of a surface
 * are from the origin, by the Bernstein coefficients of the squared distance.
 */
#ifndef GEOM_DISTANCE_BOUNDS_H
#define GEOM_DISTANCE_BOUNDS_H

#include "sym/form.h"

/* Scratch. Squared distances, in the unit of the form. */
typedef struct {
    int n;        /* parts, those of direction 0 fastest */
    double *d;    /* [n]: no point of the part is nearer (farther) */
    double best;  /* the least (largest) at a corner of a part */
    int part;     /* that part, */
    int high;     /* and its corner: bit j is set at the end of direction j */
    double slack; /* by which rounding may have falsified any of them */
} ix__distance_bounds;

/* x: the rows are the coordinates, homogeneous ones if there is a weight w
 * (else NULL), of one or two directions. Where weights are not positive, the
 * bound is 0 (farthest: infinite). */
ix_status ix__distance_bounds_of(ix_ctx *ctx, const ix_form *x,
                                 const ix_form *w, bool farthest,
                                 ix__distance_bounds *out) IX_MUST_CHECK;

#endif
