/* fit_line.c - the line and the plane nearest to points, in the sense of least
 * squares of distances: through the mean, along the principal axes. */
#include <math.h>

#include "base/ctx.h"
#include "geom/eigen.h"
#include "geom/vec3.h"
#include "iritx/geom.h"

/* Mean and principal axes (rows of axes, spreads falling) of p[n][3]. */
static ix_status principal(ix_ctx *ctx, int n, const double *p, double mean[3],
                           double spread[3], double axes[9])
{
    double cov[9] = {0};

    for (int k = 0; k < 3; k++)
        mean[k] = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            mean[k] += p[3 * i + k] / n;
    if (!isfinite(mean[0] + mean[1] + mean[2]))
        return IX_FAIL(ctx, IX_EARG, "a point is not finite");
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 9; k++)
            cov[k] += (p[3 * i + k / 3] - mean[k / 3]) *
                      (p[3 * i + k % 3] - mean[k % 3]);
    ix__eigen_symmetric(3, cov, spread, axes);
    return IX_OK;
}

ix_status ix_fit_line(ix_ctx *ctx, int n, const double *p, double point[3],
                      double dir[3], double *dist)
{
    double mean[3], spread[3], axes[9], ends[3];

    if (n < 2)
        return IX_FAIL(ctx, IX_EARG, "a line needs two points, not %d", n);
    IX_TRY(principal(ctx, n, p, mean, spread, axes));
    if (!(spread[0] > 0))
        return IX_FAIL(ctx, IX_EDOMAIN, "all %d points are equal", n);
    ix__sub3(p + 3 * ((size_t)n - 1), p, ends);
    for (int k = 0; k < 3; k++)
        dir[k] = ix__dot3(ends, axes) < 0 ? -axes[k] : axes[k];
    ix__axpy3(mean, -ix__dot3(mean, dir), dir, point);
    *dist = 0;
    for (int i = 0; i < n; i++) {
        double v[3];

        ix__sub3(p + 3 * i, mean, v);
        ix__axpy3(v, -ix__dot3(v, dir), dir, v);
        *dist += ix__len3(v) / n;
    }
    return IX_OK;
}

/* Twice the area vector of the closed polygon (Newell), about the mean. */
static void area_vector(int n, const double *p, const double mean[3],
                        double out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i < n; i++) {
        double a[3], b[3], c[3];

        ix__sub3(p + 3 * i, mean, a);
        ix__sub3(p + 3 * ((i + 1) % n), mean, b);
        ix__cross3(a, b, c);
        ix__axpy3(out, 1, c, out);
    }
}

ix_status ix_fit_plane(ix_ctx *ctx, int n, const double *p, double plane[4],
                       double *dist)
{
    double mean[3], spread[3], axes[9], area[3], sign = 1;

    if (n < 3)
        return IX_FAIL(ctx, IX_EARG, "a plane needs three points, not %d", n);
    IX_TRY(principal(ctx, n, p, mean, spread, axes));
    /* 1e-24 of a spread is 1e-12 of a length: rounding */
    if (!(spread[1] > 1e-24 * spread[0]))
        return IX_FAIL(ctx, IX_EDOMAIN, "all %d points are on one line", n);
    area_vector(n, p, mean, area);
    /* turned so that the points run counter-clockwise, if they do */
    if (ix__dot3(area, axes + 6) < -1e-9 * spread[0])
        sign = -1;
    for (int k = 0; k < 3; k++)
        plane[k] = sign * axes[6 + k];
    plane[3] = -ix__dot3(plane, mean);
    *dist = 0;
    for (int i = 0; i < n; i++) {
        double v[3];

        ix__sub3(p + 3 * i, mean, v);
        *dist += fabs(ix__dot3(v, plane)) / n;
    }
    return IX_OK;
}
