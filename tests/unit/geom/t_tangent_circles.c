/* Circles that touch two curves and closed paths of light: against closed
 * forms, against the definition, against dense search. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/distance.h"
#include "iritx/geom.h"

static void tangent(gt *t, const ix_mv *c, double u, double *p, double *d)
{
    gt_point(t, c, &u, p);
    ASSERT_OK(t->ctx, ix_tangent(t->ctx, c, u, true, d));
}

/* |C - P| = r, across the tangent; for all solutions. */
static void assert_touches(gt *t, const ix_mv *c, double u, const double *p,
                           double r)
{
    double x[IX_MAX_COORDS], d[3];

    tangent(t, c, u, x, d);
    ASSERT_CLOSE(hypot(x[0] - p[0], x[1] - p[1]), r, 1e-9);
    assert_true(fabs((x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1]) < 1e-9);
}

/* Two circles of radius 1 and 2, centres 4 apart, are touched by 8 circles of
 * radius 3.7: their centres are |1 +- 3.7| and |2 +- 3.7| away. */
static void circles(void **state)
{
    const double a[3] = {0, 0, 0}, b[3] = {4, 0, 0};
    gt t = gt_begin(1);
    ix_mv *c[2];
    ix_solutions s;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, a, 1, &c[0]));
    ASSERT_OK(t.ctx, ix_circle(t.ctx, b, 2, &c[1]));
    ASSERT_OK(t.ctx, ix_crv_tangent_circles(t.ctx, c[0], c[1], 3.7, &s));
    assert_int_equal(s.n, 8);
    assert_true(s.complete);
    for (int i = 0; i < s.n; i++) {
        assert_true(s.sol[i].certified);
        assert_touches(&t, c[0], s.sol[i].x[0], s.sol[i].x + 2, 3.7);
        assert_touches(&t, c[1], s.sol[i].x[1], s.sol[i].x + 2, 3.7);
    }
    ix_solutions_free(t.ctx, &s);
    assert_int_equal(ix_crv_tangent_circles(t.ctx, c[0], c[1], 0, &s), IX_EARG);
    assert_int_equal(ix_crv_tangent_circles(t.ctx, c[0], c[1], NAN, &s),
                     IX_EARG);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(t.ctx, c[i]);
    gt_end(&t);
}

/* Offset of c by d at u. */
static void offset(gt *t, const ix_mv *c, double u, double d, double *p)
{
    double x[IX_MAX_COORDS], v[3];

    tangent(t, c, u, x, v);
    p[0] = x[0] + d * v[1];
    p[1] = x[1] - d * v[0];
}

/* Law: as many as the crossings of densely sampled offsets to both sides. */
static int crossings(gt *t, ix_mv *const c[2], double r)
{
    enum { N = 500 };
    double p[2][N + 1][2];
    int count = 0;

    for (int side = 0; side < 4; side++) {
        for (int i = 0; i <= N; i++)
            for (int e = 0; e < 2; e++)
                offset(t, c[e], i / (double)N, side >> e & 1 ? r : -r, p[e][i]);
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                const double *a = p[0][i], *b = p[0][i + 1];
                const double *d = p[1][j], *e = p[1][j + 1];
                double s1 = (b[0] - a[0]) * (d[1] - a[1]) -
                            (b[1] - a[1]) * (d[0] - a[0]);
                double s2 = (b[0] - a[0]) * (e[1] - a[1]) -
                            (b[1] - a[1]) * (e[0] - a[0]);
                double s3 = (e[0] - d[0]) * (a[1] - d[1]) -
                            (e[1] - d[1]) * (a[0] - d[0]);
                double s4 = (e[0] - d[0]) * (b[1] - d[1]) -
                            (e[1] - d[1]) * (b[0] - d[0]);

                count += (s1 < 0) != (s2 < 0) && (s3 < 0) != (s4 < 0);
            }
    }
    return count;
}

