/* param.c - parameters for points: they start at 0, end at 1 and never fall. */
#include <math.h>
#include <string.h>

#include "base/ctx.h"
#include "geom/angle.h"
#include "geom/eigen.h"
#include "iritx/geom.h"

/* Coordinates in which the points' covariance is the unit matrix (directions
 * without extent are left out): lengths and angles there do not change under
 * affine maps of the points. pts and out: double[ncoords][n]. */
static void whiten(int n, int ncoords, const double *pts, double *out)
{
    double cov[IX_MAX_COORDS * IX_MAX_COORDS], val[IX_MAX_COORDS];
    double vec[IX_MAX_COORDS * IX_MAX_COORDS], mean[IX_MAX_COORDS];

    for (int c = 0; c < ncoords; c++) {
        mean[c] = 0;
        for (int i = 0; i < n; i++)
            mean[c] += pts[c * n + i] / n;
    }
    for (int a = 0; a < ncoords; a++)
        for (int b = 0; b < ncoords; b++) {
            double s = 0;

            for (int i = 0; i < n; i++)
                s += (pts[a * n + i] - mean[a]) * (pts[b * n + i] - mean[b]);
            cov[a * ncoords + b] = s / n;
        }
    ix__eigen_symmetric(ncoords, cov, val, vec);
    for (int k = 0; k < ncoords; k++) {
        /* 1e-20 of a variance is 1e-10 of a length: rounding, not extent */
        double f = val[k] > 1e-20 * val[0] ? 1 / sqrt(val[k]) : 0;

        for (int i = 0; i < n; i++) {
            double s = 0;

            for (int c = 0; c < ncoords; c++)
                s += vec[k * ncoords + c] * (pts[c * n + i] - mean[c]);
            out[k * n + i] = f * s;
        }
    }
}

/* Length of step i, from point i to i + 1. */
static double step_length(int n, int ncoords, const double *p, int i)
{
    double s = 0;

    for (int c = 0; c < ncoords; c++)
        s = hypot(s, p[c * n + i + 1] - p[c * n + i]);
    return s;
}

/* min(angle at point i, pi/2), the angle between the steps i - 1 and i seen
 * from outside (0: straight on). */
static double bend(int n, int ncoords, const double *p, const double *d, int i)
{
    double s = 0, c;

    if (d[i - 1] == 0 || d[i] == 0)
        return 0;
    for (int k = 0; k < ncoords; k++)
        s += (p[k * n + i] - p[k * n + i - 1]) *
             (p[k * n + i + 1] - p[k * n + i]);
    c = s / (d[i - 1] * d[i]);
    return fmin(acos(fmax(-1, fmin(1, c))), IX__PI / 2);
}

/* h_i = d_i (1 + 3/2 a_i d_{i-1} / (d_{i-1} + d_i)
 *              + 3/2 a_{i+1} d_{i+1} / (d_i + d_{i+1})). */
static void nielson_foley(int n, int ncoords, const double *p, const double *d,
                          double *h)
{
    for (int i = 0; i < n - 1; i++) {
        double f = 1;

        if (i > 0 && d[i - 1] + d[i] > 0)
            f += 1.5 * bend(n, ncoords, p, d, i) * d[i - 1] / (d[i - 1] + d[i]);
        if (i < n - 2 && d[i + 1] + d[i] > 0)
            f += 1.5 * bend(n, ncoords, p, d, i + 1) * d[i + 1] /
                 (d[i] + d[i + 1]);
        h[i] = d[i] * f;
    }
}

/* Sizes of the n - 1 steps under the rule. */
static ix_status steps(ix_ctx *ctx, ix_param how, int n, int ncoords,
                       const double *pts, double *h)
{
    double *p, *d;

    for (int i = 0; i < n - 1; i++)
        h[i] = how == IX_PARAM_UNIFORM ? 1 : step_length(n, ncoords, pts, i);
    for (int i = 0; how == IX_PARAM_CENTRIPETAL && i < n - 1; i++)
        h[i] = sqrt(h[i]);
    if (how != IX_PARAM_NIELSON_FOLEY)
        return IX_OK;
    IX_SCRATCH(ctx, p, (size_t)n * (size_t)ncoords);
    IX_SCRATCH(ctx, d, n);
    whiten(n, ncoords, pts, p);
    for (int i = 0; i < n - 1; i++)
        d[i] = step_length(n, ncoords, p, i);
    nielson_foley(n, ncoords, p, d, h);
    return IX_OK;
}

static ix_status params(ix_ctx *ctx, ix_param how, int n, int ncoords,
                        const double *pts, double *out)
{
    double *h, sum = 0;

    IX_SCRATCH(ctx, h, n);
    IX_TRY(steps(ctx, how, n, ncoords, pts, h));
    out[0] = 0;
    for (int i = 0; i < n - 1; i++)
        out[i + 1] = sum += h[i];
    if (!(sum > 0 && isfinite(sum)))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "parameters of %d points: total length is %g", n, sum);
    for (int i = 0; i < n; i++)
        out[i] = how == IX_PARAM_UNIFORM ? (double)i / (n - 1) : out[i] / sum;
    out[n - 1] = 1;
    return IX_OK;
}

ix_status ix_params(ix_ctx *ctx, ix_param how, int n, int ncoords,
                    const double *pts, double *out)
{
    if (n < 2 || ncoords < 1 || ncoords > IX_MAX_COORDS)
        return IX_FAIL(ctx, IX_EARG, "parameters of %d points", n);
    IX_RETURN_SCOPED(ctx, params(ctx, how, n, ncoords, pts, out));
}
