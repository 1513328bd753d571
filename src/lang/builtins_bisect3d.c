/* builtins_bisect3d.c - bisectors in space (chapter 21 of spec/functions). */
#include "geom/vec3.h"
#include "iritx/ops_bisect.h"
#include "iritx/ops_plane.h"
#include "iritx/solve.h"
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

static ix_obj *pair_object(ix_ctx *ctx, const double t[2])
{
    const ix_ctlpt p = {.ncoords = 2, .v = {t[0], t[1]}};

    return ix__obj_ctlpt(ctx, &p);
}

/* n pairs of parameters as an attribute of the result. */
static ix_status tell_pairs(ix_call *c, const char *name, int n,
                            const double (*t)[2])
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add(c->ctx, list, pair_object(c->ctx, t[i]));
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, &c->result->attrs, name, list);
    ix__obj_unref(c->ctx, list);
    return st;
}

/* Where both curves have a point in common the surface has none: attributes
 * Meetings, of pairs of parameters, or Overlap, from one pair to another. */
static ix_status tell_meetings(ix_call *c, const ix_report *r)
{
    const double ends[2][2] = {{r->overlap[0][0], r->overlap[1][0]},
                               {r->overlap[0][1], r->overlap[1][1]}};
    int n = r->nmeetings;

    if (ends[0][0] != ends[1][0]) {
        ix__remark(c->in,
                   "the curves run along each other, from %g to %g on the "
                   "first and from %g to %g on the second: the surface has no "
                   "points there (attribute Overlap)",
                   r->overlap[0][0], r->overlap[0][1], r->overlap[1][0],
                   r->overlap[1][1]);
        return tell_pairs(c, "Overlap", 2, ends);
    }
    if (n == 0)
        return IX_OK;
    ix__remark(c->in,
               "the curves meet at the parameters (%g, %g)%s: the surface has "
               "no single point there (attribute Meetings)",
               r->meetings[0][0], r->meetings[0][1], n > 1 ? ", ..." : "");
    return tell_pairs(c, "Meetings",
                      n < IX_REPORT_MEETINGS ? n : IX_REPORT_MEETINGS,
                      r->meetings);
}

static ix_status two_curves(ix_call *c, const ix_operand *x, double alpha)
{
    ix_op_opts o = ix__op_opts(c);
    ix_report rep;
    ix_mv *out;

    IX_TRY(ix_calphasector3d(c->ctx, x[0].mv, x[1].mv, alpha, &o, NULL, &out));
    IX_TRY(ix__ret_mv(c, -1, out));
    IX_TRY(ix_bisector_meetings(c->ctx, x[0].mv, x[1].mv, &rep));
    return tell_meetings(c, &rep);
}

static ix_status cbisector3d(ix_call *c)
{
    ix_ruling r = {.kind = IX_RULING_PLANES};
    ix_operand x[2];

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
    return two_curves(c, x, 0.5);
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
    ix_operand x[2];

    IX_TRY(ix__arg_operands(c, 0, IX_OBJ_CURVE, 2,
                            "list(curve, curve) or list(curve, point)", x));
    if (!x[1].mv && ix_mv_ncoords(x[0].mv) <= 2)
        return planar_sector(c, x, alpha);
    if (!x[1].mv)
        return ruled_bisector(c, x, alpha, &r);
    return two_curves(c, x, alpha);
}

