/* Offsets of curves and surfaces against the definition: every point of the
 * result is at the distance from the point of the same parameter, across the
 * tangent; known offsets come back; trimmed pieces keep their distance. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "iritx/offset.h"

/* A smooth planar curve: control points along a circle arc, shaken. */
static ix_mv *arch(gt *t, int n, bool rational)
{
    double p[3 * 8];
    const int order = n;

    for (int i = 0; i < n; i++) {
        double a = 3 * (i - 0.5 * (n - 1)) / (n - 1);
        double w = rational ? ix_rng_range(&t->r, 0.7, 1.4) : 1;

        if (rational)
            p[i] = w;
        p[i + (rational ? n : 0)] = w * (3 * sin(a));
        p[i + (rational ? 2 * n : n)] = w * (-3 * cos(a) +
                                             ix_rng_range(&t->r, -0.1, 0.1));
    }
    return gt_curve(t, order, n, NULL, 2, rational, p);
}

/* Law: |O(t) - C(t) - d N(t)| <= tol, N = (y', -x') / |C'|, at parameters that
 * the function did not look at; with and without interpolation. */
static void plane_offsets_hold_their_tolerance(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c = arch(&t, 4 + k % 4, k % 3 == 0), *o;
        ix_offset_opts how = {.distance = ix_rng_range(&t.r, -0.8, 0.8),
                              .tol = k % 2 ? 1e-3 : 1e-4,
                              .interpolate = k % 5 == 0};
        double err;

        ASSERT_OK(t.ctx, ix_crv_offset(t.ctx, c, &how, &err, &o));
        assert_true(err <= how.tol);
        assert_true(!how.interpolate || !ix_mv_rational(o));
        assert_int_equal(ix_mv_order(o, 0), ix_mv_order(c, 0));
        for (int i = 0; i <= 37; i++) {
            double at = i / 37.0, p[IX_MAX_COORDS], q[IX_MAX_COORDS], tan[3];

            gt_point(&t, c, &at, p);
            gt_point(&t, o, &at, q);
            ASSERT_OK(t.ctx, ix_tangent(t.ctx, c, at, true, tan));
            /* 2: what 8 samples of a smooth error can miss at most */
            assert_true(hypot(q[0] - p[0] - how.distance * tan[1],
                              q[1] - p[1] + how.distance * tan[0]) <=
                        2 * how.tol);
        }
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, o);
    }
    gt_end(&t);
}

/* The circle of three coordinates shrinks, that of two grows; a straight line
 * is exact; a distance that varies linearly too. */
static void known_offsets(void **state)
{
    const double zero[3] = {0, 0, 0}, line[4] = {0, 2, 0, 0};
    const double wide[2] = {0.5, 1};
    gt t = gt_begin(2);
    ix_offset_opts how = {.distance = 0.5, .tol = 1e-4};
    ix_mv *c, *flat, *o, *l, *w;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 2, &c));
    ASSERT_OK(t.ctx, ix_mv_coerce(t.ctx, c, 2, true, &flat));
    for (int k = 0; k < 2; k++) {
        ASSERT_OK(t.ctx, ix_crv_offset(t.ctx, k ? flat : c, &how, NULL, &o));
        for (int i = 0; i <= 50; i++) {
            double at = 4 * i / 50.0, p[IX_MAX_COORDS];

            gt_point(&t, o, &at, p);
            assert_true(fabs(hypot(p[0], p[1]) - (k ? 2.5 : 1.5)) <= how.tol);
        }
        ix_mv_unref(t.ctx, o);
    }
    l = gt_curve(&t, 2, 2, NULL, 2, false, line);
    w = gt_curve(&t, 2, 2, NULL, 1, false, wide);
    how.field = w;
    ASSERT_OK(t.ctx, ix_crv_offset(t.ctx, l, &how, NULL, &o));
    assert_int_equal(ix_mv_npts(o), 2);
    gt_same(ix_mv_coord(o, 1), (double[]){-0.5, -1}, 2, 1e-15);
    ix_mv_unref(t.ctx, o);
    ix_mv_unref(t.ctx, l);
    ix_mv_unref(t.ctx, w);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, flat);
    gt_end(&t);
}

