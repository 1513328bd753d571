/* Pairs of spans whose hulls meet: the intersections found in them are those
 * of the system on all pairs, and long curves take no more than their number.
 */
#include <string.h>

#include "geom/outer_mv.h"
#include "harness/randmv.h"
#include "iritx/distance.h"
#include "mv/mv.h"

IX_TEST_FIXTURE(20261122)

/* The system as one tensor over both domains. */
static void whole_system(const ix_mv *a, const ix_mv *b, ix_solutions *out)
{
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    ix_mv *f[2];

    for (int k = 0; k < 2; k++) {
        ASSERT_OK(ctx, ix__outer_difference(ctx, a, b, k, &f[k]));
        eq[k].f = f[k];
    }
    ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, out));
    ix_mv_unref(ctx, f[0]);
    ix_mv_unref(ctx, f[1]);
}

/* m moved by v and, with flip, with the sign of all homogeneous coordinates
 * changed, or with one weight negative. */
static ix_mv *changed(ix_mv *m, double v, bool flip, bool mixed)
{
    ix_mv *n;

    ASSERT_OK(
        ctx, ix__mv_alloc(ctx, m->ndirs, m->dirs, m->ncoords, m->rational, &n));
    for (size_t i = 0; i < m->npts; i++)
        for (int k = 0; k < m->naxes; k++) {
            size_t at = (size_t)k * m->npts + i;
            double w = m->rational ? m->pts[i] : 1;

            n->pts[at] = m->pts[at] + (k >= m->rational ? v * w : 0);
            if (m->rational && (flip || (mixed && i == 1)))
                n->pts[at] = -n->pts[at];
        }
    ix_mv_unref(ctx, m);
    return n;
}

/* Law: the same solutions, to 1e-8 of a domain of size 1 to 7 where the
 * curves meet at an angle; certified by both. */
static void as_the_whole_system(void **state)
{
    const ix_rand_opts o = {.ndirs = 1,
                            .ncoords = 2,
                            .kinds = IX_RAND_BEZIER | IX_RAND_BSPLINES,
                            .min_order = 2,
                            .max_order = 5};
    long all = 0;

    (void)state;
    for (int round = 0; round < 60; round++) {
        double v = round % 5 == 4 ? 1e6 : 0;
        bool flip = round % 7 == 3, mixed = round % 7 == 5;
        ix_mv *a = changed(ix_mv_randtest(ctx, &rng, &o), v, flip, mixed);
        ix_mv *b = changed(ix_mv_randtest(ctx, &rng, &o), v, false, false);
        double tol = v > 0 ? 1e-5 : 1e-8; /* moving rounds the points */
        ix_solutions s, t;

        ASSERT_OK(ctx, ix_crv_crv_meet(ctx, a, b, NULL, &s));
        whole_system(a, b, &t);
        assert_int_equal(s.n, t.n);
        assert_true(s.complete && t.complete);
        for (int i = 0; i < s.n; i++) {
            assert_int_equal(s.sol[i].certified, t.sol[i].certified);
            for (int k = 0; k < 2; k++)
                ASSERT_CLOSE(s.sol[i].x[k], t.sol[i].x[k], tol);
            assert_true(s.sol[i].residual < 1e-12);
        }
        all += s.n;
        ix_solutions_free(ctx, &s);
        ix_solutions_free(ctx, &t);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    assert_true(all > 60);
}

/* A polyline over [0, n - 1] with y = amplitude (-1)^i. */
static ix_mv *zigzag(int n, double amplitude, double shift)
{
    static double p[2 * 1024], kv[1024 + 2];
    ix_dir d = {IX_BSPLINE, 2, n, false, kv};
    ix_mv *m;

    for (int i = 0; i < n; i++) {
        p[i] = i + shift;
        p[n + i] = i % 2 ? amplitude : -amplitude;
        kv[i + 1] = i;
    }
    kv[0] = 0;
    kv[n + 1] = n - 1;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, p, &m));
    return m;
}

/* 1000 spans against 1000, in boxes proportional to the crossings: all pairs
 * would be a million. */
