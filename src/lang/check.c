/* check.c - the static check of a parsed statement.
 *
 * It runs over the whole statement, branches that will not be taken included,
 * before anything of it runs: names that do not exist, procedures used as
 * values, argument counts, and types as far as they are known. A type is a
 * set; a variable that the statement may change has any type. */
#include <stdio.h>
#include <string.h>

#include "lang/call.h"
#include "lang/interp_impl.h"

typedef struct {
    ix_interp *in;
    ix__unit *u;
    const ix__checks *c;
} checker;

#define FAIL(k, n, ...) IX_FAIL_AT((k)->in, (k)->u, (n)->pos, __VA_ARGS__)

static ix_status value(checker *k, ix__node *n, ix__types *t); /* recursion */
static ix_status statement(checker *k, ix__node *n);

/* --- variables
 * ---------------------------------------------------------------------- */

/* A name in a function body that exists nowhere and is never assigned: reported
 * once, fails when it is used. */
static void unbound(checker *k, ix__node *n)
{
    char text[400];

    n->kind = N_UNBOUND;
    if (n->u.sym->parsed == ~k->c->parse_no)
        return;
    n->u.sym->parsed = ~k->c->parse_no;
    (void)snprintf(text, sizeof text,
                   "%s uses %s, which is neither a parameter, a local nor an "
                   "existing variable; define it before the function",
                   k->c->fn->name, n->u.sym->name);
    ix__complain(k->in, k->u, n->pos, true, text);
}

/* One that the body assigns is a local that was not declared. */
static ix_status undeclared(checker *k, ix__node *n)
{
    ix__fn *fn = k->c->fn;
    const char *name = n->u.sym->name;
    int slot = ix__fn_slot(fn, name);
    char text[400];

    if (slot < 0) {
        slot = fn->nslots;
        IX_TRY(ix__fn_add_slot(fn, name));
        (void)snprintf(text, sizeof text,
                       "%s is taken as a local of %s, for there is no such "
                       "variable; declare it: %s = %s(...):%s:",
                       name, fn->name, fn->name,
                       fn->is_procedure ? "procedure" : "function", name);
        ix__complain(k->in, k->u, n->pos, false, text);
    }
    n->kind = N_LOCAL;
    n->u.slot = (size_t)slot;
    return IX_OK;
}

static ix_status missing(checker *k, const ix__node *n)
{
    const char *name = n->u.sym->name;
    char near[200];

    if (ix__vars_near(k->in, name, near, sizeof near))
        return FAIL(k, n, "there is no variable %s; did you mean %s?", name,
                    near);
    return FAIL(k, n, "there is no variable %s", name);
}

static ix_status variable(checker *k, ix__node *n, ix__types *t)
{
    const ix__sym *s = n->u.sym;
    bool exists, assigned;

    *t = IX_T_ANY;
    if (n->kind != N_GLOBAL)
        return IX_OK;
    exists = s->box || (k->in->opt.check_only && s->declared);
    assigned = s->parsed == k->c->parse_no;
    if (k->c->fn) {
        if (!exists && assigned)
            return undeclared(k, n);
        if (!exists && k->in->opt.strict)
            return missing(k, n);
        if (!exists)
            unbound(k, n);
        return IX_OK;
    }
    if (!exists && !assigned)
        return missing(k, n);
    if (assigned || k->c->calls)
        return IX_OK;
    *t = s->box ? 1u << s->box->type : s->declared;
    return IX_OK;
}

static ix_status assignment(checker *k, ix__node *n, ix__types *t)
{
    ix__node *target = n->kid[0];
    ix__types old;

    IX_TRY(value(k, n->kid[1], t));
    if (target->kind != N_GLOBAL)
        return IX_OK;
    if (k->c->fn)
        return variable(k, target, &old);
    if (k->in->opt.check_only)
        target->u.sym->declared |= *t;
    return IX_OK;
}

/* --- operators
 * ------------------------------------------------------------------------ */

static ix_status operand_types(checker *k, ix__op op, ix__pos pos, ix__types l,
                               ix__types r, ix__types *t)
{
    *t = ix__op_types(op, l, r);
    if (*t)
        return IX_OK;
    (void)ix__op_mismatch(k->in, op, l, r);
    return IX_AT(k->in, k->u, pos, IX_EARG);
}

static ix_status chain(checker *k, ix__node *n, ix__types *t)
{
    ix__types r;

    IX_TRY(value(k, n->kid[0], t));
    for (int i = 1; i < n->n; i++) {
        const ix__step *s = &n->u.steps[i - 1];

        IX_TRY(value(k, n->kid[i], &r));
        IX_TRY(operand_types(k, s->op, s->pos, *t, r, t));
    }
    return IX_OK;
}

static ix_status binary(checker *k, ix__node *n, ix__types *t)
{
    ix__types l, r;

    IX_TRY(value(k, n->kid[0], &l));
    IX_TRY(value(k, n->kid[1], &r));
    return operand_types(k, n->op, n->pos, l, r, t);
}

static ix_status unary(checker *k, ix__node *n, ix__types *t)
{
    ix__types a;

    IX_TRY(value(k, n->kid[0], &a));
    return operand_types(k, n->kind == N_NEG ? OP_NEG : OP_NOT, n->pos, a, a,
                         t);
}

/* --- calls
 * -------------------------------------------------------------------------------
 */

