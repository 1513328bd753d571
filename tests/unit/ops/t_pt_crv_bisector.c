/* The untrimmed bisector of a point and a planar curve: equal distances with
 * feet along normals, degrees of all forms, closed forms, degenerate input. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8101)

/* Distances from Q and from the foot, and that the foot is one, at t; relative
 * to the distance. Rounding: a few hundred units, times the conditions of the
 * two lines' intersection, which the sine of their angle measures. */
static double deviation(const ix_mv *c, const ix_mv *b, const double *q,
                        double t)
{
    double d[9], x[3], foot[2], r[2], dq[2], len, dist, sine;
    int nc = ix_mv_ncoords(c);

    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, d));
    if (ix_mv_point(ctx, b, &t, x) != IX_OK)
        return 0.0;
    for (int k = 0; k < 2; k++) {
        foot[k] = x[k] - d[k];
        r[k] = x[k] - q[k];
        dq[k] = d[k] - q[k];
    }
    len = hypot(foot[0], foot[1]);
    dist = hypot(r[0], r[1]);
    sine = fabs(dq[0] * d[nc + 1] - dq[1] * d[nc]) /
           (hypot(dq[0], dq[1]) * hypot(d[nc], d[nc + 1]));
    return sine * fmax(fabs(len - dist) / fmax(dist, 1.0),
                       fabs(foot[0] * d[nc] + foot[1] * d[nc + 1]) /
                           (fmax(len, 1.0) * hypot(d[nc], d[nc + 1])));
}

static void check_definition(const ix_mv *c, const ix_mv *b, const double *q,
                             double tol)
{
    double dom[2];

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i < 12; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * (i + 0.3) / 12;
        double dev = deviation(c, b, q, t);

        if (!(dev <= tol))
            fail_msg("deviation %g at %g, degree %d", dev, t, degree_of(c, 0));
    }
}

/* a d + b: [rational][form]. */
static const int degrees[2][4][2] = {{{3, -1}, {3, -1}, {3, -1}, {3, -1}},
                                     {{4, -2}, {4, -1}, {8, 0}, {5, 0}}};

/* Law: |B - Q| = |B - x|, (B - x).x' = 0 in all forms, in the degrees that the
 * header claims. */
static void definition_holds(void **state)
{
    (void)state;
    for (int i = 0; i < 120; i++) {
        crv_kind k = {1 + i % 5, 2 + i % 2, i & 4, i & 8 ? 3 : 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &rng, &k), *b;
        double q[2] = {ix_rng_range(&rng, -2, 2), ix_rng_range(&rng, -2, 2)};

        for (int form = 0; form < 4; form++) {
            const int *f = degrees[k.rational][form];
            ix_op_opts o = {(ix_degree_form)form, INT_MAX};
            ix_report rep;

            ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, q, 0.5, &o, &rep, &b));
            assert_int_equal(degree_of(b, 0), f[0] * k.degree + f[1]);
            assert_int_equal(ix_mv_ncoords(b), 2);
            assert_true(rep.residual <= 1e-8);
            check_definition(c, b, q, form == IX_FORM_NAIVE ? 1e-10 : 1e-12);
            ix_mv_unref(ctx, b);
        }
        ix_mv_unref(ctx, c);
    }
}

/* Law: B divides: (x - Q).(B - (alpha Q + (1 - alpha) x)) = 0. */
static void other_ratios(void **state)
{
    crv_kind k = {3, 2, true, 2, 0, 0};
    ix_mv *c = rand_crv(ctx, &rng, &k), *b;
    const double q[2] = {0.3, 1.7};

    (void)state;
    for (int i = -1; i <= 5; i++) {
        double alpha = i / 4.0, x[2], d[2], t = 0.7;

        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, q, alpha, NULL, NULL, &b));
        ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, x));
        ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, d));
        assert_true(
            fabs((x[0] - q[0]) * (d[0] - alpha * q[0] - (1 - alpha) * x[0]) +
                 (x[1] - q[1]) * (d[1] - alpha * q[1] - (1 - alpha) * x[1])) <
            1e-12);
        ix_mv_unref(ctx, b);
    }
    ix_mv_unref(ctx, c);
}

/* Line and focus: the parabola; Farouki and Johnstone's (8) for a circle. */
static void closed_forms(void **state)
{
    const double line[4] = {-2, 2, 0, 0}, focus[2] = {0, 1};
    const double s = sqrt(0.5), arc[9] = {1, s, 1, 1, s, 0, 0, s, 1};
    ix_mv *c = make_crv(ctx, 2, 2, NULL, false, 2, line), *b;
    double x[2];

    (void)state;
    ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, focus, 0.5, NULL, NULL, &b));
    assert_int_equal(degree_of(b, 0), 2);
    for (int i = 0; i <= 8; i++) {
        double t = i / 8.0;

        ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, x));
        ASSERT_CLOSE(x[0], 4 * t - 2, 1e-15);
        ASSERT_CLOSE(x[1], (1 + x[0] * x[0]) / 2, 1e-15);
    }
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
    c = make_crv(ctx, 3, 3, NULL, true, 2, arc);
    for (int i = 0; i < 20; i++) {
        double q[2] = {ix_rng_range(&rng, -2, 2), ix_rng_range(&rng, -2, 2)};
        double g = q[0] * q[0] + q[1] * q[1] - 1, h = g + 1;

        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, q, 0.5, NULL, NULL, &b));
        for (int j = 0; j < 5; j++) {
            double t = (j + 0.5) / 5, e;

            if (ix_mv_point(ctx, b, &t, x) != IX_OK)
                continue;
            e = (1 - q[0] * q[0]) * x[0] * x[0] +
                (1 - q[1] * q[1]) * x[1] * x[1] -
                2 * q[0] * q[1] * x[0] * x[1] +
                g * (q[0] * x[0] + q[1] * x[1]) - 0.25 * g * g;
            assert_true(fabs(e) <=
                        1e-10 * (1 + h) * (1 + x[0] * x[0] + x[1] * x[1]));
        }
        ix_mv_unref(ctx, b);
    }
    ix_mv_unref(ctx, c);
}

