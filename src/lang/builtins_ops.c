/* builtins_ops.c - geometric operators: bisectors and distance functions
 * (chapters 21 and 22 of spec/functions). */
#include <limits.h>

#include "iritx/geom_srf.h"
#include "iritx/ops.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"

/* The state "DegreeForm", and BspProdMethod 0 as C0 joins. */
static ix_op_opts op_opts(const ix_call *c)
{
    const ix_states *s = ix__states(c->in);

    return (ix_op_opts){.form = (ix_degree_form)s->degree_form,
                        .max_cont = s->bsp_prod_method == 0 ? 0 : INT_MAX};
}

static ix_status cbisector3d(ix_call *c)
{
    ix_op_opts o = op_opts(c);
    const ix_mv **crv;
    ix_mv *out;
    int n;

    if (o.form == IX_FORM_NAIVE)
        return IX_FAIL(c->ctx, IX_EUNABLE,
                       "the bisector surface is not available in degree form "
                       "naive, only in minimal, published and irit");
    if (ix__arg_num(c, 1) == 4)
        return IX_ARG_FAIL(c, 1,
                           "the zero set of function 4 is not available, "
                           "only the bisector surface (1)");
    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
    if (n != 2)
        return IX_ARG_FAIL(c, 0, "list(curve, curve) is needed, got %d curves",
                           n);
    IX_TRY(ix_cbisector3d(c->ctx, crv[0], crv[1], &o, NULL, &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status dist2ff(ix_call *c)
{
    static const ix_dist kinds[4] = {IX_DIST_VECTOR, IX_DIST_SQUARED,
                                     IX_DIST_NORMAL_A, IX_DIST_NORMAL_B};
    ix_mv *out;
    int type;

    IX_TRY(ix__arg_int(c, 2, 0, 3, &type));
    IX_TRY(ix_srf_distance(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                           kinds[type], &out));
    if (out->ndirs == 2)
        return ix__ret_mv(c, -1, out);
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_MULTIVAR, out));
}

/* --- table ------------------------------------------------------------- */

#define PAIR                                                        \
    "a = cbezier(list(point(0,0,0), point(1,0,1), point(2,1,0))); " \
    "b = cbezier(list(point(0,2,0), point(0,3,1))); "

const ix_builtin ix__builtins_ops[] = {
    {"CBISECTOR3D", "curves:list func:num -> surface",
     "Exact rational bisector surface of two space curves: S(u, v) has the "
     "same distance from both, with foot points at u and v.",
     PAIR "s = cbisector3d(list(a, b), 1);", cbisector3d, 0, 21},
    {"DIST2FF", "a:curve|surface b:curve|surface type:num -> surface|mv",
     "Distance function over both domains: 0 the vector a - b, 1 its squared "
     "length, 2 and 3 its product with the normal of a or b.",
     PAIR "d = dist2ff(a, b, 1);", dist2ff, 0, 22},
    {0}};
