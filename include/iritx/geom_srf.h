/* geom_srf.h - constructors of surfaces and trivariates, and their normals.
 *
 * Directions: u is direction 0, v direction 1; control points have u fastest.
 * All functions borrow their inputs and return a new reference in *out, NULL
 * unless IX_OK. Inputs may be Bezier, power or B-spline; power becomes Bezier,
 * and where one input is a B-spline the result is one. Every function may
 * return IX_ENOMEM; the other errors are listed. */
#ifndef IRITX_GEOM_SRF_H
#define IRITX_GEOM_SRF_H

#include "iritx/geom.h"
#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- layers ------------------------------------------------------------ */

/* The linear blend from a (last parameter 0) to b (1): (1-t) a + t b.
 *
 * In    a, b  as many directions each; made compatible, b's domains are mapped
 *             onto a's; if only one of them is a B-spline, to [0, 1]
 * Out   *out  one direction more, of order 2 on [0, 1]; Bezier if both are
 * Err   IX_EARG numbers of directions differ */
ix_status ix_srf_ruled(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                       ix_mv **out) IX_MUST_CHECK;

/* n >= 2 multivariates as control layers of a new last direction.
 *
 * In    order  of the new direction, >= 2; lowered to n if larger
 *       kv     IX_KV_OPEN, _FLOAT: uniform on [0, 1]; IX_KV_PERIODIC: uniform
 *              steps of 1 / (n - order + 1), one period long
 * Out   Bezier if all layers are and order = n and kv is open
 * Err   IX_EARG n, order, kv, or layers with different directions */
ix_status ix_srf_layers(ix_ctx *ctx, int n, const ix_mv *const *layers,
                        int order, ix_kv_kind kv, ix_mv **out) IX_MUST_CHECK;

/* m moved along vec: m + t vec, t in [0, 1] the new last direction. The point
 * type is widened to as many coordinates as vec needs.
 * Err   IX_EARG vec is zero or not finite */
ix_status ix_srf_extrude(ix_ctx *ctx, const ix_mv *m, const double vec[3],
                         ix_mv **out) IX_MUST_CHECK;

/* Cubic Hermite blend of curves, u the Hermite direction (order 4):
 * position b1 and derivative t1 at u = 0, b2 and t2 at u = 1; control rows
 * b1, b1 + t1/3, b2 - t2/3, b2. The curves' parameter is v. Exact; rational
 * input gets common denominators. */
ix_status ix_srf_hermite(ix_ctx *ctx, const ix_mv *b1, const ix_mv *b2,
                         const ix_mv *t1, const ix_mv *t2,
                         ix_mv **out) IX_MUST_CHECK;

/* --- interpolation ----------------------------------------------------- */

/* The B-spline in a new last direction that passes through n >= 2 layers
 * (skinning): layer k at parameter tau_k.
 *
 * In    order  <= n
 *       kv     IX_KV_OPEN or _FLOAT on [0, 1], tau the mean of those that how
 *              gives for each row of control points; IX_KV_PERIODIC: tau_k = k
 * / n, domain [0, 1] Err   IX_EARG as ix_srf_layers, or order > n; IX_EDOMAIN
 * the layers do not determine the surface (even n and odd order when periodic),
 * or all layers are the same and how is not uniform */
ix_status ix_srf_skin(ix_ctx *ctx, int n, const ix_mv *const *layers, int order,
                      ix_kv_kind kv, ix_param how, ix_mv **out) IX_MUST_CHECK;

/* The open B-spline surface on [0, 1]^2 through a grid of points at uniform
 * parameters, or nearest to them in the sense of least squares where size <
 * count.
 *
 * In    pts    double[axes][count[0] * count[1]], u fastest
 *       order  [2]; size [2] control points, 0: as many as data
 * Err   IX_EARG order <= size <= count is not so */
ix_status ix_srf_fit_grid(ix_ctx *ctx, const int count[2], int ncoords,
                          bool rational, const double *pts, const int order[2],
                          const int size[2], ix_mv **out) IX_MUST_CHECK;

