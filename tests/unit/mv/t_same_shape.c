/* Operations that change the representation only: to_bspline, to_float,
 * to_open, power basis, knots inserted, orders raised, regions, splits. */
#include "harness/fault.h"
#include "harness/randmv.h"

/* Rounding of a few convex combinations of order up to 6. */
#define TOL 2e-14

static ix_ctx *ctx;
static ix_rng rng;

static int setup(void **state)
{
    (void)state;
    ctx = ix_ctx_new(NULL, NULL);
    rng = ix_rng_new(7);
    return ctx ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    ix_ctx_free(ctx);
    return 0;
}

static void kinds_of_knots(void **state)
{
    (void)state;
    for (int k = 0; k < 150; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *b, *f, *o;

        ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
        ASSERT_OK(ctx, ix_mv_to_float(ctx, m, &f));
        ASSERT_OK(ctx, ix_mv_to_open(ctx, m, &o));
        ix_mv_assert_same(ctx, &rng, m, b, TOL);
        ix_mv_assert_same(ctx, &rng, m, f, TOL);
        ix_mv_assert_same(ctx, &rng, m, o, TOL);
        for (int d = 0; d < ix_mv_ndirs(m); d++) {
            assert_int_equal(ix_mv_dir(b, d).basis, IX_BSPLINE);
            assert_false(ix_mv_dir(f, d).periodic);
        }
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, o);
        ix_mv_unref(ctx, m);
    }
}

static void power_basis(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_BEZIER | IX_RAND_POWER};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *b, *p;

        ASSERT_OK(ctx, ix_mv_power_to_bezier(ctx, m, &b));
        ASSERT_OK(ctx, ix_mv_bezier_to_power(ctx, b, &p));
        /* order 6 in each of three directions: conditions up to 10^3 each */
        ix_mv_assert_same(ctx, &rng, m, b, 1e-11);
        ix_mv_assert_same(ctx, &rng, b, p, 1e-11);
        ix_mv_unref(ctx, p);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
    }
}

static void inserted_knots(void **state)
{
    (void)state;
    for (int k = 0; k < 150; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *b;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1), n = 4;
        double dom[2], add[4];

        ix_mv_domain(m, dir, dom);
        for (int i = 0; i < n; i++)
            add[i] = ix_rng_range(&rng, dom[0], dom[1]);
        add[1] = ix_mv_order(m, dir) > 1 ? add[0] : add[1]; /* twice */
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, m, dir, n, add, &b));
        ix_mv_assert_same(ctx, &rng, m, b, TOL);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
    }
}

static void raised(void **state)
{
    (void)state;
    for (int k = 0; k < 150; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *b;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        int order = ix_mv_order(m, dir) + ix_rng_int(&rng, 0, 5);

        ASSERT_OK(ctx, ix_mv_raise(ctx, m, dir, order, &b));
        assert_int_equal(ix_mv_order(b, dir), order);
        /* neighbouring spans differ by up to 15 in length, up to three
         * arguments of a blossom are extrapolated: 16^3 ulp */
        ix_mv_assert_same(ctx, &rng, m, b, 1e-12);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
    }
}

static void regions(void **state)
{
    (void)state;
    for (int k = 0; k < 200; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *b, *half[2];
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        double dom[2], t0, t1;

        ix_mv_domain(m, dir, dom);
        t0 = ix_rng_range(&rng, dom[0], dom[1]);
        t1 = ix_rng_range(&rng, dom[0], dom[1]);
        ASSERT_OK(ctx, ix_mv_region(ctx, m, dir, t0, t1, &b));
        if (ix_mv_dir(m, dir).basis == IX_BSPLINE) {
            double got[2];

            ix_mv_domain(b, dir, got);
            ASSERT_CLOSE(got[0], fmin(t0, t1), 1e-11);
            ASSERT_CLOSE(got[1], fmax(t0, t1), 1e-11);
            ix_mv_assert_same(ctx, &rng, b, m, TOL);
        }
        ASSERT_OK(ctx, ix_mv_split(ctx, m, dir, t0, half));
        if (ix_mv_dir(m, dir).basis == IX_BSPLINE) {
            ix_mv_assert_same(ctx, &rng, half[0], m, TOL);
            ix_mv_assert_same(ctx, &rng, half[1], m, TOL);
        }
        ix_mv_unref(ctx, half[0]);
        ix_mv_unref(ctx, half[1]);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinds_of_knots), cmocka_unit_test(power_basis),
        cmocka_unit_test(inserted_knots), cmocka_unit_test(raised),
        cmocka_unit_test(regions),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
