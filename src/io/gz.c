/* gz.c - gzip in memory. zlib's memory comes from the context, so that limits
 * and out-of-memory tests reach it. */
#include "io/gz.h"

#include <limits.h>
#include <string.h>
#include <zlib.h>

#define CHUNK     65536
#define GZIP_ONLY (15 + 16) /* zlib's windowBits: 32 KB window, gzip header */

bool ix__gz_is(const char *data, size_t n)
{
    return n >= 2 && memcmp(data, "\x1f\x8b", 2) == 0;
}

/* zlib frees without a size: it stands before each block. */
typedef union {
    size_t bytes;
    max_align_t align;
} prefix;

static voidpf z_alloc(voidpf ctx, uInt items, uInt size)
{
    size_t bytes = (size_t)items * size + sizeof(prefix);
    prefix *p = ix__alloc(ctx, bytes);

    if (!p)
        return Z_NULL;
    p->bytes = bytes;
    return p + 1;
}

static void z_free(voidpf ctx, voidpf p)
{
    prefix *head = (prefix *)p - 1;

    ix__free(ctx, head, head->bytes);
}

static void z_input(z_stream *z, const char *data, size_t n)
{
    z->next_in = (Bytef *)(uintptr_t)data; /* zlib only reads it */
    z->avail_in = (uInt)n;
}

/* --- inflating -------------------------------------------------------- */

static ix_status check_limits(const z_stream *z, const char *name, size_t in,
                              size_t out)
{
    size_t used = in - z->avail_in;

    if (out > IX_GZ_MAX)
        return IX_FAIL(z->opaque, IX_EPARSE,
                       "%.200s: inflates to more than %zu bytes", name,
                       IX_GZ_MAX);
    if (out > IX_GZ_FREE && out / IX_GZ_RATIO > used)
        return IX_FAIL(z->opaque, IX_EPARSE,
                       "%.200s: inflates more than %d times (%zu bytes from "
                       "%zu)",
                       name, IX_GZ_RATIO, out, used);
    return ix__poll(z->opaque);
}

static ix_status inflate_failed(const z_stream *z, const char *name, int code)
{
    if (code == Z_MEM_ERROR)
        return IX_ENOMEM; /* the message is set */
    if (code == Z_BUF_ERROR)
        return IX_FAIL(z->opaque, IX_EPARSE,
                       "%.200s: unexpected end of gzip data", name);
    return IX_FAIL(z->opaque, IX_EPARSE, "%.200s: corrupt gzip data (%s)", name,
                   z->msg ? z->msg : "no valid stream");
}

/* One member, up to its verified end. */
static ix_status inflate_member(z_stream *z, const char *name, size_t n,
                                char *chunk, ix_buf *out)
{
    int code;

    do {
        z->next_out = (Bytef *)chunk;
        z->avail_out = CHUNK;
        code = inflate(z, Z_NO_FLUSH);
        if (code != Z_OK && code != Z_STREAM_END)
            return inflate_failed(z, name, code);
        ix__buf_add(out, chunk, CHUNK - z->avail_out);
        IX_TRY(ix__buf_check(out));
        IX_TRY(check_limits(z, name, n, out->len));
    } while (code != Z_STREAM_END);
    return IX_OK;
}

static bool all_zero(const Bytef *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (s[i] != 0)
            return false;
    return true;
}

static ix_status inflate_all(z_stream *z, const char *name, size_t n,
                             ix_buf *out)
{
    char *chunk;

    IX_SCRATCH(z->opaque, chunk, CHUNK);
    for (;;) {
        IX_TRY(inflate_member(z, name, n, chunk, out));
        if (all_zero(z->next_in, z->avail_in)) /* padding of blocks */
            return IX_OK;
        if (!ix__gz_is((const char *)z->next_in, z->avail_in))
            return IX_FAIL(z->opaque, IX_EPARSE,
                           "%.200s: %u bytes of something else behind the "
                           "gzip data",
                           name, z->avail_in);
        if (inflateReset(z) != Z_OK)
            return inflate_failed(z, name, Z_STREAM_ERROR);
    }
}

ix_status ix__gz_inflate(ix_ctx *ctx, const char *name, const char *data,
                         size_t n, ix_buf *out)
{
    z_stream z = {.zalloc = z_alloc, .zfree = z_free, .opaque = ctx};
    ix_mark mk;
    ix_status st;

    if (n > UINT_MAX)
        return IX_FAIL(ctx, IX_EPARSE, "%.200s: more than %u bytes", name,
                       UINT_MAX);
    z_input(&z, data, n);
    if (inflateInit2(&z, GZIP_ONLY) != Z_OK)
        return IX_ENOMEM;
    mk = ix__scratch_mark(ctx);
    st = inflate_all(&z, name, n, out);
    ix__scratch_release(ctx, mk);
    (void)inflateEnd(&z);
    return st;
}

/* --- deflating -------------------------------------------------------- */

static ix_status deflate_all(z_stream *z, ix_buf *out)
{
    char *chunk;
    int code;

    IX_SCRATCH(z->opaque, chunk, CHUNK);
    do {
        z->next_out = (Bytef *)chunk;
        z->avail_out = CHUNK;
        code = deflate(z, Z_FINISH);
        ix__buf_add(out, chunk, CHUNK - z->avail_out);
        IX_TRY(ix__buf_check(out));
        IX_TRY(ix__poll(z->opaque));
    } while (code == Z_OK || code == Z_BUF_ERROR);
    if (code != Z_STREAM_END)
        return IX_FAIL(z->opaque, IX_EUNABLE, "zlib failed (%d)", code);
    return IX_OK;
}

ix_status ix__gz_deflate(ix_ctx *ctx, const char *data, size_t n, ix_buf *out)
{
    z_stream z = {.zalloc = z_alloc, .zfree = z_free, .opaque = ctx};
    ix_mark mk;
    ix_status st;

    if (n > UINT_MAX)
        return IX_FAIL(ctx, IX_EUNABLE, "more than %u bytes to compress",
                       UINT_MAX);
    z_input(&z, data, n);
    if (deflateInit2(&z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, GZIP_ONLY, 8,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        return IX_ENOMEM;
    mk = ix__scratch_mark(ctx);
    st = deflate_all(&z, out);
    ix__scratch_release(ctx, mk);
    (void)deflateEnd(&z);
    return st;
}
