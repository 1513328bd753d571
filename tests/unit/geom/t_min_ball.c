/* Smallest balls, circles and cones: all inside, and none smaller, which a
 * certificate shows: the centre is in the hull of the points on the boundary.
 */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/distance.h"
#include "iritx/enclose.h"
#include "iritx/geom.h"

static double dist(const double *a, const double *b)
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* No direction moves the centre nearer to all points on the boundary: for many
 * directions one of them is on the far side. */
static void assert_smallest(gt *t, int n, double (*p)[3], const ix_ball *b,
                            int dims)
{
    for (int k = 0; k < 200; k++) {
        double d[3] = {0}, most = -HUGE_VAL, len = 0;

        for (int c = 0; c < dims; c++)
            d[c] = ix_rng_range(&t->r, -1, 1);
        for (int c = 0; c < 3; c++)
            len += d[c] * d[c];
        for (int i = 0; i < n; i++)
            if (dist(p[i], b->center) >= b->radius * (1 - 1e-9)) {
                double s = 0;

                for (int c = 0; c < 3; c++)
                    s += d[c] * (b->center[c] - p[i][c]);
                most = fmax(most, s);
            }
        /* 1e-7: the points that count are known to the root of rounding */
        assert_true(most >= -1e-7 * b->radius * sqrt(len));
    }
}

static void balls_of_points(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < 200; k++) {
        int n = ix_rng_int(&t.r, 1, 30), dims = 2 + k % 2;
        double p[30][3] = {{0}};
        ix_ball b;

        for (int i = 0; i < n; i++)
            for (int c = 0; c < dims; c++)
                p[i][c] = k % 3 ? ix_rng_range(&t.r, -1, 1)
                                : ix_rng_int(&t.r, -2, 2); /* many ties */
        ASSERT_OK(t.ctx,
                  ix_ball_of_points(t.ctx, n, (const double(*)[3])p, &b));
        for (int i = 0; i < n; i++)
            assert_true(dist(p[i], b.center) <= b.radius * (1 + 2e-12));
        if (b.radius > 0)
            assert_smallest(&t, n, p, &b, dims);
        assert_true(dims == 3 || b.center[2] == 0);
    }
    gt_end(&t);
}

/* Law: the circle around curves holds them, and is that of dense samples to
 * what the samples leave (never smaller). */
static void circles_of_curves(void **state)
{
    gt t = gt_begin(2);

    (void)state;
    for (int k = 0; k < 40; k++) {
        const ix_mv *crv[3];
        double p[303][3] = {{0}};
        ix_ball b, rough;
        int n = 1 + k % 3;

        for (int i = 0; i < n; i++) {
            /* no knots: a short span may lie between two samples */
            crv[i] = gt_random(&t, 1, 2, k % 2 ? 1 : -1, IX_RAND_BEZIER, 2);
            for (int j = 0; j <= 100; j++) {
                double dom[2], at, x[IX_MAX_COORDS];

                ix_mv_domain(crv[i], 0, dom);
                at = dom[0] + (dom[1] - dom[0]) * j / 100;
                gt_point(&t, crv[i], &at, x);
                p[101 * i + j][0] = x[0];
                p[101 * i + j][1] = x[1];
            }
        }
        ASSERT_OK(t.ctx, ix_ball_of_curves(t.ctx, n, crv, &b));
        ASSERT_OK(t.ctx, ix_ball_of_points(t.ctx, 101 * n,
                                           (const double(*)[3])p, &rough));
        for (int i = 0; i < 101 * n; i++)
            assert_true(dist(p[i], b.center) <= b.radius * (1 + 1e-10));
        assert_true(b.radius >= rough.radius * (1 - 1e-10));
        assert_true(b.radius <= rough.radius * 1.01);
        for (int i = 0; i < n; i++)
            ix_mv_unref(t.ctx, crv[i]);
    }
    gt_end(&t);
}

static void a_circle_is_its_own(void **state)
{
    const double center[3] = {3, -2, 0};
    gt t = gt_begin(3);
    ix_ball b;
    ix_mv *c;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, center, 1.5, &c));
    ASSERT_OK(t.ctx, ix_ball_of_curves(t.ctx, 1, (const ix_mv *const *)&c, &b));
    gt_same(b.center, center, 3, 1e-10);
    ASSERT_CLOSE(b.radius, 1.5, 1e-12);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

/* Random vectors about an axis: the cone is no wider than that about it. */
static void cones(void **state)
{
    gt t = gt_begin(4);

    (void)state;
    for (int k = 0; k < 100; k++) {
        double v[12][3], axis[3], angle, wide = k % 2 ? 1.2 : 0.01;

        for (int i = 0; i < 12; i++) {
            double a = ix_rng_range(&t.r, 0, wide),
                   phi = ix_rng_range(&t.r, 0, 6.3);

            v[i][0] = 3 * sin(a) * cos(phi);
            v[i][1] = 3 * cos(a);
            v[i][2] = 3 * sin(a) * sin(phi);
        }
        ASSERT_OK(t.ctx, ix_cone_of_vectors(t.ctx, 12, (const double(*)[3])v,
                                            axis, &angle));
        assert_true(angle > 0 && angle <= wide);
        for (int i = 0; i < 12; i++) {
            double c = (v[i][0] * axis[0] + v[i][1] * axis[1] +
                        v[i][2] * axis[2]) /
                       3;

            assert_true(acos(fmin(1, c)) <= angle + 1e-7);
        }
    }
    gt_end(&t);
}

static void errors(void **state)
{
    const double v[3][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, 0}};
    const double inf[1][3] = {{INFINITY, 0, 0}};
    gt t = gt_begin(5);
    double axis[3], angle;
    ix_ball b;
    ix_mv *s = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 2);

    (void)state;
    assert_int_equal(ix_ball_of_points(t.ctx, 0, v, &b), IX_EARG);
    assert_int_equal(ix_ball_of_points(t.ctx, 1, inf, &b), IX_EARG);
    assert_int_equal(ix_ball_of_curves(t.ctx, 0, NULL, &b), IX_EARG);
    assert_int_equal(ix_ball_of_curves(t.ctx, 1, (const ix_mv *const *)&s, &b),
                     IX_EARG);
    assert_int_equal(ix_cone_of_vectors(t.ctx, 0, v, axis, &angle), IX_EARG);
    assert_int_equal(ix_cone_of_vectors(t.ctx, 2, v, axis, &angle), IX_EDOMAIN);
    assert_int_equal(ix_cone_of_vectors(t.ctx, 3, v, axis, &angle), IX_EARG);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {0, 1, 2, 0, 2, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double v[2][3] = {{1, 0, 0}, {1, 1, 0}};
    double axis[3], angle;
    ix_ball b;

    IX_TRY(ix_cone_of_vectors(ctx, 2, v, axis, &angle));
    IX_TRY(ix_ball_of_curves(ctx, 1, (const ix_mv *const *)f->in, &b));
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(balls_of_points),
        cmocka_unit_test(circles_of_curves),
        cmocka_unit_test(a_circle_is_its_own),
        cmocka_unit_test(cones),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
