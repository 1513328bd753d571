/* Focal curves in special positions. That they satisfy their definition is in
 * t_crv_truth and, exactly, in t_crv_exact; their degrees in t_crv_degrees. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "iritx/sym.h"

/* The curve (t, t^2) carried to the sphere of radius 2 around (3, -1, 2) by
 * stereographic projection, w = 1 + t^2 + t^4, (2t, 2t^2, t^2 + t^4 - 1):
 * Bernstein coefficients of degree 4 of t^k are C(i,k) / C(4,k). */
static ix_mv *on_sphere(ix_ctx *ctx)
{
    static const double centre[3] = {3, -1, 2};
    double pts[20];

    for (int i = 0; i < 5; i++) {
        double t = i / 4.0, t2 = i * (i - 1) / 12.0, t4 = i == 4;
        double w = 1 + t2 + t4;
        const double p[3] = {2 * t, 2 * t2, t2 + t4 - 1};

        pts[i] = w;
        for (int k = 0; k < 3; k++)
            pts[5 * (k + 1) + i] = centre[k] * w + 2 * p[k];
    }
    return make_crv(ctx, 5, 5, NULL, true, 3, pts);
}

/* A curve on a sphere has its centre as focal curve, in every form; reduced it
 * is a point. */
static void spherical_curve(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = on_sphere(ctx), *f, *low;

    (void)state;
    for (int form = 0; form < 3; form++) {
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};

        ASSERT_OK(ctx, ix_focal_crv(ctx, c, &o, NULL, &f));
        for (int i = 0; i < 9; i++) {
            double t = (i + 0.5) / 9, x[3];

            ASSERT_OK(ctx, ix_mv_point(ctx, f, &t, x));
            ASSERT_CLOSE(x[0], 3, 1e-12);
            ASSERT_CLOSE(x[1], -1, 1e-12);
            ASSERT_CLOSE(x[2], 2, 1e-12);
        }
        if (form == 0) {
            ASSERT_OK(ctx, ix_sym_reduce(ctx, f, 1e-12, NULL, &low));
            assert_int_equal(ix_mv_order(low, 0), 1);
            ix_mv_unref(ctx, low);
        }
        ix_mv_unref(ctx, f);
    }
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* A span in a plane is refused by name, a planar curve as a whole, too. */
static void planar_span(void **state)
{
    static const double kv[12] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    /* the first piece in z = 0, the second not */
    static const double pts[21] = {0, 1, 1, 0, -1, -1, 0, 0, 0, 1, 1,
                                   1, 2, 3, 0, 0,  0,  0, 1, 0, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = make_crv(ctx, 4, 7, kv, false, 3, pts), *f;

    (void)state;
    assert_int_equal(ix_focal_crv(ctx, c, NULL, NULL, &f), IX_EDOMAIN);
    assert_null(f);
    if (!strstr(ix_ctx_message(ctx), "plane over [0, 1]"))
        fail_msg("'%s'", ix_ctx_message(ctx));
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Law: the focal curve's tangent is along the binormal of the curve. */
static void tangent_is_the_binormal(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(62);

    (void)state;
    for (int i = 0; i < 4; i++) {
        crv_kind k = {4, 3, i & 1, i & 2 ? 3 : 0, 0, 0};
        ix_mv *c = gentle_crv(ctx, &r, &k), *f;
        double dom[2];

        ASSERT_OK(ctx, ix_focal_crv(ctx, c, NULL, NULL, &f));
        ix_mv_domain(c, 0, dom);
        for (int j = 0; j < 5; j++) {
            double t = dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 5;
            double x[9], v[6], len, a = 0, b = 0;

            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 2, x));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, f, t, 1, v));
            len = sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
            for (int n = 0; n < 3; n++) {
                a += v[3 + n] * x[3 + n];
                b += v[3 + n] * x[6 + n];
            }
            if (!(fabs(a) <= 1e-10 * len && fabs(b) <= 1e-10 * len))
                fail_msg("curve %d at %g: %g, %g of %g", i, t, a, b, len);
        }
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, f);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spherical_curve),
        cmocka_unit_test(planar_span),
        cmocka_unit_test(tangent_is_the_binormal),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
