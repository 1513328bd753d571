/* point_curves.h - curves of parameters that are a point in space. */
#ifndef GEOM_POINT_CURVES_H
#define GEOM_POINT_CURVES_H

#include "iritx/solve.h"

/* Removes the curves all of whose vertices, parameters first, first + 1 of
 * them, are one point of the surface m: edges that are its poles. Two points
 * are one within 1e-9 of the largest coordinate. Err IX_EDOMAIN a vertex is no
 * point of m. */
ix_status ix__drop_point_curves(ix_ctx *ctx, const ix_mv *m, int first,
                                ix_solution_curves *s) IX_MUST_CHECK;

#endif
