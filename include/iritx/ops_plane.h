/* ops_plane.h - true bisectors in the plane: what is equally far from two
 * objects, with the distance to the whole objects.
 *
 * An object is one curve or several, or a point. Curves have two coordinates
 * (further ones are dropped), any basis but power, any degree, may be rational,
 * closed, have corners and cusps; they are borrowed. Ends belong to them.
 *
 * The result is exact in this sense: every vertex has both feet, and the same
 * distance from both whole objects within a few roundings of their size;
 * places where pieces meet are found to the last digits. */
#ifndef IRITX_OPS_PLANE_H
#define IRITX_OPS_PLANE_H

#include "iritx/geom.h"
#include "iritx/ops.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- bisectors -------------------------------------------------------------
 */

/* What the feet of a piece are: ends and corners of curves, or the point, are
 * points; anything else is a curve. */
typedef enum {
    IX_POINT_POINT, /* straight */
    IX_POINT_CURVE, /* rational */
    IX_CURVE_CURVE  /* in general not rational: a polyline and its feet; of
                       lines and circles a conic */
} ix_bisector_kind;

/* One piece. Vertices are double[n][2]. */
typedef struct {
    ix_bisector_kind kind;
    int n;
    const double *x;    /* vertices on the bisector */
    const double *foot; /* parameters of the feet on both objects */
    const double *r;    /* [n] distances from both */
    int curve[2];       /* the curve of each object on which the feet are */
    bool point[2];      /* the foot stays */
    int side;           /* of the first object's curve on which the piece is:
                           1 left, -1 right; 0: its foot stays */
    bool unbounded[2];  /* the piece goes on to infinity at its start or end;
                           vertices reach to about 20 times the objects' size */
    double dir[2][2];   /* then: the unit direction in which it goes */
    bool joined;        /* begins where the piece before it ends */
    int component;      /* from 0: joined pieces with their feet on the same
                           points and open curves are one component, which has
                           a corner where a foot jumps */
    ix_mv *exact;       /* point-point, point-curve, and curve-curve where both
                           are straight or arcs of circles (a conic): P2, in the
                           sense of the vertices; an unbounded end has weight 0.
                           NULL for other curve-curve pieces */
} ix_bisector_piece;

typedef struct {
    int n;
    ix_bisector_piece *piece;
    bool closed; /* the last piece ends where the first begins */
    double size; /* of the objects, half the longest edge of their box */
    size_t bytes;
} ix_bisector;
void ix_bisector_free(ix_ctx *ctx, ix_bisector *b);

/* The points that are equally far from a point and a curve.
 *
 *   whole false  { b : |b - q| = dist(b, crv) }
 *   whole true   as false, with the distance from the whole carrier curve, the
 *                first and last span going on to infinity, and the nearest
 *                point of it on crv itself
 *
 * The region that is nearer to q is convex: its border is dual to the convex
 * hull of the curve inverted at q.
 *
 * In    tol    of the polylines, relative to the objects' size or, farther out,
 *              the distance; 0: 1e-4. It does not concern the exact pieces
 * Out   *out   freed with ix_bisector_free; pieces in order, counter-clockwise
 *              around q. With q on the curve: the parts of its normals on
 *              which q is nearest, point-point; at an end or a corner these
 *              bound a region in which all points are equally far (a remark)
 * Err   IX_EARG    not a curve with at least 2 coordinates; q not finite; tol
 *                  negative
 *       IX_EDOMAIN the curve is a point
 * Num   deterministic; vertices equally far within 1e-13 of the size
 * Src   Farouki & Johnstone 1994, (70), (71) */
ix_status ix_bisect_pt_crv(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                           bool whole, double tol,
                           ix_bisector *out) IX_MUST_CHECK;

/* --- special points of a point and a curve ---------------------------------
 */

typedef enum {
    IX_INFLECTION,    /* of the curve: its curvature is zero */
    IX_CLASS_POINT,   /* its tangent passes through q: the untrimmed bisector
                         passes through infinity */
    IX_CURVE_POLE,    /* the curve itself is at infinity, and the bisector */
    IX_CUSP,          /* circular point: the circle of curvature passes through
                         q; the untrimmed bisector has a cusp */
    IX_EXTRAORDINARY, /* the same where the curvature is stationary: the
                         bisector has a tangent, but no finite curvature */
    IX_CROSSING       /* the untrimmed bisector crosses itself */
} ix_pt_crv_mark;

