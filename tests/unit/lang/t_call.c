/* t_call.c - functions called by their names from outside. Law: the value is
 * that of the same call in a script; what a script is told about wrong
 * arguments, a caller is told too; nothing that touches files, commands or the
 * session can be reached. */
#define _POSIX_C_SOURCE 200809L
#include "lang/call.h"

#include "session.h"

#define MAX_ARGS 4

/* The variables of these names as arguments, up to a NULL. */
static ix_status call(session *s, const char *name, const char *const *vars,
                      ix_obj **out)
{
    ix_obj *argv[MAX_ARGS];
    int argc = 0;

    for (; argc < MAX_ARGS && vars[argc]; argc++) {
        argv[argc] = ix__var_find(s->in, vars[argc]);
        assert_non_null(argv[argc]);
    }
    return ix__call_by_name(s->in, name, argc, argv, out);
}

static void open_with_variables(session *s)
{
    session_open(s, NULL);
    ASSERT_OK(s->ctx,
              session_run(s, "n = 2; t = 0.3; str = \"FloatFrmt\"; "
                             "l = list(1, list(2, 3)); v = vector(1, 2, 3); "
                             "c = cbezier(list(point(0, 0, 0), "
                             "point(1, 2, 0), point(3, 1, 1))); "
                             "e = nil(); f = ruledsrf(c, c * tx(1)); "
                             "p = plane(0, 0, 1, 9);"));
}

static char *dump_of(session *s, const ix_obj *o)
{
    char *copy;
    ix_buf b;

    ix__buf_init(&b, s->ctx);
    ASSERT_OK(s->ctx, ix__dump_value(s->in, o, &b));
    copy = strdup(b.data);
    ix__buf_free(&b);
    return copy;
}

static void test_values(void **state)
{
    static const struct {
        const char *name, *vars[MAX_ARGS], *script;
    } cases[] = {
        {"sqrt", {"N"}, "sqrt(n)"},
        {"CEVAL", {"C", "T"}, "ceval(c, t)"},
        {"Evolute", {"C"}, "evolute(c)"},
        {"list", {"L", "C", "E"}, "list(l, c, e)"},
        {"NIL", {NULL}, "nil()"},
        {"sizeof", {"L"}, "sizeof(l)"},
        {"max", {"N", "T"}, "max(n, t)"}, /* of the start-up library */
        {"CDERIVE", {"C"}, "cderive(c)"},
    };
    session s;

    (void)state;
    open_with_variables(&s);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[200], *a, *b;
        ix_obj *o;

        ASSERT_OK(s.ctx, call(&s, cases[i].name, cases[i].vars, &o));
        (void)snprintf(text, sizeof text, "zz = %s;", cases[i].script);
        ASSERT_OK(s.ctx, session_run(&s, text));
        ASSERT_OK(s.ctx, ix__obj_set_name(s.ctx, o, "ZZ"));
        a = dump_of(&s, o);
        b = dump_of(&s, ix__var_find(s.in, "ZZ"));
        assert_string_equal(a, b);
        free(a);
        free(b);
        ix__obj_unref(s.ctx, o);
    }
    session_close(&s);
}

