/* bernstein.h - a whole multivariate as Bernstein coefficients of its boxes of
 * spans: the form in which it is cut into pieces and evaluated in bulk. */
#ifndef MV_BERNSTEIN_H
#define MV_BERNSTEIN_H

#include "bsp/spans.h"
#include "mv/mv.h"

typedef struct {
    const ix_mv *m;
    ix_spans sp[IX_MAX_DIRS];
    size_t stride[IX_MAX_DIRS]; /* of one coefficient of each direction */
    size_t axis;                /* coefficients of one axis */
    double *coefs; /* [axes]..[nspans of 1 * order][nspans of 0 * order] */
} ix__bernstein;

/* Everything in scratch. No power basis. */
ix_status ix__bernstein_of(ix_ctx *ctx, const ix_mv *m,
                           ix__bernstein *out) IX_MUST_CHECK;

/* Offset in an axis of the row of direction 0 in the box of spans at[] with
 * the coefficients q[d] of the other directions. */
size_t ix__bernstein_row(const ix__bernstein *b, const int *at, const int *q);

/* Counts q[1 ..] on, directions with the number of coefficients order[d];
 * false after the last. q[0] is not touched. */
bool ix__bernstein_next(const ix_mv *m, int *q);

#endif