/* The same nearest to the projected surface srf, sampled 4 times as densely as
 * the control points, over srf's domain; size 0: as srf. *err is the largest
 * distance at the samples. */
ix_status ix_srf_fit_surface(ix_ctx *ctx, const ix_mv *srf, const int order[2],
                             const int size[2], double *err,
                             ix_mv **out) IX_MUST_CHECK;

/* The same nearest to n scattered data points: uv double[2][n] in [0, 1],
 * values double[ncoords][n]. Err IX_EARG a parameter outside, sizes below the
 * orders; IX_EDOMAIN the points do not determine all control points. */
ix_status ix_srf_fit_points(ix_ctx *ctx, int n, const double *uv, int ncoords,
                            const double *values, const int order[2],
                            const int size[2], ix_mv **out) IX_MUST_CHECK;

/* The same for any number of directions: count, order, size [ndirs]. */
ix_status ix_mv_fit_grid(ix_ctx *ctx, int ndirs, const int *count, int ncoords,
                         bool rational, const double *pts, const int *order,
                         const int *size, ix_mv **out) IX_MUST_CHECK;
/* n points with parameters double[ndirs][n] and values double[ncoords][n]. */
typedef struct {
    int ndirs, n;
    const double *params;
    int ncoords;
    const double *values;
} ix_cloud;
ix_status ix_mv_fit_points(ix_ctx *ctx, const ix_cloud *c, const int *order,
                           const int *size, ix_mv **out) IX_MUST_CHECK;
/* The freeform whose values at m's nodes (Greville abscissae) are m's control
 * points, with m's bases, orders and knots; or nearest to them where order or
 * size [ndirs] (0: as m's) are others, then open B-splines over m's domain with
 * the knots of ix_params_knots. Rational: in homogeneous coordinates.
 *
 * Err   IX_EARG order <= size <= m's length is not so, or another order or size
 *       where m is periodic or float; IX_EDOMAIN the nodes do not determine the
 *       control points (two nodes are one: a knot as often as the order) */
ix_status ix_mv_fit_nodes(ix_ctx *ctx, const ix_mv *m, const int *order,
                          const int *size, ix_mv **out) IX_MUST_CHECK;

/* How far data are from what was fitted to them. */
typedef struct {
    double rms, largest;
} ix_fit_error;

/* --- polynomials near data ----------------------------------------------- */

/* Forms in two variables; terms by rising total degree, in that by falling
 * powers of u: 1, u, v, u^2, uv, v^2, ... */
typedef enum {
    IX_FORM_LINEAR = 1,  /* 1 u v */
    IX_FORM_BILINEAR,    /* and uv */
    IX_FORM_QUADRATIC,   /* 1 u v u^2 uv v^2 */
    IX_FORM_BIQUADRATIC, /* u^i v^j, i and j up to 2: 9 */
    IX_FORM_CUBIC,       /* i + j up to 3: 10 */
    IX_FORM_BICUBIC      /* i and j up to 3: 16 */
} ix_form_kind;
enum { IX_FORM_MOST = 16 };
/* The powers of u and v of the terms, and their number; 0 of no such form. */
int ix_form_terms(ix_form_kind kind, int power[IX_FORM_MOST][2]);
/* Of one coordinate, about a center. */
double ix_form_value(ix_form_kind kind, const double *coef,
                     const double center[2], const double uv[2]);

typedef struct {
    ix_form_kind kind;
    bool centred; /* about the mean of the parameters, else the origin */
    int n;
    const double *uv; /* double[2][n] */
    int ncoords;
    const double *values; /* double[ncoords][n] */
} ix_form_data;
/* The form nearest to n data points in the sense of least squares.
 *
 * Out   coef    double[ncoords][terms], in powers of u - center[0] and
 *               v - center[1]
 *       *err    NULL, or receives distances of the data from it
 * Err   IX_EARG no such form, fewer points than terms, not finite parameters;
 *       IX_EDOMAIN the parameters do not determine the form (they lie on a
 *       curve of its kind)
 * Num   solved about the mean by orthogonal transformations; far from the data
 *       coefficients about the origin lose digits to cancellation */
