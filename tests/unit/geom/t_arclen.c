/* Lengths, moments and frames against closed forms, and the reparametrised
 * curve against its definition. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

static const double pi = 3.14159265358979323846;

static ix_mv *bezier(ix_ctx *ctx, int order, int ncoords, const double *pts)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = order, .length = order};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, ncoords, false, pts, &m));
    return m;
}

static void lengths(void **state)
{
    static const double center[3] = {3, 1, 2};
    /* y = x^2 over [0, 1]; t^3 (1, 1): a cusp in the parametrisation only;
       (t^2, t^3): a true cusp at 0, length (13^1.5 - 8) / 27 */
    static const double parabola[6] = {0, 0.5, 1, 0, 0, 1};
    static const double slow[8] = {0, 0, 0, 1, 0, 0, 0, 1};
    static const double cusp[8] = {0, 0, 1.0 / 3, 1, 0, 0, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double half[2] = {1, 3};
    double s;
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, center, 2.5, &m));
    ASSERT_OK(ctx, ix_length(ctx, m, NULL, &s));
    ASSERT_CLOSE(s, 5 * pi, 1e-12);
    ASSERT_OK(ctx, ix_length(ctx, m, half, &s));
    ASSERT_CLOSE(s, 2.5 * pi, 1e-12);
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 3, 2, parabola);
    ASSERT_OK(ctx, ix_length(ctx, m, NULL, &s));
    ASSERT_CLOSE(s, sqrt(5) / 2 + asinh(2) / 4, 1e-13);
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 4, 2, slow);
    ASSERT_OK(ctx, ix_length(ctx, m, NULL, &s));
    ASSERT_CLOSE(s, sqrt(2), 1e-13);
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 4, 2, cusp);
    ASSERT_OK(ctx, ix_length(ctx, m, NULL, &s));
    ASSERT_CLOSE(s, (pow(13, 1.5) - 8) / 27, 1e-12);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Laws: length of the parts adds up; scaling scales it. */
static void length_is_additive(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(31);
    ix_rand_opts o = {.ndirs = 1, .max_order = 5};

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &r, &o);
        double dom[2], t, a, b, all;

        ix_mv_domain(m, 0, dom);
        t = ix_rng_range(&r, dom[0], dom[1]);
        ASSERT_OK(ctx, ix_length(ctx, m, NULL, &all));
        ASSERT_OK(ctx, ix_length(ctx, m, (double[]){dom[0], t}, &a));
        ASSERT_OK(ctx, ix_length(ctx, m, (double[]){t, dom[1]}, &b));
        /* scalar curves have kinks in |C'|: bracketed, 1e-12 */
        assert_true(fabs(a + b - all) <= 1e-11 * (1 + all));
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: |out(s1) - out(s0)| over a short step is the step, and out(s) is the
 * point of C at length s, within the tolerance. */
static void check_arclen(ix_ctx *ctx, const ix_mv *m, double tol, int order)
{
    double all, dom[2], cdom[2], err, p[18], q[18];
    ix_mv *a;

    ASSERT_OK(ctx, ix_arclen(ctx, m, tol, order, &err, &a));
    assert_true(err <= tol);
    ASSERT_OK(ctx, ix_length(ctx, m, NULL, &all));
    ix_mv_domain(a, 0, dom);
    ix_mv_domain(m, 0, cdom);
    ASSERT_CLOSE(dom[0], 0, 0);
    ASSERT_CLOSE(dom[1], all, 1e-12);
    assert_int_equal(ix_mv_order(a, 0), order);
    for (int i = 0; i <= 30; i++) {
        double t = cdom[0] + (cdom[1] - cdom[0]) * i / 30, s, d = 0;

        ASSERT_OK(ctx, ix_length(ctx, m, (double[]){cdom[0], t}, &s));
        s = fmin(s, dom[1]);
        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
        ASSERT_OK(ctx, ix_mv_point(ctx, a, &s, q));
        for (int c = 0; c < ix_mv_ncoords(m); c++)
            d = hypot(d, p[c] - q[c]);
        assert_true(d <= tol);
    }
    ix_mv_unref(ctx, a);
}

