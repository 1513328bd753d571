/* t_srf_revolve.c - surfaces of revolution. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

#define PI 3.14159265358979323846

/* Law: the parameter of an angle is where the circle of four rational arcs
 * has that angle. */
static void test_circle_param(void **state)
{
    const double zero[2] = {0, 0}, x[2] = {1, 1};
    double p[IX_MAX_COORDS], uv[2] = {0, 0.5};
    gt t = gt_begin(11);
    ix_mv *c, *s = NULL;

    (void)state;
    c = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){x[0], x[1], zero[0], 0});
    ASSERT_OK(t.ctx, ix_srf_revolve(t.ctx, c, IX_TURN_RATIONAL, &s));
    for (int deg = 0; deg <= 360; deg += 5) {
        uv[0] = ix_circle_param(deg);
        gt_point(&t, s, uv, p);
        ASSERT_CLOSE(p[0], cos(deg * PI / 180), 1e-14);
        ASSERT_CLOSE(p[1], sin(deg * PI / 180), 1e-14);
    }
    assert_true(ix_circle_param(360) == 4 && ix_circle_param(90) == 1);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

/* c's point at v turned by angle radians about Z. */
static void turned(gt *t, const ix_mv *c, double v, double angle, double q[3])
{
    double p[IX_MAX_COORDS];

    gt_point(t, c, &v, p);
    q[0] = cos(angle) * p[0] - sin(angle) * p[1];
    q[1] = sin(angle) * p[0] + cos(angle) * p[1];
    q[2] = p[2];
}