ix_status ix_fit_form(ix_ctx *ctx, const ix_form_data *d, double center[2],
                      ix_fit_error *err, double *coef) IX_MUST_CHECK;

/* --- ruled surfaces near others ---------------------------------------- */

/* How to fit one ruled surface. */
typedef struct {
    int dir;       /* 0 or 1: the direction of srf along which rulings run */
    double extend; /* 0 .. 1: srf is continued by this part of its domain at
                      both ends of the other direction, so that rulings may lean
                      at the ends too */
    int samples;   /* 2 .. 1000: places on each side where rulings may end */
} ix_ruled_opts;

/* The ruled surface nearest to a surface, all of which it is to cover.
 *
 * Rulings first join places of the two sides so that the mean squared distance
 * of the surface from them is least, without crossing (dynamic programming).
 * Then both sides, splines, move: least squares of distances, each point of the
 * surface measured from the nearest one of the ruled surface, until that
 * settles (a local optimum). The sides have srf's order and knots, each span
 * halved as long as there are at most order + samples / 4 control points, and
 * (t + r) / 2 as parameter where rulings first joined the parameters t and r. A
 * result that is worse than the ruled surface between the two sides of srf
 * gives way to it; it is also the answer where srf is ruled, then with srf's
 * rational points.
 *
 * Out   *out  order 2 in direction dir. The sides of a closed srf need not
 *             close
 *       *err  NULL, or distances of points of srf, even in its parameters,
 *             twice as many along its sides as samples, from the result
 * Err   IX_EARG not a surface of at most 3 coordinates, orders below 2, options
 *       IX_EDOMAIN poles
 * Num   O(samples^2 + points); deterministic
 * Src   damped tangent distances: Wang, Pottmann, Liu 2006 */
ix_status ix_srf_fit_ruled(ix_ctx *ctx, const ix_mv *srf,
                           const ix_ruled_opts *o, ix_fit_error *err,
                           ix_mv **out) IX_MUST_CHECK;

/* --- revolution -------------------------------------------------------- */

/* How a full turn is represented. */
typedef enum {
    IX_TURN_RATIONAL,  /* exact: order 3, 9 points, domain [0, 4] */
    IX_TURN_POLYNOMIAL /* cubic arcs, radius within 2.8e-4: order 4, 13 points,
                          domain [0, 4] */
} ix_turn;

/* The curve turned about the Z axis, counter-clockwise seen from +Z, beginning
 * at the curve itself. u is the rotation, one unit a quarter turn; v the
 * curve's parameter.
 * Err   IX_EARG a rational curve with IX_TURN_POLYNOMIAL, not one direction */
ix_status ix_srf_revolve(ix_ctx *ctx, const ix_mv *crv, ix_turn turn,
                         ix_mv **out) IX_MUST_CHECK;

/* A surface turned the same way: a trivariate, (u, v) the surface's parameters,
 * w the rotation. Err IX_EARG as above, not two directions. */
ix_status ix_tv_revolve(ix_ctx *ctx, const ix_mv *srf, ix_turn turn,
                        ix_mv **out) IX_MUST_CHECK;

/* Any part of a turn about any axis. */
typedef struct {
    ix_turn turn;
    double a0, a1;            /* degrees, exchanged if a0 > a1; 360 apart or
                                 more: the full turn */
    double point[3], axis[3]; /* a point of the axis, its direction */
} ix_revolution;
/* As ix_tv_revolve, the rotation by a1 - a0 beginning at a0. w runs over
 * [0, t(a1 - a0)], t the parameter of that angle on the circle of the turn.
 * Err   IX_EARG as ix_tv_revolve, a0 = a1, the axis is zero, not finite */
ix_status ix_tv_revolve_about(ix_ctx *ctx, const ix_mv *srf,
                              const ix_revolution *r,
                              ix_mv **out) IX_MUST_CHECK;

/* The part between the angles a0 and a1 in degrees (exchanged if a0 > a1): u
 * runs over [0, t(a1 - a0)] where t is the parameter of that angle on the
 * rational circle. 360 degrees or more give the full turn.
 * Err   IX_EARG a0 = a1 or not finite */
