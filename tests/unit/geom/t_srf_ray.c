/* Rays through surfaces, inflections of silhouettes: against closed forms and
 * the definitions. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/contour.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"

static ix_mv *graph(gt *t, int n, double size)
{
    double p[75];
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = n, .length = n},
                         {.basis = IX_BEZIER, .order = n, .length = n}};
    ix_mv *m;

    for (int i = 0; i < n * n; i++) {
        p[i] = i % n;
        p[n * n + i] = i / n;
        p[2 * n * n + i] = ix_rng_range(&t->r, -size, size);
    }
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, false, p, &m));
    return m;
}

/* Law: a ray through a point of the surface meets it there, hits are on the ray
 * and on the surface, in order; a vertical ray meets a graph once. */
static void rays(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *s = graph(&t, 3 + k % 2, 3);
        double uv[2] = {ix_rng_range(&t.r, 0.05, 0.95),
                        ix_rng_range(&t.r, 0.05, 0.95)};
        double x[IX_MAX_COORDS], p[3], d[3], best = HUGE_VAL;
        bool vertical = k % 3 == 0;
        ix_solutions h;

        gt_point(&t, s, uv, x);
        for (int c = 0; c < 3; c++) {
            d[c] = vertical ? (c == 2 ? -2 : 0) : ix_rng_range(&t.r, -1, 1);
            p[c] = x[c] - 2.5 * d[c];
        }
        ASSERT_OK(t.ctx, ix_srf_ray(t.ctx, s, p, d, &h));
        assert_true(h.n >= 1 && (!vertical || h.n == 1));
        for (int i = 0; i < h.n; i++) {
            double y[IX_MAX_COORDS];

            gt_point(&t, s, h.sol[i].x, y);
            for (int c = 0; c < 3; c++)
                ASSERT_CLOSE(y[c], p[c] + h.sol[i].x[2] * d[c], 1e-11);
            assert_true(h.sol[i].x[2] >= 0);
            assert_true(!i || h.sol[i].x[2] >= h.sol[i - 1].x[2]);
            best = fmin(best, fabs(h.sol[i].x[2] - 2.5));
        }
        assert_true(best < 1e-9);
        ix_solutions_free(t.ctx, &h);
        for (int c = 0; c < 3; c++)
            d[c] = -d[c]; /* away from the surface */
        ASSERT_OK(t.ctx, ix_srf_ray(t.ctx, s, p, d, &h));
        assert_true(!vertical || h.n == 0);
        ix_solutions_free(t.ctx, &h);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: at an inflection the normal is across the view, and the surface curves
 * neither way along it: <N, view> and its derivative along the view vanish. */
static void silhouette_inflections(void **state)
{
    gt t = gt_begin(2);
    int all = 0;

    (void)state;
    for (int k = 0; k < 20; k++) {
        ix_mv *s = graph(&t, 4, 6);
        double view[3], du[3], dv[3], n[3];
        ix_solutions h;

        for (int c = 0; c < 3; c++)
            view[c] = ix_rng_range(&t.r, -1, 1) + (c == 0);
        ASSERT_OK(t.ctx, ix_silhouette_inflections(t.ctx, s, view, &h));
        for (int i = 0; i < h.n; i++) {
            double *x = h.sol[i].x, f[2], det, a, b;

            ASSERT_OK(t.ctx, ix_srf_tangent(t.ctx, s, 0, x[0], x[1], du));
            ASSERT_OK(t.ctx, ix_srf_tangent(t.ctx, s, 1, x[0], x[1], dv));
            /* view = a du + b dv, by the first two coordinates */
            det = du[0] * dv[1] - du[1] * dv[0];
            a = (view[0] * dv[1] - view[1] * dv[0]) / det;
            b = (du[0] * view[1] - du[1] * view[0]) / det;
            ASSERT_CLOSE(a * du[2] + b * dv[2], view[2], 1e-8);
            for (int e = 0; e < 2; e++) {
                double h1 = e ? 1e-5 : -1e-5;

                ASSERT_OK(t.ctx, ix_srf_normal(
                                     t.ctx, s, fmin(1, fmax(0, x[0] + h1 * a)),
                                     fmin(1, fmax(0, x[1] + h1 * b)), n));
                f[e] = n[0] * view[0] + n[1] * view[1] + n[2] * view[2];
            }
            if (x[0] > 1e-4 && x[0] < 1 - 1e-4 && x[1] > 1e-4 &&
                x[1] < 1 - 1e-4)
                assert_true(fabs(f[1] - f[0]) / 2e-5 < 1e-3);
        }
        all += h.n;
        ix_solutions_free(t.ctx, &h);
        ix_mv_unref(t.ctx, s);
    }
    assert_true(all > 5);
    gt_end(&t);
}

static void errors(void **state)
{
    const double zero[3] = {0, 0, 0}, one[3] = {1, 0, 0};
    gt t = gt_begin(4);
    ix_mv *s = graph(&t, 3, 1), *c = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 3);
    ix_solutions h;

    (void)state;
    assert_int_equal(ix_srf_ray(t.ctx, s, zero, zero, &h), IX_EARG);
    assert_int_equal(ix_srf_ray(t.ctx, c, zero, one, &h), IX_EARG);
    assert_int_equal(ix_silhouette_inflections(t.ctx, s, zero, &h), IX_EARG);
    assert_int_equal(ix_silhouette_inflections(t.ctx, c, one, &h), IX_EARG);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double p[3] = {0.5, 0.5, 3}, d[3] = {0, 0, -1}, v[3] = {1, 0.2, 0};
    ix_solutions h;

    IX_TRY(ix_srf_ray(ctx, f->in[0], p, d, &h));
    ix_solutions_free(ctx, &h);
    IX_TRY(ix_silhouette_inflections(ctx, f->in[0], v, &h));
    ix_solutions_free(ctx, &h);
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
        cmocka_unit_test(rays),
        cmocka_unit_test(silhouette_inflections),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
