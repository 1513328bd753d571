/* xml_schema.c - patterns of RELAX NG and their derivatives. Every pattern is
 * made by one function, which looks for it first; recursion is bounded by the
 * depth of the schema. */
#include "io/xml_schema.h"

#include <libxml/parser.h>
#include <libxml/xmlregexp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum {
    NONE,
    EMPTY,
    TEXT,
    CHOICE, /* a or b */
    GROUP,  /* a, then b; attributes in any order */
    MORE,   /* a, once or more often */
    ELEMENT,
    ATTRIBUTE, /* node has the name; its value matches a */
    DATA,
    VALUE,
    LIST /* words that match a */
} kind;

typedef struct {
    kind kind;
    ix__pat a, b;
    const xmlNode *node; /* of ELEMENT, ATTRIBUTE, DATA, VALUE */
    int content;         /* of ELEMENT; -1: not made yet */
    int next;            /* of equal hash; -1 */
} pattern;

enum { HASHES = 512 };

struct ix__schema {
    ix_ctx *ctx;
    xmlDocPtr doc;
    ix_buf pats; /* pattern each */
    int hash[HASHES];
    ix_status st;
};

static pattern *at(const ix__schema *s, ix__pat p)
{
    return (pattern *)(void *)s->pats.data + p;
}

static int count(const ix__schema *s)
{
    return (int)(s->pats.len / sizeof(pattern));
}

/* --- making patterns -------------------------------------------------- */

static ix__pat make(ix__schema *s, kind k, ix__pat a, ix__pat b,
                    const xmlNode *node)
{
    size_t h = ((size_t)k * 31 + (size_t)a * 1009 + (size_t)b * 65599 +
                (size_t)(uintptr_t)node / sizeof *node) %
               HASHES;
    pattern p = {k, a, b, node, -1, s->hash[h]};

    for (int i = s->hash[h]; i >= 0; i = at(s, i)->next) {
        const pattern *q = at(s, i);

        if (q->kind == k && q->a == a && q->b == b && q->node == node)
            return i;
    }
    ix__buf_add(&s->pats, (const char *)&p, sizeof p);
    if (s->pats.failed) {
        s->st = IX_ENOMEM;
        return IX_PAT_NONE;
    }
    return s->hash[h] = count(s) - 1;
}

static bool is_choice_of(const ix__schema *s, ix__pat p, ix__pat q)
{
    for (; at(s, p)->kind == CHOICE; p = at(s, p)->b)
        if (at(s, p)->a == q)
            return true;
    return p == q;
}

/* Choices lean to the right, and nothing stands in one twice. */
static ix__pat choice(ix__schema *s, ix__pat a, ix__pat b)
{
    if (at(s, a)->kind == NONE)
        return b;
    if (at(s, a)->kind == CHOICE) {
        ix__pat rest = choice(s, at(s, a)->b, b);

        return choice(s, at(s, a)->a, rest);
    }
    if (at(s, b)->kind == NONE)
        return a;
    return is_choice_of(s, b, a) ? b : make(s, CHOICE, a, b, NULL);
}

static ix__pat group(ix__schema *s, ix__pat a, ix__pat b)
{
    kind ka = at(s, a)->kind, kb = at(s, b)->kind;

    if (ka == NONE || kb == EMPTY)
        return a;
    if (kb == NONE || ka == EMPTY)
        return b;
    return make(s, GROUP, a, b, NULL);
}

static ix__pat more(ix__schema *s, ix__pat a)
{
    kind k = at(s, a)->kind;

    return k == NONE || k == EMPTY ? a : make(s, MORE, a, 0, NULL);
}

static ix__pat empty(ix__schema *s)
{
    return make(s, EMPTY, 0, 0, NULL);
}

/* --- the schema ------------------------------------------------------- */

static bool is(const xmlNode *n, const char *name)
{
    return n->type == XML_ELEMENT_NODE &&
           strcmp((const char *)n->name, name) == 0;
}

/* The text of attribute name of n, "" if there is none. */
static const char *attr(const xmlNode *n, const char *name)
{
    const xmlAttr *a = n->properties;

    while (a && strcmp((const char *)a->name, name) != 0)
        a = a->next;
    return a && a->children ? (const char *)a->children->content : "";
}

static const char *text_of(const xmlNode *n)
{
    return n->children && n->children->content
               ? (const char *)n->children->content
               : "";
}

