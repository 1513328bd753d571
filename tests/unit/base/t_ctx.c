/* The context: messages, remarks, the memory limit, cancellation, and that
 * every byte passes through its allocator. */
#include <string.h>

#include "base/ctx.h"
#include "harness/fault.h"
#include "harness/test.h"

static void test_messages(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char longer[2000];

    (void)state;
    assert_string_equal(ix_ctx_message(ctx), "");
    assert_int_equal(ix_ctx_status(ctx), IX_OK);
    assert_int_equal(IX_FAIL(ctx, IX_EDOMAIN, "order %d", 7), IX_EDOMAIN);
    assert_string_equal(ix_ctx_message(ctx), "order 7");
    assert_int_equal(ix_ctx_status(ctx), IX_EDOMAIN);
    memset(longer, 'x', sizeof longer - 1);
    longer[sizeof longer - 1] = '\0';
    (void)IX_FAIL(ctx, IX_EARG, "%s", longer);
    assert_true(strlen(ix_ctx_message(ctx)) < sizeof ctx->msg);
    ix_ctx_free(ctx);
    ix_ctx_free(NULL);
}

static void test_names(void **state)
{
    (void)state;
    assert_string_equal(ix_status_name(IX_OK), "ok");
    assert_string_equal(ix_status_name(IX_ECANCEL), "interrupted");
    assert_string_equal(ix_status_name((ix_status)99), "?");
    assert_true(ix_version()[0] >= '0' && ix_version()[0] <= '9');
}

static void keep_note(void *ud, const char *text)
{
    strcpy(ud, text);
}

static void test_notes(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char seen[512] = "";

    (void)state;
    ix__note(ctx, "dropped");
    ix_ctx_set_note(ctx, keep_note, seen);
    ix__note(ctx, "%d weights change sign", 3);
    assert_string_equal(seen, "3 weights change sign");
    ix_ctx_free(ctx);
}

/* At the limit an allocation succeeds, one byte beyond it fails and leaves
 * what was there; freeing makes room again. */
static void test_memory_limit(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char *p, *q;

    (void)state;
    ix_ctx_set_memory_limit(ctx, 1000);
    p = ix__alloc(ctx, 600);
    assert_non_null(p);
    q = ix__alloc(ctx, 400);
    assert_non_null(q);
    assert_null(ix__alloc(ctx, 1));
    assert_int_equal(ix_ctx_status(ctx), IX_ENOMEM);
    memset(p, 'p', 600);
    assert_null(ix__realloc(ctx, p, 600, 601));
    assert_int_equal(p[599], 'p');
    ix__free(ctx, q, 400);
    assert_null(ix__alloc(ctx, SIZE_MAX)); /* no wrap-around */
    q = ix__alloc(ctx, 300);
    assert_non_null(q);
    ix__free(ctx, q, 300);
    ix__free(ctx, p, 600);
    ix__free(ctx, NULL, 123);
    assert_int_equal(ctx->live, 0);
    ix_ctx_free(ctx);
}

static void test_cancel(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    volatile int flag = 0;

    (void)state;
    ASSERT_OK(ctx, ix__poll(ctx));
    ix_ctx_set_cancel(ctx, &flag);
    ASSERT_OK(ctx, ix__poll(ctx));
    flag = 1;
    assert_int_equal(ix__poll(ctx), IX_ECANCEL);
    assert_string_equal(ix_ctx_message(ctx), "interrupted");
    ix_ctx_set_cancel(ctx, NULL);
    ASSERT_OK(ctx, ix__poll(ctx));
    ix_ctx_free(ctx);
}

typedef struct {
    int told, cleared;
    char what[16];
    double part;
} watcher;

static void watch(void *ud, const char *what, double part)
{
    watcher *w = ud;

    if (!what) {
        w->cleared++;
        return;
    }
    w->told++;
    w->part = part;
    (void)snprintf(w->what, sizeof w->what, "%s", what);
}

/* A watcher is told what goes on, and not at every poll. */
static void test_progress(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    watcher w = {0};

    (void)state;
    ix_ctx_set_progress(ctx, watch, &w);
    ix__progress(ctx, "ROOTS", 0.5);
    ix__progress_clear(ctx); /* nothing was shown */
    assert_int_equal(w.cleared, 0);
    for (int i = 0; i < 1000; i++)
        ASSERT_OK(ctx, ix__poll(ctx));
    assert_in_range(w.told, 1, 10); /* ten a second */
    assert_string_equal(w.what, "ROOTS");
    assert_true(w.part == 0.5);
    ix_ctx_set_progress(ctx, NULL, NULL);
    assert_int_equal(w.cleared, 1);
    ASSERT_OK(ctx, ix__poll(ctx));
    ix_ctx_free(ctx);
}

static void test_strings(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char *s = ix__strdup(ctx, "abc");

    (void)state;
    assert_string_equal(s, "abc");
    assert_int_equal(ctx->live, 4);
    ix__strfree(ctx, s);
    ix__strfree(ctx, NULL);
    assert_int_equal(ctx->live, 0);
    ix_ctx_free(ctx);
}

static ix_status use_memory(ix_ctx *ctx, void *state)
{
    char **s = state;
    double *t;

    IX_SCRATCH(ctx, t, 100);
    t[99] = 1;
    *s = ix__strdup(ctx, "kept");
    return *s ? IX_OK : IX_ENOMEM;
}

static void release(ix_ctx *ctx, void *state)
{
    char **s = state;

    ix__strfree(ctx, *s);
    *s = NULL;
}

static void test_out_of_memory(void **state)
{
    char *s = NULL;
    ix_fault f = {.fail_at = 0};
    long n = ix_fault_run(
        &(ix_fault_case){.run = use_memory, .teardown = release, .state = &s});

    (void)state;
    assert_int_equal(n, 2); /* the arena's chunk and the copy */
    assert_null(ix_ctx_new(ix_fault_alloc, &f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_messages), cmocka_unit_test(test_names),
        cmocka_unit_test(test_notes),    cmocka_unit_test(test_cancel),
        cmocka_unit_test(test_progress), cmocka_unit_test(test_memory_limit),
        cmocka_unit_test(test_strings),  cmocka_unit_test(test_out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
