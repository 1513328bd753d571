/* text.h - a window that moves over a text, and messages with places in it.
 *
 * Places are offsets from the start of the text. Lines and columns are counted
 * when a message needs them, by reading the text once more. */
#ifndef IO_TEXT_H
#define IO_TEXT_H

#include <stdarg.h>

#include "io/input.h"

typedef struct ix__counter ix__counter;

typedef struct {
    ix_ctx *ctx;
    ix__input *src;
    const char *p, *end; /* in the window: what is not read yet */
    bool eof;            /* end is the end of the text */
    char *window;
    size_t cap, offset; /* of the window's first byte in the text */
    int warnings;       /* so far; the first few are shown */
    ix__counter *counter;
} ix__text;

/* src stays the caller's. t is to be freed whatever this returns. */
ix_status ix__text_init(ix__text *t, ix__input *src) IX_MUST_CHECK;
void ix__text_free(ix__text *t);
/* Adds a piece behind end, unless it is the end. The bytes before p go; p and
 * end move, and with them all pointers into the window. */
ix_status ix__text_more(ix__text *t) IX_MUST_CHECK;
/* At least n bytes from p on, as far as the text has them. */
static inline IX_MUST_CHECK
ix_status ix__text_ahead(ix__text *t, size_t n)
{
    while ((size_t)(t->end - t->p) < n && !t->eof)
        IX_TRY(ix__text_more(t));
    return IX_OK;
}
size_t ix__text_at(const ix__text *t, const char *s); /* s is in the window */
/* The text has at most so many bytes from p on. */
size_t ix__text_left(const ix__text *t);

/* Columns count characters, so continuation bytes of UTF-8 do not. */
ix_status ix__text_place(ix__text *t, size_t at, ix_place *pl) IX_MUST_CHECK;
/* IX_EPARSE with "name:line:col: error: " and the text. */
ix_status ix__text_fail(ix__text *t, size_t at, const char *fmt, va_list ap)
    IX_PRINTF(3, 0);
/* A note, "name:line:col: warning: " and the text; the first 20 of a file. */
void ix__text_warn(ix__text *t, size_t at, const char *fmt, va_list ap)
    IX_PRINTF(3, 0);

#endif