/* Both sheets of the true locus. */
static ix_status cratiosector(ix_call *c)
{
    const ix_mv **crv;
    ix_crvs s;
    int n;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
    if (n != 2)
        return IX_ARG_FAIL(c, 0, "list(curve, curve) is needed, got %d curves",
                           n);
    IX_TRY(ix_ratio_sector(c->ctx, crv[0], crv[1], ix__arg_num(c, 1),
                           ix__arg_num(c, 2), NULL, &s));
    return ret_surfaces(c, &s);
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

/* --- on the sphere ----------------------------------------------------------
 */

/* Points of the curve with directions of length 1, as a curve of order 2. */
static ix_status on_sphere(ix_call *c, int n, double (*x)[3])
{
    ix_dir d = {.basis = IX_BSPLINE, .order = 2, .length = n};
    double *knots, *pts;
    ix_mv *m;

    IX_SCRATCH(c->ctx, knots, n + 2);
    IX_SCRATCH(c->ctx, pts, 3 * (size_t)n);
    for (int i = 0; i < n; i++) {
        (void)ix__unit3(x[i], x[i]);
        knots[i + 1] = i;
        for (int k = 0; k < 3; k++)
            pts[k * n + i] = x[i][k];
    }
    knots[0] = 0;
    knots[n + 1] = n - 1;
    d.knots = knots;
    IX_TRY(ix_mv_new(c->ctx, 1, &d, 3, false, pts, &m));
    return ix__ret_mv(c, -1, m);
}

enum { SPHERE_SAMPLES = 200 };

/* m, in the plane z = 1, on the sphere. */
static ix_status sampled_on_sphere(ix_call *c, const ix_mv *m)
{
    double dom[2], w[4], (*x)[3];

    IX_SCRATCH(c->ctx, x, SPHERE_SAMPLES + 1);
    ix_mv_domain(m, 0, dom);
    for (int i = 0; i <= SPHERE_SAMPLES; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * i / SPHERE_SAMPLES;

        IX_TRY(ix_mv_eval(c->ctx, m, &t, w));
        for (int k = 0; k < 3; k++)
            x[i][k] = w[k + 1];
    }
    return on_sphere(c, SPHERE_SAMPLES + 1, x);
}

/* The directions t1 x t2 of the feet along a solution curve. */
static ix_status sphere_line(ix_call *c, const ix_operand *x,
                             const ix_solution_curve *k)
{
    double(*p)[3];

    IX_SCRATCH(c->ctx, p, k->n);
    for (int v = 0; v < k->n; v++) {
        double t[2][3];

        for (int i = 0; i < 2; i++)
            IX_TRY(ix_tangent(c->ctx, x[i].mv, k->x[2 * v + i], true, t[i]));
        ix__cross3(t[0], t[1], p[v]);
        if (v > 0 && ix__dot3(p[v], p[v - 1]) < 0)
            for (int j = 0; j < 3; j++)
                p[v][j] = -p[v][j];
    }
    return on_sphere(c, k->n, p);
}

/* All lines of the bisector of two curves, without their antipodes. */
static ix_status sphere_lines(ix_call *c, const ix_operand *x, const ix_mv *f,
                              double tol)
{
    const ix_equation eq = {.f = f, .axis = 0, .rel = IX_EQUAL_ZERO};
    const ix_curves_opts o = {.tol = tol < 0.1 ? tol : 0.1};
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;
    ix_solution_curves s = {0};

    if (st == IX_OK)
        st = ix_solve_curves(c->ctx, 1, &eq, &o, &s);
    for (int i = 0; st == IX_OK && i < s.ncurves; i++) {
        st = sphere_line(c, x, &s.curve[i]);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, c->result);
        c->result = NULL;
    }
    ix_solution_curves_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

/* The determinant of C1 - C2, C1', C2' is the weight of the bisector surface.
 */
static ix_status two_sphere_curves(ix_call *c, const ix_operand *x, double tol)
{
    ix_op_opts o = ix__op_opts(c);
    ix_mv *s, *f;
    ix_status st;

    IX_TRY(ix_cbisector3d(c->ctx, x[0].mv, x[1].mv, &o, NULL, &s));
    if (tol < 0)
        return ix__ret_mv(c, -1, s);
    st = ix_mv_scalar(c->ctx, s, 0, &f);
    ix_mv_unref(c->ctx, s);
    IX_TRY(st);
    if (tol == 0)
        return ix__ret_mv(c, -1, f);
    st = sphere_lines(c, x, f, tol);
    ix_mv_unref(c->ctx, f);
    return st;
}

static ix_status sprbisect(ix_call *c)
{
    double tol = ix__arg_num(c, 1);
    ix_op_opts o = ix__op_opts(c);
    ix_operand x[2];
    ix_status st;
    ix_mv *m;

    IX_TRY(ix__arg_operands(c, 0, IX_OBJ_CURVE, 2,
                            "list(curve, curve) or list(point, curve)", x));
    if (x[1].mv)
        return two_sphere_curves(c, x, tol);
    IX_TRY(ix_sphere_bisector_point(c->ctx, x[0].mv, x[1].pt, &o, &m));
    if (!(tol > 0))
        return ix__ret_mv(c, -1, m);
    st = sampled_on_sphere(c, m);
    ix_mv_unref(c->ctx, m);
    return st;
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
    {"CRATIOSECTOR", "curves:list alpha:num tol:num -> list",
     "The points whose distances from two space curves have the ratio alpha : "
     "1 "
     "- alpha, as CALPHASECTOR has not: two sheets over both parameters, "
     "interpolated to the tolerance.",
     "a = cbezier(list(point(0,0,0), point(1,0,0.2))); b = cbezier(list(point("
     "0,0,2), point(0.3,1,2))); l = cratiosector(list(a, b), 0.4, 1e-4);",
     cratiosector, 0, 21},
    {"SBISECTOR", "s:surface p:pt3 -> surface",
     "Exact rational bisector of a surface and a point: on the normal at (u, "
     "v) the point as far from p as from the surface.",
     "s = sbezier(list(list(point(0,0,0), point(1,0,1)), list(point(0,1,1), "
     "point(1,1,0)))); b = sbisector(s, point(1, 1, 5));",
     sbisector, 0, 21},
    {"SPRBISECT", "operands:list tol:num -> curve|surface|list",
     "Bisector on the unit sphere. Of a point and a curve: in the plane z = 1 "
     "(tol > 0: on the sphere, 200 pieces). Of two curves: 0 the field over "
     "both parameters that vanishes at pairs of feet, > 0 its zeros as curves "
     "on the sphere, < 0 the bisector surface whose weight it is.",
     "c = arc(vector(1, 0, 0), vector(0, 0, 0), vector(0, 1, 0)); b = "
     "sprbisect(list(point(0, 0, 1), c), 0);",
     sprbisect, 0, 21},
    {"FFFINITE", "x:freeform depth:num reach:num -> list",
     "The parts of x that are proven finite (weights of one sign), within "
     "reach in every coordinate if that is not 0, by at most depth halvings; "
     "each keeps its domain.",
     PAIR "l = fffinite(cbisector3d(list(a, b), 1), 8, 10);", fffinite, 0, 10},
    {0}};
