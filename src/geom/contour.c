/* contour.c - zero sets of scalar fields on surfaces. */
#include "iritx/contour.h"

#include "geom/outer_mv.h"
#include "iritx/geom_srf.h"

ix_status ix_contour_field(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                           ix_mv **out)
{
    *out = NULL;
    return ix__affine_field(ctx, m, plane, out);
}

/* f is consumed. */
static ix_status trace(ix_ctx *ctx, ix_mv *f, double tol,
                       ix_solution_curves *out)
{
    const ix_equation eq = {.f = f, .rel = IX_EQUAL_ZERO};
    const ix_curves_opts o = {.tol = tol};
    ix_status st = ix_solve_curves(ctx, 1, &eq, &o, out);

    ix_mv_unref(ctx, f);
    return st;
}

ix_status ix_contour(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                     double tol, ix_solution_curves *out)
{
    ix_mv *f;

    *out = (ix_solution_curves){.unknowns = 0};
    if (m->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG,
                       "contours of a freeform of %d directions; "
                       "a surface is wanted",
                       m->ndirs);
    IX_TRY(ix__affine_field(ctx, m, plane, &f));
    return trace(ctx, f, tol, out);
}

ix_status ix_silhouette(ix_ctx *ctx, const ix_mv *s, const double view[3],
                        double tol, ix_solution_curves *out)
{
    const double v[4] = {view[0], view[1], view[2], 0};
    ix_status st;
    ix_mv *n;

    *out = (ix_solution_curves){.unknowns = 0};
    if (!(view[0] * view[0] + view[1] * view[1] + view[2] * view[2] > 0))
        return IX_FAIL(ctx, IX_EARG, "a view direction of length 0");
    IX_TRY(ix_srf_normal_field(ctx, s, &n));
    st = ix_contour(ctx, n, v, tol, out);
    ix_mv_unref(ctx, n);
    return st;
}
