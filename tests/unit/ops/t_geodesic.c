/* Geodesics against closed forms: lines, great circles, unrolled surfaces,
 * Clairaut's relation; and what stops them. */
#include "geo_test.h"

IX_TEST_FIXTURE(301)

static const ix_geo_opts fine = {.tol = 1e-10};

/* Law: on the unit sphere a geodesic is the great circle cos s P + sin s D;
 * its polar Jacobi field is sin s, the conjugate point at pi. */
static void great_circle(void **state)
{
    double r[3] = {1, 1, 1}, uv[2] = {0.5, 0.1}, dir[2] = {1, 0.35}, conj;
    ix_geo_surface s = by_function(ellipsoid_fn, r, -1, 6, -1.4, 1.4);
    double j[10][3], d[3], len = 0;
    ix_geo_curve g;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 4, &fine, &conj, &g));
    assert_int_equal(g.stop[1], IX_GEO_END);
    ASSERT_CLOSE(conj, PI, 1e-10);
    assert_true(g.fit <= 1e-10 && g.miss <= 1e-10);
    (void)ellipsoid_fn(r, uv[0], uv[1], 1, j);
    for (int c = 0; c < 3; c++) {
        d[c] = dir[0] * j[1][c] + dir[1] * j[2][c];
        len += d[c] * d[c];
    }
    for (int i = 0; i <= 40; i++) {
        double x[3], t = 0.1 * i;

        value(ctx, g.space, t, x);
        for (int c = 0; c < 3; c++)
            ASSERT_CLOSE(x[c], cos(t) * j[0][c] + sin(t) * d[c] / sqrt(len),
                         1e-10);
    }
    ASSERT_CLOSE(end_of(g.space), 4, 1e-15);
    for (size_t i = 0; i < ix_mv_npts(g.states); i++) {
        const double t = ix_mv_coord(g.states, 0)[i];

        ASSERT_CLOSE(ix_mv_coord(g.states, 3)[i], sin(t), 1e-11);
        ASSERT_CLOSE(ix_mv_coord(g.states, 4)[i], cos(t), 1e-11);
    }
    ix_geo_curve_free(ctx, &g);
}

/* Law: unrolled, the geodesics of a cylinder and a cone are straight: helices
 * with constant u' and v', and straight lines in polar coordinates. */
static void unrolled(void **state)
{
    double slope = 0.75, l = sqrt(1 + slope * slope), dir[2] = {1, 0.5};
    ix_geo_surface cyl = by_function(cylinder_fn, NULL, -9, 9, -9, 9);
    ix_geo_surface cone = by_function(cone_fn, &slope, -3, 3, 0.1, 5);
    ix_geo_curve g;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic(ctx, &cyl, (double[2]){0.2, 0.3}, dir, 5, &fine,
                               NULL, &g));
    for (int i = 0; i <= 10; i++) {
        double x[2], t = 0.5 * i / hypot(1, 0.5);

        value(ctx, g.uv, 0.5 * i, x);
        ASSERT_CLOSE(x[0], 0.2 + t, 1e-11);
        ASSERT_CLOSE(x[1], 0.3 + 0.5 * t, 1e-11);
    }
    ix_geo_curve_free(ctx, &g);
    /* from u = 0 across the rulings: x = r0 = v l in the unrolled plane */
    ASSERT_OK(ctx, ix_geodesic(ctx, &cone, (double[2]){0, 1}, (double[2]){1, 0},
                               2, &fine, NULL, &g));
    for (int i = 0; i <= 10; i++) {
        double x[2], s = 0.2 * i;

        value(ctx, g.uv, s, x);
        ASSERT_CLOSE(x[0], atan2(s, l) * l, 1e-10);
        ASSERT_CLOSE(x[1], hypot(s, l) / l, 1e-10);
    }
    assert_true(g.miss <= 1e-11);
    ix_geo_curve_free(ctx, &g);
}