static const xmlNode *find_define(const ix__schema *s, const char *name)
{
    const xmlNode *n = xmlDocGetRootElement(s->doc)->children;

    while (n && !(is(n, "define") && strcmp(attr(n, "name"), name) == 0))
        n = n->next;
    return n;
}

static ix__pat build(ix__schema *s, const xmlNode *n);

/* The children of n as a group, or as a choice. */
static ix__pat build_all(ix__schema *s, const xmlNode *n, bool any)
{
    ix__pat p = any ? IX_PAT_NONE : empty(s);

    for (const xmlNode *c = n ? n->last : NULL; c; c = c->prev) {
        if (c->type != XML_ELEMENT_NODE)
            continue;
        p = any ? choice(s, build(s, c), p) : group(s, build(s, c), p);
    }
    return p;
}

/* A recursion through elements stops there: their content is made later. */
static ix__pat build(ix__schema *s, const xmlNode *n)
{
    if (is(n, "element"))
        return make(s, ELEMENT, 0, 0, n);
    if (is(n, "attribute"))
        return make(s, ATTRIBUTE,
                    n->children ? build_all(s, n, false)
                                : make(s, TEXT, 0, 0, NULL),
                    0, n);
    if (is(n, "ref"))
        return build_all(s, find_define(s, attr(n, "name")), false);
    if (is(n, "choice"))
        return build_all(s, n, true);
    if (is(n, "optional"))
        return choice(s, empty(s), build_all(s, n, false));
    if (is(n, "zeroOrMore"))
        return choice(s, empty(s), more(s, build_all(s, n, false)));
    if (is(n, "oneOrMore"))
        return more(s, build_all(s, n, false));
    if (is(n, "data"))
        return make(s, DATA, 0, 0, n);
    if (is(n, "value"))
        return make(s, VALUE, 0, 0, n);
    if (is(n, "list"))
        return make(s, LIST, build_all(s, n, false), 0, NULL);
    if (is(n, "text"))
        return make(s, TEXT, 0, 0, NULL);
    return build_all(s, n, false); /* group, empty */
}

ix_status ix__schema_open(ix_ctx *ctx, const char *text, size_t n,
                          ix__schema **out)
{
    ix__schema *s = ix__alloc(ctx, sizeof *s);

    *out = NULL;
    if (!s)
        return IX_ENOMEM;
    *s = (ix__schema){.ctx = ctx, .st = IX_OK};
    ix__buf_init(&s->pats, ctx);
    for (int i = 0; i < HASHES; i++)
        s->hash[i] = -1;
    (void)make(s, NONE, 0, 0, NULL);
    (void)empty(s);
    s->doc = xmlReadMemory(text, (int)n, NULL, NULL,
                           XML_PARSE_NONET | XML_PARSE_NOBLANKS);
    if (!s->doc)
        s->st = IX_FAIL(ctx, IX_ENOMEM, "out of memory in libxml2");
    if (s->st != IX_OK) {
        ix__schema_close(s);
        return IX_ENOMEM;
    }
    *out = s;
    return IX_OK;
}

void ix__schema_close(ix__schema *s)
{
    if (!s)
        return;
    xmlFreeDoc(s->doc);
    ix__buf_free(&s->pats);
    ix__free(s->ctx, s, sizeof *s);
}

ix_status ix__schema_check(const ix__schema *s)
{
    if (s->st == IX_OK)
        return IX_OK;
    return IX_FAIL(s->ctx, IX_ENOMEM, "out of memory for the schema");
}

ix__pat ix__schema_start(ix__schema *s)
{
    const xmlNode *n = xmlDocGetRootElement(s->doc)->children;

    while (n && !is(n, "start"))
        n = n->next;
    return build_all(s, n, false);
}

ix__pat ix__schema_content(ix__schema *s, int e)
{
    ix__pat p;

    if (at(s, e)->content >= 0)
        return at(s, e)->content;
    p = empty(s);
    for (const xmlNode *c = at(s, e)->node->last; c; c = c->prev) {
        bool names = is(c, "name") || /* <choice> of names, not of patterns */
                     (is(c, "choice") && c->children &&
                      is(c->children, "name"));

        if (c->type == XML_ELEMENT_NODE && !names)
            p = group(s, build(s, c), p);
    }
    if (s->st == IX_OK)
        at(s, e)->content = p;
    return p;
}

