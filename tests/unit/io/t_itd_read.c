/* The text reader: tolerances of the format, and each error with its line and
 * column. */
#include <stdlib.h>
#include <string.h>

#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/io.h"

static ix_obj *read_text(ix_ctx *ctx, const char *text)
{
    ix_obj *o;
    ix_status st = ix__itd_read(ctx, "t", text, strlen(text), &o);

    if (st != IX_OK)
        fail_msg("%s\n%s", text, ix_ctx_message(ctx));
    return o;
}

/* Two texts mean the same object, names and attributes included. */
static void same_object(const char *a, const char *b)
{
    const ix_write_opts exact = {.file = true};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *x = read_text(ctx, a), *y = read_text(ctx, b);
    ix_buf s, t;

    ix__buf_init(&s, ctx);
    ix__buf_init(&t, ctx);
    ASSERT_OK(ctx, ix__itd_write(&s, x, &exact, 0));
    ASSERT_OK(ctx, ix__itd_write(&t, y, &exact, 0));
    assert_string_equal(s.data, t.data);
    ix__obj_unref(ctx, x);
    ix__obj_unref(ctx, y);
    ix__buf_free(&s);
    ix__buf_free(&t);
    ix_ctx_free(ctx);
}

/* The message is exactly "t:<expected>", and nothing is made. */
static void refused_bytes(const char *text, size_t n, const char *expected)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char *exact = malloc(n ? n : 1); /* the sanitizer watches its end */
    ix_obj *o = NULL;
    size_t live;

    memcpy(exact, text, n);
    assert_int_equal(ix__itd_read(ctx, "t", exact, n, &o), IX_EPARSE);
    assert_null(o);
    if (strcmp(ix_ctx_message(ctx) + 2, expected) != 0)
        fail_msg("%s\ngives    %s\nexpected t:%s", text, ix_ctx_message(ctx),
                 expected);
    live = ctx->live;
    ix_ctx_free(ctx);
    assert_true(live < 3u << 20); /* kept scratch, free boxes: no leak */
    free(exact);
}

static void refused(const char *text, const char *expected)
{
    refused_bytes(text, strlen(text), expected);
}

/* --- tolerances ------------------------------------------------------- */

#define LINE "[OBJECT L\n[CURVE BEZIER 2 E2\n[0 1]\n[2 3]\n]\n]\n"

static void test_layout_is_free(void **state)
{
    (void)state;
    same_object(LINE, "[OBJECT L[CURVE BEZIER 2 E2[0 1][2 3]]]");
    same_object(LINE, "[object l [cUrVe bezier 2 e2 [ 0\t1 ]\n[2\n3]]]");
    same_object(LINE,
                "[OBJECT L\r\n[CURVE BEZIER 2 E2\r\n[0 1]\r\n[2 3]]]\r\n");
    same_object(LINE, "\xef\xbb\xbf" LINE);
    same_object(LINE, "[OBJECT L [CURVE BEZIER 2.0 E2 [+0 1.] [2e0 .3E1]]]");
    same_object(LINE, "[OBJECT L [CURVE BEZIER [a 1] [b] 2 E2 [0 1][2 3]]]");
}

static void test_free_text(void **state)
{
    (void)state;
    same_object(LINE, "before \"it\" " LINE " behind ] [ not looked at");
    same_object(LINE, "caf\xe9, Latin-1 in a comment\n" LINE);
    same_object("[OBJECT A [OBJECT B [NUMBER 1]] [OBJECT C [NUMBER 2]]]",
                "[OBJECT A words here [OBJECT B and here [NUMBER 1]] or "
                "\"here\" [OBJECT C [NUMBER 2]] and here]");
}

