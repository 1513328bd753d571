/* Tests of lang/eval.c and lang/exec.c: what statements do. */
#define _POSIX_C_SOURCE 200809L
#include "session.h"

/* Runs each text; "= value" must be its last assigned RESULT. */
static void values(const char *const rows[][2], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        session s;
        const ix_obj *o;
        char got[64];

        session_open(&s, NULL);
        if (session_run(&s, rows[i][0]) != IX_OK)
            fail_msg("%s: %s", rows[i][0], s.err);
        o = ix__var_find(s.in, "r");
        if (!o)
            fail_msg("%s: r is not defined", rows[i][0]);
        if (o->type == IX_OBJ_NUMBER)
            (void)snprintf(got, sizeof got, "%g", o->u.num);
        else if (o->type == IX_OBJ_STRING)
            (void)snprintf(got, sizeof got, "%s", o->u.str.s);
        else
            (void)snprintf(got, sizeof got, "%s", ix__obj_type_name(o->type));
        if (strcmp(got, rows[i][1]) != 0)
            fail_msg("%s: %s, want %s", rows[i][0], got, rows[i][1]);
        session_close(&s);
    }
}
#define VALUES(rows) values((rows), sizeof(rows) / sizeof *(rows))

static void t_assignment(void **state)
{
    static const char *const rows[][2] = {
        {"r = 1", "1"},
        {"r = a = 3", "3"},
        {"a = 1; r = a = a + 1", "2"},
        {"r = 1; r = \"x\"", "x"},
        {"r = \"x\"; r = r", "x"},
        {"a = list(1); b = a; snoc(2, a); r = sizeof(b)", "1"},
        /* a list holds the variable's own box ... */
        {"a = 1; l = list(a); a = 5; r = nth(l, 1)", "5"},
        /* ... until the variable's new value holds the box */
        {"a = 1; l = list(a); a = list(a, 7); a = 3; r = nth(l, 1)", "1"},
        {"a = list(1); a = list(a, a); r = sizeof(nth(a, 2))", "1"},
        {"a = 1; f = function(x): x = 9: return = x; b = f(a); r = a", "1"},
        {"a = point(0, 0, 0); attrib(a, \"k\", 3); r = a; "
         "r = getattr(r, \"k\")",
         "3"},
        {"a = 2; attrib(a, \"k\", 3); b = a; r = getattr(b, \"k\")", "3"},
        {"l = list(2); attrib(nref(l, 1), \"k\", 3); "
         "r = getattr(nref(l, 1), \"k\")",
         "3"},
        {"r = 5; r == (r = 6)", "6"},
    };

    (void)state;
    VALUES(rows);
}

/* The right operand first; arguments from left to right; no short cuts. */
static void t_order(void **state)
{
#define LOG "l = \"\"; f = function(x): l = l + x: return = x; "
    static const char *const rows[][2] = {
        {LOG "a = f(1) + f(2); r = l", "21"},
        {LOG "a = f(1) + f(2) - f(3); r = l", "321"},
        {LOG "a = list(f(1), f(2), f(3)); r = l", "123"},
        {LOG "a = (f(0) && f(1)); r = l", "10"},
        {LOG "a = (f(1) || f(0)); r = l", "01"},
        {LOG "a = f(f(1) + f(2)); r = l", "213"},
        {LOG "a = f(1) == f(2); r = l", "21"},
    };

    (void)state;
    VALUES(rows);
}

static void t_branches(void **state)
{
    static const char *const rows[][2] = {
        {"if (1, r = 1, r = 2)", "1"},
        {"if (0, r = 1, r = 2)", "2"},
        {"r = 0; if (1e-6, r = 1)", "0"},
        {"r = 0; if (-1e-5, r = 1)", "1"},
        {"r = 0; if (1, a = 1 : r = a + 1, r = 9)", "2"},
        {"i = 0; while (i < 5, i = i + 1); r = i", "5"},
        {"r = 0; while (r + 0.6 < 3, r = r + 1)", "3"},
        /* the condition is rounded: these count as false */
        {"r = 0; while (0.49, r = 1)", "0"},
        {"r = 0; while (-1.4, r = 1)", "0"},
        {"r = 0; while (2 * (r < 3), r = r + 1)", "3"},
        {"r = 0; p = procedure(): r = r + 1; while (r < 3, p())", "3"},
    };

    (void)state;
    VALUES(rows);
}

