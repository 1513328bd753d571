/* builtins_trivar.c - trivariates and triangular patches (chapters 15 and 17
 * of spec/functions). */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/prims_freeform.h"

/* --- trivariates ------------------------------------------------------- */

static ix_status tbezier(ix_call *c)
{
    return ix__ret_mesh(c, 3, IX_BEZIER);
}

static ix_status tbspline(ix_call *c)
{
    return ix__ret_bspline(c, 3, "trivariate");
}

static ix_status ruledtv(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_srf_ruled(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_TRIVAR_RULED);
}

/* --- triangular patches ------------------------------------------------ */

/* A patch of the given shape from a list of exactly its points; knots NULL
 * unless it is a B-spline. */
static ix_status make_trisrf(ix_call *c, int pts_arg, ix_tri_kind kind,
                             int length, int order, const double *knots)
{
    int n, ncoords;
    bool rational;
    double *pts;
    ix_trisrf *t;

    IX_TRY(ix__arg_points(c, c->argv[pts_arg], &n, &ncoords, &rational, &pts));
    t = ix__trisrf_new(c->ctx, kind, length, order, ncoords, rational);
    if (!t)
        return IX_ENOMEM;
    if (n != t->npts) {
        ix_status st = IX_ARG_FAIL(c, pts_arg, "%d points, the patch has %d", n,
                                   t->npts);

        ix__trisrf_unref(c->ctx, t);
        return st;
    }
    memcpy(t->pts, pts, (size_t)(ncoords + rational) * (size_t)n * sizeof *pts);
    if (knots)
        memcpy(t->knots, knots, (size_t)t->nknots * sizeof *knots);
    return ix__ret(c, ix__obj_trisrf(c->ctx, t));
}

static ix_status tsbezier(ix_call *c)
{
    int order;

    IX_TRY(ix__arg_int(c, 0, 1, IX_MAX_ORDER, &order));
    return make_trisrf(c, 1, IX_TRI_BEZIER, order, order, NULL);
}

static ix_status tsbspline(ix_call *c)
{
    int length, order;
    ix_dir dir;

    IX_TRY(ix__arg_int(c, 0, 1, 10000, &length));
    IX_TRY(ix__arg_int(c, 1, 1, IX_MAX_ORDER, &order));
    IX_TRY(ix__arg_knots(c, 3, c->argv[3], order, length, &dir));
    if (dir.periodic)
        return IX_ARG_FAIL(c, 3, "a triangular patch cannot be periodic");
    return make_trisrf(c, 2, IX_TRI_BSPLINE, length, order, dir.knots);
}

static ix_status tsgregory(ix_call *c)
{
    int order;

    IX_TRY(ix__arg_int(c, 0, 5, 5, &order));
    return make_trisrf(c, 1, IX_TRI_GREGORY, order, order, NULL);
}

/* The patch of argument 0, which must be a Bezier one. */
static ix_status bezier_patch(ix_call *c, const ix_trisrf **t)
{
    *t = c->argv[0]->u.tri.item[0];
    if ((*t)->kind == IX_TRI_BEZIER)
        return IX_OK;
    c->bad_arg = 1;
    return IX_FAIL(c->ctx, IX_EUNABLE,
                   "only triangular Bezier patches can be evaluated");
}

static ix_status tseval(ix_call *c)
{
    double v[IX_MAX_COORDS + 1], uvw[3];
    const ix_trisrf *t;

    IX_TRY(bezier_patch(c, &t));
    for (int k = 0; k < 3; k++)
        uvw[k] = ix__arg_num(c, k + 1);
    IX_TRY(ix_tri_eval(c->ctx, t->order, t->ncoords + t->rational, t->pts, uvw,
                       v));
    return ix__ret_ctlpt(c, t->ncoords, t->rational, v);
}

static ix_status tsderive(ix_call *c)
{
    const ix_trisrf *t;
    int dir, order;
    ix_trisrf *out;

    IX_TRY(bezier_patch(c, &t));
    IX_TRY(ix__arg_dir(c, 1, 3, &dir));
    order = t->order > 1 ? t->order - 1 : 1;
    out = ix__trisrf_new(c->ctx, IX_TRI_BEZIER, order, order, t->ncoords,
                         t->rational);
    if (!out)
        return IX_ENOMEM;
    ix_tri_derive(t->order, t->ncoords + t->rational, dir, t->pts, out->pts);
    return ix__ret(c, ix__obj_trisrf(c->ctx, out));
}

