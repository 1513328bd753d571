/* The arena: alignment, release by mark, and requests that cannot be met. */
#include <string.h>

#include "base/ctx.h"
#include "harness/fault.h"
#include "harness/test.h"

/* Law: blocks of any sizes are aligned, do not overlap, and keep what was
 * written until their mark is released. */
static void test_blocks(void **state)
{
    enum { N = 400 };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(5);
    unsigned char *p[N];
    size_t n[N];

    (void)state;
    for (int i = 0; i < N; i++) {
        n[i] = (size_t)ix_rng_int(&r, 0, i % 50 ? 700 : 200000);
        p[i] = ix__scratch(ctx, n[i], 1);
        assert_non_null(p[i]);
        assert_int_equal((uintptr_t)p[i] % 64, 0);
        memset(p[i], i, n[i]);
    }
    for (int i = 0; i < N; i++)
        for (size_t k = 0; k < n[i]; k++)
            if (p[i][k] != (unsigned char)i)
                fail_msg("block %d overwritten at %zu", i, k);
    ix_ctx_free(ctx);
}

static void test_marks(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mark outer, inner;
    double *a, *b, *zero;
    size_t live;

    (void)state;
    outer = ix__scratch_mark(ctx);
    a = ix__scratch(ctx, 10, sizeof *a);
    a[9] = 42;
    live = ctx->live;
    for (int i = 0; i < 3; i++) {
        inner = ix__scratch_mark(ctx);
        b = ix__scratch(ctx, 100000, sizeof *b); /* a chunk of its own */
        b[99999] = 1;
        zero = ix__scratch_zero(ctx, 1000, sizeof *zero);
        assert_true(zero[0] == 0 && zero[999] == 0);
        zero[0] = 1;
        ix__scratch_release(ctx, inner);
        assert_int_equal(ctx->live, live);
    }
    assert_true(a[9] == 42);
    ix__scratch_release(ctx, outer);
    ix__scratch_release(ctx, outer);
    ix_ctx_free(ctx);
}

static void test_impossible(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    assert_null(ix__scratch(ctx, SIZE_MAX, 8));
    assert_int_equal(ix_ctx_status(ctx), IX_ENOMEM);
    assert_null(ix__scratch(ctx, SIZE_MAX / 8, 8));
    assert_null(ix__scratch_zero(ctx, SIZE_MAX / 2, 2));
    assert_non_null(ix__scratch(ctx, 0, 8));
    ix_ctx_set_memory_limit(ctx, 1 << 20);
    assert_null(ix__scratch(ctx, 1 << 20, 1));
    assert_non_null(ix__scratch(ctx, 1 << 10, 1));
    ix_ctx_free(ctx);
}

static ix_status nested(ix_ctx *ctx, void *state)
{
    double *p;

    (void)state; /* none fits what the chunks before it, eightfold, leave */
    for (int n = 20000; n <= 2500000; n *= 5)
        IX_SCRATCH(ctx, p, n);
    return IX_OK;
}

static void test_out_of_memory(void **state)
{
    (void)state;
    assert_int_equal(ix_fault_run(&(ix_fault_case){.run = nested}), 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_blocks),
                                       cmocka_unit_test(test_marks),
                                       cmocka_unit_test(test_impossible),
                                       cmocka_unit_test(test_out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
