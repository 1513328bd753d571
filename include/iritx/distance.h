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

/* The same for the line through p in direction dir. Err IX_EARG dir is 0. */
ix_status ix_srf_line_feet(ix_ctx *ctx, const ix_mv *s, const double p[3],
                           const double dir[3],
                           ix_solutions *out) IX_MUST_CHECK;
ix_status ix_srf_line_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                              const double dir[3], bool farthest, double uv[2],
                              double *distance) IX_MUST_CHECK;

/* --- pairs of points of one curve ------------------------------------------
 */

/* Pairs t < r whose chord is normal to the curve at both ends: solutions
 * (t, r). Self-intersections, whose chord has no direction, are left out. The
 * factor t - r is divided out algebraically. Err IX_EARG not a Bezier or
 * B-spline curve. */
ix_status ix_crv_antipodal(ix_ctx *ctx, const ix_mv *c,
                           ix_solutions *out) IX_MUST_CHECK;
/* Pairs t < r with one tangent line in common, in the XY plane; (t - r)^2 is
 * divided out, inflections (where both points fall together) are left out. */
ix_status ix_crv_bitangents(ix_ctx *ctx, const ix_mv *c,
                            ix_solutions *out) IX_MUST_CHECK;

/* --- circles and light between curves ---------------------------------------
 */

/* Circles of a radius that touch two curves in the XY plane: solutions (t1, t2,
 * x, y) with the centre (x, y); each curve's whole carrier does not count, only
 * its interior and its ends where the circle touches them as part of it.
 * Circles that touch both twice over an arc are not isolated: complete is
 * false. Err IX_EARG not planar Bezier or B-spline curves, radius not
 * positive; IX_EDOMAIN poles of the first curve. */
ix_status ix_crv_tangent_circles(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                 double radius,
                                 ix_solutions *out) IX_MUST_CHECK;

/* Closed paths of light in the XY plane that bounce once on each of 2 to
 * IX_MAX_UNKNOWNS curves, in order, and return: solutions (t1, .., tn). Err
 * IX_EARG the number of curves, not planar Bezier or B-spline curves;
 * IX_EDOMAIN no tangent at a solution. */
ix_status ix_crv_ray_traps(ix_ctx *ctx, int n, const ix_mv *const *crv,
                           ix_solutions *out) IX_MUST_CHECK;

/* Light that bounces between two surfaces and returns: (u1, v1, u2, v2) whose
 * chord is normal to both; points in which they meet do not count. Err IX_EARG
 * not Bezier or B-spline surfaces of at most 3 coordinates. */
ix_status ix_srf_ray_traps(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           ix_solutions *out) IX_MUST_CHECK;

/* --- pairs of points of one surface -----------------------------------------
 */

/* Curves (u1, v1, u2, v2) of pairs of different parameters with one point: the
 * self-intersections of a surface, each once; tol as in ix_curves_opts. Every
 * point's meeting with itself is divided out algebraically, within a patch,
 * across common edges of patches and across seams. An edge that is one point
 * (a pole) is not looked at: points of it meet everywhere.
 *
 * Out   *out    freed with ix_solution_curves_free; complete is false if a pair
 *               of patches overlaps over an area, or nearly
 * Err   IX_EARG not a Bezier or B-spline surface of at most 3 coordinates and
 *               orders 2 or more
 * Num   pairs whose boxes of control points are apart are not looked at
 * Src   Pekerman, Elber & Kim 2008 (elimination of the diagonal) */
ix_status ix_srf_self_meet(ix_ctx *ctx, const ix_mv *srf, double tol,
                           ix_solution_curves *out) IX_MUST_CHECK;
/* Pairs (u1, v1, u2, v2) whose chord is normal to the surface at both ends,
 * each once; self-intersections are left out. Err as above. */
ix_status ix_srf_antipodal(ix_ctx *ctx, const ix_mv *srf,
                           ix_solutions *out) IX_MUST_CHECK;

/* --- curves along each other ------------------------------------------------
 */