/* Law: on a surface of revolution r^2 u' is constant (Clairaut), and u', v'
 * have length 1; the torus through both signs of its curvature. */
static void clairaut(void **state)
{
    double r[2] = {3, 1}, uv[2] = {0, 0.4}, dir[2] = {0.4, 1}, first = 0;
    ix_geo_surface s = by_function(torus_fn, r, -20, 20, -20, 20);
    ix_geo_curve g;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 12, &fine, NULL, &g));
    for (int i = 0; i <= 60; i++) {
        double d[4], rad, c;

        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, g.uv, 0.2 * i, 1, d));
        rad = r[0] + r[1] * cos(d[1]);
        c = rad * rad * d[2];
        first = i ? first : c;
        /* derivatives of a curve that is exact to 1e-10 over steps of 0.3 */
        ASSERT_CLOSE(c, first, 1e-7);
        ASSERT_CLOSE(rad * rad * d[2] * d[2] + d[3] * d[3], 1, 1e-7);
    }
    assert_true(g.miss <= 1e-10);
    ix_geo_curve_free(ctx, &g);
}

static void bend(double u, double v, double *x)
{
    x[0] = u + 0.2 * v * v;
    x[1] = v - 0.1 * u * v;
    x[2] = 0.6 * u * (1 - u) * cos(3 * v) + 0.2 * v * v;
}

static void assert_same_end(const ix_geo_curve *a, const ix_geo_curve *b,
                            double tol)
{
    double x[3], y[3];

    value(ctx, a->space, end_of(a->space), x);
    value(ctx, b->space, end_of(b->space), y);
    for (int c = 0; c < 3; c++)
        ASSERT_CLOSE(x[c], y[c], tol);
}

/* Law: knots that change nothing, and a B-spline in place of a Bezier surface,
 * give the same geodesic; on a C1 and a C2 spline the way back meets the start,
 * though it is integrated cell by cell. */
static void over_knots(void **state)
{
    const double uv[2] = {0.05, 0.1}, dir[2] = {1, 0.8};
    const double twice[4] = {0.3, 0.3, 0.7, 0.7}, once[3] = {0.2, 0.5, 0.6};
    ix_mv *m = spline_surface(ctx, 5, 0, NULL, bend), *k;
    ix_geo_surface s = {.mv = m};
    ix_geo_curve a, b;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 1, &fine, NULL, &a));
    ASSERT_OK(ctx,
              ix_mv_insert_knots(ctx, m, 0, 3, (double[3]){0.3, 0.3, 0.8}, &k));
    s.mv = k;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 1, &fine, NULL, &b));
    assert_same_end(&a, &b, 1e-11);
    ix_geo_curve_free(ctx, &a);
    ix_geo_curve_free(ctx, &b);
    ix_mv_unref(ctx, k);
    ix_mv_unref(ctx, m);
    for (int i = 0; i < 2; i++) {
        s.mv = spline_surface(ctx, 4, i ? 3 : 4, i ? once : twice, bend);
        ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 1, &fine, NULL, &a));
        assert_int_equal(a.stop[1], IX_GEO_END);
        assert_true(a.miss <= 1e-11 && a.fit <= 1e-10);
        ix_geo_curve_free(ctx, &a);
        ix_mv_unref(ctx, s.mv);
    }
}

/* Law: in a plane geodesics are straight to rounding, whatever the parameters;
 * they end at the edge. */
