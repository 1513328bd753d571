/* Focal curves of curves on surfaces: closed forms on the sphere, and on an
 * ellipsoid and the wave surface the definition itself: neighbouring geodesics
 * touch there, and offsets have their cusps. */
#include "geo_test.h"

IX_TEST_FIXTURE(304)

static const ix_geo_opts middle = {.tol = 1e-7};

static const double bow[3][2] = {{-1, -0.7}, {0, -1.2}, {1, -0.2}};

/* Law: on the unit sphere tan s = 1 / kg; for a great circle s = pi / 2 and
 * the focal curve is the pole. */
static void sphere(void **state)
{
    double r[3] = {1, 1, 1}, x[3];
    ix_geo_surface s = by_function(ellipsoid_fn, r, -2, 2, -1.5, 1.8);
    ix_mv *c = plane_curve(ctx, 3, bow), *e;
    ix_geo_curves o;

    (void)state;
    ASSERT_OK(ctx, ix_srf_focal_crv(ctx, &s, c, 1, &middle, &o));
    assert_int_equal(o.n, 1);
    assert_true(o.crv->miss <= 1e-9);
    for (size_t i = 0; i < ix_mv_npts(o.crv->states); i++) {
        double t = ix_mv_coord(o.crv->states, 0)[i], kg[2];
        double dist = ix_mv_coord(o.crv->states, 1)[i];

        ASSERT_OK(ctx, ix_geodesic_curvature(ctx, &s, c, t, kg));
        ASSERT_CLOSE(dist, atan2(1, kg[0]), 1e-9);
        /* (5.5): s' = -kg' / (1 + kg^2) */
        ASSERT_CLOSE(ix_mv_coord(o.crv->states, 4)[i],
                     -kg[1] / (1 + kg[0] * kg[0]), 1e-7);
    }
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, c);
    /* a great circle in general position: its pole is (-sin a, 0, cos a) */
    s = by_function(ellipsoid_fn, r, -2, 6, -1.5, 1.5);
    e = plane_line(ctx, 0.3, -1, 0.3, 1);
    ASSERT_OK(ctx, ix_srf_focal_crv(ctx, &s, e, -1, &middle, &o));
    assert_int_equal(o.n, 1);
    ASSERT_CLOSE(ix_mv_coord(o.crv->states, 1)[0], PI / 2, 1e-9);
    value(ctx, o.crv->space, 0.4, x);
    ASSERT_CLOSE(x[0], -sin(0.3), 1e-9);
    ASSERT_CLOSE(x[1], cos(0.3), 1e-9);
    ASSERT_CLOSE(x[2], 0, 1e-9);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, e);
}

/* The geodesics at t - h and t + h, as long as that at t to its focal point,
 * end together: their distance is O(h^3) plus what s' makes of it. */
static void assert_touch(const ix_geo_surface *s, const ix_mv *c, double side,
                         double t, double dist)
{
    const double h = 5e-4;
    double x[3][3], d = 0;

    for (int i = 0; i < 2; i++)
        offset_point(ctx, s, c, t + (i ? h : -h), side * dist, x[i]);
    for (int k = 0; k < 3; k++)
        d += (x[1][k] - x[0][k]) * (x[1][k] - x[0][k]);
    /* |dO/dt| is of the size of 1 at the border; O''' h^2 / 6 remains */
    if (!(sqrt(d) / (2 * h) <= 1e-4))
        fail_msg("at t = %g the derivative of O is %g", t, sqrt(d) / (2 * h));
}

/* The offset at the focal distance of some t has a cusp at this t: of a piece
 * of the border around it, for time's sake. */
static void assert_cusp(const ix_geo_surface *s, const ix_mv *c, double side,
                        double t, double dist)
{
    const double h = 0.02;
    ix_geo_curves o;
    double *cusp, best = HUGE_VAL;
    ix_mv *piece;
    int n;

    ASSERT_OK(ctx, ix_mv_region(ctx, c, 0, t - h, t + h, &piece));
    ASSERT_OK(ctx, ix_geodesic_offset(ctx, s, piece, side * dist, NULL, &middle,
                                      &n, &cusp, &o));
    for (int i = 0; i < n; i++)
        best = fmin(best, fabs(t - h + 2 * h * cusp[i] - t));
    ASSERT_CLOSE(best, 0, 1e-7);
    ix_geo_numbers_free(ctx, cusp, n);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, piece);
}

