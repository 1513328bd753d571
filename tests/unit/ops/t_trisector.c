/* Trisectors of points, curves and surfaces: every vertex has feet with equal
 * distances on all three (found anew), and closed forms are covered. */
#include <stdlib.h>
#include <string.h>

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/distance.h"
#include "iritx/ops_mbisect.h"

IX_TEST_FIXTURE(8701)

static const double box[6] = {-1, -1, -1, 1, 1, 1};

static ix_mv *point(double x, double y, double z)
{
    const ix_dir d = {IX_BEZIER, 1, 1, false, NULL};
    const double p[3] = {x, y, z};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, false, p, &m));
    return m;
}

/* Quadratic through random points of [-1, 1]^3. */
static ix_mv *curve(double size)
{
    const ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    double p[9];
    ix_mv *m;

    for (int i = 0; i < 9; i++)
        p[i] = size * ix_rng_range(&rng, -1, 1);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, false, p, &m));
    return m;
}

/* o + u a + v b over [-2, 2]^2, bent by a quarter of bend; rational: with other
 * weights. */
static ix_mv *patch(const double o[3], const double a[3], const double b[3],
                    double bend, bool rational)
{
    const ix_dir d[2] = {{IX_BEZIER, 3, 3, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    double p[24], n[3];
    int r = rational;
    ix_mv *m;

    ix__cross3(a, b, n);
    for (int i = 0; i < 6; i++) {
        double u = 2.0 * (i % 3) - 2, v = 4.0 * (i / 3) - 2, h = bend * (i % 3);
        double w = rational ? 1 + 0.2 * (i % 3) : 1;

        p[i] = w;
        for (int k = 0; k < 3; k++)
            p[(k + r) * 6 + i] = w * (o[k] + u * a[k] + v * b[k] + h * n[k]);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, rational, p, &m));
    return m;
}

/* Distances from p to all feet of normals on m. */
static int distances(const ix_mv *m, const double p[3], double *d, int most)
{
    double x[3], u = 0;
    ix_root *t = NULL;
    ix_solutions s = {0};
    int n = 1, found;

    if (ix_mv_ndirs(m) == 2) {
        ASSERT_OK(ctx, ix_srf_feet(ctx, m, p, &s));
        n = s.n;
    } else if (ix_mv_order(m, 0) > 1) {
        ASSERT_OK(ctx, ix_crv_feet(ctx, m, p, NULL, &t, &n));
    }
    found = n;
    n = n < most ? n : most;
    for (int i = 0; i < n; i++) {
        const double *at = s.sol ? s.sol[i].x : t ? &t[i].t : &u;

        ASSERT_OK(ctx, ix_mv_point(ctx, m, at, x));
        d[i] = ix__dist3(x, p);
    }
    ix_solutions_free(ctx, &s);
    if (t)
        ix_roots_free(ctx, t, found);
    return n;
}

/* Smallest difference of three distances, one to each. */
static double off_equal(ix_mv *const m[3], const double p[3])
{
    double d[3][16], best = HUGE_VAL;
    int n[3];

    for (int i = 0; i < 3; i++)
        n[i] = distances(m[i], p, d[i], 16);
    for (int i = 0; i < n[0]; i++)
        for (int j = 0; j < n[1]; j++)
            for (int k = 0; k < n[2]; k++)
                best = fmin(best, fmax(d[0][i], fmax(d[1][j], d[2][k])) -
                                      fmin(d[0][i], fmin(d[1][j], d[2][k])));
    return best;
}

static size_t vertices(const ix_lines *l)
{
    size_t n = 0;

    for (int i = 0; i < l->n; i++)
        n += (size_t)l->count[i];
    return n;
}

static double off_lines(const ix_lines *l, const double p[3])
{
    double best = HUGE_VAL;
    size_t v = 0;

    for (int i = 0; i < l->n; i++)
        for (int j = 0; j < l->count[i]; j++, v++) {
            double e[3], f[3], u;

            if (j == 0)
                continue;
            ix__sub3(l->pt[v], l->pt[v - 1], e);
            ix__sub3(p, l->pt[v - 1], f);
            u = ix__dot3(e, f) / fmax(ix__dot3(e, e), 1e-300);
            ix__axpy3(f, -fmin(fmax(u, 0), 1), e, f);
            best = fmin(best, ix__len3(f));
        }
    return best;
}

static void release_all(ix_mv *m[3], ix_lines *l)
{
    ix_lines_free(ctx, l);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

/* Law: for all kinds of operands, in any order, the feet of each vertex have
 * equal distances (1e-8, of distances up to 4); every kind has curves. Three
 * bent surfaces, which take longest, on demand only. */
static void feet_are_equally_far(void **state)
{
    static const char *const kinds[] = {"ppp", "ppc", "pps", "pcc", "pcs",
                                        "pss", "ccc", "ccs", "css", "sss"};
    static const double x[3] = {0.6, 0, 0}, y[3] = {0, 0.6, 0},
                        z[3] = {0, 0, 0.6},
                        at[3][3] = {{0, 0, -0.8}, {-0.7, 0, 0}, {0, -0.9, 0.1}};
    (void)state;
    for (int i = 0; i < 9 + (getenv("IX_TEST_ROUNDS") != NULL); i++) {
        size_t seen = 0;
        double part = i == 9 ? 0.5 : 1.0, cut[6];

        for (int k = 0; k < 6; k++)
            cut[k] = part * box[k];
        for (int round = i & 1; round < 2; round += 2) {
            ix_mv *m[3];
            bool complete;
            ix_lines l;

            for (int k = 0; k < 3; k++) {
                int to = (k + round) % 3;
                char kind = kinds[i][k];

                m[to] = kind == 'p' ? point(0.7 * k - 0.5, 0.4 * (k == 1), 0.1)
                        : kind == 'c' ? curve(1)
                                      : patch(at[k], k == 1 ? y : x,
                                              k == 0 ? y : z, 0.2, round);
            }
            ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 1e-2, cut,
                                        &l, &complete));
            assert_true(complete);
            for (size_t v = 0; v < vertices(&l); v += 7) {
                double off = off_equal(m, l.pt[v]);

                if (!(off <= 1e-8))
                    fail_msg("%s: off by %g", kinds[i], off);
                for (int k = 0; k < 3; k++)
                    assert_true(fabs(l.pt[v][k]) <= part);
            }
            seen += vertices(&l);
            release_all(m, &l);
        }
        if (seen < 2)
            fail_msg("%s: no curve", kinds[i]);
    }
}

