/* Ruled surfaces along curves: developable or not. That rulings are as defined
 * is in t_crv_truth, degrees are in t_crv_degrees. */
#include <limits.h>

#include "crv_test.h"

static void sub(const double *a, const double *b, double *out)
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

static double length(const double *a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* Of the angle between the lines along a and b: 0 where they are parallel. */
static double sine(const double *a, const double *b)
{
    double c[3];

    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] -
               a[(k + 2) % 3] * b[(k + 1) % 3];
    return length(c) / (length(a) * length(b));
}

/* Unit normal direction of the surface at (t, v). */
static void normal_at(ix_ctx *ctx, const ix_mv *s, double t, double v,
                      double *out)
{
    double h[3][4], d[2][3], uv[2] = {t, v};

    for (int i = 0; i < 3; i++) {
        int k[2] = {i == 1, i == 2};

        ASSERT_OK(ctx, ix_mv_partial(ctx, s, uv, k, h[i]));
    }
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            d[i][k] = h[i + 1][k + 1] * h[0][0] - h[0][k + 1] * h[i + 1][0];
    for (int k = 0; k < 3; k++)
        out[k] = d[0][(k + 1) % 3] * d[1][(k + 2) % 3] -
                 d[0][(k + 2) % 3] * d[1][(k + 1) % 3];
}

/* Largest sine between the normals at both ends of rulings, NaN counts. */
static double turn_of_normals(ix_ctx *ctx, const ix_mv *s)
{
    double dom[2], worst = 0;

    ix_mv_domain(s, 0, dom);
    for (int j = 0; j < 7; j++) {
        double a[3], b[3], t = dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 7;

        normal_at(ctx, s, t, 0, a);
        normal_at(ctx, s, t, 1, b);
        if (!(sine(a, b) <= worst))
            worst = sine(a, b);
    }
    return worst;
}

/* Law: along a ruling of a developable (tangent, rectifying, polar) the normal
 * does not turn, in any form: the Gauss curvature, minus the square of the rate
 * of turning, is zero. The scrolls of a twisted curve turn. 1e-10 on well
 * conditioned curves. */
static void developables_have_no_gauss_curvature(void **state)
{
    static const double range[2] = {0.1, 0.3};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(76);

    (void)state;
    for (int i = 0; i < 40; i++) {
        ix_ruled_kind kind = (ix_ruled_kind)(i % 5);
        bool scroll = kind == IX_RULED_NORMAL || kind == IX_RULED_BINORMAL;
        crv_kind k = {3 + i / 20, 3, i / 5 & 1, i / 10 & 1 ? 3 : 0, 0, 0};
        ix_mv *c = gentle_crv(ctx, &r, &k), *s;

        for (int form = 0; form < 3; form++) {
            const ix_op_opts o = {(ix_degree_form)form, INT_MAX};
            double turn;

            ASSERT_OK(ctx, ix_crv_ruled(ctx, c, kind, range, &o, NULL, &s));
            turn = turn_of_normals(ctx, s);
            if (scroll ? !(turn > 1e-6) : !(turn <= 1e-10))
                fail_msg("kind %d form %d: normals turn by %g", kind, form,
                         turn);
            ix_mv_unref(ctx, s);
        }
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Law: the rulings of the polar developable are the tangents of the focal
 * curve. */
static void polar_rulings_touch_the_focal_curve(void **state)
{
    static const double range[2] = {-1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(77);

    (void)state;
    for (int i = 0; i < 4; i++) {
        crv_kind k = {4, 3, i & 1, i & 2 ? 2 : 0, 0, 0};
        ix_mv *c = gentle_crv(ctx, &r, &k), *s, *f;
        double dom[2];

        ASSERT_OK(ctx,
                  ix_crv_ruled(ctx, c, IX_RULED_POLAR, range, NULL, NULL, &s));
        ASSERT_OK(ctx, ix_focal_crv(ctx, c, NULL, NULL, &f));
        ix_mv_domain(c, 0, dom);
        for (int j = 0; j < 5; j++) {
            double uv[2] = {dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 5, 0};
            double a[3], b[3], d[6], off;

            ASSERT_OK(ctx, ix_mv_point(ctx, s, uv, a));
            uv[1] = 1;
            ASSERT_OK(ctx, ix_mv_point(ctx, s, uv, b));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, f, uv[0], 1, d));
            sub(b, a, b);
            sub(d, a, a);
            off = sine(b, a) * length(a); /* from the line to the point */
            if (!(sine(b, d + 3) <= 1e-10) || !(off <= 1e-10 * length(d)))
                fail_msg("curve %d: tangent %g, point %g of %g", i,
                         sine(b, d + 3), off, length(d));
        }
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, f);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(developables_have_no_gauss_curvature),
        cmocka_unit_test(polar_rulings_touch_the_focal_curve),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
