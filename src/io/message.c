/* message.c - the ends of messages (spec/ipc 4.1): a machine over single bytes,
 * so that a message may come in any pieces. What it keeps is the message as the
 * reader of files wants it: strings escaped. */
#include "io/message.h"

#include <string.h>

#include "io/ibd.h"

enum {
    OUTSIDE, /* between messages */
    PLAIN,
    STRING, /* the text of a line [STRING "..."], its end is not known yet */
    QUOTED, /* any other quoted text */
    ESCAPED /* behind a backslash in it */
};

#define USUAL ((size_t)1 << 20) /* bytes of a buffer worth keeping */

void ix__message_init(ix__message *m, ix_ctx *ctx)
{
    *m = (ix__message){.state = OUTSIDE};
    ix__buf_init(&m->text, ctx);
}

void ix__message_free(ix__message *m)
{
    ix__buf_free(&m->text);
}

void ix__message_clear(ix__message *m)
{
    ix_buf text = m->text;

    ix__buf_clear(&text);
    if (text.cap > USUAL)
        ix__buf_free(&text);
    *m = (ix__message){.state = OUTSIDE, .text = text};
}

/* --- lines ---------------------------------------------------------------- */

/* Without the blanks around it. */
static const char *trimmed(const char *s, size_t n, size_t *len)
{
    while (n > 0 && (*s == ' ' || *s == '\t'))
        s++, n--;
    while (n > 0 && (s[n - 1] == ' ' || s[n - 1] == '\r' || s[n - 1] == '\t'))
        n--;
    *len = n;
    return s;
}

static bool begins(const char *s, size_t n, const char *word)
{
    size_t k = strlen(word);

    return n >= k && memcmp(s, word, k) == 0;
}

/* Does the line so far read [STRING and a blank? */
static bool before_string(const ix__message *m)
{
    static const char word[] = "[STRING";
    size_t n;
    const char *s = trimmed(m->text.data + m->line[0], m->text.len - m->line[0],
                            &n);

    return n == sizeof word - 1 && memcmp(s, word, n) == 0;
}

/* The last "[OBJECT" of s[n]; NULL: there is none. */
static const char *last_object(const char *s, size_t n)
{
    for (size_t i = n; i > 0; i--)
        if (begins(s + i - 1, n - i + 1, "[OBJECT"))
            return s + i - 1;
    return NULL;
}

/* The line that has just ended is the head of a request, its third line, and
 * the two before it agree; where they begin. */
static bool head_ends(const ix__message *m, size_t *start)
{
    static const char head[] = "[STRING \"" IX_MESSAGE_HEAD "\"]";
    const char *t = m->text.data, *s;
    size_t n;

    s = trimmed(t + m->line[0], m->text.len - m->line[0], &n);
    if (n != sizeof head - 1 || memcmp(s, head, n) != 0 ||
        m->line[1] >= m->line[0] || m->line[2] >= m->line[1])
        return false;
    s = trimmed(t + m->line[1], m->line[0] - m->line[1], &n);
    if (!begins(s, n, "[OBJECT"))
        return false;
    s = last_object(t + m->line[2], m->line[1] - m->line[2]);
    *start = s ? (size_t)(s - t) : 0;
    return s != NULL;
}

/* What stood before was never finished. */
static void restart(ix__message *m, size_t start)
{
    memmove(m->text.data, m->text.data + start, m->text.len - start + 1);
    m->text.len -= start;
    m->line[2] = 0;
    m->line[1] -= start;
    m->line[0] -= start;
    m->depth = 2;
    m->state = PLAIN;
}

/* A line has ended. True: it turned out that a request begins in it. */
static bool next_line(ix__message *m)
{
    size_t start;
    bool found = head_ends(m, &start) && start > 0;

    if (found)
        restart(m, start);
    ix__buf_putc(&m->text, '\n');
    m->line[2] = m->line[1];
    m->line[1] = m->line[0];
    m->line[0] = m->text.len;
    return found;
}

/* --- strings -------------------------------------------------------------- */

/* The place behind the last "] of this line of a string; 0: there is none. */
static size_t string_end(const ix__message *m)
{
    const char *t = m->text.data;

    for (size_t i = m->text.len; i >= m->part + 2; i--)
        if (t[i - 1] == ']' && t[i - 2] == '"')
            return i;
    return 0;
}

/* The text from m->string to end gets backslashes; what is behind it stays. */
static ix_status escape(ix__message *m, size_t end)
{
    ix_buf *b = &m->text;
    ix_mark mk = ix__scratch_mark(b->ctx);
    size_t n = b->len - m->string;
    char *raw = ix__scratch(b->ctx, n + 1, 1);

    if (!raw)
        return IX_ENOMEM;
    memcpy(raw, b->data + m->string, n);
    b->len = m->string;
    for (size_t i = 0; i < n; i++) {
        if (m->string + i < end && (raw[i] == '"' || raw[i] == '\\'))
            ix__buf_putc(b, '\\');
        ix__buf_putc(b, raw[i]);
    }
    ix__scratch_release(b->ctx, mk);
    return ix__buf_check(b);
}

