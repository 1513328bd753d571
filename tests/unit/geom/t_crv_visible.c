/* What is seen of curves, hulls and pairs of tangents, against dense sampling
 * and closed forms. */
#include <stdlib.h>

#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/visible.h"

enum { DENSE = 1500 };

/* A random closed curve: control points repeated, of 5 to 9. */
static ix_mv *closed_curve(gt *t, int order, bool wild)
{
    int n = (int)ix_rng_range(&t->r, 5, 9), length = n + order - 1;
    double pts[2 * 16], knots[32];

    for (int i = 0; i < length; i++)
        for (int k = 0; k < 2; k++) {
            double a = 2 * 3.14159265358979 * (i % n) / n;
            double r = ix_rng_range(&t->r, 0.3, 1.5);

            pts[i + k * length] = i >= n ? pts[i - n + k * length]
                                  : wild ? ix_rng_range(&t->r, -1, 1)
                                         : r * (k ? sin(a) : cos(a));
        }
    for (int i = 0; i < length + order; i++)
        knots[i] = i;
    return gt_curve(t, order, length, knots, 2, false, pts);
}

static void samples(gt *t, const ix_mv *c, int n, double (*p)[2])
{
    double dom[2], x[IX_MAX_COORDS];

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i <= n; i++) {
        double u = i == n ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / n;

        gt_point(t, c, &u, x);
        p[i][0] = x[0];
        p[i][1] = x[1];
    }
}

/* Does a side of the polygon cross the way from q to the viewer? Sides within
 * `skip` of number `own` do not count. */
