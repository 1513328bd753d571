/* Joining end to end, compatible representations, segments to points. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(17)

static ix_mv *bezier2(int order, const double *pts)
{
    const ix_dir dir = {IX_BEZIER, order, order, false, NULL};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, pts, &m));
    return m;
}

static void assert_knots(const ix_mv *m, int n, const double *want)
{
    assert_int_equal(ix_mv_nknots(m, 0), n);
    for (int i = 0; i < n; i++)
        ASSERT_CLOSE(ix_mv_dir(m, 0).knots[i], want[i], 1e-14);
}

static void assert_points(const ix_mv *m, int n, const double *want)
{
    assert_int_equal(ix_mv_npts(m) * (size_t)ix_mv_naxes(m), n);
    for (int i = 0; i < n; i++)
        ASSERT_CLOSE(ix_mv_axis(m, 0)[i], want[i], 1e-15);
}

/* The representations that spec/model 12 gives, for two parabolas. */
static void joints_of_curves(void **state)
{
    const double pa[] = {0, 1, 2, 0, 1, 0}, pb[] = {3, 4, 5, 0, 1, 0};
    const double s = 2 / sqrt(32.0);
    const double bridge[] = {0, 0, 0, 1, 1, 1 + s, 1 + s, 2 + s, 2 + s, 2 + s};
    const double jump[] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
    const double shared[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double points[] = {0, 1, 2, 2.5, 3, 4, 5, 0, 1, 0, 0, 0, 1, 0};
    ix_mv *a = bezier2(3, pa), *b = bezier2(3, pb), *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_merge(ctx, a, b, 0, IX_JOIN_BRIDGE, &m));
    assert_knots(m, 10, bridge);
    assert_points(m, 14, points);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_merge(ctx, a, b, 0, IX_JOIN_JUMP, &m));
    assert_knots(m, 9, jump);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_merge(ctx, a, b, 0, IX_JOIN_SHARED, &m));
    assert_knots(m, 8, shared);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

static void segments_to_points(void **state)
{
    const double line[] = {0, 1, 0, 0}, third[] = {1, 2}, fourth[] = {0, 2};
    const double knots[] = {0, 0, 1, 3, 4, 4};
    const double square[] = {0, 1, 1, 0, 0, 0, 2, 2};
    const double para[] = {0, 1, 2, 0, 1, 0}, before[] = {-1, 0};
    const double s = -1 / sqrt(8.0);
    const double left[] = {s, s, s, 0, 0, 1, 1, 1};
    const double points[] = {-1, -0.5, 0, 1, 2, 0, 0, 0, 1, 0};
    ix_mv *a = bezier2(2, line), *b, *c;

    (void)state;
    ASSERT_OK(ctx, ix_mv_add_point(ctx, a, third, false, &b));
    ASSERT_OK(ctx, ix_mv_add_point(ctx, b, fourth, false, &c));
    assert_knots(c, 6, knots);
    assert_points(c, 8, square);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
    a = bezier2(3, para);
    ASSERT_OK(ctx, ix_mv_add_point(ctx, a, before, true, &b));
    assert_knots(b, 8, left);
    assert_points(b, 10, points);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* Law: the halves of a split join to the same map. */
static void merge_undoes_split(void **state)
{
    (void)state;
    for (int k = 0; k < 100; k++) {
        ix_rand_opts o = {.min_order = 2};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *half[2], *b, *r;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        double dom[2], t;

        ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
        ix_mv_domain(b, dir, dom);
        t = dom[0] + (dom[1] - dom[0]) * ix_rng_range(&rng, 0.1, 0.9);
        ASSERT_OK(ctx, ix_mv_split(ctx, b, dir, t, half));
        ASSERT_OK(ctx,
                  ix_mv_merge(ctx, half[0], half[1], dir, IX_JOIN_SHARED, &r));
        ix_mv_assert_same(ctx, &rng, m, r, 2e-14);
        ix_mv_unref(ctx, half[0]);
        ix_mv_unref(ctx, half[1]);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
        ix_mv_unref(ctx, r);
    }
}

/* Law: a shared joint keeps both shapes even if b carries another common
 * factor in its homogeneous points. */
static void shared_joint_scales_weights(void **state)
{
    const ix_dir dir = {IX_BEZIER, 2, 2, false, NULL};
    const double pa[] = {1, 2, 1, 4}, pb[] = {1, 3, 2, 9}; /* w, w x */
    double t = 1.5, want, got;
    ix_mv *a, *b, *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, pa, &a));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, pb, &b));
    ASSERT_OK(ctx, ix_mv_merge(ctx, a, b, 0, IX_JOIN_SHARED, &m));
    ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, &got));
    t = 0.5;
    ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, &want));
    ASSERT_CLOSE(got, want, 1e-15);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* Law: after making compatible, all that was asked for is equal, and a is the
 * same map; b too, seen over a's domain. */
