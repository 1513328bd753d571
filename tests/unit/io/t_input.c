/* Texts that come in pieces: whatever the size of the window, the same object
 * is read, with the same messages at the same places; a writer whose text
 * leaves in pieces writes the same bytes. */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/input.h"

typedef ix_status (*read_fn)(ix__input *in, ix_obj **out);

static ix_status read_in(ix_ctx *ctx, read_fn read, const ix_buf *b,
                         size_t piece, ix_obj **out)
{
    ix__input *in;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__input_memory(ctx, "f", b->data, b->len, piece, &in));
    st = read(in, out);
    ix__input_close(in);
    return st;
}

static ix_status write_any(bool xml, ix_buf *b, const ix_obj *o)
{
    const ix_write_opts file = {.file = true};

    return xml ? ix__xml_write(b, o) : ix__itd_write(b, o, &file, 0);
}

static const size_t pieces[] = {8, 9, 13, 31, 64, 100, 1000};

/* Both outcomes, at one size of the window and with all in one window. */
static void compare(ix_ctx *ctx, bool xml, const ix_buf *text, size_t piece)
{
    read_fn read = xml ? ix__xml_read_from : ix__itd_read_from;
    char message[512];
    ix_obj *whole, *parts;
    ix_buf a, b;
    ix_status st = read_in(ctx, read, text, 0, &whole), st2;

    (void)snprintf(message, sizeof message, "%s", ix_ctx_message(ctx));
    st2 = read_in(ctx, read, text, piece, &parts);
    assert_int_equal(st2, st);
    if (st != IX_OK) {
        assert_string_equal(ix_ctx_message(ctx), message);
        assert_null(parts);
        return;
    }
    ix__buf_init(&a, ctx);
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, write_any(true, &a, whole));
    ASSERT_OK(ctx, write_any(true, &b, parts));
    assert_string_equal(a.data, b.data);
    ix__buf_free(&a);
    ix__buf_free(&b);
    ix__obj_unref(ctx, whole);
    ix__obj_unref(ctx, parts);
}

/* Law: random objects, whole and with a byte changed or the end cut off, are
 * read the same in windows of any size. */
