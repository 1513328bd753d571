/* Laws of the tessellator: every point of a triangle or segment is within the
 * tolerance of the surface or curve at the same parameters, measured on dense
 * samples; closed surfaces have no cracks; poles are left out. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "mv/tessellate.h"

IX_TEST_FIXTURE(0x7e55e11a7eu)

/* Rounding of evaluation on both sides, relative to the tolerance: these tests
 * use tolerances above 1e-6 of the size. */
#define SLACK 1e-6

static double distance(const double *a, const double *b)
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* The point of m at t, three coordinates; near jumps the side of the triangle
 * counts, so t is drawn towards the middle mid of it. */
static void point_at(const ix_mv *m, const double *t, const double *mid,
                     double *out)
{
    double v[IX_MAX_COORDS], q[2];

    for (int d = 0; d < ix_mv_ndirs(m); d++)
        q[d] = t[d] + 1e-12 * (mid[d] - t[d]);
    ASSERT_OK(ctx, ix_mv_point(ctx, m, q, v));
    for (int c = 0; c < 3; c++)
        out[c] = c < ix_mv_ncoords(m) ? v[c] : 0;
}

/* The error at weights w[3] of triangle i. */
static double error_at(const ix_mv *m, const ix__mesh *g, size_t i,
                       const double *w)
{
    double x[3] = {0}, uv[2] = {0}, mid[2] = {0}, y[3];

    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++) {
            size_t v = g->tri[i][k];

            x[c] += w[k] * g->xyz[3 * v + (size_t)c];
            if (c < 2) {
                uv[c] += w[k] * g->uv[2 * v + (size_t)c];
                mid[c] += g->uv[2 * v + (size_t)c] / 3;
            }
        }
    point_at(m, uv, mid, y);
    return distance(x, y);
}

/* The largest error, on some of the triangles. */
static double measured(const ix_mv *m, const ix__mesh *g)
{
    size_t step = 1 + g->ntris / 400;
    double most = 0;

    for (size_t i = 0; i < g->ntris; i += step)
        for (int a = 0; a <= 4; a++)
            for (int b = 0; a + b <= 4; b++) {
                const double w[3] = {a / 4., b / 4., (4 - a - b) / 4.};

                most = fmax(most, error_at(m, g, i, w));
            }
    return most;
}

static void test_random_surfaces(void **state)
{
    const ix_rand_opts o = {.ndirs = 2, .ncoords = 3, .max_knots = 3};

    (void)state;
    for (int i = 0; i < 25; i++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        double tol = pow(10, -ix_rng_range(&rng, 0, 2));
        ix__mesh g;

        ASSERT_OK(ctx, ix__mesh_of_srf(ctx, m, tol, &g));
        if (g.ntris > 0)
            assert_true(measured(m, &g) <= tol * (1 + SLACK));
        ix__mesh_free(ctx, &g);
        ix_mv_unref(ctx, m);
    }
}

static void test_random_curves(void **state)
{
    const ix_rand_opts o = {.ndirs = 1, .ncoords = 3};

    (void)state;
    for (int i = 0; i < 40; i++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        double tol = pow(10, -ix_rng_range(&rng, 0, 5));
        ix__lines l;

        ASSERT_OK(ctx, ix__lines_of_crv(ctx, m, tol, &l));
        for (size_t s = 0; s < l.nlines; s++)
            for (size_t k = l.start[s]; k + 1 < l.start[s + 1]; k++) {
                double mid = (l.t[k] + l.t[k + 1]) / 2, y[3], x[3];

                for (int c = 0; c < 3; c++)
                    x[c] = (l.xyz[3 * k + (size_t)c] +
                            l.xyz[3 * k + 3 + (size_t)c]) /
                           2;
                point_at(m, &mid, &mid, y);
                assert_true(distance(x, y) <= tol * (1 + SLACK));
            }
        ix__lines_free(ctx, &l);
        ix_mv_unref(ctx, m);
    }
}

/* A Bezier surface or curve with the given points, weight first. */
static ix_mv *bezier(int ndirs, int o0, int o1, const double *pts)
{
    const ix_dir d[2] = {{IX_BEZIER, o0, o0, false, NULL},
                         {IX_BEZIER, o1, o1, false, NULL}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, d, 3, true, pts, &m));
    return m;
}

/* The quarter circle: a chord of angle a is 1 - cos(a/2) off. */
static void test_circle(void **state)
{
    const double h = sqrt(.5);
    const double pts[12] = {1, h, 1, 1, h, 0, 0, h, 1, 0, 0, 0};
    ix_mv *m = bezier(1, 3, 1, pts);

    (void)state;
    for (double tol = .1; tol > 1e-7; tol /= 10) {
        ix__lines l;
        double most = 0, least;

        ASSERT_OK(ctx, ix__lines_of_crv(ctx, m, tol, &l));
        assert_int_equal(l.nlines, 1);
        for (size_t k = 0; k + 1 < l.npts; k++) {
            double a = distance(l.xyz + 3 * k, l.xyz + 3 * k + 3) / 2;

            most = fmax(most, 1 - sqrt(1 - a * a));
        }
        assert_true(most <= tol);
        /* and not many more points than the least number */
        least = acos(-1.) / 2 / (2 * acos(1 - tol));
        assert_true((double)l.npts <= 3 + 2 * least);
        ix__lines_free(ctx, &l);
    }
    ix_mv_unref(ctx, m);
}

