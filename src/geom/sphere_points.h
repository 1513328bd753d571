/* sphere_points.h - points spread evenly over a sphere or a hemisphere. */
#ifndef GEOM_SPHERE_POINTS_H
#define GEOM_SPHERE_POINTS_H

#include "base/ctx.h"

/* n unit vectors, double[n][3]: the Fibonacci lattice (Swinbank, Purser 2006);
 * neighbours are about sqrt(4 pi / n) apart. Bit for bit the same each time. */
void ix__sphere_points(int n, double (*out)[3]);

/* Unit vectors with z >= 0 on rings of latitude, pole first, neighbours on a
 * ring and rings about spacing (radians) apart but not more. *n points in
 * scratch. Err IX_EARG spacing not in [1e-3, pi]. */
ix_status ix__hemisphere_points(ix_ctx *ctx, double spacing, int *n,
                                double (**out)[3]) IX_MUST_CHECK;

#endif