/* The corners of a square are bridged, and the bridges add to the domain. */
static void corners_are_bridged(void **state)
{
    const double kv[7] = {0, 0, 1, 2, 3, 4, 4};
    const double pts[10] = {0, 1, 1, 0, 0, 0, 0, 1, 1, 0};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 2, 5, kv, 2, false, pts), *o;
    const ix_offset_opts how = {.distance = 0.25, .tol = 1e-3};
    double dom[2], len;

    (void)state;
    ASSERT_OK(t.ctx, ix_crv_offset(t.ctx, c, &how, NULL, &o));
    ix_mv_domain(o, 0, dom);
    assert_int_equal(ix_mv_npts(o), 8);
    assert_true(dom[0] == 0 && dom[1] > 4);
    ASSERT_OK(t.ctx, ix_length(t.ctx, o, NULL, &len));
    ASSERT_CLOSE(len, 4 + 3 * 0.25 * sqrt(2), 1e-12);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, o);
    gt_end(&t);
}

/* Law: samples of the exact offset are near the fitted curve, which has the
 * asked order, size and the curve's domain. */
static void fitted_offsets(void **state)
{
    const double zero[3] = {0, 0, 0};
    gt t = gt_begin(4);
    ix_mv *c, *flat, *o;
    double err, dom[2];

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_mv_coerce(t.ctx, c, 2, true, &flat));
    ASSERT_OK(t.ctx,
              ix_crv_offset_fit(t.ctx, flat, 0.25, 200, 24, 4, &err, &o));
    ix_mv_domain(o, 0, dom);
    assert_true(dom[0] == 0 && dom[1] == 4 && err < 1e-3);
    assert_int_equal(ix_mv_npts(o), 24);
    for (int i = 0; i <= 60; i++) {
        double at = 4 * i / 60.0, p[IX_MAX_COORDS];

        gt_point(&t, o, &at, p);
        assert_true(fabs(hypot(p[0], p[1]) - 1.25) < 1e-3);
    }
    ix_mv_unref(t.ctx, o);
    assert_int_equal(ix_crv_offset_fit(t.ctx, flat, 1, 10, 12, 4, NULL, &o),
                     IX_EARG);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, flat);
    gt_end(&t);
}

/* A parabola's offset beyond the radius of curvature of its vertex: one
 * interval runs backwards, its ends have that radius; the loop goes, the rest
 * keeps its distance and ends in one point. */
static void loops_go(void **state)
{
    const double pts[6] = {0, 1, 2, 0, 2, 0};
    gt t = gt_begin(5);
    ix_mv *c = gt_curve(&t, 3, 3, NULL, 2, false, pts), *o;
    const ix_offset_opts how = {.distance = 0.6, .tol = 1e-5};
    double *ends, a[IX_MAX_COORDS], b[IX_MAX_COORDS];
    ix_crvs kept;
    int n;

    (void)state;
    ASSERT_OK(t.ctx, ix_crv_offset(t.ctx, c, &how, NULL, &o));
    ASSERT_OK(t.ctx, ix_offset_loops(t.ctx, c, o, &ends, &n));
    assert_int_equal(n, 1);
    /* y = 2 x - x^2: radius (1 + y'^2)^(3/2) / 2 = 0.6 */
    ASSERT_CLOSE(ends[0], 0.5 - sqrt(pow(1.2, 2.0 / 3) - 1) / 4, 2e-3);
    ASSERT_CLOSE(ends[0] + ends[1], 1, 1e-9);
    ix_offset_loops_free(t.ctx, ends, n);
    ASSERT_OK(t.ctx, ix_offset_trim(t.ctx, c, o, 0.599, &kept));
    assert_int_equal(kept.n, 2);
    gt_point(&t, o, &kept.t[1], a);
    gt_point(&t, o, &kept.t[2], b);
    assert_true(hypot(a[0] - b[0], a[1] - b[1]) < 1e-9 &&
                fabs(a[0] - 1) < 1e-6);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i <= 20; i++) {
            double at, d, p[IX_MAX_COORDS], dom[2];

            ix_mv_domain(kept.crv[k], 0, dom);
            at = dom[0] + (dom[1] - dom[0]) * i / 20;
            gt_point(&t, kept.crv[k], &at, p);
            ASSERT_OK(t.ctx, ix_crv_nearest(t.ctx, c, p, NULL, false, &at, &d));
            assert_true(d >= 0.599);
        }
    ix_crvs_free(t.ctx, &kept);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, o);
    gt_end(&t);
}

