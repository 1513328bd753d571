/* Convex hulls in space: closed, convex, around all points; corners against
 * all triples of points, solids of known numbers of corners. */
#include "base/ctx.h"
#include "geom/hull3.h"
#include "geom/vec3.h"
#include "harness/test.h"

enum { MOST = 3000 };

static double volume(const double *a, const double *b, const double *c,
                     const double *d)
{
    double u[3], v[3], w[3], n[3];

    ix__sub3(b, a, u);
    ix__sub3(c, a, v);
    ix__sub3(d, a, w);
    ix__cross3(u, v, n);
    return ix__dot3(n, w);
}

/* Law: every edge belongs to two faces, once in each direction; Euler's
 * formula; no point is above a face. 1e-10: the grid, 2^-38 of the size, with
 * rounding. Returns the number of corners. */
static int check(int n, const double (*p)[3], int nf, int (*f)[3])
{
    static bool corner[MOST];
    int corners = 0;

    for (int i = 0; i < n; i++)
        corner[i] = false;
    for (int i = 0; i < nf; i++)
        for (int k = 0; k < 3; k++) {
            int a = f[i][k], b = f[i][(k + 1) % 3], across = 0, along = 0;

            corner[a] = true;
            for (int j = 0; nf < 600 && j < nf; j++)
                for (int e = 0; e < 3; e++) {
                    across += f[j][e] == b && f[j][(e + 1) % 3] == a;
                    along += f[j][e] == a && f[j][(e + 1) % 3] == b;
                }
            assert_true(nf >= 600 || (across == 1 && along == 1));
        }
    for (int i = 0; i < n; i++)
        corners += corner[i];
    assert_int_equal(corners - 3 * nf / 2 + nf, 2);
    for (int i = 0; i < nf; i++)
        for (int k = 0; k < n; k += 1 + n / 500)
            assert_true(volume(p[f[i][0]], p[f[i][1]], p[f[i][2]], p[k]) <=
                        1e-10);
    return corners;
}

/* Corners; *v: six times the volume. */
static int corners_of(ix_ctx *ctx, int n, const double (*p)[3], double *v)
{
    ix_mark mk = ix__scratch_mark(ctx);
    int nf, (*f)[3], corners;
    double flat[3];

    ASSERT_OK(ctx, ix__hull3(ctx, n, p, &nf, &f, flat));
    corners = check(n, p, nf, f);
    *v = 0;
    for (int i = 0; i < nf; i++)
        *v -= volume(p[f[i][0]], p[f[i][1]], p[f[i][2]], p[0]);
    ix__scratch_release(ctx, mk);
    return corners;
}

/* A point is a corner if some plane through it and two others has all points
 * at one side. */
static int corners_by_triples(int n, const double (*p)[3])
{
    int corners = 0;

    for (int a = 0; a < n; a++) {
        bool found = false;

        for (int b = 0; b < n && !found; b++)
            for (int c = 0; c < n && !found; c++) {
                found = a != b && b != c && c != a;
                for (int d = 0; d < n && found; d++)
                    found = volume(p[a], p[b], p[c], p[d]) <= 0 || d == a ||
                            d == b || d == c;
            }
        corners += found;
    }
    return corners;
}

static void random_points(void **state)
{
    static double p[MOST][3];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(91);
    double v;

    (void)state;
    for (int round = 0; round < 30; round++) {
        int n = ix_rng_int(&g, 5, 25);

        for (int i = 0; i < n; i++)
            for (int k = 0; k < 3; k++)
                p[i][k] = ix_rng_range(&g, -1, 1);
        assert_int_equal(corners_of(ctx, n, (const double(*)[3])p, &v),
                         corners_by_triples(n, (const double(*)[3])p));
    }
    for (int i = 0; i < MOST; i++) { /* on a sphere all are corners */
        for (int k = 0; k < 3; k++)
            p[i][k] = ix_rng_range(&g, -1, 1);
        ix__unit3(p[i], p[i]);
    }
    assert_int_equal(corners_of(ctx, MOST, (const double(*)[3])p, &v), MOST);
    ix_ctx_free(ctx);
}

/* Grids of points: many in one plane, on one edge, and twice. */
static void degenerate(void **state)
{
    static double p[MOST][3];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double flat[3], v, area = 0;
    int nf, (*f)[3], n = 0;
    ix_mark mk = ix__scratch_mark(ctx);

    (void)state;
    for (int i = 0; i < 2 * 343; i++, n++) {
        p[n][0] = i % 7 / 3.0;
        p[n][1] = i / 7 % 7 / 7.0;
        p[n][2] = i / 49 % 7 / 5.0;
    }
    assert_in_range(corners_of(ctx, n, (const double(*)[3])p, &v), 8, 20);
    ASSERT_CLOSE(v, 6 * 2 * (6 / 7.0) * 1.2, 1e-13);
    for (int i = 0; i < n; i++) /* a prism with a round side */
        p[i][0] = sqrt(1.0001 - p[i][1] * p[i][1]);
    assert_in_range(corners_of(ctx, n, (const double(*)[3])p, &v), 14, 28);
    for (int i = 0; i < 6; i++) { /* trapezia below the arc, less the chord's */
        const double *a = p[7 * i], *b = p[7 * i + 7];

        area += (b[1] - a[1]) * (a[0] + b[0]) / 2;
    }
    area -= p[42][1] * (p[0][0] + p[42][0]) / 2;
    ASSERT_CLOSE(v, 6 * area * 1.2, 1e-13);
    for (int i = 0; i < n; i++)
        p[i][2] = 0.5 * p[i][0] + p[i][1];
    ASSERT_OK(ctx, ix__hull3(ctx, n, (const double(*)[3])p, &nf, &f, flat));
    assert_int_equal(nf, 0);
    ASSERT_CLOSE(fabs(flat[0]), 1 / 3.0, 1e-9);
    for (int i = 0; i < n; i++)
        p[i][1] = p[i][2] = 0;
    assert_int_equal(ix__hull3(ctx, n, (const double(*)[3])p, &nf, &f, flat),
                     IX_EDOMAIN);
    p[3][0] = NAN;
    assert_int_equal(ix__hull3(ctx, n, (const double(*)[3])p, &nf, &f, flat),
                     IX_EDOMAIN);
    ix__scratch_release(ctx, mk);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_points),
        cmocka_unit_test(degenerate),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