/* 0.3 s: around the point that all three share boxes of all sizes are needed.
 * The coordinate planes: |x| = |y| = |z|, four lines, and nothing else. */
static void three_planes(void **state)
{
    static const double o[3] = {0.03, -0.02, 0.01},
                        e[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    ix_mv *m[3];
    bool complete;
    ix_lines l;

    (void)state;
    for (int k = 0; k < 3; k++)
        m[k] = patch(o, e[(k + 1) % 3], e[(k + 2) % 3], 0, k == 2);
    ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 1e-2, box, &l,
                                &complete));
    assert_int_equal(l.n, 4);
    for (size_t v = 0; v < vertices(&l); v++) {
        double d[3];

        for (int k = 0; k < 3; k++)
            d[k] = fabs(l.pt[v][k] - o[k]);
        assert_true(fabs(d[0] - d[1]) <= 1e-10 && fabs(d[0] - d[2]) <= 1e-10);
    }
    for (int i = 0; i < 8 * 20; i++) {
        double t = 0.001 + 0.04 * (i / 8) + 0.01, p[3];

        for (int k = 0; k < 3; k++)
            p[k] = o[k] + (i >> k & 1 ? t : -t);
        if (!(off_lines(&l, p) <= 1e-9))
            fail_msg("octant %d: %g is missed by %g", i % 8, t,
                     off_lines(&l, p));
    }
    release_all(m, &l);
}

/* A point q and the planes z = 0, x = 0: on z = s x the conic
 * (y - q2)^2 = x^2 - (x - q1)^2 - (s x - q3)^2, all of it within the box (the
 * chords of polylines in steps of 0.12 are within 1e-2). */
