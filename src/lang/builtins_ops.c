/* builtins_ops.c - distance functions (chapter 22 of spec/functions). */
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"

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
    {"DIST2FF", "a:curve|surface b:curve|surface type:num -> surface|mv",
     "Distance function over both domains: 0 the vector a - b, 1 its squared "
     "length, 2 and 3 its product with the normal of a or b.",
     PAIR "d = dist2ff(a, b, 1);", dist2ff, 0, 22},
    {0}};
