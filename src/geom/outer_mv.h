/* outer_mv.h - equations in the parameters of two freeforms: tensors of which
 * each factor is known, so that no degree is raised. */
#ifndef GEOM_OUTER_MV_H
#define GEOM_OUTER_MV_H

#include "mv/mv.h"

/* x_a(t) w_b(r) - x_b(r) w_a(t) for coordinate k of both (0 if missing): a
 * polynomial scalar in the directions of a, then those of b; zero where the
 * projected coordinates agree. Power bases must be converted before. */
ix_status ix__outer_difference(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                               int k, ix_mv **out) IX_MUST_CHECK;

/* sum_k v[k] x_k + v[ncoords] w: the affine function of the coordinates (of
 * which there are at most 3 used), a polynomial scalar with m's directions. */
ix_status ix__affine_field(ix_ctx *ctx, const ix_mv *m, const double v[4],
                           ix_mv **out) IX_MUST_CHECK;

#endif
