/* connect.h - points without order joined to polylines. */
#ifndef GEOM_CONNECT_H
#define GEOM_CONNECT_H

#include "base/ctx.h"

/* Chains one after the other: count[k] points each, point[] their indices;
 * closed[k]: the last is joined to the first. All in scratch. */
typedef struct {
    int n;
    int *count, *point;
    bool *closed;
} ix__chains;

/* Joins n points double[n][dim] that are within tol of each other, shortest
 * gaps first, no point to more than two others; then closes each chain of three
 * points or more whose ends are within tol, and no farther apart than 3/2 of
 * its longest gap. What order the points have does not matter, but for equal
 * gaps; each chain begins at that end which is first among the points.
 *
 * Src   greedy matching of Kruskal's kind; closed curves sampled with gaps that
 *       are less than the distance of their branches come back in order */
ix_status ix__connect(ix_ctx *ctx, int n, int dim, const double *p, double tol,
                      ix__chains *out) IX_MUST_CHECK;

#endif
