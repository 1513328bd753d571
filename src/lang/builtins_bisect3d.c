/* builtins_bisect3d.c - bisectors in space (chapter 21 of spec/functions). */
#include "iritx/ops_bisect.h"
#include "iritx/ops_plane.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"
#include "lang/op_args.h"

/* --- curve and point -------------------------------------------------------
 */

/* list(min, max), list(min, max, normal) or list(min, max, 1): the range of the
 * rulings, their planes, or a directrix. */
static ix_status arg_ruling(ix_call *c, int i, ix_ruling *out)
{
    static const char what[] = "list(min, max), list(min, max, normal) or "
                               "list(min, max, 1) is needed";
    const ix_list *l;

    if (i >= c->argc)
        return IX_OK;
    l = &c->argv[i]->u.list;
    if (l->n < 2 || l->n > 3)
        return IX_ARG_FAIL(c, i, "%s, got %d elements", what, l->n);
    for (int k = 0; k < 2; k++) {
        if (l->item[k]->type != IX_OBJ_NUMBER)
            return IX_ARG_FAIL(c, i, "%s", what);
        out->range[k] = l->item[k]->u.num;
    }
    if (out->range[0] == out->range[1])
        return IX_ARG_FAIL(c, i, "an empty range of rulings, %g to %g",
                           out->range[0], out->range[1]);
    if (l->n == 2)
        return IX_OK;
    if (l->item[2]->type == IX_OBJ_NUMBER && l->item[2]->u.num == 1)
        out->kind = IX_RULING_DIRECTRIX;
    else if (l->item[2]->type == IX_OBJ_VECTOR ||
             l->item[2]->type == IX_OBJ_POINT)
        for (int k = 0; k < 3; k++)
            out->normal[k] = l->item[2]->u.pt[k];
    else
        return IX_ARG_FAIL(c, i, "%s", what);
    return IX_OK;
}

static ix_status ret_surface(ix_call *c, ix_mv *m)
{
    IX_TRY(ix__ret_geom(c, -1, m, IX__GEOM_RULED));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

/* Several surfaces with their poles; takes over what s holds. */
static ix_status ret_surfaces(ix_call *c, ix_crvs *s)
{
    ix_obj *list = ix__obj_list(c->ctx), *o;
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < s->n; i++) {
        o = ix__obj_mv(c->ctx, IX_OBJ_SURFACE, ix_mv_ref(s->crv[i]));
        st = o ? ix__tell_poles(c, o, s->crv[i]) : IX_ENOMEM;
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, o);
        else
            ix__obj_unref(c->ctx, o);
    }
    ix_crvs_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

/* One surface, or pieces with a remark where the planes cannot be chosen for
 * all of it. */
static ix_status ruled_bisector(ix_call *c, const ix_operand *x, double alpha,
                                const ix_ruling *r)
{
    const double *n = r->normal;
    ix_op_opts o = ix__op_opts(c);
    ix_crvs pieces;
    ix_mv *m;

    if (n[0] != 0 || n[1] != 0 || n[2] != 0) {
        IX_TRY(ix_pt_crv_bisector3d(c->ctx, x[0].mv, x[1].pt, alpha, r, &o,
                                    NULL, &m));
        return ret_surface(c, m);
    }
    IX_TRY(ix_pt_crv_bisector3d_pieces(c->ctx, x[0].mv, x[1].pt, alpha, r, &o,
                                       &pieces));
    if (pieces.n > 1) {
        ix__remark(c->in,
                   "no planes serve all rulings: %d pieces (list(min, max, 1) "
                   "rules by a directrix, in one piece)",
                   pieces.n);
        return ret_surfaces(c, &pieces);
    }
    m = ix_mv_ref(pieces.crv[0]);
    ix_crvs_free(c->ctx, &pieces);
    return ret_surface(c, m);
}

/* --- two curves ------------------------------------------------------------
 */

/* Function 4: of planar curves, a surface whose section with z = 0 is their
 * untrimmed bisector; C0 joins as IRIT makes them. */
static ix_status where_normals_meet(ix_call *c, const ix_mv *a, const ix_mv *b)
{
    static const ix_op_opts o = {IX_FORM_MINIMAL, 0};
    ix_mv *m;

    IX_TRY(ix_cbisector2d(c->ctx, a, b, 4, &o, &m));
    return ix__ret_mv(c, -1, m);
}

static ix_status cbisector3d(ix_call *c)
{
    ix_op_opts o = ix__op_opts(c);
    ix_ruling r = {.kind = IX_RULING_PLANES};
    ix_operand x[2];
    ix_mv *out;

    IX_TRY(ix__arg_operands(c, 0, IX_OBJ_CURVE, 2,
                            "list(curve, curve) or list(curve, point)", x));
    if (!x[1].mv) {
        IX_TRY(arg_ruling(c, 2, &r));
        return ruled_bisector(c, x, 0.5, &r);
    }
    if (c->argc > 2)
        return IX_ARG_FAIL(c, 2,
                           "only the bisector of a curve and a point is "
                           "ruled");
    if (ix__arg_num(c, 1) == 4)
        return where_normals_meet(c, x[0].mv, x[1].mv);
    IX_TRY(ix_cbisector3d(c->ctx, x[0].mv, x[1].mv, &o, NULL, &out));
    return ix__ret_mv(c, -1, out);
}

