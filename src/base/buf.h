/* buf.h - a growing byte string. After a failed append the buffer is marked
 * and stays as it was, so a writer can check once, at its end. */
#ifndef BASE_BUF_H
#define BASE_BUF_H

#include <stdarg.h>

#include "base/ctx.h"

typedef struct {
    ix_ctx *ctx;
    char *data; /* always NUL-terminated once anything was appended */
    size_t len, cap;
    bool failed; /* out of memory at some append */
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
/* IX_OK or IX_ENOMEM, the latter if any append failed. */
ix_status ix__buf_check(ix_buf *b) IX_MUST_CHECK;

#endif
