/* tessellate.h - curves as polylines and surfaces as triangles that stay within
 * a tolerance of them.
 *
 * The error is bounded, not sampled: on a box of parameters hu x hv the linear
 * interpolant over any triangle is no farther from the surface, at the same
 * parameters, than (hu^2 Muu + 2 hu hv Muv + hv^2 Mvv) / 8, with M the largest
 * second derivatives there; they are bounded by Bezier control points (Filip,
 * Magedson, Markot 1986). All patches of a surface share their parameters, so
 * that there are no cracks. Where a weight vanishes, pieces are left out. */
#ifndef MV_TESSELLATE_H
#define MV_TESSELLATE_H

#include <stdint.h>

#include "mv/mv.h"

/* More samples than this are refused. */
#define IX__TESS_MOST ((size_t)1 << 23)

typedef struct {
    size_t nverts, ntris;
    double *xyz;        /* double[nverts][3] */
    double *uv;         /* double[nverts][2]: their parameters */
    uint32_t (*tri)[3]; /* counter-clockwise in the parameter plane */
    size_t nleft;       /* boxes left out at poles */
    size_t vbytes, tbytes;
} ix__mesh;

/* Triangles of a surface; coordinates beyond the third are ignored, missing
 * ones 0. Triangles with two equal corners (at the poles of a sphere) are not
 * there. A note tells of poles.
 * Err IX_EARG not a surface, tol not positive; IX_EUNABLE more than
 * IX__TESS_MOST points would be needed. */
ix_status ix__mesh_of_srf(ix_ctx *ctx, const ix_mv *srf, double tol,
                          ix__mesh *out) IX_MUST_CHECK;
void ix__mesh_free(ix_ctx *ctx, ix__mesh *m);

/* Polylines of a curve: one, or more if it jumps or has poles. Line i holds
 * the points start[i] .. start[i + 1] - 1. */
typedef struct {
    size_t nlines, npts;
    size_t *start; /* [nlines + 1] */
    double *xyz;   /* double[npts][3] */
    double *t;     /* double[npts] */
    size_t nleft;
    size_t bytes;
} ix__lines;

/* Errors as ix__mesh_of_srf. */
ix_status ix__lines_of_crv(ix_ctx *ctx, const ix_mv *crv, double tol,
                           ix__lines *out) IX_MUST_CHECK;
void ix__lines_free(ix_ctx *ctx, ix__lines *l);

#endif