ix_status ix_srf_revolve_part(ix_ctx *ctx, const ix_mv *crv, double a0,
                              double a1, ix_mv **out) IX_MUST_CHECK;

/* As the two above, about the axis through the origin in direction axis; full
 * turn if a1 - a0 is 360 or more. Err IX_EARG axis is zero. */
ix_status ix_srf_revolve_axis(ix_ctx *ctx, const ix_mv *crv, double a0,
                              double a1, const double axis[3],
                              ix_mv **out) IX_MUST_CHECK;

/* Parameter in [0, 4] of the point at the given angle, 0 .. 360 degrees, of
 * the circle of four rational quadratic arcs: q + r / (1 + r) for the quarter
 * q and r = sqrt(2) T / (1 - T), T the tangent of half the remaining angle. */
double ix_circle_param(double degrees);

/* --- patches from boundaries ------------------------------------------- */

/* Bilinearly blended patch of four boundary curves (Coons 1967):
 * S(., 0) = c1, S(., 1) = c2, S(0, .) = c3, S(1, .) = c4, domain [0, 1]^2.
 * Rational boundaries whose weights agree at the corners are blended in
 * homogeneous coordinates, which keeps the degree; else as fractions.
 * Err   IX_EARG corners apart by more than 1e-5 of the size of the corners */
ix_status ix_srf_boolsum(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         const ix_mv *c3, const ix_mv *c4,
                         ix_mv **out) IX_MUST_CHECK;
/* A closed curve cut at quarters of its domain, then ix_srf_boolsum. */
ix_status ix_srf_boolone(ix_ctx *ctx, const ix_mv *crv,
                         ix_mv **out) IX_MUST_CHECK;

/* --- ribs --------------------------------------------------------------- */

/* A rib along a curve on a surface. */
typedef struct {
    const ix_mv *path; /* (u, v)(t) inside the surface's domain; no corners */
    const ix_mv *section; /* (x, y) from (-1, 0) to (1, 0) */
    double tan_scale;     /* of the tangents across, > 0 */
    double width, height;
    /* NULL, or curves over the path whose second coordinate (the only one of a
     * scalar curve) multiplies these; their domains are mapped to the path's */
    const ix_mv *width_crv, *height_crv;
} ix_rib;

/* With p+ and p- the curves of the parameter plane on the left and on the right
 * of the path, from which they are half the width away: steps whose images in
 * the tangent plane are perpendicular to the curve on the surface,
 *
 *   R(u, t) = H((1 + x(u)) / 2, t) + y(u) height(t) N(t),
 *
 * where H is the cubic Hermite surface from S(p-) to S(p+) whose derivatives
 * across are those of S along p+ - p-, times tan_scale, and N the unit normal
 * S_v x S_u on the path.
 *
 * Out   *out  over [0, 1]^2: u across as the section, t along; S(p-) at u = 0.
 *             In tangent contact with S along both borders, exactly, where the
 *             section is horizontal at its ends (y' = 0). With d the sum of S's
 *             degrees, of degree 3 d (rational: 12 d) along, of 3 times the
 *             section's across; straight borders: a third of that
 * Err   IX_EARG not a surface or curves, the section's ends, tan_scale, a width
 *       that is not positive; IX_EDOMAIN the path or a border leaves the
 * domain, a corner, a singular point (the message tells the parameter);
 * IX_EUNABLE a border is not followed by 1024 control points Num   the borders
 * are within 1e-4 of half the width of where they should be, the normals within
 * 1e-4; contact is exact up to rounding */
ix_status ix_srf_rib(ix_ctx *ctx, const ix_mv *srf, const ix_rib *o,
                     ix_mv **out) IX_MUST_CHECK;

/* --- quadrics ---------------------------------------------------------- */

