/* eval.c - the values of expressions, calls of built-ins and user functions.
 *
 * Numbers travel without a box. The right operand of a binary operator is
 * evaluated before the left one, arguments go from left to right. Operands
 * and arguments are references of our own, so a call may free or assign the
 * variables they come from. */
#include <assert.h>
#include <string.h>

#include "lang/call.h"
#include "lang/interp_impl.h"

#define FEW_ARGS    8                 /* without scratch memory */
#define STACK_BYTES ((size_t)4 << 20) /* of the usual 8 MB C stack */

/* --- variables
 * ---------------------------------------------------------------------- */

ix_obj **ix__node_slot(ix_interp *in, const ix__node *n)
{
    if (n->kind == N_GLOBAL)
        return &n->u.sym->box;
    return &in->stack[n->u.slot + (n->kind == N_LOCAL ? in->base : 0)];
}

const char *ix__node_name(const ix_interp *in, const ix__node *n)
{
    size_t slot;
    int f = in->nframes - 1;

    if (n->kind == N_GLOBAL || n->kind == N_UNBOUND)
        return n->u.sym->name;
    slot = n->u.slot + (n->kind == N_LOCAL ? in->base : 0);
    while (f > 0 && in->frame[f].base > slot)
        f--;
    return in->frame[f].fn->slot_name[slot - in->frame[f].base];
}

static ix_status undefined(ix_interp *in, const ix__node *n)
{
    const char *name = ix__node_name(in, n);

    if (n->kind == N_UNBOUND)
        return IX_FAIL_AT(in, in->unit, n->pos,
                          "%s did not exist when the function was defined",
                          name);
    if (n->kind == N_GLOBAL)
        return IX_FAIL_AT(in, in->unit, n->pos, "there is no variable %s",
                          name);
    return IX_FAIL_AT(in, in->unit, n->pos, "%s has no value yet", name);
}

ix_status ix__node_var_box(ix_interp *in, const ix__node *n, ix_obj **out)
{
    *out = n->kind == N_UNBOUND ? NULL : *ix__node_slot(in, n);
    return *out ? IX_OK : undefined(in, n);
}

static ix_status variable(ix_interp *in, const ix__node *n, ix__val *v)
{
    ix_obj *box;

    IX_TRY(ix__node_var_box(in, n, &box));
    assert(box);
    if (box->type == IX_OBJ_NUMBER)
        v->num = box->u.num;
    else
        v->o = ix__obj_ref(box);
    return IX_OK;
}

/* Names a box of ours, or gives it up. */
static ix_status rename_box(ix_interp *in, ix_obj **o, const char *name)
{
    ix_status st = ix__obj_set_name(in->ctx, *o, name);

    if (st != IX_OK) {
        ix__obj_unref(in->ctx, *o);
        *o = NULL;
    }
    return st;
}

/* --- operators
 * ------------------------------------------------------------------------ */

/* A box for a value that may be a bare number. */
static ix_status boxed(ix_interp *in, ix__val *v)
{
    if (!v->o)
        v->o = ix__obj_number(in->ctx, v->num);
    return v->o ? IX_OK : IX_ENOMEM;
}

/* A result that is a number leaves its box, unless others hold it, too: NREF
 * gives an element itself. */
static void unboxed(ix_interp *in, ix__val *v)
{
    assert(v->o);
    if (v->o->type != IX_OBJ_NUMBER || v->o->attrs || v->o->refs > 1)
        return;
    v->num = v->o->u.num;
    ix__obj_unref(in->ctx, v->o);
    v->o = NULL;
}

static ix_status apply_boxes(ix_interp *in, ix__op op, ix__val *l, ix__val *r,
                             ix__val *v)
{
    IX_TRY(boxed(in, l));
    IX_TRY(boxed(in, r));
    IX_TRY(ix__op_apply(in, op, l->o, r->o, &v->o));
    unboxed(in, v);
    return IX_OK;
}

/* *v = l op r; uses up both. v may be l. */
static ix_status apply(ix_interp *in, ix__op op, ix__pos pos, ix__val *l,
                       ix__val *r, ix__val *v)
{
    ix__val result = {NULL, 0, false};
    ix_status st;

    if (!l->o && !r->o) {
        st = ix__op_numbers(in, op, l->num, r->num, &result.num);
    } else {
        in->here = pos;
        st = apply_boxes(in, op, l, r, &result);
        ix__obj_unref(in->ctx, l->o);
        ix__obj_unref(in->ctx, r->o);
    }
    *v = result;
    return st == IX_OK ? st : IX_AT(in, in->unit, pos, st);
}

