/* xml_scan.c - a look over XML text before a parser sees it: what is refused
 * outright is refused here, piece by piece and with its place. Markup cannot
 * hide from it: < stands for itself nowhere but in comments, CDATA and
 * instructions. */
#include "io/xml_scan.h"

#include <string.h>

static bool flawed(ix__xml_flaw *flaw, size_t at, const char *what)
{
    *flaw = (ix__xml_flaw){what, at};
    return false;
}

/* --- markup ------------------------------------------------------------- */

static void begin_until(ix__xml_scan *c, const char *mark)
{
    c->state = IX_XS_UNTIL;
    c->mark = mark;
    c->matched = 0;
}

/* Is s[0 .. n) the beginning of word, or all of it? */
static bool begins(const char *s, int n, const char *word)
{
    return strncmp(s, word, (size_t)n) == 0;
}

/* A character more behind <, until they tell what it opens. */
static bool take_head(ix__xml_scan *c, char ch, ix__xml_flaw *flaw)
{
    static const char comment[] = "!--", cdata[] = "![CDATA[";

    c->head[c->nhead++] = ch;
    if (*c->head == '?') {
        begin_until(c, "?>");
    } else if (*c->head != '!') {
        c->state = IX_XS_TAG;
        c->quote = '\0';
    } else if (!begins(c->head, c->nhead, comment) &&
               !begins(c->head, c->nhead, cdata)) {
        return flawed(flaw, c->open,
                      "a DOCTYPE or another declaration is refused");
    } else if (c->nhead == sizeof comment - 1 && c->head[1] == '-') {
        begin_until(c, "-->");
    } else if (c->nhead == sizeof cdata - 1) {
        begin_until(c, "]]>");
    }
    return true;
}

/* The tag up to the > that stands outside quotes, or to the end of the piece.
 */
static const char *skip_tag(ix__xml_scan *c, const char *p, const char *end)
{
    for (; p < end; p++) {
        if (!c->quote && *p == '>') {
            c->state = IX_XS_TEXT;
            return p + 1;
        }
        if (c->quote && *p == c->quote)
            c->quote = '\0';
        else if (!c->quote && (*p == '"' || *p == '\''))
            c->quote = *p;
    }
    return p;
}

/* Behind the closing mark, whose characters but the last are equal, or are one.
 */
static const char *skip_until(ix__xml_scan *c, const char *p, const char *end)
{
    int most = (int)strlen(c->mark) - 1;

    for (; p < end; p++) {
        if (*p == '>' && c->matched == most) {
            c->state = IX_XS_TEXT;
            return p + 1;
        }
        if (*p != *c->mark)
            c->matched = 0;
        else if (c->matched < most)
            c->matched++;
    }
    return p;
}

/* Of markup in this state that has got to offset at. */
static bool check_size(const ix__xml_scan *c, ix__xml_state state, size_t at,
                       ix__xml_flaw *flaw)
{
    if (state == IX_XS_TAG && at - c->open > IX_XML_MAX_TAG)
        return flawed(flaw, c->open, "a tag of more than 64 KiB");
    if (state == IX_XS_UNTIL && at - c->open > IX_XML_MAX_TEXT)
        return flawed(flaw, c->open, "a comment or CDATA of more than 8 MiB");
    return true;
}

/* A < and what it opens: where the text goes on, or NULL. */
static const char *begin_markup(ix__xml_scan *c, const char *p, size_t at,
                                ix__xml_flaw *flaw)
{
    c->open = at;
    c->state = IX_XS_OPEN;
    c->nhead = 0;
    if (++c->nodes <= IX_XML_MAX_NODES)
        return p + 1;
    (void)flawed(flaw, at, "more than 33554432 tags");
    return NULL;
}

static bool scan_piece(ix__xml_scan *c, const char *s, size_t n,
                       ix__xml_flaw *flaw)
{
    const char *p = s, *end = s + n;

    while (p < end) {
        ix__xml_state state = c->state;

        if (state == IX_XS_TEXT) {
            p = memchr(p, '<', (size_t)(end - p));
            if (!p)
                return true;
            p = begin_markup(c, p, c->done + (size_t)(p - s), flaw);
        } else if (state == IX_XS_TAG) {
            p = skip_tag(c, p, end);
        } else if (state == IX_XS_UNTIL) {
            p = skip_until(c, p, end);
        } else if (take_head(c, *p, flaw)) {
            /* the first character of a tag may end it, or be a quote */
            p += c->state != IX_XS_TAG;
        } else {
            return false;
        }
        if (!p || !check_size(c, state, c->done + (size_t)(p - s), flaw))
            return false;
    }
    return true;
}

/* --- encoding --------------------------------------------------------- */

static bool is_blank(char ch)
{
    return ch == ' ' || ch == '\t' || ch == '\n' || ch == '\r';
}

/* The value of encoding="..." in s[0 .. n), NULL if there is none. */
static const char *find_encoding(const char *s, size_t n, size_t *len)
{
    static const char word[] = "encoding";
    const char *end = s + n, *p = s, *close;

    while (p + sizeof word < end && memcmp(p, word, sizeof word - 1) != 0)
        p++;
    if (p + sizeof word >= end)
        return NULL;
    for (p += sizeof word - 1; p < end && (is_blank(*p) || *p == '=');)
        p++;
    if (p == end || (*p != '"' && *p != '\''))
        return NULL;
    close = memchr(p + 1, *p, (size_t)(end - p) - 1);
    if (!close)
        return NULL;
    *len = (size_t)(close - p) - 1;
    return p + 1;
}

static bool same_word(const char *s, size_t n, const char *word)
{
    char text[16];

    if (n != strlen(word) || n >= sizeof text)
        return false;
    memcpy(text, s, n);
    text[n] = '\0';
    return ix__name_cmp(text, word) == 0;
}

static bool check_encoding(const char *p, const char *end, ix__xml_flaw *flaw,
                           size_t at)
{
    size_t n = (size_t)(end - p), len;
    const char *close, *enc;

    if (n < 5 || memcmp(p, "<?xml", 5) != 0)
        return true;
    close = memchr(p, '>', n < 512 ? n : 512);
    enc = find_encoding(p, close ? (size_t)(close - p) : 0, &len);
    if (!enc || same_word(enc, len, "utf-8") || same_word(enc, len, "us-ascii"))
        return true;
    return flawed(flaw, at + (size_t)(enc - p),
                  "encoding UTF-8 expected, another is declared");
}

static bool check_start(const char *s, size_t n, ix__xml_flaw *flaw)
{
    const char *p = s, *end = s + n;

    while (p < end && is_blank(*p))
        p++;
    if (p == end || *p != '<')
        return flawed(flaw, (size_t)(p - s),
                      "< of an element expected: not XML in UTF-8");
    return check_encoding(p, end, flaw, (size_t)(p - s));
}

bool ix__xml_scan_piece(ix__xml_scan *c, const char *s, size_t n,
                        ix__xml_flaw *flaw)
{
    const char *nul = n > 0 ? memchr(s, '\0', n) : NULL;

    if (nul)
        return flawed(flaw, c->done + (size_t)(nul - s),
                      "a NUL byte: not XML in UTF-8");
    if (c->done == 0 && !check_start(s, n, flaw))
        return false;
    if (!scan_piece(c, s, n, flaw))
        return false;
    c->done += n;
    return true;
}
