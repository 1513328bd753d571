/* xml_pull.c - the queue of events between libxml2's push parser and us.
 *
 * libxml2's own memory (its context, names, one piece of text) is outside the
 * allocator of ix_ctx: its hooks are global, and a host may use it, too. */
#include "io/xml_pull.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "io/xml_scan.h"

enum { PIECE = 1 << 16, MAX_WARNINGS = 20 };

typedef struct {
    ix__xkind kind;
    int nattrs;
    size_t at, off, n; /* off: in the pool */
} record;

struct ix__xml {
    ix_ctx *ctx;
    const char *fname;
    const char *text; /* behind a byte order mark */
    size_t n, fed;
    xmlParserCtxtPtr parser;
    ix_buf pool, queue; /* texts; records */
    size_t next;        /* record */
    ix_status st;       /* what follows the queue */
    size_t flaw_at;
    char flaw[256];
    int warnings;
    bool done;
};

/* --- places and messages ---------------------------------------------- */

static ix_place place_of(const ix__xml *x, size_t at)
{
    ix_place pl = {1, 1};

    for (size_t i = 0; i < at && i < x->n; i++) {
        if (x->text[i] == '\n') {
            pl.line++;
            pl.col = 1;
        } else if (((unsigned char)x->text[i] & 0xc0) != 0x80) {
            pl.col++;
        }
    }
    return pl;
}

ix_status ix__xml_fail(const ix__xml *x, size_t at, const char *fmt, ...)
{
    ix_place pl = place_of(x, at);
    char text[384];
    va_list ap;

    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    return IX_FAIL(x->ctx, IX_EPARSE, "%.100s:%d:%d: error: %s", x->fname,
                   pl.line, pl.col, text);
}

void ix__xml_warn(ix__xml *x, size_t at, const char *fmt, ...)
{
    ix_place pl;
    char text[384];
    va_list ap;

    if (!x->ctx->note || ++x->warnings > MAX_WARNINGS)
        return;
    pl = place_of(x, at);
    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    ix__note(
        x->ctx, "%.100s:%d:%d: warning: %s%s", x->fname, pl.line, pl.col, text,
        x->warnings == MAX_WARNINGS ? " (further warnings not shown)" : "");
}

ix_ctx *ix__xml_ctx(const ix__xml *x)
{
    return x->ctx;
}

size_t ix__xml_size(const ix__xml *x)
{
    return x->n;
}

/* --- what libxml2 reports --------------------------------------------- */

static void stop(ix__xml *x, ix_status st, size_t at, const char *what)
{
    if (x->st != IX_OK)
        return;
    x->st = st;
    x->flaw_at = at;
    (void)snprintf(x->flaw, sizeof x->flaw, "%s", what);
    xmlStopParser(x->parser);
}

/* The offset that the parser has reached. */
static size_t here(const ix__xml *x)
{
    long at = xmlByteConsumed(x->parser);

    return at < 0 || (size_t)at > x->n ? x->n : (size_t)at;
}

/* The texts of r are in the pool already. */
static void put(ix__xml *x, record r)
{
    if (!x->pool.failed)
        ix__buf_add(&x->queue, (const char *)&r, sizeof r);
    if (x->queue.failed || x->pool.failed)
        stop(x, IX_ENOMEM, 0, "");
}

/* With its NUL. An ampersand in an attribute comes as "&#38;", and nothing else
 * does: libxml2 leaves the rest to a builder of trees. */
static void pool_add(ix__xml *x, const char *s, size_t n)
{
    const char *end = s + n, *amp;

    while ((amp = memchr(s, '&', (size_t)(end - s)))) {
        ix__buf_add(&x->pool, s, (size_t)(amp - s) + 1);
        s = end - amp >= 5 && memcmp(amp, "&#38;", 5) == 0 ? amp + 5 : amp + 1;
    }
    ix__buf_add(&x->pool, s, (size_t)(end - s));
    ix__buf_putc(&x->pool, '\0');
}

static bool is_ours(const xmlChar *uri)
{
    return uri && strcmp((const char *)uri, IX_XML_NAMESPACE) == 0;
}

