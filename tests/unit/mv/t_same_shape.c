/* Operations that change the representation only: to_bspline, to_float,
 * to_open, power basis, knots inserted, orders raised, regions, splits. */
#include "harness/fault.h"
#include "harness/randmv.h"

/* Rounding of a few convex combinations of order up to 6. */
#define TOL 2e-14

IX_TEST_FIXTURE(7)

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

/* The representations that scripts expect (spec/model 12). */
static void region_of_a_circle(void **state)
{
    const double s = sqrt(0.5), q = (2 + sqrt(2)) / 4, x = (1 + sqrt(2)) / 4;
    const double knots[] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    const double pts[] = {1, s, 1, s,  1,  s,  1,  s,  1, /* weights */
                          1, s, 0, -s, -1, -s, 0,  s,  1, /* x */
                          0, s, 1, s,  0,  -s, -1, -s, 0};
    const double part[] = {q,        q,  1, q, q, x, x - 0.25, 0,
                           0.25 - x, -x, x, q, 1, q, x};
    const double kv[] = {0.5, 0.5, 0.5, 1, 1, 1.5, 1.5, 1.5};
    const ix_dir dir = {IX_BSPLINE, 3, 9, false, knots};
    ix_mv *m, *r;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, true, pts, &m));
    ASSERT_OK(ctx, ix_mv_region(ctx, m, 0, 1.5, 0.5, &r));
    assert_int_equal(ix_mv_npts(r), 5);
    for (int i = 0; i < 8; i++)
        assert_true(ix_mv_dir(r, 0).knots[i] == kv[i]);
    for (int i = 0; i < 15; i++)
        ASSERT_CLOSE(ix_mv_axis(r, 0)[i], part[i], 1e-15);
    ix_mv_unref(ctx, r);
    ix_mv_unref(ctx, m);
}

/* At a jump each side keeps its own limit; near a knot means at it. */
static void split_at_a_jump(void **state)
{
    const double knots[] = {0, 0, 1, 1, 2, 2}, pts[] = {0, 1, 5, 6};
    const ix_dir dir = {IX_BSPLINE, 2, 4, false, knots};
    ix_mv *m, *half[2];

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    ASSERT_OK(ctx, ix_mv_split(ctx, m, 0, 1 + 1e-13, half));
    for (int k = 0; k < 2; k++) {
        assert_int_equal(ix_mv_npts(half[k]), 2);
        assert_memory_equal(ix_mv_axis(half[k], 0), pts + 2 * k, 16);
        ix_mv_unref(ctx, half[k]);
    }
    ix_mv_unref(ctx, m);
}

/* Law: a Bezier region extrapolates: its value at u is m's at t0 + u (t1-t0),
 * whatever the interval. */
static void bezier_regions(void **state)
{
    static const double at[][2] = {{1, 2}, {-1, 0},  {-1, 1},    {0, 2},
                                   {2, 3}, {-3, -2}, {0.25, 0.5}};
    ix_rand_opts o = {.ndirs = 2, .kinds = IX_RAND_BEZIER, .max_order = 4};

    (void)state;
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;
        double t[2], u[2], v[5], w[5];

        ASSERT_OK(ctx, ix_mv_region(ctx, m, 1, at[k][0], at[k][1], &r));
        assert_int_equal(ix_mv_dir(r, 1).basis, IX_BEZIER);
        t[0] = u[0] = ix_rng_unit(&rng);
        u[1] = ix_rng_unit(&rng);
        t[1] = at[k][0] + u[1] * (at[k][1] - at[k][0]);
        ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, v));
        ASSERT_OK(ctx, ix_mv_eval(ctx, r, u, w));
        for (int a = 0; a < ix_mv_naxes(m); a++) /* values grow like 3^3 */
            ASSERT_CLOSE(v[a], w[a], 1e-13);
        ix_mv_unref(ctx, r);
        ix_mv_unref(ctx, m);
    }
}