static void t_loops(void **state)
{
    static const char *const rows[][2] = {
        {"s = 0; for (i = 1, 1, 10, s = s + i); r = s", "55"},
        {"for (i = 1, 1, 3, j = i); r = i", "3"},
        {"r = 0; for (i = 3, 1, 2, r = 1); r = i", "3"},
        {"r = 0; for (i = 5, -2, 0, r = r * 10 + i)", "531"},
        {"r = 0; for (i = 0, 0.1, 1, r = r + 1)", "11"},
        {"r = 0; for (i = 1, 1, 2.999995, r = r + 1)", "3"},
        {"i = 2; r = 0; for (i, 1, 4, r = r * 10 + i)", "234"},
        {"r = 0; for (1, 1, 4, r = r + 1)", "4"},
        {"r = 0; for (i = 1, 1, 3, r = r * 10 + i : i = 77)", "123"},
        {"n = 3; r = 0; for (i = 1, 1, n, n = 10 : r = r + 1)", "3"},
        /* the counter is one box */
        {"l = nil(); for (i = 1, 1, 3, l = l + list(i)); r = nth(l, 1)", "3"},
    };

    (void)state;
    VALUES(rows);
}

static void t_functions(void **state)
{
    static const char *const rows[][2] = {
        {"f = function(): return = 7; r = f()", "7"},
        {"f = function(x, y):t: t = x * y: return = t + 1; r = f(2, 3)", "7"},
        {"f = function(n): return = n; f = function(n): if (n < 2, "
         "return = n, return = f(n - 1) + f(n - 2)); r = f(15)",
         "610"},
        {"f = function(x): return = x + 1; g = function(x): return = f(x); "
         "f = function(x): return = x + 10; r = g(1)",
         "11"},
        {"f = function(x): return = x * 2; f = 5; r = f(f)", "10"},
        {"g = 0; p = procedure(d): g = g + d; p(3); p(4); r = g", "7"},
        {"f = function(n): return = nil(): for (n, -1, 1, snoc(n, return)); "
         "r = sizeof(f(4))",
         "4"},
        {"f = function(x): return = thisobj(\"x\"); r = f(\"s\")", "9"},
        /* a local hides the global for look-ups by name in callees, too */
        {"g = function(): return = thisobj(\"q\"); "
         "f = function():q: q = 1: return = g(); r = f() * 100 + g()",
         "200"},
        /* a body may free or replace its own function */
        {"r = 0; p = procedure(): fnfree(\"p\"): r = 4; p()", "4"},
        {"r = 0; p = procedure(x): r = x; for (i = 1, 1, 3, p(i))", "3"},
        {"f = function(x): return = -x; l = list(f(1), f(2)); "
         "r = nth(l, 2)",
         "-2"},
        /* a name that is assigned and exists nowhere is a local */
        {"f = function(x): t = x * 2: return = t + t; r = f(4) + "
         "thisobj(\"t\")",
         "16"},
        {"pause = procedure(): t = 0; pause(); r = thisobj(\"t\")", "0"},
        {"f = function(n): if (n > 0, t = n): return = t; r = f(2)", "2"},
        {"r = sizeof(usr_fn_list)", "0"},
        {"f = function(): return = 1; r = nth(usr_fn_list, 1)", "F"},
        {"f = function(): return = 1; fnfree(\"\"); f = 5; r = f", "5"},
    };

    (void)state;
    VALUES(rows);
}

static void t_exec(void **state)
{
    static const char *const rows[][2] = {
        {"exec(\"r = 5\")", "5"},
        {"exec(\"a = 5; r = a + 1;\")", "6"},
        {"f = function(x):y: y = 0: exec(\"y = x * 2\"): return = y; r = f(4)",
         "8"},
        {"g = function(): exec(\"z = z + 1\"): return = 0; "
         "f = function():z:t: z = 1: t = g(): return = z; r = f()",
         "2"},
        {"exec(\"h = function(x): return = x ^ 2\"); r = h(3)", "9"},
        {"exec(\"exec(\\\"r = 3\\\")\")", "3"},
    };

    (void)state;
    VALUES(rows);
}

/* --- printing ----------------------------------------------------------------
 */