static bool blocked(double (*p)[2], int own, int skip, const double q[2],
                    const double view[2], bool point)
{
    double d[2] = {view[0] - (point ? q[0] : 0), view[1] - (point ? q[1] : 0)};

    for (int i = 0; i < DENSE; i++) {
        double a, b, s, x[2];

        if (abs(i - own) <= skip)
            continue;
        a = d[0] * (p[i][1] - q[1]) - d[1] * (p[i][0] - q[0]);
        b = d[0] * (p[i + 1][1] - q[1]) - d[1] * (p[i + 1][0] - q[0]);
        if (a * b > 0)
            continue;
        s = a / (a - b);
        for (int k = 0; k < 2; k++)
            x[k] = p[i][k] + s * (p[i + 1][k] - p[i][k]) - q[k];
        s = (x[0] * d[0] + x[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        if (s > 0 && !(point && s > 1))
            return true;
    }
    return false;
}

static bool is_in(const ix_crvs *v, double u)
{
    for (int i = 0; i < v->n; i++)
        if (u >= v->t[2 * i] && u <= v->t[2 * i + 1])
            return true;
    return false;
}

static bool near_an_end(const ix_crvs *v, double u, double gap)
{
    for (int i = 0; i < 2 * v->n; i++)
        if (fabs(v->t[i] - u) < gap)
            return true;
    return false;
}

/* Law: seen is what no side of a fine polygon is before, but for places within
 * 6 sides of an end, where the polygon cannot tell. */
static void seen_as_sampled(void **state)
{
    static double p[DENSE + 1][2];
    gt t = gt_begin(11);
    int hidden = 0, seen = 0;

    (void)state;
    for (int k = 0; k < 12; k++) {
        ix_mv *c = closed_curve(&t, 2 + k % 3, k % 2);
        bool point = k % 4 > 1;
        double far = point ? 3 : 1, dom[2];
        const double view[2] = {far * cos(k), far * sin(k)};
        ix_crvs v;

        ASSERT_OK(t.ctx, ix_crv_visible(t.ctx, c, view, point, &v));
        samples(&t, c, DENSE, p);
        ix_mv_domain(c, 0, dom);
        for (int i = 3; i < DENSE - 3; i += 7) {
            double w = (dom[1] - dom[0]) / DENSE, u = dom[0] + w * (i + 0.5);
            double x[IX_MAX_COORDS];

            if (near_an_end(&v, u, 6 * w))
                continue;
            gt_point(&t, c, &u, x);
            if (is_in(&v, u) == blocked(p, i, 2, x, view, point))
                fail_msg("curve %d at %g: %d", k, u, is_in(&v, u));
            hidden += !is_in(&v, u);
            seen += is_in(&v, u);
        }
        for (int i = 0; i < v.n; i++) {
            double a[2];

            ix_mv_domain(v.crv[i], 0, a);
            ASSERT_CLOSE(a[0], v.t[2 * i], TOL);
            ASSERT_CLOSE(a[1], v.t[2 * i + 1], TOL);
        }
        ix_crvs_free(t.ctx, &v);
        ix_mv_unref(t.ctx, c);
    }
    assert_true(hidden > 300 && seen > 300);
    gt_end(&t);
}

/* Of the unit circle a viewer at distance 2 sees the third in front of it. */
static void seen_of_a_circle(void **state)
{
    const double zero[3] = {0, 0, 0}, view[2] = {0, 2};
    gt t = gt_begin(12);
    double x[IX_MAX_COORDS];
    ix_crvs v;
    ix_mv *c;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_crv_visible(t.ctx, c, view, true, &v));
    assert_int_equal(v.n, 1);
    for (int e = 0; e < 2; e++) {
        gt_point(&t, c, &v.t[e], x);
        ASSERT_CLOSE(x[1], 0.5, 1e-9);
    }
    ix_crvs_free(t.ctx, &v);
    ASSERT_OK(t.ctx, ix_crv_visible(t.ctx, c, view, false, &v));
    assert_int_equal(v.n, 1);
    ASSERT_CLOSE(v.t[0], 0, 1e-9);
    ASSERT_CLOSE(v.t[1], 2, 1e-9);
    ix_crvs_free(t.ctx, &v);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

/* Law: the lower envelope of several curves is what is lowest at each x, by
 * dense polygons of all. */
static void lower_envelopes(void **state)
{
    static double p[3][DENSE + 1][2];
    const double down[2] = {0, -1};
    gt t = gt_begin(13);
    int shown = 0, hidden = 0;

    (void)state;
    for (int k = 0; k < 6; k++) {
        ix_mv *c[3];
        ix_crvs v[3];
        double dom[2];

        for (int i = 0; i < 3; i++) {
            c[i] = i ? gt_random(&t, 1, 2, 0, IX_RAND_BEZIER, 3)
                     : closed_curve(&t, 3, true);
            samples(&t, c[i], DENSE, p[i]);
        }
        ASSERT_OK(t.ctx, ix_crvs_visible(t.ctx, 3, (const ix_mv *const *)c,
                                         down, false, v));
        for (int i = 0; i < 3; i++) {
            ix_mv_domain(c[i], 0, dom);
            for (int j = 3; j < DENSE - 3; j += 11) {
                double w = (dom[1] - dom[0]) / DENSE, x[IX_MAX_COORDS];
                double u = dom[0] + w * (j + 0.5);
                bool under = false;

                if (near_an_end(&v[i], u, 8 * w))
                    continue;
                gt_point(&t, c[i], &u, x);
                for (int l = 0; l < 3; l++)
                    under = under ||
                            blocked(p[l], l == i ? j : -9, 2, x, down, false);
                if (is_in(&v[i], u) == under)
                    fail_msg("round %d, curve %d at %g: %d", k, i, u, !under);
                shown += !under;
                hidden += under;
            }
            ix_crvs_free(t.ctx, &v[i]);
        }
        for (int i = 0; i < 3; i++)
            ix_mv_unref(t.ctx, c[i]);
    }
    assert_true(shown > 100 && hidden > 100);
    gt_end(&t);
}

/* Law: the hull turns only to the left, and reaches as far as the curve in all
 * directions; sampling leaves out 1e-5 of the size. */
static void hull_as_sampled(void **state)
{
    static double p[DENSE + 1][2], h[DENSE + 1][2];
    gt t = gt_begin(13);
    int bridged = 0;

    (void)state;
    for (int k = 0; k < 16; k++) {
        ix_mv *c = closed_curve(&t, 2 + k % 3, k % 2), *m;

        ASSERT_OK(t.ctx, ix_crv_hull(t.ctx, c, &m));
        samples(&t, c, DENSE, p);
        samples(&t, m, DENSE, h);
        ASSERT_CLOSE(h[0][0], h[DENSE][0], 1e-9);
        ASSERT_CLOSE(h[0][1], h[DENSE][1], 1e-9);
        for (int i = 1; i < DENSE; i++) {
            double a[2] = {h[i][0] - h[i - 1][0], h[i][1] - h[i - 1][1]};
            double b[2] = {h[i + 1][0] - h[i][0], h[i + 1][1] - h[i][1]};

            if (!(a[0] * b[1] - a[1] * b[0] >= -1e-10))
                fail_msg("hull %d turns right at %d", k, i);
        }
        for (int a = 0; a < 60; a++) {
            double best[2] = {-9, -9}, d[2] = {cos(a / 9.5), sin(a / 9.5)};

            for (int i = 0; i <= DENSE; i++) {
                best[0] = fmax(best[0], p[i][0] * d[0] + p[i][1] * d[1]);
                best[1] = fmax(best[1], h[i][0] * d[0] + h[i][1] * d[1]);
            }
            /* at a vertex, DENSE samples miss up to half a step */
            if (!(fabs(best[0] - best[1]) <= 1e-2))
                fail_msg("hull %d: %g, curve %g", k, best[1], best[0]);
        }
        bridged += ix_mv_length(m, 0) != ix_mv_length(c, 0);
        ix_mv_unref(t.ctx, m);
        ix_mv_unref(t.ctx, c);
    }
    assert_true(bridged > 4);
    gt_end(&t);
}

/* A circle is its hull; a star's hull is the polygon of its five points. */
static void known_hulls(void **state)
{
    const double zero[3] = {0, 0, 0};
    double pts[22], knots[13], dom[2];
    gt t = gt_begin(14);
    ix_mv *c, *h;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_crv_hull(t.ctx, c, &h));
    for (int i = 0; i <= 40; i++) {
        double u = i / 10.0, x[IX_MAX_COORDS];

        gt_point(&t, h, &u, x);
        ASSERT_CLOSE(hypot(x[0], x[1]), 1, TOL);
    }
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, h);
    for (int i = 0; i <= 10; i++) {
        double a = 3.14159265358979323846 * (i % 10) / 5, r = i % 2 ? 0.3 : 1;

        pts[i] = r * cos(a);
        pts[11 + i] = r * sin(a);
    }
    for (int i = 0; i < 13; i++)
        knots[i] = i < 1 ? 0 : i > 11 ? 10 : i - 1;
    c = gt_curve(&t, 2, 11, knots, 2, false, pts);
    ASSERT_OK(t.ctx, ix_crv_hull(t.ctx, c, &h));
    ix_mv_domain(h, 0, dom);
    assert_int_equal(ix_mv_length(h, 0), 6);
    for (int i = 0; i < 6; i++)
        ASSERT_CLOSE(hypot(ix_mv_coord(h, 0)[i], ix_mv_coord(h, 1)[i]), 1, TOL);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, h);
    gt_end(&t);
}

