/* arrange_classify.c - how deep a face lies, and how often closed curves turn
 * around it: both spread from the unbounded face over the edges. */
#include <limits.h>

#include "geom/arrange_edges.h"

/* One round: faces beside known ones. True if something was learnt. */
static bool spread_depth(ix_arrangement *a)
{
    bool more = false;

    for (int e = 0; e < a->nedges; e++)
        for (int k = 0; k < 2; k++) {
            int from = a->edge[e].face[k], to = a->edge[e].face[!k];

            if (from < 0 || a->face[from].depth == INT_MAX ||
                a->face[to].depth <= a->face[from].depth + 1)
                continue;
            a->face[to].depth = a->face[from].depth + 1;
            more = true;
        }
    return more;
}

/* The left side of an edge has its turns more than the right one. */
static bool spread_winding(ix_arrangement *a, bool *known)
{
    bool more = false;

    for (int e = 0; e < a->nedges; e++)
        for (int k = 0; k < 2; k++) {
            const ix_arr_edge *d = &a->edge[e];
            int from = d->face[k], to = d->face[!k];

            if (from < 0 || !known[from] || known[to])
                continue;
            known[to] = more = true;
            a->face[to].winding = a->face[from].winding +
                                  (k ? d->turns : -d->turns);
        }
    return more;
}

static ix_status check_winding(ix_ctx *ctx, const ix_arrangement *a)
{
    for (int e = 0; e < a->nedges; e++) {
        const ix_arr_edge *d = &a->edge[e];

        if (d->face[0] >= 0 &&
            a->face[d->face[0]].winding - a->face[d->face[1]].winding !=
                d->turns)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "windings contradict each other at curve %d: parts "
                           "of a closed curve are gone",
                           e + 1);
    }
    return IX_OK;
}

static ix_status classify(ix_ctx *ctx, ix_arrangement *a)
{
    bool *known;

    if (!a->evaluated)
        IX_TRY(ix_arrangement_evaluate(ctx, a, false));
    IX_SCRATCH_ZERO(ctx, known, a->nfaces);
    known[0] = true;
    for (int f = 1; f < a->nfaces; f++) {
        a->face[f].depth = INT_MAX;
        a->face[f].winding = 0;
    }
    while (spread_depth(a))
        ;
    while (spread_winding(a, known))
        ;
    IX_TRY(check_winding(ctx, a));
    a->classified = true;
    return IX_OK;
}

ix_status ix_arrangement_classify(ix_ctx *ctx, ix_arrangement *a)
{
    IX_RETURN_SCOPED(ctx, classify(ctx, a));
}