static void t_printing(void **state)
{
    static const char *const rows[][2] = {
        {"a = 3", ""},
        {"a",
         "A          (1) - Numeric   type\n[OBJECT A\n    [NUMBER 3]\n]\n"},
        {"-a",
         "A          (0) - Numeric   type\n[OBJECT A\n    [NUMBER -3]\n]\n"},
        {"a + 1",
         "NONE       (0) - Numeric   type\n[OBJECT NONE\n    [NUMBER 4]\n]\n"},
        {"for (i = 1, 1, 2, i : j = i)",
         "I          (1) - Numeric   type\n[OBJECT I\n    [NUMBER 1]\n]\n"
         "I          (1) - Numeric   type\n[OBJECT I\n    [NUMBER 2]\n]\n"},
        {"f = function(x): return = 0: x; b = f(7)",
         "X          (1) - Numeric   type\n[OBJECT X\n    [NUMBER 7]\n]\n"},
        {"list(list(), \"s\")", "NONE       (0) - Object List type\n"
                                "    NONE       (1) - Object List type\n"
                                "    NONE       (2) - String    type\n"
                                "    [OBJECT NONE\n\t[STRING \"s\"]\n    ]\n"},
        {"b = iritstate(\"dumplevel\", 16); a : list(1)",
         "A          (1) - Numeric   type\n"
         "NONE       (0) - Object List type\n"
         "    NONE       (2) - Numeric   type\n"},
        {"b = iritstate(\"dumplevel\", 257); a",
         "[OBJECT A\n    [NUMBER 3]\n]\n"},
    };
    session s;

    (void)state;
    session_open(&s, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ASSERT_OK(s.ctx, session_run(&s, rows[i][0]));
        assert_string_equal(s.out, rows[i][1]);
    }
    session_close(&s);
}

/* --- errors
 * ---------------------------------------------------------------------- */

/* Text, what the messages must contain, whether "after" still runs. */
static void t_errors(void **state)
{
    static const struct {
        const char *text, *message;
        bool soft;
    } rows[] = {
        {"a = 1 / 0", "t:1:7: error: division by zero", false},
        {"a = b", "t:1:5: error: there is no variable B", false},
        {"a = a + 1", "there is no variable A", false},
        {"a = coord(point(1, 2, 3), 9)", "argument 2 of COORD", true},
        {"coord(point(1, 2, 3), 9)", "the script goes on", true},
        {"a = 1 + coord(point(1, 2, 3), 9)", "argument 2 of COORD", false},
        {"a = iritstate(\"nosuch\", 1)", "IRITSTATE", true},
        {"printf(\"%d\", nil())", "more than the 0 arguments", true},
        {"include(\"nosuch\")", "cannot find the script nosuch", true},
        {"nth(list(1), 9)", "NTH", false},
        {"error(\"my words\")", "my words", false},
        {"f = function(x): x = 1; a = f(1)", "F has no returned value", false},
        {"f = function(): return = 1; fnfree(\"f\"); f()",
         "undefined function F", false},
        {"a = 0; p = procedure(): a = 1; p = procedure(): fnfree(\"p\") : "
         "p(); p()",
         "the function P was freed", false},
        {"f = function():y: return = y; f()", "Y has no value yet", false},
        {"f = function(n): if (n > 0, t = n): return = t; f(0)",
         "T has no value yet", false},
        {"f = function(): return = g1; a = 2",
         "F uses G1, which is neither a parameter", true},
        {"if (point(1, 2, 3) == point(1, 2, 3), r = list(nil() + nil()))", "",
         true},
        {"r = 0; f = function(x): if (x, r = 1); f(\"s\")",
         "the condition of IF must be a number, got a string", false},
        {"for (i = 1, 1, 3, free(i))", "the counter I of FOR was freed", false},
        {"for (i = 1, 1, 3, i = \"x\")", "given another type", false},
        {"for (i = 1, 0, 3, a = i)", "increment of FOR must not be 0", false},
        {"for (i = 1e20, 1, 2e20, a = i)", "does not change any more", false},
        {"exec(\"a = 1 +\")", "<exec>:1:8: error: the input ends", false},
        {"exec(\"a = 1 / 0\")", "<exec>:1:7: error: division", false},
        {"exec(\"a = 1 / 0\")", "  in EXEC, called from t:1", false},
        {"a = point(1, 2, 3) == vector(1, 2, 3)", "operator ==", false},
    };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[300];
        session s;

        session_open(&s, NULL);
        (void)snprintf(text, sizeof text, "%s;\nafter = 1;", rows[i].text);
        assert_int_equal(session_run(&s, text) == IX_OK, rows[i].soft);
        if (!strstr(s.err, rows[i].message))
            fail_msg("%s: \"%s\" wanted, got %s", text, rows[i].message, s.err);
        assert_int_equal(ix__var_find(s.in, "after") != NULL, rows[i].soft);
        if (ix__interp_errors(s.in) != (*rows[i].message != '\0'))
            fail_msg("%s: %d errors: %s", text, ix__interp_errors(s.in), s.err);
        session_close(&s);
    }
}

