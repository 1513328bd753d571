/* ctx.c - the context. All memory of the library passes through here, so
 * that limits and out-of-memory tests reach every allocation. */
#define _POSIX_C_SOURCE 200809L
#include "base/ctx.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/threads.h"

#ifndef IX_VERSION
#define IX_VERSION "unknown"
#endif

const char *ix_version(void)
{
    return IX_VERSION;
}

const char *ix_status_name(ix_status st)
{
    static const char *const names[] = {"ok",     "argument",   "domain",
                                        "unable", "memory",     "file",
                                        "syntax", "interrupted"};

    return (unsigned)st < sizeof names / sizeof *names ? names[st] : "?";
}

void ix__fail(ix_ctx *ctx, ix_status st, const char *func, const char *file,
              int line, const char *fmt, ...)
{
    va_list ap;

    ctx->code = st;
    ctx->func = func;
    ctx->file = file;
    ctx->line = line;
    va_start(ap, fmt);
    (void)vsnprintf(ctx->msg, sizeof ctx->msg, fmt, ap);
    va_end(ap);
}

void ix__note(ix_ctx *ctx, const char *fmt, ...)
{
    char text[512];
    va_list ap;

    if (!ctx->note)
        return;
    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    ctx->note(ctx->note_ud, text);
}

const char *ix_ctx_message(const ix_ctx *ctx)
{
    return ctx->msg;
}

ix_status ix_ctx_status(const ix_ctx *ctx)
{
    return ctx->code;
}

static void *default_alloc(void *ud, void *p, size_t old_size, size_t size)
{
    (void)ud;
    (void)old_size;
    if (size)
        return realloc(p, size);
    free(p);
    return NULL;
}

ix_ctx *ix_ctx_new(ix_alloc_fn alloc, void *ud)
{
    ix_ctx *ctx;

    if (!alloc)
        alloc = default_alloc;
    ctx = alloc(ud, NULL, 0, sizeof *ctx);
    if (ctx)
        *ctx = (ix_ctx){.alloc = alloc, .ud = ud, .keep_scratch = true};
    return ctx;
}

void ix_ctx_free(ix_ctx *ctx)
{
    ix_alloc_fn alloc;
    void *ud;

    if (!ctx)
        return;
    alloc = ctx->alloc;
    ud = ctx->ud;
    ix__pool_stop(ctx);
    if (ctx->free_list_drop)
        ctx->free_list_drop(ctx);
    ctx->keep_scratch = false;
    ix__scratch_release(ctx, (ix_mark){NULL, 0});
    (void)alloc(ud, ctx, sizeof *ctx, 0);
}

void ix_ctx_set_memory_limit(ix_ctx *ctx, size_t bytes)
{
    ctx->limit = bytes;
}

void ix_ctx_set_cancel(ix_ctx *ctx, const volatile int *flag)
{
    ctx->cancel = flag;
}

void ix_ctx_set_note(ix_ctx *ctx, ix_note_fn fn, void *ud)
{
    ctx->note = fn;
    ctx->note_ud = ud;
}

/* --- progress
 * ---------------------------------------------------------------------- */

#define PROGRESS_INTERVAL 0.1 /* seconds; faster nobody can read */

void ix_ctx_set_progress(ix_ctx *ctx, ix_progress_fn fn, void *ud)
{
    ix__progress_clear(ctx);
    ctx->progress = fn;
    ctx->progress_ud = ud;
    ctx->part = -1;
}

void ix__progress(ix_ctx *ctx, const char *what, double part)
{
    ctx->doing = what;
    ctx->part = part;
}

void ix__progress_clear(ix_ctx *ctx)
{
    if (ctx->progress_shown)
        ctx->progress(ctx->progress_ud, NULL, -1);
    ctx->progress_shown = false;
}

static void tell_progress(ix_ctx *ctx)
{
    struct timespec t;
    double now;

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    now = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    if (now < ctx->next_progress)
        return;
    ctx->next_progress = now + PROGRESS_INTERVAL;
    ctx->progress_shown = true;
    ctx->progress(ctx->progress_ud, ctx->doing ? ctx->doing : "", ctx->part);
}

ix_status ix__poll(ix_ctx *ctx)
{
    if (ctx->progress)
        tell_progress(ctx);
    if (ctx->cancel && *ctx->cancel)
        return IX_FAIL(ctx, IX_ECANCEL, "interrupted");
    return IX_OK;
}

void *ix__realloc(ix_ctx *ctx, void *p, size_t old_size, size_t size)
{
    void *q;

    if (ctx->limit && (size > ctx->limit || ctx->live > ctx->limit - size)) {
        (void)IX_FAIL(ctx, IX_ENOMEM,
                      "memory limit of %zu MB reached (%zu bytes more wanted)",
                      ctx->limit >> 20, size);
        return NULL;
    }
    q = ctx->alloc(ctx->ud, p, old_size, size);
    if (!q) {
        (void)IX_FAIL(ctx, IX_ENOMEM, "out of memory (%zu bytes wanted)", size);
        return NULL;
    }
    ctx->live += size - old_size;
    return q;
}

void *ix__alloc(ix_ctx *ctx, size_t size)
{
    return ix__realloc(ctx, NULL, 0, size);
}

void ix__free(ix_ctx *ctx, void *p, size_t size)
{
    if (!p)
        return;
    ctx->live -= size;
    (void)ctx->alloc(ctx->ud, p, size, 0);
}

char *ix__strdup(ix_ctx *ctx, const char *s)
{
    size_t n = strlen(s) + 1;
    char *t = ix__alloc(ctx, n);

    return t ? memcpy(t, s, n) : NULL;
}

void ix__strfree(ix_ctx *ctx, char *s)
{
    if (s)
        ix__free(ctx, s, strlen(s) + 1);
}
