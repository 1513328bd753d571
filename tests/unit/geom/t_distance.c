/* Distances, tangents, inclusion and intersections against dense sampling and
 * against what they are defined by. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "harness/test.h"
#include "iritx/contour.h"
#include "iritx/distance.h"

/* A random B-spline curve of n points and order k, rational on request. */
static ix_mv *curve(ix_ctx *ctx, ix_rng *g, int order, int n, int ncoords,
                    bool rational)
{
    double pts[4 * 32], knots[64];
    ix_dir d = {
        .basis = IX_BSPLINE, .order = order, .length = n, .knots = knots};
    ix_mv *m;

    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, order, n, knots));
    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(g, 0.5, 2) : 1;

        if (rational)
            pts[i] = w;
        for (int k = 0; k < ncoords; k++)
            pts[(k + rational) * n + i] = w * ix_rng_range(g, -1, 1);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, ncoords, rational, pts, &m));
    return m;
}

static double dist(const double *a, const double *b, int n)
{
    double s = 0;

    for (int k = 0; k < n; k++)
        s += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(s);
}

/* Law: no sample of the curve is nearer than the nearest point, which is one;
 * at every foot (C - p) . C' = 0, 1e-11 of the sizes of both. */
static void nearest_point(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(11);

    (void)state;
    for (int round = 0; round < 40; round++) {
        int dim = 2 + round % 2;
        ix_mv *c = curve(ctx, &g, 4, 9, dim, round % 3 == 0);
        double p[3] = {0, 0, 0}, t, d, x[2][3];
        ix_root *r;
        int n;

        for (int k = 0; k < dim; k++)
            p[k] = ix_rng_range(&g, -1.5, 1.5);
        for (int far = 0; far < 2; far++) {
            ASSERT_OK(ctx, ix_crv_nearest(ctx, c, p, NULL, far != 0, &t, &d));
            ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, x[0]));
            ASSERT_CLOSE(dist(x[0], p, dim), d, 1e-14);
            for (int i = 0; i <= 500; i++) {
                double s = i / 500.0, e;

                ASSERT_OK(ctx, ix_mv_point(ctx, c, &s, x[0]));
                e = dist(x[0], p, dim);
                assert_true(far ? e <= d + 1e-13 : e >= d - 1e-13);
            }
        }
        ASSERT_OK(ctx, ix_crv_feet(ctx, c, p, NULL, &r, &n));
        for (int i = 0; i < n; i++) {
            double s = 0, a = 0, b = 0;

            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, r[i].t, 1, &x[0][0]));
            for (int k = 0; k < dim; k++) {
                double u = (&x[0][0])[k] - p[k], v = (&x[0][0])[dim + k];

                s += u * v;
                a += u * u;
                b += v * v;
            }
            assert_true(fabs(s) <= 1e-11 * (sqrt(a * b) + b));
        }
        ix_roots_free(ctx, r, n);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* The nearest point to a line against samples of the distance to it. */
static void nearest_to_line(void **state)
{
    const double dir[3] = {1, 2, -0.5};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(12);

    (void)state;
    for (int round = 0; round < 20; round++) {
        ix_mv *c = curve(ctx, &g, 4, 8, 3, round % 2 == 0);
        double p[3] = {0.1, -0.2, 0.3}, t, d, x[3];

        ASSERT_OK(ctx, ix_crv_nearest(ctx, c, p, dir, false, &t, &d));
        for (int i = 0; i <= 400; i++) {
            double s = i / 400.0, q[3], l = 0;

            ASSERT_OK(ctx, ix_mv_point(ctx, c, &s, x));
            for (int k = 0; k < 3; k++)
                l += (x[k] - p[k]) * dir[k] / 5.25;
            for (int k = 0; k < 3; k++)
                q[k] = p[k] + l * dir[k];
            assert_true(dist(x, q, 3) >= d - 1e-13);
        }
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Every tangent from p passes through it; between two roots the side on which
 * p lies does not change (sampled). */
static void tangents(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(13);

    (void)state;
    for (int round = 0; round < 30; round++) {
        ix_mv *c = curve(ctx, &g, 4, 8, 2, round % 2 == 0);
        double p[3] = {ix_rng_range(&g, -2, 2), ix_rng_range(&g, -2, 2), 0};
        int n, changes = 0, last = 0;
        double x[4];
        ix_root *r;

        ASSERT_OK(ctx, ix_crv_tangents_from(ctx, c, p, &r, &n));
        for (int i = 0; i <= 4000; i++) {
            double s, t = i / 4000.0;

            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, x));
            s = (x[0] - p[0]) * x[3] - (x[1] - p[1]) * x[2];
            if (last && (s > 0) != (last > 0))
                changes++;
            last = s > 0 ? 1 : -1;
        }
        assert_true(n >= changes && (n - changes) % 2 == 0);
        ix_roots_free(ctx, r, n);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Inside a star-shaped closed curve: known from the radius. */
static void encloses(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(14);
    double pts[2 * 13];
    ix_dir d = {.basis = IX_BSPLINE, .order = 2, .length = 13};
    double knots[15], p[3] = {0, 0, 0};
    ix_mv *c;
    int where;

    (void)state;
    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, 2, 13, knots));
    d.knots = knots;
    for (int i = 0; i < 13; i++) {
        pts[i] = cos(i * acos(-1.0) / 6);
        pts[13 + i] = sin(i * acos(-1.0) / 6);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &c));
    for (int i = 0; i < 300; i++) {
        double r = ix_rng_range(&g, 0, 2), a = ix_rng_range(&g, 0, 7);

        p[0] = r * cos(a);
        p[1] = i % 10 ? r * sin(a) : 0; /* also through the vertices */
        r = hypot(p[0], p[1]);
        if (r > 0.95 && r < 1.01)
            continue; /* between the polygon's in- and circumcircle */
        ASSERT_OK(ctx, ix_crv_encloses(ctx, c, p, 1e-9, &where));
        assert_int_equal(where, r < 1 ? 1 : -1);
    }
    p[0] = 1;
    p[1] = 0;
    ASSERT_OK(ctx, ix_crv_encloses(ctx, c, p, 1e-9, &where));
    assert_int_equal(where, 0);
    ix_mv_unref(ctx, c);
    c = curve(ctx, &g, 3, 5, 2, false);
    assert_int_equal(ix_crv_encloses(ctx, c, p, 1e-9, &where), IX_EDOMAIN);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Crossings of the control-free kind: polylines of samples, counted; each
 * solution satisfies both curves to rounding and is certified. */
