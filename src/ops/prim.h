/* prim.h - primitives as surfaces, and the bisectors that do not reduce to a
 * point and something. */
#ifndef OPS_PRIM_H
#define OPS_PRIM_H

#include "iritx/ops_prim.h"

/* Right-handed axes with z along p->dir (unit vectors). */
typedef struct {
    double x[3], y[3], z[3];
} ix_prim_axes;
/* Err IX_EARG no direction. */
ix_status ix__prim_axes(ix_ctx *ctx, const ix_prim *p,
                        ix_prim_axes *out) IX_MUST_CHECK;
/* What belongs to p with its axis along z at the origin, where p has it. */
ix_status ix__prim_place(ix_ctx *ctx, const ix_prim *p, const ix_mv *local,
                         ix_mv **out) IX_MUST_CHECK;
/* A surface of revolution (planes: a square), as far as size. */
ix_status ix__prim_surface(ix_ctx *ctx, const ix_prim *p, double size,
                           ix_mv **out) IX_MUST_CHECK;

/* The cone of the points with equal angles to the half line from apex along u
 * and the cone around n with half the angle (degrees): both nappes. */
ix_status ix__prim_apex(ix_ctx *ctx, const double apex[3], const double n[3],
                        double degrees, const double u[3], double size,
                        ix_mv *out[2]) IX_MUST_CHECK;
/* Cylinders and cones: equal distances from tangent planes, over [0, 1]^2. */
ix_status ix__prim_tangents(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                            ix_mv **out) IX_MUST_CHECK;

/* --- special positions ------------------------------------------------------
 *
 * Directions (of length 1) whose sine is at most IX__PARALLEL count as
 * parallel: what is farther apart is still given to nine digits by the general
 * formulas. Lengths below IX__ONE_POINT of size and coordinates count as 0. */

#define IX__PARALLEL  1e-9
#define IX__ONE_POINT 1e-12

/* Up to four surfaces, references of the caller also when a function fails. */
typedef struct {
    int n;
    ix_mv *srf[4];
} ix__prim_set;

bool ix__prim_parallel(const double u[3], const double v[3]);
/* Whether gap counts as 0 between objects at p and q. */
bool ix__prim_touch(double gap, const double p[3], const double q[3],
                    double size);
/* The vector from the axis of a to q, at a right angle to it. */
void ix__prim_offset(const ix_prim *a, const double q[3], double out[3]);
bool ix__prim_is_coaxial(const ix_prim *a, const ix_prim *b, double size);

/* Adds a square of half the side size. */
ix_status ix__prim_plane(ix_ctx *ctx, const double at[3],
                         const double normal[3], double size,
                         ix__prim_set *s) IX_MUST_CHECK;
/* Err IX_EDOMAIN both are one plane. */
ix_status ix__prim_two_planes(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                              double size, ix__prim_set *s) IX_MUST_CHECK;
/* Nothing if they are skew. Err IX_EDOMAIN both are one line. */
ix_status ix__prim_flat_lines(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                              double size, ix__prim_set *s) IX_MUST_CHECK;
/* Nothing if q is not on the line. */
ix_status ix__prim_line_point(ix_ctx *ctx, const ix_prim *line,
                              const double q[3], double size,
                              ix__prim_set *s) IX_MUST_CHECK;
/* Lines and cylinders with parallel axes: a hyperbolic cylinder (a plane if the
 * radii are equal), an elliptic cylinder if one is inside the other, both if
 * they intersect. Err IX_EDOMAIN both are one. */
ix_status ix__prim_parallel_axes(ix_ctx *ctx, const ix_prim *a,
                                 const ix_prim *b, double size,
                                 ix__prim_set *s) IX_MUST_CHECK;
/* A line or cylinder and a plane parallel to it: parabolic cylinders, or a
 * plane where the axis is in the plane moved by the radius. */
ix_status ix__prim_axis_plane(ix_ctx *ctx, const ix_prim *axis,
                              const ix_prim *plane, double size,
                              ix__prim_set *s) IX_MUST_CHECK;
/* Cones that open the same way with one angle: a hyperbolic cylinder or a plane
 * if neither apex is inside the other cone, and the quartic of the points that
 * are inside one. Err IX_EDOMAIN nothing within size. */
ix_status ix__prim_equal_cones(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                               double size, ix__prim_set *s) IX_MUST_CHECK;
/* Cylinders and cones around one axis: cones, cylinders, planes. Err IX_EDOMAIN
 * both are one. */
ix_status ix__prim_coaxial(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                           double size, ix__prim_set *s) IX_MUST_CHECK;
/* Height of p->pos along a->dir above a->pos. */
double ix__prim_height(const ix_prim *a, const ix_prim *p);
/* A line, cylinder, cone or plane around the axis of a is n.X = h in the half
 * plane of radius and height: n[2] is h, positive distances are outside. */
void ix__prim_profile(const ix_prim *a, const ix_prim *p, double n[3]);
/* Adds the curve (radius, 0, height) turned about the axis. */
ix_status ix__prim_turned(ix_ctx *ctx, const ix_prim *axis,
                          const ix_mv *profile, ix__prim_set *s) IX_MUST_CHECK;
/* Adds the cone of the points with equal distances from both points of the half
 * plane; nothing if it is not within size. */
ix_status ix__prim_halfway(ix_ctx *ctx, const ix_prim *axis, const double f1[2],
                           const double f2[2], double size,
                           ix__prim_set *s) IX_MUST_CHECK;

/* --- tori -------------------------------------------------------------------
 */

/* A torus and a line, cylinder, cone or plane around its axis: parabolas,
 * turned. Err IX_EDOMAIN nothing within size. */
ix_status ix__prim_torus_line(ix_ctx *ctx, const ix_prim *torus,
                              const ix_prim *b, double size,
                              ix__prim_set *s) IX_MUST_CHECK;
/* Tori around one axis: the branch of a hyperbola (a line for one minor radius)
 * if neither is inside the other, an ellipse if they intersect or one is, both
 * turned. Err IX_EDOMAIN both are one; nothing within size. */
ix_status ix__prim_coaxial_tori(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                                double size, ix__prim_set *s) IX_MUST_CHECK;
/* A torus and a plane that is not at a right angle to its axis: on each side of
 * the plane on which the torus is, a biquadratic surface. */
ix_status ix__prim_torus_plane(ix_ctx *ctx, const ix_prim *torus,
                               const ix_prim *plane, double size,
                               ix__prim_set *s) IX_MUST_CHECK;

#endif
