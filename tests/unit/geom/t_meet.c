/* Intersections of surfaces, pairs of points of a curve, distances of two
 * freeforms: against known answers, sampling and each other. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/contour.h"
#include "iritx/distance.h"

IX_TEST_FIXTURE(20260717)

static ix_mv *bezier(int ndirs, int n0, int n1, int nc, const double *pts)
{
    ix_dir d[2] = {{.basis = IX_BEZIER, .order = n0, .length = n0},
                   {.basis = IX_BEZIER, .order = n1, .length = n1}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, d, nc, false, pts, &m));
    return m;
}

/* The graph z = h[4][4] over [0, 1]^2. */
static ix_mv *graph(const double *h)
{
    double p[48];

    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            p[i + 4 * j] = i / 3.0;
            p[16 + i + 4 * j] = j / 3.0;
            p[32 + i + 4 * j] = h[i + 4 * j];
        }
    return bezier(2, 4, 4, 3, p);
}

static ix_mv *plane(double z, double slope)
{
    const double p[12] = {-0.1, 1.1, -0.1, 1.1,       -0.1, -0.1,
                          1.1,  1.1, z,    z + slope, z,    z + slope};

    return bezier(2, 2, 2, 3, p);
}

static void point(const ix_mv *m, const double *t, double p[3])
{
    p[0] = p[1] = p[2] = 0;
    ASSERT_OK(ctx, ix_mv_point(ctx, m, t, p));
}

static double dist(const double *p, const double *q)
{
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

static void count(const ix_solution_curves *s, int *loops, int *arcs)
{
    *loops = *arcs = 0;
    for (int i = 0; i < s->ncurves; i++) {
        *loops += s->curve[i].start == IX_END_CLOSED;
        *arcs += s->curve[i].start != IX_END_CLOSED;
    }
}

/* Law: graph and plane meet in as many loops and arcs as the contour of the
 * graph has, and every vertex is on both. */
static void surface_and_plane(void **state)
{
    int all = 0;

    (void)state;
    for (int round = 0; round < 8; round++) {
        ix_solution_curves s, flat;
        double h[16], level[4] = {0, 0, 1, 0};
        ix_mv *a, *b;
        int loops, arcs, want_loops, want_arcs;

        for (int i = 0; i < 16; i++)
            h[i] = ix_rng_range(&rng, -1, 1);
        level[3] = -ix_rng_range(&rng, -0.2, 0.2);
        level[0] = -0.1 * (round % 3);
        a = graph(h);
        b = plane(-level[3] - 0.1 * -level[0], -level[0] * 1.2);
        ASSERT_OK(ctx, ix_srf_srf_meet(ctx, a, b, 1e-3, &s));
        ASSERT_OK(ctx, ix_contour(ctx, a, level, 1e-3, &flat));
        count(&s, &loops, &arcs);
        count(&flat, &want_loops, &want_arcs);
        assert_int_equal(loops, want_loops);
        assert_int_equal(arcs, want_arcs);
        for (int i = 0; i < s.ncurves; i++)
            for (int k = 0; k < s.curve[i].n; k++) {
                double p[3], q[3];

                point(a, s.curve[i].x + 4 * k, p);
                point(b, s.curve[i].x + 4 * k + 2, q);
                assert_true(dist(p, q) < 1e-13);
            }
        all += loops + arcs;
        ix_solution_curves_free(ctx, &s);
        ix_solution_curves_free(ctx, &flat);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    assert_true(all > 8);
}

/* Two bicubic graphs: their difference is a scalar whose zero set is known. */
static void two_bicubics(void **state)
{
    double h[16], g[16], zero[4] = {1, 0, 0, 0};
    int loops, arcs, want_loops, want_arcs;
    ix_solution_curves s, flat;
    ix_mv *a, *b, *f;

    (void)state;
    for (int i = 0; i < 16; i++) {
        h[i] = (i % 4 == 1 || i % 4 == 2) == (i / 4 == 1 || i / 4 == 2) ? 1
                                                                        : -1;
        g[i] = 0.3 * ix_rng_range(&rng, -1, 1);
    }
    a = graph(h);
    b = graph(g);
    for (int i = 0; i < 16; i++)
        h[i] -= g[i];
    f = bezier(2, 4, 4, 1, h);
    ASSERT_OK(ctx, ix_srf_srf_meet(ctx, a, b, 1e-3, &s));
    ASSERT_OK(ctx, ix_contour(ctx, f, zero, 1e-3, &flat));
    count(&s, &loops, &arcs);
    count(&flat, &want_loops, &want_arcs);
    assert_int_equal(loops, want_loops);
    assert_int_equal(arcs, want_arcs);
    assert_true(loops + arcs > 0);
    ix_solution_curves_free(ctx, &s);
    ix_solution_curves_free(ctx, &flat);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, f);
}

/* A vertical line meets a graph once; three planes share a point. */
static void points_in_common(void **state)
{
    const double line[6] = {0.3, 0.3, 0.4, 0.4, -5, 5};
    const double side[12] = {0.25, 0.25, 0.25, 0.25, 0, 1, 0, 1, -2, -2, 2, 2};
    ix_mv *c = bezier(1, 2, 2, 3, line), *a, *three[3];
    double h[16], p[3], q[3];
    ix_solutions s;

    (void)state;
    for (int i = 0; i < 16; i++)
        h[i] = ix_rng_range(&rng, -1, 1);
    a = graph(h);
    ASSERT_OK(ctx, ix_crv_srf_meet(ctx, c, a, &s));
    assert_int_equal(s.n, 1);
    assert_true(s.sol[0].certified);
    point(c, s.sol[0].x, p);
    point(a, s.sol[0].x + 1, q);
    assert_true(dist(p, q) < 1e-14);
    ix_solutions_free(ctx, &s);
    three[0] = plane(0.1, 0.2);
    three[1] = bezier(2, 2, 2, 3, side);
    ASSERT_OK(ctx, ix_mv_swap_dirs(ctx, three[0], 0, 1, &three[2]));
    ix_mv_unref(ctx, three[2]);
    three[2] = plane(0.4, -1);
    ASSERT_OK(ctx, ix_srf3_meet(ctx, (const ix_mv *const *)three, &s));
    /* z = 0.1 + 0.2 (x + 0.1) / 1.2 and z = 0.4 - (x + 0.1) / 1.2: x = 0.2 is
     * not on x = 0.25: none; moved planes below meet */
    assert_int_equal(s.n, 0);
    ix_solutions_free(ctx, &s);
    ix_mv_unref(ctx, three[2]);
    {
        const double wall[12] = {0, 1, 0, 1, 0.6, 0.6, 0.6, 0.6, -2, -2, 2, 2};

        three[2] = bezier(2, 2, 2, 3, wall);
    }
    ASSERT_OK(ctx, ix_srf3_meet(ctx, (const ix_mv *const *)three, &s));
    assert_int_equal(s.n, 1);
    assert_true(s.sol[0].certified);
    point(three[0], s.sol[0].x, p);
    ASSERT_CLOSE(p[0], 0.25, 1e-14);
    ASSERT_CLOSE(p[1], 0.6, 1e-14);
    ix_solutions_free(ctx, &s);
    for (int k = 0; k < 3; k++)
        ix_mv_unref(ctx, three[k]);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, c);
}

