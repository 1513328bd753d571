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

/* The part over `range` of the curve at parameter t. Level 0: the borders; 1:
 * in the middle of the domain; each further one in the middle of two curves of
 * lower levels. */
typedef struct {
    double t, range[2];
    int level;
} ix__iso_part;

/* As above, but curves are only where those around them are farther apart than
 * eps, measured exactly. part[*n] in scratch, by rising t, then range; the
 * borders and the middle are there as wholes. Err as above; IX_EUNABLE more
 * than 2^16 parts, or level 24 */
ix_status ix__iso_parts(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                        int *n, ix__iso_part **part) IX_MUST_CHECK;

/* The checks of both. */
ix_status ix__iso_check(ix_ctx *ctx, const ix_mv *s, double eps) IX_MUST_CHECK;

#endif
