/* Derivatives and integrals: against each other, against evaluation, against
 * reference numbers, and what is refused. */
#include "sym_test.h"

/* Law: the axes of the derivative are the partials of the axes; the control
 * points stay in their basis. Tolerance: derivatives of size 1e3 at most. */
static void axes_are_partials(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(61);

    for (int round = 0; round < 60; round++) {
        ix_rand_opts s = {.max_order = 5, .max_knots = 4, .kinds = IX_RAND_ALL};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *d;
        int dir = ix_rng_int(&r, 0, ix_mv_ndirs(m) - 1);
        int k[3] = {0}, order = ix_mv_order(m, dir);

        k[dir] = 1;
        ASSERT_OK(w->ctx, ix_sym_derive_axes(w->ctx, m, dir, &d));
        assert_int_equal(ix_mv_order(d, dir), order > 1 ? order - 1 : 1);
        assert_int_equal(ix_mv_dir(d, dir).basis, ix_mv_dir(m, dir).basis);
        for (int i = 0; i < 5; i++) {
            double t[3], got[8], want[8];

            rand_param(&r, m, t);
            ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, d, t, got));
            ASSERT_OK(w->ctx, ix_mv_partial(w->ctx, m, t, k, want));
            for (int a = 0; a < ix_mv_naxes(m); a++)
                ASSERT_CLOSE(got[a], want[a], 1e-11);
        }
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, d);
    }
}

/* Law: the derivative of a rational curve is its Euclidean derivative; order
 * 2k - 1 (quotient rule), continuity one less. */
static void rational_curves(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(62);

    for (int round = 0; round < 40; round++) {
        ix_rand_opts s = {.ndirs = 1,
                          .ncoords = 3,
                          .rational = 1,
                          .kinds = IX_RAND_ALL,
                          .min_order = 2,
                          .max_order = 5};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *d;
        double t, got[3], want[6];

        ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, m, 0, NULL, &d));
        assert_int_equal(ix_mv_order(d, 0), 2 * ix_mv_order(m, 0) - 1);
        for (int i = 0; i < 5; i++) {
            rand_param(&r, d, &t);
            ASSERT_OK(w->ctx, ix_mv_point(w->ctx, d, &t, got));
            ASSERT_OK(w->ctx, ix_mv_curve_derivs(w->ctx, m, t, 1, want));
            for (int a = 0; a < 3; a++)
                ASSERT_CLOSE(got[a], want[3 + a], 1e-10);
        }
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, d);
    }
}

/* Law: the partials of a rational surface follow the quotient rule on its
 * homogeneous partials. */
static void rational_surfaces(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(63);

    for (int round = 0; round < 20; round++) {
        ix_rand_opts s = {.ndirs = 2,
                          .ncoords = 2,
                          .rational = 1,
                          .kinds = IX_RAND_BEZIER | IX_RAND_OPEN,
                          .max_order = 4,
                          .max_knots = 2};
        int dir = round & 1, k[2] = {!dir, dir};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *d;
        double t[2], x[3], dx[3], got[2];

        ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, m, dir, NULL, &d));
        rand_param(&r, m, t);
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, m, t, x));
        ASSERT_OK(w->ctx, ix_mv_partial(w->ctx, m, t, k, dx));
        ASSERT_OK(w->ctx, ix_mv_point(w->ctx, d, t, got));
        for (int a = 0; a < 2; a++)
            ASSERT_CLOSE(got[a],
                         (dx[a + 1] * x[0] - x[a + 1] * dx[0]) / (x[0] * x[0]),
                         1e-11);
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, d);
    }
}

static ix_mv *curve(ix_ctx *ctx, int order, int n, const double *kv,
                    const double *p)
{
    ix_dir d = {kv ? IX_BSPLINE : IX_BEZIER, order, n, false, kv};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 1, false, p, &m));
    return m;
}

static void check(ix_ctx *ctx, const ix_mv *m, int nk, const double *kv, int n,
                  const double *p)
{
    assert_int_equal(ix_mv_nknots(m, 0), nk);
    assert_int_equal(ix_mv_length(m, 0), n);
    for (int i = 0; i < nk; i++)
        ASSERT_CLOSE(ix_mv_dir(m, 0).knots[i], kv[i], 1e-14);
    for (int i = 0; i < n; i++)
        ASSERT_CLOSE(ix_mv_coord(m, 0)[i], p[i], 1e-14);
    ix_mv_unref(ctx, m);
}

/* The reference cases mv-derive-bspline and crv-derive-float; a jump stays a
 * jump; order 1 gives zeros of order 1 and the same length. */
