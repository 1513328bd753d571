/* t_srf_fit.c - surfaces through curves, grids, surfaces, scattered points. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* Law: the curves are met at the parameters that were chosen, and these are
 * found again from the surface: S(., tau_k) = c_k. */
static void test_skin(void **state)
{
    static const ix_kv_kind kinds[3] = {IX_KV_OPEN, IX_KV_FLOAT,
                                        IX_KV_PERIODIC};
    static const ix_param how[4] = {IX_PARAM_UNIFORM, IX_PARAM_CENTRIPETAL,
                                    IX_PARAM_CHORD, IX_PARAM_NIELSON_FOLEY};
    gt t = gt_begin(101);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        int n = 3 + 2 * ix_rng_int(&t.r, 0, 2), order = ix_rng_int(&t.r, 2, 3);
        ix_kv_kind kv = kinds[k % 3];
        ix_mv *c[7], *s = NULL;
        double uv[2], p[IX_MAX_COORDS], q[IX_MAX_COORDS];

        for (int i = 0; i < n; i++)
            c[i] = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER | IX_RAND_OPEN, 2);
        ASSERT_OK(t.ctx,
                  ix_srf_skin(t.ctx, n, (const ix_mv *const *)c, order, kv,
                              k % 3 ? IX_PARAM_UNIFORM : how[k % 4], &s));
        for (int i = 0; i < n; i++) {
            if (kv == IX_KV_OPEN && k % 4 && i > 0 && i < n - 1)
                continue; /* parameters inside are not known here */
            uv[0] = gt_param(&t, s, 0);
            uv[1] = kv == IX_KV_PERIODIC ? (double)i / n : (double)i / (n - 1);
            gt_point(&t, s, uv, p);
            uv[0] = gt_map(s, 0, c[i], uv[0]);
            gt_point(&t, c[i], uv, q);
            gt_same(p, q, 3, 1e-9);
        }
        for (int i = 0; i < n; i++)
            ix_mv_unref(t.ctx, c[i]);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* A polynomial of degree (2, 1) in (u, v) with three coordinates. */
static void poly21(double u, double v, double out[3])
{
    out[0] = 1 + u - 2 * u * u + v * u;
    out[1] = 3 * v - u * v + u * u * v;
    out[2] = u - v;
}

/* Laws: interpolation meets the grid; least squares reproduces polynomials of
 * the spline's degree. */
