/* t_analytic.c - analytic geometry against its definitions: incidence,
 * perpendicularity, distances by a second way. */
#include "geom/analytic.h"

#include <string.h>

#include "geom/vec3.h"
#include "harness/test.h"

enum { ROUNDS = 300 };
/* Numbers of size 1 .. 10 through some ten operations; near-parallel cases
 * among the random ones cost up to three digits. */
static const double TOL = 1e-11;

static void random3(ix_rng *g, double r, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = ix_rng_range(g, -r, r);
}

static double height(const double pl[4], const double p[3])
{
    return (ix__dot3(pl, p) + pl[3]) / ix__len3(pl);
}

/* Law: the foot is on the line, the way to it perpendicular to the line and
 * as long as the distance. */
static void test_line_foot(void **state)
{
    ix_rng g = ix_rng_new(21);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double p[3], a[3], u[3], f[3], d[3], e[3], c[3], dist;

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        random3(&g, 9, p);
        random3(&g, 9, a);
        random3(&g, 2, u);
        ASSERT_OK(ctx, ix__line_foot(ctx, p, a, u, f));
        ASSERT_OK(ctx, ix__line_dist(ctx, p, a, u, &dist));
        ix__sub3(p, f, d);
        ix__sub3(f, a, e);
        ix__cross3(e, u, c);
        ASSERT_CLOSE(ix__dot3(d, u), 0.0, TOL);
        ASSERT_CLOSE(ix__len3(c), 0.0, TOL);
        ASSERT_CLOSE(ix__len3(d), dist, TOL);
    }
    u[0] = u[1] = u[2] = 0;
    assert_int_equal(ix__line_foot(ctx, p, a, u, f), IX_EARG);
    assert_int_equal(ix__line_dist(ctx, p, a, u, &dist), IX_EARG);
    ix_ctx_free(ctx);
}

/* Law: line and plane share the point; its distance to the plane is 0; the
 * plane through three points contains them. */
static void test_planes(void **state)
{
    ix_rng g = ix_rng_new(22);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double p[3][3], a[3], u[3], q[3], pl[4], d, e[3], c[3];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        for (int i = 0; i < 3; i++)
            random3(&g, 5, p[i]);
        random3(&g, 5, a);
        random3(&g, 5, u);
        ASSERT_OK(ctx, ix__plane_through(ctx, (const double(*)[3])p, pl));
        ASSERT_CLOSE(ix__len3(pl), 1.0, 1e-15);
        for (int i = 0; i < 3; i++) {
            ASSERT_OK(ctx, ix__plane_dist(ctx, p[i], pl, &d));
            ASSERT_CLOSE(d, 0.0, TOL);
        }
        for (int i = 0; i < 4; i++)
            pl[i] *= -3; /* any length */
        if (fabs(ix__dot3(pl, u)) < 0.1)
            continue;
        ASSERT_OK(ctx, ix__line_plane(ctx, a, u, pl, q));
        ASSERT_CLOSE(height(pl, q), 0.0, TOL);
        ix__sub3(q, a, e);
        ix__cross3(e, u, c);
        ASSERT_CLOSE(ix__len3(c), 0.0, 1e-10); /* e up to 1000 */
        ASSERT_OK(ctx, ix__plane_dist(ctx, a, pl, &d));
        ASSERT_CLOSE(d, fabs(height(pl, a)), TOL);
    }
    assert_int_equal(ix__line_plane(ctx, (double[3]){0, 0, 5},
                                    (double[3]){1, 0, 0},
                                    (double[4]){0, 0, 2, 0}, q),
                     IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "at distance 5"));
    assert_int_equal(ix__plane_dist(ctx, a, (double[4]){0, 0, 0, 1}, &d),
                     IX_EARG);
    for (int i = 0; i < 3; i++)
        ix__axpy3(a, i * 0.1, u, p[i]);
    assert_int_equal(ix__plane_through(ctx, (const double(*)[3])p, pl),
                     IX_EDOMAIN);
    assert_int_equal(ix__barycentric(ctx, (const double(*)[3])p, a, q),
                     IX_EDOMAIN);
    ix_ctx_free(ctx);
}

