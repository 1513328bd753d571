/* scratch.c - the arena for temporaries: a stack of chunks, released by mark.
 * One empty chunk is kept so that small operators never reach the allocator. */
#include <stdint.h>
#include <string.h>

#include "base/ctx.h"

#define ALIGN 64u

#ifdef IX_HARDTEST
#define CHUNK  ALIGN /* a fresh block for every request: overruns meet ASan */
#define GROWTH 0u
#else
#define CHUNK  65536u
#define GROWTH 8u
#endif
/* Just below what the C library maps anew each time, whatever it has learned
 * (32 MB): it keeps blocks up to that, and twice as much free memory. */
#define MOST ((size_t)31 << 20)

struct ix__chunk {
    ix__chunk *prev;
    size_t size, used; /* bytes behind the header */
};

static unsigned char *chunk_data(ix__chunk *c)
{
    uintptr_t a = (uintptr_t)(c + 1);

    return (unsigned char *)(c + 1) + ((ALIGN - a % ALIGN) % ALIGN);
}

static size_t chunk_bytes(size_t size)
{
    return sizeof(ix__chunk) + ALIGN + size;
}

ix_mark ix__scratch_mark(ix_ctx *ctx)
{
    return (ix_mark){ctx->scratch, ctx->scratch ? ctx->scratch->used : 0};
}

void ix__scratch_release(ix_ctx *ctx, ix_mark mk)
{
    while (ctx->scratch != mk.chunk) {
        ix__chunk *c = ctx->scratch;

        if (!c->prev && !mk.chunk && c->size == CHUNK && ctx->keep_scratch) {
            c->used = 0;
            return;
        }
        ctx->scratch = c->prev;
        ix__free(ctx, c, chunk_bytes(c->size));
    }
    if (ctx->scratch)
        ctx->scratch->used = mk.used;
}

/* Chunks grow eightfold: then large work takes few of them, and the system's
 * allocator keeps the memory from one operation to the next (it gives back
 * what exceeds twice its largest block). */
static size_t chunk_size(const ix_ctx *ctx, size_t need)
{
    size_t size = ctx->scratch && GROWTH ? GROWTH * ctx->scratch->size : CHUNK;

    if (size < CHUNK)
        size = CHUNK;
    if (size > MOST)
        size = MOST;
    return need > size ? need : size;
}

static ix__chunk *push_chunk(ix_ctx *ctx, size_t need)
{
    size_t size = chunk_size(ctx, need);
    ix__chunk *c = ix__alloc(ctx, chunk_bytes(size));

    if (!c && size > need && size > CHUNK) { /* a limit may be near */
        size = need > CHUNK ? need : CHUNK;
        c = ix__alloc(ctx, chunk_bytes(size));
    }
    if (!c)
        return NULL;
    *c = (ix__chunk){.prev = ctx->scratch, .size = size};
    ctx->scratch = c;
    return c;
}

void *ix__scratch(ix_ctx *ctx, size_t n, size_t size)
{
    ix__chunk *c = ctx->scratch;
    size_t need;
    void *p;

    if (__builtin_mul_overflow(n, size, &need) || need > SIZE_MAX / 2) {
        (void)IX_FAIL(ctx, IX_ENOMEM, "scratch: %zu items of %zu bytes", n,
                      size);
        return NULL;
    }
    need = (need + ALIGN - 1) / ALIGN * ALIGN;
    if (need == 0)
        need = ALIGN;
    if (!c || c->size - c->used < need)
        c = push_chunk(ctx, need);
    if (!c)
        return NULL;
    p = chunk_data(c) + c->used;
    c->used += need;
#ifdef IX_HARDTEST
    memset(p, 0xff, need); /* doubles read before they are set are NaN */
#endif
    return p;
}

void *ix__scratch_zero(ix_ctx *ctx, size_t n, size_t size)
{
    void *p = ix__scratch(ctx, n, size);

    return p ? memset(p, 0, n * size) : NULL;
}