static void any_window(bool xml, uint64_t seed)
{
    ix_rng r = ix_rng_new(seed);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    for (int i = 0; i < 40; i++) {
        ix_obj *o = ix_rand_obj(ctx, &r, 2);
        size_t piece =
            pieces[ix_rng_next(&r) % (sizeof pieces / sizeof *pieces)];
        ix_buf b;

        ix__buf_init(&b, ctx);
        ASSERT_OK(ctx, write_any(xml, &b, o));
        compare(ctx, xml, &b, piece);
        for (int k = 0; k < 5; k++) {
            size_t at = (size_t)(ix_rng_next(&r) % b.len), n = b.len;
            char old = b.data[at];

            b.data[at] = "[]\"<>&1 \n\x01\xc3-"[ix_rng_next(&r) % 12];
            compare(ctx, xml, &b, piece);
            b.data[at] = old;
            b.len = at;
            compare(ctx, xml, &b, piece);
            b.len = n;
        }
        ix__buf_free(&b);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

static void test_itd(void **state)
{
    (void)state;
    any_window(false, 0x17d);
}

static void test_xml(void **state)
{
    (void)state;
    any_window(true, 0x3371);
}

/* Words, numbers, blanks, texts, comments longer than the window, a byte order
 * mark, and a place far behind them. */
static void test_long(void **state)
{
    enum { LONG = 3000 };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf b;

    (void)state;
    for (int wrong = 0; wrong < 2; wrong++) {
        ix__buf_init(&b, ctx);
        ix__buf_puts(&b, "\xef\xbb\xbf[");
        ix__buf_fill(&b, '\n', LONG);
        ix__buf_puts(&b, "OBJECT [\"");
        ix__buf_fill(&b, 'n', LONG);
        ix__buf_puts(&b, "\" \"\xc3\xa9 \\\" ");
        ix__buf_fill(&b, 'v', LONG);
        ix__buf_puts(&b, "\"] ");
        ix__buf_fill(&b, 'A', 200);
        ix__buf_puts(&b, " [CURVE BEZIER 2 E2 [");
        ix__buf_fill(&b, ' ', LONG);
        ix__buf_puts(&b, "0.");
        ix__buf_fill(&b, '1', LONG);
        ix__buf_puts(&b, wrong ? " x][1 1]]]" : " 1][1 1]]]");
        compare(ctx, false, &b, 16);
        ix__buf_free(&b);
    }
    ix__buf_init(&b, ctx);
    ix__buf_puts(&b, "\xef\xbb\xbf<?xml version='1.0'?><!--");
    ix__buf_fill(&b, '>', LONG);
    ix__buf_puts(&b, "--><iritx xmlns='urn:iritx:geometry' version='1'><object "
                     "name='");
    ix__buf_fill(&b, '>', LONG);
    ix__buf_puts(&b, "'><string><![CDATA[]] ]>");
    ix__buf_fill(&b, 'x', LONG);
    ix__buf_puts(&b, "]]></string></object></iritx>");
    compare(ctx, true, &b, 16);
    b.data[b.len - 3] = '"';
    compare(ctx, true, &b, 16);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

/* --- writing ------------------------------------------------------------ */

typedef struct {
    ix_buf all;
    int calls;
    size_t odd; /* pieces that are not whole */
    bool full;
} sink;

static ix_status take(void *arg, const char *s, size_t n)
{
    sink *k = arg;

    if (k->full)
        return IX_FAIL(k->all.ctx, IX_EIO, "full");
    k->calls++;
    k->odd += n != IX_BUF_PIECE;
    ix__buf_add(&k->all, s, n);
    return ix__buf_check(&k->all);
}

/* Numbers enough for several pieces. */
static ix_obj *large(ix_ctx *ctx)
{
    const ix_dir dir = {IX_BEZIER, 1000, 1000, false, NULL};
    ix_obj *l = ix__obj_list(ctx);
    double *pts = calloc(3000, sizeof *pts);
    ix_rng r = ix_rng_new(5);

    assert_non_null(pts);
    for (int i = 0; i < 40; i++) {
        ix_mv *m;
        ix_obj *o;

        for (int k = 0; k < 3000; k++)
            pts[k] = ix_rng_range(&r, -1, 1);
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 3, false, pts, &m));
        o = ix__obj_mv(ctx, IX_OBJ_CURVE, m);
        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
    }
    free(pts);
    return l;
}

static void test_sink(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = large(ctx);

    (void)state;
    for (int xml = 0; xml < 2; xml++) {
        sink k = {0};
        ix_buf whole, b;

        ix__buf_init(&k.all, ctx);
        ix__buf_init(&whole, ctx);
        ix__buf_init(&b, ctx);
        b.sink = take;
        b.sink_arg = &k;
        ASSERT_OK(ctx, write_any(xml, &whole, o));
        ASSERT_OK(ctx, write_any(xml, &b, o));
        ASSERT_OK(ctx, ix__buf_flush(&b));
        assert_int_equal(ix__buf_total(&b), whole.len);
        assert_int_equal(k.all.len, whole.len);
        assert_memory_equal(k.all.data, whole.data, whole.len);
        assert_true(k.calls > 20 && k.odd == 1);
        assert_true(b.cap <= 16 * IX_BUF_PIECE); /* not the whole */
        k.full = true;
        assert_int_equal(write_any(xml, &b, o), IX_EIO);
        ix__buf_free(&k.all);
        ix__buf_free(&whole);
        ix__buf_free(&b);
    }
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* --- memory ------------------------------------------------------------- */

typedef struct {
    ix_buf text;
    ix_obj *o;
} reading;

static ix_status run_faults(ix_ctx *ctx, void *state)
{
    reading *r = state;

    return read_in(ctx, ix__itd_read_from, &r->text, 8, &r->o);
}

static void teardown(ix_ctx *ctx, void *state)
{
    reading *r = state;

    ix__obj_unref(ctx, r->o);
    r->o = NULL;
}

/* The window grows, and a warning looks for its place, without memory. */
static void test_faults(void **state)
{
    char text[] = "[OBJECT A_LONG_NAME [CURVE BEZIER 2 P1 [1 0] [-1 0]]]";
    reading r = {{.data = text, .len = sizeof text - 1}, NULL};
    ix_fault_case c = {NULL, run_faults, teardown, &r};

    (void)state;
    assert_true(ix_fault_run(&c) > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_itd), cmocka_unit_test(test_xml),
        cmocka_unit_test(test_long), cmocka_unit_test(test_sink),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
