/* ops_crv.h - differential geometry of planar and space curves.
 *
 * All functions take curves of 2 or 3 coordinates, any basis, polynomial or
 * rational, any continuity, and borrow them. ' = d/dt, x = p / w the curve,
 * det of vectors. Degrees are of generic curves of degree d, polynomial /
 * rational, in the form IX_FORM_MINIMAL; docs/ops has those of all forms. A
 * negative degree: the field is identically zero (a result of degree 0).
 *
 * Common errors, not repeated below:
 *   IX_EARG    not a curve, not 2 or 3 coordinates
 *   IX_EDOMAIN all weights are zero; a number overflows
 *   IX_EUNABLE an order above IX_MAX_ORDER */
#ifndef IRITX_OPS_CRV_H
#define IRITX_OPS_CRV_H

#include "iritx/geom.h"
#include "iritx/ops.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- scalar fields ------------------------------------------------------ */

typedef enum {
    IX_CRV_INFLECTION,     /* det(x', x'') of the first two coordinates */
    IX_CRV_CRITICAL,       /* zero where the curvature is stationary */
    IX_CRV_CURVATURE_SQR,  /* squared curvature */
    IX_CRV_TORSION_ZERO,   /* det(x', x'', x''') */
    IX_CRV_TORSION,        /* torsion */
    IX_CRV_CRITICAL_DIRECT /* as CRITICAL; naive: (3.4) of the paper, without
                              squaring, in fractions: 4d-6 / 26d */
} ix_crv_field_kind;

/* A scalar function of the curve's parameter.
 *
 *   INFLECTION   w^3 det(x', x'')                         2d-4 / 3d-6
 *   CRITICAL     planar: w^8 |x'|^5 kappa'                4d-7 / 8d-12
 *                space: w^11 |x'|^8 (kappa^2)'            6d-11 / 11d-18
 *   CURVATURE_SQR  |x' x x''|^2 / |x'|^6, rational        6d-6 / 12d-12
 *   TORSION_ZERO w^4 det(x', x'', x''')                   3d-9 / 4d-12
 *   TORSION      det(x', x'', x''') / |x' x x''|^2        4d-8 / 6d-12
 *
 * (w = 1 for polynomial curves.) The other degree forms give the same function
 * times a power of w, with two exceptions: IX_FORM_NAIVE's CRITICAL is
 * (kappa^2)', IX_FORM_IRIT's the derivative of |kappa N|^2: both vanish at
 * inflections as well. Fields that IRIT does not have are minimal in
 * IX_FORM_IRIT.
 *
 * In    crv    space curves in a plane z = const count as planar
 *       o      NULL: minimal
 * Out   *out   E1 (polynomial) or P1, domain of crv; new reference
 *       rep    residual: largest deviation from the values of derivatives at
 *              nine parameters, relative to the largest value
 * Err   IX_EARG    torsion of a planar curve's two coordinates is zero: no
 *                  error; other coordinates counts see above
 *       IX_EDOMAIN TORSION of a straight line, CURVATURE_SQR of a point
 * Src   Chen, Riesenfeld & Cohen 2005, 3.1, 3.2 and (4.6); minimal degrees by
 *       Wronskians of one degree (docs/ops/crv_field.md) */
ix_status ix_crv_field(ix_ctx *ctx, const ix_mv *crv, ix_crv_field_kind kind,
                       const ix_op_opts *o, ix_report *rep,
                       ix_mv **out) IX_MUST_CHECK;

/* The graph (t, f(t)) of a scalar function of one parameter.
 *
 * In    nodes   the abscissa of a rational f: true - its control points are at
 *               the nodes of its degree, as IRIT, so that x(t) is not exactly
 *               t; false - exact, one degree more
 * Out   *out    E2 or P2; degree at least 1 */
ix_status ix_crv_graph(ix_ctx *ctx, const ix_mv *f, bool nodes,
                       ix_mv **out) IX_MUST_CHECK;

/* --- special points ----------------------------------------------------- */

typedef enum {
    IX_CRV_FLAT,      /* the curvature is zero (in the plane: an inflection if
                         root.before and root.after differ) */
    IX_CRV_MAX,       /* of the absolute curvature; a cusp where it is infinite
                       */
    IX_CRV_MIN,       /* above 0 */
    IX_CRV_STATIONARY /* the derivative is zero, but neither */
} ix_crv_mark;

typedef struct {
    ix_root root; /* of the field; IX_ROOT_JUMP: an extremum at a knot where
                     the derivative changes its sign by a jump */
    ix_crv_mark mark;
    double curvature; /* absolute, at root.t (from the right at a knot); NaN at
                         a cusp or pole */
} ix_crv_feature;

/* Zeros of the curvature of the curve projected to the xy plane, by increasing
 * t; straight pieces are intervals.
 *
 * Out   *roots  array of *n, freed with ix_roots_free */
