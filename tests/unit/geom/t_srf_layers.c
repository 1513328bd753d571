/* t_srf_layers.c - ruled, layered, extruded and Hermite surfaces. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* Homogeneous value of a curve with given point type. */
static void hom(gt *t, const ix_mv *c, int ncoords, bool rational, double at,
                double *p)
{
    ix_mv *w = NULL;

    ASSERT_OK(t->ctx, ix_mv_coerce(t->ctx, c, ncoords, rational, &w));
    ASSERT_OK(t->ctx, ix_mv_eval(t->ctx, w, &at, p));
    ix_mv_unref(t->ctx, w);
}

/* Law: the ruled surface is (1 - v) a + v b in homogeneous coordinates, b's
 * parameter mapped affinely to a's. */
static void test_ruled(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *a = gt_random(&t, 1, 0, 0, IX_RAND_ALL, 1);
        ix_mv *b = gt_random(&t, 1, 0, 0, IX_RAND_ALL, 1), *s = NULL;
        double uv[2], p[20], q[20], r[20];

        ASSERT_OK(t.ctx, ix_srf_ruled(t.ctx, a, b, &s));
        assert_int_equal(ix_mv_order(s, 1), 2);
        uv[0] = gt_param(&t, s, 0);
        uv[1] = ix_rng_unit(&t.r);
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, s, uv, p));
        hom(&t, a, ix_mv_ncoords(s), ix_mv_rational(s), gt_map(s, 0, a, uv[0]),
            q);
        hom(&t, b, ix_mv_ncoords(s), ix_mv_rational(s), gt_map(s, 0, b, uv[0]),
            r);
        for (int i = 0; i < ix_mv_naxes(s); i++)
            ASSERT_CLOSE(p[i], (1 - uv[1]) * q[i] + uv[1] * r[i], TOL);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: Bezier inputs alone give a Bezier; a domain other than [0, 1] is kept
 * unless only one curve is a B-spline. */
static void test_ruled_domain(void **state)
{
    const double kv[4] = {2, 2, 5, 5}, pts[2] = {0, 1};
    gt t = gt_begin(2);
    ix_mv *a = gt_curve(&t, 2, 2, kv, 1, false, pts);
    ix_mv *b = gt_curve(&t, 2, 2, NULL, 1, false, pts), *s[3];
    double dom[2];

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_ruled(t.ctx, b, b, &s[0]));
    assert_int_equal(ix_mv_dir(s[0], 0).basis, IX_BEZIER);
    assert_int_equal(ix_mv_dir(s[0], 1).basis, IX_BEZIER);
    ASSERT_OK(t.ctx, ix_srf_ruled(t.ctx, a, a, &s[1]));
    ix_mv_domain(s[1], 0, dom);
    assert_true(dom[0] == 2 && dom[1] == 5);
    ASSERT_OK(t.ctx, ix_srf_ruled(t.ctx, a, b, &s[2]));
    ix_mv_domain(s[2], 0, dom);
    assert_true(dom[0] == 0 && dom[1] == 1);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(t.ctx, s[i]);
    ix_mv_unref(t.ctx, a);
    ix_mv_unref(t.ctx, b);
    gt_end(&t);
}

/* Law: at fixed u, a surface through layers is the B-spline curve in v whose
 * control points are the layers' points at u. */
static void test_layers(void **state)
{
    static const ix_kv_kind kinds[3] = {IX_KV_OPEN, IX_KV_FLOAT,
                                        IX_KV_PERIODIC};
    gt t = gt_begin(3);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        int n = ix_rng_int(&t.r, 2, 6), order = ix_rng_int(&t.r, 2, 7);
        ix_mv *c[6], *s = NULL, *across = NULL;
        double uv[2], pts[6 * 4], p[4], q[4];
        int axes;
        ix_dir d;

        for (int i = 0; i < n; i++)
            c[i] = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER | IX_RAND_OPEN, 1);
        ASSERT_OK(t.ctx, ix_srf_layers(t.ctx, n, (const ix_mv *const *)c, order,
                                       kinds[ix_rng_int(&t.r, 0, 2)], &s));
        assert_int_equal(ix_mv_order(s, 1), order < n ? order : n);
        axes = ix_mv_naxes(s);
        uv[0] = gt_param(&t, s, 0);
        uv[1] = gt_param(&t, s, 1);
        for (int i = 0; i < n; i++) {
            hom(&t, c[i], 3, false, gt_map(s, 0, c[i], uv[0]), q);
            for (int a = 0; a < axes; a++)
                pts[a * n + i] = q[a];
        }
        d = ix_mv_dir(s, 1);
        ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 1, &d, 3, false, pts, &across));
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, across, &uv[1], q));
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, s, uv, p));
        gt_same(p, q, axes, TOL);
        for (int i = 0; i < n; i++)
            ix_mv_unref(t.ctx, c[i]);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, across);
    }
    gt_end(&t);
}

/* Law: S(u, v) = c(u) + v d, whatever the point type; surfaces become
 * trivariates. */
