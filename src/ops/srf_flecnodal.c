/* srf_flecnodal.c - tangent lines that meet a surface four or five times. */
#include "iritx/ops_srf.h"
#include "ops/contact_patches.h"

ix_status ix_srf_flecnodal(ix_ctx *ctx, const ix_mv *s, double tol,
                           ix_solution_curves *out)
{
    return ix__contact_curves(ctx, s, tol, 0.0, out);
}

ix_status ix_srf_flecnodal_points(ix_ctx *ctx, const ix_mv *s,
                                  ix_solutions *out)
{
    return ix__contact_points(ctx, s, out);
}
