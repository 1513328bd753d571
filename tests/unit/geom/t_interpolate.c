/* Interpolation against its definition (the data come back), least squares
 * against planted splines, parameters against their invariances. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

static void draw_points(ix_rng *r, int n, int axes, double *pts)
{
    for (int i = 0; i < n * axes; i++)
        pts[i] = ix_rng_range(r, -1, 1);
}

/* Law: every parametrisation and order gives a curve through the points. */
static void passes_through(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(21);
    double pts[3 * 30], tau[30], p[4];

    (void)state;
    for (int k = 0; k < 400; k++) {
        ix_interpolate_opts o = {.order = ix_rng_int(&r, 2, 6)};
        int n = ix_rng_int(&r, o.order, 30);
        double res;
        ix_mv *m;

        o.param = (ix_param)(k % 4);
        draw_points(&r, n, 3, pts);
        ASSERT_OK(ctx, ix_interpolate(ctx, n, 3, false, pts, &o, &res, &m));
        ASSERT_OK(ctx, ix_params(ctx, o.param, n, 3, pts, tau));
        for (int i = 0; i < n; i++) {
            ASSERT_OK(ctx, ix_mv_point(ctx, m, &tau[i], p));
            for (int c = 0; c < 3; c++) /* amplification 50 */
                ASSERT_CLOSE(p[c], pts[c * n + i], 1e-13);
        }
        assert_true(res < 1e-13);
        assert_int_equal(ix_mv_length(m, 0), n);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: the same for periodic curves of even order or odd count. */
static void periodic_passes_through(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(22);
    double pts[3 * 31], p[4];

    (void)state;
    for (int k = 0; k < 100; k++) {
        ix_interpolate_opts o = {.order = ix_rng_int(&r, 2, 6),
                                 .periodic = true};
        int n = ix_rng_int(&r, o.order, 30);
        ix_mv *m;

        if (o.order % 2 && n % 2 == 0)
            n++;
        draw_points(&r, n, 3, pts);
        ASSERT_OK(ctx, ix_interpolate(ctx, n, 2, true, pts, &o, NULL, &m));
        assert_true(ix_mv_dir(m, 0).periodic);
        for (int i = 0; i < n; i++) {
            double t = (double)i / n;

            ASSERT_OK(ctx, ix_mv_eval(ctx, m, &t, p));
            for (int c = 0; c < 3; c++) /* condition grows to 1e5 */
                ASSERT_CLOSE(p[c], pts[c * n + i], 1e-10);
        }
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: samples of a spline in its own space give it back, whatever m > n. */
static void least_squares_finds_planted(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(23);
    ix_rand_opts ro = {.ndirs = 1,
                       .ncoords = 2,
                       .rational = -1,
                       .kinds = IX_RAND_OPEN | IX_RAND_PERIODIC,
                       .min_order = 2,
                       .max_order = 5};

    (void)state;
    for (int k = 0; k < 100; k++) {
        ix_mv *want = ix_mv_randtest(ctx, &r, &ro), *m;
        ix_dir d = ix_mv_dir(want, 0);
        ix_interpolate_opts o = {.order = d.order,
                                 .size = d.length,
                                 .periodic = d.periodic,
                                 .knots = d.knots,
                                 .nknots = ix_knots_count(&d)};
        double tau[256], pts[512], dom[2], p[2], res;
        int n = 200;

        if (d.length < d.order) { /* periodic with few points */
            ix_mv_unref(ctx, want);
            continue;
        }
        ix_mv_domain(want, 0, dom);
        for (int i = 0; i < n; i++) {
            tau[i] = dom[0] + (dom[1] - dom[0]) * i / (n - 1);
            ASSERT_OK(ctx, ix_mv_point(ctx, want, &tau[i], p));
            pts[i] = p[0];
            pts[n + i] = p[1];
        }
        o.params = tau;
        o.nparams = n;
        ASSERT_OK(ctx, ix_interpolate(ctx, n, 2, false, pts, &o, &res, &m));
        assert_true(res < 1e-12);
        /* knots within a factor 1e2: condition of B-splines below 1e4 */
        assert_true(ix_mv_equal(want, m, 1e-9));
        ix_mv_unref(ctx, want);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Laws: scaling does not change parameters; chord and centripetal follow
 * rotations; the Nielson metric any affine map. */
static void parameters_are_invariant(void **state)
{
    static const double map[3][3] = {{2, 1, 0}, {-1, 0.5, 3}, {0, 1, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(24);
    double pts[36], img[36], a[12], b[12];

    (void)state;
    for (int k = 0; k < 50; k++) {
        draw_points(&r, 12, 3, pts);
        for (int i = 0; i < 12; i++)
            for (int c = 0; c < 3; c++)
                img[c * 12 + i] = 7 + map[c][0] * pts[i] +
                                  map[c][1] * pts[12 + i] +
                                  map[c][2] * pts[24 + i];
        ASSERT_OK(ctx, ix_params(ctx, IX_PARAM_NIELSON_FOLEY, 12, 3, pts, a));
        ASSERT_OK(ctx, ix_params(ctx, IX_PARAM_NIELSON_FOLEY, 12, 3, img, b));
        for (int i = 0; i < 12; i++)
            ASSERT_CLOSE(a[i], b[i], 1e-12);
        for (int i = 0; i < 36; i++)
            img[i] = 1e-5 * pts[i];
        for (int how = 0; how < 4; how++) {
            ASSERT_OK(ctx, ix_params(ctx, (ix_param)how, 12, 3, pts, a));
            ASSERT_OK(ctx, ix_params(ctx, (ix_param)how, 12, 3, img, b));
            for (int i = 0; i < 12; i++)
                ASSERT_CLOSE(a[i], b[i], 1e-12);
            for (int i = 1; i < 12; i++)
                assert_true(a[i] > a[i - 1]);
        }
    }
    ix_ctx_free(ctx);
}

/* On a straight line the rules have closed forms. */
static void parameters_on_a_line(void **state)
{
    const double x[4] = {0, 4, 5, 14}; /* steps 4, 1, 9 */
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double t[4], kv[7];

    (void)state;
    ASSERT_OK(ctx, ix_params(ctx, IX_PARAM_CENTRIPETAL, 4, 1, x, t));
    ASSERT_CLOSE(t[1], 1.0 / 3, 1e-15);
    ASSERT_CLOSE(t[2], 0.5, 1e-15);
    /* averages 1/6, 5/12, 3/4 mapped to [0, 1] */
    ASSERT_OK(ctx, ix_params_knots(ctx, 3, 4, 4, t, kv));
    ASSERT_CLOSE(kv[3], 3.0 / 7, 1e-15);
    ASSERT_OK(ctx, ix_params(ctx, IX_PARAM_CHORD, 4, 1, x, t));
    ASSERT_CLOSE(t[1], 4.0 / 14, 1e-15);
    ASSERT_OK(ctx, ix_params(ctx, IX_PARAM_NIELSON_FOLEY, 4, 1, x, t));
    ASSERT_CLOSE(t[2], 5.0 / 14, 1e-14); /* no angles */
    ix_ctx_free(ctx);
}

/* The mapped averages would leave a control point without data here; the
 * second rule takes over. */
static void uneven_parameters_still_solve(void **state)
{
    const double x[7] = {0, 9, 9.2, 9.4, 9.6, 9.8, 10};
    const ix_interpolate_opts o = {.order = 4, .param = IX_PARAM_CHORD};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_interpolate(ctx, 7, 1, false, x, &o, NULL, &m));
    for (int i = 0; i < 7; i++) { /* chord length on a line: identity */
        double t = x[i] / 10, p;

        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, &p));
        ASSERT_CLOSE(p, x[i], 1e-12);
    }
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Law: cubic interpolation of many smooth data is as good as theory has it,
 * O(h^4), and rounding adds nothing: the system stays well conditioned. */
static void many_points(void **state)
{
    enum { N = 10000 };
    const ix_interpolate_opts o = {.order = 4};
    static double x[N];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double h = 60.0 / (N - 1);
    ix_mv *m;

    (void)state;
    for (int i = 0; i < N; i++)
        x[i] = sin(h * i);
    ASSERT_OK(ctx, ix_interpolate(ctx, N, 1, false, x, &o, NULL, &m));
    for (int i = 0; i < 1000; i++) {
        double t = (i + 0.5) / 1000, p;

        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, &p));
        assert_true(fabs(p - sin(60 * t)) < 0.1 * h * h * h * h + 1e-13);
    }
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Laws: a curve inside the spline space is its own best fit; otherwise the
 * error is what dense sampling finds and ends are kept. */
static void fits_curves(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(25);
    ix_rand_opts ro = {.ndirs = 1, .ncoords = 3, .kinds = IX_RAND_OPEN};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *c = ix_mv_randtest(ctx, &r, &ro), *m;
        ix_interpolate_opts o = {.order = 4, .size = 12};
        double err, dom[2], p[3], q[3];

        ASSERT_OK(ctx, ix_fit_curve(ctx, c, &o, &err, &m));
        ix_mv_domain(c, 0, dom);
        for (int i = 0; i <= 50; i++) {
            double t = dom[0] + (dom[1] - dom[0]) * i / 50, d = 0;

            ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, p));
            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, q));
            for (int a = 0; a < 3; a++)
                d = hypot(d, p[a] - q[a]);
            /* sampling misses a little between the places */
            assert_true(d <= 1.05 * err + 1e-12);
            assert_true(d < 1e-12 || (i != 0 && i != 50));
        }
        ix_mv_unref(ctx, m);
        if (!ix_mv_rational(c)) {
            ix_dir d = ix_mv_dir(c, 0);

            o = (ix_interpolate_opts){.order = d.order,
                                      .size = d.length,
                                      .knots = d.knots,
                                      .nknots = ix_knots_count(&d)};
            ASSERT_OK(ctx, ix_fit_curve(ctx, c, &o, &err, &m));
            assert_true(err < 1e-11);
            assert_true(ix_mv_equal(c, m, 1e-9));
            ix_mv_unref(ctx, m);
        }
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Law: at the samples' parameters the fitted curves are near their formula. */
static void windings(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double p[3], worst = 0;
    ix_mv *h, *s;

    (void)state;
    ASSERT_OK(ctx, ix_helix(ctx, 2, 3, 1.5, 400, 16, &h));
    ASSERT_OK(ctx, ix_spiral(ctx, 2, 0.5, 400, 16, &s));
    assert_int_equal(ix_mv_length(h, 0), 36);
    for (int i = 0; i <= 100; i++) {
        double t = i / 100.0, a = 4 * acos(-1) * t, q;

        ASSERT_OK(ctx, ix_mv_point(ctx, h, &t, p));
        ASSERT_CLOSE(p[2], 6 * t, 1e-12); /* one pitch per turn */
        worst = fmax(worst, hypot(p[0] - 1.5 * cos(a), p[1] - 1.5 * sin(a)));
        ASSERT_OK(ctx, ix_mv_point(ctx, s, &t, p));
        q = 0.5 / (6 * acos(-1)) * a;
        worst = fmax(worst, hypot(p[0] - q * cos(a), p[1] - q * sin(a)));
    }
    /* cubic, 0.38 radians a span: h^4 / 384 * 1.5, and more at the ends */
    assert_true(worst < 1e-3);
    ix_mv_unref(ctx, h);
    ix_mv_unref(ctx, s);
    ASSERT_OK(ctx, ix_helix(ctx, 1, 1, -2, 100, 20, &h));
    worst = 1;
    ASSERT_OK(ctx, ix_mv_point(ctx, h, &worst, p));
    assert_true(fabs(p[0] - 2) < 1e-3);
    worst = 0;
    ASSERT_OK(ctx, ix_mv_point(ctx, h, &worst, p));
    assert_true(fabs(p[0]) < 1e-3);
    ix_mv_unref(ctx, h);
    ASSERT_OK(ctx, ix_sine(ctx, 3, 300, 12, &s));
    worst = 0.25;
    ASSERT_OK(ctx, ix_mv_point(ctx, s, &worst, p));
    assert_true(fabs(p[1] - sin(p[0])) < 5e-3);
    ix_mv_unref(ctx, s);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    const double x[6] = {0, 1, 2, 3, 4, 5}, same[3] = {1, 1, 1};
    const double kv[5] = {0, 0, 1, 1, 1}, down[6] = {0, 2, 1, 3, 4, 5};
    const double bad[3] = {0, (double)NAN, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_interpolate_opts o = {.order = 4};
    double t[3], kvs[8], err;
    ix_mv *m, *c;

    (void)state;
    assert_int_equal(ix_interpolate(ctx, 3, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    assert_null(m);
    assert_int_equal(ix_interpolate(ctx, 0, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    o.order = 2;
    assert_int_equal(ix_interpolate(ctx, 3, 1, false, bad, &o, NULL, &m),
                     IX_EARG);
    o.size = 7;
    assert_int_equal(ix_interpolate(ctx, 6, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    o = (ix_interpolate_opts){.order = 2, .knots = kv, .nknots = 5};
    assert_int_equal(ix_interpolate(ctx, 6, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    o = (ix_interpolate_opts){.order = 2, .params = x, .nparams = 5};
    assert_int_equal(ix_interpolate(ctx, 6, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    o.nparams = 6; /* the automatic knots have domain [0, 1] */
    assert_int_equal(ix_interpolate(ctx, 6, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    o = (ix_interpolate_opts){.order = 3, .periodic = true};
    assert_int_equal(ix_interpolate(ctx, 6, 1, false, x, &o, NULL, &m),
                     IX_EDOMAIN);
    o = (ix_interpolate_opts){.order = 2, .param = IX_PARAM_CHORD};
    assert_int_equal(ix_interpolate(ctx, 3, 1, false, same, &o, NULL, &m),
                     IX_EDOMAIN);
    assert_int_equal(ix_params(ctx, IX_PARAM_UNIFORM, 1, 1, x, t), IX_EARG);
    assert_int_equal(ix_params_knots(ctx, 3, 2, 3, x, kvs), IX_EARG);
    o = (ix_interpolate_opts){.order = 2, .params = down, .nparams = 6};
    assert_int_equal(ix_interpolate(ctx, 6, 1, false, x, &o, NULL, &m),
                     IX_EARG);
    assert_int_equal(ix_helix(ctx, 0, 1, 1, 100, 8, &m), IX_EARG);
    assert_int_equal(ix_helix(ctx, 2, 1, 1, 10, 8, &m), IX_EARG);
    assert_int_equal(ix_sine(ctx, 1, 2000000, 8, &m), IX_EARG);
    o = (ix_interpolate_opts){.order = 9};
    ASSERT_OK(ctx, ix_sine(ctx, 1, 100, 1, &c));
    assert_int_equal(ix_fit_curve(ctx, c, &o, &err, &m), IX_EARG);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    static const double pts[12] = {0, 1, 2, 3, 4, 7, 0, 1, 0, 1, 0, 2};
    const ix_interpolate_opts o = {.order = 3, .param = IX_PARAM_NIELSON_FOLEY};
    const ix_interpolate_opts fit = {.order = 3, .size = 4};
    ix_mv **m = state;
    double err;
    ix_status st;

    m[1] = NULL;
    st = ix_interpolate(ctx, 6, 2, false, pts, &o, NULL, &m[0]);
    if (st == IX_OK)
        st = ix_fit_curve(ctx, m[0], &fit, &err, &m[1]);
    return st;
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
}

static void out_of_memory(void **state)
{
    ix_mv *m[2];
    const ix_fault_case c = {NULL, run, drop, m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_through),
        cmocka_unit_test(periodic_passes_through),
        cmocka_unit_test(least_squares_finds_planted),
        cmocka_unit_test(parameters_are_invariant),
        cmocka_unit_test(parameters_on_a_line),
        cmocka_unit_test(uneven_parameters_still_solve),
        cmocka_unit_test(many_points),
        cmocka_unit_test(fits_curves),
        cmocka_unit_test(windings),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
