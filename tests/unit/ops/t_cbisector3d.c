/* The bisector surface of two space curves: its definition substituted back,
 * its degrees, its behaviour under changes of the input, degenerate input. */
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/ops.h"

static ix_mv *make_curve(ix_ctx *ctx, int order, int n, const double *knots,
                         bool rational, int nc, const double *pts)
{
    ix_dir d = {knots ? IX_BSPLINE : IX_BEZIER, order, n, false, knots};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, nc, rational, pts, &m));
    return m;
}

/* kind 0: Bezier; else a B-spline with that many spans (simple knots). */
static ix_mv *rand_curve(ix_ctx *ctx, ix_rng *r, int degree, bool rational,
                         int spans, const double *shift, double size)
{
    double kv[64], pts[4 * 40];
    int n = degree + (spans > 0 ? spans : 1);

    for (int i = 0; i < n + degree + 1; i++)
        kv[i] = i <= degree ? 0 : i >= n ? spans : i - degree + 0.2;
    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(r, 0.5, 2) : 1;
        double *p = pts + (rational ? n : 0);

        pts[i] = w;
        for (int k = 0; k < 3; k++)
            p[k * n + i] = w * (size * ix_rng_range(r, -1, 1) +
                                (shift ? shift[k] : 0));
    }
    return make_curve(ctx, degree + 1, n, spans ? kv : NULL, rational, 3, pts);
}

/* Largest of the three defining residuals over random samples, relative to the
 * distance: equidistance and the two normal planes. Points where the weight is
 * below 1e-3 of the largest are near infinity and left out. */
static double worst_residual(ix_ctx *ctx, ix_rng *r, const ix_mv *a,
                             const ix_mv *b, const ix_mv *s)
{
    double worst = 0, top = 0;

    for (size_t i = 0; i < ix_mv_npts(s); i++)
        top = fmax(top, fabs(ix_mv_weights(s)[i]));
    for (int round = 0; round < 40; round++) {
        double t[2], dom[2], x[4], e[2][6], d[2] = {0, 0}, dot[2] = {0, 0},
                                            tan[2] = {0, 0};

        for (int i = 0; i < 2; i++) {
            ix_mv_domain(s, i, dom);
            t[i] = ix_rng_range(r, dom[0], dom[1]);
        }
        ASSERT_OK(ctx, ix_mv_eval(ctx, s, t, x));
        if (!(fabs(x[0]) > 1e-3 * top))
            continue;
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, a, t[0], 1, e[0]));
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, b, t[1], 1, e[1]));
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 3; k++) {
                double v = x[k + 1] / x[0] - e[i][k];

                d[i] += v * v;
                dot[i] += v * e[i][3 + k];
                tan[i] += e[i][3 + k] * e[i][3 + k];
            }
        worst = fmax(worst, fabs(sqrt(d[0]) - sqrt(d[1])) / sqrt(d[0]));
        for (int i = 0; i < 2; i++)
            worst = fmax(worst, fabs(dot[i]) / sqrt(d[i] * tan[i]));
    }
    return worst;
}

static int degree_of(const ix_mv *s, int dir)
{
    return ix_mv_order(s, dir) - 1;
}

/* Law: |B - C1| = |B - C2|, (B - C1).C1' = (B - C2).C2' = 0, for polynomial
 * and rational Bezier and B-spline curves; degrees exactly 3d - 1 (polynomial
 * curve) and 4d - 2 (rational curve). Tolerance: the aim of the project. */
static void definition_holds(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(31);

    (void)state;
    for (int round = 0; round < 32; round++) {
        int d1 = ix_rng_int(&r, 1, 4), d2 = ix_rng_int(&r, 1, 4);
        bool q1 = round & 1, q2 = round >> 1 & 1;
        int n1 = round & 4 ? 3 : 0, n2 = round & 8 ? 4 : 0;
        ix_mv *a = rand_curve(ctx, &r, d1, q1, n1, NULL, 1);
        ix_mv *b = rand_curve(ctx, &r, d2, q2, n2, NULL, 1), *s;
        double res;
        ix_report rep;

        ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, &rep, &s));
        assert_int_equal(degree_of(s, 0), q1 ? 4 * d1 - 2 : 3 * d1 - 1);
        assert_int_equal(degree_of(s, 1), q2 ? 4 * d2 - 2 : 3 * d2 - 1);
        assert_int_equal(rep.orders[0], ix_mv_order(s, 0));
        assert_true(ix_mv_rational(s) && ix_mv_ncoords(s) == 3);
        assert_int_equal(ix_mv_dir(s, 0).basis, n1 ? IX_BSPLINE : IX_BEZIER);
        res = worst_residual(ctx, &r, a, b, s);
        if (!(res <= 1e-12 && rep.residual <= 1e-12))
            fail_msg("degrees %d %d rational %d %d spans %d %d: %g, %g", d1, d2,
                     q1, q2, n1, n2, res, rep.residual);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition_holds),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
