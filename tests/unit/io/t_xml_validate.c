/* The schema as we match it against libxml2's RELAX NG, which reads
 * docs/iritx.rng by itself: documents of all types, whole and with elements,
 * attributes and texts lost, doubled, exchanged or changed, are valid for both
 * or for neither. */
#include <libxml/parser.h>
#include <libxml/relaxng.h>
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/input.h"

static xmlRelaxNGPtr schema;

static void quiet(void *ud, const char *fmt, ...)
{
    (void)ud;
    (void)fmt;
}

static int load_schema(void **state)
{
    xmlRelaxNGParserCtxtPtr p = xmlRelaxNGNewParserCtxt("docs/iritx.rng");

    (void)state;
    schema = xmlRelaxNGParse(p);
    xmlRelaxNGFreeParserCtxt(p);
    return schema ? 0 : -1;
}

static int free_schema(void **state)
{
    (void)state;
    xmlRelaxNGFree(schema);
    return 0;
}

static bool valid_for_libxml2(xmlDocPtr doc)
{
    xmlRelaxNGValidCtxtPtr v = xmlRelaxNGNewValidCtxt(schema);
    int code;

    assert_non_null(v);
    xmlRelaxNGSetValidErrors(v, quiet, quiet, NULL);
    code = xmlRelaxNGValidateDoc(v, doc);
    xmlRelaxNGFreeValidCtxt(v);
    return code == 0;
}

static ix_status validate(ix_ctx *ctx, const char *text, size_t n, size_t piece)
{
    ix__input *in;
    ix_status st;

    IX_TRY(ix__input_memory(ctx, "f", text, n, piece, &in));
    st = ix__xml_validate(in);
    ix__input_close(in);
    return st;
}

/* True if both say that doc is valid. */
static bool compare(ix_ctx *ctx, xmlDocPtr doc)
{
    bool theirs = valid_for_libxml2(doc);
    xmlChar *text;
    ix_status st;
    int n;

    xmlDocDumpMemory(doc, &text, &n);
    st = validate(ctx, (const char *)text, (size_t)n, 0);
    if ((st == IX_OK) != theirs || (st != IX_OK && st != IX_EPARSE))
        fail_msg("libxml2: %s, ours: %s\n%.3000s", theirs ? "valid" : "invalid",
                 st == IX_OK ? "valid" : ix_ctx_message(ctx), (char *)text);
    xmlFree(text);
    return theirs;
}

/* --- changes ------------------------------------------------------------ */

static xmlNodePtr next_in_order(xmlNodePtr n)
{
    if (n->children && n->type == XML_ELEMENT_NODE)
        return n->children;
    while (n && !n->next)
        n = n->parent;
    return n ? n->next : NULL;
}

/* Some element below the root; NULL if there is none. */
static xmlNodePtr pick(xmlDocPtr doc, ix_rng *r)
{
    xmlNodePtr root = xmlDocGetRootElement(doc), found = NULL;
    int seen = 0;

    for (xmlNodePtr n = root->children; n; n = next_in_order(n))
        if (n->type == XML_ELEMENT_NODE && ix_rng_int(r, 0, seen++) == 0)
            found = n;
    return found;
}

static void change_attribute(xmlNodePtr n, ix_rng *r)
{
    static const char *const values[] = {
        "0",   "1",   "2",   "-1",   "1.5",    "1025",
        "+3",  " 4 ", "",    "true", "bezier", "bspline",
        "uv1", "E19", "P18", "ab",   "abc",    "object"};
    static const char *const names[] = {"name",   "name-hex", "type",  "order",
                                        "length", "basis",    "plane", "face1",
                                        "use",    "encoding"};
    const xmlAttr *a = n->properties;
    const char *v = values[ix_rng_int(r, 0, 17)];

    if (a && a->next && ix_rng_int(r, 0, 1))
        a = a->next;
    switch (ix_rng_int(r, 0, 2)) {
    case 0:
        if (a)
            (void)xmlUnsetProp(n, a->name);
        break;
    case 1:
        if (a)
            (void)xmlSetProp(n, a->name, (const xmlChar *)v);
        break;
    default:
        (void)xmlSetProp(n, (const xmlChar *)names[ix_rng_int(r, 0, 9)],
                         (const xmlChar *)v);
        break;
    }
}

