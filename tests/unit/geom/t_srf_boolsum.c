/* t_srf_boolsum.c - patches from boundary curves. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* A Bezier curve with given ends, of random order, weights 1 at the ends if
 * rational (scaled by end_weight). */
static ix_mv *between(gt *t, const double a[2], const double b[2],
                      bool rational, double end_weight)
{
    int n = ix_rng_int(&t->r, 2, 5);
    double pts[3][5];

    for (int i = 0; i < n; i++) {
        bool end = i == 0 || i == n - 1;
        double w = !rational ? 1
                   : end     ? end_weight
                             : ix_rng_range(&t->r, 0.5, 2);

        pts[0][i] = w;
        for (int k = 0; k < 2; k++)
            pts[1 + k][i] = w * (i == 0       ? a[k]
                                 : i == n - 1 ? b[k]
                                              : ix_rng_range(&t->r, -1, 1));
    }
    if (n < 5)
        for (int k = 1; k < 3; k++)
            memmove((double *)pts + k * n, pts[k], (size_t)n * sizeof(double));
    return gt_curve(t, n, n, NULL, 2, rational,
                    rational ? pts[0] : (double *)pts + n);
}

/* Law: the four sides of the patch are the four curves. */
static void check_sides(gt *t, const ix_mv *s, ix_mv *const c[4])
{
    for (int k = 0; k < 4; k++) {
        double x = ix_rng_unit(&t->r), p[IX_MAX_COORDS], q[IX_MAX_COORDS];
        double uv[2] = {k < 2 ? x : k - 2, k < 2 ? k : x}, at;
        double dom[2];

        ix_mv_domain(c[k], 0, dom);
        at = dom[0] + x * (dom[1] - dom[0]);
        gt_point(t, s, uv, p);
        gt_point(t, c[k], &at, q);
        gt_same(p, q, 3, TOL);
    }
}

/* Laws: the sides are the curves; with equal weights at the corners the degree
 * is the largest of opposite curves, else sums of weights raise it. */
static void test_boolsum(void **state)
{
    static const double corner[4][2] = {{0, 0}, {2, 0.5}, {-0.5, 1}, {1, 2}};
    gt t = gt_begin(21);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        bool rational = k % 3 > 0;
        double w = k % 3 == 2 ? 1.5 : 1;
        ix_mv *c[4], *s = NULL;

        c[0] = between(&t, corner[0], corner[1], rational, 1);
        c[1] = between(&t, corner[2], corner[3], false, 1);
        c[2] = between(&t, corner[0], corner[2], rational, w);
        c[3] = between(&t, corner[1], corner[3], rational, 1);
        if (k % 2) {
            ix_mv *moved = NULL;

            ASSERT_OK(t.ctx, ix_mv_reparam(t.ctx, c[1], 0, -1, 4, &moved));
            ix_mv_unref(t.ctx, c[1]);
            c[1] = moved;
        }
        ASSERT_OK(t.ctx, ix_srf_boolsum(t.ctx, c[0], c[1], c[2], c[3], &s));
        check_sides(&t, s, c);
        if (w == 1)
            for (int d = 0; d < 2; d++) {
                int o1 = ix_mv_order(c[2 * d], 0);
                int o2 = ix_mv_order(c[2 * d + 1], 0);

                assert_int_equal(ix_mv_order(s, d), o1 > o2 ? o1 : o2);
            }
        for (int i = 0; i < 4; i++)
            ix_mv_unref(t.ctx, c[i]);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

static ix_mv *circle(gt *t)
{
    const double k[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    const double h = sqrt(0.5);
    const double pts[27] = {1,  h, 1, h, 1, h, 1, h, 1, 1,  h,  0,  -h, -1,
                            -h, 0, h, 1, 0, h, 1, h, 0, -h, -1, -h, 0};

    return gt_curve(t, 3, 9, k, 2, true, pts);
}

/* Law: the boundary of the disk is the circle; orders stay 3. */
static void test_boolone(void **state)
{
    gt t = gt_begin(22);
    ix_mv *c = circle(&t), *s = NULL;

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_boolone(t.ctx, c, &s));
    assert_int_equal(ix_mv_order(s, 0), 3);
    assert_int_equal(ix_mv_order(s, 1), 3);
    for (int k = 0; k < ROUNDS; k++) {
        double x = ix_rng_unit(&t.r), p[IX_MAX_COORDS];
        double uv[2] = {k % 4 < 2 ? x : k % 2, k % 4 < 2 ? k % 2 : x};

        gt_point(&t, s, uv, p);
        ASSERT_CLOSE(hypot(p[0], p[1]), 1, 1e-14);
    }
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(23);
    ix_mv *a = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){0, 1, 0, 0});
    ix_mv *b = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){0, 0, 0, 1});
    ix_mv *s = gt_random(&t, 2, 2, -1, IX_RAND_BEZIER, 2), *out;

    (void)state;
    assert_int_equal(ix_srf_boolsum(t.ctx, a, a, b, b, &out), IX_EARG);
    assert_int_equal(ix_srf_boolsum(t.ctx, a, s, b, b, &out), IX_EARG);
    assert_int_equal(ix_srf_boolone(t.ctx, a, &out), IX_EARG);
    assert_int_equal(ix_srf_boolone(t.ctx, s, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, a);
    ix_mv_unref(t.ctx, b);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(24)};

    f->in[0] = circle(&t);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_boolone(ctx, f->in[0], out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_boolsum), cmocka_unit_test(test_boolone),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
