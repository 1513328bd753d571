/* Basis values and derivatives of a window. */
#include "bsp/basis.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(77)

/* Law: all derivatives at once are those taken one by one, bit for bit; also
 * beyond the degree, and outside of the window's span. */
static void all_at_once(void **state)
{
    const ix_rand_opts o = {
        .ndirs = 1, .kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_FLOAT};

    (void)state;
    for (int n = 0; n < 200; n++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        ix_dir d = ix_mv_dir(m, 0);
        double t, all[5 * 8], one[8];
        int k = ix_rng_int(&rng, 0, 4), first;

        ix_mv_randparam(&rng, m, &t);
        first = ix__basis_first(&d, t);
        t += ix_rng_range(&rng, -0.5, 0.5);
        ix__basis_derivs(&d, first, t, k, all);
        for (int i = 0; i <= k; i++) {
            ix__basis_derive(&d, first, t, i, one);
            for (int q = 0; q < d.order; q++)
                assert_true(all[i * d.order + q] == one[q]);
        }
        ix_mv_unref(ctx, m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_at_once),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