/* Not "1e": libxml2 takes it for an xsd:double, which it is not (XML
 * Schema 1.0, part 2, 3.2.5.1). */
static void change_text(xmlNodePtr n, ix_rng *r)
{
    static const char *const texts[] = {"",
                                        " ",
                                        "1",
                                        "x",
                                        "1 2 3",
                                        "1 2 3 4",
                                        "-.5e+3",
                                        "1f",
                                        "1 2x",
                                        "INF",
                                        "5.",
                                        "+7 -8.",
                                        "9223372036854775808",
                                        "-1"};

    if (!n->children ||
        (n->children->type == XML_TEXT_NODE && !n->children->next))
        xmlNodeSetContent(n, (const xmlChar *)texts[ix_rng_int(r, 0, 13)]);
}

static void change(xmlDocPtr doc, ix_rng *r)
{
    static const char *const names[] = {"object", "attribute", "curve",
                                        "points", "string",    "vertex",
                                        "edges",  "none"};
    xmlNodePtr n = pick(doc, r), m = pick(doc, r);

    if (!n)
        return;
    switch (ix_rng_int(r, 0, 6)) {
    case 0:
        xmlUnlinkNode(n);
        xmlFreeNode(n);
        break;
    case 1:
        (void)xmlAddNextSibling(n, xmlCopyNode(n, 1));
        break;
    case 2:
        (void)xmlAddPrevSibling(m, xmlCopyNode(n, 1));
        break;
    case 3:
        xmlNodeSetName(n, (const xmlChar *)names[ix_rng_int(r, 0, 7)]);
        break;
    case 4:
        change_text(n, r);
        break;
    default:
        change_attribute(n, r);
        break;
    }
}

static void test_against_libxml2(void **state)
{
    ix_rng r = ix_rng_new(0x5c4e);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    int valid = 0, invalid = 0;

    (void)state;
    for (int i = 0; i < 60; i++) {
        ix_obj *o = ix_rand_obj_of(
            ctx, &r,
            (ix_obj_type)(IX_OBJ_POLY +
                          i % (IX_OBJ_MULTIVAR - IX_OBJ_POLY + 1)),
            1);
        xmlDocPtr whole;
        ix_buf b;

        ix__buf_init(&b, ctx);
        ASSERT_OK(ctx, ix__xml_write(&b, o));
        whole = xmlReadMemory(b.data, (int)b.len, NULL, NULL, 0);
        assert_non_null(whole);
        assert_true(compare(ctx, whole));
        for (int k = 0; k < 20; k++) {
            xmlDocPtr doc = xmlCopyDoc(whole, 1);

            change(doc, &r);
            if (compare(ctx, doc))
                valid++;
            else
                invalid++;
            xmlFreeDoc(doc);
        }
        xmlFreeDoc(whole);
        ix__buf_free(&b);
        ix__obj_unref(ctx, o);
    }
    assert_true(valid > 100 && invalid > 300); /* both occur */
    ix_ctx_free(ctx);
}

/* --- memory ------------------------------------------------------------- */

static ix_status run_faults(ix_ctx *ctx, void *state)
{
    return validate(ctx, state, strlen(state), 16);
}

static void test_faults(void **state)
{
    char text[] =
        "<iritx xmlns=\"urn:iritx:geometry\" version=\"1\"><object name=\"A\">"
        "<attribute name=\"color\" type=\"integer\">4</attribute>"
        "<curve type=\"E1\"><direction basis=\"bezier\" order=\"1\"/>"
        "<points>5</points></curve></object></iritx>";
    ix_fault_case c = {NULL, run_faults, NULL, text};

    (void)state;
    assert_true(ix_fault_run(&c) > 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_against_libxml2),
                                       cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, load_schema, free_schema);
}
