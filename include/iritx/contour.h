/* contour.h - curves on a surface where a scalar field vanishes: contours,
 * silhouettes, isoclines. */
#ifndef IRITX_CONTOUR_H
#define IRITX_CONTOUR_H

#include "iritx/geom.h"
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

/* The same for what is to be drawn on another surface with these parameters:
 * within tol of its size there, too, and without edges that are one point of
 * it. on NULL: in the plane of the parameters; ix_contour: on m, unless that is
 * a scalar. */
ix_status ix_contour_on(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                        const ix_mv *on, double tol,
                        ix_solution_curves *out) IX_MUST_CHECK;

/* The scalar a x + b y + c z + d w (the numerator) with the directions of m. */
ix_status ix_contour_field(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                           ix_mv **out) IX_MUST_CHECK;

/* Where the normal of s is perpendicular to view. Edges that are one point of
 * s, where there is no normal, are left out, here and below. */
ix_status ix_silhouette(ix_ctx *ctx, const ix_mv *s, const double view[3],
                        double tol, ix_solution_curves *out) IX_MUST_CHECK;

/* Where the normal makes the angle theta (radians) with the line along view,
 * in either sense: <n, view>^2 = cos^2(theta) <n, n> <view, view>. */
ix_status ix_isocline(ix_ctx *ctx, const ix_mv *s, const double view[3],
                      double theta, double tol,
                      ix_solution_curves *out) IX_MUST_CHECK;
/* The field of the isocline, the left side less the right one: positive where
 * the angle with that line is less than theta. Where theta is a right angle (to
 * 1e-12), <n, view> itself. Err IX_EARG view is 0. */
ix_status ix_isocline_field(ix_ctx *ctx, const ix_mv *s, const double view[3],
                            double theta, ix_mv **out) IX_MUST_CHECK;

/* Ruled surfaces of constant slope that go on from the isocline of theta
 * (radians) where s is left, tangent to s: into the part where the angle is
 * less (below) or more than theta. A ruling is the line of steepest slope in
 * the tangent plane; it ends at the level, along view, of the farthest control
 * point of s. tol as in ix_curves_opts.
 *
 * Out   *out  lines 2 i (points of s) and 2 i + 1 (ends of the rulings) of as
 *             many points, in pieces where the rulings change sides; freed with
 *             ix_lines_free
 * Err   IX_EARG theta is 0 or 180 degrees, view is 0; IX_EDOMAIN no normal at a
 *       point of the isocline, a control point at infinity */
ix_status ix_isocline_drafts(ix_ctx *ctx, const ix_mv *s, const double view[3],
                             double theta, bool below, double tol,
                             ix_lines *out) IX_MUST_CHECK;

/* Where the scalar f is positive: closed polylines (u, v, 0), first vertex =
 * last, that are to be filled by parity (a point is inside if a ray from it
 * crosses them an odd number of times); tol as in ix_curves_opts.
 *
 * Err   IX_EARG     not a scalar surface
 *       IX_EUNABLE  f jumps, vanishes over an area, or its zeros are not known
 *                   completely */
ix_status ix_positive_region(ix_ctx *ctx, const ix_mv *f, double tol,
                             ix_lines *out) IX_MUST_CHECK;

/* Parts of a surface, each with a direction that its normals are near to. */
typedef struct {
    double dir[3];   /* unit */
    ix_lines border; /* closed, as of ix_positive_region */
} ix_view_region;
typedef struct {
    int n;
    ix_view_region *region;
    size_t bytes;
} ix_view_regions;
void ix_view_regions_free(ix_ctx *ctx, ix_view_regions *r);

/* Few directions such that every normal (S_v x S_u) is within
 * angle of one of them, and where it is: the regions cover the surface, and
 * overlap.
 *
 * In    cells  1 .. 100: the domain is cut into about cells x cells first, then
 *              further while normals of a cell spread by more than angle / 3
 *       angle  0.001 to a right angle (radians)
 *       tol    of the borders, as in ix_curves_opts
 * Out   *out   by direction; where an edge of the surface is one point, or its
 *              field of normals jumps at knots (rational surfaces), every patch
 *              has regions of its own
 * Err   IX_EARG    not a surface in space, power basis, cells, angle
 *       IX_EDOMAIN a patch without normals
 *       IX_EUNABLE more than 2000 directions or 20000 cells are needed; as
 *                  ix_positive_region
 * Num   covered for certain: cells are bounded, not sampled; the number of
 *       directions is that of a greedy choice
 * Src   Elber and Cohen 1995 (visibility by Gauss maps) */
ix_status ix_srf_view_regions(ix_ctx *ctx, const ix_mv *srf, int cells,
                              double angle, double tol,
                              ix_view_regions *out) IX_MUST_CHECK;

/* What is seen as silhouette when the surface turns about the axis through the
 * origin: <S x n, axis> = 0. */
ix_status ix_polar_silhouette(ix_ctx *ctx, const ix_mv *s, const double axis[3],
                              double tol,
                              ix_solution_curves *out) IX_MUST_CHECK;
/* Points (u, v) of the silhouette at which the view is an asymptotic direction:
 * its image has a cusp or an inflection there. Err IX_EARG view is 0, not a
 * Bezier or B-spline surface; IX_EDOMAIN the view lies in all tangent planes.
 */
ix_status ix_silhouette_inflections(ix_ctx *ctx, const ix_mv *s,
                                    const double view[3],
                                    ix_solutions *out) IX_MUST_CHECK;
/* Points of the implicit curve f(u, v) = 0 at which direction dir (0 or 1) is
 * stationary along it: f = df/d(other direction) = 0. Solutions (u, v). Err
 * IX_EARG f is not a scalar of two directions. */
ix_status ix_implicit_extremes(ix_ctx *ctx, const ix_mv *f, int dir,
                               ix_solutions *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
