/* Tests of lang/interp.c, lang/paths.c, lang/scope.c: scripts and the files
 * they include, what primitives may do with variables, memory failures. */
#define _XOPEN_SOURCE 700
#include <sys/stat.h>
#include <unistd.h>

#include "session.h"

/* --- files
 * --------------------------------------------------------------------- */

static char home[64]; /* a directory of our own, the present one */

static int enter_home(void **state)
{
    (void)state;
    (void)strcpy(home, "/tmp/t_interp.XXXXXX");
    return !mkdtemp(home) || chdir(home) != 0;
}

static int leave_home(void **state)
{
    char command[100];

    (void)state;
    (void)snprintf(command, sizeof command, "rm -rf %s", home);
    return chdir("/") != 0 || system(command) != 0;
}

static void put(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");

    assert_non_null(f);
    assert_true(fputs(text, f) >= 0);
    assert_int_equal(fclose(f), 0);
}

static ix_status run_file(session *s, const char *name)
{
    ix_status st = ix__interp_run_file(s->in, name);

    (void)fflush(s->ferr);
    return st;
}

/* The included text runs after the rest of the line, before the next one. */
static void t_include_order(void **state)
{
    session s;

    (void)state;
    put("main.irt", "l = \"\"; include(\"part\"); l = l + \"a\";\n"
                    "l = l + \"c\"; include(\"part.irt\"); l = l + \"d\";\n"
                    "l = l + \"e\";\n");
    put("part.irt", "l = l + \"b\";\n");
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, run_file(&s, "main"));
    assert_string_equal(ix__var_find(s.in, "l")->u.str.s, "abcdbe");
    session_close(&s);
}

/* Where a script is looked for: here, beside the includer, in the path. */
static void t_include_search(void **state)
{
    static const ix_interp_opts opts = {.include_path = "none;lib"};
    session s;

    (void)state;
    assert_int_equal(mkdir("sub", 0700), 0);
    assert_int_equal(mkdir("lib", 0700), 0);
    put("sub/main.irt", "include(\"b\"); include(\"c\"); include(\"d\");\n");
    put("sub/b.irt", "b = 1;\n");
    put("c.irt", "c = 1;\n");
    put("sub/c.irt", "c = 2;\n");
    put("lib/d.irt", "d = 1;\n");
    session_open(&s, &opts);
    ASSERT_OK(s.ctx, run_file(&s, "sub/main.irt"));
    assert_true(ix__var_num(s.in, "b", 0) == 1);
    assert_true(ix__var_num(s.in, "c", 0) == 1);
    assert_true(ix__var_num(s.in, "d", 0) == 1);
    session_close(&s);
}

/* A file that is being read cannot be included again, by whatever name. */
static void t_include_cycle(void **state)
{
    session s;

    (void)state;
    put("self.irt", "n = 1;\ninclude(\"self\");\nm = 1;\n");
    put("one.irt", "include(\"two\");\na = 1;\n");
    put("two.irt", "include(\"../two_again\");\nb = 1;\n");
    session_open(&s, NULL);
    assert_int_equal(run_file(&s, "self.irt"), IX_EARG);
    assert_non_null(strstr(s.err, "self.irt:2:1: error: INCLUDE: self.irt is "
                                  "being read already"));
    assert_null(ix__var_find(s.in, "m"));
    put("two.irt", "include(\"./one\");\nb = 1;\n");
    assert_int_equal(run_file(&s, "one.irt"), IX_EARG);
    assert_null(ix__var_find(s.in, "a"));
    session_close(&s);
}

static void t_include_depth(void **state)
{
    char name[32], text[80];
    session s;

    (void)state;
    for (int i = 0; i < 13; i++) {
        (void)snprintf(name, sizeof name, "n%d.irt", i);
        (void)snprintf(text, sizeof text, "d = %d;\ninclude(\"n%d\");\nx = 1;",
                       i, i + 1);
        put(name, text);
    }
    session_open(&s, NULL);
    assert_int_equal(run_file(&s, "n0.irt"), IX_EARG);
    assert_non_null(strstr(s.err, "included more than 10 deep"));
    assert_true(ix__var_num(s.in, "d", 0) == 10);
    session_close(&s);
}

