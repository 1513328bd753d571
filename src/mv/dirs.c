/* dirs.c - directions added, fixed, cut out, stacked. */
#include <string.h>

#include "mv/mv.h"

/* If some direction is a B-spline, all become so; consumes m. */
static ix_status one_basis(ix_ctx *ctx, ix_mv *m, ix_mv **out)
{
    ix_mv *cur = m, *next;
    bool any = false;

    for (int d = 0; d < m->ndirs; d++)
        any = any || m->dirs[d].basis == IX_BSPLINE;
    if (any)
        IX_TRY(
            ix__mv_step(ctx, &cur, &next, ix_mv_to_bspline(ctx, cur, &next)));
    *out = cur;
    return IX_OK;
}

/* count constant directions before direction at: the points stay in place. */
static ix_status insert(ix_ctx *ctx, const ix_mv *m, int at, int count,
                        int after, ix_mv **out)
{
    static const ix_dir constant = {IX_BEZIER, 1, 1, false, NULL};
    ix_dir dirs[IX_MAX_DIRS];
    int n = 0;
    ix_mv *r;

    for (int i = 0; i < at; i++)
        dirs[n++] = m->dirs[i];
    for (int i = 0; i < count; i++)
        dirs[n++] = constant;
    for (int i = at; i < m->ndirs; i++)
        dirs[n++] = m->dirs[i];
    for (int i = 0; i < after; i++)
        dirs[n++] = constant;
    IX_TRY(ix__mv_alloc(ctx, n, dirs, m->ncoords, m->rational, &r));
    memcpy(r->pts, m->pts, m->npts * (size_t)m->naxes * sizeof *r->pts);
    return one_basis(ctx, r, out);
}

ix_status ix_mv_promote(ix_ctx *ctx, const ix_mv *m, int ndirs, int start,
                        ix_mv **out)
{
    *out = NULL;
    if (ndirs <= m->ndirs || ndirs > IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG, "%d directions to %d (at most %d)",
                       m->ndirs, ndirs, IX_MAX_DIRS);
    if (start < 0 || start > ndirs - m->ndirs)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions at direction %d of %d do not fit",
                       m->ndirs, start, ndirs);
    return insert(ctx, m, 0, start, ndirs - m->ndirs - start, out);
}

ix_status ix_mv_insert_dir(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    *out = NULL;
    if (dir < 0 || dir > m->ndirs || m->ndirs == IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG,
                       "a new direction %d besides %d (at most %d)", dir,
                       m->ndirs, IX_MAX_DIRS);
    return insert(ctx, m, dir, 1, 0, out);
}

/* --- one direction less ------------------------------------------------- */

static ix_status can_spare(ix_ctx *ctx, const ix_mv *m, int dir)
{
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (m->ndirs == 1)
        return IX_FAIL(ctx, IX_EARG, "a curve has no direction to spare");
    return IX_OK;
}

/* A block like m's without direction dir; points unset. */
static ix_status without(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    int n = 0;

    for (int d = 0; d < m->ndirs; d++)
        if (d != dir)
            dirs[n++] = m->dirs[d];
    return ix__mv_alloc(ctx, n, dirs, m->ncoords, m->rational, out);
}

static ix_status fix(ix_ctx *ctx, const ix_mv *m, int dir, double t,
                     ix_mv **out)
{
    ix__mv_extent s = ix__mv_shape(m, dir);
    ix_rows rows;

    IX_TRY(ix__mv_param(ctx, m, dir, &t));
    IX_TRY(ix__rows_sample(ctx, m->dirs + dir, 1, &t, &rows));
    IX_TRY(without(ctx, m, dir, out));
    ix__rows_apply(ctx, &rows, m->dirs[dir].length, s.outer, s.inner, m->pts,
                   (*out)->pts);
    return IX_OK;
}

ix_status ix_mv_fix(ix_ctx *ctx, const ix_mv *m, int dir, double t, ix_mv **out)
{
    *out = NULL;
    IX_TRY(can_spare(ctx, m, dir));
    IX_RETURN_SCOPED(ctx, fix(ctx, m, dir, t, out));
}

ix_status ix_mv_layer(ix_ctx *ctx, const ix_mv *m, int dir, int i, ix_mv **out)
{
    ix__mv_extent s;
    size_t n;

    *out = NULL;
    IX_TRY(can_spare(ctx, m, dir));
    if (i < 0 || i >= m->dirs[dir].length)
        return IX_FAIL(ctx, IX_EARG, "layer %d of %d in direction %d", i,
                       m->dirs[dir].length, dir);
    IX_TRY(without(ctx, m, dir, out));
    s = ix__mv_shape(m, dir);
    n = (size_t)m->dirs[dir].length;
    for (size_t o = 0; o < s.outer; o++)
        memcpy((*out)->pts + o * s.inner,
               m->pts + (o * n + (size_t)i) * s.inner,
               s.inner * sizeof *m->pts);
    return IX_OK;
}

/* --- one direction more ------------------------------------------------- */

/* Layers of one shape as layers of the last direction. */
static ix_status stack(ix_ctx *ctx, int n, ix_mv *const *layer,
                       const ix_dir *dir, ix_mv **out)
{
    const ix_mv *m = layer[0];
    ix_dir dirs[IX_MAX_DIRS];
    ix_mv *r;

    memcpy(dirs, m->dirs, (size_t)m->ndirs * sizeof *dirs);
    dirs[m->ndirs] = *dir;
    IX_TRY(ix__mv_alloc(ctx, m->ndirs + 1, dirs, m->ncoords, m->rational, &r));
    if (dir->basis == IX_BSPLINE)
        ix__mv_join_knots(r->dirs + m->ndirs, ix__mv_knots(r, m->ndirs));
    for (size_t a = 0; a < (size_t)m->naxes; a++)
        for (size_t i = 0; i < (size_t)n; i++)
            memcpy(r->pts + (a * (size_t)n + i) * m->npts,
                   layer[i]->pts + a * m->npts, m->npts * sizeof *r->pts);
    return one_basis(ctx, r, out);
}

static ix_status stack_compatible(ix_ctx *ctx, int n, const ix_mv *const *in,
                                  const ix_dir *dir, ix_mv **out)
{
    ix_mv **same;
    ix_status st;

    IX_SCRATCH(ctx, same, n);
    IX_TRY(ix__mv_compatible_all(ctx, n, in, IX_SAME_ALL, same));
    st = stack(ctx, n, same, dir, out);
    for (int i = 0; i < n; i++)
        ix_mv_unref(ctx, same[i]);
    return st;
}

ix_status ix_mv_stack(ix_ctx *ctx, int n, const ix_mv *const *layers,
                      const ix_dir *dir, ix_mv **out)
{
    *out = NULL;
    if (n < 1 || dir->length != n)
        return IX_FAIL(ctx, IX_EARG, "%d layers for %d points", n, dir->length);
    if (layers[0]->ndirs == IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG, "more than %d directions", IX_MAX_DIRS);
    IX_TRY(ix__mv_check_dirs(ctx, 1, dir, 1));
    IX_RETURN_SCOPED(ctx, stack_compatible(ctx, n, layers, dir, out));
}
