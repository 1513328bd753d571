/* hull3.h - convex hulls of points in space. */
#ifndef GEOM_HULL3_H
#define GEOM_HULL3_H

#include "base/ctx.h"

/* The triangles of the convex hull of p[n], counter-clockwise seen from
 * outside; several may lie in one plane, and few points on faces and edges may
 * be corners of them. Decided exactly on a grid of 2^-38 of the size, so that
 * the points are at most that far outside.
 *
 * Out   *face  scratch, [*nfaces][3] numbers of points; *nfaces is 0 if all
 *              points lie in one plane (to 2^-35 of the size), with its unit
 * normal in flat Err   IX_EDOMAIN  all points lie on one line, or are not
 * finite Num   n log n for points in general position Src   quickhull: Barber,
 * Dobkin and Huhdanpaa 1996 */
ix_status ix__hull3(ix_ctx *ctx, int n, const double (*p)[3], int *nfaces,
                    int (**face)[3], double flat[3]) IX_MUST_CHECK;

#endif
