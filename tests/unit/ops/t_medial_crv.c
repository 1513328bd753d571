/* Medial curves: closed forms in the plane and on the sphere, the examples of
 * Rausch, Wolter and Sniehotta by a function and by a spline, what ends them.
 */
#include "geo_test.h"
#include "iritx/geom.h"

#include <stdlib.h>

IX_TEST_FIXTURE(303)

static const ix_geo_opts fine = {.tol = 1e-10};
/* Quicker: the examples take half a second as it is, for thousands of
 * geodesics. */
static const ix_geo_opts coarse = {.tol = 1e-7};

/* T5 in Bernstein form: five zeros at (1 + cos((2k - 1) pi / 10)) / 2. */
static const double t5[6] = {-1, 9, -21, 21, -9, 1};

static double zero_of_t5(int k)
{
    return 0.5 * (1 + cos((2 * k - 1) * PI / 10));
}

/* The border that crosses the line v = 3.1 five times, both with u = 0.5 + 5.3
 * t. */
static ix_mv *winding(ix_ctx *cx, double v, double height)
{
    double p[6][2];

    for (int i = 0; i < 6; i++) {
        p[i][0] = 0.5 + 5.3 * i / 5;
        p[i][1] = v + height * t5[i];
    }
    return plane_curve(cx, 6, (const double(*)[2])p);
}

/* sin (or cos) on [0, 2 pi] as a spline of order 11. */
static void interpolate(ix_ctx *cx, int cosine, ix_mv **out)
{
    enum { N = 26, ORDER = 11 };
    double x[N], tau[N], kv[N + ORDER];
    ix_interpolate_opts o = {.order = ORDER,
                             .size = N,
                             .nparams = N,
                             .params = tau,
                             .nknots = N + ORDER,
                             .knots = kv};
    ix_dir dir = {IX_BSPLINE, ORDER, N, false, kv};

    for (int i = 0; i < N + ORDER; i++)
        kv[i] = i < ORDER ? 0
                : i >= N  ? 2 * PI
                          : 2 * PI * (i - ORDER + 1) / (N - ORDER + 1);
    ix_knots_nodes(&dir, tau);
    for (int i = 0; i < N; i++)
        x[i] = cosine ? cos(tau[i]) : sin(tau[i]);
    ASSERT_OK(cx, ix_interpolate(cx, N, 1, false, x, &o, NULL, out));
}

/* The surface (u, v, sin u cos v) as a spline, within 1e-12. */
static ix_mv *wave_spline(ix_ctx *cx)
{
    ix_mv *f, *g, *out;
    ix_dir d[2];
    double nu[64], *pts, p[2], x[3];
    size_t n;

    interpolate(cx, 0, &f);
    interpolate(cx, 1, &g);
    d[0] = ix_mv_dir(f, 0);
    d[1] = ix_mv_dir(g, 0);
    n = (size_t)d[0].length;
    ix_knots_nodes(&d[0], nu);
    pts = calloc(3 * n * n, sizeof *pts);
    for (size_t i = 0; i < n * n; i++) {
        pts[i] = nu[i % n];
        pts[n * n + i] = nu[i / n];
        pts[2 * n * n + i] = ix_mv_coord(f, 0)[i % n] *
                             ix_mv_coord(g, 0)[i / n];
    }
    ASSERT_OK(cx, ix_mv_new(cx, 2, d, 3, false, pts, &out));
    free(pts);
    ix_mv_unref(cx, f);
    ix_mv_unref(cx, g);
    for (int i = 0; i < 400; i++) {
        p[0] = 2 * PI * (i % 20 + 0.37) / 20;
        p[1] = 2 * PI * (i / 20 + 0.61) / 20;
        ASSERT_OK(cx, ix_mv_point(cx, out, p, x));
        assert_true(fabs(x[2] - sin(p[0]) * cos(p[1])) <= 1e-12);
        assert_true(fabs(x[0] - p[0]) + fabs(x[1] - p[1]) <= 1e-12);
    }
    return out;
}

/* How far the curve c (two coordinates) passes from p, from t on. */
static double passes(const ix_mv *c, double t, const double p[2])
{
    double d[4], r = 0;

    for (int i = 0; i < 8; i++) {
        double a, b;

        t = fmin(fmax(t, 0), end_of(c));
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, d));
        a = p[0] - d[0];
        b = p[1] - d[1];
        r = hypot(a, b);
        t += (a * d[2] + b * d[3]) / (d[2] * d[2] + d[3] * d[3]);
    }
    return r;
}

