/* ops_prim.h - bisectors of points, lines, planes, spheres, cylinders, cones
 * and tori. */
#ifndef IRITX_OPS_PRIM_H
#define IRITX_OPS_PRIM_H

#include "iritx/ops_bisect.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    IX_PRIM_POINT,
    IX_PRIM_LINE,
    IX_PRIM_PLANE,
    IX_PRIM_SPHERE,
    IX_PRIM_CYLINDER,
    IX_PRIM_CONE, /* the half that opens along dir */
    IX_PRIM_TORUS
} ix_prim_kind;

typedef struct {
    ix_prim_kind kind;
    double pos[3];  /* the point, one of the line, plane, axis; centre; apex */
    double dir[3];  /* of line and axes, normal of the plane; any length */
    double radius;  /* of sphere and cylinder; minor radius of the torus */
    double major;   /* major radius of the torus */
    double degrees; /* half the opening angle of the cone, 0 < .. < 90 */
} ix_prim;

/* The bisector of two primitives, as rational surfaces of the lowest degrees.
 *
 * A sphere shrinks to its centre, a cylinder or cone to its axis, while the
 * other grows or shrinks as much: what is left are
 *
 *   a surface or line and a point      ix_pt_srf_bisector, ix_pt_crv_bisector3d
 *   cones with one apex, among them lines and planes: a cone. Its rulings are
 *       the directions (u - e) x e', u the axis of one, e the circle that the
 *       other cuts out of the unit sphere
 *   cylinders and cones: the planes through axis and ruling of both, and equal
 *       distances from both tangent planes
 *   two lines, cylinders and tori with lines, cylinders and tori of the same
 *       (minor) radius: ix_cbisector3d of their spines
 *   a torus and a plane: with F the circle inside the torus and N its unit
 *       normal, F + k N / (1 - n.N), biquadratic; its weight is 0 in two points
 *       only, where N = n. One surface for each side of the plane that has a
 *       part of the torus
 *
 * Special positions (directions within 1e-9, lengths within 1e-12 of size) have
 * lower ones:
 *
 *   two planes, two lines in one plane, a line and a point on it: planes
 *   parallel lines and cylinders: a hyperbolic cylinder if they are apart, or a
 *       plane for one radius, an elliptic one if one is inside the other, both
 *       if they intersect; to the nearest feet
 *   a plane and a line, cylinder, ruling of a cone parallel to it: parabolic
 *       cylinders, of which some may be planes
 *   cylinders and cones around one axis: cones, cylinders, planes
 *   a torus and a line, cylinder, cone or plane around its axis: turned
 *       parabolas; two tori: a turned branch of a hyperbola or line, if they
 *       are apart, an ellipse, if one is inside the other, both if they
 *       intersect. Parts of positive radius, to the nearest feet
 *   cones that open the same way with one angle: a plane or a hyperbolic
 *       cylinder if neither apex is inside the other cone; a quartic of degree
 *       (2, 2) with the points that are inside one of them
 *
 * In    a, b   in any order, in any position
 *       size   > 0: how far unbounded primitives (from pos, both ways) or the
 *              bisecting cone (from its apex) go
 *       o      IX_FORM_IRIT: of a plane and a cone both nappes of one side;
 *              skew cylinders of one radius by tangent planes; in
 *              pairs with a sphere, and cones with one apex,
 *              the offset that IRIT has: that of a sphere inside the other (two
 *              spheres: outside; cones: |a1 - a2|). Else that of the actual
 *              position. Degrees are those of minimal forms, reduced
 * Out   *out   one to four surfaces (both nappes of a cone, one on each side of
 *              a plane, both signs of a special position, parts up to an axis);
 *              ix_crvs_free
 * Err   IX_EARG    size, radius, angle, direction out of range; a torus and,
 *                  not around its axis, a cone, or a line, cylinder or torus of
 *                  another radius
 *       IX_EDOMAIN both are the same; the same apex and point; nothing within
 *                  size; other positions without a bisector surface (the
 *                  message names them)
 * Src   Dutta & Hoffmann 1993; spec of IRIT's BSCT functions */
ix_status ix_prim_bisector(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                           double size, const ix_op_opts *o,
                           ix_crvs *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
