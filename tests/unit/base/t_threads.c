/* Sharing out work: every item exactly once, the same bits whatever the
 * number of threads, and no need for memory or threads to be available. */
#include <stdlib.h>
#include <string.h>

#include "base/threads.h"
#include "harness/fault.h"
#include "harness/test.h"

#define N 5000

typedef struct {
    int seen[N];
    double value[N];
} job;

static void work(void *arg, size_t begin, size_t end)
{
    job *j = arg;

    for (size_t i = begin; i < end; i++) {
        double s = 0;

        for (int k = 1; k < 20; k++)
            s += sin((double)i + 1.0 / k) / k;
        j->seen[i]++;
        j->value[i] = s;
    }
}

static void run(ix_ctx *ctx, size_t n, double item_ns, job *j)
{
    memset(j, 0, sizeof *j);
    ix__parallel(ctx, n, item_ns, work, j);
    for (size_t i = 0; i < N; i++)
        assert_int_equal(j->seen[i], i < n);
}

/* Law: sizes, costs and numbers of threads change nothing in the result. */
static void test_each_item_once(void **state)
{
    static const size_t sizes[] = {0, 1, 2, 3, 63, 64, 65, 1000, N};
    static const double costs[] = {0.001, 1, 1e3, 1e5, 1e9};
    static job one, many;

    (void)state;
    for (int threads = 0; threads <= 5; threads++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);

        ix_ctx_set_threads(ctx, 1);
        run(ctx, N, 1e3, &one);
        ix_ctx_set_threads(ctx, threads);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
            for (size_t k = 0; k < sizeof costs / sizeof *costs; k++) {
                run(ctx, sizes[i], costs[k], &many);
                assert_memory_equal(many.value, one.value,
                                    sizes[i] * sizeof *one.value);
            }
        ix_ctx_free(ctx);
        assert_true(one.seen[0] == 1);
    }
}

static void test_many_rounds(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    static job j;

    (void)state;
    ix_ctx_set_threads(ctx, 4);
    for (int i = 0; i < 300; i++)
        run(ctx, 10 + (size_t)i % 7, 1e5, &j);
    ix_ctx_set_threads(ctx, 64);
    run(ctx, N, 1e4, &j);
    ix_ctx_set_threads(ctx, 1);
    run(ctx, N, 1e4, &j);
    ix_ctx_free(ctx);
}

/* Without memory for the pool the caller does all of it. */
static void test_no_memory(void **state)
{
    ix_fault f = {.fail_at = -1};
    ix_ctx *ctx = ix_ctx_new(ix_fault_alloc, &f);
    static job j;

    (void)state;
    ix_ctx_set_threads(ctx, 4);
    f.fail_at = f.calls;
    run(ctx, N, 1e4, &j);
    ix_ctx_free(ctx);
    assert_int_equal(f.live, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_each_item_once),
                                       cmocka_unit_test(test_many_rounds),
                                       cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