/* Law: each is the foot of the other; also for parallel lines. */
static void test_lines_near(void **state)
{
    ix_rng g = ix_rng_new(23);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double a[3], u[3], b[3], v[3], p[3], q[3], f[3];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        random3(&g, 5, a);
        random3(&g, 2, u);
        random3(&g, 5, b);
        random3(&g, 2, v);
        if (k % 5 == 0)
            for (int i = 0; i < 3; i++)
                v[i] = -2 * u[i];
        ASSERT_OK(ctx, ix__lines_near(ctx, a, u, b, v, p, q));
        ASSERT_OK(ctx, ix__line_foot(ctx, p, b, v, f));
        assert_true(ix__dist3(f, q) < 1e-9);
        ASSERT_OK(ctx, ix__line_foot(ctx, q, a, u, f));
        assert_true(ix__dist3(f, p) < 1e-9); /* up to 1e3 away, 1/sin^2 */
    }
    ix__axpy3(a, 0.5, u, b);
    ASSERT_OK(ctx, ix__lines_near(ctx, b, u, b, v, b, q)); /* may alias */
    ix_ctx_free(ctx);
}

/* Law: the coordinates sum to 1 and weigh the corners to the foot of q. */
static void test_barycentric(void **state)
{
    ix_rng g = ix_rng_new(24);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double p[3][3], q[3], w[3], f[3], pl[4];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        for (int i = 0; i < 3; i++)
            random3(&g, 3, p[i]);
        random3(&g, 3, q);
        ASSERT_OK(ctx, ix__plane_through(ctx, (const double(*)[3])p, pl));
        ASSERT_OK(ctx, ix__barycentric(ctx, (const double(*)[3])p, q, w));
        ASSERT_CLOSE(w[0] + w[1] + w[2], 1.0, TOL);
        for (int j = 0; j < 3; j++)
            f[j] = w[0] * p[0][j] + w[1] * p[1][j] + w[2] * p[2][j];
        ix__axpy3(f, height(pl, q), pl, f);
        assert_true(ix__dist3(f, q) < 1e-10);
    }
    ix_ctx_free(ctx);
}

static void assert_on(const ix__circle3 *c, const double p[3])
{
    double d[3], n[3];

    ix__sub3(p, c->centre, d);
    ix__unit3(c->normal, n);
    ASSERT_CLOSE(ix__len3(d), c->radius, 1e-8);
    ASSERT_CLOSE(ix__dot3(d, n), 0.0, 1e-8);
}

/* A circle with random normal through p (and q if not NULL). */
static ix__circle3 circle_through(ix_rng *g, const double p[3], const double *q)
{
    ix__circle3 c;
    double mid[3], e[3], x[3], y[3] = {0, 0, 0};

    random3(g, 3, x);
    if (q) {
        ix__sub3(q, p, e);
        ix__axpy3(p, 0.5, e, mid);
        ix__cross3(e, x, y); /* centre in the middle plane */
        ix__axpy3(mid, ix_rng_range(g, 0.1, 1), y, c.centre);
        ix__cross3(e, y, c.normal);
    } else {
        ix__axpy3(p, 1, x, c.centre);
        random3(g, 1, y);
        ix__cross3(x, y, c.normal);
    }
    c.radius = ix__dist3(c.centre, p);
    return c;
}

/* Law: what is found is on both circles; circles built through one or two
 * common points give just these. */
static void test_circles_meet(void **state)
{
    ix_rng g = ix_rng_new(25);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double p[3], q[3], out[2][3];
    int n;

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix__circle3 a, b;

        random3(&g, 3, p);
        random3(&g, 3, q);
        a = circle_through(&g, p, k % 2 ? q : NULL);
        b = circle_through(&g, p, k % 2 ? q : NULL);
        ASSERT_OK(ctx, ix__circles_meet(ctx, &a, &b, 1e-8, &n, out));
        assert_int_equal(n, k % 2 ? 2 : 1);
        for (int i = 0; i < n; i++) {
            assert_on(&a, out[i]);
            assert_on(&b, out[i]);
        }
        b.radius += 0.1;
        ASSERT_OK(ctx, ix__circles_meet(ctx, &a, &b, 1e-8, &n, out));
        assert_int_equal(n, 0);
    }
    ix_ctx_free(ctx);
}

