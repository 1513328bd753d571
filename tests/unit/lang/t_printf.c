/* Tests of lang/printf.c. */
#define _POSIX_C_SOURCE 200809L
#include "session.h"

/* What printf(args) prints; args is script text. */
static const char *printed(session *s, const char *args)
{
    char text[1000];

    (void)snprintf(text, sizeof text, "printf(%s);", args);
    ASSERT_OK(s->ctx, session_run(s, text));
    return s->out;
}

static void t_conversions(void **state)
{
    static const char *const rows[][2] = {
        {"\"plain\", nil()", "plain"},
        {"\"%d %i %u %x %X %o\", list(42, -7, 9, 255, 255, 8)",
         "42 -7 9 ff FF 10"},
        {"\"%d %d\", list(3.99, -3.99)", "3 -3"},
        {"\"[%5d] [%-5d] [%05d] [%+d]\", list(42, 42, 42, 42)",
         "[   42] [42   ] [00042] [+42]"},
        {"\"%f %.2f %e %g %G %E\", list(1.5, 2.345, 1, 1e-7, 1e-7, 1)",
         "1.500000 2.35 1.000000e+00 1e-07 1E-07 1.000000E+00"},
        {"\"%lf %ld %hhd\", list(1, 2, 3)", "1.000000 2 3"},
        {"\"[%s] [%8s] [%-8s] [%.2s]\", list(\"a\", \"b\", \"c\", \"def\")",
         "[a] [       b] [c       ] [de]"},
        {"\"a\\\\nb\\\\tc\\\\%\\\\\\\\\", nil()", "a\nb\tc%\\"},
        {"\"100%%\", nil()", "100%"},
        {"\"%pf\", list(point(1, 2, 3))", "1.000000, 2.000000, 3.000000"},
        {"\"%vg|%.3vg\", list(vector(1, 2, 3), point(0.1234567, 0, -1))",
         "1, 2, 3|0.123, 0, -1"},
        {"\"%8.5lvf\", list(vector(1, 2, 3))", " 1.00000,  2.00000,  3.00000"},
        {"\"%Pg\", list(plane(1, 2, 3, 4))", "1, 2, 3, 4"},
        {"\"%pg %pg\", list(ctlpt(E2, 1, 2), ctlpt(P3, 1, 2, 3, 4))",
         "E2, 1, 2 P3, 1, 2, 3, 4"},
        {"\"%d\", list(1, 2, 3)", "1"},
    };
    session s;

    (void)state;
    session_open(&s, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_string_equal(printed(&s, rows[i][0]), rows[i][1]);
    session_close(&s);
}

/* %D is the dump of the value, in FloatFrmt unless it has a format itself. */
static void t_object(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = 1 / 3;"));
    assert_non_null(strstr(printed(&s, "\"%Dg\", list(a)"),
                           "\nA          (2) - Numeric   type\n[OBJECT A\n"
                           "    [NUMBER 0.33333333333333]\n]\n"));
    assert_non_null(
        strstr(printed(&s, "\"%.3Dg\", list(a)"), "[NUMBER 0.333]"));
    assert_string_equal(s.in->states.float_format, "%-16.14lg");
    session_close(&s);
}

/* What is refused prints nothing at all. */
static void t_errors(void **state)
{
    static const char *const rows[][2] = {
        {"\"a %d\", nil()", "more than the 0 arguments"},
        {"\"a %d %d\", list(1)", "more than the 1 argument "},
        {"\"%d\", list(\"x\")", "%d needs a number as argument 1, got a st"},
        {"\"%s\", list(1)", "%s needs a string as argument 1, got a number"},
        {"\"%pf\", list(1)", "%p needs a point"},
        {"\"%vf\", list(ctlpt(E1, 1))", "%v needs a vector"},
        {"\"%Pf\", list(point(1, 2, 3))", "%P needs a plane"},
        {"\"%ps\", list(point(1, 2, 3))", "must be followed by e, f or g"},
        {"\"%n\", list(1)", "conversion %n is not known"},
        {"\"%c\", list(1)", "conversion %c is not known"},
        {"\"%99999999d\", list(1)", "malformed conversion"},
        {"\"%.1025f\", list(1)", "malformed conversion"},
        {"\"%*d\", list(1, 2)", "malformed conversion"},
        {"\"%\", list(1)", "malformed conversion"},
    };
    session s;

    (void)state;
    session_open(&s, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_string_equal(printed(&s, rows[i][0]), "");
        if (!strstr(s.err, rows[i][1]))
            fail_msg("%s: \"%s\" wanted, got %s", rows[i][0], rows[i][1],
                     s.err);
    }
    session_close(&s);
}

/* Random formats never print more than their text and arguments allow. */
static void t_random_formats(void **state)
{
    static const char letters[] = "%%%%dsfgpvPD0123456789.-+ #lhnqZ\\nt";
    ix_rng rng = ix_rng_new(3);
    session s;

    (void)state;
    session_open(&s, NULL);
    for (int round = 0; round < 500; round++) {
        char text[100] = "printf(\"", *p = text + strlen(text);

        for (int i = 0; i < 12; i++)
            *p++ = letters[ix_rng_int(&rng, 0, (int)sizeof letters - 2)];
        while (p[-1] == '\\')
            p--;
        (void)strcpy(p, "\", list(1, \"s\", point(1, 2, 3)));");
        ASSERT_OK(s.ctx, session_run(&s, text));
        assert_true(strlen(s.out) < 4 * 1024 * 3);
    }
    session_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_conversions),
        cmocka_unit_test(t_object),
        cmocka_unit_test(t_errors),
        cmocka_unit_test(t_random_formats),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
