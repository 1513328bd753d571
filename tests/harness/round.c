/* round.c - what is written reads back the same. */
#include "harness/round.h"

#include <dirent.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"

#define DATA "tests/data/itd"

static void write_text(const ix_codec *codec, ix_ctx *ctx, const ix_obj *o,
                       ix_buf *b)
{
    ix__buf_init(b, ctx);
    ASSERT_OK(ctx, codec->write(b, o));
}

/* Law: reading what was written gives the same value, and writing that gives
 * the same text, so that names and attributes survive, too. */
void ix_round_check(const ix_codec *codec, ix_ctx *ctx, const ix_obj *o)
{
    ix_buf first, second;
    ix_obj *again;
    bool equal;

    write_text(codec, ctx, o, &first);
    ASSERT_OK(ctx, codec->read(ctx, "first", first.data, first.len, &again));
    write_text(codec, ctx, again, &second);
    if (first.len != second.len ||
        memcmp(first.data, second.data, first.len) != 0)
        fail_msg("written again:\n%.2000s\n%.2000s", first.data, second.data);
    ASSERT_OK(ctx, ix__obj_equal(ctx, o, again, 0, &equal));
    if (!equal)
        fail_msg("not equal after reading:\n%.2000s", first.data);
    ix__obj_unref(ctx, again);
    ix__buf_free(&first);
    ix__buf_free(&second);
}

void ix_round_random(const ix_codec *codec)
{
    ix_rng r = ix_rng_new(0x17d);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    for (int i = 0; i < 400; i++) {
        ix_obj *o = ix_rand_obj(ctx, &r, 3);

        assert_non_null(o);
        ix_round_check(codec, ctx, o);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* All types, so that none depends on the luck of test_random. */
void ix_round_each_type(const ix_codec *codec)
{
    ix_rng r = ix_rng_new(0x17e);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        for (int i = 0; i < 20; i++) {
            ix_obj *o = ix_rand_obj_of(ctx, &r, (ix_obj_type)t, 1);

            assert_non_null(o);
            ix_round_check(codec, ctx, o);
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

static void check_sample(const ix_codec *codec, ix_ctx *ctx, const char *name)
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
    ix_round_check(codec, ctx, o);
    ix__obj_unref(ctx, o);
}

void ix_round_samples(const ix_codec *codec)
{
    DIR *dir = opendir(DATA);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    struct dirent *e;
    int n = 0;

    assert_non_null(dir);
    while ((e = readdir(dir)))
        if (is_text_file(e->d_name)) {
            check_sample(codec, ctx, e->d_name);
            n++;
        }
    closedir(dir);
    assert_true(n > 50);
    ix_ctx_free(ctx);
}

/* --- memory ----------------------------------------------------------- */

typedef struct {
    const ix_codec *codec;
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
    write_text(s->codec, ctx, s->in, &s->text);
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
    ix_status st = s->codec->read(ctx, "faults", s->text.data, s->text.len,
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
    st = s->codec->write(&b, s->in);
    ix__buf_free(&b);
    return st;
}

void ix_round_faults(const ix_codec *codec)
{
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        fault_state s = {.codec = codec, .type = (ix_obj_type)t};
        ix_fault_case c = {fault_setup, run_read, fault_teardown, &s};

        assert_true(ix_fault_run(&c) > 0);
        c.run = run_write;
        assert_true(ix_fault_run(&c) > 0);
    }
}