typedef enum {
    IX_CRVS_SAME = 1, /* all of both */
    IX_CRVS_OVERLAP,
    IX_CRVS_DISTINCT
} ix_crvs_relation;
typedef struct {
    ix_crvs_relation relation;
    double a[2], b[2]; /* the overlap's ends on both (0 if there is none), b
                          falling if the curves run against each other */
} ix_overlap;

/* Where two curves of at most 3 coordinates lie on each other within eps, over
 * a length: the longest such part of a. Crossings and contacts do not count.
 * Err IX_EARG not two such curves; eps negative. */
ix_status ix_crv_overlap(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                         double eps, ix_overlap *out) IX_MUST_CHECK;

/* A point that two curves have in common. */
typedef struct {
    double t[2]; /* its parameters on both */
    double gap;  /* distance of the curves there: within eps */
    double sine; /* of the angle of the tangents; 0 where the curves touch */
} ix_meeting;
typedef struct {
    int n;
    ix_meeting *at; /* by increasing t[0], then t[1] */
    double eps;     /* what counts as one point: the rounding of both curves */
    bool complete;  /* false: so many pairs of pieces stay together that the
                       curves run along each other (ix_crv_overlap) */
} ix_meetings;

/* The points that two curves of at most 3 coordinates share, within the
 * rounding of their coordinates; ends and contacts count.
 *
 * Out   *out   freed with ix_meetings_free
 * Err   IX_EARG not two such curves
 * Num   two meetings on one pair of spans are told apart if their parameters
 *       differ by more than 2^-14 of the spans; at a contact of order k the
 *       parameters are known to the k-th root of eps */
ix_status ix_crv_meetings(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          ix_meetings *out) IX_MUST_CHECK;
void ix_meetings_free(ix_ctx *ctx, ix_meetings *m);

/* --- intersections in space ------------------------------------------------
 */

/* Curves (u1, v1, u2, v2) in which two surfaces meet, without edges that are
 * one point; tol as in ix_curves_opts; freed with ix_solution_curves_free.
 * Surfaces that coincide have no curves: what is open is reported as singular,
 * complete is false. */
ix_status ix_srf_srf_meet(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          double tol, ix_solution_curves *out) IX_MUST_CHECK;
/* Points in which a curve meets a surface: solutions (t, u, v). */
ix_status ix_crv_srf_meet(ix_ctx *ctx, const ix_mv *c, const ix_mv *s,
                          ix_solutions *out) IX_MUST_CHECK;
/* Points that three surfaces share: (u1, v1, u2, v2, u3, v3). */
ix_status ix_srf3_meet(ix_ctx *ctx, const ix_mv *const s[3],
                       ix_solutions *out) IX_MUST_CHECK;

/* Where the ray p + t d, t >= 0, meets a surface: solutions (u, v, t) by
 * increasing t. Err IX_EARG d is 0, not a Bezier or B-spline surface. */
ix_status ix_srf_ray(ix_ctx *ctx, const ix_mv *s, const double p[3],
                     const double d[3], ix_solutions *out) IX_MUST_CHECK;

/* --- distances of two freeforms --------------------------------------------
 */

typedef struct {
    double distance; /* of the points at a[] and b[]: attained */
    double error;    /* the true value differs by no more than this */
    double a[2], b[2];
} ix_distance;

/* The least distance of two curves or surfaces of at most 3 coordinates with
 * positive weights (an order 1 curve is a point). Boxes are excluded by bounds
 * along the direction between their middles, which close in quadratically.
 *
 * Err   IX_EARG     more directions or coordinates
 *       IX_EUNABLE  a weight is not positive */
ix_status ix_distance_least(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            ix_distance *out) IX_MUST_CHECK;
/* The largest distance of a point of a from b (one_sided), or the Hausdorff
 * distance: the larger of both directions. Each bound is the distance of a
 * box from the foot of its middle. Errors as above. */
ix_status ix_distance_hausdorff(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                bool one_sided, ix_distance *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
