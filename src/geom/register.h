/* register.h - the rigid motion that brings points onto others. */
#ifndef GEOM_REGISTER_H
#define GEOM_REGISTER_H

#include "iritx/mv.h"

/* Iterated nearest points (Besl & McKay 1992): mat takes p[n] near to q[m], or
 * to the surface srf if that is given. Every step pairs each moved point with
 * its nearest one and takes the best rigid motion of the pairs (Horn 1987).
 *
 * In    iters  at most so many steps, >= 1; stops when the root mean square
 *              distance changes by no more than eps
 * Out   mat    row vectors, as ix_mv_transform; *err that distance (at the last
 *              pairing)
 * Err   IX_EARG  n or m below 3, iters; what ix_srf_nearest says
 * Num   finds the motion next to the given position, which need not be the best
 */
ix_status ix__register(ix_ctx *ctx, int n, const double (*p)[3], int m,
                       const double (*q)[3], const ix_mv *srf, int iters,
                       double eps, double mat[16], double *err) IX_MUST_CHECK;

#endif
