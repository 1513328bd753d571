/* xml_read_text.c - the smallest parts of XML being read: children,
 * attributes, numbers in text. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/xml_read_impl.h"

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static const char *skip_blanks(const char *p, const char *end)
{
    while (p < end && is_blank(*p))
        p++;
    return p;
}

/* --- elements --------------------------------------------------------- */

static ix_status check_between(ix__xmlr *r, const ix__xevent *e)
{
    const char *p = skip_blanks(e->s, e->s + e->n);
    int n = (int)(e->n - (size_t)(p - e->s));

    if (n == 0)
        return IX_OK;
    return ix__xml_fail(r->x, e->at + (size_t)(p - e->s),
                        "text \"%.*s\" between elements", n < 20 ? n : 20, p);
}

ix_status ix__xmlr_child(ix__xmlr *r, bool *more)
{
    ix__xevent e;

    for (;;) {
        IX_TRY(ix__xml_next(r->x, &e));
        if (e.kind != IX_X_TEXT)
            break;
        IX_TRY(check_between(r, &e));
    }
    *more = e.kind == IX_X_START;
    if (!*more) {
        r->depth--;
        return IX_OK;
    }
    r->e = e;
    if (++r->depth > IX_MAX_DEPTH)
        return ix__xml_fail(r->x, e.at, "elements nested deeper than %d",
                            IX_MAX_DEPTH);
    return IX_OK;
}

ix_status ix__xmlr_empty(ix__xmlr *r)
{
    bool more;

    IX_TRY(ix__xmlr_child(r, &more));
    return more ? ix__xmlr_unexpected(r, "the end of the element") : IX_OK;
}

bool ix__xmlr_is(const ix__xmlr *r, const char *name)
{
    return strcmp(r->e.s, name) == 0;
}

ix_status ix__xmlr_unexpected(ix__xmlr *r, const char *wanted)
{
    return ix__xml_fail(r->x, r->e.at, "%s expected, found element \"%.40s\"",
                        wanted, r->e.s);
}

/* --- attributes ------------------------------------------------------- */

const char *ix__xmlr_attr(const ix__xmlr *r, const char *name)
{
    const char *s = r->e.s + strlen(r->e.s) + 1;

    for (int i = 0; i < r->e.nattrs; i++) {
        const char *value = s + strlen(s) + 1;

        if (strcmp(s, name) == 0)
            return value;
        s = value + strlen(value) + 1;
    }
    return NULL;
}

static bool is_among(const char *s, const char *names)
{
    size_t n = strlen(s);

    for (const char *p = strstr(names, s); p && n > 0; p = strstr(p + 1, s))
        if (p[n] == ' ' && p > names && p[-1] == ' ')
            return true;
    return false;
}

ix_status ix__xmlr_allow(ix__xmlr *r, const char *names)
{
    const char *s = r->e.s + strlen(r->e.s) + 1;

    for (int i = 0; i < r->e.nattrs; i++) {
        if (!is_among(s, names))
            return ix__xml_fail(r->x, r->e.at,
                                "element \"%s\" has no attribute \"%.40s\"",
                                r->e.s, s);
        s += strlen(s) + 1;
        s += strlen(s) + 1;
    }
    return IX_OK;
}

ix_status ix__xmlr_need(ix__xmlr *r, const char *name, const char **value)
{
    *value = ix__xmlr_attr(r, name);
    if (*value)
        return IX_OK;
    return ix__xml_fail(r->x, r->e.at, "element \"%s\" needs attribute \"%s\"",
                        r->e.s, name);
}

static ix_status bad_attr(ix__xmlr *r, const char *name, const char *wanted)
{
    const char *value = ix__xmlr_attr(r, name);

    return ix__xml_fail(r->x, r->e.at, "%s=\"%.40s\": %s expected", name,
                        value ? value : "", wanted);
}

static int hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

/* Pairs of digits s[0 .. n) as bytes, at most in place; the number of bytes,
 * or SIZE_MAX if they are none. */
