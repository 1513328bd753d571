/* offset.h - curves and surfaces at a distance, and where such curves meet
 * themselves.
 *
 * Sides, as IRIT has them: curves of three or more coordinates and order above
 * 2 move towards their centre of curvature (where there is none, as the
 * others); all other curves move to the right of their direction in the XY
 * plane, (y', -x'); surfaces along S_v x S_u. Negative distances move the
 * other way. */
#ifndef IRITX_OFFSET_H
#define IRITX_OFFSET_H

#include "iritx/geom.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    double distance;
    const ix_mv *field; /* NULL, or a scalar curve that replaces distance; its
                           domain is mapped to the curve's */
    double tol;         /* for |offset(t) - (C(t) + distance N(t))| */
    bool interpolate;   /* through offset points at the nodes, polynomial; else
                           control points are moved, weights kept */
} ix_offset_opts;

/* The offset of a curve: its control points (at their nodes) moved along the
 * normal, with knots inserted where the tolerance asks for it. Straight lines
 * are exact. At corners straight bridges, whose spans add to the domain, join
 * the pieces.
 *
 * Out   *out   order of crv; *err (may be NULL) the largest error, sampled at
 *              8 places of each span
 * Err   IX_EARG     tol not positive, field not a scalar curve, one coordinate
 *       IX_EDOMAIN  poles
 * Num   error O(h^2), interpolated O(h^order); knots closer than 2^-20 of the
 *       domain are not inserted: where the principal normal changes sides (at
 *       inflections in space) *err stays large */
ix_status ix_crv_offset(ix_ctx *ctx, const ix_mv *crv, const ix_offset_opts *o,
                        double *err, ix_mv **out) IX_MUST_CHECK;

/* The open B-spline of an order and size nearest (least squares) to the exact
 * offset at `samples` even parameters, on crv's domain; polynomial. *err (may
 * be NULL) is the root mean square distance. Err as above, and as
 * ix_interpolate. */
ix_status ix_crv_offset_fit(ix_ctx *ctx, const ix_mv *crv, double distance,
                            int samples, int size, int order, double *err,
                            ix_mv **out) IX_MUST_CHECK;

/* The offset by matching tangents: C(t) + distance q(t), with q(t) the point of
 * the unit circle at which its tangent is parallel to C'(t). Arcs of the circle
 * of at most angle (radians) are replaced by parabolas that touch it at their
 * ends, so that q(t) is rational and the tangents are exactly parallel.
 *
 * In    crv    of two coordinates or more, which move in the XY plane, to the
 *              right of the direction; further ones stay
 *       angle  0.001 to a right angle
 * Out   *out   rational, degree 3 d - 2 (5 d - 4 of a rational curve), C0 knots
 *              where the tangent leaves an arc; the parameter is that of crv,
 *              but corners and cusps are gone around on parabolas whose spans
 *              add to the domain (at those of a closed curve's ends, too)
 *       *err   (may be NULL) distances are from |distance| to |distance| + err:
 *              err = |distance| ((cos(a/2) + 1 / cos(a/2)) / 2 - 1), a <= angle
 * Err   IX_EARG not such a curve, angle; IX_EDOMAIN poles, a span that is a
 *       point
 * Src   Lee, Kim, Elber 1996 (offsets by convolution with approximate circles)
 */
ix_status ix_crv_offset_match(ix_ctx *ctx, const ix_mv *crv, double distance,
                              double angle, double *err,
                              ix_mv **out) IX_MUST_CHECK;

/* Intervals of the parameter in which off, the offset of crv, runs backwards:
 * <C', O'> < 0, between the zeros of that field. In these the distance exceeds
 * the radius of curvature. ends double[*n][2], freed with
 * ix_offset_loops_free. Err IX_EARG different numbers of coordinates. */
ix_status ix_offset_loops(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                          double **ends, int *n) IX_MUST_CHECK;
void ix_offset_loops_free(ix_ctx *ctx, double *ends, int n);

/* The pieces of off, cut at its self-intersections, of which no part is nearer
 * to crv than amount; in order, with their intervals of off's parameter. Both
 * curves in the XY plane.
 *
 * Num   a piece is judged by its middle and 8 more places; amount is best a
 *       little below |distance|
 * Err   as ix_crv_self_meet, ix_crv_nearest */
ix_status ix_offset_trim(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                         double amount, ix_crvs *out) IX_MUST_CHECK;

/* The offset of a surface, as ix_crv_offset without field; the error is
 * sampled at 4 x 4 places of each patch, knots are inserted in both
 * directions. Err as ix_crv_offset; IX_EDOMAIN no normal at a node. */
ix_status ix_srf_offset(ix_ctx *ctx, const ix_mv *srf, double distance,
                        double tol, double *err, ix_mv **out) IX_MUST_CHECK;

/* Where off, an offset of srf, meets itself, as far as its points are not
 * nearer to srf than amount (0: all of it; best a little below |distance|): the
 * edges that are left when the inner parts of off are cut away. Curves of order
 * 2, of the points (euclid) or of both pairs of parameters (u1, v1, u2, v2);
 * t is their own domain.
 *
 * In    tol       as in ix_curves_opts
 * Out   *complete false: there may be more, see ix_srf_self_meet
 * Err   as ix_srf_self_meet, ix_srf_nearest
 * Num   vertices are exact; a curve that amount cuts ends within tol */
ix_status ix_srf_offset_meet(ix_ctx *ctx, const ix_mv *srf, const ix_mv *off,
                             double amount, bool euclid, double tol,
                             bool *complete, ix_crvs *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
