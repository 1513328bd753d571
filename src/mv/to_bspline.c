/* to_bspline.c - Bezier to B-spline, periodic to float, float to open: the
 * same map with another kind of knots. */
#include <string.h>

#include "bsp/knots.h"
#include "mv/mv.h"

static ix_status to_bspline(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];

    for (int d = 0; d < m->ndirs; d++) {
        dirs[d] = m->dirs[d];
        if (dirs[d].basis == IX_BSPLINE)
            continue;
        IX_TRY(ix__dir_knots(ctx, m->dirs + d, &dirs[d].knots));
        dirs[d].basis = IX_BSPLINE;
    }
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, dirs, m->ncoords, m->rational, out));
    memcpy((*out)->pts, m->pts, m->npts * (size_t)m->naxes * sizeof *m->pts);
    return IX_OK;
}

static ix_status to_bspline_scoped(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, to_bspline(ctx, m, out));
}

ix_status ix_mv_to_bspline(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *cur, *next;
    bool all = true;

    *out = NULL;
    for (int d = 0; d < m->ndirs; d++)
        all = all && m->dirs[d].basis == IX_BSPLINE;
    if (all) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix__mv_no_power(ctx, m, &cur));
    IX_TRY(ix__mv_step(ctx, &cur, &next, to_bspline_scoped(ctx, cur, &next)));
    *out = cur;
    return IX_OK;
}

ix_status ix__mv_unwrap(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    ix_dir nd = m->dirs[dir];
    ix__mv_extent s = ix__mv_shape(m, dir);
    size_t n = (size_t)nd.length, to, layer = s.inner * sizeof *m->pts;

    nd.length = ix__dir_npoints(&nd);
    nd.periodic = false;
    to = (size_t)nd.length;
    IX_TRY(ix__mv_alloc_like(ctx, m, dir, &nd, out));
    for (size_t o = 0; o < s.outer; o++)
        for (size_t i = 0; i < to; i++)
            memcpy((*out)->pts + (o * to + i) * s.inner,
                   m->pts + (o * n + i % n) * s.inner, layer);
    return IX_OK;
}

ix_status ix_mv_to_float(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(m), *next;

    *out = NULL;
    for (int d = 0; d < m->ndirs; d++)
        if (m->dirs[d].periodic)
            IX_TRY(ix__mv_step(ctx, &cur, &next,
                               ix__mv_unwrap(ctx, cur, d, &next)));
    *out = cur;
    return IX_OK;
}

ix_status ix__mv_open_dir(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    double dom[2];

    if (ix__dir_is_open(m->dirs + dir)) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    ix__dir_domain(m->dirs + dir, dom);
    return ix__mv_clip(ctx, m, dir, dom, out);
}

ix_status ix_mv_to_open(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(m), *next;

    *out = NULL;
    for (int d = 0; d < m->ndirs; d++)
        IX_TRY(
            ix__mv_step(ctx, &cur, &next, ix__mv_open_dir(ctx, cur, d, &next)));
    *out = cur;
    return IX_OK;
}