/* --- pairs of points --------------------------------------------------------
 */

/* y = (x^2 - 1)^2 on [-2, 2]: one bitangent, y = 0 from -1 to 1. */
static void bitangent(void **state)
{
    const double p[10] = {-2, -1, 0, 1, 2, 9, -15, 59 / 3.0, -15, 9};
    ix_mv *c = bezier(1, 5, 1, 2, p), *b;
    double kv[3] = {0.25, 0.4, 0.75};
    ix_solutions s;

    (void)state;
    for (int spline = 0; spline <= 1; spline++) {
        if (spline) { /* knots, two of them at the points of contact */
            ASSERT_OK(ctx, ix_mv_to_bspline(ctx, c, &b));
            ix_mv_unref(ctx, c);
            ASSERT_OK(ctx, ix_mv_insert_knots(ctx, b, 0, 3, kv, &c));
            ix_mv_unref(ctx, b);
        }
        ASSERT_OK(ctx, ix_crv_bitangents(ctx, c, &s));
        assert_int_equal(s.n, 1);
        ASSERT_CLOSE(s.sol[0].x[0], 0.25, 1e-12);
        ASSERT_CLOSE(s.sol[0].x[1], 0.75, 1e-12);
        ix_solutions_free(ctx, &s);
    }
    ix_mv_unref(ctx, c);
}

/* Law: what sampling and Newton-free bisection by signs cannot deny: both
 * conditions hold, and knots change nothing. */
