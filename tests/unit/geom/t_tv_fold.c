/* Jacobian determinants by derivatives and differences, folds of trivariates
 * that are known, surfaces without a hole, errors, failing allocations. */
#include <string.h>

#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/geom_srf.h"

IX_TEST_FIXTURE(1729)

static double det3(double a[3][3])
{
    double n[3];

    ix__cross3(a[0], a[1], n);
    return ix__dot3(n, a[2]);
}

/* det(T_u, T_v, T_w) w^4 by the quotient rule, and by differences. */
static void jacobian_at(const ix_mv *m, const double *t, double out[2])
{
    int r = ix_mv_rational(m);
    double h[4], d[4], a[3][3], b[3][3], w = 1;

    ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, h));
    if (r)
        w = h[0];
    for (int k = 0; k < 3; k++) {
        const int order[3] = {k == 0, k == 1, k == 2};
        double x[2][3], lo[3] = {t[0], t[1], t[2]}, hi[3] = {t[0], t[1], t[2]};

        ASSERT_OK(ctx, ix_mv_partial(ctx, m, t, order, d));
        lo[k] -= 1e-5;
        hi[k] += 1e-5;
        ASSERT_OK(ctx, ix_mv_point(ctx, m, lo, x[0]));
        ASSERT_OK(ctx, ix_mv_point(ctx, m, hi, x[1]));
        for (int c = 0; c < 3; c++) {
            a[k][c] = (d[c + r] - (r ? h[c + 1] / w * d[0] : 0)) / w;
            b[k][c] = (x[1][c] - x[0][c]) / 2e-5;
        }
    }
    out[0] = det3(a) * w * w * w * w;
    out[1] = det3(b) * w * w * w * w;
}

/* Law: the field is the determinant, also of splines and rational ones. */
static void determinant(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        const ix_rand_opts o = {.ndirs = 3,
                                .ncoords = 3,
                                .rational = i % 2 ? 1 : -1,
                                .kinds = i % 3 ? IX_RAND_OPEN : IX_RAND_BEZIER,
                                .min_order = 2,
                                .max_order = 3,
                                .max_knots = 1,
                                .unit = true};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *f;

        ASSERT_OK(ctx, ix_tv_jacobian(ctx, m, &f));
        for (int k = 0; k < 8; k++) {
            double t[3], want[2], have;

            for (int d = 0; d < 3; d++)
                t[d] = ix_rng_range(&rng, 0.01, 0.99);
            jacobian_at(m, t, want);
            ASSERT_OK(ctx, ix_mv_eval(ctx, f, t, &have));
            ASSERT_CLOSE(have, want[0], 1e-11);
            /* a knot within 1e-5 of t would show; none is */
            ASSERT_CLOSE(have, want[1], 1e-4);
        }
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, m);
    }
}

/* The trivariate (u, v, g), g of the given coefficients of u^i v^j w^k, i, j <
 * 3, k < 4, on [0, 1]^3. */
static ix_mv *graph(const double c[4][3][3])
{
    const ix_dir dirs[3] = {{IX_POWER, 3, 3, false, NULL},
                            {IX_POWER, 3, 3, false, NULL},
                            {IX_POWER, 4, 4, false, NULL}};
    double pts[3 * 36] = {0};
    ix_mv *m, *b;

    pts[1] = 1;
    pts[36 + 3] = 1;
    for (int i = 0; i < 36; i++)
        pts[72 + i] = c[i / 9][i / 3 % 3][i % 3];
    ASSERT_OK(ctx, ix_mv_new(ctx, 3, dirs, 3, false, pts, &m));
    ASSERT_OK(ctx, ix_mv_power_to_bezier(ctx, m, &b));
    ix_mv_unref(ctx, m);
    return b;
}

static double area_of(const ix_lines *l)
{
    double sum = 0;

    for (int i = 0; i < l->n; i++) {
        double a[3], b[3], n[3];

        ix__sub3(l->pt[3 * i + 1], l->pt[3 * i], a);
        ix__sub3(l->pt[3 * i + 2], l->pt[3 * i], b);
        ix__cross3(a, b, n);
        sum += ix__len3(n) / 2;
    }
    return sum;
}

/* (u, v, w - w^2) folds where w = 1/2, into z = 1/4. */
static void folded_sheet(void **state)
{
    static const double c[4][3][3] = {[1] = {{1}}, [2] = {{-1}}};
    static const int cells[3] = {3, 4, 5};
    ix_mv *m = graph(c);
    ix_lines l;

    (void)state;
    for (int euclid = 0; euclid < 2; euclid++) {
        ASSERT_OK(ctx, ix_tv_fold(ctx, m, cells, euclid, &l));
        assert_true(l.n > 0);
        for (int i = 0; i < 3 * l.n; i++)
            ASSERT_CLOSE(l.pt[i][2], euclid ? 0.25 : 0.5, 1e-15);
        ASSERT_CLOSE(area_of(&l), 1, 1e-12);
        ix_lines_free(ctx, &l);
    }
    ix_mv_unref(ctx, m);
}

