/* gzip: round trip, members, damage, bombs, memory. */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "io/gz.h"
#include "io/input.h"

static void fill(ix_rng *r, ix_buf *b, size_t n, bool noise)
{
    for (size_t i = 0; i < n; i++)
        ix__buf_putc(b, noise ? (char)ix_rng_next(r) : (char)('a' + i % 7));
}

static ix_status to_buf(void *arg, const char *s, size_t n)
{
    ix__buf_add(arg, s, n);
    return ix__buf_check(arg);
}

/* In pieces of one size, or all at once. */
static ix_status deflate_all(ix_ctx *ctx, const char *s, size_t n, size_t piece,
                             ix_buf *out)
{
    ix__gzip *g;
    ix_status st;

    IX_TRY(ix__gzip_open(ctx, to_buf, out, &g));
    st = IX_OK;
    for (size_t at = 0; st == IX_OK && at < n; at += piece)
        st = ix__gzip_put(g, s + at, n - at < piece ? n - at : piece);
    if (st == IX_OK)
        st = ix__gzip_finish(g);
    ix__gzip_close(g);
    return st;
}

static void pack(ix_ctx *ctx, const ix_buf *text, ix_buf *out)
{
    ASSERT_OK(ctx, deflate_all(ctx, text->data, text->len, 50000, out));
}

static ix_status fill_from(ix_ctx *ctx, ix__input *s, ix_buf *out)
{
    char piece[1000];
    size_t n;

    (void)ctx;
    do {
        IX_TRY(ix__input_read(s, piece, sizeof piece, &n));
        ix__buf_add(out, piece, n);
        IX_TRY(ix__buf_check(out));
    } while (n == sizeof piece);
    return IX_OK;
}

/* What is gzip, through a source. */
static ix_status inflate_all(ix_ctx *ctx, const char *name, const char *data,
                             size_t n, ix_buf *out)
{
    ix__input *s;
    ix_status st;

    IX_TRY(ix__input_memory(ctx, name, data, n, 0, &s));
    assert_true(ix__input_most(s) >= (n > 20 ? n / 2 : 0));
    st = fill_from(ctx, s, out);
    ix__input_close(s);
    return st;
}

/* Law: inflating what was deflated gives it back, noise or not, large or
 * empty; two files one behind the other give both. */
static void test_round(void **state)
{
    static const size_t sizes[] = {0, 1, 1000, 65536, 300000};
    ix_rng r = ix_rng_new(1);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 10; i++) {
        ix_buf text, packed, out;

        ix__buf_init(&text, ctx);
        ix__buf_init(&packed, ctx);
        ix__buf_init(&out, ctx);
        ix__buf_puts(&text, "");
        fill(&r, &text, sizes[i % 5], i > 4);
        pack(ctx, &text, &packed);
        assert_true(ix__gz_is(packed.data, packed.len));
        pack(ctx, &text, &packed); /* a second member */
        ix__buf_fill(&packed, '\0', 512);
        ASSERT_OK(ctx, inflate_all(ctx, "t", packed.data, packed.len, &out));
        assert_int_equal(out.len, 2 * text.len);
        assert_memory_equal(out.data, text.data, text.len);
        assert_memory_equal(out.data + text.len, text.data, text.len);
        ix__buf_free(&text);
        ix__buf_free(&packed);
        ix__buf_free(&out);
    }
    ix_ctx_free(ctx);
}

static void expect_bad(ix_ctx *ctx, const char *data, size_t n,
                       const char *message)
{
    ix_buf out;

    ix__buf_init(&out, ctx);
    assert_int_equal(inflate_all(ctx, "x.gz", data, n, &out), IX_EPARSE);
    assert_non_null(strstr(ix_ctx_message(ctx), message));
    assert_ptr_equal(strstr(ix_ctx_message(ctx), "x.gz: "),
                     ix_ctx_message(ctx));
    ix__buf_free(&out);
}