static ix_status binary(ix_interp *in, ix__node *n, ix__val *v)
{
    ix__val l, r;
    ix_status st;

    IX_TRY(ix__eval(in, n->kid[1], &r));
    st = ix__eval(in, n->kid[0], &l);
    if (st != IX_OK) {
        ix__obj_unref(in->ctx, r.o);
        return st;
    }
    return apply(in, n->op, n->pos, &l, &r, v);
}

/* All operands from the right, then the operators from the left. */
static ix_status chain_values(ix_interp *in, ix__node *n, ix__val *a)
{
    for (int i = n->n - 1; i >= 0; i--) {
        ix_status st = ix__eval(in, n->kid[i], &a[i]);

        if (st != IX_OK) {
            while (++i < n->n)
                ix__obj_unref(in->ctx, a[i].o);
            return st;
        }
    }
    return IX_OK;
}

static ix_status fold(ix_interp *in, const ix__node *n, ix__val *a, ix__val *v)
{
    *v = a[0];
    for (int i = 1; i < n->n; i++) {
        const ix__step *s = &n->u.steps[i - 1];
        ix_status st = apply(in, s->op, s->pos, v, &a[i], v);

        if (st != IX_OK) {
            while (++i < n->n)
                ix__obj_unref(in->ctx, a[i].o);
            return st;
        }
    }
    return IX_OK;
}

static ix_status chain(ix_interp *in, ix__node *n, ix__val *v)
{
    ix_mark mk = ix__scratch_mark(in->ctx);
    ix__val *a = ix__scratch(in->ctx, (size_t)n->n, sizeof *a);
    ix_status st = a ? chain_values(in, n, a) : IX_ENOMEM;

    if (st == IX_OK)
        st = fold(in, n, a, v);
    ix__scratch_release(in->ctx, mk);
    return st;
}

static ix_status unary(ix_interp *in, ix__node *n, ix__val *v)
{
    ix__val a;
    ix_status st;

    IX_TRY(ix__eval(in, n->kid[0], &a));
    if (!a.o) {
        v->num = n->kind == N_NEG ? -a.num : !ix__truth(a.num);
        return IX_OK;
    }
    in->here = n->pos;
    if (n->kind == N_NEG)
        st = ix__op_negate(in, a.o, &v->o);
    else
        st = ix__op_mismatch(in, OP_NOT, 1u << a.o->type, 0);
    ix__obj_unref(in->ctx, a.o);
    if (st != IX_OK)
        return IX_AT(in, in->unit, n->pos, st);
    unboxed(in, v);
    return IX_OK;
}

/* --- built-ins
 * ---------------------------------------------------------------------------
 */

/* Puts the function's name in front of its message and says where. */
static ix_status call_failed(ix_interp *in, const ix__node *n, const ix_call *c,
                             ix_status st)
{
    ix__pos pos = n->pos;

    if (in->exiting || in->place.set) /* an EXEC inside said all */
        return st;
    if (ix__call_blame(n->u.bi, c, st))
        pos = n->kid[c->bad_arg - 1]->pos;
    in->soft = n->u.bi->row->flags & IX_B_SOFT && st != IX_ENOMEM &&
               st != IX_ECANCEL;
    in->soft_node = n;
    return IX_AT(in, in->unit, pos, st);
}

static ix_status invoke(ix_interp *in, ix__node *n, ix_obj **argv, ix__val *v)
{
    ix_call c = {.in = in, .ctx = in->ctx, .argc = n->n, .argv = argv};
    const ix__bi *bi = n->u.bi;
    int bad = ix__call_misfit(bi, n->n, argv);
    ix_status st;

    if (bad < n->n) {
        (void)ix__arg_mismatch(in, bi, bad, 1u << argv[bad]->type);
        return IX_AT(in, in->unit, n->kid[bad]->pos, IX_EARG);
    }
    in->here = n->pos;
    st = ix__call_run(bi, &c);
    if (st != IX_OK)
        return call_failed(in, n, &c, st);
    v->o = c.result;
    v->none = !c.result;
    if (c.result)
        unboxed(in, v);
    return IX_OK;
}

