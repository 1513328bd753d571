/* Edits of knots, points, parametrisation: each against what it must keep. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

/* Laws: control points and domain stay; uniform spacing gives uniform knots;
 * a second time changes nothing. */
static void reknot_keeps_points(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(91);
    ix_rand_opts o = {.ndirs = 1,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_PERIODIC,
                      .min_order = 2};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *c = ix_mv_randtest(ctx, &r, &o), *m, *again;
        double a[2], b[2];
        ix_dir d;

        if (ix_mv_npts(c) == 1) { /* periodic: no step has a length */
            assert_int_equal(ix_reknot(ctx, c, IX_PARAM_CHORD, &m), IX_EDOMAIN);
            ix_mv_unref(ctx, c);
            continue;
        }
        ASSERT_OK(ctx, ix_reknot(ctx, c, (ix_param)(k % 4), &m));
        ASSERT_OK(ctx, ix_reknot(ctx, m, (ix_param)(k % 4), &again));
        ix_mv_domain(c, 0, a);
        ix_mv_domain(m, 0, b);
        ASSERT_CLOSE(a[0], b[0], 1e-15);
        ASSERT_CLOSE(a[1], b[1], 1e-15);
        for (int x = 0; x < ix_mv_naxes(c); x++)
            for (size_t i = 0; i < ix_mv_npts(c); i++)
                assert_true(ix_mv_axis(c, x)[i] == ix_mv_axis(m, x)[i]);
        assert_true(ix_mv_equal(m, again, 1e-12));
        d = ix_mv_dir(m, 0);
        for (int i = d.order; k % 4 == 0 && i + 1 < d.length; i++)
            ASSERT_CLOSE(d.knots[i + 1] - d.knots[i],
                         d.knots[d.order] - d.knots[d.order - 1], 1e-11);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, m);
        ix_mv_unref(ctx, again);
    }
    ix_ctx_free(ctx);
}

/* Law: the same points in the same order; the parameter moves by the Moebius
 * map t = c s / (1 + (c - 1) s). */
static void moebius_keeps_the_shape(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(92);
    ix_rand_opts o = {
        .ndirs = 1, .kinds = IX_RAND_BEZIER | IX_RAND_OPEN, .min_order = 2};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *c = ix_mv_randtest(ctx, &r, &o), *m;
        double ratio = k % 3 ? ix_rng_range(&r, 0.2, 5) : 0, q = ratio, p[18],
               x[18], dom[2];
        size_t last = ix_mv_npts(c) - 1;

        ASSERT_OK(ctx, ix_moebius(ctx, c, ratio, &m));
        if (ratio == 0) {
            ASSERT_CLOSE(ix_mv_weights(m)[0], ix_mv_weights(m)[last], 1e-13);
            q = ix_mv_rational(c)
                    ? pow(ix_mv_weights(c)[0] / ix_mv_weights(c)[last],
                          1.0 / (ix_mv_order(c, 0) - 1))
                    : 1;
        }
        if (ix_mv_rational(c))
            ASSERT_CLOSE(ix_mv_weights(m)[last], ix_mv_weights(c)[last], 1e-13);
        ix_mv_domain(c, 0, dom);
        for (int i = 0; i < 20; i++) {
            double s = i / 20.0, t = q * s / (1 + (q - 1) * s);

            s = dom[0] + (dom[1] - dom[0]) * s;
            t = dom[0] + (dom[1] - dom[0]) * t;
            ASSERT_OK(ctx, ix_mv_point(ctx, m, &s, p));
            ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, x));
            for (int a = 0; a < ix_mv_ncoords(c); a++)
                ASSERT_CLOSE(p[a], x[a], 1e-9);
        }
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

static void set_point(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double pt[4] = {2, 1, 1, 1}, bad[4] = {1, (double)NAN, 0, 0};
    ix_mv *c, *m;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){0, 0, 0}, 1, &c));
    ASSERT_OK(ctx, ix_set_point(ctx, c, 3, 3, true, pt, &m));
    for (int a = 0; a < 4; a++)
        for (size_t i = 0; i < 9; i++)
            assert_true(ix_mv_axis(m, a)[i] ==
                        (i == 3 ? pt[a] : ix_mv_axis(c, a)[i]));
    ix_mv_unref(ctx, m);
    assert_int_equal(ix_set_point(ctx, c, 9, 3, true, pt, &m), IX_EARG);
    assert_int_equal(ix_set_point(ctx, c, 0, 2, true, pt, &m), IX_EARG);
    assert_int_equal(ix_set_point(ctx, c, 0, 3, false, pt, &m), IX_EARG);
    assert_int_equal(ix_set_point(ctx, c, 0, 3, true, bad, &m), IX_EARG);
    assert_null(m);
    assert_int_equal(ix_moebius(ctx, c, -1, &m), IX_EARG);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void setup(ix_ctx *ctx, void *state)
{
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){0, 0, 0}, 1, (ix_mv **)state));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;
    ix_status st = ix_reknot(ctx, m[0], IX_PARAM_CHORD, &m[1]);

    m[2] = NULL;
    if (st == IX_OK)
        st = ix_moebius(ctx, m[0], 2, &m[2]);
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
    assert_true(ix_fault_run(&c) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reknot_keeps_points),
        cmocka_unit_test(moebius_keeps_the_shape),
        cmocka_unit_test(set_point),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
