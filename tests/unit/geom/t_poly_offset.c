/* Offsets of polygons: areas by Steiner's formulas, distances of vertices. */
#include "base/ctx.h"
#include "geom/poly_offset.h"
#include "geom/vec3.h"
#include "harness/test.h"

enum { MOST = 24 };

/* A convex polygon in the plane with normal up, counter-clockwise. */
static int convex(ix_rng *g, const double *up, double (*p)[3])
{
    int n = ix_rng_int(g, 3, MOST);
    double x[3], y[3], a = ix_rng_range(g, 0, 6);

    ix__perp3(up, x);
    ix__cross3(up, x, y);
    for (int i = 0; i < n; i++) {
        a += ix_rng_range(g, 0.5, 1.5) * 4 / n; /* 6 at most: below a turn */
        for (int k = 0; k < 3; k++)
            p[i][k] = 3 * cos(a) * x[k] + 2 * sin(a) * y[k] + up[k];
    }
    return n;
}

static double area(int n, const double (*p)[3], const double *up)
{
    double s = 0;

    for (int i = 1; i + 1 < n; i++) {
        double a[3], b[3], c[3];

        ix__sub3(p[i], p[0], a);
        ix__sub3(p[i + 1], p[0], b);
        ix__cross3(a, b, c);
        s += ix__dot3(c, up) / 2;
    }
    return s;
}

static double perimeter(int n, const double (*p)[3])
{
    double s = 0;

    for (int i = 0; i < n; i++)
        s += ix__dist3(p[i], p[(i + 1) % n]);
    return s;
}

/* The sum of f(turn) over the corners. */
static double corners(int n, const double (*p)[3], double (*f)(double))
{
    double s = 0;

    for (int i = 0; i < n; i++) {
        double a[3], b[3];

        ix__sub3(p[(i + 1) % n], p[i], a);
        ix__sub3(p[(i + 2) % n], p[(i + 1) % n], b);
        ix__unit3(a, a);
        ix__unit3(b, b);
        s += f(acos(fmin(1, ix__dot3(a, b))));
    }
    return s;
}

static double mitre(double t)
{
    return t < 2.6362 ? tan(t / 2) : sin(t) / 2; /* 4 distances: acos(-7/8) */
}

static double bevel(double t)
{
    return sin(t) / 2;
}

static double inside(double t)
{
    return tan(t / 2);
}

/* The sectors of a round corner, cut into triangles. */
static double rounded(double t)
{
    int k = (int)ceil(t / (acos(-1) / 18) - 1e-9);

    return k * sin(t / k) / 2;
}

/* Law (Steiner): with perimeter P the area grows by P d plus, at each corner,
 * d^2 times that of the join for d = 1; 1e-13: sums of some dozen terms. */
static void areas(void **state)
{
    static double (*const join[3])(double) = {bevel, mitre, rounded};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(31);

    (void)state;
    for (int round = 0; round < 90; round++) {
        double up[3] = {0, 0, 1}, p[MOST][3], (*out)[3], d, want;
        int n, m, kind = round % 3;
        ix_mark mk = ix__scratch_mark(ctx);

        for (int k = 0; round % 2 && k < 3; k++)
            up[k] = ix_rng_range(&g, -1, 1);
        ix__unit3(up, up);
        n = convex(&g, up, p);
        d = ix_rng_range(&g, 0.01, 2);
        ASSERT_OK(ctx, ix__polyline_offset(ctx, n, (const double(*)[3])p, true,
                                           up, d, (ix__join)kind, &m, &out));
        want = area(n, (const double(*)[3])p, up) +
               perimeter(n, (const double(*)[3])p) * d +
               d * d * corners(n, (const double(*)[3])p, join[kind]);
        ASSERT_CLOSE(area(m, (const double(*)[3])out, up), want, 1e-13);
        /* inwards the edges meet, whatever the join */
        d = -1e-3;
        ASSERT_OK(ctx, ix__polyline_offset(ctx, n, (const double(*)[3])p, true,
                                           up, d, (ix__join)kind, &m, &out));
        assert_int_equal(m, n);
        want = area(n, (const double(*)[3])p, up) +
               perimeter(n, (const double(*)[3])p) * d +
               d * d * corners(n, (const double(*)[3])p, inside);
        ASSERT_CLOSE(area(m, (const double(*)[3])out, up), want, 1e-13);
        ix__scratch_release(ctx, mk);
    }
    ix_ctx_free(ctx);
}

/* A zigzag, with repeated vertices: ends and edges at the distance, to the
 * right; a hairpin gets no endless mitre. */
static void open_lines(void **state)
{
    const double up[3] = {0, 0, 1};
    const double p[6][3] = {{0, 0, 1}, {2, 0, 1},    {2, 0, 1},
                            {2, 2, 1}, {2.01, 0, 1}, {2.01, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mark mk = ix__scratch_mark(ctx);
    double(*out)[3];
    int m;

    (void)state;
    ASSERT_OK(ctx, ix__polyline_offset(ctx, 6, p, false, up, 0.5,
                                       IX__JOIN_MITRE, &m, &out));
    assert_int_equal(m, 5); /* the hairpin, seen from inside, has two */
    ASSERT_CLOSE(out[0][0], 0, 0);
    ASSERT_CLOSE(out[0][1], -0.5, 0);
    ASSERT_CLOSE(out[0][2], 1, 0);
    ASSERT_CLOSE(out[1][0], 2.5, 1e-15);
    ASSERT_CLOSE(out[1][1], -0.5, 1e-15);
    ASSERT_CLOSE(out[2][0], 2.5, 1e-15);
    ASSERT_CLOSE(out[2][1], 2, 1e-15);
    ASSERT_CLOSE(ix__dist3(out[3], p[3]), 0.5, 1e-15);
    ASSERT_OK(ctx, ix__polyline_offset(ctx, 2, p, false, up, -0.5,
                                       IX__JOIN_BEVEL, &m, &out));
    ASSERT_CLOSE(out[1][1], 0.5, 0);
    assert_int_equal(ix__polyline_offset(ctx, 2, p + 1, false, up, 1,
                                         IX__JOIN_BEVEL, &m, &out),
                     IX_EDOMAIN);
    ix__scratch_release(ctx, mk);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas),
        cmocka_unit_test(open_lines),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
