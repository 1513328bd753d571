/* tile.h - planar regions as quadrilaterals. */
#ifndef IRITX_TILE_H
#define IRITX_TILE_H

#include "iritx/geom.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One quadrilateral, counter-clockwise; side k leads from corner k to k + 1. */
typedef struct {
    int v[4];
    int crv[4];     /* the curve that side k follows; -1: none, straight */
    double t[4][2]; /* its parameters at the side's ends */
} ix_quad;

typedef struct {
    int npts, nquads;
    double (*p)[2];
    ix_quad *quad;
    size_t bytes;
} ix_quads;
void ix_quads_free(ix_ctx *ctx, ix_quads *q);

typedef struct {
    double angle; /* largest turn of the tangent along two sides in a row on a
                     curve (radians), 0.01 to half a turn */
    double size;  /* length of sides, about; positive */
    int smooth;   /* rounds of smoothing, 0 to 1000 */
} ix_tile_opts;

/* The region that an odd number of closed curves enclose, as quadrilaterals
 * that share whole sides: Delaunay triangles on the curves and on a square grid
 * inside; neighbours that make good quadrilaterals are joined; then each
 * quadrilateral is divided into four and each triangle into three. Sides on
 * curves have their ends there.
 *
 * Out   *out  freed with ix_quads_free; smoothing moves inner points to the
 * mean of their neighbours where no corner turns inside out by that Err IX_EARG
 * not planar curves, options; size so small that more than a million points
 * would be needed IX_EDOMAIN a curve is not closed, poles, no region */
ix_status ix_region_quads(ix_ctx *ctx, int n, const ix_mv *const *crv,
                          const ix_tile_opts *o, ix_quads *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
