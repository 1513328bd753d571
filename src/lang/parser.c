/* parser.c - from tokens to the nodes of one statement.
 *
 * The grammar is spec/language 2: one table row per operator, one function
 * for all levels. Names are resolved here; whether they exist and whether the
 * types fit is decided in check.c once the statement is complete. */
#include <stdio.h>
#include <string.h>

#include "lang/interp_impl.h"
#include "lang/startup.h"

#define MAX_DEPTH  256
#define MAX_PARAMS 20

typedef struct {
    ix_interp *in;
    ix__reader *rd;
    ix__unit *u;
    bool dynamic;
    ix__token q[3]; /* read, but not consumed */
    int nq;
    ix__tok_kind last; /* the last token read */
    int depth;
    ix__checks checks;
    ix__fn *fn; /* being defined */
} parser;

/* A growing array of nodes in the unit. */
typedef struct {
    ix__node **item;
    int n, cap;
} nodes;

/* --- tokens
 * ---------------------------------------------------------------------- */

static const char *token_text(const ix__token *t, char buf[80])
{
    static const char *const text[] = {"the end of the input",
                                       "a number",
                                       "a string",
                                       "",
                                       "'('",
                                       "')'",
                                       "','",
                                       "':'",
                                       "';'"};

    if (t->kind == T_NAME)
        (void)snprintf(buf, 80, "%.60s", t->text);
    else if (t->kind == T_OP)
        (void)snprintf(buf, 80, "'%s'", ix__op_text(t->op));
    else
        return text[t->kind];
    return buf;
}

static ix_status syntax(parser *p, ix__pos pos, const char *text)
{
    (void)IX_FAIL(p->in->ctx, IX_EPARSE, "%s", text);
    return IX_AT(p->in, p->u, pos, IX_EPARSE);
}

/* The token k places ahead. */
static ix_status peek(parser *p, int k, ix__token **t)
{
    while (p->nq <= k) {
        IX_TRY(ix__lex(p->rd, p->u, &p->q[p->nq]));
        p->last = p->q[p->nq++].kind;
    }
    *t = &p->q[k];
    return IX_OK;
}

static ix_status next(parser *p, ix__token *t)
{
    ix__token *front;

    IX_TRY(peek(p, 0, &front));
    *t = *front;
    p->nq--;
    memmove(p->q, p->q + 1, (size_t)p->nq * sizeof *p->q);
    return IX_OK;
}

/* Consumes the next token if it is of this kind. */
static ix_status accept(parser *p, ix__tok_kind kind, bool *yes)
{
    ix__token *t, drop;

    IX_TRY(peek(p, 0, &t));
    *yes = t->kind == kind;
    return *yes ? next(p, &drop) : IX_OK;
}

static ix_status expect(parser *p, ix__tok_kind kind, const char *what)
{
    ix__token t;
    char buf[80], text[200];

    IX_TRY(next(p, &t));
    if (t.kind == kind)
        return IX_OK;
    (void)snprintf(text, sizeof text, "expected %s, found %s", what,
                   token_text(&t, buf));
    return syntax(p, t.pos, text);
}

/* --- nodes
 * ------------------------------------------------------------------------- */

static ix__node *node(parser *p, ix__kind kind, ix__pos pos)
{
    ix__node *n = ix__unit_alloc(p->u, sizeof *n);

    if (n) {
        n->kind = kind;
        n->pos = pos;
    }
    return n;
}

static ix_status push(parser *p, nodes *a, ix__node *n)
{
    if (a->n == a->cap) {
        int cap = a->cap ? 2 * a->cap : 4;
        ix__node **more = ix__unit_alloc(p->u, (size_t)cap * sizeof *more);

        if (!more)
            return IX_ENOMEM;
        if (a->n)
            memcpy(more, a->item, (size_t)a->n * sizeof *more);
        a->item = more;
        a->cap = cap;
    }
    a->item[a->n++] = n;
    return IX_OK;
}

