/* contour.h - curves on a surface where a scalar field vanishes: contours,
 * silhouettes, isoclines. */
#ifndef IRITX_CONTOUR_H
#define IRITX_CONTOUR_H

#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a x + b y + c z + d = 0 on m (two directions; missing coordinates are
 * 0, so that a scalar surface takes part with its value as x). tol as in
 * ix_curves_opts. Result in the parameters of m, freed with
 * ix_solution_curves_free. */
ix_status ix_contour(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                     double tol, ix_solution_curves *out) IX_MUST_CHECK;

/* The scalar a x + b y + c z + d w (the numerator) with the directions of m. */
ix_status ix_contour_field(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                           ix_mv **out) IX_MUST_CHECK;

/* Where the normal of s is perpendicular to view. */
ix_status ix_silhouette(ix_ctx *ctx, const ix_mv *s, const double view[3],
                        double tol, ix_solution_curves *out) IX_MUST_CHECK;

/* Where the normal makes the angle theta (radians) with the line along view,
 * in either sense: <n, view>^2 = cos^2(theta) <n, n> <view, view>. */
ix_status ix_isocline(ix_ctx *ctx, const ix_mv *s, const double view[3],
                      double theta, double tol,
                      ix_solution_curves *out) IX_MUST_CHECK;
/* What is seen as silhouette when the surface turns about the axis through the
 * origin: <S x n, axis> = 0. */
ix_status ix_polar_silhouette(ix_ctx *ctx, const ix_mv *s, const double axis[3],
                              double tol,
                              ix_solution_curves *out) IX_MUST_CHECK;
/* Points of the implicit curve f(u, v) = 0 at which direction dir (0 or 1) is
 * stationary along it: f = df/d(other direction) = 0. Solutions (u, v). Err
 * IX_EARG f is not a scalar of two directions. */
ix_status ix_implicit_extremes(ix_ctx *ctx, const ix_mv *f, int dir,
                               ix_solutions *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
