/* Self-intersections and antipodal points of surfaces: extruded curves against
 * those of the curve, refined surfaces against themselves, both against the
 * definition and against Newton's method from many starts. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "solve/small.h"

/* A curve with loops in the plane z = 0: its control points go around twice and
 * more, by 2.2 radians a step. Narrow loops would be costly. */
static ix_mv *loopy(gt *t, int n, const double *knots, int order)
{
    double p[3 * 12] = {0};

    for (int i = 0; i < n; i++) {
        double r = ix_rng_range(&t->r, 1.5, 2);

        p[i] = r * cos(2.2 * i);
        p[n + i] = r * sin(2.2 * i);
    }
    return gt_curve(t, order, n, knots, 3, false, p);
}

static double gap(gt *t, const ix_mv *s, const double *x)
{
    double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

    gt_point(t, s, x, p);
    gt_point(t, s, x + 2, q);
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

/* Law: the extrusion of a plane curve meets itself in one straight line from
 * v = 0 to 1 for each self-intersection of the curve, at its parameters. */
static void extruded_curves(void **state)
{
    const double kv[10] = {0, 0, 0, 1, 2, 3, 4, 5, 5, 5};
    const double up[3] = {0.1, -0.2, 1};
    gt t = gt_begin(1);
    int all = 0;

    (void)state;
    for (int k = 0; k < 6; k++) {
        ix_mv *c = k % 2 ? loopy(&t, 7, kv, 3)
                         : loopy(&t, 4 + k % 3, NULL, 4 + k % 3);
        ix_solution_curves s;
        ix_solutions want;
        ix_mv *srf;

        ASSERT_OK(t.ctx, ix_crv_self_meet(t.ctx, c, &want));
        ASSERT_OK(t.ctx, ix_srf_extrude(t.ctx, c, up, &srf));
        ASSERT_OK(t.ctx, ix_srf_self_meet(t.ctx, srf, 1e-3, &s));
        assert_true(s.complete);
        assert_int_equal(s.ncurves, want.n);
        for (int i = 0; i < s.ncurves; i++) {
            const double *x = s.curve[i].x, *y = x + 4 * (s.curve[i].n - 1);
            double best = HUGE_VAL;

            for (int j = 0; j < want.n; j++) {
                const double *w = want.sol[j].x;

                best = fmin(best, fmin(hypot(x[0] - w[0], x[2] - w[1]),
                                       hypot(x[0] - w[1], x[2] - w[0])));
            }
            assert_true(best < 1e-9 && fabs(x[0] - y[0]) < 1e-9);
            assert_true(fabs(x[1] - y[1]) > 1 - 1e-12); /* all of v */
        }
        all += s.ncurves;
        ix_solution_curves_free(t.ctx, &s);
        ix_solutions_free(t.ctx, &want);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, srf);
    }
    assert_true(all > 5);
    gt_end(&t);
}

/* A lip that folds over itself: a curve that ends at a pinch point. */
static ix_mv *lip(gt *t, double shake)
{
    const double x[16] = {0, 3, -2, 1, 0, 3.3, -2,  1,
                          0, 2, -1, 1, 0, 0.5, 0.5, 1};
    double p[48];
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 4, .length = 4},
                         {.basis = IX_BEZIER, .order = 4, .length = 4}};
    ix_mv *m;

    for (int i = 0; i < 16; i++) {
        p[i] = x[i] + ix_rng_range(&t->r, -shake, shake);
        p[16 + i] = i / 4;
        p[32 + i] = i % 4 == 1 || i % 4 == 2 ? 2 : 0;
        p[32 + i] += ix_rng_range(&t->r, -shake, shake);
    }
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, false, p, &m));
    return m;
}

static double length_of(gt *t, const ix_mv *s, const ix_solution_curves *c)
{
    double sum = 0, p[2][IX_MAX_COORDS];

    for (int i = 0; i < c->ncurves; i++)
        for (int k = 0; k < c->curve[i].n; k++) {
            gt_point(t, s, c->curve[i].x + 4 * k, p[k % 2]);
            if (k)
                sum += sqrt(pow(p[0][0] - p[1][0], 2) +
                            pow(p[0][1] - p[1][1], 2) +
                            pow(p[0][2] - p[1][2], 2));
        }
    return sum;
}

/* Law: knots do not matter, wherever they cut the curve; all vertices are
 * pairs of one point. */
