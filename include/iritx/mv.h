/* mv.h - the one geometry type: a multivariate with any number of directions.
 *
 * A multivariate maps a box of parameters to m coordinates. A curve has one
 * direction, a surface two, a trivariate three. Each direction is Bezier,
 * B-spline or power basis; a weight makes it rational.
 *
 * Shapes. Control points are double[axes][npts]: each axis contiguous, the
 * weight axis first when rational, direction 0 fastest inside an axis.
 * axes = ncoords + (rational ? 1 : 0), npts = product of the lengths.
 * Rational points are homogeneous: (w, w x, w y, ...).
 *
 * Knots. order o, length n: o + n knots, domain [knots[o-1], knots[n]].
 * Periodic: n stored points stand for n + o - 1 (point i is point i mod n),
 * n + 2 o - 1 knots, domain [knots[o-1], knots[n+o-1]]. Bezier and power:
 * no knots, length = order, domain [0, 1].
 *
 * Ownership. Multivariates are immutable and counted; functions borrow their
 * inputs and return new references (possibly to the input itself). */
#ifndef IRITX_MV_H
#define IRITX_MV_H

#include "iritx/base.h"

#ifdef __cplusplus
extern "C" {
#endif

#define IX_MAX_DIRS   16
#define IX_MAX_COORDS 18
#define IX_MAX_ORDER  1024

typedef struct ix_mv ix_mv;

typedef enum { IX_BEZIER, IX_BSPLINE, IX_POWER } ix_basis;

/* One direction, as given to ix_mv_new and told by ix_mv_dir. */
typedef struct {
    ix_basis basis;
    int order;           /* 1 .. IX_MAX_ORDER */
    int length;          /* stored control points; = order unless B-spline */
    bool periodic;       /* B-spline only */
    const double *knots; /* B-spline only; non-decreasing */
} ix_dir;

/* --- making and reading ------------------------------------------------ */

/* A new multivariate.
 *
 * In    dirs   ndirs directions (1 .. IX_MAX_DIRS); knots are copied
 *       pts    double[axes][npts], finite; copied
 * Err   IX_EARG  an order, length, coordinate count or knot vector is not
 *                legal (the message names the direction, the knot's index
 *                and value), or a number is not finite
 * Num   knots that differ by no more than 4 ulp are made equal */
ix_status ix_mv_new(ix_ctx *ctx, int ndirs, const ix_dir *dirs, int ncoords,
                    bool rational, const double *pts,
                    ix_mv **out) IX_MUST_CHECK;

ix_mv *ix_mv_ref(const ix_mv *m);              /* a new reference to m */
void ix_mv_unref(ix_ctx *ctx, const ix_mv *m); /* m may be NULL */

int ix_mv_ndirs(const ix_mv *m);
ix_dir ix_mv_dir(const ix_mv *m, int dir); /* knots: view into m */
int ix_mv_order(const ix_mv *m, int dir);
int ix_mv_length(const ix_mv *m, int dir);
int ix_mv_nknots(const ix_mv *m, int dir); /* 0 unless B-spline */
int ix_mv_ncoords(const ix_mv *m);
bool ix_mv_rational(const ix_mv *m);
int ix_mv_naxes(const ix_mv *m);
size_t ix_mv_npts(const ix_mv *m);
/* View into m: double[npts] of one axis (axis 0 is the weight if rational). */
const double *ix_mv_axis(const ix_mv *m, int axis);
/* View into m: double[npts] of coordinate c = 0 .. ncoords-1. */
const double *ix_mv_coord(const ix_mv *m, int c);
const double *ix_mv_weights(const ix_mv *m); /* NULL unless rational */
void ix_mv_domain(const ix_mv *m, int dir, double dom[2]);

/* --- evaluation ---------------------------------------------------------
 * Parameters must lie in the domain up to 1e-5 times its length, then they
 * are clamped; Bezier and power directions of curves and surfaces, and those
 * B-splines that are Bezier (one open span), accept any parameter (they
 * extrapolate). At interior knots the piece to the right
 * counts, at the upper end the last piece. */

/* Homogeneous value at t[ndirs]: out[axes]. Err IX_EDOMAIN outside. */
ix_status ix_mv_eval(ix_ctx *ctx, const ix_mv *m, const double *t,
                     double *out) IX_MUST_CHECK;

/* Projected value: out[ncoords]. Err IX_EDOMAIN outside or at a pole. */
ix_status ix_mv_point(ix_ctx *ctx, const ix_mv *m, const double *t,
                      double *out) IX_MUST_CHECK;

/* Partial derivative of the homogeneous coordinates, k[ndirs] times in each
 * direction, taken of every axis including the weight: out[axes]. */
ix_status ix_mv_partial(ix_ctx *ctx, const ix_mv *m, const double *t,
                        const int *k, double *out) IX_MUST_CHECK;

/* Euclidean derivatives of a curve: out[(order + 1)][ncoords], derivatives
 * 0 .. order of the projected curve. Err IX_EDOMAIN outside or at a pole. */
ix_status ix_mv_curve_derivs(ix_ctx *ctx, const ix_mv *m, double t, int order,
                             double *out) IX_MUST_CHECK;

/* Many points at once: t is double[ndirs][n], out double[axes][n]; uses all
 * threads. Err IX_EDOMAIN names the first parameter outside. */
ix_status ix_mv_eval_many(ix_ctx *ctx, const ix_mv *m, size_t n,
                          const double *t, double *out) IX_MUST_CHECK;
/* The same, projected: out double[ncoords][n], not finite at a pole. */
ix_status ix_mv_point_many(ix_ctx *ctx, const ix_mv *m, size_t n,
                           const double *t, double *out) IX_MUST_CHECK;
/* On the grid of params[d][counts[d]], direction 0 fastest:
 * out double[axes][product of counts]. */
ix_status ix_mv_eval_grid(ix_ctx *ctx, const ix_mv *m, const int *counts,
                          const double *const *params,
                          double *out) IX_MUST_CHECK;

/* Blossom (polar form) of a curve or surface at order-1 values a direction,
 * args[dir][order-1]: homogeneous out[axes]. */
ix_status ix_mv_blossom(ix_ctx *ctx, const ix_mv *m, const double *const *args,
                        double *out) IX_MUST_CHECK;

/* --- the same shape, represented otherwise ------------------------------ */

/* Bezier/power directions become open B-splines on [0, 1]. */
ix_status ix_mv_to_bspline(ix_ctx *ctx, const ix_mv *m,
                           ix_mv **out) IX_MUST_CHECK;
/* Periodic directions become float (points repeated, knots kept). */
ix_status ix_mv_to_float(ix_ctx *ctx, const ix_mv *m,
                         ix_mv **out) IX_MUST_CHECK;
/* Periodic and float directions become open (clamped) by knot insertion. */
ix_status ix_mv_to_open(ix_ctx *ctx, const ix_mv *m, ix_mv **out) IX_MUST_CHECK;
/* Power <-> Bezier, exact; B-spline input is refused (IX_EARG). */
ix_status ix_mv_power_to_bezier(ix_ctx *ctx, const ix_mv *m,
                                ix_mv **out) IX_MUST_CHECK;
ix_status ix_mv_bezier_to_power(ix_ctx *ctx, const ix_mv *m,
                                ix_mv **out) IX_MUST_CHECK;
/* The Bezier pieces of a multivariate: *count of them, direction 0 fastest;
 * pieces[i] is a new reference; lo/hi, double[count][ndirs], their original
 * intervals. All arrays live in one block released by ix_mv_pieces_free. */
typedef struct {
    size_t count;
    ix_mv **piece;
    double *lo, *hi; /* double[count][ndirs] */
    size_t bytes;
} ix_mv_pieces;
ix_status ix_mv_to_bezier(ix_ctx *ctx, const ix_mv *m,
                          ix_mv_pieces *out) IX_MUST_CHECK;
void ix_mv_pieces_free(ix_ctx *ctx, ix_mv_pieces *p);

/* Operations that make one direction a B-spline make all of them B-splines, as
 * the file formats have one basis for a whole object. */

/* Inserts n knots (sorted inside) in one direction; Bezier becomes B-spline,
 * periodic becomes float. Err IX_EARG a knot outside the domain, or a
 * multiplicity above the order. */
ix_status ix_mv_insert_knots(ix_ctx *ctx, const ix_mv *m, int dir, int n,
                             const double *knots, ix_mv **out) IX_MUST_CHECK;
/* Replaces the knot vector (same number of knots; the shape changes). Bezier
 * becomes B-spline. */
ix_status ix_mv_set_knots(ix_ctx *ctx, const ix_mv *m, int dir, int nknots,
                          const double *knots, ix_mv **out) IX_MUST_CHECK;
/* Raises the order of one direction, exactly; B-splines keep their
 * continuity (each interior knot's multiplicity grows by the difference).
 * Err IX_EARG order below the present one. */
ix_status ix_mv_raise(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                      ix_mv **out) IX_MUST_CHECK;
/* Best approximation of lower order; *err (may be NULL) is a bound of the
 * change of any coordinate; exact (within rounding) for raised input. */
ix_status ix_mv_reduce(ix_ctx *ctx, const ix_mv *m, int dir, int order,
                       double *err, ix_mv **out) IX_MUST_CHECK;
/* Removes interior knots while the change of every coordinate stays below
 * tol (0: only what is removable within rounding). */
ix_status ix_mv_remove_knots(ix_ctx *ctx, const ix_mv *m, int dir, double tol,
                             ix_mv **out) IX_MUST_CHECK;
/* The part over [t0, t1] (exchanged if t0 > t1). Bezier stays Bezier on
 * [0, 1] and may extrapolate; B-spline keeps the interval, becomes open.
 * Err IX_EDOMAIN outside the domain of a B-spline. */
ix_status ix_mv_region(ix_ctx *ctx, const ix_mv *m, int dir, double t0,
                       double t1, ix_mv **out) IX_MUST_CHECK;
ix_status ix_mv_split(ix_ctx *ctx, const ix_mv *m, int dir, double t,
                      ix_mv *out[2]) IX_MUST_CHECK;
/* t -> t_first + t_last - t in one direction (knots mirrored). Periodic: the
 * stored points and the gaps between knots are reversed, the domain stays, so
 * that the closed curve is the same with its start order - 1 knots away. */
ix_status ix_mv_reverse(ix_ctx *ctx, const ix_mv *m, int dir,
                        ix_mv **out) IX_MUST_CHECK;
/* Exchanges two directions. */
ix_status ix_mv_swap_dirs(ix_ctx *ctx, const ix_mv *m, int d1, int d2,
                          ix_mv **out) IX_MUST_CHECK;
/* The domain of one direction becomes [t0, t1], t0 < t1 (B-spline result). */
ix_status ix_mv_reparam(ix_ctx *ctx, const ix_mv *m, int dir, double t0,
                        double t1, ix_mv **out) IX_MUST_CHECK;

/* Point type: adds zero coordinates, drops trailing ones, adds weight 1, or
 * divides every control point by its weight (which changes the shape; weight
 * 0 counts as 1e-14, spec/model 4). */
ix_status ix_mv_coerce(ix_ctx *ctx, const ix_mv *m, int ncoords, bool rational,
                       ix_mv **out) IX_MUST_CHECK;

/* --- two or more multivariates ------------------------------------------ */

/* How to join end to end. */
typedef enum {
    IX_JOIN_SHARED, /* end points agree: one common layer, C0 knot */
    IX_JOIN_BRIDGE, /* a straight bridge between the ends */
    IX_JOIN_JUMP    /* both layers kept, discontinuous knot */
} ix_join;
/* a, then b shifted to continue a's domain; made compatible otherwise. A
 * shared layer is a's; b's homogeneous points are first multiplied by one
 * factor that gives its first point the weight of the end of a. The bridge is
 * a straight segment of order points whose knot span is (D1 + D2) gap /
 * (A1 + A2), D the domains' lengths, A those of the control polygons, lengths
 * below 1e-2 taken as 1e-2 (spec/model 12; means over the rows of surfaces).
 * Order 1 joins with a jump whatever is asked for. */
ix_status ix_mv_merge(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int dir,
                      ix_join how, ix_mv **out) IX_MUST_CHECK;

/* The curve m and a straight segment to the point p[axes] (homogeneous if m is
 * rational), before m (then its domain starts earlier) or after it. The knot
 * span of the segment is that of the curve per length of control polygon
 * (spec/model 12). Becomes an open B-spline. Err IX_EARG not a curve. */
ix_status ix_mv_add_point(ix_ctx *ctx, const ix_mv *m, const double *p,
                          bool before, ix_mv **out) IX_MUST_CHECK;

/* Same point type, orders and knots (b's domains are mapped onto a's).
 * flags: what to make equal. */
enum {
    IX_SAME_POINTS = 1,
    IX_SAME_ORDERS = 2,
    IX_SAME_KNOTS = 4,
    IX_SAME_ALL = 7
};
ix_status ix_mv_compatible(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           unsigned flags, ix_mv **outa,
                           ix_mv **outb) IX_MUST_CHECK;

/* ndirs directions, m's own beginning at start, all others constant (order
 * 1, domain [0, 1]). Err IX_EARG ndirs <= m's, or they do not fit. */
ix_status ix_mv_promote(ix_ctx *ctx, const ix_mv *m, int ndirs, int start,
                        ix_mv **out) IX_MUST_CHECK;
/* A new constant direction at index dir, 0 .. ndirs. */
ix_status ix_mv_insert_dir(ix_ctx *ctx, const ix_mv *m, int dir,
                           ix_mv **out) IX_MUST_CHECK;
/* One parameter fixed: one direction less (at least one must stay). */
ix_status ix_mv_fix(ix_ctx *ctx, const ix_mv *m, int dir, double t,
                    ix_mv **out) IX_MUST_CHECK;
/* Control layer i of a direction, as a multivariate of one direction less. */
ix_status ix_mv_layer(ix_ctx *ctx, const ix_mv *m, int dir, int i,
                      ix_mv **out) IX_MUST_CHECK;
/* n >= 2 multivariates, made compatible, as control layers of a new last
 * direction dir (dir->length = n; its basis, order, knots as given). */
ix_status ix_mv_stack(ix_ctx *ctx, int n, const ix_mv *const *layers,
                      const ix_dir *dir, ix_mv **out) IX_MUST_CHECK;

/* One axis as a scalar polynomial multivariate. */
ix_status ix_mv_scalar(ix_ctx *ctx, const ix_mv *m, int axis,
                       ix_mv **out) IX_MUST_CHECK;
/* Axes from scalar polynomial multivariates, made compatible; with rational
 * the first is the weight. */
ix_status ix_mv_join_scalars(ix_ctx *ctx, int naxes,
                             const ix_mv *const *scalars, bool rational,
                             ix_mv **out) IX_MUST_CHECK;

/* Copy with control point idx replaced by p[axes]. */
ix_status ix_mv_set_point(ix_ctx *ctx, const ix_mv *m, size_t idx,
                          const double *p, ix_mv **out) IX_MUST_CHECK;

/* x' = x M in row vectors (4x4, row-major, translation in the last row),
 * homogeneous, of the first three coordinates; the point type is kept,
 * missing coordinates are 0 before and dropped after. Only a matrix with a
 * perspective part makes a polynomial multivariate rational. */
ix_status ix_mv_transform(ix_ctx *ctx, const ix_mv *m, const double mat[16],
                          ix_mv **out) IX_MUST_CHECK;

/* --- questions ----------------------------------------------------------- */

/* Same representation: bases, orders, lengths, point type exactly; knots and
 * points within eps (absolute). */
bool ix_mv_equal(const ix_mv *a, const ix_mv *b, double eps);
/* Box of the projected control points: lo[ncoords], hi[ncoords]. Err
 * IX_EDOMAIN weights of both signs or zero. */
ix_status ix_mv_bbox(ix_ctx *ctx, const ix_mv *m, double *lo,
                     double *hi) IX_MUST_CHECK;
/* True if some weight is zero or the weights have both signs. */
bool ix_mv_has_poles(const ix_mv *m);

/* --- knot vectors -------------------------------------------------------- */

/* Number of knots of a direction: length + order, periodic length + 2 order
 * - 1; 0 unless B-spline. */
int ix_knots_count(const ix_dir *dir);
/* Standard vectors with domain [0, 1]; knots has ix_knots_count entries. */
typedef enum {
    IX_KV_OPEN,
    IX_KV_FLOAT,
    IX_KV_PERIODIC,
    IX_KV_DISC_OPEN
} ix_kv_kind;
/* Err IX_EARG for IX_KV_DISC_OPEN unless order-1 divides length-order. */
ix_status ix_knots_make(ix_ctx *ctx, ix_kv_kind kind, int order, int length,
                        double *knots) IX_MUST_CHECK;
/* Greville abscissae: nodes[length], clamped into the domain. */
void ix_knots_nodes(const ix_dir *dir, double *nodes);

#ifdef __cplusplus
}
#endif
#endif