/* A patch of the surface
 *
 *   A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0
 *
 * with coef = A .. J, as a rational biquadratic Bezier surface (P3) with
 * positive weights, symmetric to the principal axes: 120 degrees of ellipses,
 * hyperbolas with parameter -1 .. 1 from their vertex, everything unbounded
 * over [-1, 1] along its axes; of two sheets one, of a cone both halves.
 *
 * Err   IX_EARG not finite; IX_EDOMAIN no real points, a point, a line, two
 *       planes (the message tells)
 * Num   exact up to rounding; zero is what is below 1e-12 of its terms */
ix_status ix_srf_quadric(ix_ctx *ctx, const double coef[10],
                         ix_mv **out) IX_MUST_CHECK;

/* The cylinder over the conic A x^2 + B xy + C y^2 + D x + E y + F = 0 (coef =
 * A .. F) from the plane z = 0 (v = 0) to z = height; as above. */
ix_status ix_srf_conic_cylinder(ix_ctx *ctx, const double coef[6],
                                double height, ix_mv **out) IX_MUST_CHECK;

/* --- sums, products, distances ----------------------------------------- */

/* S(u, v) = a(u) + b(v); any number of directions each, a's first. */
ix_status ix_srf_algsum(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        ix_mv **out) IX_MUST_CHECK;
/* S(u, v) = (x1 x2, x1 y2, y1) of a profile a = (x1, y1)(u) and a trajectory
 * b = (x2, y2)(v). Err IX_EARG fewer than two coordinates. */
ix_status ix_srf_swung(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                       ix_mv **out) IX_MUST_CHECK;

typedef enum {
    IX_DIST_VECTOR,   /* a - b */
    IX_DIST_SQUARED,  /* |a - b|^2 */
    IX_DIST_NORMAL_A, /* <a - b, N_a>, N_a the normal below, not normalised */
    IX_DIST_NORMAL_B  /* <a - b, N_b> */
} ix_dist;
/* A distance function over the product of the domains, a's directions first.
 * The normal of a planar curve is (y', -x'), that of a surface S_v x S_u.
 * Err   IX_EARG a normal of anything else is asked for */
ix_status ix_srf_distance(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          ix_dist what, ix_mv **out) IX_MUST_CHECK;

/* --- sweeping ---------------------------------------------------------- */

typedef enum {
    IX_FRAME_MINIMAL, /* rotation minimising; begins with the least rotation
                         that takes +Z to the tangent */
    IX_FRAME_VECTOR,  /* the section's Y axis is as near to vec as possible */
    IX_FRAME_CURVE    /* the same with a vector field along the axis */
} ix_frame;

typedef struct {
    int nsections; /* >= 1; several are spread evenly over the axis and
                      blended linearly in between */
    const ix_mv *const *sections; /* curves near the XY plane */
    const ix_mv *axis;
    double factor;      /* constant scale */
    const ix_mv *scale; /* NULL or a curve whose second coordinate (the only
                           one of a scalar curve) multiplies factor; its domain
                           is mapped to the axis' */
    ix_frame frame;
    double vec[3];
    const ix_mv *field; /* domain mapped to the axis' */
    int refine;         /* knots inserted in the axis before, evenly spaced */
} ix_sweep;

/* u along the section, v along the axis. At each control point of the axis
 * stands the section, scaled, in the frame at that point's node (Greville
 * abscissa): the section's origin runs exactly along the axis, the section is
 * exact where the axis is straight and approximate elsewhere (refine it).
 * Frames by double reflection (Wang, Juettler, Zheng, Liu 2008).
 * Err   IX_EARG a section or axis that is no curve, more than 3 coordinates;
 *       IX_EDOMAIN the axis has a zero tangent, or a binormal is parallel to
 *       it, at the parameter told */
ix_status ix_srf_sweep(ix_ctx *ctx, const ix_sweep *s,
                       ix_mv **out) IX_MUST_CHECK;

/* --- normals, tangents ------------------------------------------------- */

/* Unit normal S_v x S_u at (u, v). At a degenerate point it is taken a little
 * inside the domain. Err IX_EDOMAIN outside, at a pole, or no normal there. */
ix_status ix_srf_normal(ix_ctx *ctx, const ix_mv *srf, double u, double v,
                        double n[3]) IX_MUST_CHECK;
