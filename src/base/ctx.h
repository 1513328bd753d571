/* ctx.h - the context: last message, allocator, scratch arena, cancellation.
 *
 * Temporaries come from the scratch arena and are released together, by mark,
 * in the public function that took the mark. Results come from ix__alloc and
 * are freed with their exact size. */
#ifndef BASE_CTX_H
#define BASE_CTX_H

#include <stdarg.h>
#include <stddef.h>

#include "iritx/base.h"

typedef struct ix__chunk ix__chunk;
typedef struct ix__pool ix__pool;

struct ix_ctx {
    ix_status code;
    const char *func, *file; /* where the last failure arose */
    int line;
    char msg[512];
    ix_alloc_fn alloc;
    void *ud;
    size_t live, limit; /* bytes now; 0 means no limit */
    ix__chunk *scratch;
    bool keep_scratch; /* false only while the context is being freed */
    const volatile int *cancel;
    ix_note_fn note;
    void *note_ud;
    ix_progress_fn progress;
    void *progress_ud;
    const char *doing;    /* what is being computed; NULL: nothing named */
    double part;          /* of it that is done; negative: not known */
    double next_progress; /* seconds of the clock when to tell again */
    bool progress_shown;
    int nthreads; /* 0: one per processor */
    ix__pool *pool;
    void *free_list; /* value boxes kept for reuse, see object/object.c */
    int free_count;  /* how many */
    void (*free_list_drop)(ix_ctx *ctx); /* set once there is such a list */
};

typedef struct {
    ix__chunk *chunk;
    size_t used;
} ix_mark;

void ix__fail(ix_ctx *ctx, ix_status st, const char *func, const char *file,
              int line, const char *fmt, ...) IX_PRINTF(6, 7);
void ix__note(ix_ctx *ctx, const char *fmt, ...) IX_PRINTF(2, 3);

/* Uninitialised memory, NULL (message set) if there is none; size > 0. */
void *ix__alloc(ix_ctx *ctx, size_t size) IX_MUST_CHECK;
/* Resized block or NULL (the old block stays); p may be NULL. */
void *ix__realloc(ix_ctx *ctx, void *p, size_t old_size,
                  size_t size) IX_MUST_CHECK;
void ix__free(ix_ctx *ctx, void *p, size_t size); /* p may be NULL */
char *ix__strdup(ix_ctx *ctx, const char *s) IX_MUST_CHECK;
void ix__strfree(ix_ctx *ctx, char *s); /* s may be NULL */

ix_mark ix__scratch_mark(ix_ctx *ctx);
void ix__scratch_release(ix_ctx *ctx, ix_mark mk);

/* Returns what expr returns, its scratch released. */
#define IX_RETURN_SCOPED(ctx, expr)               \
    do {                                          \
        ix_mark ix_mark_ = ix__scratch_mark(ctx); \
        ix_status ix_scoped_ = (expr);            \
        ix__scratch_release((ctx), ix_mark_);     \
        return ix_scoped_;                        \
    } while (0)
/* n items of the given size, 64-byte aligned, unset; n may be 0. NULL and a
 * message on failure (also on overflow of n * size). */
void *ix__scratch(ix_ctx *ctx, size_t n, size_t size) IX_MUST_CHECK;
void *ix__scratch_zero(ix_ctx *ctx, size_t n, size_t size) IX_MUST_CHECK;

/* IX_ECANCEL (with its message) once the cancel flag is set; call it at least
 * every few milliseconds of work, from the context's own thread. */
ix_status ix__poll(ix_ctx *ctx) IX_MUST_CHECK;

/* What is computed from now on, a text with a long life or NULL, and which part
 * of it is done (negative: not known): for ix_ctx_set_progress. */
void ix__progress(ix_ctx *ctx, const char *what, double part);
/* What was shown of the progress vanishes: something else is to be written. */
void ix__progress_clear(ix_ctx *ctx);

/* Record the error and yield the literal status, so that a static analyser
 * sees that the caller cannot be told IX_OK. */
#define IX_FAIL(ctx, st, ...) \
    (ix__fail((ctx), (st), __func__, __FILE__, __LINE__, __VA_ARGS__), (st))

/* p = n scratch items of p's type, or return IX_ENOMEM. */
#define IX_SCRATCH(ctx, p, n)                               \
    do {                                                    \
        (p) = ix__scratch((ctx), (size_t)(n), sizeof *(p)); \
        if (!(p))                                           \
            return IX_ENOMEM;                               \
    } while (0)
#define IX_SCRATCH_ZERO(ctx, p, n)                               \
    do {                                                         \
        (p) = ix__scratch_zero((ctx), (size_t)(n), sizeof *(p)); \
        if (!(p))                                                \
            return IX_ENOMEM;                                    \
    } while (0)

#endif