static void test_messages(void **state)
{
    static const struct {
        const char *name, *vars[MAX_ARGS], *message;
    } cases[] = {
        {"EVOLUT", {"C"}, "there is no function EVOLUT; did you mean EVOLUTE"},
        {"nosuchthing", {NULL}, "there is no function nosuchthing"},
        {"", {NULL}, "there is no function "},
        {"evolute",
         {"N"},
         "argument 1 of EVOLUTE must be a curve or a surface, got a num"},
        {"ceval", {"C", "C"}, "argument 2 of CEVAL must be a number, got a "},
        {"ceval", {"C"}, "CEVAL takes 2 arguments, got 1: CEVAL(c:curve, t:"},
        {"sqrt", {NULL}, "SQRT takes 1 argument, got 0"},
        {"nth", {"L", "N", "N"}, "NTH takes 2 arguments, got 3"},
        {"cbezier", {"E"}, "argument 1 of CBEZIER: "},
        {"save", {"STR", "N"}, "SAVE touches files, commands, the terminal"},
        {"System", {"STR"}, "SYSTEM touches files"},
        {"thisobj", {"STR"}, "THISOBJ touches"},
        {"getline", {"N"}, "GETLINE touches"},
        {"color", {"C", "N"}, "COLOR is a procedure: it gives no value"},
        {"IF", {"N", "N"}, "IF is a procedure"},
        {"contour", {"F", "P"}, "CONTOUR gives no value here"},
        {"viewclear", {NULL}, "start-up library"},
    };
    session s;

    (void)state;
    open_with_variables(&s);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ix_obj *o = NULL;

        if (call(&s, cases[i].name, cases[i].vars, &o) == IX_OK || o)
            fail_msg("%s gave a value", cases[i].name);
        if (!strstr(ix_ctx_message(s.ctx), cases[i].message))
            fail_msg("%s: %s", cases[i].name, ix_ctx_message(s.ctx));
    }
    session_close(&s);
}

/* Of the chapters of the system and of output only these are offered; nothing
 * else prints (a function that did would show in this program's output), reads
 * the terminal or starts a program. */
static void test_what_is_refused(void **state)
{
    static const char *const local[] = {"GETLINE",  "CLNTREAD", "CLNTWRITE",
                                        "CLNTEXEC", "CLNTCRSR", "CLNTPICKOBJ"};
    const ix_builtin *row;
    int offered = 0;

    (void)state;
    for (size_t i = 0; (row = ix__builtin_at(i)); i++) {
        bool refused = row->flags & IX_B_LOCAL ||
                       strstr(row->signature, "-> nothing");

        if (row->chapter != 1 && row->chapter != 4)
            continue;
        if (!refused && strcmp(row->name, "IRITSTATE") != 0 &&
            strcmp(row->name, "TIME") != 0)
            fail_msg("%s is offered", row->name);
        offered += !refused;
    }
    assert_int_equal(offered, 2);
    for (size_t i = 0; i < sizeof local / sizeof *local; i++)
        assert_true(ix__builtin_find(local[i])->flags & IX_B_LOCAL);
    assert_true(ix__call_keeps_state("IritState"));
    assert_true(ix__call_keeps_state("random"));
    assert_false(ix__call_keeps_state("evolute"));
    assert_false(ix__call_keeps_state("nosuch"));
}

static void test_state_stays(void **state)
{
    session s;
    ix_obj *o;

    (void)state;
    open_with_variables(&s);
    ASSERT_OK(s.ctx, session_run(&s, "f = \"DegreeForm\"; three = 3;"));
    ASSERT_OK(s.ctx,
              call(&s, "IRITSTATE", (const char *[]){"F", "THREE", NULL}, &o));
    ix__obj_unref(s.ctx, o);
    assert_int_equal(ix__states(s.in)->degree_form, 3);
    session_close(&s);
}

/* --- out of memory ---------------------------------------------------------
 */

typedef struct {
    ix_interp *in;
    ix_obj *arg, *out;
} call_state;

static void setup(ix_ctx *ctx, void *state)
{
    static const ix_interp_opts none;
    static const char text[] = "c = circle(vector(0, 0, 0), 1);";
    call_state *s = state;

    ASSERT_OK(ctx, ix__interp_new(ctx, &none, &s->in));
    ASSERT_OK(ctx, ix__interp_run_text(s->in, "t", text, strlen(text)));
    s->arg = ix__var_find(s->in, "C");
    s->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    call_state *s = state;

    (void)ctx;
    return ix__call_by_name(s->in, "cderive", 1, &s->arg, &s->out);
}

static void teardown(ix_ctx *ctx, void *state)
{
    call_state *s = state;

    ix__obj_unref(ctx, s->out);
    ix__interp_free(s->in);
}

static void test_no_memory(void **state)
{
    call_state s = {NULL, NULL, NULL};
    ix_fault_case c = {setup, run, teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_messages),
        cmocka_unit_test(test_what_is_refused),
        cmocka_unit_test(test_state_stays),
        cmocka_unit_test(test_no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
