/* xml_pull.c - the queue of events between libxml2's push parser and us.
 *
 * libxml2's own memory (its context, names, one piece of text) is outside the
 * allocator of ix_ctx: its hooks are global, and a host may use it, too. */
#include "io/xml_pull.h"

#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <stdio.h>
#include <string.h>

#include "io/xml_scan.h"

/* The first piece holds the XML declaration. */
enum { DECLARATION = 1024 };

typedef struct {
    ix__xkind kind;
    int nattrs;
    size_t at, off, n; /* off: in the pool */
} record;

struct ix__xml {
    ix_ctx *ctx;
    ix__text t; /* the window is behind what the parser has, too */
    ix__xml_scan scan;
    xmlParserCtxtPtr parser;
    ix_buf pool, queue; /* texts; records */
    size_t next;        /* record */
    size_t fed;         /* bytes */
    ix_status st;       /* what follows the queue */
    size_t flaw_at;
    char flaw[256];
    bool done;
};

/* --- places and messages ---------------------------------------------- */

ix_status ix__xml_fail(ix__xml *x, size_t at, const char *fmt, ...)
{
    ix_status st;
    va_list ap;

    va_start(ap, fmt);
    st = ix__text_fail(&x->t, at, fmt, ap);
    va_end(ap);
    return st;
}

void ix__xml_warn(ix__xml *x, size_t at, const char *fmt, ...)
{
    va_list ap;

    va_start(ap, fmt);
    ix__text_warn(&x->t, at, fmt, ap);
    va_end(ap);
}

ix_ctx *ix__xml_ctx(const ix__xml *x)
{
    return x->ctx;
}

size_t ix__xml_most(const ix__xml *x)
{
    return ix__input_most(x->t.src);
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

    return at < 0 || (size_t)at > x->fed ? x->fed : (size_t)at;
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

/* No tag holds another <, and all of it is in the window. */
static size_t start_of_tag(const ix__xml *x, size_t at)
{
    const char *end = x->t.window + (at - x->t.offset), *s = end;

    if (s == x->t.end)
        s--;
    while (s > x->t.window && *s != '<')
        s--;
    return at - (size_t)(end - s);
}

static void on_start(void *ud, const xmlChar *name, const xmlChar *prefix,
                     const xmlChar *uri, int nns, const xmlChar **ns,
                     int nattrs, int ndefaulted, const xmlChar **attrs)
{
    ix__xml *x = ud;
    record r = {IX_X_START, nattrs, here(x), x->pool.len, 0};
    char text[200];

    (void)prefix, (void)nns, (void)ns, (void)ndefaulted;
    r.at = start_of_tag(x, r.at);
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

ix_status ix__xml_open(ix__input *src, ix__xml **out)
{
    ix_ctx *ctx = ix__input_ctx(src);
    ix__xml *x = ix__alloc(ctx, sizeof *x);
    ix_status st;

    *out = NULL;
    if (!x)
        return IX_ENOMEM;
    *x = (ix__xml){.ctx = ctx};
    ix__buf_init(&x->pool, ctx);
    ix__buf_init(&x->queue, ctx);
    st = ix__text_init(&x->t, src);
    if (st == IX_OK)
        st = make_parser(x);
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
    ix__text_free(&x->t);
    ix__buf_free(&x->pool);
    ix__buf_free(&x->queue);
    ix__free(x->ctx, x, sizeof *x);
}

/* Reads a piece behind the window's end. As much of what the parser has stays
 * in the window as a tag may have. */
static ix_status read_piece(ix__xml *x, const char **piece)
{
    const char *fed = x->t.window + (x->fed - x->t.offset);
    size_t back = (size_t)(fed - x->t.window), keep;

    back = back < IX_XML_MAX_TAG ? back : IX_XML_MAX_TAG;
    x->t.p = fed - back;
    keep = (size_t)(x->t.end - x->t.p);
    IX_TRY(ix__text_more(&x->t));
    if (x->scan.done == 0)
        IX_TRY(ix__text_ahead(&x->t, DECLARATION));
    *piece = x->t.p + keep;
    return IX_OK;
}

/* What the parser may have: it takes a > within a comment for its end when a
 * piece ends behind it, so that it gets comments as a whole. */
static const char *safe_end(const ix__xml *x)
{
    bool open = x->scan.state == IX_XS_OPEN || x->scan.state == IX_XS_UNTIL;

    if (!open || x->t.eof)
        return x->t.end;
    return x->t.window + (x->scan.open - x->t.offset);
}

/* Well-formedness is checked at the end of the last piece. */
static void parse(ix__xml *x, const char *end)
{
    const char *s = x->t.window + (x->fed - x->t.offset);
    handler old = take_errors(x);
    int code;

    x->done = x->t.eof;
    x->fed += (size_t)(end - s);
    code = xmlParseChunk(x->parser, s, (int)(end - s), x->done);
    give_errors_back(old);
    if (code == XML_ERR_NO_MEMORY && x->st == IX_OK)
        x->st = IX_ENOMEM;
    if (code != XML_ERR_OK && x->st == IX_OK)
        stop(x, IX_EPARSE, here(x), "not well-formed");
}

static ix_status feed(ix__xml *x)
{
    ix__xml_flaw flaw;
    const char *piece;

    IX_TRY(ix__poll(x->ctx));
    x->next = 0;
    ix__buf_clear(&x->queue);
    ix__buf_clear(&x->pool);
    IX_TRY(read_piece(x, &piece));
    if (!ix__xml_scan_piece(&x->scan, piece, (size_t)(x->t.end - piece), &flaw))
        stop(x, IX_EPARSE, flaw.at, flaw.what);
    else if (x->t.eof || safe_end(x) > x->t.window + (x->fed - x->t.offset))
        parse(x, safe_end(x));
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
            *e = (ix__xevent){.kind = IX_X_EOF, .at = x->fed};
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
