/* pool.h - formulas between multivariates written as expressions.
 *
 * Every function takes the pool, makes one intermediate result, keeps it and
 * returns a view of it. After a failure st says which, and all further ones
 * return NULL at once, so that a formula needs one check at its end. */
#ifndef GEOM_POOL_H
#define GEOM_POOL_H

#include "iritx/sym.h"
#include "mv/mv.h"

typedef struct {
    ix_ctx *ctx;
    ix_status st;
    int n;
    ix_mv *mv[256]; /* the longest formula needs some 200 */
} ix_pool;

/* Releases all intermediate results. */
void ix__pool_free(ix_pool *q);
/* A new reference to f in *out, everything else released; returns st. */
ix_status ix__pool_give(ix_pool *q, const ix_mv *f, ix_mv **out) IX_MUST_CHECK;

/* A place for a result that another function makes, NULL before (the next one
 * too), and what stands there afterwards:
 *     made(q, ix_sym_dot(q->ctx, a, b, NULL, room(q)))   if q->st is IX_OK */
ix_mv **ix__pool_room(ix_pool *q);
const ix_mv *ix__pool_made(ix_pool *q, ix_status st);

const ix_mv *ix__pool_mul(ix_pool *q, const ix_mv *a, const ix_mv *b);
const ix_mv *ix__pool_add(ix_pool *q, const ix_mv *a, const ix_mv *b);
const ix_mv *ix__pool_sub(ix_pool *q, const ix_mv *a, const ix_mv *b);
/* A scalar times a number. */
const ix_mv *ix__pool_scale(ix_pool *q, const ix_mv *a, double f);
const ix_mv *ix__pool_derive(ix_pool *q, const ix_mv *a, int dir);
/* a' w - a w' in direction dir, of two scalars that belong together (equal
 * degrees d there): degree 2d - 2, in which the quotient rule has 2d - 1. */
const ix_mv *ix__pool_wronskian(ix_pool *q, const ix_mv *a, const ix_mv *w,
                                int dir);
/* Axis k (the weight first if rational) as a polynomial scalar. */
const ix_mv *ix__pool_axis(ix_pool *q, const ix_mv *m, int k);
/* The polynomial scalar f with its directions at start .. of n, [0, 1] being
 * the domain of the others. */
const ix_mv *ix__pool_promote(ix_pool *q, const ix_mv *f, int n, int start);

#endif
