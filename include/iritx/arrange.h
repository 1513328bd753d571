/* arrange.h - arrangements of planar curves: the vertices, edges and faces into
 * which curves divide the plane.
 *
 * An arrangement holds curves in the XY plane (E2 or P2) and is changed step by
 * step: copies taken out, curves cut where they meet, hanging parts left out.
 * Then ix_arrangement_evaluate finds how the curves, now edges, bound faces.
 * Every change forgets what was evaluated. A step that fails changes nothing.
 *
 * Half edges: 2 e is edge e along its curve, 2 e + 1 against it. A loop is a
 * closed walk of half edges that has one face on its left. */
#ifndef IRITX_ARRANGE_H
#define IRITX_ARRANGE_H

#include "iritx/geom.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    const ix_mv *crv; /* a reference */
    int source;       /* which of the curves at the beginning it is a part of */
    int turns;        /* how many closed curves run along it, less those that
                         run against it */
    /* After evaluation, else -1: */
    int vertex[2]; /* at its start and end */
    int face[2];   /* on its left and right; -1: the edge hangs and is ignored,
                      or is shorter than the tolerance */
} ix_arr_edge;

typedef struct {
    double p[2];
    int degree; /* edge ends that meet here, ignored ones aside */
} ix_arr_vertex;

typedef struct {
    int first, n; /* its half edges, in half */
    int face;     /* on its left */
    int component;
    double area; /* signed: positive if the face lies inside */
} ix_arr_loop;

typedef struct {
    int outer;   /* loop around it; -1 for face 0, which is unbounded */
    int parent;  /* face around the component whose loop is outer; -1 for 0 */
    double area; /* less that of what lies inside; infinite for face 0 */
    int depth;   /* fewest edges to be crossed from face 0 */
    int winding; /* turns of the closed curves around it */
} ix_arr_face;

typedef struct {
    double tol; /* ends of curves nearer than this are one vertex */
    int nedges;
    ix_arr_edge *edge;

    bool evaluated, classified;
    int nvertices, nloops, nfaces, ncomponents, nhalf;
    ix_arr_vertex *vertex;
    ix_arr_loop *loop;
    ix_arr_face *face;
    int *half;
    size_t bytes;
} ix_arrangement;

/* The rigid motion (row vectors, as ix_mv_transform) that takes the plane of n
 * curves to z = 0: a shift along z if they are level, else the plane nearest to
 * their control points. Err IX_EARG not curves; IX_EDOMAIN poles, control
 * points farther than tol from it, on one line that is not level. */
ix_status ix_crvs_plane(ix_ctx *ctx, int n, const ix_mv *const *crv, double tol,
                        double to_xy[16]) IX_MUST_CHECK;

/* From n curves, of which x and y count.
 *
 * In    crv  Bezier, B-spline or power basis, two or three coordinates
 *       tol  positive
 * Out   *out  freed with ix_arrangement_free
 * Err   IX_EARG not such curves, tol; IX_EDOMAIN poles */
ix_status ix_arrangement_new(ix_ctx *ctx, int n, const ix_mv *const *crv,
                             double tol, ix_arrangement **out) IX_MUST_CHECK;
/* A copy (what was evaluated is not copied); the curves are shared. */
ix_status ix_arrangement_copy(ix_ctx *ctx, const ix_arrangement *a,
                              ix_arrangement **out) IX_MUST_CHECK;
void ix_arrangement_free(ix_ctx *ctx, ix_arrangement *a); /* a may be NULL */

/* --- steps -------------------------------------------------------------------
 */

/* Of curves that are the same point set within tol, in either direction, the
 * first stays; turns are added up. Err IX_EARG tol negative. */
ix_status ix_arrangement_drop_copies(ix_ctx *ctx, ix_arrangement *a,
                                     double tol) IX_MUST_CHECK;
/* The same for parts along which curves run together: they are cut out, and one
 * copy stays. */
ix_status ix_arrangement_drop_overlaps(ix_ctx *ctx, ix_arrangement *a,
                                       double tol) IX_MUST_CHECK;

/* Edge number edge cut at n parameters (any order). No piece stays within tol
 * of its start. Err IX_EARG no such edge, a parameter outside its domain. */