/* The coplanar cases: apart, touching outside and inside, crossing, inside,
 * concentric, equal. */
static void test_circles_coplanar(void **state)
{
    static const struct {
        double x, r;
        int n;
    } rows[] = {{3, 1, 0}, {2, 1, 1},   {1, 1, 2},   {0.5, 0.5, 1},
                {1, 2, 1}, {0.2, 3, 0}, {0, 0.5, 0}, {1.9, 1, 2}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix__circle3 a = {{0, 0, 0}, {0, 0, 1}, 1}, b = a;
    double out[2][3];
    int n;

    (void)state;
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        b.centre[0] = rows[k].x;
        b.radius = rows[k].r;
        ASSERT_OK(ctx, ix__circles_meet(ctx, &a, &b, 1e-9, &n, out));
        assert_int_equal(n, rows[k].n);
        for (int i = 0; i < n; i++) {
            assert_on(&a, out[i]);
            assert_on(&b, out[i]);
        }
        assert_true(n < 2 || out[0][1] > 0);
    }
    assert_int_equal(ix__circles_meet(ctx, &a, &a, 1e-9, &n, out), IX_EDOMAIN);
    b.radius = 0;
    assert_int_equal(ix__circles_meet(ctx, &a, &b, 1e-9, &n, out), IX_EARG);
    b = a;
    b.centre[2] = 1; /* parallel planes */
    ASSERT_OK(ctx, ix__circles_meet(ctx, &a, &b, 1e-9, &n, out));
    assert_int_equal(n, 0);
    ix_ctx_free(ctx);
}

/* Law: both end points on their circles, the tangent perpendicular to both
 * radii; outer ones leave both centres on one side, inner ones do not. */
static void test_tangents(void **state)
{
    ix_rng g = ix_rng_new(26);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double t[2][2][3], ca[3], cb[3];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double ra = ix_rng_range(&g, 0.1, 2), rb = ix_rng_range(&g, 0.1, 2);
        bool outer = k % 2;

        random3(&g, 2, ca);
        random3(&g, 2, cb);
        cb[0] += 9;
        ASSERT_OK(ctx, ix__circles_tangents(ctx, ca, ra, cb, rb, outer, t));
        for (int i = 0; i < 2; i++) {
            double *p = t[i][0], *q = t[i][1];
            double dx = q[0] - p[0], dy = q[1] - p[1];
            double sa = dx * (ca[1] - p[1]) - dy * (ca[0] - p[0]);
            double sb = dx * (cb[1] - p[1]) - dy * (cb[0] - p[0]);

            ASSERT_CLOSE(hypot(p[0] - ca[0], p[1] - ca[1]), ra, TOL);
            ASSERT_CLOSE(hypot(q[0] - cb[0], q[1] - cb[1]), rb, TOL);
            ASSERT_CLOSE(dx * (p[0] - ca[0]) + dy * (p[1] - ca[1]), 0.0, TOL);
            ASSERT_CLOSE(dx * (q[0] - cb[0]) + dy * (q[1] - cb[1]), 0.0, TOL);
            assert_true((sa * sb > 0) == outer);
            assert_true(p[2] == ca[2] && q[2] == cb[2]);
            assert_true((sa < 0) == (i == 0)); /* the first on the left */
        }
    }
    cb[0] = ca[0] + 1;
    cb[1] = ca[1];
    assert_int_equal(ix__circles_tangents(ctx, ca, 1, cb, 1, false, t),
                     IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "inner tangents"));
    assert_int_equal(ix__circles_tangents(ctx, ca, 3, cb, 1, true, t),
                     IX_EDOMAIN);
    assert_int_equal(ix__circles_tangents(ctx, ca, -3, cb, 1, true, t),
                     IX_EARG);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_line_foot),
        cmocka_unit_test(test_planes),
        cmocka_unit_test(test_lines_near),
        cmocka_unit_test(test_barycentric),
        cmocka_unit_test(test_circles_meet),
        cmocka_unit_test(test_circles_coplanar),
        cmocka_unit_test(test_tangents),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
