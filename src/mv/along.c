/* along.c - what operations along one direction share. */
#include <string.h>

#include "mv/mv.h"

ix_status ix__mv_check_dir(ix_ctx *ctx, const ix_mv *m, int dir)
{
    if (dir < 0 || dir >= m->ndirs)
        return IX_FAIL(ctx, IX_EARG, "direction %d of %d", dir, m->ndirs);
    return IX_OK;
}

ix_status ix__mv_alloc_like(ix_ctx *ctx, const ix_mv *m, int dir,
                            const ix_dir *nd, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];

    memcpy(dirs, m->dirs, (size_t)m->ndirs * sizeof *dirs);
    dirs[dir] = *nd;
    return ix__mv_alloc(ctx, m->ndirs, dirs, m->ncoords, m->rational, out);
}

ix__mv_extent ix__mv_shape(const ix_mv *m, int dir)
{
    size_t inner = ix__mv_stride(m, dir);
    size_t layer = inner * (size_t)m->dirs[dir].length;

    return (ix__mv_extent){m->npts / layer * (size_t)m->naxes, inner};
}

ix_status ix__mv_map(ix_ctx *ctx, const ix_mv *m, int dir, const ix_rows *b,
                     const ix_dir *nd, ix_mv **out)
{
    ix__mv_extent s = ix__mv_shape(m, dir);

    IX_TRY(ix__mv_alloc_like(ctx, m, dir, nd, out));
    ix__rows_apply(ctx, b, m->dirs[dir].length, s.outer, s.inner, m->pts,
                   (*out)->pts);
    return IX_OK;
}

ix_status ix__mv_step(ix_ctx *ctx, ix_mv **cur, ix_mv **next, ix_status st)
{
    ix_mv_unref(ctx, *cur);
    *cur = st == IX_OK ? *next : NULL;
    return st;
}

ix_status ix__mv_with_knots(ix_ctx *ctx, const ix_mv *m, int dir,
                            const double *knots, ix_mv **out)
{
    ix_dir nd = m->dirs[dir];

    nd.knots = knots;
    IX_TRY(ix__mv_alloc_like(ctx, m, dir, &nd, out));
    memcpy((*out)->pts, m->pts, m->npts * (size_t)m->naxes * sizeof *m->pts);
    return IX_OK;
}

ix_status ix__mv_finish(ix_ctx *ctx, ix_status st, ix_mv *m, ix_mv **out)
{
    *out = NULL;
    if (st == IX_OK)
        *out = m;
    else
        ix_mv_unref(ctx, m);
    return st;
}