/* All five meetings lie on the curve: s changes its sign there. */
static void assert_meetings(const ix_geo_curve *c, double tol)
{
    const double *s = ix_mv_coord(c->states, 1);
    ix_dir d = ix_mv_dir(c->states, 0);
    int k = 5;

    for (int i = 1; i < (int)ix_mv_npts(c->states); i++) {
        double p[2] = {0, 3.1}, r;

        if (s[i] * s[i - 1] > 0 || s[i] == 0)
            continue;
        assert_true(k >= 1);
        p[0] = 0.5 + 5.3 * zero_of_t5(k--);
        r = passes(c->uv, d.knots[i], p);
        if (!(r <= tol))
            fail_msg("meeting %d missed by %g", k + 1, r);
    }
    assert_int_equal(k, 0);
}

/* The first example of the paper: started at one meeting, traced through all
 * of them. */
static void five_meetings(void **state)
{
    ix_geo_surface s = by_function(wave_fn, NULL, 0, 2 * PI, 0, 2 * PI),
                   t = {0};
    ix_mv *a = plane_line(ctx, 0.5, 3.1, 5.8, 3.1);
    ix_mv *b = winding(ctx, 3.1, 0.25);
    const ix_medial_opts m = {.sides = {1, -1}};
    double x[2][3];
    ix_geo_curves o, p;

    (void)state;
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &m, &fine, &o));
    assert_int_equal(o.n, 1);
    assert_true(o.crv->miss <= 1e-11 && o.crv->fit <= 1e-10);
    assert_meetings(o.crv, 1e-10);
    t.mv = wave_spline(ctx);
    ASSERT_OK(ctx, ix_medial_crv(ctx, &t, a, b, &m, &coarse, &p));
    assert_int_equal(p.n, 1);
    assert_true(p.crv->miss <= 1e-10);
    assert_meetings(p.crv, 1e-7);
    for (int i = 0; i < 2; i++) {
        const ix_mv *c = i ? p.crv->space : o.crv->space;

        value(ctx, c, end_of(c), x[i]);
    }
    for (int c = 0; c < 3; c++)
        ASSERT_CLOSE(x[0][c], x[1][c], 1e-10);
    ix_geo_curves_free(ctx, &o);
    ix_geo_curves_free(ctx, &p);
    ix_mv_unref(ctx, t.mv);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* The second one: borders that do not meet; started by (4.6). */
static void no_meeting(void **state)
{
    ix_geo_surface s = by_function(wave_fn, NULL, 0, 2 * PI, 0, 2 * PI);
    ix_mv *a = plane_line(ctx, 0.5, 2.4, 5.8, 2.6);
    ix_mv *b = winding(ctx, 3.7, 0.1);
    const ix_medial_opts m = {.sides = {1, -1}};
    ix_geo_curves o, p;

    (void)state;
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &m, NULL, &o));
    assert_int_equal(o.n, 1);
    assert_int_equal(o.crv->stop[0], IX_GEO_END);
    assert_int_equal(o.crv->stop[1], IX_GEO_END);
    assert_true(o.crv->miss <= 1e-10);
    /* Law: from one of its own points the same curve is found */
    {
        double st[4], at = 0.6 * end_of(o.crv->states), e[2][4];
        ix_medial_opts g = {.sides = {1, -1}, .start = IX_MEDIAL_GUESS};

        value(ctx, o.crv->states, at, st);
        g.guess[0] = st[0];
        g.guess[1] = st[2];
        g.guess[2] = st[1];
        ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &g, &coarse, &p));
        assert_int_equal(p.n, 1);
        value(ctx, o.crv->states, end_of(o.crv->states), e[0]);
        value(ctx, p.crv->states, end_of(p.crv->states), e[1]);
        for (int k = 0; k < 4; k++)
            ASSERT_CLOSE(e[0][k], e[1][k], 1e-8);
        ix_geo_curves_free(ctx, &p);
    }
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* Law: points at the same distance from the great circles z = 0 and y = 0 lie
 * in the planes z = y and z = -y; the distance is asin |z|. */