static void planar(void **state)
{
    const double uv[2] = {0.2, 0.3}, dir[2] = {1, 0.4};
    const double w[9] = {1, 2, 1, 1, 1.5, 1, 2, 1, 1};
    double pts[4 * 9], p[3], q[3], x[3];
    ix_dir d[2] = {{IX_BEZIER, 3, 3, false, NULL},
                   {IX_BEZIER, 3, 3, false, NULL}};
    ix_geo_surface s = {0};
    ix_mv *m;
    ix_geo_curve g;

    (void)state;
    for (int i = 0; i < 9; i++) {
        double u = i % 3, v = i / 3 + 0.2 * u * u;

        pts[i] = w[i];
        pts[9 + i] = w[i] * u;
        pts[18 + i] = w[i] * v;
        pts[27 + i] = w[i] * (2 * u - v + 1);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, true, pts, &m));
    s.mv = m;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 100, &fine, NULL, &g));
    assert_int_equal(g.stop[1], IX_GEO_DOMAIN);
    value(ctx, g.uv, end_of(g.uv), x);
    ASSERT_CLOSE(fmax(x[0], x[1]), 1, 1e-11);
    value(ctx, g.space, 0, p);
    value(ctx, g.space, end_of(g.space), q);
    for (int i = 0; i <= 10; i++) {
        value(ctx, g.space, 0.1 * i * end_of(g.space), x);
        for (int c = 0; c < 3; c++)
            ASSERT_CLOSE(x[c], p[c] + 0.1 * i * (q[c] - p[c]), 1e-13);
    }
    ix_geo_curve_free(ctx, &g);
    ix_mv_unref(ctx, m);
}

static void roof(double u, double v, double *x)
{
    x[0] = u;
    x[1] = v;
    x[2] = -fabs(u - 0.5);
}

/* The edge of the domain is met within rounding; a crease ends a geodesic. */
static void stops(void **state)
{
    const double half = 0.5;
    double r[3] = {1, 1, 1}, x[2];
    ix_geo_surface s = by_function(ellipsoid_fn, r, 0, 1, -1, 1);
    ix_geo_curve g;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, (double[2]){0.25, 0}, (double[2]){1, 0},
                               4, &fine, NULL, &g));
    assert_int_equal(g.stop[1], IX_GEO_DOMAIN);
    value(ctx, g.uv, end_of(g.uv), x);
    ASSERT_CLOSE(x[0], 1, 1e-11);
    ASSERT_CLOSE(end_of(g.uv), 0.75, 1e-11);
    ix_geo_curve_free(ctx, &g);
    s = (ix_geo_surface){.mv = spline_surface(ctx, 2, 1, &half, roof)};
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, (double[2]){0.1, 0.1},
                               (double[2]){1, 0}, 4, &fine, NULL, &g));
    assert_int_equal(g.stop[1], IX_GEO_CREASE);
    ASSERT_CLOSE(end_of(g.uv), 0.4 * sqrt(2), 1e-11);
    ix_geo_curve_free(ctx, &g);
    ix_mv_unref(ctx, s.mv);
}

/* Law: a piece of a surface, and units of other sizes, change nothing but the
 * numbers: lengths by the factor of the units. */
static void piece_and_units(void **state)
{
    const double uv[2] = {0.3, 0.4}, dir[2] = {1, 0.3};
    ix_mv *m = spline_surface(ctx, 4, 0, NULL, bend), *big;
    double mat[16] = {1000, 0, 0, 0, 0, 1000, 0, 0, 0, 0, 1000, 0, 7, 8, 9, 1};
    ix_geo_surface s = {.mv = m}, t = {.lo = {0.2, 0.3}, .hi = {0.6, 0.8}};
    ix_geo_curve a, b;
    double x[2], y[2];

    (void)state;
    ASSERT_OK(ctx, ix_mv_transform(ctx, m, mat, &big));
    t.mv = big;
    ASSERT_OK(ctx, ix_geodesic(ctx, &s, uv, dir, 0.25, &fine, NULL, &a));
    ASSERT_OK(ctx, ix_geodesic(ctx, &t, uv, dir, 250, &fine, NULL, &b));
    value(ctx, a.uv, 0.25, x);
    value(ctx, b.uv, 250, y);
    ASSERT_CLOSE(x[0], y[0], 1e-11);
    ASSERT_CLOSE(x[1], y[1], 1e-11);
    ix_geo_curve_free(ctx, &a);
    ix_geo_curve_free(ctx, &b);
    ASSERT_OK(ctx, ix_geodesic(ctx, &t, uv, dir, 2500, &fine, NULL, &b));
    assert_int_equal(b.stop[1], IX_GEO_DOMAIN);
    value(ctx, b.uv, end_of(b.uv), y);
    ASSERT_CLOSE(y[0], 0.6, 1e-11);
    ix_geo_curve_free(ctx, &b);
    ix_mv_unref(ctx, big);
    ix_mv_unref(ctx, m);
}