static void point_and_two_planes(void **state)
{
    static const double o[3] = {0, 0, 0}, x[3] = {1, 0, 0}, y[3] = {0, 1, 0},
                        z[3] = {0, 0, 1}, q[3] = {0.3, 0.1, 0.4};
    ix_mv *m[3] = {point(q[0], q[1], q[2]), patch(o, x, y, 0, false),
                   patch(o, y, z, 0, false)};
    bool complete;
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 9e-4, box, &l,
                                &complete));
    for (size_t v = 0; v < vertices(&l); v++) {
        const double *p = l.pt[v];

        assert_true(fabs(ix__dist3(p, q) - fabs(p[0])) <= 1e-10);
        assert_true(fabs(ix__dist3(p, q) - fabs(p[2])) <= 1e-10);
    }
    for (int s = -1; s <= 1; s += 2)
        for (double t = -0.99; t < 1; t += 0.02) {
            double h = t * t - (t - q[0]) * (t - q[0]) -
                       (s * t - q[2]) * (s * t - q[2]);

            for (int side = -1; side <= 1 && h >= 0; side += 2) {
                const double p[3] = {t, q[1] + side * sqrt(h), s * t};

                if (fabs(p[1]) < 0.98 && !(off_lines(&l, p) <= 1e-2))
                    fail_msg("(%g, %g, %g) is missed by %g", p[0], p[1], p[2],
                             off_lines(&l, p));
            }
        }
    release_all(m, &l);
}

/* --- closed forms -----------------------------------------------------------
 */

/* A point, a line or a plane through at with the direction (or normal) d. */
typedef struct {
    char kind;
    double at[3], d[3];
} simple;

static simple random_simple(char kind)
{
    simple s = {.kind = kind};

    for (int k = 0; k < 3; k++) {
        s.at[k] = ix_rng_range(&rng, -0.8, 0.8);
        s.d[k] = ix_rng_range(&rng, -1, 1);
    }
    ix__unit3(s.d, s.d);
    return s;
}

/* Large enough for all feet from the box. */
static ix_mv *object_of(const simple *s)
{
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    double p[6], a[3], b[3];
    ix_mv *m;

    if (s->kind == 'p')
        return point(s->at[0], s->at[1], s->at[2]);
    if (s->kind == 'c') {
        for (int i = 0; i < 6; i++)
            p[i] = s->at[i / 2] + (i % 2 ? 4 : -4) * s->d[i / 2];
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, false, p, &m));
        return m;
    }
    ix__perp3(s->d, a);
    ix__cross3(s->d, a, b);
    for (int k = 0; k < 3; k++) {
        a[k] *= 2;
        b[k] *= 2;
    }
    return patch(s->at, a, b, 0, false);
}

/* The squared distance from x and its gradient. */
static double squared(const simple *s, const double x[3], double g[3])
{
    double e[3], h;

    ix__sub3(x, s->at, e);
    h = ix__dot3(e, s->d);
    for (int k = 0; k < 3; k++)
        g[k] = 2 * (s->kind == 'p'   ? e[k]
                    : s->kind == 'c' ? e[k] - h * s->d[k]
                                     : h * s->d[k]);
    return ix__dot3(g, g) / 4;
}

/* The nearest point with three equal distances, by steps of least length. */
static bool equal_near(const simple s[3], double x[3])
{
    for (int it = 0; it < 30; it++) {
        double g[3][3], d[3], a[3], b[3], aa, ab, bb, det, u, v;

        for (int i = 0; i < 3; i++)
            d[i] = squared(&s[i], x, g[i]);
        ix__sub3(g[1], g[0], a);
        ix__sub3(g[2], g[0], b);
        aa = ix__dot3(a, a), ab = ix__dot3(a, b), bb = ix__dot3(b, b);
        det = aa * bb - ab * ab;
        if (!(det > 1e-8))
            return false;
        u = (bb * (d[0] - d[1]) - ab * (d[0] - d[2])) / det;
        v = (aa * (d[0] - d[2]) - ab * (d[0] - d[1])) / det;
        ix__axpy3(x, u, a, x);
        ix__axpy3(x, v, b, x);
        if (fabs(d[0] - d[1]) + fabs(d[0] - d[2]) < 1e-14)
            return fabs(x[0]) < 0.97 && fabs(x[1]) < 0.97 && fabs(x[2]) < 0.97;
    }
    return false;
}

/* Law: points, lines and planes in all mixes, from their distance functions: a
 * point to which Newton's method leads from a node of a grid is on a polyline,
 * to its chords (0.02; steps of 0.1), and each vertex is such a point. */
