/* Radial curvature: its definition at the vertices, a paraboloid by its
 * equation, completeness on a grid, silhouettes, errors, allocations. */
#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/contour.h"
#include "line_test.h"
#include "ops/surface.h"

IX_TEST_FIXTURE(1984)

/* II(w, w) / I(w, w) for the projection w of view, and |w|. */
static double radial_at(const ix_mv *s, const double view[3], const double *uv,
                        double w[3], double *len)
{
    double n[3], p, q, a, b, det;
    ix_srf_jet j;

    ASSERT_OK(ctx, ix__srf_jet(ctx, s, uv[0], uv[1], &j));
    ix__unit3(j.n, n);
    ix__axpy3(view, -ix__dot3(view, n), n, w);
    *len = ix__len3(w);
    p = ix__dot3(w, j.su);
    q = ix__dot3(w, j.sv);
    det = j.g[0] * j.g[2] - j.g[1] * j.g[1];
    a = (j.g[2] * p - j.g[1] * q) / det;
    b = (j.g[0] * q - j.g[1] * p) / det;
    return (j.b[0] * a * a + 2 * j.b[1] * a * b + j.b[2] * b * b) /
           (*len * *len);
}

/* Law: the normal curvature along the projected view is 0, and that is the
 * direction; curvatures are of the order of 1, vertices right to rounding. */
static void definition(void **state)
{
    static const double view[3] = {0.3, -0.8, 0.6};

    (void)state;
    for (int r = 0; r < 2; r++) {
        ix_mv *s = lt_random(ctx, &rng, 3, 2, r == 1);
        ix_solution_curves c;

        ASSERT_OK(ctx, ix_srf_radial(ctx, s, view, 1e-3, &c));
        assert_true(c.complete && c.ncurves > 0);
        assert_int_equal(c.unknowns, 4);
        for (int i = 0; i < c.ncurves; i++)
            for (int k = 0; k < c.curve[i].n; k++) {
                const double *x = c.curve[i].x + 4 * (size_t)k;
                double w[3], len, off[3], d[3];
                ix_srf_jet j;

                assert_true(fabs(radial_at(s, view, x, w, &len)) < 1e-9);
                ASSERT_OK(ctx, ix__srf_jet(ctx, s, x[0], x[1], &j));
                for (int e = 0; e < 3; e++)
                    d[e] = x[2] * j.su[e] + x[3] * j.sv[e];
                ix__cross3(d, w, off);
                assert_true(ix__len3(off) < 1e-9);
                assert_true(ix__dot3(d, w) > 0);
                ASSERT_CLOSE(hypot(x[2], x[3]), 1, 1e-12);
            }
        ix_solution_curves_free(ctx, &c);
        ix_mv_unref(ctx, s);
    }
}

/* z = u v: asymptotic are u = const and v = const, so that the projected view
 * has no part along one of them. */
static void saddle(void **state)
{
    static const double z[4] = {0, 0, 0, 1}, v[3] = {0.4, -0.3, -0.9};
    ix_mv *s = lt_bilinear(ctx, z);
    ix_solution_curves c;
    int hits[2] = {0};

    (void)state;
    ASSERT_OK(ctx, ix_srf_radial(ctx, s, v, 1e-3, &c));
    for (int i = 0; i < c.ncurves; i++)
        for (int k = 0; k < c.curve[i].n; k++) {
            const double *x = c.curve[i].x + 4 * (size_t)k;
            double p[2] = {
                v[0] * (1 + x[0] * x[0]) + x[1] * v[2] - x[0] * x[1] * v[1],
                v[1] * (1 + x[1] * x[1]) + x[0] * v[2] - x[0] * x[1] * v[0]};
            int which = fabs(p[0]) < fabs(p[1]) ? 0 : 1;

            assert_true(fabs(p[which]) < 1e-12);
            assert_true(fabs(x[2 + which]) < 1e-9);
            hits[which]++;
        }
    assert_true(hits[0] + hits[1] > 2);
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, s);
}

#define CELLS 40

static double distance_to(const ix_solution_curves *c, const double *uv)
{
    double best = HUGE_VAL;

    for (int i = 0; i < c->ncurves; i++)
        for (int k = 0; k < c->curve[i].n; k++) {
            const double *x = c->curve[i].x + 4 * (size_t)k;

            best = fmin(best, hypot(x[0] - uv[0], x[1] - uv[1]));
        }
    return best;
}

/* Where the curvature has different signs at two neighbours of a grid, a curve
 * passes: none is missing, and the field has the sign of the curvature. */
static void complete(void **state)
{
    static const double view[3] = {1, 0.2, 0.1};
    ix_mv *s = lt_random(ctx, &rng, 3, 3, false), *f;
    ix_solution_curves c;
    double last = 0;
    int changes = 0;

    (void)state;
    ASSERT_OK(ctx, ix_srf_radial(ctx, s, view, 1e-4, &c));
    ASSERT_OK(ctx, ix_srf_radial_field(ctx, s, view, &f));
    for (int i = 0; i < CELLS * CELLS; i++) {
        double uv[2] = {(i % CELLS + 0.5) / CELLS,
                        ((double)(i / CELLS) + 0.5) / CELLS};
        double w[3], len, k = radial_at(s, view, uv, w, &len), value;

        ASSERT_OK(ctx, ix_mv_eval(ctx, f, uv, &value));
        assert_true(fabs(k) < 1e-6 || (k > 0) == (value > 0));
        if (i % CELLS > 0 && (k > 0) != (last > 0)) {
            changes++;
            assert_true(distance_to(&c, uv) < 4.0 / CELLS);
        }
        last = k;
    }
    assert_true(changes > 5);
    ix_mv_unref(ctx, f);
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, s);
}

