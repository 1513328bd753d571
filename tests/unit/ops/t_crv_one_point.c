/* The curvature's sign by one control point: the field by derivatives of the
 * edited curve, where inflections appear by their definition and for cubics by
 * the parabola of Stone and DeRose, regions by counting, errors, allocations.
 */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/ops_crv.h"

IX_TEST_FIXTURE(1989)

static ix_mv *random_curve(int i)
{
    const ix_rand_opts o = {.ndirs = 1,
                            .ncoords = 2,
                            .rational = i % 2 ? 1 : -1,
                            .kinds = i % 3 ? IX_RAND_OPEN : IX_RAND_BEZIER,
                            .min_order = 4,
                            .max_order = 5,
                            .max_knots = 2,
                            .unit = true};

    return ix_mv_randtest(ctx, &rng, &o);
}

static ix_mv *moved(const ix_mv *c, int idx, double x, double y)
{
    double p[3] = {1, x, y};
    ix_mv *m;

    if (ix_mv_rational(c)) {
        p[0] = ix_mv_weights(c)[idx];
        p[1] *= p[0];
        p[2] *= p[0];
    }
    ASSERT_OK(ctx,
              ix_mv_set_point(ctx, c, (size_t)idx, p + !ix_mv_rational(c), &m));
    return m;
}

/* det(x', x''), and its derivative det(x', x'''). */
static void bending(const ix_mv *c, double t, double out[2])
{
    double d[8];

    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 3, d));
    out[0] = d[2] * d[5] - d[3] * d[4];
    out[1] = d[2] * d[7] - d[3] * d[6];
}

static double weight_at(const ix_mv *c, double t)
{
    double h[3] = {1, 0, 0};

    if (ix_mv_rational(c))
        ASSERT_OK(ctx, ix_mv_eval(ctx, c, &t, h));
    return h[0];
}

/* Law: F(t, x, y) = w^3 det(x', x'') of the curve with its point at (x, y). */
static void definition(void **state)
{
    static const double range[2] = {-2, 3};

    (void)state;
    for (int i = 0; i < 12; i++) {
        ix_mv *c = random_curve(i), *f;
        int idx = ix_rng_int(&rng, 0, ix_mv_length(c, 0) - 1);

        ASSERT_OK(ctx, ix_crv_one_point(ctx, c, idx, range, &f));
        assert_int_equal(ix_mv_ndirs(f), 3);
        assert_int_equal(ix_mv_ncoords(f), 1);
        for (int k = 0; k < 8; k++) {
            double p[3] = {ix_rng_unit(&rng), ix_rng_range(&rng, -2, 3),
                           ix_rng_range(&rng, -2, 3)};
            ix_mv *m = moved(c, idx, p[1], p[2]);
            double want[2], have, w = weight_at(m, p[0]);

            bending(m, p[0], want);
            ASSERT_OK(ctx, ix_mv_eval(ctx, f, p, &have));
            ASSERT_CLOSE(have, w * w * w * want[0], 1e-10);
            ix_mv_unref(ctx, m);
        }
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, c);
    }
}

/* Law: where two inflections appear, the curvature has a double zero. Sizes of
 * det(x', x'') are some 10^3. */
static void double_zeros(void **state)
{
    static const double range[2] = {-2, 2};
    int seen = 0;

    (void)state;
    for (int i = 0; i < 6; i++) {
        ix_mv *c = random_curve(i);
        ix_solution_curves s;

        ASSERT_OK(ctx, ix_crv_one_point_births(ctx, c, 1, range, 1e-3, &s));
        assert_int_equal(s.unknowns, 3);
        for (int k = 0; k < s.ncurves; k++) {
            const double *p = s.curve[k].x + 3 * (size_t)(s.curve[k].n / 2);
            ix_mv *m = moved(c, 1, p[1], p[2]);
            double b[2];

            bending(m, p[0], b);
            assert_true(fabs(b[0]) < 1e-7 && fabs(b[1]) < 1e-5);
            ix_mv_unref(ctx, m);
            seen++;
        }
        ix_solution_curves_free(ctx, &s);
        ix_mv_unref(ctx, c);
    }
    assert_true(seen > 3);
}

static ix_mv *cubic(void)
{
    static const double pts[8] = {0, 0, 1, 2, 0, 1, 1, 0};
    const ix_dir d = {IX_BEZIER, 4, 4, false, NULL};
    ix_mv *c;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &c));
    return c;
}

/* (0, 0), (0, 1), (1, 1), (x, y): the inflections meet where the curve has a
 * cusp, y = (3 + 2 x - x^2) / 4. */
static void cusps_of_cubics(void **state)
{
    static const double range[2] = {-4, 3};
    ix_mv *c = cubic();
    ix_solution_curves s;
    int n = 0;

    (void)state;
    ASSERT_OK(ctx, ix_crv_one_point_births(ctx, c, 3, range, 1e-4, &s));
    assert_true(s.complete);
    for (int i = 0; i < s.ncurves; i++)
        for (int k = 0; k < s.curve[i].n; k++, n++) {
            const double *p = s.curve[i].x + 3 * (size_t)k;

            ASSERT_CLOSE(p[2], (3 + 2 * p[1] - p[1] * p[1]) / 4, 1e-12);
        }
    assert_true(n > 10);
    ix_solution_curves_free(ctx, &s);
    ix_mv_unref(ctx, c);
}

static int inflections(const ix_mv *c, double x, double y)
{
    ix_mv *m = moved(c, 1, x, y);
    ix_root *r;
    int n, count = 0;

    ASSERT_OK(ctx, ix_crv_inflections(ctx, m, &r, &n));
    for (int i = 0; i < n; i++)
        count += r[i].before * r[i].after < 0;
    ix_roots_free(ctx, r, n);
    ix_mv_unref(ctx, m);
    return count;
}

