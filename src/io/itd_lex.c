/* itd_lex.c - tokens of the text format (spec/itd-format 1). What is being
 * looked at stays in the window: a token that reaches its end makes it move. */
#include "io/itd_lex.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Bytes that a number and the blanks before it rarely exceed, and those that a
 * character may have. */
enum { NUMBER_ROOM = 64, CHAR_ROOM = 4 };

/* --- characters ------------------------------------------------------- */

bool ix__lex_blank(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

static bool is_control(char c)
{
    return (unsigned char)c < ' ' && !ix__lex_blank(c);
}

static bool ends_word(char c)
{
    return ix__lex_blank(c) || c == '[' || c == ']';
}

/* Length of the UTF-8 sequence at s, 0 if it is none (RFC 3629: no overlong
 * forms, no surrogates, nothing above U+10FFFF). */
static int utf8_length(const char *s, const char *end)
{
    const unsigned char *u = (const unsigned char *)s;
    int n = u[0] < 0x80                    ? 1
            : u[0] >= 0xc2 && u[0] <= 0xdf ? 2
            : (u[0] & 0xf0) == 0xe0        ? 3
            : u[0] >= 0xf0 && u[0] <= 0xf4 ? 4
                                           : 0;

    if (n == 0 || end - s < n)
        return 0;
    for (int i = 1; i < n; i++)
        if ((u[i] & 0xc0) != 0x80)
            return 0;
    if ((u[0] == 0xe0 && u[1] < 0xa0) || (u[0] == 0xed && u[1] > 0x9f) ||
        (u[0] == 0xf0 && u[1] < 0x90) || (u[0] == 0xf4 && u[1] > 0x8f))
        return 0;
    return n;
}

/* --- messages --------------------------------------------------------- */

ix_status ix__lex_fail(ix__lex *l, size_t at, const char *fmt, ...)
{
    ix_status st;
    va_list ap;

    va_start(ap, fmt);
    st = ix__text_fail(&l->t, at, fmt, ap);
    va_end(ap);
    return st;
}

void ix__lex_warn(ix__lex *l, size_t at, const char *fmt, ...)
{
    va_list ap;

    va_start(ap, fmt);
    ix__text_warn(&l->t, at, fmt, ap);
    va_end(ap);
}

size_t ix__lex_at(const ix__lex *l)
{
    return ix__text_at(&l->t, l->t.p);
}

ix_status ix__lex_init(ix__lex *l, ix__input *src)
{
    *l = (ix__lex){.ctx = ix__input_ctx(src)};
    return ix__text_init(&l->t, src);
}

void ix__lex_free(ix__lex *l)
{
    ix__text_free(&l->t);
}

/* A token for a message: at most 40 bytes, printable. */
static void show_token(const ix__token *t, char out[48])
{
    size_t n = (size_t)(t->end - t->s), k = 0;

    for (size_t i = 0; i < n && k < 40; i++)
        out[k++] = (unsigned char)t->s[i] < ' ' ? '?' : t->s[i];
    if (n > 40)
        memcpy(out + k, "...", 3), k += 3;
    out[k] = '\0';
}

/* --- tokens ----------------------------------------------------------- */

static ix_status bad_control(ix__lex *l, const char *s)
{
    size_t at = ix__text_at(&l->t, s);

    return ix__lex_fail(l, at,
                        "control byte 0x%02x at offset %zu: not a text file",
                        (unsigned char)*s, at);
}

/* Room for a character at s, which is behind p; s moves with the window. */
static inline ix_status char_room(ix__lex *l, const char **s)
{
    size_t k = (size_t)(*s - l->t.p);

    if (l->t.end - *s >= CHAR_ROOM || l->t.eof)
        return IX_OK;
    IX_TRY(ix__text_ahead(&l->t, k + CHAR_ROOM));
    *s = l->t.p + k;
    return IX_OK;
}

static ix_status next_quoted(ix__lex *l, ix__token *t)
{
    const char *s = l->t.p + 1;

    t->kind = IX_T_QUOTED;
    for (;;) {
        IX_TRY(char_room(l, &s));
        if (s == l->t.end || *s == '"' || *s == '\n')
            break;
        if (is_control(*s))
            return bad_control(l, s);
        if (*s == '\\' && s + 1 < l->t.end)
            s++;
        s++;
    }
    t->s = l->t.p + 1;
    t->at++;
    if (s < l->t.end && *s == '"') {
        t->end = s;
        l->t.p = s + 1;
        return IX_OK;
    }
    t->end = s > t->s && s[-1] == '\r' ? s - 1 : s; /* ended by the line */
    l->t.p = s;
    return IX_OK;
}

static ix_status next_word(ix__lex *l, ix__token *t, bool free_text)
{
    const char *s = l->t.p;

    t->kind = IX_T_WORD;
    for (;;) {
        int n;

        IX_TRY(char_room(l, &s));
        if (s == l->t.end || ends_word(*s))
            break;
        n = free_text ? 1 : utf8_length(s, l->t.end);
        if (is_control(*s))
            return bad_control(l, s);
        if (n == 0)
            return ix__lex_fail(l, ix__text_at(&l->t, s),
                                "byte 0x%02x at offset %zu is not UTF-8",
                                (unsigned char)*s, ix__text_at(&l->t, s));
        s += n;
    }
    t->s = l->t.p;
    t->end = l->t.p = s;
    return IX_OK;
}

static ix_status skip_blanks(ix__lex *l)
{
    for (;;) {
        while (l->t.p < l->t.end && ix__lex_blank(*l->t.p))
            l->t.p++;
        if (l->t.p < l->t.end || l->t.eof)
            return IX_OK;
        IX_TRY(ix__text_more(&l->t));
    }
}

static ix_status next_token(ix__lex *l, ix__token *t, bool free_text)
{
    IX_TRY(skip_blanks(l));
    t->s = t->end = l->t.p;
    t->at = ix__lex_at(l);
    t->kind = IX_T_END;
    if (l->t.p == l->t.end)
        return IX_OK;
    if (*l->t.p == '"')
        return next_quoted(l, t);
    if (*l->t.p != '[' && *l->t.p != ']')
        return next_word(l, t, free_text);
    t->kind = *l->t.p == '[' ? IX_T_OPEN : IX_T_CLOSE;
    t->end = ++l->t.p;
    return IX_OK;
}

/* The token is the next one again; nothing has been read since. */
static void push_back(ix__lex *l, const ix__token *t)
{
    l->t.p = t->kind == IX_T_QUOTED ? t->s - 1 : t->s;
}

ix_status ix__lex_next(ix__lex *l, ix__token *t)
{
    return next_token(l, t, false);
}

ix_status ix__lex_peek(ix__lex *l, ix__token *t)
{
    IX_TRY(next_token(l, t, false));
    push_back(l, t);
    return IX_OK;
}

ix_status ix__lex_skip_junk(ix__lex *l, ix__token *t)
{
    do
        IX_TRY(next_token(l, t, true));
    while (t->kind == IX_T_WORD || t->kind == IX_T_QUOTED);
    push_back(l, t);
    return IX_OK;
}

/* --- what did not come ------------------------------------------------ */

/* Where the innermost bracket is that is open at the end of the text: the last
 * one that reached the final depth. First pass: that depth. */
static ix_status last_open(ix__lex *l, int *depth, size_t *at)
{
    int now = 0, last = *depth;
    ix__token t;

    for (;;) {
        IX_TRY(ix__lex_next(l, &t));
        now += t.kind == IX_T_OPEN ? 1 : t.kind == IX_T_CLOSE ? -1 : 0;
        if (t.kind == IX_T_OPEN && now == last)
            *at = t.at;
        if (t.kind == IX_T_END)
            break;
    }
    *depth = now;
    return IX_OK;
}

/* *depth 0 if none is open. */
static ix_status open_bracket(const ix__lex *l, int *depth, size_t *at)
{
    ix_status st = IX_OK;

    *depth = 0;
    for (int pass = 0; st == IX_OK && pass < 2; pass++) {
        ix__input *again;
        ix__lex scan;

        IX_TRY(ix__input_again(l->t.src, &again));
        st = ix__lex_init(&scan, again);
        if (st == IX_OK)
            st = last_open(&scan, depth, at);
        ix__lex_free(&scan);
        ix__input_close(again);
    }
    return st;
}

static ix_status early_end(ix__lex *l, size_t at, const char *wanted)
{
    size_t open = 0;
    int depth;
    ix_place pl;
    ix_status st = open_bracket(l, &depth, &open);

    if (st != IX_OK && st != IX_EPARSE) /* bytes that only junk may have */
        return st;
    if (st != IX_OK || depth <= 0)
        return ix__lex_fail(l, at, "unexpected end of file, %s expected",
                            wanted);
    IX_TRY(ix__text_place(&l->t, open, &pl));
    return ix__lex_fail(
        l, at, "unexpected end of file, %s expected; [ opened at %d:%d", wanted,
        pl.line, pl.col);
}

ix_status ix__lex_unexpected(ix__lex *l, const ix__token *t, const char *wanted)
{
    char text[48];

    if (t->kind == IX_T_END)
        return early_end(l, t->at, wanted);
    if (t->kind == IX_T_OPEN || t->kind == IX_T_CLOSE)
        return ix__lex_fail(l, t->at, "%s expected, found %c", wanted,
                            t->kind == IX_T_OPEN ? '[' : ']');
    show_token(t, text);
    return ix__lex_fail(l, t->at, "%s expected, found \"%s\"", wanted, text);
}

/* --- words ------------------------------------------------------------ */

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool ix__token_is(const ix__token *t, const char *keyword)
{
    const char *s = t->s;

    if (t->kind != IX_T_WORD)
        return false;
    while (s < t->end && *keyword && lower(*s) == lower(*keyword)) {
        s++;
        keyword++;
    }
    return s == t->end && !*keyword;
}

ix_status ix__token_text(ix__lex *l, const ix__token *t, char **out, size_t *n)
{
    size_t k = 0;
    char *text;

    IX_SCRATCH(l->ctx, text, (size_t)(t->end - t->s) + 1);
    for (const char *s = t->s; s < t->end; s++) {
        if (t->kind == IX_T_QUOTED && *s == '\\' && s + 1 < t->end)
            s++;
        text[k++] = *s;
    }
    text[k] = '\0';
    *out = text;
    *n = k;
    return IX_OK;
}

/* --- what must come --------------------------------------------------- */

ix_status ix__lex_open(ix__lex *l)
{
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    return t.kind == IX_T_OPEN ? IX_OK : ix__lex_unexpected(l, &t, "[");
}

ix_status ix__lex_close(ix__lex *l, const char *wanted)
{
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    return t.kind == IX_T_CLOSE ? IX_OK : ix__lex_unexpected(l, &t, wanted);
}

/* A number that the window cut, or none. */
static ix_status careful_number(ix__lex *l, const char *wanted, double *v)
{
    char text[48];
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    if (t.kind != IX_T_WORD || ix_num_parse(t.s, t.end, v) != t.end)
        return ix__lex_unexpected(l, &t, wanted);
    if (isfinite(*v))
        return IX_OK;
    show_token(&t, text);
    return ix__lex_fail(l, t.at, "number %s is out of range (1.8e308)", text);
}

ix_status ix__lex_num(ix__lex *l, const char *wanted, double *v)
{
    const char *p, *e;

    IX_TRY(ix__text_ahead(&l->t, NUMBER_ROOM));
    p = l->t.p;
    while (p < l->t.end && ix__lex_blank(*p))
        p++;
    e = ix_num_parse(p, l->t.end, v);
    if (!e || e == l->t.end || !ends_word(*e) || !isfinite(*v))
        return careful_number(l, wanted, v);
    l->t.p = e;
    return IX_OK;
}

ix_status ix__lex_nums(ix__lex *l, const char *wanted, int n, double *v)
{
    for (int i = 0; i < n; i++)
        IX_TRY(ix__lex_num(l, wanted, v + i));
    return IX_OK;
}

ix_status ix__lex_int(ix__lex *l, const char *what, int lo, int hi, int *v)
{
    char text[48], wanted[96];
    ix__token t;
    double x;

    IX_TRY(ix__lex_next(l, &t));
    if (t.kind != IX_T_WORD || ix_num_parse(t.s, t.end, &x) != t.end) {
        (void)snprintf(wanted, sizeof wanted, "an integer (%s)", what);
        return ix__lex_unexpected(l, &t, wanted);
    }
    show_token(&t, text);
    if (!(x >= lo && x <= hi))
        return ix__lex_fail(l, t.at, "%s is %s; it must be in %d .. %d", what,
                            text, lo, hi);
    if (x != floor(x))
        return ix__lex_fail(l, t.at, "%s is %s; it must be an integer", what,
                            text);
    *v = (int)x;
    return IX_OK;
}

ix_status ix__lex_room(ix__lex *l, size_t at, double n, int item_bytes,
                       const char *items)
{
    const double small = 65536; /* the end of the file will be met soon */
    size_t left = ix__text_left(&l->t);

    if (n * item_bytes <= fmax(small, (double)left))
        return IX_OK;
    return ix__lex_fail(l, at,
                        "%.0f %s cannot stand in the %zu bytes left; is the "
                        "file cut short?",
                        n, items, left);
}