/* An eighth of a sphere: one corner is a pole of the parametrisation. */
static void test_sphere(void **state)
{
    const double h = sqrt(.5);
    const double c[3][3] = {{1, 1, 0}, {h, h, h}, {1, 0, 1}}; /* w x y */
    double pts[36];
    ix_mv *m;

    (void)state;
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++) {
            int k = 3 * j + i;

            pts[k] = c[i][0] * c[j][0];
            pts[9 + k] = c[i][1] * c[j][1];
            pts[18 + k] = c[i][2] * c[j][1];
            pts[27 + k] = c[i][0] * c[j][2];
        }
    m = bezier(2, 3, 3, pts);
    for (double tol = .1; tol > 1e-4; tol /= 10) {
        double depth = 0;
        ix__mesh g;

        ASSERT_OK(ctx, ix__mesh_of_srf(ctx, m, tol, &g));
        for (size_t i = 0; i < g.ntris; i++) {
            double x[3] = {0};

            for (int k = 0; k < 3; k++)
                for (int a = 0; a < 3; a++)
                    x[a] += g.xyz[3 * g.tri[i][k] + (size_t)a] / 3;
            depth = fmax(depth,
                         1 - sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
        }
        assert_true(depth <= tol);
        assert_true(measured(m, &g) <= tol * (1 + SLACK));
        ix__mesh_free(ctx, &g);
    }
    ix_mv_unref(ctx, m);
}

/* Inner edges belong to two triangles, in opposite senses. */
static void test_watertight(void **state)
{
    const ix_rand_opts o = {.ndirs = 2,
                            .ncoords = 3,
                            .kinds = IX_RAND_OPEN,
                            .min_order = 2,
                            .max_knots = 2};

    (void)state;
    for (int i = 0; i < 10; i++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        size_t edges = 0, nb = 0;
        ix__mesh g;

        ASSERT_OK(ctx, ix__mesh_of_srf(ctx, m, .3, &g));
        /* Euler: a disk has v - e + f = 1, with 2 e = 3 f + border */
        for (size_t v = 0; v < g.nverts; v++) {
            double d0[2], d1[2];

            ix_mv_domain(m, 0, d0);
            ix_mv_domain(m, 1, d1);
            nb += g.uv[2 * v] == d0[0] || g.uv[2 * v] == d0[1] ||
                  g.uv[2 * v + 1] == d1[0] || g.uv[2 * v + 1] == d1[1];
        }
        edges = (3 * g.ntris + nb) / 2;
        assert_int_equal(g.nverts + g.ntris, edges + 1);
        ix__mesh_free(ctx, &g);
        ix_mv_unref(ctx, m);
    }
}

/* x = 1 / (t - 1/2): two branches, neither crossing the pole. */
static void test_pole(void **state)
{
    const double pts[8] = {-.5, .5, 1, 1, 0, 0, 0, 0};
    ix_mv *m = bezier(1, 2, 1, pts);
    ix__lines l;

    (void)state;
    ASSERT_OK(ctx, ix__lines_of_crv(ctx, m, .01, &l));
    assert_int_equal(l.nlines, 2);
    assert_true(l.nleft > 0);
    assert_true(l.t[l.start[1] - 1] < .5 && l.t[l.start[1]] > .5);
    for (size_t k = 0; k < l.npts; k++)
        assert_true(fabs(l.xyz[3 * k]) <= 2 * 64 + 1);
    ix__lines_free(ctx, &l);
    ix_mv_unref(ctx, m);
}

static void test_errors(void **state)
{
    const double pts[8] = {1, 1, 0, 1, 0, 0, 0, 0};
    const double bent[12] = {1, 1, 1, 0, 1, 2, 0, 1, 0, 0, 0, 0};
    ix_mv *m = bezier(1, 2, 1, pts), *c = bezier(1, 3, 1, bent);
    ix__lines l;
    ix__mesh g;

    (void)state;
    assert_int_equal(ix__mesh_of_srf(ctx, m, 1, &g), IX_EARG);
    assert_int_equal(ix__lines_of_crv(ctx, m, 0, &l), IX_EARG);
    assert_int_equal(ix__lines_of_crv(ctx, m, NAN, &l), IX_EARG);
    assert_int_equal(ix__lines_of_crv(ctx, c, 1e-30, &l), IX_EUNABLE);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, c);
}

/* --- every allocation fails ------------------------------------------- */

typedef struct {
    ix_mv *crv, *srf;
    ix__lines l;
    ix__mesh g;
} inputs;

static void make(ix_ctx *c, void *state)
{
    const ix_rand_opts o = {.ndirs = 1, .ncoords = 3, .min_order = 3};
    const ix_rand_opts o2 = {.ndirs = 2,
                             .ncoords = 3,
                             .kinds = IX_RAND_OPEN,
                             .min_order = 3,
                             .rational = 1};
    ix_rng r = ix_rng_new(7);
    inputs *in = state;

    in->crv = ix_mv_randtest(c, &r, &o);
    in->srf = ix_mv_randtest(c, &r, &o2);
}

static ix_status work(ix_ctx *c, void *state)
{
    inputs *in = state;

    IX_TRY(ix__lines_of_crv(c, in->crv, .01, &in->l));
    return ix__mesh_of_srf(c, in->srf, .02, &in->g);
}

static void drop(ix_ctx *c, void *state)
{
    inputs *in = state;

    ix__lines_free(c, &in->l);
    ix__mesh_free(c, &in->g);
    ix_mv_unref(c, in->crv);
    ix_mv_unref(c, in->srf);
    *in = (inputs){0};
}

static void test_faults(void **state)
{
    inputs in = {0};
    const ix_fault_case c = {make, work, drop, &in};

    (void)state;
    assert_true(ix_fault_run(&c) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_surfaces),
        cmocka_unit_test(test_random_curves),
        cmocka_unit_test(test_circle),
        cmocka_unit_test(test_sphere),
        cmocka_unit_test(test_watertight),
        cmocka_unit_test(test_pole),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_faults),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