static void long_curves(void **state)
{
    ix_mv *a = zigzag(1001, 1, 0), *b = zigzag(1001, 0, 0.25);
    ix_solutions s;

    (void)state;
    ASSERT_OK(ctx, ix_crv_crv_meet(ctx, a, b, NULL, &s));
    assert_true(s.complete);
    assert_int_equal(s.n, 1000);
    for (int i = 0; i < s.n; i++) {
        if (i > 0) /* the first is left of b */
            ASSERT_CLOSE(s.sol[i].x[0] - s.sol[i - 1].x[0], 1, 1e-12);
        ASSERT_CLOSE(s.sol[i].x[0] - s.sol[i].x[1], 0.25, 1e-12);
    }
    assert_true(s.boxes < 4000);
    ix_solutions_free(ctx, &s);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* The cubic with value and derivatives d[4][2] at u, over [0, 1]; its weights,
 * if any, are 1. */
static ix_mv *cubic_by_jet(double u, double d[4][2], bool weights)
{
    static const double choose[4][4] = {{1, 0, 0, 0},
                                        {1, 1.0 / 3, 0, 0},
                                        {1, 2.0 / 3, 1.0 / 3, 0},
                                        {1, 1, 1, 1}};
    const ix_dir dir = {.basis = IX_BEZIER, .order = 4, .length = 4};
    double p[12];
    ix_mv *m;

    for (int k = 0; k < 2; k++) {
        double c[4] = {d[0][k] - u * d[1][k] + u * u * d[2][k] / 2 -
                           u * u * u * d[3][k] / 6,
                       d[1][k] - u * d[2][k] + u * u * d[3][k] / 2,
                       d[2][k] / 2 - u * d[3][k] / 2, d[3][k] / 6};

        for (int i = 0; i < 4; i++) {
            double *q = &p[(k + weights) * 4 + i];

            *q = 0;
            for (int j = 0; j < 4; j++)
                *q += choose[i][j] * c[j];
            if (weights)
                p[i] = 1;
        }
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, weights, p, &m));
    return m;
}

static bool encloses(const ix_solution *s, double t, double u)
{
    return s->lo[0] <= t && t <= s->hi[0] && s->lo[1] <= u && u <= s->hi[1];
}

/* Law: a contact of known order is enclosed by one solution, not certified,
 * also when weights of 1 keep the equations from being sums. The size of the
 * box follows from the order and by how much the next derivatives differ
 * across the curves: what is hidden by 100 roundings. */
static void contacts(void **state)
{
    (void)state;
    for (int round = 0; round < 60; round++) {
        int order = 1 + round % 2, at[2] = {0, 0};
        double t = ix_rng_range(&rng, 0.2, 0.8);
        double u = ix_rng_range(&rng, 0.2, 0.8), d[2][4][2];
        double off[2], room;

        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 2; k++) {
                d[0][j][k] = ix_rng_range(&rng, -1, 1);
                d[1][j][k] = j <= order ? d[0][j][k]
                                        : ix_rng_range(&rng, -1, 1);
            }
        d[0][1][0] = d[1][1][0] = 1;
        for (int k = 0; k < 2; k++)
            off[k] = d[1][order + 1][k] - d[0][order + 1][k];
        room = fabs(d[0][1][0] * off[1] - d[0][1][1] * off[0]);
        room = 40 * pow(1e-14 / room, 1.0 / (order + 1));
        for (int weights = 0; weights < 2; weights++) {
            ix_mv *a = cubic_by_jet(t, d[0], false);
            ix_mv *b = cubic_by_jet(u, d[1], weights);
            ix_solutions s;

            ASSERT_OK(ctx, ix_crv_crv_meet(ctx, a, b, NULL, &s));
            assert_true(s.complete);
            for (int i = 0; i < s.n; i++)
                if (encloses(&s.sol[i], t, u)) {
                    at[weights]++;
                    assert_false(s.sol[i].certified);
                    assert_true(s.sol[i].hi[0] - s.sol[i].lo[0] < room);
                }
            assert_int_equal(at[weights], 1);
            ix_solutions_free(ctx, &s);
            ix_mv_unref(ctx, a);
            ix_mv_unref(ctx, b);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_the_whole_system),
        cmocka_unit_test(long_curves),
        cmocka_unit_test(contacts),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
