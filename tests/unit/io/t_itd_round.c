/* Text files: what is written reads back the same, for random objects and for
 * the sample files; every allocation may fail. */
#include <string.h>

#include "harness/round.h"

#define DATA "tests/data/itd"

static const ix_write_opts exact = {.file = true};

static ix_status write_itd(ix_buf *b, const ix_obj *o)
{
    return ix__itd_write(b, o, &exact, 0);
}

static const ix_codec codec = {write_itd, ix__itd_read};

static void test_random(void **state)
{
    (void)state;
    ix_round_random(&codec);
}

static void test_each_type(void **state)
{
    (void)state;
    ix_round_each_type(&codec);
}

static void test_samples(void **state)
{
    (void)state;
    ix_round_samples(&codec);
}

static void test_faults(void **state)
{
    (void)state;
    ix_round_faults(&codec);
}

/* Files in the layout of the writer come out byte for byte: samples that were
 * made with 17 digits only where 17 are the shortest. */
static void test_layout(void **state)
{
    static const char *const names[] = {
        "02-surfaces", "03-trimsrf", "04-trivar",   "05-multivar",
        "06-trisrf",   "08-basics",  "09-instance", "10-model"};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[512];
        ix_buf text, out;
        ix_obj *o;

        (void)snprintf(path, sizeof path, "%s/spec-%s.itd", DATA, names[i]);
        ASSERT_OK(ctx, ix__file_read(ctx, path, &text));
        ASSERT_OK(ctx, ix__itd_read(ctx, path, text.data, text.len, &o));
        ix__buf_init(&out, ctx);
        if (o->type != IX_OBJ_LIST || o->name) {
            ASSERT_OK(ctx, ix__itd_write(&out, o, &exact, 0));
        } else { /* several objects in the file */
            for (int k = 0; k < o->u.list.n; k++)
                ASSERT_OK(ctx,
                          ix__itd_write(&out, o->u.list.item[k], &exact, 0));
        }
        assert_string_equal(text.data, out.data);
        ix__obj_unref(ctx, o);
        ix__buf_free(&text);
        ix__buf_free(&out);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random), cmocka_unit_test(test_each_type),
        cmocka_unit_test(test_samples), cmocka_unit_test(test_layout),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
