/* Linear maps with short rows: refinement, sampling, raising, application. */
#include <stdlib.h>
#include <string.h>

#include "bsp/basis.h"
#include "bsp/rows.h"
#include "bsp/weigh.h"
#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(12)

/* Law: applying a map is summing its rows, however long the inner rows are and
 * whether the points wrap or not. */
static void apply_is_the_sum(void **state)
{
    (void)state;
    for (int trial = 0; trial < 60; trial++) {
        int n = ix_rng_int(&rng, 1, 9), width = ix_rng_int(&rng, 1, 6);
        size_t outer = (size_t)ix_rng_int(&rng, 1, 3);
        size_t inner = (size_t)ix_rng_int(&rng, 1, 21);
        double in[3 * 9 * 21], out[3 * 5 * 21];
        ix_mark mk = ix__scratch_mark(ctx);
        ix_rows r;

        ASSERT_OK(ctx, ix__rows_alloc(ctx, 5, width, &r));
        r.affine = false;
        for (int i = 0; i < 5 * width; i++)
            r.w[i] = ix_rng_range(&rng, -1, 1);
        for (int i = 0; i < 5; i++)
            r.first[i] = ix_rng_int(&rng, 0, n - 1);
        ix__rows_weigh(&r);
        for (size_t i = 0; i < outer * (size_t)n * inner; i++)
            in[i] = ix_rng_range(&rng, -1, 1);
        ix__rows_apply(ctx, &r, n, outer, inner, in, out);
        for (size_t k = 0; k < outer * 5 * inner; k++) {
            size_t o = k / (5 * inner), i = k / inner % 5;
            double want = 0;

            for (int q = 0; q < width; q++)
                want += r.w[i * (size_t)width + (size_t)q] *
                        in[(o * (size_t)n + (size_t)((r.first[i] + q) % n)) *
                               inner +
                           k % inner];
            ASSERT_CLOSE(out[k], want, 2e-15);
        }
        ix__scratch_release(ctx, mk);
    }
}

/* Law: the sum of rows keeps a constant to the last bit. */
static void constants_stay(void **state)
{
    const double w[] = {0.1, 0.2, 0.3, 0.4}, c = 0.3;
    double in[4 * 19], out[19];

    (void)state;
    for (int i = 0; i < 4 * 19; i++)
        in[i] = c;
    for (size_t inner = 1; inner <= 19; inner++) {
        ix__weigh(inner, 4, w, in, in, out);
        for (size_t l = 0; l < inner; l++)
            assert_true(out[l] == c);
    }
}

/* Law: the weights of raising are those of the elevation formula, positive,
 * adding up to 1; also where binomials are huge. */
static void raising(void **state)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_rows r;

    (void)state;
    ASSERT_OK(ctx, ix__rows_raise(ctx, 2, 3, &r));
    ASSERT_CLOSE(r.w[3], 1 / 3.0, 1e-16);
    ASSERT_CLOSE(r.w[4], 2 / 3.0, 1e-16);
    assert_true(r.w[0] == 1 && r.w[5] == 0 && r.w[11] == 1);
    ASSERT_OK(ctx, ix__rows_raise(ctx, 500, 1000, &r));
    for (int j = 0; j <= 1000; j += 125) {
        double sum = 0, mean = 0;

        for (int i = 0; i <= 500; i++) {
            double w = r.w[j * 501 + i];

            assert_true(w >= 0);
            sum += w;
            mean += w * i;
        }
        ASSERT_CLOSE(sum, 1, 1e-14);
        ASSERT_CLOSE(mean, 0.5 * j, 1e-12);
    }
    ix__scratch_release(ctx, mk);
}

/* Law: rows of points that stay have a single 1; all rows are convex. */
static void refining(void **state)
{
    const double k[] = {0, 0, 0, 1, 2, 4, 4, 4};
    const double fine[] = {0, 0, 0, 1, 1, 2, 3, 4, 4, 4};
    const ix_dir dir = {IX_BSPLINE, 3, 5, false, k};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_rows r;

    (void)state;
    ASSERT_OK(ctx, ix__rows_refine(ctx, &dir, 7, fine, &r));
    for (int i = 0; i < 7; i++) {
        double sum = 0;
        int ones = 0;

        for (int q = 0; q < 3; q++) {
            assert_true(r.w[3 * i + q] >= 0);
            sum += r.w[3 * i + q];
            ones += r.w[3 * i + q] == 1;
        }
        ASSERT_CLOSE(sum, 1, 2e-16);
        assert_int_equal(ones, i == 0 || i == 1 || i == 3 || i == 6);
    }
    ix__scratch_release(ctx, mk);
}

/* The blossom of consecutive knots selects a point. */
static void blossom_of_knots(void **state)
{
    const double k[] = {0, 0, 0, 0, 1, 2, 2, 4, 5, 5, 5, 5};
    double w[4];

    (void)state;
    for (int mu = 3; mu < 8; mu++)
        for (int i = mu - 3; i <= mu && k[mu] < k[mu + 1]; i++) {
            ix__blossom_weights(k, mu, 3, k + i + 1, w);
            for (int q = 0; q < 4; q++)
                ASSERT_CLOSE(w[q], q == i - (mu - 3), 1e-15);
        }
}

/* Law: the bits do not depend on the number of threads. */
static void threads_do_not_matter(void **state)
{
    enum { N = 300, INNER = 400 };
    double *in = malloc(N * INNER * sizeof *in);
    double *one = malloc((N + 1) * INNER * sizeof *one);
    double *two = malloc((N + 1) * INNER * sizeof *two);
    ix_mark mk = ix__scratch_mark(ctx);
    ix_rows r;

    (void)state;
    assert_true(in && one && two);
    for (int i = 0; i < N * INNER; i++)
        in[i] = ix_rng_unit(&rng);
    ASSERT_OK(ctx, ix__rows_raise(ctx, N - 1, N, &r));
    ix_ctx_set_threads(ctx, 1);
    ix__rows_apply(ctx, &r, N, 1, INNER, in, one);
    ix_ctx_set_threads(ctx, 3);
    ix__rows_apply(ctx, &r, N, 1, INNER, in, two);
    ix_ctx_set_threads(ctx, 0);
    assert_memory_equal(one, two, (N + 1) * INNER * sizeof *one);
    ix__scratch_release(ctx, mk);
    free(in);
    free(one);
    free(two);
}

static ix_status make_rows(ix_ctx *c, void *state)
{
    const double t[] = {0.5, 0.2};
    const ix_dir dir = {IX_BEZIER, 4, 4, false, NULL};
    ix_mark mk = ix__scratch_mark(c);
    ix_status st;
    ix_rows r;

    (void)state;
    st = ix__rows_sample(c, &dir, 2, t, &r);
    if (st == IX_OK)
        st = ix__rows_raise(c, 3, 9, &r);
    ix__scratch_release(c, mk);
    return st;
}

static void out_of_memory(void **state)
{
    ix_rows r;

    (void)state;
    assert_true(ix_fault_run(&(ix_fault_case){.run = make_rows}) > 0);
    assert_int_equal(ix__rows_alloc(ctx, INT32_MAX, INT32_MAX, &r), IX_ENOMEM);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(apply_is_the_sum),
        cmocka_unit_test(constants_stay),
        cmocka_unit_test(raising),
        cmocka_unit_test(refining),
        cmocka_unit_test(blossom_of_knots),
        cmocka_unit_test(threads_do_not_matter),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