/* Law: S(u(angle), v) is c(v) turned by the angle. */
static void test_revolve(void **state)
{
    gt t = gt_begin(12);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c = gt_random(&t, 1, ix_rng_int(&t.r, 1, 3), 0, IX_RAND_ALL, 1);
        ix_mv *s = NULL;
        double deg = ix_rng_range(&t.r, 0, 360), uv[2], p[IX_MAX_COORDS], q[3];

        ASSERT_OK(t.ctx, ix_srf_revolve(t.ctx, c, IX_TURN_RATIONAL, &s));
        uv[0] = ix_circle_param(deg);
        uv[1] = gt_param(&t, s, 1);
        gt_point(&t, s, uv, p);
        turned(&t, c, uv[1], deg * PI / 180, q);
        gt_same(p, q, 3, TOL);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: the polynomial turn has the radius within 2.8e-4 and is exact at
 * quarter turns. */
static void test_polynomial(void **state)
{
    gt t = gt_begin(13);
    ix_mv *c = gt_random(&t, 1, 3, -1, IX_RAND_OPEN, 2), *s = NULL;

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_revolve(t.ctx, c, IX_TURN_POLYNOMIAL, &s));
    assert_false(ix_mv_rational(s));
    assert_int_equal(ix_mv_length(s, 0), 13);
    for (int k = 0; k < ROUNDS; k++) {
        double uv[2] = {k % 2 ? gt_param(&t, s, 0) : k / 2 % 5,
                        gt_param(&t, s, 1)};
        double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

        gt_point(&t, s, uv, p);
        gt_point(&t, c, &uv[1], q);
        ASSERT_CLOSE(p[2], q[2], 1e-13);
        assert_true(fabs(hypot(p[0], p[1]) / hypot(q[0], q[1]) - 1) <
                    (k % 2 ? 2.8e-4 : 1e-13));
    }
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

/* Law: a part begins at a0 and ends at a1. */
static void test_part(void **state)
{
    gt t = gt_begin(14);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c = gt_random(&t, 1, 3, 0, IX_RAND_ALL, 2), *s = NULL;
        double a[2] = {ix_rng_range(&t.r, -90, 90),
                       ix_rng_range(&t.r, 91, 440)};
        double uv[2], dom[2], p[IX_MAX_COORDS], q[3];

        ASSERT_OK(t.ctx,
                  ix_srf_revolve_part(t.ctx, c, a[k % 2], a[1 - k % 2], &s));
        ix_mv_domain(s, 0, dom);
        assert_true(dom[0] == 0);
        for (int e = 0; e < 2; e++) {
            uv[0] = dom[e];
            uv[1] = gt_param(&t, s, 1);
            gt_point(&t, s, uv, p);
            if (e == 1 && a[1] - a[0] >= 360)
                a[1] = a[0] + 360;
            turned(&t, c, uv[1], a[e] * PI / 180, q);
            gt_same(p, q, 3, TOL);
        }
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: turning about an axis keeps the distance from it and the position
 * along it, begins at the curve, and turns counter-clockwise around it. */
static void test_axis(void **state)
{
    gt t = gt_begin(15);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c = gt_random(&t, 1, 3, 0, IX_RAND_ALL, 2), *s = NULL;
        double d[3] = {ix_rng_range(&t.r, -1, 1), ix_rng_range(&t.r, -1, 1),
                       ix_rng_range(&t.r, -1, 1)};
        double uv[2] = {0, 0}, p[IX_MAX_COORDS], q[IX_MAX_COORDS], n, side = 0;

        if (k == 0)
            memcpy(d, (double[3]){0, 0, -2}, sizeof d);
        n = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        ASSERT_OK(t.ctx, ix_srf_revolve_axis(t.ctx, c, 0, 360, d, &s));
        uv[1] = gt_param(&t, s, 1);
        gt_point(&t, s, uv, p);
        gt_point(&t, c, &uv[1], q);
        gt_same(p, q, 3, TOL);
        uv[0] = ix_circle_param(60);
        gt_point(&t, s, uv, p);
        ASSERT_CLOSE(p[0] * d[0] + p[1] * d[1] + p[2] * d[2],
                     q[0] * d[0] + q[1] * d[1] + q[2] * d[2], TOL);
        ASSERT_CLOSE(p[0] * p[0] + p[1] * p[1] + p[2] * p[2],
                     q[0] * q[0] + q[1] * q[1] + q[2] * q[2], TOL);
        for (int i = 0; i < 3; i++) { /* (q x p).d = |d| r^2 sin 60 > 0 */
            int j = (i + 1) % 3, l = (i + 2) % 3;

            side += (q[j] * p[l] - q[l] * p[j]) * d[i] / n;
        }
        assert_true(side > 0);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* p turned about the axis through q along the unit vector n (Rodrigues). */
static void rodrigues(const double *p, const double *q, const double *n,
                      double degrees, double out[3])
{
    double a = degrees * PI / 180, d[3], dot = 0;

    for (int k = 0; k < 3; k++) {
        d[k] = p[k] - q[k];
        dot += d[k] * n[k];
    }
    for (int k = 0; k < 3; k++) {
        double cross = n[(k + 1) % 3] * d[(k + 2) % 3] -
                       n[(k + 2) % 3] * d[(k + 1) % 3];

        out[k] = q[k] + d[k] * cos(a) + cross * sin(a) +
                 n[k] * dot * (1 - cos(a));
    }
}

/* Law: the faces of a part of a turn are the surface turned to both angles,
 * about any axis; what is between keeps its distance from the axis (cubics:
 * within 2.8e-4 of it). */
static void test_volume(void **state)
{
    static const double n[3] = {2.0 / 3, -1.0 / 3, 2.0 / 3};
    gt t = gt_begin(18);

    (void)state;
    for (int k = 0; k < 20; k++) {
        ix_revolution r = {.turn = k % 2 ? IX_TURN_POLYNOMIAL
                                         : IX_TURN_RATIONAL,
                           .a0 = ix_rng_range(&t.r, -200, 200),
                           .point = {1, -2, 0.5},
                           .axis = {2, -1, 2}};
        double tol = k % 2 ? 1e-3 : TOL, at[3], p[IX_MAX_COORDS];
        ix_mv *s = gt_random(&t, 2, 3, k % 2 ? -1 : 0, IX_RAND_BEZIER, 2),
              *v = NULL;
        double q[3], x[IX_MAX_COORDS], end[2];

        r.a1 = r.a0 + ix_rng_range(&t.r, 1, k < 15 ? 359 : 500);
        ASSERT_OK(t.ctx, ix_tv_revolve_about(t.ctx, s, &r, &v));
        ix_mv_domain(v, 2, end);
        for (int e = 0; e < 2; e++) {
            at[0] = ix_rng_unit(&t.r);
            at[1] = ix_rng_unit(&t.r);
            at[2] = end[e];
            gt_point(&t, s, at, x);
            gt_point(&t, v, at, p);
            rodrigues(x, r.point, n, e ? fmin(r.a1, r.a0 + 360) : r.a0, q);
            gt_same(p, q, 3, tol);
        }
        ix_mv_unref(t.ctx, v);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    const double zero[3] = {0, 0, 0};
    gt t = gt_begin(16);
    ix_mv *c = gt_random(&t, 1, 2, 1, IX_RAND_BEZIER, 2);
    ix_mv *s = gt_random(&t, 2, 2, -1, IX_RAND_BEZIER, 2), *out;
    ix_revolution r = {.a1 = 90, .axis = {0, 0, 0}};

    (void)state;
    assert_int_equal(ix_tv_revolve_about(t.ctx, s, &r, &out), IX_EARG);
    r.axis[1] = 1;
    assert_int_equal(ix_tv_revolve_about(t.ctx, c, &r, &out), IX_EARG);
    r.a0 = 90;
    assert_int_equal(ix_tv_revolve_about(t.ctx, s, &r, &out), IX_EARG);
    r.a0 = (double)NAN;
    assert_int_equal(ix_tv_revolve_about(t.ctx, s, &r, &out), IX_EARG);
    assert_int_equal(ix_srf_revolve(t.ctx, c, IX_TURN_POLYNOMIAL, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_revolve(t.ctx, s, IX_TURN_RATIONAL, &out), IX_EARG);
    assert_int_equal(ix_srf_revolve_part(t.ctx, c, 5, 5, &out), IX_EARG);
    assert_int_equal(ix_srf_revolve_part(t.ctx, c, 5, (double)NAN, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_revolve_axis(t.ctx, c, 0, 90, zero, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(17)};

    f->in[0] = gt_random(&t, 1, 2, -1, IX_RAND_BEZIER, 3);
    f->in[1] = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 3);
}

static ix_status build_volume(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_revolution r = {.a0 = 10, .a1 = 100, .axis = {1, 2, 3}};

    return ix_tv_revolve_about(ctx, f->in[1], &r, out);
}

static ix_status build_full(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_revolve(ctx, f->in[0], IX_TURN_POLYNOMIAL, out);
}

static ix_status build_axis(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_revolve_axis(ctx, f->in[0], 10, 250,
                               (const double[3]){1, 2, 3}, out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build_full};

    (void)state;
    ix_build_faults(&f);
    f.build = build_axis;
    ix_build_faults(&f);
    f.build = build_volume;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_circle_param), cmocka_unit_test(test_revolve),
        cmocka_unit_test(test_polynomial),   cmocka_unit_test(test_part),
        cmocka_unit_test(test_axis),         cmocka_unit_test(test_volume),
        cmocka_unit_test(test_errors),       cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
