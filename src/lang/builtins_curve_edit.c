/* builtins_curve_edit.c - chapter 8: functions that change curves or take them
 * apart. Each one fetches, calls and returns. */
#include <limits.h>
#include <math.h>

#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/coerce.h"
#include "lang/curve_args.h"
#include "lang/prims_freeform.h"

#define C "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,3,0))); "
#define CB                                                                \
    "cb = cbspline(3, list(ctlpt(E2,0,0), ctlpt(E2,1,1), ctlpt(E2,2,0), " \
    "ctlpt(E2,3,3), ctlpt(E2,4,0)), list(KV_OPEN)); "

/* --- parameters and knots ----------------------------------------------------
 */

static ix_status creparam(ix_call *c)
{
    double t0 = ix__arg_num(c, 1), t1 = ix__arg_num(c, 2);
    ix_param how;
    ix_mv *out;

    if (t0 == t1 && ix__is_param(t0)) {
        IX_TRY(ix__arg_param(c, 1, &how));
        IX_TRY(ix_reknot(c->ctx, ix__arg_mv(c, 0), how, &out));
        return ix__ret_mv(c, 0, out);
    }
    IX_TRY(ix_mv_reparam(c->ctx, ix__arg_mv(c, 0), 0, t0, t1, &out));
    return ix__ret_edited(c, 0, out);
}

static ix_status cregion(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_mv_region(c->ctx, ix__arg_mv(c, 0), 0, ix__arg_num(c, 1),
                        ix__arg_num(c, 2), &out));
    return ix__ret_edited(c, 0, out);
}

static ix_status crefine(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double *knots;
    int n;
    ix_mv *out, *bsp;
    ix_status st;

    IX_TRY(ix__arg_nums(c, 2, &n, &knots));
    c->bad_arg = 3;
    if (!ix__arg_bool(c, 1)) {
        IX_TRY(ix_mv_insert_knots(c->ctx, m, 0, n, knots, &out));
        c->bad_arg = 0;
        return ix__ret_edited(c, 0, out);
    }
    IX_TRY(ix_mv_to_bspline(c->ctx, m, &bsp));
    st = ix_mv_set_knots(c->ctx, bsp, 0, n, knots, &out);
    ix_mv_unref(c->ctx, bsp);
    if (st != IX_OK)
        return st;
    c->bad_arg = 0;
    return ix__ret_mv(c, 0, out);
}

static ix_status cmoebius(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_moebius(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1), &out));
    return ix__ret_edited(c, 0, out);
}

static ix_status knotclean(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_mv_remove_knots(c->ctx, ix__arg_mv(c, 0), 0, 0, &out));
    return ix__ret_edited(c, 0, out);
}

static ix_status knotremove(ix_call *c)
{
    double tol = ix__arg_num(c, 1);
    ix_mv *out;

    if (!(tol >= 0))
        return IX_ARG_FAIL(c, 1, "tolerance %g is negative", tol);
    IX_TRY(ix_mv_remove_knots(c->ctx, ix__arg_mv(c, 0), 0, tol, &out));
    return ix__ret_mv(c, 0, out);
}

/* --- orders and bases --------------------------------------------------------
 */

static ix_status craise(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    int order;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 1, 1, IX_MAX_ORDER, &order));
    if (order <= ix_mv_order(m, 0))
        return IX_ARG_FAIL(c, 1, "order %d is not above the curve's, %d", order,
                           ix_mv_order(m, 0));
    IX_TRY(ix_mv_raise(c->ctx, m, 0, order, &out));
    return ix__ret_edited(c, 0, out);
}

