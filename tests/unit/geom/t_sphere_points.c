/* t_sphere_points.c - point sets on the sphere: unit length, no near pairs,
 * no large holes. */
#include "geom/sphere_points.h"

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/test.h"

static double nearest(int n, double (*p)[3], const double q[3], int skip)
{
    double best = 9;

    for (int j = 0; j < n; j++)
        if (j != skip)
            best = fmin(best, ix__dist3(p[j], q));
    return best;
}

/* Law: neighbours between half and twice of sqrt(4 pi / n). */
static void test_sphere(void **state)
{
    double p[400][3];

    (void)state;
    for (int n = 1; n <= 400; n = n * 3 + 1) {
        ix__sphere_points(n, p);
        for (int i = 0; i < n; i++) {
            double d = nearest(n, p, p[i], i) / sqrt(12.566370614 / n);

            ASSERT_CLOSE(ix__len3(p[i]), 1.0, 1e-15);
            assert_true(n < 4 || (d > 0.5 && d < 2));
        }
    }
}

/* Law: every direction of the upper half is within the spacing (a square's
 * half diagonal is 0.71 of it), and no two are closer than 0.4 of it. */
static void test_hemisphere(void **state)
{
    static const double spacings[] = {3.1, 1, 0.3, 0.1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(31);

    (void)state;
    for (int k = 0; k < 4; k++) {
        int n;
        double(*p)[3];
        ix_mark mk = ix__scratch_mark(ctx);

        ASSERT_OK(ctx, ix__hemisphere_points(ctx, spacings[k], &n, &p));
        for (int i = 0; i < n; i++) {
            ASSERT_CLOSE(ix__len3(p[i]), 1.0, 1e-15);
            assert_true(p[i][2] >= 0);
            assert_true(k == 0 || nearest(n, p, p[i], i) > 0.4 * spacings[k]);
        }
        for (int i = 0; i < 50; i++) {
            double q[3] = {ix_rng_range(&g, -1, 1), ix_rng_range(&g, -1, 1),
                           ix_rng_range(&g, 0, 1)};

            ix__unit3(q, q);
            assert_true(nearest(n, p, q, -1) < spacings[k]);
        }
        ix__scratch_release(ctx, mk);
    }
    ix_ctx_free(ctx);
}

static void test_hemisphere_errors(void **state)
{
    static const double bad[] = {0, -1, 1e-4, 4, (double)NAN};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double(*p)[3];
    int n;

    (void)state;
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++)
        assert_int_equal(ix__hemisphere_points(ctx, bad[k], &n, &p), IX_EARG);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sphere),
        cmocka_unit_test(test_hemisphere),
        cmocka_unit_test(test_hemisphere_errors),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