/* A node with the given kids. */
static ix_status parent(parser *p, ix__kind kind, ix__pos pos, const nodes *a,
                        ix__node **out)
{
    *out = node(p, kind, pos);
    if (!*out)
        return IX_ENOMEM;
    (*out)->n = a->n;
    (*out)->kid = a->item;
    return IX_OK;
}

static ix_status enter(parser *p, ix__pos pos)
{
    if (++p->depth > MAX_DEPTH)
        return syntax(p, pos, "nested deeper than 256 levels");
    return IX_OK;
}

/* --- names
 * ---------------------------------------------------------------------------
 */

static ix_status variable(parser *p, const ix__token *t, ix__node **out)
{
    ix__node *n = node(p, N_GLOBAL, t->pos);
    int slot = p->fn ? ix__fn_slot(p->fn, t->text) : -1;

    *out = n;
    if (!n)
        return IX_ENOMEM;
    if (slot >= 0) {
        n->kind = N_LOCAL;
        n->u.slot = (size_t)slot;
    } else if (p->dynamic && ix__slot_outer(p->in, t->text, &n->u.slot)) {
        n->kind = N_OUTER;
    } else {
        n->u.sym = ix__sym_get(p->in, t->text);
    }
    return n->kind == N_GLOBAL && !n->u.sym ? IX_ENOMEM : IX_OK;
}

static ix_status name_value(parser *p, const ix__token *t, ix__node **out)
{
    double v;

    if (!ix__constant_find(t->text, &v))
        return variable(p, t, out);
    *out = node(p, N_NUM, t->pos);
    if (!*out)
        return IX_ENOMEM;
    (*out)->u.lit.num = v;
    (*out)->u.lit.constant = t->text;
    return IX_OK;
}

/* A variable named like a constant or a built-in cannot exist. */
static ix_status check_new_name(parser *p, const ix__token *t)
{
    char text[160];
    double v;

    if (!ix__constant_find(t->text, &v))
        return IX_OK;
    (void)snprintf(text, sizeof text,
                   "%.60s is a predefined constant; choose another name",
                   t->text);
    return syntax(p, t->pos, text);
}

static ix_status unknown_function(parser *p, const ix__token *t)
{
    char near[120], text[280];

    if (p->fn && strcmp(p->fn->name, t->text) == 0)
        (void)snprintf(text, sizeof text,
                       "%.60s calls itself before it exists; define it as a "
                       "dummy first: %.60s = function(...): return = 0;",
                       t->text, t->text);
    else if (strcmp(t->text, "FUNCTION") == 0 ||
             strcmp(t->text, "PROCEDURE") == 0)
        (void)snprintf(text, sizeof text,
                       "a definition must be a statement of its own: NAME = "
                       "%s(...): ...;",
                       t->text[0] == 'F' ? "function" : "procedure");
    else if (ix__names_near(p->in, t->text, near, sizeof near))
        (void)snprintf(text, sizeof text,
                       "undefined function %.60s; did you mean %s?", t->text,
                       near);
    else
        (void)snprintf(text, sizeof text, "undefined function %.60s", t->text);
    return syntax(p, t->pos, text);
}

/* What a call of this name calls. */
static ix_status callee(parser *p, const ix__token *t, ix__node *n)
{
    static const struct {
        const char *name;
        ix__kind kind;
    } control[] = {{"IF", N_IF}, {"FOR", N_FOR}, {"WHILE", N_WHILE}};
    ix__sym *s;

    for (size_t i = 0; i < 3; i++) {
        if (strcmp(control[i].name, t->text) == 0) {
            n->kind = control[i].kind;
            return IX_OK;
        }
    }
    IX_TRY(ix__fn_lookup(p->in, t->text, &s));
    if (s) {
        n->kind = N_USER;
        n->u.sym = s;
        p->checks.calls = true;
        return IX_OK;
    }
    n->u.bi = ix__bi_find(t->text);
    if (!n->u.bi || !(n->u.bi->row->fn || n->u.bi->ext))
        return unknown_function(p, t);
    p->checks.calls = p->checks.calls || strcmp(t->text, "EXEC") == 0;
    return IX_OK;
}

