/* Fields of curves: degrees of all forms, values against derivatives. */
#include <limits.h>

#include "crv_test.h"

/* What the table of degrees says, for polynomial and rational curves. */
typedef struct {
    ix_crv_field_kind kind;
    int ncoords;
    int poly[4][2], rat[4][2]; /* a d + b of each form */
} degrees;

static const degrees table[] = {
    {IX_CRV_INFLECTION,
     2,
     {{2, -4}, {2, -3}, {2, -3}, {2, -3}},
     {{3, -6}, {3, -3}, {6, 0}, {6, 0}}},
    {IX_CRV_CRITICAL,
     2,
     {{4, -7}, {4, -6}, {12, -12}, {16, -16}},
     {{8, -12}, {9, -6}, {48, 0}, {64, 0}}},
    {IX_CRV_CURVATURE_SQR,
     2,
     {{6, -6}, {6, -6}, {6, -6}, {6, -6}},
     {{12, -12}, {12, -6}, {24, 0}, {24, 0}}},
    {IX_CRV_TORSION_ZERO,
     3,
     {{3, -9}, {3, -6}, {3, -6}, {3, -9}},
     {{4, -12}, {6, -6}, {14, 0}, {4, -12}}},
    {IX_CRV_TORSION,
     3,
     {{4, -8}, {4, -6}, {4, -6}, {4, -8}},
     {{6, -12}, {8, -6}, {26, 0}, {6, -12}}},
};

/* The bound that a value may deviate from derivatives by, relative to the
 * largest value: random curves come near cusps, where the curvature, a quotient
 * by |x'|^6, has few digits; the higher forms lose one more. */
static const double bounds[4] = {1e-9, 1e-9, 1e-8, 1e-8};

static void check_row(ix_ctx *ctx, ix_rng *r, const degrees *row, int d,
                      bool rational, int spans)
{
    crv_kind k = {d, row->ncoords, rational, spans, 0, 0};
    ix_mv *c = rand_crv(ctx, r, &k);

    for (int form = 0; form < 4; form++) {
        const int *f = rational ? row->rat[form] : row->poly[form];
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        ix_report rep;
        ix_mv *out;

        ASSERT_OK(ctx, ix_crv_field(ctx, c, row->kind, &o, &rep, &out));
        if (degree_of(out, 0) != at_least_0(f[0] * d + f[1]))
            fail_msg("field %d form %d degree %d rational %d: %d", row->kind,
                     form, d, rational, degree_of(out, 0));
        if (rep.residual > bounds[form])
            fail_msg("field %d form %d degree %d rational %d: residual %g",
                     row->kind, form, d, rational, rep.residual);
        ix_mv_unref(ctx, out);
    }
    ix_mv_unref(ctx, c);
}

/* Law: the degrees of the table, exactly; values as defined. */
static void degrees_and_values(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(71);

    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        for (int d = 2; d <= 5; d++)
            for (int rational = 0; rational < 2; rational++)
                if (d > 2 || table[i].ncoords == 2)
                    check_row(ctx, &r, &table[i], d, rational, d & 1 ? 3 : 0);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(degrees_and_values),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
