/* Tests of lang/parser.c: how a text is grouped. */
#define _POSIX_C_SOURCE 200809L
#include "session.h"

/* Appends n as a fully parenthesised expression. */
static void show(const ix__node *n, char *out)
{
    char *end = out + strlen(out);

    switch (n->kind) {
    case N_NUM:
        (void)sprintf(end, "%g", n->u.lit.num);
        return;
    case N_STR:
        (void)sprintf(end, "\"%s\"", n->u.str.s);
        return;
    case N_GLOBAL:
        strcat(end, n->u.sym->name);
        return;
    case N_LOCAL:
        (void)sprintf(end, "$%d", (int)n->u.slot);
        return;
    case N_NEG:
    case N_NOT:
        strcat(end, n->kind == N_NEG ? "-" : "!");
        show(n->kid[0], end);
        return;
    case N_ASSIGN:
    case N_BINARY:
        strcat(end, "(");
        show(n->kid[0], end);
        strcat(end, ix__op_text(n->kind == N_ASSIGN ? OP_ASSIGN : n->op));
        show(n->kid[1], end);
        strcat(end, ")");
        return;
    case N_CHAIN:
        for (int i = 1; i < n->n; i++)
            strcat(end, "(");
        show(n->kid[0], end);
        for (int i = 1; i < n->n; i++) {
            strcat(end, ix__op_text(n->u.steps[i - 1].op));
            show(n->kid[i], end);
            strcat(end, ")");
        }
        return;
    case N_FUNDEF:
        (void)sprintf(end, "%s[%d,%d]:", n->u.fn->name, n->u.fn->nparams,
                      n->u.fn->nslots);
        show(n->u.fn->body, end);
        return;
    default:
        break;
    }
    strcat(end, n->kind == N_SEQ     ? "{"
                : n->kind == N_IF    ? "IF{"
                : n->kind == N_FOR   ? "FOR{"
                : n->kind == N_WHILE ? "WHILE{"
                : n->kind == N_USER  ? "CALL{"
                                     : "BUILTIN{");
    for (int i = 0; i < n->n; i++) {
        strcat(end, i ? (n->kind == N_SEQ ? ":" : ",") : "");
        show(n->kid[i], end);
    }
    strcat(end, "}");
}

/* The first statement of text; "ERROR line:col message" if it has none. */
static void parsed(session *s, const char *text, char *out)
{
    ix__unit *u = ix__unit_new(s->ctx);
    ix__reader rd;
    ix__node *n;
    bool end;
    ix_status st;

    ix__reader_init(&rd, s->in);
    ix__reader_push_text(&rd, "t", text, strlen(text));
    st = ix__parse(s->in, &rd, u, false, &n, &end);
    *out = '\0';
    if (st != IX_OK) {
        const ix__place *p = &s->in->place;

        (void)sprintf(out, "ERROR %u:%u %s", p->pos.line + 1, p->pos.col,
                      ix_ctx_message(s->ctx));
        ix__report(s->in, false);
    } else if (n) {
        show(n, out);
    }
    ix__reader_free(&rd);
    ix__unit_unref(u);
}

/* Texts and their grouping; an expected error needs only its beginning. */
static void table(const char *const rows[][2], size_t n)
{
    session s;
    char out[4096];

    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, "a = 1; b = 2; c = 3; d = 4; "
                                     "f = function(x): return = x;"));
    for (size_t i = 0; i < n; i++) {
        bool error = strncmp(rows[i][1], "ERROR", 5) == 0;

        parsed(&s, rows[i][0], out);
        if (error ? strncmp(out, rows[i][1], strlen(rows[i][1]))
                  : strcmp(out, rows[i][1]))
            fail_msg("%s\n  is   %s\n  want %s", rows[i][0], out, rows[i][1]);
    }
    session_close(&s);
}
#define TABLE(rows) table((rows), sizeof(rows) / sizeof *(rows))

/* The table of spec/language 2, "Consequences". */
static void t_consequences(void **state)
{
    static const char *const rows[][2] = {
        {"-2^2;", "(-2^2)"},
        {"-a^2;", "(-A^2)"},
        {"2^3^2;", "((2^3)^2)"},
        {"2^-1;", "(2^-1)"},
        {"2*-3;", "(2*-3)"},
        {"!0+1;", "(!0+1)"},
        {"a = b = 3;", "(A=(B=3))"},
        {"c = 1 && 0;", "((C=1)&&0)"},
        {"c = (1 && 0);", "(C=(1&&0))"},
        {"d = 3 < 4 == 1;", "(D=(3<(4==1)))"},
        {"a = a == 4;", "(A=(A==4))"},
        {"a = a == 1 && b == 2;", "((A=(A==1))&&(B==2))"},
        {"8-3-2;", "((8-3)-2)"},
        {"8/4/2;", "((8/4)/2)"},
    };

    (void)state;
    TABLE(rows);
}