/* The projected derivative of t in direction dir at uvw, 3 coordinates. */
static ix_status tri_tangent(ix_call *c, const ix_trisrf *t, int dir,
                             const double uvw[3], double out[3])
{
    int axes = t->ncoords + t->rational,
        order = t->order > 1 ? t->order - 1 : 1;
    double p[IX_MAX_COORDS + 1], d[IX_MAX_COORDS + 1], *pts;

    IX_SCRATCH(c->ctx, pts, (size_t)axes * (size_t)t->npts);
    ix_tri_derive(t->order, axes, dir, t->pts, pts);
    IX_TRY(ix_tri_eval(c->ctx, t->order, axes, t->pts, uvw, p));
    IX_TRY(ix_tri_eval(c->ctx, order, axes, pts, uvw, d));
    for (int k = 0; k < 3; k++)
        out[k] = k >= t->ncoords ? 0
                 : t->rational   ? (d[k + 1] - p[k + 1] / p[0] * d[0]) / p[0]
                                 : d[k];
    return IX_OK;
}

static ix_status tsnormal(ix_call *c)
{
    double uvw[3], du[3], dv[3], n[3], len;
    const ix_trisrf *t;

    IX_TRY(bezier_patch(c, &t));
    for (int k = 0; k < 3; k++)
        uvw[k] = ix__arg_num(c, k + 1);
    IX_TRY(tri_tangent(c, t, 0, uvw, du));
    IX_TRY(tri_tangent(c, t, 1, uvw, dv));
    ix__cross3(dv, du, n);
    len = ix__len3(du) * ix__len3(dv);
    /* Half of the digits must be left, as for surfaces. */
    if (!(ix__unit3(n, n) > 1e-10 * len))
        return IX_FAIL(c->ctx, IX_EDOMAIN,
                       "the patch has no normal at (%g, %g, %g)", uvw[0],
                       uvw[1], uvw[2]);
    return ix__ret_vector(c, n);
}

/* --- table ------------------------------------------------------------- */

#define T                                                                    \
    "t = tbezier(list(list(list(ctlpt(E1,0), ctlpt(E1,1)), "                 \
    "list(ctlpt(E1,2), ctlpt(E1,5))), list(list(ctlpt(E1,3), ctlpt(E1,4)), " \
    "list(ctlpt(E1,9), ctlpt(E1,7))))); "
#define S                                                       \
    "s = sbezier(list(list(ctlpt(E3,0,0,0), ctlpt(E3,1,0,0)), " \
    "list(ctlpt(E3,0,1,0), ctlpt(E3,1,1,1)))); "
#define TRI                                                   \
    "t = tsbezier(2, list(ctlpt(E3,0,0,0), ctlpt(E3,1,0,0), " \
    "ctlpt(E3,0,1,0))); "

