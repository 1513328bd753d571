/* pack_triangle.h - circles in a triangle that touch each other and its sides.
 */
#ifndef GEOM_PACK_TRIANGLE_H
#define GEOM_PACK_TRIANGLE_H

#include "iritx/solve.h"

typedef struct {
    double at[2], radius;
} ix__disc;

/* Three circles, each in one angle of the triangle p, touching both of its
 * sides and both other circles (Malfatti 1803). With x_i = sqrt(r_i), on the
 * side between corners i and j
 *
 *   cot(A_i/2) x_i^2 + 2 x_i x_j + cot(A_j/2) x_j^2 = |P_i P_j|.
 *
 * interior: x > 0, the one triple inside; else x_2, x_3 of either sign, which
 * are circles that pass each other along a side. Out: triples in scratch.
 * Err IX_EDOMAIN the points are on one line. */
ix_status ix__pack_three(ix_ctx *ctx, const double (*p)[2], bool interior,
                         int *n, ix__disc (**out)[3]) IX_MUST_CHECK;

/* Six: one in each angle, then one at each side (12, 23, 31) between two of
 * those, which touches the other two at sides: the bowling pins. */
ix_status ix__pack_six(ix_ctx *ctx, const double (*p)[2], int *n,
                       ix__disc (**out)[6]) IX_MUST_CHECK;

#endif
