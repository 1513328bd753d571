/* Sign changes of polynomials with known zeros. */
#include <stdlib.h>

#include "bern/bern.h"
#include "harness/test.h"

enum { MOST = 12 };

/* Bernstein coefficients of the product of (u - root) over n roots. */
static void from_roots(int n, const double *root, double *b)
{
    double c[MOST + 1] = {1}, next[MOST + 1], work[64];

    for (int d = 0; d < n; d++) {
        double line[2] = {-root[d], 1 - root[d]};

        ix__bern_conv_spans(1, d, c, 1, line, IX__SET, work, next);
        for (int i = 0; i <= d + 1; i++)
            c[i] = next[i];
    }
    ix__bern_unscale(1, n, 1, ix__binom(n, NULL), c, b);
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Law: separated simple zeros inside (0, 1) are all found, in order. Zeros at
 * distance 0.04 of degree up to 12: condition below 1e9. */
static void simple_zeros(void **state)
{
    ix_rng r = ix_rng_new(91);

    (void)state;
    for (int round = 0; round < 100; round++) {
        int n = ix_rng_int(&r, 1, MOST), inside = 0, m;
        double root[MOST], b[MOST + 1], work[2 * MOST + 2], got[MOST];

        for (int i = 0; i < n; i++)
            root[i] = -0.4 + 1.8 * (i + ix_rng_range(&r, 0.2, 0.8)) / n;
        from_roots(n, root, b);
        m = ix__bern_crossings(n, b, 1e-16, work, got);
        qsort(root, (size_t)n, sizeof *root, by_value);
        for (int i = 0; i < n; i++)
            if (root[i] > 0 && root[i] < 1) {
                assert_true(inside < m);
                ASSERT_CLOSE(got[inside], root[i], 1e-7);
                inside++;
            }
        assert_int_equal(m, inside);
    }
}

/* Double zeros are no crossings, triple ones are; a zero in the middle of the
 * first halving is found; zeros at the ends and vanishing stretches are not. */
static void special_zeros(void **state)
{
    static const struct {
        int n;
        double root[4];
        int crossings;
        double at;
    } cases[] = {{2, {0.3, 0.3}, 0, 0},      {3, {0.4, 0.4, 0.4}, 1, 0.4},
                 {1, {0.5}, 1, 0.5},         {3, {0.5, 0.25, 0.25}, 1, 0.5},
                 {2, {0, 1}, 0, 0},          {3, {0, 1, 0.75}, 1, 0.75},
                 {4, {0, 0.5, 0.5, 1}, 0, 0}};
    const double zeros[4] = {0, 1e-17, -1e-17, 0};
    double b[5], work[10], got[4];

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int m;

        from_roots(cases[i].n, cases[i].root, b);
        m = ix__bern_crossings(cases[i].n, b, 1e-15, work, got);
        assert_int_equal(m, cases[i].crossings);
        if (m)
            ASSERT_CLOSE(got[0], cases[i].at, 1e-5); /* cube root of 1e-15 */
    }
    assert_int_equal(ix__bern_crossings(3, zeros, 1e-16, work, got), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(simple_zeros),
        cmocka_unit_test(special_zeros),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