/* Errors name the included file; all files are left after a hard one. */
static void t_include_error(void **state)
{
    session s;

    (void)state;
    put("main.irt", "include(\"bad\");\na = 1;\n");
    put("bad.irt", "\n  x = 1 / 0; y = 2;\nz = 1;\n");
    session_open(&s, NULL);
    assert_int_equal(run_file(&s, "main.irt"), IX_EARG);
    assert_non_null(strstr(s.err, "bad.irt:2:9: error: division by zero\n"
                                  "    x = 1 / 0; y = 2;\n"
                                  "          ^\n"));
    assert_non_null(ix__var_find(s.in, "y"));
    assert_null(ix__var_find(s.in, "z"));
    assert_null(ix__var_find(s.in, "a"));
    session_close(&s);
}

static void t_missing_script(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    assert_int_equal(run_file(&s, "nosuch"), IX_EIO);
    assert_non_null(strstr(s.err, "cannot open nosuch"));
    assert_int_equal(ix__interp_errors(s.in), 1);
    session_close(&s);
}

static void t_paths(void **state)
{
    static const struct {
        const char *name;
        bool ok;
    } rows[] = {
        {"a.itd", true},    {"sub/a.itd", true},    {"./a", true},
        {"nosuch/a", true}, /* cannot be opened anyway */
        {"../a", false},    {"/etc/passwd", false}, {"sub/../../a", false},
        {"link/a", false},  {"linked", false},      {"|id", false},
        {"", false},        {"sub", false},         {"/dev/null", false},
        {"pipe", false},
    };
    static const ix_interp_opts all = {.allow_system = true};
    static const ix_interp_opts rooted = {.root = "sub"};
    session s;

    (void)state;
    assert_int_equal(symlink("/tmp", "link"), 0);
    assert_int_equal(symlink("/etc/passwd", "linked"), 0);
    assert_int_equal(mkfifo("pipe", 0600), 0);
    session_open(&s, NULL);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int w = 0; w < 2; w++)
            if ((ix__path_check(s.in, rows[i].name, w) == IX_OK) != rows[i].ok)
                fail_msg("%s: %s", rows[i].name, ix_ctx_message(s.ctx));
    assert_int_equal(ix__system_check(s.in), IX_EIO);
    session_close(&s);
    session_open(&s, &all);
    ASSERT_OK(s.ctx, ix__path_check(s.in, "/dev/null", true));
    ASSERT_OK(s.ctx, ix__path_check(s.in, "../a", true));
    ASSERT_OK(s.ctx, ix__system_check(s.in));
    assert_int_equal(ix__path_check(s.in, "|id", true), IX_EIO);
    session_close(&s);
    session_open(&s, &rooted);
    assert_int_equal(ix__path_check(s.in, "a.itd", true), IX_EIO);
    ASSERT_OK(s.ctx, ix__path_check(s.in, "sub/a.itd", true));
    session_close(&s);
}

/* --- services
 * -------------------------------------------------------------------- */

static void t_variables(void **state)
{
    session s;
    ix_obj *o;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "abc = 5; l = list(abc);"));
    o = ix__var_find(s.in, "aBc");
    assert_true(ix__var_num(s.in, "ABC", 0) == 5);
    assert_true(ix__var_num(s.in, "L", 7) == 7);
    assert_true(ix__var_num(s.in, "RESOLUTION", 0) == 20);
    ASSERT_OK(s.ctx, ix__var_rename(s.in, "abc", "def"));
    assert_ptr_equal(ix__var_find(s.in, "def"), o);
    assert_null(ix__var_find(s.in, "abc"));
    assert_string_equal(o->name, "DEF");
    assert_int_equal(ix__var_rename(s.in, "abc", "x"), IX_EARG);
    ASSERT_OK(s.ctx, ix__var_free(s.in, "def"));
    assert_int_equal(ix__var_free(s.in, "def"), IX_EARG);
    ASSERT_OK(s.ctx, session_run(&s, "resolution = 3; xyz = 1;"));
    ASSERT_OK(s.ctx, ix__var_reset(s.in));
    assert_true(ix__var_num(s.in, "RESOLUTION", 0) == 20);
    assert_null(ix__var_find(s.in, "xyz"));
    session_close(&s);
}