static size_t unhex(const char *s, size_t n, char *out)
{
    if (n % 2 != 0)
        return SIZE_MAX;
    for (size_t i = 0; i < n; i += 2) {
        int hi = hex_digit(s[i]), lo = hex_digit(s[i + 1]);

        if (hi < 0 || lo < 0)
            return SIZE_MAX;
        out[i / 2] = (char)(16 * hi + lo);
    }
    return n / 2;
}

ix_status ix__xmlr_name(ix__xmlr *r, const char *name, char **value)
{
    const char *text = ix__xmlr_attr(r, name), *hex;
    char with_hex[32], *copy;
    size_t n;

    *value = NULL;
    (void)snprintf(with_hex, sizeof with_hex, "%s-hex", name);
    hex = ix__xmlr_attr(r, with_hex);
    if (text && hex)
        return ix__xml_fail(r->x, r->e.at, "both \"%s\" and \"%s\" given", name,
                            with_hex);
    if (!text && !hex)
        return IX_OK;
    n = strlen(text ? text : hex);
    IX_SCRATCH(r->ctx, copy, n + 1);
    if (text)
        memcpy(copy, text, n);
    else
        n = unhex(hex, n, copy);
    if (n == SIZE_MAX || memchr(copy, '\0', n))
        return bad_attr(r, with_hex, "pairs of hexadecimal digits but 00");
    copy[n] = '\0';
    *value = copy;
    return IX_OK;
}

ix_status ix__xmlr_int(ix__xmlr *r, const char *name, int lo, int hi, int *v)
{
    const char *s;
    char wanted[64];
    double x;

    IX_TRY(ix__xmlr_need(r, name, &s));
    if (*s && ix_num_parse(s, s + strlen(s), &x) == s + strlen(s) && x >= lo &&
        x <= hi && x == floor(x)) {
        *v = (int)x;
        return IX_OK;
    }
    (void)snprintf(wanted, sizeof wanted, "an integer in %d .. %d", lo, hi);
    return bad_attr(r, name, wanted);
}

ix_status ix__xmlr_bool(ix__xmlr *r, const char *name, bool *v)
{
    const char *s = ix__xmlr_attr(r, name);

    *v = s && strcmp(s, "true") == 0;
    if (!s || *v || strcmp(s, "false") == 0)
        return IX_OK;
    return bad_attr(r, name, "true or false");
}

ix_status ix__xmlr_attr_nums(ix__xmlr *r, const char *name, int n, double *v,
                             bool *given)
{
    const char *s = ix__xmlr_attr(r, name), *end;
    char wanted[32];

    *given = s != NULL;
    if (!s)
        return IX_OK;
    (void)snprintf(wanted, sizeof wanted, "%d numbers", n);
    end = s + strlen(s);
    for (int i = 0; i < n; i++) {
        s = ix_num_parse(skip_blanks(s, end), end, v + i);
        if (!s || !isfinite(v[i]) || (s < end && !is_blank(*s)))
            return bad_attr(r, name, wanted);
    }
    return skip_blanks(s, end) == end ? IX_OK : bad_attr(r, name, wanted);
}

ix_status ix__xmlr_point_type(ix__xmlr *r, int *ncoords, bool *rational)
{
    const char *s;
    int v = 0;

    IX_TRY(ix__xmlr_need(r, "type", &s));
    if ((*s == 'E' || *s == 'P') && s[1] >= '1' && s[1] <= '9') {
        v = s[1] - '0';
        if (s[2] >= '0' && s[2] <= '9' && !s[3])
            v = 10 * v + s[2] - '0';
        else if (s[2])
            v = 0;
    }
    if (v < 1 || v > IX_MAX_COORDS)
        return bad_attr(r, "type", "E1 .. E18 or P1 .. P18");
    *ncoords = v;
    *rational = *s == 'P';
    return IX_OK;
}

ix_status ix__xmlr_word(ix__xmlr *r, const char *name, int n,
                        const char *const *words, int *i)
{
    const char *s;
    char wanted[80] = "";
    size_t len = 0;

    IX_TRY(ix__xmlr_need(r, name, &s));
    for (*i = 0; *i < n; ++*i) {
        if (strcmp(s, words[*i]) == 0)
            return IX_OK;
        if (len < sizeof wanted)
            len += (size_t)snprintf(wanted + len, sizeof wanted - len, "%s%s",
                                    *i ? ", " : "one of ", words[*i]);
    }
    return bad_attr(r, name, wanted);
}

