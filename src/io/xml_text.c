/* xml_text.c - the smallest parts of written XML: tags, escapes, numbers. */
#include <string.h>

#include "io/xml_pull.h"
#include "io/xml_write_impl.h"

ix_status ix__xmlw_check(const ix__xmlw *w)
{
    return ix__write_check(w->b, w->start, w->nonfinite);
}

/* --- text ------------------------------------------------------------- */

/* The length of the character of XML at s, 0 if there is none. */
static size_t character(const unsigned char *s, size_t n)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    size_t k = *s < 0x80 ? 1 : *s < 0xe0 ? 2 : *s < 0xf0 ? 3 : 4;
    uint32_t c = k == 1 ? *s : *s & (0x7fu >> k);

    if (*s < ' ')
        return *s == '\t' || *s == '\n' || *s == '\r';
    if ((*s & 0xc0) == 0x80 || *s >= 0xf8 || k > n)
        return 0;
    for (size_t i = 1; i < k; i++) {
        if ((s[i] & 0xc0) != 0x80)
            return 0;
        c = c << 6 | (s[i] & 0x3fu);
    }
    if (c < least[k] || c > 0x10ffff || (c >= 0xd800 && c < 0xe000) ||
        c == 0xfffe || c == 0xffff)
        return 0;
    return k;
}

bool ix__xml_is_text(const char *s, size_t n)
{
    const unsigned char *p = (const unsigned char *)s, *end = p + n;

    while (p < end) {
        size_t k = character(p, (size_t)(end - p));

        if (k == 0)
            return false;
        p += k;
    }
    return true;
}

static const char *escape_of(char c)
{
    switch (c) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    case '\t':
        return "&#9;";
    case '\n':
        return "&#10;";
    case '\r':
        return "&#13;";
    default:
        return NULL;
    }
}

void ix__xmlw_escaped(ix_buf *b, const char *s, size_t n)
{
    size_t from = 0;

    for (size_t i = 0; i < n; i++) {
        const char *e = escape_of(s[i]);

        if (!e)
            continue;
        ix__buf_add(b, s + from, i - from);
        ix__buf_puts(b, e);
        from = i + 1;
    }
    ix__buf_add(b, s + from, n - from);
}

/* --- tags ------------------------------------------------------------- */

static void indent(ix__xmlw *w)
{
    ix__buf_fill(w->b, ' ', 2 * (size_t)w->depth);
}

void ix__xmlw_tag(ix__xmlw *w, const char *name)
{
    indent(w);
    ix__buf_putc(w->b, '<');
    ix__buf_puts(w->b, name);
}

void ix__xmlw_attr(ix__xmlw *w, const char *name, const char *value)
{
    ix__buf_printf(w->b, " %s=\"%s\"", name, value);
}

void ix__xmlw_attr_int(ix__xmlw *w, const char *name, long long v)
{
    ix__buf_printf(w->b, " %s=\"%lld\"", name, v);
}

void ix__xmlw_attr_nums(ix__xmlw *w, const char *name, int n, const double *v)
{
    ix__buf_printf(w->b, " %s=\"", name);
    ix__xmlw_nums(w, n, v);
    ix__buf_putc(w->b, '"');
}

ix_status ix__xmlw_attr_text(ix__xmlw *w, const char *name, const char *s,
                             size_t n)
{
    size_t before = w->b->len;
    bool text = ix__xml_is_text(s, n);

    ix__buf_printf(w->b, text ? " %s=\"" : " %s-hex=\"", name);
    if (text)
        ix__xmlw_escaped(w->b, s, n);
    for (size_t i = 0; !text && i < n; i++)
        ix__buf_printf(w->b, "%02x", (unsigned char)s[i]);
    ix__buf_putc(w->b, '"');
    if (w->b->len - before > IX_XML_MAX_TAG / 2)
        return IX_FAIL(w->b->ctx, IX_EUNABLE,
                       "a name of %zu bytes is too long for XML", n);
    return IX_OK;
}

void ix__xmlw_none(ix__xmlw *w)
{
    ix__buf_puts(w->b, "/>\n");
}

void ix__xmlw_open(ix__xmlw *w)
{
    ix__buf_puts(w->b, ">\n");
    w->depth++;
}

void ix__xmlw_begin(ix__xmlw *w)
{
    ix__buf_putc(w->b, '>');
}

void ix__xmlw_close(ix__xmlw *w, const char *name)
{
    w->depth--;
    indent(w);
    ix__xmlw_end(w, name);
}

void ix__xmlw_end(ix__xmlw *w, const char *name)
{
    ix__buf_puts(w->b, "</");
    ix__buf_puts(w->b, name);
    ix__buf_puts(w->b, ">\n");
}

/* --- numbers ---------------------------------------------------------- */

void ix__xmlw_num(ix__xmlw *w, double v)
{
    ix__write_num(w->b, v, &w->nonfinite);
}

void ix__xmlw_nums(ix__xmlw *w, int n, const double *v)
{
    for (int i = 0; i < n; i++) {
        if (i > 0)
            ix__buf_putc(w->b, ' ');
        ix__xmlw_num(w, v[i]);
    }
}