typedef struct {
    ix_pt_crv_mark mark;
    double t;     /* parameter on the curve */
    double other; /* IX_CROSSING: the other parameter of the same point */
    double b[2];  /* the point of the untrimmed bisector; NaN at infinity */
} ix_pt_crv_special;

/* All of them, by increasing t; a crossing is listed for both parameters. Where
 * one of the conditions holds along an interval both its ends are listed.
 *
 * Out   *out   array of *n, freed with ix_pt_crv_specials_free
 * Err   IX_EARG    not a curve with at least 2 coordinates; q not finite
 * Num   by the curve inverted at q: cusps are its inflections, crossings its
 *       bitangents; all to the accuracy of ix_roots and ix_solve
 * Src   Farouki & Johnstone 1994, (36), (37), (57) to (59), 3.1 and 3.3 */
ix_status ix_pt_crv_specials(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                             ix_pt_crv_special **out, int *n) IX_MUST_CHECK;
void ix_pt_crv_specials_free(ix_ctx *ctx, ix_pt_crv_special *s, int n);

/* --- two objects -----------------------------------------------------------
 */

/* The points that are equally far from two objects of n1 and n2 curves, and
 * that separate what is nearer to one from what is nearer to the other: regions
 * in which all points have a foot in common (behind a common end) are left out.
 *
 * In    tol    as above
 * Out   *out   pieces in order around the first object, so that those of one
 *              connected part of the bisector follow each other
 * Err   IX_EARG    as above
 *       IX_EDOMAIN a curve is a point
 *       IX_EUNABLE tol takes more than 1e7 vertices, or than the context's
 *                  memory limit allows (220 bytes each)
 * Src   Adamou, Fioravanti, Gonzalez-Vega & Moussa: the kinds of pieces; here
 *       any degree */
ix_status ix_bisect_crv_crv(ix_ctx *ctx, int n1, const ix_mv *const *c1, int n2,
                            const ix_mv *const *c2, double tol,
                            ix_bisector *out) IX_MUST_CHECK;

/* The exact point of a curve-curve piece near feet that lie between those of
 * two vertices: the centre of the circle that touches c1 at foot[0] and c2
 * near foot[1].
 *
 * In    side     1: to the left of c1, -1: to its right
 * Out   foot[1]  the parameter on c2
 *       b[2], *r centre and radius
 * Err   IX_EARG    not curves with at least two coordinates
 *       IX_EDOMAIN a parameter outside its domain, a pole, a cusp
 *       IX_EUNABLE no circle is near */
ix_status ix_bisector_touch(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                            int side, double foot[2], double b[2],
                            double *r) IX_MUST_CHECK;

/* An end point of a segment, by its feet on the other segment in the
 * curve-curve pieces that begin or end there (Adamou et al., definition 2). */
typedef enum {
    IX_END_FREE = 0,     /* FP: none */
    IX_END_ONE_FOOT = 1, /* NFP1 */
    IX_END_TWO_FEET = 2  /* NFP2 */
} ix_end_class;
/* Of the ends of c1, then of c2: start, end; closed curves have free ones. */
void ix_bisector_ends(const ix_bisector *b, const ix_mv *c1, const ix_mv *c2,
                      ix_end_class out[4]);

/* The untrimmed bisector of coplanar curves by the bisector surface of two
 * space curves: c2 is lifted out of the plane by the distance eps, or tilted by
 * eps degrees about a line along x through the middle of both; the surface is
 * cut with the plane halfway. Lifting is exact, tilting deviates by O(eps^2).
 *
 * In    tol    of the polylines, as in ix_curves_opts
 * Out   *out   polylines, freed with ix_lines_free; z is 0
 *       *error NULL, or how far the curve/curve parts of the true bisector
 * (with radius up to twice the size) are from the polylines at most Err IX_EARG
 * eps 0, not finite, or 90 degrees and more; tol; not curves of the plane;
 * those of ix_cbisector3d Src   Elber & Kim 1998, 2.3 */