static ix_status call_builtin(ix_interp *in, ix__node *n, ix__val *v)
{
    ix_obj *few[FEW_ARGS], **argv = few;
    ix_mark mk = ix__scratch_mark(in->ctx);
    ix_status st = IX_OK;
    int done = 0;

    if (n->n > FEW_ARGS) {
        argv = ix__scratch(in->ctx, (size_t)n->n, sizeof *argv);
        st = argv ? IX_OK : IX_ENOMEM;
    }
    while (st == IX_OK && done < n->n) {
        st = ix__eval_box(in, n->kid[done], &argv[done]);
        done += st == IX_OK;
    }
    if (st == IX_OK)
        st = invoke(in, n, argv, v);
    while (done > 0)
        ix__obj_unref(in->ctx, argv[--done]);
    ix__scratch_release(in->ctx, mk);
    return st;
}

/* --- user functions
 * ------------------------------------------------------------------------- */

static ix_status user_args(ix_interp *in, ix__node *n, size_t base)
{
    for (int i = 0; i < n->n; i++) {
        ix__val v;
        ix_obj **slot;

        IX_TRY(ix__eval(in, n->kid[i], &v));
        slot = &in->stack[base + (size_t)i];
        IX_TRY(v.o ? ix__slot_take(in, slot, NULL, v.o)
                   : ix__slot_number(in, slot, NULL, v.num));
    }
    return IX_OK;
}

ix_status ix__frame_push(ix_interp *in, const ix__fn *fn, size_t base,
                         ix__pos call)
{
    uintptr_t here = (uintptr_t)__builtin_frame_address(0);

    if (in->nframes >= in->opt.max_calls)
        return IX_FAIL_AT(in, in->unit, call,
                          "more than %d nested calls (does %s ever end?)",
                          in->opt.max_calls, fn->name);
    if (in->stack_base > here && in->stack_base - here > STACK_BYTES)
        return IX_FAIL_AT(in, in->unit, call,
                          "calls and expressions are nested too deeply");
    if ((size_t)in->nframes == in->cap_frames) {
        ix__frame *more = ix__grow(in->ctx, in->frame, &in->cap_frames,
                                   sizeof *more);

        if (!more)
            return IX_ENOMEM;
        in->frame = more;
    }
    in->frame[in->nframes++] = (ix__frame){
        .fn = fn, .base = base, .caller = in->unit, .call = call};
    return IX_OK;
}

/* Runs fn, whose arguments are in place. */
static ix_status run_body(ix_interp *in, const ix__node *n, ix__fn *fn,
                          size_t base)
{
    ix__unit *caller = in->unit, *unit = fn->unit;
    size_t caller_base = in->base;
    ix_status st;

    IX_TRY(ix__frame_push(in, fn, base, n->pos));
    if (in->states.debug_func)
        ix__remark(in, "%s is called", fn->name);
    in->base = base;
    in->unit = ix__unit_ref(unit); /* the body may redefine fn */
    st = ix__exec(in, fn->body);
    in->nframes--;
    in->unit = caller;
    in->base = caller_base;
    ix__unit_unref(unit);
    return st;
}

static ix_status take_result(ix_interp *in, const ix__node *n, const ix__fn *fn,
                             size_t base, ix__val *v)
{
    ix_obj **slot = &in->stack[base + (size_t)fn->result];

    v->o = *slot;
    if (!v->o)
        return IX_FAIL_AT(in, in->unit, n->pos,
                          "%s has no returned value: its body must assign "
                          "RETURN",
                          fn->name);
    *slot = NULL;
    if (v->o->refs == 1)
        IX_TRY(rename_box(in, &v->o, NULL));
    unboxed(in, v);
    return IX_OK;
}