/* --- expressions
 * ------------------------------------------------------------------------ */

static ix_status sequence(parser *p, ix__node **out); /* recursion */

static ix_status arguments(parser *p, nodes *args)
{
    bool more;

    IX_TRY(accept(p, T_RPAREN, &more));
    if (more)
        return IX_OK;
    do {
        ix__node *a;

        IX_TRY(sequence(p, &a));
        IX_TRY(push(p, args, a));
        IX_TRY(accept(p, T_COMMA, &more));
    } while (more);
    return expect(p, T_RPAREN, "',' or ')'");
}

static ix_status call(parser *p, const ix__token *name, ix__node **out)
{
    nodes args = {NULL, 0, 0};
    ix__token paren;
    ix__node *n = node(p, N_CALL, name->pos);

    *out = n;
    if (!n)
        return IX_ENOMEM;
    IX_TRY(callee(p, name, n));
    IX_TRY(next(p, &paren));
    IX_TRY(enter(p, paren.pos));
    IX_TRY(arguments(p, &args));
    p->depth--;
    n->kid = args.item;
    n->n = args.n;
    return IX_OK;
}

static ix_status literal(parser *p, const ix__token *t, ix__node **out)
{
    *out = node(p, t->kind == T_NUMBER ? N_NUM : N_STR, t->pos);
    if (!*out)
        return IX_ENOMEM;
    if (t->kind == T_NUMBER) {
        (*out)->u.lit.num = t->num;
    } else {
        (*out)->u.str.s = t->text;
        (*out)->u.str.len = t->len;
    }
    return IX_OK;
}

static ix_status unexpected(parser *p, const ix__token *t)
{
    char buf[80], text[200];

    if (t->kind == T_SEMICOLON || t->kind == T_COLON)
        (void)snprintf(text, sizeof text, "a value is missing before %s",
                       token_text(t, buf));
    else if (t->kind == T_END)
        (void)snprintf(text, sizeof text,
                       "the input ends inside a statement (a ';' is missing)");
    else
        (void)snprintf(text, sizeof text, "expected a value, found %s",
                       token_text(t, buf));
    return syntax(p, t->pos, text);
}

static ix_status primary(parser *p, ix__node **out)
{
    ix__token t, *after;

    IX_TRY(next(p, &t));
    if (t.kind == T_NUMBER || t.kind == T_STRING)
        return literal(p, &t, out);
    if (t.kind == T_NAME) {
        IX_TRY(peek(p, 0, &after));
        return after->kind == T_LPAREN ? call(p, &t, out)
                                       : name_value(p, &t, out);
    }
    if (t.kind != T_LPAREN)
        return unexpected(p, &t);
    IX_TRY(enter(p, t.pos));
    IX_TRY(sequence(p, out));
    p->depth--;
    return expect(p, T_RPAREN, "')'");
}

static ix_status unary(parser *p, ix__node **out)
{
    nodes operand = {NULL, 0, 0};
    ix__token *t, op;

    IX_TRY(peek(p, 0, &t));
    if (t->kind != T_OP || (t->op != OP_SUB && t->op != OP_NOT))
        return primary(p, out);
    IX_TRY(next(p, &op));
    IX_TRY(enter(p, op.pos));
    IX_TRY(unary(p, out));
    p->depth--;
    if (op.op == OP_SUB && (*out)->kind == N_NUM) {
        (*out)->u.lit.num = -(*out)->u.lit.num;
        return IX_OK;
    }
    IX_TRY(push(p, &operand, *out));
    return parent(p, op.op == OP_SUB ? N_NEG : N_NOT, op.pos, &operand, out);
}

