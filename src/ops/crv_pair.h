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
    int powers[2]; /* of the weight that are in minors */
    bool turned;   /* by the rotation turn, after the frame */
    double turn[3][3];
    double thin; /* extent across, of that along the line; 1 if not turned */
    double band; /* relative error of a coefficient of the result */
} ix_crv_pair;

/* Sets turned and turn: curves near one straight line are turned until that is
 * parallel to an axis. Then what is across is in coordinates of its own, and
 * determinants have no terms of the length of the line that cancel. */
void ix__crv_pair_turn(ix_crv_pair *p);

/* Sets the band. */
void ix__crv_pair_band(ix_crv_pair *p);
/* Err IX_EDOMAIN a curve is a point; both are one curve, perhaps reversed. */
ix_status ix__crv_pair_check(ix_ctx *ctx, const ix_crv_pair *p) IX_MUST_CHECK;
/* w: the products of the weight (row 0 alone). Err IX_EDOMAIN the curves lie on
 * one line or in one plane, or a span of one and a span of the other do; a
 * curve stands still on a span. */
ix_status ix__crv_pair_weight(ix_ctx *ctx, const ix_crv_pair *p,
                              const ix_outer *w) IX_MUST_CHECK;

#endif