static void arclen_follows_the_curve(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(32);
    /* jumps have two points at one length; E1 is a line walked to and fro */
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 2,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_PERIODIC,
                      .min_order = 3,
                      .max_knots = 3,
                      .max_order = 4};
    static const double line[4] = {0, 3, 0, 4};
    ix_mv *m = bezier(ctx, 2, 2, line), *a;

    (void)state;
    check_arclen(ctx, m, 1e-9, 3);
    ASSERT_OK(ctx, ix_arclen(ctx, m, 1e-3, 3, NULL, &a));
    assert_int_equal(ix_mv_length(a, 0), 3); /* nothing to refine */
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, m);
    for (int k = 0; k < 5; k++) {
        m = ix_mv_randtest(ctx, &r, &o);
        check_arclen(ctx, m, k % 2 ? 1e-2 : 1e-3, 2 + k % 4);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

static void moments(void **state)
{
    static const double o[3] = {1, 2, 3}, line[6] = {0, 3, 1, 5, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double c[3], axis[3];
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 2, &m));
    ASSERT_OK(ctx, ix_moments(ctx, m, c, axis));
    for (int i = 0; i < 3; i++)
        ASSERT_CLOSE(c[i], o[i], 1e-13);
    assert_true(fabs(axis[2]) < 1e-12);
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 2, 3, line); /* (0, 1, 0) to (3, 5, 0) */
    ASSERT_OK(ctx, ix_moments(ctx, m, c, axis));
    ASSERT_CLOSE(c[0], 1.5, 1e-14);
    ASSERT_CLOSE(c[1], 3, 1e-14);
    ASSERT_CLOSE(axis[0], 0.6, 1e-12);
    ASSERT_CLOSE(axis[1], 0.8, 1e-12);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_arc_angles(ctx, o, 2, 0, 180, &m));
    ASSERT_OK(ctx, ix_moments(ctx, m, c, axis)); /* half circle: 2 r / pi */
    ASSERT_CLOSE(c[1], 2 + 4 / pi, 1e-12);
    ASSERT_CLOSE(axis[0], 1, 1e-12);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void frames(void **state)
{
    static const double o[3] = {0, 0, 0}, cusp[8] = {0, 0, 1, 3, 0, 0, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double v[3];
    ix_mv *m, *flat;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 2, &m));
    for (int i = 0; i <= 16; i++) { /* on a circle, T and N are known */
        double t = i / 4.0, p[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
        ASSERT_OK(ctx, ix_tangent(ctx, m, t, true, v));
        ASSERT_CLOSE(v[0], -p[1] / 2, 1e-13);
        ASSERT_CLOSE(v[1], p[0] / 2, 1e-13);
        ASSERT_OK(ctx, ix_normal(ctx, m, t, v));
        ASSERT_CLOSE(v[0], -p[0] / 2, 1e-12);
        ASSERT_CLOSE(v[1], -p[1] / 2, 1e-12);
    }
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 2, true, &flat));
    ASSERT_OK(ctx, ix_normal(ctx, flat, 0, v)); /* left of +y */
    ASSERT_CLOSE(v[0], -1, 1e-15);
    ix_mv_unref(ctx, flat);
    assert_int_equal(ix_tangent(ctx, m, 4.5, true, v), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 4, 2, cusp); /* begins with zero speed along x */
    ASSERT_OK(ctx, ix_tangent(ctx, m, 0, true, v));
    ASSERT_CLOSE(v[0], 1, 1e-15);
    ASSERT_OK(ctx, ix_tangent(ctx, m, 0, false, v));
    ASSERT_CLOSE(v[0], 0, 0);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Law: the area function of a closed curve ends at its area, and turns sign
 * with the direction. */
