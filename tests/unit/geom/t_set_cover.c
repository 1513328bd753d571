/* t_set_cover.c - the cover covers, and no smaller choice does: compared with
 * trying all choices. */
#include "geom/set_cover.h"

#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"

enum { MAX_SETS = 9, MAX_RANGES = 24, SAMPLES = 64 };

/* Samples in the middle of the cells of a grid of 1/SAMPLES. */
static uint64_t samples_of(int n, const ix__range *r, unsigned sets)
{
    uint64_t m = 0;

    for (int i = 0; i < n; i++)
        for (int k = 0; k < SAMPLES; k++) {
            double x = (k + 0.5) / SAMPLES;

            if (sets >> r[i].set & 1 && r[i].lo < x && x < r[i].hi)
                m |= (uint64_t)1 << k;
        }
    return m;
}

static int bits(unsigned m)
{
    int n = 0;

    for (; m; m &= m - 1)
        n++;
    return n;
}

/* Law: same union, smallest number; single ranges and lists of ranges. */
static void test_smallest(void **state)
{
    ix_rng g = ix_rng_new(41);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int round = 0; round < 60; round++) {
        ix__range r[MAX_RANGES];
        char pick[MAX_SETS];
        int nsets = ix_rng_int(&g, 1, MAX_SETS), n = 0, least = MAX_SETS;
        int per = round % 2 ? 1 : 3, chosen = 0;
        unsigned mask = 0, all = (1u << nsets) - 1;
        uint64_t want;

        for (int s = 0; s < nsets; s++)
            for (int k = ix_rng_int(&g, 1, per); k > 0 && n < MAX_RANGES; k--) {
                int a = ix_rng_int(&g, 0, SAMPLES - 1);
                int b = ix_rng_int(&g, a + 1, SAMPLES);

                b = b > a + 20 ? a + 20 : b;
                r[n++] = (ix__range){(double)a / SAMPLES, (double)b / SAMPLES,
                                     s};
            }
        ASSERT_OK(ctx, ix__set_cover(ctx, n, r, nsets, 1e-6, pick));
        for (int s = 0; s < nsets; s++) {
            mask |= (unsigned)pick[s] << s;
            chosen += pick[s];
        }
        want = samples_of(n, r, all);
        assert_true(samples_of(n, r, mask) == want);
        for (unsigned m = 1; m <= all; m++)
            if (bits(m) < least && samples_of(n, r, m) == want)
                least = bits(m);
        assert_int_equal(chosen, least);
    }
    ix_ctx_free(ctx);
}

/* Gaps up to the tolerance are no gaps; reversed ranges cover nothing. */
static void test_tolerance(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix__range r[] = {
        {0, 0.5, 0}, {0.5005, 1, 1}, {0.4, 0.6, 2}, {0.9, 0.1, 3}};
    char pick[4];

    (void)state;
    ASSERT_OK(ctx, ix__set_cover(ctx, 4, r, 4, 1e-3, pick));
    assert_memory_equal(pick, "\1\1\0\0", 4);
    ASSERT_OK(ctx, ix__set_cover(ctx, 4, r, 4, 1e-6, pick));
    assert_memory_equal(pick, "\1\1\1\0", 4);
    ASSERT_OK(ctx, ix__set_cover(ctx, 0, r, 4, 1e-6, pick));
    assert_memory_equal(pick, "\0\0\0\0", 4);
    ix_ctx_free(ctx);
}

static void test_errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix__range r = {0, (double)NAN, 0};
    const ix__range some[] = {{0, 1, 0}, {2, 3, 0}, {0, 3, 1}, {3, 4, 2}};
    volatile int stop = 1;
    char pick[3];

    (void)state;
    assert_int_equal(ix__set_cover(ctx, 1, &r, 1, 1e-6, pick), IX_EARG);
    ix_ctx_set_cancel(ctx, &stop);
    assert_int_equal(ix__set_cover(ctx, 4, some, 3, 0, pick), IX_ECANCEL);
    ix_ctx_free(ctx);
}

static ix_status run_fault(ix_ctx *ctx, void *state)
{
    const ix__range r[] = {{0, 1, 0}, {2, 3, 0}, {0, 3, 1}, {3, 4, 2}};
    char pick[3];

    (void)state;
    return ix__set_cover(ctx, 4, r, 3, 0, pick);
}

static void test_memory(void **state)
{
    ix_fault_case c = {.run = run_fault};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_smallest),
        cmocka_unit_test(test_tolerance),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
