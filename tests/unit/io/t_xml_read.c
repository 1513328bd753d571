/* XML that is wrong: each error has its place and its reason; limits; nothing
 * is fetched; what is right in an unusual way is read. */
#include <libxml/parser.h>
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/xml_pull.h"

#define ROOT "<iritx xmlns=\"urn:iritx:geometry\" version=\"1\">\n"
#define END  "</iritx>"
#define LINE "<direction basis=\"bezier\" order=\"2\"/>"

static xmlParserInputPtr no_loader(const char *url, const char *id,
                                   xmlParserCtxtPtr p)
{
    (void)id, (void)p;
    fail_msg("%s would be fetched", url);
    return NULL;
}

/* Lines count from the first of the body, which is line 2 of the file. */
static void expect_error(ix_ctx *ctx, const char *body, const char *message)
{
    char *text = malloc(strlen(body) + 100);
    ix_obj *o;

    assert_non_null(text);
    (void)sprintf(text, ROOT "%s" END, body);
    assert_int_equal(ix__xml_read(ctx, "f", text, strlen(text), &o), IX_EPARSE);
    assert_null(o);
    if (!strstr(ix_ctx_message(ctx), message))
        fail_msg("\"%s\" expected, got \"%s\"", message, ix_ctx_message(ctx));
    free(text);
}

static void expect_raw(ix_ctx *ctx, const char *text, size_t n,
                       const char *message)
{
    ix_obj *o;

    assert_int_equal(ix__xml_read(ctx, "f", text, n, &o), IX_EPARSE);
    assert_null(o);
    if (!strstr(ix_ctx_message(ctx), message))
        fail_msg("\"%s\" expected, got \"%s\"", message, ix_ctx_message(ctx));
}

/* --- errors ----------------------------------------------------------- */

typedef struct {
    const char *body, *message;
} wrong;

static const wrong objects[] = {
    {"", "f:1:1: error: file empty"},
    {"<object/>x", "f:2:10: error: text \"x\" between elements"},
    {"\n<thing/>", "f:3:1: error: object expected, found element \"thing\""},
    {"<object id=\"1\"/>", "element \"object\" has no attribute \"id\""},
    {"<object xmlns:a=\"urn:a\" a:name=\"A\"/>", "no attribute \"a:name\""},
    {"<object xmlns=\"urn:a\"/>", "is not of namespace"},
    {"<object name=\"A\" name-hex=\"41\"/>", "both \"name\" and \"name-hex\""},
    {"<object name-hex=\"4\"/>", "name-hex=\"4\": pairs of hexadecimal"},
    {"<object name-hex=\"00\"/>", "name-hex=\"00\""},
    {"<object><number>1</number><number>2</number></object>",
     "f:2:27: error: a second \"number\""},
    {"<object><number>1</number><point>1 2 3</point></object>",
     "an object holds entities of one type"},
    {"<object><object/><number>1</number></object>",
     "objects, not entities, expected"},
    {"<object><number>1</number><object/></object>",
     "entities, not objects, expected"},
    {"<object><object/><attribute name=\"a\" type=\"string\"/></object>",
     "expected, found element \"attribute\""},
    {"<object><number>1 2</number></object>",
     "f:2:19: error: 1 number expected, not more, found \"2\""},
    {"<object><point>1 2</point></object>", "f:2:19: error: a number expected"},
    {"<object><point>1 2<!-- --> x</point></object>", "a number expected"},
    {"<object><number>1e999</number></object>", "out of range"},
    {"<object><number>1,5</number></object>", "found \"1,5\""},
    {"<object><number><b/></number></object>",
     "text expected, found element \"b\""},
    {"<object><undefined>1</undefined></object>", "text \"1\" between"},
    {"<object><undefined><b/></undefined></object>", "found element \"b\""},
    {"<object><string encoding=\"hex\">4g</string></object>",
     "pairs of hexadecimal digits expected"},
    {"<object><string encoding=\"rot13\">a</string></object>",
     "encoding=\"rot13\": one of hex expected"},
    {"<object><instance>1</instance></object>", "needs attribute \"of\""},
    {"<object><controlpoint type=\"e2\">1 2</controlpoint></object>",
     "E1 .. E18 or P1 .. P18 expected"},
    {"<object><controlpoint>1 2</controlpoint></object>",
     "needs attribute \"type\""},
};

