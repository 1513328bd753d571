/* enclose.h - least circles, spheres and cones that hold points, vectors or
 * curves. */
#ifndef IRITX_ENCLOSE_H
#define IRITX_ENCLOSE_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    double center[3], radius;
} ix_ball;

/* The smallest sphere that holds n points (of which in the plane the smallest
 * circle).
 *
 * Err   IX_EARG no points, something not finite
 * Num   points lie inside to 1e-12 of the radius; O(n) a step, few steps
 * Src   an LP-type problem: the ball of at most four support points, exchanged
 *       for the farthest point until none is outside (Sharir and Welzl 1992) */
ix_status ix_ball_of_points(ix_ctx *ctx, int n, const double (*p)[3],
                            ix_ball *out) IX_MUST_CHECK;

/* The smallest circle in the XY plane that holds n curves, exactly: the
 * farthest points from the centre are found on the curves themselves.
 *
 * Err   IX_EARG no curves, not curves of at most 3 coordinates; IX_EDOMAIN
 *       poles
 * Num   the curves lie inside to 1e-12 of the radius */
ix_status ix_ball_of_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                            ix_ball *out) IX_MUST_CHECK;

/* The narrowest cone that holds n directions: unit axis and half angle
 * (radians).
 *
 * Err   IX_EARG no vectors, one of length 0; IX_EDOMAIN they do not fit into
 *       an open half space */
ix_status ix_cone_of_vectors(ix_ctx *ctx, int n, const double (*v)[3],
                             double axis[3], double *angle) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
