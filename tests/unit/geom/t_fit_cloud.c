/* Points from a known curve, in random order, are found again. */
#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/geom.h"

enum { N = 200 };

/* An ellipse-like closed curve, or an arch; shuffled by a random parameter. */
static void draw(ix_rng *r, bool periodic, double noise, double *pts)
{
    for (int i = 0; i < N; i++) {
        double a = ix_rng_range(r, 0, periodic ? 6.283185307179586 : 2.5);

        pts[i] = 3 * cos(a) + noise * ix_rng_range(r, -1, 1);
        pts[N + i] = 2 * sin(a) + (periodic ? 0.3 * cos(2 * a) : 0) +
                     noise * ix_rng_range(r, -1, 1);
    }
}

/* Law: without noise the error becomes what the spline space can do; the
 * squared distance needs fewer rounds. */
static void finds_the_curve(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double pts[2 * N], err[2];

    (void)state;
    for (int periodic = 0; periodic < 2; periodic++) {
        ix_rng r = ix_rng_new(81);
        ix_mv *init, *m;

        draw(&r, periodic, 0, pts);
        ASSERT_OK(ctx,
                  ix_fit_cloud_start(ctx, N, 2, pts, 12, 4, periodic, &init));
        for (int how = 1; how <= 2; how++) {
            const ix_cloud_opts o = {
                .how = (ix_cloud_how)how, .max_iter = 12, .lambda = 1e-9};

            ASSERT_OK(
                ctx, ix_fit_cloud(ctx, N, 2, pts, init, &o, &err[how - 1], &m));
            assert_int_equal(ix_mv_length(m, 0), 12);
            assert_true(ix_mv_dir(m, 0).periodic == periodic);
            ix_mv_unref(ctx, m);
        }
        /* size 3, 12 cubic spans: (2 pi / 12)^4 / 384 * 3 is 6e-4 */
        assert_true(err[0] < 5e-3);
        assert_true(err[1] < 6e-4);
        ix_mv_unref(ctx, init);
    }
    ix_ctx_free(ctx);
}

/* Law: with noise the error is that of the noise, not less than a fit with so
 * many unknowns can make it, not more. */
static void averages_noise(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(82);
    const ix_cloud_opts o = {
        .how = IX_CLOUD_SQUARED, .max_iter = 20, .lambda = 1e-8};
    double pts[2 * N], err;
    ix_mv *init, *m;

    (void)state;
    draw(&r, true, 0.1, pts);
    ASSERT_OK(ctx, ix_fit_cloud_start(ctx, N, 2, pts, 8, 4, true, &init));
    ASSERT_OK(ctx, ix_fit_cloud(ctx, N, 2, pts, init, &o, &err, &m));
    /* uniform noise of +-0.1 across the curve: 0.1 / sqrt 3 = 0.058 */
    assert_true(err > 0.04 && err < 0.07);
    ix_mv_unref(ctx, init);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Points in space, and a first curve that is given. */
static void in_space(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(83);
    const ix_cloud_opts o = {
        .how = IX_CLOUD_SQUARED, .max_iter = 15, .lambda = 1e-10};
    double pts[3 * N], err;
    ix_mv *init, *m;

    (void)state;
    for (int i = 0; i < N; i++) {
        double a = ix_rng_range(&r, 0, 3);

        pts[i] = cos(a);
        pts[N + i] = sin(a);
        pts[2 * N + i] = a;
    }
    ASSERT_OK(ctx,
              ix_hermite(ctx, (double[]){1, 0, 0}, (double[]){-1, 0, 3},
                         (double[]){0, 1, 3}, (double[]){0, -1, 3}, &init));
    ASSERT_OK(ctx, ix_fit_cloud(ctx, N, 3, pts, init, &o, &err, &m));
    assert_true(err < 0.03); /* one cubic over 3 radians */
    ix_mv_unref(ctx, init);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_cloud_opts o = {.how = IX_CLOUD_POINT, .max_iter = 3};
    const double pts[4] = {0, 1, 0, 1};
    ix_mv *circle, *line, *m;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){0, 0, 0}, 1, &circle));
    assert_int_equal(ix_fit_cloud(ctx, 2, 3, pts, circle, &o, NULL, &m),
                     IX_EARG);
    ix_mv_unref(ctx, circle);
    assert_int_equal(ix_fit_cloud_start(ctx, 1, 2, pts, 4, 3, false, &m),
                     IX_EARG);
    assert_int_equal(ix_fit_cloud_start(ctx, 2, 2, pts, 2, 3, false, &m),
                     IX_EARG);
    ASSERT_OK(ctx, ix_fit_cloud_start(ctx, 2, 2, pts, 4, 4, false, &line));
    assert_int_equal(ix_fit_cloud(ctx, 2, 2, pts, line, &o, NULL, &m),
                     IX_EDOMAIN); /* two points, four unknowns */
    o.max_iter = 0;
    assert_int_equal(ix_fit_cloud(ctx, 2, 2, pts, line, &o, NULL, &m), IX_EARG);
    ix_mv_unref(ctx, line);
    ix_ctx_free(ctx);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    static const double pts[12] = {1, 0, -1, 0, .7, -.7, 0, 1, 0, -1, .7, -.7};
    const ix_cloud_opts o = {
        .how = IX_CLOUD_SQUARED, .max_iter = 2, .lambda = 1e-3};
    ix_mv **m = state;
    ix_status st = ix_fit_cloud_start(ctx, 6, 2, pts, 5, 3, true, &m[0]);

    m[1] = NULL;
    if (st == IX_OK)
        st = ix_fit_cloud(ctx, 6, 2, pts, m[0], &o, NULL, &m[1]);
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
    assert_true(ix_fault_run(&c) >= 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_the_curve), cmocka_unit_test(averages_noise),
        cmocka_unit_test(in_space),        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
