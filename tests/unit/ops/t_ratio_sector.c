/* Sectors of constant ratio: the definition at all points, the ratio's limit,
 * errors. */
#include <string.h>

#include "crv_test.h"
#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8701)

/* Of length 0.4, along x (across 0) or y (1), at (x, 0, z). */
static ix_mv *segment(ix_ctx *own, double x, int across, double z)
{
    double a = across ? 0 : 0.2, b = across ? 0.2 : 0.02;
    const double pts[6] = {x - a, x + a, -b, b, z, z};
    ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    ix_mv *m = NULL;

    return ix_mv_new(own, 1, &d, 3, false, pts, &m) == IX_OK ? m : NULL;
}

/* Law: the ratio of the distances is alpha : 1 - alpha, and feet are along
 * normals, within the error that is told; for lines that are nearly orthogonal.
 */
static void constant_ratio(void **state)
{
    static const double alphas[] = {0.3, 0.45, 0.7};

    (void)state;
    for (int i = 0; i < 3; i++) {
        double alpha = alphas[i], tol = 1e-5, err;
        ix_mv *a = segment(ctx, 0, 0, 0), *b = segment(ctx, 0.1, 1, 1);
        ix_crvs s;

        ASSERT_OK(ctx, ix_ratio_sector(ctx, a, b, alpha, tol, &err, &s));
        assert_int_equal(s.n, 2);
        assert_true(err <= tol);
        for (int j = 0; j < 50; j++) {
            double t[2] = {ix_rng_unit(&rng), ix_rng_unit(&rng)}, x[3], p[6];
            double q[6], f[3], g[3];

            ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[j & 1], t, x));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, a, t[0], 1, p));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, b, t[1], 1, q));
            ix__sub3(x, p, f);
            ix__sub3(x, q, g);
            assert_true(fabs((1 - alpha) * ix__len3(f) - alpha * ix__len3(g)) <=
                        2 * tol);
            assert_true(fabs(ix__dot3(f, p + 3)) <= 2 * tol * ix__len3(p + 3));
            assert_true(fabs(ix__dot3(g, q + 3)) <= 2 * tol * ix__len3(q + 3));
        }
        ix_crvs_free(ctx, &s);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
}

static void expect(const ix_mv *a, const ix_mv *b, double alpha, double tol,
                   ix_status st, const char *text)
{
    ix_crvs s;

    assert_int_equal(ix_ratio_sector(ctx, a, b, alpha, tol, NULL, &s), st);
    assert_int_equal(s.n, 0);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

static void refused(void **state)
{
    ix_mv *a = segment(ctx, 0, 0, 0), *b = segment(ctx, 0.1, 1, 1);
    ix_mv *far = segment(ctx, 5, 1, 0.1), *scalar;

    (void)state;
    expect(a, b, 0.5, 1e-3, IX_EARG, "a ratio of 0.5");
    expect(a, b, NAN, 1e-3, IX_EARG, "a ratio of nan");
    expect(a, b, 0.4, 0, IX_EARG, "a tolerance of 0");
    expect(a, a, 0.4, 1e-3, IX_EDOMAIN, "no point with this ratio");
    expect(far, a, 0.4, 1e-3, IX_EDOMAIN, "no point with this ratio");
    expect(a, b, 0.4, 1e-15, IX_EUNABLE, "257 x 257 points");
    ASSERT_OK(ctx, ix_mv_scalar(ctx, a, 0, &scalar));
    expect(a, scalar, 0.4, 1e-3, IX_EARG, "operand 2");
    ix_mv_unref(ctx, scalar);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, far);
}

static void make(ix_ctx *own, ix_build_case *f)
{
    f->in[0] = segment(own, 0, 0, 0);
    f->in[1] = segment(own, 0.1, 1, 1);
}

static ix_status build(ix_ctx *own, const ix_build_case *f, ix_mv **out)
{
    ix_crvs s;

    IX_TRY(ix_ratio_sector(own, f->in[0], f->in[1], 0.4, 1.0, NULL, &s));
    *out = ix_mv_ref(s.crv[1]);
    ix_crvs_free(own, &s);
    return IX_OK;
}

static void memory_may_fail(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_ratio),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