static void test_extrude(void **state)
{
    gt t = gt_begin(4);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        int ndirs = ix_rng_int(&t.r, 1, 2);
        unsigned kinds = k % 4 ? IX_RAND_ALL & ~(unsigned)IX_RAND_POWER
                               : (unsigned)IX_RAND_POWER;
        ix_mv *c = gt_random(&t, ndirs, ix_rng_int(&t.r, 1, 4), 0, kinds, 1);
        double d[3] = {ix_rng_range(&t.r, -1, 1), ix_rng_range(&t.r, -1, 1),
                       k % 2 ? 0 : ix_rng_range(&t.r, -1, 1)};
        double at[3], p[IX_MAX_COORDS], q[IX_MAX_COORDS];
        ix_mv *s = NULL;

        ASSERT_OK(t.ctx, ix_srf_extrude(t.ctx, c, d, &s));
        for (int i = 0; i <= ndirs; i++)
            at[i] = gt_param(&t, s, i);
        gt_point(&t, s, at, p);
        gt_point(&t, c, at, q);
        for (int i = 0; i < 3; i++)
            q[i] += at[ndirs] * d[i];
        gt_same(p, q, ix_mv_ncoords(s), TOL);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: position and u-derivative at both ends are the four given curves. */
static void test_hermite(void **state)
{
    gt t = gt_begin(5);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c[4], *s = NULL;
        double v, p[IX_MAX_COORDS], q[IX_MAX_COORDS], d[2 * IX_MAX_COORDS];

        for (int i = 0; i < 4; i++)
            c[i] = gt_random(&t, 1, 3, k % 3 ? -1 : 0,
                             IX_RAND_BEZIER | IX_RAND_OPEN, 1);
        ASSERT_OK(t.ctx, ix_srf_hermite(t.ctx, c[0], c[1], c[2], c[3], &s));
        assert_int_equal(ix_mv_order(s, 0), 4);
        v = gt_param(&t, s, 1);
        for (int e = 0; e < 2; e++) {
            double at[2] = {e, v};
            ix_mv *across = NULL;

            gt_point(&t, s, at, p);
            at[1] = gt_map(s, 1, c[e], v);
            gt_point(&t, c[e], &at[1], q);
            gt_same(p, q, 3, TOL);
            ASSERT_OK(t.ctx, ix_mv_fix(t.ctx, s, 1, v, &across));
            ASSERT_OK(t.ctx, ix_mv_curve_derivs(t.ctx, across, e, 1, d));
            ix_mv_unref(t.ctx, across);
            at[1] = gt_map(s, 1, c[2 + e], v);
            gt_point(&t, c[2 + e], &at[1], q);
            gt_same(d + 3, q, 3, 1e-9); /* quotients of weights down to 0.1 */
        }
        for (int i = 0; i < 4; i++)
            ix_mv_unref(t.ctx, c[i]);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(6);
    ix_mv *c = gt_random(&t, 1, 2, -1, IX_RAND_BEZIER, 2);
    ix_mv *s = gt_random(&t, 2, 2, -1, IX_RAND_BEZIER, 2), *out;
    const ix_mv *cs[2] = {c, s}, *cc[2] = {c, c};
    const double zero[3] = {0, 0, 0}, bad[3] = {(double)NAN, 0, 0};

    (void)state;
    assert_int_equal(ix_srf_ruled(t.ctx, c, s, &out), IX_EARG);
    assert_null(out);
    assert_int_equal(ix_srf_layers(t.ctx, 1, cc, 2, IX_KV_OPEN, &out), IX_EARG);
    assert_int_equal(ix_srf_layers(t.ctx, 2, cc, 1, IX_KV_OPEN, &out), IX_EARG);
    assert_int_equal(ix_srf_layers(t.ctx, 2, cs, 2, IX_KV_OPEN, &out), IX_EARG);
    assert_int_equal(ix_srf_extrude(t.ctx, c, zero, &out), IX_EARG);
    assert_int_equal(ix_srf_extrude(t.ctx, c, bad, &out), IX_EARG);
    assert_int_equal(ix_srf_hermite(t.ctx, c, c, s, c, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make_curves(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(7)};

    for (int i = 0; i < 4; i++)
        f->in[i] = gt_random(&t, 1, 2 + i % 2, i % 2 ? 1 : -1,
                             i % 2 ? IX_RAND_OPEN : IX_RAND_BEZIER, 2);
}

static ix_status build_ruled(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_ruled(ctx, f->in[0], f->in[1], out);
}

static ix_status build_layers(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_layers(ctx, 4, (const ix_mv *const *)f->in, 3, IX_KV_PERIODIC,
                         out);
}

static ix_status build_extrude(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_extrude(ctx, f->in[1], (const double[3]){0, 1, 2}, out);
}

static ix_status build_hermite(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_hermite(ctx, f->in[0], f->in[1], f->in[2], f->in[3], out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make_curves, .build = build_ruled};

    (void)state;
    ix_build_faults(&f);
    f.build = build_layers;
    ix_build_faults(&f);
    f.build = build_extrude;
    ix_build_faults(&f);
    f.build = build_hermite;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ruled),    cmocka_unit_test(test_ruled_domain),
        cmocka_unit_test(test_layers),   cmocka_unit_test(test_extrude),
        cmocka_unit_test(test_hermite),  cmocka_unit_test(test_errors),
        cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
