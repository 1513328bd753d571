/* srf_pairs.h - all pairs of Bezier patches of one surface, as the equations
 * for pairs of its points want them (diagonal.h). */
#ifndef GEOM_SRF_PAIRS_H
#define GEOM_SRF_PAIRS_H

#include "geom/diagonal.h"
#include "iritx/solve.h"

/* One system: two patches, how they lie, and the way back to (u1, v1, u2, v2).
 */
typedef struct {
    ix__pair_kind kind;
    bool corner;     /* APART: they have a corner in common */
    int dir;         /* EDGE: the direction across the edge */
    bool reversed;   /* EDGE: the first patch ends at the edge */
    double lo[2][2]; /* of the patches' domains: [patch][direction] */
    double hi[2][2];
    ix__pair eq;
} ix__srf_pair;

/* Own unknowns to (u1, v1, u2, v2). */
void ix__srf_pair_map(const ix__srf_pair *p, const double *own, double *out);

/* Calls visit for every pair whose control boxes overlap (or, with all, every
 * pair), q holding its equations. Every unordered pair of patches comes once,
 * EDGE pairs twice (either is blown up). *size is the surface's, *dom its
 * domains. Scratch memory is not released. Err IX_EARG not such a surface; what
 * visit returns. */
typedef struct {
    bool all;
    double size, dom[2][2];
    ix_status (*visit)(ix_ctx *ctx, void *arg, const ix__srf_pair *p);
    void *arg;
} ix__srf_walk;
ix_status ix__srf_pairs(ix_ctx *ctx, const ix_mv *srf,
                        ix__srf_walk *w) IX_MUST_CHECK;

#endif
