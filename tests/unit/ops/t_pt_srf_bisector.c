/* The bisector of a point and a surface: equal distances along the normal,
 * degrees, quadrics, degenerate input. */
#include <limits.h>
#include <string.h>

#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/geom_srf.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8301)

/* Deviation of B(t) from the definition by the projected partials (quotient
 * rule on ix_mv_partial), times the sine at which the tangent plane and the
 * line to Q meet, which is the condition of the problem. */
static double deviation(const ix_mv *s, const ix_mv *b, const double *q,
                        const double *t)
{
    static const int ks[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    double h[3][4] = {{0}}, x[3][3], n[3], p[3], f[3], y[3], sine, dist;

    for (int i = 0; i < 3; i++) {
        double v[4];

        ASSERT_OK(ctx, ix_mv_partial(ctx, s, t, ks[i], v));
        h[i][0] = ix_mv_rational(s) ? v[0] : i == 0;
        memcpy(h[i] + 1, v + ix_mv_rational(s), 3 * sizeof *v);
    }
    for (int k = 0; k < 3; k++) {
        x[0][k] = h[0][k + 1] / h[0][0];
        x[1][k] = (h[1][k + 1] - x[0][k] * h[1][0]) / h[0][0];
        x[2][k] = (h[2][k + 1] - x[0][k] * h[2][0]) / h[0][0];
    }
    if (ix_mv_point(ctx, b, t, p) != IX_OK)
        return 0.0;
    ix__cross3(x[1], x[2], n);
    ix__sub3(p, x[0], f);
    ix__sub3(x[0], q, y);
    sine = fabs(ix__dot3(y, n)) / (ix__len3(y) * ix__len3(n));
    dist = ix__dist3(p, q);
    return sine *
           fmax(fabs(dist - ix__len3(f)) / fmax(1, dist),
                fmax(fabs(ix__dot3(f, x[1])) / (fmax(1, dist) * ix__len3(x[1])),
                     fabs(ix__dot3(f, x[2])) /
                         (fmax(1, dist) * ix__len3(x[2]))));
}

static void definition_holds(void **state)
{
    (void)state;
    for (int i = 0; i < 60; i++) {
        ix_rand_opts ro = {.ndirs = 2,
                           .ncoords = 3,
                           .rational = i & 1 ? 1 : -1,
                           .kinds = i & 2 ? IX_RAND_BEZIER : IX_RAND_OPEN,
                           .min_order = 2,
                           .max_order = 4,
                           .max_knots = 2};
        ix_mv *s = ix_mv_randtest(ctx, &rng, &ro), *b;
        double q[3] = {ix_rng_range(&rng, -2, 2), ix_rng_range(&rng, -2, 2), 3};

        for (int form = 0; form < 4; form += 3) {
            ix_op_opts o = {(ix_degree_form)form, INT_MAX};
            ix_report rep;

            ASSERT_OK(ctx, ix_pt_srf_bisector(ctx, s, q, &o, &rep, &b));
            assert_true(rep.residual <= 1e-7);
            for (int j = 0; j < 2; j++) {
                int d = ix_mv_order(s, j) - 1;

                assert_int_equal(ix_mv_order(b, j) - 1,
                                 i & 1 ? (form ? 8 * d : 5 * d - 2)
                                       : 4 * d - 1);
            }
            for (int j = 0; j < 10; j++) {
                double t[2], dev;

                ix_mv_randparam(&rng, s, t);
                dev = deviation(s, b, q, t);
                if (!(dev <= 1e-11))
                    fail_msg("surface %d: deviation %g", i, dev);
            }
            ix_mv_unref(ctx, b);
        }
        ix_mv_unref(ctx, s);
    }
}

/* Partials of a cubic Bezier form relative to c0: c0 and weights are such that
 * the differences are exact. */
static void local_jet(const double *p, bool rational, const double c0[3],
                      const double t[2], double x[3][3])
{
    double b[2][2][4], h[3][4] = {{0}};

    for (int d = 0; d < 2; d++) {
        double u = t[d], v = 1 - u;
        const double val[4] = {v * v * v, 3 * v * v * u, 3 * v * u * u,
                               u * u * u},
                     der[4] = {-3 * v * v, 3 * v * v - 6 * v * u,
                               6 * v * u - 3 * u * u, 3 * u * u};

        memcpy(b[d][0], val, sizeof val);
        memcpy(b[d][1], der, sizeof der);
    }
    for (int i = 0; i < 16; i++)
        for (int r = 0; r < 3; r++) {
            double f = b[0][r == 1][i % 4] * b[1][r == 2][i / 4];
            double w = rational ? p[i] : 1;

            h[r][0] += f * w;
            for (int k = 0; k < 3; k++)
                h[r][k + 1] += f * (p[(k + rational) * 16 + i] - w * c0[k]);
        }
    for (int k = 0; k < 3; k++) {
        x[0][k] = h[0][k + 1] / h[0][0];
        for (int r = 1; r < 3; r++)
            x[r][k] = (h[r][k + 1] - x[0][k] * h[r][0]) / h[0][0];
    }
}

/* Law: a surface of size 1 or 1e-6, at the origin or 2^20 away, and a point
 * next to it, at the distance 1, or at the origin: B as computed around the
 * surface, to 64 roundings of the largest of B, the surface's place and its
 * size (rational: 256, of which the products of weights and coordinates are
 * most). */
static void far_from_the_point(void **state)
{
    const ix_dir d[2] = {{IX_BEZIER, 4, 4, false, NULL},
                         {IX_BEZIER, 4, 4, false, NULL}};

    (void)state;
    for (int i = 0; i < 48; i++) {
        bool rational = i & 1;
        double size = i & 2 ? 1e-6 : 1, far = i & 4 ? 1 << 20 : 0;
        double c0[3] = {far, -far, far / 2}, p[64], q[3], worst = 0;
        ix_mv *s, *b;

        for (int j = 0; j < 16; j++) {
            const double at[3] = {j % 4 / 3.0, j / 4 / 3.0, 0};
            double w = rational ? 1 + 0.25 * (j % 3) : 1;

            p[j] = w;
            for (int k = 0; k < 3; k++)
                p[(k + rational) * 16 + j] =
                    w *
                    (c0[k] + size * (at[k] + 0.15 * ix_rng_range(&rng, -1, 1)));
        }
        for (int k = 0; k < 3; k++)
            q[k] = i / 8 % 3 == 0   ? c0[k] + size * (k == 2 ? 1.5 : 0.3)
                   : i / 8 % 3 == 1 ? c0[k] + (k == 2 ? 1 : 0.5)
                                    : 3.0 * (k == 2);
        ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, rational, p, &s));
        ASSERT_OK(ctx, ix_pt_srf_bisector(ctx, s, q, NULL, NULL, &b));
        for (int j = 0; j < 9; j++) {
            double t[2] = {(j % 3 + 0.5) / 3, (j / 3 + 0.5) / 3}, x[3][3], n[3];
            double r[3], y[3], lambda, far_off = size + fabs(c0[0]), off = 0;

            local_jet(p, rational, c0, t, x);
            ix__cross3(x[1], x[2], n);
            for (int k = 0; k < 3; k++)
                r[k] = (q[k] - c0[k]) - x[0][k];
            lambda = ix__dot3(r, r) / (2 * ix__dot3(r, n));
            ASSERT_OK(ctx, ix_mv_point(ctx, b, t, y));
            for (int k = 0; k < 3; k++) {
                double want = x[0][k] + lambda * n[k];

                far_off = fmax(far_off, fabs(want));
                off = fmax(off, fabs(y[k] - c0[k] - want));
            }
            worst = fmax(worst, off / far_off);
        }
        if (!(worst <= (rational ? 256 : 64) * 2.3e-16))
            fail_msg("case %d: off by %g", i, worst);
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, b);
    }
}

