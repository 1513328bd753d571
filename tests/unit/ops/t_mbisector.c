/* Bisectors by equations: fields vanish at pairs of feet of one sphere, points
 * are equally far along normals, rational ones in R^4 and R^5, trisectors,
 * points of skeletons against Apollonius and closed forms. */
#include <limits.h>
#include <string.h>

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/ops_mbisect.h"

IX_TEST_FIXTURE(8601)

static ix_mv *rand_mv(int ndirs, int ncoords, bool rational, int order,
                      double shift)
{
    ix_dir d[2] = {{IX_BEZIER, order, order, false, NULL},
                   {IX_BEZIER, order, order, false, NULL}};
    double pts[8 * 16];
    int n = ndirs == 2 ? order * order : order, r = rational;
    ix_mv *m;

    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(&rng, 0.6, 1.5) : 1;

        pts[i] = w;
        for (int k = 0; k < ncoords; k++)
            pts[(k + r) * n + i] =
                w * (ix_rng_range(&rng, -0.3, 0.3) + (k == 2 ? shift : 0) +
                     (k == 0 ? (double)(i % order) / (order - 1) : 0) +
                     (k == 1 ? (double)(i / order) / (order - 1) : 0));
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, d, ncoords, rational, pts, &m));
    return m;
}

/* Point and tangents at t, by differences of the quotient rule's terms. */
static void jet(const ix_mv *m, const double *t, double x[3], double d[2][3])
{
    double h[3][4] = {{0}}, v[4];
    int r = ix_mv_rational(m);

    for (int j = 0; j <= ix_mv_ndirs(m); j++) {
        int order[2] = {j == 1, j == 2};

        ASSERT_OK(ctx, ix_mv_partial(ctx, m, t, order, v));
        h[j][0] = r ? v[0] : j == 0;
        for (int k = 0; k < ix_mv_ncoords(m); k++)
            h[j][k + 1] = v[k + r];
    }
    for (int k = 0; k < 3; k++) {
        x[k] = h[0][k + 1] / h[0][0];
        for (int j = 0; j < ix_mv_ndirs(m); j++)
            d[j][k] = (h[j + 1][k + 1] - x[k] * h[j + 1][0]) / h[0][0];
    }
}

static double off_normal(const ix_mv *m, const double *t, const double p[3],
                         double *dist)
{
    double x[3], d[2][3], v[3], u[3], worst = 0;

    jet(m, t, x, d);
    ix__sub3(p, x, v);
    *dist = ix__len3(v);
    for (int j = 0; j < ix_mv_ndirs(m); j++) {
        (void)ix__unit3(d[j], u);
        worst = fmax(worst, fabs(ix__dot3(u, v)));
    }
    return worst;
}

/* Law: a bisector point has equal distances along normals, 1e-9 of them; the
 * degrees are those of the header. */
static void points_are_equidistant(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        bool ra = i & 1, rb = i & 2, curve = i % 3 > 0;
        ix_mv *s = rand_mv(2, 3, ra, 2 + i % 2, 0), *f[2];
        ix_mv *o = rand_mv(curve ? 1 : 2, 3, rb, curve ? 3 : 2, 1.5);
        ix_bisector_point *p;
        int n, nf, q = ix_mv_order(s, 0) - 1, e = ix_mv_order(o, 0) - 1;

        ASSERT_OK(ctx, ix_mbisector_fields(ctx, s, o, f, &nf));
        assert_int_equal(nf, curve ? 1 : 2);
        if (curve) {
            assert_int_equal(ix_mv_order(f[0], 0) - 1,
                             rb ? 4 * e - 2 : 3 * e - 1);
            assert_int_equal(ix_mv_order(f[0], 1) - 1,
                             ra ? 6 * q - 2 : 4 * q - 1);
        } else {
            assert_int_equal(ix_mv_order(f[0], 1) - 1,
                             ra ? 6 * q - 2 : 4 * q - 1);
            assert_int_equal(ix_mv_order(f[0], 2) - 1,
                             rb ? 4 * e - 2 : 3 * e - 1);
            assert_int_equal(ix_mv_order(f[0], 3) - 1, rb ? 4 * e : 3 * e);
        }
        for (int k = 0; k < nf; k++)
            ix_mv_unref(ctx, f[k]);
        ASSERT_OK(ctx, ix_mbisector_points(ctx, o, s, 3, &p, &n));
        for (int k = 0; k < n; k++) {
            const ix_mv *first = curve ? s : o, *other = curve ? o : s;
            double a, b, off = off_normal(first, p[k].uv, p[k].x, &a);

            off = fmax(off, off_normal(other, p[k].on, p[k].x, &b));
            if (!(fmax(off, fabs(a - b)) <= 1e-8 * (a + b)))
                fail_msg("case %d: off %g, %g - %g", i, off, a, b);
        }
        if (curve)
            assert_true(n > 0);
        ix_bisector_points_free(ctx, p, n);
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, o);
    }
}