static void compatible_pairs(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_ALL};

    (void)state;
    for (int k = 0; k < 150; k++) {
        ix_mv *a, *b, *ca, *cb;

        o.ndirs = ix_rng_int(&rng, 1, 3);
        a = ix_mv_randtest(ctx, &rng, &o);
        b = ix_mv_randtest(ctx, &rng, &o);
        ASSERT_OK(ctx, ix_mv_compatible(ctx, a, b, IX_SAME_ALL, &ca, &cb));
        assert_int_equal(ix_mv_naxes(ca), ix_mv_naxes(cb));
        assert_true(ix_mv_rational(ca) == ix_mv_rational(cb));
        for (int d = 0; d < o.ndirs; d++) {
            ix_dir da = ix_mv_dir(ca, d), db = ix_mv_dir(cb, d);

            assert_int_equal(da.basis, db.basis);
            assert_int_equal(da.order, db.order);
            assert_int_equal(da.length, db.length);
            for (int i = 0; i < ix_knots_count(&da); i++)
                assert_true(da.knots[i] == db.knots[i]);
        }
        for (int i = 0; i < 6; i++) {
            double t[IX_MAX_DIRS], s[IX_MAX_DIRS], v[19], w[19];

            for (int d = 0; d < o.ndirs; d++) {
                double x = ix_rng_unit(&rng), da[2], db[2];

                ix_mv_domain(ca, d, da);
                ix_mv_domain(b, d, db);
                t[d] = da[0] + x * (da[1] - da[0]);
                s[d] = db[0] + x * (db[1] - db[0]);
            }
            ASSERT_OK(ctx, ix_mv_point(ctx, ca, t, v));
            ASSERT_OK(ctx, ix_mv_point(ctx, a, t, w));
            for (int c = 0; c < ix_mv_ncoords(a); c++)
                ASSERT_CLOSE(v[c], w[c], 1e-11); /* raised by up to 5 */
            ASSERT_OK(ctx, ix_mv_point(ctx, cb, t, v));
            ASSERT_OK(ctx, ix_mv_point(ctx, b, s, w));
            for (int c = 0; c < ix_mv_ncoords(b); c++)
                ASSERT_CLOSE(v[c], w[c], 1e-11);
        }
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, ca);
        ix_mv_unref(ctx, cb);
    }
}

/* What spec/model 5 does to knots of two domains. */
static void compatible_knots(void **state)
{
    const double ka[] = {0, 0, 0, 1, 2, 2, 2}, kb[] = {0, 0, 0, 1, 4, 4, 4};
    const double pa[] = {0, 1, 3, 2}, pb[] = {0, 4, 3, 2};
    const double knots[] = {0, 0, 0, 0.5, 1, 2, 2, 2};
    const double wa[] = {0, 0.5, 1.5, 3, 2};
    const double wb[] = {0, 4, 3.5, 8.0 / 3, 2};
    ix_dir da = {IX_BSPLINE, 3, 4, false, ka},
           db = {IX_BSPLINE, 3, 4, false, kb};
    ix_mv *a, *b, *ca, *cb;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &da, 1, false, pa, &a));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &db, 1, false, pb, &b));
    ASSERT_OK(ctx, ix_mv_compatible(ctx, a, b, IX_SAME_ALL, &ca, &cb));
    assert_knots(ca, 8, knots);
    assert_knots(cb, 8, knots);
    assert_points(ca, 5, wa);
    assert_points(cb, 5, wb);
    ix_mv_unref(ctx, ca);
    ix_mv_unref(ctx, cb);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

static void errors(void **state)
{
    ix_rand_opts one = {.ndirs = 1, .ncoords = 2, .rational = -1},
                 two = {.ndirs = 2};
    ix_mv *a = ix_mv_randtest(ctx, &rng, &one);
    ix_mv *b = ix_mv_randtest(ctx, &rng, &two), *m, *n;
    double p[19] = {(double)NAN};

    (void)state;
    assert_int_equal(ix_mv_merge(ctx, a, a, 1, IX_JOIN_JUMP, &m), IX_EARG);
    assert_null(m);
    assert_int_equal(ix_mv_merge(ctx, a, b, 0, IX_JOIN_JUMP, &m), IX_EARG);
    assert_int_equal(ix_mv_compatible(ctx, a, b, IX_SAME_ALL, &m, &n), IX_EARG);
    assert_int_equal(ix_mv_add_point(ctx, b, p, true, &m), IX_EARG);
    assert_int_equal(ix_mv_add_point(ctx, a, p, true, &m), IX_EARG);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joints_of_curves),
        cmocka_unit_test(segments_to_points),
        cmocka_unit_test(merge_undoes_split),
        cmocka_unit_test(shared_joint_scales_weights),
        cmocka_unit_test(compatible_pairs),
        cmocka_unit_test(compatible_knots),
        cmocka_unit_test(errors),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
