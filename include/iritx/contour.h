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

#ifdef __cplusplus
}
#endif
#endif