static double side(const double *a, const double *b, const double *p)
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static bool crosses(const ix_lines *l, const double *p, const double *q)
{
    size_t at = 0;

    for (int i = 0; i < l->n; at += (size_t)l->count[i++])
        for (int k = 1; k < l->count[i]; k++) {
            const double *a = l->pt[at + (size_t)k - 1];
            const double *b = l->pt[at + (size_t)k];

            if ((side(a, b, p) < 0) != (side(a, b, q) < 0) &&
                (side(p, q, a) < 0) != (side(p, q, b) < 0))
                return true;
        }
    return false;
}

/* Law: between two places for which the curve has different numbers of
 * inflections there is a line, with knots of every continuity. */
static void regions(void **state)
{
    static const double range[2] = {-1.5, 1.5};
    int different = 0;

    (void)state;
    for (int i = 0; i < 9; i++) {
        const ix_rand_opts o = {.ndirs = 1,
                                .ncoords = 2,
                                .rational = i % 4 == 3 ? 1 : -1,
                                .kinds = IX_RAND_OPEN,
                                .min_order = 4,
                                .max_order = 4,
                                .max_knots = 3,
                                .unit = true};
        ix_mv *c = ix_mv_randtest(ctx, &rng, &o);
        bool complete;
        ix_lines l;

        ASSERT_OK(ctx, ix_crv_one_point_regions(ctx, c, 1, range, 1e-4,
                                                &complete, &l));
        assert_true(complete);
        for (int k = 0; k < 40; k++) {
            double p[2], q[2];

            for (int d = 0; d < 2; d++) {
                p[d] = ix_rng_range(&rng, -1.5, 1.5);
                q[d] = ix_rng_range(&rng, -1.5, 1.5);
            }
            if (inflections(c, p[0], p[1]) != inflections(c, q[0], q[1])) {
                different++;
                assert_true(crosses(&l, p, q));
            }
        }
        ix_lines_free(ctx, &l);
        ix_mv_unref(ctx, c);
    }
    assert_true(different > 20);
}

/* Vertices of the surface are zeros of the field. */
static void surface(void **state)
{
    static const double range[2] = {-2, 2};
    ix_mv *c = cubic(), *f;
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix_crv_one_point(ctx, c, 2, range, &f));
    ASSERT_OK(ctx, ix_crv_one_point_surface(ctx, c, 2, range, 6, &l));
    assert_true(l.n > 20);
    for (int i = 0; i < 3 * l.n; i++) {
        double v;

        ASSERT_OK(ctx, ix_mv_eval(ctx, f, l.pt[i], &v));
        assert_true(fabs(v) < 1e-13); /* of values of about 10 */
    }
    ix_lines_free(ctx, &l);
    ix_mv_unref(ctx, f);
    ix_mv_unref(ctx, c);
}

static void expect(const ix_mv *c, int idx, double lo, double hi,
                   ix_status want)
{
    const double range[2] = {lo, hi};
    ix_solution_curves s;
    bool complete;
    ix_lines l;
    ix_mv *f;

    assert_int_equal(ix_crv_one_point(ctx, c, idx, range, &f), want);
    assert_null(f);
    assert_int_equal(ix_crv_one_point_births(ctx, c, idx, range, 0, &s), want);
    assert_int_equal(
        ix_crv_one_point_regions(ctx, c, idx, range, 0, &complete, &l), want);
    assert_int_equal(ix_crv_one_point_surface(ctx, c, idx, range, 4, &l), want);
    assert_int_equal(l.n, 0);
}

static void errors(void **state)
{
    static const double pts[4] = {0, 1, 2, 0};
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    ix_mv *c = cubic(), *m;

    (void)state;
    expect(c, 4, 0, 1, IX_EARG);
    expect(c, -1, 0, 1, IX_EARG);
    expect(c, 1, 1, 1, IX_EARG);
    expect(c, 1, 0, NAN, IX_EARG);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, c, 1, false, &m));
    expect(m, 1, 0, 1, IX_EARG);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_bezier_to_power(ctx, c, &m));
    expect(m, 1, 0, 1, IX_EARG);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &m));
    expect(m, 1, 0, 1, IX_EDOMAIN);
    ix_mv_unref(ctx, m);
}

typedef struct {
    int which;
    ix_mv *c;
    ix_lines l;
} job;

static void job_setup(ix_ctx *c, void *state)
{
    static const double pts[8] = {0, 0, 1, 1, 0, 1, 1, 0};
    const ix_dir d = {IX_BEZIER, 4, 4, false, NULL};
    job *j = state;

    ASSERT_OK(c, ix_mv_new(c, 1, &d, 2, false, pts, &j->c));
    j->l = (ix_lines){.n = 0};
}

static ix_status job_run(ix_ctx *c, void *state)
{
    static const double range[2] = {-1, 1};
    bool complete;
    job *j = state;

    return j->which ? ix_crv_one_point_surface(c, j->c, 1, range, 2, &j->l)
                    : ix_crv_one_point_regions(c, j->c, 1, range, 0.1,
                                               &complete, &j->l);
}

static void job_teardown(ix_ctx *c, void *state)
{
    job *j = state;

    ix_mv_unref(c, j->c);
    ix_lines_free(c, &j->l);
}

static void every_allocation_fails(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        job j = {.which = i};
        ix_fault_case c = {job_setup, job_run, job_teardown, &j};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition),
        cmocka_unit_test(double_zeros),
        cmocka_unit_test(cusps_of_cubics),
        cmocka_unit_test(regions),
        cmocka_unit_test(surface),
        cmocka_unit_test(errors),
        cmocka_unit_test(every_allocation_fails)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
