/* matrix.c - making, multiplying, inverting and taking apart 4 x 4 matrices.
 * Everything is for row vectors: the image of e_i is row i. */
#include "geom/matrix.h"

#include <float.h>
#include <string.h>

#include "geom/vec3.h"

static const double PI = 3.14159265358979323846;

void ix__mat_identity(double m[16])
{
    for (int i = 0; i < 16; i++)
        m[i] = i % 5 == 0;
}

void ix__mat_translate(const double v[3], double m[16])
{
    ix__mat_identity(m);
    memcpy(m + 12, v, 3 * sizeof *v);
}

void ix__mat_scale(const double v[3], double m[16])
{
    ix__mat_identity(m);
    for (int i = 0; i < 3; i++)
        m[5 * i] = v[i];
}

void ix__sincos_deg(double deg, double *s, double *c)
{
    double r = fmod(deg, 360.0); /* exact */
    double q = nearbyint(r / 90.0);
    double x = (r - 90.0 * q) * (PI / 180.0); /* r - 90 q: exact */
    double sx = sin(x), cx = cos(x);
    int k = isfinite(q) ? ((int)q & 3) : 0;

    *s = k == 0 ? sx : k == 1 ? cx : k == 2 ? -sx : -cx;
    *c = k == 0 ? cx : k == 1 ? -sx : k == 2 ? -cx : sx;
    *s += 0.0; /* no negative zero */
    *c += 0.0;
}

void ix__mat_rotate(int axis, double deg, double m[16])
{
    int j = (axis + 1) % 3, k = (axis + 2) % 3;
    double s, c;

    ix__sincos_deg(deg, &s, &c);
    ix__mat_identity(m);
    m[5 * j] = m[5 * k] = c;
    m[4 * j + k] = s;
    m[4 * k + j] = 0.0 - s;
}

void ix__mat_mul(const double a[16], const double b[16], double out[16])
{
    double t[16];

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            t[4 * i + j] = (a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j]) +
                           (a[4 * i + 2] * b[8 + j] + a[4 * i + 3] * b[12 + j]);
    memcpy(out, t, sizeof t);
}

/* Multiplies four entries, step apart, by the power of two that brings the
 * largest to [1, 2), and returns it; zeros keep 1. */
static double level(double *a, int step)
{
    double big = 0, f = 1;

    for (int i = 0; i < 4; i++)
        big = fmax(big, fabs(a[i * step]));
    if (big > 0 && isfinite(big))
        f = ldexp(1.0, -ilogb(big));
    for (int i = 0; i < 4; i++)
        a[i * step] *= f;
    return f;
}

/* Brings the largest entry of a[k..][k..] to (k, k), b following the rows;
 * perm records which unknown column k now stands for. */
static double pivot(double a[4][4], double b[4][4], int perm[4], int k)
{
    int pi = k, pj = k, t;

    for (int i = k; i < 4; i++)
        for (int j = k; j < 4; j++)
            if (fabs(a[i][j]) > fabs(a[pi][pj])) {
                pi = i;
                pj = j;
            }
    for (int j = 0; j < 4; j++) {
        double x = a[k][j], y = b[k][j];

        a[k][j] = a[pi][j];
        a[pi][j] = x;
        b[k][j] = b[pi][j];
        b[pi][j] = y;
    }
    for (int i = 0; i < 4; i++) {
        double x = a[i][k];

        a[i][k] = a[i][pj];
        a[i][pj] = x;
    }
    t = perm[k];
    perm[k] = perm[pj];
    perm[pj] = t;
    return a[k][k];
}

/* One Gauss-Jordan step on column k of [a | b]. */
static void eliminate(double a[4][4], double b[4][4], int k)
{
    double p = a[k][k];

    for (int j = 0; j < 4; j++) {
        a[k][j] /= p;
        b[k][j] /= p;
    }
    for (int i = 0; i < 4; i++) {
        double f = a[i][k];

        for (int j = 0; j < 4 && i != k; j++) {
            a[i][j] -= f * a[k][j];
            b[i][j] -= f * b[k][j];
        }
    }
}