static void on_start(void *ud, const xmlChar *name, const xmlChar *prefix,
                     const xmlChar *uri, int nns, const xmlChar **ns,
                     int nattrs, int ndefaulted, const xmlChar **attrs)
{
    ix__xml *x = ud;
    record r = {IX_X_START, nattrs, here(x), x->pool.len, 0};
    char text[200];

    (void)prefix, (void)nns, (void)ns, (void)ndefaulted;
    while (r.at > 0 && (r.at == x->n || x->text[r.at] != '<'))
        r.at--; /* no tag holds another < */
    if (!is_ours(uri)) {
        (void)snprintf(text, sizeof text,
                       "element \"%.80s\" is not of namespace "
                       "\"" IX_XML_NAMESPACE "\"",
                       (const char *)name);
        stop(x, IX_EPARSE, r.at, text);
        return;
    }
    pool_add(x, (const char *)name, strlen((const char *)name));
    for (int i = 0; i < nattrs; i++, attrs += 5) {
        /* name, prefix, namespace, value, end of value */
        if (attrs[1])
            ix__buf_printf(&x->pool, "%s:", (const char *)attrs[1]);
        pool_add(x, (const char *)attrs[0], strlen((const char *)attrs[0]));
        pool_add(x, (const char *)attrs[3], (size_t)(attrs[4] - attrs[3]));
    }
    put(x, r);
}

static void on_end(void *ud, const xmlChar *name, const xmlChar *prefix,
                   const xmlChar *uri)
{
    ix__xml *x = ud;

    (void)name, (void)prefix, (void)uri;
    put(x, (record){IX_X_END, 0, here(x), 0, 0});
}

/* Where the text s begins: in the parser's input it tells by itself, else it
 * was copied out and ends where the parser is. */
static size_t text_place(const ix__xml *x, const xmlChar *s, size_t n)
{
    const xmlParserInput *in = x->parser->input;
    size_t at = here(x), back = n;

    if (s >= in->base && s <= in->cur)
        back = (size_t)(in->cur - s);
    return at > back ? at - back : 0;
}

static void on_text(void *ud, const xmlChar *s, int n)
{
    ix__xml *x = ud;
    record r = {IX_X_TEXT, 0, text_place(x, s, (size_t)n), x->pool.len,
                (size_t)n};

    ix__buf_add(&x->pool, (const char *)s, (size_t)n);
    put(x, r);
}

/* Never reached, as ix__xml_scan refuses these; a second lock. */
static void on_doctype(void *ud, const xmlChar *name, const xmlChar *external,
                       const xmlChar *system)
{
    (void)name, (void)external, (void)system;
    stop(ud, IX_EPARSE, here(ud), "a DOCTYPE is refused");
}

static xmlEntityPtr on_entity(void *ud, const xmlChar *name)
{
    (void)ud;
    return xmlGetPredefinedEntity(name);
}

static void on_error(void *ud, xmlErrorPtr e)
{
    ix__xml *x = ud;
    size_t n;
    char text[200];

    if (e->level < XML_ERR_ERROR || x->st != IX_OK)
        return;
    (void)snprintf(text, sizeof text, "%s", e->message ? e->message : "?");
    n = strlen(text);
    while (n > 0 && (text[n - 1] == '\n' || text[n - 1] == ' '))
        text[--n] = '\0';
    for (char *c = text; *c; c++)
        *c = *c == '\n' ? ' ' : *c;
    stop(x, e->code == XML_ERR_NO_MEMORY ? IX_ENOMEM : IX_EPARSE, here(x),
         text);
}

/* Errors that libxml2 does not tell a parser's own handler, memory mostly: it
 * would print them. The handler is that of the thread, and put back. */
typedef struct {
    xmlStructuredErrorFunc func;
    void *ud;
} handler;

static void on_other_error(void *ud, xmlErrorPtr e)
{
    ix__xml *x = ud;

    if (e->code == XML_ERR_NO_MEMORY && x->st == IX_OK)
        x->st = IX_ENOMEM;
}

static handler take_errors(ix__xml *x)
{
    handler old = {xmlStructuredError, xmlStructuredErrorContext};

    xmlSetStructuredErrorFunc(x, on_other_error);
    return old;
}

static void give_errors_back(handler old)
{
    xmlSetStructuredErrorFunc(old.ud, old.func);
}

/* --- pulling ---------------------------------------------------------- */

static ix_status no_memory(ix__xml *x)
{
    return IX_FAIL(x->ctx, IX_ENOMEM, "out of memory in libxml2");
}

