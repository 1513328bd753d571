/* ops_mbisect.h - bisectors that are not rational: equations between the
 * parameters of curves and surfaces, and their solutions.
 *
 * A sphere a.x + b + e |x|^2 = 0 meets a curve or surface P = (p, w) at a point
 * where (a, b, e) is orthogonal to its lift L = (w p, w^2, |p|^2), and touches
 * it where it is orthogonal to the derivatives of L as well. Conditions on
 * several objects are determinants of such rows; their solutions are triples
 * and pairs of feet of one sphere. All parameters are mapped to [0, 1]. */
#ifndef IRITX_OPS_MBISECT_H
#define IRITX_OPS_MBISECT_H

#include "iritx/ops_bisect.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The fields whose common zeros are the pairs of feet of spheres that touch a
 * curve and a surface, or two surfaces, in space.
 *
 *   curve(t), surface(u, v)      det(L, L_t, M, M_u, M_v) = 0
 *   surface(u, v), surface(r, s) det(L, L_u, L_v, M, M_r) = 0 and with M_s
 *
 * In    a, b   in any order; 2 or 3 coordinates
 * Out   *out   polynomial scalars over [0, 1]^3 in the order t, u, v, or over
 *              [0, 1]^4 in the order u, v, r, s; degrees for polynomial input
 *              3p-1 in t, 4q-1 in u and v (r, s: 3q-1, 3q); rational 4p-1, 6q-1
 *              (4q-1, 4q); *n of them, new references
 * Err   IX_EARG two curves (they have a rational bisector); other objects */
ix_status ix_mbisector_fields(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              ix_mv *out[2], int *n) IX_MUST_CHECK;

/* The rational bisector of objects whose directions add up to one less than the
 * dimension of their space: two curves in R^3, a curve and a surface in R^4,
 * two surfaces in R^5.
 *
 * Out   *out   rational, over the directions of a, then those of b, domains [0,
 *              1]
 * Err   IX_EARG other directions or coordinates; IX_EDOMAIN the weight
 * vanishes: both lie in one hyperplane */
ix_status ix_mbisector_exact(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             ix_mv **out) IX_MUST_CHECK;

/* Points equally far from both along normals. */
typedef struct {
    double uv[2]; /* foot on the surface (the first of two), its parameters */
    double on[2]; /* parameters on the other */
    double x[3];
} ix_bisector_point;

/* For each node of a grid of (n + 1)^2 parameters on the surface (the first of
 * two) all points of the bisector that have their foot there.
 *
 * Out   *out   array of *count, freed with ix_bisector_points_free; ordered by
 *              v, u, then parameters on the other
 * Err   as ix_mbisector_fields; IX_EARG n not in 1 .. 256 */
ix_status ix_mbisector_points(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              int n, ix_bisector_point **out,
                              int *count) IX_MUST_CHECK;
void ix_bisector_points_free(ix_ctx *ctx, ix_bisector_point *p, int count);

/* The points equally far, along normals, from three points, curves and surfaces
 * in any combination: curves, as polylines.
 *
 * In    m      2 or 3 coordinates; a curve of order 1 is a point
 *       tol    distance of the polylines from the curves, as a part of the
 *              domains and of the box, with steps of at most its square root;
 *              0: 1e-4
 *       box    lo[3], hi[3]; parts outside are left out
 * Out   *out   freed with ix_lines_free; *complete: every curve is there, but
 *              those smaller than 1e-6 of the box, and spheres than 1e-5
 * Err   IX_EARG other objects, tol, an empty box; IX_EDOMAIN two points are
 *       one; a direction in which an operand does not change
 * Num   boxes of centres with boxes of their feet, each left out, proven to
 *       hold one arc (in rounded arithmetic), or halved; curves followed by
 *       Newton's method, their vertices equally far to rounding. Stops with
 *       *complete false after some ten seconds of work, as if whole surfaces
 *       are equally far. Deterministic
 * Src   Krawczyk 1969, with one unknown as a parameter */
ix_status ix_trisector(ix_ctx *ctx, const ix_mv *const m[3], double tol,
                       const double box[6], ix_lines *out,
                       bool *complete) IX_MUST_CHECK;

/* A point of the plane equally far, along normals, from three objects. */
typedef struct {
    double center[2], foot[3][2], radius;
} ix_skeleton_point;

/* All points equally far from three planar points and curves.
 *
 * In    m      NULL: the point q[i]; else a curve, of which x and y count
 *       extent > 0: centres farther than this from the origin are left out
 *       eps    > 0: largest difference of two distances
 * Out   *out   array of *n, freed with ix_skeleton_points_free; *complete false
 *              if the search had to stop
 * Err   IX_EARG not curves; extent, eps */
ix_status ix_skeleton_points(ix_ctx *ctx, const ix_mv *const m[3],
                             const double q[3][2], double extent, double eps,
                             ix_skeleton_point **out, int *n,
                             bool *complete) IX_MUST_CHECK;
void ix_skeleton_points_free(ix_ctx *ctx, ix_skeleton_point *p, int n);

/* A point of R^n equally far, along normals, from n + 1 objects. */
#define IX_CENTRE_OBJECTS 6
typedef struct {
    double x[IX_CENTRE_OBJECTS - 1], radius;
    double t[IX_CENTRE_OBJECTS][2]; /* the feet's parameters; points: 0 */
} ix_centre;

/* The centres of all spheres of R^(n - 1) that pass through the points, and
 * touch the curves and surfaces, among n objects.
 *
 * In    n      3 .. IX_CENTRE_OBJECTS
 *       m      NULL: the point q[i] (n - 1 numbers each); else a curve or a
 *              surface with n - 1 coordinates
 * Out   *out   array of *count, freed with ix_centres_free; *complete false if
 *              the search had to stop: objects that share a sphere with a whole
 *              curve of centres, or that meet
 * Err   IX_EARG other objects; more than IX_MAX_UNKNOWNS parameters
 * Num   determinants of lifts (ix_solve); each result has equal distances,
 *       along normals, to 1e-7 of the radius
 * See   ix_skeleton_points */
ix_status ix_equidistant_centres(ix_ctx *ctx, int n, const ix_mv *const *m,
                                 const double *q, ix_centre **out, int *count,
                                 bool *complete) IX_MUST_CHECK;
void ix_centres_free(ix_ctx *ctx, ix_centre *p, int n);

#ifdef __cplusplus
}
#endif
#endif
