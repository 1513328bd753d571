/* t_srf_algsum.c - sums, swung products and distances over two domains. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

enum { SUM, SWUNG, VECTOR, SQUARED, KINDS };

static ix_status build_kind(ix_ctx *ctx, int kind, const ix_mv *a,
                            const ix_mv *b, ix_mv **out)
{
    if (kind == SUM)
        return ix_srf_algsum(ctx, a, b, out);
    if (kind == SWUNG)
        return ix_srf_swung(ctx, a, b, out);
    return ix_srf_distance(
        ctx, a, b, kind == VECTOR ? IX_DIST_VECTOR : IX_DIST_SQUARED, out);
}

/* The definitions. */
static void expected(int kind, const double *p, const double *q, double *r)
{
    r[0] = r[1] = r[2] = 0;
    if (kind == SWUNG) {
        r[0] = p[0] * q[0];
        r[1] = p[0] * q[1];
        r[2] = p[1];
        return;
    }
    for (int k = 0; k < 3; k++)
        if (kind == SQUARED)
            r[0] += (p[k] - q[k]) * (p[k] - q[k]);
        else
            r[k] = kind == SUM ? p[k] + q[k] : p[k] - q[k];
}

/* Law: values are those of the definition at the two points. */
static void test_values(void **state)
{
    gt t = gt_begin(31);

    (void)state;
    for (int k = 0; k < 4 * ROUNDS; k++) {
        int kind = k % KINDS, na = kind == SWUNG ? 1 : ix_rng_int(&t.r, 1, 2);
        ix_mv *a = gt_random(&t, na, ix_rng_int(&t.r, 2, 3), 0,
                             IX_RAND_ALL & ~(unsigned)IX_RAND_POWER, 1);
        ix_mv *b = gt_random(&t, 1, ix_rng_int(&t.r, 2, 3), 0, IX_RAND_ALL, 1);
        double at[3], p[IX_MAX_COORDS], q[IX_MAX_COORDS], s[IX_MAX_COORDS];
        double r[3];
        ix_mv *m = NULL;

        ASSERT_OK(t.ctx, build_kind(t.ctx, kind, a, b, &m));
        assert_int_equal(ix_mv_ndirs(m), na + 1);
        for (int d = 0; d <= na; d++)
            at[d] = gt_param(&t, m, d);
        gt_point(&t, m, at, s);
        gt_point(&t, a, at, p);
        gt_point(&t, b, at + na, q);
        expected(kind, p, q, r);
        gt_same(s, r, ix_mv_ncoords(m), TOL);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
        ix_mv_unref(t.ctx, m);
    }
    gt_end(&t);
}

/* Law: <a - b, N> with N from derivatives of the curve; zero where b's point
 * is the foot point on a. */
static void test_normals(void **state)
{
    gt t = gt_begin(32);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *a = gt_random(&t, 1, 2, 0, IX_RAND_BEZIER | IX_RAND_OPEN, 2);
        ix_mv *b = gt_random(&t, 1, 2, 0, IX_RAND_BEZIER | IX_RAND_OPEN, 2);
        double st[2], p[IX_MAX_COORDS], q[IX_MAX_COORDS], d[4];
        double v[IX_MAX_COORDS];
        ix_mv *m = NULL;

        ASSERT_OK(t.ctx, ix_srf_distance(
                             t.ctx, a, b,
                             k % 2 ? IX_DIST_NORMAL_A : IX_DIST_NORMAL_B, &m));
        for (int i = 0; i < 2; i++)
            st[i] = gt_param(&t, m, i);
        gt_point(&t, m, st, v);
        gt_point(&t, a, &st[0], p);
        gt_point(&t, b, &st[1], q);
        ASSERT_OK(t.ctx, ix_mv_curve_derivs(t.ctx, k % 2 ? a : b,
                                            k % 2 ? st[0] : st[1], 1, d));
        ASSERT_CLOSE(v[0], (p[0] - q[0]) * d[3] - (p[1] - q[1]) * d[2], 1e-9);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
        ix_mv_unref(t.ctx, m);
    }
    gt_end(&t);
}

/* Law: for a surface, N is S_v x S_u. */
static void test_surface_normal(void **state)
{
    gt t = gt_begin(33);

    (void)state;
    for (int k = 0; k < 10; k++) {
        ix_mv *s = gt_random(&t, 2, 3, k % 2 ? 1 : -1, IX_RAND_BEZIER, 2);
        ix_mv *c = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 2), *m = NULL;
        double at[3], du[3], dv[3], p[IX_MAX_COORDS], q[IX_MAX_COORDS];
        double v[IX_MAX_COORDS], e = 0;

        ASSERT_OK(t.ctx, ix_srf_distance(t.ctx, c, s, IX_DIST_NORMAL_B, &m));
        for (int i = 0; i < 3; i++)
            at[i] = gt_param(&t, m, i);
        gt_point(&t, m, at, v);
        gt_point(&t, c, at, p);
        gt_point(&t, s, at + 1, q);
        ASSERT_OK(t.ctx, ix_srf_tangent(t.ctx, s, 0, at[1], at[2], du));
        ASSERT_OK(t.ctx, ix_srf_tangent(t.ctx, s, 1, at[1], at[2], dv));
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, l = (i + 2) % 3;

            e += (p[i] - q[i]) * (dv[j] * du[l] - dv[l] * du[j]);
        }
        ASSERT_CLOSE(v[0], e, 1e-9);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, m);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(34);
    ix_mv *c = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 2);
    ix_mv *e1 = gt_random(&t, 1, 1, -1, IX_RAND_BEZIER, 2);
    ix_mv *m = gt_random(&t, 3, 2, -1, IX_RAND_BEZIER, 2), *out, *big = NULL;

    (void)state;
    assert_int_equal(ix_srf_distance(t.ctx, c, c, IX_DIST_NORMAL_A, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_distance(t.ctx, m, c, IX_DIST_NORMAL_A, &out),
                     IX_EARG);
    assert_int_equal(ix_srf_swung(t.ctx, e1, c, &out), IX_EARG);
    assert_int_equal(ix_srf_swung(t.ctx, c, m, &out), IX_EARG);
    ASSERT_OK(t.ctx, ix_mv_promote(t.ctx, m, IX_MAX_DIRS, 0, &big));
    assert_int_equal(ix_srf_algsum(t.ctx, big, c, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, e1);
    ix_mv_unref(t.ctx, m);
    ix_mv_unref(t.ctx, big);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(35)};

    f->in[0] = gt_random(&t, 1, 2, 1, IX_RAND_BEZIER, 3);
    f->in[1] = gt_random(&t, 1, 2, -1, IX_RAND_OPEN, 3);
}

static ix_status build_swung(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_swung(ctx, f->in[0], f->in[1], out);
}

static ix_status build_normal(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_distance(ctx, f->in[0], f->in[1], IX_DIST_NORMAL_B, out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build_swung};

    (void)state;
    ix_build_faults(&f);
    f.build = build_normal;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values), cmocka_unit_test(test_normals),
        cmocka_unit_test(test_surface_normal), cmocka_unit_test(test_errors),
        cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
