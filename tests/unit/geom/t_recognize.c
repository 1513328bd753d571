/* t_recognize.c - shapes that are made to be of a kind, moved arbitrarily, are
 * recognised with their parameters, and shapes that are not are told apart. */
#include "geom/recognize.h"

#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/test.h"

enum { ROUNDS = 20 };
/* Shapes of size 1 .. 10 through a motion and a rational evaluation. */
static const double EPS = 1e-10, TOL = 1e-9;

static ix_mv *make(ix_ctx *ctx, int nu, int nv, bool rational,
                   const double *pts)
{
    const ix_dir dirs[2] = {{.basis = IX_BEZIER, .order = nu, .length = nu},
                            {.basis = IX_BEZIER, .order = nv, .length = nv}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, nv ? 2 : 1, dirs, 3, rational, pts, &m));
    return m;
}

/* A random rigid motion. */
static void motion(ix_ctx *ctx, ix_rng *g, double m[16])
{
    double axis[3], t[3], tr[16];

    for (int i = 0; i < 3; i++) {
        axis[i] = ix_rng_range(g, -1, 1);
        t[i] = ix_rng_range(g, -5, 5);
    }
    ASSERT_OK(ctx, ix__mat_rotate_about(ctx, axis, ix_rng_range(g, 0, 360), m));
    ix__mat_translate(t, tr);
    ix__mat_mul(m, tr, m);
}

/* m moved; m's reference is taken over. */
static ix_mv *moved(ix_ctx *ctx, ix_mv *m, const double mat[16])
{
    ix_mv *out;

    ASSERT_OK(ctx, ix_mv_transform(ctx, m, mat, &out));
    ix_mv_unref(ctx, m);
    return out;
}

static int flag_of(ix_ctx *ctx, const ix_mv *m, ix__geom_kind kind)
{
    ix__geom_fit f;

    ASSERT_OK(ctx, ix__recognize(ctx, m, kind, EPS, &f));
    return f.flag;
}

/* Quarter turn about z, as homogeneous weights and unit positions. */
static const double W[3] = {1, 0.70710678118654757, 1};
static const double CX[3] = {1, 0.70710678118654757, 0};
static const double CY[3] = {0, 0.70710678118654757, 1};

/* The surface of a profile (w, r w, z w)[n]: direction 0 turns, 1 profile. */
static ix_mv *revolve(ix_ctx *ctx, int n, const double (*profile)[3])
{
    double pts[4 * 3 * 8];

    for (int j = 0; j < n; j++)
        for (int i = 0; i < 3; i++) {
            double *p = pts + 3 * j + i;

            p[0] = W[i] * profile[j][0];
            p[3 * n] = CX[i] * profile[j][1];
            p[6 * n] = CY[i] * profile[j][1];
            p[9 * n] = W[i] * profile[j][2];
        }
    return make(ctx, 3, n, true, pts);
}

static ix_mv *random_curve(ix_ctx *ctx, ix_rng *g, int n, double pts[24])
{
    for (int i = 0; i < 3 * n; i++)
        pts[i] = ix_rng_range(g, -3, 3);
    return make(ctx, n, 0, false, pts);
}

/* Law: an arc is circular with the moved centre and its radius, and planar;
 * a random curve is nothing; a raised line is linear. */
static void test_curves(void **state)
{
    ix_rng g = ix_rng_new(51);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double r = ix_rng_range(&g, 0.5, 4), mat[16], pts[24], c[3];
        ix__geom_fit f;
        ix_mv *m;

        motion(ctx, &g, mat);
        for (int i = 0; i < 3; i++) {
            pts[i] = W[i];
            pts[3 + i] = CX[i] * r;
            pts[6 + i] = CY[i] * r;
            pts[9 + i] = 0;
        }
        m = moved(ctx, make(ctx, 3, 0, true, pts), mat);
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_CIRCULAR, EPS, &f));
        assert_int_equal(f.flag, 1);
        ASSERT_CLOSE(f.radius, r, TOL);
        assert_true(ix__mat_point((double[3]){0, 0, 0}, mat, c));
        assert_true(ix__dist3(f.point, c) < TOL);
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_PLANAR, EPS, &f));
        assert_int_equal(f.flag, 1);
        ASSERT_CLOSE(ix__dot3(f.plane, c) + f.plane[3], 0.0, TOL);
        assert_int_equal(flag_of(ctx, m, IX_KIND_LINEAR), 0);
        ix_mv_unref(ctx, m);

        m = random_curve(ctx, &g, 5, pts);
        assert_int_equal(flag_of(ctx, m, IX_KIND_CIRCULAR), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_PLANAR), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_SPHERICAL), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_CONST), 0);
        ix_mv_unref(ctx, m);

        for (int i = 0; i < 5; i++)
            for (int j = 0; j < 3; j++)
                pts[5 * j + i] = (j + 1) * (i * i + 0.5) - j;
        m = moved(ctx, make(ctx, 5, 0, false, pts), mat);
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_LINEAR, EPS, &f));
        assert_int_equal(f.flag, 1);
        ASSERT_CLOSE(ix__len3(f.dir), 1.0, TOL);
        assert_int_equal(flag_of(ctx, m, IX_KIND_CIRCULAR), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_PLANAR), 1);
        assert_int_equal(flag_of(ctx, m, IX_KIND_CONST), 0);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: revolved profiles are surfaces of revolution about the moved z axis;
 * meridians are congruent; only the sphere is spherical. */