/* --- values ----------------------------------------------------------- */

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static void trim(const char **s, size_t *n)
{
    while (*n > 0 && is_blank(**s))
        ++*s, --*n;
    while (*n > 0 && is_blank((*s)[*n - 1]))
        --*n;
}

static size_t digits(const char *s, size_t n)
{
    size_t k = 0;

    while (k < n && s[k] >= '0' && s[k] <= '9')
        k++;
    return k;
}

static size_t sign(const char *s, size_t n)
{
    return n > 0 && (*s == '+' || *s == '-');
}

/* xsd:double but INF and NaN. */
static bool is_double(const char *s, size_t n)
{
    size_t i = sign(s, n), k = digits(s + i, n - i), frac = 0;

    i += k;
    if (i < n && s[i] == '.') {
        frac = digits(s + i + 1, n - i - 1);
        i += frac + 1;
    }
    if (k + frac == 0)
        return false;
    if (i < n && (s[i] == 'e' || s[i] == 'E')) {
        i++;
        i += sign(s + i, n - i);
        k = digits(s + i, n - i);
        if (k == 0)
            return false;
        i += k;
    }
    return i == n;
}

/* -1, 0, 1: how two integers without sign compare. */
static int compare_digits(const char *a, size_t na, const char *b, size_t nb)
{
    int c;

    for (; na > 0 && *a == '0'; na--)
        a++;
    for (; nb > 0 && *b == '0'; nb--)
        b++;
    if (na != nb)
        return na < nb ? -1 : 1;
    c = na ? memcmp(a, b, na) : 0;
    return c < 0 ? -1 : c > 0;
}

/* An integer s is at least, or at most, the bound (no sign: natural). */
static int compare_int(const char *s, size_t n, const char *bound)
{
    bool minus = *s == '-', below = *bound == '-';
    size_t k = sign(s, n), j = sign(bound, 1);
    int c = compare_digits(s + k, n - k, bound + j, strlen(bound + j));

    if (minus != below) {
        bool zeros = compare_digits(s + k, n - k, "", 0) == 0 &&
                     compare_digits(bound + j, strlen(bound + j), "", 0) == 0;

        return zeros ? 0 : minus ? -1 : 1;
    }
    return minus ? -c : c;
}

static bool is_integer(const char *type, const char *s, size_t n)
{
    size_t k = sign(s, n);

    if (n == k || digits(s + k, n - k) != n - k)
        return false;
    if (strcmp(type, "long") == 0)
        return compare_int(s, n, "9223372036854775807") <= 0 &&
               compare_int(s, n, "-9223372036854775808") >= 0;
    if (strcmp(type, "positiveInteger") == 0)
        return compare_int(s, n, "1") >= 0;
    if (strcmp(type, "nonNegativeInteger") == 0)
        return compare_int(s, n, "0") >= 0;
    return true;
}

/* One class of characters, "[a-z.+\-\s]*" or "...+", which the long texts have:
 * *known false for other patterns. */
static bool match_class(const char *pat, const char *s, size_t n, bool *known)
{
    bool in[256] = {false};
    const char *p = pat + 1;

    *known = false;
    if (*pat != '[')
        return false;
    for (; *p && *p != ']'; p++) {
        if (p[0] == '\\' && p[1] == 's') {
            in[' '] = in['\t'] = in['\n'] = in['\r'] = true;
            p++;
        } else if (p[0] == '\\') {
            in[(unsigned char)*++p] = true;
        } else if (p[1] == '-' && p[2] != ']') {
            for (int c = (unsigned char)*p; c <= (unsigned char)p[2]; c++)
                in[c] = true;
            p += 2;
        } else {
            in[(unsigned char)*p] = true;
        }
    }
    if (!*p || (strcmp(p, "]*") != 0 && strcmp(p, "]+") != 0))
        return false;
    *known = true;
    for (size_t i = 0; i < n; i++)
        if (!in[(unsigned char)s[i]])
            return false;
    return p[1] == '*' || n > 0;
}

