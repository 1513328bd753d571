/* gap.h - how far apart two freeforms are, parameter by parameter. */
#ifndef GEOM_GAP_H
#define GEOM_GAP_H

#include "iritx/mv.h"

/* A bound of |a - b| over their common parameters, of at most 3 coordinates.
 * The difference is a fraction with both weights: nearly equal ones are not
 * taken to be equal, as ix_sym_sub does it, which small gaps would show. Err
 * IX_EDOMAIN weights of both signs; those of ix_sym_mul */
ix_status ix__gap_bound(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        double *out) IX_MUST_CHECK;

#endif