/* A plane and a line at a right angle to it: the cone |z| = rho around the foot
 * of the line, at each (u, v) once above and below the plane. */
static void plane_and_line(void **state)
{
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    const double plane[12] = {-1, 1, -1, 1, -1, -1, 1, 1, 0, 0, 0, 0};
    const double line[6] = {0.5, 0.5, 0.25, 0.25, -3, 3};
    ix_bisector_point *p;
    ix_mv *s, *c;
    int n;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, plane, &s));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 3, false, line, &c));
    ASSERT_OK(ctx, ix_mbisector_points(ctx, s, c, 5, &p, &n));
    assert_int_equal(n, 2 * 36);
    for (int i = 0; i < n; i++)
        ASSERT_CLOSE(fabs(p[i].x[2]), hypot(p[i].x[0] - 0.5, p[i].x[1] - 0.25),
                     1e-12);
    ix_bisector_points_free(ctx, p, n);
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, c);
}

/* Law: in R^n the rational bisector is equally far from both, at right angles
 * to all partials (differences of 1e-6: 1e-5). */
static void rational_in_higher_space(void **state)
{
    (void)state;
    for (int i = 0; i < 9; i++) {
        int da = 1 + i / 3 % 2 + (i > 5), db = 1 + (i > 2);
        int na = da > 2 ? 2 : da, dim = na + db + 1;
        ix_mv *a = rand_mv(na, dim, i % 2, 3, 0), *s;
        ix_mv *b = rand_mv(db, dim, i % 3 == 1, 2, 1.5);

        ASSERT_OK(ctx, ix_mbisector_exact(ctx, a, b, &s));
        assert_int_equal(ix_mv_ndirs(s), na + db);
        for (int j = 0; j < 6; j++) {
            double t[4], p[6], x[6], y[6], ra = 0, rb = 0;

            for (int k = 0; k < na + db; k++)
                t[k] = ix_rng_unit(&rng) * 0.9;
            ASSERT_OK(ctx, ix_mv_point(ctx, s, t, p));
            for (int k = -1; k < na + db; k++) {
                double at[4], da2 = 0, db2 = 0;

                memcpy(at, t, sizeof at);
                if (k >= 0)
                    at[k] += 1e-6;
                ASSERT_OK(ctx, ix_mv_point(ctx, a, at, x));
                ASSERT_OK(ctx, ix_mv_point(ctx, b, at + na, y));
                for (int c = 0; c < dim; c++) {
                    da2 += (p[c] - x[c]) * (p[c] - x[c]);
                    db2 += (p[c] - y[c]) * (p[c] - y[c]);
                }
                if (k < 0) {
                    ra = da2;
                    rb = db2;
                    if (!(fabs(ra - rb) <= 1e-8 * (ra + rb)))
                        fail_msg("case %d: %g and %g", i, sqrt(ra), sqrt(rb));
                } else if (!(fabs((k < na ? da2 - ra : db2 - rb)) <=
                             1e-6 * 1e-3 * (1 + ra))) {
                    fail_msg("case %d: slope %g", i, (da2 - ra) / 1e-6);
                }
            }
        }
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, s);
    }
}

/* --- trisectors
 * --------------------------------------------------------------- */

/* The unit cube's three skew edges' lines: the diagonal x = y = z is in their
 * trisector, and every vertex has equal distances from the three lines. */
