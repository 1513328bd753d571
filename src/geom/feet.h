/* feet.h - feet of perpendiculars, as the nearest points need them. */
#ifndef GEOM_FEET_H
#define GEOM_FEET_H

#include "iritx/solve.h"
#include "sym/form.h"

/* A curve less p as rows, homogeneous if it is rational, and its weight (else
 * w->nrows is 0), in a frame of its own size; and where x . x' = 0, roots in
 * scratch. */
ix_status ix__foot_forms(ix_ctx *ctx, const ix_mv *c, const double p[3],
                         ix_form *x, ix_form *w) IX_MUST_CHECK;
ix_status ix__foot_roots(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                         ix_root **roots, int *n) IX_MUST_CHECK;

/* m - p, or (dir given) its part perpendicular to dir, in 3 coordinates. Err
 * IX_EARG dir is 0. */
ix_status ix__relative_to(ix_ctx *ctx, const ix_mv *m, const double p[3],
                          const double *dir, ix_mv **out) IX_MUST_CHECK;

/* Feet of the perpendiculars from the origin on a surface. */
ix_status ix__feet_of_origin(ix_ctx *ctx, const ix_mv *s, size_t max_boxes,
                             ix_solutions *out) IX_MUST_CHECK;

/* Err IX_EARG not a curve (surface) of at most 3 coordinates. */
ix_status ix__check_curve(ix_ctx *ctx, const ix_mv *c,
                          int least_coords) IX_MUST_CHECK;
ix_status ix__check_surface(ix_ctx *ctx, const ix_mv *s) IX_MUST_CHECK;

#endif
