/* tv_boolsum.h - trivariates from faces. */
#ifndef GEOM_TV_BOOLSUM_H
#define GEOM_TV_BOOLSUM_H

#include "iritx/mv.h"

/* Trilinearly blended volume of faces on [0, 1]^3 (Gordon & Hall 1973): f[0] at
 * u = 0 and f[1] at u = 1 as functions of (v, w), f[2], f[3] at v = 0, 1 of
 * (u, w), f[4], f[5] at w = 0, 1 of (u, v); without the last two (both NULL)
 * each w has the bilinearly blended patch of its four edges.
 * Err IX_EARG not polynomial surfaces of one number of coordinates, faces whose
 * common edges are apart by more than 1e-5 of the coordinates' size. */
ix_status ix__tv_boolsum(ix_ctx *ctx, const ix_mv *const f[6],
                         ix_mv **out) IX_MUST_CHECK;

/* A tube, closed in u, filled: for every v the bilinearly blended patch of its
 * closed curve cut in four (ix_srf_boolone); w is the tube's v. */
ix_status ix__tv_boolone(ix_ctx *ctx, const ix_mv *tube,
                         ix_mv **out) IX_MUST_CHECK;

#endif