static void closed_forms_are_covered(void **state)
{
    static const char *const kinds[] = {"ppc", "pps", "pcc", "pcs", "pss",
                                        "ccc", "ccs", "css", "sss"};
    int points = 0;

    (void)state;
    for (int i = 0; i < 8 + (getenv("IX_TEST_ROUNDS") != NULL); i++) {
        simple s[3];
        ix_mv *m[3];
        bool complete;
        ix_lines l;

        for (int k = 0; k < 3; k++) {
            s[k] = random_simple(kinds[i][k]);
            m[k] = object_of(&s[k]);
        }
        ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 1e-2, box, &l,
                                    &complete));
        if (!complete && i < 8)
            fail_msg("%s: stopped", kinds[i]);
        for (size_t v = 0; v < vertices(&l); v++) {
            double g[3], d = squared(&s[0], l.pt[v], g);

            assert_true(fabs(squared(&s[1], l.pt[v], g) - d) <= 1e-10);
            assert_true(fabs(squared(&s[2], l.pt[v], g) - d) <= 1e-10);
        }
        for (int n = 0; n < 512; n++) {
            double x[3] = {0.28 * (n % 8) - 0.98, 0.28 * (n / 8 % 8) - 0.98,
                           0.28 * (n / 64) - 0.98};

            if (!equal_near(s, x))
                continue;
            points++;
            if (!(off_lines(&l, x) <= 0.02))
                fail_msg("%s: (%g, %g, %g) is missed by %g", kinds[i], x[0],
                         x[1], x[2], off_lines(&l, x));
        }
        release_all(m, &l);
    }
    assert_true(points > 200);
}

/* A spherical octant: a patch with a pole, turned by the signs of s. */
static ix_mv *octant(const double c[3], double r, const double s[3])
{
    static const double w1[3] = {1, 0.70710678118654752440, 1};
    static const double q[3][2] = {{1, 0}, {1, 1}, {0, 1}};
    const ix_dir d[2] = {{IX_BEZIER, 3, 3, false, NULL},
                         {IX_BEZIER, 3, 3, false, NULL}};
    double p[36];
    ix_mv *m;

    for (int i = 0; i < 9; i++) {
        int u = i % 3, v = i / 3;
        double w = w1[u] * w1[v],
               x[3] = {q[u][0] * q[v][0], q[u][1] * q[v][0], q[v][1]};

        p[i] = w;
        for (int k = 0; k < 3; k++)
            p[9 * (k + 1) + i] = w * (c[k] + r * s[k] * x[k]);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, true, p, &m));
    return m;
}

/* Octants of spheres of one radius around three points, with the pole on top:
 * their centres' axis is equally far, as far as the feet are on the octants. */
static void spherical_octants(void **state)
{
    static const double at[3][3] = {{1.5, 0.1, 0}, {0, 1.4, 0}, {-1.3, -1, 0}},
                        part[6] = {-0.2, -0.2, 0.2, 0.3, 0.3, 0.9};
    double c[2], a[2][2], h[2], det;
    ix_mv *m[3];
    bool complete;
    ix_lines l;

    (void)state;
    for (int i = 0; i < 2; i++) {
        h[i] = 0;
        for (int k = 0; k < 2; k++) {
            a[i][k] = at[i + 1][k] - at[0][k];
            h[i] += (at[i + 1][k] * at[i + 1][k] - at[0][k] * at[0][k]) / 2;
        }
    }
    det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    c[0] = (h[0] * a[1][1] - h[1] * a[0][1]) / det;
    c[1] = (h[1] * a[0][0] - h[0] * a[1][0]) / det;
    for (int i = 0; i < 3; i++) {
        const double s[3] = {copysign(1, c[0] - at[i][0]),
                             copysign(1, c[1] - at[i][1]), 1};

        m[i] = octant(at[i], 0.5, s);
    }
    ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 1e-2, part, &l,
                                &complete));
    assert_true(complete);
    assert_int_equal(l.n, 1);
    for (size_t v = 0; v < vertices(&l); v++) {
        ASSERT_CLOSE(l.pt[v][0], c[0], 1e-10);
        ASSERT_CLOSE(l.pt[v][1], c[1], 1e-10);
    }
    release_all(m, &l);
}

/* The axis of the circle through three points, across the box; none if they are
 * on one line. */
