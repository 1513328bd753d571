/* transform.c - objects times 4 x 4 matrices (spec/language 5.3). Lists that
 * are shared in the object are shared in the result in the same way. */
#include <string.h>

#include "object/transform_impl.h"
#include "object/walk.h"

static ix_status made(ix_obj *o, ix_obj **out)
{
    *out = o;
    return o ? IX_OK : IX_ENOMEM;
}

/* --- boxes without children ------------------------------------------- */

static ix_status move_pt(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                         ix_obj **out)
{
    double p[3];

    IX_TRY(ix__move_point(ctx, o->u.pt, mat, p));
    return made(o->type == IX_OBJ_POINT ? ix__obj_point(ctx, p)
                                        : ix__obj_vector(ctx, p),
                out);
}

static ix_obj *product(ix_ctx *ctx, const ix_obj *o, const double mat[16])
{
    bool inst = o->type == IX_OBJ_INSTANCE;
    const double *a = inst ? o->u.inst->mat : o->u.mat;
    double m[16];

    for (int i = 0; i < 4; i++)
        ix__row_times(a + 4 * i, mat, m + 4 * i);
    return inst ? ix__obj_instance(ctx, o->u.inst->target, m)
                : ix__obj_matrix(ctx, m);
}

static ix_status move_simple(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                             ix_obj **out)
{
    double plane[4];
    ix_ctlpt pt;

    switch (o->type) {
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        return move_pt(ctx, o, mat, out);
    case IX_OBJ_PLANE: /* a row like any other, as in IRIT */
        ix__row_times(o->u.plane, mat, plane);
        return made(ix__obj_plane(ctx, plane), out);
    case IX_OBJ_CTLPT:
        ix__move_ctlpt(o->u.ctlpt, mat, &pt);
        return made(ix__obj_ctlpt(ctx, &pt), out);
    case IX_OBJ_MATRIX:
    case IX_OBJ_INSTANCE:
        return made(product(ctx, o, mat), out);
    default:
        return IX_FAIL(ctx, IX_EARG,
                       "an object of type %s has no image under "
                       "a matrix",
                       ix__obj_type_name(o->type));
    }
}

static ix_status move_poly(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                           ix_obj **out)
{
    ix_poly *p;

    IX_TRY(ix__move_poly(ctx, o->u.poly, mat, &p));
    return made(ix__obj_poly(ctx, p), out);
}

static ix_status move_sequence(ix_ctx *ctx, const ix_obj *o,
                               const double mat[16], ix_obj **out)
{
    int n = ix__seq_count(o), k = 0;
    ix_mark mk = ix__scratch_mark(ctx);
    const void **moved = ix__scratch(ctx, (size_t)n, sizeof *moved);
    ix_status st = moved ? IX_OK : IX_ENOMEM;

    while (st == IX_OK && k < n) {
        st = ix__move_item(ctx, o->type, ix__seq_item(o, k), mat, &moved[k]);
        k += st == IX_OK;
    }
    if (st == IX_OK)
        st = made(ix__seq_new(ctx, o->type, n, moved), out);
    for (int i = 0; i < k; i++)
        ix__seq_unref(ctx, o->type, moved[i]);
    ix__scratch_release(ctx, mk);
    return st;
}

/* Name and attributes as well. */
static ix_status move_leaf(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                           ix_obj **out)
{
    *out = NULL;
    if (o->type == IX_OBJ_POLY)
        IX_TRY(move_poly(ctx, o, mat, out));
    else if (ix__seq_count(o) > 0)
        IX_TRY(move_sequence(ctx, o, mat, out));
    else
        IX_TRY(move_simple(ctx, o, mat, out));
    if (ix__attr_copy_all(ctx, o->attrs, &(*out)->attrs) == IX_OK &&
        ix__obj_set_name(ctx, *out, o->name) == IX_OK)
        return IX_OK;
    ix__obj_unref(ctx, *out);
    *out = NULL;
    return IX_ENOMEM;
}

/* --- lists ------------------------------------------------------------ */

typedef struct {
    ix__walk walk; /* first: the ops are given its address */
    const double *mat;
} moving;

static ix_status enter(ix__walk *w)
{
    const ix_obj *o = w->top->box;
    ix_obj *r = ix__obj_list(w->ctx);

    w->top->result = r;
    if (!r)
        return IX_ENOMEM;
    IX_TRY(ix__attr_copy_all(w->ctx, o->attrs, &r->attrs));
    return ix__obj_set_name(w->ctx, r, o->name);
}

static ix_status leaf(ix__walk *w, const ix_obj *o)
{
    const moving *m = (const moving *)w;
    ix_obj *r;
    ix_status st;

    IX_TRY(move_leaf(w->ctx, o, m->mat, &r));
    st = ix__obj_append(w->ctx, w->top->result, r);
    ix__obj_unref(w->ctx, r);
    return st;
}

static ix_status join(ix__walk *w, const ix__node *n)
{
    return ix__obj_append(w->ctx, w->top->result, n->result);
}

static ix_status move_list(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                           ix_obj **out)
{
    static const ix__walk_ops ops = {enter, leaf, join};
    moving m = {.walk = {.ctx = ctx, .ops = &ops}, .mat = mat};
    ix_mark mk = ix__scratch_mark(ctx);
    ix__node *root;
    ix_status st = ix__walk_run(&m.walk, o, &root);

    if (st == IX_OK)
        *out = ix__obj_ref(root->result);
    for (ix__node *n = m.walk.all; n; n = n->all)
        ix__obj_unref(ctx, n->result);
    ix__walk_end(&m.walk);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix__obj_transform(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                            ix_obj **out)
{
    *out = NULL;
    if (o->type == IX_OBJ_LIST)
        return move_list(ctx, o, mat, out);
    return move_leaf(ctx, o, mat, out);
}
