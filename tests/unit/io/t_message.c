/* t_message.c - where messages end. Law: cut a stream in any pieces, the same
 * messages come out of it; and any bytes at all leave the next request whole.
 */
#include "io/message.h"

#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"

#define REQUEST                                                            \
    "[OBJECT NONE\n[OBJECT NONE\n[STRING \"IRITX/1\"]\n]\n[OBJECT X_SEQ\n" \
    "[NUMBER 42]\n]\n[OBJECT OP\n[STRING \"PING\"]\n]\n[OBJECT ARGS\n]\n]\n"

/* Feeds all of s in pieces; what the messages are, one a line, as they are
 * written again; "!" for one that cannot be read. */
static void feed(ix__message *m, const char *s, size_t n, size_t piece,
                 ix_buf *out)
{
    const ix_write_opts peer = {.file = true, .peer = true};
    ix_ctx *ctx = out->ctx;

    for (size_t at = 0, used; at < n; at += used) {
        bool complete;
        ix_obj *o;

        ASSERT_OK(ctx,
                  ix__message_feed(m, s + at, piece < n - at ? piece : n - at,
                                   &used, &complete));
        assert_true(used > 0);
        if (!complete)
            continue;
        if (ix__message_object(m, &o) == IX_OK)
            ASSERT_OK(ctx, ix__itd_write(out, o, &peer, 0));
        else
            ix__buf_puts(out, "!");
        ix__obj_unref(ctx, o);
        ix__message_clear(m);
    }
}

static void becomes(const char *stream, const char *wanted)
{
    static const size_t pieces[] = {1, 2, 7, 1000};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    for (size_t i = 0; i < sizeof pieces / sizeof *pieces; i++) {
        ix__message m;
        ix_buf out;

        ix__message_init(&m, ctx);
        ix__buf_init(&out, ctx);
        feed(&m, stream, strlen(stream), pieces[i], &out);
        assert_string_equal(out.data ? out.data : "", wanted);
        ix__buf_free(&out);
        ix__message_free(&m);
    }
    ix_ctx_free(ctx);
}

#define NUM(x)  "[OBJECT NONE\n[NUMBER " x "]\n]\n"
#define STR(s)  "[OBJECT NONE\n[STRING \"" s "\"]\n]\n"
#define EMPTY   "[OBJECT NONE\n[OBJECT NONE\n]\n]\n"
#define LIST(x) "[OBJECT NONE\n" x "]\n"

static void test_messages(void **state)
{
    (void)state;
    becomes("", "");
    becomes("junk ]]] \" \n", "");
    becomes("[OBJECT A\n[NUMBER 5]\n]\n", NUM("5"));
    becomes("junk [OBJECT A [NUMBER 5]]x[OBJECT B [NUMBER 6] ]",
            NUM("5") NUM("6"));
    becomes("[OBJECT A\n]\n", EMPTY);
    becomes("[OBJECT A\n[OBJECT B\n]\n[OBJECT C\n[NUMBER 1]\n]\n]\n",
            LIST(EMPTY NUM("1")));
    becomes("[OBJECT A\n[NUMBER nan]\n]\n", "!");
    becomes("[OBJECT A\n[NUMBER       -inf]\n]\n", "!");
}

/* IRIT does not escape what stands in a string. */
static void test_strings(void **state)
{
    (void)state;
    becomes("[OBJECT A\n[STRING \"a\"b\"]\n]\n", STR("a\\\"b"));
    becomes("[OBJECT A\n[STRING \"]\"]\"]\n]\n", STR("]\\\"]"));
    becomes("[OBJECT A\n  [STRING \"\\\"]\n]\n", STR("\\\\"));
    becomes("[OBJECT A\n[STRING \"[[[\"] \n]\n", STR("[[["));
    becomes("[OBJECT A\n[STRING \"\"]\n]\n", STR(""));
    becomes("[OBJECT A\n[STRING \"two\nlines\"]\n]\n", STR("two lines"));
    becomes("[OBJECT A\n[STRING \"x\"]]\n[OBJECT B\n[NUMBER 1]\n]\n",
            STR("x") NUM("1"));
    /* of attributes it does escape quotes, and brackets there do not count */
    becomes("[OBJECT [a \"[\\\"[\"] A\n[NUMBER 1]\n]\n",
            "[OBJECT [a \"[\\\"[\"] NONE\n[NUMBER 1]\n]\n");
}

/* What a peer that begins anew has left half done makes place. */
static void test_restart(void **state)
{
    static const char whole[] = REQUEST;
    char wanted[1000] = "", stream[1000];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix__message m;
    ix_buf out;

    (void)state;
    ix__message_init(&m, ctx);
    ix__buf_init(&out, ctx);
    feed(&m, whole, strlen(whole), 100, &out);
    (void)strcpy(wanted, out.data);
    ix__buf_free(&out);
    ix__message_free(&m);
    ix_ctx_free(ctx);
    /* after the head's third line the first half is a request of its own */
    for (size_t cut = 0; cut < strlen(whole) - 2; cut++) {
        memcpy(stream, whole, cut);
        (void)strcpy(stream + cut, whole);
        becomes(stream, wanted);
        stream[cut] = '\n';
        (void)strcpy(stream + cut + 1, whole);
        becomes(stream, wanted);
    }
}

