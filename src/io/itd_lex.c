/* itd_lex.c - tokens of the text format (spec/itd-format 1). Line and column
 * are counted only when a message needs them. */
#include "io/itd_lex.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MAX_WARNINGS 20 /* shown of one file */

/* --- characters ------------------------------------------------------- */

static bool is_blank(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

static bool is_control(char c)
{
    return (unsigned char)c < ' ' && !is_blank(c);
}

static bool ends_word(char c)
{
    return is_blank(c) || c == '[' || c == ']';
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

/* Columns count characters, so continuation bytes do not. Goes on from the
 * place that was asked for before, if it can. */
static ix_place place_of(ix__lex *l, const char *at)
{
    ix_place pl = {1, 1};
    const char *s = l->text;

    if (l->counted && l->counted <= at) {
        pl = l->place;
        s = l->counted;
    }
    for (; s < at; s++) {
        if (*s == '\n') {
            pl.line++;
            pl.col = 1;
        } else if (((unsigned char)*s & 0xc0) != 0x80) {
            pl.col++;
        }
    }
    l->counted = at;
    l->place = pl;
    return pl;
}

ix_status ix__lex_fail(ix__lex *l, const char *at, const char *fmt, ...)
{
    ix_place pl = place_of(l, at);
    char text[384];
    va_list ap;

    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    return IX_FAIL(l->ctx, IX_EPARSE, "%.100s:%d:%d: error: %s", l->fname,
                   pl.line, pl.col, text);
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

/* The innermost bracket that is open at the end: the last one that reached
 * the final depth. NULL if none. */
static const char *open_bracket(ix__lex *l)
{
    const char *at = NULL;
    int last = 0;

    for (int pass = 0; pass < 2; pass++) {
        ix__lex scan = *l;
        ix__token t = {0};
        int depth = 0;

        scan.p = l->text;
        while (ix__lex_next(&scan, &t) == IX_OK && t.kind != IX_T_END) {
            depth += t.kind == IX_T_OPEN ? 1 : t.kind == IX_T_CLOSE ? -1 : 0;
            if (pass == 1 && t.kind == IX_T_OPEN && depth == last)
                at = t.s;
        }
        last = depth;
    }
    return at;
}

ix_status ix__lex_unexpected(ix__lex *l, const ix__token *t, const char *wanted)
{
    const char *open;
    char text[48];
    ix_place pl;

    if (t->kind == IX_T_OPEN || t->kind == IX_T_CLOSE)
        return ix__lex_fail(l, t->s, "%s expected, found %c", wanted, *t->s);
    if (t->kind != IX_T_END) {
        show_token(t, text);
        return ix__lex_fail(l, t->s, "%s expected, found \"%s\"", wanted, text);
    }
    open = open_bracket(l);
    if (!open)
        return ix__lex_fail(l, t->s, "unexpected end of file, %s expected",
                            wanted);
    pl = place_of(l, open);
    return ix__lex_fail(
        l, t->s, "unexpected end of file, %s expected; [ opened at %d:%d",
        wanted, pl.line, pl.col);
}

void ix__lex_warn(ix__lex *l, const char *at, const char *fmt, ...)
{
    char text[384];
    ix_place pl;
    va_list ap;

    if (!l->ctx->note || ++l->warnings > MAX_WARNINGS)
        return;
    pl = place_of(l, at);
    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    ix__note(
        l->ctx, "%.100s:%d:%d: warning: %s%s", l->fname, pl.line, pl.col, text,
        l->warnings == MAX_WARNINGS ? " (further warnings not shown)" : "");
}

/* --- tokens ----------------------------------------------------------- */

void ix__lex_init(ix__lex *l, ix_ctx *ctx, const char *fname, const char *text,
                  size_t n)
{
    *l = (ix__lex){.ctx = ctx, .fname = fname, .text = text, .end = text + n};
    l->p = text;
    if (n >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        l->text = l->p = text + 3; /* byte order mark */
}

static ix_status bad_control(ix__lex *l, const char *at)
{
    return ix__lex_fail(l, at,
                        "control byte 0x%02x at offset %zu: not a text file",
                        (unsigned char)*at, (size_t)(at - l->text));
}

static ix_status next_quoted(ix__lex *l, ix__token *t)
{
    const char *s = l->p + 1;

    t->kind = IX_T_QUOTED;
    t->s = s;
    while (s < l->end && *s != '"' && *s != '\n') {
        if (is_control(*s))
            return bad_control(l, s);
        if (*s == '\\' && s + 1 < l->end)
            s++;
        s++;
    }
    if (s < l->end && *s == '"') {
        t->end = s;
        l->p = s + 1;
        return IX_OK;
    }
    t->end = s > t->s && s[-1] == '\r' ? s - 1 : s; /* ended by the line */
    l->p = s;
    return IX_OK;
}

static ix_status next_word(ix__lex *l, ix__token *t, bool free_text)
{
    const char *s = l->p;

    t->kind = IX_T_WORD;
    t->s = s;
    while (s < l->end && !ends_word(*s)) {
        int n = free_text ? 1 : utf8_length(s, l->end);

        if (is_control(*s))
            return bad_control(l, s);
        if (n == 0)
            return ix__lex_fail(l, s, "byte 0x%02x at offset %zu is not UTF-8",
                                (unsigned char)*s, (size_t)(s - l->text));
        s += n;
    }
    t->end = l->p = s;
    return IX_OK;
}

static ix_status next_token(ix__lex *l, ix__token *t, bool free_text)
{
    while (l->p < l->end && is_blank(*l->p))
        l->p++;
    t->s = t->end = l->p;
    t->kind = IX_T_END;
    if (l->p == l->end)
        return IX_OK;
    if (*l->p == '"')
        return next_quoted(l, t);
    if (*l->p != '[' && *l->p != ']')
        return next_word(l, t, free_text);
    t->kind = *l->p == '[' ? IX_T_OPEN : IX_T_CLOSE;
    t->end = ++l->p;
    return IX_OK;
}

ix_status ix__lex_next(ix__lex *l, ix__token *t)
{
    return next_token(l, t, false);
}

ix_status ix__lex_peek(ix__lex *l, ix__token *t)
{
    const char *p = l->p;
    ix_status st = next_token(l, t, false);

    l->p = p;
    return st;
}

ix_status ix__lex_skip_junk(ix__lex *l, ix__token *t)
{
    const char *p;

    do {
        p = l->p;
        IX_TRY(next_token(l, t, true));
    } while (t->kind == IX_T_WORD || t->kind == IX_T_QUOTED);
    l->p = p;
    return IX_OK;
}

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

static ix_status bad_number(ix__lex *l, const char *wanted)
{
    char text[48];
    ix__token t;
    double v;

    IX_TRY(ix__lex_next(l, &t));
    if (t.kind == IX_T_WORD && ix_num_parse(t.s, t.end, &v) == t.end) {
        show_token(&t, text);
        return ix__lex_fail(l, t.s, "number %s is out of range (1.8e308)",
                            text);
    }
    return ix__lex_unexpected(l, &t, wanted);
}

ix_status ix__lex_num(ix__lex *l, const char *wanted, double *v)
{
    const char *p = l->p, *e;

    while (p < l->end && is_blank(*p))
        p++;
    e = ix_num_parse(p, l->end, v);
    if (!e || (e < l->end && !ends_word(*e)) || !isfinite(*v))
        return bad_number(l, wanted);
    l->p = e;
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
        return ix__lex_fail(l, t.s, "%s is %s; it must be in %d .. %d", what,
                            text, lo, hi);
    if (x != floor(x))
        return ix__lex_fail(l, t.s, "%s is %s; it must be an integer", what,
                            text);
    *v = (int)x;
    return IX_OK;
}

ix_status ix__lex_room(ix__lex *l, const char *at, double n, int item_bytes,
                       const char *items)
{
    const double small = 65536; /* the end of the file will be met soon */
    size_t left = (size_t)(l->end - l->p);

    if (n * item_bytes <= fmax(small, (double)left))
        return IX_OK;
    return ix__lex_fail(l, at,
                        "%.0f %s cannot stand in the %zu bytes left; is the "
                        "file cut short?",
                        n, items, left);
}
