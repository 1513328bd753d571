/* iso_curvature.h - level surfaces of a scalar function of three parameters. */
#ifndef GEOM_ISO_CURVATURE_H
#define GEOM_ISO_CURVATURE_H

#include "iritx/mv.h"

typedef struct {
    double gradient[3], hessian[9];
    bool regular;           /* the gradient does not vanish */
    double k[2], dir[2][3]; /* if regular: principal curvatures, k[0] >= k[1],
                               of the level surface for the normal along the
                               gradient, and unit directions */
} ix__level_point;

/* At t[3]. The curvature along a tangent d is -d.H d / |g|: a ball's level
 * surfaces are curved away from their outer normal, -1 / r.
 * Err IX_EARG not a polynomial scalar of three directions; IX_EDOMAIN outside
 */
ix_status ix__level_curvature(ix_ctx *ctx, const ix_mv *f, const double t[3],
                              ix__level_point *out) IX_MUST_CHECK;

#endif
