/* t_srf_quadric.c - patches of quadrics. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* The equation's value at p and the sum of its terms' sizes. */
static double equation(const double c[10], const double p[3], double *size)
{
    const double m[10] = {
        p[0] * p[0], p[1] * p[1], p[2] * p[2], p[0] * p[1], p[0] * p[2],
        p[1] * p[2], p[0],        p[1],        p[2],        1};
    double s = 0;

    *size = 0;
    for (int i = 0; i < 10; i++) {
        s += c[i] * m[i];
        *size += fabs(c[i] * m[i]);
    }
    return s;
}

/* Law: every point satisfies the equation; the patch is no curve. */
static void check(gt *t, const double c[10])
{
    double size, p[IX_MAX_COORDS], uv[2], lo[3], hi[3];
    ix_mv *s = NULL;

    ASSERT_OK(t->ctx, ix_srf_quadric(t->ctx, c, &s));
    assert_true(ix_mv_rational(s) && !ix_mv_has_poles(s));
    for (int k = 0; k < 20; k++) {
        double e;

        uv[0] = ix_rng_unit(&t->r);
        uv[1] = ix_rng_unit(&t->r);
        gt_point(t, s, uv, p);
        e = equation(c, p, &size);
        assert_true(fabs(e) <= 1e-10 * size);
    }
    ASSERT_OK(t->ctx, ix_mv_bbox(t->ctx, s, lo, hi));
    assert_true((hi[0] - lo[0]) * (hi[1] - lo[1]) +
                    (hi[1] - lo[1]) * (hi[2] - lo[2]) +
                    (hi[2] - lo[2]) * (hi[0] - lo[0]) >
                0);
    ix_mv_unref(t->ctx, s);
}

/* c with the variables turned and moved at random: still the same kind. */
static void moved(gt *t, const double c[10], double out[10])
{
    double a = ix_rng_range(&t->r, 0, 6), b = ix_rng_range(&t->r, 0, 6);
    double r[3][3] = {{cos(a) * cos(b), -sin(a), cos(a) * sin(b)},
                      {sin(a) * cos(b), cos(a), sin(a) * sin(b)},
                      {-sin(b), 0, cos(b)}};
    double d[3], m[3][3], g[3], n[3][3] = {{0}};

    for (int i = 0; i < 3; i++)
        d[i] = ix_rng_range(&t->r, -2, 2);
    for (int i = 0; i < 3; i++) {
        m[i][i] = c[i];
        g[i] = c[6 + i];
    }
    m[0][1] = m[1][0] = c[3] / 2;
    m[0][2] = m[2][0] = c[4] / 2;
    m[1][2] = m[2][1] = c[5] / 2;
    out[9] = c[9];
    for (int i = 0; i < 3; i++) { /* x = R y + d */
        out[6 + i] = 0;
        for (int j = 0; j < 3; j++) {
            out[6 + i] += g[j] * r[j][i];
            for (int k = 0; k < 3; k++)
                out[6 + i] += 2 * d[k] * m[k][j] * r[j][i];
            for (int k = 0; k < 3; k++)
                for (int l = 0; l < 3; l++)
                    n[i][j] += r[k][i] * m[k][l] * r[l][j];
        }
        out[9] += g[i] * d[i];
        for (int j = 0; j < 3; j++)
            out[9] += d[i] * m[i][j] * d[j];
        out[i] = n[i][i];
    }
    out[3] = 2 * n[0][1];
    out[4] = 2 * n[0][2];
    out[5] = 2 * n[1][2];
}

static void test_kinds(void **state)
{
    static const double kinds[][10] = {
        {1, 2, 3, 0, 0, 0, 0, 0, 0, -4}, /* ellipsoid */
        {-1, -2, -3, 0, 0, 0, 0, 0, 0, 4},
        {1, 2, -3, 0, 0, 0, 0, 0, 0, -4},  /* one sheet */
        {1, -2, -3, 0, 0, 0, 0, 0, 0, -4}, /* two sheets */
        {1, 2, -3, 0, 0, 0, 0, 0, 0, 0},   /* cone */
        {-1, -2, 3, 0, 0, 0, 0, 0, 0, 0},
        {-1, 2, 3, 0, 0, 0, 0, 0, 0, 0},
        {1, 2, 0, 0, 0, 0, 0, 0, 1, 3}, /* paraboloids */
        {1, -2, 0, 0, 0, 0, 0, 0, 2, 1},
        {1, 2, 0, 0, 0, 0, 0, 0, 0, -1}, /* cylinders */
        {1, -2, 0, 0, 0, 0, 0, 0, 0, -1},
        {2, 0, 0, 0, 0, 0, 0, 1, 2, -1},
        {0, 0, 0, 0, 0, 0, 1, 2, 3, 4}, /* plane */
        {0, 0, 0, 1, 1, 1, 0, 0, 0, -1}};
    gt t = gt_begin(91);
    double c[10];

    (void)state;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        check(&t, kinds[k]);
        for (int n = 0; n < 5; n++) {
            moved(&t, kinds[k], c);
            check(&t, c);
        }
    }
    gt_end(&t);
}

/* Law: points of the cylinder satisfy the conic's equation; z = v height. */
static void test_cylinder(void **state)
{
    static const double conics[][6] = {{1, 0, 4, 0, 0, -1},
                                       {1, 3, 1, 1, 0, -2},
                                       {1, 2, 1, 1, 0, 0},
                                       {0, 0, 0, 1, 2, 3}};
    gt t = gt_begin(93);

    (void)state;
    for (int k = 0; k < 4; k++) {
        const double *f = conics[k];
        ix_mv *s = NULL;

        ASSERT_OK(t.ctx, ix_srf_conic_cylinder(t.ctx, f, 2.5, &s));
        for (int n = 0; n < 20; n++) {
            double uv[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)};
            double p[IX_MAX_COORDS];

            gt_point(&t, s, uv, p);
            ASSERT_CLOSE(f[0] * p[0] * p[0] + f[1] * p[0] * p[1] +
                             f[2] * p[1] * p[1] + f[3] * p[0] + f[4] * p[1] +
                             f[5],
                         0, 1e-12);
            ASSERT_CLOSE(p[2], 2.5 * uv[1], 1e-13);
        }
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    static const double none[][10] = {
        {1, 2, 3, 0, 0, 0, 0, 0, 0, 4},  {1, 2, 3, 0, 0, 0, 0, 0, 0, 0},
        {1, 2, 0, 0, 0, 0, 0, 0, 0, 1},  {1, 2, 0, 0, 0, 0, 0, 0, 0, 0},
        {1, -2, 0, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0, 0, -1},
        {1, 0, 0, 0, 0, 0, 0, 0, 0, 1},  {1, 0, 0, 0, 0, 0, 0, 0, 0, 0},
        {0, 0, 0, 0, 0, 0, 0, 0, 0, 1},  {0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
    const double bad[10] = {HUGE_VAL};
    gt t = gt_begin(92);
    ix_mv *out;

    (void)state;
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        assert_int_equal(ix_srf_quadric(t.ctx, none[k], &out), IX_EDOMAIN);
        assert_null(out);
    }
    assert_int_equal(ix_srf_quadric(t.ctx, bad, &out), IX_EARG);
    assert_int_equal(ix_srf_conic_cylinder(t.ctx, none[0], 0, &out), IX_EARG);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    (void)ctx;
    (void)f;
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double c[10] = {1, 2, 3, 0, 0, 0, 0, 0, 0, -4};

    (void)f;
    return ix_srf_quadric(ctx, c, out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_kinds), cmocka_unit_test(test_cylinder),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
