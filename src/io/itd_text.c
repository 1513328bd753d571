/* itd_text.c - the smallest parts of written text: numbers, names, strings,
 * indentation. A number is the shortest text that reads back, or follows a
 * printf-style format with IRIT's clean-up (spec/itd-format 10.3): no trailing
 * blanks, no trailing zeros after a point, tiny values are 0. */
#include <math.h>
#include <string.h>

#include "io/itd_write_impl.h"

#define DEFAULT_FORMAT "%-16.14lg"
#define PEER_TEXT      4000 /* of 4096, some of which backslashes may take */

/* --- numbers ---------------------------------------------------------- */

static double tiny_of(const ix_numfmt *f)
{
    static const double powers[] = {
        1e-6,  1e-7,  1e-8,  1e-9,  1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15,
        1e-16, 1e-17, 1e-18, 1e-19, 1e-20, 1e-21, 1e-22, 1e-23, 1e-24, 1e-25};
    int digits = f->precision < 0 ? 6 : f->precision;

    if (strchr("eEgGs", f->conv))
        digits = 25;
    else if (!strchr("fF", f->conv))
        digits = 0; /* integers */
    if (digits < 6)
        digits = 6;
    return powers[digits > 25 ? 19 : digits - 6];
}

double ix__itd_tiny(const char *float_format)
{
    ix_numfmt f;

    if (strcmp(float_format, DEFAULT_FORMAT) == 0)
        return 1e-13;
    return ix__numfmt_parse(float_format, &f) ? tiny_of(&f) : 0;
}

static ix_status bad_format(ix_ctx *ctx, const char *format)
{
    return IX_FAIL(ctx, IX_EARG,
                   "number format \"%.40s\" is not one conversion such as "
                   "\"%%.15g\"",
                   format);
}

static ix_status init_format(ix__itdw *w, const ix_write_opts *o)
{
    const char *s = o->float_format, *end = ix__numfmt_parse(s, &w->fmt);

    if (!end || *end || w->fmt.conv == 's')
        return bad_format(w->b->ctx, s);
    w->tiny = o->tiny != 0 ? o->tiny : ix__itd_tiny(s);
    return IX_OK;
}

ix_status ix__itdw_init(ix__itdw *w, ix_buf *b, const ix_write_opts *o)
{
    *w = (ix__itdw){.b = b, .start = ix__buf_total(b), .shortest = true};
    if (!o)
        return IX_OK;
    w->file = o->file;
    w->peer = o->peer;
    w->shortest = !o->float_format;
    return w->shortest ? IX_OK : init_format(w, o);
}

ix_status ix__itdw_check(const ix__itdw *w)
{
    return ix__write_check(w->b, w->start, w->file && w->nonfinite);
}

/* Takes off what IRIT takes off, from offset start on. */
static void clean_up(ix_buf *b, size_t start)
{
    const char *s = b->data + start;
    size_t n = b->len - start;

    while (n > 0 && s[n - 1] == ' ')
        n--;
    if (memchr(s, '.', n) && !memchr(s, 'e', n) && !memchr(s, 'E', n))
        while (n > 0 && s[n - 1] == '0')
            n--;
    b->len = start + n;
    b->data[b->len] = '\0';
}

void ix__itdw_num(ix__itdw *w, double v)
{
    size_t start = w->b->len;

    if (w->shortest) {
        ix__write_num(w->b, v, &w->nonfinite);
        return;
    }
    if (!isfinite(v))
        w->nonfinite = true;
    ix__numfmt_put(w->b, &w->fmt, fabs(v) < w->tiny ? 0.0 : v);
    if (!w->b->failed)
        clean_up(w->b, start);
}

void ix__itdw_nums(ix__itdw *w, int n, const double *v)
{
    for (int i = 0; i < n; i++) {
        if (i > 0)
            ix__buf_putc(w->b, ' ');
        ix__itdw_num(w, v[i]);
    }
}

