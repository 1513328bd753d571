/* mv.h - the multivariate's block: header, directions, knots, points in one
 * allocation. Nothing changes it once a public function has returned it. */
#ifndef MV_MV_H
#define MV_MV_H

#include "base/ctx.h"
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

/* The checks of ix_mv_new without the points. */
ix_status ix__mv_check_dirs(ix_ctx *ctx, int ndirs, const ix_dir *dirs,
                            int ncoords) IX_MUST_CHECK;

/* Checks a parameter of direction d against the domain and clamps it, as
 * ix_mv_eval does. Err IX_EDOMAIN. */
ix_status ix__mv_param(ix_ctx *ctx, const ix_mv *m, int d,
                       double *t) IX_MUST_CHECK;

/* Stride of a direction inside one axis, in points. */
size_t ix__mv_stride(const ix_mv *m, int dir);

#endif