static void curves_meet(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(15);
    long total = 0;

    (void)state;
    for (int round = 0; round < 20; round++) {
        ix_mv *a = curve(ctx, &g, 4, 8, 2, round % 2 == 0);
        ix_mv *b = curve(ctx, &g, 3, 7, 2, round % 3 == 0);
        enum { N = 400 };
        static double pa[N + 1][2], pb[N + 1][2];
        ix_solutions s;
        int crossings = 0;

        ASSERT_OK(ctx, ix_crv_crv_meet(ctx, a, b, NULL, &s));
        for (int i = 0; i < s.n; i++) {
            double x[2], y[2];

            ASSERT_OK(ctx, ix_mv_point(ctx, a, &s.sol[i].x[0], x));
            ASSERT_OK(ctx, ix_mv_point(ctx, b, &s.sol[i].x[1], y));
            assert_true(dist(x, y, 2) < 1e-13);
            assert_true(s.sol[i].certified);
        }
        for (int i = 0; i <= N; i++) {
            double t = (double)i / N;

            ASSERT_OK(ctx, ix_mv_point(ctx, a, &t, pa[i]));
            ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, pb[i]));
        }
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                double ux = pa[i + 1][0] - pa[i][0],
                       uy = pa[i + 1][1] - pa[i][1];
                double vx = pb[j + 1][0] - pb[j][0],
                       vy = pb[j + 1][1] - pb[j][1];
                double wx = pb[j][0] - pa[i][0], wy = pb[j][1] - pa[i][1];
                double det = ux * vy - uy * vx;
                double p = (wx * vy - wy * vx) / det,
                       q = (wx * uy - wy * ux) / det;

                crossings += p >= 0 && p < 1 && q >= 0 && q < 1;
            }
        /* two crossings closer than a chord are not seen by the samples */
        assert_true(s.n >= crossings && (s.n - crossings) % 2 == 0);
        total += s.n;
        ix_solutions_free(ctx, &s);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    print_message("# %ld intersections\n", total);
    ix_ctx_free(ctx);
}

/* Self-intersections against crossings of a sampled polyline; both points of a
 * solution agree to rounding. Curves with a double knot are only C1 there. */
static void self_meet(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(18);
    long total = 0;

    (void)state;
    for (int round = 0; round < 60; round++) {
        int order = 2 + round % 4;
        ix_mv *a = curve(ctx, &g, order, order + round % 7, 2, round % 2 == 0);
        enum { N = 600 };
        static double p[N + 1][2];
        ix_solutions s;
        int crossings = 0;

        ASSERT_OK(ctx, ix_crv_self_meet(ctx, a, &s));
        assert_true(s.complete);
        for (int i = 0; i < s.n; i++) {
            double x[2], y[2];

            ASSERT_OK(ctx, ix_mv_point(ctx, a, &s.sol[i].x[0], x));
            ASSERT_OK(ctx, ix_mv_point(ctx, a, &s.sol[i].x[1], y));
            assert_true(dist(x, y, 2) < 1e-12);
            assert_true(s.sol[i].certified);
            assert_true(s.sol[i].x[0] < s.sol[i].x[1]);
        }
        for (int i = 0; i <= N; i++) {
            double t = (double)i / N;

            ASSERT_OK(ctx, ix_mv_point(ctx, a, &t, p[i]));
        }
        for (int i = 0; i < N; i++)
            for (int j = i + 2; j < N; j++) {
                double ux = p[i + 1][0] - p[i][0], uy = p[i + 1][1] - p[i][1];
                double vx = p[j + 1][0] - p[j][0], vy = p[j + 1][1] - p[j][1];
                double wx = p[j][0] - p[i][0], wy = p[j][1] - p[i][1];
                double det = ux * vy - uy * vx;
                double u = (wx * vy - wy * vx) / det,
                       v = (wx * uy - wy * ux) / det;

                /* pieces of one straight span are parallel to rounding */
                crossings += fabs(det) > 1e-15 && u >= 0 && u < 1 && v >= 0 &&
                             v < 1;
            }
        if (s.n < crossings || (s.n - crossings) % 2)
            fail_msg("round %d: %d found, %d crossings of samples", round, s.n,
                     crossings);
        total += s.n;
        ix_solutions_free(ctx, &s);
        ix_mv_unref(ctx, a);
    }
    print_message("# %ld self-intersections\n", total);
    ix_ctx_free(ctx);
}