static void t_levels(void **state)
{
    static const char *const rows[][2] = {
        {"1+2*3-4/5^6;", "((1+(2*3))-(4/(5^6)))"},
        {"a && b || c && d;", "(A&&(B||(C&&D)))"},
        {"a < b + c && d;", "((A<(B+C))&&D)"},
        {"!a && !b;", "(!A&&!B)"},
        {"- - -a;", "---A"},
        {"-!-a;", "-!-A"},
        {"a - -b;", "(A--B)"},
        {"a--b;", "(A--B)"},
        {"((a));", "A"},
        {"(a + b) * c;", "((A+B)*C)"},
        {"f(a, b:c);", "ERROR 1:1 F takes 1 argument, got 2"},
        {"f(-a) + f(!b);", "(CALL{-A}+CALL{!B})"},
        {"pi;", "3.14159"},
        {"a = b:c:d = 1;", "{(A=B):C:(D=1)}"},
        {"if (a, b : c, d);", "IF{A,{B:C},D}"},
        {"if (a, if (b, c), d = 1);", "IF{A,IF{B,C},(D=1)}"},
        {"for (a = 1, 1, 3, b = a : c = b);", "FOR{(A=1),1,3,{(B=A):(C=B)}}"},
        {"while (a < 3, a = a + 1);", "WHILE{(A<3),(A=(A+1))}"},
        {";", ""},
    };

    (void)state;
    TABLE(rows);
}

static void t_definitions(void **state)
{
    static const char *const rows[][2] = {
        {"g = function(): return = 1;", "G[0,1]:($0=1)"},
        {"g = function(x, y): return = x + y;", "G[2,3]:($2=($0+$1))"},
        {"g = function(x):t:u: t = x: u = t: return = u;",
         "G[1,4]:{($1=$0):($2=$1):($3=$2)}"},
        {"g = procedure(x): a = x;", "G[1,1]:(A=$0)"},
        {"sc = function(x): return = x;", "SC[1,2]:($1=$0)"},
        {"g = function(x, x): return = x;", "ERROR 1:17 X is a parameter"},
        {"g = function(x):x: return = x;", "ERROR 1:17 X is a parameter"},
        {"g = function(pi): return = 1;", "ERROR 1:14 PI is a predefined"},
        {"g = function(return): return = 1;", "ERROR 1:1 RETURN is a"},
        {"sin = function(x): return = x;", "ERROR 1:1 SIN is a built-in"},
        {"g = function(1): return = 1;", "ERROR 1:14 a parameter must be"},
        {"g = function(x) return = x;", "ERROR 1:17 expected ':' after"},
        {"g = function(x): return = g(x);", "ERROR 1:27 G calls itself"},
        {"a = 1: g = function(x): return = x;", "ERROR 1:12 a definition"},
    };

    (void)state;
    TABLE(rows);
}

static void t_errors(void **state)
{
    static const char *const rows[][2] = {
        {"a = 3 + * 4;", "ERROR 1:9 expected a value, found '*'"},
        {"a = ;", "ERROR 1:5 a value is missing before ';'"},
        {"a = 1:;", "ERROR 1:7 a value is missing before ';'"},
        {"a = (1;", "ERROR 1:7 expected ')', found ';'"},
        {"a = 1 2;", "ERROR 1:7 expected an operator or ';', found a number"},
        {"a = 1", "ERROR 1:6 the input ends inside a statement"},
        {"f(1;", "ERROR 1:4 expected ',' or ')', found ';'"},
        {"a + b = 1;", "ERROR 1:3 the left side of '='"},
        {"f(1) = 1;", "ERROR 1:1 the left side of '='"},
        {"pi = 1;", "ERROR 1:1 PI is a predefined constant"},
        {"nosuch(1);", "ERROR 1:1 undefined function NOSUCH"},
        {"sni(1);", "ERROR 1:1 undefined function SNI; did you mean SIN"},
        {"nosuch;", "ERROR 1:1 there is no variable NOSUCH"},
        {"if (0, a = nosuch);", "ERROR 1:12 there is no variable NOSUCH"},
        {"a = (b : c);", "ERROR 1:6 a value is expected here"},
        {"a = if (b, c);", "ERROR 1:5 IF is a statement"},
        {"a = free(b);", "ERROR 1:5 FREE is a procedure"},
        {"if (a);", "ERROR 1:1 IF takes a condition"},
        {"for (a = 1, 1, 2);", "ERROR 1:1 FOR takes 4 arguments, got 3"},
        {"while (1);", "ERROR 1:1 WHILE takes 2 arguments"},
        {"a = 1 + point(1, 2, 3);", "ERROR 1:7 operator + with a number"},
        {"if (\"x\", a = 1);", "ERROR 1:5 the condition of IF must be"},
        {"a = sin(\"x\");", "ERROR 1:9 argument 1 of SIN must be a number"},
        {"a = sin();", "ERROR 1:5 SIN takes 1 argument, got 0: SIN("},
        {"a = 1 +\n\n  2 2;", "ERROR 3:5 expected an operator"},
    };

    (void)state;
    TABLE(rows);
}