static void test_head(void **state)
{
    static const struct {
        const char *text;
        bool request;
        double seq;
    } cases[] = {
        {REQUEST, true, 42},
        {"[OBJECT A\n[OBJECT B\n[STRING \"IRITX/1\"]\n]\n[OBJECT C\n"
         "[NUMBER x]\n]\n]\n",
         true, 0},
        {"[OBJECT A\n[OBJECT B\n[STRING \"IRITX/1\"]\n]\n]\n", true, 0},
        {"[OBJECT A\n[OBJECT B\n[STRING \"IRITX/12\"]\n]\n]\n", false, 0},
        {"[OBJECT A\n[OBJECT B\n[NUMBER 1]\n]\n[OBJECT C\n"
         "[STRING \"IRITX/1\"]\n]\n]\n",
         false, 0},
        {"[OBJECT A\n[NUMBER 1]\n]\n", false, 0}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ix__message m;
        bool complete;
        size_t used;
        double seq;

        ix__message_init(&m, ctx);
        ASSERT_OK(ctx,
                  ix__message_feed(&m, cases[i].text, strlen(cases[i].text),
                                   &used, &complete));
        assert_true(complete);
        assert_int_equal(ix__message_is_request(&m, &seq), cases[i].request);
        assert_true(seq == cases[i].seq);
        ix__message_free(&m);
    }
    ix_ctx_free(ctx);
}

/* Damage of all kinds, then a sound request: it is the last message. */
static void test_damage(void **state)
{
    static const char bytes[] = "[]\"\\\n O1N";
    ix_rng rng = ix_rng_new(11);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix__message m;

    (void)state;
    ix__message_init(&m, ctx);
    for (int round = 0; round < 20000; round++) {
        char s[sizeof REQUEST], last[400] = "";
        size_t n = sizeof s - 1;
        ix_buf out;

        memcpy(s, REQUEST, sizeof s);
        for (int k = ix_rng_int(&rng, 1, 6); k > 0; k--)
            s[ix_rng_int(&rng, 0, (int)n - 1)] =
                bytes[ix_rng_int(&rng, 0, (int)sizeof bytes - 2)];
        if (ix_rng_int(&rng, 0, 1))
            n = (size_t)ix_rng_int(&rng, 1, (int)n);
        ix__buf_init(&out, ctx);
        feed(&m, s, n, 64, &out);
        ix__buf_clear(&out);
        feed(&m, REQUEST, sizeof REQUEST - 1, 64, &out);
        if (out.data)
            (void)snprintf(last, sizeof last, "%s", out.data);
        if (!strstr(last, "[NUMBER 42]") || m.depth != 0)
            fail_msg("lost after %.*s: %s", (int)n, s, last);
        ix__buf_free(&out);
    }
    ix__message_free(&m);
    ix_ctx_free(ctx);
}

/* --- what IRIT's end gets --------------------------------------------------
 */

static void refused(ix_ctx *ctx, const char *s, size_t n, const char *message)
{
    const ix_write_opts peer = {.file = true, .peer = true};
    ix_obj *o = ix__obj_string(ctx, s, n);
    ix_buf out;

    assert_non_null(o);
    ix__buf_init(&out, ctx);
    assert_true(ix__itd_write(&out, o, &peer, 0) != IX_OK);
    assert_non_null(strstr(ix_ctx_message(ctx), message));
    ix__buf_free(&out);
    ix__obj_unref(ctx, o);
}

static void test_peer_strings(void **state)
{
    static char text[5000];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    memset(text, 'x', sizeof text);
    refused(ctx, text, sizeof text, "IRIT reads less");
    refused(ctx, "a\xff", 2, "0xff");
    refused(ctx, "a\001", 2, "control byte");
    ix_ctx_free(ctx);
}

/* --- out of memory ----------------------------------------------------------
 */

typedef struct {
    ix__message m;
    ix_obj *o;
} message_state;

static void setup(ix_ctx *ctx, void *state)
{
    message_state *s = state;

    ix__message_init(&s->m, ctx);
    s->o = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    static const char text[] = "[OBJECT A\n[STRING \"a\"b\"]\n]\n";
    message_state *s = state;
    bool complete;
    size_t used;

    (void)ctx;
    IX_TRY(ix__message_feed(&s->m, text, sizeof text - 1, &used, &complete));
    assert_true(complete);
    return ix__message_object(&s->m, &s->o);
}

static void teardown(ix_ctx *ctx, void *state)
{
    message_state *s = state;

    ix__obj_unref(ctx, s->o);
    ix__message_free(&s->m);
}

static void test_no_memory(void **state)
{
    message_state s;
    ix_fault_case c = {setup, run, teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_messages),  cmocka_unit_test(test_strings),
        cmocka_unit_test(test_restart),   cmocka_unit_test(test_head),
        cmocka_unit_test(test_damage),    cmocka_unit_test(test_peer_strings),
        cmocka_unit_test(test_no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