/* The partial derivative of the projected surface in direction dir, 3
 * coordinates (missing ones 0). Err IX_EDOMAIN outside or at a pole. */
ix_status ix_srf_tangent(ix_ctx *ctx, const ix_mv *srf, int dir, double u,
                         double v, double t[3]) IX_MUST_CHECK;
/* The same with length 1. Err IX_EDOMAIN also where it vanishes. */
ix_status ix_srf_unit_tangent(ix_ctx *ctx, const ix_mv *srf, int dir, double u,
                              double v, double t[3]) IX_MUST_CHECK;
/* The field S_v x S_u, exact and not normalised: three coordinates, polynomial
 * of degrees 2d - 1, or for rational S = X/w the lowest common form
 * (w X_v x X_u - w_v X x X_u - w_u X_v x X) / w^3 of degrees 3d.
 * Err   IX_EARG not a surface with two or three coordinates */
ix_status ix_srf_normal_field(ix_ctx *ctx, const ix_mv *srf,
                              ix_mv **out) IX_MUST_CHECK;
/* A cone that holds all normals S_v x S_u: unit axis and half angle in
 * radians, from the control vectors of the field; pi where they do not fit
 * into a half space. Err IX_EDOMAIN the field vanishes identically. */
ix_status ix_srf_normal_cone(ix_ctx *ctx, const ix_mv *srf, double axis[3],
                             double *half_angle) IX_MUST_CHECK;

/* --- volumes ----------------------------------------------------------- */

/* What is integrated over the surface, N = S_u x S_v, S = (x, y, z):
 *
 *   origin       S.N / 3: the volume of the cone over it from the origin
 *   else         x^i y^j z^(k+1) / (k+1) N_z, (i, j, k) = power: the integral
 *                of x^i y^j z^k over the space between it and the XY plane
 *
 * For a closed surface both are integrals over what it encloses (up to the
 * sign of its orientation). */
typedef struct {
    bool origin;
    int power[3]; /* 0 .. 2 each */
} ix_volume;

/* The integral. Num: polynomial exact up to rounding, rational within 1e-13.
 * Err   IX_EARG not a surface in space, powers; IX_EDOMAIN a pole; IX_EUNABLE
 *       a rational integral does not settle (weights near 0) */
ix_status ix_srf_volume(ix_ctx *ctx, const ix_mv *srf, const ix_volume *what,
                        double *out) IX_MUST_CHECK;
/* The integral from the lower corner of the domain to (u, v), as a scalar
 * surface; polynomial surfaces only (IX_EARG). */
ix_status ix_srf_volume_field(ix_ctx *ctx, const ix_mv *srf,
                              const ix_volume *what, ix_mv **out) IX_MUST_CHECK;

/* --- other representations --------------------------------------------- */

/* (1 - t) a + t b, control point by control point.
 * Err   IX_EARG a and b differ in directions, orders, lengths or point type,
 *       or in a knot by more than 1e-5 of the domain */
ix_status ix_mv_morph(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, double t,
                      ix_mv **out) IX_MUST_CHECK;
/* The same shape with a parameter transformed by the Moebius map that makes
 * (last weight) / (first weight) of the first row of that direction equal to
 * ratio; 0 stands for 1. Domain kept; B-spline knots move (Lee, Lucian 1991).
 * Err   IX_EARG order 1, ratio negative; IX_EDOMAIN end weights of different
 *       signs or zero */
ix_status ix_mv_moebius(ix_ctx *ctx, const ix_mv *m, int dir, double ratio,
                        ix_mv **out) IX_MUST_CHECK;

/* Integral of B_i,order1(t) B_j,order2(t) over the whole line, both on the
 * knots of dir (a Bezier direction: 0 and 1, order times each).
 * Num   exact up to rounding: Gauss-Legendre of sufficient degree on each span
 * Err   IX_EARG an order or index out of range, power basis */
ix_status ix_bsp_inner(ix_ctx *ctx, const ix_dir *dir, const int order[2],
                       const int index[2], double *out) IX_MUST_CHECK;

/* --- sampling, similarity ---------------------------------------------- */