/* Brackets and quotes in what followed a string in its line. */
static void count_rest(ix__message *m, const char *s, const char *end)
{
    for (; s < end && m->depth > 0; s++)
        m->depth += *s == '[' ? 1 : *s == ']' ? -1 : 0;
}

/* A line of a string has ended, and perhaps the string. */
static ix_status end_string_line(ix__message *m)
{
    size_t end = string_end(m), start, rest;

    if (m->part > m->string && head_ends(m, &start)) {
        (void)next_line(m);
        return ix__buf_check(&m->text);
    }
    if (end == 0) {
        (void)next_line(m);
        IX_TRY(ix__buf_check(&m->text));
        m->text.data[m->text.len - 1] = ' '; /* a line end in the text */
        m->part = m->text.len;
        return IX_OK;
    }
    rest = m->text.len - end;
    IX_TRY(escape(m, end - 2));
    m->state = PLAIN;
    m->depth--; /* of the string */
    count_rest(m, m->text.data + m->text.len - rest,
               m->text.data + m->text.len);
    if (m->depth > 0)
        (void)next_line(m);
    return ix__buf_check(&m->text);
}

/* --- bytes ---------------------------------------------------------------- */

static void plain(ix__message *m, char c)
{
    if (c == '\n') {
        (void)next_line(m);
        return;
    }
    if (c == '"') {
        m->state = before_string(m) ? STRING : QUOTED;
        m->string = m->part = m->text.len + 1;
    }
    m->depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    ix__buf_putc(&m->text, c);
}

static void quoted(ix__message *m, char c)
{
    if (c == '\n') { /* ends the text, too */
        m->state = PLAIN;
        (void)next_line(m);
        return;
    }
    if (m->state == ESCAPED || c == '\\')
        m->state = m->state == ESCAPED ? QUOTED : ESCAPED;
    else if (c == '"')
        m->state = PLAIN;
    ix__buf_putc(&m->text, c);
}

static ix_status feed_byte(ix__message *m, char c)
{
    switch (m->state) {
    case OUTSIDE:
        if (c != '[')
            return IX_OK;
        m->state = PLAIN;
        plain(m, c);
        return IX_OK;
    case PLAIN:
        plain(m, c);
        return IX_OK;
    case STRING:
        if (c == '\n')
            return end_string_line(m);
        ix__buf_putc(&m->text, c);
        return IX_OK;
    default:
        quoted(m, c);
        return IX_OK;
    }
}

ix_status ix__message_feed(ix__message *m, const char *s, size_t n,
                           size_t *used, bool *complete)
{
    ix_ctx *ctx = m->text.ctx;

    *complete = false;
    for (*used = 0; *used < n && !*complete; ++*used) {
        IX_TRY(feed_byte(m, s[*used]));
        *complete = m->state != OUTSIDE && m->depth == 0;
    }
    IX_TRY(ix__buf_check(&m->text));
    if (m->text.len > IX_MAX_TEXT)
        return IX_FAIL(ctx, IX_EUNABLE, "a message of more than %zu bytes",
                       IX_MAX_TEXT);
    return IX_OK;
}

/* --- requests ------------------------------------------------------------- */

bool ix__message_is_request(const ix__message *m, double *seq)
{
    static const char number[] = "[NUMBER ";
    const char *t = m->text.data, *end = t + m->text.len, *s;
    const char *first = t ? strstr(t, "[STRING \"") : NULL;

    *seq = 0;
    if (!first ||
        !begins(first + 9, (size_t)(end - first) - 9, IX_MESSAGE_HEAD "\"]"))
        return false;
    for (s = t; s < first; s++) /* two names stand before it, nothing else */
        if (*s == '[' && !begins(s, (size_t)(end - s), "[OBJECT"))
            return false;
    s = strstr(first, number);
    if (s && !ix_num_parse(s + sizeof number - 1, end, seq))
        *seq = 0;
    return true;
}

/* The first number record; blocks are little-endian. */
static double record_number(const char *s, const char *end)
{
    static const char sync[] = {IX_OBJ_NUMBER, (char)0x80, 0x16, 0x43};
    double v = 0;

    for (; end - s >= 4 + IX_IBD_OBJECT; s++) {
        if (memcmp(s, sync, sizeof sync) != 0)
            continue;
        memcpy(&v, s + 4 + IX_IBD_REAL(0), sizeof v);
        break;
    }
    return v;
}

bool ix__record_is_request(const char *s, size_t n, double *seq)
{
    static const char head[] = IX_MESSAGE_HEAD;
    const char *end = s + n;

    *seq = 0;
    for (; end - s >= (ptrdiff_t)sizeof head; s++) {
        if (memcmp(s, head, sizeof head) != 0)
            continue;
        *seq = record_number(s, end);
        return true;
    }
    return false;
}