static void three_lines(void **state)
{
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    const double at[3][6] = {
        {-2, 3, 0, 0, 1, 1}, {1, 1, -2, 3, 0, 0}, {0, 0, 1, 1, -2, 3}};
    const double box[6] = {-1, -1, -1, 2, 2, 2};
    bool complete, diagonal = false;
    size_t v = 0;
    ix_mv *m[3];
    ix_lines l;

    (void)state;
    for (int i = 0; i < 3; i++)
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, false, at[i], &m[i]));
    ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 1e-4, box, &l,
                                &complete));
    assert_true(l.n > 0);
    for (int i = 0; i < l.n; i++)
        for (int j = 0; j < l.count[i]; j++, v++) {
            const double *p = l.pt[v];
            double a = hypot(p[1], p[2] - 1), b = hypot(p[0] - 1, p[2]);
            double c = hypot(p[0], p[1] - 1);

            assert_true(fabs(a - b) <= 1e-9 * (1 + a));
            assert_true(fabs(a - c) <= 1e-9 * (1 + a));
            diagonal |= fabs(p[0] - p[1]) + fabs(p[1] - p[2]) < 1e-9;
        }
    assert_true(diagonal);
    ix_lines_free(ctx, &l);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

/* Two lines and a plane: equal distances from all. */
static void two_lines_and_a_plane(void **state)
{
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    const double a[6] = {-3, 3, 0, 0, 2, 2}, b[6] = {1, 1, -3, 3, 3, 3};
    const double plane[12] = {-3, 3, -3, 3, -3, -3, 3, 3, 0, 0, 0, 0};
    const double box[6] = {-3, -3, -3, 3, 3, 3};
    bool complete;
    size_t v = 0;
    ix_mv *m[3];
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, plane, &m[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 3, false, a, &m[1]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 3, false, b, &m[2]));
    ASSERT_OK(ctx, ix_trisector(ctx, (const ix_mv *const *)m, 1e-3, box, &l,
                                &complete));
    assert_true(l.n > 0);
    for (int i = 0; i < l.n; i++)
        for (int j = 0; j < l.count[i]; j++, v++) {
            const double *p = l.pt[v];
            double r = hypot(p[1], p[2] - 2);

            assert_true(fabs(r - hypot(p[0] - 1, p[2] - 3)) <= 1e-9 * (1 + r));
            assert_true(fabs(r - fabs(p[2])) <= 1e-9 * (1 + r));
        }
    ix_lines_free(ctx, &l);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

/* --- skeletons
 * ---------------------------------------------------------------- */

/* Law: the circles of Apollonius: eight touch three circles apart from each
 * other, and the feet are on them; two pass through a point, or two points. */
static void apollonius(void **state)
{
    const double c[3][3] = {{-1.1, 0, 0.3}, {1, 0.2, 0.35}, {0, 1.3, 0.4}};
    static const int expected[4] = {8, 4, 2, 1};

    (void)state;
    for (int points = 0; points <= 3; points++) {
        const ix_mv *m[3] = {NULL, NULL, NULL};
        double q[3][2] = {{0}};
        ix_mv *own[3] = {NULL, NULL, NULL};
        ix_skeleton_point *s;
        bool complete;
        int n;

        for (int i = 0; i < 3; i++) {
            const double at[3] = {c[i][0], c[i][1], 0};

            memcpy(q[i], c[i], sizeof q[i]);
            if (i < points)
                continue;
            ASSERT_OK(ctx, ix_circle(ctx, at, c[i][2], &own[i]));
            m[i] = own[i];
        }
        ASSERT_OK(ctx, ix_skeleton_points(ctx, m, (const double(*)[2])q, 100,
                                          1e-7, &s, &n, &complete));
        assert_true(complete);
        assert_int_equal(n, expected[points]);
        for (int k = 0; k < n; k++)
            for (int i = 0; i < 3; i++) {
                double off = hypot(s[k].foot[i][0] - c[i][0],
                                   s[k].foot[i][1] - c[i][1]);

                ASSERT_CLOSE(off, i < points ? 0 : c[i][2], 1e-9);
                ASSERT_CLOSE(hypot(s[k].foot[i][0] - s[k].center[0],
                                   s[k].foot[i][1] - s[k].center[1]),
                             s[k].radius, 1e-8);
            }
        ix_skeleton_points_free(ctx, s, n);
        for (int i = 0; i < 3; i++)
            ix_mv_unref(ctx, own[i]);
    }
}

/* --- errors
 * ------------------------------------------------------------------- */

#define EXPECT(expr, text)                                                  \
    do {                                                                    \
        assert_int_equal((expr), IX_EARG);                                  \
        if (!strstr(ix_ctx_message(ctx), text))                             \
            fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx)); \
    } while (0)

