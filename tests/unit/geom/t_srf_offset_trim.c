/* Where offsets of surfaces meet themselves: against offset profiles whose
 * crossing is known, and against distances. */
#include "geomtest.h"
#include "harness/fault.h"
#include "iritx/distance.h"
#include "iritx/offset.h"

/* The channel z = x^2 over [-1, 1] x [0, 1], whose offsets to the inside have
 * the profile (x - 2 x d / s, x^2 + d / s), s = sqrt(1 + 4 x^2): for d > 1/2 it
 * crosses itself above 0 where s = 2 d, at z = d^2 + 1/4. */
static ix_mv *channel(ix_ctx *ctx, ix_mv **off, double d, double tol)
{
    const double pts[18] = {-1, 0, 1, -1, 0,  1, 0, 0,  0,
                            1,  1, 1, 1,  -1, 1, 1, -1, 1};
    const ix_dir dir[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                           {.basis = IX_BEZIER, .order = 2, .length = 2}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dir, 3, false, pts, &m));
    ASSERT_OK(ctx, ix_srf_offset(ctx, m, -d, tol, NULL, off));
    return m;
}

static void known_edge(void **state)
{
    const double d = 0.8, tol = 5e-3;
    gt t = gt_begin(81);
    ix_mv *off, *s = channel(t.ctx, &off, d, tol);
    bool complete;
    ix_crvs c;

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_offset_meet(t.ctx, s, off, d - 0.01, true, 1e-2,
                                        &complete, &c));
    assert_true(complete);
    assert_int_equal(c.n, 1);
    for (int i = 0; i <= 10; i++) {
        double at = c.t[0] + (c.t[1] - c.t[0]) * i / 10, p[3];

        ASSERT_OK(t.ctx, ix_mv_point(t.ctx, c.crv[0], &at, p));
        ASSERT_CLOSE(p[0], 0, 1e-9);
        ASSERT_CLOSE(p[2], d * d + 0.25, 4 * tol);
    }
    ix_crvs_free(t.ctx, &c);
    /* in parameters both points are one; nothing is farther than d */
    ASSERT_OK(t.ctx,
              ix_srf_offset_meet(t.ctx, s, off, 0, false, 1e-2, &complete, &c));
    assert_int_equal(c.n, 1);
    for (int i = 0; i < 2; i++) {
        double x[4], p[3], q[3];

        ASSERT_OK(t.ctx, ix_mv_point(t.ctx, c.crv[0], &c.t[i], x));
        ASSERT_OK(t.ctx, ix_mv_point(t.ctx, off, x, p));
        ASSERT_OK(t.ctx, ix_mv_point(t.ctx, off, x + 2, q));
        for (int k = 0; k < 3; k++)
            ASSERT_CLOSE(p[k], q[k], 1e-12);
        assert_true(fabs(x[0] - x[2]) > 0.1);
    }
    ix_crvs_free(t.ctx, &c);
    ASSERT_OK(t.ctx, ix_srf_offset_meet(t.ctx, s, off, d + 0.01, true, 1e-2,
                                        &complete, &c));
    assert_int_equal(c.n, 0);
    ix_crvs_free(t.ctx, &c);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, off);
    gt_end(&t);
}

/* Of a surface that is not the one that was offset only a part is far enough:
 * the channel, cut off at y = 0.4. The run ends there, on the circle of the
 * amount around the end of the axis. */
static void part_of_an_edge(void **state)
{
    const double d = 0.8, amount = 0.85;
    gt t = gt_begin(82);
    ix_mv *off, *s = channel(t.ctx, &off, d, 5e-3), *half;
    double p[3], foot[2], away;
    bool complete;
    ix_crvs c;

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_region(t.ctx, s, 1, 0, 0.4, &half));
    ASSERT_OK(t.ctx, ix_srf_offset_meet(t.ctx, half, off, amount, true, 1e-2,
                                        &complete, &c));
    assert_int_equal(c.n, 1);
    for (int i = 0; i < 2; i++) {
        ASSERT_OK(t.ctx, ix_mv_point(t.ctx, c.crv[0], &c.t[i], p));
        if (p[1] > 0.99)
            continue;
        ASSERT_OK(t.ctx, ix_srf_nearest(t.ctx, half, p, false, foot, &away));
        ASSERT_CLOSE(away, amount, 1e-6);
        /* sqrt(d^2 + (y - 0.4)^2) = amount; the offset is off by 5e-3 */
        ASSERT_CLOSE(p[1], 0.4 + sqrt(amount * amount - d * d), 5e-2);
    }
    ix_crvs_free(t.ctx, &c);
    ix_mv_unref(t.ctx, half);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, off);
    gt_end(&t);
}

static void refused(void **state)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    const double pts[6] = {0, 1, 0, 0, 0, 1};
    gt t = gt_begin(83);
    bool complete;
    ix_crvs c;
    ix_mv *m;

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 1, &d, 3, false, pts, &m));
    assert_int_equal(ix_srf_offset_meet(t.ctx, m, m, 0, true, 0, &complete, &c),
                     IX_EARG);
    ix_mv_unref(t.ctx, m);
    gt_end(&t);
}

typedef struct {
    ix_mv *s, *off;
    ix_crvs c;
} oom;

static void oom_setup(ix_ctx *ctx, void *state)
{
    oom *o = state;

    o->s = channel(ctx, &o->off, 0.8, 1);
}

static ix_status oom_run(ix_ctx *ctx, void *state)
{
    oom *o = state;
    bool complete;

    return ix_srf_offset_meet(ctx, o->s, o->off, 0, true, 1e-2, &complete,
                              &o->c);
}

static void oom_teardown(ix_ctx *ctx, void *state)
{
    oom *o = state;

    ix_crvs_free(ctx, &o->c);
    ix_mv_unref(ctx, o->s);
    ix_mv_unref(ctx, o->off);
}

static void out_of_memory(void **state)
{
    oom o = {NULL, NULL, {0}};
    ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) >= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_edge),
        cmocka_unit_test(part_of_an_edge),
        cmocka_unit_test(refused),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
