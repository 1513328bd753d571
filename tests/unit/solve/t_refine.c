/* Points moved onto solution sets. */
#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/solve.h"

/* x^2 + y^2 - 1/2 on [0, 1]^2. */
static ix_mv *circle(ix_ctx *ctx)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};
    const double p[9] = {-0.5, -0.5, 0.5, -0.5, -0.5, 0.5, 0.5, 0.5, 1.5};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 1, false, p, &m));
    return m;
}

/* x - y. */
static ix_mv *diagonal(ix_ctx *ctx)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};
    const double p[4] = {0, 1, -1, 0};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 1, false, p, &m));
    return m;
}

/* Any start goes to the circle along its radius, to rounding. */
static void onto_a_curve(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_equation eq = {.f = circle(ctx), .rel = IX_EQUAL_ZERO};
    ix_rng g = ix_rng_new(31);

    (void)state;
    for (int i = 0; i < 200; i++) {
        double a = ix_rng_range(&g, 0.1, 1.4), r = ix_rng_range(&g, 0.4, 0.95);
        double x[2] = {r * cos(a), r * sin(a)};

        ASSERT_OK(ctx, ix_solve_refine(ctx, 1, &eq, x));
        ASSERT_CLOSE(x[0], sqrt(0.5) * cos(a), 1e-14);
        ASSERT_CLOSE(x[1], sqrt(0.5) * sin(a), 1e-14);
    }
    ix_mv_unref(ctx, eq.f);
    ix_ctx_free(ctx);
}

static void onto_a_point(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_equation eq[2] = {{.f = circle(ctx)}, {.f = diagonal(ctx)}};
    double x[2] = {0.7, 0.2};

    (void)state;
    ASSERT_OK(ctx, ix_solve_refine(ctx, 2, eq, x));
    ASSERT_CLOSE(x[0], 0.5, 1e-15);
    ASSERT_CLOSE(x[1], 0.5, 1e-15);
    ix_mv_unref(ctx, eq[0].f);
    ix_mv_unref(ctx, eq[1].f);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = circle(ctx);
    ix_equation eq[3] = {{.f = m}, {.f = m}, {.f = m}};
    double out[2] = {2, 0.5}, flat[2] = {0, 0}, x[2] = {0.5, 0.4};

    (void)state;
    assert_int_equal(ix_solve_refine(ctx, 3, eq, x), IX_EARG);
    assert_int_equal(ix_solve_refine(ctx, 0, eq, x), IX_EARG);
    assert_int_equal(ix_solve_refine(ctx, 2, eq, x), IX_EUNABLE);
    assert_int_equal(ix_solve_refine(ctx, 1, eq, flat), IX_EUNABLE);
    assert_int_equal(ix_solve_refine(ctx, 1, eq, out), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static ix_status fault_step(ix_ctx *ctx, void *state)
{
    const ix_equation eq = {.f = *(ix_mv **)state};
    double x[2] = {0.6, 0.6};

    return ix_solve_refine(ctx, 1, &eq, x);
}

static void fault_make(ix_ctx *ctx, void *state)
{
    *(ix_mv **)state = circle(ctx);
}

static void fault_drop(ix_ctx *ctx, void *state)
{
    ix_mv_unref(ctx, *(ix_mv **)state);
}

static void out_of_memory(void **state)
{
    ix_mv *m = NULL;
    const ix_fault_case c = {fault_make, fault_step, fault_drop, &m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(onto_a_curve), cmocka_unit_test(onto_a_point),
        cmocka_unit_test(errors), cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