/* Law: where a silhouette runs along the view, radial curvature is zero. */
static void ends_of_contours(void **state)
{
    static const double view[3] = {1, 0.1, 0.05};
    int n = 0;

    (void)state;
    for (int i = 0; i < 3; i++) {
        ix_mv *s = lt_random(ctx, &rng, 3, 3, false);
        ix_solutions p;

        ASSERT_OK(ctx, ix_silhouette_inflections(ctx, s, view, &p));
        for (int k = 0; k < p.n; k++) {
            double w[3], len;

            assert_true(fabs(radial_at(s, view, p.sol[k].x, w, &len)) < 1e-8);
        }
        n += p.n;
        ix_solutions_free(ctx, &p);
        ix_mv_unref(ctx, s);
    }
    assert_true(n > 0);
}

/* Head on, four arms meet; they have directions all the same. */
static void head_on(void **state)
{
    static const double z[4] = {0, 0, 0, 1}, view[3] = {-0.5, -0.5, 1};
    ix_mv *s = lt_bilinear(ctx, z); /* its normal at (1/2, 1/2) */
    ix_solution_curves c;
    int arms = 0;

    (void)state;
    ASSERT_OK(ctx, ix_srf_radial(ctx, s, view, 1e-3, &c));
    for (int i = 0; i < c.ncurves; i++) {
        arms += (c.curve[i].start == IX_END_SINGULAR) +
                (c.curve[i].end == IX_END_SINGULAR);
        for (int k = 0; k < c.curve[i].n; k++)
            ASSERT_CLOSE(
                hypot(c.curve[i].x[4 * k + 2], c.curve[i].x[4 * k + 3]), 1,
                1e-12);
    }
    assert_int_equal(arms, 4);
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, s);
}

/* A parabola moved along z. */
static ix_mv *gutter(void)
{
    const ix_dir dirs[2] = {{IX_BEZIER, 3, 3, false, NULL},
                            {IX_BEZIER, 2, 2, false, NULL}};
    static const double pts[18] = {0, 1, 2, 0, 1, 2, 0, 2, 0,
                                   0, 2, 0, 0, 0, 0, 1, 1, 1};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 3, false, pts, &m));
    return m;
}

/* A dome, v = 0 its top: no curve, although the field vanishes along that edge.
 */
static void pole(void **state)
{
    const ix_dir dirs[2] = {{IX_BEZIER, 3, 3, false, NULL},
                            {IX_BEZIER, 3, 3, false, NULL}};
    /* u from x to y, v down */
    static const double pts[27] = {0, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0, 0, 1,
                                   1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0};
    static const double view[3] = {0.2, 0.3, 0.1};
    ix_solution_curves c;
    ix_mv *s;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 3, false, pts, &s));
    ASSERT_OK(ctx, ix_srf_radial(ctx, s, view, 1e-2, &c));
    assert_int_equal(c.ncurves, 0);
    ix_solution_curves_free(ctx, &c);
    ix_mv_unref(ctx, s);
}

static void expect(ix_mv *s, const double view[3], ix_status want)
{
    ix_solution_curves c;

    assert_int_equal(ix_srf_radial(ctx, s, view, 1e-3, &c), want);
    assert_int_equal(c.ncurves, 0);
}

static void errors(void **state)
{
    static const double flat[4] = {0, 1, 2, 3}, none[3] = {0, 0, 0};
    static const double along[3] = {0, 0, 1};
    ix_mv *c, *s, *f;

    (void)state;
    s = lt_bilinear(ctx, flat);
    expect(s, along, IX_EDOMAIN);
    expect(s, none, IX_EARG);
    assert_int_equal(ix_srf_radial_field(ctx, s, none, &f), IX_EARG);
    assert_null(f);
    ix_mv_unref(ctx, s);
    s = gutter();
    expect(s, along, IX_EDOMAIN); /* the view is a ruling */
    ASSERT_OK(ctx, ix_mv_layer(ctx, s, 0, 0, &c));
    expect(c, along, IX_EARG);
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, c);
}

static void make(ix_ctx *c, ix_build_case *f)
{
    static const double z[4] = {0, 0, 0, 1};

    f->in[0] = lt_bilinear(c, z);
}

static ix_status build(ix_ctx *c, const ix_build_case *f, ix_mv **out)
{
    static const double view[3] = {-0.5, -0.5, 1};
    ix_solution_curves s;

    IX_TRY(ix_srf_radial(c, f->in[0], view, 0.1, &s));
    ix_solution_curves_free(c, &s);
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
        cmocka_unit_test(definition), cmocka_unit_test(saddle),
        cmocka_unit_test(complete),   cmocka_unit_test(ends_of_contours),
        cmocka_unit_test(head_on),    cmocka_unit_test(pole),
        cmocka_unit_test(errors),     cmocka_unit_test(every_allocation_fails)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
