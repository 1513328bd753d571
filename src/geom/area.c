/* area.c - the area that the position vector sweeps, exactly. */
#include "base/ctx.h"
#include "geom/parts.h"
#include "iritx/geom.h"
#include "iritx/sym.h"

static ix_status area(ix_ctx *ctx, const ix_mv *crv, ix_mv *t[4], ix_mv **out)
{
    const double half_z[3] = {0, 0, 0.5};

    IX_TRY(ix_mv_coerce(ctx, crv, 2, false, &t[0]));
    IX_TRY(ix_sym_derive(ctx, t[0], 0, NULL, &t[1]));
    IX_TRY(ix_sym_cross(ctx, t[0], t[1], NULL, &t[2]));
    IX_TRY(ix_sym_dot_vector(ctx, t[2], half_z, &t[3]));
    return ix_sym_integrate(ctx, t[3], 0, out);
}

ix_status ix_area(ix_ctx *ctx, const ix_mv *crv, ix_mv **out)
{
    ix_mv *t[4] = {NULL};
    ix_status st;

    *out = NULL;
    if (ix_mv_ndirs(crv) != 1 || ix_mv_ncoords(crv) < 2)
        return IX_FAIL(ctx, IX_EARG, "an area needs a curve with x and y");
    if (ix_mv_rational(crv))
        return IX_FAIL(ctx, IX_EARG,
                       "the area of a rational curve is not rational: make it "
                       "polynomial first");
    st = area(ctx, crv, t, out);
    ix__mv_unref_all(ctx, t, 4);
    return st;
}
