/* crvs.h - making the rows of curves that geom.h returns. */
#ifndef GEOM_CRVS_H
#define GEOM_CRVS_H

#include "base/ctx.h"
#include "iritx/geom.h"

/* n empty places (NULL, [0, 0]), to be filled; ix_crvs_free takes partly
 * filled ones. */
ix_status ix__crvs_new(ix_ctx *ctx, int n, ix_crvs *out) IX_MUST_CHECK;

/* Err IX_EARG unless c is a Bezier or B-spline curve of two coordinates or
 * more. */
ix_status ix__check_planar(ix_ctx *ctx, const ix_mv *c) IX_MUST_CHECK;
/* Err IX_EARG not a curve of two or three coordinates; IX_EDOMAIN its ends are
 * more than 1e-6 of its size apart. */
ix_status ix__check_closed(ix_ctx *ctx, const ix_mv *c) IX_MUST_CHECK;

#endif
