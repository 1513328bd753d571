/* Conics: points of the curve satisfy the equation; transformations, ellipses,
 * lines and planes against their definitions. */
#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/geom.h"

#include <string.h>

static double form(const double c[6], const double p[3])
{
    return c[0] * p[0] * p[0] + c[1] * p[0] * p[1] + c[2] * p[1] * p[1] +
           c[3] * p[0] + c[4] * p[1] + c[5];
}

/* The size of the terms whose sum form() is. */
static double terms(const double c[6], const double p[3])
{
    return fabs(c[0] * p[0] * p[0]) + fabs(c[1] * p[0] * p[1]) +
           fabs(c[2] * p[1] * p[1]) + fabs(c[3] * p[0]) + fabs(c[4] * p[1]) +
           fabs(c[5]);
}

/* Law: every point of the curve is on the conic, at height z. */
static void check_on(ix_ctx *ctx, const double c[6], const ix_mv *m, double z)
{
    double dom[2], p[3];

    ix_mv_domain(m, 0, dom);
    for (int i = 0; i <= 40; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * i / 40;

        ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
        assert_true(fabs(form(c, p)) <= 1e-12 * terms(c, p));
        ASSERT_CLOSE(p[2], z, 1e-14);
    }
}

/* The conic with the given principal form, turned and moved. */
static void turned(const double plain[6], double angle, double x, double y,
                   ix_ctx *ctx, double out[6])
{
    double c = cos(angle), s = sin(angle);
    const double m[16] = {c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, x, y, 0, 1};

    ASSERT_OK(ctx, ix_conic_transform(ctx, plain, m, out));
}