void ix__itdw_real_attr(ix__itdw *w, double v)
{
    static const ix_numfmt six = {.precision = -1, .conv = 'g'};

    if (w->shortest) {
        ix__write_num(w->b, v, &w->nonfinite);
        return;
    }
    if (!isfinite(v))
        w->nonfinite = true;
    ix__numfmt_put(w->b, &six, v);
}

void ix__itd_number(ix_buf *b, const ix_write_opts *o, double v)
{
    ix__itdw w;

    if (ix__itdw_init(&w, b, o) != IX_OK)
        w.shortest = true;
    ix__itdw_num(&w, v);
}

/* --- words ------------------------------------------------------------ */

void ix__itdw_indent(ix__itdw *w, int column)
{
    if (w->peer)
        return;
    ix__buf_fill(w->b, '\t', (size_t)column / 8);
    ix__buf_fill(w->b, ' ', (size_t)column % 8);
}

static bool ends_word(char c)
{
    return (unsigned char)c <= ' ' || c == '[' || c == ']' || c == '"' ||
           c == 0x7f;
}

/* An object's name must be one word: what would break it becomes an
 * underscore in files. */
void ix__itdw_word(ix__itdw *w, const char *s)
{
    if (!s || !*s) {
        ix__buf_puts(w->b, "NONE");
        return;
    }
    for (; *s; s++)
        ix__buf_putc(w->b, w->file && ends_word(*s) ? '_' : *s);
}

/* IRIT gives up on longer texts, and on this byte. */
static ix_status check_peer_text(const ix__itdw *w, const char *s, size_t n)
{
    if (n >= PEER_TEXT)
        return IX_FAIL(w->b->ctx, IX_EUNABLE,
                       "a string of %zu bytes: IRIT reads less than %d", n,
                       PEER_TEXT);
    if (n > 0 && memchr(s, 0xff, n))
        return IX_FAIL(w->b->ctx, IX_EDOMAIN,
                       "a string holds byte 0xff, which IRIT cannot read");
    return IX_OK;
}

static ix_status put_escaped(ix__itdw *w, const char *s, size_t n)
{
    if (w->peer)
        IX_TRY(check_peer_text(w, s, n));
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)s[i];

        if (c < ' ' && c != '\t' && c != '\n' && c != '\r')
            return IX_FAIL(w->b->ctx, IX_EDOMAIN,
                           "a string holds control byte 0x%02x, which text "
                           "files cannot hold",
                           c);
        if (w->peer && (c == '\n' || c == '\r')) {
            ix__buf_putc(w->b, ' '); /* a line is the end of a string there */
            continue;
        }
        if (c == '"' || c == '\\' || c == '\n' || c == '\r')
            ix__buf_putc(w->b, '\\');
        ix__buf_putc(w->b, s[i]);
    }
    return IX_OK;
}

ix_status ix__itdw_quoted(ix__itdw *w, const char *s, size_t n)
{
    ix__buf_putc(w->b, '"');
    if (w->file)
        IX_TRY(put_escaped(w, s, n));
    else
        ix__buf_add(w->b, s, n);
    ix__buf_putc(w->b, '"');
    return IX_OK;
}

/* What stands for something else in front of vertices. */
static bool is_reserved(const char *name)
{
    return ix__name_cmp(name, "NORMAL") == 0 ||
           ix__name_cmp(name, "INTERNAL") == 0 ||
           ix__name_cmp(name, "PLANE") == 0;
}

ix_status ix__itdw_attr_name(ix__itdw *w, const char *name)
{
    const char *s = name;

    while (*s && !ends_word(*s))
        s++;
    if (w->file && (*s || s == name || is_reserved(name)))
        return ix__itdw_quoted(w, name, strlen(name));
    ix__buf_puts(w->b, name);
    return IX_OK;
}

ix_status ix__itdw_attr_quoted(ix__itdw *w, const char *s)
{
    if (w->file)
        return ix__itdw_quoted(w, s, strlen(s));
    ix__buf_putc(w->b, '"');
    for (; *s; s++) {
        if (*s == '"')
            ix__buf_putc(w->b, '\\');
        ix__buf_putc(w->b, *s);
    }
    ix__buf_putc(w->b, '"');
    return IX_OK;
}
