/* builtins_degrees.c - DEGREES: the degree forms of an operator as a list. */
#include <math.h>
#include <string.h>

#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "ops/degrees.h"

/* --- arguments ----------------------------------------------------------- */

/* Freeforms, then numbers; those left out are the defaults. */
static ix_status arg_op(ix_call *c, const ix_op **op, ix_op_args *a)
{
    const char *name = ix__arg_str(c, 0);
    int n = 0, i = 1;

    while (i < c->argc && ix__obj_is_freeform(c->argv[i])) {
        if (n == IX_OP_MAX_MVS)
            return IX_ARG_FAIL(c, i, "operators take at most %d freeforms", n);
        a->mv[n++] = ix__arg_mv(c, i++);
    }
    *op = ix__op_for(name, n, a->mv);
    if (!*op)
        return IX_ARG_FAIL(c, 0,
                           "no operator \"%s\" takes such freeforms (%d of "
                           "them)",
                           name, n);
    ix__op_defaults(*op, a->num);
    if (c->argc - i > (*op)->nnums)
        return IX_ARG_FAIL(c, i + (*op)->nnums, "%s takes %d numbers",
                           (*op)->name, (*op)->nnums);
    for (n = 0; i < c->argc; i++, n++) {
        if (c->argv[i]->type != IX_OBJ_NUMBER)
            return IX_ARG_FAIL(c, i, "a number is wanted");
        a->num[n] = ix__arg_num(c, i);
    }
    return IX_OK;
}

/* --- rows ---------------------------------------------------------------- */

static ix_obj *degree_list(ix_ctx *ctx, int n, const int *v)
{
    ix_obj *list = ix__obj_list(ctx);

    for (int i = 0; list && i < n; i++)
        if (ix__list_add_num(ctx, list, v[i]) != IX_OK) {
            ix__obj_unref(ctx, list);
            return NULL;
        }
    return list;
}

/* (form, degrees, control points, residual). */
static ix_obj *row_object(ix_ctx *ctx, int form, const ix_degree_row *r)
{
    const char *name = ix__form_name(form);
    ix_obj *list = ix__obj_list(ctx);
    double residual = isnan(r->residual) ? -1.0 : r->residual;
    ix_status st = ix__list_add(ctx, list,
                                ix__obj_string(ctx, name, strlen(name)));

    if (st == IX_OK)
        st = ix__list_add(ctx, list, degree_list(ctx, r->ndirs, r->degree));
    if (st == IX_OK)
        st = ix__list_add_num(ctx, list, (double)r->npts);
    if (st == IX_OK)
        st = ix__list_add_num(ctx, list, residual);
    if (st == IX_OK)
        return list;
    ix__obj_unref(ctx, list);
    return NULL;
}

static ix_status degrees(ix_call *c)
{
    ix_op_args a = {.num = {0}};
    ix_obj *list;
    const ix_op *op;
    ix_status st;

    IX_TRY(arg_op(c, &op, &a));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int form = 0; st == IX_OK && form < IX__NFORMS; form++) {
        ix_degree_row row;

        if (!ix__op_has_form(op, form))
            continue;
        st = ix__degree_row(c->ctx, op, &a, form, &row);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, row_object(c->ctx, form, &row));
    }
    return ix__ret_list(c, list, st);
}

/* --- table --------------------------------------------------------------- */

const ix_builtin ix__builtins_degrees[] = {
    {"DEGREES", "name:str args:any... -> list",
     "What the degree forms of an operator come to: rows (form, degrees, "
     "control points, residual; -1 if there is none). args are its freeforms, "
     "then its numbers.",
     "c = circle(vector(0, 0, 0), 1); l = degrees(\"evolute\", c);", degrees, 0,
     18},
    {0}};
