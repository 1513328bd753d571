/* Binary files: what is written reads back the same; damaged, cut or reversed
 * data are a message or an object, never more; every allocation may fail. */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/round.h"
#include "io/ibd.h"

static ix_status write_ibd(ix_buf *b, const ix_obj *o)
{
    return ix__ibd_write(b, o, NULL);
}

static ix_status read_ibd(ix_ctx *ctx, const char *name, const char *data,
                          size_t n, ix_obj **out)
{
    ix__input *s;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__input_memory(ctx, name, data, n, 0, &s));
    st = ix__ibd_read_from(s, out);
    ix__input_close(s);
    return st;
}

static const ix_codec codec = {write_ibd, read_ibd};

/* --- random objects ---------------------------------------------------- */

static void on_note(void *ud, const char *text)
{
    (void)text;
    *(bool *)ud = true;
}

/* The same value, unless the writer said that it left something out. */
static void round_trip(ix_ctx *ctx, const ix_obj *o, const bool *lost)
{
    ix_buf b;
    ix_obj *again;
    bool equal = true;

    ix__buf_init(&b, ctx);
    if (write_ibd(&b, o) == IX_OK) {
        ASSERT_OK(ctx, read_ibd(ctx, "b", b.data, b.len, &again));
        if (!*lost)
            ASSERT_OK(ctx, ix__obj_equal(ctx, o, again, 0, &equal));
        if (!equal)
            fail_msg("not equal after reading: type %d", (int)o->type);
        ix_round_check(&codec, ctx, again);
        ix__obj_unref(ctx, again);
    } else {
        assert_non_null(strstr(ix_ctx_message(ctx), "one kind"));
    }
    ix__buf_free(&b);
}

static void test_random(void **state)
{
    ix_rng r = ix_rng_new(0x1bd);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    bool lost;

    (void)state;
    ix_ctx_set_note(ctx, on_note, &lost);
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        for (int i = 0; i < 20; i++) {
            ix_obj *o = ix_rand_obj_of(ctx, &r, (ix_obj_type)t, 3);

            assert_non_null(o);
            lost = false;
            round_trip(ctx, o, &lost);
            ix__obj_unref(ctx, o);
        }
    }
    ix_ctx_free(ctx);
}

static void test_samples(void **state)
{
    (void)state;
    ix_round_samples(&codec);
}

/* --- damage ------------------------------------------------------------ */

/* A list with something of each kind that a text of LINES makes. */
static ix_obj *a_bit_of_all(ix_ctx *ctx)
{
    static const char text[] =
        "[OBJECT [RGB \"1,2,3\"] [n 7] [x 0.5] [o [OBJECT I [NUMBER 1]]] ALL\n"
        "[OBJECT A [NUMBER 3]] [OBJECT B [STRING \"text\"]]\n"
        "[OBJECT C [CURVE BSPLINE 3 2 P2 [KV 0 0 1 2 2]"
        " [1 0 0] [1 1 1] [2 4 2]]]\n"
        "[OBJECT S [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 1]]]\n"
        "[OBJECT P [POLYGON 3 [0 0 0] [[INTERNAL] [k 1] 1 0 0] [0 1 0]]]\n"
        "[OBJECT M [MULTIVAR BSPLINE 1 5 3 E1 [KVP 0 1 2 3 4 5 6 7 8 9]"
        " [1] [2] [3] [4] [5]]]\n"
        "[OBJECT T [TRIMSRF [SURFACE BEZIER 2 2 E3"
        " [0 0 0] [1 0 0] [0 1 0] [1 1 1]]"
        " [TRIMCRV [TRIMCRVSEG [CURVE BEZIER 2 E2 [0 0] [1 1]]]]]]\n"
        "[OBJECT V [CTLPT P2 1 2 3]] [OBJECT L [OBJECT NONE [POINT 1 2 3]]]]";
    ix_obj *o;

    ASSERT_OK(ctx, ix__itd_read(ctx, "t", text, sizeof text - 1, &o));
    return o;
}

static void expect_orderly(ix_ctx *ctx, const ix_buf *b, size_t n)
{
    ix_obj *o;
    ix_status st = read_ibd(ctx, "damaged", b->data, n, &o);

    if (st == IX_OK) {
        ix__obj_unref(ctx, o);
        return;
    }
    assert_null(o);
    assert_true(st == IX_EPARSE || st == IX_ENOMEM);
    assert_int_equal(strncmp(ix_ctx_message(ctx), "damaged: ", 9), 0);
}

