/* The bound of a distance: above all samples, not far above, also for weights
 * that nearly agree. */
#include "geom/gap.h"

#include <math.h>

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(1995)

/* A cubic of 3 coordinates; its weights are moved by about change. */
static void pair(ix_ctx *c, bool rational, double change, ix_mv *m[2])
{
    const ix_dir d = {IX_BEZIER, 4, 4, false, NULL};
    double pts[16];

    for (int i = 0; i < 16; i++)
        pts[i] = i < 4 ? 1 + 0.1 * i : 0.3 * ((i * 7) % 5) - 0.5;
    ASSERT_OK(
        c, ix_mv_new(c, 1, &d, 3, rational, pts + (rational ? 0 : 4), &m[0]));
    for (int i = 0; i < 4; i++)
        pts[i] *= 1 + change * i;
    pts[5] += change;
    ASSERT_OK(
        c, ix_mv_new(c, 1, &d, 3, rational, pts + (rational ? 0 : 4), &m[1]));
}

/* Law: the largest distance of samples <= the bound <= three times that. */
static void bounds(void **state)
{
    (void)state;
    for (int r = 0; r < 2; r++)
        for (double change = 1e-7; change < 0.1; change *= 10) {
            double bound, far = 0, x[2][3];
            ix_mv *m[2];

            pair(ctx, r == 1, change, m);
            ASSERT_OK(ctx, ix__gap_bound(ctx, m[0], m[1], &bound));
            for (int i = 0; i <= 200; i++) {
                double t = i / 200.0;

                for (int k = 0; k < 2; k++)
                    ASSERT_OK(ctx, ix_mv_point(ctx, m[k], &t, x[k]));
                far = fmax(far, ix__dist3(x[0], x[1]));
            }
            /* values of the order of 1 are rounded */
            assert_true(bound >= far - 1e-15 && bound <= 3 * far);
            for (int k = 0; k < 2; k++)
                ix_mv_unref(ctx, m[k]);
        }
}

static void mixed(void **state)
{
    ix_mv *m[2], *p;
    double bound;

    (void)state;
    pair(ctx, false, 0, m);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m[0], 3, true, &p));
    ASSERT_OK(ctx, ix__gap_bound(ctx, p, m[1], &bound));
    assert_true(bound <= 1e-15);
    ASSERT_OK(ctx, ix__gap_bound(ctx, m[1], p, &bound));
    assert_true(bound <= 1e-15);
    for (int k = 0; k < 2; k++)
        ix_mv_unref(ctx, m[k]);
    ix_mv_unref(ctx, p);
}

static void poles(void **state)
{
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    static const double pts[8] = {1, -1, 0, 1, 0, 2, 0, 3};
    double bound;
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, true, pts, &m));
    /* the square of the weight is positive, but not its coefficients */
    assert_int_equal(ix__gap_bound(ctx, m, m, &bound), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
}

static void job_setup(ix_ctx *c, void *state)
{
    pair(c, true, 0.01, state);
}

static ix_status job_run(ix_ctx *c, void *state)
{
    ix_mv **m = state;
    double bound;

    return ix__gap_bound(c, m[0], m[1], &bound);
}

static void job_teardown(ix_ctx *c, void *state)
{
    ix_mv **m = state;

    for (int k = 0; k < 2; k++)
        ix_mv_unref(c, m[k]);
}

static void every_allocation_fails(void **state)
{
    ix_mv *m[2];
    ix_fault_case c = {job_setup, job_run, job_teardown, m};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds), cmocka_unit_test(mixed),
        cmocka_unit_test(poles), cmocka_unit_test(every_allocation_fails)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