/* Nesting is bounded, chains are not. */
static void t_depth(void **state)
{
    static char text[300000], out[900000];
    static const struct {
        const char *head, *open, *tail;
        int n;
        bool fits;
    } rows[] = {
        {"a = ", "(", "1;", 200, false}, /* not closed */
        {"a = ", "-", "b;", 250, true},    {"a = ", "-", "b;", 257, false},
        {"a = ", "1+", "1;", 50000, true}, {"a = ", "2^", "1;", 50000, true},
        {"", "a=", "1;", 250, true},       {"", "a=", "1;", 257, false},
        {"", "a:", "1;", 50000, true},     {"a = ", "f(", "1;", 257, false},
    };
    session s;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx,
              session_run(&s, "a = b = 2; f = function(x): return = x;"));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *p = text + sprintf(text, "%s", rows[i].head);

        for (int k = 0; k < rows[i].n; k++)
            p += sprintf(p, "%s", rows[i].open);
        (void)strcpy(p, rows[i].tail);
        parsed(&s, text, out);
        if ((strncmp(out, "ERROR", 5) != 0) != rows[i].fits)
            fail_msg("%d x %s: %.60s", rows[i].n, rows[i].open, out);
    }
    session_close(&s);
}

/* --- random expressions ----------------------------------------------------
 */

/* The level of an operator: the loosest is 0. */
static int level_of(ix__op op)
{
    switch (op) {
    case OP_AND:
    case OP_OR:
        return 0;
    case OP_ADD:
    case OP_SUB:
        return 2;
    case OP_MUL:
    case OP_DIV:
        return 3;
    case OP_POW:
        return 4;
    default:
        return 1;
    }
}

/* Writes a random expression: into plain with as few parentheses as the
 * levels allow, into full with all. Returns its level, 5 for a primary. */
static int random_expression(ix_rng *rng, int depth, char *plain, char *full)
{
    static const ix__op ops[] = {OP_ADD, OP_SUB, OP_MUL, OP_DIV, OP_POW,
                                 OP_EQ,  OP_NE,  OP_LT,  OP_LE,  OP_GT,
                                 OP_GE,  OP_AND, OP_OR};
    char p[2][2000], f[2][2000];
    ix__op op = ops[ix_rng_int(rng, 0, 12)];
    int lv = level_of(op), side[2];

    if (depth == 0) {
        (void)sprintf(plain, "%d", ix_rng_int(rng, 0, 9));
        (void)strcpy(full, plain);
        return 5;
    }
    for (int i = 0; i < 2; i++)
        side[i] = random_expression(rng, depth - ix_rng_int(rng, 1, depth),
                                    p[i], f[i]);
    for (int i = 0; i < 2; i++) {
        bool inner = i == (lv <= 1); /* the side that may have this level */
        bool bare = side[i] > lv || (side[i] == lv && inner);

        (void)sprintf(plain + (i ? strlen(plain) : 0), "%s%s%s%s",
                      bare ? "" : "(", p[i], bare ? "" : ")",
                      i ? "" : ix__op_text(op));
    }
    (void)sprintf(full, "(%s%s%s)", f[0], ix__op_text(op), f[1]);
    return lv;
}

/* Law: an expression written with the fewest parentheses that the table of
 * levels and associativities allows is grouped as it was made. */
static void t_random_expressions(void **state)
{
    ix_rng rng = ix_rng_new(5);
    session s;

    (void)state;
    session_open(&s, NULL);
    for (int i = 0; i < 500; i++) {
        char plain[4000] = "", full[4000] = "", out[4000];

        (void)random_expression(&rng, 6, plain, full);
        strcat(plain, ";");
        parsed(&s, plain, out);
        if (strcmp(out, full) != 0)
            fail_msg("seed 5, round %d: %s\n  is   %s\n  want %s", i, plain,
                     out, full);
    }
    session_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(t_consequences),
        cmocka_unit_test(t_levels),
        cmocka_unit_test(t_definitions),
        cmocka_unit_test(t_errors),
        cmocka_unit_test(t_depth),
        cmocka_unit_test(t_random_expressions),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