ix_status ix_arrangement_split(ix_ctx *ctx, ix_arrangement *a, int edge, int n,
                               const double *t, double tol) IX_MUST_CHECK;
/* Cut at special points: those of the kinds in what. Err IX_EARG others, tol
 * negative. */
enum {
    IX_ARR_INFLECTIONS = 1,
    IX_ARR_X_EXTREMES = 2, /* where x is stationary */
    IX_ARR_Y_EXTREMES = 4,
    IX_ARR_CURVATURE = 8 /* extrema of the absolute curvature */
};
ix_status ix_arrangement_split_special(ix_ctx *ctx, ix_arrangement *a,
                                       unsigned what, double tol) IX_MUST_CHECK;
/* Cut at corners: breaks at which the tangent turns by more than angle
 * (radians). */
ix_status ix_arrangement_split_corners(ix_ctx *ctx, ix_arrangement *a,
                                       double angle) IX_MUST_CHECK;
/* Cut where curves cross or touch each other or themselves, where an end of one
 * lies on another (within tol), and where two begin or cease to run together.
 * tol becomes the arrangement's tolerance if it is the larger one.
 *
 * Err   IX_EARG tol not positive; IX_EUNABLE the intersections of two curves,
 *       or of one with itself, are not known completely */
ix_status ix_arrangement_split_meetings(ix_ctx *ctx, ix_arrangement *a,
                                        double tol) IX_MUST_CHECK;
/* Cut at the places nearest to points (x and y count), where these are within
 * tol of the curve. */
ix_status ix_arrangement_split_near(ix_ctx *ctx, ix_arrangement *a, int n,
                                    const double (*p)[3],
                                    double tol) IX_MUST_CHECK;
/* Two curves whose ends meet by themselves become one if it does not turn there
 * by more than angle (radians) and both have the same turns; small gaps are
 * bridged. Directions follow the first one. */
ix_status ix_arrangement_merge(ix_ctx *ctx, ix_arrangement *a,
                               double angle) IX_MUST_CHECK;
/* Every curve becomes a polynomial B-spline of an order within tol, ends kept:
 * with 1, 2, 4, .. knot intervals on its domain, or on each of its spans, these
 * joined by C0 knots, whichever is first near enough.
 *
 * Err   IX_EARG order, tol; IX_EUNABLE more than 512 control points needed */
ix_status ix_arrangement_fit(ix_ctx *ctx, ix_arrangement *a, double tol,
                             int order) IX_MUST_CHECK;

/* --- the subdivision of the plane
 * ------------------------------------------------ */

/* Vertices, loops and faces. Curves must meet in their ends only.
 *
 *   V - E + F = 1 + C   for C components, hanging edges and all
 *
 * In    ignore_hanging  edges with an end that meets no other, and those that
 *                       hang when these are gone, are ignored
 * Num   around a vertex edges are ordered where they first leave one circle
 *       around it that all of them reach: disjoint arcs inside a disk arrive in
 *       the order in which they left, touching ones too
 * Err   IX_EUNABLE two edges run together (drop them), a loop or component
 *       fits nowhere (curves still cross) */
ix_status ix_arrangement_evaluate(ix_ctx *ctx, ix_arrangement *a,
                                  bool ignore_hanging) IX_MUST_CHECK;
/* Depth and winding of each face, see ix_arr_face; evaluates first, if that has
 * not been done, with hanging edges.
 *
 * Err   also IX_EUNABLE windings contradict each other: parts of a closed curve
 *       are gone */
ix_status ix_arrangement_classify(ix_ctx *ctx, ix_arrangement *a) IX_MUST_CHECK;

/* A loop as one closed curve, B-spline; gaps are bridged by straight lines. */
ix_status ix_arrangement_loop_curve(ix_ctx *ctx, const ix_arrangement *a,
                                    int loop, ix_mv **out) IX_MUST_CHECK;
/* The face in which p lies (of neighbours, if it is on an edge, any one). Err
 * IX_EARG not evaluated. */
ix_status ix_arrangement_locate(ix_ctx *ctx, const ix_arrangement *a,
                                const double p[2], int *face) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
