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
 *       knots would be needed, or tol is below rounding */
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

/* --- lines, planes, conics, quadrics -------------------------------------- */

/* The line nearest to points p[n][3]: the point of it nearest to the origin,
 * its unit direction (from the first point towards the last), and the mean
 * distance of the points from it.
 *
 * Err   IX_EARG fewer than 2 points; IX_EDOMAIN all are equal */
ix_status ix_fit_line(ix_ctx *ctx, int n, const double *p, double point[3],
                      double dir[3], double *dist) IX_MUST_CHECK;
/* The plane (unit normal; the points run counter-clockwise around it) and the
 * mean distance. Err IX_EARG fewer than 3 points; IX_EDOMAIN on one line. */
ix_status ix_fit_plane(ix_ctx *ctx, int n, const double *p, double plane[4],
                       double *dist) IX_MUST_CHECK;

/* The conic A x^2 + B xy + C y^2 + D x + E y + F = 0, coef = A .. F, at
 * height z, exactly.
 *
 * In    range  NULL: an ellipse as a whole, of a hyperbola (the branch towards
 *              its positive axis) parameters -2 .. 2, of a parabola the part
 *              up to four times its half width at the focus. Else the
 *              parameters of the ends: for an ellipse the eccentric angles in
 *              degrees (counter-clockwise), for a hyperbola u in (a cosh u,
 *              b sinh u), for a parabola the distance from its axis, both
 *              growing towards +x or +y. An ellipse's axes are turned by at
 *              most 45 degrees from x and y.
 * Out   *out   P3, order 3; whole ellipses as ix_circle, else one or two spans
 * Err   IX_EARG     no or infinite coefficients, an empty range
 *       IX_EDOMAIN  no real points, a point, lines: the message says which */
ix_status ix_conic(ix_ctx *ctx, const double coef[6], double z,
                   const double *range, ix_mv **out) IX_MUST_CHECK;
/* The part between two points on it (x and y count, within 1e-5 of its size),
 * for an ellipse counter-clockwise from p0. Err also IX_EDOMAIN a point is off
 * the conic or on the other branch. */
ix_status ix_conic_between(ix_ctx *ctx, const double coef[6], double z,
                           const double p0[3], const double p1[3],
                           ix_mv **out) IX_MUST_CHECK;

/* Coefficients of the image under x' = x M (mat row-major, row vectors); for
 * conics M acts in the plane. Err IX_EDOMAIN singular. */
ix_status ix_conic_transform(ix_ctx *ctx, const double coef[6],
                             const double mat[16], double out[6]) IX_MUST_CHECK;
/* Quadric A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J. */
ix_status ix_quadric_transform(ix_ctx *ctx, const double coef[10],
                               const double mat[16],
                               double out[10]) IX_MUST_CHECK;
/* The quadric that meets z = 0 in a central conic and has half height
 * `height` over its center. Err IX_EARG height 0; IX_EDOMAIN no center. */
ix_status ix_conic_to_quadric(ix_ctx *ctx, const double coef[6], double height,
                              double out[10]) IX_MUST_CHECK;
/* The ellipse of least area through three points of the plane (Steiner 1829),
 * semi-axes enlarged by offset; -1 at its center.
 *
 * Err   IX_EDOMAIN on one line; IX_EARG offset leaves no ellipse */
ix_status ix_ellipse_three_points(ix_ctx *ctx, const double (*p)[3],
                                  double offset, double out[6]) IX_MUST_CHECK;

/* --- editing ---------------------------------------------------------------
 */

/* The same control points on knots spaced by a rule for the control polygon
 * (ix_params, ix_params_knots; periodic: its closed steps). Domain kept, the
 * shape changes. Err as ix_params. */
ix_status ix_reknot(ix_ctx *ctx, const ix_mv *crv, ix_param how,
                    ix_mv **out) IX_MUST_CHECK;

/* A copy with control point i (direction 0 fastest) replaced by pt[axes].
 * Err IX_EARG i out of range, another point type, not finite. */
ix_status ix_set_point(ix_ctx *ctx, const ix_mv *m, size_t i, int ncoords,
                       bool rational, const double *pt,
                       ix_mv **out) IX_MUST_CHECK;

/* The same curve reparametrised by a Moebius map of its domain, rational:
 * a Bezier's weights (and points) i get the factor ratio^(i - degree), so the
 * last one stays; ratio 0: the map that makes both end weights equal.
 *
 * Err   IX_EARG ratio negative, order 1; IX_EDOMAIN end weights differ in sign
 * See   ix_mv_moebius, where the ratio is that of the end weights */