static void refined_surfaces(void **state)
{
    gt t = gt_begin(2);

    (void)state;
    for (int k = 0; k < 2; k++) {
        const double cu[2] = {ix_rng_range(&t.r, 0.2, 0.45),
                              ix_rng_range(&t.r, 0.55, 0.8)};
        const double cv = ix_rng_range(&t.r, 0.3, 0.7);
        ix_mv *s = lip(&t, 0.1), *a, *b;
        ix_solution_curves one, many;

        ASSERT_OK(t.ctx, ix_mv_insert_knots(t.ctx, s, 0, 2, cu, &a));
        ASSERT_OK(t.ctx, ix_mv_insert_knots(t.ctx, a, 1, 1, &cv, &b));
        ASSERT_OK(t.ctx, ix_srf_self_meet(t.ctx, s, 1e-3, &one));
        ASSERT_OK(t.ctx, ix_srf_self_meet(t.ctx, b, 1e-3, &many));
        assert_true(one.ncurves > 0 && one.complete && many.complete);
        assert_int_equal(one.ncurves, many.ncurves);
        /* chords of polylines within 1e-3 of the curve, and its end, the pinch
           point, which is known to its box */
        ASSERT_CLOSE(length_of(&t, s, &one), length_of(&t, b, &many), 5e-3);
        for (int i = 0; i < many.ncurves; i++)
            for (int j = 0; j < many.curve[i].n; j++)
                assert_true(gap(&t, b, many.curve[i].x + 4 * j) < 1e-12);
        ix_solution_curves_free(t.ctx, &one);
        ix_solution_curves_free(t.ctx, &many);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
    }
    gt_end(&t);
}

/* Graphs do not meet themselves, nor does a cylinder at its seam. */
static void none(void **state)
{
    const double zero[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    gt t = gt_begin(3);
    ix_solution_curves s;
    ix_mv *c, *m, *cut;

    (void)state;
    for (int k = 0; k < 3; k++) {
        const double mid[2] = {0.25, 0.7};
        double p[48];
        const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 4, .length = 4},
                             {.basis = IX_BEZIER, .order = 4, .length = 4}};

        for (int i = 0; i < 16; i++) {
            p[i] = i % 4;
            p[16 + i] = i / 4;
            p[32 + i] = ix_rng_range(&t.r, -3, 3);
        }
        ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, p, &m));
        ASSERT_OK(t.ctx, ix_mv_insert_knots(t.ctx, m, 0, 2, mid, &cut));
        ASSERT_OK(t.ctx, ix_srf_self_meet(t.ctx, cut, 1e-3, &s));
        assert_int_equal(s.ncurves, 0);
        assert_true(s.complete);
        ix_mv_unref(t.ctx, m);
        ix_mv_unref(t.ctx, cut);
    }
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_srf_extrude(t.ctx, c, up, &m));
    ASSERT_OK(t.ctx, ix_srf_self_meet(t.ctx, m, 1e-3, &s));
    assert_int_equal(s.ncurves, 0);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, m);
    gt_end(&t);
}

/* --- antipodal points ------------------------------------------------------
 */

/* Gradient of |S(u,v) - S(s,t)|^2 / 2, and its derivatives by differences. */
static void gradient(gt *t, const ix_mv *m, const double *x, double *g)
{
    double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

    gt_point(t, m, x, p);
    gt_point(t, m, x + 2, q);
    for (int k = 0; k < 4; k++) {
        double d[3];

        ASSERT_OK(t->ctx, ix_srf_tangent(t->ctx, m, k % 2, x[k / 2 * 2],
                                         x[k / 2 * 2 + 1], d));
        g[k] = 0;
        for (int c = 0; c < 3; c++)
            g[k] += (k < 2 ? 1 : -1) * d[c] * (p[c] - q[c]);
    }
}

/* Newton's method from x; false if it leaves or stalls. */
static bool newton(gt *t, const ix_mv *m, double *x)
{
    for (int it = 0; it < 30; it++) {
        double g[4], h[4], y[4], size = 0;
        ix__mat jac, inv;

        gradient(t, m, x, g);
        for (int k = 0; k < 4; k++) {
            memcpy(y, x, sizeof y);
            y[k] += 1e-6;
            gradient(t, m, y, h);
            for (int i = 0; i < 4; i++)
                jac[i][k] = (h[i] - g[i]) / 1e-6;
        }
        if (!ix__small_invert(4, jac, inv))
            return false;
        for (int i = 0; i < 4; i++) {
            double step = 0;

            for (int k = 0; k < 4; k++)
                step += inv[i][k] * g[k];
            x[i] -= step;
            size = fmax(size, fabs(step));
            if (!(x[i] >= 0 && x[i] <= 1 - 2e-6))
                return false;
        }
        if (size < 1e-11)
            return gap(t, m, x) > 1e-3;
    }
    return false;
}