bool ix__mat_inverse(const double m[16], double out[16])
{
    double a[4][4], b[4][4], r[4], c[4];
    int perm[4] = {0, 1, 2, 3};

    memcpy(a, m, sizeof a);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            b[i][j] = i == j;
    for (int i = 0; i < 4; i++)
        r[i] = level(a[i], 1);
    for (int j = 0; j < 4; j++)
        c[j] = level(&a[0][j], 4);
    for (int k = 0; k < 4; k++) {
        /* Levelled entries are below 2: smaller is rounding. */
        if (!(fabs(pivot(a, b, perm, k)) >= 16 * DBL_EPSILON))
            return false;
        eliminate(a, b, k);
    }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            if (!isfinite(b[i][j]))
                return false;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            out[4 * perm[i] + j] = c[perm[i]] * b[i][j] * r[j] + 0.0;
    return true;
}

double ix__mat_det(const double m[16])
{
    double s[6], c[6]; /* 2 x 2 minors of the upper and the lower two rows */

    for (int i = 0, k = 0; i < 4; i++)
        for (int j = i + 1; j < 4; j++, k++) {
            s[k] = m[i] * m[4 + j] - m[j] * m[4 + i];
            c[k] = m[8 + i] * m[12 + j] - m[8 + j] * m[12 + i];
        }
    return s[0] * c[5] - s[1] * c[4] + s[2] * c[3] + s[3] * c[2] - s[4] * c[1] +
           s[5] * c[0];
}

bool ix__mat_point(const double p[3], const double m[16], double out[3])
{
    double h[4];

    for (int j = 0; j < 4; j++)
        h[j] = p[0] * m[j] + p[1] * m[4 + j] + p[2] * m[8 + j] + m[12 + j];
    if (h[3] == 0)
        return false;
    for (int j = 0; j < 3; j++)
        out[j] = h[3] == 1 ? h[j] : h[j] / h[3];
    return true;
}

/* Rodrigues: about the unit vector u by the angle of cosine c, sine s. */
static void rodrigues(const double u[3], double s, double c, double m[16])
{
    ix__mat_identity(m);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[4 * i + j] = (1 - c) * u[i] * u[j];
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;

        m[5 * i] += c;
        m[4 * j + k] += s * u[i];
        m[4 * k + j] -= s * u[i];
    }
}

ix_status ix__mat_rotate_about(ix_ctx *ctx, const double axis[3], double deg,
                               double m[16])
{
    double u[3], s, c;

    IX_TRY(ix__direction(ctx, "axis", axis, u));
    ix__sincos_deg(deg, &s, &c);
    rodrigues(u, s, c, m);
    return IX_OK;
}

ix_status ix__mat_turn(ix_ctx *ctx, const double a[3], const double b[3],
                       double m[16])
{
    double u[3], v[3], axis[3], s, c;

    IX_TRY(ix__direction(ctx, "vector", a, u));
    IX_TRY(ix__direction(ctx, "vector", b, v));
    ix__cross3(u, v, axis);
    s = ix__len3(axis);
    c = ix__dot3(u, v);
    if (s < 4 * DBL_EPSILON) { /* rounding of the products: no axis in it */
        ix__perp3(u, axis);
        s = 0;
        c = c < 0 ? -1 : 1;
    } else { /* near half a turn the axis is good only across u */
        ix__unit3(axis, axis);
        ix__axpy3(axis, -ix__dot3(axis, u), u, axis);
        ix__unit3(axis, axis);
    }
    rodrigues(axis, s, c, m);
    return IX_OK;
}

static void set_rows(const double x[3], const double y[3], const double z[3],
                     double m[16])
{
    ix__mat_identity(m);
    memcpy(m, x, 3 * sizeof *x);
    memcpy(m + 4, y, 3 * sizeof *y);
    memcpy(m + 8, z, 3 * sizeof *z);
}

