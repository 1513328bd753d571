/* direction_curves.h - arcs of (u, v, a, b), points of a surface with a tangent
 * up to its sign, joined to whole curves. */
#ifndef OPS_DIRECTION_CURVES_H
#define OPS_DIRECTION_CURVES_H

#include "iritx/solve.h"

typedef struct {
    int first, n;        /* of the vertices */
    ix_curve_end end[2]; /* IX_END_CLOSED: both are one point; a clipped end
                            without a partner becomes BOUNDARY or OPEN */
} ix__direction_arc;

/* Growing, in scratch. */
typedef struct {
    ix_ctx *ctx;
    double dom[2][2]; /* of the surface */
    double (*x)[4];
    int n, cap;
    ix__direction_arc *arc;
    int narcs, arc_cap;
} ix__direction_arcs;

/* A vertex of the last arc. */
ix_status ix__direction_add(ix__direction_arcs *a,
                            const double x[4]) IX_MUST_CHECK;
ix_status ix__direction_begin(ix__direction_arcs *a,
                              ix_curve_end start) IX_MUST_CHECK;
/* Ends the last arc; one of a single vertex goes. */
void ix__direction_end(ix__direction_arcs *a, ix_curve_end end);

/* Whether two are the same point and tangent. */
bool ix__direction_same(const ix__direction_arcs *a, const double x[4],
                        const double y[4]);

/* Sets out's curves; what else out says stays. (a, b) does not jump along a
 * curve, so that it may have changed its sign when a loop is closed. */
ix_status ix__direction_join(ix__direction_arcs *a,
                             ix_solution_curves *out) IX_MUST_CHECK;

#endif