static ix_status creduce(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    int order;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 1, 1, IX_MAX_ORDER, &order));
    if (order >= ix_mv_order(m, 0))
        return IX_ARG_FAIL(c, 1, "order %d is not below the curve's, %d", order,
                           ix_mv_order(m, 0));
    IX_TRY(ix_mv_reduce(c->ctx, m, 0, order, NULL, &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status bzr2bsp(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_mv_to_bspline(c->ctx, ix__arg_mv(c, 0), &out));
    return ix__ret_edited(c, 0, out);
}

static ix_status bsp2bzr(ix_call *c)
{
    return ix__coerce(c->ctx, c->argv[0], IX__BEZIER_TYPE, &c->result);
}

/* --- control points, pieces
 * ---------------------------------------------------- */

static ix_status ceditpt(ix_call *c)
{
    const ix_ctlpt *p = c->argv[1]->u.ctlpt;
    int i;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 2, 0, ix_mv_length(ix__arg_mv(c, 0), 0) - 1, &i));
    c->bad_arg = 2;
    IX_TRY(ix_set_point(c->ctx, ix__arg_mv(c, 0), (size_t)i, p->ncoords,
                        p->rational, p->v, &out));
    c->bad_arg = 0;
    return ix__ret_mv(c, 0, out);
}

static ix_status cdivide(ix_call *c)
{
    ix_mv *half[2];

    IX_TRY(ix_mv_split(c->ctx, ix__arg_mv(c, 0), 0, ix__arg_num(c, 1), half));
    return ix__ret_pair(c, 0, half);
}

/* Puts m (taken over) into the variable's box; name and attributes stay. */
static ix_status replace(ix_call *c, int i, ix_mv *m)
{
    const ix_mv *const one[1] = {m};
    const ix_mvs *mvs = ix__mvs_new(c->ctx, 1, one);

    ix_mv_unref(c->ctx, m);
    if (!mvs)
        return IX_ENOMEM;
    ix__mvs_unref(c->ctx, c->argv[i]->u.mvs);
    c->argv[i]->u.mvs = mvs;
    return IX_OK;
}

static ix_status ffcompat(ix_call *c)
{
    ix_mv *a, *b;
    ix_status st;

    if (c->argv[0]->type != c->argv[1]->type)
        return IX_ARG_FAIL(c, 1, "a %s and a %s cannot be made compatible",
                           ix__obj_type_name(c->argv[0]->type),
                           ix__obj_type_name(c->argv[1]->type));
    IX_TRY(ix_mv_compatible(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                            IX_SAME_ALL, &a, &b));
    st = replace(c, 0, a);
    if (st != IX_OK) {
        ix_mv_unref(c->ctx, b);
        return st;
    }
    return replace(c, 1, b);
}

/* --- two curves
 * ------------------------------------------------------------------ */

static ix_status ffmatch(ix_call *c)
{
    ix_match_opts o = {.rotate = ix__arg_bool(c, 5)};
    int norm;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 2, 2, 4096, &o.length));
    IX_TRY(ix__arg_int(c, 3, 2, 4096, &o.samples));
    IX_TRY(ix__arg_int(c, 4, 2, IX_MAX_ORDER, &o.order));
    IX_TRY(ix__arg_int(c, 6, -4, 4, &norm));
    o.norm = (ix_match_norm)(norm < 0 ? -norm : norm);
    o.allow_negative = norm < 0;
    IX_TRY(
        ix_match(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &o, NULL, &out));
    return ix__ret_mv(c, 1, out);
}

static ix_status cmorph(ix_call *c)
{
    double blend = ix__arg_num(c, 3);
    int method;
    ix_mv *out;
    ix_crvs seq;

    IX_TRY(ix__arg_int(c, 2, 0, 5, &method));
    if (method == 0) {
        IX_TRY(ix_mv_morph(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), blend,
                           &out));
        return ix__ret_mv(c, 0, out);
    }
    IX_TRY(ix_morph(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                    (ix_morph_how){.levels = method == 5,
                                   .by_length = method % 2 == 1,
                                   .follow = method >= 3},
                    blend, &seq));
    return ix__ret_crvs(c, &seq);
}

/* IRIT gives a B-spline, whatever the operands are. */
static ix_status compose(ix_call *c)
{
    ix_mv *out, *bsp;

    IX_TRY(ix_sym_compose(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &out));
    if (ix_mv_dir(out, 0).basis == IX_BSPLINE)
        return ix__ret_mv(c, 1, out);
    if (ix_mv_to_bspline(c->ctx, out, &bsp) != IX_OK) {
        ix_mv_unref(c->ctx, out);
        return IX_ENOMEM;
    }
    ix_mv_unref(c->ctx, out);
    return ix__ret_mv(c, 1, bsp);
}