/* Law: certified pairs are stationary, in order, and every pair that Newton's
 * method finds from random starts is among them. */
static void antipodal_pairs(void **state)
{
    gt t = gt_begin(4);
    int all = 0, found = 0;

    (void)state;
    for (int k = 0; k < 3; k++) {
        const double kv[7] = {0, 0, 0, 0.5, 1, 1, 1};
        const double flat[6] = {0, 0, 0, 1, 1, 1}, cut = 0.4;
        const ix_dir d[2] = {{IX_BSPLINE, 3, 4, false, kv},
                             {IX_BSPLINE, 3, 3, false, flat}};
        ix_solutions s;
        double p[36];
        ix_mv *m, *b;

        for (int i = 0; i < 12; i++) { /* a trough with overhanging sides,
                                          narrower in the middle */
            const double x[4] = {-1, -2, 2, 1}, z[4] = {1, -1, -1, 1};
            double wide = i / 4 == 1 ? 1 : 1.3;

            p[i] = wide * x[i % 4] + ix_rng_range(&t.r, -0.1, 0.1);
            p[12 + i] = i / 4 - 1;
            p[24 + i] = z[i % 4] + ix_rng_range(&t.r, -0.1, 0.1);
        }
        ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, p, &m));
        ASSERT_OK(t.ctx, ix_mv_insert_knots(t.ctx, m, 0, 1, &cut, &b));
        ASSERT_OK(t.ctx, ix_srf_antipodal(t.ctx, k % 2 ? b : m, &s));
        assert_true(s.complete);
        for (int i = 0; i < s.n; i++) {
            double g[4];

            gradient(&t, m, s.sol[i].x, g);
            assert_true(s.sol[i].x[0] <= s.sol[i].x[2]);
            for (int c = 0; c < 4 && s.sol[i].certified; c++)
                assert_true(fabs(g[c]) < 1e-10);
        }
        all += s.n;
        for (int trial = 0; trial < 150; trial++) {
            double x[4], best = HUGE_VAL;

            for (int c = 0; c < 4; c++)
                x[c] = ix_rng_range(&t.r, 0, 1);
            if (!newton(&t, m, x))
                continue;
            found++;
            for (int i = 0; i < s.n; i++)
                for (int swap = 0; swap < 2; swap++) {
                    double far = 0;

                    for (int c = 0; c < 4; c++)
                        far = fmax(far,
                                   fabs(x[c] - s.sol[i].x[(c + 2 * swap) % 4]));
                    best = fmin(best, far);
                }
            assert_true(best < 1e-8);
        }
        ix_solutions_free(t.ctx, &s);
        ix_mv_unref(t.ctx, m);
        ix_mv_unref(t.ctx, b);
    }
    assert_true(all >= 3 && found > 10);
    gt_end(&t);
}

static void errors(void **state)
{
    const double flat[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};
    gt t = gt_begin(5);
    ix_solution_curves s;
    ix_solutions p;
    ix_mv *c = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 3), *f;

    (void)state;
    assert_int_equal(ix_srf_self_meet(t.ctx, c, 0, &s), IX_EARG);
    assert_int_equal(ix_srf_antipodal(t.ctx, c, &p), IX_EARG);
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 2, false, flat, &f));
    assert_int_equal(ix_srf_self_meet(t.ctx, f, 0, &s), IX_EDOMAIN);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, f);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[9] = {0, 1, 0, 0, 1, 2, 0, 0, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};
    const double up[3] = {0, 0, 1}, cut = 0.5;
    ix_mv *c, *s;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, false, p, &c));
    ASSERT_OK(ctx, ix_srf_extrude(ctx, c, up, &s));
    ASSERT_OK(ctx, ix_mv_insert_knots(ctx, s, 0, 1, &cut, &f->in[0]));
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_solution_curves s;

    IX_TRY(ix_srf_self_meet(ctx, f->in[0], 1e-2, &s));
    ix_solution_curves_free(ctx, &s);
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extruded_curves),
        cmocka_unit_test(refined_surfaces),
        cmocka_unit_test(none),
        cmocka_unit_test(antipodal_pairs),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
