/* t_ruled_fit.c - one ruled surface near another: ruled ones come back, leaning
 * rulings are found, distances are measured again by brute force. */
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

static ix_mv *bezier2(gt *t, int nu, int nv, bool rational, const double *pts)
{
    const ix_dir d[2] = {{IX_BEZIER, nu, nu, false, NULL},
                         {IX_BEZIER, nv, nv, false, NULL}};
    ix_mv *m = NULL;

    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, rational, pts, &m));
    return m;
}

/* Control points (i, j, random height). */
static ix_mv *hills(gt *t)
{
    double pts[3][16];

    for (int k = 0; k < 16; k++) {
        pts[0][k] = k % 4;
        pts[1][k] = k / 4;
        pts[2][k] = ix_rng_range(&t->r, -1, 1);
    }
    return bezier2(t, 4, 4, false, pts[0]);
}

/* Law: what is ruled comes back, also with weights and float knots; its points
 * are at the same parameters. */
static void ruled_comes_back(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < 12; k++) {
        ix_ruled_opts o = {.dir = k % 2, .samples = 5};
        ix_mv *c[2], *s, *turned = NULL, *r = NULL;
        ix_fit_error err;

        for (int i = 0; i < 2; i++)
            c[i] = gt_random(&t, 1, 3, 0,
                             IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_FLOAT, 2);
        ASSERT_OK(t.ctx, ix_srf_ruled(t.ctx, c[0], c[1], &s));
        if (o.dir == 0) {
            ASSERT_OK(t.ctx, ix_mv_swap_dirs(t.ctx, s, 0, 1, &turned));
            ix_mv_unref(t.ctx, s);
            s = turned;
        }
        ASSERT_OK(t.ctx, ix_srf_fit_ruled(t.ctx, s, &o, &err, &r));
        assert_true(err.largest <= 1e-11);
        assert_int_equal(ix_mv_order(r, o.dir), 2);
        assert_true(ix_mv_rational(r) == ix_mv_rational(s));
        for (int i = 0; i < 20; i++) {
            double at[2] = {gt_param(&t, s, 0), gt_param(&t, s, 1)};
            double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

            gt_point(&t, s, at, p);
            gt_point(&t, r, at, q);
            gt_same(p, q, 3, TOL);
        }
        ix_mv_unref(t.ctx, r);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, c[0]);
        ix_mv_unref(t.ctx, c[1]);
    }
    gt_end(&t);
}

/* S(u, v) = C(u + 0.4 v) + v (0, 0, 3) with C(x) = (x, x^2, 0): a cylinder
 * whose rulings lean by -0.4 over its parameters. */
static ix_mv *leaning_cylinder(gt *t)
{
    const double k = 0.4;
    const double pts[3][9] = {
        {0, 0.5, 1, k / 2, (1 + k) / 2, 1 + k / 2, k, 0.5 + k, 1 + k},
        {0, 0, 1, 0, k / 2, 1 + k, k * k, k * k + k, (1 + k) * (1 + k)},
        {0, 0, 0, 1.5, 1.5, 1.5, 3, 3, 3}};

    return bezier2(t, 3, 3, false, pts[0]);
}

/* Law: with room at the ends the leaning rulings are found: a hundredth of the
 * error that is there without room, and of the size of 1. */
static void leaning_rulings(void **state)
{
    gt t = gt_begin(2);
    ix_mv *s = leaning_cylinder(&t), *r;
    ix_ruled_opts o = {.dir = 1, .samples = 9};
    ix_fit_error narrow, wide;

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_fit_ruled(t.ctx, s, &o, &narrow, &r));
    ix_mv_unref(t.ctx, r);
    o.extend = 0.4;
    ASSERT_OK(t.ctx, ix_srf_fit_ruled(t.ctx, s, &o, &wide, &r));
    print_message("rms %g without room, %g with\n", narrow.rms, wide.rms);
    assert_true(wide.rms < 1e-4);
    assert_true(wide.rms < narrow.rms / 10);
    /* independent: the true nearest points */
    for (int i = 0; i < 6; i++) {
        double at[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)};
        double p[IX_MAX_COORDS], uv[2], d;

        gt_point(&t, s, at, p);
        ASSERT_OK(t.ctx, ix_srf_nearest(t.ctx, r, p, false, uv, &d));
        assert_true(d <= 1.5 * wide.largest);
    }
    ix_mv_unref(t.ctx, r);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

/* Squared distance of p from the segment a b. */
static double from_segment(const double *p, const double *a, const double *b)
{
    double dot = 0, len = 0, sum = 0, x;

    for (int c = 0; c < 3; c++) {
        dot += (p[c] - a[c]) * (b[c] - a[c]);
        len += (b[c] - a[c]) * (b[c] - a[c]);
    }
    x = fmin(1, fmax(0, dot / len));
    for (int c = 0; c < 3; c++) {
        double d = p[c] - a[c] - x * (b[c] - a[c]);

        sum += d * d;
    }
    return sum;
}