/* The binary operators, loosest first; assignment is one of the comparisons. */
typedef enum { LOGIC, COMPARISON, SUM, TERM, POWER, UNARY } level;
static const struct {
    level level;
    bool right; /* associative to the right */
} grammar[] = {
    [OP_AND] = {LOGIC, true},         [OP_OR] = {LOGIC, true},
    [OP_ASSIGN] = {COMPARISON, true}, [OP_EQ] = {COMPARISON, true},
    [OP_NE] = {COMPARISON, true},     [OP_LT] = {COMPARISON, true},
    [OP_LE] = {COMPARISON, true},     [OP_GT] = {COMPARISON, true},
    [OP_GE] = {COMPARISON, true},     [OP_ADD] = {SUM, false},
    [OP_SUB] = {SUM, false},          [OP_MUL] = {TERM, false},
    [OP_DIV] = {TERM, false},         [OP_POW] = {POWER, false},
};

/* The next token is a binary operator of this level. */
static ix_status at_level(parser *p, level lv, bool *yes)
{
    ix__token *t;

    IX_TRY(peek(p, 0, &t));
    *yes = t->kind == T_OP && t->op != OP_NOT && grammar[t->op].level == lv;
    return IX_OK;
}

static ix_status check_target(parser *p, const ix__node *n)
{
    char text[160];

    if (ix__node_is_var(n)) {
        if (n->kind == N_GLOBAL)
            n->u.sym->parsed = p->checks.parse_no;
        return IX_OK;
    }
    if (n->kind == N_NUM && n->u.lit.constant)
        (void)snprintf(text, sizeof text,
                       "%.60s is a predefined constant; it cannot be assigned",
                       n->u.lit.constant);
    else
        (void)snprintf(text, sizeof text,
                       "the left side of '=' must be a plain variable name "
                       "(to compare write '==')");
    return syntax(p, n->pos, text);
}

static ix_status binary(parser *p, level lv, ix__node **out); /* recursion */

/* a = b = c: the rest of the line is the right operand. */
static ix_status right_side(parser *p, level lv, ix__node *left, ix__node **out)
{
    nodes pair = {NULL, 0, 0};
    ix__token op;
    ix__node *right;

    IX_TRY(next(p, &op));
    if (op.op == OP_ASSIGN)
        IX_TRY(check_target(p, left));
    IX_TRY(enter(p, op.pos));
    IX_TRY(binary(p, lv, &right));
    p->depth--;
    IX_TRY(push(p, &pair, left));
    IX_TRY(push(p, &pair, right));
    IX_TRY(parent(p, op.op == OP_ASSIGN ? N_ASSIGN : N_BINARY, op.pos, &pair,
                  out));
    (*out)->op = op.op;
    return IX_OK;
}

/* One more operator of a chain. */
static ix_status push_op(parser *p, const ix__token *t, ix__step **steps, int n)
{
    ix__step *s = *steps;

    if ((n & (n - 1)) == 0) { /* room for 1, 2, 4, ... */
        s = ix__unit_alloc(p->u, (n ? 2 * (size_t)n : 1) * sizeof *s);
        if (!s)
            return IX_ENOMEM;
        if (n)
            memcpy(s, *steps, (size_t)n * sizeof *s);
        *steps = s;
    }
    s[n] = (ix__step){t->op, t->pos};
    return IX_OK;
}

/* a - b - c, in one node however long it is. */
static ix_status left_chain(parser *p, level lv, ix__node *first,
                            ix__node **out)
{
    nodes operands = {NULL, 0, 0};
    ix__step *steps = NULL;
    bool more = true;

    IX_TRY(push(p, &operands, first));
    while (more) {
        ix__token op;
        ix__node *n;

        IX_TRY(next(p, &op));
        IX_TRY(push_op(p, &op, &steps, operands.n - 1));
        IX_TRY(binary(p, lv + 1, &n));
        IX_TRY(push(p, &operands, n));
        IX_TRY(at_level(p, lv, &more));
    }
    IX_TRY(parent(p, operands.n == 2 ? N_BINARY : N_CHAIN, steps[0].pos,
                  &operands, out));
    if (operands.n == 2)
        (*out)->op = steps[0].op;
    else
        (*out)->u.steps = steps;
    return IX_OK;
}

