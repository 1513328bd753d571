/* system_impl.h - shared by the parts of the system solver. */
#ifndef SOLVE_SYSTEM_IMPL_H
#define SOLVE_SYSTEM_IMPL_H

#include "base/ctx.h"
#include "iritx/solve.h"
#include "solve/small.h"
#include "solve/tensor.h"

/* The system on one patch: all tensors have one shape, each scaled so that its
 * largest coefficient is about 1. Equalities first (neq of them, n used for
 * the square system, the rest as checks), then relations f >= 0. */
typedef struct {
    ix_ctx *ctx;
    ix__shape shape;
    int n, neq, nall;
    double cell; /* smallest edge, as a part of the domain's */
    size_t max_boxes, boxes;
    double edge[IX_MAX_UNKNOWNS]; /* lengths of the whole domain */
    struct ix__search *search;    /* working memory, made for the first patch */
} ix__system;

typedef struct {
    double *c;                       /* [nall][size] */
    double err[3 * IX_MAX_UNKNOWNS]; /* absolute, per tensor */
    double lo[IX_MAX_UNKNOWNS], hi[IX_MAX_UNKNOWNS];
} ix__box;

/* Solutions found so far, in a growing scratch array. */
typedef struct {
    ix_ctx *ctx;
    ix_solution *sol;
    int n, cap;
} ix__found;

ix_status ix__found_add(ix__found *f, const ix_solution *s) IX_MUST_CHECK;

/* All solutions in b, added to found. */
ix_status ix__system_search(ix__system *sys, const ix__box *b,
                            ix__found *found) IX_MUST_CHECK;

/* One solution reported by several boxes becomes one; undecided boxes that
 * touch become one box; undecided boxes around a certified solution that they
 * cannot be told from go away. Sorted. */
ix_status ix__found_merge(ix__found *f, int n,
                          const double *edge) IX_MUST_CHECK;

#endif