static const wrong attributes[] = {
    {"<object><attribute type=\"string\"/></object>", "needs a name"},
    {"<object><attribute name=\"a\"/></object>", "needs attribute \"type\""},
    {"<object><attribute name=\"a\" type=\"text\"/></object>",
     "one of string, integer, real, object expected"},
    {"<object><attribute name=\"a\" type=\"integer\">1.5</attribute></object>",
     "one integer expected, found \".5\""},
    {"<object><attribute name=\"a\" type=\"integer\"/></object>",
     "an integer expected"},
    {"<object><attribute name=\"a\" type=\"integer\">-</attribute></object>",
     "an integer expected"},
    {"<object><attribute name=\"a\" "
     "type=\"integer\">9223372036854775808</attribute></object>",
     "out of range"},
    {"<object><attribute name=\"a\" type=\"real\">x</attribute></object>",
     "a number expected"},
    {"<object><attribute name=\"a\" type=\"real\" "
     "encoding=\"hex\">1</attribute></object>",
     "an encoding of a real"},
    {"<object><attribute name=\"a\" type=\"string\" "
     "encoding=\"hex\">00</attribute></object>",
     "a NUL byte in an attribute"},
    {"<object><attribute name=\"a\" type=\"object\"/></object>",
     "an object expected in it"},
    {"<object><attribute name=\"a\" type=\"object\"><object/><object/>"
     "</attribute></object>",
     "the end of the element expected"},
};

static const wrong freeforms[] = {
    {"<object><curve type=\"E1\"><points>1 2</points></curve></object>",
     "f:2:9: error: 0 directions found, 1 needed"},
    {"<object><surface type=\"E1\">" LINE
     "<points>1</points></surface></object>",
     "1 directions found, 2 needed"},
    {"<object><curve type=\"E1\">" LINE "</curve></object>",
     "no control points"},
    {"<object><curve type=\"E1\">" LINE "<points>1</points></curve></object>",
     "2 control points expected, 1 found"},
    {"<object><curve type=\"E1\">" LINE
     "<points>1 2 3</points></curve></object>",
     "all control points are given already, found \"3\""},
    {"<object><curve type=\"E1\">" LINE "<points>1 2</points>" LINE
     "</curve></object>",
     "a direction behind the points"},
    {"<object><curve type=\"E1\" use=\"uv\">" LINE
     "<points>1 2</points></curve></object>",
     "attribute \"use\" is for curves of"},
    {"<object><curve type=\"E1\"><direction basis=\"spline\" order=\"2\"/>"
     "</curve></object>",
     "one of bezier, bspline, power expected"},
    {"<object><curve type=\"E1\"><direction basis=\"power\" order=\"2\" "
     "length=\"3\"/></curve></object>",
     "a power direction has its order as length"},
    {"<object><curve type=\"E1\"><direction basis=\"bspline\" order=\"3\" "
     "length=\"2\"/></curve></object>",
     "order 3 needs 3 points, there are 2"},
    {"<object><curve type=\"E1\"><direction basis=\"bspline\" order=\"2\" "
     "length=\"2\" periodic=\"yes\"/></curve></object>",
     "true or false expected"},
    {"<object><curve type=\"E1\"><direction basis=\"bspline\" order=\"2\" "
     "length=\"2\"><knots>0 0 1 1 2</knots></direction></curve></object>",
     "all knots are given already, found \"2\""},
    {"<object><curve type=\"E1\"><direction basis=\"bspline\" order=\"2\" "
     "length=\"2\"><knots>0 0 1</knots></direction></curve></object>",
     "3 knots found, 4 needed for 2 points of order 2"},
    {"<object><curve type=\"P1\">" LINE
     "<points>0 1 0 2</points></curve></object>",
     "weights are zero"},
    {"<object><triangularsurface type=\"E1\" basis=\"gregory\" length=\"4\"/>"
     "</object>",
     "an integer in 5 .. 32767 expected"},
    {"<object><triangularsurface type=\"E1\" basis=\"bezier\" length=\"2\">"
     "<points>1 2</points></triangularsurface></object>",
     "3 control points expected, 2 found"},
    {"<object><triangularsurface type=\"E1\" basis=\"bspline\" length=\"2\" "
     "order=\"2\"><knots>0 0 1 0</knots><points>1 2 3</points>"
     "</triangularsurface></object>",
     "knot 3 = 0 is below"},
};

#define FLAT                          \
    "<surface type=\"E3\">" LINE LINE \
    "<points>0 0 0 1 0 0 0 1 0 1 1 0</points></surface>"