static void test_damage(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = a_bit_of_all(ctx);
    ix_rng r = ix_rng_new(3);
    ix_buf b;

    (void)state;
    ix_ctx_set_memory_limit(ctx, 1 << 26);
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, write_ibd(&b, o));
    for (size_t n = 0; n < b.len; n += 3) /* cut off there */
        expect_orderly(ctx, &b, n);
    for (int i = 0; i < 4000; i++) { /* a byte changed, for a moment */
        char *p = b.data + ix_rng_int(&r, 0, (int)b.len - 1), was = *p;

        *p = (char)ix_rng_int(&r, 0, 255);
        expect_orderly(ctx, &b, b.len);
        *p = was;
    }
    expect_orderly(ctx, &b, b.len);
    ix__buf_free(&b);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

static void expect_refused(ix_ctx *ctx, const char *data, size_t n,
                           const char *message)
{
    ix_obj *o;

    assert_int_equal(read_ibd(ctx, "f", data, n, &o), IX_EPARSE);
    if (!strstr(ix_ctx_message(ctx), message))
        fail_msg("\"%s\" expected, got \"%s\"", message, ix_ctx_message(ctx));
}

static void test_messages(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_undef(ctx);
    ix_buf b;

    (void)state;
    expect_refused(ctx, "", 0, "f: byte 0: no object");
    expect_refused(ctx, "[OBJECT A", 9, "f: byte 4: no record begins here");
    expect_refused(ctx, "\x02\x60\x16\x43", 4, "other word sizes");
    expect_refused(ctx, "\x02\x80\x16\x43....", 8, "the data end within");
    expect_refused(ctx, "\xc8\x80\x16\x43", 4, "where an object is due");
    ix__buf_init(&b, ctx);
    assert_int_equal(write_ibd(&b, o), IX_EUNABLE);
    ix__obj_unref(ctx, o);
    o = ix__obj_number(ctx, NAN);
    assert_int_equal(write_ibd(&b, o), IX_EDOMAIN);
    ix__obj_unref(ctx, o);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

/* --- byte order --------------------------------------------------------- */

static void reverse(char *p, size_t n)
{
    for (size_t i = 0; i < n / 2; i++) {
        char c = p[i];

        p[i] = p[n - 1 - i];
        p[n - 1 - i] = c;
    }
}

/* A number as a machine of the other byte order writes it: sync words, the
 * type and the value of the block, the length of the name turned round. */
static void test_other_order(void **state)
{
    static const size_t words[] = {0, 4 + 32, 276, 280, 292};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 0.1), *again;
    bool equal;
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, write_ibd(&b, o));
    assert_int_equal(b.len, 296); /* spec/ipc 5 */
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        reverse(b.data + words[i], 4);
    reverse(b.data + 4 + 88, 8);
    ASSERT_OK(ctx, read_ibd(ctx, "b", b.data, b.len, &again));
    ASSERT_OK(ctx, ix__obj_equal(ctx, o, again, 0, &equal));
    assert_true(equal);
    ix__obj_unref(ctx, again);
    ix__obj_unref(ctx, o);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

/* --- memory ------------------------------------------------------------- */

typedef struct {
    ix_obj *in, *out;
    ix_buf data;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    s->in = a_bit_of_all(ctx);
    s->out = NULL;
    ix__buf_init(&s->data, ctx);
    ASSERT_OK(ctx, write_ibd(&s->data, s->in));
}

static ix_status fault_read(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    return read_ibd(ctx, "f", s->data.data, s->data.len, &s->out);
}

static ix_status fault_write(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_buf b;
    ix_status st;

    ix__buf_init(&b, ctx);
    st = write_ibd(&b, s->in);
    ix__buf_free(&b);
    return st;
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix__obj_unref(ctx, s->in);
    ix__obj_unref(ctx, s->out);
    ix__buf_free(&s->data);
}

static void test_faults(void **state)
{
    fault_state s;
    ix_fault_case c = {fault_setup, fault_read, fault_teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
    c.run = fault_write;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),      cmocka_unit_test(test_samples),
        cmocka_unit_test(test_damage),      cmocka_unit_test(test_messages),
        cmocka_unit_test(test_other_order), cmocka_unit_test(test_faults),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
