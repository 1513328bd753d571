/* Tests of lang/operators*.c: the complete table of operand types, and what
 * each combination gives. */
#define _POSIX_C_SOURCE 200809L
#include "session.h"

/* One value of each type that a script can make without much ado. */
static const struct {
    const char *letter; /* in the tables below */
    ix_obj_type type;
    const char *text;
} kinds[] = {
    {"n", IX_OBJ_NUMBER, "2"},
    {"s", IX_OBJ_STRING, "\"ab\""},
    {"p", IX_OBJ_POINT, "point(1, 2, 3)"},
    {"v", IX_OBJ_VECTOR, "vector(4, 5, 7)"},
    {"L", IX_OBJ_PLANE, "plane(1, 2, 3, 4)"},
    {"m", IX_OBJ_MATRIX, "trans(vector(1, 2, 3))"},
    {"c", IX_OBJ_CTLPT, "ctlpt(E3, 1, 2, 3)"},
    {"l", IX_OBJ_LIST, "list(point(1, 2, 3))"},
    {"C", IX_OBJ_CURVE, "cbezier(list(point(0, 0, 0), point(1, 1, 0)))"},
    {"S", IX_OBJ_SURFACE,
     "sbezier(list(list(point(0, 0, 0), point(1, 0, 0)), "
     "list(point(0, 1, 0), point(1, 1, 1))))"},
    {"y", IX_OBJ_POLY, "poly(list(point(0, 0, 0), point(1, 0, 0)), true)"},
    {"M", IX_OBJ_MULTIVAR,
     "mbezier(list(2), list(ctlpt(E1, 0), ctlpt(E1, 1)))"},
};
#define NKINDS (sizeof kinds / sizeof *kinds)

/* spec/language 5: "left right result", results of Boolean operations "#". */
static const struct {
    const char *op, *rows;
} tables[] = {
    {"+", "nnn sss nss sns ppv pvv vpv vvv mmm lll ccC CCC CcC cCC ypy yvy pyy "
          "vyy yy# SS#"},
    {"-", "nnn ppv pvv vpv vvv mmm yy# SS#"},
    {"*", "nnn npp pnp nvv vnv ppn pvn vpn vvn nmm mnm vCC CvC vSS SvS mmm "
          "pmp mpp vmv mvv LmL mLL cmc mcc ymy myy CmC mCC SmS mSS MmM mMM "
          "lml mll yy# SS#"},
    {"/", "nnn ppy pvy vpy vvy pyy vyy ypy yvy yy# SS#"},
    {"^", "nnn sss nss sns ppv pvv vpv vvv mnm yyy SSS"},
    {"==", "nnn ssn ppn vvn LLn mmn ccn lln CCn SSn yyn MMn"},
    {"!=", "nnn ssn ppn vvn LLn mmn ccn lln CCn SSn yyn MMn"},
    {"<", "nnn ssn"},
    {"<=", "nnn ssn"},
    {">", "nnn ssn"},
    {">=", "nnn ssn"},
    {"&&", "nnn"},
    {"||", "nnn"},
};

/* The result of l op r by the table: a letter, '#', or 0. */
static char wanted(const char *rows, char l, char r)
{
    for (; *rows; rows += rows[3] ? 4 : 3)
        if (rows[0] == l && rows[1] == r)
            return rows[2];
    return 0;
}

static void check_pair(session *s, size_t t, size_t i, size_t j)
{
    char text[500];
    char want = wanted(tables[t].rows, *kinds[i].letter, *kinds[j].letter);
    const ix_obj *o;
    ix_status st;

    (void)snprintf(text, sizeof text, "r = (%s %s %s);", kinds[i].text,
                   tables[t].op, kinds[j].text);
    st = session_run(s, text);
    if (!want || want == '#') {
        if (st != (want ? IX_EUNABLE : IX_EARG))
            fail_msg("%s: %s %s", text, ix_status_name(st), s->err);
        return;
    }
    if (st != IX_OK)
        fail_msg("%s: %s", text, s->err);
    o = ix__var_find(s->in, "r");
    for (size_t k = 0; k < NKINDS; k++)
        if (*kinds[k].letter == want && kinds[k].type != o->type)
            fail_msg("%s: %s", text, ix__obj_type_name(o->type));
}

/* Every operator with every pair of types. */
static void t_types(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++)
        for (size_t i = 0; i < NKINDS; i++)
            for (size_t j = 0; j < NKINDS; j++)
                check_pair(&s, t, i, j);
    session_close(&s);
}