ix_status ix_moebius(ix_ctx *ctx, const ix_mv *crv, double ratio,
                     ix_mv **out) IX_MUST_CHECK;

/* --- curves in simpler pieces ----------------------------------------------
 */

/* Polynomial Bezier pieces of order 3 or 4 along a curve, end to end; each is
 * as long as the tolerance allows, ends at a knot if it reaches one, and does
 * not pass a corner.
 *
 * In    tol      for |C(t) - piece(u)|, u linear in t
 *       max_len  largest arc length of the curve that a piece may cover; not
 *                positive: any
 * Out   *out     pieces with their intervals of t, polynomial
 *       *err     NULL, or receives the bound of the largest distance
 * Err   IX_EARG order, tol; IX_EDOMAIN poles; IX_EUNABLE more than 2^20 pieces
 * Num   distances are bounded by control points, not sampled. A polynomial of
 *       no higher order comes back exactly; orders 3, 4: error O(h^order) */
ix_status ix_fit_pieces(ix_ctx *ctx, const ix_mv *crv, int order, double tol,
                        double max_len, double *err,
                        ix_crvs *out) IX_MUST_CHECK;

/* Circular arcs along a planar curve, tangent to each other and to the curve
 * at every other joint (biarcs); corners stay.
 *
 * In    crv        in a plane z = const
 *       tol        for the distance between curve and arcs
 *       max_angle  of one arc, degrees; more than 170 counts as 170
 * Out   *out       rational quadratic Beziers, P2 (P3 for 3 coordinates and
 *                  more), straight ones with weights 1; their intervals of t
 *       *err       NULL, or receives the bound of the largest distance
 * Err   IX_EARG tol, angle, not in such a plane; IX_EDOMAIN poles; IX_EUNABLE
 *       too many arcs
 * Src   Bolton 1975; distances bounded by control points */
ix_status ix_biarcs(ix_ctx *ctx, const ix_mv *crv, double tol, double max_angle,
                    double *err, ix_crvs *out) IX_MUST_CHECK;

/* --- decompositions ---------------------------------------------------------
 */

/* How a curve is split into resolutions. */
typedef struct {
    bool keep_jumps; /* knots of full multiplicity stay */
    bool wavelets;   /* one knot at a time: each detail is a multiple of one
                        B-wavelet; else every second knot at a time */
} ix_multires;

/* A polynomial curve as the sum of its best approximation without interior
 * knots (first) and of details, coarse to fine, each orthogonal (in the mean
 * square over the parameter) to all coarser splines.
 *
 * Out   *out  open B-splines on the curve's domain; each in its own space
 * Err   IX_EARG rational; IX_EUNABLE more than 4096 wavelets
 * Num   the sum is the curve up to rounding
 * Src   Elber and Gotsman 1995; Kazinnik and Elber 1997 */
ix_status ix_multires_split(ix_ctx *ctx, const ix_mv *crv, ix_multires how,
                            ix_crvs *out) IX_MUST_CHECK;
/* The scalar B-wavelet of one interior knot (an index into the knots of the
 * curve made open): orthogonal to all splines without that knot, largest
 * control value 1. Err IX_EARG rational, not an interior knot. */
ix_status ix_multires_wavelet(ix_ctx *ctx, const ix_mv *crv, int knot,
                              ix_mv **out) IX_MUST_CHECK;

/* f and g with f(g(t)) = crv(t), both of degree 2 at least, g scalar with
 * values in [0, 1] and of the least degree possible; both NULL (and IX_OK) if
 * there are none.
 *
 * Out   *f  Bezier, point type of crv; *g as crv: Bezier or B-spline
 * Err   IX_EARG interior knots
 * Num   |f(g) - crv| <= 1e-10 of the largest control value, in the mean
 * Src   Kozen and Landau 1989 */
ix_status ix_decompose(ix_ctx *ctx, const ix_mv *crv, ix_mv **f,
                       ix_mv **g) IX_MUST_CHECK;

/* --- matching and morphing ---------------------------------------------------
 */

/* What makes two points of two curves a good pair; T are unit tangents, d the
 * unit vector from one to the other. */