ix_status ix_crv_inflections(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                             int *n) IX_MUST_CHECK;
/* Zeros of the torsion; none for curves of two coordinates. */
ix_status ix_crv_torsion_zeros(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                               int *n) IX_MUST_CHECK;
/* Extrema of the absolute curvature and its zeros, by increasing t. Pieces of
 * constant curvature (lines, circles) have none. An end of the domain is listed
 * if the curvature is stationary there.
 *
 * Out   *f   array of *n, freed with ix_crv_features_free */
ix_status ix_crv_features(ix_ctx *ctx, const ix_mv *crv, ix_crv_feature **f,
                          int *n) IX_MUST_CHECK;
void ix_crv_features_free(ix_ctx *ctx, ix_crv_feature *f, int n);

/* The absolute curvature at t.
 *
 * Err   IX_EDOMAIN a pole, x' = 0, t outside */
ix_status ix_crv_curvature(ix_ctx *ctx, const ix_mv *crv, double t,
                           double *out) IX_MUST_CHECK;

/* --- one control point --------------------------------------------------- */

/* The sign of the curvature as a function of the parameter and of the place of
 * control point idx (from 0): F(t, x, y) = w^3 det(c', c'') of the curve with
 * that point at (x, y), its weight kept. F is affine in x and y.
 *
 * In    range  x and y are in [range[0], range[1]]
 * Out   *out   E1, three directions, B-splines; degree as IX_CRV_INFLECTION in
 *              t, 1 in x and y
 * Err   IX_EARG    not a Bezier or B-spline curve of 2 or 3 coordinates, idx,
 *                  an empty range
 *       IX_EDOMAIN a polygon (order 2) */
ix_status ix_crv_one_point(ix_ctx *ctx, const ix_mv *crv, int idx,
                           const double range[2], ix_mv **out) IX_MUST_CHECK;
/* Where two inflections appear or vanish: F = dF/dt = 0, curves of (t, x, y).
 * tol as in ix_curves_opts. Freed with ix_solution_curves_free. Err as above.
 */
ix_status ix_crv_one_point_births(ix_ctx *ctx, const ix_mv *crv, int idx,
                                  const double range[2], double tol,
                                  ix_solution_curves *out) IX_MUST_CHECK;
/* Lines (x, y, 0) that divide the square of places into regions in each of
 * which the number of inflections is one: the curves above, and the straight
 * lines on which F is zero at an end of the domain, or at a knot where F or its
 * derivative jumps. *complete: as of the curves. Freed with ix_lines_free. */
ix_status ix_crv_one_point_regions(ix_ctx *ctx, const ix_mv *crv, int idx,
                                   const double range[2], double tol,
                                   bool *complete, ix_lines *out) IX_MUST_CHECK;
/* F = 0 as triangles in (t, x, y), cells boxes to each span and to the range
 * (see ix_tv_fold). Err also IX_EARG cells < 1. */
ix_status ix_crv_one_point_surface(ix_ctx *ctx, const ix_mv *crv, int idx,
                                   const double range[2], int cells,
                                   ix_lines *out) IX_MUST_CHECK;

/* --- curves ------------------------------------------------------------- */

/* The vector of curvature, kappa N = (x' x x'') x x' / |x'|^4.
 *
 * Out   *out   P3; degree 4d-4 / 8d-8
 * Err   IX_EDOMAIN the curve is a point */
ix_status ix_crv_normal_field(ix_ctx *ctx, const ix_mv *crv,
                              const ix_op_opts *o, ix_report *rep,
                              ix_mv **out) IX_MUST_CHECK;

/* The centres of curvature, x + N / kappa.
 *
 *   planar: (w^2 K p + Q D_r) / (w^3 K), K the inflection field, D = p'w - pw'
 *           (D_r turned by +90 degrees), Q = |D|^2: 3d-3 / 6d-6
 *   space:  (w^2 |V|^2 p + Q V x D) / (w^3 |V|^2), V the direction of the
 *           binormal: 5d-7 / 9d-12; in a plane within rounding V = K n with
 *           constant n, and the degree is the planar one
 *
 * Out   *out   rational, 2 or 3 coordinates as crv (3 in IX_FORM_IRIT); the
 *              weights add up to a positive number. At an inflection the
 *              evolute passes through infinity: its weight has a zero there
 *              (ix_roots of axis 0 lists these poles). At a cusp of crv the
 *              evolute is at the cusp. The evolute of a circle is its centre:
 *              a constant curve, of lower degree by ix_sym_reduce
 *       rep    residual: (E - x).x' and (E - x).x'' - |x'|^2, relative
 * Err   IX_EDOMAIN straight on a span (the message names it): there the
 *                  evolute is at infinity
 * Src   Chen, Riesenfeld & Cohen 2005, (3.6) and 3.3; (4.4) */
