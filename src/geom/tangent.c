/* tangent.c - tangent and normal at a parameter, of the projected curve. */
#include <math.h>

#include "geom/path.h"
#include "geom/vec3.h"
#include "iritx/geom.h"

/* The path, and the span that counts at t (clamped as evaluation does). */
static ix_status locate(ix_ctx *ctx, const ix_mv *crv, double *t, ix_path *p,
                        int *span)
{
    double dom[2], slack;

    IX_TRY(ix__path_new(ctx, crv, p));
    dom[0] = p->breaks[0];
    dom[1] = p->breaks[p->nspans];
    slack = 1e-5 * (dom[1] - dom[0]);
    if (ix_mv_dir(crv, 0).basis == IX_BSPLINE) {
        if (!(*t >= dom[0] - slack && *t <= dom[1] + slack))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "parameter %g is outside the domain [%g, %g]", *t,
                           dom[0], dom[1]);
        *t = fmax(dom[0], fmin(dom[1], *t));
    }
    *span = ix__path_span(p, *t);
    return IX_OK;
}

static ix_status tangent(ix_ctx *ctx, const ix_mv *crv, double t, bool unit,
                         double out[3])
{
    double d[2][3];
    ix_path p;
    int span;

    IX_TRY(locate(ctx, crv, &t, &p, &span));
    ix__path_derivs3(&p, span, t, 1, d);
    if (!(isfinite(ix__len3(d[1]))))
        return IX_FAIL(ctx, IX_EDOMAIN, "the curve has a pole at %g", t);
    for (int i = 0; i < 3; i++)
        out[i] = d[1][i];
    if (unit && !ix__path_tangent3(&p, span, t, t >= p.breaks[p.nspans], out))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no tangent at %g: the derivatives vanish", t);
    return IX_OK;
}

ix_status ix_tangent(ix_ctx *ctx, const ix_mv *crv, double t, bool unit,
                     double out[3])
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = tangent(ctx, crv, t, unit, out);

    ix__scratch_release(ctx, mk);
    return st;
}

static ix_status normal(ix_ctx *ctx, const ix_mv *crv, double t, double out[3])
{
    double u[3];
    ix_path p;
    int span;

    if (ix_mv_ncoords(crv) < 2 || ix_mv_ncoords(crv) > 3)
        return IX_FAIL(ctx, IX_EARG, "a normal in %d coordinates",
                       ix_mv_ncoords(crv));
    IX_TRY(locate(ctx, crv, &t, &p, &span));
    if (p.ncoords == 2) {
        if (!ix__path_tangent3(&p, span, t, t >= p.breaks[p.nspans], u))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "no normal at %g: the derivatives vanish", t);
        out[0] = -u[1];
        out[1] = u[0];
        out[2] = 0;
        return IX_OK;
    }
    if (!ix__path_normal3(&p, span, t, out))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no normal at %g: C' or the curvature is zero", t);
    return IX_OK;
}

ix_status ix_normal(ix_ctx *ctx, const ix_mv *crv, double t, double out[3])
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = normal(ctx, crv, t, out);

    ix__scratch_release(ctx, mk);
    return st;
}