static void test_grid(void **state)
{
    const int count[2] = {7, 5}, exact[2] = {0, 0}, fewer[2] = {4, 3};
    gt t = gt_begin(102);
    double pts[3][35], p[IX_MAX_COORDS], q[3], uv[2];
    ix_mv *s = NULL;

    (void)state;
    for (int i = 0; i < 105; i++)
        pts[i / 35][i % 35] = ix_rng_range(&t.r, -1, 1);
    ASSERT_OK(t.ctx, ix_srf_fit_grid(t.ctx, count, 3, false, pts[0],
                                     (int[2]){4, 3}, exact, &s));
    for (int k = 0; k < 35; k++) {
        uv[0] = k % 7 / 6.0;
        uv[1] = k / 7 / 4.0;
        gt_point(&t, s, uv, p);
        for (int c = 0; c < 3; c++)
            ASSERT_CLOSE(p[c], pts[c][k], 1e-12);
    }
    ix_mv_unref(t.ctx, s);
    for (int k = 0; k < 35; k++) {
        poly21(k % 7 / 6.0, k / 7 / 4.0, q);
        for (int c = 0; c < 3; c++)
            pts[c][k] = q[c];
    }
    ASSERT_OK(t.ctx, ix_srf_fit_grid(t.ctx, count, 3, false, pts[0],
                                     (int[2]){3, 2}, fewer, &s));
    assert_int_equal(ix_mv_length(s, 0), 4);
    for (int k = 0; k < ROUNDS; k++) {
        uv[0] = ix_rng_unit(&t.r);
        uv[1] = ix_rng_unit(&t.r);
        gt_point(&t, s, uv, p);
        poly21(uv[0], uv[1], q);
        gt_same(p, q, 3, 1e-12);
    }
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

/* Laws: scattered points on a polynomial give the polynomial; a surface in
 * the space gives itself with error 0, another one a positive error. */
static void test_points_surface(void **state)
{
    enum { N = 60 };
    gt t = gt_begin(103);
    double uv[2][N], val[3][N], p[IX_MAX_COORDS], q[3], at[2], err;
    ix_mv *s = NULL, *f = NULL;

    (void)state;
    for (int i = 0; i < N; i++) {
        uv[0][i] = ix_rng_unit(&t.r);
        uv[1][i] = ix_rng_unit(&t.r);
        poly21(uv[0][i], uv[1][i], q);
        for (int c = 0; c < 3; c++)
            val[c][i] = q[c];
    }
    ASSERT_OK(t.ctx, ix_srf_fit_points(t.ctx, N, uv[0], 3, val[0],
                                       (int[2]){3, 2}, (int[2]){4, 3}, &s));
    for (int k = 0; k < ROUNDS; k++) {
        at[0] = ix_rng_unit(&t.r);
        at[1] = ix_rng_unit(&t.r);
        gt_point(&t, s, at, p);
        poly21(at[0], at[1], q);
        gt_same(p, q, 3, 1e-10);
    }
    ASSERT_OK(t.ctx, ix_srf_fit_surface(t.ctx, s, (int[2]){3, 2},
                                        (int[2]){0, 0}, &err, &f));
    assert_true(err < 1e-12);
    ix_mv_unref(t.ctx, f);
    ASSERT_OK(t.ctx, ix_srf_fit_surface(t.ctx, s, (int[2]){2, 2},
                                        (int[2]){3, 2}, &err, &f));
    assert_true(err > 1e-3);
    ix_mv_unref(t.ctx, f);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void test_errors(void **state)
{
    const int three[2] = {3, 3}, two[2] = {2, 2}, zero[2] = {0, 0};
    const double pts[4] = {0, 1, 2, 3}, uv[4] = {0, 0.5, 0, 2};
    gt t = gt_begin(104);
    ix_mv *c[4], *out;
    double err;

    (void)state;
    for (int i = 0; i < 4; i++)
        c[i] = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 2);
    assert_int_equal(ix_srf_skin(t.ctx, 4, (const ix_mv *const *)c, 5,
                                 IX_KV_OPEN, IX_PARAM_UNIFORM, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_skin(t.ctx, 4, (const ix_mv *const *)c, 3,
                                 IX_KV_DISC_OPEN, IX_PARAM_UNIFORM, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_skin(t.ctx, 4, (const ix_mv *const *)c, 3,
                                 IX_KV_PERIODIC, IX_PARAM_UNIFORM, &out),
                     IX_EDOMAIN);
    assert_int_equal(
        ix_srf_fit_grid(t.ctx, two, 1, false, pts, three, zero, &out), IX_EARG);
    assert_int_equal(ix_srf_fit_surface(t.ctx, c[0], two, two, &err, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_fit_points(t.ctx, 2, uv, 1, pts, two, three, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_fit_points(t.ctx, 1, uv, 1, pts, two, two, &out),
                     IX_EDOMAIN);
    assert_int_equal(ix_srf_fit_points(t.ctx, 1, uv, 1, pts, three, two, &out),
                     IX_EARG);
    assert_null(out);
    for (int i = 0; i < 4; i++)
        ix_mv_unref(t.ctx, c[i]);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(105)};

    for (int i = 0; i < 3; i++)
        f->in[i] = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 2);
    f->in[3] = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 3);
}

static ix_status build_skin(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_skin(ctx, 3, (const ix_mv *const *)f->in, 3, IX_KV_OPEN,
                       IX_PARAM_CHORD, out);
}

static ix_status build_surface(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    double err;

    return ix_srf_fit_surface(ctx, f->in[3], (int[2]){3, 3}, (int[2]){4, 4},
                              &err, out);
}

static ix_status build_points(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double uv[8] = {0, 1, 0, 1, 0, 0, 1, 1}, v[4] = {1, 2, 3, 4};

    (void)f;
    return ix_srf_fit_points(ctx, 4, uv, 1, v, (int[2]){2, 2}, (int[2]){2, 2},
                             out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build_skin};

    (void)state;
    ix_build_faults(&f);
    f.build = build_surface;
    ix_build_faults(&f);
    f.build = build_points;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_skin), cmocka_unit_test(test_grid),
        cmocka_unit_test(test_points_surface), cmocka_unit_test(test_errors),
        cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