static void test_revolution(void **state)
{
    ix_rng g = ix_rng_new(52);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double mat[16], p[4][3], r = ix_rng_range(&g, 0.5, 3), o[3], z[3];
        double off[3];
        ix__geom_fit f;
        ix_mv *m;

        motion(ctx, &g, mat);
        for (int i = 0; i < 4; i++) {
            p[i][0] = 1;
            p[i][1] = ix_rng_range(&g, 0.5, 3);
            p[i][2] = i + ix_rng_range(&g, -0.4, 0.4);
        }
        m = moved(ctx, revolve(ctx, 4, (const double(*)[3])p), mat);
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_REVOLUTION, EPS, &f));
        assert_int_equal(f.flag, 1);
        ix__mat_point((double[3]){0, 0, 0}, mat, o);
        ix__mat_point((double[3]){0, 0, 1}, mat, z);
        ix__sub3(z, o, z);
        ASSERT_CLOSE(fabs(ix__dot3(z, f.dir)), 1.0, TOL);
        ix__sub3(f.point, o, o);
        ix__cross3(o, z, off);
        ASSERT_CLOSE(ix__len3(off), 0.0, TOL);
        assert_int_equal(flag_of(ctx, m, IX_KIND_SWEEP), 2);
        assert_int_equal(flag_of(ctx, m, IX_KIND_SPHERICAL), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_EXTRUSION), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 0);
        ix_mv_unref(ctx, m);

        for (int i = 0; i < 3; i++) { /* an eighth of a sphere, pole included */
            p[i][0] = W[i];
            p[i][1] = CX[i] * r;
            p[i][2] = CY[i] * r;
        }
        m = moved(ctx, revolve(ctx, 3, (const double(*)[3])p), mat);
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_SPHERICAL, EPS, &f));
        assert_int_equal(f.flag, 1);
        ASSERT_CLOSE(f.radius, r, TOL);
        assert_int_equal(flag_of(ctx, m, IX_KIND_REVOLUTION), 1);
        assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 0);
        ix_mv_unref(ctx, m);

        m = moved(ctx, revolve(ctx, 2, (const double(*)[3])p), mat);
        assert_int_equal(flag_of(ctx, m, IX_KIND_REVOLUTION), 1); /* a cone */
        assert_int_equal(flag_of(ctx, m, IX_KIND_RULED), 2);
        assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 2);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* c(u) + v c'(u) of a cubic. */
static ix_mv *tangent_surface(ix_ctx *ctx, const double *c)
{
    double pts[24];

    for (int j = 0; j < 3; j++) {
        const double *q = c + 4 * j;
        double d[3] = {3 * (q[1] - q[0]), 3 * (q[2] - q[1]), 3 * (q[3] - q[2])};
        double e[4] = {d[0], (d[0] + 2 * d[1]) / 3, (2 * d[1] + d[2]) / 3,
                       d[2]};

        for (int i = 0; i < 4; i++) {
            pts[8 * j + i] = q[i];
            pts[8 * j + 4 + i] = q[i] + e[i];
        }
    }
    return make(ctx, 4, 2, false, pts);
}

/* Law: extrusions, tangent surfaces and saddles are ruled; the first two are
 * developable; only the first is an extrusion, and by its vector. */