static ix_status call_user(ix_interp *in, ix__node *n, ix__val *v)
{
    ix__fn *fn = n->u.sym->fn;
    size_t base = in->top;
    int nslots;
    ix_status st;

    if (!fn)
        return IX_FAIL_AT(in, in->unit, n->pos, "the function %s was freed",
                          n->u.sym->name);
    if (n->n != fn->nparams)
        return IX_FAIL_AT(in, in->unit, n->pos,
                          "%s takes %d arguments now, got %d", fn->name,
                          fn->nparams, n->n);
    nslots = fn->nslots;
    (void)ix__unit_ref(fn->unit); /* arguments may redefine fn, too */
    st = ix__stack_push(in, (size_t)nslots);
    if (st == IX_OK) {
        st = user_args(in, n, base);
        if (st == IX_OK)
            st = run_body(in, n, fn, base);
        if (st == IX_OK && !fn->is_procedure)
            st = take_result(in, n, fn, base, v);
        ix__stack_pop(in, (size_t)nslots);
    }
    ix__unit_unref(fn->unit);
    return st;
}

/* --- any node
 * ---------------------------------------------------------------------------------
 */

ix_status ix__eval_maybe(ix_interp *in, ix__node *n, ix__val *v)
{
    *v = (ix__val){NULL, 0, false};
    switch (n->kind) {
    case N_NUM:
        v->num = n->u.lit.num;
        return IX_OK;
    case N_STR:
        return ix__eval_box(in, n, &v->o);
    case N_GLOBAL:
    case N_LOCAL:
    case N_OUTER:
    case N_UNBOUND:
        return variable(in, n, v);
    case N_BINARY:
        return binary(in, n, v);
    case N_CHAIN:
        return chain(in, n, v);
    case N_NEG:
    case N_NOT:
        return unary(in, n, v);
    case N_ASSIGN:
        IX_TRY(ix__assign(in, n));
        return variable(in, n->kid[0], v);
    case N_CALL:
        return call_builtin(in, n, v);
    case N_USER:
        return call_user(in, n, v);
    default:
        return IX_FAIL_AT(in, in->unit, n->pos, "a value is expected here");
    }
}

ix_status ix__eval(ix_interp *in, ix__node *n, ix__val *v)
{
    IX_TRY(ix__eval_maybe(in, n, v));
    if (v->none)
        return IX_FAIL_AT(in, in->unit, n->pos, "%s gave no value",
                          n->u.bi->row->name);
    return IX_OK;
}

/* The variable's own box, with its name. */
static ix_status own_box(ix_interp *in, const ix__node *n, ix_obj **out)
{
    IX_TRY(ix__node_var_box(in, n, out));
    if (!(*out)->name)
        IX_TRY(ix__obj_set_name(in->ctx, *out, ix__node_name(in, n)));
    (void)ix__obj_ref(*out);
    return IX_OK;
}

static ix_status literal_box(ix_interp *in, ix__node *n, ix_obj **out)
{
    *out = ix__node_box(in->unit, n);
    if (!*out)
        return IX_ENOMEM;
    (void)ix__obj_ref(*out);
    return IX_OK;
}

ix_status ix__eval_box(ix_interp *in, ix__node *n, ix_obj **out)
{
    ix__val v;

    if (n->kind == N_NUM || n->kind == N_STR)
        return literal_box(in, n, out);
    if (ix__node_is_var(n))
        return own_box(in, n, out);
    IX_TRY(ix__eval(in, n, &v));
    if (n->kind == N_ASSIGN) {
        ix__obj_unref(in->ctx, v.o);
        return own_box(in, n->kid[0], out);
    }
    IX_TRY(boxed(in, &v));
    *out = v.o;
    /* -a is still called A. */
    if (n->kind == N_NEG && ix__node_is_var(n->kid[0]) && !v.o->name)
        return rename_box(in, out, ix__node_name(in, n->kid[0]));
    return IX_OK;
}

ix_status ix__eval_num(ix_interp *in, ix__node *n, const char *what,
                       double *out)
{
    ix__val v;
    char buf[64];

    IX_TRY(ix__eval(in, n, &v));
    *out = v.num;
    if (!v.o)
        return IX_OK;
    *out = v.o->u.num;
    if (v.o->type == IX_OBJ_NUMBER) {
        ix__obj_unref(in->ctx, v.o);
        return IX_OK;
    }
    (void)IX_FAIL(in->ctx, IX_EARG, "%s must be a number, got %s", what,
                  ix__types_text(1u << v.o->type, buf, sizeof buf));
    ix__obj_unref(in->ctx, v.o);
    return IX_AT(in, in->unit, n->pos, IX_EARG);
}
