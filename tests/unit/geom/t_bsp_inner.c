/* t_bsp_inner.c - inner products of B-spline basis functions. */
#include "iritx/geom_srf.h"
#include "iritx/sym.h"
#include "unit/geom/geomtest.h"

/* The basis function itself as a curve. */
static ix_mv *basis_curve(gt *t, const ix_dir *dir, int i)
{
    double pts[64] = {0};
    ix_mv *m = NULL;

    assert_true(dir->length <= 64);
    pts[i] = 1;
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 1, dir, 1, false, pts, &m));
    return m;
}

/* Law: the integral of the exact product of the two functions as curves. */
static void test_product(void **state)
{
    gt t = gt_begin(71);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *m = gt_random(&t, 1, 1, -1,
                             k % 3 ? IX_RAND_OPEN : IX_RAND_BEZIER, 1);
        ix_dir dir = ix_mv_dir(m, 0);
        int order[2] = {dir.order, dir.order}, n = dir.length;
        int index[2] = {ix_rng_int(&t.r, 0, n - 1), ix_rng_int(&t.r, 0, n - 1)};
        ix_mv *f = basis_curve(&t, &dir, index[0]);
        ix_mv *g = basis_curve(&t, &dir, index[1]), *p = NULL, *i = NULL;
        double dom[2], end, v;

        ASSERT_OK(t.ctx, ix_bsp_inner(t.ctx, &dir, order, index, &v));
        ASSERT_OK(t.ctx, ix_sym_mul(t.ctx, f, g, NULL, &p));
        ASSERT_OK(t.ctx, ix_sym_integrate(t.ctx, p, 0, &i));
        ix_mv_domain(i, 0, dom);
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, i, &dom[1], &end));
        ASSERT_CLOSE(v, end, 1e-13);
        ix_mv_unref(t.ctx, m);
        ix_mv_unref(t.ctx, f);
        ix_mv_unref(t.ctx, g);
        ix_mv_unref(t.ctx, p);
        ix_mv_unref(t.ctx, i);
    }
    gt_end(&t);
}

/* Law: functions of different orders on one knot vector: those of each order
 * sum up to 1 on its own domain, so with order 1 (the characteristic functions
 * of the spans) all inner products of B_i sum up to its integral, the length
 * of its support divided by its order. */
static void test_orders(void **state)
{
    const double knots[10] = {0, 1, 1.5, 2, 4, 4, 5, 7, 7.5, 8};
    const ix_dir dir = {IX_BSPLINE, 3, 7, false, knots};
    gt t = gt_begin(72);

    (void)state;
    for (int o = 1; o <= 6; o++)
        for (int i = 0; i + o < 10; i++) {
            double sum = 0, v;

            for (int j = 0; j < 9; j++) {
                ASSERT_OK(t.ctx, ix_bsp_inner(t.ctx, &dir, (int[2]){o, 1},
                                              (int[2]){i, j}, &v));
                sum += v;
            }
            ASSERT_CLOSE(sum, (knots[i + o] - knots[i]) / o, 1e-13);
        }
    gt_end(&t);
}

static void test_errors(void **state)
{
    const ix_dir bez = {IX_BEZIER, 3, 3, false, NULL};
    const ix_dir pow = {IX_POWER, 3, 3, false, NULL};
    gt t = gt_begin(73);
    double v;

    (void)state;
    assert_int_equal(
        ix_bsp_inner(t.ctx, &pow, (int[2]){3, 3}, (int[2]){0, 0}, &v), IX_EARG);
    assert_int_equal(
        ix_bsp_inner(t.ctx, &bez, (int[2]){0, 3}, (int[2]){0, 0}, &v), IX_EARG);
    assert_int_equal(
        ix_bsp_inner(t.ctx, &bez, (int[2]){3, 6}, (int[2]){0, 0}, &v), IX_EARG);
    assert_int_equal(
        ix_bsp_inner(t.ctx, &bez, (int[2]){3, 3}, (int[2]){0, 3}, &v), IX_EARG);
    assert_int_equal(
        ix_bsp_inner(t.ctx, &bez, (int[2]){3, 9999}, (int[2]){0, 3}, &v),
        IX_EARG);
    ASSERT_OK(t.ctx,
              ix_bsp_inner(t.ctx, &bez, (int[2]){3, 3}, (int[2]){0, 2}, &v));
    ASSERT_CLOSE(v, 1.0 / 30, 1e-15); /* integral of (1-t)^2 t^2 */
    gt_end(&t);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    const ix_dir bez = {IX_BEZIER, 3, 3, false, NULL};
    double v;

    (void)state;
    return ix_bsp_inner(ctx, &bez, (int[2]){3, 3}, (int[2]){0, 2}, &v);
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
        cmocka_unit_test(test_product), cmocka_unit_test(test_orders),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
