/* args.c - what primitives need to fetch arguments and to give results.
 *
 * The interpreter has checked types and counts before a primitive is called,
 * so most of these cannot fail. */
#include <math.h>
#include <string.h>

#include "lang/codes.h"
#include "lang/interp_impl.h"

/* --- scalars
 * --------------------------------------------------------------------- */

double ix__arg_num(const ix_call *c, int i)
{
    return c->argv[i]->u.num;
}

bool ix__arg_bool(const ix_call *c, int i)
{
    return ix__truth(ix__arg_num(c, i));
}

ix_status ix__arg_int(ix_call *c, int i, int lo, int hi, int *out)
{
    double v = round(ix__arg_num(c, i));

    if (!(v >= lo && v <= hi))
        return IX_ARG_FAIL(c, i, "%.15g is not within %d .. %d",
                           ix__arg_num(c, i), lo, hi);
    *out = (int)v;
    return IX_OK;
}

const char *ix__arg_str(const ix_call *c, int i)
{
    return c->argv[i]->u.str.s;
}

ix_status ix__arg_dir(ix_call *c, int i, int ndirs, int *dir)
{
    double v = round(ix__arg_num(c, i));

    if (v >= IX__COL && v <= IX__DEPTH)
        v -= IX__COL;
    if (v >= 0 && v < ndirs) {
        *dir = (int)v;
        return IX_OK;
    }
    if (ndirs == 2 && c->argv[0]->type != IX_OBJ_MULTIVAR)
        return IX_ARG_FAIL(c, i, "the direction must be COL or ROW, got %.15g",
                           ix__arg_num(c, i));
    return IX_ARG_FAIL(c, i,
                       "the direction must be 0 .. %d (or COL, ROW, DEPTH), "
                       "got %.15g",
                       ndirs - 1, ix__arg_num(c, i));
}

/* --- points
 * ------------------------------------------------------------------------ */

/* Projected and padded to three coordinates. Err IX_EDOMAIN weight 0. */
static ix_status project(ix_call *c, int i, const ix_ctlpt *q, double p[3])
{
    double w = q->rational ? q->v[0] : 1;
    const double *x = q->v + q->rational;

    if (w == 0)
        return ((c)->bad_arg = i + 1,
                IX_FAIL(c->ctx, IX_EDOMAIN,
                        "the control point has weight 0: it is no point"));
    for (int k = 0; k < 3; k++)
        p[k] = k < q->ncoords ? x[k] / w : 0;
    return IX_OK;
}

ix_status ix__arg_pt3(ix_call *c, int i, double p[3])
{
    const ix_obj *o = c->argv[i];

    if (o->type == IX_OBJ_CTLPT)
        return project(c, i, o->u.ctlpt, p);
    memcpy(p, o->u.pt, 3 * sizeof *p);
    return IX_OK;
}

const ix_mv *ix__arg_mv(const ix_call *c, int i)
{
    return ix__obj_first_mv(c->argv[i]);
}

/* --- lists
 * ----------------------------------------------------------------------------
 */

ix_status ix__wrong_element(ix_call *c, int i, int k, const ix_obj *o,
                            const char *want)
{
    char buf[64];

    return IX_ARG_FAIL(c, i, "element %d must be %s, got %s", k + 1, want,
                       ix__types_text(1u << o->type, buf, sizeof buf));
}

ix_status ix__arg_nums(ix_call *c, int i, int *n, double **out)
{
    const ix_list *l = &c->argv[i]->u.list;

    *n = 0;
    IX_SCRATCH(c->ctx, *out, l->n);
    for (int k = 0; k < l->n; k++) {
        if (l->item[k]->type != IX_OBJ_NUMBER)
            return ix__wrong_element(c, i, k, l->item[k], "a number");
        (*out)[k] = l->item[k]->u.num;
    }
    *n = l->n;
    return IX_OK;
}

/* The smallest control point type that holds all elements. The first list
 * argument is blamed for a wrong one. */