static ix_status make_parser(ix__xml *x)
{
    xmlSAXHandler sax = {
        .initialized = XML_SAX2_MAGIC,
        .startElementNs = on_start,
        .endElementNs = on_end,
        .characters = on_text,
        .ignorableWhitespace = on_text,
        .cdataBlock = on_text,
        .internalSubset = on_doctype,
        .getEntity = on_entity,
        .serror = on_error,
    };
    handler old;

    old = take_errors(x);
    x->parser = xmlCreatePushParserCtxt(&sax, x, NULL, 0, NULL);
    give_errors_back(old);
    if (!x->parser)
        return no_memory(x);
    (void)xmlCtxtUseOptions(x->parser, XML_PARSE_NONET | XML_PARSE_IGNORE_ENC);
    return IX_OK;
}

static bool is_utf8_mark(const char *text, size_t n)
{
    return n >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0;
}

static ix_status open_xml(ix__xml *x)
{
    ix__xml_flaw flaw;

    if (x->n > IX_MAX_TEXT)
        return ix__xml_fail(x, 0, "more than %zu bytes", IX_MAX_TEXT);
    if (!ix__xml_scan(x->text, x->n, &flaw))
        return ix__xml_fail(x, flaw.at, "%s", flaw.what);
    return make_parser(x);
}

ix_status ix__xml_open(ix_ctx *ctx, const char *fname, const char *text,
                       size_t n, ix__xml **out)
{
    ix__xml *x = ix__alloc(ctx, sizeof *x);
    size_t mark = is_utf8_mark(text, n) ? 3 : 0;
    ix_status st;

    *out = NULL;
    if (!x)
        return IX_ENOMEM;
    *x = (ix__xml){
        .ctx = ctx, .fname = fname, .text = text + mark, .n = n - mark};
    ix__buf_init(&x->pool, ctx);
    ix__buf_init(&x->queue, ctx);
    st = open_xml(x);
    if (st == IX_OK)
        *out = x;
    else
        ix__xml_close(x);
    return st;
}

void ix__xml_close(ix__xml *x)
{
    if (!x)
        return;
    if (x->parser)
        xmlFreeParserCtxt(x->parser);
    ix__buf_free(&x->pool);
    ix__buf_free(&x->queue);
    ix__free(x->ctx, x, sizeof *x);
}

/* One piece more. Well-formedness is checked at the end of the last one. */
static ix_status feed(ix__xml *x)
{
    size_t n = x->n - x->fed < PIECE ? x->n - x->fed : PIECE;
    handler old;
    int code;

    IX_TRY(ix__poll(x->ctx));
    x->next = 0;
    ix__buf_clear(&x->queue);
    ix__buf_clear(&x->pool);
    x->done = x->fed + n == x->n;
    old = take_errors(x);
    code = xmlParseChunk(x->parser, x->text + x->fed, (int)n, x->done);
    give_errors_back(old);
    x->fed += n;
    if (code == XML_ERR_NO_MEMORY && x->st == IX_OK)
        x->st = IX_ENOMEM;
    if (code != XML_ERR_OK && x->st == IX_OK)
        stop(x, IX_EPARSE, here(x), "not well-formed");
    return IX_OK;
}

static ix_status at_flaw(ix__xml *x)
{
    if (x->st == IX_ENOMEM && (x->queue.failed || x->pool.failed))
        return IX_ENOMEM; /* the message is set */
    if (x->st == IX_ENOMEM)
        return no_memory(x);
    return ix__xml_fail(x, x->flaw_at, "%s", x->flaw);
}

ix_status ix__xml_next(ix__xml *x, ix__xevent *e)
{
    record r;

    while (x->next * sizeof r == x->queue.len) {
        if (x->st != IX_OK)
            return at_flaw(x);
        if (x->done) {
            *e = (ix__xevent){.kind = IX_X_EOF, .at = x->n};
            return IX_OK;
        }
        IX_TRY(feed(x));
    }
    memcpy(&r, x->queue.data + x->next * sizeof r, sizeof r);
    x->next++;
    *e = (ix__xevent){.kind = r.kind, .at = r.at, .nattrs = r.nattrs, .n = r.n};
    if (r.kind != IX_X_END)
        e->s = x->pool.data + r.off;
    return IX_OK;
}
