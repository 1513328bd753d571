/* matrix_parts.c - a matrix taken apart into scale, rotation and translation.
 * What cannot be recomposed (shear, perspective) is refused with its size. */
#include <float.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"

/* Admits matrices that were written with five digits. */
static const double ORTHO_TOL = 1e-4;

/* The linear part with the last entry divided out, and the translation. */
static ix_status affine_part(ix_ctx *ctx, const double m[16], double lin[3][3],
                             double t[3])
{
    double w = m[15], size = fabs(w);

    for (int i = 0; i < 12; i++)
        if (!isfinite(m[i]))
            return IX_FAIL(ctx, IX_EDOMAIN, "entry %d is not finite", i);
    if (!(size > 0) || !isfinite(size))
        return IX_FAIL(ctx, IX_EDOMAIN, "the last entry is %g", w);
    for (int i = 0; i < 3; i++) {
        if (!(fabs(m[4 * i + 3]) <= ORTHO_TOL * size))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "the matrix has perspective (entry %d is %g)",
                           4 * i + 3, m[4 * i + 3]);
        for (int j = 0; j < 3; j++)
            lin[i][j] = m[4 * i + j] / w;
        t[i] = m[12 + i] / w;
    }
    return IX_OK;
}

static void transpose(double a[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < i; j++) {
            double x = a[i][j];

            a[i][j] = a[j][i];
            a[j][i] = x;
        }
}

/* Unit rows and their lengths; the largest cosine between two of them, with
 * the pair; infinity if a row is zero. */
static double unit_rows(double a[3][3], double len[3], int pair[2])
{
    double worst = 0;

    for (int i = 0; i < 3; i++) {
        len[i] = ix__unit3(a[i], a[i]);
        if (!(len[i] > 0))
            return HUGE_VAL;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        double c = fabs(ix__dot3(a[i], a[j]));

        if (!(c <= worst)) {
            worst = c;
            pair[0] = i;
            pair[1] = j;
        }
    }
    return worst;
}

/* Makes nearly orthonormal rows orthonormal: the mean with the inverse
 * transpose is Newton's step to the polar factor (Higham 1986). For rows the
 * inverse transpose has the rows r1 x r2, ... over the determinant. */
static void orthonormalise(double r[3][3])
{
    for (int step = 0; step < 4; step++) { /* 1e-4, 1e-8, 1e-16 */
        double c[3][3], det;

        for (int i = 0; i < 3; i++)
            ix__cross3(r[(i + 1) % 3], r[(i + 2) % 3], c[i]);
        det = ix__dot3(r[0], c[0]);
        for (int i = 0; i < 9; i++)
            (&r[0][0])[i] = 0.5 * ((&r[0][0])[i] + (&c[0][0])[i] / det);
    }
}

/* Signs of the axes (rows of s) with the given product of signs and the
 * greatest trace of sign * r: the rotation nearest to none. */
static void choose_signs(double r[3][3], double det, double sign[3])
{
    static const double odd[4][3] = {
        {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}, {-1, -1, -1}};
    double best = -HUGE_VAL;

    for (int i = 0; i < 3; i++)
        sign[i] = 1;
    for (int k = 0; k < 4 && det < 0; k++) {
        double tr = odd[k][0] * r[0][0] + odd[k][1] * r[1][1] +
                    odd[k][2] * r[2][2];

        if (tr > best) {
            best = tr;
            memcpy(sign, odd[k], 3 * sizeof *sign);
        }
    }
}

static double det3(double a[3][3])
{
    double c[3];

    ix__cross3(a[1], a[2], c);
    return ix__dot3(a[0], c);
}

/* Tries the rows of a (R S: columns of the matrix, given transposed). */
static bool split(double a[3][3], double scale[3], double *worst, int pair[2])
{
    double sign[3];

    *worst = unit_rows(a, scale, pair);
    if (!(*worst <= ORTHO_TOL))
        return false;
    orthonormalise(a);
    choose_signs(a, det3(a), sign);
    for (int i = 0; i < 3; i++) {
        scale[i] *= sign[i];
        for (int j = 0; j < 3; j++)
            a[i][j] *= sign[i];
    }
    return true;
}

ix_status ix__mat_decompose(ix_ctx *ctx, const double m[16], ix__mat_parts *out)
{
    ix__mat_parts p;
    double rows[3][3], cols[3][3], worst, other;
    int pair[2], ignored[2];

    IX_TRY(affine_part(ctx, m, rows, p.trans));
    memcpy(cols, rows, sizeof cols);
    transpose(cols);
    ix__mat_identity(p.rot);
    if (split(cols, p.scale, &worst, pair)) {
        transpose(cols);
        memcpy(rows, cols, sizeof rows);
    } else if (worst == HUGE_VAL) {
        return IX_FAIL(ctx, IX_EDOMAIN, "the matrix is singular");
    } else if (!split(rows, p.scale, &other, ignored)) {
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the matrix has shear: columns %d and %d meet at %g "
                       "degrees",
                       pair[0] + 1, pair[1] + 1,
                       acos(fmin(worst, 1)) * 57.29577951308232);
    }
    for (int i = 0; i < 3; i++)
        memcpy(p.rot + 4 * (size_t)i, rows[i], sizeof rows[i]);
    *out = p;
    return IX_OK;
}

ix_status ix__mat_to_euler(ix_ctx *ctx, const double m[16], double v[7])
{
    ix__mat_parts p;
    double s, cb, *r = p.rot;

    IX_TRY(ix__mat_decompose(ctx, m, &p));
    s = fabs(p.scale[0]);
    for (int i = 1; i < 3; i++)
        if (!(fabs(fabs(p.scale[i]) - s) <= ORTHO_TOL * s))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "the scale is not uniform: %g, %g, %g", p.scale[0],
                           p.scale[1], p.scale[2]);
    s = (s + fabs(p.scale[1]) + fabs(p.scale[2])) / 3;
    if (p.scale[0] * p.scale[1] * p.scale[2] < 0) {
        s = -s; /* all three axes are turned round: R' = R diag(-sign) */
        for (int i = 0; i < 12; i++)
            r[i] = i % 4 < 3 && p.scale[i % 4] > 0 ? -r[i] : r[i];
    }
    cb = hypot(r[0], r[1]);
    v[1] = atan2(-r[2], cb);
    /* At cos b = 0 only a - c or a + c counts: take c = 0. The entries are
     * good to a few eps, so below that their angles say nothing. */
    v[0] = cb > 16 * DBL_EPSILON ? atan2(r[6], r[10]) : atan2(-r[9], r[5]);
    v[2] = cb > 16 * DBL_EPSILON ? atan2(r[1], r[0]) : 0;
    v[3] = s;
    memcpy(v + 4, p.trans, sizeof p.trans);
    return IX_OK;
}

void ix__mat_from_euler(const double v[7], double m[16])
{
    double sa = sin(v[0]), ca = cos(v[0]), sb = sin(v[1]), cb = cos(v[1]);
    double sc = sin(v[2]), cc = cos(v[2]);
    const double r[9] = {cb * cc,
                         cb * sc,
                         -sb,
                         sa * sb * cc - ca * sc,
                         sa * sb * sc + ca * cc,
                         sa * cb,
                         ca * sb * cc + sa * sc,
                         ca * sb * sc - sa * cc,
                         ca * cb};

    ix__mat_identity(m);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[4 * i + j] = v[3] * r[3 * i + j];
    memcpy(m + 12, v + 4, 3 * sizeof *m);
}