/* Law: kg of a parallel of the sphere is tan(latitude); its derivative is that
 * by differences; and y is the derivative of O(s, t) by differences. */
static void curvature_and_field(void **state)
{
    static const double p[4][2] = {{1, 3}, {2.5, 5}, {3.7, 4.2}, {5, 3.4}};
    const double h = 1e-4;
    double r[3] = {1, 1, 1}, kg[2], lo[2], hi[2], x[2][3], st[5];
    ix_geo_surface s = by_function(ellipsoid_fn, r, 0, 6, -1.5, 1.5);
    ix_mv *c = plane_line(ctx, 0.5, 0.4, 5, 0.4);
    ix_geo_curve g;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic_curvature(ctx, &s, c, 0.3, kg));
    ASSERT_CLOSE(kg[0], tan(0.4), 1e-14);
    ASSERT_CLOSE(kg[1], 0, 1e-13);
    ix_mv_unref(ctx, c);
    s = by_function(wave_fn, NULL, 0, 2 * PI, 0, 2 * PI);
    c = plane_curve(ctx, 4, p);
    ASSERT_OK(ctx, ix_geodesic_curvature(ctx, &s, c, 0.3, kg));
    ASSERT_OK(ctx, ix_geodesic_curvature(ctx, &s, c, 0.3 - h, lo));
    ASSERT_OK(ctx, ix_geodesic_curvature(ctx, &s, c, 0.3 + h, hi));
    ASSERT_CLOSE(kg[1], (hi[0] - lo[0]) / (2 * h), 1e-6); /* h^2 kg''' */
    for (int side = -1; side <= 1; side += 2) {
        double d = 0;

        ASSERT_OK(ctx,
                  ix_geodesic_normal(ctx, &s, c, 0.3, side, false, &fine, &g));
        value(ctx, g.states, 1, st);
        for (int i = 0; i < 2; i++)
            offset_point(ctx, &s, c, 0.3 + (i ? h : -h), side, x[i]);
        for (int k = 0; k < 3; k++)
            d += (x[1][k] - x[0][k]) * (x[1][k] - x[0][k]);
        ASSERT_CLOSE(fabs(st[3]), sqrt(d) / (2 * h), 1e-5);
        ix_geo_curve_free(ctx, &g);
    }
    ix_mv_unref(ctx, c);
}

