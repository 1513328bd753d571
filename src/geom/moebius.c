/* moebius.c - Moebius reparametrisation of a curve, as scripts ask for it: the
 * factor from one weight to the next is given, and the last weight stays. */
#include <math.h>

#include "geom/parts.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"

/* All control values times f. */
static ix_status scaled(ix_ctx *ctx, const ix_mv *m, double f, ix_mv **out)
{
    size_t n = m->npts * (size_t)m->naxes;

    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->ncoords, m->rational, out));
    for (size_t i = 0; i < n; i++)
        (*out)->pts[i] = f * m->pts[i];
    return IX_OK;
}

static ix_status moebius(ix_ctx *ctx, const ix_mv *crv, double ratio,
                         ix_mv *t[2], ix_mv **out)
{
    size_t last;
    double w0, w1, want, end;

    IX_TRY(ix_mv_to_open(ctx, crv, &t[0]));
    last = t[0]->npts - 1;
    w0 = t[0]->rational ? t[0]->pts[0] : 1;
    w1 = t[0]->rational ? t[0]->pts[last] : 1;
    want = ratio > 0 ? pow(ratio, t[0]->dirs[0].order - 1) * (w1 / w0) : 1;
    IX_TRY(ix_mv_moebius(ctx, t[0], 0, want, &t[1]));
    end = t[1]->pts[t[1]->npts - 1];
    return scaled(ctx, t[1], w1 / end, out);
}

ix_status ix_moebius(ix_ctx *ctx, const ix_mv *crv, double ratio, ix_mv **out)
{
    ix_mv *t[2] = {NULL};
    ix_status st;

    *out = NULL;
    if (crv->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "not a curve: %d directions", crv->ndirs);
    if (!(ratio >= 0 && isfinite(ratio)))
        return IX_FAIL(ctx, IX_EARG, "ratio %g is negative", ratio);
    st = moebius(ctx, crv, ratio, t, out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}
