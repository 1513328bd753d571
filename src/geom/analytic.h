/* analytic.h - points, lines, planes and circles: distances, nearest points,
 * intersections.
 *
 * A line is a point and a direction of any length; a plane is (A, B, C, D)
 * with A x + B y + C z + D = 0, of any length. Directions count as parallel
 * when the sine of their angle is below 1e-14, the rounding of its factors. */
#ifndef GEOM_ANALYTIC_H
#define GEOM_ANALYTIC_H

#include "base/ctx.h"

/* Nearest point of the line. Err IX_EARG the direction is zero. */
ix_status ix__line_foot(ix_ctx *ctx, const double p[3], const double at[3],
                        const double dir[3], double out[3]) IX_MUST_CHECK;
ix_status ix__line_dist(ix_ctx *ctx, const double p[3], const double at[3],
                        const double dir[3], double *out) IX_MUST_CHECK;
/* Not negative. Err IX_EARG the plane's normal is zero. */
ix_status ix__plane_dist(ix_ctx *ctx, const double p[3], const double plane[4],
                         double *out) IX_MUST_CHECK;
/* Err IX_EDOMAIN they are parallel (message: the distance, or "inside"). */
ix_status ix__line_plane(ix_ctx *ctx, const double at[3], const double dir[3],
                         const double plane[4], double out[3]) IX_MUST_CHECK;
/* The points of each line nearest to the other line; for parallel lines the
 * first line's own point and its foot, one of many pairs. */
ix_status ix__lines_near(ix_ctx *ctx, const double a[3], const double da[3],
                         const double b[3], const double db[3], double on_a[3],
                         double on_b[3]) IX_MUST_CHECK;
/* Through three points, unit normal by the right-hand rule. Err IX_EDOMAIN
 * they are on one line. */
ix_status ix__plane_through(ix_ctx *ctx, const double p[3][3],
                            double plane[4]) IX_MUST_CHECK;
/* Barycentric coordinates, of sum 1, of the point of the triangle's plane
 * nearest to q. Err IX_EDOMAIN the triangle is on one line. */
ix_status ix__barycentric(ix_ctx *ctx, const double p[3][3], const double q[3],
                          double out[3]) IX_MUST_CHECK;

typedef struct {
    double centre[3], normal[3], radius;
} ix__circle3;
/* The common points of two circles in space: *n = 0, 1 (they touch) or 2. In
 * one plane the first is to the left of the way from a's to b's centre.
 * tol: distance within which a point counts as lying on b, and circles as
 * touching. Err IX_EARG a normal is zero, a radius not positive; IX_EDOMAIN
 * the circles are one. */
ix_status ix__circles_meet(ix_ctx *ctx, const ix__circle3 *a,
                           const ix__circle3 *b, double tol, int *n,
                           double out[2][3]) IX_MUST_CHECK;

/* The two outer (or inner) common tangents of circles in planes z = const:
 * out[k] = tangent point on a, tangent point on b; k = 0 is to the left of
 * the way from a to b. Err IX_EARG a radius is negative; IX_EDOMAIN there are
 * none, with the distance that would be needed. */
ix_status ix__circles_tangents(ix_ctx *ctx, const double ca[3], double ra,
                               const double cb[3], double rb, bool outer,
                               double out[2][2][3]) IX_MUST_CHECK;

#endif