static bool match_pattern(ix__schema *s, const char *pat, const char *text,
                          size_t n)
{
    bool known, ok = match_class(pat, text, n, &known);
    xmlRegexpPtr re;
    xmlChar *copy;

    if (known)
        return ok;
    re = xmlRegexpCompile((const xmlChar *)pat);
    copy = xmlStrndup((const xmlChar *)text, (int)n);
    if (!re || !copy)
        s->st = IX_ENOMEM;
    ok = s->st == IX_OK && xmlRegexpExec(re, copy) == 1;
    xmlFree(copy);
    xmlRegFreeRegexp(re);
    return ok;
}

static bool match_data(ix__schema *s, const xmlNode *node, const char *text,
                       size_t n)
{
    const char *type = attr(node, "type");

    if (strcmp(type, "string") != 0)
        trim(&text, &n);
    if (strcmp(type, "double") == 0 && !is_double(text, n))
        return false;
    if (strcmp(type, "string") != 0 && strcmp(type, "double") != 0 &&
        !is_integer(type, text, n))
        return false;
    for (const xmlNode *c = node->children; c; c = c->next) {
        const char *param = attr(c, "name"), *v = text_of(c);

        if (!is(c, "param"))
            continue;
        if (strcmp(param, "pattern") == 0        ? !match_pattern(s, v, text, n)
            : strcmp(param, "minInclusive") == 0 ? compare_int(text, n, v) < 0
                                                 : compare_int(text, n, v) > 0)
            return false;
    }
    return true;
}

static bool match_value(const xmlNode *node, const char *text, size_t n)
{
    const char *v = text_of(node);

    trim(&text, &n);
    return n == strlen(v) && memcmp(text, v, n) == 0;
}

/* --- derivatives ------------------------------------------------------ */

/* What has been seen: an element, an attribute or a word of a list. */
typedef struct {
    kind kind; /* ELEMENT, ATTRIBUTE, LIST */
    ix__pat element;
    const char *name, *s;
    size_t n;
} event;

bool ix__schema_may_end(const ix__schema *s, ix__pat p)
{
    const pattern *q = at(s, p);

    switch (q->kind) {
    case EMPTY:
    case TEXT:
        return true;
    case CHOICE:
        return ix__schema_may_end(s, q->a) || ix__schema_may_end(s, q->b);
    case GROUP:
        return ix__schema_may_end(s, q->a) && ix__schema_may_end(s, q->b);
    case MORE:
        return ix__schema_may_end(s, q->a);
    default:
        return false;
    }
}

static bool matches(ix__schema *s, ix__pat p, const event *e)
{
    const pattern q = *at(s, p);

    switch (e->kind) {
    case ELEMENT:
        return p == e->element;
    case ATTRIBUTE:
        return q.kind == ATTRIBUTE &&
               strcmp(attr(q.node, "name"), e->name) == 0 &&
               ix__schema_text(s, q.a, e->s, e->n);
    default:
        return q.kind == DATA    ? match_data(s, q.node, e->s, e->n)
               : q.kind == VALUE ? match_value(q.node, e->s, e->n)
                                 : false;
    }
}

/* What may follow e where p may stand. Patterns move when one is made. */
static ix__pat derive(ix__schema *s, ix__pat p, const event *e)
{
    const pattern q = *at(s, p);
    ix__pat a, b;

    switch (q.kind) {
    case CHOICE:
        a = derive(s, q.a, e);
        return choice(s, a, derive(s, q.b, e));
    case GROUP:
        a = group(s, derive(s, q.a, e), q.b);
        if (e->kind != ATTRIBUTE && !ix__schema_may_end(s, q.a))
            return a;
        b = derive(s, q.b, e);
        return choice(s, a, e->kind == ATTRIBUTE ? group(s, q.a, b) : b);
    case MORE:
        a = derive(s, q.a, e);
        return group(s, a, choice(s, empty(s), p));
    default:
        return matches(s, p, e) ? empty(s) : IX_PAT_NONE;
    }
}

ix__pat ix__schema_behind(ix__schema *s, ix__pat p, int element)
{
    const event e = {.kind = ELEMENT, .element = element};

    return derive(s, p, &e);
}

ix__pat ix__schema_with(ix__schema *s, ix__pat p, const char *name,
                        const char *value)
{
    const event e = {
        .kind = ATTRIBUTE, .name = name, .s = value, .n = strlen(value)};

    return derive(s, p, &e);
}