static ix_status builtin_call(checker *k, ix__node *n)
{
    const ix__sig *s = &n->u.bi->sig;
    ix_status st = ix__call_count(k->in->ctx, n->u.bi, n->n);

    if (st != IX_OK)
        return IX_AT(k->in, k->u, n->pos, st);
    for (int i = 0; i < n->n; i++) {
        ix__types t;

        IX_TRY(value(k, n->kid[i], &t));
        if (!(t & ix__sig_arg(s, i))) {
            (void)ix__arg_mismatch(k->in, n->u.bi, i, t);
            return IX_AT(k->in, k->u, n->kid[i]->pos, IX_EARG);
        }
    }
    return IX_OK;
}

static ix_status user_call(checker *k, ix__node *n)
{
    const ix__fn *fn = n->u.sym->fn;

    if (n->n != fn->nparams)
        return FAIL(k, n, "%s takes %d argument%s, got %d", fn->name,
                    fn->nparams, fn->nparams == 1 ? "" : "s", n->n);
    for (int i = 0; i < n->n; i++) {
        ix__types t;

        IX_TRY(value(k, n->kid[i], &t));
    }
    return IX_OK;
}

/* --- values
 * ------------------------------------------------------------------------------
 */

static ix_status no_value(checker *k, const ix__node *n)
{
    static const char *const word[] = {
        [N_IF] = "IF", [N_FOR] = "FOR", [N_WHILE] = "WHILE"};

    if (n->kind == N_SEQ)
        return FAIL(k, n, "a value is expected here; ':' separates statements");
    if (n->kind == N_CALL)
        return FAIL(k, n, "%s is a procedure: it gives no value",
                    n->u.bi->row->name);
    if (n->kind == N_USER)
        return FAIL(k, n, "%s is a procedure: it gives no value",
                    n->u.sym->name);
    return FAIL(k, n, "%s is a statement: it gives no value", word[n->kind]);
}

static ix_status value(checker *k, ix__node *n, ix__types *t)
{
    *t = IX_T_ANY;
    switch (n->kind) {
    case N_NUM:
        *t = IX_T(NUMBER);
        return IX_OK;
    case N_STR:
        *t = IX_T(STRING);
        return IX_OK;
    case N_GLOBAL:
    case N_LOCAL:
    case N_OUTER:
    case N_UNBOUND:
        return variable(k, n, t);
    case N_NEG:
    case N_NOT:
        return unary(k, n, t);
    case N_BINARY:
        return binary(k, n, t);
    case N_CHAIN:
        return chain(k, n, t);
    case N_ASSIGN:
        return assignment(k, n, t);
    case N_CALL:
        if (!n->u.bi->sig.result)
            return no_value(k, n);
        *t = n->u.bi->sig.result;
        return builtin_call(k, n);
    case N_USER:
        if (n->u.sym->fn->is_procedure)
            return no_value(k, n);
        return user_call(k, n);
    default:
        return no_value(k, n);
    }
}

/* --- statements
 * ----------------------------------------------------------------------------
 */

static ix_status number(checker *k, ix__node *n, const char *what)
{
    ix__types t;
    char buf[200];

    IX_TRY(value(k, n, &t));
    if (t & IX_T(NUMBER))
        return IX_OK;
    return FAIL(k, n, "%s must be a number, got %s", what,
                ix__types_text(t, buf, sizeof buf));
}

static ix_status if_statement(checker *k, ix__node *n)
{
    if (n->n != 2 && n->n != 3)
        return FAIL(k, n,
                    "IF takes a condition and one or two branches, got %d "
                    "arguments: if (condition, then [, else])",
                    n->n);
    IX_TRY(number(k, n->kid[0], "the condition of IF"));
    for (int i = 1; i < n->n; i++)
        IX_TRY(statement(k, n->kid[i]));
    return IX_OK;
}

static ix_status for_statement(checker *k, ix__node *n)
{
    if (n->n != 4)
        return FAIL(k, n,
                    "FOR takes 4 arguments, got %d: for (i = first, increment, "
                    "last, body)",
                    n->n);
    IX_TRY(number(k, n->kid[0], "the first value of FOR"));
    IX_TRY(number(k, n->kid[1], "the increment of FOR"));
    IX_TRY(number(k, n->kid[2], "the last value of FOR"));
    return statement(k, n->kid[3]);
}

static ix_status while_statement(checker *k, ix__node *n)
{
    if (n->n != 2)
        return FAIL(k, n,
                    "WHILE takes 2 arguments, got %d: while (condition, body)",
                    n->n);
    IX_TRY(number(k, n->kid[0], "the condition of WHILE"));
    return statement(k, n->kid[1]);
}

static ix_status statement(checker *k, ix__node *n)
{
    ix__types t;

    switch (n->kind) {
    case N_SEQ:
        for (int i = 0; i < n->n; i++)
            IX_TRY(statement(k, n->kid[i]));
        return IX_OK;
    case N_IF:
        return if_statement(k, n);
    case N_FOR:
        return for_statement(k, n);
    case N_WHILE:
        return while_statement(k, n);
    case N_FUNDEF:
        return statement(k, n->u.fn->body);
    case N_CALL:
        return builtin_call(k, n);
    case N_USER:
        return user_call(k, n);
    default:
        return value(k, n, &t);
    }
}

ix_status ix__check(ix_interp *in, ix__unit *u, const ix__checks *c,
                    ix__node *n)
{
    checker k = {in, u, c};

    return statement(&k, n);
}