static ix_mv *patch(ix_ctx *ctx, ix_rng *g, bool rational)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};
    double pts[4 * 9];
    int r = rational;
    ix_mv *m;

    for (int i = 0; i < 9; i++) {
        double w = rational ? ix_rng_range(g, 0.7, 1.5) : 1;

        if (rational)
            pts[i] = w;
        pts[r * 9 + i] = w * (i % 3 + ix_rng_range(g, -0.2, 0.2));
        pts[(r + 1) * 9 + i] = w * (i / 3 + ix_rng_range(g, -0.2, 0.2));
        pts[(r + 2) * 9 + i] = w * ix_rng_range(g, -1, 1);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, rational, pts, &m));
    return m;
}

static void surface_nearest(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(16);

    (void)state;
    for (int round = 0; round < 12; round++) {
        ix_mv *s = patch(ctx, &g, round % 2 == 0);
        double p[3] = {ix_rng_range(&g, -1, 3), ix_rng_range(&g, -1, 3),
                       ix_rng_range(&g, -2, 2)};
        double uv[2], d, x[3];

        ASSERT_OK(ctx, ix_srf_nearest(ctx, s, p, false, uv, &d));
        ASSERT_OK(ctx, ix_mv_point(ctx, s, uv, x));
        ASSERT_CLOSE(dist(x, p, 3), d, 1e-14);
        for (int i = 0; i <= 40; i++)
            for (int j = 0; j <= 40; j++) {
                double t[2] = {i / 40.0, j / 40.0};

                ASSERT_OK(ctx, ix_mv_point(ctx, s, t, x));
                assert_true(dist(x, p, 3) >= d - 1e-12);
            }
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

/* Contour vertices satisfy the plane's equation; both sides occur next to a
 * contour, so there is one wherever the sign changes along the boundary. */
static void contours(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(17);

    (void)state;
    for (int round = 0; round < 12; round++) {
        ix_mv *s = patch(ctx, &g, round % 2 == 0);
        const double plane[4] = {0.1, -0.2, 1, ix_rng_range(&g, -0.3, 0.3)};
        ix_solution_curves c;
        double x[3];

        ASSERT_OK(ctx, ix_contour(ctx, s, plane, 1e-4, &c));
        assert_true(c.complete && c.nsingular == 0);
        for (int i = 0; i < c.ncurves; i++) {
            assert_true(c.curve[i].start != IX_END_OPEN);
            for (int k = 0; k < c.curve[i].n; k++) {
                ASSERT_OK(ctx, ix_mv_point(ctx, s, c.curve[i].x + 2 * k, x));
                ASSERT_CLOSE(0,
                             fabs(plane[0] * x[0] + plane[1] * x[1] +
                                  plane[2] * x[2] + plane[3]),
                             1e-13);
            }
        }
        ix_solution_curves_free(ctx, &c);
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *a, *b;
    ix_solutions s;
    ix_root *r;
    int n;
} oom;

static void oom_setup(ix_ctx *ctx, void *state)
{
    ix_rng g = ix_rng_new(1);

    ((oom *)state)->a = curve(ctx, &g, 3, 4, 2, true);
    ((oom *)state)->b = curve(ctx, &g, 3, 4, 2, false);
}

static ix_status oom_run(ix_ctx *ctx, void *state)
{
    const double p[3] = {0.1, 0.2, 0}, dir[3] = {1, 1, 0};
    oom *o = state;
    double t, d;
    ix_status st = ix_crv_nearest(ctx, o->a, p, dir, false, &t, &d);

    if (st == IX_OK)
        st = ix_crv_crv_meet(ctx, o->a, o->b, NULL, &o->s);
    return st;
}

static void oom_teardown(ix_ctx *ctx, void *state)
{
    oom *o = state;

    ix_solutions_free(ctx, &o->s);
    ix_mv_unref(ctx, o->a);
    ix_mv_unref(ctx, o->b);
}

static void out_of_memory(void **state)
{
    oom o = {0};
    ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nearest_point), cmocka_unit_test(nearest_to_line),
        cmocka_unit_test(tangents),      cmocka_unit_test(encloses),
        cmocka_unit_test(curves_meet),   cmocka_unit_test(surface_nearest),
        cmocka_unit_test(contours),      cmocka_unit_test(self_meet),
        cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