/* Law: points that need not change are copied, and planes stay planes. */
static void insertion_is_local(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .kinds = IX_RAND_OPEN,
                      .min_order = 4,
                      .max_order = 4,
                      .ncoords = 1,
                      .rational = -1};

    (void)state;
    for (int k = 0; k < 30; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;
        int n = ix_mv_length(m, 0), same = 0;
        double dom[2], t;

        ix_mv_domain(m, 0, dom);
        t = ix_rng_range(&rng, dom[0], dom[1]);
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, m, 0, 1, &t, &r));
        for (int i = 0; i <= n; i++) {
            double x = ix_mv_axis(r, 0)[i];

            same += (i < n && x == ix_mv_axis(m, 0)[i]) ||
                    (i > 0 && x == ix_mv_axis(m, 0)[i - 1]);
        }
        assert_true(same >= n - 2); /* order - 1 new points */
        ix_mv_unref(ctx, r);
        ix_mv_unref(ctx, m);
    }
}

/* Orders up to 400: convex combinations, so rounding stays near d ulp. */
static void high_orders(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 1,
                      .rational = -1,
                      .min_order = 100,
                      .max_order = 200,
                      .max_knots = 2,
                      .kinds = IX_RAND_BEZIER};

    (void)state;
    for (int k = 0; k < 4; k++) {
        ix_mv *m, *r, *half[2];
        double t;

        o.kinds = k % 2 ? IX_RAND_OPEN | IX_RAND_JUMPS : IX_RAND_BEZIER;
        m = ix_mv_randtest(ctx, &rng, &o);
        if (k % 2 == 0) {
            ASSERT_OK(ctx, ix_mv_raise(ctx, m, 0, 400, &r));
            ix_mv_assert_same(ctx, &rng, m, r, 1e-13);
            ix_mv_unref(ctx, r);
        }
        ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &r));
        t = 0.4 * ix_mv_dir(r, 0).knots[0] +
            0.6 * ix_mv_dir(r, 0).knots[ix_mv_nknots(r, 0) - 1];
        ASSERT_OK(ctx, ix_mv_split(ctx, r, 0, t, half));
        ix_mv_assert_same(ctx, &rng, half[0], m, 1e-13);
        ix_mv_assert_same(ctx, &rng, half[1], m, 1e-13);
        ix_mv_unref(ctx, half[0]);
        ix_mv_unref(ctx, half[1]);
        ix_mv_unref(ctx, r);
        ix_mv_unref(ctx, m);
    }
}

/* A cubic with simple knots raised to order 400: high degree, low continuity,
 * as products have it. */
static void raised_to_400(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 1,
                      .rational = -1,
                      .min_order = 4,
                      .max_order = 4,
                      .max_knots = 1,
                      .kinds = IX_RAND_OPEN};
    ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;

    (void)state;
    ASSERT_OK(ctx, ix_mv_raise(ctx, m, 0, 400, &r));
    ix_mv_assert_same(ctx, &rng, m, r, 1e-12);
    ix_mv_unref(ctx, r);
    ix_mv_unref(ctx, m);
}

/* High order and simple knots: raised by convex steps, to a few ulp; and the
 * two ways agree where both are good. */
static void raised_smooth(void **state)
{
    (void)state;
    for (int order = 8; order <= 32; order += 8) {
        ix_rand_opts o = {.ndirs = 1,
                          .rational = -1,
                          .min_order = order,
                          .max_order = order,
                          .max_knots = 30,
                          .kinds = IX_RAND_OPEN | IX_RAND_FLOAT};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;

        ASSERT_OK(ctx, ix_mv_raise(ctx, m, 0, order + 2, &r));
        ix_mv_assert_same(ctx, &rng, m, r, 1e-13);
        ix_mv_unref(ctx, r);
        ix_mv_unref(ctx, m);
    }
}