/* g_w = |x - (1/2, 1/2, 1/2)|^2 - 1/9. */
static ix_mv *ball(void)
{
    static const double c[4][3][3] = {
        [1] = {{0.75 - 1.0 / 9, -1, 1}, {-1}, {1}},
        [2] = {{-0.5}},
        [3] = {{1.0 / 3}}};

    return graph(c);
}

static bool same(const double a[3], const double b[3])
{
    return memcmp(a, b, 3 * sizeof *a) == 0;
}

/* How many triangles have the directed edge a b. */
static int edges(const ix_lines *l, const double *a, const double *b)
{
    int n = 0;

    for (int i = 0; i < l->n; i++)
        for (int k = 0; k < 3; k++)
            n += same(l->pt[3 * i + k], a) &&
                 same(l->pt[3 * i + (k + 1) % 3], b);
    return n;
}

/* Fold along a sphere: vertices on it, every edge once in either sense, the
 * positive side outside, the area of a sphere (less what chords cut off). */
static void sphere(void **state)
{
    static const int cells[3] = {7, 7, 7};
    ix_mv *m = ball();
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix_tv_fold(ctx, m, cells, false, &l));
    for (int i = 0; i < l.n; i++) {
        double(*p)[3] = l.pt + 3 * i, x[3][3];

        for (int k = 0; k < 3; k++) {
            for (int d = 0; d < 3; d++)
                x[k][d] = p[k][d] - 0.5;
            ASSERT_CLOSE(ix__len3(x[k]), 1.0 / 3, 1e-14);
            assert_int_equal(edges(&l, p[k], p[(k + 1) % 3]), 1);
            assert_int_equal(edges(&l, p[(k + 1) % 3], p[k]), 1);
        }
        assert_true(det3(x) > 0);
    }
    ASSERT_CLOSE(area_of(&l), 4 * 3.14159265358979 / 9, 0.05);
    ix_lines_free(ctx, &l);
    ix_mv_unref(ctx, m);
}

/* Law: knots change nothing but the grid, which then has them among its planes.
 */
static void knots(void **state)
{
    static const double at = 0.3;
    static const int cells[3] = {4, 4, 4};
    ix_mv *m = ball(), *k;
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix_mv_insert_knots(ctx, m, 2, 1, &at, &k));
    ASSERT_OK(ctx, ix_tv_fold(ctx, k, cells, false, &l));
    assert_true(l.n > 0);
    for (int i = 0; i < 3 * l.n; i++) {
        double x[3];

        for (int d = 0; d < 3; d++)
            x[d] = l.pt[i][d] - 0.5;
        ASSERT_CLOSE(ix__len3(x), 1.0 / 3, 1e-13);
    }
    ix_lines_free(ctx, &l);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, k);
}

static void errors(void **state)
{
    static const double none[4][3][3] = {{{0}}}, up[4][3][3] = {[1] = {{1}}};
    const int cells[3] = {2, 2, 2}, zero[3] = {2, 0, 2};
    const int many[3] = {1000, 1000, 1000};
    ix_mv *flat = graph(none), *m = graph(up), *p;
    ix_lines l;

    (void)state;
    assert_int_equal(ix_tv_fold(ctx, flat, cells, true, &l), IX_EDOMAIN);
    assert_int_equal(ix_tv_fold(ctx, m, zero, true, &l), IX_EARG);
    assert_int_equal(ix_tv_fold(ctx, m, many, true, &l), IX_EUNABLE);
    assert_int_equal(l.n, 0);
    ASSERT_OK(ctx, ix_tv_fold(ctx, m, cells, true, &l)); /* no fold */
    assert_int_equal(l.n, 0);
    ix_lines_free(ctx, &l);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 2, false, &p));
    assert_int_equal(ix_tv_fold(ctx, p, cells, true, &l), IX_EARG);
    ix_mv_unref(ctx, p);
    ASSERT_OK(ctx, ix_mv_fix(ctx, m, 0, 0.5, &p));
    assert_int_equal(ix_tv_fold(ctx, p, cells, true, &l), IX_EARG);
    ix_mv_unref(ctx, p);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, flat);
}

static void make(ix_ctx *c, ix_build_case *f)
{
    ix_ctx *keep = ctx;

    ctx = c; /* for ball */
    f->in[0] = ball();
    ctx = keep;
}

static ix_status build(ix_ctx *c, const ix_build_case *f, ix_mv **out)
{
    static const int cells[3] = {2, 2, 2};
    ix_lines l;

    IX_TRY(ix_tv_fold(c, f->in[0], cells, true, &l));
    ix_lines_free(c, &l);
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void every_allocation_fails(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(determinant),
        cmocka_unit_test(folded_sheet),
        cmocka_unit_test(sphere),
        cmocka_unit_test(knots),
        cmocka_unit_test(errors),
        cmocka_unit_test(every_allocation_fails)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