/* A planar curve and a point: a curve. */
static ix_status planar_sector(ix_call *c, const ix_operand *x, double alpha)
{
    ix_op_opts o = ix__op_opts(c);
    ix_mv *out;

    IX_TRY(ix_pt_crv_bisector(c->ctx, x[0].mv, x[1].pt, alpha, &o, NULL, &out));
    IX_TRY(ix__ret_mv(c, -1, out));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

static ix_status calphasector(ix_call *c)
{
    static const ix_ruling r = {.kind = IX_RULING_PLANES};
    double alpha = ix__arg_num(c, 1);
    ix_op_opts o = ix__op_opts(c);
    ix_operand x[2];
    ix_mv *out;

    IX_TRY(ix__arg_operands(c, 0, IX_OBJ_CURVE, 2,
                            "list(curve, curve) or list(curve, point)", x));
    if (!x[1].mv && ix_mv_ncoords(x[0].mv) <= 2)
        return planar_sector(c, x, alpha);
    if (!x[1].mv)
        return ruled_bisector(c, x, alpha, &r);
    IX_TRY(ix_calphasector3d(c->ctx, x[0].mv, x[1].mv, alpha, &o, NULL, &out));
    return ix__ret_mv(c, -1, out);
}

/* --- surfaces --------------------------------------------------------------
 */

static ix_status sbisector(ix_call *c)
{
    ix_op_opts o = ix__op_opts(c);
    double q[3];
    ix_mv *out;

    IX_TRY(ix__arg_pt3(c, 1, q));
    IX_TRY(ix_pt_srf_bisector(c->ctx, ix__arg_mv(c, 0), q, &o, NULL, &out));
    return ix__ret_mv(c, -1, out);
}

/* --- poles -----------------------------------------------------------------
 */

static ix_status fffinite(ix_call *c)
{
    ix_obj *list;
    ix_mv_pieces p;
    ix_status st;
    int depth;

    IX_TRY(ix__arg_int(c, 1, 0, 12, &depth));
    if (!(ix__arg_num(c, 2) >= 0))
        return IX_ARG_FAIL(c, 2, "a reach of %g; 0 is without bound",
                           ix__arg_num(c, 2));
    IX_TRY(ix_finite_pieces(c->ctx, ix__arg_mv(c, 0), depth, ix__arg_num(c, 2),
                            &p));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (size_t i = 0; st == IX_OK && i < p.count; i++)
        st = ix__list_add(
            c->ctx, list,
            ix__obj_mv(c->ctx, c->argv[0]->type, ix_mv_ref(p.piece[i])));
    ix_mv_pieces_free(c->ctx, &p);
    return ix__ret_list(c, list, st);
}

/* --- table -----------------------------------------------------------------
 */

#define PAIR                                                        \
    "a = cbezier(list(point(0,0,0), point(1,0,1), point(2,1,0))); " \
    "b = cbezier(list(point(0,2,0), point(0,3,1))); "

const ix_builtin ix__builtins_bisect3d[] = {
    {"CBISECTOR3D", "operands:list func:num [rulings:list] -> surface|list",
     "Exact rational bisector surface of two space curves: S(u, v) has the "
     "same distance from both, with foot points at u and v. Of a curve and a "
     "point: a ruled surface, v along the rulings, which end at planes or, "
     "with list(min, max, 1), are given by a directrix. func 4: of planar "
     "curves the surface whose section with z = 0 is their bisector.",
     PAIR "s = cbisector3d(list(a, b), 1); r = cbisector3d(list(a, point(0, "
          "1, 1)), 1, list(-1, 1));",
     cbisector3d, 0, 21},
    {"CALPHASECTOR", "operands:list alpha:num -> surface|curve|list",
     "As CBISECTOR3D, with the plane that divides the line between the feet "
     "in the ratio alpha, 0 at the first curve, 1 at the second; of a curve "
     "and a point 0 at the curve. Two coordinates and a point: a curve.",
     PAIR "s = calphasector(list(a, b), 0.25);", calphasector, 0, 21},
    {"SBISECTOR", "s:surface p:pt3 -> surface",
     "Exact rational bisector of a surface and a point: on the normal at (u, "
     "v) the point as far from p as from the surface.",
     "s = sbezier(list(list(point(0,0,0), point(1,0,1)), list(point(0,1,1), "
     "point(1,1,0)))); b = sbisector(s, point(1, 1, 5));",
     sbisector, 0, 21},
    {"FFFINITE", "x:freeform depth:num reach:num -> list",
     "The parts of x that are proven finite (weights of one sign), within "
     "reach in every coordinate if that is not 0, by at most depth halvings; "
     "each keeps its domain.",
     PAIR "l = fffinite(cbisector3d(list(a, b), 1), 8, 10);", fffinite, 0, 10},
    {0}};
