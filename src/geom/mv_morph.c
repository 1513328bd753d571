/* mv_morph.c - convex blends of two maps with the same representation. */
#include <math.h>

#include "geom/parts.h"
#include "iritx/geom_srf.h"

/* Knots may differ by the reference's 1e-5, relative to the domain. */
static ix_status check_dir(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int d)
{
    const ix_dir *p = &a->dirs[d], *q = &b->dirs[d];
    double dom[2], tol;

    if (p->basis != q->basis || p->order != q->order ||
        p->length != q->length || p->periodic != q->periodic)
        return IX_FAIL(ctx, IX_EARG,
                       "direction %d: order %d with %d points and order %d "
                       "with %d points are not compatible",
                       d + 1, p->order, p->length, q->order, q->length);
    ix_mv_domain(a, d, dom);
    tol = 1e-5 * (dom[1] - dom[0]);
    for (int i = 0; i < ix_knots_count(p); i++)
        if (!(fabs(p->knots[i] - q->knots[i]) <= tol))
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d: knots %d differ, %.15g and %.15g",
                           d + 1, i + 1, p->knots[i], q->knots[i]);
    return IX_OK;
}

ix_status ix_mv_morph(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, double t,
                      ix_mv **out)
{
    size_t n = (size_t)a->naxes * a->npts;

    *out = NULL;
    if (a->ndirs != b->ndirs || a->ncoords != b->ncoords ||
        a->rational != b->rational)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions of %c%d and %d of %c%d are not "
                       "compatible",
                       a->ndirs, a->rational ? 'P' : 'E', a->ncoords, b->ndirs,
                       b->rational ? 'P' : 'E', b->ncoords);
    for (int d = 0; d < a->ndirs; d++)
        IX_TRY(check_dir(ctx, a, b, d));
    IX_TRY(ix__mv_alloc(ctx, a->ndirs, a->dirs, a->ncoords, a->rational, out));
    for (size_t i = 0; i < n; i++)
        (*out)->pts[i] = (1 - t) * a->pts[i] + t * b->pts[i];
    return IX_OK;
}