static void great_circles(void **state)
{
    double r[3] = {1, 1, 1};
    ix_geo_surface s = by_function(ellipsoid_fn, r, -2, 2, -1.5, 1.5);
    ix_mv *a = plane_line(ctx, -1, 0, 1, 0), *b = plane_line(ctx, 0, -1, 0, 1);
    ix_geo_curves o;

    (void)state;
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, NULL, NULL, &o));
    assert_int_equal(o.n, 2);
    for (int k = 0; k < 2; k++) {
        double sign = 0, end = end_of(o.crv[k].space);

        assert_true(o.crv[k].miss <= 1e-10);
        for (int i = 1; i < 20; i++) {
            double x[3];

            value(ctx, o.crv[k].space, i * end / 20, x);
            if (sign == 0)
                sign = x[1] * x[2] > 0 ? 1 : -1;
            ASSERT_CLOSE(x[2], sign * x[1], 1e-7);
            ASSERT_CLOSE(x[0] * x[0] + x[1] * x[1] + x[2] * x[2], 1, 2e-7);
        }
        for (size_t i = 0; i < ix_mv_npts(o.crv[k].states); i++) {
            double x[3], t = ix_mv_dir(o.crv[k].states, 0).knots[i + 1];

            value(ctx, o.crv[k].space, t, x);
            ASSERT_CLOSE(ix_mv_coord(o.crv[k].states, 3)[i], asin(fabs(x[2])),
                         1e-11);
        }
    }
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* The plane [-9, 9]^2 with u and v as coordinates. */
static ix_mv *make_plane(ix_ctx *cx)
{
    double pts[8] = {-9, 9, -9, 9, -9, -9, 9, 9};
    double kv[4] = {-9, -9, 9, 9};
    ix_dir d[2] = {{IX_BSPLINE, 2, 2, false, kv},
                   {IX_BSPLINE, 2, 2, false, kv}};
    ix_mv *m;

    ASSERT_OK(cx, ix_mv_new(cx, 2, d, 2, false, pts, &m));
    return m;
}

/* The medial curve of the parabola y = x^2 (inside) and the line y = 3 (below)
 * ends at a focal point of the parabola: its distance there is the radius of
 * curvature (1 + 4 x^2)^(3/2) / 2, that of the line 2.5 - 3 x^2. */
static void focal_point(void **state)
{
    static const double p[3][2] = {{-2, 4}, {0, -4}, {2, 4}};
    ix_geo_surface s = {.mv = make_plane(ctx)};
    ix_mv *a = plane_curve(ctx, 3, p), *b = plane_line(ctx, -5, 3, 5, 3);
    const ix_medial_opts m = {.sides = {1, -1}};
    double lo = 0, hi = 1;
    int seen = 0;
    ix_geo_curves o;

    (void)state;
    for (int i = 0; i < 60; i++) {
        double x = 0.5 * (lo + hi), w = 1 + 4 * x * x;

        *(w * sqrt(w) / 2 < 2.5 - 3 * x * x ? &lo : &hi) = x;
    }
    for (int swap = 0; swap < 2; swap++) {
        const ix_medial_opts w = {.sides = {-1, 1}};

        ASSERT_OK(ctx, ix_medial_crv(ctx, &s, swap ? b : a, swap ? a : b,
                                     swap ? &w : &m, &fine, &o));
        for (int k = 0; k < o.n; k++)
            for (int e = 0; e < 2; e++) {
                double st[4];
                ix_geo_stop stop = o.crv[k].stop[e];

                if (stop != (swap ? IX_GEO_FOCAL2 : IX_GEO_FOCAL))
                    continue;
                seen++;
                value(ctx, o.crv[k].states, e ? end_of(o.crv[k].states) : 0,
                      st);
                ASSERT_CLOSE(fabs(4 * st[swap ? 2 : 0] - 2), lo, 1e-9);
                ASSERT_CLOSE(st[3], 2.5 - 3 * lo * lo, 1e-9);
            }
        ix_geo_curves_free(ctx, &o);
    }
    assert_int_equal(seen, 4); /* on both sides, each from both borders */
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s.mv);
}

/* Law: two lines in the plane have the lines that halve their angles; the
 * domain, a corner and the reach end a medial curve. */
static void ends(void **state)
{
    ix_geo_surface s = {.mv = make_plane(ctx)};
    ix_mv *a = plane_line(ctx, -8, 0, 8, 0), *b = plane_line(ctx, 0, -8, 0, 8);
    const ix_medial_opts m = {.sides = {1, 1}};
    ix_geo_opts near = {.tol = 1e-10, .reach = 2.5};
    const double bent[6] = {0, 0, 2, -8, 4, 5}, kv[5] = {0, 0, 0.5, 1, 1};
    ix_dir dir = {IX_BSPLINE, 2, 3, false, kv};
    double x[2], st[4];
    ix_mv *l;
    ix_geo_curves o;

    (void)state;
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &m, &fine, &o));
    assert_int_equal(o.n, 1);
    assert_true(o.crv->miss <= 1e-13);
    value(ctx, o.crv->uv, 0.3 * end_of(o.crv->uv), x);
    ASSERT_CLOSE(x[1], -x[0], 1e-12); /* left of a: up, left of b: to -x */
    assert_int_equal(o.crv->stop[0], IX_GEO_END);
    ix_geo_curves_free(ctx, &o);
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &m, &near, &o));
    assert_int_equal(o.crv->stop[1], IX_GEO_REACH);
    value(ctx, o.crv->states, end_of(o.crv->states), st);
    ASSERT_CLOSE(st[3], 2.5, 1e-9);
    ix_geo_curves_free(ctx, &o);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, bent, &l));
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, l, &m, &fine, &o));
    assert_int_equal(o.n, 1);
    assert_true(o.crv->stop[0] == IX_GEO_CORNER ||
                o.crv->stop[1] == IX_GEO_CORNER);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, l);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s.mv);
}

