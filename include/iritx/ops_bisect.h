/* ops_bisect.h - bisectors of points, curves and surfaces.
 *
 * Curves may have any basis and any continuity, be polynomial or rational, and
 * are borrowed. x = p / w is a curve of degree d, ' = d/dt. Degrees are those
 * of generic input, polynomial / rational. */
#ifndef IRITX_OPS_BISECT_H
#define IRITX_OPS_BISECT_H

#include "iritx/geom.h"
#include "iritx/ops.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The untrimmed bisector of a planar curve and a point Q, or an alpha-sector.
 *
 *   B(t): (B - x).x' = 0,  (x - Q).(B - (alpha Q + (1 - alpha) x)) = 0
 *
 * the point of the curve's normal at t on the line at right angles to x - Q
 * that divides it in the ratio alpha : 1 - alpha from Q's end (alpha = 1/2:
 * equally far from Q and x). With r = p - w Q, D = p'w - pw' and the quarter
 * turn R,
 *
 *   B = Q + ((1 - alpha) |r|^2 R D - (r.D) R r) / (w det(D, r)).
 *
 * In    crv    2 or 3 coordinates; the third is dropped
 *       q      double[2]
 *       alpha  a finite number, 1/2 for the bisector
 *       o      degree: minimal 3d-1 / 4d-2, published 3d-1 / 4d-1, naive 3d-1
 *              / 8d, irit 3d-1 / 5d; NULL: minimal
 * Out   *out   P2 over the domain of crv, Bezier or B-spline as crv,
 *              continuity one less; the weights add up to a positive number.
 *              Where the tangent passes through Q the weight is zero: the
 *              bisector passes through infinity (ix_roots of axis 0 lists these
 *              poles). Where Q is on the curve weight and numerators have a
 *              common double zero, whose limit is the centre of curvature (of
 *              the bisector)
 *       rep    residual: distance from the two lines at nine parameters,
 *              relative; poles are left out
 * Err   IX_EARG    not a curve of 2 or 3 coordinates; q or alpha not finite
 *       IX_EDOMAIN a span is a straight line through Q (its bisector with Q is
 *                  at infinity) or a point: the message names the span
 *       IX_EUNABLE an order above IX_MAX_ORDER
 * Src   Farouki & Johnstone 1994, 2.2; Chen, Riesenfeld & Cohen 2005, 5 */
ix_status ix_pt_crv_bisector(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                             double alpha, const ix_op_opts *o, ix_report *rep,
                             ix_mv **out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
