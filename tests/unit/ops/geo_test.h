/* geo_test.h - surfaces and curves that the tests of geodesics share. */
#ifndef UNIT_OPS_GEO_TEST_H
#define UNIT_OPS_GEO_TEST_H

#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geodesic.h"

#define PI 3.14159265358979323846

/* f(u) g(v) in one coordinate: derivatives from those of the factors. */
static inline void product(const double f[4], const double g[4], double (*d)[3],
                           int c, int order)
{
    static const int ij[10][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1},
                                  {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};

    for (int k = 0; k < 10 && ij[k][0] + ij[k][1] <= order; k++)
        d[k][c] = f[ij[k][0]] * g[ij[k][1]];
}

/* a + b trig with its derivatives: sin (0) or cos (1). */
static inline void trig(double x, int cosine, double a, double b, double f[4])
{
    double s = sin(x), c = cos(x);
    double v[4] = {cosine ? c : s, cosine ? -s : c, cosine ? -c : -s,
                   cosine ? s : -c};

    for (int k = 0; k < 4; k++)
        f[k] = b * v[k] + (k ? 0 : a);
}

static const double one[4] = {1, 0, 0, 0};

/* ud: double[3], the half axes; u longitude, v latitude. */
static inline bool ellipsoid_fn(void *ud, double u, double v, int order,
                                double (*d)[3])
{
    const double *r = ud;
    double f[4], g[4];

    trig(v, 1, 0, 1, g);
    trig(u, 1, 0, r[0], f);
    product(f, g, d, 0, order);
    trig(u, 0, 0, r[1], f);
    product(f, g, d, 1, order);
    trig(v, 0, 0, r[2], g);
    product(one, g, d, 2, order);
    return true;
}

/* ud: double[2], radius of the centre line and of the tube. */
static inline bool torus_fn(void *ud, double u, double v, int order,
                            double (*d)[3])
{
    const double *r = ud;
    double f[4], g[4];

    trig(v, 1, r[0], r[1], g);
    trig(u, 1, 0, 1, f);
    product(f, g, d, 0, order);
    trig(u, 0, 0, 1, f);
    product(f, g, d, 1, order);
    trig(v, 0, 0, r[1], g);
    product(one, g, d, 2, order);
    return true;
}

/* (v cos u, v sin u, ud v): a cone of slope ud, with ud = 0 a plane. */
static inline bool cone_fn(void *ud, double u, double v, int order,
                           double (*d)[3])
{
    double f[4], g[4] = {v, 1, 0, 0};

    trig(u, 1, 0, 1, f);
    product(f, g, d, 0, order);
    trig(u, 0, 0, 1, f);
    product(f, g, d, 1, order);
    for (int k = 0; k < 4; k++)
        f[k] = *(double *)ud * g[k];
    product(one, f, d, 2, order);
    return true;
}

/* (cos u, sin u, v). */
static inline bool cylinder_fn(void *ud, double u, double v, int order,
                               double (*d)[3])
{
    double f[4], g[4] = {v, 1, 0, 0};

    (void)ud;
    trig(u, 1, 0, 1, f);
    product(f, one, d, 0, order);
    trig(u, 0, 0, 1, f);
    product(f, one, d, 1, order);
    product(one, g, d, 2, order);
    return true;
}

/* (u, v, sin u cos v), the surface of the paper. */
static inline bool wave_fn(void *ud, double u, double v, int order,
                           double (*d)[3])
{
    double f[4], g[4], x[4] = {u, 1, 0, 0}, y[4] = {v, 1, 0, 0};

    (void)ud;
    product(x, one, d, 0, order);
    product(one, y, d, 1, order);
    trig(u, 0, 0, 1, f);
    trig(v, 1, 0, 1, g);
    product(f, g, d, 2, order);
    return true;
}