/* Six directions, all operations at once. */
static void six_directions(void **state)
{
    ix_rand_opts o = {.ndirs = 6, .max_order = 3, .max_knots = 1};

    (void)state;
    for (int k = 0; k < 6; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *a, *b, *c;
        double dom[2];

        ix_mv_domain(m, k, dom);
        ASSERT_OK(ctx, ix_mv_raise(ctx, m, k, 4, &a));
        ASSERT_OK(ctx, ix_mv_reparam(ctx, a, k, dom[0], dom[1], &b));
        ASSERT_OK(ctx, ix_mv_to_open(ctx, b, &c));
        ix_mv_assert_same(ctx, &rng, m, c, 1e-12);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, m);
    }
}

static void errors(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .kinds = IX_RAND_OPEN,
                      .min_order = 3,
                      .max_order = 3,
                      .unit = true};
    ix_rand_opts p = {.ndirs = 1, .kinds = IX_RAND_POWER};
    ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r, *half[2];
    ix_mv *pow = ix_mv_randtest(ctx, &rng, &p);
    const double out = 1.5, many[] = {0.5, 0.5, 0.5, 0.5};

    (void)state;
    assert_int_equal(ix_mv_power_to_bezier(ctx, m, &r), IX_EARG);
    assert_int_equal(ix_mv_bezier_to_power(ctx, m, &r), IX_EARG);
    assert_int_equal(ix_mv_insert_knots(ctx, m, 0, 1, &out, &r), IX_EARG);
    assert_int_equal(ix_mv_insert_knots(ctx, m, 0, 4, many, &r), IX_EARG);
    assert_int_equal(ix_mv_insert_knots(ctx, m, 0, -1, many, &r), IX_EARG);
    assert_int_equal(ix_mv_insert_knots(ctx, m, 1, 1, many, &r), IX_EARG);
    assert_int_equal(ix_mv_set_knots(ctx, m, 0, 2, many, &r), IX_EARG);
    assert_int_equal(ix_mv_raise(ctx, m, 0, 2, &r), IX_EARG);
    assert_int_equal(ix_mv_raise(ctx, m, 0, 1025, &r), IX_EARG);
    assert_int_equal(ix_mv_raise(ctx, pow, 0, 9, &r), IX_EARG);
    assert_int_equal(ix_mv_reduce(ctx, m, 0, 3, NULL, &r), IX_EARG);
    assert_int_equal(ix_mv_reduce(ctx, m, 0, 0, NULL, &r), IX_EARG);
    assert_int_equal(ix_mv_remove_knots(ctx, m, 0, -1, &r), IX_EARG);
    assert_int_equal(ix_mv_region(ctx, m, 0, 0.2, 1.1, &r), IX_EDOMAIN);
    assert_int_equal(ix_mv_region(ctx, m, 0, 0.2, 0.2, &r), IX_EDOMAIN);
    assert_int_equal(ix_mv_region(ctx, m, 0, (double)NAN, 0.2, &r), IX_EDOMAIN);
    assert_int_equal(ix_mv_region(ctx, pow, 0, 0, 0.2, &r), IX_EARG);
    assert_int_equal(ix_mv_split(ctx, m, 0, 1, half), IX_EDOMAIN);
    assert_int_equal(ix_mv_reparam(ctx, m, 0, 1, 1, &r), IX_EARG);
    assert_null(r);
    ix_mv_unref(ctx, pow);
    ix_mv_unref(ctx, m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinds_of_knots),
        cmocka_unit_test(power_basis),
        cmocka_unit_test(inserted_knots),
        cmocka_unit_test(raised),
        cmocka_unit_test(regions),
        cmocka_unit_test(region_of_a_circle),
        cmocka_unit_test(split_at_a_jump),
        cmocka_unit_test(bezier_regions),
        cmocka_unit_test(insertion_is_local),
        cmocka_unit_test(high_orders),
        cmocka_unit_test(raised_to_400),
        cmocka_unit_test(raised_smooth),
        cmocka_unit_test(six_directions),
        cmocka_unit_test(errors),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
