/* curve_args.c - taking lists apart and putting lists of curves together. */
#include "lang/curve_args.h"

#include <math.h>
#include <string.h>

#include "lang/codes.h"

bool ix__is_param(double code)
{
    return code == IX__PARAM_UNIFORM || code == IX__PARAM_CENTRIP ||
           code == IX__PARAM_CHORD || code == IX__PARAM_NIELFOL;
}

ix_status ix__arg_param(ix_call *c, int i, ix_param *out)
{
    double code = ix__arg_num(c, i);

    if (!ix__is_param(code))
        return IX_ARG_FAIL(c, i,
                           "%g is none of PARAM_UNIFORM, PARAM_CENTRIP, "
                           "PARAM_CHORD, PARAM_NIELFOL",
                           code);
    *out = code == IX__PARAM_UNIFORM   ? IX_PARAM_UNIFORM
           : code == IX__PARAM_CENTRIP ? IX_PARAM_CENTRIPETAL
           : code == IX__PARAM_CHORD   ? IX_PARAM_CHORD
                                       : IX_PARAM_NIELSON_FOLEY;
    return IX_OK;
}

ix_status ix__arg_nums_of(ix_call *c, int i, const ix_obj *list, int *n,
                          const double **out)
{
    double *v;

    if (list->type != IX_OBJ_LIST)
        return IX_ARG_FAIL(c, i, "a list of numbers is needed, not a %s",
                           ix__obj_type_name(list->type));
    *n = list->u.list.n;
    IX_SCRATCH(c->ctx, v, *n);
    for (int k = 0; k < *n; k++) {
        const ix_obj *o = list->u.list.item[k];

        if (o->type != IX_OBJ_NUMBER || !isfinite(o->u.num))
            return IX_ARG_FAIL(c, i, "element %d is not a finite number",
                               k + 1);
        v[k] = o->u.num;
    }
    *out = v;
    return IX_OK;
}

ix_status ix__arg_nums_n(ix_call *c, int i, int n, const double **out)
{
    int have;

    IX_TRY(ix__arg_nums_of(c, i, c->argv[i], &have, out));
    if (have != n)
        return IX_ARG_FAIL(c, i, "%d numbers are needed, not %d", n, have);
    return IX_OK;
}

static ix_status point3(ix_call *c, int i, int k, const ix_obj *o, double p[3])
{
    if (o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR) {
        memcpy(p, o->u.pt, 3 * sizeof *p);
        return IX_OK;
    }
    if (o->type != IX_OBJ_CTLPT)
        return ix__wrong_element(c, i, k, o,
                                 "a point, vector or control point");
    for (int a = 0; a < 3; a++) {
        const ix_ctlpt *q = o->u.ctlpt;
        double w = q->rational ? q->v[0] : 1;

        p[a] = a < q->ncoords ? q->v[a + (q->rational ? 1 : 0)] / w : 0;
        if (!isfinite(p[a]))
            return IX_ARG_FAIL(c, i, "element %d has weight 0", k + 1);
    }
    return IX_OK;
}

ix_status ix__arg_points3(ix_call *c, int i, int *n, double **out)
{
    const ix_obj *list = c->argv[i];

    *n = list->u.list.n;
    IX_SCRATCH(c->ctx, *out, 3 * (size_t)*n);
    for (int k = 0; k < *n; k++)
        IX_TRY(point3(c, i, k, list->u.list.item[k], *out + 3 * (size_t)k));
    return IX_OK;
}

ix_status ix__ret_crvs(ix_call *c, ix_crvs *crvs)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int k = 0; st == IX_OK && k < crvs->n; k++)
        st = ix__list_add(
            c->ctx, list,
            ix__obj_mv(c->ctx, IX_OBJ_CURVE, ix_mv_ref(crvs->crv[k])));
    ix_crvs_free(c->ctx, crvs);
    if (st == IX_OK)
        return ix__ret(c, list);
    ix__obj_unref(c->ctx, list);
    return st;
}

ix_status ix__ret_edited(ix_call *c, int i, const ix_mv *m)
{
    const ix_attr *a = ix__attr_find(c->argv[i]->attrs, "GeomType");

    IX_TRY(ix__ret_mv(c, i, m));
    if (!a || a->type != IX_ATTR_INT)
        return IX_OK;
    return ix__attr_set_int(c->ctx, &c->result->attrs, "GeomType", a->i);
}
