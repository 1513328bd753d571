/* t_mv_moebius.c - Moebius reparametrisation and convex blends. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* Laws: the shape is the same, the old parameter being t = c s / r(s) with one
 * c for all s; the end weights of the first row get the ratio. */
static void test_moebius(void **state)
{
    gt t = gt_begin(61);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        int ndirs = ix_rng_int(&t.r, 1, 2),
            dir = ix_rng_int(&t.r, 0, ndirs - 1);
        ix_mv *m = gt_random(&t, ndirs, 3, k % 3 ? 1 : -1,
                             IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_PERIODIC |
                                 IX_RAND_FLOAT,
                             2);
        double ratio = k % 4 ? ix_rng_range(&t.r, 0.2, 4) : 0, dom[2], c, x;
        double at[2], q[IX_MAX_COORDS], p[IX_MAX_COORDS], w[2];
        ix_mv *r = NULL, *open = NULL;
        size_t last;

        ASSERT_OK(t.ctx, ix_mv_moebius(t.ctx, m, dir, ratio, &r));
        last = (size_t)(ix_mv_length(r, dir) - 1) *
               (dir ? (size_t)ix_mv_length(r, 0) : 1);
        w[0] = ix_mv_weights(r)[0];
        w[1] = ix_mv_weights(r)[last];
        ASSERT_CLOSE(w[1] / w[0], ratio == 0 ? 1 : ratio, 1e-12);
        ASSERT_OK(t.ctx, ix_mv_to_open(t.ctx, m, &open));
        c = 1;
        if (ix_mv_rational(open))
            c = ix_mv_weights(open)[0] / ix_mv_weights(open)[last];
        c = pow(c * (ratio == 0 ? 1 : ratio), 1.0 / (ix_mv_order(m, dir) - 1));
        for (int d = 0; d < ndirs; d++)
            at[d] = gt_param(&t, r, d);
        gt_point(&t, r, at, p);
        ix_mv_domain(m, dir, dom);
        x = (at[dir] - dom[0]) / (dom[1] - dom[0]);
        at[dir] = dom[0] + (dom[1] - dom[0]) * c * x / (1 + (c - 1) * x);
        gt_point(&t, m, at, q);
        gt_same(p, q, 3, 1e-9);
        ix_mv_unref(t.ctx, m);
        ix_mv_unref(t.ctx, r);
        ix_mv_unref(t.ctx, open);
    }
    gt_end(&t);
}

/* Law: homogeneous values blend linearly. */
static void test_morph(void **state)
{
    gt t = gt_begin(62);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *a = gt_random(&t, 0, 0, 0, IX_RAND_ALL, 1), *b = NULL, *m = NULL;
        const double mat[16] = {0, 1, 0,  0, 2, 0, 0, 0,
                                0, 0, -1, 0, 1, 2, 3, 1};
        double x = ix_rng_range(&t.r, -1, 2), at[3], p[3][20];

        ASSERT_OK(t.ctx, ix_mv_transform(t.ctx, a, mat, &b));
        ASSERT_OK(t.ctx, ix_mv_morph(t.ctx, a, b, x, &m));
        ix_mv_randparam(&t.r, a, at);
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, a, at, p[0]));
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, b, at, p[1]));
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, m, at, p[2]));
        for (int i = 0; i < ix_mv_naxes(m); i++)
            ASSERT_CLOSE(p[2][i], (1 - x) * p[0][i] + x * p[1][i], 1e-11);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
        ix_mv_unref(t.ctx, m);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    const double k1[5] = {0, 0, 1, 3, 3}, k2[5] = {0, 0, 2, 3, 3};
    gt t = gt_begin(63);
    ix_mv *a = gt_curve(&t, 2, 3, k1, 1, false, (double[3]){0, 1, 2});
    ix_mv *b = gt_curve(&t, 2, 3, k2, 1, false, (double[3]){0, 1, 2});
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 1, true, (double[4]){1, -1, 0, 1});
    ix_mv *d = gt_curve(&t, 1, 1, NULL, 1, false, (double[1]){1}), *out;

    (void)state;
    assert_int_equal(ix_mv_morph(t.ctx, a, b, 0.5, &out), IX_EARG);
    assert_int_equal(ix_mv_morph(t.ctx, a, c, 0.5, &out), IX_EARG);
    assert_int_equal(ix_mv_morph(t.ctx, a, d, 0.5, &out), IX_EARG);
    assert_int_equal(ix_mv_moebius(t.ctx, a, 1, 1, &out), IX_EARG);
    assert_int_equal(ix_mv_moebius(t.ctx, a, 0, -1, &out), IX_EARG);
    assert_int_equal(ix_mv_moebius(t.ctx, a, 0, (double)NAN, &out), IX_EARG);
    assert_int_equal(ix_mv_moebius(t.ctx, d, 0, 1, &out), IX_EARG);
    assert_int_equal(ix_mv_moebius(t.ctx, c, 0, 1, &out), IX_EDOMAIN);
    assert_null(out);
    ix_mv_unref(t.ctx, a);
    ix_mv_unref(t.ctx, b);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, d);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(64)};

    f->in[0] = gt_random(&t, 2, 2, 1, IX_RAND_PERIODIC, 2);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_mv_moebius(ctx, f->in[0], 1, 2, out);
}

static ix_status build_morph(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_mv_morph(ctx, f->in[0], f->in[0], 0.5, out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
    f.build = build_morph;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moebius), cmocka_unit_test(test_morph),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
