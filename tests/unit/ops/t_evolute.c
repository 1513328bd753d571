/* Evolutes in closed form and in special positions. That they satisfy their
 * definition is in t_crv_truth, their degrees in t_crv_degrees. */
#include <limits.h>

#include "crv_test.h"

/* A degree form's tolerance on these curves, whose values are well conditioned:
 * the minimal one's is that of a few roundings. */
static const double tol[4] = {1e-14, 1e-13, 1e-12, 1e-12};

static ix_mv *evolute_of(ix_ctx *ctx, const ix_mv *c, int form)
{
    ix_op_opts o = {(ix_degree_form)form, INT_MAX};
    ix_mv *e;

    ASSERT_OK(ctx, ix_evolute(ctx, c, &o, NULL, &e));
    return e;
}

/* The point at a part u of the domain. */
static double point_at(ix_ctx *ctx, const ix_mv *m, double u, double x[3])
{
    double dom[2], t;

    ix_mv_domain(m, 0, dom);
    t = dom[0] + u * (dom[1] - dom[0]);
    x[2] = 0;
    ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, x));
    return t;
}

/* x = 2 cos, y = sin: (3/2 cos^3, -3 sin^3), in all forms. */
static void ellipse(void **state)
{
    static const double origin[3] = {0, 0, 0},
                        wide[16] = {2, 0, 0, 0, 0, 1, 0, 0,
                                    0, 0, 1, 0, 0, 0, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *round, *c, *e;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, origin, 1, &round));
    ASSERT_OK(ctx, ix_mv_transform(ctx, round, wide, &c));
    for (int form = 0; form < 4; form++) {
        e = evolute_of(ctx, c, form);
        for (int i = 0; i < 23; i++) {
            double x[3], y[3];

            point_at(ctx, c, i / 22.0, x);
            point_at(ctx, e, i / 22.0, y);
            ASSERT_CLOSE(y[0], 1.5 * pow(x[0] / 2, 3), tol[form]);
            ASSERT_CLOSE(y[1], -3 * pow(x[1], 3), tol[form]);
        }
        ix_mv_unref(ctx, e);
    }
    ix_mv_unref(ctx, round);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* y = x^2 over [-1, 1]: (-4 x^3, 1/2 + 3 x^2), of degree 3. */
static void parabola(void **state)
{
    static const double p[6] = {-1, 0, 1, 1, -1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = make_crv(ctx, 3, 3, NULL, false, 2, p), *e;

    (void)state;
    for (int form = 0; form < 4; form++) {
        e = evolute_of(ctx, c, form);
        if (form < 3)
            assert_int_equal(degree_of(e, 0), 3);
        for (int i = 0; i <= 10; i++) {
            double x = i / 5.0 - 1, y[3];

            point_at(ctx, e, i / 10.0, y);
            ASSERT_CLOSE(y[0], -4 * x * x * x, tol[form]);
            ASSERT_CLOSE(y[1], 0.5 + 3 * x * x, tol[form]);
        }
        ix_mv_unref(ctx, e);
    }
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* y = x^3: at the inflection the weight changes its sign, the evolute goes to
 * infinity along the normal, in all forms; the minimal weight is 0 exactly. */
static void inflection(void **state)
{
    static const double p[8] = {-1, -1. / 3, 1. / 3, 1, -1, 1, -1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = make_crv(ctx, 4, 4, NULL, false, 2, p), *e;

    (void)state;
    for (int form = 0; form < 4; form++) {
        double half = 0.5, near = 0.499, past = 0.501, w[3][4], x[3];

        e = evolute_of(ctx, c, form);
        assert_true(ix_mv_has_poles(e));
        ASSERT_OK(ctx, ix_mv_eval(ctx, e, &near, w[0]));
        ASSERT_OK(ctx, ix_mv_eval(ctx, e, &half, w[1]));
        ASSERT_OK(ctx, ix_mv_eval(ctx, e, &past, w[2]));
        /* IRIT's form has the square of the curvature as weight */
        assert_true(form == 3 ? w[0][0] > 0 && w[2][0] > 0
                              : w[0][0] * w[2][0] < 0);
        assert_true(fabs(w[1][0]) <= 1e-16);
        /* 1 / kappa = (1 + 9 x^4)^(3/2) / (6 x), x = -0.002 */
        ASSERT_OK(ctx, ix_mv_point(ctx, e, &near, x));
        ASSERT_CLOSE(x[1], -1 / 0.012, 1e-6);
        ix_mv_unref(ctx, e);
    }
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Law: the evolute of a planar curve carried to any plane of space is its
 * evolute carried there, in the planar degree. */
static void tilted_plane(void **state)
{
    /* rows are the images of the axes, then of the origin */
    static const double turn[16] = {0.8,  -0.6, 0,   0, 0.36, 0.48, -0.8, 0,
                                    0.48, 0.64, 0.6, 0, 3,    -2,   1,    1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(61);

    (void)state;
    for (int i = 0; i < 4; i++) {
        crv_kind k = {3, 2, i & 1, i & 2 ? 2 : 0, 0, 0};
        ix_mv *c = gentle_crv(ctx, &r, &k), *e = evolute_of(ctx, c, 0);
        ix_mv *flat, *s, *es;

        ASSERT_OK(ctx, ix_mv_coerce(ctx, c, 3, i & 1, &flat));
        ASSERT_OK(ctx, ix_mv_transform(ctx, flat, turn, &s));
        es = evolute_of(ctx, s, 0);
        for (int j = 0; j < 7; j++) {
            double x[3], y[3];

            point_at(ctx, e, (j + 0.5) / 7, x);
            point_at(ctx, es, (j + 0.5) / 7, y);
            for (int a = 0; a < 3; a++)
                ASSERT_CLOSE(y[a],
                             turn[a] * x[0] + turn[4 + a] * x[1] + turn[12 + a],
                             1e-12);
        }
        assert_int_equal(degree_of(es, 0), degree_of(e, 0));
        ix_mv_unref(ctx, es);
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, flat);
        ix_mv_unref(ctx, e);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Law: the centre of curvature moves along the normal, E'.x' = 0. */
static void moves_along_the_normal(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(78);

    (void)state;
    for (int i = 0; i < 8; i++) {
        crv_kind k = {3 + i / 4, 2, i & 1, i & 2 ? 3 : 0, 0, 0};
        ix_mv *c = gentle_crv(ctx, &r, &k), *e = evolute_of(ctx, c, 0);
        double dom[2];

        ix_mv_domain(c, 0, dom);
        for (int j = 0; j < 5; j++) {
            double t = dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 5, x[4], v[4];

            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, x));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, e, t, 1, v));
            if (!(fabs(x[2] * v[2] + x[3] * v[3]) <=
                  1e-11 * hypot(x[2], x[3]) * (hypot(v[2], v[3]) + 1)))
                fail_msg("curve %d at %g: not along the normal, %g", i, t,
                         x[2] * v[2] + x[3] * v[3]);
        }
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, e);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ellipse),
        cmocka_unit_test(parabola),
        cmocka_unit_test(inflection),
        cmocka_unit_test(tilted_plane),
        cmocka_unit_test(moves_along_the_normal),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
