/* band.h - linear least squares whose rows are banded, by Givens rotations.
 *
 * Rows arrive one by one; each has a few neighbouring unknowns, as values of
 * B-splines have. The triangle of the QR factorisation keeps that band, so m
 * rows in n unknowns cost O(m k^2). Periodic systems, whose rows run over
 * from the last unknown to the first, keep their last `border` unknowns
 * dense. As many rows as unknowns: plain solving. */
#ifndef BSP_BAND_H
#define BSP_BAND_H

#include "base/ctx.h"

typedef struct {
    int n;      /* unknowns */
    int width;  /* most neighbouring unknowns in a row */
    int border; /* the last unknowns, which any row may touch; 0 or, for rows
                   that run over, width - 1 (all n if n is small) */
    int nrhs;
    double *band; /* [n - border][width]: row j of the triangle from column j */
    double *edge; /* [n][border]: its last columns, and the last triangle */
    double *rhs;  /* [n][nrhs] */
    double *rest; /* [nrhs]: sum of squares that no unknowns can remove */
    double *row;  /* [width + border + nrhs]: the row that is coming in */
} ix_band;

/* An empty system in scratch. periodic: rows may run over the end. */
ix_status ix__band_new(ix_ctx *ctx, int n, int width, bool periodic, int nrhs,
                       ix_band *out) IX_MUST_CHECK;

/* The row  sum coef[i] x[(first + i) mod n] = rhs,  0 <= first < n, m <= width
 * (unless periodic, first + m <= n). Weights are the caller's: multiply both
 * sides. Cheap when rows come in the order of their first unknown. */
void ix__band_add(ix_band *b, int first, int m, const double *coef,
                  const double *rhs);

/* x[nrhs][n]. Err IX_EDOMAIN singular: a pivot below 1e-13 of the largest,
 * the message names its unknown. */
ix_status ix__band_solve(ix_ctx *ctx, const ix_band *b,
                         double *x) IX_MUST_CHECK;

#endif