/* A plane is exact, a cylinder refined around only, and a curved patch keeps
 * its tolerance along the normal that ix_srf_normal tells. */
static void surface_offsets(void **state)
{
    const double zero[3] = {0, 0, 0}, up[3] = {0, 0, 2};
    gt t = gt_begin(6);
    ix_mv *c, *s, *o;
    double err;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_srf_extrude(t.ctx, c, up, &s));
    ASSERT_OK(t.ctx, ix_srf_offset(t.ctx, s, 0.25, 1e-3, &err, &o));
    assert_true(err <= 1e-3);
    assert_int_equal(ix_mv_length(o, 1), 2);
    for (int i = 0; i <= 40; i++) {
        double at[2] = {4 * i / 40.0, i / 40.0}, p[IX_MAX_COORDS],
               q[IX_MAX_COORDS], n[3];

        gt_point(&t, s, at, p);
        gt_point(&t, o, at, q);
        ASSERT_OK(t.ctx, ix_srf_normal(t.ctx, s, at[0], at[1], n));
        for (int k = 0; k < 3; k++)
            assert_true(fabs(q[k] - p[k] - 0.25 * n[k]) <= 1.5e-3);
    }
    ix_mv_unref(t.ctx, o);
    assert_int_equal(ix_srf_offset(t.ctx, s, 0.25, 0, NULL, &o), IX_EARG);
    assert_int_equal(ix_srf_offset(t.ctx, c, 0.25, 1, NULL, &o), IX_EARG);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void errors(void **state)
{
    const double pts[4] = {0, 1, 0, 0}, one[2] = {0, 1};
    const double pole[6] = {1, -1, 0, -1, 0, 0};
    gt t = gt_begin(7);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, pts), *o;
    ix_mv *s = gt_curve(&t, 2, 2, NULL, 1, false, one);
    ix_mv *bad = gt_curve(&t, 2, 2, NULL, 2, true, pole);
    ix_offset_opts how = {.distance = 1, .tol = -1};

    (void)state;
    assert_int_equal(ix_crv_offset(t.ctx, c, &how, NULL, &o), IX_EARG);
    how.tol = NAN;
    assert_int_equal(ix_crv_offset(t.ctx, c, &how, NULL, &o), IX_EARG);
    how.tol = 0.1;
    assert_int_equal(ix_crv_offset(t.ctx, s, &how, NULL, &o), IX_EARG);
    assert_int_equal(ix_crv_offset(t.ctx, bad, &how, NULL, &o), IX_EDOMAIN);
    how.field = c;
    assert_int_equal(ix_crv_offset(t.ctx, c, &how, NULL, &o), IX_EARG);
    assert_null(o);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, bad);
    gt_end(&t);
}

/* --- memory ----------------------------------------------------------------
 */

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {0, 1, 2, 0, 2, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};
    const double up[3] = {0, 0, 1};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, p, &f->in[0]));
    ASSERT_OK(ctx, ix_srf_extrude(ctx, f->in[0], up, &f->in[1]));
}

static ix_status build_curve(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_offset_opts how = {.distance = 0.4, .tol = 1e-2};

    return ix_crv_offset(ctx, f->in[0], &how, NULL, out);
}

static ix_status build_fit(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_crv_offset_fit(ctx, f->in[0], 0.4, 20, 6, 4, NULL, out);
}

static ix_status build_surface(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_srf_offset(ctx, f->in[1], 0.4, 0.1, NULL, out);
}

static ix_status build_trim(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_crvs p;

    IX_TRY(ix_offset_trim(ctx, f->in[0], f->in[0], 0, &p));
    *out = ix_mv_ref(p.crv[0]);
    ix_crvs_free(ctx, &p);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build_curve});
    ix_build_faults(&(ix_build_case){.make = make, .build = build_fit});
    ix_build_faults(&(ix_build_case){.make = make, .build = build_surface});
    ix_build_faults(&(ix_build_case){.make = make, .build = build_trim});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plane_offsets_hold_their_tolerance),
        cmocka_unit_test(known_offsets),
        cmocka_unit_test(corners_are_bridged),
        cmocka_unit_test(fitted_offsets),
        cmocka_unit_test(loops_go),
        cmocka_unit_test(surface_offsets),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