typedef enum {
    IX_MATCH_RULED = 1, /* T1.T2 - (|N1||N2| - N1.N2) / 2, N = T x d: ruled
                           surfaces that are nearly developable */
    IX_MATCH_MORPH,     /* T1.T2 */
    IX_MATCH_WALK,      /* 1 - distance / largest distance */
    IX_MATCH_BISECT     /* T2 and T1 mirrored at the plane between: one circle
                           touches both */
} ix_match_norm;
typedef struct {
    int samples; /* of each curve, even in the parameter, 2 .. 4096 */
    int length;  /* control points of the reparametrisation */
    int order;   /* of it */
    bool rotate; /* a closed c2 may begin anywhere */
    ix_match_norm norm;
    bool allow_negative; /* pairs of negative value are allowed */
} ix_match_opts;

/* c2 reparametrised, on c1's domain, so that points with equal parameters are
 * pairs of the largest mean value.
 *
 * Out   *out    c2(r(t)), r a non-falling spline from end to end
 *       *worth  NULL, or the mean value over the path, at most 1
 * Err   IX_EARG not 2 <= order <= length <= samples, norm; IX_EDOMAIN no path
 *       without negative pairs, poles
 * Num   O(samples^2); rotating, 64 times that
 * Src   Cohen, Elber, Bar-Yehuda 1997 */
ix_status ix_match(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                   const ix_match_opts *o, double *worth,
                   ix_mv **out) IX_MUST_CHECK;

/* How ix_morph goes. */
typedef struct {
    bool levels;    /* exchange details, coarse to fine; else turn edges */
    bool by_length; /* edges: sizes are polygon lengths, else diagonals of
                       boxes */
    bool follow;    /* edges: neighbours turn the same way (no tangencies on
                       the way), else each the shorter way */
} ix_morph_how;

/* Curves from c1 (blend 0) to c2 (blend 1) in equal steps of at most step.
 *
 * In    c1, c2  same order, knots, point type
 * Out   *out    as c1; with levels: open B-splines; t holds the blend
 * Err   IX_EARG not compatible, step not in [1e-4, 1], more than 3 coordinates,
 *       levels of rational curves
 * Src   Sederberg, Gao, Wang, Mu 1993 (edges) */
ix_status ix_morph(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                   ix_morph_how how, double step, ix_crvs *out) IX_MUST_CHECK;

/* --- points without order
 * ------------------------------------------------------ */

typedef enum {
    IX_CLOUD_POINT = 1, /* distances from foot points */
    IX_CLOUD_SQUARED    /* squared distance to the curve: fewer iterations */
} ix_cloud_how;
typedef struct {
    ix_cloud_how how;
    int max_iter;
    double err_limit;    /* stop at this root mean square distance */
    double change_limit; /* stop when it changes by no more */
    double lambda;       /* weight of the integral of |C''|^2, domain as [0, 1],
                            against the mean square distance */
} ix_cloud_opts;

/* A B-spline near n points double[ncoords][n] that have no order, from a first
 * curve with the wanted knots. Finds a local optimum.
 *
 * Out   *out  knots of init; *err (may be NULL) the root mean square distance
 * Err   IX_EARG init not polynomial or of another dimension, n < 2, options;
 *       IX_EDOMAIN points leave control points undetermined (lambda 0)
 * Src   Wang, Pottmann, Liu 2006 */
ix_status ix_fit_cloud(ix_ctx *ctx, int n, int ncoords, const double *pts,
                       const ix_mv *init, const ix_cloud_opts *o, double *err,
                       ix_mv **out) IX_MUST_CHECK;
/* A first curve from the points' spread: a line, or for periodic an ellipse,
 * along their principal axes. */
ix_status ix_fit_cloud_start(ix_ctx *ctx, int n, int ncoords, const double *pts,
                             int length, int order, bool periodic,
                             ix_mv **out) IX_MUST_CHECK;

/* --- conics of distances
 * ------------------------------------------------------- */

/* Polylines: n of them, count[i] points each, one after the other in pt. */
typedef struct {
    int n;
    int *count;
    double (*pt)[3];
    size_t bytes;
} ix_lines;
void ix_lines_free(ix_ctx *ctx, ix_lines *l);

/* Points of the plane whose distances to two curves (x and y count), measured
 * along normals, add up to sum: the scalar field over their parameters (s, t)
 * that vanishes where the normals at C1(s), C2(t) meet in such a point. It
 * vanishes too where a difference of the distances is +-sum, and where the
 * normals are one line. Polynomial, E1.
 *
 * Err   IX_EARG not two planar curves, sum not positive */
ix_status ix_conic_distance(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                            double sum, ix_mv **out) IX_MUST_CHECK;
/* The locus itself, without the differences: polylines in (s, t, 0), or of the
 * points (x, y, 0). tol as in ix_curves_opts. */
ix_status ix_conic_locus(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         double sum, bool euclid, double tol,
                         ix_lines *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
