/* The systems that bench/b_mzero times have the solutions that they are said
 * to have. */
#include "harness/mzero_suite.h"
#include "harness/randmv.h"
#include "systest.h"

IX_TEST_FIXTURE(20261122)

static ix_mv *equation(const mzero_system *d, int i, double (*box)[2])
{
    ix_mv *m = st_mv(ctx, d->eq[i], d->n, box), *b;

    if (!d->knots)
        return m;
    ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
    ix_mv_unref(ctx, m);
    for (int j = 0; j < d->n; j++) {
        double kv[8];

        for (int k = 0; k < d->knots; k++)
            kv[k] = (k + 1.0) / (d->knots + 1);
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, b, j, d->knots, kv, &m));
        ix_mv_unref(ctx, b);
        b = m;
    }
    return b;
}

/* The larger one of the enclosures' edges, parts of the domain. */
static double widest(const ix_solutions *s)
{
    double w = 0;

    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < s->unknowns && s->sol[i].certified; j++)
            w = fmax(w, s->sol[i].hi[j] - s->sol[i].lo[j]);
    return w;
}

static void suite(void **state)
{
    long verified = 0;

    (void)state;
    for (int k = 0; k < MZERO_SYSTEMS; k++) {
        const mzero_system *d = &mzero_suite[k];
        ix_equation eq[3];
        double box[6][2];
        ix_solutions s;
        int certified;
        ix_mv *m[3];

        fill(box, d->lo, d->hi);
        for (int i = 0; i < d->n; i++) {
            m[i] = equation(d, i, box);
            eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
        }
        ASSERT_OK(ctx, ix_solve(ctx, d->n, eq, NULL, &s));
        certified = count_certified(&s);
        print_message("# %s %s: %zu boxes, %d certified in %g, %d open\n",
                      d->name, d->trait, s.boxes, certified, widest(&s),
                      s.n - certified);
        if (certified != d->regular || s.crowded != d->curve ||
            (!d->curve && s.n - certified != d->multiple))
            fail_msg("%s: expected %d regular, %d multiple", d->name,
                     d->regular, d->multiple);
        assert_true(widest(&s) <= 1e-12);
        verified += check_roots(d->name, d->n, d->n, d->eq, box, &s);
        check_complete(&rng, d->name, d->n, d->eq, box, &s, 100);
        ix_solutions_free(ctx, &s);
        for (int i = 0; i < d->n; i++)
            ix_mv_unref(ctx, m[i]);
    }
    print_message("# %ld solutions verified\n", verified);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(suite)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
