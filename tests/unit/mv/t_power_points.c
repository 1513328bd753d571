/* t_power_points.c - the constant 1 of a power basis has one coefficient: a
 * weight that is added, and translations, must act on that one only. */
#include "harness/randmv.h"

/* Laws: coercion to a rational type keeps the points; a matrix maps them. */
static void test_power(void **state)
{
    const double mat[16] = {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 3, 0, 4, 5, 6, 2};
    const ix_rand_opts o = {.ncoords = 3, .kinds = IX_RAND_POWER};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(3);

    (void)state;
    print_message("seed %llu\n", (unsigned long long)r.s);
    for (int k = 0; k < 40; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &r, &o), *c = NULL, *h = NULL;
        double t[3] = {ix_rng_unit(&r), ix_rng_unit(&r), ix_rng_unit(&r)};
        double p[3], q[3];

        ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 3, true, &c));
        ASSERT_OK(ctx, ix_mv_point(ctx, m, t, p));
        ASSERT_OK(ctx, ix_mv_point(ctx, c, t, q));
        for (int i = 0; i < 3; i++)
            ASSERT_CLOSE(p[i], q[i], 1e-13);
        ASSERT_OK(ctx, ix_mv_transform(ctx, m, mat, &h));
        ASSERT_OK(ctx, ix_mv_point(ctx, h, t, q));
        for (int i = 0; i < 3; i++)
            ASSERT_CLOSE(q[i],
                         (p[0] * mat[i] + p[1] * mat[4 + i] +
                          p[2] * mat[8 + i] + mat[12 + i]) /
                             2,
                         1e-13);
        ix_mv_unref(ctx, m);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, h);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_power)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
