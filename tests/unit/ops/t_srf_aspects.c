/* Views at which outlines change: a torus by its circles, parabolic points and
 * their asymptotic directions, swallowtails by the number of cusps on either
 * side, errors, failing allocations. */
#include <stdlib.h>

#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/contour.h"
#include "iritx/ops_srf.h"
#include "line_test.h"
#include "torus_test.h"

IX_TEST_FIXTURE(1992)

/* Vertices are on the sphere; chords are near it, and the second of each pair
 * of lines is the first one's antipode. */
static void on_the_sphere(const ix_lines *l, double tol)
{
    size_t at = 0;

    for (int i = 0; i < l->n; i++) {
        for (int k = 0; k < l->count[i]; k++, at++) {
            double mid[3];

            ASSERT_CLOSE(ix__len3(l->pt[at]), 1, 1e-14);
            if (k > 0) {
                ix__axpy3(l->pt[at], 1, l->pt[at - 1], mid);
                assert_true(1 - 0.5 * ix__len3(mid) <= tol);
            }
            if (i % 2) {
                ix__axpy3(l->pt[at], 1, l->pt[at - (size_t)l->count[i]], mid);
                assert_true(ix__len3(mid) <= 0);
            }
        }
        assert_true(i % 2 == 0 || l->count[i] == l->count[i - 1]);
    }
    assert_int_equal(l->n % 2, 0);
}

/* Distance of d from the polylines. */
static double distance_to(const ix_lines *l, const double d[3])
{
    double best = HUGE_VAL, e[3], off[3], t;
    size_t at = 0;

    for (int i = 0; i < l->n; at += (size_t)l->count[i++])
        for (int k = 1; k < l->count[i]; k++) {
            const double *a = l->pt[at + (size_t)k - 1];

            ix__sub3(l->pt[at + (size_t)k], a, e);
            ix__sub3(d, a, off);
            t = ix__dot3(off, e) / ix__dot3(e, e);
            ix__axpy3(off, -fmin(fmax(t, 0), 1), e, off);
            best = fmin(best, ix__len3(off));
        }
    return best;
}

#define TOL 1e-2

/* A torus: seen from the side of its top, the equator of views; swallowtails of
 * the inner equator, whose asymptotic directions have the height sqrt(r / R) by
 * Euler's theorem, and again of the circles on top and bottom. */
static void torus(void **state)
{
    ix_mv *t = lt_torus(ctx);
    double height = sqrt(1.0 / 3);
    ix_aspects a;
    size_t at = 0;

    (void)state;
    ASSERT_OK(ctx, ix_srf_aspects(ctx, t, TOL, &a));
    assert_true(a.complete);
    on_the_sphere(&a.parabolic, TOL);
    on_the_sphere(&a.swallowtail, TOL);
    for (int i = 0; i < a.parabolic.n; i++)
        for (int k = 0; k < a.parabolic.count[i]; k++)
            assert_true(fabs(a.parabolic.pt[at++][2]) < 1e-12);
    at = 0;
    for (int i = 0; i < a.swallowtail.n; i++)
        for (int k = 0; k < a.swallowtail.count[i]; k++, at++) {
            double z = fabs(a.swallowtail.pt[at][2]);

            assert_true(z < 1e-12 || fabs(z - height) < 1e-12);
        }
    for (int i = 0; i < 100; i++) {
        double phi = 0.0628 * i, w = sqrt(1 - height * height);
        double d[3] = {cos(phi), sin(phi), 0};
        double e[3] = {w * d[0], w * d[1], height};

        assert_true(distance_to(&a.parabolic, d) <= TOL);
        assert_true(distance_to(&a.swallowtail, e) <= TOL);
    }
    ix_aspects_free(ctx, &a);
    ix_mv_unref(ctx, t);
}

/* Law: the asymptotic direction of every parabolic point is near the lines. */
static void parabolic_points(void **state)
{
    ix_mv *s = lt_random(ctx, &rng, 3, 3, false);
    ix_solution_curves c;
    ix_aspects a;
    int seen = 0;

    (void)state;
    ASSERT_OK(ctx, ix_srf_parabolic(ctx, s, 1e-3, &c));
    ASSERT_OK(ctx, ix_srf_aspects(ctx, s, TOL, &a));
    on_the_sphere(&a.parabolic, TOL);
    for (int i = 0; i < c.ncurves; i++)
        for (int k = 0; k < c.curve[i].n; k += 3) {
            const double *x = c.curve[i].x + 2 * (size_t)k;
            ix_principal p;
            int small;

            ASSERT_OK(ctx, ix_srf_principal(ctx, s, x[0], x[1], &p));
            small = fabs(p.k[0]) < fabs(p.k[1]) ? 0 : 1;
            assert_true(distance_to(&a.parabolic, p.dir[small]) <= TOL);
            seen++;
        }
    assert_true(seen > 10);
    ix_solution_curves_free(ctx, &c);
    ix_aspects_free(ctx, &a);
    ix_mv_unref(ctx, s);
}

