/* The text writer: layout, number rules, dumps against files, and what it
 * refuses. */
#include <string.h>

#include "harness/test.h"
#include "io/io.h"

static void expect_text(ix_ctx *ctx, const ix_obj *o, const ix_write_opts *w,
                        int column, const char *expected)
{
    ix_buf b;

    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, ix__itd_write(&b, o, w, column));
    assert_string_equal(b.data, expected);
    ix__buf_free(&b);
}

/* Reads and dumps. */
static void expect_dump(const char *text, const char *expected)
{
    const ix_write_opts dump = {.float_format = "%.15g"};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o;

    ASSERT_OK(ctx, ix__itd_read(ctx, "t", text, strlen(text), &o));
    expect_text(ctx, o, &dump, 0, expected);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* The dumps that IRIT printed for the attr-* conformance cases. */
static void test_attributes(void **state)
{
    (void)state;
    expect_dump("[OBJECT [neg -3] [len 2.5] [count 5] A [CURVE BEZIER 2 E3 [0 "
                "0 0] [1 0 0]]]",
                "[OBJECT [neg -3] [len 2.5] \n"
                "    [count 5] A\n"
                "    [CURVE BEZIER 2 E3\n"
                "\t[0 0 0]\n"
                "\t[1 0 0]\n"
                "    ]\n"
                "]\n");
    expect_dump("[OBJECT [dir [OBJECT NONE [VECTOR 0 0 1]]] A [POINT 1 2 3]]",
                "[OBJECT \n"
                "    [dir\n"
                "\t[OBJECT NONE\n"
                "\t    [VECTOR 0 0 1]\n"
                "\t]\n"
                "    ]\n"
                "    A\n"
                "    [POINT 1 2 3]\n"
                "]\n");
    expect_dump("[OBJECT [z 1] [k \"new\"] [_hidden 1] A [POINT 0 0 0]]",
                "[OBJECT [z 1] [k \"new\"] A\n"
                "    [POINT 0 0 0]\n"
                "]\n");
}

static void test_geometry(void **state)
{
    (void)state;
    expect_dump("[OBJECT T [TRIVAR BEZIER 1 2 2 E1 [1][2][3][4]]]",
                "[OBJECT T\n"
                "    [TRIVAR BEZIER 1 2 2 E1\n"
                "\t[1]\n\n\t[2]\n\n\n\t[3]\n\n\t[4]\n"
                "    ]\n"
                "]\n");
    expect_dump("[OBJECT M [MULTIVAR BSPLINE 2 1 2 1 2 P1 [KV 0 1] [KV 0 0 1 "
                "1] [1 2] [1 3]]]",
                "[OBJECT M\n"
                "    [MULTIVAR BSPLINE 2   1 2   1 2 P1\n"
                "\t[KV 0 1]\n"
                "\t[KV 0 0 1 1]\n"
                "\t[1 2]\n"
                "\t[1 3]\n"
                "    ]\n"
                "]\n");
    expect_dump("[OBJECT C [CURVE BSPLINE 3 3 E1 [KVP 1 2 3 4 5 6 7 8][1][2]"
                "[3]]]",
                "[OBJECT C\n"
                "    [CURVE BSPLINE 3 3 E1\n"
                "\t[KVP 1 2 3 4 5\n"
                "\t     6 7 8]\n"
                "\t[1]\n\t[2]\n\t[3]\n"
                "    ]\n"
                "]\n");
    expect_dump("[OBJECT P [POLYGON [k 1] 3 [[a 1] [INTERNAL] 0 0 0] [1 0 0]"
                "[[NORMAL 0 1 0] 0 1 0]] [POLYLINE 1 [0 0 0]]]",
                "[OBJECT P\n"
                "    [POLYGON [PLANE 0 0 1 0] [k 1] \t3\n"
                "\t[[a 1] [INTERNAL] 0 0 0]\n"
                "\t[1 0 0]\n"
                "\t[[NORMAL 0 1 0] 0 1 0]\n"
                "    ]\n"
                "    [POLYLINE \t1\n"
                "\t[0 0 0]\n"
                "    ]\n"
                "]\n");
}

/* --- numbers ---------------------------------------------------------- */

static void expect_number(const char *format, double tiny, double v,
                          const char *expected)
{
    ix_write_opts w = {.float_format = format, .tiny = tiny};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf b;

    ix__buf_init(&b, ctx);
    ix__itd_number(&b, &w, v);
    assert_string_equal(b.data, expected);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

static void test_numbers(void **state)
{
    (void)state;
    expect_number(NULL, 0, 0.1, "0.1");
    expect_number(NULL, 0, 1e-300, "1e-300");
    expect_number("%-16.14lg", 0, 1 / 3.0, "0.33333333333333");
    expect_number("%-16.14lg", 0, 2, "2");
    expect_number("%-16.14lg", 0, -1e-12, "-1e-12");
    expect_number("%-16.14lg", 0, -9e-14, "0"); /* below 1e-13 */
    expect_number("%.15g", 0, 9e-26, "0");
    expect_number("%.15g", 0, 1.1e-25, "1.1e-25");
    expect_number("%.15g", 1e-3, 5e-4, "0");
    expect_number("%lf", 0, 2.5, "2.5");
    expect_number("%lf", 0, 2, "2."); /* a bare point stays */
    expect_number("%.10f", 0, 100, "100.");
    expect_number("%.3e", 0, 100, "1.000e+02"); /* zeros before e stay */
    expect_number("%.0f", 0, 100, "100");
    expect_number("no format", 0, 0.1, "0.1"); /* shortest instead */
}

/* Law: the format shows the threshold as something but 0, and a tenth of it
 * not (from 1e-25 to 1e-6, where the search ends). */
static void test_tiny(void **state)
{
    static const char *const formats[] = {"%lf", "%.9f",  "%.20f",
                                          "%g",  "%.17g", "%e"};
    char text[64];

    (void)state;
    assert_true(ix__itd_tiny("%-16.14lg") == 1e-13);
    assert_true(ix__itd_tiny("%.2f") == 1e-6);
    assert_true(ix__itd_tiny("%d") == 1e-6);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        const char *f = formats[i];
        double t = ix__itd_tiny(f);
        int digits = f[1] == '.' ? (f[2] == '2'   ? 20
                                    : f[2] == '9' ? 9
                                                  : 17)
                                 : 6;

        if (strchr(f, 'f')) {
            (void)snprintf(text, sizeof text, "%.*f", digits, t);
            assert_non_null(strchr(text, '1'));
            (void)snprintf(text, sizeof text, "%.*f", digits, t / 10);
            assert_null(strchr(text, '1'));
        } else {
            assert_true(t == 1e-25);
        }
    }
}

/* Attributes that are reals follow %g when there is a format. */
static void test_real_attributes(void **state)
{
    const ix_write_opts dump = {.float_format = "%.15g"};
    const ix_write_opts file = {.file = true};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 1 / 3.0);

    (void)state;
    ASSERT_OK(ctx, ix__attr_set_real(ctx, &o->attrs, "x", 1 / 3.0));
    expect_text(ctx, o, &dump, 0,
                "[OBJECT [x 0.333333] NONE\n    [NUMBER 0.333333333333333]\n]"
                "\n");
    expect_text(ctx, o, &file, 4,
                "    [OBJECT [x 0.3333333333333333] NONE\n"
                "\t[NUMBER 0.3333333333333333]\n    ]\n");
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* --- strings, names --------------------------------------------------- */

static void test_strings(void **state)
{
    const char text[] = "a\"b\\c\nd";
    const ix_write_opts dump = {0}, file = {.file = true};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_string(ctx, text, sizeof text - 1);

    (void)state;
    expect_text(ctx, o, &dump, 0,
                "[OBJECT NONE\n    [STRING \"a\"b\\c\nd\"]\n]\n");
    expect_text(ctx, o, &file, 0,
                "[OBJECT NONE\n    [STRING \"a\\\"b\\\\c\\\nd\"]\n]\n");
    ASSERT_OK(ctx, ix__obj_set_name(ctx, o, "two words]"));
    expect_text(ctx, o, &file, 0,
                "[OBJECT TWO_WORDS_\n    [STRING \"a\\\"b\\\\c\\\nd\"]\n]\n");
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* --- what is refused -------------------------------------------------- */

static void expect_refused(ix_ctx *ctx, const ix_obj *o, const ix_write_opts *w,
                           ix_status st, const char *message)
{
    ix_buf b;

    ix__buf_init(&b, ctx);
    assert_int_equal(ix__itd_write(&b, o, w, 0), st);
    assert_non_null(strstr(ix_ctx_message(ctx), message));
    ix__buf_free(&b);
}

static void test_refused(void **state)
{
    const ix_write_opts file = {.file = true}, dump = {0};
    const ix_write_opts bad = {.float_format = "%s"};
    const ix_write_opts two = {.float_format = "%g %g"};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, HUGE_VAL);
    ix_obj *bell = ix__obj_string(ctx, "\a", 1);

    (void)state;
    expect_refused(ctx, o, &file, IX_EDOMAIN, "finite numbers only");
    expect_text(ctx, o, &dump, 0, "[OBJECT NONE\n    [NUMBER inf]\n]\n");
    expect_refused(ctx, o, &bad, IX_EARG, "\"%s\"");
    expect_refused(ctx, o, &two, IX_EARG, "\"%g %g\"");
    expect_refused(ctx, bell, &file, IX_EDOMAIN, "control byte 0x07");
    ix__obj_unref(ctx, o);
    ix__obj_unref(ctx, bell);
    ix_ctx_free(ctx);
}

/* n lists around o, each holding the one before `times` times. */
static ix_obj *nest(ix_ctx *ctx, ix_obj *o, int n, int times)
{
    for (int i = 0; i < n; i++) {
        ix_obj *l = ix__obj_list(ctx);

        assert_non_null(l);
        for (int k = 0; k < times; k++)
            ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
        o = l;
    }
    return o;
}

/* 2^60 paths through 61 boxes: an error at once; so for depth and cycles. */
static void test_size(void **state)
{
    const ix_write_opts dump = {0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = nest(ctx, ix__obj_number(ctx, 1), 60, 2);
    ix_buf b;

    (void)state;
    expect_refused(ctx, o, &dump, IX_EUNABLE, "written out");
    ix__obj_unref(ctx, o);
    o = nest(ctx, ix__obj_number(ctx, 1), 256, 1);
    expect_refused(ctx, o, &dump, IX_EUNABLE, "nested deeper than 256");
    ix__obj_unref(ctx, o);
    o = nest(ctx, ix__obj_number(ctx, 1), 255, 1); /* 256 with the number */
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, ix__itd_write(&b, o, &dump, 0));
    ix__buf_free(&b);
    ix__obj_unref(ctx, o);
    o = nest(ctx, ix__obj_number(ctx, 1), 2, 1);
    ASSERT_OK(ctx, ix__obj_append(ctx, o->u.list.item[0], o));
    expect_refused(ctx, o, &dump, IX_EUNABLE, "contains itself");
    ix__obj_unref(ctx, o->u.list.item[0]->u.list.item[1]); /* cut the cycle */
    o->u.list.item[0]->u.list.n = 1;
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* Directions of two kinds have no word in the format: B-splines. */
static void test_mixed_bases(void **state)
{
    static const double knots[] = {0, 0, 1, 1}, pts[] = {1, 2, 3, 4};
    const ix_dir dirs[2] = {{IX_BEZIER, 2, 2, false, NULL},
                            {IX_BSPLINE, 2, 2, false, knots}};
    const ix_write_opts dump = {0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m;
    ix_obj *o;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 1, false, pts, &m));
    o = ix__obj_mv(ctx, IX_OBJ_SURFACE, m);
    expect_text(ctx, o, &dump, 0,
                "[OBJECT NONE\n"
                "    [SURFACE BSPLINE 2 2 2 2 E1\n"
                "\t[KV 0 0 1 1]\n\t[KV 0 0 1 1]\n"
                "\t[1]\n\t[2]\n\n\t[3]\n\t[4]\n"
                "    ]\n]\n");
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

static void test_cancel(void **state)
{
    const ix_write_opts dump = {0};
    volatile int stop = 1;
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 1);

    (void)state;
    ix_ctx_set_cancel(ctx, &stop);
    expect_refused(ctx, o, &dump, IX_ECANCEL, "");
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_attributes),      cmocka_unit_test(test_geometry),
        cmocka_unit_test(test_numbers),         cmocka_unit_test(test_tiny),
        cmocka_unit_test(test_real_attributes), cmocka_unit_test(test_strings),
        cmocka_unit_test(test_refused),         cmocka_unit_test(test_size),
        cmocka_unit_test(test_mixed_bases),     cmocka_unit_test(test_cancel)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