static void test_objects(void **state)
{
    (void)state;
    /* one object stands for itself, several are a list */
    same_object("[OBJECT NONE [OBJECT A [NUMBER 1]] [OBJECT B [NUMBER 2]]]",
                "[OBJECT A [NUMBER 1]] [OBJECT B [NUMBER 2]]");
    /* empty ones are dropped, also as elements */
    same_object("[OBJECT A [NUMBER 1]]",
                "[OBJECT X] [OBJECT A [NUMBER 1]] [OBJECT Y]");
    /* bare geometry */
    same_object("[OBJECT NONE [NUMBER 1]]", "[NUMBER 1]");
    same_object("[OBJECT NONE [CURVE BEZIER 1 E1 [1]] [CURVE BEZIER 1 E1 [2]]]",
                "[CURVE BEZIER 1 E1 [1]] [CURVE BEZIER 1 E1 [2]] text");
    /* quoted: no name */
    same_object("[OBJECT NONE [NUMBER 1]]", "[OBJECT \"name\" [NUMBER 1]]");
    same_object("[OBJECT NONE [NUMBER 1]]", "[OBJECT none [NUMBER 1]]");
    same_object("[OBJECT POINT [NUMBER 1]]", "[OBJECT Point [NUMBER 1]]");
}

/* An attribute's type follows from the look of its value. */
static void test_attributes(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(
        ctx, "[OBJECT [a 2] [b 2.0] [c 1e2] [d 2.5] [e \"2\"] [f word more] "
             "[g] [h 2012-05-01] [i e] [j [OBJECT NONE [NUMBER 1]]] [K \"a\\\"b"
             "\\\\\"] [a 7] [big 1e300] [color red] N [NUMBER 1]]");
    ix_attr *a = o->attrs;

    (void)state;
    assert_string_equal(a->name, "a"); /* the file's order, replaced in place */
    assert_int_equal(a->type, IX_ATTR_INT);
    assert_int_equal(a->i, 7);
    assert_int_equal(ix__attr_find(a, "B")->type, IX_ATTR_INT);
    assert_int_equal(ix__attr_find(a, "c")->i, 100);
    assert_true(ix__attr_find(a, "d")->r == 2.5);
    assert_string_equal(ix__attr_find(a, "e")->s, "2");
    assert_string_equal(ix__attr_find(a, "f")->s, "word");
    assert_string_equal(ix__attr_find(a, "g")->s, "");
    assert_string_equal(ix__attr_find(a, "h")->s, "2012-05-01");
    assert_string_equal(ix__attr_find(a, "i")->s, "e");
    assert_int_equal(ix__attr_find(a, "j")->obj->type, IX_OBJ_NUMBER);
    assert_string_equal(ix__attr_find(a, "k")->s, "a\"b\\");
    assert_int_equal(ix__attr_find(a, "big")->type, IX_ATTR_REAL);
    assert_string_equal(ix__attr_find(a, "color")->s, "red");
    assert_null(ix__attr_find(a, "n"));
    ix__obj_unref(ctx, o);
    o = read_text(ctx, "[OBJECT [two [OBJECT A [NUMBER 1]] [OBJECT B [NUMBER "
                       "2]]] [none [OBJECT X]] N [NUMBER 1]]");
    assert_int_equal(o->attrs->obj->type, IX_OBJ_LIST);
    assert_int_equal(o->attrs->obj->u.list.n, 2);
    assert_string_equal(o->attrs->next->s, "");
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* A quoted name is a name, also where the word would mean something. */
static void test_quoted_names(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, "[OBJECT [\"two words\" 1] P [POLYGON "
                               "[\"PLANE\" 2] 1 [[\"NORMAL\" 3] 0 0 0]]]");
    const ix_polygon *p = o->u.poly->poly;

    (void)state;
    assert_int_equal(ix__attr_find(o->attrs, "Two Words")->i, 1);
    assert_int_equal(ix__attr_find(p->attrs, "plane")->i, 2);
    assert_int_equal(ix__attr_find(p->v[0].attrs, "normal")->i, 3);
    assert_false(p->has_plane || p->v[0].has_normal);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

static void test_many_attributes(void **state)
{
    char text[8000] = "[OBJECT ";

    (void)state;
    for (int i = 0; i < 1001; i++)
        (void)snprintf(text + strlen(text), 16, "[a%d]", i);
    refused(text, "1:5899: error: more than 1000 attributes");
}

static void test_strings(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, "[OBJECT S [STRING \"a\\\"\\n\\\\ \xe9\"]]");

    (void)state;
    assert_string_equal(o->u.str.s, "a\"n\\ \xe9");
    assert_int_equal(o->u.str.len, 6);
    ix__obj_unref(ctx, o);
    o = read_text(ctx, "[STRING word]");
    assert_string_equal(o->u.str.s, "word");
    ix__obj_unref(ctx, o);
    o = read_text(ctx, "[STRING \"ends with the line\r\n]");
    assert_string_equal(o->u.str.s, "ends with the line");
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* Planes and normals become unit vectors; what is missing is computed. */
static void test_polygons(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, "[OBJECT P [POLYGON 3 [[INTERNAL] 0 0 2] [1 0 2]"
                               " [[NORMAL 0 0 -2] [w 1] 0 1 2]]"
                               "[POLYLINE [k 1] 2 [0 0 0] [1 1 1]]"
                               "[POLYGON [PLANE 0 0 4 -8] 1 [0 0 2]]]");
    const ix_polygon *p = o->u.poly->poly;

    (void)state;
    assert_int_equal(o->u.poly->n, 3);
    assert_true(p[0].has_plane && p[0].plane[2] == 1 && p[0].plane[3] == -2);
    assert_true(p[0].v[0].internal && p[0].v[0].normal[2] == 1);
    assert_true(p[0].v[2].normal[2] == -1);
    assert_int_equal(p[0].v[2].attrs->i, 1);
    assert_true(!p[1].has_plane && !p[1].v[0].has_normal);
    assert_true(p[2].plane[2] == 1 && p[2].plane[3] == -2);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

static void keep_note(void *ud, const char *text)
{
    strcpy(ud, text);
}

static void test_weights(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char note[512] = "";
    ix_obj *o;

    (void)state;
    ix_ctx_set_note(ctx, keep_note, note);
    /* a point at infinity is kept without a word */
    o = read_text(ctx, "[CURVE BEZIER 2 P1 [1 0] [0 1]]");
    assert_true(ix_mv_weights(ix__obj_first_mv(o))[1] == 0);
    assert_string_equal(note, "");
    ix__obj_unref(ctx, o);
    o = read_text(ctx, "[CURVE\nBEZIER 3 P1 [1 0] [-2 1] [1 0]]");
    assert_string_equal(note, "t:2:1: warning: weights change sign (-2 .. 1)");
    ix__obj_unref(ctx, o);
    /* coefficients of a power basis may vanish */
    o = read_text(ctx, "[CURVE POWER 2 P1 [1 1] [0 0]]");
    ix__obj_unref(ctx, o);
    o = read_text(ctx, "[TRIMSRF [SURFACE BEZIER 1 1 E1 [0]]]");
    assert_non_null(strstr(note, "no trimming curve"));
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

static void count_note(void *ud, const char *text)
{
    ++*(int *)ud;
    (void)text;
}

/* Many warnings: places are right, the first 20 are shown. */
static void test_many_warnings(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    char note[512] = "";
    int notes = 0;
    ix_buf b;
    ix_obj *o;

    (void)state;
    ix__buf_init(&b, ctx);
    for (int i = 0; i < 100; i++)
        ix__buf_puts(&b, "[CURVE BEZIER 2 P1\n[1 0]\n[-2 1]]\n");
    ix_ctx_set_note(ctx, count_note, &notes);
    ASSERT_OK(ctx, ix__itd_read(ctx, "t", b.data, b.len, &o));
    assert_int_equal(notes, 20);
    ix__obj_unref(ctx, o);
    ix_ctx_set_note(ctx, keep_note, note);
    ASSERT_OK(ctx, ix__itd_read(ctx, "t", b.data, b.len, &o));
    assert_string_equal(note, "t:58:8: warning: weights change sign (-2 .. 1) "
                              "(further warnings not shown)");
    ix__obj_unref(ctx, o);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

/* Our extensions: point types up to 18, power trivariates. */
static void test_extensions(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, "[CURVE BEZIER 1 P18 [1 2 3 4 5 6 7 8 9 10 11 "
                               "12 13 14 15 16 17 18 19]]");

    (void)state;
    assert_int_equal(ix_mv_ncoords(ix__obj_first_mv(o)), 18);
    assert_true(ix_mv_coord(ix__obj_first_mv(o), 17)[0] == 19);
    ix__obj_unref(ctx, o);
    o = read_text(ctx, "[TRIVAR POWER 1 1 2 E1 [1] [2]]");
    assert_int_equal(ix_mv_dir(ix__obj_first_mv(o), 2).basis, IX_POWER);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* --- errors ----------------------------------------------------------- */

static void test_bytes(void **state)
{
    static const char nul[] = "[OBJECT A\n [NUMBER\0 3]]";

    (void)state;
    refused_bytes(nul, sizeof nul - 1,
                  "2:9: error: control byte 0x00 at offset 18: not a text "
                  "file");
    refused("[OBJECT A [STRING \"\x07\"]]",
            "1:20: error: control byte 0x07 at offset 19: not a text file");
    refused("[OBJECT \xff\xfe [NUMBER 3]]",
            "1:9: error: byte 0xff at offset 8 is not UTF-8");
    refused("[OBJECT \xc0\x80 [NUMBER 3]]",
            "1:9: error: byte 0xc0 at offset 8 is not UTF-8");
    refused("[OBJECT \xed\xa0\x80 [NUMBER 3]]",
            "1:9: error: byte 0xed at offset 8 is not UTF-8");
    refused("[OBJECT \xc3\xa9\xc3\xa9 [\xe2\x82]]", /* columns: characters */
            "1:13: error: byte 0xe2 at offset 14 is not UTF-8");
}

static void test_structure(void **state)
{
    (void)state;
    refused("", "1:1: error: file empty: it holds no object");
    refused("]]]]]]\n", "1:1: error: file empty: it holds no object");
    refused("[OBJECT A]", "1:1: error: file empty: it holds no object");
    refused("[OBJECT A\n [CURVE BEZIER 2 E1\n  [0",
            "3:5: error: unexpected end of file, ] of a control point "
            "expected; [ opened at 3:3");
    refused("[OBJECT A [OBJECT B [NUMBER 1]]",
            "1:32: error: unexpected end of file, ] of the object expected; [ "
            "opened at 1:1");
    refused("[OBJECT A [NUMBER 1] [NUMBER 2]]",
            "1:22: error: ] of the object expected, found [");
    refused("[OBJECT A [OBJECT B [NUMBER 1]] [NUMBER 2]]",
            "1:34: error: OBJECT expected, found \"NUMBER\"");
    refused("[NUMBER 1] [OBJECT B [NUMBER 1]]",
            "1:12: error: end of file expected, found [");
    refused("[OBJECT A [FROB 1]]", "1:12: error: an entity such as NUMBER or "
                                   "CURVE expected, found \"FROB\"");
    refused("[OBJECT A [CURVE BEZIER 1 E1 [0]] [SURFACE BEZIER 1 1 E1 [0]]]",
            "1:35: error: SURFACE in an object of another type; an object "
            "holds entities of one type");
    refused("[OBJECT A [CURVE BEZIER 1 E1 [0]] x [CURVE BEZIER 1 E1 [0]]]",
            "1:35: error: ] of the object expected, found \"x\"");
    refused("[OBJECT [CURVE BEZIER 1 E1 [0]]]",
            "1:28: error: ] of the attribute expected, found [");
    refused("[OBJECT [a [CURVE BEZIER 1 E1 [0]]] A [NUMBER 1]]",
            "1:13: error: OBJECT (in an attribute; an object's name, or NONE, "
            "must stand before its contents) expected, found \"CURVE\"");
    refused("[OBJECT [] A [NUMBER 1]]",
            "1:10: error: name of an attribute expected, found ]");
}

static void test_depth(void **state)
{
    char text[257 * 10 + 1] = "";
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o;

    (void)state;
    for (int i = 0; i < 257; i++)
        strcpy(text + 10 * i, "[OBJECT A ");
    refused(text, "1:2568: error: objects nested deeper than 256");
    strcpy(text + 2560, "[NUMBER 1]"); /* 256 are allowed */
    {
        char full[sizeof text + 300];

        strcpy(full, text);
        memset(full + 2570, ']', 256);
        full[2570 + 256] = '\0';
        o = read_text(ctx, full);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

static void test_numbers(void **state)
{
    (void)state;
    refused("[NUMBER nan]", "1:9: error: number expected, found \"nan\"");
    refused("[NUMBER inf]", "1:9: error: number expected, found \"inf\"");
    refused("[NUMBER 0x10]", "1:9: error: number expected, found \"0x10\"");
    refused("[NUMBER 1,5]", "1:9: error: number expected, found \"1,5\"");
    refused("[NUMBER \"1\"]", "1:10: error: number expected, found \"1\"");
    refused("[NUMBER 1e999]",
            "1:9: error: number 1e999 is out of range (1.8e308)");
    refused("[NUMBER]", "1:8: error: number expected, found ]");
    refused("[NUMBER 1 2]", "1:11: error: ] of the entity expected, found "
                            "\"2\"");
    refused("[POINT 1 2]", "1:11: error: number expected, found ]");
    refused("[MATRIX 1 2 3]", "1:14: error: number expected, found ]");
    refused("[CTLPT E19 1]", "1:8: error: point type E1 .. E18 or P1 .. P18 "
                             "expected, found \"E19\"");
    refused("[CTLPT P2 1 2]", "1:14: error: number expected, found ]");
    refused("[STRING]", "1:8: error: text of the STRING expected, found ]");
    refused("[INSTANCE [", "1:11: error: name of the INSTANCE expected, found "
                           "[");
}

static void test_sizes(void **state)
{
    (void)state;
    refused("[CURVE BSPLINE -5 4 E3", "1:16: error: the number of control "
                                      "points is -5; it must be in 1 .. "
                                      "2147481599");
    refused("[CURVE BSPLINE 2.5 4 E3", "1:16: error: the number of control "
                                       "points is 2.5; it must be an integer");
    refused("[CURVE BSPLINE x 4 E3", "1:16: error: an integer (the number of "
                                     "control points) expected, found \"x\"");
    refused("[CURVE BEZIER 0 E3",
            "1:15: error: the order is 0; it must be in 1 .. 1024");
    refused("[CURVE BSPLINE 3 1025 E3",
            "1:18: error: the order is 1025; it must be in 1 .. 1024");
    refused("[CURVE FROB 3", "1:8: error: BEZIER, BSPLINE or POWER expected, "
                             "found \"FROB\"");
    refused("[CURVE BSPLINE 1000000000 4 E3 [KV 0 0",
            "1:8: error: 1000000000 control points cannot stand in the 8 bytes "
            "left; is the file cut short?");
    refused("[SURFACE BSPLINE 65536 65536 4 4 E3 [KV",
            "1:10: error: 4294967296 control points cannot stand in the 4 bytes"
            " left; is the file cut short?");
    refused("[MULTIVAR BEZIER 17 ", "1:18: error: the number of directions is "
                                    "17; it must be in 1 .. 16");
    refused("[MULTIVAR BEZIER 16 1024 1024 1024 1024 1024 1024 1024 1024 1024 "
            "1024 1024 1024 1024 1024 1024 1024 E1",
            "1:11: error: 146150163733090291820368483271628301965593254297"
            "6 control points cannot stand in the 0 bytes left; is the file "
            "cut short?");
    refused("[POLYLINE 99999999 ", "1:11: error: 99999999 vertices cannot "
                                   "stand in the 1 bytes left; is the file "
                                   "cut short?");
    refused("[MODEL 99999999 0 ", "1:8: error: 99999999 surfaces cannot stand "
                                  "in the 1 bytes left; is the file cut "
                                  "short?");
    refused("[TRISRF BEZIER 32767 E1 ", "1:9: error: 536854528 control points "
                                        "cannot stand in the 1 bytes left; is "
                                        "the file cut short?");
}

static void test_knots(void **state)
{
    (void)state;
    refused("[CURVE BSPLINE 3 4 E1 [KV 0 0 0 0 1 1 1]",
            "1:23: error: order 4 needs 4 points, there are 3");
    refused("[CURVE BSPLINE 3 2 E1 [KV 0 0 1 1]",
            "1:34: error: 4 knots found, 5 needed for 3 points of order 2");
    refused("[CURVE BSPLINE 3 2 E1 [KV 0 0 1 2 2 2]",
            "1:37: error: more than the 5 knots of 3 points of order 2");
    refused("[CURVE BSPLINE 3 2 E1 [KVP 0 0 1 2 2]",
            "1:37: error: 5 knots found, 6 needed for 3 periodic points of "
            "order 2");
    refused("[CURVE BSPLINE 3 2 E1\n [KV 0 0 3 2 2]",
            "2:2: error: direction 0: knot 3 = 2 is below knot 2 = 3");
    refused("[SURFACE BSPLINE 2 3 2 2 E1 [KV 0 0 1 1] [KV 0 0 0 2 2]",
            "1:42: error: direction 1: knot 2 = 0 occurs more than order = 2 "
            "times");
    refused("[CURVE BSPLINE 2 2 E1 [KX 0 0 1 1]",
            "1:24: error: KV or KVP expected, found \"KX\"");
    refused("[CURVE BSPLINE 2 2 E1 [KV 0 0 1 KV]",
            "1:33: error: knot expected, found \"KV\"");
}

static void test_points(void **state)
{
    (void)state;
    refused("[CURVE BEZIER 3 E2 [0 0] [1 1]]",
            "1:31: error: 3 control points expected, 2 found");
    refused("[CURVE BEZIER 1 E2 [0 0] [1 1]]",
            "1:26: error: ] behind the last control point expected, found [");
    refused("[CURVE BEZIER 2 E2 [0 0] [1]]", "1:26: error: control point 2 has "
                                             "1 numbers; its type needs 2");
    refused("[CURVE BEZIER 2 E2 [0 0 7] [1 1]]",
            "1:25: error: control point 1 has more than 2 numbers");
    refused("[CURVE BEZIER 2 E2 [0 CURVE] [1 1]]",
            "1:23: error: number expected, found \"CURVE\"");
    refused("[CURVE BEZIER 2 E2 [0 1e999] [1 1]]",
            "1:23: error: number 1e999 is out of range (1.8e308)");
    refused("[CURVE BEZIER 2 E2 0 0",
            "1:20: error: [ of a control point expected, found \"0\"");
    refused("[CURVE BEZIER 1 E2 [[a 1] 0 0]]",
            "1:21: error: number expected, found [");
    refused("[CURVE BEZIER 2 P1 [1 0] [0 0]]",
            "1:8: error: point 1: weight and coordinates are all zero");
    refused("[CURVE BEZIER 2 P1 [0 1] [0 2]]",
            "1:8: error: all 2 weights are zero");
}

static void test_other_entities(void **state)
{
    (void)state;
    refused("[POLYGON [PLANE 0 0 0 1] 3", "1:11: error: degenerate normal: "
                                          "PLANE 0 0 0");
    refused("[POLYLINE 0]", "1:11: error: the number of vertices is 0; it must "
                            "be in 1 .. 2147483647");
    refused("[POLYLINE 2 [0 0 0]]", "1:20: error: 2 vertices expected, 1 "
                                    "found");
    refused("[POLYLINE 1 [0 0]]", "1:17: error: coordinate expected, found ]");
    refused("[TRIMSRF [CURVE BEZIER 1 E1 [0]]]",
            "1:11: error: SURFACE expected, found \"CURVE\"");
    refused("[TRIMSRF [SURFACE BEZIER 1 1 E1 [0]] [TRIMCRV]]",
            "1:38: error: TRIMCRV holds no TRIMCRVSEG");
    refused("[TRISRF GREGORY 4 E1", "1:17: error: the number of points of a "
                                    "side is 4; it must be in 5 .. 32767");
    refused("[TRISRF BSPLINE 1 1 E1 [KVP 0 1] [0]]",
            "1:24: error: KV expected in a triangular surface");
    refused("[MODEL 1 1 [MDLTSRF 1 [SURFACE BEZIER 1 1 E1 [0]] [MDLLOOP 2]]",
            "1:60: error: the index of a segment is 2; it must be in -1 .. 1");
    refused("[MODEL 1 1 [MDLTSRF 1 [SURFACE BEZIER 1 1 E1 [0]] [MDLLOOP 0]]",
            "1:60: error: segments are counted from 1");
    refused("[MODEL 1 1 [MDLTSRF 0 [SURFACE BEZIER 1 1 E1 [0]]] [MDLTSEG 0 2 "
            "0]]",
            "1:63: error: the index of a surface is 2; it must be in 0 .. 1");
}

/* --- whatever comes --------------------------------------------------- */

/* Law: a prefix of a file, and a file with one byte changed, are read or
 * refused, without a leak; sanitizers watch the rest. */
static void test_damaged(void **state)
{
    const ix_write_opts exact = {.file = true};
    ix_rng r = ix_rng_new(0xdead);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = NULL, *p;
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    while (b.len < 2000) {
        ix__obj_unref(ctx, o);
        o = ix_rand_obj(ctx, &r, 2);
        assert_non_null(o);
        ASSERT_OK(ctx, ix__itd_write(&b, o, &exact, 0));
    }
    ix__obj_unref(ctx, o);
    for (int i = 0; i < 600; i++) {
        size_t at = (size_t)ix_rng_int(&r, 0, (int)b.len - 1);
        size_t n = i % 2 ? b.len : at;
        char old = b.data[at];

        b.data[at] = "[]\"\\ 0-E\n\x80z"[ix_rng_int(&r, 0, 10)];
        if (ix__itd_read(ctx, "t", b.data, n, &p) == IX_OK)
            ix__obj_unref(ctx, p);
        else
            assert_null(p);
        b.data[at] = old;
    }
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

static void test_cancel(void **state)
{
    volatile int stop = 1;
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o;

    (void)state;
    ix_ctx_set_cancel(ctx, &stop);
    assert_int_equal(ix__itd_read(ctx, "t", LINE, strlen(LINE), &o),
                     IX_ECANCEL);
    assert_null(o);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_layout_is_free),
                                       cmocka_unit_test(test_free_text),
                                       cmocka_unit_test(test_objects),
                                       cmocka_unit_test(test_attributes),
                                       cmocka_unit_test(test_quoted_names),
                                       cmocka_unit_test(test_many_attributes),
                                       cmocka_unit_test(test_strings),
                                       cmocka_unit_test(test_polygons),
                                       cmocka_unit_test(test_weights),
                                       cmocka_unit_test(test_many_warnings),
                                       cmocka_unit_test(test_extensions),
                                       cmocka_unit_test(test_bytes),
                                       cmocka_unit_test(test_structure),
                                       cmocka_unit_test(test_depth),
                                       cmocka_unit_test(test_numbers),
                                       cmocka_unit_test(test_sizes),
                                       cmocka_unit_test(test_knots),
                                       cmocka_unit_test(test_points),
                                       cmocka_unit_test(test_other_entities),
                                       cmocka_unit_test(test_damaged),
                                       cmocka_unit_test(test_cancel)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