static void test_ruled(void **state)
{
    ix_rng g = ix_rng_new(53);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double c[24], pts[24], v[3];
        ix__geom_fit f;
        ix_mv *m = random_curve(ctx, &g, 4, c);

        ix_mv_unref(ctx, m);
        for (int j = 0; j < 3; j++) {
            v[j] = ix_rng_range(&g, 1, 3);
            for (int i = 0; i < 4; i++) {
                pts[8 * j + i] = c[4 * j + i];
                pts[8 * j + 4 + i] = c[4 * j + i] + v[j];
            }
        }
        m = make(ctx, 4, 2, false, pts);
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_EXTRUSION, EPS, &f));
        assert_int_equal(f.flag, 2);
        assert_true(ix__dist3(f.dir, v) < TOL);
        assert_int_equal(flag_of(ctx, m, IX_KIND_RULED), 2);
        assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 2);
        assert_int_equal(flag_of(ctx, m, IX_KIND_SWEEP), 1);
        assert_int_equal(flag_of(ctx, m, IX_KIND_PLANAR), 0);
        ix_mv_unref(ctx, m);

        m = tangent_surface(ctx, c);
        assert_int_equal(flag_of(ctx, m, IX_KIND_EXTRUSION), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_RULED), 2);
        assert_int_equal(flag_of(ctx, m, IX_KIND_REVOLUTION), 0);
        ix_mv_unref(ctx, m);

        m = make(ctx, 2, 2, false, c); /* a saddle */
        assert_int_equal(flag_of(ctx, m, IX_KIND_RULED), 1);
        assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 0);
        assert_int_equal(flag_of(ctx, m, IX_KIND_EXTRUSION), 0);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* The tangent surface of a curve without inflections; its curvature is 0 but
 * for rounding near the edge of regression, so the bound is wider. */
static void test_tangent_developable(void **state)
{
    static const double c[12] = {0, 1, 2, 3, 0, 0, 1, 3, 0, 0, 0, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = tangent_surface(ctx, c);
    ix__geom_fit f;

    (void)state;
    ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_DEVELOPABLE, 1e-6, &f));
    assert_int_equal(f.flag, 2);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Law: bumps below eps pass, bumps above do not; several spans are seen. */
static void test_tolerance(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    static const double knots[9] = {0, 0, 0, 1, 2, 3, 4, 4, 4};
    const ix_dir dir = {
        .basis = IX_BSPLINE, .order = 3, .length = 6, .knots = knots};
    double pts[18] = {0, 1, 2, 3, 4, 5};
    ix__geom_fit f;

    (void)state;
    for (int k = 0; k < 2; k++) {
        ix_mv *m;

        pts[6 + 4] = k ? 3e-3 : 3e-4; /* the curve bulges by about half */
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 3, false, pts, &m));
        ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_LINEAR, 1e-3, &f));
        assert_int_equal(f.flag, !k);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

static void test_constant(void **state)
{
    static const double p[6] = {1, 1, 2, 2, 3, 3};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = make(ctx, 2, 0, false, p);
    ix__geom_fit f;

    (void)state;
    ASSERT_OK(ctx, ix__recognize(ctx, m, IX_KIND_CONST, EPS, &f));
    assert_true(f.flag == 1 && f.point[2] == 3);
    assert_int_equal(flag_of(ctx, m, IX_KIND_LINEAR), 0);
    assert_int_equal(flag_of(ctx, m, IX_KIND_PLANAR), 1);
    assert_int_equal(flag_of(ctx, m, IX_KIND_CIRCULAR), 0);
    assert_int_equal(flag_of(ctx, m, IX_KIND_RULED), 0);
    assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 0);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Nearly a circle, a plane, a sphere, a surface of revolution, an extrusion:
 * one control point moved by 1 % spoils each. */
