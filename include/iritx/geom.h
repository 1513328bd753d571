/* geom.h - making, editing and asking curves.
 *
 * A curve is a multivariate with one direction. Functions borrow their
 * inputs and return new references; outputs are NULL unless IX_OK. Points
 * given as double[3] are x, y, z. */
#ifndef IRITX_GEOM_H
#define IRITX_GEOM_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Some curves, in order, each with an interval [t[2 i], t[2 i + 1]] of the
 * curve that it came from (or as stated). Released as a whole. */
typedef struct {
    int n;
    ix_mv **crv; /* n references */
    double *t;   /* double[n][2] */
} ix_crvs;
void ix_crvs_free(ix_ctx *ctx, ix_crvs *c);

/* --- circles and arcs ---------------------------------------------------- */

/* The circle around center in the plane z = center[2], exactly.
 *
 * Out   *out   P3, order 3, 9 points, domain [0, 4], counter-clockwise from
 *              (x + r, y, z); knots 0 0 0 1 1 2 2 3 3 4 4 4
 * Err   IX_EARG  radius not positive, or something not finite */
ix_status ix_circle(ix_ctx *ctx, const double center[3], double radius,
                    ix_mv **out) IX_MUST_CHECK;

/* The same as a polynomial: E3, order 4, 10 points, C1, domain [0, 4].
 *
 * Num   radius right within 2.73e-4 of it: handles 4 (sqrt 2 - 1) / 3 */
ix_status ix_pcircle(ix_ctx *ctx, const double center[3], double radius,
                     ix_mv **out) IX_MUST_CHECK;

/* The arc from start to end around center, the shorter way.
 *
 * Out   *out   P3 Bezier of order 3, weights 1, cos(half the angle), 1
 * Err   IX_EARG    start or end equal to center
 *       IX_EDOMAIN no angle, or half a turn: no plane or no way is the shorter
 * Num   where the radii differ, an arc of the ellipse around center that is
 *       the affine image of the circular arc with the same angle */
ix_status ix_arc(ix_ctx *ctx, const double start[3], const double center[3],
                 const double end[3], ix_mv **out) IX_MUST_CHECK;

/* The arc in the plane z = center[2] counter-clockwise from angle a0 to a1,
 * degrees; whole turns do not count, so 300 to 60 is an arc of 120.
 *
 * Out   *out   P3, order 3; below 160 degrees one Bezier, else a B-spline of
 *              two equal spans with domain [0, 2]
 * Err   IX_EARG  radius not positive, a0 and a1 equal but for whole turns */
ix_status ix_arc_angles(ix_ctx *ctx, const double center[3], double radius,
                        double a0, double a1, ix_mv **out) IX_MUST_CHECK;

/* Centre of the circle of which a rational quadratic Bezier is an arc.
 *
 * Out   center[3]   false if arc is not such an arc, or straight */
bool ix_arc_center(const ix_mv *arc, double center[3]);

/* The cubic Bezier (E3) from p0 to p1 with first derivatives v0, v1 there. */
ix_status ix_hermite(ix_ctx *ctx, const double p0[3], const double p1[3],
                     const double v0[3], const double v1[3],
                     ix_mv **out) IX_MUST_CHECK;

/* --- interpolation and fitting -------------------------------------------- */

/* Parameters of points, by the lengths d of the steps between them. */
typedef enum {
    IX_PARAM_UNIFORM,
    IX_PARAM_CENTRIPETAL,  /* sqrt(d), Lee 1989 */
    IX_PARAM_CHORD,        /* d */
    IX_PARAM_NIELSON_FOLEY /* d and the angles beside it, in the metric that
                              affine maps of all points leave alone */
} ix_param;

/* Parameters in [0, 1] of n points double[ncoords][n]: params[n], first 0,
 * last 1, non-decreasing.
 *
 * Err   IX_EARG    n < 2, something not finite
 *       IX_EDOMAIN all points are equal (not for IX_PARAM_UNIFORM)
 * Src   Foley and Nielson 1989, metric of Nielson 1987 */
ix_status ix_params(ix_ctx *ctx, ix_param how, int n, int ncoords,
                    const double *pts, double *params) IX_MUST_CHECK;

/* The knots of an open B-spline for given parameters tau[m], 0 .. 1, not
 * falling: averages of order - 1 consecutive ones, mapped so that the first is
 * 0 and the last is 1 (uniform for uniform tau), as IRIT has them. Where they
 * would amplify data more than 50 times (many points, high order, uneven
 * steps), de Boor's averages of the inner ones, which always interpolate.
 * With fewer control points than parameters the tau are resampled first.
 *
 * Out   knots[length + order], domain [0, 1]
 * Err   IX_EARG order < 1, length < order, m < length */
ix_status ix_params_knots(ix_ctx *ctx, int order, int length, int m,
                          const double *tau, double *knots) IX_MUST_CHECK;

typedef struct {
    int order;
    int size; /* control points; 0: as many as data points */
    ix_param param;
    bool periodic; /* parameters i / n, uniform periodic knots */
    /* Given parameters and knots replace the two above unless NULL. */
    int nparams; /* as many as data points; non-decreasing, in the domain */
    const double *params;
    int nknots; /* size + order, periodic size + 2 order - 1 */
    const double *knots;
} ix_interpolate_opts;

