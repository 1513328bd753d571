/* The functions whose zeros are pairs of feet: against their definition by
 * values of derivatives, and the curves of their zeros. */
#include <string.h>

#include "crv_test.h"
#include "harness/fault.h"
#include "iritx/ops_plane.h"

static double cross(const double *a, const double *b)
{
    return a[0] * b[1] - a[1] * b[0];
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1];
}

/* The definition at points c and derivatives t; func 4: X, Y, D, z in out. */
static void define(int func, double c[2][2], double t[2][2], double out[4])
{
    double d[2] = {c[1][0] - c[0][0], c[1][1] - c[0][1]};
    double p[2] = {dot(c[0], t[0]), dot(c[1], t[1])};
    double det = cross(t[0], t[1]), x = p[0] * t[1][1] - t[0][1] * p[1];
    double y = t[0][0] * p[1] - p[0] * t[1][0], a, b;

    if (func < 3) {
        a = func == 1 ? cross(d, t[1]) : dot(d, t[1]);
        b = func == 1 ? cross(t[0], d) : dot(d, t[0]);
        out[0] = a * a * dot(t[0], t[0]) - b * b * dot(t[1], t[1]);
        return;
    }
    out[0] = (x - det * (c[0][0] + c[1][0]) / 2) * (c[0][0] - c[1][0]) +
             (y - det * (c[0][1] + c[1][1]) / 2) * (c[0][1] - c[1][1]);
    if (func < 4)
        return;
    out[3] = -2 * out[0];
    out[0] = det;
    out[1] = x / det;
    out[2] = y / det;
}

/* Law: F equals the definition; of rational curves times a constant and the
 * power of both weights that clears denominators (6 for F1, F2, 4 for F3). */
static void by_definition(void **state)
{
    static const int power[5] = {0, 6, 6, 4, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(721);

    (void)state;
    for (int i = 0; i < 24; i++) {
        crv_kind k = {1 + i % 3, 2, i % 4 == 3, i % 3 == 2 ? 3 : 0, 0, 1};
        crv_kind l = {2 + i % 2, 2, i % 8 == 7, 0, 0.5, 1};
        ix_mv *c[2] = {rand_crv(ctx, &r, &k), rand_crv(ctx, &r, &l)}, *f;
        int func = 1 + i % 4;
        double first = 0;

        ASSERT_OK(ctx, ix_cbisector2d(ctx, c[0], c[1], func, NULL, &f));
        assert_int_equal(ix_mv_ncoords(f), func == 4 ? 3 : 1);
        for (int j = 0; j < 9; j++) {
            double x[2][2], t[2][2], u[2], d[4], w = 1, v[4], want[4], big;

            for (int s = 0; s < 2; s++) {
                double dom[2], h[3];

                ix_mv_domain(c[s], 0, dom);
                u[s] = dom[0] +
                       (dom[1] - dom[0]) * ((s ? j / 3 : j % 3) * 0.31 + 0.15);
                ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c[s], u[s], 1, d));
                for (int q = 0; q < 2; q++) {
                    x[s][q] = d[q];
                    t[s][q] = d[2 + q];
                }
                ASSERT_OK(ctx, ix_mv_eval(ctx, c[s], &u[s], h));
                if (ix_mv_rational(c[s]))
                    w *= pow(h[0], power[func]);
            }
            define(func, x, t, want);
            ASSERT_OK(ctx, ix_mv_eval(ctx, f, u, v));
            if (func == 4) {
                for (int q = 1; q < 4; q++)
                    ASSERT_CLOSE(v[q] / v[0], want[q], 1e-8);
                continue;
            }
            big = w * want[0];
            if (j == 0)
                first = v[0] / big;
            /* values of size 1 to 1e3; cancellation takes six digits */
            if (!(fabs(v[0] - first * big) <=
                  1e-9 * (fabs(first) + fabs(v[0]))))
                fail_msg("function %d, pair %d: %.15g, %.15g", func, i, v[0],
                         first * big);
        }
        if (!ix_mv_rational(c[0]) && !ix_mv_rational(c[1]) && func < 4)
            ASSERT_CLOSE(first, 1, 1e-9);
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, c[0]);
        ix_mv_unref(ctx, c[1]);
    }
    ix_ctx_free(ctx);
}

/* Law: the same for functions 1 to 3 of rational curves with weights from 1e-3
 * to 1e3, repeated knots too, in relation to the terms whose difference they
 * are (1e-8: weights as different as that take six digits of a point). */
static void weights(void **state)
{
    static const int power[4] = {0, 6, 6, 4};
    static const double kv[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(723);

    (void)state;
    for (int i = 0; i < 24; i++) {
        int func = 1 + i % 3;
        double first = 0;
        ix_mv *c[2], *f;

        for (int s = 0; s < 2; s++) {
            double pts[15];

            for (int j = 0; j < 5; j++) {
                pts[j] = pow(10, ix_rng_range(&r, -3, 3));
                for (int k = 1; k < 3; k++)
                    pts[5 * k + j] = pts[j] * ix_rng_range(&r, -1, 1);
            }
            c[s] = make_crv(ctx, 3, 5, kv, true, 2, pts);
        }
        ASSERT_OK(ctx, ix_cbisector2d(ctx, c[0], c[1], func, NULL, &f));
        for (int j = 0; j < 16; j++) {
            double x[2][2], t[2][2], u[2], d[4], h[3], w = 1, v, want[4];
            double size;

            for (int s = 0; s < 2; s++) {
                u[s] = 0.13 + 0.51 * (s ? j / 4 : j % 4);
                ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c[s], u[s], 1, d));
                memcpy(x[s], d, sizeof x[s]);
                memcpy(t[s], d + 2, sizeof t[s]);
                ASSERT_OK(ctx, ix_mv_eval(ctx, c[s], &u[s], h));
                w *= pow(h[0], power[func]);
            }
            define(func, x, t, want);
            ASSERT_OK(ctx, ix_mv_eval(ctx, f, u, &v));
            size = hypot(t[0][0], t[0][1]) * hypot(t[1][0], t[1][1]);
            size *= func == 3 ? 1 : size;
            if (j == 0)
                first = v / (w * want[0]);
            if (!(fabs(v / first - w * want[0]) <= 1e-8 * w * size))
                fail_msg("function %d, pair %d, place %d: %.15g, %.15g", func,
                         i, j, v / first, w * want[0]);
        }
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, c[0]);
        ix_mv_unref(ctx, c[1]);
    }
    ix_ctx_free(ctx);
}