/* Root mean square distance of 33 x 17 points of s from the nearest of 301
 * rulings (along direction 1) of r. */
static double brute(gt *t, const ix_mv *s, const ix_mv *r)
{
    enum { N = 301, MU = 33, MV = 17 };
    static double q[N][2][IX_MAX_COORDS];
    double dom[2], sum = 0;

    ix_mv_domain(r, 0, dom);
    for (int i = 0; i < 2 * N; i++) {
        double at[2] = {dom[0] + (dom[1] - dom[0]) * (i / 2) / (N - 1), i % 2};

        gt_point(t, r, at, q[i / 2][i % 2]);
    }
    for (int k = 0; k < MU * MV; k++) {
        double at[2] = {(k % MU) / (MU - 1.0), (k / MU) / (MV - 1.0)};
        double p[IX_MAX_COORDS], least = HUGE_VAL;

        gt_point(t, s, at, p);
        for (int i = 0; i < N; i++)
            least = fmin(least, from_segment(p, q[i][0], q[i][1]));
        sum += least;
    }
    return sqrt(sum / (MU * MV));
}

/* Law: never worse than the ruled surface between the sides; measured errors
 * are those of brute force up to its rulings (0.01 apart, sloping up to 3). */
static void not_worse_than_sides(void **state)
{
    gt t = gt_begin(3);

    (void)state;
    for (int k = 0; k < 2; k++) {
        ix_ruled_opts o = {.dir = 1, .samples = 8};
        ix_mv *s = hills(&t), *side[2], *plain, *r;
        double got, simple;
        ix_fit_error err;

        for (int e = 0; e < 2; e++)
            ASSERT_OK(t.ctx, ix_mv_fix(t.ctx, s, o.dir, e, &side[e]));
        ASSERT_OK(t.ctx, ix_srf_ruled(t.ctx, side[0], side[1], &plain));
        ASSERT_OK(t.ctx, ix_srf_fit_ruled(t.ctx, s, &o, &err, &r));
        got = brute(&t, s, r);
        simple = brute(&t, s, plain);
        print_message("rms %g measured, %g by brute force, sides %g\n", err.rms,
                      got, simple);
        assert_true(got <= simple);
        assert_true(err.rms <= simple);
        assert_true(fabs(got - err.rms) <= 0.01);
        assert_true(err.rms <= err.largest);
        for (int e = 0; e < 2; e++)
            ix_mv_unref(t.ctx, side[e]);
        ix_mv_unref(t.ctx, plain);
        ix_mv_unref(t.ctx, r);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

static void errors(void **state)
{
    const double pole[4][4] = {{1, -1, 1, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0}};
    gt t = gt_begin(4);
    ix_mv *s = hills(&t), *c, *bad, *out;
    ix_ruled_opts o = {.dir = 1, .samples = 10};

    (void)state;
    c = gt_random(&t, 1, 3, 0, IX_RAND_BEZIER, 3);
    assert_int_equal(ix_srf_fit_ruled(t.ctx, c, &o, NULL, &out), IX_EARG);
    ix_mv_unref(t.ctx, c);
    o.dir = 2;
    assert_int_equal(ix_srf_fit_ruled(t.ctx, s, &o, NULL, &out), IX_EARG);
    o.dir = 0;
    o.samples = 1;
    assert_int_equal(ix_srf_fit_ruled(t.ctx, s, &o, NULL, &out), IX_EARG);
    o.samples = 1001;
    assert_int_equal(ix_srf_fit_ruled(t.ctx, s, &o, NULL, &out), IX_EARG);
    o.samples = 10;
    o.extend = -0.1;
    assert_int_equal(ix_srf_fit_ruled(t.ctx, s, &o, NULL, &out), IX_EARG);
    o.extend = NAN;
    assert_int_equal(ix_srf_fit_ruled(t.ctx, s, &o, NULL, &out), IX_EARG);
    o.extend = 0;
    bad = bezier2(&t, 2, 2, true, pole[0]);
    assert_int_equal(ix_srf_fit_ruled(t.ctx, bad, &o, NULL, &out), IX_EDOMAIN);
    assert_null(out);
    ix_mv_unref(t.ctx, bad);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(5)};

    f->in[0] = leaning_cylinder(&t);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_ruled_opts o = {.dir = 0, .extend = 0.4, .samples = 2};

    return ix_srf_fit_ruled(ctx, f->in[0], &o, NULL, out);
}

static void out_of_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ruled_comes_back),
        cmocka_unit_test(leaning_rulings),
        cmocka_unit_test(not_worse_than_sides),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
