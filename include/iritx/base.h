/* base.h - status codes, the context, numbers as text.
 *
 * Every public function takes an ix_ctx first and returns an ix_status. The
 * context holds the allocator, the scratch memory, the last message, limits
 * and the worker threads. A context serves one thread at a time; objects made
 * with a context are released with the same context. */
#ifndef IRITX_BASE_H
#define IRITX_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define IX_MUST_CHECK   __attribute__((warn_unused_result))
#define IX_PRINTF(f, a) __attribute__((format(printf, f, a)))
#else
#define IX_MUST_CHECK
#define IX_PRINTF(f, a)
#endif

typedef struct ix_ctx ix_ctx;

typedef enum {
    IX_OK = 0,
    IX_EARG,    /* the caller broke a stated, checkable rule */
    IX_EDOMAIN, /* mathematically, no such result exists */
    IX_EUNABLE, /* a result may exist; we could not establish it */
    IX_ENOMEM,  /* no memory, or the context's memory limit */
    IX_EIO,     /* the operating system refused a file operation */
    IX_EPARSE,  /* malformed text or binary input */
    IX_ECANCEL  /* interrupted by the user or by a budget */
} ix_status;

/* Returns the status of expr from the calling function unless it is IX_OK. */
#define IX_TRY(expr)                \
    do {                            \
        ix_status ix_try_ = (expr); \
        if (ix_try_ != IX_OK)       \
            return ix_try_;         \
    } while (0)

/* "ok", "argument", "domain", ... ; never NULL. */
const char *ix_status_name(ix_status st);

/* The library's version, "0.1.0". */
const char *ix_version(void);

/* One function serves all memory: p == NULL allocates, size == 0 frees (and
 * returns NULL), else resizes. old_size is the size given at allocation.
 * Called only from the thread that uses the context. */
typedef void *(*ix_alloc_fn)(void *ud, void *p, size_t old_size, size_t size);

/* A new context, NULL if memory is short. alloc NULL means malloc. */
ix_ctx *ix_ctx_new(ix_alloc_fn alloc, void *ud);

/* Frees the context. All objects made with it must be released before. */
void ix_ctx_free(ix_ctx *ctx);

/* The message of the last failed call: one line, no newline, never NULL. */
const char *ix_ctx_message(const ix_ctx *ctx);
ix_status ix_ctx_status(const ix_ctx *ctx);

/* At most this many bytes may be live at once; 0 (the default) means no
 * limit. Beyond it, allocation fails with IX_ENOMEM. */
void ix_ctx_set_memory_limit(ix_ctx *ctx, size_t bytes);

/* Number of threads for large work, 1 .. 64; 0 means one per processor (the
 * default). Results have the same bits whatever the number. */
void ix_ctx_set_threads(ix_ctx *ctx, int n);

/* Long computations return IX_ECANCEL soon after *flag becomes non-zero (set
 * it from a signal handler). The flag must outlive the context; NULL: none. */
void ix_ctx_set_cancel(ix_ctx *ctx, const volatile int *flag);

/* Called now and then during long computations, at most ten times a second:
 * what is being computed (a function's name, "" if it has none) and which part
 * of it is done, 0 .. 1, negative if that is not known. what NULL: something
 * else is about to be written, what was shown should vanish. fn NULL (the
 * default): nobody watches. */
typedef void (*ix_progress_fn)(void *ud, const char *what, double part);
void ix_ctx_set_progress(ix_ctx *ctx, ix_progress_fn fn, void *ud);

/* Called with each remark that does not stop a computation ("weights change
 * sign"). NULL (the default): remarks are dropped. */
typedef void (*ix_note_fn)(void *ud, const char *text);
void ix_ctx_set_note(ix_ctx *ctx, ix_note_fn fn, void *ud);

/* The shortest decimal text that reads back as exactly v ("0.1", "1e-07",
 * "inf", "nan"), whatever the locale. buf has room for IX_NUM_MAX characters;
 * returns the length without the final NUL. */
#define IX_NUM_MAX 32
int ix_num_format(double v, char *buf);

/* Reads a decimal number at s (not beyond end), independently of the locale,
 * correctly rounded: [+-] digits [. digits] [e [+-] digits]. Returns the
 * first character after it, or NULL if there is no number. Overflow gives
 * +-inf. "nan", "inf" and hexadecimal are not numbers here. */
const char *ix_num_parse(const char *s, const char *end, double *out);

#ifdef __cplusplus
}
#endif
#endif