static ix_status binary(parser *p, level lv, ix__node **out)
{
    bool yes;

    if (lv == UNARY)
        return unary(p, out);
    IX_TRY(binary(p, lv + 1, out));
    IX_TRY(at_level(p, lv, &yes));
    if (!yes)
        return IX_OK;
    return lv <= COMPARISON ? right_side(p, lv, *out, out)
                            : left_chain(p, lv, *out, out);
}

/* Elements separated by ':'. */
static ix_status sequence(parser *p, ix__node **out)
{
    nodes parts = {NULL, 0, 0};
    bool more;

    do {
        IX_TRY(binary(p, LOGIC, out));
        IX_TRY(push(p, &parts, *out));
        IX_TRY(accept(p, T_COLON, &more));
    } while (more);
    if (parts.n == 1)
        return IX_OK;
    return parent(p, N_SEQ, parts.item[0]->pos, &parts, out);
}

/* --- definitions
 * ---------------------------------------------------------------------------
 */

static ix_status add_slot(parser *p, const ix__token *t)
{
    ix__fn *fn = p->fn;
    char text[160];

    IX_TRY(check_new_name(p, t));
    if (ix__fn_slot(fn, t->text) >= 0) {
        (void)snprintf(text, sizeof text,
                       "%.60s is a parameter or local of %.60s already",
                       t->text, fn->name);
        return syntax(p, t->pos, text);
    }
    return ix__fn_add_slot(fn, t->text);
}

static ix_status parameters(parser *p)
{
    bool done;

    IX_TRY(expect(p, T_LPAREN, "'('"));
    IX_TRY(accept(p, T_RPAREN, &done));
    while (!done) {
        ix__token t;
        bool more;

        IX_TRY(next(p, &t));
        if (t.kind != T_NAME)
            return syntax(p, t.pos, "a parameter must be a plain name");
        if (p->fn->nparams == MAX_PARAMS)
            return syntax(p, t.pos, "more than 20 parameters");
        IX_TRY(add_slot(p, &t));
        p->fn->nparams++;
        IX_TRY(accept(p, T_COMMA, &more));
        if (!more)
            IX_TRY(expect(p, T_RPAREN, "',' or ')'"));
        done = !more;
    }
    return IX_OK;
}

/* Bare names, each followed by ':'. */
static ix_status locals(parser *p)
{
    for (;;) {
        ix__token *name, *colon, t;

        IX_TRY(peek(p, 0, &name));
        if (name->kind != T_NAME)
            return IX_OK;
        IX_TRY(peek(p, 1, &colon));
        if (colon->kind != T_COLON)
            return IX_OK;
        IX_TRY(next(p, &t));
        IX_TRY(add_slot(p, &t));
        IX_TRY(next(p, &t));
    }
}

static ix_status function_name(parser *p, const ix__token *t)
{
    const ix__bi *bi = ix__bi_find(t->text);
    char text[160];

    IX_TRY(check_new_name(p, t));
    if (!bi || bi->row->flags & IX_B_LIBRARY)
        return IX_OK;
    (void)snprintf(text, sizeof text,
                   "%.60s is a built-in function; choose another name",
                   t->text);
    return syntax(p, t->pos, text);
}

/* NAME = FUNCTION(parameters):locals: body */
static ix_status definition(parser *p, ix__node **out)
{
    ix__token name, assign, kind, result = {.text = "RETURN"};
    ix__fn *fn = ix__unit_alloc(p->u, sizeof *fn);
    const ix__sym *s;

    if (!fn)
        return IX_ENOMEM;
    IX_TRY(next(p, &name));
    IX_TRY(next(p, &assign));
    IX_TRY(next(p, &kind));
    IX_TRY(function_name(p, &name));
    fn->unit = p->u;
    s = ix__sym_get(p->in, name.text);
    if (!s)
        return IX_ENOMEM;
    fn->name = s->name; /* traces outlive the unit */
    fn->pos = name.pos;
    fn->is_procedure = kind.text[0] == 'P';
    p->fn = fn;
    p->checks.fn = fn;
    IX_TRY(parameters(p));
    IX_TRY(expect(p, T_COLON, "':' after the header"));
    IX_TRY(locals(p));
    result.pos = name.pos;
    fn->result = fn->nslots;
    if (!fn->is_procedure)
        IX_TRY(add_slot(p, &result));
    IX_TRY(sequence(p, &fn->body));
    *out = node(p, N_FUNDEF, name.pos);
    if (!*out)
        return IX_ENOMEM;
    (*out)->u.fn = fn;
    return IX_OK;
}