/* Law: it follows a curve and a point that are scaled and moved together; the
 * rounding of the moved coordinates is what may change (1e9 far: 1e-7). */
static void moved_and_scaled(void **state)
{
    static const double at[][2] = {{0, 1e-9}, {0, 1e9}, {1e6, 1}, {1e9, 1}};

    (void)state;
    for (int i = 0; i < 8; i++) {
        crv_kind k = {3, 2, i & 4, 0, 0, 1};
        ix_mv *c = rand_crv(ctx, &rng, &k), *m, *a, *b;
        const double *s = at[i & 3], q[2] = {0.4, 1.3}, t = 0.3125;
        double mat[16] = {s[1], 0, 0,    0, 0,    s[1], 0, 0,
                          0,    0, s[1], 0, s[0], s[0], 0, 1};
        double qm[2] = {q[0] * s[1] + s[0], q[1] * s[1] + s[0]}, x[2], y[2];

        ASSERT_OK(ctx, ix_mv_transform(ctx, c, mat, &m));
        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, q, 0.5, NULL, NULL, &a));
        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, m, qm, 0.5, NULL, NULL, &b));
        ASSERT_OK(ctx, ix_mv_point(ctx, a, &t, x));
        ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, y));
        for (int j = 0; j < 2; j++)
            assert_true(fabs((y[j] - s[0]) / s[1] - x[j]) <=
                        (1e-12 + 1e-13 * s[0]) * (1 + hypot(x[0], x[1])));
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, m);
        ix_mv_unref(ctx, c);
    }
}

/* A point far away, where differences cancel, and one on the curve, where the
 * definition still holds at all other parameters. */
static void nasty_points(void **state)
{
    crv_kind k = {3, 2, true, 0, 0, 0};
    const double t = 0.5, far[2] = {3e5, -2e5};
    double on[2];

    (void)state;
    for (int i = 0; i < 20; i++) {
        ix_mv *c = rand_crv(ctx, &rng, &k), *b;

        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, far, 0.5, NULL, NULL, &b));
        check_definition(c, b, far, 1e-11);
        ix_mv_unref(ctx, b);
        ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, on));
        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, on, 0.5, NULL, NULL, &b));
        check_definition(c, b, on, 1e-9);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
    }
}

/* --- errors --------------------------------------------------------------- */

static void expect(const ix_mv *c, const double *q, double alpha, ix_status st,
                   const char *text)
{
    ix_mv *b = NULL;

    assert_int_equal(ix_pt_crv_bisector(ctx, c, q, alpha, NULL, NULL, &b), st);
    assert_null(b);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

static void refused(void **state)
{
    const double line[6] = {0, 1, 3, 0.1, 1.1, 3.1},
                 dot[6] = {1, 1, 1, 2, 2, 2};
    const double on[2] = {-1, -0.9}, off[2] = {1, 2}, bad[2] = {NAN, 0};
    /* the second span runs straight at the point */
    const double kv[9] = {0, 0, 0, 1, 1, 2, 2, 2, 0};
    const double bent[10] = {0, 1, 1, 1, 1, 0, 0, 1, 2, 3}, below[2] = {1, -1};
    ix_mv *c = make_crv(ctx, 3, 3, NULL, false, 2, line), *s;
    ix_op_opts o = {(ix_degree_form)7, 0};
    ix_dir d[2] = {{IX_BEZIER, 1, 1, false, NULL},
                   {IX_BEZIER, 1, 1, false, NULL}};

    (void)state;
    expect(c, on, 0.5, IX_EDOMAIN, "straight line through the point");
    expect(c, bad, 0.5, IX_EARG, "coordinate 1 of the point is nan");
    expect(c, off, INFINITY, IX_EARG, "a ratio of inf");
    assert_int_equal(ix_pt_crv_bisector(ctx, c, off, 0.5, &o, NULL, &s),
                     IX_EARG);
    ix_mv_unref(ctx, c);
    c = make_crv(ctx, 3, 3, NULL, false, 2, dot);
    expect(c, off, 0.5, IX_EDOMAIN, "a point over [0, 1]");
    ix_mv_unref(ctx, c);
    c = make_crv(ctx, 3, 5, kv, false, 2, bent);
    expect(c, below, 0.5, IX_EDOMAIN, "over [1, 2]");
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 2, false, off, &s));
    expect(s, off, 0.5, IX_EARG, "2 directions");
    ix_mv_unref(ctx, s);
}

/* --- memory --------------------------------------------------------------- */

static void make(ix_ctx *own, ix_build_case *f)
{
    ix_rng r = ix_rng_new(36);
    crv_kind k = {2, 2, true, 2, 0, 0};

    f->in[0] = rand_crv(own, &r, &k);
}

static ix_status build(ix_ctx *own, const ix_build_case *f, ix_mv **out)
{
    const double q[2] = {0.5, 2};
    ix_op_opts opts = {IX_FORM_NAIVE, INT_MAX};
    ix_report rep;

    return ix_pt_crv_bisector(own, f->in[0], q, 0.5, &opts, &rep, out);
}

static void memory_may_fail(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition_holds), cmocka_unit_test(other_ratios),
        cmocka_unit_test(closed_forms),     cmocka_unit_test(moved_and_scaled),
        cmocka_unit_test(nasty_points),     cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
