/* Nearest and farthest points of curves and surfaces of every shape, against
 * dense samples and closed forms. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/distance.h"
#include "mv/mv.h"

IX_TEST_FIXTURE(20261123)

static double dist(const ix_mv *m, const double *t, const double *p)
{
    double x[3] = {0, 0, 0};

    ASSERT_OK(ctx, ix_mv_point(ctx, m, t, x));
    return sqrt((x[0] - p[0]) * (x[0] - p[0]) + (x[1] - p[1]) * (x[1] - p[1]) +
                (x[2] - p[2]) * (x[2] - p[2]));
}

/* Nothing among random parameters (often at knots) and a grid is better; the
 * distance is that of the point. 1e-12: rounding of both evaluations. */
static void check(const ix_mv *m, const double *p, bool far)
{
    enum { N = 60 };
    double t[2] = {0, 0}, d, dom[2][2] = {{0, 0}, {0, 0}};

    if (m->ndirs == 1)
        ASSERT_OK(ctx, ix_crv_nearest(ctx, m, p, NULL, far, t, &d));
    else
        ASSERT_OK(ctx, ix_srf_nearest(ctx, m, p, far, t, &d));
    ASSERT_CLOSE(dist(m, t, p), d, 1e-13);
    for (int j = 0; j < m->ndirs; j++)
        ix_mv_domain(m, j, dom[j]);
    for (int i = 0; i <= N; i++)
        for (int k = 0; k <= (m->ndirs > 1 ? N : 0); k++) {
            double s[2] = {dom[0][0] + i * (dom[0][1] - dom[0][0]) / N,
                           dom[1][0] + k * (dom[1][1] - dom[1][0]) / N};
            double e;

            if (k == 0 && i % 3 == 0)
                ix_mv_randparam(&rng, m, s);
            e = dist(m, s, p);
            assert_true(far ? e <= d + 1e-12 : e >= d - 1e-12);
        }
}

/* Law: no point is nearer (farther), whatever the basis, with corners and
 * creases. */
static void none_is_better(void **state)
{
    (void)state;
    for (int round = 0; round < 60; round++) {
        const ix_rand_opts o = {.ndirs = 1 + round % 2,
                                .ncoords = 3,
                                .min_order = 2,
                                .max_order = 4,
                                .kinds = IX_RAND_BEZIER | IX_RAND_OPEN |
                                         IX_RAND_FLOAT | IX_RAND_PERIODIC |
                                         (round % 2 ? 0u : IX_RAND_POWER),
                                .rational = round % 4 == 0 ? -1 : 0};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        double p[3];

        for (int k = 0; k < 3; k++)
            p[k] = ix_rng_range(&rng, -1, 1);
        check(m, p, false);
        check(m, p, true);
        ix_mv_unref(ctx, m);
    }
}

/* A roof z = -|x - 1| over [0, 2] x [0, 1], linear with a knot at the ridge. */
static ix_mv *roof(void)
{
    const double kv[5] = {0, 0, 1, 2, 2}, kw[4] = {0, 0, 1, 1};
    const double pts[18] = {0, 1, 2, 0,  1, 2,  0,  0, 0,
                            1, 1, 1, -1, 0, -1, -1, 0, -1};
    const ix_dir d[2] = {{IX_BSPLINE, 2, 3, false, kv},
                         {IX_BSPLINE, 2, 2, false, kw}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, pts, &m));
    return m;
}

/* The nearest point is on the crease, where there is no perpendicular. */
static void on_a_crease(void **state)
{
    const double p[3] = {1.1, 0.3, 2};
    ix_mv *m = roof();
    double uv[2], d;

    (void)state;
    ASSERT_OK(ctx, ix_srf_nearest(ctx, m, p, false, uv, &d));
    ASSERT_CLOSE(uv[0], 1, 0);
    ASSERT_CLOSE(uv[1], 0.3, 1e-14);
    ASSERT_CLOSE(d, sqrt(0.01 + 4), 1e-15);
    ix_mv_unref(ctx, m);
}

/* A cubic whose control points lie on a line with many knots: the foot is
 * known, also when it is on a knot, and the parameter has all its digits. */
static void on_a_knot(void **state)
{
    enum { N = 203 };
    static double pts[3 * N], kv[N + 4];
    const ix_dir dir = {IX_BSPLINE, 4, N, false, kv};
    ix_mv *m;

    (void)state;
    for (int i = 0; i < N + 4; i++)
        kv[i] = i < 4 ? 0 : i >= N ? N - 3 : i - 3;
    for (int i = 0; i < N; i++)
        pts[i] = (kv[i + 1] + kv[i + 2] + kv[i + 3]) / 3; /* x = t */
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 3, false, pts, &m));
    for (int i = 0; i < 40; i++) {
        double p[3] = {5 * i + (i % 2 ? 1e-9 : 0), 0.5, 0}, t, d;

        ASSERT_OK(ctx, ix_crv_nearest(ctx, m, p, NULL, false, &t, &d));
        ASSERT_CLOSE(t, p[0], 1e-15);
        ASSERT_CLOSE(d, 0.5, 1e-15);
    }
    ix_mv_unref(ctx, m);
}

typedef struct {
    ix_mv *m;
} oom;

static void oom_setup(ix_ctx *c, void *state)
{
    ix_rng g = ix_rng_new(3);
    const ix_rand_opts o = {.ndirs = 2,
                            .ncoords = 3,
                            .max_order = 3,
                            .kinds = IX_RAND_OPEN,
                            .max_knots = 2};

    ((oom *)state)->m = ix_mv_randtest(c, &g, &o);
}

static ix_status oom_run(ix_ctx *c, void *state)
{
    const double p[3] = {0.1, 0.2, 0.3};
    double uv[2], d;

    return ix_srf_nearest(c, ((oom *)state)->m, p, false, uv, &d);
}

static void oom_teardown(ix_ctx *c, void *state)
{
    ix_mv_unref(c, ((oom *)state)->m);
}

static void out_of_memory(void **state)
{
    oom o = {NULL};
    ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) >= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(none_is_better),
        cmocka_unit_test(on_a_crease),
        cmocka_unit_test(on_a_knot),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
