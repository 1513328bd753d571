/* implicit.c - conics and quadrics as coefficient lists: transformed, promoted
 * to one more dimension, and the smallest ellipse around a triangle.
 *
 *   conic    A x^2 + B xy + C y^2 + D x + E y + F = 0
 *   quadric  A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J
 */
#include <math.h>
#include <string.h>

#include "base/ctx.h"
#include "geom/eigen.h"
#include "geom/matrix.h"
#include "geom/vec3.h"
#include "iritx/geom.h"

/* Places of the quadric's coefficients in its symmetric 4 x 4 matrix; those
 * off the diagonal count half. */
static const int place[10][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2},
                                 {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}};

static void to_matrix(const double q[10], double m[4][4])
{
    for (int k = 0; k < 10; k++) {
        int i = place[k][0], j = place[k][1];

        m[i][j] = m[j][i] = i == j ? q[k] : q[k] / 2;
    }
}

static void from_matrix(double m[4][4], double q[10])
{
    for (int k = 0; k < 10; k++) {
        int i = place[k][0], j = place[k][1];

        q[k] = i == j ? m[i][j] : m[i][j] + m[j][i];
    }
}

/* x' = x M keeps the zero set of x Q x^T if Q' = M^-1 Q M^-T. */
ix_status ix_quadric_transform(ix_ctx *ctx, const double q[10],
                               const double mat[16], double out[10])
{
    double inv[16], m[4][4], t[4][4], r[4][4];

    if (!ix__mat_inverse(mat, inv))
        return IX_FAIL(ctx, IX_EDOMAIN, "the matrix is singular");
    to_matrix(q, m);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            t[i][j] = 0;
            for (int k = 0; k < 4; k++)
                t[i][j] += inv[4 * i + k] * m[k][j];
        }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            r[i][j] = 0;
            for (int k = 0; k < 4; k++)
                r[i][j] += t[i][k] * inv[4 * j + k];
        }
    from_matrix(r, out);
    return IX_OK;
}

/* As a cylinder over the plane; what the matrix does to z does not count. */
ix_status ix_conic_transform(ix_ctx *ctx, const double c[6],
                             const double mat[16], double out[6])
{
    const double q[10] = {c[0], c[2], 0, c[1], 0, 0, c[3], c[4], 0, c[5]};
    double flat[16], r[10];

    memcpy(flat, mat, sizeof flat);
    for (int k = 0; k < 4; k++)
        flat[8 + k] = flat[4 * k + 2] = k == 2;
    IX_TRY(ix_quadric_transform(ctx, q, flat, r));
    out[0] = r[0];
    out[1] = r[3];
    out[2] = r[1];
    out[3] = r[6];
    out[4] = r[7];
    out[5] = r[9];
    return IX_OK;
}

ix_status ix_conic_to_quadric(ix_ctx *ctx, const double c[6], double height,
                              double out[10])
{
    double det = 4 * c[0] * c[2] - c[1] * c[1], x, y, at;

    if (!(fabs(height) > 0 && isfinite(height)))
        return IX_FAIL(ctx, IX_EARG, "height %g", height);
    /* 1e-12: rounding of products of coefficients that should cancel */
    if (!(fabs(det) > 1e-12 * (c[0] * c[0] + c[1] * c[1] + c[2] * c[2])))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the conic has no center: 4AC - B^2 is %g", det);
    x = (c[1] * c[4] - 2 * c[2] * c[3]) / det;
    y = (c[1] * c[3] - 2 * c[0] * c[4]) / det;
    at = (c[3] * x + c[4] * y) / 2 + c[5]; /* the form's value there */
    memcpy(out,
           (const double[10]){c[0], c[2], -at / (height * height), c[1], 0, 0,
                              c[3], c[4], 0, c[5]},
           10 * sizeof *out);
    return IX_OK;
}

/* Covariance and mean of three points in the plane. */
static void spread3(const double (*p)[3], double mean[2], double cov[4])
{
    for (int k = 0; k < 2; k++)
        mean[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
    for (int k = 0; k < 4; k++) {
        cov[k] = 0;
        for (int i = 0; i < 3; i++)
            cov[k] += (p[i][k / 2] - mean[k / 2]) *
                      (p[i][k % 2] - mean[k % 2]) / 3;
    }
}

/* Steiner's circumellipse: (x - m)^T S^-1 (x - m) = 2 with mean m and
 * covariance S of the corners. */
ix_status ix_ellipse_three_points(ix_ctx *ctx, const double (*p)[3],
                                  double offset, double out[6])
{
    double m[2], cov[4], val[2], vec[4], f[2];

    spread3(p, m, cov);
    ix__eigen_symmetric(2, cov, val, vec);
    if (!(val[1] > 1e-24 * val[0])) /* 1e-12 of a length: rounding */
        return IX_FAIL(ctx, IX_EDOMAIN, "the three points are on one line");
    for (int k = 0; k < 2; k++) {
        double axis = sqrt(2 * val[k]) + offset;

        if (!(axis > 0 && isfinite(axis)))
            return IX_FAIL(ctx, IX_EARG,
                           "offset %g leaves no ellipse: a semi-axis is %g",
                           offset, axis);
        f[k] = 1 / (axis * axis);
    }
    out[0] = f[0] * vec[0] * vec[0] + f[1] * vec[2] * vec[2];
    out[1] = 2 * (f[0] * vec[0] * vec[1] + f[1] * vec[2] * vec[3]);
    out[2] = f[0] * vec[1] * vec[1] + f[1] * vec[3] * vec[3];
    out[3] = -2 * out[0] * m[0] - out[1] * m[1];
    out[4] = -2 * out[2] * m[1] - out[1] * m[0];
    out[5] = -(out[3] * m[0] + out[4] * m[1]) / 2 - 1;
    return IX_OK;
}