/* A function is bound to the globals that exist when it is defined. */
static void t_unbound_names(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "f = function(): return = g1 + g1;"));
    assert_int_equal(ix__interp_errors(s.in), 1);
    assert_int_not_equal(session_run(&s, "g1 = 2; f();"), IX_OK);
    assert_non_null(
        strstr(s.err, "t:1:31: error: G1 did not exist when the function was"));
    ASSERT_OK(s.ctx, session_run(&s, "f = function(): return = g1 + g1;"));
    assert_true(session_number(&s, "f()") == 4);
    session_close(&s);
}

/* After a hard error the rest of its line runs, and nothing else. */
static void t_rest_of_line(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    assert_int_not_equal(
        session_run(&s, "a = 1 / 0; b = 2; c = ;; d = 4;\ne = 5;"), IX_OK);
    assert_non_null(ix__var_find(s.in, "b"));
    assert_non_null(ix__var_find(s.in, "d"));
    assert_null(ix__var_find(s.in, "e"));
    assert_int_equal(ix__interp_errors(s.in), 2);
    session_close(&s);
}

/* A variable whose new value is missing must not keep its old one. */
static void t_no_stale_value(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = 5; a = coord(point(1, 2, 3), 9);"));
    assert_null(ix__var_find(s.in, "a"));
    session_close(&s);
}

static void t_many_errors(void **state)
{
    char text[2000] = "";
    session s;
    int shown = 0;

    (void)state;
    session_open(&s, NULL);
    for (int i = 0; i < 30; i++)
        strcat(text, "a = 1 / 0; ");
    (void)session_run(&s, text);
    for (const char *p = s.err; (p = strstr(p, ": error: ")); p++)
        shown++;
    assert_int_equal(shown, 20);
    assert_int_equal(ix__interp_errors(s.in), 30);
    session_close(&s);
}

/* --- limits
 * -------------------------------------------------------------------- */

static void t_call_depth(void **state)
{
    static const ix_interp_opts opts = {.max_calls = 50};
    session s;
    int frames = 0;

    (void)state;
    session_open(&s, &opts);
    ASSERT_OK(s.ctx,
              session_run(&s, "f = function(n): return = 0; f = function(n): "
                              "if (n > 0, return = f(n - 1), return = 0);"));
    assert_true(session_number(&s, "f(49)") == 0);
    assert_int_equal(session_run(&s, "f(50)"), IX_EARG);
    for (const char *p = s.err; (p = strstr(p, "called from")); p++)
        frames++;
    assert_int_equal(frames, 10);
    assert_non_null(strstr(s.err, "and 40 more calls"));
    assert_int_equal(s.in->nframes, 0);
    assert_int_equal(s.in->top, 0);
    assert_true(session_number(&s, "f(3)") == 0);
    session_close(&s);
}

/* Deep expressions inside deep calls stop before the C stack does. */
static void t_stack(void **state)
{
    static const ix_interp_opts opts = {.max_calls = 1000000};
    char text[2000] = "f = function(n): return = ";
    session s;

    (void)state;
    session_open(&s, &opts);
    for (int i = 0; i < 120; i++)
        strcat(text, "-(1+");
    strcat(text, "f(n)");
    for (int i = 0; i < 120; i++)
        strcat(text, ")");
    ASSERT_OK(s.ctx, session_run(&s, "f = function(n): return = 0;"));
    ASSERT_OK(s.ctx, session_run(&s, text));
    assert_int_equal(session_run(&s, "f(1)"), IX_EARG);
    assert_non_null(strstr(s.err, "nested too deeply"));
    session_close(&s);
}

static void t_steps(void **state)
{
    static const ix_interp_opts opts = {.steps = 1000};
    session s;

    (void)state;
    session_open(&s, &opts);
    assert_int_equal(session_run(&s, "while (1, a = 1);"), IX_ECANCEL);
    assert_non_null(strstr(s.err, "limit of 1000 steps"));
    session_close(&s);
}

