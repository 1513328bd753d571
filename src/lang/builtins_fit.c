/* builtins_fit.c - freeforms near others and near points (chapters 11, 15 and
 * 24 of spec/functions). */
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"

static ix_status ruledfit(ix_call *c)
{
    ix_ruled_opts o = {.extend = ix__arg_num(c, 2)};
    ix_fit_error err;
    ix_mv *out;
    ix_obj *r;

    IX_TRY(ix__arg_dir(c, 1, 2, &o.dir));
    if (!(o.extend >= 0 && o.extend <= 1))
        return IX_ARG_FAIL(c, 2, "an extension by %g; 0 .. 1 is possible",
                           o.extend);
    IX_TRY(ix__arg_int(c, 3, 2, 1000, &o.samples));
    c->bad_arg = 1;
    IX_TRY(ix_srf_fit_ruled(c->ctx, ix__arg_mv(c, 0), &o, &err, &out));
    c->bad_arg = 0;
    r = ix__obj_mv(c->ctx, IX_OBJ_SURFACE, out);
    if (r && (ix__attr_set_real(c->ctx, &r->attrs, "Error", err.rms) != IX_OK ||
              ix__attr_set_real(c->ctx, &r->attrs, "MaxError", err.largest) !=
                  IX_OK)) {
        ix__obj_unref(c->ctx, r);
        r = NULL;
    }
    return ix__ret(c, r);
}

const ix_builtin ix__builtins_fit[] = {
    {"RULEDFIT", "s:surface dir:num extend:num samples:num -> surface",
     "One ruled surface near s and as long, its rulings along dir (PRISA makes "
     "several). Rulings first join the best of `samples` places on each side, "
     "then the sides move to the least squares of distances. With extend, 0 .. "
     "1, s is first continued by that part of its domain at both ends across "
     "the rulings, so that they may lean there too. Attributes Error (root "
     "mean square) and MaxError are distances of points of s from the result.",
     "s = sbezier(list(list(point(0,0,0), point(0,1,1), point(0,2,0)), "
     "list(point(2,0,1), point(2,1,0.5), point(2,2,1)), list(point(4,0,0), "
     "point(4,1,2), point(4,2,0.4)))); r = ruledfit(s, ROW, 0, 20);",
     ruledfit, 0, 11},
    {0}};