/* --- decompositions
 * ---------------------------------------------------------------- */

/* Each arc carries the centre of its circle. */
static ix_status add_centers(ix_call *c)
{
    for (int i = 0; i < c->result->u.list.n; i++) {
        ix_obj *arc = c->result->u.list.item[i], *o;
        double center[3];
        ix_status st;

        if (!ix_arc_center(ix__obj_first_mv(arc), center))
            continue;
        o = ix__obj_point(c->ctx, center);
        if (!o)
            return IX_ENOMEM;
        st = ix__attr_set_obj(c->ctx, &arc->attrs, "center", o);
        ix__obj_unref(c->ctx, o);
        if (st != IX_OK)
            return st;
    }
    return IX_OK;
}

static ix_status cbiarcs(ix_call *c)
{
    ix_crvs arcs;

    IX_TRY(ix_biarcs(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1),
                     ix__arg_num(c, 2), NULL, &arcs));
    IX_TRY(ix__ret_crvs(c, &arcs));
    return add_centers(c);
}

static ix_status pieces(ix_call *c, int order)
{
    ix_crvs out;

    IX_TRY(ix_fit_pieces(c->ctx, ix__arg_mv(c, 0), order, ix__arg_num(c, 1),
                         ix__arg_num(c, 2), NULL, &out));
    return ix__ret_crvs(c, &out);
}

static ix_status quadcrvs(ix_call *c)
{
    return pieces(c, 3);
}

static ix_status cubiccrvs(ix_call *c)
{
    return pieces(c, 4);
}

static ix_status cmultires(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_multires how = {.keep_jumps = ix__arg_bool(c, 1),
                       .wavelets = !ix__arg_bool(c, 2)};
    ix_crvs out;
    ix_mv *wavelet;
    int knot;

    if (ix__arg_num(c, 1) == -1) {
        IX_TRY(ix__arg_int(c, 2, 0, INT_MAX - 1, &knot));
        IX_TRY(ix_multires_wavelet(c->ctx, m, knot, &wavelet));
        return ix__ret_mv(c, 0, wavelet);
    }
    IX_TRY(ix_multires_split(c->ctx, m, how, &out));
    return ix__ret_crvs(c, &out);
}

static ix_status decompose(ix_call *c)
{
    ix_mv *f, *g;

    IX_TRY(ix_decompose(c->ctx, ix__arg_mv(c, 0), &f, &g));
    if (f) {
        ix_mv *const pair[2] = {f, g};

        return ix__ret_pair(c, 0, pair);
    }
    return ix__ret(c, ix__obj_list(c->ctx));
}