static void antipodal(void **state)
{
    int all = 0;

    (void)state;
    for (int round = 0; round < 20; round++) {
        const ix_rand_opts o = {.ndirs = 1,
                                .ncoords = 2 + round % 2,
                                .rational = round % 3 == 2 ? 1 : -1,
                                .kinds = IX_RAND_BEZIER,
                                .min_order = 4,
                                .max_order = 5};
        ix_mv *c = ix_mv_randtest(ctx, &rng, &o), *b, *cut;
        double kv[2] = {0.31, 0.62};
        ix_solutions s, t;

        ASSERT_OK(ctx, ix_crv_antipodal(ctx, c, &s));
        for (int i = 0; i < s.n; i++)
            for (int e = 0; e < 2; e++) {
                double p[3], q[3], lo[3], hi[3], u, dot = 0, h = 1e-6;

                point(c, &s.sol[i].x[0], p);
                point(c, &s.sol[i].x[1], q);
                u = s.sol[i].x[e] - h;
                point(c, &u, lo);
                u += 2 * h;
                point(c, &u, hi);
                for (int k = 0; k < 3; k++)
                    dot += (p[k] - q[k]) * (hi[k] - lo[k]) / (2 * h);
                assert_true(fabs(dot) < 1e-7); /* of the difference quotient */
            }
        ASSERT_OK(ctx, ix_mv_to_bspline(ctx, c, &b));
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, b, 0, 2, kv, &cut));
        ASSERT_OK(ctx, ix_crv_antipodal(ctx, cut, &t));
        assert_int_equal(s.n, t.n);
        for (int i = 0; i < s.n; i++)
            for (int e = 0; e < 2; e++)
                ASSERT_CLOSE(s.sol[i].x[e], t.sol[i].x[e], 1e-9);
        all += s.n;
        ix_solutions_free(ctx, &s);
        ix_solutions_free(ctx, &t);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, cut);
    }
    print_message("# %d antipodal pairs\n", all);
    assert_true(all > 5);
}

/* --- lines and surfaces ------------------------------------------------------
 */

/* A paraboloid-like patch and the line x = 0.5, z = 3 along y: the nearest
 * point by the contour of the same problem in one unknown. */
static void line_and_surface(void **state)
{
    double p[3] = {0.5, 0, 3}, dir[3] = {0, 2, 0}, uv[2], d, h[16];
    double best = HUGE_VAL;
    ix_mv *a;

    (void)state;
    for (int i = 0; i < 16; i++)
        h[i] = ix_rng_range(&rng, -1, 1);
    a = graph(h);
    ASSERT_OK(ctx, ix_srf_line_nearest(ctx, a, p, dir, false, uv, &d));
    for (int k = 0; k < 200 * 200; k++) {
        double t[2] = {(k % 200) / 199.0, (k / 200) / 199.0}, q[3];

        point(a, t, q);
        best = fmin(best, hypot(q[0] - 0.5, q[2] - 3));
    }
    assert_true(d <= best + 1e-14);
    assert_true(d >= best - 1e-3); /* the grid is 5e-3 fine, at an extremum */
    ix_mv_unref(ctx, a);
}

/* --- distances of two freeforms ---------------------------------------------
 */

static ix_mv *random_curve(int round)
{
    const ix_rand_opts o = {.ndirs = 1,
                            .ncoords = 2 + round % 2,
                            .rational = round % 4 == 3 ? 1 : -1,
                            .kinds = IX_RAND_OPEN,
                            .min_order = 3,
                            .max_order = 4,
                            .max_knots = 2,
                            .unit = true};

    return ix_mv_randtest(ctx, &rng, &o);
}

#define SAMPLES 400

/* Law: no sample contradicts the result, and the samples come near to it. */
static void curve_distances(void **state)
{
    (void)state;
    for (int round = 0; round < 12; round++) {
        ix_mv *a = random_curve(round), *b = random_curve(round);
        double least = HUGE_VAL, most = 0, p[3], q[3];
        ix_distance near, far;

        ASSERT_OK(ctx, ix_distance_least(ctx, a, b, &near));
        ASSERT_OK(ctx, ix_distance_hausdorff(ctx, a, b, true, &far));
        for (int i = 0; i <= SAMPLES; i++) {
            double t = (double)i / SAMPLES, r, d;

            point(a, &t, p);
            ASSERT_OK(ctx, ix_crv_nearest(ctx, b, p, NULL, false, &r, &d));
            least = fmin(least, d);
            most = fmax(most, d);
        }
        assert_true(near.distance <= least + 1e-12);
        assert_true(near.distance >= least - 2e-2); /* speed times step */
        assert_true(far.distance >= most - 1e-12);
        assert_true(far.distance <= most + 2e-2);
        assert_true(near.error <= 1e-9 && far.error <= 1e-9);
        point(a, near.a, p);
        point(b, near.b, q);
        ASSERT_CLOSE(dist(p, q), near.distance, 1e-13);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
}

/* Two planes one above the other, and a point. */
static void surface_distances(void **state)
{
    const double one[3] = {0.5, 0.5, 4};
    ix_mv *a = plane(0, 0), *b = plane(1, 0.5), *p = bezier(1, 1, 1, 3, one);
    ix_distance d;

    (void)state;
    ASSERT_OK(ctx, ix_distance_least(ctx, a, p, &d));
    ASSERT_CLOSE(d.distance, 4, 1e-14);
    ASSERT_OK(ctx, ix_distance_least(ctx, p, a, &d));
    ASSERT_CLOSE(d.distance, 4, 1e-14);
    ASSERT_OK(ctx, ix_distance_least(ctx, a, b, &d));
    ASSERT_CLOSE(d.distance, 1, 1e-9);
    ASSERT_OK(ctx, ix_distance_hausdorff(ctx, p, a, true, &d));
    ASSERT_CLOSE(d.distance, 4, 1e-14);
    ASSERT_OK(ctx, ix_distance_hausdorff(ctx, b, a, false, &d));
    ASSERT_CLOSE(d.distance, 1.5, 1e-9);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, p);
}