/* Unit z along a, unit x along the part of b across a, y = z x x. */
static ix_status frame(ix_ctx *ctx, const double a[3], const double b[3],
                       double x[3], double y[3], double z[3])
{
    double v[3];

    IX_TRY(ix__direction(ctx, "direction", a, z));
    IX_TRY(ix__direction(ctx, "second direction", b, v));
    ix__cross3(z, v, y);
    if (!(ix__len3(y) >= 4 * DBL_EPSILON)) /* rounding of the products */
        return IX_FAIL(ctx, IX_EARG,
                       "(%g, %g, %g) and (%g, %g, %g) are parallel", a[0], a[1],
                       a[2], b[0], b[1], b[2]);
    ix__unit3(y, y);
    ix__cross3(y, z, x);
    ix__unit3(x, x);
    return IX_OK;
}

ix_status ix__mat_frame(ix_ctx *ctx, const double dir[3], const double dir2[3],
                        double m[16])
{
    double x[3], y[3], z[3];

    IX_TRY(frame(ctx, dir, dir2, x, y, z));
    set_rows(x, y, z, m);
    return IX_OK;
}

ix_status ix__mat_project(ix_ctx *ctx, const double plane[4],
                          const double eye[4], double m[16])
{
    double d = 0, size = 0;

    for (int i = 0; i < 4; i++) {
        d += plane[i] * eye[i];
        size += fabs(plane[i] * eye[i]);
    }
    if (!(fabs(d) > 8 * DBL_EPSILON * size)) /* rounding of the sum */
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the eye (%g, %g, %g; weight %g) lies in the plane",
                       eye[0], eye[1], eye[2], eye[3]);
    ix__mat_identity(m);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            m[4 * i + j] -= plane[i] * eye[j] / d;
    return IX_OK;
}

ix_status ix__mat_reflect(ix_ctx *ctx, const double plane[4], double m[16])
{
    double n[4];

    IX_TRY(ix__direction(ctx, "plane normal", plane, n));
    n[3] = plane[3] / ix__len3(plane);
    ix__mat_identity(m);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++)
            m[4 * i + j] -= 2 * n[i] * n[j];
    return IX_OK;
}

ix_status ix__mat_view(ix_ctx *ctx, const double pos[3], const double dir[3],
                       const double up[3], double m[16])
{
    double back[3] = {-dir[0], -dir[1], -dir[2]}, x[3], y[3], z[3];

    IX_TRY(frame(ctx, back, up, y, x, z)); /* its x lies along up */
    ix__cross3(y, z, x);
    ix__mat_identity(m);
    for (int i = 0; i < 3; i++) {
        m[4 * i] = x[i];
        m[4 * i + 1] = y[i];
        m[4 * i + 2] = z[i];
    }
    m[12] = -ix__dot3(pos, x);
    m[13] = -ix__dot3(pos, y);
    m[14] = -ix__dot3(pos, z);
    return IX_OK;
}

ix_status ix__mat_equilateral(ix_ctx *ctx, double p[3][3], double m[16])
{
    const double h = sqrt(0.75);
    const double to[16] = {2 * h, 0, 0, 0, h,  1.5,  0, 0,
                           0,     0, 1, 0, -h, -0.5, 0, 1};
    double a[16] = {0}, inv[16], size;

    ix__sub3(p[1], p[0], a);
    ix__sub3(p[2], p[0], a + 4);
    ix__cross3(a, a + 4, a + 8);
    size = ix__len3(a) * ix__len3(a + 4);
    if (!(ix__unit3(a + 8, a + 8) > 16 * DBL_EPSILON * size))
        return IX_FAIL(ctx, IX_EDOMAIN, "the three points are on one line");
    memcpy(a + 12, p[0], 3 * sizeof *a);
    a[15] = 1;
    if (!ix__mat_inverse(a, inv))
        return IX_FAIL(ctx, IX_EDOMAIN, "the three points are on one line");
    ix__mat_mul(inv, to, m);
    return IX_OK;
}
