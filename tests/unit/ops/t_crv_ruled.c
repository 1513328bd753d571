/* Ruled surfaces along curves: rulings as defined, degrees of all forms. */
#include <limits.h>

#include "crv_test.h"

/* a d + b of each form, at least d: [kind][rational][form]. */
static const int degrees[5][2][4][2] = {
    [IX_RULED_TANGENT] = {{{1, 0}, {1, 0}, {1, 0}, {1, 0}},
                          {{2, -2}, {2, -1}, {3, 0}, {2, -2}}},
    [IX_RULED_NORMAL] = {{{3, -5}, {3, -4}, {3, -4}, {3, -5}},
                         {{5, -8}, {6, -4}, {9, 0}, {5, -8}}},
    [IX_RULED_BINORMAL] = {{{2, -4}, {2, -3}, {2, -3}, {2, -4}},
                           {{3, -6}, {4, -3}, {7, 0}, {3, -6}}},
    [IX_RULED_RECTIFYING] = {{{6, -12}, {7, -8}, {7, -8}, {6, -12}},
                             {{10, -18}, {13, -8}, {39, 0}, {10, -18}}},
    [IX_RULED_POLAR] = {{{3, -3}, {6, -9}, {6, -9}, {3, -3}},
                        {{6, -6}, {12, -6}, {31, 0}, {6, -6}}},
};

static void one(ix_ctx *ctx, ix_rng *r, const crv_kind *k, ix_ruled_kind kind)
{
    static const double bounds[4] = {1e-9, 1e-8, 1e-7, 1e-9};
    static const double range[2] = {-0.5, 0.5};
    ix_mv *c = rand_crv(ctx, r, k), *s;

    for (int form = 0; form < 4; form++) {
        const int *deg = degrees[kind][k->rational][form];
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        int want = deg[0] * k->degree + deg[1];
        ix_report rep;

        want = want > k->degree ? want : k->degree;
        ASSERT_OK(ctx, ix_crv_ruled(ctx, c, kind, range, &o, &rep, &s));
        if (degree_of(s, 0) != want || degree_of(s, 1) != 1)
            fail_msg("kind %d form %d degree %d rational %d: %d", kind, form,
                     k->degree, k->rational, degree_of(s, 0));
        if (!(rep.residual <= bounds[form]))
            fail_msg("kind %d form %d degree %d rational %d: residual %g", kind,
                     form, k->degree, k->rational, rep.residual);
        ix_mv_unref(ctx, s);
    }
    ix_mv_unref(ctx, c);
}

/* Law: rulings pass through the curve (the polar ones through the centres of
 * curvature) in the direction of tangent, normal, binormal, Darboux vector. */
static void definition_holds(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(74);

    (void)state;
    for (int kind = IX_RULED_TANGENT; kind <= IX_RULED_POLAR; kind++)
        for (int d = 3; d <= 5; d++)
            for (int i = 0; i < 2; i++) {
                crv_kind k = {d, 3, i, d & 1 ? 3 : 0, 0, 0};

                one(ctx, &r, &k, (ix_ruled_kind)kind);
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