static const wrong others[] = {
    {"<object><polygon/></object>", "no vertices"},
    {"<object><polygon plane=\"0 0 0 1\"><points>0 0 0</points></polygon>"
     "</object>",
     "degenerate normal"},
    {"<object><polygon plane=\"0 0 1\"><points>0 0 0</points></polygon>"
     "</object>",
     "plane=\"0 0 1\": 4 numbers expected"},
    {"<object><polyline><points>0 0</points></polyline></object>",
     "f:2:30: error: a number expected"},
    {"<object><polyline><vertex/></polyline></object>", "without a position"},
    {"<object><polyline><vertex position=\"1 2 3 4\"/></polyline></object>",
     "position=\"1 2 3 4\": 3 numbers expected"},
    {"<object><trimmedsurface/></object>",
     "element \"surface\" expected in it"},
    {"<object><trimmedsurface>" FLAT "<loop/></trimmedsurface></object>",
     "a loop without segments"},
    {"<object><trimmedsurface>" FLAT
     "<loop><segment/></loop></trimmedsurface></object>",
     "a segment without its uv curve"},
    {"<object><trimmedsurface>" FLAT
     "<loop><segment><curve use=\"uv1\" type=\"E2\"/></segment></loop>"
     "</trimmedsurface></object>",
     "one of uv, space expected"},
    {"<object><model/></object>", "a model without faces"},
    {"<object><model><face>" FLAT "<edges>1</edges></face></model></object>",
     "edge 1 of 0 in a loop"},
    {"<object><model><face>" FLAT "<edges>0</edges></face></model></object>",
     "the number of an edge expected"},
    {"<object><model><face>" FLAT
     "</face><edge face1=\"1\" face2=\"2\"/></model></object>",
     "face2=\"2\": an integer in 0 .. 1 expected"},
    {"<object><model><face>" FLAT "</face><edge face1=\"1\" face2=\"0\"/>"
     "<face>" FLAT "</face></model></object>",
     "faces, then edges, expected"},
};

static void expect_all(const wrong *w, size_t n)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    for (size_t i = 0; i < n; i++)
        expect_error(ctx, w[i].body, w[i].message);
    ix_ctx_free(ctx);
}

static void test_objects(void **state)
{
    (void)state;
    expect_all(objects, sizeof objects / sizeof *objects);
}

static void test_attributes(void **state)
{
    (void)state;
    expect_all(attributes, sizeof attributes / sizeof *attributes);
}

static void test_freeforms(void **state)
{
    (void)state;
    expect_all(freeforms, sizeof freeforms / sizeof *freeforms);
}

static void test_others(void **state)
{
    (void)state;
    expect_all(others, sizeof others / sizeof *others);
}

/* --- what is refused before it is parsed -------------------------------- */

static void test_documents(void **state)
{
    static const wrong documents[] = {
        {"", "f:1:1: error: < of an element expected"},
        {"words", "< of an element expected"},
        {"<!DOCTYPE a><a/>", "f:1:1: error: a DOCTYPE"},
        {ROOT "\n<!DOCTYPE a SYSTEM \"file:///etc/passwd\">" END,
         "f:3:1: error"},
        {"<?xml version=\"1.0\" encoding='latin1'?>" ROOT END,
         "f:1:31: error: encoding UTF-8 expected"},
        {ROOT "<object>&x;</object>" END, "Entity 'x' not defined"},
        {ROOT "<object>", "f:2:9: error: "},
        {ROOT "<object></thing>" END, "f:2:"},
        {ROOT "<object/>" END "<b/>", "f:2:"},
        {ROOT "<object name=\"\xff\"/>" END, "UTF-8"},
        {"<iritx xmlns=\"urn:iritx:geometry\"/>",
         "needs attribute \"version\""},
        {"<iritx xmlns=\"urn:iritx:geometry\" version=\"9\"/>", "version 9;"},
        {"<other xmlns=\"urn:iritx:geometry\"/>", "iritx expected"},
    };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++)
        expect_raw(ctx, documents[i].body, strlen(documents[i].body),
                   documents[i].message);
    expect_raw(ctx, "<a>\0</a>", 8, "f:1:4: error: a NUL byte");
    ix_ctx_free(ctx);
}

