/* regions.h - a rectangle divided by curves. */
#ifndef IRITX_REGIONS_H
#define IRITX_REGIONS_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Regions of the plane. Region i has the loops first_loop[i] .. first_loop[i +
 * 1]
 * - 1, the outer one (counter-clockwise) first, then its holes (clockwise);
 * loop k has the curves first_crv[k] .. first_crv[k + 1] - 1, each beginning
 * where the one before ends. */
typedef struct {
    int n, nloops, ncrvs;
    int *first_loop; /* [n + 1] */
    int *first_crv;  /* [nloops + 1] */
    ix_mv **crv;     /* [ncrvs] references, two coordinates */
    double *area;    /* [n], holes taken off */
    size_t bytes;
} ix_regions;
void ix_regions_free(ix_ctx *ctx, ix_regions *r);

/* The regions into which n curves (x and y count) divide a rectangle. Curves
 * may cross, touch, run along each other and along the sides, leave the
 * rectangle (what is outside does not count), and cross themselves; parts that
 * end inside a region without bounding one are ignored. Without curves: the
 * rectangle.
 *
 * In    box  [direction][lower, upper], not empty
 * Out   *out areas add up to that of the rectangle; every point of it lies
 * inside one region or on the borders of some Err   IX_EARG box, not curves of
 * two or more coordinates; IX_EDOMAIN poles; IX_EUNABLE meetings of curves are
 * not known completely Num   curves that are nearer than 1e-7 of the
 * rectangle's sides are one */
ix_status ix_divide_box(ix_ctx *ctx, const double box[2][2], int n,
                        const ix_mv *const *crv, ix_regions *out) IX_MUST_CHECK;

/* What of the inside of closed loops lies in a rectangle: as above, of the
 * regions those that are inside an odd number of loops.
 *
 * In    first  loop k has the curves first[k] .. first[k + 1] - 1 of crv, end
 * to end; gaps between them, and at the end, are bridged by straight lines Err
 * also IX_EUNABLE loops run along each other so that inside and outside cannot
 * be told */
ix_status ix_trim_box(ix_ctx *ctx, const double box[2][2], int nloops,
                      const int *first, const ix_mv *const *crv,
                      ix_regions *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
