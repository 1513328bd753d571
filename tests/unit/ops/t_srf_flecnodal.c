/* Flecnodal curves and points: the height of the surface over the line, on a
 * torus by its equation, on a cubic surface by its lines, completeness by
 * changes of sign, edges that are points, errors, failing allocations. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "iritx/ops_srf.h"
#include "line_test.h"
#include "torus_test.h"

IX_TEST_FIXTURE(1882)

/* h'' and h''' of the line at a vertex, differences being exact to about the
 * 6th power of the step times derivatives of order 9: 1e-9 is seen, of second
 * derivatives of about 3. */
#define FLAT 1e-7

static void vertices_touch(const ix_mv *s, const ix_solution_curves *c)
{
    for (int i = 0; i < c->ncurves; i++)
        for (int k = 0; k < 9; k++) {
            const double *p = c->curve[i].x +
                              4 * (size_t)(k * (c->curve[i].n - 1) / 8);
            real h[5];

            lt_contact(s, p, h);
            for (int e = 0; e < 4; e++)
                assert_true(fabsl(h[e]) < FLAT);
            ASSERT_CLOSE(p[2] * p[2] + p[3] * p[3], 1, 1e-14);
        }
}

/* Law: in every vertex the line meets the surface four times; curves end on the
 * boundary or are loops. */
static void four_times(void **state)
{
    static const int deg[][3] = {{3, 3, 0}, {2, 2, 1}};
    int curves = 0;

    (void)state;
    for (int i = 0; i < 2; i++) {
        ix_mv *s = lt_random(ctx, &rng, deg[i][0], deg[i][1], deg[i][2]);
        ix_solution_curves c;

        ASSERT_OK(ctx, ix_srf_flecnodal(ctx, s, 1e-2, &c));
        assert_true(c.complete);
        assert_int_equal(c.unknowns, 4);
        vertices_touch(s, &c);
        for (int k = 0; k < c.ncurves; k++)
            assert_true(c.curve[k].start == IX_END_BOUNDARY ||
                        c.curve[k].start == IX_END_CLOSED);
        curves += c.ncurves;
        ix_solution_curves_free(ctx, &c);
        ix_mv_unref(ctx, s);
    }
    assert_true(curves >= 4);
}

/* Law: five times at the points, and all of them: between two vertices of a
 * flecnodal curve at which h'''' has different signs there is one. */
static void five_times(void **state)
{
    int points = 0, changes = 0;

    (void)state;
    for (int i = 0; i < 3; i++) {
        ix_mv *s = lt_random(ctx, &rng, 3, 3, false);
        ix_solution_curves c;
        ix_solutions p;

        ASSERT_OK(ctx, ix_srf_flecnodal(ctx, s, 1e-2, &c));
        ASSERT_OK(ctx, ix_srf_flecnodal_points(ctx, s, &p));
        assert_true(p.complete);
        for (int k = 0; k < p.n; k++) {
            real h[5];

            assert_true(p.sol[k].certified);
            lt_contact(s, p.sol[k].x, h);
            for (int e = 0; e < 5; e++) /* 1e-7 / step for the last */
                assert_true(fabsl(h[e]) < 50 * FLAT);
        }
        for (int k = 0; k < c.ncurves; k++) {
            real last = 0;

            for (int v = 0; v < c.curve[k].n; v++) {
                real h[5];

                lt_contact(s, c.curve[k].x + 4 * (size_t)v, h);
                changes += v > 0 && (h[4] > 0) != (last > 0);
                last = h[4];
            }
        }
        points += p.n;
        ix_solutions_free(ctx, &p);
        ix_solution_curves_free(ctx, &c);
        ix_mv_unref(ctx, s);
    }
    assert_true(points >= 1);
    assert_int_equal(changes, points);
}

/* (|X|^2 + 8)^2 = 36 (x^2 + y^2) along the line X + s D: c[0] .. c[3] of s. */
static void torus_along(const ix_mv *t, const double *p, double c[4])
{
    double s[4], d[2][4], x[3], dir[3], len = 0;
    double a = 8, b = 0, e = 0, f = 0, g = 0;
    static const int ku[2] = {1, 0}, kv[2] = {0, 1};

    ASSERT_OK(ctx, ix_mv_eval(ctx, t, p, s));
    ASSERT_OK(ctx, ix_mv_partial(ctx, t, p, ku, d[0]));
    ASSERT_OK(ctx, ix_mv_partial(ctx, t, p, kv, d[1]));
    for (int k = 0; k < 3; k++) {
        x[k] = s[k + 1] / s[0];
        dir[k] = p[2] * (d[0][k + 1] - x[k] * d[0][0]) +
                 p[3] * (d[1][k + 1] - x[k] * d[1][0]);
        len += dir[k] * dir[k];
    }
    for (int k = 0; k < 3; k++) {
        dir[k] /= sqrt(len);
        a += x[k] * x[k];
        b += 2 * x[k] * dir[k];
    }
    for (int k = 0; k < 2; k++) {
        e += x[k] * x[k];
        f += 2 * x[k] * dir[k];
        g += dir[k] * dir[k];
    }
    c[0] = a * a - 36 * e;
    c[1] = 2 * a * b - 36 * f;
    c[2] = b * b + 2 * a - 36 * g;
    c[3] = 2 * b;
}

