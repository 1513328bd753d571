/* exec.c - statements: assignment, printing, branches, loops, definitions.
 *
 * A soft failure (spec/language 9) of the call that is a whole statement, or
 * a whole right side, is reported here and the script goes on; anywhere else
 * it stops the script like any other failure. */
#include <assert.h>
#include <math.h>
#include <string.h>

#include "lang/interp_impl.h"

/* The counter of FOR has reached the last value within this (spec/language
 * 6). */
#define FOR_EPS 1e-5

ix_status ix__tick(ix_interp *in)
{
    in->step++;
    if (in->opt.steps && in->step > in->opt.steps)
        return IX_FAIL(in->ctx, IX_ECANCEL,
                       "the limit of %lu steps is used up (--max-steps)",
                       in->opt.steps);
    if (in->out_errno)
        return IX_FAIL(in->ctx, IX_EIO, "cannot write the output: %s",
                       strerror(in->out_errno));
    return ix__poll(in->ctx);
}

/* The failure is a soft one of n itself: it has been reported now. */
static bool softened(ix_interp *in, const ix__node *n)
{
    if (!in->soft || in->soft_node != n || in->opt.strict)
        return false;
    ix__report(in, true);
    return true;
}

/* --- assignment
 * --------------------------------------------------------------------- */

/* The right side gave no value: the variable is not defined any more. */
static void undefine(ix_interp *in, const ix__node *target)
{
    ix_obj **slot = ix__node_slot(in, target);

    ix__obj_unref(in->ctx, *slot);
    *slot = NULL;
}

static ix_status store(ix_interp *in, const ix__node *target, ix__val *v)
{
    ix_obj **slot = ix__node_slot(in, target);
    const char *name = target->kind == N_GLOBAL ? target->u.sym->name : NULL;

    if (!v->o)
        return ix__slot_number(in, slot, name, v->num);
    return ix__slot_take(in, slot, name, v->o);
}

/* The value of the right side: a variable's own box, for its attributes. */
static ix_status right_side(ix_interp *in, ix__node *n, ix__val *v)
{
    ix_obj *box;

    *v = (ix__val){NULL, 0, false};
    if (n->kind == N_ASSIGN) {
        IX_TRY(ix__assign(in, n));
        n = n->kid[0];
    }
    if (!ix__node_is_var(n))
        return ix__eval_maybe(in, n, v);
    IX_TRY(ix__node_var_box(in, n, &box));
    if (box->type == IX_OBJ_NUMBER && !box->attrs)
        v->num = box->u.num;
    else
        v->o = ix__obj_ref(box);
    return IX_OK;
}

ix_status ix__assign(ix_interp *in, ix__node *n)
{
    const ix__node *target = n->kid[0];
    ix__val v;
    ix_status st;

    assert(target->kind != N_UNBOUND); /* see check.c */
    st = right_side(in, n->kid[1], &v);
    if (st != IX_OK && !softened(in, n->kid[1]))
        return st;
    if (st == IX_OK && !v.none)
        return store(in, target, &v);
    undefine(in, target);
    return IX_OK;
}

/* --- printing
 * ------------------------------------------------------------------------- */

/* References to the value besides ours, as the header line shows them; a
 * literal belongs to nobody. */
static int holders(const ix__node *n, const ix_obj *o)
{
    return n->kind == N_NUM || n->kind == N_STR ? 0 : o->refs - 1;
}

static ix_status print(ix_interp *in, ix__node *n)
{
    ix_obj *o;
    ix_status st;

    if (n->kind == N_CALL) { /* may give no value */
        ix__val v;

        IX_TRY(ix__eval_maybe(in, n, &v));
        if (v.none)
            return IX_OK;
        o = v.o ? v.o : ix__obj_number(in->ctx, v.num);
        if (!o)
            return IX_ENOMEM;
    } else {
        IX_TRY(ix__eval_box(in, n, &o));
    }
    st = ix__print_value(in, o, holders(n, o));
    ix__obj_unref(in->ctx, o);
    return st == IX_OK ? st : IX_AT(in, in->unit, n->pos, st);
}

/* --- branches and loops
 * ------------------------------------------------------------------ */

static ix_status if_statement(ix_interp *in, ix__node *n)
{
    double c;

    IX_TRY(ix__eval_num(in, n->kid[0], "the condition of IF", &c));
    if (ix__truth(c))
        return ix__exec(in, n->kid[1]);
    return n->n > 2 ? ix__exec(in, n->kid[2]) : IX_OK;
}