/* Law: every prefix is refused as cut short; a changed bit of data or trailer
 * is found out, or was one of those that do not matter. */
static void test_damage(void **state)
{
    ix_rng r = ix_rng_new(2);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf text, packed, out;
    int found = 0;

    (void)state;
    ix__buf_init(&text, ctx);
    ix__buf_init(&packed, ctx);
    fill(&r, &text, 300, true);
    pack(ctx, &text, &packed);
    for (size_t n = 2; n < packed.len; n += n < 20 ? 1 : 7)
        expect_bad(ctx, packed.data, n, "unexpected end of gzip data");
    for (size_t i = 10; i < packed.len; i++) {
        ix_status st;

        packed.data[i] ^= 0x10;
        ix__buf_init(&out, ctx);
        st = inflate_all(ctx, "t", packed.data, packed.len, &out);
        if (st == IX_OK) { /* padding in front of a stored block */
            assert_int_equal(out.len, text.len);
            assert_memory_equal(out.data, text.data, text.len);
        } else {
            assert_int_equal(st, IX_EPARSE);
            found++;
        }
        ix__buf_free(&out);
        packed.data[i] ^= 0x10;
    }
    assert_true(found > 300);
    packed.data[packed.len - 6] ^= 1; /* the checksum */
    expect_bad(ctx, packed.data, packed.len, "incorrect data check");
    packed.data[packed.len - 6] ^= 1;
    ix__buf_puts(&packed, "tail");
    expect_bad(ctx, packed.data, packed.len, "4 bytes of something else");
    ix__buf_free(&text);
    ix__buf_free(&packed);
    ix_ctx_free(ctx);
}

/* Blanks pack 1000 times: allowed up to 16 MiB only, in one member or many. */
static void test_bomb(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf text, packed, out;

    (void)state;
    ix__buf_init(&text, ctx);
    ix__buf_init(&packed, ctx);
    ix__buf_fill(&text, ' ', IX_GZ_FREE / 8);
    for (int i = 0; i < 8; i++)
        pack(ctx, &text, &packed);
    ix__buf_init(&out, ctx);
    ASSERT_OK(ctx, inflate_all(ctx, "t", packed.data, packed.len, &out));
    assert_int_equal(out.len, IX_GZ_FREE);
    pack(ctx, &text, &packed);
    expect_bad(ctx, packed.data, packed.len, "inflates more than 200 times");
    ix__buf_free(&text);
    ix__buf_free(&packed);
    ix__buf_free(&out);
    ix_ctx_free(ctx);
}

static void test_memory_limit(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf text, packed, out;

    (void)state;
    ix__buf_init(&text, ctx);
    ix__buf_init(&packed, ctx);
    ix__buf_fill(&text, ' ', 1000000);
    pack(ctx, &text, &packed);
    ix_ctx_set_memory_limit(ctx, ctx->live + 500000);
    ix__buf_init(&out, ctx);
    assert_int_equal(inflate_all(ctx, "t", packed.data, packed.len, &out),
                     IX_ENOMEM);
    ix__buf_free(&text);
    ix__buf_free(&packed);
    ix__buf_free(&out);
    ix_ctx_free(ctx);
}

static ix_status run_faults(ix_ctx *ctx, void *state)
{
    ix_buf packed, out;
    ix_status st;

    ix__buf_init(&packed, ctx);
    ix__buf_init(&out, ctx);
    st = deflate_all(ctx, state, strlen(state), 7, &packed);
    if (st == IX_OK)
        st = inflate_all(ctx, "t", packed.data, packed.len, &out);
    ix__buf_free(&packed);
    ix__buf_free(&out);
    return st;
}

static void test_faults(void **state)
{
    char text[] = "some text to pack";
    ix_fault_case c = {NULL, run_faults, NULL, text};

    (void)state;
    assert_true(ix_fault_run(&c) > 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round), cmocka_unit_test(test_damage),
        cmocka_unit_test(test_bomb), cmocka_unit_test(test_memory_limit),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
