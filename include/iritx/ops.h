/* ops.h - the geometric operators.
 *
 * Every operator can build the same geometry in several degree forms and
 * tells, in a report, what it built and how well the result satisfies its
 * definition. Options and report may be NULL. */
#ifndef IRITX_OPS_H
#define IRITX_OPS_H

#include "iritx/mv.h"
#include "iritx/sym.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The same geometry in different degrees. */
typedef enum {
    IX_FORM_MINIMAL,   /* lowest degree in general position (minors) */
    IX_FORM_PUBLISHED, /* the formulas and degrees of the paper */
    IX_FORM_NAIVE,     /* quotient rule and sums of fractions throughout */
    IX_FORM_IRIT       /* degrees, knots and point types of IRIT 11 */
} ix_degree_form;

/* Options of operators; NULL stands for the defaults {IX_FORM_MINIMAL,
 * INT_MAX}. */
typedef struct {
    ix_degree_form form;
    int max_cont; /* as in ix_sym_opts: 0 gives C0 joins */
} ix_op_opts;

#define IX_REPORT_MEETINGS 8

/* What an operator built. */
typedef struct {
    ix_degree_form form;
    int ndirs;
    int orders[IX_MAX_DIRS]; /* of the result */
    double residual;         /* of the defining equations, relative; NaN if
                                nothing could be measured */
    const char *how;         /* what was measured and where; static text */

    /* of a bisector or sector of two space curves: where they meet, so that
     * the surface has no single point there */
    int nmeetings;
    double meetings[IX_REPORT_MEETINGS][2]; /* parameters on both, the first */
    double overlap[2][2]; /* parameters, on both, of a part that they share;
                             equal: none */
} ix_report;

/* The bisector surface of two space curves.
 *
 *   B(s, t): |B - C1(s)| = |B - C2(t)|, (B - C1).C1' = 0, (B - C2).C2' = 0
 *
 * one point for each pair of parameters: the centre of the sphere that touches
 * C1 at s and C2 at t.
 *
 * In    c1, c2   curves of at most 3 coordinates (missing ones are 0), any
 *                basis, polynomial or rational, with any continuity; borrowed
 *       o        IX_FORM_MINIMAL; IX_FORM_PUBLISHED, IX_FORM_NAIVE and
 *                IX_FORM_IRIT have rational degrees 4d - 1, 6d - 2 and 5d, the
 *                last gives a B-spline with C0 joins
 * Out   *out     rational surface with 3 coordinates, direction 0 over c1's
 *                domain, direction 1 over c2's; new reference. Degree in a
 *                direction: 3d - 1 if its curve is polynomial of degree d, 4d
 *                - 2 if rational; continuity one less than the curve's. The
 *                weights add up to a positive number: all are positive where
 *                one sign suffices. Weights of both signs: the surface passes
 *                through infinity (poles)
 *       rep      residual: largest ||B - C1| - |B - C2|| relative to |B - C1|
 *                or the size of the curves, on a 5 x 5 grid, poles left out;
 *                where the curves meet (ix_crv_meetings) or run along each
 *                other: weight and numerators are zero there
 * Err   IX_EARG     not a curve, or more than 3 coordinates
 *       IX_EDOMAIN  the weight vanishes identically within its error band:
 *                   coplanar curves, among them intersecting or parallel
 *                   lines (the message gives weight and band), or a span of one
 *                   is coplanar with a span of the other (the message names
 *                   both)
 *       IX_EDOMAIN  a curve is a point, or stands still on a span
 *       IX_EDOMAIN  both are the same curve, perhaps reversed
 *       IX_EDOMAIN  all weights of the input are zero
 *       IX_EUNABLE  an order above IX_MAX_ORDER
 * Num   as six products of minors for each coordinate, those of each curve
 *       computed in its own frame: relative equidistance about 1e-14 where the
 *       weight is not small, also for curves that are small in comparison with
 *       their distance
 * Src   Elber and Kim 1998, equations (4)-(6); the degree by minors of lifted
 *       curves (docs/ops/cbisector3d.md) */
ix_status ix_cbisector3d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         const ix_op_opts *o, ix_report *rep,
                         ix_mv **out) IX_MUST_CHECK;

/* The part of the report about two curves: nmeetings, meetings and overlap of
 * *rep. Err those of ix_crv_meetings. */
ix_status ix_bisector_meetings(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                               ix_report *rep) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