static void areas(void **state)
{
    static const double o[3] = {5, -3, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double t = 4, a, sum;
    ix_mv *m, *s, *back;

    (void)state;
    ASSERT_OK(ctx, ix_pcircle(ctx, o, 1, &m));
    ASSERT_OK(ctx, ix_area(ctx, m, &s));
    assert_int_equal(ix_mv_ncoords(s), 1);
    ASSERT_OK(ctx, ix_mv_point(ctx, s, &t, &a));
    sum = 0; /* the polygon of 4000 points, error below 1e-6 */
    for (int i = 0; i < 4000; i++) {
        double u = i / 1000.0, v = (i + 1) / 1000.0, p[3], q[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, m, &u, p));
        ASSERT_OK(ctx, ix_mv_point(ctx, m, &v, q));
        sum += (p[0] * q[1] - p[1] * q[0]) / 2;
    }
    assert_true(fabs(a - sum) < 2e-6);
    assert_true(fabs(a - pi) < 1e-3);
    ix_mv_unref(ctx, s);
    ASSERT_OK(ctx, ix_mv_reverse(ctx, m, 0, &back));
    ASSERT_OK(ctx, ix_area(ctx, back, &s));
    ASSERT_OK(ctx, ix_mv_point(ctx, s, &t, &t));
    ASSERT_CLOSE(t, -a, 1e-13);
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, back);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    static const double o[3] = {0, 0, 0}, point[4] = {1, 1, 2, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double s, v[3], axis[3];
    ix_mv *m, *a;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 1, &m));
    assert_int_equal(ix_length(ctx, m, (double[]){1, 5}, &s), IX_EDOMAIN);
    assert_int_equal(ix_arclen(ctx, m, 0, 3, NULL, &a), IX_EARG);
    assert_null(a);
    assert_int_equal(ix_arclen(ctx, m, 1e-3, 1, NULL, &a), IX_EARG);
    assert_int_equal(ix_area(ctx, m, &a), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "rational"));
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 2, 2, point);
    assert_int_equal(ix_arclen(ctx, m, 1e-3, 3, NULL, &a), IX_EDOMAIN);
    assert_int_equal(ix_moments(ctx, m, v, axis), IX_EDOMAIN);
    assert_int_equal(ix_tangent(ctx, m, 0.5, true, v), IX_EDOMAIN);
    assert_int_equal(ix_normal(ctx, m, 0.5, v), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 2, 3, (double[]){0, 1, 0, 1, 0, 1});
    assert_int_equal(ix_normal(ctx, m, 0.5, v), IX_EDOMAIN); /* straight */
    ix_mv_unref(ctx, m);
    m = bezier(ctx, 3, 1, point);
    assert_int_equal(ix_normal(ctx, m, 0.5, v), IX_EARG);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void setup(ix_ctx *ctx, void *state)
{
    static const double o[3] = {0, 0, 0};
    ix_mv **m = state;

    ASSERT_OK(ctx, ix_pcircle(ctx, o, 1, &m[0]));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;
    double v[3], s;
    ix_status st = ix_arclen(ctx, m[0], 0.1, 4, NULL, &m[1]);

    m[2] = NULL;
    if (st == IX_OK)
        st = ix_area(ctx, m[0], &m[2]);
    if (st == IX_OK)
        st = ix_moments(ctx, m[0], v, NULL);
    if (st == IX_OK)
        st = ix_length(ctx, m[0], NULL, &s);
    if (st == IX_OK)
        st = ix_normal(ctx, m[0], 0.3, v);
    return st;
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

static void out_of_memory(void **state)
{
    ix_mv *m[3];
    const ix_fault_case c = {setup, run, drop, m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths),
        cmocka_unit_test(length_is_additive),
        cmocka_unit_test(arclen_follows_the_curve),
        cmocka_unit_test(moments),
        cmocka_unit_test(frames),
        cmocka_unit_test(areas),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
