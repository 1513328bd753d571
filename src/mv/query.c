/* query.c - questions about representations. */
#include <math.h>

#include "mv/mv.h"

static bool same_dir(const ix_dir *a, const ix_dir *b, double eps)
{
    if (a->basis != b->basis || a->order != b->order ||
        a->length != b->length || a->periodic != b->periodic)
        return false;
    for (int i = 0; i < ix_knots_count(a); i++)
        if (!(fabs(a->knots[i] - b->knots[i]) <= eps))
            return false;
    return true;
}

bool ix_mv_equal(const ix_mv *a, const ix_mv *b, double eps)
{
    if (a->ndirs != b->ndirs || a->ncoords != b->ncoords ||
        a->rational != b->rational)
        return false;
    for (int d = 0; d < a->ndirs; d++)
        if (!same_dir(a->dirs + d, b->dirs + d, eps))
            return false;
    for (size_t i = 0; i < a->npts * (size_t)a->naxes; i++)
        if (!(fabs(a->pts[i] - b->pts[i]) <= eps))
            return false;
    return true;
}

bool ix_mv_has_poles(const ix_mv *m)
{
    if (!m->rational)
        return false;
    for (size_t i = 0; i < m->npts; i++)
        if (m->pts[0] > 0 ? !(m->pts[i] > 0) : !(m->pts[i] < 0))
            return true;
    return false;
}

ix_status ix_mv_bbox(ix_ctx *ctx, const ix_mv *m, double *lo, double *hi)
{
    if (ix_mv_has_poles(m))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "weights that are zero or of both signs: no box");
    for (int c = 0; c < m->ncoords; c++) {
        const double *x = ix_mv_coord(m, c);

        lo[c] = HUGE_VAL;
        hi[c] = -HUGE_VAL;
        for (size_t i = 0; i < m->npts; i++) {
            double v = m->rational ? x[i] / m->pts[i] : x[i];

            lo[c] = fmin(lo[c], v);
            hi[c] = fmax(hi[c], v);
        }
    }
    return IX_OK;
}
