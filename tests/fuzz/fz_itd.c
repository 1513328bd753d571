/* fz_itd.c - any bytes as a text file, for libFuzzer:
 *
 *   make CFG=asan CC=clang CFLAGS=-fsanitize=fuzzer-no-link
 *   clang -g -fsanitize=fuzzer,address,undefined -Iinclude -Isrc \
 *       tests/fuzz/fz_itd.c build/asan-clang/libiritx.a -lz -lxml2 -lm \
 *       -pthread -o fz_itd
 *   ./fz_itd -dict=tests/fuzz/itd.dict corpus tests/fuzz/itd tests/data/itd
 *
 * Law: what can be read can be written, unless it is too deep; the text reads
 * back, and gives the same text again. t_itd_corpus.c replays the corpus. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/io.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool ok, ix_ctx *ctx, const char *what)
{
    if (ok)
        return;
    fprintf(stderr, "%s: %s\n", what, ix_ctx_message(ctx));
    abort();
}

/* Reads n bytes and writes what they hold; false if they cannot be read, or
 * not be written for their depth. */
static bool pass(ix_ctx *ctx, const char *text, size_t n, ix_buf *out)
{
    const ix_write_opts file = {.file = true};
    ix_status st;
    ix_obj *o;

    ix__buf_init(out, ctx);
    if (ix__itd_read(ctx, "fuzz", text, n, &o) != IX_OK) {
        require(o == NULL, ctx, "an object in spite of an error");
        return false;
    }
    st = ix__itd_write(out, o, &file, 0);
    require(st == IX_OK || st == IX_EUNABLE, ctx, "not written");
    ix__obj_unref(ctx, o);
    return st == IX_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf first, second;

    ix_ctx_set_memory_limit(ctx, (size_t)1 << 28);
    if (pass(ctx, (const char *)data, size, &first)) {
        require(pass(ctx, first.data, first.len, &second), ctx,
                "not read back");
        require(first.len == second.len &&
                    memcmp(first.data, second.data, first.len) == 0,
                ctx, "not the same text");
        ix__buf_free(&second);
    }
    ix__buf_free(&first);
    ix_ctx_free(ctx);
    return 0;
}
