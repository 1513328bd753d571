/* t_spread.c - random parameters, uniform over domains or shapes. */
#include <stdlib.h>

#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* Law: by length as many points fall on both halves of the curve, by
 * parameter on both halves of the domain. */
static void test_curve(void **state)
{
    enum { N = 2000 };
    gt t = gt_begin(121);
    /* A parabola traversed slowly, then fast: x = u^2, length in x. */
    ix_mv *c = gt_curve(&t, 3, 3, NULL, 1, false, (double[3]){0, 0, 1});
    double u[N];
    uint64_t seed = t.r.s;
    int below[2] = {0, 0};

    (void)state;
    for (int by = 0; by < 2; by++) {
        ASSERT_OK(t.ctx, ix_spread(t.ctx, c, by, N, &seed, u));
        for (int i = 0; i < N; i++) {
            assert_true(u[i] >= 0 && u[i] <= 1);
            below[by] += (by ? u[i] * u[i] : u[i]) < 0.5;
        }
        /* Five standard deviations of N fair coins. */
        assert_true(abs(below[by] - N / 2) < 5 * sqrt(N) / 2);
    }
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

/* Law: on a disk in polar form points are uniform in area: half of them
 * beyond the radius sqrt(1/2). */
static void test_surface(void **state)
{
    enum { N = 2000 };
    gt t = gt_begin(122);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){0, 1, 0, 0});
    ix_mv *s = NULL;
    double uv[2][N];
    uint64_t seed = t.r.s;
    int far = 0;

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_revolve(t.ctx, c, IX_TURN_RATIONAL, &s));
    ASSERT_OK(t.ctx, ix_spread(t.ctx, s, true, N, &seed, uv[0]));
    for (int i = 0; i < N; i++)
        far += uv[1][i] > sqrt(0.5);
    assert_true(abs(far - N / 2) < 5 * sqrt(N) / 2);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(124);
    ix_mv *p = gt_curve(&t, 2, 2, NULL, 1, false, (double[2]){5, 5});
    ix_mv *m = gt_random(&t, 3, 3, -1, IX_RAND_BEZIER, 2);
    double u[3];
    uint64_t seed = 1;

    (void)state;
    assert_int_equal(ix_spread(t.ctx, p, true, 1, &seed, u), IX_EDOMAIN);
    assert_int_equal(ix_spread(t.ctx, m, false, 1, &seed, u), IX_EARG);
    assert_int_equal(ix_spread(t.ctx, p, false, -1, &seed, u), IX_EARG);
    ix_mv_unref(t.ctx, p);
    ix_mv_unref(t.ctx, m);
    gt_end(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_curve),
                                       cmocka_unit_test(test_surface),
                                       cmocka_unit_test(test_errors)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
