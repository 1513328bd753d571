/* iso_curves.h - isoparametric curves so dense that neighbours are near. */
#ifndef GEOM_ISO_CURVES_H
#define GEOM_ISO_CURVES_H

#include "iritx/mv.h"

/* Parameters of direction dir, halved until the curves of s at neighbours are
 * nowhere farther than eps from each other at equal parameters (a bound by
 * control points). t[*n] in scratch, rising, the domain's ends included.
 * Err IX_EARG not a surface of at most 3 coordinates, eps not positive;
 * IX_EDOMAIN poles; IX_EUNABLE more than 4096 pieces */
ix_status ix__iso_params(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                         int *n, double **t) IX_MUST_CHECK;

#endif
