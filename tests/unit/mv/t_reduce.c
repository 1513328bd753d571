/* Lower orders and fewer knots: exact where they can be, within the stated
 * bound elsewhere. */
#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(11)

/* Law: reducing what was raised gives the former back, and says so. */
static void reduce_undoes_raise(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_BEZIER | IX_RAND_OPEN,
                      .min_order = 2,
                      .max_order = 5,
                      .max_knots = 4};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *up, *down;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        int order = ix_mv_order(m, dir);
        double err;

        ASSERT_OK(
            ctx, ix_mv_raise(ctx, m, dir, order + ix_rng_int(&rng, 1, 3), &up));
        ASSERT_OK(ctx, ix_mv_reduce(ctx, up, dir, order, &err, &down));
        /* raising loses up to 16^2 ulp between spans of unlike length */
        assert_true(err < 1e-11);
        assert_true(ix_mv_equal(m, down, 1e-11));
        ix_mv_unref(ctx, down);
        ix_mv_unref(ctx, up);
        ix_mv_unref(ctx, m);
    }
}

static void assert_within(const ix_mv *a, const ix_mv *b, double err)
{
    for (int i = 0; i < 20; i++) {
        double t[IX_MAX_DIRS], va[IX_MAX_COORDS], vb[IX_MAX_COORDS];

        ix_mv_randparam(&rng, a, t);
        ASSERT_OK(ctx, ix_mv_point(ctx, a, t, va));
        ASSERT_OK(ctx, ix_mv_point(ctx, b, t, vb));
        for (int c = 0; c < ix_mv_ncoords(a); c++)
            assert_true(fabs(va[c] - vb[c]) <= err + 1e-12);
    }
}

/* Law: the change is within the bound; end points of curves stay. */
static void reduce_keeps_its_bound(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_BEZIER | IX_RAND_BSPLINES,
                      .min_order = 2,
                      .max_order = 7,
                      .max_knots = 4};

    (void)state;
    for (int k = 0; k < 100; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *down;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        int order = ix_rng_int(&rng, 1, ix_mv_order(m, dir) - 1);
        double err;

        ASSERT_OK(ctx, ix_mv_reduce(ctx, m, dir, order, &err, &down));
        assert_int_equal(ix_mv_order(down, dir), order);
        assert_within(m, down, err);
        ix_mv_unref(ctx, down);
        ix_mv_unref(ctx, m);
    }
}

/* Law: knots that were inserted can go again. */
static void removes_what_was_inserted(void **state)
{
    ix_rand_opts o = {
        .kinds = IX_RAND_BEZIER | IX_RAND_OPEN, .max_knots = 4, .max_order = 5};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *b, *more, *less;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        double dom[2], add[3];

        ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
        ix_mv_domain(m, dir, dom);
        for (int i = 0; i < 3; i++)
            add[i] = dom[0] +
                     (dom[1] - dom[0]) * (i + ix_rng_range(&rng, .2, .8)) / 3;
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, m, dir, 3, add, &more));
        ASSERT_OK(ctx, ix_mv_remove_knots(ctx, more, dir, 0, &less));
        assert_true(ix_mv_equal(b, less, 1e-11));
        ix_mv_unref(ctx, less);
        ix_mv_unref(ctx, more);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
    }
}

static void removal_keeps_its_bound(void **state)
{
    ix_rand_opts o = {.ndirs = 1, .max_knots = 30, .kinds = IX_RAND_BSPLINES};
    int gone = 0;

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *less;
        double tol = ix_rng_range(&rng, 0, 0.5);

        ASSERT_OK(ctx, ix_mv_remove_knots(ctx, m, 0, tol, &less));
        gone += ix_mv_length(m, 0) - ix_mv_length(less, 0);
        assert_within(m, less, tol);
        ix_mv_unref(ctx, less);
        ix_mv_unref(ctx, m);
    }
    assert_true(gone > 40);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reduce_undoes_raise),
        cmocka_unit_test(reduce_keeps_its_bound),
        cmocka_unit_test(removes_what_was_inserted),
        cmocka_unit_test(removal_keeps_its_bound),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