static void random_curves(void **state)
{
    gt t = gt_begin(2);
    int all = 0;

    (void)state;
    for (int k = 0; k < 6; k++) {
        double p[2][8], r = ix_rng_range(&t.r, 0.3, 0.8);
        ix_solutions s;
        ix_mv *c[2];

        for (int e = 0; e < 2; e++) {
            for (int i = 0; i < 4; i++) {
                p[e][i] = i + ix_rng_range(&t.r, -0.3, 0.3);
                p[e][4 + i] = ix_rng_range(&t.r, -2, 2) + e;
            }
            c[e] = gt_curve(&t, 4, 4, NULL, 2, false, p[e]);
        }
        ASSERT_OK(t.ctx, ix_crv_tangent_circles(t.ctx, c[0], c[1], r, &s));
        assert_int_equal(s.n, crossings(&t, c, r));
        for (int i = 0; i < s.n; i++)
            for (int e = 0; e < 2; e++)
                assert_touches(&t, c[e], s.sol[i].x[e], s.sol[i].x + 2, r);
        all += s.n;
        ix_solutions_free(t.ctx, &s);
        ix_mv_unref(t.ctx, c[0]);
        ix_mv_unref(t.ctx, c[1]);
    }
    assert_true(all > 5);
    gt_end(&t);
}

/* Two parabolas that face each other: the axis, and no more; three sides of a
 * triangle: the path through the feet of its altitudes (Fagnano). */
static void paths_of_light(void **state)
{
    const double up[6] = {-1, 0, 1, 1, 0.2, 1},
                 low[6] = {-1, 0, 1, -1, -0.3, -1};
    const double corner[3][2] = {{0, 0}, {4, 0}, {1, 3}};
    gt t = gt_begin(3);
    ix_solutions s;
    ix_mv *c[3];

    (void)state;
    c[0] = gt_curve(&t, 3, 3, NULL, 2, false, up);
    c[1] = gt_curve(&t, 3, 3, NULL, 2, false, low);
    ASSERT_OK(t.ctx, ix_crv_ray_traps(t.ctx, 2, (const ix_mv *const *)c, &s));
    assert_int_equal(s.n, 1);
    ASSERT_CLOSE(s.sol[0].x[0], 0.5, 1e-12);
    ASSERT_CLOSE(s.sol[0].x[1], 0.5, 1e-12);
    ix_solutions_free(t.ctx, &s);
    ix_mv_unref(t.ctx, c[0]);
    ix_mv_unref(t.ctx, c[1]);
    for (int i = 0; i < 3; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % 3];
        const double p[4] = {a[0], b[0], a[1], b[1]};

        c[i] = gt_curve(&t, 2, 2, NULL, 2, false, p);
    }
    ASSERT_OK(t.ctx, ix_crv_ray_traps(t.ctx, 3, (const ix_mv *const *)c, &s));
    assert_int_equal(s.n, 1);
    for (int i = 0; i < 3; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % 3];
        const double *o = corner[(i + 2) % 3];
        double e[2] = {b[0] - a[0], b[1] - a[1]};

        ASSERT_CLOSE(s.sol[0].x[i],
                     ((o[0] - a[0]) * e[0] + (o[1] - a[1]) * e[1]) /
                         (e[0] * e[0] + e[1] * e[1]),
                     1e-9);
        ix_mv_unref(t.ctx, c[i]);
    }
    ix_solutions_free(t.ctx, &s);
    gt_end(&t);
}

static void errors(void **state)
{
    gt t = gt_begin(4);
    ix_mv *s = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 3);
    const ix_mv *two[2] = {s, s};
    ix_solutions out;

    (void)state;
    assert_int_equal(ix_crv_ray_traps(t.ctx, 1, two, &out), IX_EARG);
    assert_int_equal(ix_crv_ray_traps(t.ctx, 2, two, &out), IX_EARG);
    assert_int_equal(ix_crv_tangent_circles(t.ctx, s, s, 1, &out), IX_EARG);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {-1, 0, 1, 1, 0.2, 1}, q[6] = {-1, 0, 1, -1, -0.3, -1};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, p, &f->in[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, q, &f->in[1]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_solutions s;

    IX_TRY(ix_crv_ray_traps(ctx, 2, (const ix_mv *const *)f->in, &s));
    ix_solutions_free(ctx, &s);
    IX_TRY(ix_crv_tangent_circles(ctx, f->in[0], f->in[1], 0.3, &s));
    ix_solutions_free(ctx, &s);
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(circles),        cmocka_unit_test(random_curves),
        cmocka_unit_test(paths_of_light), cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
