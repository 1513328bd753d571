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

/* A closed polyline in the parameter plane of a surface. */
typedef struct {
    size_t n;
    const double *uv;  /* double[n][2] */
    const double *xyz; /* double[n][3]: where to put them, or NULL: on the
                          surface */
} ix__trim_loop;

/* The samples of a surface, for what is made in several steps; in scratch. */
typedef struct ix__tess_grid ix__tess_grid;
ix_status ix__mesh_grid(ix_ctx *ctx, const ix_mv *srf, double tol,
                        ix__tess_grid **out) IX_MUST_CHECK;
/* The same in equal steps, so many for the domain; a new one at each knot. */
ix_status ix__mesh_grid_even(ix_ctx *ctx, const ix_mv *srf, const int steps[2],
                             ix__tess_grid **out) IX_MUST_CHECK;
/* Triangles of the part of the surface that an odd number of loops encloses
 * (all of it without loops). Each lies in one cell of the grid, so that its
 * error is bounded as that of the whole surface is. Vertices on the border of
 * the part are the points of the loops, and others on the lines between them
 * where these cross the grid or each other. Outside of the domain loops are
 * drawn to its border. Err IX_EUNABLE the surface jumps, loops cross
 * everywhere, too many points. */
ix_status ix__mesh_of_part(ix_ctx *ctx, const ix_mv *srf,
                           const ix__tess_grid *g, int nloops,
                           const ix__trim_loop *loop,
                           ix__mesh *out) IX_MUST_CHECK;

/* Parameters of a trimming curve, sorted, in scratch: the polyline through them
 * stays, on the surface, within tol of the curve (by the largest first
 * derivatives of the surface); if steps > 0, they are as many equal ones. The
 * curve's own domain; its ends are among them. Err IX_EDOMAIN the curve has
 * poles. */
ix_status ix__trim_samples(ix_ctx *ctx, const ix__tess_grid *g, const ix_mv *uv,
                           double tol, int steps, size_t *n,
                           double **t) IX_MUST_CHECK;
/* Where parameters are in the grid, in integers: points at the same place
 * become one vertex. Is one of the two on a line of the grid? */
void ix__trim_place(const ix__tess_grid *g, const double uv[2], int64_t x[2]);
bool ix__trim_on_line(int64_t x);
/* More of them: where the polyline crosses lines of the grid, the curve does so
 * at a parameter between, which is added. */
ix_status ix__trim_crossings(ix_ctx *ctx, const ix__tess_grid *g,
                             const ix_mv *uv, size_t *n,
                             double **t) IX_MUST_CHECK;

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
/* In equal steps, so many for the domain; a new one at each knot. Straight
 * spans get their ends only. Err IX_EARG steps below 1. */
ix_status ix__lines_even(ix_ctx *ctx, const ix_mv *crv, int steps,
                         ix__lines *out) IX_MUST_CHECK;
/* Room for them, not filled. */
ix_status ix__lines_alloc(ix_ctx *ctx, size_t nlines, size_t npts,
                          ix__lines *out) IX_MUST_CHECK;
void ix__lines_free(ix_ctx *ctx, ix__lines *l);

#endif
