/* xml_scan.c - a look over XML text before a parser sees it: what is refused
 * outright is refused here, in one pass and with its place. Markup cannot hide
 * from it: < stands for itself nowhere but in comments, CDATA and
 * instructions. */
#include "io/xml_scan.h"

#include <string.h>

typedef struct {
    const char *s, *p, *end;
    size_t nodes;
    ix__xml_flaw *flaw;
} scan;

static bool flawed(scan *c, const char *at, const char *what)
{
    *c->flaw = (ix__xml_flaw){what, (size_t)(at - c->s)};
    return false;
}

static bool looking_at(const scan *c, const char *what)
{
    size_t n = strlen(what);

    return (size_t)(c->end - c->p) >= n && memcmp(c->p, what, n) == 0;
}

/* Moves behind the closing mark; an open end is the parser's to report. */
static bool skip_to(scan *c, const char *mark)
{
    const char *open = c->p;
    size_t n = strlen(mark);

    while (c->p < c->end && !looking_at(c, mark)) {
        const char *next = memchr(c->p + 1, *mark, (size_t)(c->end - c->p) - 1);

        c->p = next ? next : c->end;
    }
    if ((size_t)(c->p - open) > IX_XML_MAX_TEXT)
        return flawed(c, open, "a comment or CDATA of more than 8 MiB");
    c->p += c->p < c->end ? n : 0;
    return true;
}

/* A tag, up to the > that stands outside quotes. */
static bool skip_tag(scan *c)
{
    const char *open = c->p;
    char quote = '\0';

    for (; c->p < c->end; c->p++) {
        char ch = *c->p;

        if ((size_t)(c->p - open) > IX_XML_MAX_TAG)
            return flawed(c, open, "a tag of more than 64 KiB");
        if (!quote && ch == '>')
            return true;
        if (quote && ch == quote)
            quote = '\0';
        else if (!quote && (ch == '"' || ch == '\''))
            quote = ch;
    }
    return true;
}

static bool skip_markup(scan *c)
{
    if (++c->nodes > IX_XML_MAX_NODES)
        return flawed(c, c->p, "more than 33554432 tags");
    if (looking_at(c, "<!--"))
        return skip_to(c, "-->");
    if (looking_at(c, "<![CDATA["))
        return skip_to(c, "]]>");
    if (looking_at(c, "<?"))
        return skip_to(c, "?>");
    if (looking_at(c, "<!"))
        return flawed(c, c->p, "a DOCTYPE or another declaration is refused");
    return skip_tag(c);
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

static bool check_encoding(scan *c)
{
    size_t n = (size_t)(c->end - c->p), len;
    const char *close, *enc;

    if (!looking_at(c, "<?xml"))
        return true;
    close = memchr(c->p, '>', n < 512 ? n : 512);
    enc = find_encoding(c->p, close ? (size_t)(close - c->p) : 0, &len);
    if (!enc || same_word(enc, len, "utf-8") || same_word(enc, len, "us-ascii"))
        return true;
    return flawed(c, enc, "encoding UTF-8 expected, another is declared");
}

static bool check_start(scan *c)
{
    const char *nul = memchr(c->s, '\0', (size_t)(c->end - c->s));

    if (nul)
        return flawed(c, nul, "a NUL byte: not XML in UTF-8");
    while (c->p < c->end && is_blank(*c->p))
        c->p++;
    if (c->p == c->end || *c->p != '<')
        return flawed(c, c->p, "< of an element expected: not XML in UTF-8");
    return check_encoding(c);
}

bool ix__xml_scan(const char *s, size_t n, ix__xml_flaw *flaw)
{
    scan c = {.s = s, .p = s, .end = s + n, .flaw = flaw};

    if (!check_start(&c))
        return false;
    while ((c.p = memchr(c.p, '<', (size_t)(c.end - c.p))))
        if (!skip_markup(&c))
            return false;
    return true;
}
