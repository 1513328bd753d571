/* distance.h - feet of perpendiculars, distances, tangents from a point and
 * intersections of curves and surfaces, all through the solver.
 *
 * Points and lines are given in three coordinates; a curve of fewer lies in
 * the plane of those it has, the missing ones being 0. */
#ifndef IRITX_DISTANCE_H
#define IRITX_DISTANCE_H

#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Parameters where the distance from p (dir NULL) or from the line p + s dir is
 * stationary: (C - p) . C' = 0 with C - p taken perpendicular to dir. Corners
 * at which the distance has an extremum are roots of kind IX_ROOT_JUMP, an
 * arc at constant distance is one of kind IX_ROOT_INTERVAL. The ends of the
 * curve are not included.
 *
 * Out   *roots   array of *n, freed with ix_roots_free
 * Err   IX_EARG  not a curve of at most 3 coordinates; dir is zero
 * Num   a field of degree 2d - 1, or 3d - 2 for a rational curve */
ix_status ix_crv_feet(ix_ctx *ctx, const ix_mv *c, const double p[3],
                      const double *dir, ix_root **roots, int *n) IX_MUST_CHECK;

/* The nearest (or farthest) point of the whole curve, its ends included; of
 * several the one with the smallest parameter. Errors as above; IX_EDOMAIN if
 * the curve has a pole there. */
ix_status ix_crv_nearest(ix_ctx *ctx, const ix_mv *c, const double p[3],
                         const double *dir, bool farthest, double *t,
                         double *distance) IX_MUST_CHECK;

/* Parameters where the tangent line passes through p, in the XY plane. */
ix_status ix_crv_tangents_from(ix_ctx *ctx, const ix_mv *c, const double p[3],
                               ix_root **roots, int *n) IX_MUST_CHECK;

/* 1 if p is inside the closed planar curve c (the sum of its turns around p is
 * not 0), 0 on it (within eps), -1 outside. Err IX_EDOMAIN c is not closed. */
ix_status ix_crv_encloses(ix_ctx *ctx, const ix_mv *c, const double p[3],
                          double eps, int *where) IX_MUST_CHECK;

/* Intersections of two curves in the XY plane: solutions (t, r), freed with
 * ix_solutions_free. Tangential contacts are not certified. */
ix_status ix_crv_crv_meet(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          const ix_solve_opts *o,
                          ix_solutions *out) IX_MUST_CHECK;

/* Self-intersections of a curve in the XY plane: solutions (t, r), t < r. The
 * factor t - r is divided out algebraically, so that no solution lies on the
 * diagonal, and none is lost near it; the two ends of a closed curve do not
 * count. Err IX_EARG not a Bezier or B-spline curve of 2 or more coordinates.
 */
ix_status ix_crv_self_meet(ix_ctx *ctx, const ix_mv *c,
                           ix_solutions *out) IX_MUST_CHECK;

/* The nearest (or farthest) point of a surface, its boundary included:
 * uv[2], *distance. Err IX_EARG not a surface of at most 3 coordinates. */
ix_status ix_srf_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                         bool farthest, double uv[2],
                         double *distance) IX_MUST_CHECK;
/* Interior points where the distance from p is stationary: solutions (u, v). */
ix_status ix_srf_feet(ix_ctx *ctx, const ix_mv *s, const double p[3],
                      ix_solutions *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
