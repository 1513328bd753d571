/* Circles and arcs against x^2 + y^2 = r^2, and their ends and angles. */
#include <string.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/geom.h"

static const double center[3] = {1.5, -2, 0.25};

/* Law: every point of the circle has its distance from the centre. */
static void check_radius(ix_ctx *ctx, const ix_mv *m, double r, double tol)
{
    double dom[2], p[3];

    ix_mv_domain(m, 0, dom);
    for (int i = 0; i <= 200; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * i / 200;

        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
        assert_true(fabs(ix__dist3(p, center) - r) <= tol * r);
        assert_true(fabs(p[2] - center[2]) <= 1e-15);
    }
}

static void circles_are_round(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m;
    double t = 1, p[3];

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, center, 3, &m));
    check_radius(ctx, m, 3, 4e-16);
    ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p)); /* a quarter turn: +y */
    ASSERT_CLOSE(p[1], center[1] + 3, 1e-15);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_pcircle(ctx, center, 3, &m));
    check_radius(ctx, m, 3, 2.73e-4);
    assert_false(ix_mv_rational(m));
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Law: a random arc lies on its circle, has the given ends, and stays on the
 * shorter side; its centre is found again. */
static void arcs_follow_their_circle(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(5);

    (void)state;
    for (int k = 0; k < 200; k++) {
        double u[3], v[3], a[3], b[3], p[3], c[3], rad, t;
        ix_mv *m;

        for (int i = 0; i < 3; i++) {
            u[i] = ix_rng_range(&r, -1, 1);
            v[i] = ix_rng_range(&r, -1, 1);
        }
        rad = ix_rng_range(&r, 0.1, 10);
        ix__unit3(u, u);
        ix__unit3(v, v);
        ix__axpy3(center, rad, u, a);
        ix__axpy3(center, rad, v, b);
        ASSERT_OK(ctx, ix_arc(ctx, a, center, b, &m));
        for (t = 0; t <= 1; t += 0.0625) {
            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
            ASSERT_CLOSE(ix__dist3(p, center), rad, 1e-14);
        }
        t = 0.5; /* the middle is nearer to both ends than they are apart */
        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
        assert_true(ix__dist3(p, a) < ix__dist3(a, b));
        ASSERT_CLOSE(ix__dist3(p, a), ix__dist3(p, b), 1e-13);
        assert_true(ix_arc_center(m, c));
        /* flat arcs lose digits as angle^-2; the angle is above 0.02 here */
        assert_true(ix__dist3(c, center) < 1e-10 * rad);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: angle arcs begin and end at their angles and turn counter-clockwise. */
static void angle_arcs(void **state)
{
    static const double angles[][3] = {{0, 90, 90},    {30, 300, 270},
                                       {300, 60, 120}, {-90, 90, 180},
                                       {10, 9, 359},   {0, 450, 90}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t k = 0; k < sizeof angles / sizeof *angles; k++) {
        double dom[2], p[3], last = 0, turn = 0;
        ix_mv *m;

        ASSERT_OK(
            ctx, ix_arc_angles(ctx, center, 2, angles[k][0], angles[k][1], &m));
        check_radius(ctx, m, 2, 1e-15);
        ix_mv_domain(m, 0, dom);
        ASSERT_CLOSE(dom[1], angles[k][2] < 160 ? 1 : 2, 0);
        for (int i = 0; i <= 64; i++) {
            double t = dom[1] * i / 64, a;

            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
            a = IX__DEG(atan2(p[1] - center[1], p[0] - center[0]));
            if (i == 0)
                ASSERT_CLOSE(remainder(a - angles[k][0], 360), 0, 1e-12);
            else
                turn += remainder(a - last, 360);
            last = a;
        }
        ASSERT_CLOSE(turn, angles[k][2], 1e-11);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

static void hermite_has_its_ends(void **state)
{
    const double p0[3] = {1, 2, 3}, p1[3] = {4, 0, -1}, v0[3] = {1, 1, 0},
                 v1[3] = {0, -3, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double d[2][3];
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_hermite(ctx, p0, p1, v0, v1, &m));
    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, m, 0, 1, d[0]));
    for (int i = 0; i < 3; i++) {
        ASSERT_CLOSE(d[0][i], p0[i], 1e-15);
        ASSERT_CLOSE(d[1][i], v0[i], 1e-15);
    }
    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, m, 1, 1, d[0]));
    for (int i = 0; i < 3; i++) {
        ASSERT_CLOSE(d[0][i], p1[i], 1e-15);
        ASSERT_CLOSE(d[1][i], v1[i], 1e-14);
    }
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    const double zero[3] = {0, 0, 0}, x[3] = {1, 0, 0}, mx[3] = {-1, 0, 0},
                 bad[3] = {(double)NAN, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double c[3];
    ix_mv *m;

    (void)state;
    assert_int_equal(ix_circle(ctx, zero, 0, &m), IX_EARG);
    assert_null(m);
    assert_int_equal(ix_circle(ctx, bad, 1, &m), IX_EARG);
    assert_int_equal(ix_pcircle(ctx, zero, -1, &m), IX_EARG);
    assert_int_equal(ix_pcircle(ctx, zero, (double)NAN, &m), IX_EARG);
    assert_int_equal(ix_arc(ctx, x, zero, mx, &m), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "180 degrees"));
    assert_int_equal(ix_arc(ctx, x, zero, x, &m), IX_EDOMAIN);
    assert_int_equal(ix_arc(ctx, zero, zero, x, &m), IX_EARG);
    assert_int_equal(ix_arc_angles(ctx, zero, 1, 10, 370, &m), IX_EARG);
    assert_int_equal(ix_arc_angles(ctx, zero, 1, 10, 10, &m), IX_EARG);
    assert_int_equal(ix_arc_angles(ctx, zero, 1, 0, HUGE_VAL, &m), IX_EARG);
    assert_null(m);
    ASSERT_OK(ctx, ix_hermite(ctx, zero, x, x, x, &m));
    assert_false(ix_arc_center(m, c));
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static ix_status make_all(ix_ctx *ctx, void *state)
{
    const double a[3] = {1, 0, 0}, o[3] = {0, 0, 0}, b[3] = {0, 1, 0};
    ix_mv **m = state;
    ix_status st = ix_circle(ctx, o, 1, &m[0]);

    m[1] = m[2] = m[3] = NULL;
    if (st == IX_OK)
        st = ix_pcircle(ctx, o, 1, &m[1]);
    if (st == IX_OK)
        st = ix_arc(ctx, a, o, b, &m[2]);
    if (st == IX_OK)
        st = ix_arc_angles(ctx, o, 1, 0, 200, &m[3]);
    return st;
}

static void drop_all(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    for (int i = 0; i < 4; i++)
        ix_mv_unref(ctx, m[i]);
}

static void out_of_memory(void **state)
{
    ix_mv *m[4];
    const ix_fault_case c = {NULL, make_all, drop_all, m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circles_are_round),
        cmocka_unit_test(arcs_follow_their_circle),
        cmocka_unit_test(angle_arcs),
        cmocka_unit_test(hermite_has_its_ends),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