static ix_mv *plane(const double *pts)
{
    ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                   {IX_BEZIER, 2, 2, false, NULL}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, pts, &m));
    return m;
}

/* A plane and a point: the paraboloid z = (1 + x^2 + y^2) / 2. A sphere: the
 * quadric | |B - C| - |B - Q| | = r or |B - C| + |B - Q| = r. */
static void quadrics(void **state)
{
    const double flat[12] = {-2, 2, -2, 2, -2, -2, 2, 2, 0, 0, 0, 0};
    const double top[3] = {0, 0, 1}, out[3] = {3, 1, 0}, in[3] = {0.2, 0.1, 0};
    const double coef[10] = {1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
    ix_mv *s = plane(flat), *b;

    (void)state;
    ASSERT_OK(ctx, ix_pt_srf_bisector(ctx, s, top, NULL, NULL, &b));
    for (int i = 0; i < 9; i++) {
        double t[2] = {i % 3 / 2.0, i / 3 / 2.0}, x[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, b, t, x));
        ASSERT_CLOSE(x[2], (1 + x[0] * x[0] + x[1] * x[1]) / 2, 1e-14);
    }
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s);
    ASSERT_OK(ctx, ix_srf_quadric(ctx, coef, &s));
    for (int k = 0; k < 2; k++) {
        const double *q = k ? in : out, zero[3] = {0, 0, 0};

        ASSERT_OK(ctx, ix_pt_srf_bisector(ctx, s, q, NULL, NULL, &b));
        for (int i = 0; i < 25; i++) {
            double t[2], dom[2], x[3], e;

            for (int j = 0; j < 2; j++) {
                ix_mv_domain(s, j, dom);
                t[j] = dom[0] +
                       (dom[1] - dom[0]) * ((j ? i / 5 : i % 5) + 0.45) / 5;
            }
            if (ix_mv_point(ctx, b, t, x) != IX_OK)
                continue;
            e = k ? ix__dist3(x, zero) + ix__dist3(x, q)
                  : fabs(ix__dist3(x, zero) - ix__dist3(x, q));
            if (!(fabs(e - 1) <= 1e-9 * (1 + ix__len3(x))))
                fail_msg("%d: %g at (%g, %g)", k, e, t[0], t[1]);
        }
        ix_mv_unref(ctx, b);
    }
    ix_mv_unref(ctx, s);
}

