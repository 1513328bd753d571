/* The bisector of a point and a curve on the unit sphere. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8801)

/* Law: P.(q - C) = 0 and P.C' = 0; an arc of the equator and the pole: z = 1
 * at the distance 1 from the axis, halfway. */
static void on_the_sphere(void **state)
{
    const double s = sqrt(0.5), arc[12] = {1, s, 1, 1, s, 0, 0, s, 1, 0, 0, 0};
    const double pole[3] = {0, 0, 1};
    ix_mv *c = make_crv(ctx, 3, 3, NULL, true, 3, arc), *b;

    (void)state;
    ASSERT_OK(ctx, ix_sphere_bisector_point(ctx, c, pole, NULL, &b));
    assert_int_equal(degree_of(b, 0), 2);
    for (int i = 0; i < 9; i++) {
        double t = i / 8.0, x[3], d[6];

        ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, x));
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, d));
        ASSERT_CLOSE(x[2], 1, 1e-15);
        ASSERT_CLOSE(hypot(x[0], x[1]), 1, 1e-14);
        ASSERT_CLOSE(ix__dot3(x, d + 3), 0, 1e-14);
        ASSERT_CLOSE(ix__dot3(x, d), 1, 1e-14);
    }
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
}

static void refused(void **state)
{
    const double up[6] = {1, 1, 0, 0, -1, 1}, q[3] = {0, 1, 0};
    ix_mv *c = make_crv(ctx, 2, 2, NULL, false, 3, up), *s;

    (void)state;
    assert_int_equal(ix_sphere_bisector_point(ctx, c, q, NULL, &s), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "in the plane z = 1"));
    ix_mv_unref(ctx, c);
}

static void make(ix_ctx *own, ix_build_case *f)
{
    ix_rng r = ix_rng_new(36);
    crv_kind k = {2, 3, true, 2, 0, 0};

    f->in[0] = rand_crv(own, &r, &k);
}

static ix_status build(ix_ctx *own, const ix_build_case *f, ix_mv **out)
{
    const double q[3] = {0, 0.3, 1};

    return ix_sphere_bisector_point(own, f->in[0], q, NULL, out);
}

static void memory_may_fail(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_the_sphere),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
