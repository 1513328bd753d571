/* line_test.h - how a Bezier surface lies over a line that touches it, by
 * Newton's method in long double, independent of the library. */
#ifndef UNIT_OPS_LINE_TEST_H
#define UNIT_OPS_LINE_TEST_H

#include <string.h>

#include "harness/test.h"
#include "mv/mv.h"

typedef long double real;

/* Bernstein polynomials of degree n and their derivatives. */
static inline void lt_basis(int n, real t, real *b, real *d)
{
    real low[8] = {0};

    memset(b, 0, 8 * sizeof *b);
    b[0] = 1;
    for (int k = 1; k <= n; k++) {
        memcpy(low, b, sizeof low);
        for (int i = k; i >= 0; i--)
            b[i] = (1 - t) * b[i] + (i > 0 ? t * b[i - 1] : 0);
    }
    for (int i = 0; i <= n; i++)
        d[i] = n * ((i > 0 ? low[i - 1] : 0) - (i < n ? low[i] : 0));
}

/* S, S_u, S_v; parameters may lie outside. */
static inline void lt_eval(const ix_mv *m, real u, real v, real out[3][3])
{
    int n = m->dirs[0].length;
    real b[2][8], d[2][8], h[3][4] = {{0}};
    const double *w = ix_mv_weights(m);

    lt_basis(n - 1, u, b[0], d[0]);
    lt_basis(m->dirs[1].length - 1, v, b[1], d[1]);
    for (size_t k = 0; k < m->npts; k++) {
        int i = (int)k % n, j = (int)k / n;
        real f[3] = {b[0][i] * b[1][j], d[0][i] * b[1][j], b[0][i] * d[1][j]};

        for (int e = 0; e < 3; e++) {
            h[e][3] += f[e] * (w ? w[k] : 1);
            for (int c = 0; c < 3; c++)
                h[e][c] += f[e] * ix_mv_coord(m, c)[k];
        }
    }
    for (int c = 0; c < 3; c++) {
        out[0][c] = h[0][c] / h[0][3];
        for (int e = 1; e < 3; e++)
            out[e][c] = (h[e][c] - out[0][c] * h[e][3]) / h[0][3];
    }
}

static inline real lt_det(const real a[3], const real b[3], const real c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) -
           a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* h with S(u, v) + h n = x. */
static inline real lt_height(const ix_mv *m, real u, real v, const real n[3],
                             const real x[3])
{
    real h = 0;

    for (int it = 0; it < 6; it++) {
        real s[3][3], r[3], det;

        lt_eval(m, u, v, s);
        for (int c = 0; c < 3; c++)
            r[c] = x[c] - s[0][c] - h * n[c];
        det = lt_det(s[1], s[2], n);
        u += lt_det(r, s[2], n) / det;
        v += lt_det(s[1], r, n) / det;
        h += lt_det(s[1], s[2], r) / det;
    }
    return h;
}

#define LT_STEP 0.004L /* of a unit surface */

/* out[k], k = 0 .. 4: the k-th derivative of the height over the line at p =
 * (u, v, a, b), by differences of 9 points (error of the order of the step's
 * 5th power at least). False: no normal. */
static inline void lt_contact(const ix_mv *m, const double *p, real out[5])
{
    static const real w[5][5] = {
        /* of h(-k) +- h(k), k = 0 .. 4 */
        {1, 0, 0, 0, 0},
        {0, 4.L / 5, -1.L / 5, 4.L / 105, -1.L / 280},
        {-205.L / 72, 8.L / 5, -1.L / 5, 8.L / 315, -1.L / 560},
        {0, -61.L / 30, 169.L / 120, -3.L / 10, 7.L / 240},
        {91.L / 8, -122.L / 15, 169.L / 60, -2.L / 5, 7.L / 240}};
    real s[3][3], n[3], d[3], len = 0, nlen = 0, h[9], step = 1;

    lt_eval(m, p[0], p[1], s);
    for (int c = 0; c < 3; c++) {
        int i = (c + 1) % 3, j = (c + 2) % 3;

        n[c] = s[1][i] * s[2][j] - s[1][j] * s[2][i];
        d[c] = p[2] * s[1][c] + p[3] * s[2][c];
        nlen += n[c] * n[c];
        len += d[c] * d[c];
    }
    for (int c = 0; c < 3; c++) {
        n[c] /= sqrtl(nlen);
        d[c] /= sqrtl(len);
    }
    for (int k = -4; k <= 4; k++) {
        real x[3];

        for (int c = 0; c < 3; c++)
            x[c] = s[0][c] + k * LT_STEP * d[c];
        h[k + 4] = lt_height(m, p[0], p[1], n, x);
    }
    for (int k = 0; k < 5; k++, step *= LT_STEP) {
        out[k] = w[k][0] * h[4];
        for (int i = 1; i < 5; i++)
            out[k] += w[k][i] * (h[4 + i] + (k % 2 ? -h[4 - i] : h[4 - i]));
        out[k] /= step;
    }
}

/* A Bezier graph over [0, 1]^2 with random heights. */
static inline ix_mv *lt_random(ix_ctx *ctx, ix_rng *rng, int du, int dv,
                               bool rational)
{
    const ix_dir dirs[2] = {{IX_BEZIER, du + 1, du + 1, false, NULL},
                            {IX_BEZIER, dv + 1, dv + 1, false, NULL}};
    int np = (du + 1) * (dv + 1);
    double pts[4 * 64], *p = pts + (rational ? np : 0);
    ix_mv *m;

    for (int i = 0; i < np; i++) {
        double w = rational ? ix_rng_range(rng, 0.8, 1.25) : 1;

        pts[i] = w;
        p[i] = w * (i % (du + 1)) / du;
        p[np + i] = w * (double)(i / (du + 1)) / dv;
        p[2 * np + i] = w * ix_rng_range(rng, 0, 1);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 3, rational, pts, &m));
    return m;
}

/* z of degrees 1 and 1 over [0, 1]^2 from its corners. */
static inline ix_mv *lt_bilinear(ix_ctx *ctx, const double z[4])
{
    const ix_dir dirs[2] = {{IX_BEZIER, 2, 2, false, NULL},
                            {IX_BEZIER, 2, 2, false, NULL}};
    const double pts[12] = {0, 1, 0, 1, 0, 0, 1, 1, z[0], z[1], z[2], z[3]};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 3, false, pts, &m));
    return m;
}

#endif