ix__pat ix__schema_closed(ix__schema *s, ix__pat p)
{
    const pattern q = *at(s, p);
    ix__pat a;

    switch (q.kind) {
    case ATTRIBUTE:
        return IX_PAT_NONE;
    case CHOICE:
        a = ix__schema_closed(s, q.a);
        return choice(s, a, ix__schema_closed(s, q.b));
    case GROUP:
        a = ix__schema_closed(s, q.a);
        return group(s, a, ix__schema_closed(s, q.b));
    case MORE:
        return more(s, ix__schema_closed(s, q.a));
    default:
        return p;
    }
}

static bool match_list(ix__schema *s, ix__pat p, const char *text, size_t n)
{
    event e = {.kind = LIST, .s = text};
    const char *end = text + n;

    for (;;) {
        while (e.s < end && is_blank(*e.s))
            e.s++;
        if (e.s == end)
            return ix__schema_may_end(s, p);
        for (e.n = 0; e.s + e.n < end && !is_blank(e.s[e.n]);)
            e.n++;
        p = derive(s, p, &e);
        e.s += e.n;
    }
}

bool ix__schema_text(ix__schema *s, ix__pat p, const char *text, size_t n)
{
    const pattern q = *at(s, p);
    const char *t = text;
    size_t k = n;

    switch (q.kind) {
    case TEXT:
        return true;
    case EMPTY:
        trim(&t, &k);
        return k == 0;
    case DATA:
        return match_data(s, q.node, text, n);
    case VALUE:
        return match_value(q.node, text, n);
    case LIST:
        return match_list(s, q.a, text, n);
    case CHOICE:
        return ix__schema_text(s, q.a, text, n) ||
               ix__schema_text(s, q.b, text, n);
    case GROUP:
        return (ix__schema_may_end(s, q.b) &&
                ix__schema_text(s, q.a, text, n)) ||
               (ix__schema_may_end(s, q.a) && ix__schema_text(s, q.b, text, n));
    case MORE:
        return ix__schema_text(s, q.a, text, n);
    default:
        return false;
    }
}

/* --- what may come ---------------------------------------------------- */

/* <element name="..."> or names in a <choice>: is name the i-th; NULL: none. */
static const char *name_of(const xmlNode *e, int i)
{
    const xmlNode *c = e->children;

    if (*attr(e, "name"))
        return i == 0 ? attr(e, "name") : NULL;
    for (c = c ? c->children : NULL; c; c = c->next)
        if (is(c, "name") && i-- == 0)
            return text_of(c);
    return NULL;
}

static bool has_name(const xmlNode *e, const char *name)
{
    const char *own;

    for (int i = 0; (own = name_of(e, i)); i++)
        if (strcmp(own, name) == 0)
            return true;
    return false;
}

int ix__schema_find(ix__schema *s, ix__pat p, const char *name)
{
    const pattern q = *at(s, p);
    int e;

    switch (q.kind) {
    case ELEMENT:
        return has_name(q.node, name) ? p : -1;
    case CHOICE:
        e = ix__schema_find(s, q.a, name);
        return e >= 0 ? e : ix__schema_find(s, q.b, name);
    case GROUP:
        e = ix__schema_find(s, q.a, name);
        return e >= 0 || !ix__schema_may_end(s, q.a)
                   ? e
                   : ix__schema_find(s, q.b, name);
    case MORE:
        return ix__schema_find(s, q.a, name);
    default:
        return -1;
    }
}

static void add_name(char *out, size_t room, const char *name)
{
    size_t n = strlen(out);

    if (!strstr(out, name) && n + strlen(name) + 3 < room)
        (void)snprintf(out + n, room - n, "%s%s", n ? ", " : "", name);
}

void ix__schema_expected(const ix__schema *s, ix__pat p, bool attributes,
                         char *out, size_t room)
{
    const pattern q = *at(s, p);
    const char *name;

    if (q.kind == ELEMENT && !attributes)
        for (int i = 0; (name = name_of(q.node, i)); i++)
            add_name(out, room, name);
    if (q.kind == ATTRIBUTE && attributes)
        add_name(out, room, attr(q.node, "name"));
    if (q.kind != CHOICE && q.kind != GROUP && q.kind != MORE)
        return;
    ix__schema_expected(s, q.a, attributes, out, room);
    if (q.kind == CHOICE ||
        (q.kind == GROUP && (attributes || ix__schema_may_end(s, q.a))))
        ix__schema_expected(s, q.b, attributes, out, room);
}
