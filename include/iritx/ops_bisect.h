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

/* How the bisector surface of a curve and a point in space is ruled: each line
 * of centres, the intersection of the normal plane of x and the plane that
 * divides x - Q, is given a parameter. */
typedef enum {
    IX_RULING_PLANES,   /* by planes at right angles to a fixed direction n:
                           n.(B - Q) = h ("direct": no directrix) */
    IX_RULING_DIRECTRIX /* B = R(t) + h E(t): R the point of the line next to
                           Q, E = (x - Q) x x'
                           (w^2 times that in IX_FORM_PUBLISHED) */
} ix_ruling_kind;

typedef struct {
    ix_ruling_kind kind;
    double range[2];  /* of h; equal: the default, half the size of the box of
                         curve and point to both sides, or -1/2 .. 1/2 */
    double normal[3]; /* n of IX_RULING_PLANES, any length; zero: chosen, so
                         that no ruling is parallel to the planes if possible */
} ix_ruling;

/* The ruled bisector surface of a space curve and a point Q, or an
 * alpha-sector.
 *
 *   B(t, v): (B - x).x' = 0, (x - Q).(B - (alpha Q + (1 - alpha) x)) = 0
 *
 * In    crv    2 or 3 coordinates (a missing one is 0)
 *       q      double[3]
 *       alpha  1/2 for the bisector
 *       r      how it is ruled; NULL: planes, default range
 *       o      degree in t with
 *                            planes            directrix
 *                minimal     3d-1 / 4d-2       max(5d-3, 6d-6) / 6d-4
 *                published   3d-1 / 4d-1       7d-3 / 10d-3
 *                naive       7d-3 / 17d, by a directrix
 *                irit        7d-3 / 12d, by a directrix
 *              NULL: minimal
 * Out   *out   P3; direction 0 over the domain of crv, direction 1 linear over
 *              [0, 1], h = range[0] + v (range[1] - range[0]). The weight does
 *              not depend on v. It is zero (a pole: ix_roots of axis 0 of an
 *              isoparametric curve lists them) where the tangent passes through
 *              Q, and with planes also where a ruling is parallel to them:
 *              ix_pt_crv_bisector3d_pieces has other planes there
 *       rep    residual: distance from the two planes, on both boundary rulings
 *              at nine parameters, relative; poles are left out
 * Err   as ix_pt_crv_bisector; IX_EARG range or normal not finite;
 *       IX_EDOMAIN all rulings of a span are parallel to the given planes
 * Src   Elber & Kim 1998, 3.1; Chen, Riesenfeld & Cohen 2005, 5.2 */
ix_status ix_pt_crv_bisector3d(ix_ctx *ctx, const ix_mv *crv, const double q[3],
                               double alpha, const ix_ruling *r,
                               const ix_op_opts *o, ix_report *rep,
                               ix_mv **out) IX_MUST_CHECK;
/* The same with planes, in as many pieces as it takes to keep every ruling at
 * more than 11 degrees from its planes (one if possible): surfaces with the
 * intervals of t that they belong to. r->normal is not looked at, r->kind
 * IX_RULING_DIRECTRIX gives one piece. */
ix_status ix_pt_crv_bisector3d_pieces(ix_ctx *ctx, const ix_mv *crv,
                                      const double q[3], double alpha,
                                      const ix_ruling *r, const ix_op_opts *o,
                                      ix_crvs *out) IX_MUST_CHECK;

/* An alpha-sector of two space curves as IRIT defines it.
 *
 *   B(s, t): (B - C1).C1' = 0, (B - C2).C2' = 0,
 *            (C2 - C1).(B - ((1 - alpha) C1 + alpha C2)) = 0
 *
 * the bisector (ix_cbisector3d) for alpha = 1/2; otherwise the distances from
 * both curves have no constant ratio (ix_ratio_sector has).
 *
 * In    alpha  finite; 0 passes through C1, 1 through C2
 *       o      degree in a curve's own direction 3d-1 / 4d-2; published 3d-1 /
 *              4d-1, naive 3d-1 / 6d-2, irit 3d-1 / 5d as ix_cbisector3d
 * Out, Err     as ix_cbisector3d, and IX_EARG a ratio that is not finite
 * Src   Elber & Kim 1998, equations (4)-(6) */
