/* xml_validate.c - XML against the RELAX NG schema of docs/iritx.rng, which is
 * compiled in: element by element, as the text comes, so that memory and the
 * time for an element do not depend on the size of the file. */
#include <stdio.h>
#include <string.h>

#include "io/xml_pull.h"
#include "io/xml_schema.h"

static const char schema_text[] = {
#include "iritx_rng.h"
};

/* Of an element that is open. */
typedef struct {
    ix__pat rest;  /* what may still come */
    size_t at;     /* of its tag */
    bool children; /* some element has come */
    char name[24]; /* for messages; names of the schema are shorter */
} level;

/* level[0] is the file. */
typedef struct {
    ix__xml *x;
    ix__schema *schema;
    ix_buf text; /* since the last tag */
    size_t text_at;
    int depth;
    level level[IX_MAX_DEPTH + 2];
} checker;

static bool is_blank(const ix_buf *b)
{
    for (size_t i = 0; i < b->len; i++)
        if (!b->data[i] || !strchr(" \t\r\n", b->data[i]))
            return false;
    return true;
}

/* --- tags ------------------------------------------------------------- */

static ix_status bad_element(checker *c, const ix__xevent *e)
{
    const level *l = &c->level[c->depth];
    char wanted[300] = "";

    ix__schema_expected(c->schema, l->rest, false, wanted, sizeof wanted);
    if (*wanted)
        return ix__xml_fail(c->x, e->at,
                            "element \"%.40s\" may not stand here; the schema "
                            "expects %s",
                            e->s, wanted);
    return ix__xml_fail(c->x, e->at,
                        "element \"%.40s\" may not stand here; the schema "
                        "expects the end of \"%s\"",
                        e->s, l->name);
}

static ix_status bad_attribute(checker *c, const ix__xevent *e, ix__pat p,
                               const char *name, const char *value)
{
    char allowed[300] = "";

    ix__schema_expected(c->schema, p, true, allowed, sizeof allowed);
    return ix__xml_fail(c->x, e->at,
                        "attribute %.40s=\"%.40s\" of element \"%s\" does not "
                        "fit the schema%s%s",
                        name, value, e->s, *allowed ? "; it may have " : "",
                        allowed);
}

/* The content that the attributes leave. */
static ix_status take_attributes(checker *c, const ix__xevent *e, ix__pat *p)
{
    const char *s = e->s + strlen(e->s) + 1;
    char needed[300] = "";
    ix__pat next;

    for (int i = 0; i < e->nattrs; i++) {
        const char *value = s + strlen(s) + 1;

        next = ix__schema_with(c->schema, *p, s, value);
        IX_TRY(ix__schema_check(c->schema));
        if (next == IX_PAT_NONE)
            return bad_attribute(c, e, *p, s, value);
        *p = next;
        s = value + strlen(value) + 1;
    }
    next = ix__schema_closed(c->schema, *p);
    IX_TRY(ix__schema_check(c->schema));
    if (next == IX_PAT_NONE) {
        ix__schema_expected(c->schema, *p, true, needed, sizeof needed);
        return ix__xml_fail(c->x, e->at, "element \"%s\" needs attribute %s",
                            e->s, needed);
    }
    *p = next;
    return IX_OK;
}

static ix_status check_between(checker *c)
{
    if (!is_blank(&c->text))
        return ix__xml_fail(c->x, c->text_at, "text between elements");
    ix__buf_clear(&c->text);
    return IX_OK;
}

static ix_status on_start(checker *c, const ix__xevent *e)
{
    level *l = &c->level[c->depth];
    int kind = ix__schema_find(c->schema, l->rest, e->s);
    ix__pat p;

    IX_TRY(check_between(c));
    if (kind < 0)
        return bad_element(c, e);
    if (c->depth == IX_MAX_DEPTH)
        return ix__xml_fail(c->x, e->at, "elements nested deeper than %d",
                            IX_MAX_DEPTH);
    l->rest = ix__schema_behind(c->schema, l->rest, kind);
    l->children = true;
    p = ix__schema_content(c->schema, kind);
    IX_TRY(ix__schema_check(c->schema));
    IX_TRY(take_attributes(c, e, &p));
    l = &c->level[++c->depth];
    *l = (level){.rest = p, .at = e->at};
    (void)snprintf(l->name, sizeof l->name, "%s", e->s);
    return IX_OK;
}

static ix_status early_end(checker *c, const level *l)
{
    char wanted[300] = "";

    ix__schema_expected(c->schema, l->rest, false, wanted, sizeof wanted);
    return ix__xml_fail(c->x, l->at,
                        "element \"%s\" is not complete; the "
                        "schema expects %s",
                        l->name, wanted);
}

static ix_status on_end(checker *c)
{
    const level *l = &c->level[c->depth];
    ix_status st = IX_OK;

    if (l->children || is_blank(&c->text)) {
        IX_TRY(check_between(c));
        if (!ix__schema_may_end(c->schema, l->rest) &&
            (l->children || !ix__schema_text(c->schema, l->rest, "", 0)))
            st = early_end(c, l);
    } else if (!ix__schema_text(c->schema, l->rest, c->text.data,
                                c->text.len)) {
        st = ix__xml_fail(c->x, c->text_at,
                          "the text of element \"%s\" does not fit the schema",
                          l->name);
    }
    ix__buf_clear(&c->text);
    c->depth--;
    return st;
}

static ix_status on_text(checker *c, const ix__xevent *e)
{
    if (c->text.len == 0)
        c->text_at = e->at;
    ix__buf_add(&c->text, e->s, e->n);
    IX_TRY(ix__buf_check(&c->text));
    if (c->text.len <= IX_XML_MAX_TEXT)
        return IX_OK;
    return ix__xml_fail(c->x, c->text_at,
                        "text of more than %zu bytes in one element",
                        IX_XML_MAX_TEXT);
}

/* --- files ------------------------------------------------------------ */

static ix_status run(checker *c)
{
    ix__xevent e;

    c->level[0].rest = ix__schema_start(c->schema);
    for (;;) {
        IX_TRY(ix__schema_check(c->schema));
        IX_TRY(ix__xml_next(c->x, &e));
        if (e.kind == IX_X_EOF)
            return IX_OK;
        if (e.kind == IX_X_START)
            IX_TRY(on_start(c, &e));
        else if (e.kind == IX_X_END)
            IX_TRY(on_end(c));
        else
            IX_TRY(on_text(c, &e));
    }
}

ix_status ix__xml_validate(ix__input *src)
{
    ix_ctx *ctx = ix__input_ctx(src);
    checker *c = ix__alloc(ctx, sizeof *c);
    ix_status st;

    if (!c)
        return IX_ENOMEM;
    memset(c, 0, sizeof *c);
    ix__buf_init(&c->text, ctx);
    st = ix__schema_open(ctx, schema_text, sizeof schema_text, &c->schema);
    if (st == IX_OK)
        st = ix__xml_open(src, &c->x);
    if (st == IX_OK)
        st = run(c);
    ix__xml_close(c->x);
    ix__schema_close(c->schema);
    ix__buf_free(&c->text);
    ix__free(ctx, c, sizeof *c);
    return st;
}