ix_status ix_evolute(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out) IX_MUST_CHECK;
/* The same for the parts of crv that are not straight, each with its interval:
 * none if all is straight. */
ix_status ix_evolute_pieces(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                            ix_crvs *out) IX_MUST_CHECK;

/* The focal curve: the centres of the osculating spheres, those that meet the
 * curve in four coinciding points.
 *
 *   (w^3 T p - (w (V'Q - 3/2 V Q') + 3 w'Q V)) / (w^4 T): 4d-7 / 8d-12
 *
 * T the torsion field, V, Q as for ix_evolute. It is rational:
 * docs/ops/focal.md has the proof (Chen, Riesenfeld & Cohen 2005 doubt it).
 *
 * Out   *out   rational, 3 coordinates; where the torsion is zero it passes
 *              through infinity (ix_roots of axis 0 lists these poles)
 *       rep    residual: the equations of contact, relative
 * Err   IX_EDOMAIN  the torsion vanishes on a span (the message names it): a
 *                   planar piece has no sphere of that contact, or all.
 *                   IX_FORM_IRIT: as minimal */
ix_status ix_focal_crv(ix_ctx *ctx, const ix_mv *crv, const ix_op_opts *o,
                       ix_report *rep, ix_mv **out) IX_MUST_CHECK;

/* --- ruled surfaces ----------------------------------------------------- */

typedef enum {
    IX_RULED_TANGENT,    /* tangent developable */
    IX_RULED_NORMAL,     /* normal scroll */
    IX_RULED_BINORMAL,   /* binormal scroll */
    IX_RULED_RECTIFYING, /* rectifying developable */
    IX_RULED_POLAR       /* polar developable, or focal surface */
} ix_ruled_kind;

/* The ruled surface x(t) + r b(t), direction 0 over the curve's domain,
 * direction 1 over [0, 1] with r = range[0] + v (range[1] - range[0]). Ruling
 * b(t) and degree in t of the minimal form:
 *
 *   TANGENT     w x'                                    d / max(d, 2d-2)
 *   NORMAL      w^4 (x' x x'') x x'           max(d, 3d-5) / max(d, 5d-8)
 *   BINORMAL    w^2 x' x x''                  max(d, 2d-4) / max(d, 3d-6)
 *   RECTIFYING  w^9 (det(x', x'', x''') |x'|^2 x' + |x' x x''|^2 x' x x'')
 *                                           max(d, 6d-12) / max(d, 10d-18)
 *   POLAR       the axis of the circle of curvature, between the planes at the
 *               distances range[0] and range[1] from one through the middle of
 *               the control points' box, whose normal is the mean direction of
 *               the binormals, or that binormal which is farthest from a right
 *               angle to all others: 3d-3 / 6d-6
 *
 * (w = 1 for polynomial curves.) The other degree forms have the same rulings
 * with the scale of their formulas: published w x', w^5 .., w^3 .., the Darboux
 * vector times |x'|; naive the bare derivatives; both have POLAR as the centre
 * of curvature plus r x' x x''.
 *
 * Out   *out   rational surface, 3 coordinates
 *       rep    residual: directions and positions of nine rulings, relative
 * Err   IX_EARG    range not finite, or empty
 *       IX_EDOMAIN a straight span (all but TANGENT), a span that is a point
 * Src   Chen, Riesenfeld & Cohen 2005, section 4 */
ix_status ix_crv_ruled(ix_ctx *ctx, const ix_mv *crv, ix_ruled_kind kind,
                       const double range[2], const ix_op_opts *o,
                       ix_report *rep, ix_mv **out) IX_MUST_CHECK;

/* --- curvature as a function -----------------------------------------------
 */

/* Signed curvature of a planar curve (the first two coordinates), roughly: n
 * samples at uniform parameters are the control values of an E1 B-spline of
 * that order, with uniform open knots over the domain or, arclen, over [0,
 * length] by arc length.
 *
 * Err   IX_EARG n or order; IX_EDOMAIN x' = 0 or a pole at a sample */
ix_status ix_curvature_function(ix_ctx *ctx, const ix_mv *crv, int n, int order,
                                bool arclen, ix_mv **out) IX_MUST_CHECK;
/* The planar curve with curvature k(s), s the arc length, from the origin in
 * direction (1, 0).
 *
 * In    k       polynomial, one coordinate
 *       n       cubic pieces, C1; the error falls with n^-4
 *       closed  the gap between the ends is spread evenly
 * Out   *out    E2 B-spline of order 4, domain of k */
ix_status ix_curve_of_curvature(ix_ctx *ctx, const ix_mv *k, int n, bool closed,
                                ix_mv **out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
