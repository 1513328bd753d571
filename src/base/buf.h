/* buf.h - a growing byte string. After a failed append the buffer is marked
 * and stays as it was, so a writer can check once, at its end. With a sink it
 * holds the last bytes only: what came before has gone there. */
#ifndef BASE_BUF_H
#define BASE_BUF_H

#include <stdarg.h>

#include "base/ctx.h"

/* Bytes go to the sink in pieces of this size, the last one excepted, and not
 * before there are a few of them. */
#define IX_BUF_PIECE ((size_t)1 << 16)

/* Takes bytes over; what it fails with, ix__buf_check returns. */
typedef ix_status (*ix__sink_fn)(void *arg, const char *s, size_t n);

typedef struct {
    ix_ctx *ctx;
    char *data; /* always NUL-terminated once anything was appended */
    size_t len, cap;
    bool failed;      /* out of memory at some append */
    ix__sink_fn sink; /* NULL: everything stays in data */
    void *sink_arg;
    size_t drained; /* bytes that the sink has */
} ix_buf;

void ix__buf_init(ix_buf *b, ix_ctx *ctx);
void ix__buf_free(ix_buf *b);
void ix__buf_clear(ix_buf *b); /* keeps the memory */
void ix__buf_add(ix_buf *b, const char *s, size_t n);
void ix__buf_puts(ix_buf *b, const char *s);
void ix__buf_putc(ix_buf *b, char c);
void ix__buf_fill(ix_buf *b, char c, size_t n);
void ix__buf_num(ix_buf *b, double v); /* shortest round-trip form */
void ix__buf_int(ix_buf *b, long long v);
void ix__buf_printf(ix_buf *b, const char *fmt, ...) IX_PRINTF(2, 3);
/* IX_ENOMEM if any append failed. With a sink, whole pieces go there: data
 * moves, so that no writer may keep a place in it across this call. */
ix_status ix__buf_check(ix_buf *b) IX_MUST_CHECK;
/* The same, and with a sink everything goes there. */
ix_status ix__buf_flush(ix_buf *b) IX_MUST_CHECK;
/* Bytes appended so far, wherever they are. */
size_t ix__buf_total(const ix_buf *b);

#endif
