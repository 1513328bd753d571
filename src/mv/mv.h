/* mv.h - the multivariate's block: header, directions, knots, points in one
 * allocation. Nothing changes it once a public function has returned it. */
#ifndef MV_MV_H
#define MV_MV_H

#include "base/ctx.h"
#include "bsp/rows.h"
#include "iritx/mv.h"

struct ix_mv {
    int refs; /* changed by the context's own thread only */
    int ndirs, ncoords, naxes;
    bool rational;
    size_t npts;
    size_t bytes; /* of the whole block */
    ix_dir *dirs; /* [ndirs], inside the block */
    double *pts;  /* [naxes][npts], inside the block, 64-byte aligned */
};

/* A block with room for the given shape: directions and knots copied, refs
 * 1, points unset. For builders: they fill pts, then return it as it is. The
 * caller has checked that the shape is legal; IX_ENOMEM otherwise only. */
ix_status ix__mv_alloc(ix_ctx *ctx, int ndirs, const ix_dir *dirs, int ncoords,
                       bool rational, ix_mv **out) IX_MUST_CHECK;

/* The knots of a direction while m is being built. */
double *ix__mv_knots(ix_mv *m, int dir);

/* A block like m's with direction dir replaced by nd; points unset. */
ix_status ix__mv_alloc_like(ix_ctx *ctx, const ix_mv *m, int dir,
                            const ix_dir *nd, ix_mv **out) IX_MUST_CHECK;

/* One axis after another, m's points seen along a direction are
 * double[outer][length][inner]. */
typedef struct {
    size_t outer, inner;
} ix__mv_extent;
ix__mv_extent ix__mv_shape(const ix_mv *m, int dir);

/* m with the knots of a B-spline direction replaced; no checks. */
ix_status ix__mv_with_knots(ix_ctx *ctx, const ix_mv *m, int dir,
                            const double *knots, ix_mv **out) IX_MUST_CHECK;

/* m with the points of direction dir mapped by b, that direction becoming nd
 * (b->nrows points). */
ix_status ix__mv_map(ix_ctx *ctx, const ix_mv *m, int dir, const ix_rows *b,
                     const ix_dir *nd, ix_mv **out) IX_MUST_CHECK;

/* The open B-spline over [t0, t1], t0 < t1 inside the domain, of a B-spline
 * direction. */
ix_status ix__mv_clip(ix_ctx *ctx, const ix_mv *m, int dir, const double t[2],
                      ix_mv **out) IX_MUST_CHECK;
/* The open B-spline direction dir of m over [to[0], to[1]], which holds its
 * domain: the first and the last polynomial go on there. */
ix_status ix__mv_continue(ix_ctx *ctx, const ix_mv *m, int dir,
                          const double to[2], ix_mv **out) IX_MUST_CHECK;
/* A periodic direction made float: points repeated at its end. */
ix_status ix__mv_unwrap(ix_ctx *ctx, const ix_mv *m, int dir,
                        ix_mv **out) IX_MUST_CHECK;
/* Power directions made Bezier, the others left. */
ix_status ix__mv_no_power(ix_ctx *ctx, const ix_mv *m,
                          ix_mv **out) IX_MUST_CHECK;
/* Direction dir made open; m itself if it is. */
ix_status ix__mv_open_dir(ix_ctx *ctx, const ix_mv *m, int dir,
                          ix_mv **out) IX_MUST_CHECK;

/* n multivariates made compatible, domains and bases as the first one's; new
 * references in out[n]. flags as ix_mv_compatible. */
ix_status ix__mv_compatible_all(ix_ctx *ctx, int n, const ix_mv *const *in,
                                unsigned flags, ix_mv **out) IX_MUST_CHECK;
/* ix_mv_compatible with flags for each direction: flags[ndirs]. Point types
 * are made equal if any of them says so. */
ix_status ix__mv_compatible_dirs(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                 const unsigned *flags, ix_mv **outa,
                                 ix_mv **outb) IX_MUST_CHECK;

/* A chain of operations: *cur is released and becomes *next if st is IX_OK,
 * else NULL. Returns st. */
ix_status ix__mv_step(ix_ctx *ctx, ix_mv **cur, ix_mv **next,
                      ix_status st) IX_MUST_CHECK;

/* The end of a builder whose last step may fail: *out = m, or m released and
 * *out NULL. Returns st. */
ix_status ix__mv_finish(ix_ctx *ctx, ix_status st, ix_mv *m,
                        ix_mv **out) IX_MUST_CHECK;

/* The checks of ix_mv_new without the points. */
ix_status ix__mv_check_dirs(ix_ctx *ctx, int ndirs, const ix_dir *dirs,
                            int ncoords) IX_MUST_CHECK;

/* True for Bezier directions of curves and surfaces, also as B-splines of one
 * open span: they take any parameter. */
bool ix__mv_extrapolates(const ix_mv *m, int d);

/* Checks a parameter of direction d against the domain and clamps it, as
 * ix_mv_eval does. Err IX_EDOMAIN. */
ix_status ix__mv_param(ix_ctx *ctx, const ix_mv *m, int d,
                       double *t) IX_MUST_CHECK;

/* Err IX_EARG unless m has a direction dir. */
ix_status ix__mv_check_dir(ix_ctx *ctx, const ix_mv *m, int dir) IX_MUST_CHECK;

/* Knots that are meant to be one (4 ulp of the largest) become equal. */
void ix__mv_join_knots(const ix_dir *dir, double *knots);

/* Coefficient i of the constant 1 on m's directions: 1, but 0 for the higher
 * coefficients of a power basis. */
double ix__mv_one(const ix_mv *m, size_t i);

/* Stride of a direction inside one axis, in points. */
size_t ix__mv_stride(const ix_mv *m, int dir);

#endif
