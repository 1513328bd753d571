/* visible.h - what is seen of planar curves, their convex hulls, and pairs of
 * their points by the angle between tangents. All in the XY plane. */
#ifndef IRITX_VISIBLE_H
#define IRITX_VISIBLE_H

#include "iritx/geom.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The parts of a curve from which nothing of it hides the viewer, in the order
 * of the parameter, with their intervals.
 *
 * In    crv      Bezier or B-spline; the pieces are B-splines on their
 *                intervals of its domain
 *       view     the viewer, or (point false) the direction towards it
 * Err   IX_EARG  not a planar curve, a direction of length 0; IX_EDOMAIN poles
 * Num   visibility changes at contours, behind them, behind corners and ends,
 *       and at crossings: between these places it is decided once. A straight
 *       part along the line of sight is not seen. What hides a point is
 *       at least 1e-9 of the size of the curve in front of it */
ix_status ix_crv_visible(ix_ctx *ctx, const ix_mv *crv, const double view[2],
                         bool point, ix_crvs *out) IX_MUST_CHECK;

/* The same of n curves that hide each other: out[n], those of each curve. What
 * is seen from the direction (0, -1) is their lower envelope; of parts that
 * several curves share each shows its own. */
ix_status ix_crvs_visible(ix_ctx *ctx, int n, const ix_mv *const *crv,
                          const double view[2], bool point,
                          ix_crvs *out) IX_MUST_CHECK;

/* The boundary of the convex hull of a closed curve, counter-clockwise: arcs of
 * the curve and straight bridges between them, in one B-spline.
 *
 * Err   IX_EARG  not a planar curve; IX_EDOMAIN not closed, poles, on one line
 * Num   ends of arcs are bitangents, tangents from corners, or corners, all to
 *       rounding; dents of less than 1e-9 of the size may stay */
ix_status ix_crv_hull(ix_ctx *ctx, const ix_mv *crv, ix_mv **out) IX_MUST_CHECK;

/* The scalar over (t, r) that vanishes where the tangent lines at t and r make
 * the angle theta (radians), T the tangents:
 *
 *   T(t) x T(r) for 0, T(t) . T(r) for a right angle (both to 1e-12), else
 *   (T(t) . T(r))^2 - cos^2(theta) |T(t)|^2 |T(r)|^2
 *
 * Err IX_EARG not a planar curve; IX_EDOMAIN it vanishes everywhere (a straight
 * line, by its angle) */
ix_status ix_crv_angle_field(ix_ctx *ctx, const ix_mv *crv, double theta,
                             ix_mv **out) IX_MUST_CHECK;
/* Its zeros as polylines (t, r, 0), without the diagonal t = r. tol as in
 * ix_curves_opts. Err also IX_EUNABLE the zeros are not known completely. */
ix_status ix_crv_angle_pairs(ix_ctx *ctx, const ix_mv *crv, double theta,
                             double tol, ix_lines *out) IX_MUST_CHECK;

/* Silhouettes and their shadows for all directions of view at once: polylines
 * (t, v, r). First those with r = t, where the tangent at C(t) has the
 * direction V(v), which points to the viewer; then those where that tangent,
 * the line of sight through the silhouette, meets the curve again at C(r).
 *
 * In    view  a planar curve whose position is the direction
 *       trim  only silhouettes that nothing hides, and of their shadows the
 *             first place behind them; lines end where that changes, to 2^-30
 * of a step of the polyline tol   as in ix_curves_opts Err   IX_EARG    not
 * planar Bezier or B-spline curves IX_EDOMAIN poles IX_EUNABLE the solution
 * curves are not known completely Src   the boundaries of visibility charts
 * (Elber, Sayegh, Barequet, Martin 2005) */
ix_status ix_crv_view_map(ix_ctx *ctx, const ix_mv *crv, const ix_mv *view,
                          bool trim, double tol, ix_lines *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