static int cusps(const ix_mv *s, const double view[3])
{
    ix_solutions p;
    int n;

    ASSERT_OK(ctx, ix_silhouette_inflections(ctx, s, view, &p));
    n = p.n;
    ix_solutions_free(ctx, &p);
    return n;
}

/* Law: two cusps of the outline come or go as the view crosses the curve (steps
 * of 0.001 across it, where vertices are far apart). */
static void swallowtails(void **state)
{
    ix_mv *s = lt_random(ctx, &rng, 3, 3, false);
    int tried = 0, changed = 0;
    ix_aspects a;
    size_t at = 0;

    (void)state;
    ASSERT_OK(ctx, ix_srf_aspects(ctx, s, TOL, &a));
    on_the_sphere(&a.swallowtail, TOL);
    for (int i = 0; i < a.swallowtail.n;
         at += (size_t)a.swallowtail.count[i++]) {
        const double(*p)[3] = (const double(*)[3])a.swallowtail.pt + at;
        int n = a.swallowtail.count[i], k = n / 4;
        double along[3], across[3], v[2][3];

        if (n < 5 || i % 2)
            continue;
        for (int e = n / 4; e < 3 * n / 4; e++) /* no cusp, no end */
            if (ix__dist3(p[e + 1], p[e - 1]) > ix__dist3(p[k + 1], p[k - 1]))
                k = e;
        ix__sub3(p[k + 1], p[k - 1], along);
        ix__cross3(p[k], along, across);
        ix__unit3(across, across);
        for (int e = 0; e < 2; e++)
            ix__axpy3(p[k], e ? 0.001 : -0.001, across, v[e]);
        tried++;
        changed += abs(cusps(s, v[0]) - cusps(s, v[1])) == 2;
    }
    assert_true(tried >= 2);
    assert_int_equal(changed, tried);
    ix_aspects_free(ctx, &a);
    ix_mv_unref(ctx, s);
}

static void errors(void **state)
{
    static const double flat[4] = {0, 1, 2, 3}, saddle[4] = {0, 0, 0, 1};
    ix_mv *s = lt_bilinear(ctx, flat), *t = lt_bilinear(ctx, saddle), *c;
    ix_aspects a;

    (void)state;
    assert_int_equal(ix_srf_aspects(ctx, s, TOL, &a), IX_EDOMAIN);
    assert_int_equal(ix_srf_aspects(ctx, t, TOL, &a), IX_EDOMAIN);
    assert_int_equal(a.parabolic.n + a.swallowtail.n, 0);
    ASSERT_OK(ctx, ix_mv_layer(ctx, s, 0, 0, &c));
    assert_int_equal(ix_srf_aspects(ctx, c, TOL, &a), IX_EARG);
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, t, 2, false, &c));
    assert_true(ix_srf_aspects(ctx, c, TOL, &a) != IX_OK);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, t);
}

static void make(ix_ctx *c, ix_build_case *f)
{
    const ix_dir dirs[2] = {{IX_BEZIER, 3, 3, false, NULL},
                            {IX_BEZIER, 3, 3, false, NULL}};
    static const double z[9] = {0, 0, 1, 0, 0, 1, 1, 1, 1.62};
    double pts[27];

    for (int i = 0; i < 9; i++) {
        pts[i] = 0.5 * (i % 3);
        pts[9 + i] = 0.5 * (double)(i / 3);
        pts[18 + i] = z[i];
    }
    ASSERT_OK(c, ix_mv_new(c, 2, dirs, 3, false, pts, &f->in[0]));
}

static ix_status build(ix_ctx *c, const ix_build_case *f, ix_mv **out)
{
    ix_aspects a;

    IX_TRY(ix_srf_aspects(c, f->in[0], 0.5, &a));
    ix_aspects_free(c, &a);
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
        cmocka_unit_test(torus), cmocka_unit_test(parabolic_points),
        cmocka_unit_test(swallowtails), cmocka_unit_test(errors),
        cmocka_unit_test(every_allocation_fails)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
