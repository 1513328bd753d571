/* recognize.h - what kind of geometry a curve or surface is.
 *
 * Decided on samples at Chebyshev points of every span, more of them than the
 * degree of the defining equation, so that an exact shape is told from one
 * that only nearly is down to eps. The numbers are those of scripts (GEOM_
 * constants) and files (attribute GeomType). */
#ifndef GEOM_RECOGNIZE_H
#define GEOM_RECOGNIZE_H

#include "base/ctx.h"
#include "iritx/mv.h"

typedef enum {
    IX_KIND_CONST = 0,
    IX_KIND_LINEAR = 1,
    IX_KIND_CIRCULAR = 2,
    IX_KIND_PLANAR = 4,
    IX_KIND_SPHERICAL = 5,
    IX_KIND_REVOLUTION = 9,
    IX_KIND_EXTRUSION = 12,
    IX_KIND_RULED = 13,
    IX_KIND_DEVELOPABLE = 14,
    IX_KIND_SWEEP = 15
} ix__geom_kind;

/* flag 0: it is not. Else 1, except that for revolution, extrusion, ruled and
 * developable surfaces 1 and 2 tell the circular or straight direction, for
 * sweeps that of the rigid cross-section. Filled, besides:
 *   const        point
 *   linear       point (the start), dir (unit)
 *   circular     point (centre), dir (unit normal), radius
 *   planar       plane (unit normal, by the right-hand rule from a curve's
 *                loop or from directions 0 and 1 of a surface)
 *   spherical    point (centre), radius
 *   revolution   point on the axis, dir (unit)
 *   extrusion    dir (from the first to the farthest copy) */
typedef struct {
    int flag;
    double point[3], dir[3], plane[4], radius;
} ix__geom_fit;

/* Is the curve or surface m everywhere within eps of such a shape? eps is a
 * distance; for developable surfaces a bound of |Gauss curvature| times the
 * squared diameter. Shapes that are less than asked for (a line as a circle,
 * a point as a line) are not it; in a plane there is no sphere.
 * Err IX_EARG no curve or surface, eps not positive; IX_EDOMAIN a pole. */
ix_status ix__recognize(ix_ctx *ctx, const ix_mv *m, ix__geom_kind kind,
                        double eps, ix__geom_fit *out) IX_MUST_CHECK;

#endif
