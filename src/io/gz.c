/* gz.c - gzip in both directions, one piece in memory. zlib's memory comes from
 * the context, so that limits and out-of-memory tests reach it. */
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

size_t ix__gz_most(size_t packed)
{
    const size_t deflate_ratio = 1032; /* of a block of equal bytes */
    size_t most = packed > IX_GZ_MAX / IX_GZ_RATIO ? IX_GZ_MAX
                                                   : packed * IX_GZ_RATIO;

    if (most < IX_GZ_FREE)
        most = packed > IX_GZ_FREE / deflate_ratio ? IX_GZ_FREE
                                                   : packed * deflate_ratio;
    return most;
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

/* --- inflating -------------------------------------------------------- */

struct ix__gunzip {
    ix_ctx *ctx;
    const char *name;
    ix__fill_fn fill;
    void *arg;
    z_stream z;
    size_t in, out; /* bytes so far; of in, z.avail_in are not used yet */
    bool inside;    /* a member has begun and not ended */
    bool exhausted; /* fill has no more */
    bool done;
    char chunk[CHUNK];
};

ix_status ix__gunzip_open(ix_ctx *ctx, const char *name, ix__fill_fn fill,
                          void *arg, ix__gunzip **out)
{
    ix__gunzip *g = ix__alloc(ctx, sizeof *g);

    *out = NULL;
    if (!g)
        return IX_ENOMEM;
    g->ctx = ctx;
    g->name = name;
    g->fill = fill;
    g->arg = arg;
    g->z = (z_stream){.zalloc = z_alloc, .zfree = z_free, .opaque = ctx};
    g->in = g->out = 0;
    g->inside = true;
    g->exhausted = g->done = false;
    if (inflateInit2(&g->z, GZIP_ONLY) != Z_OK) {
        ix__free(ctx, g, sizeof *g);
        return IX_ENOMEM;
    }
    *out = g;
    return IX_OK;
}

void ix__gunzip_close(ix__gunzip *g)
{
    if (!g)
        return;
    (void)inflateEnd(&g->z);
    ix__free(g->ctx, g, sizeof *g);
}

/* At least n packed bytes in the chunk, if there are so many. */
static ix_status need_input(ix__gunzip *g, size_t n)
{
    size_t k = g->z.avail_in, more;

    if (k >= n || g->exhausted)
        return IX_OK;
    if (k > 0)
        memmove(g->chunk, g->z.next_in, k);
    IX_TRY(g->fill(g->arg, g->chunk + k, CHUNK - k, &more));
    g->exhausted = more < CHUNK - k;
    g->in += more;
    g->z.next_in = (Bytef *)g->chunk;
    g->z.avail_in = (uInt)(k + more);
    return IX_OK;
}

static ix_status check_limits(const ix__gunzip *g)
{
    size_t used = g->in - g->z.avail_in;

    if (g->out > IX_GZ_MAX)
        return IX_FAIL(g->ctx, IX_EPARSE,
                       "%.200s: inflates to more than %zu bytes", g->name,
                       IX_GZ_MAX);
    if (g->out > IX_GZ_FREE && g->out / IX_GZ_RATIO > used)
        return IX_FAIL(g->ctx, IX_EPARSE,
                       "%.200s: inflates more than %d times (%zu bytes from "
                       "%zu)",
                       g->name, IX_GZ_RATIO, g->out, used);
    return ix__poll(g->ctx);
}

static ix_status inflate_failed(const ix__gunzip *g, int code)
{
    if (code == Z_MEM_ERROR)
        return IX_ENOMEM; /* the message is set */
    if (code == Z_BUF_ERROR)
        return IX_FAIL(g->ctx, IX_EPARSE, "%.200s: unexpected end of gzip data",
                       g->name);
    return IX_FAIL(g->ctx, IX_EPARSE, "%.200s: corrupt gzip data (%s)", g->name,
                   g->z.msg ? g->z.msg : "no valid stream");
}

/* What is left must be zeros, the padding of blocks. */
static ix_status skip_padding(ix__gunzip *g)
{
    size_t n = 0;
    bool zero = true;

    do {
        for (uInt i = 0; i < g->z.avail_in; i++)
            zero = zero && g->z.next_in[i] == 0;
        n += g->z.avail_in;
        g->z.avail_in = 0;
        IX_TRY(need_input(g, 1));
        IX_TRY(ix__poll(g->ctx));
    } while (g->z.avail_in > 0);
    g->done = true;
    if (zero)
        return IX_OK;
    return IX_FAIL(g->ctx, IX_EPARSE,
                   "%.200s: %zu bytes of something else behind the gzip data",
                   g->name, n);
}

/* Behind a member: another one, or the end. */
static ix_status next_member(ix__gunzip *g)
{
    IX_TRY(need_input(g, 2));
    if (!ix__gz_is((const char *)g->z.next_in, g->z.avail_in))
        return skip_padding(g);
    if (inflateReset(&g->z) != Z_OK)
        return inflate_failed(g, Z_STREAM_ERROR);
    g->inside = true;
    return IX_OK;
}

ix_status ix__gunzip_read(ix__gunzip *g, char *to, size_t room, size_t *n)
{
    *n = 0;
    while (*n < room && !g->done) {
        uInt most = room - *n < CHUNK ? (uInt)(room - *n) : CHUNK;
        int code;

        if (!g->inside) {
            IX_TRY(next_member(g));
            continue;
        }
        IX_TRY(need_input(g, 1));
        g->z.next_out = (Bytef *)to + *n;
        g->z.avail_out = most;
        code = inflate(&g->z, Z_NO_FLUSH);
        if (code != Z_OK && code != Z_STREAM_END)
            return inflate_failed(g, code);
        g->inside = code != Z_STREAM_END;
        *n += most - g->z.avail_out;
        g->out += most - g->z.avail_out;
        IX_TRY(check_limits(g));
    }
    return IX_OK;
}

/* --- deflating -------------------------------------------------------- */

struct ix__gzip {
    ix_ctx *ctx;
    ix__sink_fn sink;
    void *arg;
    z_stream z;
    char chunk[CHUNK];
};

ix_status ix__gzip_open(ix_ctx *ctx, ix__sink_fn sink, void *arg,
                        ix__gzip **out)
{
    ix__gzip *g = ix__alloc(ctx, sizeof *g);

    *out = NULL;
    if (!g)
        return IX_ENOMEM;
    g->ctx = ctx;
    g->sink = sink;
    g->arg = arg;
    g->z = (z_stream){.zalloc = z_alloc, .zfree = z_free, .opaque = ctx};
    if (deflateInit2(&g->z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, GZIP_ONLY, 8,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
        ix__free(ctx, g, sizeof *g);
        return IX_ENOMEM;
    }
    *out = g;
    return IX_OK;
}

void ix__gzip_close(ix__gzip *g)
{
    if (!g)
        return;
    (void)deflateEnd(&g->z);
    ix__free(g->ctx, g, sizeof *g);
}

/* Until zlib has taken all of its input, or at the end given all output. */
static ix_status run(ix__gzip *g, int flush)
{
    int code;

    do {
        g->z.next_out = (Bytef *)g->chunk;
        g->z.avail_out = CHUNK;
        code = deflate(&g->z, flush);
        if (code != Z_OK && code != Z_BUF_ERROR && code != Z_STREAM_END)
            return IX_FAIL(g->ctx, IX_EUNABLE, "zlib failed (%d)", code);
        IX_TRY(g->sink(g->arg, g->chunk, CHUNK - g->z.avail_out));
        IX_TRY(ix__poll(g->ctx));
    } while (g->z.avail_out == 0 ||
             (flush == Z_FINISH && code != Z_STREAM_END));
    return IX_OK;
}

ix_status ix__gzip_put(ix__gzip *g, const char *s, size_t n)
{
    while (n > 0) {
        uInt k = n < UINT_MAX ? (uInt)n : UINT_MAX;

        g->z.next_in = (Bytef *)(uintptr_t)s; /* zlib only reads it */
        g->z.avail_in = k;
        IX_TRY(run(g, Z_NO_FLUSH));
        s += k;
        n -= k;
    }
    return IX_OK;
}

ix_status ix__gzip_finish(ix__gzip *g)
{
    return run(g, Z_FINISH);
}