static ix_status while_statement(ix_interp *in, ix__node *n)
{
    for (;;) {
        double c;

        IX_TRY(ix__eval_num(in, n->kid[0], "the condition of WHILE", &c));
        /* Values in about (-1.5, 0.5) count as false here (spec/language 6);
         * NaN, too. */
        if (!(c + 0.5 >= 1 || c + 0.5 <= -1))
            return IX_OK;
        IX_TRY(ix__exec(in, n->kid[1])); /* counts the step */
    }
}

typedef struct {
    const ix__node *var; /* NULL: anonymous counter */
    double value, inc, end;
} loop;

static ix_status loop_begin(ix_interp *in, ix__node *n, loop *l)
{
    ix__node *init = n->kid[0];

    l->var = NULL;
    if (init->kind == N_ASSIGN)
        l->var = init->kid[0];
    else if (ix__node_is_var(init))
        l->var = init;
    IX_TRY(ix__eval_num(in, init, "the first value of FOR", &l->value));
    IX_TRY(ix__eval_num(in, n->kid[1], "the increment of FOR", &l->inc));
    IX_TRY(ix__eval_num(in, n->kid[2], "the last value of FOR", &l->end));
    if (l->inc == 0)
        return IX_FAIL_AT(in, in->unit, n->kid[1]->pos,
                          "the increment of FOR must not be 0");
    return IX_OK;
}

static bool loop_goes_on(const loop *l)
{
    if (fabs(l->value - l->end) < FOR_EPS)
        return true;
    return l->inc > 0 ? l->value <= l->end : l->value >= l->end;
}

/* The counter's next value; changes by the body are overwritten. */
static ix_status loop_step(ix_interp *in, const ix__node *n, loop *l)
{
    double next = l->value + l->inc;
    ix_obj *box;

    if (next == l->value)
        return IX_FAIL_AT(in, in->unit, n->kid[1]->pos,
                          "the increment %g of FOR is too small: %.17g does "
                          "not change any more",
                          l->inc, l->value);
    l->value = next;
    if (!l->var)
        return IX_OK;
    box = *ix__node_slot(in, l->var);
    if (!box || box->type != IX_OBJ_NUMBER)
        return IX_FAIL_AT(in, in->unit, l->var->pos,
                          "the counter %s of FOR was %s by the loop's body",
                          ix__node_name(in, l->var),
                          box ? "given another type" : "freed");
    if (loop_goes_on(l))
        box->u.num = next;
    return IX_OK;
}

static ix_status for_statement(ix_interp *in, ix__node *n)
{
    bool outer = !(in->ctx->part >= 0); /* its rounds are the progress */
    double first;
    loop l;

    IX_TRY(loop_begin(in, n, &l));
    first = l.value;
    while (loop_goes_on(&l)) {
        if (outer)
            ix__progress(in->ctx, NULL, (l.value - first) / (l.end - first));
        IX_TRY(ix__exec(in, n->kid[3])); /* counts the step */
        IX_TRY(loop_step(in, n, &l));
    }
    if (outer)
        ix__progress(in->ctx, NULL, -1);
    return IX_OK;
}

/* --- statements
 * ------------------------------------------------------------------------------
 */

static ix_status run_call(ix_interp *in, ix__node *n)
{
    bool procedure = n->kind == N_CALL
                         ? !n->u.bi->sig.result
                         : n->u.sym->fn && n->u.sym->fn->is_procedure;
    ix__val v;

    if (!procedure)
        return print(in, n);
    IX_TRY(ix__eval_maybe(in, n, &v));
    ix__obj_unref(in->ctx, v.o); /* there is none, as a rule */
    return IX_OK;
}

static ix_status sequence(ix_interp *in, ix__node *n)
{
    for (int i = 0; i < n->n; i++)
        IX_TRY(ix__exec(in, n->kid[i]));
    return IX_OK;
}

ix_status ix__exec(ix_interp *in, ix__node *n)
{
    ix_status st = ix__tick(in);

    if (st != IX_OK)
        return IX_AT(in, in->unit, n->pos, st);
    switch (n->kind) {
    case N_SEQ:
        return sequence(in, n);
    case N_ASSIGN:
        return ix__assign(in, n);
    case N_IF:
        return if_statement(in, n);
    case N_FOR:
        return for_statement(in, n);
    case N_WHILE:
        return while_statement(in, n);
    case N_FUNDEF:
        return ix__fn_define(in, n->u.fn);
    case N_CALL:
    case N_USER:
        st = run_call(in, n);
        return st != IX_OK && softened(in, n) ? IX_OK : st;
    default:
        return print(in, n);
    }
}
