/* register.c - see the header. */
#include "geom/register.h"

#include <math.h>
#include <string.h>

#include "geom/eigen.h"
#include "geom/matrix.h"
#include "geom/vec3.h"
#include "iritx/distance.h"

static void mean_of(int n, const double (*p)[3], double out[3])
{
    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < n; i++)
        ix__axpy3(out, 1.0 / n, p[i], out);
}

/* The rotation of the unit quaternion q = (w, x, y, z), for row vectors. */
static void rotation(const double q[4], double m[16])
{
    double w = q[0], x = q[1], y = q[2], z = q[3];
    const double r[16] = {1 - 2 * (y * y + z * z),
                          2 * (x * y + w * z),
                          2 * (x * z - w * y),
                          0,
                          2 * (x * y - w * z),
                          1 - 2 * (x * x + z * z),
                          2 * (y * z + w * x),
                          0,
                          2 * (x * z + w * y),
                          2 * (y * z - w * x),
                          1 - 2 * (x * x + y * y),
                          0,
                          0,
                          0,
                          0,
                          1};

    memcpy(m, r, sizeof r);
}

/* The motion for which the sum of |p_i M - q_i|^2 is least: the quaternion is
 * the first eigenvector of Horn's symmetric 4 x 4 matrix. */
static void best_motion(int n, const double (*p)[3], const double (*q)[3],
                        double m[16])
{
    double s[3][3] = {{0}}, a[3], b[3], value[4], vector[16], moved[3];

    mean_of(n, p, a);
    mean_of(n, q, b);
    for (int i = 0; i < n; i++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                s[r][c] += (p[i][r] - a[r]) * (q[i][c] - b[c]);
    {
        double h[16] = {
            s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1],
            s[2][0] - s[0][2],           s[0][1] - s[1][0],
            s[1][2] - s[2][1],           s[0][0] - s[1][1] - s[2][2],
            s[0][1] + s[1][0],           s[2][0] + s[0][2],
            s[2][0] - s[0][2],           s[0][1] + s[1][0],
            s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1],
            s[0][1] - s[1][0],           s[2][0] + s[0][2],
            s[1][2] + s[2][1],           s[2][2] - s[0][0] - s[1][1]};

        ix__eigen_symmetric(4, h, value, vector);
    }
    rotation(vector, m);
    (void)ix__mat_point(a, m, moved);
    for (int k = 0; k < 3; k++)
        m[12 + k] = b[k] - moved[k];
}

static ix_status nearest(ix_ctx *ctx, const double p[3], int m,
                         const double (*q)[3], const ix_mv *srf, double out[3])
{
    double best = HUGE_VAL, x[IX_MAX_COORDS] = {0}, uv[2];

    if (srf) {
        IX_TRY(ix_srf_nearest(ctx, srf, p, false, uv, &best));
        IX_TRY(ix_mv_point(ctx, srf, uv, x));
        memcpy(out, x, 3 * sizeof *out);
        return IX_OK;
    }
    for (int j = 0; j < m; j++) {
        double d = ix__dist3(p, q[j]);

        if (d < best) {
            best = d;
            memcpy(out, q[j], 3 * sizeof *out);
        }
    }
    return IX_OK;
}

static ix_status iterate(ix_ctx *ctx, int n, const double (*p)[3], int m,
                         const double (*q)[3], const ix_mv *srf, int iters,
                         double eps, double mat[16], double *err)
{
    double(*to)[3], before = HUGE_VAL;

    IX_SCRATCH(ctx, to, n);
    ix__mat_identity(mat);
    for (int k = 0; k < iters; k++) {
        double sum = 0;

        IX_TRY(ix__poll(ctx));
        for (int i = 0; i < n; i++) {
            double at[3], d;

            (void)ix__mat_point(p[i], mat, at);
            IX_TRY(nearest(ctx, at, m, q, srf, to[i]));
            d = ix__dist3(at, to[i]);
            sum += d * d;
        }
        *err = sqrt(sum / n);
        if (before - *err <= eps)
            return IX_OK;
        before = *err;
        best_motion(n, p, (const double(*)[3])to, mat);
    }
    return IX_OK;
}

ix_status ix__register(ix_ctx *ctx, int n, const double (*p)[3], int m,
                       const double (*q)[3], const ix_mv *srf, int iters,
                       double eps, double mat[16], double *err)
{
    if (n < 3 || (!srf && m < 3))
        return IX_FAIL(ctx, IX_EARG,
                       "%d and %d points; three and more are wanted", n, m);
    if (iters < 1)
        return IX_FAIL(ctx, IX_EARG, "%d steps", iters);
    IX_RETURN_SCOPED(ctx, iterate(ctx, n, p, m, q, srf, iters, eps, mat, err));
}
