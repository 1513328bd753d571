/* Evolutes: the definition substituted back, degrees of all forms. */
#include <limits.h>

#include "crv_test.h"

/* a d + b of each form: [space][rational][form]. */
static const int degrees[2][2][4][2] = {
    {{{3, -3}, {3, -3}, {3, -3}, {6, -6}},
     {{6, -6}, {6, -3}, {13, 0}, {25, 0}}},
    {{{5, -7}, {5, -6}, {5, -6}, {6, -6}},
     {{9, -12}, {10, -6}, {25, 0}, {25, 0}}}};

static void one(ix_ctx *ctx, ix_rng *r, const crv_kind *k)
{
    static const double bounds[4] = {1e-11, 1e-10, 1e-9, 1e-9};
    ix_mv *c = rand_crv(ctx, r, k), *e;

    for (int form = 0; form < 4; form++) {
        const int *f = degrees[k->ncoords == 3][k->rational][form];
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        ix_report rep;

        ASSERT_OK(ctx, ix_evolute(ctx, c, &o, &rep, &e));
        if (degree_of(e, 0) != f[0] * k->degree + f[1])
            fail_msg("form %d degree %d rational %d coordinates %d: %d", form,
                     k->degree, k->rational, k->ncoords, degree_of(e, 0));
        if (!(rep.residual <= bounds[form]))
            fail_msg("form %d degree %d rational %d coordinates %d: residual "
                     "%g",
                     form, k->degree, k->rational, k->ncoords, rep.residual);
        ix_mv_unref(ctx, e);
    }
    ix_mv_unref(ctx, c);
}

/* Law: |E - x| is the radius of curvature, towards the centre. */
static void definition_holds(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(72);

    (void)state;
    for (int d = 2; d <= 5; d++)
        for (int i = 0; i < 4; i++) {
            crv_kind k = {d, 2 + (i & 1), i >> 1, d & 1 ? 3 : 0, 0, 0};

            one(ctx, &r, &k);
        }
    ix_ctx_free(ctx);
}

/* Law: the centre of curvature moves along the normal, E'.x' = 0, with the
 * rate of the radius, |E'| = |(1/kappa)'| (by central differences, which are
 * good to about 1e-6). */
static void velocity_of_the_centre(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(78);

    (void)state;
    for (int i = 0; i < 8; i++) {
        crv_kind k = {3, 2, i & 1, 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &r, &k), *e;

        ASSERT_OK(ctx, ix_evolute(ctx, c, NULL, NULL, &e));
        for (int j = 0; j < 5; j++) {
            double t = (j + 0.5) / 5, h = 1e-5, x[4], v[4], a, b, rate, speed;

            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, x));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, e, t, 1, v));
            ASSERT_OK(ctx, ix_crv_curvature(ctx, c, t - h, &a));
            ASSERT_OK(ctx, ix_crv_curvature(ctx, c, t + h, &b));
            rate = fabs(1 / b - 1 / a) / (2 * h);
            speed = hypot(v[2], v[3]);
            if (!(fabs(x[2] * v[2] + x[3] * v[3]) <=
                  1e-9 * hypot(x[2], x[3]) * speed))
                fail_msg("curve %d at %g: not along the normal", i, t);
            if (!(fabs(rate - speed) <= 1e-4 * (1 + speed)))
                fail_msg("curve %d at %g: %g, %g", i, t, speed, rate);
        }
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, e);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition_holds),
        cmocka_unit_test(velocity_of_the_centre),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