static void errors(void **state)
{
    const double p[2] = {0, 1}, line[4] = {0, 1, 0, 1};
    ix_mv *c = bezier(1, 2, 1, 1, p), *l = bezier(1, 2, 1, 2, line);
    const double zero[3] = {0, 0, 0};
    double uv[2], d;
    ix_solution_curves cs;
    ix_solutions s;
    ix_mv *a = plane(0, 0);

    (void)state;
    assert_int_equal(ix_crv_bitangents(ctx, c, &s), IX_EARG);
    assert_int_equal(ix_crv_antipodal(ctx, a, &s), IX_EARG);
    assert_int_equal(ix_srf_srf_meet(ctx, a, c, 1e-3, &cs), IX_EARG);
    assert_int_equal(ix_crv_srf_meet(ctx, a, a, &s), IX_EARG);
    assert_int_equal(ix_srf_line_nearest(ctx, a, zero, zero, false, uv, &d),
                     IX_EARG);
    assert_int_equal(ix_isocline(ctx, a, zero, 1, 1e-3, &cs), IX_EARG);
    assert_int_equal(ix_polar_silhouette(ctx, a, zero, 1e-3, &cs), IX_EARG);
    assert_int_equal(ix_implicit_extremes(ctx, a, 0, &s), IX_EARG);
    ASSERT_OK(ctx, ix_crv_antipodal(ctx, l, &s)); /* straight: none */
    assert_int_equal(s.n, 0);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, l);
    ix_mv_unref(ctx, a);
}

/* --- memory ------------------------------------------------------------------
 */

typedef struct {
    ix_mv *m, *point;
    int what;
} oom;

static void oom_setup(ix_ctx *own, void *state)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 4, .length = 4};
    const double p[8] = {0, 3, -2, 1, 0, 2, 2, 0.3};
    oom *o = state;

    const ix_dir one = {.basis = IX_BEZIER, .order = 1, .length = 1};

    ASSERT_OK(own, ix_mv_new(own, 1, &d, 2, false, p, &o->m));
    ASSERT_OK(own, ix_mv_new(own, 1, &one, 2, false, p + 3, &o->point));
}

static ix_status oom_run(ix_ctx *own, void *state)
{
    oom *o = state;
    ix_solutions s;
    ix_distance d;
    ix_status st;

    if (o->what == 2)
        return ix_distance_least(own, o->point, o->point, &d);
    if (o->what == 3)
        return ix_distance_hausdorff(own, o->point, o->m, true, &d);
    st = (o->what ? ix_crv_antipodal : ix_crv_bitangents)(own, o->m, &s);
    ix_solutions_free(own, &s);
    return st;
}

static void oom_teardown(ix_ctx *own, void *state)
{
    oom *o = state;

    ix_mv_unref(own, o->m);
    ix_mv_unref(own, o->point);
}

static void out_of_memory(void **state)
{
    (void)state;
    for (int what = 0; what < 4; what++) {
        oom o = {.what = what};
        const ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

        assert_true(ix_fault_run(&c) > 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(surface_and_plane),
                                       cmocka_unit_test(two_bicubics),
                                       cmocka_unit_test(points_in_common),
                                       cmocka_unit_test(bitangent),
                                       cmocka_unit_test(antipodal),
                                       cmocka_unit_test(line_and_surface),
                                       cmocka_unit_test(curve_distances),
                                       cmocka_unit_test(surface_distances),
                                       cmocka_unit_test(errors),
                                       cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
