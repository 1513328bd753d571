/* coerce.c - other point types, single axes, single points. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"

static ix_status alloc_axes(ix_ctx *ctx, const ix_mv *m, int ncoords,
                            bool rational, ix_mv **out)
{
    return ix__mv_alloc(ctx, m->ndirs, m->dirs, ncoords, rational, out);
}

/* One coordinate divided by the weights; IRIT's value for weight 0. */
static void divide(size_t n, const double *x, const double *w, double *out)
{
    for (size_t i = 0; i < n; i++)
        out[i] = x[i] / (w[i] == 0 ? 1e-14 : w[i]);
}

double ix__mv_one(const ix_mv *m, size_t i)
{
    for (int d = 0; d < m->ndirs; d++) {
        size_t len = (size_t)m->dirs[d].length;

        if (m->dirs[d].basis == IX_POWER && i % len > 0)
            return 0;
        i /= len;
    }
    return 1;
}

ix_status ix_mv_coerce(ix_ctx *ctx, const ix_mv *m, int ncoords, bool rational,
                       ix_mv **out)
{
    size_t n = m->npts;
    double *to;

    *out = NULL;
    if (ncoords < 1 || ncoords > IX_MAX_COORDS)
        return IX_FAIL(ctx, IX_EARG, "%d coordinates are not in 1 .. %d",
                       ncoords, IX_MAX_COORDS);
    if (ncoords == m->ncoords && rational == m->rational) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(alloc_axes(ctx, m, ncoords, rational, out));
    to = (*out)->pts;
    for (size_t i = 0; rational && i < n; i++)
        to[i] = m->rational ? m->pts[i] : ix__mv_one(m, i);
    for (int c = 0; c < ncoords; c++) {
        double *x = to + (size_t)(c + rational) * n;

        if (c >= m->ncoords)
            memset(x, 0, n * sizeof *x);
        else if (m->rational && !rational)
            divide(n, ix_mv_coord(m, c), m->pts, x);
        else
            memcpy(x, ix_mv_coord(m, c), n * sizeof *x);
    }
    return IX_OK;
}

ix_status ix_mv_scalar(ix_ctx *ctx, const ix_mv *m, int axis, ix_mv **out)
{
    *out = NULL;
    if (axis < 0 || axis >= m->naxes)
        return IX_FAIL(ctx, IX_EARG, "axis %d of %d", axis, m->naxes);
    IX_TRY(alloc_axes(ctx, m, 1, false, out));
    memcpy((*out)->pts, ix_mv_axis(m, axis), m->npts * sizeof *m->pts);
    return IX_OK;
}

ix_status ix_mv_set_point(ix_ctx *ctx, const ix_mv *m, size_t idx,
                          const double *p, ix_mv **out)
{
    *out = NULL;
    if (idx >= m->npts)
        return IX_FAIL(ctx, IX_EARG, "control point %zu of %zu", idx, m->npts);
    for (int a = 0; a < m->naxes; a++)
        if (!isfinite(p[a]))
            return IX_FAIL(ctx, IX_EARG, "coordinate %d is %g", a, p[a]);
    IX_TRY(alloc_axes(ctx, m, m->ncoords, m->rational, out));
    memcpy((*out)->pts, m->pts, m->npts * (size_t)m->naxes * sizeof *m->pts);
    for (size_t a = 0; a < (size_t)m->naxes; a++)
        (*out)->pts[a * m->npts + idx] = p[a];
    return IX_OK;
}