const ix_builtin ix__builtins_curve_edit[] = {
    {"CREPARAM", "c:curve t0:num t1:num -> curve",
     "The curve on the domain [t0, t1]; with a PARAM_* constant twice, new "
     "knots by that rule.",
     CB "c = creparam(cb, 0, 2);", creparam, 0, 8},
    {"CREGION", "c:curve t0:num t1:num -> curve", "The part over [t0, t1].",
     "h = cregion(circle(vector(0,0,0), 1), 0, 2);", cregion, 0, 8},
    {"CREFINE", "c:curve replace:num knots:list -> curve",
     "Inserts knots, or replaces all of them.",
     C "c = crefine(c, false, list(0.25, 0.5));", crefine, 0, 8},
    {"FFCOMPAT", "a:curve|surface|trivar b:curve|surface|trivar -> nothing",
     "Gives two variables the same point type, orders and knots, in place.",
     C CB "ffcompat(c, cb);", ffcompat, IX_B_SOFT, 8},
    {"CEDITPT", "c:curve p:ctlpt i:num -> curve",
     "A copy with control point i (from 0) replaced.",
     C "d = ceditpt(c, ctlpt(E2,9,9), 1);", ceditpt, 0, 8},
    {"FFMATCH",
     "c1:curve c2:curve reduce:num samples:num order:num rotate:num norm:num "
     "-> curve",
     "c2 reparametrised to correspond to c1; norm 1 ruled, 2 morphing, 3 "
     "walking the dog, 4 bisector, negative: negative pairs allowed.",
     C CB "d = ffmatch(c, cb, 20, 50, 2, false, -2);", ffmatch, IX_B_SOFT, 8},
    {"CMORPH", "c1:curve c2:curve method:num blend:num -> any",
     "Blend of compatible curves (method 0), or curves in steps of blend: 1, 2 "
     "turning edges, scaled by length or size, 3, 4 without tangencies, 5 by "
     "resolution.",
     C "d = cmorph(c, -c, 0, 0.5);", cmorph, 0, 8},
    {"COMPOSE", "f:curve|surface c:curve -> curve",
     "f(c(t)): a curve at a scalar curve, a surface at a planar one.",
     C "d = compose(c, cbezier(list(ctlpt(E1,0), ctlpt(E1,0.2), "
       "ctlpt(E1,1))));",
     compose, 0, 8},
    {"CRAISE", "c:curve order:num -> curve",
     "The same curve with a higher order.", C "d = craise(c, 5);", craise, 0,
     8},
    {"CREDUCE", "c:curve order:num -> curve",
     "The best approximation of lower order; exact if it was raised.",
     C "d = creduce(craise(c, 5), 4);", creduce, 0, 8},
    {"CDIVIDE", "c:curve t:num -> list", "The two parts before and after t.",
     C "l = cdivide(c, 0.4);", cdivide, 0, 8},
    {"BSP2BZR", "x:freeform -> any",
     "Bezier pieces; a single one not in a list.", CB "l = bsp2bzr(cb);",
     bsp2bzr, 0, 8},
    {"BZR2BSP", "x:freeform -> any", "A Bezier as B-spline on [0, 1].",
     C "d = bzr2bsp(c);", bzr2bsp, 0, 8},
    {"CMOEBIUS", "c:curve ratio:num -> curve",
     "Moebius reparametrisation: ratio from weight to weight, the last one "
     "kept; 0: equal end weights.",
     "c = cmoebius(circle(vector(0,0,0), 1), 2);", cmoebius, 0, 8},
    {"CBIARCS", "c:curve tol:num maxangle:num -> list",
     "Circular arcs within tol of a planar curve, none above maxangle degrees, "
     "each with the attribute center.",
     CB "l = cbiarcs(cb, 0.01, 90);", cbiarcs, 0, 8},
    {"CMULTIRES", "c:curve discont:num lsq:num -> any",
     "Curves that add up to c, coarse to fine; lsq false: one B-wavelet each; "
     "discont true keeps jumps, -1: the B-wavelet of knot lsq.",
     CB "l = cmultires(cb, false, true);", cmultires, 0, 8},
    {"QUADCRVS", "c:curve tol:num maxlen:num -> list",
     "Quadratic Bezier pieces within tol, none longer than maxlen > 0.",
     CB "l = quadcrvs(cb, 0.01, 0);", quadcrvs, 0, 8},
    {"CUBICCRVS", "c:curve tol:num maxlen:num -> list",
     "Cubic Bezier pieces within tol, none longer than maxlen > 0.",
     CB "l = cubiccrvs(cb, 0.01, 0);", cubiccrvs, 0, 8},
    {"DECOMPOSE", "c:curve -> list",
     "list(f, g) with f(g(t)) = c(t), or an empty list.",
     C "l = decompose(compose(c, cbezier(list(ctlpt(E1,0), ctlpt(E1,0.2), "
       "ctlpt(E1,1)))));",
     decompose, 0, 8},
    {"KNOTCLEAN", "c:curve -> curve",
     "Removes the knots that do not change the curve.",
     CB "d = knotclean(crefine(cb, false, list(.3)));", knotclean, 0, 8},
    {"KNOTREMOVE", "c:curve tol:num -> curve",
     "Removes as many knots as a change of at most tol allows.",
     CB "d = knotremove(cb, 0.1);", knotremove, 0, 8},
    {0}};
