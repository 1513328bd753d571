/* reflection.h - what a mirroring surface shows of lines and circles. */
#ifndef GEOM_REFLECTION_H
#define GEOM_REFLECTION_H

#include "iritx/mv.h"

/* With N the normal field and R = <N,N> V - 2 <V,N> N the mirrored direction
 * of view V, |R| = <N,N> |V|:
 *
 *   line    det(R, dir, p - S)              the mirrored ray meets the line
 *   circle  <R, axis> - cos |V| |axis| <N,N>  it makes the angle with the axis
 *
 * as scalar polynomials on the surface's domain.
 * Err IX_EARG not a surface of two or three coordinates, a zero vector;
 * IX_EDOMAIN the field vanishes everywhere. */
ix_status ix__reflected_line(ix_ctx *ctx, const ix_mv *srf,
                             const double view[3], const double p[3],
                             const double dir[3], ix_mv **out) IX_MUST_CHECK;
ix_status ix__reflected_circle(ix_ctx *ctx, const ix_mv *srf,
                               const double view[3], const double axis[3],
                               double angle, ix_mv **out) IX_MUST_CHECK;

#endif
