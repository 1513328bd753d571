/* circle.c - whole circles, rational (exact) and polynomial (C1, four cubic
 * quarters). Both run counter-clockwise from +x over [0, 4]. */
#include "geom/circle.h"
#include "base/ctx.h"

#include <math.h>

/* sin 45 degrees, and the handle of a cubic quarter circle. */
#define HALF_SQRT2 0.70710678118654752440
#define HANDLE     0.55228474983079339840

ix_status ix__check_circle(ix_ctx *ctx, const double center[3], double radius)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(center[i]))
            return IX_FAIL(ctx, IX_EARG, "center (%g, %g, %g) is not finite",
                           center[0], center[1], center[2]);
    if (!(radius > 0 && isfinite(radius)))
        return IX_FAIL(ctx, IX_EARG, "radius %g is not positive", radius);
    return IX_OK;
}

ix_status ix_circle(ix_ctx *ctx, const double center[3], double radius,
                    ix_mv **out)
{
    static const double knots[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    static const int x[9] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
    static const int y[9] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    const ix_dir dir = {
        .basis = IX_BSPLINE, .order = 3, .length = 9, .knots = knots};
    double pts[4][9];

    *out = NULL;
    IX_TRY(ix__check_circle(ctx, center, radius));
    for (int i = 0; i < 9; i++) {
        double w = i % 2 ? HALF_SQRT2 : 1;

        pts[0][i] = w;
        pts[1][i] = w * (radius * x[i] + center[0]);
        pts[2][i] = w * (radius * y[i] + center[1]);
        pts[3][i] = w * center[2];
    }
    return ix_mv_new(ctx, 1, &dir, 3, true, pts[0], out);
}

ix_status ix_pcircle(ix_ctx *ctx, const double center[3], double radius,
                     ix_mv **out)
{
    static const double knots[14] = {0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4, 4};
    static const double k = HANDLE;
    const double x[10] = {1, 1, k, -k, -1, -1, -k, k, 1, 1};
    const double y[10] = {0, k, 1, 1, k, -k, -1, -1, -k, 0};
    const ix_dir dir = {
        .basis = IX_BSPLINE, .order = 4, .length = 10, .knots = knots};
    double pts[3][10];

    *out = NULL;
    IX_TRY(ix__check_circle(ctx, center, radius));
    for (int i = 0; i < 10; i++) {
        pts[0][i] = radius * x[i] + center[0];
        pts[1][i] = radius * y[i] + center[1];
        pts[2][i] = center[2];
    }
    return ix_mv_new(ctx, 1, &dir, 3, false, pts[0], out);
}
