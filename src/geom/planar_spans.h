/* planar_spans.h - the spans of a planar curve with a tree of their boxes, and
 * the pairs of spans of two curves that may have a point in common. */
#ifndef GEOM_PLANAR_SPANS_H
#define GEOM_PLANAR_SPANS_H

#include "bsp/spans.h"

typedef struct {
    double lo[2], hi[2];
} ix__rect;

/* Scratch. */
typedef struct {
    ix_spans sp;
    double *w, *x[2]; /* [nspans * (degree + 1)]; w NULL: polynomial */
    double size[2];   /* largest |x[k]| */
    double wsize;     /* largest |w|, or 1 */
    double steps;     /* roundings of the coefficients, in units of 2^-53 */
    int leaves;       /* a power of 2, at least nspans */
    ix__rect *tree;   /* [2 leaves]: the box of span i at leaves + i, that of
                         nodes 2 n and 2 n + 1 at n */
} ix__planar_spans;

typedef struct {
    int i, j;
} ix__span_pair;

/* The first two coordinates of both curves (any basis but power), from one
 * origin near them unless both are Bezier curves, which stay as they are. */
ix_status ix__planar_spans_of(ix_ctx *ctx, const ix_mv *const c[2],
                              ix__planar_spans out[2]) IX_MUST_CHECK;

/* Pairs of a span of a and one of b whose control polygons no line along the
 * axes or along a chord separates. Where a weight is not positive, all. */
ix_status ix__span_pairs(ix_ctx *ctx, const ix__planar_spans *a,
                         const ix__planar_spans *b, const ix__span_pair **out,
                         int *n) IX_MUST_CHECK;

#endif
