/* set_cover.h - the fewest sets of ranges with the same union as all. */
#ifndef GEOM_SET_COVER_H
#define GEOM_SET_COVER_H

#include "base/ctx.h"

/* One range of set number set. */
typedef struct {
    double lo, hi;
    int set;
} ix__range;

/* A smallest choice of sets whose union is the union of all, gaps of at most
 * tol aside. pick[nsets] becomes 1 for the chosen ones. Exact: greedy when
 * every set is one range, else branch and bound (exponential in bad cases).
 * Of several smallest choices always the same one is taken.
 * Err IX_EARG a range is not finite; IX_ECANCEL. */
ix_status ix__set_cover(ix_ctx *ctx, int nranges, const ix__range *ranges,
                        int nsets, double tol, char *pick) IX_MUST_CHECK;

#endif
