/* The byte string: appends, growth, and that a failure sticks and harms
 * nothing that was there. */
#include <string.h>

#include "base/buf.h"
#include "harness/fault.h"
#include "harness/test.h"

static void test_appends(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    ix__buf_puts(&b, "ab");
    ix__buf_putc(&b, '-');
    ix__buf_fill(&b, 'z', 3);
    ix__buf_num(&b, -0.1);
    ix__buf_int(&b, -123456789012LL);
    ix__buf_printf(&b, "<%s %d>", "x", 5);
    ix__buf_add(&b, "\0tail", 5);
    ASSERT_OK(ctx, ix__buf_check(&b));
    assert_int_equal(b.len, 2 + 1 + 3 + 4 + 13 + 5 + 5);
    assert_memory_equal(b.data, "ab-zzz-0.1-123456789012<x 5>\0tail",
                        b.len + 1);
    ix__buf_clear(&b);
    assert_int_equal(b.len, 0);
    assert_string_equal(b.data, "");
    ix__buf_free(&b);
    ix__buf_free(&b);
    assert_int_equal(ctx->live, 0);
    ix_ctx_free(ctx);
}

/* Law: a buffer filled in any pieces holds their concatenation. */
static void test_growth(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(99);
    size_t n = 0;
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    for (int i = 0; i < 2000; i++) {
        size_t k = (size_t)ix_rng_int(&r, 0, 300);

        ix__buf_fill(&b, (char)('a' + i % 26), k);
        n += k;
        assert_int_equal(b.len, n);
        assert_true(k == 0 || b.data[n - 1] == 'a' + i % 26);
        assert_true(!b.data || b.data[n] == '\0');
    }
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

static void test_failure_sticks(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    ix__buf_puts(&b, "kept");
    ix__buf_fill(&b, 'x', SIZE_MAX);
    ix__buf_puts(&b, "not appended");
    assert_string_equal(b.data, "kept");
    assert_int_equal(ix__buf_check(&b), IX_ENOMEM);
    ix__buf_clear(&b);
    ix__buf_fill(&b, 'x', SIZE_MAX - 2);
    assert_int_equal(ix__buf_check(&b), IX_ENOMEM);
    ix__buf_clear(&b);
    ix__buf_puts(&b, "again");
    ASSERT_OK(ctx, ix__buf_check(&b));
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

static ix_status write_text(ix_ctx *ctx, void *state)
{
    ix_buf b;
    ix_status st;

    (void)state;
    ix__buf_init(&b, ctx);
    for (int i = 0; i < 400; i++)
        ix__buf_printf(&b, "%d ", i);
    ix__buf_num(&b, 1.5);
    st = ix__buf_check(&b);
    ix__buf_free(&b);
    return st;
}

static void test_out_of_memory(void **state)
{
    (void)state;
    assert_true(ix_fault_run(&(ix_fault_case){.run = write_text}) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_appends),
                                       cmocka_unit_test(test_growth),
                                       cmocka_unit_test(test_failure_sticks),
                                       cmocka_unit_test(test_out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
