/* belt.h - a belt around pulleys in the plane. */
#ifndef GEOM_BELT_H
#define GEOM_BELT_H

#include "iritx/geom.h"

/* One side of a closed belt: for pulleys (x, y, r), r > 0 passed counter-
 * clockwise, r < 0 clockwise, arcs of radius |r| + grow about each, grow added
 * to r itself (so a belt's left side is grow < 0 there), and the tangents from
 * each to the next, in order: 2 n rational quadratic or linear P2 pieces, an
 * arc and the line that leaves it. Err IX_EARG fewer than 2 pulleys, a radius 0
 * or one that vanishes; IX_EDOMAIN no tangent between two pulleys. */
ix_status ix__belt(ix_ctx *ctx, int n, const double (*pulley)[3], double grow,
                   ix_crvs *out) IX_MUST_CHECK;

#endif
