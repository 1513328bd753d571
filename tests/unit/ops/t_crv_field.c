/* Fields of curves: the squaring approach on gentle curves, printed counts.
 * Degrees are in t_crv_degrees, values in t_crv_truth. */
#include <limits.h>

#include "crv_test.h"
#include "ops/table.h"

/* Law: (kappa^2)' of the naive and IRIT forms, in the plane and in space, of
 * curves with speeds between 1 and 4. */
static void gentle_slopes(void **state)
{
    static const double pts[16] = {1, 1.2, 0.9, 1, 0,   1.2, 2.1, 3,
                                   0, 1.1, 0.8, 0, 0.1, 0.9, 0.3, 0.2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 4; i++) {
        bool rational = i & 1;
        ix_mv *c = make_crv(ctx, 4, 4, NULL, rational, 2 + i / 2,
                            rational ? pts : pts + 4);

        for (int form = 0; form < 4; form++) {
            ix_op_opts o = {(ix_degree_form)form, INT_MAX};
            ix_report rep;
            ix_mv *f;

            ASSERT_OK(ctx, ix_crv_field(ctx, c, IX_CRV_CRITICAL, &o, &rep, &f));
            if (!(rep.residual <= 1e-10))
                fail_msg("curve %d form %d: %g", i, form, rep.residual);
            ix_mv_unref(ctx, f);
        }
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* --- printed and measured counts ------------------------------------------ */

/* Degree and control points of an operator in each form (0: not checked). */
typedef struct {
    const char *op;
    int want[4][2];
} counts;

static void check_counts(ix_ctx *ctx, const ix_mv *c, const counts *row)
{
    const ix_op *op = ix__op_find(row->op);
    ix_op_args a = {.mv = {c}};

    for (int form = 0; form < 4; form++) {
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        ix_mv *m;

        if (row->want[form][0] == 0)
            continue;
        ASSERT_OK(ctx, op->run(ctx, &a, &o, NULL, &m));
        if (degree_of(m, 0) != row->want[form][0] ||
            (int)ix_mv_npts(m) != row->want[form][1])
            fail_msg("%s form %d: %d / %zu", row->op, form, degree_of(m, 0),
                     ix_mv_npts(m));
        ix_mv_unref(ctx, m);
    }
}

/* The figures of Chen, Riesenfeld & Cohen 2005 for an ellipse of four arcs and
 * (Figure 1, where they print 24 points: six pieces with jumps have 42) for a
 * cubic B-spline of six spans; the counts that IRIT 11 was seen to give. */
static void printed_counts(void **state)
{
    static const counts ellipse[] = {
        {"EVOLUTE", {{6, 28}, {9, 40}, {26, 108}, {50, 201}}},
        {"CCRVTR", {{4, 20}, {12, 52}, {96, 388}, {128, 513}}},
        {"CCRVTRSQR", {{0}, {0}, {48, 196}, {48, 193}}},
        {"CNRMLCRV", {{0}, {0}, {0}, {32, 129}}},
        {"CINFLECT", {{0}, {0}, {0}, {12, 49}}}};
    static const counts spline[] = {
        {"EVOLUTE", {{6, 37}, {6, 37}, {6, 37}, {12, 73}}},
        {"CCRVTR", {{5, 36}, {6, 42}, {24, 150}, {32, 198}}},
        {"CCRVTRSQR", {{0}, {0}, {0}, {12, 73}}},
        {"CNRMLCRV", {{0}, {0}, {0}, {8, 49}}},
        {"CINFLECT", {{0}, {0}, {0}, {3, 19}}}};
    static const double origin[3] = {0, 0, 0},
                        wide[16] = {2, 0, 0, 0, 0, 1, 0, 0,
                                    0, 0, 1, 0, 0, 0, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(75);
    crv_kind k = {3, 2, false, 6, 0, 0};
    ix_mv *round, *e, *b = rand_crv(ctx, &r, &k);

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, origin, 1, &round));
    ASSERT_OK(ctx, ix_mv_transform(ctx, round, wide, &e));
    for (size_t i = 0; i < 5; i++) {
        check_counts(ctx, e, &ellipse[i]);
        check_counts(ctx, b, &spline[i]);
    }
    ix_mv_unref(ctx, round);
    ix_mv_unref(ctx, e);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gentle_slopes),
        cmocka_unit_test(printed_counts),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