/* The segment x = x0, y = 0.8 .. 2 in polar coordinates, within 1e-10. */
static ix_mv *polar_segment(double x0)
{
    enum { N = 24 };
    double pts[2 * N];
    const ix_interpolate_opts o = {.order = 10};
    ix_mv *m;

    for (int i = 0; i < N; i++) {
        double y = 0.8 + 1.2 * i / (N - 1);

        pts[i] = atan2(y, x0);
        pts[N + i] = hypot(x0, y);
    }
    ASSERT_OK(ctx, ix_interpolate(ctx, N, 2, false, pts, &o, NULL, &m));
    return m;
}

/* In the plane without the unit disc, the medial curve of the segments x = -1
 * and x = 3, y >= 0.8, is x = 1 down to y = 1: there, not at the domain's edge,
 * but far from it, the geodesics from x = -1 touch the disc. */
static void around_a_hole(void **state)
{
    double slope = 0, x[3];
    ix_geo_surface s = by_function(cone_fn, &slope, 0.1, 3.1, 1, 5);
    ix_mv *a = polar_segment(-1), *b = polar_segment(3);
    const ix_medial_opts m = {.sides = {1, -1}};
    ix_geo_curves o; /* S_u x S_v points down: left is the right */
    int e;

    (void)state;
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &m, &coarse, &o));
    assert_int_equal(o.n, 1);
    e = o.crv->stop[1] == IX_GEO_DOMAIN;
    assert_int_equal(o.crv->stop[e], IX_GEO_DOMAIN);
    value(ctx, o.crv->space, e ? end_of(o.crv->space) : 0, x);
    ASSERT_CLOSE(x[0], 1, 1e-7);
    /* where it turns round between two steps is known to the cubic's error */
    ASSERT_CLOSE(x[1], 1, 1e-4);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

static void errors(void **state)
{
    ix_geo_surface s = {.mv = make_plane(ctx)};
    ix_mv *a = plane_line(ctx, -8, 0, 8, 0), *b = plane_line(ctx, -8, 1, 8, 1);
    ix_medial_opts m = {.sides = {1, 0}};
    ix_geo_curves o;

    (void)state;
    assert_int_equal(ix_medial_crv(ctx, &s, a, b, &m, NULL, &o), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "sides 1, 0"));
    m = (ix_medial_opts){
        .sides = {-1, -1}, .start = IX_MEDIAL_GUESS, .guess = {0.5, 0.5, 1}};
    assert_int_equal(ix_medial_crv(ctx, &s, a, b, &m, NULL, &o), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "no medial point"));
    assert_int_equal(ix_medial_crv(ctx, &s, a, s.mv, &m, NULL, &o), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "curve 2"));
    /* no medial point at all is no error */
    m = (ix_medial_opts){.sides = {-1, 1}};
    ASSERT_OK(ctx, ix_medial_crv(ctx, &s, a, b, &m, NULL, &o));
    assert_int_equal(o.n, 0);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s.mv);
}

typedef struct {
    ix_mv *m, *a, *b;
    ix_geo_curves o;
} work;

static void make(ix_ctx *cx, void *state)
{
    work *w = state;

    *w = (work){.m = make_plane(cx),
                .a = plane_line(cx, -8, 0, 8, 0),
                .b = plane_line(cx, 0, -8, 1, 8)};
}

static ix_status run(ix_ctx *cx, void *state)
{
    work *w = state;
    const ix_geo_opts o = {.tol = 1e-2};
    ix_geo_surface s = {.mv = w->m};

    return ix_medial_crv(cx, &s, w->a, w->b, NULL, &o, &w->o);
}

static void drop(ix_ctx *cx, void *state)
{
    work *w = state;

    ix_geo_curves_free(cx, &w->o);
    ix_mv_unref(cx, w->m);
    ix_mv_unref(cx, w->a);
    ix_mv_unref(cx, w->b);
}

static void faults(void **state)
{
    work w;
    const ix_fault_case f = {make, run, drop, &w};

    (void)state;
    assert_true(ix_fault_run(&f) > 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(five_meetings), cmocka_unit_test(no_meeting),
        cmocka_unit_test(great_circles), cmocka_unit_test(focal_point),
        cmocka_unit_test(ends),          cmocka_unit_test(errors),
        cmocka_unit_test(faults),        cmocka_unit_test(around_a_hole),
    };

    GEO_RUN(tests);
}