static inline ix_geo_surface by_function(ix_surface_fn fn, void *ud, double u0,
                                         double u1, double v0, double v1)
{
    return (ix_geo_surface){.fn = fn, .ud = ud, .lo = {u0, v0}, .hi = {u1, v1}};
}

/* A Bezier curve of the parameter plane from n points (u, v). */
static inline ix_mv *plane_curve(ix_ctx *ctx, int n, const double (*p)[2])
{
    ix_dir d = {IX_BEZIER, n, n, false, NULL};
    double pts[2 * 32];
    ix_mv *m;

    for (int i = 0; i < n; i++) {
        pts[i] = p[i][0];
        pts[n + i] = p[i][1];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &m));
    return m;
}

static inline ix_mv *plane_line(ix_ctx *ctx, double u0, double v0, double u1,
                                double v1)
{
    const double p[2][2] = {{u0, v0}, {u1, v1}};

    return plane_curve(ctx, 2, p);
}

/* Value of a curve: out[coords]. */
static inline void value(ix_ctx *ctx, const ix_mv *c, double t, double *out)
{
    ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, out));
}

/* A surface of order (mu, mv) on knots that are open on [0, 1] with the inner
 * ones given, from points f(u, v) at the nodes. */
static inline ix_mv *spline_surface(ix_ctx *ctx, int order, int ninner,
                                    const double *inner,
                                    void (*f)(double u, double v, double *x))
{
    int n = order + ninner;
    double kv[64], node[32], pts[3 * 32 * 32], x[3];
    ix_dir d[2] = {{IX_BSPLINE, order, n, false, kv},
                   {IX_BSPLINE, order, n, false, kv}};
    ix_mv *m;

    for (int i = 0; i < n + order; i++)
        kv[i] = i < order ? 0 : i < n ? inner[i - order] : 1;
    ix_knots_nodes(&d[0], node);
    for (int i = 0; i < n * n; i++) {
        f(node[i % n], node[i / n], x);
        for (int c = 0; c < 3; c++)
            pts[c * n * n + i] = x[c];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, pts, &m));
    return m;
}

/* O(len, t), by the normal geodesic. */
static inline void offset_point(ix_ctx *ctx, const ix_geo_surface *s,
                                const ix_mv *c, double t, double len, double *x)
{
    static const ix_geo_opts fine = {.tol = 1e-10};
    ix_geo_curve g;

    ASSERT_OK(ctx, ix_geodesic_normal(ctx, s, c, t, len, false, &fine, &g));
    assert_int_equal(g.stop[1], IX_GEO_END);
    value(ctx, g.space, fabs(len), x);
    ix_geo_curve_free(ctx, &g);
}

/* Without SUNDIALS there is only the message. */
static inline void left_out(void **state)
{
    double r[3] = {1, 1, 1};
    const double uv[2] = {0, 0}, dir[2] = {1, 0};
    ix_geo_surface s = by_function(ellipsoid_fn, r, -1, 1, -1, 1);
    ix_ctx *cx = ix_ctx_new(NULL, NULL);
    ix_geo_curve g;

    (void)state;
    assert_int_equal(ix_geodesic(cx, &s, uv, dir, 0.5, NULL, NULL, &g),
                     IX_EUNABLE);
    assert_non_null(strstr(ix_ctx_message(cx), "SUNDIALS"));
    ix_ctx_free(cx);
}

#ifdef IX_NO_SUNDIALS
#define GEO_RUN(tests)                                                 \
    do {                                                               \
        const struct CMUnitTest none[] = {cmocka_unit_test(left_out)}; \
                                                                       \
        (void)(tests);                                                 \
        return cmocka_run_group_tests(none, setup, teardown);          \
    } while (0)
#else
#define GEO_RUN(tests) return cmocka_run_group_tests(tests, setup, teardown)
#endif

static inline double end_of(const ix_mv *c)
{
    double dom[2];

    ix_mv_domain(c, 0, dom);
    return dom[1];
}

#endif