/* One unit beyond each limit, and the limit itself. */
static void test_limits(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    size_t n = IX_XML_MAX_TEXT + 200;
    char *text = malloc(n + 200);
    ix_obj *o;
    int k;

    (void)state;
    assert_non_null(text);
    k = sprintf(text, ROOT "<object><string>");
    memset(text + k, 'x', n);
    (void)sprintf(text + k + IX_XML_MAX_TEXT, "</string></object>" END);
    ASSERT_OK(ctx, ix__xml_read(ctx, "f", text, strlen(text), &o));
    assert_int_equal(o->u.str.len, IX_XML_MAX_TEXT);
    ix__obj_unref(ctx, o);
    memset(text + k + IX_XML_MAX_TEXT, 'x', 40);
    (void)sprintf(text + k + IX_XML_MAX_TEXT + 1, "</string></object>" END);
    expect_raw(ctx, text, strlen(text), "text of more than");
    k = sprintf(text, ROOT "<object name=\"");
    memset(text + k, 'x', IX_XML_MAX_TAG);
    (void)sprintf(text + k + IX_XML_MAX_TAG, "\"/>" END);
    expect_raw(ctx, text, strlen(text), "a tag of more than 64 KiB");
    (void)sprintf(text + k + IX_XML_MAX_TAG - 20, "\"/>" END);
    ASSERT_OK(ctx, ix__xml_read(ctx, "f", text, strlen(text), &o));
    ix__obj_unref(ctx, o);
    free(text);
    ix_ctx_free(ctx);
}

static char *nested(int n)
{
    char *text = malloc((size_t)n * 17 + 200), *p = text;

    assert_non_null(text);
    p += sprintf(p, ROOT);
    for (int i = 0; i < n; i++)
        p += sprintf(p, "<object>");
    for (int i = 0; i < n; i++)
        p += sprintf(p, "</object>");
    (void)sprintf(p, END);
    return text;
}

static void test_depth(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char *deep = nested(IX_MAX_DEPTH - 1), *deeper = nested(IX_MAX_DEPTH);
    ix_buf b;
    ix_obj *o;

    (void)state;
    ASSERT_OK(ctx, ix__xml_read(ctx, "f", deep, strlen(deep), &o));
    ix__buf_init(&b, ctx);
    assert_int_equal(ix__xml_write(&b, o), IX_EUNABLE);
    assert_non_null(strstr(ix_ctx_message(ctx), "nested too deeply"));
    ix__buf_free(&b);
    ix__obj_unref(ctx, o);
    expect_raw(ctx, deeper, strlen(deeper), "elements nested deeper than 256");
    free(deep);
    free(deeper);
    ix_ctx_free(ctx);
}

/* A place far behind the first piece that libxml2 is fed, in a text that it
 * hands over in several parts. */
static void test_far_place(void **state)
{
    const int n = 30000;
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char *text = malloc((size_t)n * 20 + 200), *p = text;

    (void)state;
    assert_non_null(text);
    p += sprintf(p, ROOT "<object><polyline><points>\n");
    for (int i = 0; i < n; i++)
        p += sprintf(p, i == n - 5 ? "1 2 %dx\n" : "1 2 %d\n", i);
    (void)sprintf(p, "</points></polyline></object>" END);
    expect_raw(ctx, text, strlen(text), "f:29998:5: error: a number expected");
    free(text);
    ix_ctx_free(ctx);
}

/* --- what cannot be written --------------------------------------------- */

static void test_write_errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, INFINITY);
    char *name = malloc(IX_XML_MAX_TAG + 1);
    ix_buf b;

    (void)state;
    assert_non_null(name);
    memset(name, 'x', IX_XML_MAX_TAG);
    name[IX_XML_MAX_TAG] = '\0';
    ix__buf_init(&b, ctx);
    assert_int_equal(ix__xml_write(&b, o), IX_EDOMAIN);
    ix__obj_unref(ctx, o);
    o = ix__obj_number(ctx, 1);
    ASSERT_OK(ctx, ix__obj_set_name(ctx, o, name));
    assert_int_equal(ix__xml_write(&b, o), IX_EUNABLE);
    ix__obj_unref(ctx, o);
    ix__buf_free(&b);
    free(name);
    ix_ctx_free(ctx);
}

/* --- the schema ---------------------------------------------------------- */

static ix_status validate(ix_ctx *ctx, const char *text, size_t n)
{
    ix__input *s;
    ix_status st;

    IX_TRY(ix__input_memory(ctx, "f", text, n, 0, &s));
    st = ix__xml_validate(s);
    ix__input_close(s);
    return st;
}