ix_status ix_calphasector3d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                            double alpha, const ix_op_opts *o, ix_report *rep,
                            ix_mv **out) IX_MUST_CHECK;

/* The bisector of a surface and a point Q.
 *
 *   B(u, v) = S + lambda n, |B - S| = |B - Q|, n normal to the surface
 *
 * In    srf   2 or 3 coordinates, any basis but powers
 *       q     double[3]
 *       o     degree in a direction of degree d: 4d-1 / 5d-2, naive and irit
 *             4d-1 / 8d (published: minimal)
 * Out   *out  P3 over the domain of srf; weights add up to a positive number.
 *             The weight is zero where the tangent plane passes through Q (a
 *             pole) and where there is no normal
 *       rep   residual: equal distances along the normal on a 5 x 5 grid,
 *             relative; poles are left out
 * Num   in the surface's own frame: a few roundings (rational: 100) of the
 *       largest of B, its coordinates and its size, however far Q is
 * Err   IX_EARG    not a surface of 2 or 3 coordinates; q not finite
 *       IX_EDOMAIN the normal vanishes identically; all tangent planes pass
 *                  through Q: a plane through it, a cone with that apex
 * Src   IRIT's SBISECTOR; the degree by minors of (P, P_u, P_v) */
ix_status ix_pt_srf_bisector(ix_ctx *ctx, const ix_mv *srf, const double q[3],
                             const ix_op_opts *o, ix_report *rep,
                             ix_mv **out) IX_MUST_CHECK;

/* The finite parts of a rational multivariate: boxes of its domain over which
 * the weights of the control points have one sign, which proves that there is
 * no pole, found by halving the directions in turn.
 *
 * In    depth  halvings of a part, 0 .. 12
 *       reach  > 0: only parts whose control points have no coordinate beyond
 *              it, so that neither has the part; 0: any
 * Out   *out   B-splines that keep their part of the domain, with these
 *              intervals; none, if there is no such part; ix_mv_pieces_free
 * Err   IX_EARG depth, reach */
ix_status ix_finite_pieces(ix_ctx *ctx, const ix_mv *m, int depth, double reach,
                           ix_mv_pieces *out) IX_MUST_CHECK;

/* The points whose distances from two space curves have a constant ratio,
 *
 *   (1 - alpha) |B - C1| = alpha |B - C2|, (B - C1).C1' = 0, (B - C2).C2' = 0
 *
 * unlike those of ix_calphasector3d. They are not rational: a quadratic
 * equation has two solutions over each pair of parameters.
 *
 * In    c1, c2  2 or 3 coordinates, C2 at least for the accuracy to grow fast
 *       alpha   0 < alpha < 1, not 1/2 (ix_cbisector3d); near 0 next to C1
 *       tol     > 0: distance of the result from the sheets half way between
 *               the points that it interpolates
 * Out   *out    two bicubic E3 B-splines over the domains of c1 and c2, a sheet
 *               each, of 17 x 17 to 257 x 257 points
 *       *err    that distance, may be NULL
 * Err   IX_EARG    alpha, tol, operands
 *       IX_EDOMAIN no real solution over some parameters (the message names
 *                  them), or the normal planes are parallel there; no tangent
 *       IX_EUNABLE 257 x 257 points are not enough */
ix_status ix_ratio_sector(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                          double alpha, double tol, double *err,
                          ix_crvs *out) IX_MUST_CHECK;

/* Directions equally far, on the unit sphere around the origin, from the point
 * q and a curve on it: (q - C) x C', as points of the plane z = 1.
 *
 * Out   *out   P3 over the domain of crv, degree 2d - 2
 * Err   as ix_pt_crv_bisector3d; IX_EDOMAIN all directions are in the plane z
 *       = 0 */
ix_status ix_sphere_bisector_point(ix_ctx *ctx, const ix_mv *crv,
                                   const double q[3], const ix_op_opts *o,
                                   ix_mv **out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