static void three_points(void **state)
{
    ix_mv *m[3] = {point(0.5, 0, 0.2), point(0, 0.5, 0.2), point(-0.5, 0, 0.2)};
    bool complete;
    ix_lines l;

    (void)state;
    ASSERT_OK(
        ctx, ix_trisector(ctx, (const ix_mv *const *)m, 0, box, &l, &complete));
    assert_true(l.n == 1 && l.count[0] == 2);
    for (int i = 0; i < 2; i++) {
        ASSERT_CLOSE(l.pt[i][0], 0, 1e-15);
        ASSERT_CLOSE(l.pt[i][1], 0, 1e-15);
        ASSERT_CLOSE(fabs(l.pt[i][2]), 1, 1e-15);
    }
    ix_lines_free(ctx, &l);
    ix_mv_unref(ctx, m[1]);
    m[1] = point(0, 0, 0.2);
    ASSERT_OK(
        ctx, ix_trisector(ctx, (const ix_mv *const *)m, 0, box, &l, &complete));
    assert_int_equal(l.n, 0);
    release_all(m, &l);
}

static void expect(const ix_mv *const m[3], double tol, ix_status st,
                   const char *text)
{
    bool complete;
    ix_lines l;

    assert_int_equal(ix_trisector(ctx, m, tol, box, &l, &complete), st);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

static void refused(void **state)
{
    ix_mv *p = point(0, 0, 0), *c = curve(1), *t, *flat, *thin;
    const ix_mv *m[3] = {p, p, c}, *points[3] = {p, p, p};

    (void)state;
    expect(points, 0, IX_EDOMAIN, "two of the points are one");
    expect(m, (double)NAN, IX_EARG, "a tolerance of nan");
    ASSERT_OK(ctx, ix_mv_promote(ctx, c, 3, 0, &t));
    m[1] = t;
    expect(m, 0, IX_EARG, "operand 2 has 3 directions");
    ASSERT_OK(ctx, ix_mv_coerce(ctx, c, 1, false, &flat));
    m[1] = flat;
    expect(m, 0, IX_EARG, "operand 2 has 1 directions and 1 coordinates");
    ASSERT_OK(ctx, ix_mv_promote(ctx, c, 2, 0, &thin));
    m[1] = thin;
    expect(m, 0, IX_EDOMAIN, "operand 2 does not change in direction 2");
    ix_mv_unref(ctx, p);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, t);
    ix_mv_unref(ctx, flat);
    ix_mv_unref(ctx, thin);
}

typedef struct {
    int which;
    ix_mv *m[3];
    ix_lines l;
} operands;

static void make(ix_ctx *own, void *state)
{
    static const double pts[3][12] = {{-1, 1, -1, 1, -1, -1, 1, 1, 0, 0, 0, 0},
                                      {0, 0, 0, 0, -1, 1, -1, 1, -1, -1, 1, 1},
                                      {0.2, 0.3, 0.4}};
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}},
                 one = {IX_BEZIER, 1, 1, false, NULL};
    operands *o = state;

    for (int i = 0; i < 3; i++)
        ASSERT_OK(own,
                  i < 3 - o->which
                      ? ix_mv_new(own, 2, d, 3, false, pts[i % 2], &o->m[i])
                      : ix_mv_new(own, 1, &one, 3, false, pts[2], &o->m[i]));
    o->l = (ix_lines){.n = 0};
}

static ix_status call(ix_ctx *own, void *state)
{
    static const double small[6] = {0.1, 0.1, 0.1, 0.4, 0.4, 0.4};
    operands *o = state;
    bool complete;

    return ix_trisector(own, (const ix_mv *const *)o->m, 0.2, small, &o->l,
                        &complete);
}

static void release(ix_ctx *own, void *state)
{
    operands *o = state;

    for (int i = 0; i < 3; i++)
        ix_mv_unref(own, o->m[i]);
    ix_lines_free(own, &o->l);
}

/* A point with two planes. */
static void memory_may_fail(void **state)
{
    operands o = {.which = 1};
    ix_fault_case c = {make, call, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(feet_are_equally_far),
        cmocka_unit_test(three_planes),
        cmocka_unit_test(point_and_two_planes),
        cmocka_unit_test(closed_forms_are_covered),
        cmocka_unit_test(spherical_octants),
        cmocka_unit_test(three_points),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