/* The types are not known before the call: the same is refused while it
 * runs, with the same words. */
static void t_types_at_run_time(void **state)
{
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "f = function(a, b): return = a + b;"));
    assert_int_equal(session_run(&s, "f(1, point(1, 2, 3));"), IX_EARG);
    assert_non_null(strstr(s.err, "operator + with a number on its left takes "
                                  "a number or a string on its right, got a "
                                  "point"));
    assert_int_equal(session_run(&s, "a = 1 + point(1, 2, 3);"), IX_EARG);
    assert_non_null(strstr(s.err, "takes a number or a string on its right"));
    session_close(&s);
}

/* Conditions that must hold. */
static void truths(const char *const *text, size_t n)
{
    session s;

    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "p = point(1, 2, 3); v = vector(4, 5, 7); "
                                     "m = trans(vector(1, 2, 3)) * rotx(30); "
                                     "k = scale(vector(2, 3, 4)); "
                                     "c = cbezier(list(point(0, 0, 0), "
                                     "point(1, 2, 0), point(3, 1, 1)));"));
    for (size_t i = 0; i < n; i++)
        if (session_number(&s, text[i]) != 1)
            fail_msg("%s is not true", text[i]);
    session_close(&s);
}
#define TRUTHS(t) truths((t), sizeof(t) / sizeof *(t))

static void t_strings(void **state)
{
    static const char *const text[] = {
        "\"abc\" + \"def\" == \"abcdef\"",
        "\"abc\" ^ \"def\" == \"abcdef\"",
        "\"abc\" + 3.7 == \"abc3\"",
        "-3.7 + \"abc\" == \"-3abc\"",
        "\"abc\" ^ 3.7 == \"abc3.7             \"",
        "1 ^ \"a\" == \"1               a\"",
        "-\"hello\" == \"olleh\"",
        "-\"\" == \"\"",
        "\"a\" < \"b\"",
        "\"B\" < \"a\"",
        "(\"a\" == \"A\") == 0",
        "\"ab\" > \"a\"",
    };

    (void)state;
    TRUTHS(text);
}

static void t_numbers(void **state)
{
    static const char *const text[] = {
        "1 == 1 + 1e-15",
        "1 <= 1 - 1e-15",
        "(1 < 1 + 1e-15) == 0",
        "(1 > 1 - 1e-15) == 0",
        "1 != 1 + 1e-12",
        "1 / 1e-320 == 2 / 1e-320", /* both are infinite */
        "(sqrt(-1) == sqrt(-1)) == 0",
        "!(0.00000999)",
        "!0 == 1",
        "!(-3) == 0",
        "(1 && 0.00001)",
        "(0.000009 || 0) == 0",
        "0 ^ 0 == 1",
        "-2 ^ 2 == 4",
    };

    (void)state;
    TRUTHS(text);
}

static void t_points_and_matrices(void **state)
{
    static const char *const text[] = {
        "p + p == vector(2, 4, 6)",
        "p - v == vector(-3, -3, -4)",
        "p * v == 35",
        "2 * p == point(2, 4, 6)",
        "-v == vector(-4, -5, -7)",
        /* a ^ b is b x a: perpendicular to both, and reversed */
        "(p ^ v) * p == 0",
        "vector(1, 2, 3) ^ vector(0, 0, 1) == vector(-2, 1, 0)",
        "p ^ v == -(v ^ p)",
        /* the left factor acts first; either order of object and matrix */
        "p * (m * k) == (p * m) * k",
        "m * p == p * m",
        "m ^ 0 == scale(vector(1, 1, 1))",
        "m ^ 3 == m * m * m",
        "m ^ 1 == m",
        "(m ^ -2) ^ -2 == m",
        "2 * m == m + m",
        "m - m == 0 * m",
        "-m == -1 * m",
        "plane(1, 2, 3, 4) * tx(1) == plane(5, 2, 3, 4)",
        "ctlpt(P2, 2, 1, 0) * trans(vector(1, 2, 3)) == ctlpt(P2, 2, 3, 4)",
        "-ctlpt(P2, 2, 1, 3) == ctlpt(P2, 2, -1, -3)",
        "-plane(1, 2, 3, 4) == plane(-1, -2, -3, -4)",
    };
    session s;

    (void)state;
    TRUTHS(text);
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "m = rotx(30) * trans(vector(1, 2, 3)); "
                                     "d = m * m ^ -1 - m ^ 0;"));
    for (int i = 0; i < 16; i++) /* 4 products of entries of size 1 .. 4 */
        ASSERT_CLOSE(ix__var_find(s.in, "d")->u.mat[i], 0, 1e-14);
    assert_int_equal(session_run(&s, "a = scale(vector(0, 1, 1)) ^ -1;"),
                     IX_EDOMAIN);
    assert_int_equal(session_run(&s, "a = rotx(1) ^ -3;"), IX_EARG);
    assert_int_equal(session_run(&s, "a = rotx(1) ^ 0.5;"), IX_EARG);
    session_close(&s);
}

