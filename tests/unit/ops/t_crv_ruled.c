/* Ruled surfaces along curves: developable or not. That rulings are as defined
 * is in t_crv_truth, degrees are in t_crv_degrees. */
#include <limits.h>

#include "crv_test.h"

static void sub(const double *a, const double *b, double *out)
{
    for (int k = 0; k < 3; k++)
        out[k] = a[k] - b[k];
}

static double cosine(const double *a, const double *b)
{
    double ab = 0, aa = 0, bb = 0;

    for (int k = 0; k < 3; k++) {
        ab += a[k] * b[k];
        aa += a[k] * a[k];
        bb += b[k] * b[k];
    }
    return ab / sqrt(aa * bb);
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

/* Law: along a ruling of a developable (tangent, rectifying, polar) the normal
 * does not turn; the Gauss curvature is zero. The scrolls of a twisted curve
 * turn. */
static void developables_have_no_gauss_curvature(void **state)
{
    static const double range[2] = {0.1, 0.3};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(76);

    (void)state;
    for (int i = 0; i < 10; i++) {
        ix_ruled_kind kind = (ix_ruled_kind)(i % 5);
        bool scroll = kind == IX_RULED_NORMAL || kind == IX_RULED_BINORMAL;
        crv_kind k = {3, 3, i >= 5, 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &r, &k), *s;
        double worst = 1;

        ASSERT_OK(ctx, ix_crv_ruled(ctx, c, kind, range, NULL, NULL, &s));
        for (int j = 0; j < 7; j++) {
            double a[3], b[3], t = (j + 0.5) / 7;

            normal_at(ctx, s, t, 0, a);
            normal_at(ctx, s, t, 1, b);
            worst = fmin(worst, fabs(cosine(a, b)));
        }
        if (scroll ? worst > 1 - 1e-6 : !(worst >= 1 - 1e-10))
            fail_msg("kind %d: cosine of normals 1 - %g", kind, 1 - worst);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, s);
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
        crv_kind k = {3, 3, i & 1, i & 2 ? 2 : 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &r, &k), *s, *f;
        double dom[2];

        ASSERT_OK(ctx,
                  ix_crv_ruled(ctx, c, IX_RULED_POLAR, range, NULL, NULL, &s));
        ASSERT_OK(ctx, ix_focal_crv(ctx, c, NULL, NULL, &f));
        ix_mv_domain(c, 0, dom);
        for (int j = 0; j < 5; j++) {
            double uv[2] = {dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 5, 0};
            double a[3], b[3], d[6];

            ASSERT_OK(ctx, ix_mv_point(ctx, s, uv, a));
            uv[1] = 1;
            ASSERT_OK(ctx, ix_mv_point(ctx, s, uv, b));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, f, uv[0], 1, d));
            sub(b, a, b);
            sub(d, a, a);
            /* 1 - cosine: the square of the angle, far below rounding */
            if (!(fabs(cosine(b, d + 3)) >= 1 - 1e-10) ||
                !(fabs(cosine(b, a)) >= 1 - 1e-10))
                fail_msg("curve %d: tangent %g, point %g", i,
                         1 - fabs(cosine(b, d + 3)), 1 - fabs(cosine(b, a)));
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
