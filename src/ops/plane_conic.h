/* plane_conic.h - pieces of a bisector with both feet on straight lines or
 * circles: exact conics. */
#ifndef OPS_PLANE_CONIC_H
#define OPS_PLANE_CONIC_H

#include "iritx/ops_plane.h"

/* Of a piece that has its vertices: crv[2] with two coordinates carry its feet,
 * which move over t[i] on crv[i]. They are seen from q, a place near them: a
 * line that is far from the origin is a circle but for its rounding.
 *
 * Out   *straight  both are lines, or circles that make it one
 *       *out       else the conic as seen from q, P2 of order 3: a Bezier
 * curve, or up to three spans; NULL if the piece is none Num   parts of curves
 * count as straight or circular if 2 d + 1 points of each span are so within
 * 1e-13 of their size */
ix_status ix__bisector_conic(ix_ctx *ctx, const ix_mv *const crv[2],
                             double t[2][2], const ix_bisector_piece *p,
                             const double q[2], bool *straight,
                             ix_mv **out) IX_MUST_CHECK;

#endif
