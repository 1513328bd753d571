/* t_tri_eval.c - triangular Bezier patches. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

enum { MAX_ORDER = 7, MAX_PTS = MAX_ORDER * (MAX_ORDER + 1) / 2 };

/* n! / (i! j! (n-i-j)!) */
static double multinomial(int n, int i, int j)
{
    double f = 1;

    for (int k = 1; k <= n; k++)
        f *= k;
    for (int k = 1; k <= i; k++)
        f /= k;
    for (int k = 1; k <= j; k++)
        f /= k;
    for (int k = 1; k <= n - i - j; k++)
        f /= k;
    return f;
}

/* The sum of Bernstein polynomials; u, v, w need not sum up to 1. */
static double bernstein(int order, const double *pts, const double b[3])
{
    double s = 0;

    for (int j = 0; j < order; j++)
        for (int i = 0; i + j < order; i++)
            s += *pts++ * multinomial(order - 1, i, j) *
                 pow(b[0], order - 1 - i - j) * pow(b[1], i) * pow(b[2], j);
    return s;
}

/* Laws: values are sums of Bernstein polynomials; derivatives are those of the
 * sum along the stated directions. */
static void test_eval(void **state)
{
    static const double along[3][3] = {{1, 0, -1}, {0, 1, -1}, {-1, 0, 1}};
    gt t = gt_begin(81);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        int order = ix_rng_int(&t.r, 1, MAX_ORDER), n = order * (order + 1) / 2;
        double pts[2 * MAX_PTS], d[2 * MAX_PTS], b[3], c[3], v[2], e[2];

        for (int i = 0; i < 2 * n; i++)
            pts[i] = ix_rng_range(&t.r, -1, 1);
        b[0] = ix_rng_unit(&t.r);
        b[1] = ix_rng_range(&t.r, 0, 1 - b[0]);
        b[2] = 1 - b[0] - b[1];
        ASSERT_OK(t.ctx, ix_tri_eval(t.ctx, order, 2, pts, b, v));
        for (int a = 0; a < 2; a++)
            ASSERT_CLOSE(v[a], bernstein(order, pts + a * n, b), 1e-13);
        for (int dir = 0; dir < 3; dir++) {
            const double h = 1e-4;

            ix_tri_derive(order, 2, dir, pts, d);
            ASSERT_OK(t.ctx, ix_tri_eval(t.ctx, order > 1 ? order - 1 : 1, 2, d,
                                         b, v));
            for (int a = 0; a < 2; a++) {
                e[a] = 0;
                for (int s = -1; s <= 1; s += 2) {
                    for (int i = 0; i < 3; i++)
                        c[i] = b[i] + s * h * along[dir][i];
                    e[a] += s * bernstein(order, pts + a * n, c) / (2 * h);
                }
                ASSERT_CLOSE(v[a], e[a], 1e-4); /* h^2 times f''' / 6 */
            }
        }
    }
    gt_end(&t);
}

/* Law: the curve of a constant parameter is the patch there; the first of the
 * others falls, the second grows. */
static void test_iso(void **state)
{
    gt t = gt_begin(84);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        int order = ix_rng_int(&t.r, 1, MAX_ORDER), n = order * (order + 1) / 2;
        double pts[2 * MAX_PTS], crv[2 * MAX_ORDER], v[2], b[3], at;
        double x = ix_rng_unit(&t.r), s = ix_rng_unit(&t.r);
        int dir = k % 3;
        ix_mv *c;

        for (int i = 0; i < 2 * n; i++)
            pts[i] = ix_rng_range(&t.r, -1, 1);
        b[dir] = x;
        b[dir == 0 ? 1 : 0] = (1 - x) * (1 - s);
        b[dir == 2 ? 1 : 2] = (1 - x) * s;
        ASSERT_OK(t.ctx, ix_tri_iso(t.ctx, order, 2, dir, x, pts, crv));
        c = gt_curve(&t, order, order, NULL, 2, false, crv);
        at = s;
        ASSERT_OK(t.ctx, ix_mv_point(t.ctx, c, &at, v));
        for (int a = 0; a < 2; a++)
            ASSERT_CLOSE(v[a], bernstein(order, pts + a * n, b), 1e-13);
        ix_mv_unref(t.ctx, c);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    const double pts[1] = {1}, good[3] = {0.2, 0.3, 0.5}, bad[3] = {1, 1, 1};
    gt t = gt_begin(82);
    double v;

    (void)state;
    assert_int_equal(ix_tri_eval(t.ctx, 0, 1, pts, good, &v), IX_EARG);
    assert_int_equal(ix_tri_eval(t.ctx, 1, 1, pts, bad, &v), IX_EDOMAIN);
    ASSERT_OK(t.ctx, ix_tri_eval(t.ctx, 1, 1, pts, good, &v));
    assert_true(v == 1);
    assert_int_equal(ix_tri_iso(t.ctx, 0, 1, 0, 0.5, pts, &v), IX_EARG);
    assert_int_equal(ix_tri_iso(t.ctx, 1, 1, 3, 0.5, pts, &v), IX_EARG);
    assert_int_equal(ix_tri_iso(t.ctx, 1, 1, 0, 1.5, pts, &v), IX_EDOMAIN);
    assert_int_equal(ix_tri_iso(t.ctx, 1, 1, 0, (double)NAN, pts, &v),
                     IX_EDOMAIN);
    gt_end(&t);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    const double pts[3] = {1, 2, 3}, at[3] = {0.2, 0.3, 0.5};
    double v, row[2];

    (void)state;
    IX_TRY(ix_tri_iso(ctx, 2, 1, 0, 0.5, pts, row));
    return ix_tri_eval(ctx, 2, 1, pts, at, &v);
}

static void test_no_memory(void **state)
{
    const ix_fault_case c = {NULL, run, NULL, NULL};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_eval), cmocka_unit_test(test_iso),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