static void reference_points(void **state)
{
    sym_world *w = *state;
    double k1[] = {0, 0, 0, 1, 4, 4, 4}, p1[] = {0, 1, 3, 2};
    double k2[] = {-1, -0.5, 0, 0.5, 1, 1.5, 2}, p2[] = {0, 1, 2, 0};
    double k3[] = {0, 0, 1, 1, 2, 2}, p3[] = {0, 1, 5, 7};
    double k4[] = {0, 1, 2}, p4[] = {3, 4};
    ix_mv *m, *d;

    m = curve(w->ctx, 3, 4, k1, p1);
    ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, m, 0, NULL, &d));
    check(w->ctx, d, 5, (double[]){0, 0, 1, 4, 4}, 3,
          (double[]){2, 1, -2.0 / 3});
    ix_mv_unref(w->ctx, m);
    m = curve(w->ctx, 3, 4, k2, p2);
    ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, m, 0, NULL, &d));
    check(w->ctx, d, 5, (double[]){-0.5, 0, 0.5, 1, 1.5}, 3,
          (double[]){2, 2, -4});
    ix_mv_unref(w->ctx, m);
    m = curve(w->ctx, 2, 4, k3, p3);
    ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, m, 0, NULL, &d));
    check(w->ctx, d, 3, (double[]){0, 1, 2}, 2, (double[]){1, 2});
    ix_mv_unref(w->ctx, m);
    m = curve(w->ctx, 1, 2, k4, p4);
    ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, m, 0, NULL, &d));
    check(w->ctx, d, 3, k4, 2, (double[]){0, 0});
    ix_mv_unref(w->ctx, m);
}

/* Law: d/dt of the integral is the function; the integral begins at 0. */
static void integrals_are_inverse(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(64);

    for (int round = 0; round < 60; round++) {
        ix_rand_opts s = {.rational = -1, .max_order = 4, .kinds = IX_RAND_ALL};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *q, *d;
        int dir = ix_rng_int(&r, 0, ix_mv_ndirs(m) - 1);
        double t[3], x[8], y[8], dom[2];

        ASSERT_OK(w->ctx, ix_sym_integrate(w->ctx, m, dir, &q));
        ASSERT_OK(w->ctx, ix_sym_derive(w->ctx, q, dir, NULL, &d));
        assert_int_equal(ix_mv_order(q, dir), ix_mv_order(m, dir) + 1);
        for (int i = 0; i < 4; i++) {
            rand_param(&r, m, t);
            ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, m, t, x));
            ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, d, t, y));
            for (int a = 0; a < ix_mv_ncoords(m); a++)
                ASSERT_CLOSE(y[a], x[a], 1e-11);
        }
        ix_mv_domain(m, dir, dom);
        t[dir] = dom[0];
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, q, t, y));
        for (int a = 0; a < ix_mv_ncoords(m); a++)
            ASSERT_CLOSE(y[a], 0, 1e-14);
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, q);
        ix_mv_unref(w->ctx, d);
    }
}

static void errors_are_told(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(65);
    ix_rand_opts s = {.ndirs = 1, .rational = 1};
    ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *out;

    assert_int_equal(ix_sym_derive(w->ctx, m, 1, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_derive_axes(w->ctx, m, -1, &out), IX_EARG);
    assert_int_equal(ix_sym_integrate(w->ctx, m, 1, &out), IX_EARG);
    assert_int_equal(ix_sym_integrate(w->ctx, m, 0, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(w->ctx, m);
}

typedef struct {
    int what;
    ix_mv *m, *out;
} operand;

static void make(ix_ctx *ctx, void *state)
{
    operand *o = state;
    ix_rng r = ix_rng_new(66);
    ix_rand_opts s = {.ndirs = 2,
                      .rational = o->what == 2 ? -1 : 1,
                      .kinds = IX_RAND_PERIODIC};

    o->m = ix_mv_randtest(ctx, &r, &s);
    o->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    operand *o = state;
    ix_status st = o->what == 0   ? ix_sym_derive(ctx, o->m, 1, NULL, &o->out)
                   : o->what == 1 ? ix_sym_derive_axes(ctx, o->m, 1, &o->out)
                                  : ix_sym_integrate(ctx, o->m, 1, &o->out);

    assert_true((st == IX_OK) == (o->out != NULL));
    return st;
}

static void release(ix_ctx *ctx, void *state)
{
    operand *o = state;

    ix_mv_unref(ctx, o->m);
    ix_mv_unref(ctx, o->out);
}

static void memory_may_fail(void **state)
{
    operand o;
    ix_fault_case c = {make, run, release, &o};

    (void)state;
    for (o.what = 0; o.what < 3; o.what++)
        assert_true(ix_fault_run(&c) > 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, world_open, world_close)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(axes_are_partials),           TEST(rational_curves),
        TEST(rational_surfaces),           TEST(reference_points),
        TEST(integrals_are_inverse),       TEST(errors_are_told),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