static void t_exit(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = 1; exit(); b = 1;\nc = 1;"));
    assert_null(ix__var_find(s.in, "b"));
    assert_int_equal(ix__interp_errors(s.in), 0);
    ASSERT_OK(s.ctx, session_run(&s, "c = 1;"));
    assert_null(ix__var_find(s.in, "c"));
    session_close(&s);
}

/* What was viewed stays as it was then. */
static void t_view(void **state)
{
    const ix_obj *l;
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = 1; viewobj(a); a = 2; viewobj(a);"));
    l = ix__interp_viewed(s.in);
    assert_int_equal(l->u.list.n, 2);
    assert_true(l->u.list.item[0]->u.num == 1);
    assert_true(l->u.list.item[1]->u.num == 2);
    session_close(&s);
}

static void t_output_file(void **state)
{
    char line[100];
    FILE *f;
    session s;

    (void)state;
    session_open(&s, NULL);
    s.in->out = NULL; /* the real thing */
    ASSERT_OK(s.ctx, session_run(&s, "printfile(\"p.txt\"); printf(\"hello\", "
                                     "nil()); a = 1; printfile(\"\");"));
    s.in->out = s.fout;
    f = fopen("p.txt", "r");
    assert_non_null(f);
    assert_non_null(fgets(line, sizeof line, f));
    assert_string_equal(line, "hello");
    (void)fclose(f);
    session_close(&s);
}

/* --- memory
 * ---------------------------------------------------------------------------
 */

static ix_status run_script(ix_ctx *ctx, void *state)
{
    static const ix_interp_opts none;
    static const char text[] =
        "f2 = function(n): return = nil(): snoc(n, return);\n"
        "f = function(n):t: t = n: if (n > 0, return = f2(t) + list(sqr(t)), "
        "return = nil());\n"
        "a = b = list(1, 2); a = list(a, a); c = -f(3); c;\n"
        "for (i = 1, 1, 3, x = \"s\" + i : exec(\"y = x ^ x\"));\n"
        "printf(\"%s %d %pf\\\\n\", list(y, i, point(1, 2, 3)));\n"
        "z = coord(point(1, 2, 3), 9); viewobj(c); fnfree(\"\"); m = rx(30);\n";
    ix_interp *in;
    ix_status st = ix__interp_new(ctx, &none, &in);

    if (st != IX_OK)
        return st;
    in->err = in->out = state;
    st = ix__interp_run_text(in, "t", text, sizeof text - 1);
    in->err = in->out = NULL;
    ix__interp_free(in);
    return st;
}

/* Every allocation of a small script fails cleanly. */
static void t_no_memory(void **state)
{
    FILE *sink = fopen("/dev/null", "w");
    const ix_fault_case c = {NULL, run_script, NULL, sink};

    (void)state;
    assert_non_null(sink);
    assert_true(ix_fault_run(&c) > 100);
    (void)fclose(sink);
}

/* A script that grows without end meets the limit; what was there before is
 * still there and usable. */
static void t_memory_limit(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = list(1, 2, 3);"));
    ix_ctx_set_memory_limit(s.ctx, s.ctx->live + (1 << 20));
    assert_int_equal(session_run(&s, "l = nil(); while (1, snoc(a, l));"),
                     IX_ENOMEM);
    assert_non_null(strstr(s.err, "memory limit"));
    ASSERT_OK(s.ctx, session_run(&s, "free(l);"));
    assert_true(session_number(&s, "sizeof(a)") == 3);
    session_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_include_order), cmocka_unit_test(t_include_search),
        cmocka_unit_test(t_include_cycle), cmocka_unit_test(t_include_depth),
        cmocka_unit_test(t_include_error), cmocka_unit_test(t_missing_script),
        cmocka_unit_test(t_paths),         cmocka_unit_test(t_variables),
        cmocka_unit_test(t_exit),          cmocka_unit_test(t_view),
        cmocka_unit_test(t_output_file),   cmocka_unit_test(t_no_memory),
        cmocka_unit_test(t_memory_limit),
    };

    return cmocka_run_group_tests(tests, enter_home, leave_home);
}
