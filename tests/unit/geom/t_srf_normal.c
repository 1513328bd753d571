/* t_srf_normal.c - tangents, normals, normal fields and cones. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

static void cross(const double *a, const double *b, double *out)
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] -
                 a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double norm(const double *a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* Derivative of the projected surface by the curve of the other parameter. */
static void by_curve(gt *t, const ix_mv *s, int dir, const double uv[2],
                     double out[3])
{
    double d[2 * IX_MAX_COORDS];
    ix_mv *c = NULL;

    ASSERT_OK(t->ctx, ix_mv_fix(t->ctx, s, 1 - dir, uv[1 - dir], &c));
    ASSERT_OK(t->ctx, ix_mv_curve_derivs(t->ctx, c, uv[dir], 1, d));
    for (int k = 0; k < 3; k++)
        out[k] = k < ix_mv_ncoords(s) ? d[ix_mv_ncoords(s) + k] : 0;
    ix_mv_unref(t->ctx, c);
}

/* Laws: tangents are derivatives of iso-curves; the field is S_v x S_u; the
 * normal is its direction; the cone holds it. */
static void test_normals(void **state)
{
    gt t = gt_begin(41);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *s = gt_random(&t, 2, ix_rng_int(&t.r, 2, 3), 0,
                             IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_FLOAT, 2);
        ix_mv *f = NULL;
        double uv[2], du[3], dv[3], p[3], n[3], field[IX_MAX_COORDS];
        double axis[3], angle, dot = 0;

        ASSERT_OK(t.ctx, ix_srf_normal_field(t.ctx, s, &f));
        for (int i = 0; i < 2; i++)
            uv[i] = gt_param(&t, s, i);
        by_curve(&t, s, 0, uv, du);
        by_curve(&t, s, 1, uv, dv);
        for (int d = 0; d < 2; d++) {
            ASSERT_OK(t.ctx, ix_srf_tangent(t.ctx, s, d, uv[0], uv[1], p));
            gt_same(p, d ? dv : du, 3, 1e-10);
            ASSERT_OK(t.ctx, ix_srf_unit_tangent(t.ctx, s, d, uv[0], uv[1], p));
            ASSERT_CLOSE(norm(p), 1, 1e-14);
        }
        cross(dv, du, n);
        gt_point(&t, f, uv, field);
        for (int i = 0; i < 3; i++)
            assert_true(fabs(field[i] - n[i]) <= 1e-9 * norm(du) * norm(dv));
        ASSERT_OK(t.ctx, ix_srf_normal(t.ctx, s, uv[0], uv[1], p));
        for (int i = 0; i < 3; i++)
            ASSERT_CLOSE(p[i] * norm(n), n[i], 1e-9);
        ASSERT_OK(t.ctx, ix_srf_normal_cone(t.ctx, s, axis, &angle));
        for (int i = 0; i < 3; i++)
            dot += axis[i] * p[i];
        assert_true(acos(fmin(dot, 1)) <= angle + 1e-6);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, f);
    }
    gt_end(&t);
}

/* Laws: the degrees of the field are 2d - 1 and, rational, 3d. */
static void test_degrees(void **state)
{
    gt t = gt_begin(42);

    (void)state;
    for (int r = 0; r < 2; r++) {
        ix_mv *s = gt_random(&t, 2, 3, r ? 1 : -1, IX_RAND_BEZIER, 3);
        ix_mv *f = NULL;

        ASSERT_OK(t.ctx, ix_srf_normal_field(t.ctx, s, &f));
        for (int d = 0; d < 2; d++) {
            int deg = ix_mv_order(s, d) - 1;

            assert_int_equal(ix_mv_order(f, d) - 1, r ? 3 * deg : 2 * deg - 1);
        }
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, f);
    }
    gt_end(&t);
}

/* The apex of a cone and the pole of a sphere-like patch: the normal is taken
 * nearby; a surface without area has none. */
static void test_degenerate(void **state)
{
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    const double apex[12] = {0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0};
    const double line[12] = {0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0};
    gt t = gt_begin(43);
    ix_mv *s = NULL, *l = NULL, *out;
    double n[3], axis[3], angle;

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, apex, &s));
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, line, &l));
    ASSERT_OK(t.ctx, ix_srf_normal(t.ctx, s, 0.5, 0, n));
    ASSERT_CLOSE(fabs(n[2]), 1, 1e-12);
    assert_int_equal(ix_srf_normal(t.ctx, l, 0.5, 0.5, n), IX_EDOMAIN);
    assert_int_equal(ix_srf_normal_cone(t.ctx, l, axis, &angle), IX_EDOMAIN);
    assert_int_equal(ix_srf_unit_tangent(t.ctx, s, 0, 0.5, 0, n), IX_EDOMAIN);
    ix_mv_unref(t.ctx, l);
    l = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 2);
    assert_int_equal(ix_srf_normal(t.ctx, l, 0, 0, n), IX_EARG);
    assert_int_equal(ix_srf_tangent(t.ctx, s, 2, 0, 0, n), IX_EARG);
    assert_int_equal(ix_srf_normal_field(t.ctx, l, &out), IX_EARG);
    ix_mv_unref(t.ctx, s);
    s = gt_random(&t, 2, 1, -1, IX_RAND_BEZIER, 2);
    assert_int_equal(ix_srf_normal_field(t.ctx, s, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, l);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(44)};

    f->in[0] = gt_random(&t, 2, 2, 1, IX_RAND_BEZIER, 2);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    double axis[3], angle;
    ix_status st = ix_srf_normal_cone(ctx, f->in[0], axis, &angle);

    return st == IX_OK ? ix_srf_normal_field(ctx, f->in[0], out) : st;
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
        cmocka_unit_test(test_normals), cmocka_unit_test(test_degrees),
        cmocka_unit_test(test_degenerate), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