static void refused(void **state)
{
    ix_mv *c = rand_mv(1, 3, false, 3, 0), *s = rand_mv(2, 3, false, 2, 0);
    ix_mv *flat, *out[2];
    const ix_mv *two[3] = {s, s, c}, *none[3] = {c, c, c};
    const double empty[6] = {0, 0, 0, 1, 0, 1};
    const double q[3][2] = {{0}};
    ix_skeleton_point *k;
    ix_bisector_point *p;
    ix_lines l;
    bool complete;
    int n;

    (void)state;
    EXPECT(ix_mbisector_fields(ctx, c, c, out, &n), "a rational bisector");
    EXPECT(ix_mbisector_points(ctx, s, c, 0, &p, &n), "a grid of 0");
    EXPECT(ix_mbisector_exact(ctx, s, c, &out[0]), "in R^4");
    EXPECT(ix_trisector(ctx, none, 0, empty, &l, &complete), "an empty box");
    EXPECT(ix_skeleton_points(ctx, two, q, 1, 1, &k, &n, &complete),
           "a planar curve is needed");
    EXPECT(ix_skeleton_points(ctx, none, q, 0, 1, &k, &n, &complete),
           "must be positive");
    flat = rand_mv(2, 4, false, 2, 0);
    ix_mv_unref(ctx, c);
    c = rand_mv(1, 4, false, 2, 0);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, c, 3, false, &out[0]));
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, out[0], 4, false, &c));
    ix_mv_unref(ctx, out[0]);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, flat, 3, false, &out[0]));
    ix_mv_unref(ctx, flat);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, out[0], 4, false, &flat));
    ix_mv_unref(ctx, out[0]);
    assert_int_equal(ix_mbisector_exact(ctx, c, flat, &out[0]), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "in one hyperplane"));
    ix_mv_unref(ctx, flat);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s);
}

/* --- memory
 * ------------------------------------------------------------------- */

typedef struct {
    int which, n;
    ix_mv *m[3], *f[2];
    ix_bisector_point *p;
    ix_skeleton_point *k;
    ix_lines l;
} operands;

static void make(ix_ctx *own, void *state)
{
    static const double pts[3][12] = {{-1, 1, -1, 1, -1, -1, 1, 1, 0, 0, 0, 0},
                                      {0, 1, 0.1, 0.4, 2, 2.5},
                                      {0, 0.3, -1, 1, 1.5, 1.6}};
    ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                   {IX_BEZIER, 2, 2, false, NULL}};
    operands *o = state;

    *o = (operands){.which = o->which};
    for (int i = 0; i < 3; i++)
        ASSERT_OK(own,
                  ix_mv_new(own, i ? 1 : 2, d, 3, false, pts[i], &o->m[i]));
}

static ix_status call(ix_ctx *own, void *state)
{
    static const double box[6] = {-9, -9, -9, 9, 9, 9}, q[3][2] = {{5, 5}};
    operands *o = state;
    const ix_mv *flat[3] = {NULL, o->m[1], o->m[2]};
    bool complete;

    switch (o->which) {
    case 0:
        return ix_mbisector_fields(own, o->m[0], o->m[0], o->f, &o->n);
    case 1:
        return ix_mbisector_points(own, o->m[0], o->m[1], 1, &o->p, &o->n);
    case 2:
        return ix_mbisector_exact(own, o->m[1], o->m[2], &o->f[0]);
    case 3:
        return ix_trisector(own, (const ix_mv *const *)o->m, 0.1, box, &o->l,
                            &complete);
    default:
        return ix_skeleton_points(own, flat, q, 100, 1, &o->k, &o->n,
                                  &complete);
    }
}

static void release(ix_ctx *own, void *state)
{
    operands *o = state;

    for (int i = 0; i < 3; i++)
        ix_mv_unref(own, o->m[i]);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(own, o->f[i]);
    ix_bisector_points_free(own, o->p, o->n);
    ix_skeleton_points_free(own, o->k, o->n);
    ix_lines_free(own, &o->l);
}

static void memory_may_fail(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++) {
        operands o = {.which = i};
        ix_fault_case c = {make, call, release, &o};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_equidistant),
        cmocka_unit_test(plane_and_line),
        cmocka_unit_test(rational_in_higher_space),
        cmocka_unit_test(three_lines),
        cmocka_unit_test(two_lines_and_a_plane),
        cmocka_unit_test(apollonius),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
