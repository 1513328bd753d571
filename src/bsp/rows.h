/* rows.h - linear maps of one direction whose rows are short.
 *
 * Row i of the result is a weighted sum of width consecutive points, the
 * first of them first[i] (before wrapping). Knot insertion, sampling, raising
 * and restriction are such maps. Rows whose weights add up to 1 keep a
 * constant exactly. */
#ifndef BSP_ROWS_H
#define BSP_ROWS_H

#include "bsp/knots.h"

typedef struct {
    int nrows, width;
    bool affine; /* every row's weights add up to 1 */
    int *first;  /* [nrows] */
    int *heavy;  /* [nrows]: index of the weight of largest size */
    double *w;   /* [nrows][width] */
} ix_rows;

/* Room for nrows rows, in scratch; affine true, the rest unset. */
ix_status ix__rows_alloc(ix_ctx *ctx, int nrows, int width,
                         ix_rows *out) IX_MUST_CHECK;

/* From the B-spline direction dir to one of the same order with the given
 * knots, length + order of them. In the domain of both the new knots contain
 * those of dir, and every new point has a part of its support in dir's
 * domain. A point that stays has a row with a single 1. */
ix_status ix__rows_refine(ix_ctx *ctx, const ix_dir *dir, int length,
                          const double *knots, ix_rows *out) IX_MUST_CHECK;

/* Values at n parameters inside the domain, in any order. */
ix_status ix__rows_sample(ix_ctx *ctx, const ix_dir *dir, int n,
                          const double *t, ix_rows *out) IX_MUST_CHECK;

/* Bernstein coefficients of degree from to degree to >= from. */
ix_status ix__rows_raise(ix_ctx *ctx, int from, int to,
                         ix_rows *out) IX_MUST_CHECK;

/* From an open B-spline direction to the order one higher, knots (open) with
 * each distinct one of dir's once more: the mean of the blossom values that
 * leave one argument out (Ramshaw 1989). Convex. */
ix_status ix__rows_raise_one(ix_ctx *ctx, const ix_dir *dir, int length,
                             const double *knots, ix_rows *out) IX_MUST_CHECK;

/* Fills heavy, which the makers above do themselves. */
void ix__rows_weigh(ix_rows *b);

/* in [outer][n][inner], rows wrapping at n, to out [outer][nrows][inner]; no
 * overlap. Shares out large work. */
void ix__rows_apply(ix_ctx *ctx, const ix_rows *b, int n, size_t outer,
                    size_t inner, const double *in, double *out);

#endif
