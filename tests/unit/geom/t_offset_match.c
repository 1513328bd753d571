/* Offsets by matching tangents, against their definition: the point stays
 * between the distance and the distance plus the bound, and the tangents are
 * parallel. */
#include <math.h>

#include "geomtest.h"
#include "iritx/distance.h"
#include "iritx/offset.h"

#define PI 3.14159265358979323846

static double cross_unit(const double *a, const double *b)
{
    return (a[0] * b[1] - a[1] * b[0]) /
           (hypot(a[0], a[1]) * hypot(b[0], b[1]));
}

/* Law: with no corners parameters agree; O - C lies on the right (d > 0), is
 * from |d| to |d| + err long, within half an arc of the normal, and O' is
 * parallel to C'. */
static void check_smooth(gt *t, const ix_mv *c, const ix_mv *o, double d,
                         double arc, double err)
{
    double dom[2], a[2], worst = 0;

    ix_mv_domain(c, 0, dom);
    ix_mv_domain(o, 0, a);
    ASSERT_CLOSE(a[0], dom[0], 1e-12);
    ASSERT_CLOSE(a[1], dom[1], 1e-12);
    for (int i = 1; i < 300; i++) {
        double u = dom[0] + (dom[1] - dom[0]) * i / 300;
        double x[2 * IX_MAX_COORDS], y[2 * IX_MAX_COORDS], move[2], len, dot;
        int nc = ix_mv_ncoords(c);

        ASSERT_OK(t->ctx, ix_mv_curve_derivs(t->ctx, c, u, 1, x));
        ASSERT_OK(t->ctx, ix_mv_curve_derivs(t->ctx, o, u, 1, y));
        move[0] = y[0] - x[0];
        move[1] = y[1] - x[1];
        len = hypot(move[0], move[1]);
        if (!(len >= fabs(d) - 1e-10 && len <= fabs(d) + err + 1e-10))
            fail_msg("distance %.15g at %g", len, u);
        worst = fmax(worst, len - fabs(d));
        dot = (move[0] * x[nc] + move[1] * x[nc + 1]) /
              (len * hypot(x[nc], x[nc + 1]));
        assert_true(fabs(dot) <= sin(arc / 2));
        assert_true((move[0] * x[nc + 1] - move[1] * x[nc]) * d > 0);
        if (hypot(y[nc], y[nc + 1]) > 1e-3)
            assert_true(fabs(cross_unit(x + nc, y + nc)) < 1e-8);
        if (nc > 2)
            ASSERT_CLOSE(y[2], x[2], 1e-10);
    }
    assert_true(worst > err / 4); /* the bound is no idle one */
}

static void the_law(void **state)
{
    const double arcs[3] = {PI / 2, PI / 6, PI / 18};
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < 12; k++) {
        int rational = k % 2, nc = 2 + k % 3 / 2, n = 7, order = 4;
        double pts[4 * 7], knots[11], err, d = k % 4 < 2 ? 0.2 : -0.1;
        double arc = arcs[k % 3];
        ix_mv *c, *o;

        ASSERT_OK(t.ctx, ix_knots_make(t.ctx, IX_KV_OPEN, order, n, knots));
        for (int i = 0; i < n; i++) {
            double w = rational ? ix_rng_range(&t.r, 0.5, 2) : 1;

            if (rational)
                pts[i] = w;
            for (int a = 0; a < nc; a++)
                pts[i + (a + rational) * n] = w * ix_rng_range(&t.r, -1, 1);
        }
        c = gt_curve(&t, order, n, knots, nc, rational, pts);
        ASSERT_OK(t.ctx, ix_crv_offset_match(t.ctx, c, d, arc, &err, &o));
        assert_true(ix_mv_rational(o));
        assert_int_equal(ix_mv_order(o, 0),
                         1 + (rational ? 5 * 3 - 4 : 3 * 3 - 2));
        ASSERT_CLOSE(err, fabs(d) * ((cos(arc / 2) + 1 / cos(arc / 2)) / 2 - 1),
                     1e-12);
        check_smooth(&t, c, o, d, arc, err);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, o);
    }
    gt_end(&t);
}

/* A square: round corners outside, from the sides' lines; closed; every point
 * at the distance from the square. A point with a doubled control point, where
 * the speed is 0. */