const ix_builtin ix__builtins_trivar[] = {
    {"TFROMSRFS", "srfs:list order:num kv:num -> trivar",
     "Trivariate with the surfaces as control layers along w, KV_OPEN, "
     "KV_FLOAT or KV_PERIODIC.",
     S "t = tfromsrfs(list(s, s * trans(vector(0,0,3))), 2, KV_OPEN);",
     ix__prim_layers, 0, 15},
    {"STRIVAR", "t:trivar dir:num p:num -> surface",
     "Surface with one parameter fixed (COL u, ROW v, DEPTH w).",
     T "s = strivar(t, DEPTH, 0.5);", ix__prim_fix, 0, 15},
    {"TEVAL", "t:trivar u:num v:num w:num -> ctlpt",
     "The point at (u, v, w), not projected.", T "q = teval(t, .5, .5, .5);",
     ix__prim_eval, 0, 15},
    {"TREFINE", "t:trivar dir:num replace:bool knots:list -> trivar",
     "Knots inserted, or with replace the whole knot vector exchanged.",
     T "r = trefine(t, ROW, false, list(0.5));", ix__prim_refine, 0, 15},
    {"TBSPLINE", "uo:num vo:num wo:num mesh:list kvs:list -> trivar",
     "B-spline trivariate; innermost lists along u, then v, then w.",
     "t = tbspline(2, 2, 2, list(list(list(ctlpt(E1,0), ctlpt(E1,1)), "
     "list(ctlpt(E1,0), ctlpt(E1,1))), list(list(ctlpt(E1,0), ctlpt(E1,1)), "
     "list(ctlpt(E1,0), ctlpt(E1,1)))), list(list(KV_OPEN), list(KV_OPEN), "
     "list(KV_OPEN)));",
     tbspline, 0, 15},
    {"TBEZIER", "mesh:list -> trivar",
     "Bezier trivariate; innermost lists along u, then v, then w.", T, tbezier,
     0, 15},
    {"TREPARAM", "t:trivar dir:num p0:num p1:num -> trivar",
     "The same shape with the domain of one direction moved to [p0, p1].",
     T "r = treparam(t, DEPTH, 0, 2);", ix__prim_reparam, 0, 15},
    {"RULEDTV", "s1:surface s2:surface -> trivar",
     "Linear blend of two surfaces, w from 0 to 1.",
     S "t = ruledtv(s, s * trans(vector(0,0,3)));", ruledtv, 0, 15},
    {"TDERIVE", "t:trivar dir:num -> trivar", "Partial derivative.",
     T "d = tderive(t, DEPTH);", ix__prim_derive, 0, 15},
    {"TDIVIDE", "t:trivar dir:num p:num -> list",
     "The two parts below and above a parameter.",
     T "l = tdivide(t, DEPTH, 0.5);", ix__prim_divide, 0, 15},
    {"TRAISE", "t:trivar dir:num order:num -> trivar",
     "The same shape with a higher order in one direction.",
     T "r = traise(t, DEPTH, 4);", ix__prim_raise, IX_B_SOFT, 15},
    {"TREGION", "t:trivar dir:num p0:num p1:num -> trivar",
     "The part between two parameters.", T "r = tregion(t, COL, 0.1, 0.5);",
     ix__prim_region, 0, 15},
    {"SMESH", "t:trivar dir:num i:num -> surface",
     "Surface of the control points with one index, counted from 0, fixed.",
     T "s = smesh(t, DEPTH, 0);", ix__prim_layer, 0, 15},
    {"TEDITPT", "t:trivar p:ctlpt i:num j:num k:num -> trivar",
     "A copy with control point (i, j, k), counted from 0, replaced.",
     T "r = teditpt(t, ctlpt(E1, 20), 0, 0, 0);", ix__prim_edit, 0, 15},
    {"TMORPH", "t1:trivar t2:trivar blend:num -> trivar",
     "(1 - blend) t1 + blend t2, which must be compatible.",
     T "r = tmorph(t, t, 0.5);", ix__prim_morph, 0, 15},

    {"TINTPSRFS", "srfs:list order:num kv:num param:num -> trivar",
     "Trivariate through all surfaces, w spaced by PARAM_*.",
     S "t = tintpsrfs(list(s, s * trans(vector(0,0,1)), s * "
       "trans(vector(0,0,3))), 3, KV_OPEN, PARAM_CHORD);",
     ix__prim_skin, 0, 15},

    {"TSBEZIER", "order:num pts:list -> trisrf",
     "Triangular Bezier patch of order (order + 1) / 2 points: rows of falling "
     "length, the first along u^(order-1) .. v^(order-1).",
     TRI, tsbezier, 0, 17},
    {"TSBSPLINE", "length:num order:num pts:list kv:list -> trisrf",
     "Triangular B-spline patch (kept and saved, not evaluated).",
     "t = tsbspline(3, 2, list(ctlpt(E3,0,0,0), ctlpt(E3,1,0,0), "
     "ctlpt(E3,2,0,0), ctlpt(E3,0,1,0), ctlpt(E3,1,1,0), ctlpt(E3,0,2,0)), "
     "list(KV_OPEN));",
     tsbspline, 0, 17},
    {"TSGREGORY", "order:num pts:list -> trisrf",
     "Triangular Gregory patch of order 5, 18 points (kept and saved, not "
     "evaluated).",
     "l = nil(); for (i = 1, 1, 18, snoc(point(i, i * i, 0), l)); "
     "t = tsgregory(5, l);",
     tsgregory, 0, 17},
    {"TSEVAL", "t:trisrf u:num v:num w:num -> ctlpt",
     "The point at barycentric coordinates with u + v + w = 1.",
     TRI "q = tseval(t, .2, .3, .5);", tseval, 0, 17},
    {"TSDERIVE", "t:trisrf dir:num -> trisrf",
     "Derivative with respect to u (COL) or v (ROW), w = 1 - u - v, or to w "
     "(DEPTH), u = 1 - v - w.",
     TRI "d = tsderive(t, COL);", tsderive, 0, 17},
    {"TSNORMAL", "t:trisrf u:num v:num w:num -> vector",
     "Unit normal, dT/dv x dT/du with w = 1 - u - v.",
     TRI "n = tsnormal(t, .2, .3, .5);", tsnormal, 0, 17},
    {0}};
