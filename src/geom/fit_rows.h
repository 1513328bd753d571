/* fit_rows.h - least squares along one direction of a grid of data. */
#ifndef GEOM_FIT_ROWS_H
#define GEOM_FIT_ROWS_H

#include "mv/mv.h"

/* Rows of data double[outer][n][inner] at parameters tau to control points
 * out[outer][dir->length][inner]. */
typedef struct {
    const ix_dir *dir;
    int n;
    const double *tau;
    size_t outer, inner;
} ix__fit;

/* Err IX_EDOMAIN the parameters do not determine the control points. */
ix_status ix__fit_rows(ix_ctx *ctx, const ix__fit *f, const double *data,
                       double *out) IX_MUST_CHECK;

/* Err IX_EARG unless 1 <= order <= size <= count (NULL: any) in each
 * direction. */
ix_status ix__fit_check(ix_ctx *ctx, int ndirs, const int *count,
                        const int *order, const int *size) IX_MUST_CHECK;

#endif