ix_status ix_pln_bisect(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                        double eps, bool lift, double tol, ix_lines *out,
                        double *error) IX_MUST_CHECK;

/* --- medial axis ------------------------------------------------------------
 */

typedef struct {
    int n;
    const double *x;    /* double[n][3]: centre and radius of circles that touch
                           the border twice and hold none of it */
    const double *foot; /* double[n][2]: parameters of both feet */
    int curve[2];       /* on which curve they are */
    bool point[2];      /* the foot is a corner, and stays */
    int node[2];        /* at both ends; the same twice for a loop */
} ix_medial_branch;

typedef struct {
    double x[2], r;
    int degree; /* ends of branches: 1 an end, 2 a change of feet (curve to
                   corner), 3 and more a meeting */
} ix_medial_node;

typedef struct {
    int nbranches, nnodes;
    ix_medial_branch *branch;
    ix_medial_node *node;
    double size; /* half the longest edge of the box */
    size_t bytes;
} ix_medial_axis;
void ix_medial_axis_free(ix_ctx *ctx, ix_medial_axis *m);

/* The medial axis of the region that closed curves bound: what an odd number
 * of them enclose. A graph: connected if the region is, with as many loops as
 * it has holes.
 *
 * In    crv    n closed curves of two coordinates, not crossing; corners and
 *              cusps may be
 *       tol    of the polylines, relative to the size; 0: 1e-4
 * Out   *out   freed with ix_medial_axis_free. Branches end at corners with
 *              angle below 180 degrees (radius 0), at centres of curvature of
 *              vertices where the border is closest to its circle, and where
 *              three circles' feet meet. A disc: one node
 * Err   IX_EARG    a curve that is not closed, or of other coordinates; tol
 *       IX_EDOMAIN nothing is enclosed; a curve is a point
 * Num   every vertex is the centre of a circle that touches twice, within 1e-13
 *       of the size; nodes are found to 1e-9 */
ix_status ix_medial_axis_of(ix_ctx *ctx, int n, const ix_mv *const *crv,
                            double tol, ix_medial_axis *out) IX_MUST_CHECK;

/* --- correspondence of feet ------------------------------------------------
 */

/* A function F(t, r) over the parameters of two planar curves that vanishes
 * where one circle touches both: at C1(t) and at C2(r). With C' = D / w^2 and
 * d = C2 - C1:
 *
 *   1   (d x C2')^2 |C1'|^2 - (C1' x d)^2 |C2'|^2       4d-2 / 6d-4
 *   2   (d.C2')^2 |C1'|^2 - (d.C1')^2 |C2'|^2 = -F1     4d-2 / 6d-4
 *   3   <(X, Y) - det (C1 + C2) / 2, C1 - C2>           3d-1 / 4d-2
 *   4   P3: the point (X, Y) / det where the normals meet, as z the number
 *       -2 F3                                           4d-2 / 7d-2
 *
 * det = C1' x C2'. (d the degree, polynomial / rational; of rational curves F1
 * to F3 are these times powers of the weights.) F1 and F2 also vanish where the
 * normals make equal angles with d without meeting on the circle; F3 is the
 * determinant of both lifts and their derivatives and does not.
 *
 * In    o      max_cont; degree forms are all the same; NULL: defaults
 * Out   *out   two directions, E1 or P3, over both domains
 * Err   IX_EARG not curves with at least two coordinates, func
 * Num   in a frame of size 1; relative error a few roundings of the terms
 * Src   Elber & Kim 1998 (functions 1 to 4 of IRIT, which drops weights) */
ix_status ix_cbisector2d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         int func, const ix_op_opts *o,
                         ix_mv **out) IX_MUST_CHECK;

/* The untrimmed bisector of two curves: all centres of circles that touch
 * both, as polylines (z is 0) of exact points, by function 3.
 *
 * In    tol     as in ix_curves_opts
 *       facing  only where the tangents make no acute angle
 * Out   *out    freed with ix_lines_free; points farther away than ten times
 *               the size of both curves are left out
 * Err   IX_EARG not curves with at least two coordinates, tol */
ix_status ix_cbisector2d_curves(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                                double tol, bool facing,
                                ix_lines *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
