/* Text files: what is written reads back the same, for random objects and for
 * the sample files; every allocation may fail. */
#include <dirent.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/io.h"

#define DATA "tests/data/itd"

static const ix_write_opts exact = {.file = true};

static void write_text(ix_ctx *ctx, const ix_obj *o, ix_buf *b)
{
    ix__buf_init(b, ctx);
    ASSERT_OK(ctx, ix__itd_write(b, o, &exact, 0));
}

/* Law: reading what was written gives the same value, and writing that gives
 * the same text, so that names and attributes survive, too. */
static void check_round(ix_ctx *ctx, const ix_obj *o)
{
    ix_buf first, second;
    ix_obj *again;
    bool equal;

    write_text(ctx, o, &first);
    ASSERT_OK(ctx, ix__itd_read(ctx, "first", first.data, first.len, &again));
    write_text(ctx, again, &second);
    assert_string_equal(first.data, second.data);
    ASSERT_OK(ctx, ix__obj_equal(ctx, o, again, 0, &equal));
    if (!equal)
        fail_msg("not equal after reading:\n%.2000s", first.data);
    ix__obj_unref(ctx, again);
    ix__buf_free(&first);
    ix__buf_free(&second);
}

static void test_random(void **state)
{
    ix_rng r = ix_rng_new(0x17d);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 400; i++) {
        ix_obj *o = ix_rand_obj(ctx, &r, 3);

        assert_non_null(o);
        check_round(ctx, o);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* All types, so that none depends on the luck of test_random. */
static void test_each_type(void **state)
{
    ix_rng r = ix_rng_new(0x17e);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        for (int i = 0; i < 20; i++) {
            ix_obj *o = ix_rand_obj_of(ctx, &r, (ix_obj_type)t, 1);

            assert_non_null(o);
            check_round(ctx, o);
            ix__obj_unref(ctx, o);
        }
    }
    ix_ctx_free(ctx);
}

/* --- sample files ----------------------------------------------------- */

static bool is_text_file(const char *name)
{
    const char *dot = strrchr(name, '.');

    return dot && (strcmp(dot, ".itd") == 0 || strcmp(dot, ".imd") == 0);
}

/* Its rational surface was written with all weights 0: refused, with a
 * reason. */
static bool is_bad_sample(const char *name)
{
    return strstr(name, "sevolute-bil.itd") != NULL;
}

static void check_sample(ix_ctx *ctx, const char *name)
{
    char path[512];
    ix_obj *o;
    ix_status st;

    (void)snprintf(path, sizeof path, "%s/%s", DATA, name);
    st = ix__load(ctx, path, NULL, &o);
    if (is_bad_sample(name)) {
        assert_int_equal(st, IX_EPARSE);
        assert_non_null(strstr(ix_ctx_message(ctx), "weights are zero"));
        return;
    }
    if (st != IX_OK)
        fail_msg("%s", ix_ctx_message(ctx));
    check_round(ctx, o);
    ix__obj_unref(ctx, o);
}

static void test_samples(void **state)
{
    DIR *dir = opendir(DATA);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    struct dirent *e;
    int n = 0;

    (void)state;
    assert_non_null(dir);
    while ((e = readdir(dir)))
        if (is_text_file(e->d_name)) {
            check_sample(ctx, e->d_name);
            n++;
        }
    closedir(dir);
    assert_true(n > 50);
    ix_ctx_free(ctx);
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

/* --- memory ----------------------------------------------------------- */

typedef struct {
    ix_obj_type type;
    ix_obj *in, *out;
    ix_buf text;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(5 + (uint64_t)s->type);

    s->in = ix_rand_obj_of(ctx, &r, s->type, 2);
    s->out = NULL;
    assert_non_null(s->in);
    write_text(ctx, s->in, &s->text);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix__obj_unref(ctx, s->in);
    ix__obj_unref(ctx, s->out);
    ix__buf_free(&s->text);
}

static ix_status run_read(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_status st = ix__itd_read(ctx, "faults", s->text.data, s->text.len,
                                &s->out);

    assert_true((st == IX_OK) == (s->out != NULL));
    return st;
}

static ix_status run_write(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_buf b;
    ix_status st;

    ix__buf_init(&b, ctx);
    st = ix__itd_write(&b, s->in, &exact, 0);
    ix__buf_free(&b);
    return st;
}

static void test_faults(void **state)
{
    (void)state;
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        fault_state s = {.type = (ix_obj_type)t};
        ix_fault_case c = {fault_setup, run_read, fault_teardown, &s};

        assert_true(ix_fault_run(&c) > 0);
        c.run = run_write;
        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random), cmocka_unit_test(test_each_type),
        cmocka_unit_test(test_samples), cmocka_unit_test(test_layout),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