/* The B-spline through n data points, or nearest to them in the sense of least
 * squares if size < n.
 *
 * In    pts   double[axes][n], weight first if rational (fitted like the
 *             others)
 *       res   NULL, or receives the root mean square of the distances
 * Out   *out  open on [0, 1], or periodic, or with the given knots
 * Err   IX_EARG    order <= size <= n not so; counts that do not fit;
 *                  parameters outside the domain
 *       IX_EDOMAIN the parameters do not determine the control points (as for
 *                  periodic interpolation of evenly many points by odd order)
 * Num   orthogonal transformations of the banded system; O(n order^2) */
ix_status ix_interpolate(ix_ctx *ctx, int n, int ncoords, bool rational,
                         const double *pts, const ix_interpolate_opts *o,
                         double *res, ix_mv **out) IX_MUST_CHECK;

/* The spline of order and size (uniform knots on the curve's domain, or those
 * of o) nearest to a curve in the mean square over its domain; the ends of an
 * open one are kept. Polynomial, whatever crv is.
 *
 * In    o     order, size (0: as crv), periodic, knots count; the rest not
 * Out   *err  largest distance |C(t) - out(t)|, measured densely
 * Err   IX_EARG as ix_interpolate; IX_EDOMAIN poles */
ix_status ix_fit_curve(ix_ctx *ctx, const ix_mv *crv,
                       const ix_interpolate_opts *o, double *err,
                       ix_mv **out) IX_MUST_CHECK;

/* Cubic B-splines (domain [0, 1]) nearest to samples of
 *
 *   helix   (r cos a, r sin a, pitch a / 2 pi)    E3, one pitch per turn;
 *           r = radius, or growing from 0 to |radius| if that is negative
 *   spiral  (q a cos a, q a sin a),  q = pitch / (2 pi (1 + loops))     E2
 *   sine    (a, sin a)                                                  E2
 *
 * at `samples` even steps of a from 0 to 2 pi loops, with 4 + floor(per_loop *
 * loops) control points.
 *
 * Err   IX_EARG  loops not positive, fewer samples than control points, more
 *                than a million samples */
ix_status ix_helix(ix_ctx *ctx, double loops, double pitch, double radius,
                   int samples, double per_loop, ix_mv **out) IX_MUST_CHECK;
ix_status ix_spiral(ix_ctx *ctx, double loops, double pitch, int samples,
                    double per_loop, ix_mv **out) IX_MUST_CHECK;
ix_status ix_sine(ix_ctx *ctx, double loops, int samples, double per_loop,
                  ix_mv **out) IX_MUST_CHECK;

/* --- lengths, moments, frames ----------------------------------------------
 */

/* Length of a curve, or of its part over [range[0], range[1]] (NULL: all).
 *
 * Err   IX_EDOMAIN  a range outside the domain, poles
 * Num   1e-12 relative: adaptive Gauss quadrature; kinks and cusps included */
ix_status ix_length(ix_ctx *ctx, const ix_mv *crv, const double *range,
                    double *out) IX_MUST_CHECK;

/* The curve by its arc length, approximately.
 *
 * In    tol    for |out(s) - C(t(s))|, s the arc length from the start
 *       order  of the result, 2 .. 32
 * Out   *out   polynomial B-spline, domain [0, length]; corners are C0 knots
 *       *err   NULL, or receives the largest distance that was measured
 * Err   IX_EARG tol or order; IX_EDOMAIN poles, length 0; IX_EUNABLE too many
 *       knots would be needed */
ix_status ix_arclen(ix_ctx *ctx, const ix_mv *crv, double tol, int order,
                    double *err, ix_mv **out) IX_MUST_CHECK;

/* Centre of mass of the curve as a wire of constant density, and the unit
 * direction of its longest principal axis (largest component positive; may be
 * NULL). Three coordinates, missing ones 0.
 *
 * Err   IX_EDOMAIN  poles, length 0
 * Num   1e-12 relative */
ix_status ix_moments(ix_ctx *ctx, const ix_mv *crv, double center[3],
                     double axis[3]) IX_MUST_CHECK;

/* First derivative of the projected curve, first three coordinates; unit: the
 * tangent's direction, at a cusp that in which the curve goes on.
 *
 * Err   IX_EDOMAIN  t outside a B-spline's domain, a pole, no direction */
ix_status ix_tangent(ix_ctx *ctx, const ix_mv *crv, double t, bool unit,
                     double out[3]) IX_MUST_CHECK;

/* Unit normal. Two coordinates: the tangent turned by +90 degrees. Three: the
 * principal normal, towards the centre of curvature.
 *
 * Err   IX_EARG 1 or more than 3 coordinates; IX_EDOMAIN as ix_tangent, or no
 *       curvature in space */
ix_status ix_normal(ix_ctx *ctx, const ix_mv *crv, double t,
                    double out[3]) IX_MUST_CHECK;

/* Area swept from the start, as a scalar curve A(t) on the same domain:
 *
 *   A(t) = 1/2 integral (x y' - y x') dt;   A(end) = area, if closed and
 *                                           counter-clockwise
 *
 * Out   *out  E1, degree 2 d
 * Err   IX_EARG rational, or fewer than two coordinates */
ix_status ix_area(ix_ctx *ctx, const ix_mv *crv, ix_mv **out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