/* Degrees as stated. */
static void degrees(void **state)
{
    static const int want[5][2][2] = {{{0}},
                                      {{4, -2}, {6, -4}},
                                      {{4, -2}, {6, -4}},
                                      {{3, -1}, {4, -2}},
                                      {{4, -2}, {7, -2}}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(722);

    (void)state;
    for (int func = 1; func <= 4; func++)
        for (int rational = 0; rational < 2; rational++)
            for (int d = 2; d <= 4; d++) {
                crv_kind k = {d, 2, rational, 0, 0, 1};
                ix_mv *a = rand_crv(ctx, &r, &k), *b = rand_crv(ctx, &r, &k);
                const int *w = want[func][rational];
                ix_mv *f;

                ASSERT_OK(ctx, ix_cbisector2d(ctx, a, b, func, NULL, &f));
                for (int i = 0; i < 2; i++)
                    assert_int_equal(degree_of(f, i), w[0] * d + w[1]);
                ix_mv_unref(ctx, f);
                ix_mv_unref(ctx, a);
                ix_mv_unref(ctx, b);
            }
    ix_ctx_free(ctx);
}

/* Law: each point of the curves is the centre of a circle that touches both:
 * the distances of feet found from it are equal. Here the feet are those of two
 * circles, on lines through both centres. */
static void curves_of_circles(void **state)
{
    const double o[3] = {0, 0, 0}, p[3] = {3, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a, *b;
    ix_lines l;
    int n = 0;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 1, &a));
    ASSERT_OK(ctx, ix_circle(ctx, p, 0.5, &b));
    ASSERT_OK(ctx, ix_cbisector2d_curves(ctx, a, b, 1e-3, false, &l));
    for (int i = 0; i < l.n; i++)
        for (int j = 0; j < l.count[i]; j++, n++) {
            double d = hypot(l.pt[n][0], l.pt[n][1]);
            double e = hypot(l.pt[n][0] - 3, l.pt[n][1]), best = INFINITY;

            for (int s = -1; s <= 1; s += 2)
                for (int q = -1; q <= 1; q += 2)
                    best = fmin(best, fabs(fabs(d + s) - fabs(e + 0.5 * q)));
            assert_true(best <= 1e-9 * (1 + d));
        }
    assert_true(l.n >= 2 && n > 40);
    ix_lines_free(ctx, &l);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    static const double pts[4] = {0, 1, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = make_crv(ctx, 2, 2, NULL, false, 2, pts), *f;
    ix_mv *e1 = make_crv(ctx, 2, 2, NULL, false, 1, pts);
    ix_lines l;

    (void)state;
    assert_int_equal(ix_cbisector2d(ctx, a, a, 0, NULL, &f), IX_EARG);
    assert_int_equal(ix_cbisector2d(ctx, a, a, 5, NULL, &f), IX_EARG);
    assert_int_equal(ix_cbisector2d(ctx, a, e1, 3, NULL, &f), IX_EARG);
    assert_int_equal(ix_cbisector2d_curves(ctx, a, e1, 0, false, &l), IX_EARG);
    assert_int_equal(ix_cbisector2d_curves(ctx, a, a, NAN, false, &l), IX_EARG);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, e1);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *a, *b, *f[4];
    ix_lines l;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    static const double p[6] = {0, 1, 2, 0, 1, 0}, q[6] = {0, 1, 2, 3, 2, 3.1};
    fault_state *s = state;

    *s = (fault_state){.a = make_crv(ctx, 3, 3, NULL, false, 2, p),
                       .b = make_crv(ctx, 3, 3, NULL, false, 2, q)};
}

static ix_status fault_call(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < 4; i++)
        st = ix_cbisector2d(ctx, s->a, s->b, i + 1, NULL, &s->f[i]);
    return st == IX_OK
               ? ix_cbisector2d_curves(ctx, s->a, s->b, 0.1, true, &s->l)
               : st;
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    for (int i = 0; i < 4; i++)
        ix_mv_unref(ctx, s->f[i]);
    ix_lines_free(ctx, &s->l);
    ix_mv_unref(ctx, s->a);
    ix_mv_unref(ctx, s->b);
    *s = (fault_state){0};
}

static void no_memory(void **state)
{
    fault_state s = {0};
    ix_fault_case c = {fault_setup, fault_call, fault_teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_definition), cmocka_unit_test(weights),
        cmocka_unit_test(degrees),       cmocka_unit_test(curves_of_circles),
        cmocka_unit_test(errors),        cmocka_unit_test(no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
