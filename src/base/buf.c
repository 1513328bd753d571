/* buf.c - a growing byte string. */
#include "base/buf.h"

#include <stdio.h>
#include <string.h>

void ix__buf_init(ix_buf *b, ix_ctx *ctx)
{
    *b = (ix_buf){.ctx = ctx};
}

void ix__buf_free(ix_buf *b)
{
    ix__free(b->ctx, b->data, b->cap);
    *b = (ix_buf){.ctx = b->ctx};
}

void ix__buf_clear(ix_buf *b)
{
    b->len = 0;
    b->failed = false;
    if (b->data)
        b->data[0] = '\0';
}

static bool reserve(ix_buf *b, size_t extra)
{
    size_t need, cap;
    char *p;

    if (b->failed)
        return false;
    if (extra >= SIZE_MAX / 4 - b->len) { /* so that doubling cannot wrap */
        b->failed = true;
        return false;
    }
    need = b->len + extra + 1;
    if (need <= b->cap)
        return true;
    cap = b->cap ? b->cap : 256;
    while (cap < need)
        cap += cap;
    p = ix__realloc(b->ctx, b->data, b->cap, cap);
    if (!p) {
        b->failed = true;
        return false;
    }
    b->data = p;
    b->cap = cap;
    return true;
}

void ix__buf_add(ix_buf *b, const char *s, size_t n)
{
    if (!reserve(b, n))
        return;
    memcpy(b->data + b->len, s, n);
    b->len += n;
    b->data[b->len] = '\0';
}

void ix__buf_puts(ix_buf *b, const char *s)
{
    ix__buf_add(b, s, strlen(s));
}

void ix__buf_putc(ix_buf *b, char c)
{
    ix__buf_add(b, &c, 1);
}

void ix__buf_fill(ix_buf *b, char c, size_t n)
{
    if (!reserve(b, n))
        return;
    memset(b->data + b->len, c, n);
    b->len += n;
    b->data[b->len] = '\0';
}

void ix__buf_num(ix_buf *b, double v)
{
    if (reserve(b, IX_NUM_MAX))
        b->len += (size_t)ix_num_format(v, b->data + b->len);
}

void ix__buf_int(ix_buf *b, long long v)
{
    ix__buf_printf(b, "%lld", v);
}

void ix__buf_printf(ix_buf *b, const char *fmt, ...)
{
    va_list ap, again;
    int n;

    va_start(ap, fmt);
    va_copy(again, ap);
    n = vsnprintf(NULL, 0, fmt, ap);
    va_end(ap);
    if (n >= 0 && reserve(b, (size_t)n)) {
        (void)vsnprintf(b->data + b->len, (size_t)n + 1, fmt, again);
        b->len += (size_t)n;
    }
    va_end(again);
}

size_t ix__buf_total(const ix_buf *b)
{
    return b->drained + b->len;
}

/* The first n bytes, piece by piece. */
static ix_status drain(ix_buf *b, size_t n)
{
    for (size_t at = 0; at < n; at += IX_BUF_PIECE)
        IX_TRY(b->sink(b->sink_arg, b->data + at,
                       n - at < IX_BUF_PIECE ? n - at : IX_BUF_PIECE));
    memmove(b->data, b->data + n, b->len - n + 1);
    b->len -= n;
    b->drained += n;
    return IX_OK;
}

ix_status ix__buf_check(ix_buf *b)
{
    if (b->failed)
        return IX_FAIL(b->ctx, IX_ENOMEM, "out of memory for text");
    if (!b->sink || b->len < 2 * IX_BUF_PIECE)
        return IX_OK;
    return drain(b, b->len / IX_BUF_PIECE * IX_BUF_PIECE);
}

ix_status ix__buf_flush(ix_buf *b)
{
    IX_TRY(ix__buf_check(b));
    return b->sink && b->len > 0 ? drain(b, b->len) : IX_OK;
}
