/* crv_pair.h - two space curves whose bisector is wanted, and what keeps them
 * from having one. */
#ifndef OPS_CRV_PAIR_H
#define OPS_CRV_PAIR_H

#include "iritx/ops.h"
#include "sym/outer.h"

/* Both curves in one frame: forms, and the minors of their lifts (ten rows as
 * ix__lift_minor has them, then others). */
typedef struct {
    const ix_mv *const *crv;
    ix_frame frame;
    ix_form f[2], minors[2];
    double band; /* relative error of a coefficient of the result */
} ix_crv_pair;

/* Sets the band. */
void ix__crv_pair_band(ix_crv_pair *p);
/* Err IX_EDOMAIN a curve is a point; both are one curve, perhaps reversed. */
ix_status ix__crv_pair_check(ix_ctx *ctx, const ix_crv_pair *p) IX_MUST_CHECK;
/* pts[n]: the composed weight, w its products (row 0 alone), size a bound of
 * their terms. Err IX_EDOMAIN the curves lie on one line or in one plane, or a
 * span of one and a span of the other do; a curve stands still on a span. */
ix_status ix__crv_pair_weight(ix_ctx *ctx, const ix_crv_pair *p,
                              const ix_outer *w, size_t n, const double *pts,
                              double size) IX_MUST_CHECK;

#endif
