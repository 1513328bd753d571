/* cone_envelope.h - the surface that cones of 45 degrees along a curve touch.
 */
#ifndef GEOM_CONE_ENVELOPE_H
#define GEOM_CONE_ENVELOPE_H

#include "iritx/mv.h"

/* Rulings from C(t), at z = 0, to the offset points C(t) + height N(t) at z =
 * height; of an open curve both sides and the half cones at its ends, as one
 * surface, u around it; of a closed one (ends within 1e-10 of its size) two
 * surfaces, to the left (*out) and to the right (*right) of its direction; else
 * *right is NULL. Offsets are those of ix_crv_offset, within tol.
 * Err IX_EARG not a planar curve, height 0, tol; what ix_crv_offset says */
ix_status ix__cone_envelope(ix_ctx *ctx, const ix_mv *c, double height,
                            double tol, ix_mv **out,
                            ix_mv **right) IX_MUST_CHECK;

#endif