static void check_surface(const ix_geo_surface *s, const ix_mv *c, int side)
{
    ix_geo_curves o;

    ASSERT_OK(ctx, ix_srf_focal_crv(ctx, s, c, side, &middle, &o));
    assert_true(o.n >= 1);
    for (int k = 0; k < o.n; k++) {
        const ix_mv *st = o.crv[k].states;
        size_t n = ix_mv_npts(st), at = n / 3;
        double t = ix_mv_coord(st, 0)[at], dist = ix_mv_coord(st, 1)[at];

        assert_true(o.crv[k].miss <= 1e-7);
        assert_touch(s, c, side, t, dist);
        assert_cusp(s, c, side, t, dist);
    }
    ix_geo_curves_free(ctx, &o);
}

static void ellipsoid(void **state)
{
    double r[3] = {1, 1.3, 0.8};
    ix_geo_surface s = by_function(ellipsoid_fn, r, -2, 2, -1.5, 1.5);
    ix_mv *c = plane_curve(ctx, 3, bow);

    (void)state;
    check_surface(&s, c, 1);
    ix_mv_unref(ctx, c);
}

static void wave(void **state)
{
    static const double p[3][2] = {{1.2, 1.6}, {3.5, 4}, {5.4, 1.5}};
    ix_geo_surface s = by_function(wave_fn, NULL, 0, 2 * PI, 0, 2 * PI);
    ix_mv *c = plane_curve(ctx, 3, p);

    (void)state;
    check_surface(&s, c, -1);
    ix_mv_unref(ctx, c);
}

static void hill(double u, double v, double *x)
{
    x[0] = u;
    x[1] = v;
    x[2] = 2 * u * (1 - u) * v * (1 - v);
}

/* Law: a cubic spline with a knot, where grad K jumps, and a quadratic one,
 * where K and kg jump and the focal curve with them: s' is the derivative of s
 * all the same. */
static void over_knots(void **state)
{
    static const double p[3][2] = {{0.1, 0.25}, {0.5, -0.05}, {0.9, 0.25}};
    const double knot = 0.45;
    ix_mv *c = plane_curve(ctx, 3, p);

    (void)state;
    for (int order = 3; order <= 4; order++) {
        ix_geo_surface s = {.mv = spline_surface(ctx, order, 1, &knot, hill)};
        ix_geo_curves o;

        ASSERT_OK(ctx, ix_srf_focal_crv(ctx, &s, c, 1, &middle, &o));
        assert_int_equal(o.n, order == 3 ? 2 : 1);
        assert_int_equal(o.crv->stop[1],
                         order == 3 ? IX_GEO_CORNER : IX_GEO_DOMAIN);
        for (int k = 0; k < o.n; k++)
            assert_true(o.crv[k].miss <= 1e-6 && o.crv[k].fit <= 1e-7);
        ix_geo_curves_free(ctx, &o);
        ix_mv_unref(ctx, s.mv);
    }
    ix_mv_unref(ctx, c);
}

static void errors(void **state)
{
    double r[3] = {1, 1, 1}, slope = 0;
    ix_geo_surface s = by_function(ellipsoid_fn, r, -2, 2, -1.5, 1.5);
    ix_geo_surface flat = by_function(cone_fn, &slope, -1, 1, 1, 3);
    ix_mv *c = plane_curve(ctx, 3, bow), *l = plane_line(ctx, 0, 1.5, 0, 2.5);
    ix_geo_curves o;

    (void)state;
    assert_int_equal(ix_srf_focal_crv(ctx, &s, c, 0, NULL, &o), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "side 0"));
    /* a straight line in the plane has no focal points: no error */
    ASSERT_OK(ctx, ix_srf_focal_crv(ctx, &flat, l, 1, NULL, &o));
    assert_int_equal(o.n, 0);
    ix_geo_curves_free(ctx, &o);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, l);
}

typedef struct {
    ix_mv *c;
    ix_geo_curves o;
} work;

static void make(ix_ctx *cx, void *state)
{
    work *w = state;

    *w = (work){.c = plane_curve(cx, 3, bow)};
}

static ix_status run(ix_ctx *cx, void *state)
{
    work *w = state;
    double r[3] = {1, 1, 1};
    const ix_geo_opts o = {.tol = 0.1};
    ix_geo_surface s = by_function(ellipsoid_fn, r, -2, 2, -1.5, 1.5);

    return ix_srf_focal_crv(cx, &s, w->c, 1, &o, &w->o);
}

static void drop(ix_ctx *cx, void *state)
{
    work *w = state;

    ix_geo_curves_free(cx, &w->o);
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
        cmocka_unit_test(sphere), cmocka_unit_test(ellipsoid),
        cmocka_unit_test(wave),   cmocka_unit_test(over_knots),
        cmocka_unit_test(errors), cmocka_unit_test(faults),
    };

    GEO_RUN(tests);
}
