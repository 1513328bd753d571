/* Tests of lang/lexer.c and lang/reader.c: what tokens a text has. */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>

#include "session.h"

/* The tokens of text as one line: names and numbers as they are, strings in
 * quotes, symbols; "ERROR" at the end if there was one. */
static void tokens(session *s, const char *text, char *out)
{
    ix__unit *u = ix__unit_new(s->ctx);
    ix__reader rd;
    ix__token t;
    ix_status st;

    assert_non_null(u);
    ix__reader_init(&rd, s->in);
    ix__reader_push_text(&rd, "t", text, strlen(text));
    *out = '\0';
    while ((st = ix__lex(&rd, u, &t)) == IX_OK && t.kind != T_END) {
        static const char symbol[] = "    (),:;";

        out += strlen(out);
        if (t.kind == T_NUMBER)
            (void)sprintf(out, "%g ", t.num);
        else if (t.kind == T_STRING)
            (void)sprintf(out, "\"%s\" ", t.text);
        else if (t.kind == T_NAME)
            (void)sprintf(out, "%s ", t.text);
        else if (t.kind == T_OP)
            (void)sprintf(out, "%s ", ix__op_text(t.op));
        else
            (void)sprintf(out, "%c ", symbol[t.kind]);
    }
    if (st != IX_OK) {
        strcat(out, "ERROR ");
        s->in->place.set = false;
        ix__unit_unref(s->in->place.unit);
        s->in->place.unit = NULL;
    }
    if (*out)
        out[strlen(out) - 1] = '\0';
    ix__reader_free(&rd);
    ix__unit_unref(u);
}

static void table(const char *const rows[][2], size_t n)
{
    session s;
    char out[4096];

    session_open(&s, NULL);
    for (size_t i = 0; i < n; i++) {
        tokens(&s, rows[i][0], out);
        if (strcmp(out, rows[i][1]) != 0)
            fail_msg("%s\n  is   %s\n  want %s", rows[i][0], out, rows[i][1]);
    }
    session_close(&s);
}
#define TABLE(rows) table((rows), sizeof(rows) / sizeof *(rows))

static void t_numbers(void **state)
{
    static const char *const rows[][2] = {
        {"1 .5 5. 1e3 1E-3 2.5e0", "1 0.5 5 1000 0.001 2.5"},
        {"1.5E+2", "1.5 + 2"}, /* a plus never belongs to the exponent */
        {"1e-2-3", "0.01 - 3"},
        {"2x", "2 X"},
        {"1.2.3", "ERROR"},
        {"1e2e3", "ERROR"},
        {".", "ERROR"},
        {"1e-", "ERROR"},
        {"1e999", "ERROR"},
        {"1e-400", "0"},
    };

    (void)state;
    TABLE(rows);
}

static void t_lines(void **state)
{
    static const char *const rows[][2] = {
        {"12\n34", "1234"},
        {"12\n 34", "12 34"},
        {"ab\r\ncd", "ABCD"},
        {"\"ab\ncd\"", "\"abcd\""},
        {"a =\n= b", "A == B"},
        {"a = # no more\n1", "A = 1"},
        {"a#b\nc", "A C"},
        {"\"a # b\"", "\"a # b\""},
        {"\"a\tb\"", "\"a      b\""}, /* a tab reaches column 8 */
        {"\xef\xbb\xbfx", "X"},
        {"a; # \xc3\xa9t\xc3\xa9\nb", "A ; B"},
        {"a \x01 b\nc", "A C"},
    };

    (void)state;
    TABLE(rows);
}

static void t_symbols(void **state)
{
    static const char *const rows[][2] = {
        {"+-*/^(),:;", "+ - * / ^ ( ) , : ;"},
        {"= == != < <= > >= && || !", "= == != < <= > >= && || !"},
        {"a=-b", "A = - B"},
        {"a<=b>=c", "A <= B >= C"},
        {"a & b", "A ERROR"},
        {"a | b", "A ERROR"},
        {"_a", "ERROR"},
        {"a_1", "A_1"},
        {"a $", "A ERROR"},
    };

    (void)state;
    TABLE(rows);
}

static void t_strings_and_comments(void **state)
{
    static const char *const rows[][2] = {
        {"\"\"", "\"\""},
        {"\"a\\\"b\\\\c\\n\"", "\"a\"b\\cn\""},
        {"\"never closed", "ERROR"},
        {"\"\xc3\xa9\"", "ERROR"},
        {"COMMENT $ a; b\n c $ d", "D"},
        {"comment xabcx1", "1"},
        {"COMMENT $ \xc3\xa9 \n $ d", "D"},
        {"commented", "COMMENTED"},
        {"COMMENT $ never", "ERROR"},
        {"COMMENT", "ERROR"},
    };

    (void)state;
    TABLE(rows);
}

/* Law: blanks, comments and line ends between tokens change nothing. */
static void t_separators(void **state)
{
    static const char *const words[] = {"abc", "12", "\"s t\"", "<=", "+",
                                        "(",   "==", ";",       ",",  "x1"};
    static const char *const gaps[] = {" ",  "  \n ",           "# c ; \"\n ",
                                       "\t", " COMMENT % ; % ", "\n\n "};
    ix_rng rng = ix_rng_new(11);
    session s;

    (void)state;
    session_open(&s, NULL);
    for (int round = 0; round < 200; round++) {
        char plain[400] = "", odd[2000] = "", a[1000], b[1000];

        for (int i = 0; i < 12; i++) {
            const char *w = words[ix_rng_int(&rng, 0, 9)];

            strcat(strcat(plain, w), " ");
            strcat(strcat(odd, w), gaps[ix_rng_int(&rng, 0, 5)]);
        }
        tokens(&s, plain, a);
        tokens(&s, odd, b);
        assert_string_equal(a, b);
    }
    session_close(&s);
}

/* Random bytes end in tokens or in an error, and always end. */
static void t_any_bytes(void **state)
{
    ix_rng rng = ix_rng_new(12);
    session s;

    (void)state;
    session_open(&s, NULL);
    for (int round = 0; round < 300; round++) {
        char text[200], out[4096];

        for (size_t i = 0; i < sizeof text - 1; i++)
            text[i] = (char)ix_rng_int(&rng, 1, 255);
        text[sizeof text - 1] = '\0';
        tokens(&s, text, out);
    }
    session_close(&s);
}

static void t_limits(void **state)
{
    static char text[70000], out[70100];
    session s;

    (void)state;
    session_open(&s, NULL);
    memset(text, 'a', 255);
    tokens(&s, text, out);
    assert_int_equal(strlen(out), 255);
    memset(text, 'a', 256);
    tokens(&s, text, out);
    assert_string_equal(out, "ERROR");
    memset(text, 'x', 65538);
    text[0] = text[65537] = '"';
    tokens(&s, text, out);
    assert_int_equal(strlen(out), 65538);
    text[65537] = 'x';
    text[65538] = '"';
    tokens(&s, text, out);
    assert_string_equal(out, "ERROR");
    session_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_numbers),
        cmocka_unit_test(t_lines),
        cmocka_unit_test(t_symbols),
        cmocka_unit_test(t_strings_and_comments),
        cmocka_unit_test(t_separators),
        cmocka_unit_test(t_any_bytes),
        cmocka_unit_test(t_limits),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
