/* builtins_curve_ask.c - chapter 9: what can be asked about one curve without
 * solving equations, and fits that need an answer first. */
#include <limits.h>
#include <math.h>

#include "iritx/geom.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"
#include "lang/prims_freeform.h"

#define C "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,3,0))); "

/* Products as the state BspProdMethod asks for: 0 gives C0 joins. */
static ix_status cderive(ix_call *c)
{
    const ix_sym_opts o = {
        .max_cont = ix__states(c->in)->bsp_prod_method ? INT_MAX : 0};
    ix_mv *out;

    IX_TRY(ix_sym_derive(c->ctx, ix__arg_mv(c, 0), 0, &o, &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status cinteg(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_sym_integrate(c->ctx, ix__arg_mv(c, 0), 0, &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status ctangent(ix_call *c)
{
    double v[3];

    IX_TRY(ix_tangent(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1),
                      ix__arg_bool(c, 2), v));
    return ix__ret_vector(c, v);
}

static ix_status cnormal(ix_call *c)
{
    double v[3];

    IX_TRY(ix_normal(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1), v));
    return ix__ret_vector(c, v);
}

static ix_status carclen(ix_call *c)
{
    int order;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 2, 2, 32, &order));
    IX_TRY(ix_arclen(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1), order, NULL,
                     &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status carea(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_area(c->ctx, ix__arg_mv(c, 0), &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status moment(ix_call *c)
{
    double center[3], axis[3];
    int k;

    IX_TRY(ix__arg_int(c, 1, 0, 1, &k));
    IX_TRY(ix_moments(c->ctx, ix__arg_mv(c, 0), center, axis));
    if (k == 1)
        return ix__ret_vector(c, axis);
    return ix__ret(c, ix__obj_point(c->ctx, center));
}

/* --- point clouds
 * ------------------------------------------------------------- */

/* list(length, order, periodic) to a first curve; a curve stays. */
static ix_status first_curve(ix_call *c, const ix_mesh *m, const ix_mv **out,
                             ix_mv **made)
{
    const double *v;

    *made = NULL;
    *out = ix__arg_mv(c, 1);
    if (c->argv[1]->type == IX_OBJ_CURVE)
        return IX_OK;
    IX_TRY(ix__arg_nums_n(c, 1, 3, &v));
    if (!(v[0] >= 2 && v[0] <= 1e6 && v[1] >= 2 && v[1] <= IX_MAX_ORDER))
        return IX_ARG_FAIL(c, 1, "length %g, order %g", v[0], v[1]);
    IX_TRY(ix_fit_cloud_start(c->ctx, m->length[0], m->ncoords, m->pts,
                              (int)v[0], (int)v[1], fabs(v[2]) >= 1e-5, made));
    *out = *made;
    return IX_OK;
}

/* list(iterations, error limit, limit of its change, lambda), all optional. */
static ix_status cloud_opts(ix_call *c, ix_cloud_opts *o)
{
    const double *v;
    int n, how;

    *o = (ix_cloud_opts){.max_iter = 50, .lambda = 1e-7};
    IX_TRY(ix__arg_int(c, 2, 1, 2, &how));
    o->how = (ix_cloud_how)how;
    IX_TRY(ix__arg_nums_of(c, 3, c->argv[3], &n, &v));
    if (n > 4)
        return IX_ARG_FAIL(c, 3, "at most 4 numbers, not %d", n);
    if (n > 0 && !(v[0] >= 1 && v[0] <= 1e6))
        return IX_ARG_FAIL(c, 3, "%g iterations", v[0]);
    o->max_iter = n > 0 ? (int)v[0] : o->max_iter;
    o->err_limit = n > 1 ? v[1] : 0;
    o->change_limit = n > 2 ? v[2] : 0;
    o->lambda = n > 3 ? v[3] : o->lambda;
    return IX_OK;
}

static ix_status cbsp_fit(ix_call *c)
{
    ix_cloud_opts o;
    const ix_mv *init;
    ix_mv *made, *out;
    ix_mesh m;
    ix_status st;

    IX_TRY(cloud_opts(c, &o));
    IX_TRY(ix__arg_mesh(c, 0, 1, &m));
    if (m.rational)
        return IX_ARG_FAIL(c, 0, "points with weights");
    IX_TRY(first_curve(c, &m, &init, &made));
    st = ix_fit_cloud(c->ctx, m.length[0], m.ncoords, m.pts, init, &o, NULL,
                      &out);
    ix_mv_unref(c->ctx, made);
    if (st != IX_OK)
        return st;
    return ix__ret_mv(c, -1, out);
}

const ix_builtin ix__builtins_curve_ask[] = {
    {"CEVAL", "c:curve t:num -> ctlpt",
     "The curve's point at t, homogeneous if the curve is rational.",
     C "p = coerce(ceval(c, 0.5), POINT_TYPE);", ix__prim_eval, 0, 9},
    {"CDERIVE", "c:curve -> curve",
     "The derivative; of a rational curve by the rule of quotients.",
     C "d = cderive(c);", cderive, 0, 9},
    {"CINTEG", "c:curve -> curve",
     "The integral from the start of a polynomial curve.", C "d = cinteg(c);",
     cinteg, 0, 9},
    {"CTANGENT", "c:curve t:num normalize:num -> vector",
     "First derivative of the projected curve, or its direction.",
     C "v = ctangent(c, 0.5, true);", ctangent, 0, 9},
    {"CNORMAL", "c:curve t:num -> vector",
     "Unit normal: left of planar curves, the principal one in space.",
     C "v = cnormal(c, 0.5);", cnormal, 0, 9},
    {"CARCLEN", "c:curve fineness:num order:num -> curve",
     "The curve by its arc length within fineness, domain [0, length].",
     C "d = carclen(c, 0.01, 3);", carclen, 0, 9},
    {"CAREA", "c:curve -> curve",
     "Scalar curve of the area swept from the origin; its end is the area of a "
     "closed curve.",
     "d = carea(pcircle(vector(0,0,0), 1));", carea, 0, 9},
    {"MOMENT", "c:curve k:num -> point|vector",
     "Centre of mass (0) or direction of the principal axis (1).",
     C "q = moment(c, 0);", moment, 0, 9},
    {"CBSP_FIT", "pts:list init:curve|list fit:num consts:list -> curve",
     "B-spline near points without order, from a curve or list(length, order, "
     "periodic); fit 1 point distance, 2 squared distance.",
     "c = cbsp_fit(list(point(1,0,0), point(0,1,0), point(-1,0,0), "
     "point(0,-1,0), point(.7,.7,0), point(-.7,.7,0), point(-.7,-.7,0), "
     "point(.7,-.7,0)), list(6,3,1), 1, list(20));",
     cbsp_fit, 0, 7},
    {0}};
