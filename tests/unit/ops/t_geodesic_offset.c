/* Geodesic offsets against closed forms: parallels, unrolled surfaces, planar
 * offsets with their cusps; variable distances. */
#include "geo_test.h"

IX_TEST_FIXTURE(302)

static const ix_geo_opts fine = {.tol = 1e-10};

/* Law: the offset of a parallel of the unit sphere is another one; y is the
 * ratio of their radii. */
static void parallels(void **state)
{
    double r[3] = {1, 1, 1};
    ix_geo_surface s = by_function(ellipsoid_fn, r, 0, 6, -1.5, 1.5);
    ix_mv *c = plane_line(ctx, 0.5, 0.2, 5, 0.2);
    ix_geo_curves o;

    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        double x[5], lat = 0.2 + side * 0.7;

        ASSERT_OK(ctx, ix_geodesic_offset(ctx, &s, c, side * 0.7, NULL, &fine,
                                          NULL, NULL, &o));
        assert_int_equal(o.n, 1);
        assert_true(o.crv->fit <= 1e-10 && o.crv->miss <= 1e-11);
        for (int i = 0; i <= 20; i++) {
            double t = 0.05 * i, u = 0.5 + 4.5 * t;

            value(ctx, o.crv->uv, t, x);
            ASSERT_CLOSE(x[0], u, 1e-10);
            ASSERT_CLOSE(x[1], lat, 1e-10);
            value(ctx, o.crv->space, t, x);
            ASSERT_CLOSE(x[0], cos(lat) * cos(u), 1e-10);
            value(ctx, o.crv->states, t, x);
            ASSERT_CLOSE(x[3], 4.5 * cos(lat), 1e-10);
            ASSERT_CLOSE(x[4], side * 0.7, 1e-15);
        }
        ix_geo_curves_free(ctx, &o);
    }
    ix_mv_unref(ctx, c);
}

/* The plane [-3, 3]^2 in the parameters u, v. */
static ix_mv *make_plane(ix_ctx *cx)
{
    ix_mv *m, *p;
    double pts[8] = {-3, 3, -3, 3, -3, -3, 3, 3};
    ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                   {IX_BEZIER, 2, 2, false, NULL}};

    ASSERT_OK(cx, ix_mv_new(cx, 2, d, 2, false, pts, &m));
    ASSERT_OK(cx, ix_mv_reparam(cx, m, 0, -3, 3, &p));
    ix_mv_unref(cx, m);
    ASSERT_OK(cx, ix_mv_reparam(cx, p, 1, -3, 3, &m));
    ix_mv_unref(cx, p);
    return m;
}

/* Law: the offset of the parabola (t, t^2) in the plane at the distance 1 has
 * cusps where the radius of curvature is 1; in between it runs backwards. */
static void plane_cusps(void **state)
{
    static const double p[3][2] = {{-1, 1}, {0, -1}, {1, 1}};
    const double cusp = sqrt((cbrt(4.0) - 1) / 4);
    ix_geo_surface s = {.mv = make_plane(ctx)};
    ix_mv *c = plane_curve(ctx, 3, p);
    ix_geo_curves o;
    double *t;
    int n;

    (void)state;
    ASSERT_OK(ctx, ix_geodesic_offset(ctx, &s, c, 1, NULL, &fine, &n, &t, &o));
    assert_int_equal(n, 2);
    for (int i = 0; i < 2; i++) /* the parameter is (x + 1) / 2 */
        ASSERT_CLOSE(2 * t[i] - 1, i ? cusp : -cusp, 1e-13);
    ix_geo_numbers_free(ctx, t, n);
    assert_int_equal(o.n, 1);
    assert_true(o.crv->miss <= 1e-14);
    for (int i = 0; i <= 20; i++) {
        double x = -1 + 0.1 * i, w = sqrt(1 + 4 * x * x), q[2];

        value(ctx, o.crv->uv, 0.05 * i, q);
        ASSERT_CLOSE(q[0], x - 2 * x / w, 1e-10);
        ASSERT_CLOSE(q[1], x * x + 1 / w, 1e-10);
    }
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s.mv);
}

/* Law: on the unrolled cylinder the variable offset is C + d(t) N, exactly
 * where the curve is straight. */
