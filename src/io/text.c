/* text.c - the window of a reader, and the places of its messages. What counts
 * lines goes through the text behind the reader, and goes on from the place
 * that was asked for before, if it can. */
#include "io/text.h"

#include <stdio.h>
#include <string.h>

enum { MAX_WARNINGS = 20, COUNTED = 1 << 14 };

/* --- the window ------------------------------------------------------- */

ix_status ix__text_init(ix__text *t, ix__input *src)
{
    size_t piece = ix__input_piece(src);

    *t = (ix__text){.ctx = ix__input_ctx(src), .src = src};
    t->window = ix__alloc(t->ctx, piece);
    if (!t->window)
        return IX_ENOMEM;
    t->cap = piece;
    t->p = t->end = t->window;
    return IX_OK;
}

/* A word that fills half of the window: twice the size, so that the bytes are
 * moved a bounded number of times. */
static ix_status widen(ix__text *t, size_t kept)
{
    size_t cap = 2 * t->cap;
    char *w = ix__alloc(t->ctx, cap);

    if (!w)
        return IX_ENOMEM;
    memcpy(w, t->p, kept);
    ix__free(t->ctx, t->window, t->cap);
    t->window = w;
    t->cap = cap;
    return IX_OK;
}

ix_status ix__text_more(ix__text *t)
{
    size_t kept = (size_t)(t->end - t->p), room, n;
    size_t passed = (size_t)(t->p - t->window);

    if (t->eof)
        return IX_OK;
    if (kept > t->cap / 2)
        IX_TRY(widen(t, kept));
    else
        memmove(t->window, t->p, kept);
    t->offset += passed;
    t->p = t->window;
    t->end = t->p + kept;
    room = t->cap - kept;
    IX_TRY(ix__input_read(t->src, t->window + kept, room, &n));
    t->end += n;
    t->eof = n < room;
    return IX_OK;
}

size_t ix__text_at(const ix__text *t, const char *s)
{
    return t->offset + (size_t)(s - t->window);
}

size_t ix__text_left(const ix__text *t)
{
    size_t most = ix__input_most(t->src), at = ix__text_at(t, t->p);

    if (t->eof)
        return (size_t)(t->end - t->p);
    return most > at ? most - at : 0;
}

/* --- places ----------------------------------------------------------- */

struct ix__counter {
    ix_ctx *ctx;
    ix__input *src;
    ix_place place; /* of at */
    size_t at, n;   /* n bytes are at p */
    const char *p;
    char piece[COUNTED];
};

static void drop_counter(ix__counter *c)
{
    if (!c)
        return;
    ix__input_close(c->src);
    ix__free(c->ctx, c, sizeof *c);
}

static ix_status new_counter(const ix__text *t, ix__counter **out)
{
    ix__counter *c = ix__alloc(t->ctx, sizeof *c);
    ix_status st;

    *out = NULL;
    if (!c)
        return IX_ENOMEM;
    c->ctx = t->ctx;
    c->place = (ix_place){1, 1};
    c->at = c->n = 0;
    st = ix__input_again(t->src, &c->src);
    if (st == IX_OK)
        *out = c;
    else
        ix__free(t->ctx, c, sizeof *c);
    return st;
}

static void count(ix__counter *c, size_t n)
{
    ix_place pl = c->place;

    for (const char *end = c->p + n; c->p < end; c->p++) {
        if (*c->p == '\n') {
            pl.line++;
            pl.col = 1;
        } else if (((unsigned char)*c->p & 0xc0) != 0x80) {
            pl.col++;
        }
    }
    c->place = pl;
    c->at += n;
    c->n -= n;
}

static ix_status count_to(ix__counter *c, size_t at)
{
    while (c->at < at) {
        if (c->n == 0) {
            IX_TRY(ix__input_read(c->src, c->piece, sizeof c->piece, &c->n));
            c->p = c->piece;
        }
        if (c->n == 0)
            return IX_OK; /* the file has become shorter */
        count(c, c->n < at - c->at ? c->n : at - c->at);
    }
    return IX_OK;
}

ix_status ix__text_place(ix__text *t, size_t at, ix_place *pl)
{
    *pl = (ix_place){0};
    if (t->counter && t->counter->at > at) {
        drop_counter(t->counter);
        t->counter = NULL;
    }
    if (!t->counter)
        IX_TRY(new_counter(t, &t->counter));
    IX_TRY(count_to(t->counter, at));
    *pl = t->counter->place;
    return IX_OK;
}

void ix__text_free(ix__text *t)
{
    drop_counter(t->counter);
    ix__free(t->ctx, t->window, t->cap);
    *t = (ix__text){.ctx = t->ctx};
}

/* --- messages --------------------------------------------------------- */

ix_status ix__text_fail(ix__text *t, size_t at, const char *fmt, va_list ap)
{
    char text[384];
    ix_place pl;

    (void)vsnprintf(text, sizeof text, fmt, ap);
    IX_TRY(ix__text_place(t, at, &pl));
    return IX_FAIL(t->ctx, IX_EPARSE, "%.100s:%d:%d: error: %s",
                   ix__input_name(t->src), pl.line, pl.col, text);
}

/* Without memory for the place there is no warning. */
void ix__text_warn(ix__text *t, size_t at, const char *fmt, va_list ap)
{
    char text[384];
    ix_place pl;

    if (!t->ctx->note || ++t->warnings > MAX_WARNINGS)
        return;
    (void)vsnprintf(text, sizeof text, fmt, ap);
    if (ix__text_place(t, at, &pl) != IX_OK)
        return;
    ix__note(t->ctx, "%.100s:%d:%d: warning: %s%s", ix__input_name(t->src),
             pl.line, pl.col, text,
             t->warnings == MAX_WARNINGS ? " (further warnings not shown)"
                                         : "");
}
