/* iso_surface.h - where a scalar function of three parameters changes its sign,
 * as triangles. */
#ifndef GEOM_ISO_SURFACE_H
#define GEOM_ISO_SURFACE_H

#include "iritx/geom.h"

/* Triangles in the parameters of f, counter-clockwise seen from where f is
 * positive. cells[d] boxes to each
 * span of direction d, each cut in six tetrahedra of which those with both
 * signs at their corners count: what is smaller than a box can be missed. The
 * triangles of neighbours have their edges in common.
 *
 * Err   IX_EARG    not a polynomial scalar of three directions; cells < 1
 *       IX_EUNABLE more than 20 million points
 * Num   vertices are zeros of f along the edges, to rounding; where f jumps
 *       from one sign to the other they are at the jump
 * Src   Kuhn's division of the cube; Doi & Koide 1991 */
ix_status ix__iso_surface(ix_ctx *ctx, const ix_mv *f, const int cells[3],
                          ix_lines *out) IX_MUST_CHECK;

#endif
