/* crv_pairs.h - pairs of points of one curve as equations on its spans. */
#ifndef GEOM_CRV_PAIRS_H
#define GEOM_CRV_PAIRS_H

#include "mv/mv.h"

/* The scalar over t in span i, r in span j (each by [0, 1]) that vanishes where
 * the tangent line at t passes through the point at r, in the XY plane:
 * (C(t) - C(r)) x C'(t), numerators, with (t - r)^2 divided out if i = j. *out
 * is NULL for i = j if the span is straight. */
ix_status ix__tangent_chords(ix_ctx *ctx, const ix_mv *c, int i, int j,
                             ix_mv **out) IX_MUST_CHECK;

#endif