static void test_nearly(void **state)
{
    static const double profile[3][3] = {
        {1, 1, 0},
        {0.70710678118654757, 0.70710678118654757, 0.70710678118654757},
        {1, 0, 1}};
    static const ix__geom_kind kinds[] = {IX_KIND_SPHERICAL, IX_KIND_REVOLUTION,
                                          IX_KIND_SWEEP};
    double pts[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0.01}, moved_pt[4];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = revolve(ctx, 3, profile), *bad;

    (void)state;
    for (int k = 0; k < 3; k++)
        assert_true(flag_of(ctx, m, kinds[k]) > 0);
    for (int a = 0; a < 4; a++)
        moved_pt[a] = ix_mv_axis(m, a)[4] * (a ? 1.01 : 1);
    ASSERT_OK(ctx, ix_mv_set_point(ctx, m, 4, moved_pt, &bad));
    for (int k = 0; k < 3; k++)
        assert_int_equal(flag_of(ctx, bad, kinds[k]), 0);
    ix_mv_unref(ctx, bad);
    ix_mv_unref(ctx, m);

    m = make(ctx, 2, 2, false, pts); /* a square, one corner lifted */
    assert_int_equal(flag_of(ctx, m, IX_KIND_PLANAR), 0);
    assert_int_equal(flag_of(ctx, m, IX_KIND_EXTRUSION), 0);
    ix_mv_unref(ctx, m);
    pts[11] = 0;
    m = make(ctx, 2, 2, false, pts);
    assert_int_equal(flag_of(ctx, m, IX_KIND_PLANAR), 1);
    assert_int_equal(flag_of(ctx, m, IX_KIND_EXTRUSION), 1);
    assert_int_equal(flag_of(ctx, m, IX_KIND_SPHERICAL), 0);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* A plane region bounded by parabolas is developable, though not ruled in its
 * parameters; a curve with many spans is sampled less densely. */
static void test_odd_input(void **state)
{
    static const double pts[27] = {0, 1,  2, 0, 1.3, 2, 0, 1, 2,
                                   0, -1, 0, 1, 1.2, 1, 2, 3, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = make(ctx, 3, 3, false, pts);
    double knots[303], line[900];
    ix_dir dir = {
        .basis = IX_BSPLINE, .order = 3, .length = 300, .knots = knots};

    (void)state;
    assert_int_equal(flag_of(ctx, m, IX_KIND_RULED), 0);
    assert_int_equal(flag_of(ctx, m, IX_KIND_DEVELOPABLE), 1);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, 3, 300, knots));
    for (int i = 0; i < 900; i++)
        line[i] = (i % 300) * (1 + i / 300);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 3, false, line, &m));
    assert_int_equal(flag_of(ctx, m, IX_KIND_LINEAR), 1);
    assert_int_equal(flag_of(ctx, m, IX_KIND_CIRCULAR), 0);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void test_errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    static const double pts[8] = {1, -1, 0, 1, 0, 0, 0, 0};
    static const double pole[12] = {1, 1, 0, 0, 1, 2};
    const ix_dir dirs[3] = {{.basis = IX_BEZIER, .order = 1, .length = 1},
                            {.basis = IX_BEZIER, .order = 1, .length = 1},
                            {.basis = IX_BEZIER, .order = 1, .length = 1}};
    ix__geom_fit f;
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 3, dirs, 3, false, pts, &m));
    assert_int_equal(ix__recognize(ctx, m, IX_KIND_CONST, EPS, &f), IX_EARG);
    ix_mv_unref(ctx, m);
    m = make(ctx, 2, 0, false, pts);
    assert_int_equal(ix__recognize(ctx, m, IX_KIND_CONST, 0, &f), IX_EARG);
    assert_int_equal(ix__recognize(ctx, m, (ix__geom_kind)3, EPS, &f), IX_EARG);
    ix_mv_unref(ctx, m);
    m = make(ctx, 3, 0, true, pole); /* its end is at infinity */
    assert_int_equal(ix__recognize(ctx, m, IX_KIND_CONST, EPS, &f), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void fault_setup(ix_ctx *ctx, void *state)
{
    static const double p[3][3] = {{1, 1, 0}, {1, 2, 1}, {1, 1, 2}};

    *(ix_mv **)state = revolve(ctx, 3, p);
}

static ix_status fault_run(ix_ctx *ctx, void *state)
{
    ix__geom_fit f;

    IX_TRY(ix__recognize(ctx, *(ix_mv **)state, IX_KIND_REVOLUTION, EPS, &f));
    return ix__recognize(ctx, *(ix_mv **)state, IX_KIND_DEVELOPABLE, EPS, &f);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    ix_mv_unref(ctx, *(ix_mv **)state);
}

static void test_memory(void **state)
{
    ix_mv *m = NULL;
    ix_fault_case c = {fault_setup, fault_run, fault_teardown, &m};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_curves),
        cmocka_unit_test(test_revolution),
        cmocka_unit_test(test_ruled),
        cmocka_unit_test(test_tangent_developable),
        cmocka_unit_test(test_tolerance),
        cmocka_unit_test(test_constant),
        cmocka_unit_test(test_nearly),
        cmocka_unit_test(test_odd_input),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