static void corners_and_stops(void **state)
{
    const double sq[10] = {0, 2, 2, 0, 0, 0, 0, 2, 2, 0};
    const double kv[7] = {0, 0, 1, 2, 3, 4, 4},
                 stop[8] = {0, 0, 1, 2, 0, 0, 2, 1};
    gt t = gt_begin(2);
    ix_mv *c = gt_curve(&t, 2, 5, kv, 2, false, sq), *o;
    double dom[2], p[IX_MAX_COORDS], q[IX_MAX_COORDS], err, at, far;

    (void)state;
    ASSERT_OK(t.ctx, ix_crv_offset_match(t.ctx, c, 0.5, PI / 18, &err, &o));
    ix_mv_domain(o, 0, dom);
    assert_true(dom[1] > 4);
    for (int i = 0; i <= 200; i++) {
        double u = i == 200 ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / 200;

        gt_point(&t, o, &u, p);
        ASSERT_OK(t.ctx, ix_crv_nearest(t.ctx, c, p, NULL, false, &at, &far));
        assert_true(far >= 0.5 - 1e-9 && far <= 0.5 + err + 1e-9);
        assert_true(p[0] < 0 || p[0] > 2 || p[1] < 0 || p[1] > 2);
    }
    gt_point(&t, o, &dom[0], q);
    gt_same(p, q, 2, 1e-12);
    ix_mv_unref(t.ctx, o);
    ASSERT_OK(t.ctx, ix_crv_offset_match(t.ctx, c, 0, PI / 18, &err, &o));
    ix_mv_domain(o, 0, dom);
    ASSERT_CLOSE(dom[1], 4, 1e-12); /* nothing to go around */
    ix_mv_unref(t.ctx, o);
    ix_mv_unref(t.ctx, c);

    c = gt_curve(&t, 4, 4, NULL, 2, false, stop);
    ASSERT_OK(t.ctx, ix_crv_offset_match(t.ctx, c, 0.3, PI / 18, &err, &o));
    check_smooth(&t, c, o, 0.3, PI / 18, err);
    ix_mv_unref(t.ctx, o);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

/* A cusp: the tangent turns back, a half circle goes around. */
static void around_a_cusp(void **state)
{
    const double cusp[8] = {-1, 1, -1, 1, 0, 1, 1, 0};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 4, 4, NULL, 2, false, cusp), *o;
    double dom[2], err, p[IX_MAX_COORDS], at, far;

    (void)state;
    ASSERT_OK(t.ctx, ix_crv_offset_match(t.ctx, c, -0.1, PI / 18, &err, &o));
    ix_mv_domain(o, 0, dom);
    for (int i = 0; i <= 100; i++) {
        double u = dom[0] + (dom[1] - dom[0]) * i / 100;

        gt_point(&t, o, &u, p);
        ASSERT_OK(t.ctx, ix_crv_nearest(t.ctx, c, p, NULL, false, &at, &far));
        assert_true(far <= 0.1 + err + 1e-7);
    }
    ix_mv_unref(t.ctx, o);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

static void errors(void **state)
{
    const double line[4] = {0, 1, 0, 1}, point[4] = {1, 1, 2, 2};
    const double pole[6] = {1, -1, 0, -1, 0, 0};
    gt t = gt_begin(4);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, line), *o;
    ix_mv *p = gt_curve(&t, 2, 2, NULL, 2, false, point);
    ix_mv *b = gt_curve(&t, 2, 2, NULL, 2, true, pole);
    ix_mv *s = gt_curve(&t, 2, 2, NULL, 1, false, line);

    (void)state;
    assert_int_equal(ix_crv_offset_match(t.ctx, c, 1, 0, NULL, &o), IX_EARG);
    assert_int_equal(ix_crv_offset_match(t.ctx, c, 1, 2, NULL, &o), IX_EARG);
    assert_int_equal(ix_crv_offset_match(t.ctx, c, NAN, 1, NULL, &o), IX_EARG);
    assert_int_equal(ix_crv_offset_match(t.ctx, s, 1, 1, NULL, &o), IX_EARG);
    assert_int_equal(ix_crv_offset_match(t.ctx, p, 1, 1, NULL, &o), IX_EDOMAIN);
    assert_int_equal(ix_crv_offset_match(t.ctx, b, 1, 1, NULL, &o), IX_EDOMAIN);
    assert_null(o);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, p);
    ix_mv_unref(t.ctx, b);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {0, 1, 1, 0, 0, 1}, kv[5] = {0, 0, 1, 2, 2};
    const ix_dir d = {IX_BSPLINE, 2, 3, false, kv};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_crv_offset_match(ctx, f->in[0], 0.5, 1.5, NULL, out);
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_law),       cmocka_unit_test(corners_and_stops),
        cmocka_unit_test(around_a_cusp), cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