/* A torus: the inner equator, twice, and the circles on top and bottom. They
 * run along knots. */
static void torus(void **state)
{
    ix_mv *t = lt_torus(ctx);
    ix_solution_curves c;
    int at[4] = {0};

    (void)state;
    ASSERT_OK(ctx, ix_srf_flecnodal(ctx, t, 1e-2, &c));
    assert_true(c.complete);
    assert_int_equal(c.ncurves, 4);
    for (int i = 0; i < 4; i++) {
        const double *x = c.curve[i].x;
        int v = (int)lround(x[1]);

        assert_true(v >= 1 && v <= 3);
        at[v]++;
        ASSERT_CLOSE(fabs(x[4 * c.curve[i].n - 4] - x[0]), 4, 1e-12);
        for (int k = 0; k < c.curve[i].n; k++, x += 4) {
            double q[4];

            torus_along(t, x, q);
            for (int e = 0; e < 4; e++) /* terms of about 200 */
                assert_true(fabs(q[e]) < 1e-12);
            ASSERT_CLOSE(x[1], v, 1e-12);
        }
    }
    assert_int_equal(at[1], 1);
    assert_int_equal(at[2], 2);
    assert_int_equal(at[3], 1);
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, t);
}

/* z = x^3 + y^3 over [0.3, 1] x [-1, -0.2]. */
static ix_mv *cubes(void)
{
    static const double lo[2] = {0.3, -1}, hi[2] = {1, -0.2};
    const ix_dir dirs[2] = {{IX_BEZIER, 4, 4, false, NULL},
                            {IX_BEZIER, 4, 4, false, NULL}};
    double pts[48], c[2][4];
    ix_mv *m;

    for (int d = 0; d < 2; d++) {
        double a = lo[d], b = hi[d];

        c[d][0] = a * a * a;
        c[d][1] = a * a * b;
        c[d][2] = a * b * b;
        c[d][3] = b * b * b;
    }
    for (int i = 0; i < 16; i++) {
        pts[i] = lo[0] + (hi[0] - lo[0]) * (i % 4) / 3;
        pts[16 + i] = lo[1] + (hi[1] - lo[1]) * (double)(i / 4) / 3;
        pts[32 + i] = c[0][i % 4] + c[1][i / 4];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 3, false, pts, &m));
    return m;
}

/* On a cubic surface a line that meets it four times lies in it: those of
 * z = x^3 + y^3 are x + y = z = 0 and complex ones. */
static void lines_of_a_cubic(void **state)
{
    ix_mv *s = cubes();
    ix_solution_curves c;

    (void)state;
    ASSERT_OK(ctx, ix_srf_flecnodal(ctx, s, 1e-2, &c));
    assert_true(c.complete);
    assert_int_equal(c.ncurves, 1);
    for (int k = 0; k < c.curve[0].n; k++) {
        const double *p = c.curve[0].x + 4 * (size_t)k;
        double x[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, s, p, x));
        assert_true(fabs(x[0] + x[1]) < 1e-12 && fabs(x[2]) < 1e-12);
        /* 0.7 a + 0.8 b = 0 */
        assert_true(fabs(0.7 * p[2] + 0.8 * p[3]) < 1e-11);
    }
    ASSERT_CLOSE(c.curve[0].x[0] + c.curve[0].x[4 * c.curve[0].n - 4], 1,
                 1e-10); /* from x = 0.3 to x = 1 */
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, s);
}

static double length_of(const ix_solution_curves *c, double scale)
{
    double len = 0;

    for (int i = 0; i < c->ncurves; i++)
        for (int k = 1; k < c->curve[i].n; k++) {
            const double *p = c->curve[i].x + 4 * (size_t)k;

            len += hypot(scale * (p[0] - p[-4]), p[1] - p[-3]);
        }
    return len;
}

