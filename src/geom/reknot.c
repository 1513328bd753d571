/* reknot.c - new knots for given control points, and new control points for
 * given knots: edits that change the shape. */
#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "iritx/geom.h"

/* Euclidean control points double[ncoords][n]; periodic ones are followed by
 * the first one again. */
static ix_status polygon(ix_ctx *ctx, const ix_mv *m, int n, double **out)
{
    IX_SCRATCH(ctx, *out, (size_t)n * (size_t)m->ncoords);
    for (int c = 0; c < m->ncoords; c++)
        for (int i = 0; i < n; i++) {
            size_t k = (size_t)i % m->npts;
            double w = m->rational ? m->pts[k] : 1;
            double x = ix_mv_coord(m, c)[k] / w;

            if (!isfinite(x))
                return IX_FAIL(ctx, IX_EDOMAIN,
                               "control point %zu has weight 0", k);
            (*out)[(size_t)c * (size_t)n + (size_t)i] = x;
        }
    return IX_OK;
}

/* Knots with period 1 whose steps are those of the closed polygon. */
static void periodic_knots(const ix_dir *dir, const double *tau, double *knots)
{
    int n = dir->length, first = dir->order - 1, nk = ix_knots_count(dir);

    for (int i = 0; i < nk; i++) {
        int k = i - first, turns = k >= 0 ? k / n : -((n - 1 - k) / n);

        knots[i] = turns + tau[k - turns * n];
    }
}

static ix_status reknot(ix_ctx *ctx, const ix_mv *m, ix_param how, ix_mv **out)
{
    const ix_dir *dir = &m->dirs[0];
    int n = dir->length + (dir->periodic ? 1 : 0), nk = ix_knots_count(dir);
    double *pts, *tau, *knots, dom[2];

    IX_SCRATCH(ctx, tau, n);
    IX_SCRATCH(ctx, knots, nk);
    IX_TRY(polygon(ctx, m, n, &pts));
    IX_TRY(ix_params(ctx, how, n, m->ncoords, pts, tau));
    if (dir->periodic)
        periodic_knots(dir, tau, knots);
    else
        IX_TRY(ix_params_knots(ctx, dir->order, dir->length, n, tau, knots));
    ix_mv_domain(m, 0, dom);
    for (int i = 0; i < nk; i++)
        knots[i] = knots[i] == 1 ? dom[1]
                                 : dom[0] + knots[i] * (dom[1] - dom[0]);
    return ix_mv_set_knots(ctx, m, 0, nk, knots, out);
}

ix_status ix_reknot(ix_ctx *ctx, const ix_mv *crv, ix_param how, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *bsp = NULL;
    ix_status st;

    *out = NULL;
    if (crv->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "not a curve: %d directions", crv->ndirs);
    st = ix_mv_to_bspline(ctx, crv, &bsp);
    if (st == IX_OK)
        st = reknot(ctx, bsp, how, out);
    ix_mv_unref(ctx, bsp);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_set_point(ix_ctx *ctx, const ix_mv *m, size_t i, int ncoords,
                       bool rational, const double *pt, ix_mv **out)
{
    *out = NULL;
    if (i >= m->npts)
        return IX_FAIL(ctx, IX_EARG, "control point %zu of 0 .. %zu", i,
                       m->npts - 1);
    if (ncoords != m->ncoords || rational != m->rational)
        return IX_FAIL(ctx, IX_EARG, "point of type %c%d where %c%d is needed",
                       rational ? 'P' : 'E', ncoords, m->rational ? 'P' : 'E',
                       m->ncoords);
    for (int a = 0; a < m->naxes; a++)
        if (!isfinite(pt[a]))
            return IX_FAIL(ctx, IX_EARG, "coordinate %g", pt[a]);
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->ncoords, m->rational, out));
    memcpy((*out)->pts, m->pts, m->npts * (size_t)m->naxes * sizeof *m->pts);
    for (int a = 0; a < m->naxes; a++)
        (*out)->pts[(size_t)a * m->npts + i] = pt[a];
    return IX_OK;
}