/* n random parameters of a curve or surface: double[ndirs][n], uniform in the
 * domain, or (by_measure) in arc length or area, by rejection.
 *
 * In    *random  state of the generator, changed
 * Err   IX_EARG  not a curve or surface with at most 3 coordinates, n < 0;
 *       IX_EDOMAIN a pole, or length or area is 0 */
ix_status ix_spread(ix_ctx *ctx, const ix_mv *m, bool by_measure, int n,
                    uint64_t *random, double *out) IX_MUST_CHECK;

/* A similarity of the XY plane, x' = t + s R(angle) x. */
typedef struct {
    double shift[2], scale, degrees;
} ix_similarity;
/* Whether b is the image of a, control point by control point (projected;
 * weights in proportion, z the same) within eps: least squares in the complex
 * plane. *found is false also where the representations differ, or all points
 * of a are one. Err IX_EARG fewer than two coordinates; IX_EDOMAIN weight 0 */
ix_status ix_similar(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, double eps,
                     bool *found, ix_similarity *out) IX_MUST_CHECK;

/* --- folds of trivariates ---------------------------------------------- */

/* det(T_u, T_v, T_w) over the parameters of T: a polynomial scalar, of degree
 * 3d-1; of a rational T its product with w^4, 4d-1.
 * Err   IX_EARG not a Bezier or B-spline trivariate of 3 coordinates */
ix_status ix_tv_jacobian(ix_ctx *ctx, const ix_mv *t,
                         ix_mv **out) IX_MUST_CHECK;

/* Where that changes its sign: T folds there, or is turned inside out. A
 * surface of triangles, each a line of three points, in the parameters of T or
 * (euclid) on T itself; counter-clockwise seen, in the parameters, from where
 * the determinant is positive.
 *
 * In    cells  boxes to each span of the knots of T, a direction; of a fold
 *              that is smaller than one nothing may be seen
 * Err   IX_EARG    as above, cells < 1
 *       IX_EDOMAIN the determinant is zero everywhere
 *       IX_EUNABLE more than 20 million boxes
 * Num   vertices are zeros along edges of the boxes, their sides' and their own
 *       diagonals, to rounding; the triangles have no gaps. Where the
 *       determinant touches zero without a change of sign there is no fold
 * Src   Joy & Duchaineau 1999; marching tetrahedra, Doi & Koide 1991 */
ix_status ix_tv_fold(ix_ctx *ctx, const ix_mv *t, const int cells[3],
                     bool euclid, ix_lines *out) IX_MUST_CHECK;

/* --- triangular Bezier patches ----------------------------------------- */

/* Control points double[naxes][n (n+1) / 2] for order n: index j over the
 * power of w outermost, i over that of v inside, so that point 0 belongs to
 * u^(n-1). Value at barycentric (u, v, w), u + v + w = 1 within 1e-5.
 * Err   IX_EARG order < 1 or > IX_MAX_ORDER; IX_EDOMAIN the sum is not 1 */
ix_status ix_tri_eval(ix_ctx *ctx, int order, int naxes, const double *pts,
                      const double uvw[3], double *out) IX_MUST_CHECK;
/* Control points double[naxes][order] of the curve on which parameter dir is t,
 * s in [0, 1]: (t, (1-t)(1-s), (1-t)s) for dir 0, ((1-t)(1-s), t, (1-t)s) for
 * 1,
 * ((1-t)(1-s), (1-t)s, t) for 2: a Bezier curve of the same order.
 * Err   IX_EARG order, dir; IX_EDOMAIN t outside [0, 1] */
ix_status ix_tri_iso(ix_ctx *ctx, int order, int naxes, int dir, double t,
                     const double *pts, double *out) IX_MUST_CHECK;
/* Control points of the derivative (order - 1; an order of 1 gives one zero),
 * every axis by itself: dir 0 with respect to u and 1 to v, both with
 * w = 1 - u - v; dir 2 with respect to w with u = 1 - v - w. */
void ix_tri_derive(int order, int naxes, int dir, const double *pts,
                   double *out);

#ifdef __cplusplus
}
#endif
#endif
