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

/* --- trivariates -----------------------------------------------------------
 */

typedef struct {
    int order[3], size[3];
} tv_args;

/* A grid of points, lists three deep. */
static ix_status tv_grid(ix_call *c, const tv_args *a)
{
    ix_mesh m;
    ix_mv *out;

    IX_TRY(ix__arg_mesh(c, 0, 3, &m));
    IX_TRY(ix_mv_fit_grid(c->ctx, 3, m.length, m.ncoords, m.rational, m.pts,
                          a->order, a->size, &out));
    return ix__ret_mv(c, -1, out);
}

/* Control points (u, v, w, values ...). */
static ix_status tv_scattered(ix_call *c, const tv_args *a)
{
    int n, ncoords;
    bool rational;
    double *pts;
    ix_mv *out;

    IX_TRY(ix__arg_points(c, c->argv[0], &n, &ncoords, &rational, &pts));
    if (rational || ncoords < 4)
        return IX_ARG_FAIL(c, 0,
                           "scattered points need the coordinates u, v, w and "
                           "at least one value, not %c%d",
                           rational ? 'P' : 'E', ncoords);
    for (int d = 0; d < 3; d++)
        if (a->order[d] < 1 || a->size[d] < a->order[d])
            return IX_ARG_FAIL(
                c, 1 + d,
                "%d control points of order %d; scattered points "
                "need 1 <= order <= control points",
                a->size[d], a->order[d]);
    IX_TRY(ix_mv_fit_points(
        c->ctx, &(ix_cloud){3, n, pts, ncoords - 3, pts + 3 * (size_t)n},
        a->order, a->size, &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status tinterp(ix_call *c)
{
    const ix_obj *o = c->argv[0];
    tv_args a;
    ix_mv *out;

    for (int d = 0; d < 3; d++) {
        IX_TRY(ix__arg_int(c, 1 + d, 0, 10000, &a.size[d]));
        IX_TRY(ix__arg_int(c, 4 + d, 0, IX_MAX_ORDER, &a.order[d]));
    }
    if (o->type == IX_OBJ_LIST)
        return o->u.list.n > 0 && o->u.list.item[0]->type == IX_OBJ_LIST
                   ? tv_grid(c, &a)
                   : tv_scattered(c, &a);
    IX_TRY(ix_mv_fit_nodes(c->ctx, ix__arg_mv(c, 0), a.order, a.size, &out));
    return ix__ret_mv(c, -1, out);
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
    {"TINTERP",
     "t:trivar|list ul:num vl:num wl:num uo:num vo:num wo:num -> trivar",
     "Trivariate of the given lengths and orders through data, or nearest to "
     "them. Of a trivariate: its control points as data at its nodes, lengths "
     "and orders 0 as t has them (then it interpolates, on t's knots). Of a "
     "list: control points (u, v, w, values), parameters in [0, 1], on uniform "
     "knots; or a grid of points (lists three deep, the inner ones along u) at "
     "even parameters, lengths 0 as many as data.",
     "t = tbezier(list(list(list(ctlpt(E1,0), ctlpt(E1,1)), list(ctlpt(E1,2), "
     "ctlpt(E1,5))), list(list(ctlpt(E1,3), ctlpt(E1,4)), list(ctlpt(E1,0), "
     "ctlpt(E1,1))))); x = tinterp(t, 0, 0, 0, 0, 0, 0);",
     tinterp, 0, 15},
    {0}};