static void t_cancel(void **state)
{
    static volatile int flag;
    session s;

    (void)state;
    session_open(&s, NULL);
    ix_ctx_set_cancel(s.ctx, &flag);
    flag = 1;
    assert_int_equal(session_run(&s, "while (1, a = 1); b = 1;"), IX_ECANCEL);
    assert_null(ix__var_find(s.in, "b"));
    flag = 0;
    ASSERT_OK(s.ctx, session_run(&s, "b = 1;"));
    session_close(&s);
}

static void t_strict(void **state)
{
    static const ix_interp_opts opts = {.strict = true};
    session s;

    (void)state;
    session_open(&s, &opts);
    assert_int_not_equal(
        session_run(&s, "a = coord(point(1, 2, 3), 9); b = 1;"), IX_OK);
    assert_null(ix__var_find(s.in, "b"));
    assert_int_not_equal(session_run(&s, "include(\"nosuch\"); b = 1;"), IX_OK);
    assert_int_not_equal(session_run(&s, "f = function(): return = zz;"),
                         IX_OK);
    session_close(&s);
}

static void t_check_only(void **state)
{
    static const ix_interp_opts opts = {.check_only = true};
    session s;

    (void)state;
    session_open(&s, &opts);
    ASSERT_OK(s.ctx, session_run(&s, "a = 1; b = a + 1; b; printf(\"x\", "
                                     "nil()); f = function(x): return = x;\n"
                                     "while (1, c = f(a)); c = 1 / 0;"));
    assert_string_equal(s.out, "");
    assert_int_not_equal(
        session_run(&s, "p = point(1, 2, 3); q = p + 1;\nr = nosuch;\n"
                        "f(1, 2);\ns = p + p;"),
        IX_OK);
    assert_int_equal(ix__interp_errors(s.in), 3);
    assert_int_not_equal(session_run(&s, "t = 1; free(t); u = t;"), IX_OK);
    session_close(&s);
}

/* --- a law
 * ------------------------------------------------------------------------ */

/* A random expression as text, and its value by C. */
static double random_value(ix_rng *rng, int depth, char *text)
{
    char a[1500], b[1500];
    double x, y;

    if (depth == 0) {
        x = ix_rng_int(rng, 1, 99) / 8.0;
        (void)sprintf(text, "%g", x);
        return x;
    }
    x = random_value(rng, depth - 1, a);
    y = random_value(rng, depth - ix_rng_int(rng, 1, depth), b);
    switch (ix_rng_int(rng, 0, 5)) {
    case 0:
        (void)sprintf(text, "(%s + %s)", a, b);
        return x + y;
    case 1:
        (void)sprintf(text, "(%s - %s)", a, b);
        return x - y;
    case 2:
        (void)sprintf(text, "(%s * %s)", a, b);
        return x * y;
    case 3:
        (void)sprintf(text, "(-(%s) < %s)", a, b);
        return -x < y && fabs(-x - y) >= 1e-14;
    case 4:
        (void)sprintf(text, "max(%s, %s)", a, b);
        return x > y ? x : y;
    default:
        (void)sprintf(text, "atan2(%s, 1 + abs(%s))", a, b);
        return atan2(x, 1 + fabs(y));
    }
}

/* Law: an expression has the value that C gives it, bit by bit. */
static void t_random_expressions(void **state)
{
    ix_rng rng = ix_rng_new(21);
    session s;

    (void)state;
    session_open(&s, NULL);
    for (int i = 0; i < 300; i++) {
        char text[1500];
        double want = random_value(&rng, 5, text);

        if (strchr(text, 'e')) /* %g: 1e-05 has no counterpart here */
            continue;
        if (session_number(&s, text) != want)
            fail_msg("seed 21, round %d: %s", i, text);
    }
    session_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_assignment),
        cmocka_unit_test(t_order),
        cmocka_unit_test(t_branches),
        cmocka_unit_test(t_loops),
        cmocka_unit_test(t_functions),
        cmocka_unit_test(t_exec),
        cmocka_unit_test(t_printing),
        cmocka_unit_test(t_errors),
        cmocka_unit_test(t_unbound_names),
        cmocka_unit_test(t_rest_of_line),
        cmocka_unit_test(t_no_stale_value),
        cmocka_unit_test(t_many_errors),
        cmocka_unit_test(t_call_depth),
        cmocka_unit_test(t_stack),
        cmocka_unit_test(t_steps),
        cmocka_unit_test(t_cancel),
        cmocka_unit_test(t_strict),
        cmocka_unit_test(t_check_only),
        cmocka_unit_test(t_random_expressions),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