static void variable(void **state)
{
    ix_geo_surface s = by_function(cylinder_fn, NULL, -9, 9, -9, 9);
    ix_mv *c = plane_line(ctx, 0, 0, 3, 4), *d;
    const double heights[3] = {0, 2, -1};
    ix_dir dir = {IX_BSPLINE, 2, 3, false, (double[5]){0, 0, 0.4, 1, 1}};
    ix_geo_curves o;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, heights, &d));
    ASSERT_OK(ctx,
              ix_geodesic_offset(ctx, &s, c, 0.5, d, &fine, NULL, NULL, &o));
    assert_int_equal(o.n, 1);
    for (int i = 0; i <= 20; i++) {
        double t = 0.05 * i, h = 0.5, q[2];

        h += t < 0.4 ? 5 * t : 2 - 5 * (t - 0.4);
        value(ctx, o.crv->uv, t, q);
        ASSERT_CLOSE(q[0], 3 * t - 0.8 * h, 1e-10);
        ASSERT_CLOSE(q[1], 4 * t + 0.6 * h, 1e-10);
    }
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, d);
    ix_mv_unref(ctx, c);
}

/* A border that comes near the edge: the offset is interrupted where the
 * geodesics end there; at a corner it has a gap. */
static void interrupted(void **state)
{
    static const double p[3][2] = {{-2, 1}, {0, 4}, {2, 1}};
    ix_geo_surface s = {.mv = make_plane(ctx)};
    ix_mv *c = plane_curve(ctx, 3, p), *l;
    ix_dir dir = {IX_BSPLINE, 2, 3, false, (double[5]){0, 0, 0.5, 1, 1}};
    const double bent[6] = {-1, 0, 1, -1, 0, -1};
    ix_geo_curves o;
    double x[2];

    (void)state;
    ASSERT_OK(ctx,
              ix_geodesic_offset(ctx, &s, c, 1, NULL, &fine, NULL, NULL, &o));
    assert_int_equal(o.n, 2);
    assert_int_equal(o.crv[0].stop[0], IX_GEO_END);
    assert_int_equal(o.crv[0].stop[1], IX_GEO_DOMAIN);
    assert_int_equal(o.crv[1].stop[0], IX_GEO_DOMAIN);
    value(ctx, o.crv[0].uv, end_of(o.crv[0].uv), x);
    ASSERT_CLOSE(x[1], 3, 1e-11);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, bent, &l));
    ASSERT_OK(ctx,
              ix_geodesic_offset(ctx, &s, l, 1, NULL, &fine, NULL, NULL, &o));
    assert_int_equal(o.n, 2);
    assert_int_equal(o.crv[0].stop[1], IX_GEO_CORNER);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, l);
    ix_mv_unref(ctx, s.mv);
}

static void errors(void **state)
{
    ix_geo_surface s = {.mv = make_plane(ctx)};
    ix_mv *c = plane_line(ctx, -1, 0, 1, 0), *d;
    ix_geo_curves o;

    (void)state;
    assert_int_equal(
        ix_geodesic_offset(ctx, &s, c, NAN, NULL, 0, NULL, NULL, &o), IX_EARG);
    assert_int_equal(ix_geodesic_offset(ctx, &s, c, 5, NULL, 0, NULL, NULL, &o),
                     IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "no geodesic of length 5"));
    ASSERT_OK(ctx, ix_mv_reparam(ctx, c, 0, 0, 2, &d));
    assert_int_equal(ix_geodesic_offset(ctx, &s, c, 0, d, 0, NULL, NULL, &o),
                     IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "given over [0, 2]"));
    assert_int_equal(ix_geodesic_offset(ctx, &s, c, 0, s.mv, 0, NULL, NULL, &o),
                     IX_EARG);
    ix_mv_unref(ctx, d);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s.mv);
}

typedef struct {
    ix_mv *m, *c;
    double *cusps;
    int n;
    ix_geo_curves o;
} work;

static void make(ix_ctx *cx, void *state)
{
    static const double p[3][2] = {{-1, 1}, {0, -1}, {1, 1}};
    work *w = state;

    *w = (work){.m = make_plane(cx), .c = plane_curve(cx, 3, p)};
}

static ix_status run(ix_ctx *cx, void *state)
{
    work *w = state;
    const ix_geo_opts o = {.tol = 1e-2};
    ix_geo_surface s = {.mv = w->m};

    return ix_geodesic_offset(cx, &s, w->c, 1, NULL, &o, &w->n, &w->cusps,
                              &w->o);
}

static void drop(ix_ctx *cx, void *state)
{
    work *w = state;

    ix_geo_numbers_free(cx, w->cusps, w->n);
    ix_geo_curves_free(cx, &w->o);
    ix_mv_unref(cx, w->m);
    ix_mv_unref(cx, w->c);
}

static void faults(void **state)
{
    work w;
    const ix_fault_case f = {make, run, drop, &w};

    (void)state;
    assert_true(ix_fault_run(&f) > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallels), cmocka_unit_test(plane_cusps),
        cmocka_unit_test(variable),  cmocka_unit_test(interrupted),
        cmocka_unit_test(errors),    cmocka_unit_test(faults),
    };

    GEO_RUN(tests);
}
