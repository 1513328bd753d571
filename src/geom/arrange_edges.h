/* arrange_edges.h - how the steps on an arrangement replace its edges.
 *
 * A step gathers the new edges in scratch memory and takes them over in the
 * end: until then the arrangement is what it was. */
#ifndef GEOM_ARRANGE_EDGES_H
#define GEOM_ARRANGE_EDGES_H

#include "geom/marks.h"
#include "iritx/arrange.h"

typedef struct {
    ix_ctx *ctx;
    int n, room;
    ix_arr_edge *e;
} ix__edges;

/* Takes over the caller's reference to crv, also if it fails. */
ix_status ix__edges_add(ix__edges *l, const ix_mv *crv, int source,
                        int turns) IX_MUST_CHECK;
/* The pieces of edge e between the marks, or e itself. */
ix_status ix__edges_add_pieces(ix__edges *l, const ix_arr_edge *e,
                               const ix__marks *m) IX_MUST_CHECK;
/* If st is IX_OK they become a's edges, else they are released. */
ix_status ix__edges_take(ix__edges *l, ix_arrangement *a,
                         ix_status st) IX_MUST_CHECK;

/* Numbers of the vertices at ends 2 e + (0 start, 1 end), in scratch: ends
 * closer than a->tol, and chains of such, are one. p[*n] is their mean. */
ix_status ix__arr_vertices(ix_ctx *ctx, const ix_arrangement *a, int **vertex,
                           int *n, double (**p)[2]) IX_MUST_CHECK;

/* What was evaluated is forgotten. */
void ix__arr_forget(ix_ctx *ctx, ix_arrangement *a);
/* Err IX_EARG it has not been evaluated. */
ix_status ix__arr_check_evaluated(ix_ctx *ctx,
                                  const ix_arrangement *a) IX_MUST_CHECK;

/* b after a, with a straight line between when they are apart by more than
 * 1e-9 of their size. */
ix_status ix__crv_chain(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        ix_mv **out) IX_MUST_CHECK;

#endif
