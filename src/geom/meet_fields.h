/* meet_fields.h - intersections of surfaces that straight lines or circles
 * sweep out, in two unknowns: one curve parameter of each. */
#ifndef GEOM_MEET_FIELDS_H
#define GEOM_MEET_FIELDS_H

#include "iritx/mv.h"

/* F(u, v) = det(a2 - a1, b2 - b1, b1 - a1), which vanishes where the line
 * through a1(u), a2(u) meets that through b1(v), b2(v) or is parallel to it.
 * Polynomial; domains are those of a1 and b1 (a2 and b2 are mapped onto them).
 * Err IX_EARG not four curves of at most 3 coordinates; IX_EDOMAIN F is 0
 * everywhere (all lines meet). Src Heo, Kim & Elber 1999 */
ix_status ix__ruled_meet_field(ix_ctx *ctx, const ix_mv *const c[4],
                               ix_mv **out) IX_MUST_CHECK;

/* The points of the lines next to each other, halfway; false if they are
 * parallel or one of them is a point. */
ix_status ix__ruled_meet_point(ix_ctx *ctx, const ix_mv *const c[4], double u,
                               double v, double p[3], double along[2],
                               bool *found) IX_MUST_CHECK;

/* Circles about axis(u) in its normal plane with radius rad(u), of two ringed
 * surfaces (axis1, rad1, axis2, rad2): with T tangents, D = C2 - C1 and the
 * point C1 + Y of both planes and of the radical plane,
 *
 *   d Y = (D.T2) D x T1 + (|D|^2 + r1^2 - r2^2)/2 T1 x T2,  d = D.(T1 x T2)
 *   F(u, v) = |d Y|^2 - r1^2 d^2
 *
 * vanishes where the circles meet (Heo, Hong, Seong, Kim, Elber 2001). Where
 * both axes lie in one plane d is 0 everywhere: then F is the one component of
 * d Y, zero where the three planes share a line.
 * Errors as above; IX_EUNABLE parallel axes; IX_EARG a radius is rational;
 * radii are scalar curves on their axis' domain (mapped). */
ix_status ix__ring_meet_field(ix_ctx *ctx, const ix_mv *const c[4],
                              ix_mv **out) IX_MUST_CHECK;
/* The common point C1 + Y; *found false if it is not determined. The common
 * line has two, side -1 and 1; otherwise the point belongs to side 1. */
ix_status ix__ring_meet_point(ix_ctx *ctx, const ix_mv *const c[4], double u,
                              double v, int side, double p[3],
                              bool *found) IX_MUST_CHECK;

#endif