/* NAME = FUNCTION ... or NAME = PROCEDURE ... follows. */
static ix_status at_definition(parser *p, bool *yes)
{
    ix__token *t;

    *yes = false;
    IX_TRY(peek(p, 0, &t));
    if (t->kind != T_NAME)
        return IX_OK;
    IX_TRY(peek(p, 1, &t));
    if (t->kind != T_OP || t->op != OP_ASSIGN)
        return IX_OK;
    IX_TRY(peek(p, 2, &t));
    *yes = t->kind == T_NAME && (strcmp(t->text, "FUNCTION") == 0 ||
                                 strcmp(t->text, "PROCEDURE") == 0);
    return IX_OK;
}

/* --- statements
 * ------------------------------------------------------------------------------
 */

static ix_status terminator(parser *p)
{
    ix__token *t;

    IX_TRY(peek(p, 0, &t));
    if (t->kind == T_END && p->rd->add_semicolon)
        return IX_OK;
    if (t->kind == T_END)
        return unexpected(p, t);
    return expect(p, T_SEMICOLON, "an operator or ';'");
}

static ix_status statement(parser *p, ix__node **out, bool *end)
{
    ix__token *t, drop;
    bool def;

    IX_TRY(ix__lex_begin(p->rd, p->u));
    p->rd->inside = false;
    IX_TRY(peek(p, 0, &t));
    p->rd->inside = true;
    *end = t->kind == T_END;
    if (*end)
        return IX_OK;
    if (t->kind == T_SEMICOLON)
        return next(p, &drop);
    IX_TRY(at_definition(p, &def));
    IX_TRY(def ? definition(p, out) : sequence(p, out));
    return terminator(p);
}

ix_status ix__parse(ix_interp *in, ix__reader *rd, ix__unit *u, bool dynamic,
                    ix__node **out, bool *end)
{
    parser p = {.in = in, .rd = rd, .u = u, .dynamic = dynamic};
    ix_status st;

    p.checks.parse_no = ++in->parse_no;
    *out = NULL;
    *end = false;
    st = statement(&p, out, end);
    if (st != IX_OK && p.last != T_SEMICOLON)
        ix__lex_skip(rd);
    if (st == IX_OK && *out)
        st = ix__check(in, u, &p.checks, *out);
    return st;
}

/* --- functions by name
 * -------------------------------------------------------------------------- */

static ix_status compile_startup(ix_interp *in, const char *text)
{
    ix__unit *u = ix__unit_new(in->ctx);
    ix__reader rd;
    ix__node *n = NULL;
    bool end;
    ix_status st;

    if (!u)
        return IX_ENOMEM;
    ix__reader_init(&rd, in);
    rd.add_semicolon = true;
    ix__reader_push_text(&rd, "<start-up>", text, strlen(text));
    st = ix__parse(in, &rd, u, false, &n, &end);
    if (st == IX_OK && n && n->kind == N_FUNDEF) {
        n->u.fn->is_startup = true;
        st = ix__fn_define(in, n->u.fn);
    }
    ix__reader_free(&rd);
    ix__unit_unref(u);
    return st;
}

ix_status ix__fn_lookup(ix_interp *in, const char *name, ix__sym **out)
{
    ix__sym *s = ix__sym_find(in, name);
    const ix__startup_fn *f;

    *out = s && s->fn ? s : NULL;
    if (*out || (s && s->no_startup) || ix__bi_find(name))
        return IX_OK;
    f = ix__startup_find(name);
    if (!f)
        return IX_OK;
    IX_TRY(compile_startup(in, f->text));
    *out = ix__sym_find(in, name);
    return IX_OK;
}