/* Law: knots, and another domain, change nothing but the parameters. */
static void knots_and_domain(void **state)
{
    static const double knots[2] = {0.4, 0.4};
    ix_mv *s = lt_random(ctx, &rng, 3, 2, false), *a, *b;
    ix_solution_curves c[2];

    (void)state;
    ASSERT_OK(ctx, ix_mv_insert_knots(ctx, s, 0, 2, knots, &a));
    ASSERT_OK(ctx, ix_mv_reparam(ctx, a, 0, -3, 7, &b));
    ASSERT_OK(ctx, ix_srf_flecnodal(ctx, s, 1e-3, &c[0]));
    ASSERT_OK(ctx, ix_srf_flecnodal(ctx, b, 1e-3, &c[1]));
    assert_true(c[0].ncurves > 0);
    assert_int_equal(c[0].ncurves, c[1].ncurves);
    ASSERT_CLOSE(length_of(&c[0], 1), length_of(&c[1], 0.1), 1e-4);
    for (int i = 0; i < c[1].ncurves; i++)
        for (int k = 0; k < c[1].curve[i].n; k += 5) {
            const double *p = c[1].curve[i].x + 4 * (size_t)k;
            const double q[4] = {(p[0] + 3) / 10, p[1], p[2] / 10, p[3]};
            real h[5];

            lt_contact(s, q, h);
            for (int e = 0; e < 4; e++)
                assert_true(fabsl(h[e]) < FLAT);
        }
    for (int i = 0; i < 2; i++)
        ix_solution_curves_free(ctx, &c[i]);
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* A sphere has none, its poles included, and that is known. */
static void sphere(void **state)
{
    static const double p[4][3] = {
        {0, 0, -1}, {1, 0, -1}, {1, 0, 1}, {0, 0, 1}};
    static const double at[3] = {0, 0, 0};
    ix_mv *arc, *s;
    ix_solution_curves c;

    (void)state;
    (void)p;
    {
        const double start[3] = {0, 0, -1}, end[3] = {1, 0, 0};

        ASSERT_OK(ctx, ix_arc(ctx, start, at, end, &arc));
    }
    ASSERT_OK(ctx, ix_srf_revolve(ctx, arc, IX_TURN_RATIONAL, &s));
    ASSERT_OK(ctx, ix_srf_flecnodal(ctx, s, 1e-2, &c));
    assert_int_equal(c.ncurves, 0);
    assert_true(c.complete);
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, arc);
    ix_mv_unref(ctx, s);
}

static void expect(ix_mv *s, ix_status want)
{
    ix_solution_curves c;
    ix_solutions p;

    assert_int_equal(ix_srf_flecnodal(ctx, s, 1e-3, &c), want);
    assert_int_equal(c.ncurves, 0);
    assert_int_equal(ix_srf_flecnodal_points(ctx, s, &p), want);
    assert_int_equal(p.n, 0);
    ix_mv_unref(ctx, s);
}

static void errors(void **state)
{
    static const double flat[4] = {0, 1, 2, 3}, saddle[4] = {0, 0, 0, 1};
    static const double at[3] = {0, 0, 0}, up[3] = {0, 0, 2};
    ix_mv *c, *s, *t;

    (void)state;
    expect(lt_bilinear(ctx, flat), IX_EDOMAIN);
    expect(lt_bilinear(ctx, saddle), IX_EDOMAIN);
    ASSERT_OK(ctx, ix_circle(ctx, at, 1, &c));
    ASSERT_OK(ctx, ix_srf_extrude(ctx, c, up, &s));
    expect(s, IX_EDOMAIN);
    s = lt_random(ctx, &rng, 2, 2, false);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, s, 2, false, &t));
    expect(t, IX_EARG);
    ASSERT_OK(ctx, ix_mv_bezier_to_power(ctx, s, &t));
    expect(t, IX_EARG);
    expect(c, IX_EARG);
    ix_mv_unref(ctx, s);
}

typedef struct {
    bool points;
    ix_mv *s;
    ix_solution_curves c;
    ix_solutions p;
} job;

/* z = u^2 + v^2 - 0.38 u^2 v^2: convex but for a corner. */
static void job_setup(ix_ctx *c, void *state)
{
    static const double z[9] = {0, 0, 1, 0, 0, 1, 1, 1, 1.62};
    const ix_dir dirs[2] = {{IX_BEZIER, 3, 3, false, NULL},
                            {IX_BEZIER, 3, 3, false, NULL}};
    double pts[27];
    job *j = state;

    for (int i = 0; i < 9; i++) {
        pts[i] = 0.5 * (i % 3);
        pts[9 + i] = 0.5 * (double)(i / 3);
        pts[18 + i] = z[i];
    }
    ASSERT_OK(c, ix_mv_new(c, 2, dirs, 3, false, pts, &j->s));
    j->c = (ix_solution_curves){.unknowns = 0};
    j->p = (ix_solutions){.n = 0};
}

static ix_status job_run(ix_ctx *c, void *state)
{
    job *j = state;

    return j->points ? ix_srf_flecnodal_points(c, j->s, &j->p)
                     : ix_srf_flecnodal(c, j->s, 0.1, &j->c);
}

static void job_teardown(ix_ctx *c, void *state)
{
    job *j = state;

    ix_mv_unref(c, j->s);
    ix_solution_curves_free(c, &j->c);
    ix_solutions_free(c, &j->p);
}

static void every_allocation_fails(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        job j = {.points = i == 1};
        ix_fault_case c = {job_setup, job_run, job_teardown, &j};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_times),
        cmocka_unit_test(five_times),
        cmocka_unit_test(torus),
        cmocka_unit_test(lines_of_a_cubic),
        cmocka_unit_test(knots_and_domain),
        cmocka_unit_test(sphere),
        cmocka_unit_test(errors),
        cmocka_unit_test(every_allocation_fails)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
