/* hermite.c - the cubic with given ends and end derivatives. */
#include "base/ctx.h"
#include "iritx/geom.h"

ix_status ix_hermite(ix_ctx *ctx, const double p0[3], const double p1[3],
                     const double v0[3], const double v1[3], ix_mv **out)
{
    const ix_dir dir = {.basis = IX_BEZIER, .order = 4, .length = 4};
    double pts[3][4];

    *out = NULL;
    for (int i = 0; i < 3; i++) {
        pts[i][0] = p0[i];
        pts[i][1] = p0[i] + v0[i] / 3;
        pts[i][2] = p1[i] - v1[i] / 3;
        pts[i][3] = p1[i];
    }
    return ix_mv_new(ctx, 1, &dir, 3, false, pts[0], out);
}