/* Law: what we write is valid, for values of every type. */
static void test_valid(void **state)
{
    ix_rng r = ix_rng_new(0x3d);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf b;

    (void)state;
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        ix_obj *o = ix_rand_obj_of(ctx, &r, (ix_obj_type)t, 2);

        ix__buf_init(&b, ctx);
        ASSERT_OK(ctx, ix__xml_write(&b, o));
        ASSERT_OK(ctx, validate(ctx, b.data, b.len));
        ix__buf_free(&b);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

static void test_invalid(void **state)
{
    static const wrong w[] = {
        {ROOT END, "f:1:1: error: "},
        {ROOT "\n <object>\n<sphere/></object>" END, "f:4:1: error: "},
        {ROOT "<object><number>x</number></object>" END, "f:2:17: error: "},
        {"<!DOCTYPE a><a/>", "a DOCTYPE"},
        {ROOT "<object", "error: "},
    };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t i = 0; i < sizeof w / sizeof *w; i++) {
        assert_int_equal(validate(ctx, w[i].body, strlen(w[i].body)),
                         IX_EPARSE);
        if (!strstr(ix_ctx_message(ctx), w[i].message))
            fail_msg("\"%s\" expected, got \"%s\"", w[i].message,
                     ix_ctx_message(ctx));
    }
    ix_ctx_free(ctx);
}

/* As many elements side by side as there are, one in a moment: the time for
 * each does not grow. The last one is wrong, and is found. */
static void test_many(void **state)
{
    enum { MANY = 200000 };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char *text = malloc(MANY * 9 + 200), *p = text;

    (void)state;
    assert_non_null(text);
    p += sprintf(p, ROOT);
    for (int i = 0; i < MANY; i++)
        p += sprintf(p, "<object/>");
    (void)sprintf(p, END);
    ASSERT_OK(ctx, validate(ctx, text, strlen(text)));
    memcpy(p - 9, "<objact/>", 9);
    assert_int_equal(validate(ctx, text, strlen(text)), IX_EPARSE);
    assert_non_null(strstr(ix_ctx_message(ctx), "f:2:1799992: error: "));
    free(text);
    ix_ctx_free(ctx);
}

/* --- right, if unusual --------------------------------------------------- */

static void test_unusual(void **state)
{
    static const char text[] =
        "\xef\xbb\xbf<?xml version='1.0' encoding='utf-8'?>\r\n"
        "<!-- <!DOCTYPE> is no one here -->\r\n"
        "<?pi <a <b ?>"
        "<g:iritx xmlns:g='urn:iritx:geometry' version='1'>\r\n"
        "<g:object name='caf\xc3\xa9 &amp;#38; &lt;'><!-- ' -->\r\n"
        "<g:string><![CDATA[<&amp;]]>&#65;\r\n</g:string>"
        "<g:string>, more</g:string></g:object>"
        "<g:object name='none'><g:curve type='E1'>"
        "<g:direction order='2' basis='bspline' length='2'>"
        "<g:knots>0 0</g:knots><g:knots>1\r\n1</g:knots></g:direction>"
        "<g:points>1</g:points><g:points/><g:points> +2e0 </g:points>"
        "</g:curve></g:object></g:iritx>\r\n";
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o;

    (void)state;
    ASSERT_OK(ctx, ix__xml_read(ctx, "f", text, sizeof text - 1, &o));
    assert_int_equal(o->u.list.n, 2);
    assert_string_equal(o->u.list.item[0]->name, "CAF\xc3\xa9 &#38; <");
    assert_string_equal(o->u.list.item[0]->u.str.s, "<&amp;A\n, more");
    assert_null(o->u.list.item[1]->name);
    assert_true(ix_mv_coord(ix__obj_first_mv(o->u.list.item[1]), 0)[1] == 2);
    ix__obj_unref(ctx, o);
    ASSERT_OK(ctx, validate(ctx, text, sizeof text - 1));
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_objects),      cmocka_unit_test(test_attributes),
        cmocka_unit_test(test_freeforms),    cmocka_unit_test(test_others),
        cmocka_unit_test(test_documents),    cmocka_unit_test(test_limits),
        cmocka_unit_test(test_depth),        cmocka_unit_test(test_far_place),
        cmocka_unit_test(test_write_errors), cmocka_unit_test(test_valid),
        cmocka_unit_test(test_invalid),      cmocka_unit_test(test_many),
        cmocka_unit_test(test_unusual)};

    xmlSetExternalEntityLoader(no_loader);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