static ix_status common_type(ix_call *c, const ix_obj *list, ix_ctlpt *type)
{
    int blame = 0;

    while (blame < c->argc - 1 && c->argv[blame]->type != IX_OBJ_LIST)
        blame++;
    *type = (ix_ctlpt){.ncoords = 1};
    for (int k = 0; k < list->u.list.n; k++) {
        const ix_obj *o = list->u.list.item[k];
        int n = 3;

        if (o->type == IX_OBJ_CTLPT) {
            n = o->u.ctlpt->ncoords;
            type->rational = type->rational || o->u.ctlpt->rational;
        } else if (o->type != IX_OBJ_POINT && o->type != IX_OBJ_VECTOR) {
            return ix__wrong_element(c, blame, k, o,
                                     "a point, vector or control point");
        }
        type->ncoords = n > type->ncoords ? n : type->ncoords;
    }
    return IX_OK;
}

/* A point, vector or control point as a control point of the given type, that
 * has no fewer coordinates. */
static ix_ctlpt converted(const ix_obj *o, const ix_ctlpt *type)
{
    ix_ctlpt p = *type;

    if (o->type == IX_OBJ_CTLPT) {
        const ix_ctlpt *q = o->u.ctlpt;

        if (p.rational)
            p.v[0] = q->rational ? q->v[0] : 1;
        memcpy(p.v + p.rational, q->v + q->rational,
               (size_t)q->ncoords * sizeof *p.v);
        return p;
    }
    if (p.rational)
        p.v[0] = 1;
    memcpy(p.v + p.rational, o->u.pt, 3 * sizeof *p.v);
    return p;
}

static bool same_type(const ix_obj *o, const ix_ctlpt *t)
{
    return o->type == IX_OBJ_CTLPT && o->u.ctlpt->ncoords == t->ncoords &&
           o->u.ctlpt->rational == t->rational;
}

/* The element itself becomes a control point: the list's owner sees it. */
static ix_status coerce(ix_ctx *ctx, ix_obj *o, const ix_ctlpt *p)
{
    ix_obj *q = ix__obj_ctlpt(ctx, p);
    ix_status st;

    if (!q)
        return IX_ENOMEM;
    st = ix__attr_copy_all(ctx, o->attrs, &q->attrs);
    if (st == IX_OK)
        st = ix__obj_assign(ctx, o, q);
    ix__obj_unref(ctx, q);
    return st;
}

ix_status ix__arg_points(ix_call *c, ix_obj *list, int *n, int *ncoords,
                         bool *rational, double **pts)
{
    ix_ctlpt type;
    int np = list->u.list.n, axes;

    IX_TRY(common_type(c, list, &type));
    axes = type.ncoords + type.rational;
    IX_SCRATCH(c->ctx, *pts, (size_t)np * (size_t)axes);
    for (int k = 0; k < np; k++) {
        ix_obj *o = list->u.list.item[k];
        ix_ctlpt p = converted(o, &type);

        for (int a = 0; a < axes; a++)
            (*pts)[(size_t)a * (size_t)np + (size_t)k] = p.v[a];
        if (!same_type(o, &type))
            IX_TRY(coerce(c->ctx, o, &p));
    }
    *n = np;
    *ncoords = type.ncoords;
    *rational = type.rational;
    return IX_OK;
}

/* --- results
 * ------------------------------------------------------------------------------
 */

ix_status ix__ret(ix_call *c, ix_obj *o)
{
    c->result = o;
    return o ? IX_OK : IX_ENOMEM;
}

ix_status ix__ret_num(ix_call *c, double v)
{
    return ix__ret(c, ix__obj_number(c->ctx, v));
}

ix_status ix__ret_mv(ix_call *c, int like, const ix_mv *m)
{
    ix_obj_type type = ix__obj_type_of_mv(m);

    if (like >= 0 && c->argv[like]->type == IX_OBJ_MULTIVAR)
        type = IX_OBJ_MULTIVAR;
    return ix__ret(c, ix__obj_mv(c->ctx, type, m));
}

ix_status ix__list_add(ix_ctx *ctx, ix_obj *list, ix_obj *o)
{
    ix_status st = list && o ? ix__obj_append(ctx, list, o) : IX_ENOMEM;

    ix__obj_unref(ctx, o);
    return st;
}

ix_status ix__list_add_num(ix_ctx *ctx, ix_obj *list, double v)
{
    return ix__list_add(ctx, list, ix__obj_number(ctx, v));
}
