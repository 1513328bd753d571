/* Tests of lang/types.c and lang/tables.c: signatures, sets, names. */
#define _POSIX_C_SOURCE 200809L
#include "lang/startup.h"
#include "session.h"

static void t_signatures(void **state)
{
    ix__sig s;

    (void)state;
    assert_true(
        ix__sig_parse("a:num b:curve|surface [c:str] [d:any] -> list", &s));
    assert_int_equal(s.nmin, 2);
    assert_int_equal(s.nmax, 4);
    assert_int_equal(ix__sig_arg(&s, 1), IX_T(CURVE) | IX_T(SURFACE));
    assert_int_equal(s.result, IX_T(LIST));
    assert_true(ix__sig_parse("x:pv y:num... -> nothing", &s));
    assert_int_equal(s.nmin, 1);
    assert_int_equal(s.nmax, -1);
    assert_int_equal(ix__sig_arg(&s, 0), IX_T(POINT) | IX_T(VECTOR));
    assert_int_equal(ix__sig_arg(&s, 7), IX_T(NUMBER));
    assert_int_equal(s.result, 0);
    assert_true(ix__sig_parse("-> num", &s));
    assert_int_equal(s.nmax, 0);
}

static void t_bad_signatures(void **state)
{
    static const char *const bad[] = {
        "",
        "a:num",
        "a -> num",
        "a:nmu -> num",
        "-> curv",
        "[a:num] b:num -> num",
        "a:num... b:num -> num",
        "a: -> num",
        "[a:num -> num",
        "a:num| -> num",
    };
    ix__sig s;

    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (ix__sig_parse(bad[i], &s))
            fail_msg("accepted: %s", bad[i]);
}

static void t_texts(void **state)
{
    static const ix_builtin row = {
        "FOO", "a:num [b:list] -> curve", "", "", NULL, 0, 1};
    char buf[200];

    (void)state;
    assert_string_equal(ix__types_text(IX_T(NUMBER), buf, sizeof buf),
                        "a number");
    assert_string_equal(ix__types_text(IX_T(CURVE) | IX_T(LIST) | IX_T(STRING),
                                       buf, sizeof buf),
                        "a string, a list or a curve");
    assert_string_equal(ix__types_text(IX_T_ANY, buf, sizeof buf), "a value");
    assert_string_equal(ix__sig_text(&row, buf, sizeof buf),
                        "FOO(a:num, [b:list]) -> curve");
    assert_string_equal(ix__sig_text(&row, buf, 8), "FOO(a:n");
}

/* Every row of every table: a valid signature, a function, its own name,
 * found in any case; a summary and an example. */
static void t_rows(void **state)
{
    const ix_builtin *row;
    size_t n = 0;

    (void)state;
    for (; (row = ix__builtin_at(n)); n++) {
        char lower[64];
        ix__sig s;

        if (!ix__sig_parse(row->signature, &s))
            fail_msg("%s: signature \"%s\"", row->name, row->signature);
        assert_ptr_equal(ix__builtin_find(row->name), row);
        for (size_t i = 0; i <= strlen(row->name); i++)
            lower[i] = row->name[i] >= 'A' && row->name[i] <= 'Z'
                           ? (char)(row->name[i] + 32)
                           : row->name[i];
        assert_ptr_equal(ix__builtin_find(lower), row);
        assert_true(*row->summary && *row->example);
        assert_int_equal(row->summary[strlen(row->summary) - 1], '.');
    }
    assert_true(n > 300);
    assert_null(ix__builtin_find("NOSUCH"));
    assert_null(ix__builtin_find(""));
}

/* The texts of the start-up library compile without a message, each by
 * itself in a new interpreter; those without an example need a built-in that
 * we do not have. */
static void t_startup_texts(void **state)
{
    (void)state;
    for (const ix__startup_fn *f = ix__startup_text; f->name; f++) {
        session s;
        ix__sym *sym;

        session_open(&s, NULL);
        if (ix__fn_lookup(s.in, f->name, &sym) != IX_OK) {
            if (f->example)
                fail_msg("%s: %s", f->name, ix_ctx_message(s.ctx));
        } else {
            assert_non_null(sym);
            assert_true(sym->fn->is_startup);
            assert_null(ix__fn_at(s.in, 0));
        }
        assert_int_equal(ix__interp_errors(s.in), 0);
        session_close(&s);
    }
}

static void t_constants(void **state)
{
    const char *name;
    double v, w;

    (void)state;
    for (size_t i = 0; (name = ix__constant_at(i, &v)); i++) {
        assert_true(ix__constant_find(name, &w) && v == w);
        assert_null(ix__builtin_find(name));
    }
    assert_true(ix__constant_find("P9", &v) && v == 1117);
    assert_true(ix__constant_find("NUMERIC_TYPE", &v) && v == 2);
    assert_false(ix__constant_find("E10", &v));
}

static void t_near_names(void **state)
{
    static const char *const rows[][2] = {
        {"SINN", "SIN"},      {"SNOCK", "SNOC"}, {"PRITNF", "PRINTF"},
        {"VECOTR", "VECTOR"}, {"POIN", "POINT"},
    };
    char buf[200];
    session s;

    (void)state;
    session_open(&s, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_true(ix__names_near(s.in, rows[i][0], buf, sizeof buf));
        if (strncmp(buf, rows[i][1], strlen(rows[i][1])) != 0)
            fail_msg("%s: %s", rows[i][0], buf);
    }
    assert_false(ix__names_near(s.in, "QXZWQXZW", buf, sizeof buf));
    assert_false(ix__names_near(s.in, "Q", buf, sizeof buf));
    ASSERT_OK(s.ctx, session_run(&s, "myfunc = function(x): return = x;"));
    assert_true(ix__names_near(s.in, "MYFUNK", buf, sizeof buf));
    assert_string_equal(buf, "MYFUNC");
    assert_true(ix__names_near(s.in, "SPHERSRF", buf, sizeof buf));
    assert_string_equal(buf, "SPHERESRF");
    ASSERT_OK(s.ctx, session_run(&s, "mycurve = 1;"));
    assert_true(ix__vars_near(s.in, "MYCRUVE", buf, sizeof buf));
    assert_string_equal(buf, "MYCURVE");
    assert_true(ix__vars_near(s.in, "KV_OPNE", buf, sizeof buf));
    assert_string_equal(buf, "KV_OPEN");
    assert_false(ix__vars_near(s.in, "XX", buf, sizeof buf));
    session_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_signatures),    cmocka_unit_test(t_bad_signatures),
        cmocka_unit_test(t_texts),         cmocka_unit_test(t_rows),
        cmocka_unit_test(t_startup_texts), cmocka_unit_test(t_constants),
        cmocka_unit_test(t_near_names),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