/* --- text ------------------------------------------------------------- */

ix_status ix__xmlr_text(ix__xmlr *r)
{
    ix__xevent e;

    ix__buf_clear(&r->text);
    ix__buf_add(&r->text, "", 0); /* an empty text is one, too */
    r->behind = SIZE_MAX;
    for (;;) {
        IX_TRY(ix__xml_next(r->x, &e));
        if (r->behind == SIZE_MAX)
            r->behind = e.at;
        if (e.kind != IX_X_TEXT)
            break;
        ix__buf_add(&r->text, e.s, e.n);
        IX_TRY(ix__buf_check(&r->text));
        if (r->text.len > IX_XML_MAX_TEXT)
            return ix__xml_fail(r->x, r->behind,
                                "text of more than %zu bytes in one element",
                                IX_XML_MAX_TEXT);
    }
    if (e.kind == IX_X_START)
        return ix__xml_fail(r->x, e.at,
                            "text expected, found element \"%.40s\"", e.s);
    r->depth--;
    r->p = r->text.data;
    return ix__buf_check(&r->text);
}

ix_status ix__xmlr_bytes(ix__xmlr *r, bool hex)
{
    size_t n;

    IX_TRY(ix__xmlr_text(r));
    if (!hex)
        return IX_OK;
    n = unhex(r->text.data, r->text.len, r->text.data);
    if (n == SIZE_MAX)
        return ix__xml_fail(r->x, r->behind,
                            "pairs of hexadecimal digits expected");
    r->text.len = n;
    r->text.data[n] = '\0';
    return IX_OK;
}

bool ix__xmlr_at_end(ix__xmlr *r)
{
    const char *end = r->text.data + r->text.len;

    r->p = skip_blanks(r->p, end);
    return r->p == end;
}

ix_status ix__xmlr_bad_text(ix__xmlr *r, const char *what)
{
    const char *end = r->text.data + r->text.len, *p = skip_blanks(r->p, end);
    size_t at = r->behind + (size_t)(p - r->text.data);
    int n = 0;

    while (p + n < end && n < 30 && !is_blank(p[n]))
        n++;
    if (n == 0)
        return ix__xml_fail(r->x, at, "%s", what);
    return ix__xml_fail(r->x, at, "%s, found \"%.*s\"", what, n, p);
}

ix_status ix__xmlr_num(ix__xmlr *r, double *v)
{
    const char *end = r->text.data + r->text.len;
    const char *p = skip_blanks(r->p, end), *next = ix_num_parse(p, end, v);

    if (!next || (next < end && !is_blank(*next)))
        return ix__xmlr_bad_text(r, "a number expected");
    if (!isfinite(*v))
        return ix__xmlr_bad_text(r, "number out of range (1.8e308)");
    r->p = next;
    return IX_OK;
}

ix_status ix__xmlr_nums(ix__xmlr *r, int n, double *v)
{
    char wanted[40];

    (void)snprintf(wanted, sizeof wanted, "%d number%s expected, not more", n,
                   n == 1 ? "" : "s");
    IX_TRY(ix__xmlr_text(r));
    for (int i = 0; i < n; i++)
        IX_TRY(ix__xmlr_num(r, v + i));
    return ix__xmlr_at_end(r) ? IX_OK : ix__xmlr_bad_text(r, wanted);
}

ix_status ix__xmlr_at(ix__xmlr *r, size_t at, ix_status st)
{
    char text[256];

    if (st != IX_EARG)
        return st;
    (void)snprintf(text, sizeof text, "%.255s", ix_ctx_message(r->ctx));
    return ix__xml_fail(r->x, at, "%s", text);
}

ix_status ix__xmlr_room(ix__xmlr *r, size_t at, double n, const char *what)
{
    const double small = 65536; /* the end of the file will be met soon */
    double size = (double)ix__xml_most(r->x);

    if (2 * n <= fmax(small, size)) /* a digit and a blank */
        return IX_OK;
    return ix__xml_fail(r->x, at,
                        "%.0f %s cannot stand in a text of %.0f bytes", n, what,
                        size);
}