static void t_geometry(void **state)
{
    static const char *const text[] = {
        /* negation twice is nothing */
        "-(-c) == c",
        "nth(-(-list(c, p)), 1) == c",
        "ceval(-c, 0.25) == ceval(c, 0.75)",
        "c * vector(1, 0, 0) == vector(1, 0, 0) * c",
        /* curves joined where they meet keep their points */
        "sizeof(c + (c * trans(vector(3, 1, 1)))) == 5",
        "sizeof(c + c) == 7",
        "ceval(c + ctlpt(E3, 5, 5, 5), 0.5) == ceval(c, 0.5)",
        "sizeof(ctlpt(E2, 0, 0) + ctlpt(E2, 1, 0) + ctlpt(E2, 1, 1)) == 3",
        "ffpttype(ctlpt(E3, 0, 0, 0) + ctlpt(E3, 1, 0, 0)) == E1",
        "ffpttype(ctlpt(E3, 0, 1, 0) + ctlpt(E3, 1, 0, 0)) == E2",
        "ffpttype(c * tx(1)) == E3",
        "ffpttype((ctlpt(E1, 0) + ctlpt(E1, 1)) * tx(1)) == E3",
        /* polylines */
        "sizeof(p / v) == 2",
        "coord(coord(p / v / p, 2), 1) == 2",
        "coord(coord(v / (p / v), 0), 0) == 4",
        "sizeof((p / v) + p) == 3",
        "coord(coord(-(p / v), 0), 0) == 4",
        "sizeof((p / v) ^ (v / p)) == 2",
    };

    (void)state;
    TRUTHS(text);
}

/* Lists: concatenation shares elements, negation and motion copy them. */
static void t_lists(void **state)
{
    static const char *const text[] = {
        "sizeof(nil() + list(1)) == 1",
        "nth(-list(list(1), \"ab\"), 2) == \"ba\"",
        "nth(list(1, 2) * tx(1), 1) == 1",
    };
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = 1; l = list(a) + list(2); a = 5;"));
    assert_true(session_number(&s, "nth(l, 1)") == 5);
    ASSERT_OK(s.ctx, session_run(&s, "k = -l; a = 6;"));
    assert_true(session_number(&s, "nth(k, 1)") == -5);
    session_close(&s);
    truths(text, 2);
}

/* Every allocation of every operator fails cleanly. */
static ix_status run_operators(ix_ctx *ctx, void *state)
{
    static const ix_interp_opts none;
    static const char text[] =
        "a = \"x\" + 1 ^ \"y\"; m = tx(1) * ty(2) ^ -1; "
        "c = ctlpt(E2, 0, 0) + ctlpt(E2, 1, 0) + ctlpt(P2, 1, 1, 1); "
        "d = -c + c; e = c * vector(1, 0, 0); l = -(list(c, a) + list(m)); "
        "y = point(1, 2, 3) / point(3, 4, 5) / point(0, 0, 0); y = -y ^ y; "
        "t = c * m == c; k = list(c) * m;";
    ix_interp *in;
    ix_status st = ix__interp_new(ctx, &none, &in);

    if (st != IX_OK)
        return st;
    in->err = state;
    st = ix__interp_run_text(in, "t", text, sizeof text - 1);
    in->err = NULL;
    ix__interp_free(in);
    return st;
}

static void t_no_memory(void **state)
{
    FILE *sink = fopen("/dev/null", "w");
    const ix_fault_case c = {NULL, run_operators, NULL, sink};

    (void)state;
    assert_non_null(sink);
    assert_true(ix_fault_run(&c) > 100);
    (void)fclose(sink);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_types),
        cmocka_unit_test(t_types_at_run_time),
        cmocka_unit_test(t_strings),
        cmocka_unit_test(t_numbers),
        cmocka_unit_test(t_points_and_matrices),
        cmocka_unit_test(t_geometry),
        cmocka_unit_test(t_lists),
        cmocka_unit_test(t_no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