static void curves_satisfy_their_equation(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(41);

    (void)state;
    for (int k = 0; k < 300; k++) {
        double a = ix_rng_range(&r, 0.1, 5), b = ix_rng_range(&r, 0.1, 5);
        const double kinds[4][6] = {{a, 0, b, 0, 0, -1},
                                    {a, 0, -b, 0, 0, -1},
                                    {-a, 0, b, 0, 0, -1},
                                    {0, 0, b, -a, 0, 0}};
        double c[6], range[2] = {-1, 1.5}, angle = ix_rng_range(&r, -3.2, 3.2);
        ix_mv *m;

        if (k % 5 == 0)
            angle = 1.5707963267948966 * (k % 4);
        turned(kinds[k % 4], angle, ix_rng_range(&r, -2, 2),
               ix_rng_range(&r, -2, 2), ctx, c);
        for (int i = 0; i < 6; i++)
            c[i] *= k % 3 ? 1 : -1e5; /* the scale does not matter */
        ASSERT_OK(ctx, ix_conic(ctx, c, 0.5, NULL, &m));
        assert_int_equal(ix_mv_order(m, 0), 3);
        assert_int_equal(ix_mv_length(m, 0), k % 4 ? 3 : 9);
        check_on(ctx, c, m, 0.5);
        ix_mv_unref(ctx, m);
        if (k % 4 == 0) {
            range[0] = 20;
            range[1] = 250;
        }
        ASSERT_OK(ctx, ix_conic(ctx, c, -1, range, &m));
        check_on(ctx, c, m, -1);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: between two points of the conic the part has them as its ends. */
static void between_points(void **state)
{
    static const double kinds[3][6] = {
        {1, 0, 4, 0, 0, -4}, {1, 0, -1, 0, 0, -1}, {1, 0, 0, 0, -1, 0}};
    static const double ends[3][2][3] = {
        {{2, 0}, {0, 1}},
        {{-2, -1.7320508075688772}, {-2, 1.7320508075688772}},
        {{-1, 1}, {2, 4}}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double off[3] = {2, 0.5, 0};

    (void)state;
    for (int k = 0; k < 3; k++) {
        double p[2][3], t[2] = {0, 1}, d[2];
        ix_mv *m;

        ASSERT_OK(ctx, ix_conic_between(ctx, kinds[k], 0, ends[k][0],
                                        ends[k][1], &m));
        check_on(ctx, kinds[k], m, 0);
        for (int i = 0; i < 2; i++)
            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t[i], p[i]));
        for (int i = 0; i < 2; i++) { /* either way round */
            d[i] = 0;
            for (int j = 0; j < 2; j++)
                d[i] += hypot(p[j][0] - ends[k][i ? 1 - j : j][0],
                              p[j][1] - ends[k][i ? 1 - j : j][1]);
        }
        assert_true(fmin(d[0], d[1]) < 1e-14);
        ix_mv_unref(ctx, m);
        assert_int_equal(
            ix_conic_between(ctx, kinds[k], 0, off, ends[k][1], &m),
            IX_EDOMAIN);
    }
    ix_ctx_free(ctx);
}

static void degenerate_conics(void **state)
{
    static const struct {
        double c[6];
        const char *what;
    } cases[] = {{{1, 0, 1, 0, 0, 0}, "single point"},
                 {{1, 0, -1, 0, 0, 0}, "cross"},
                 {{1, 0, 1, 0, 0, 1}, "no real"},
                 {{0, 0, 1, 0, 0, -1}, "parallel lines at distance 2"},
                 {{1, 2, 1, 0, 0, 1}, "no real"},
                 {{0, 0, 0, 1, 1, 0}, "linear"},
                 {{1, -2, 1, 2, -2, 0}, "parallel"}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double none[6] = {0}, ok[6] = {1, 0, -1, 0, 0, -1}, bad[2] = {1, 1};
    ix_mv *m;

    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        assert_int_equal(ix_conic(ctx, cases[k].c, 0, NULL, &m), IX_EDOMAIN);
        assert_null(m);
        if (!strstr(ix_ctx_message(ctx), cases[k].what))
            fail_msg("%s: %s", cases[k].what, ix_ctx_message(ctx));
    }
    assert_int_equal(ix_conic(ctx, none, 0, NULL, &m), IX_EARG);
    assert_int_equal(ix_conic(ctx, ok, 0, bad, &m), IX_EARG);
    ix_ctx_free(ctx);
}

/* Law: the image of a point of the quadric is on the image. */
static void transforms_follow_points(void **state)
{
    static const double sphere[10] = {1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(42);
    const double flat[16] = {0};
    double out[10];

    (void)state;
    for (int k = 0; k < 100; k++) {
        double m[16], x[4] = {0, 0, 0, 1}, y[4] = {0}, f, len = 0;

        for (int i = 0; i < 16; i++)
            m[i] = i % 4 == 3 ? i == 15
                              : ix_rng_range(&r, -1, 1) + (i % 5 == 0);
        for (int i = 0; i < 3; i++)
            x[i] = ix_rng_range(&r, -1, 1);
        for (int i = 0; i < 3; i++)
            len = hypot(len, x[i]);
        for (int i = 0; i < 3; i++)
            x[i] /= len;
        for (int i = 0; i < 16; i++)
            y[i % 4] += x[i / 4] * m[i];
        if (ix_quadric_transform(ctx, sphere, m, out) != IX_OK)
            continue;
        f = out[0] * y[0] * y[0] + out[1] * y[1] * y[1] + out[2] * y[2] * y[2] +
            out[3] * y[0] * y[1] + out[4] * y[0] * y[2] + out[5] * y[1] * y[2] +
            out[6] * y[0] + out[7] * y[1] + out[8] * y[2] + out[9];
        len = 0;
        for (int i = 0; i < 10; i++)
            len += fabs(out[i]);
        assert_true(fabs(f) <= 1e-11 * len);
    }
    assert_int_equal(ix_quadric_transform(ctx, sphere, flat, out), IX_EDOMAIN);
    ix_ctx_free(ctx);
}

static void promoted_to_quadric(void **state)
{
    /* (x - 3)^2 + 4 (y + 1)^2 = 4, half height 5 over (3, -1) */
    static const double c[6] = {1, 0, 4, -6, 8, 9};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double parabola[6] = {1, 0, 0, 0, -1, 0};
    double q[10];

    (void)state;
    ASSERT_OK(ctx, ix_conic_to_quadric(ctx, c, 5, q));
    ASSERT_CLOSE(q[2] * 25 + q[0] * 9 + q[1] - 6 * 3 - 8 + 9, 0, 1e-13);
    ASSERT_CLOSE(q[2], 4.0 / 25, 1e-14);
    assert_int_equal(ix_conic_to_quadric(ctx, c, 0, q), IX_EARG);
    assert_int_equal(ix_conic_to_quadric(ctx, parabola, 1, q), IX_EDOMAIN);
    ix_ctx_free(ctx);
}

/* Law: the ellipse passes through the points, its centre is theirs, and its
 * area is the least: 4 pi / (3 sqrt 3) of the triangle's. */
static void smallest_ellipse(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(43);
    double c[6], line[3][3] = {{0, 0}, {1, 1}, {2, 2}}, grow[6];
    const double equal[3][3] = {
        {2, 0}, {-1, 1.7320508075688772}, {-1, -1.7320508075688772}};

    (void)state;
    for (int k = 0; k < 100; k++) {
        double p[3][3], area, det;

        for (int i = 0; i < 9; i++)
            p[i / 3][i % 3] = ix_rng_range(&r, -3, 3);
        area = fabs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                    (p[2][0] - p[0][0]) * (p[1][1] - p[0][1])) /
               2;
        if (area < 0.1)
            continue;
        ASSERT_OK(ctx,
                  ix_ellipse_three_points(ctx, (const double(*)[3])p, 0, c));
        for (int i = 0; i < 3; i++)
            assert_true(fabs(form(c, p[i])) < 1e-11 * terms(c, p[i]));
        det = c[0] * c[2] - c[1] * c[1] / 4; /* area = pi / sqrt(det) */
        ASSERT_CLOSE(1 / sqrt(det), 4 * area / (3 * sqrt(3)), 1e-11);
    }
    ASSERT_OK(ctx, ix_ellipse_three_points(ctx, equal, 1, grow));
    ASSERT_CLOSE(grow[0], 1.0 / 9, 1e-14); /* radius 2 + 1 */
    ASSERT_CLOSE(grow[5], -1, 1e-14);
    assert_int_equal(ix_ellipse_three_points(ctx, equal, -2, grow), IX_EARG);
    assert_int_equal(
        ix_ellipse_three_points(ctx, (const double(*)[3])line, 0, c),
        IX_EDOMAIN);
    ix_ctx_free(ctx);
}

/* Laws: points on a line or plane give it back; no small move of the result
 * brings the sum of squares down. */
static void lines_and_planes(void **state)
{
    static const double square[12] = {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    static const double same[6] = {1, 2, 3, 1, 2, 3};
    static const double row[9] = {0, 0, 0, 1, 2, 3, 2, 4, 6};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double p[3], d[3], dist, pl[4];

    (void)state;
    ASSERT_OK(ctx, ix_fit_line(ctx, 3, row, p, d, &dist));
    ASSERT_CLOSE(d[0], 1 / sqrt(14), 1e-14);
    ASSERT_CLOSE(dist, 0, 1e-15);
    ASSERT_CLOSE(p[0], 0, 1e-15);
    ASSERT_OK(ctx, ix_fit_plane(ctx, 4, square, pl, &dist));
    ASSERT_CLOSE(pl[2], 1, 1e-15); /* counter-clockwise from above */
    ASSERT_CLOSE(pl[3], -1, 1e-15);
    ASSERT_OK(ctx, ix_fit_line(ctx, 4, square, p, d, &dist));
    ASSERT_CLOSE(dist, 0.5, 1e-12); /* through the middle, whatever direction */
    assert_int_equal(ix_fit_line(ctx, 1, row, p, d, &dist), IX_EARG);
    assert_int_equal(ix_fit_line(ctx, 2, same, p, d, &dist), IX_EDOMAIN);
    assert_int_equal(ix_fit_plane(ctx, 2, row, pl, &dist), IX_EARG);
    assert_int_equal(ix_fit_plane(ctx, 3, row, pl, &dist), IX_EDOMAIN);
    ix_ctx_free(ctx);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    static const double c[6] = {1, 0.5, 1, 0, 0, -1};

    return ix_conic(ctx, c, 0, NULL, state);
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv_unref(ctx, *(ix_mv **)state);
}

static void out_of_memory(void **state)
{
    ix_mv *m;
    const ix_fault_case c = {NULL, run, drop, &m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_satisfy_their_equation),
        cmocka_unit_test(between_points),
        cmocka_unit_test(degenerate_conics),
        cmocka_unit_test(transforms_follow_points),
        cmocka_unit_test(promoted_to_quadric),
        cmocka_unit_test(smallest_ellipse),
        cmocka_unit_test(lines_and_planes),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
