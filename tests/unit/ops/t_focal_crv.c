/* Focal curves: contact of third order, degrees of all forms. */
#include <limits.h>

#include "crv_test.h"

/* a d + b of each form: [rational][form]. */
static const int degrees[2][4][2] = {{{4, -7}, {4, -6}, {4, -6}, {4, -7}},
                                     {{8, -12}, {9, -6}, {41, 0}, {8, -12}}};

static void one(ix_ctx *ctx, ix_rng *r, const crv_kind *k)
{
    static const double bounds[4] = {1e-9, 1e-8, 1e-7, 1e-9};
    ix_mv *c = rand_crv(ctx, r, k), *f;

    for (int form = 0; form < 4; form++) {
        const int *deg = degrees[k->rational][form];
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        ix_report rep;

        ASSERT_OK(ctx, ix_focal_crv(ctx, c, &o, &rep, &f));
        if (degree_of(f, 0) != deg[0] * k->degree + deg[1])
            fail_msg("form %d degree %d rational %d: %d", form, k->degree,
                     k->rational, degree_of(f, 0));
        if (!(rep.residual <= bounds[form]))
            fail_msg("form %d degree %d rational %d: residual %g", form,
                     k->degree, k->rational, rep.residual);
        ix_mv_unref(ctx, f);
    }
    ix_mv_unref(ctx, c);
}

/* Law: (c - x).x' = 0, (c - x).x'' = |x'|^2, (c - x).x''' = 3 x'.x'': the
 * sphere around c meets the curve four times at x. Being built as a rational
 * curve that satisfies these is the proof that the focal curve is rational. */
static void definition_holds(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(73);

    (void)state;
    for (int d = 3; d <= 5; d++)
        for (int i = 0; i < 2; i++) {
            crv_kind k = {d, 3, i, d & 1 ? 3 : 0, 0, 0};

            one(ctx, &r, &k);
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