static double angle_at(gt *t, const ix_mv *c, double u)
{
    double d[3];

    ASSERT_OK(t->ctx, ix_tangent(t->ctx, c, u, true, d));
    return atan2(d[1], d[0]);
}

/* Law: for each t the polylines cross as often as the angle, sampled in r,
 * passes +-theta; every vertex has it to 1e-7. */
static void pairs_as_sampled(void **state)
{
    gt t = gt_begin(15);

    (void)state;
    for (int k = 0; k < 9; k++) {
        ix_mv *c = gt_random(&t, 1, 2, k % 2, IX_RAND_BEZIER, 4);
        double theta = k % 3 == 0 ? 0 : k % 3 == 1 ? 1 : 1.57079632679489662;
        double u = 0.37, base = angle_at(&t, c, u), last = 0;
        int crossings = 0, found = 0, at = 0;
        ix_lines l;

        ASSERT_OK(t.ctx, ix_crv_angle_pairs(t.ctx, c, theta, 1e-3, &l));
        for (int i = 0; i <= 3000; i++) {
            double r = i / 3000.0, d = cos(angle_at(&t, c, r) - base);
            double f = k % 3 ? d * d - cos(theta) * cos(theta) : 0;

            if (k % 3 == 0)
                f = sin(angle_at(&t, c, r) - base) * (r > u ? 1 : -1);
            if (k % 3 == 2)
                f = d;
            if (i && i != 1110 && i != 1111)
                crossings += f * last < 0;
            last = f;
        }
        for (int i = 0; i < l.n; at += l.count[i++])
            for (int v = 0; v < l.count[i]; v++) {
                const double *p = l.pt[at + v];
                double d = angle_at(&t, c, p[0]) - angle_at(&t, c, p[1]);

                if (!(fabs(fabs(cos(d)) - fabs(cos(theta))) <= 1e-7))
                    fail_msg("%g %g: %g", p[0], p[1], d);
                found += v && (p[0] - u) * (l.pt[at + v - 1][0] - u) < 0;
            }
        assert_int_equal(found, crossings);
        ix_lines_free(t.ctx, &l);
        ix_mv_unref(t.ctx, c);
    }
    gt_end(&t);
}

static void errors(void **state)
{
    const double zero[2] = {0, 0}, line[4] = {0, 1, 0, 1}, view[2] = {1, 0};
    const double there[] = {0, 1, 0, 0, 1, 0}, knots[] = {0, 0, 1, 2, 2};
    gt t = gt_begin(16);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, line), *out;
    ix_mv *flat = gt_curve(&t, 2, 3, knots, 2, false, there);
    ix_mv *one = gt_curve(&t, 2, 2, NULL, 1, false, line);
    ix_lines l;
    ix_crvs v;

    (void)state;
    assert_int_equal(ix_crv_visible(t.ctx, c, zero, false, &v), IX_EARG);
    assert_int_equal(ix_crv_visible(t.ctx, one, view, false, &v), IX_EARG);
    assert_int_equal(ix_crv_hull(t.ctx, c, &out), IX_EDOMAIN);
    assert_int_equal(ix_crv_hull(t.ctx, flat, &out), IX_EDOMAIN);
    assert_int_equal(ix_crv_hull(t.ctx, one, &out), IX_EARG);
    assert_int_equal(ix_crv_angle_field(t.ctx, c, 0, &out), IX_EDOMAIN);
    assert_int_equal(ix_crv_angle_field(t.ctx, one, 0, &out), IX_EARG);
    assert_int_equal(ix_crv_angle_pairs(t.ctx, c, 0, 1e-3, &l), IX_EDOMAIN);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, flat);
    ix_mv_unref(t.ctx, one);
    gt_end(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(seen_as_sampled), cmocka_unit_test(seen_of_a_circle),
        cmocka_unit_test(lower_envelopes), cmocka_unit_test(hull_as_sampled),
        cmocka_unit_test(known_hulls),     cmocka_unit_test(pairs_as_sampled),
        cmocka_unit_test(errors)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