/* Every documented error, by its message. */
static void errors(void **state)
{
    double r[3] = {1, 1, 1}, kg[2];
    const double uv[2] = {0.3, 0}, dir[2] = {1, 0}, none[2] = {0, 0};
    ix_geo_surface s = by_function(ellipsoid_fn, r, 0, 1, -PI / 2, 1),
                   bad = {0};
    ix_mv *c = plane_line(ctx, 0.1, 0, 0.9, 0), *out, *still;
    ix_geo_opts wrong = {.tol = -1};
    ix_geo_curve g;

    (void)state;
#define FAILS(st, what, call)                                            \
    do {                                                                 \
        assert_int_equal((call), (st));                                  \
        if (!strstr(ix_ctx_message(ctx), what))                          \
            fail_msg("\"%s\" is not in: %s", what, ix_ctx_message(ctx)); \
    } while (0)
    FAILS(IX_EARG, "either", ix_geodesic(ctx, &bad, uv, dir, 1, 0, 0, &g));
    bad.mv = c;
    FAILS(IX_EARG, "a surface with 2 or 3",
          ix_geodesic(ctx, &bad, uv, dir, 1, 0, 0, &g));
    bad = s;
    bad.hi[0] = 0;
    FAILS(IX_EARG, "is not a domain",
          ix_geodesic(ctx, &bad, uv, dir, 1, 0, 0, &g));
    FAILS(IX_EARG, "direction (0, 0)",
          ix_geodesic(ctx, &s, uv, none, 1, 0, 0, &g));
    FAILS(IX_EARG, "outside",
          ix_geodesic(ctx, &s, (double[2]){2, 0}, dir, 1, 0, 0, &g));
    FAILS(IX_EARG, "length", ix_geodesic(ctx, &s, uv, dir, 0, 0, 0, &g));
    FAILS(IX_EARG, "length", ix_geodesic(ctx, &s, uv, dir, NAN, 0, 0, &g));
    FAILS(IX_EARG, "tolerance -1",
          ix_geodesic(ctx, &s, uv, dir, 1, &wrong, 0, &g));
    FAILS(IX_EDOMAIN, "no normal",
          ix_geodesic(ctx, &s, (double[2]){0.3, -PI / 2}, dir, 1, 0, 0, &g));
    FAILS(IX_EARG, "parameter 3",
          ix_geodesic_normal(ctx, &s, c, 3, 1, false, 0, &g));
    ASSERT_OK(ctx, ix_mv_scalar(ctx, c, 0, &out));
    FAILS(IX_EARG, "2 coordinates",
          ix_geodesic_curvature(ctx, &s, out, 0.5, kg));
    ix_mv_unref(ctx, out);
    out = plane_line(ctx, 0.1, 0, 1.9, 0);
    FAILS(IX_EARG, "leaves the surface's domain",
          ix_geodesic_curvature(ctx, &s, out, 0.5, kg));
    still = plane_line(ctx, 0.1, 0, 0.1, 0);
    FAILS(IX_EDOMAIN, "stands still",
          ix_geodesic_curvature(ctx, &s, still, 0.5, kg));
    assert_null(g.uv);
    ix_mv_unref(ctx, still);
    ix_mv_unref(ctx, out);
    ix_mv_unref(ctx, c);
}

typedef struct {
    ix_mv *m, *c;
    ix_geo_curve g[2];
} work;

static void make(ix_ctx *cx, void *state)
{
    work *w = state;

    w->m = spline_surface(cx, 4, 0, NULL, bend);
    w->c = plane_line(cx, 0.2, 0.3, 0.7, 0.4);
    memset(w->g, 0, sizeof w->g);
}

static ix_status run(ix_ctx *cx, void *state)
{
    work *w = state;
    const ix_geo_opts o = {.tol = 1e-3};
    ix_geo_surface s = {.mv = w->m};
    const double uv[2] = {0.3, 0.4}, dir[2] = {1, 0.3};
    ix_status st = ix_geodesic(cx, &s, uv, dir, 0.2, &o, NULL, &w->g[0]);

    if (st == IX_OK)
        st = ix_geodesic_normal(cx, &s, w->c, 0.5, 0.2, true, &o, &w->g[1]);
    return st;
}

static void drop(ix_ctx *cx, void *state)
{
    work *w = state;

    for (int i = 0; i < 2; i++)
        ix_geo_curve_free(cx, &w->g[i]);
    ix_mv_unref(cx, w->m);
    ix_mv_unref(cx, w->c);
}

static void faults(void **state)
{
    work w;
    const ix_fault_case f = {make, run, drop, &w};

    (void)state;
    assert_true(ix_fault_run(&f) > 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(great_circle),
        cmocka_unit_test(unrolled),
        cmocka_unit_test(clairaut),
        cmocka_unit_test(over_knots),
        cmocka_unit_test(planar),
        cmocka_unit_test(stops),
        cmocka_unit_test(piece_and_units),
        cmocka_unit_test(curvature_and_field),
        cmocka_unit_test(errors),
        cmocka_unit_test(faults),
    };

    GEO_RUN(tests);
}
