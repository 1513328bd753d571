/* Curvature as a function and back. */
#include "crv_test.h"

/* Law: the curve of a curvature has it, by arc length: k(s) = 1 - 3 s^2 over
 * [0, 1], 64 pieces; C1 cubics are good to h^2 in the curvature, about 1e-4. */
static void curve_has_its_curvature(void **state)
{
    static const double k[3] = {1, 1, -2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *f = make_crv(ctx, 3, 3, NULL, false, 1, k), *c;
    double len;

    (void)state;
    ASSERT_OK(ctx, ix_curve_of_curvature(ctx, f, 64, false, &c));
    ASSERT_OK(ctx, ix_length(ctx, c, NULL, &len));
    ASSERT_CLOSE(len, 1, 1e-8);
    for (int i = 0; i < 10; i++) {
        double s = (i + 0.5) / 10, got;

        ASSERT_OK(ctx, ix_crv_curvature(ctx, c, s, &got));
        ASSERT_CLOSE(got, fabs(1 - 3 * s * s), 1e-3);
    }
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_curve_of_curvature(ctx, f, 8, true, &c));
    for (int a = 0; a < 2; a++) {
        const double *x = ix_mv_axis(c, a);

        ASSERT_CLOSE(x[0], x[ix_mv_length(c, 0) - 1], 1e-15);
    }
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, f);
    ix_ctx_free(ctx);
}

/* A circle of radius 2, run backwards: -1/2 everywhere, by parameter and by
 * arc length. */
static void circle_is_constant(void **state)
{
    static const double center[3] = {5, 1, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c, *back, *k;
    double dom[2];

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, center, 2, &c));
    ASSERT_OK(ctx, ix_mv_reverse(ctx, c, 0, &back));
    for (int arclen = 0; arclen < 2; arclen++) {
        ASSERT_OK(ctx, ix_curvature_function(ctx, back, 33, 4, arclen, &k));
        assert_int_equal(ix_mv_npts(k), 33);
        for (int i = 0; i < 33; i++)
            ASSERT_CLOSE(ix_mv_axis(k, 0)[i], -0.5, 1e-13);
        ix_mv_domain(k, 0, dom);
        ASSERT_CLOSE(dom[1], arclen ? 12.566370614359172 : 4, 1e-11);
        ix_mv_unref(ctx, k);
    }
    assert_int_equal(ix_curvature_function(ctx, c, 3, 4, false, &k), IX_EARG);
    assert_int_equal(ix_curve_of_curvature(ctx, c, 3, false, &k), IX_EARG);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, back);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curve_has_its_curvature),
        cmocka_unit_test(circle_is_constant),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
