/* xml_validate.c - XML against the RELAX NG schema of docs/iritx.rng, which is
 * compiled in. The text has passed ix__xml_scan before libxml2 sees it. */
#include <libxml/relaxng.h>
#include <libxml/xmlreader.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "io/xml_scan.h"

/* libxml2 takes a time that grows with the square of the number of elements
 * side by side: 20000 take about a second. */
enum { MAX_SIBLINGS = 30000 };

static const char schema_text[] = {
#include "iritx_rng.h"
};

/* The first error that libxml2 reports. */
typedef struct {
    const ix__xml *x;
    bool any, memory;
    int line;
    char element[64], text[256];
} finding;

static void on_error(void *ud, xmlErrorPtr e)
{
    finding *f = ud;
    const xmlNode *node = e->node;

    f->memory = f->memory || e->code == XML_ERR_NO_MEMORY;
    if (f->any || e->level < XML_ERR_ERROR)
        return;
    f->any = true;
    f->line = e->line;
    if (node && node->type == XML_ELEMENT_NODE)
        (void)snprintf(f->element, sizeof f->element, "<%.60s",
                       (const char *)node->name);
    (void)snprintf(f->text, sizeof f->text, "%s", e->message ? e->message : "");
    for (char *c = f->text; *c; c++)
        if (*c == '\n')
            *c = c[1] ? ' ' : '\0';
}

/* libxml2 knows the line only, that of the end of a start tag: the offset of
 * the tag, which is the last one of its name up to there. */
static size_t place_of(const finding *f, const char *s, size_t n)
{
    size_t at = 0, len = strlen(f->element);
    int line = 1;

    while (at < n && line < f->line)
        line += s[at++] == '\n';
    if (len == 0)
        return at;
    while (at < n && s[at] != '\n')
        at++;
    for (size_t k = at; k > 0; k--)
        if (k - 1 + len <= n && memcmp(s + k - 1, f->element, len) == 0)
            return k - 1;
    return at;
}

static xmlRelaxNGPtr load_schema(finding *f)
{
    xmlRelaxNGParserCtxtPtr p = xmlRelaxNGNewMemParserCtxt(schema_text,
                                                           sizeof schema_text);
    xmlRelaxNGPtr schema;

    if (!p)
        return NULL;
    xmlRelaxNGSetParserStructuredErrors(p, on_error, f);
    schema = xmlRelaxNGParse(p);
    xmlRelaxNGFreeParserCtxt(p);
    return schema;
}

/* Up to the end or the first error. */
static ix_status run(ix_ctx *ctx, xmlTextReaderPtr reader, finding *f)
{
    int code;

    do {
        IX_TRY(ix__poll(ctx));
        code = xmlTextReaderRead(reader);
    } while (code == 1 && !f->any);
    if (f->memory)
        return IX_FAIL(ctx, IX_ENOMEM, "out of memory in libxml2");
    if (!f->any && (code != 0 || xmlTextReaderIsValid(reader) != 1)) {
        f->any = true;
        (void)snprintf(f->text, sizeof f->text, "not valid by the schema");
    }
    return IX_OK;
}

static ix_status validate(ix_ctx *ctx, const char *text, size_t n, finding *f)
{
    xmlRelaxNGPtr schema = load_schema(f);
    xmlTextReaderPtr reader = NULL;
    ix_status st = IX_ENOMEM;

    if (schema)
        reader = xmlReaderForMemory(text, (int)n, NULL, "UTF-8",
                                    XML_PARSE_NONET | XML_PARSE_IGNORE_ENC);
    if (reader) {
        xmlTextReaderSetStructuredErrorHandler(reader, on_error, f);
        if (xmlTextReaderRelaxNGSetSchema(reader, schema) == 0)
            st = run(ctx, reader, f);
    }
    if (st == IX_ENOMEM)
        st = IX_FAIL(ctx, IX_ENOMEM, "out of memory in libxml2");
    xmlFreeTextReader(reader);
    xmlRelaxNGFree(schema);
    return st;
}

static ix_status check_siblings(ix__xml *x, ix_ctx *ctx)
{
    int count[IX_MAX_DEPTH + 2] = {0}, depth = 0;
    ix__xevent e;

    do {
        IX_TRY(ix__xml_next(x, &e));
        if (e.kind == IX_X_END)
            depth--;
        if (e.kind != IX_X_START)
            continue;
        if (++count[depth] > MAX_SIBLINGS)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "more than %d elements side by side are not held "
                           "against the schema",
                           MAX_SIBLINGS);
        if (++depth > IX_MAX_DEPTH)
            return ix__xml_fail(x, e.at, "elements nested deeper than %d",
                                IX_MAX_DEPTH);
        count[depth] = 0;
    } while (e.kind != IX_X_EOF);
    return IX_OK;
}

ix_status ix__xml_validate(ix_ctx *ctx, const char *fname, const char *text,
                           size_t n)
{
    size_t mark = n >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    finding f = {0};
    xmlStructuredErrorFunc func = xmlStructuredError;
    void *ud = xmlStructuredErrorContext;
    ix__xml *x;
    ix_status st;

    IX_TRY(ix__xml_open(ctx, fname, text, n, &x)); /* scans */
    text += mark;
    n -= mark;
    st = check_siblings(x, ctx);
    xmlSetStructuredErrorFunc(&f, on_error); /* else some are printed */
    if (st == IX_OK)
        st = validate(ctx, text, n, &f);
    xmlSetStructuredErrorFunc(ud, func);
    if (st == IX_OK && f.any)
        st = ix__xml_fail(x, place_of(&f, text, n), "%s", f.text);
    ix__xml_close(x);
    return st;
}