static void expect(const ix_mv *s, const double *q, ix_status st,
                   const char *text)
{
    ix_mv *b = NULL;

    assert_int_equal(ix_pt_srf_bisector(ctx, s, q, NULL, NULL, &b), st);
    assert_null(b);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

static void refused(void **state)
{
    const double flat[12] = {0.1, 1, 0.1, 1,   0.3, 0.3,
                             2,   2, 0.2, 0.2, 0.9, 0.9};
    const double on[3] = {-1, 0.3, 0.2}, bad[3] = {0, NAN, 0}, dot[12] = {0};
    ix_mv *s = plane(flat), *c;
    ix_dir d = {IX_BEZIER, 4, 4, false, NULL};

    (void)state;
    expect(s, on, IX_EDOMAIN, "tangent planes pass through the point");
    expect(s, bad, IX_EARG, "coordinate 2 of the point is nan");
    ix_mv_unref(ctx, s);
    s = plane(dot);
    assert_int_equal(ix_pt_srf_bisector(ctx, s, on, NULL, NULL, &c),
                     IX_EDOMAIN);
    ix_mv_unref(ctx, s);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, false, flat, &c));
    expect(c, on, IX_EARG, "surface");
    ix_mv_unref(ctx, c);
}

static void make(ix_ctx *own, ix_build_case *f)
{
    ix_rng r = ix_rng_new(36);
    ix_rand_opts ro = {.ndirs = 2,
                       .ncoords = 3,
                       .rational = 1,
                       .kinds = IX_RAND_BEZIER,
                       .min_order = 2,
                       .max_order = 3};

    f->in[0] = ix_mv_randtest(own, &r, &ro);
}

static ix_status build(ix_ctx *own, const ix_build_case *f, ix_mv **out)
{
    const double q[3] = {0.5, 2, 1};
    ix_report rep;

    return ix_pt_srf_bisector(own, f->in[0], q, NULL, &rep, out);
}

static void memory_may_fail(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition_holds),
        cmocka_unit_test(far_from_the_point),
        cmocka_unit_test(quadrics),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
