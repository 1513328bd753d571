/* builtins_bisect2d.c - bisectors in the plane (chapter 21 of spec/functions).
 */
#include <math.h>
#include <string.h>

#include "iritx/ops_bisect.h"
#include "iritx/ops_plane.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "lang/op_args.h"

/* --- pieces as objects -----------------------------------------------------
 */

/* An E2 curve of order 2 through n points double[n][2], its knots u[n]; takes
 * no memory over. */
static ix_status polyline(ix_ctx *ctx, int n, const double *u, const double *x,
                          ix_mv **out)
{
    ix_dir d = {.basis = IX_BSPLINE, .order = 2, .length = n};
    double *knots, *pts;

    IX_SCRATCH(ctx, knots, n + 2);
    IX_SCRATCH(ctx, pts, 2 * n);
    for (int i = 0; i < n; i++) {
        knots[i + 1] = u[i];
        pts[i] = x[2 * i];
        pts[n + i] = x[2 * i + 1];
    }
    knots[0] = u[0];
    knots[n + 1] = u[n - 1];
    d.knots = knots;
    return ix_mv_new(ctx, 1, &d, 2, false, pts, out);
}

/* Distance of vertices i and k. */
static double apart(const double *x, int i, int k)
{
    return hypot(x[2 * i] - x[2 * k], x[2 * i + 1] - x[2 * k + 1]);
}

/* Knots of n vertices from 0 to 1 by their distances; points that fall
 * together are left out of x and y (if not NULL), but never the last. Returns
 * how many are left. */
static int by_length(int n, double *x, double *y, double *u)
{
    double size = 0.0, sum;
    int m = 1;

    for (int i = 1; i < n; i++)
        size += apart(x, i, i - 1);
    u[0] = 0.0;
    for (int i = 1; i < n; i++) {
        if (!(apart(x, i, m - 1) > 1e-12 * size)) {
            if (i + 1 < n)
                continue;
            m = m > 1 ? m - 1 : 1; /* the one before gives way */
        }
        u[m] = u[m - 1] + apart(x, i, m - 1);
        memmove(x + 2 * m, x + 2 * i, 2 * sizeof(double));
        if (y)
            memmove(y + 2 * m, y + 2 * i, 2 * sizeof(double));
        m++;
    }
    sum = u[m - 1];
    for (int i = 1; i < m; i++)
        u[i] /= sum;
    u[m - 1] = 1.0;
    return m;
}

static ix_status set_pair(ix_ctx *ctx, ix_obj *o, const char *name, double a,
                          double b)
{
    ix_obj *l = ix__obj_list(ctx);
    ix_status st = l ? ix__list_add_num(ctx, l, a) : IX_ENOMEM;

    if (st == IX_OK)
        st = ix__list_add_num(ctx, l, b);
    if (st == IX_OK)
        st = ix__attr_set_obj(ctx, &o->attrs, name, l);
    ix__obj_unref(ctx, l);
    return st;
}

/* Kind, Foot1, Foot2, Component, Side, Unbounded, Joined. */
static ix_status describe(ix_ctx *ctx, ix_obj *o, const ix_bisector_piece *p)
{
    static const char *const kinds[] = {"point-point", "point-curve",
                                        "curve-curve"};
    const double *z = p->foot + 2 * (p->n - 1);
    int far = (p->unbounded[0] ? 1 : 0) + (p->unbounded[1] ? 2 : 0);

    if (p->side)
        IX_TRY(ix__attr_set_int(ctx, &o->attrs, "Side", p->side));
    if (far)
        IX_TRY(ix__attr_set_int(ctx, &o->attrs, "Unbounded", far));
    if (p->joined)
        IX_TRY(ix__attr_set_int(ctx, &o->attrs, "Joined", 1));
    IX_TRY(ix__attr_set_int(ctx, &o->attrs, "Component", p->component + 1));
    IX_TRY(set_pair(ctx, o, "Foot2", p->foot[1], z[1]));
    IX_TRY(set_pair(ctx, o, "Foot1", p->foot[0], z[0]));
    return ix__attr_set_string(ctx, &o->attrs, "Kind", kinds[p->kind]);
}

/* The polyline with its feet as the attribute Feet, and what it is exactly, if
 * that is a conic. */
static ix_status curve_curve(ix_ctx *ctx, const ix_bisector_piece *p,
                             ix_obj **out)
{
    double *u, *x, *y;
    ix_mv *m, *feet;
    ix_obj *o;
    ix_status st;
    int n;

    IX_SCRATCH(ctx, u, p->n);
    IX_SCRATCH(ctx, x, 2 * p->n);
    IX_SCRATCH(ctx, y, 2 * p->n);
    memcpy(x, p->x, (size_t)(2 * p->n) * sizeof *x);
    memcpy(y, p->foot, (size_t)(2 * p->n) * sizeof *y);
    n = by_length(p->n, x, y, u);
    IX_TRY(polyline(ctx, n, u, x, &m));
    *out = ix__obj_mv(ctx, IX_OBJ_CURVE, m);
    if (!*out)
        return IX_ENOMEM;
    st = polyline(ctx, n, u, y, &feet);
    o = st == IX_OK ? ix__obj_mv(ctx, IX_OBJ_CURVE, feet) : NULL;
    if (st == IX_OK)
        st = o ? ix__attr_set_obj(ctx, &(*out)->attrs, "Feet", o) : IX_ENOMEM;
    ix__obj_unref(ctx, o);
    if (st != IX_OK || !p->exact)
        return st;
    o = ix__obj_mv(ctx, IX_OBJ_CURVE, ix_mv_ref(p->exact));
    st = o ? ix__attr_set_obj(ctx, &(*out)->attrs, "Exact", o) : IX_ENOMEM;
    ix__obj_unref(ctx, o);
    return st;
}

static ix_status piece_object(ix_ctx *ctx, const ix_bisector_piece *p,
                              ix_obj **out)
{
    ix_status st = IX_OK;

    *out = NULL;
    if (p->exact && p->kind != IX_CURVE_CURVE)
        *out = ix__obj_mv(ctx, IX_OBJ_CURVE, ix_mv_ref(p->exact));
    else
        st = curve_curve(ctx, p, out);
    if (st == IX_OK && !*out)
        st = IX_ENOMEM;
    if (st == IX_OK)
        st = describe(ctx, *out, p);
    if (st != IX_OK) {
        ix__obj_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}

/* All pieces as they are. */
static ix_status pieces(ix_call *c, const ix_bisector *b)
{
    ix_obj *list = ix__obj_list(c->ctx), *o;
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < b->n; i++) {
        st = piece_object(c->ctx, &b->piece[i], &o);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, o);
    }
    return ix__ret_list(c, list, st);
}

/* --- point and curve -------------------------------------------------------
 */

static ix_status untrimmed(ix_call *c, const double q[2])
{
    ix_op_opts o = ix__op_opts(c);
    ix_mv *m;

    IX_TRY(ix_pt_crv_bisector(c->ctx, ix__arg_mv(c, 0), q, 0.5, &o, NULL, &m));
    IX_TRY(ix__ret_mv(c, 0, m));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

static ix_status ptcrvbisect(ix_call *c)
{
    ix_bisector b;
    ix_status st;
    double q[3];
    int trim;

    IX_TRY(ix__arg_pt3(c, 1, q));
    IX_TRY(ix__arg_int(c, 2, 0, 2, &trim));
    if (trim == 0)
        return untrimmed(c, q);
    IX_TRY(ix_bisect_pt_crv(c->ctx, ix__arg_mv(c, 0), q, trim == 2, 0, &b));
    st = pieces(c, &b);
    ix_bisector_free(c->ctx, &b);
    return st;
}

static ix_obj *special_object(ix_ctx *ctx, const ix_pt_crv_special *s)
{
    static const char *const marks[] = {
        "inflection", "infinity", "pole", "cusp", "extraordinary", "crossing"};
    ix_obj *o = ix__obj_number(ctx, s->t), *p = NULL;
    ix_status st = o ? IX_OK : IX_ENOMEM;
    double x[3] = {s->b[0], s->b[1], 0.0};

    if (st == IX_OK && isfinite(x[0]) && isfinite(x[1])) {
        p = ix__obj_point(ctx, x);
        st = p ? ix__attr_set_obj(ctx, &o->attrs, "Point", p) : IX_ENOMEM;
        ix__obj_unref(ctx, p);
    }
    if (st == IX_OK && s->mark == IX_CROSSING)
        st = ix__attr_set_real(ctx, &o->attrs, "Partner", s->other);
    if (st == IX_OK)
        st = ix__attr_set_string(ctx, &o->attrs, "Kind", marks[s->mark]);
    if (st == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status ptcrvspecial(ix_call *c)
{
    ix_pt_crv_special *s;
    ix_obj *list;
    ix_status st;
    double q[3];
    int n;

    IX_TRY(ix__arg_pt3(c, 1, q));
    IX_TRY(ix_pt_crv_specials(c->ctx, ix__arg_mv(c, 0), q, &s, &n));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add(c->ctx, list, special_object(c->ctx, &s[i]));
    ix_pt_crv_specials_free(c->ctx, s, n);
    return ix__ret_list(c, list, st);
}

/* --- two curves ------------------------------------------------------------
 */

/* The pieces from first on that are joined, as one polyline; how many. */
static ix_status chain(ix_ctx *ctx, const ix_bisector *b, int first,
                       ix_obj **out, int *count)
{
    int last = first, n = 0, m = 0;
    double *u, *x;
    ix_mv *line;

    *out = NULL;
    while (last + 1 < b->n && b->piece[last + 1].joined)
        last++;
    for (int i = first; i <= last; i++)
        n += b->piece[i].n;
    IX_SCRATCH(ctx, u, n);
    IX_SCRATCH(ctx, x, 2 * n);
    for (int i = first; i <= last; i++) {
        memcpy(x + 2 * m, b->piece[i].x,
               (size_t)(2 * b->piece[i].n) * sizeof *x);
        m += b->piece[i].n;
    }
    *count = last - first + 1;
    n = by_length(n, x, NULL, u);
    IX_TRY(polyline(ctx, n, u, x, &line));
    *out = ix__obj_mv(ctx, IX_OBJ_CURVE, line);
    n = (b->piece[first].unbounded[0] ? 1 : 0) +
        (b->piece[last].unbounded[1] ? 2 : 0);
    if (!*out)
        return IX_ENOMEM;
    return n ? ix__attr_set_int(ctx, &(*out)->attrs, "Unbounded", n) : IX_OK;
}

static ix_status chains(ix_call *c, const ix_bisector *b)
{
    ix_obj *list = ix__obj_list(c->ctx), *o;
    ix_status st = list ? IX_OK : IX_ENOMEM;
    int n;

    for (int i = 0; st == IX_OK && i < b->n; i += n) {
        st = chain(c->ctx, b, i, &o, &n);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, o);
        else
            ix__obj_unref(c->ctx, o);
    }
    return ix__ret_list(c, list, st);
}

static ix_status crvbisect(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0), *z = ix__arg_mv(c, 1);
    double tol = ix__arg_num(c, 2);
    ix_bisector b;
    ix_status st;

    if (!(tol >= 0.0 && isfinite(tol)))
        return IX_ARG_FAIL(c, 2,
                           "a tolerance of %g: positive, relative to the "
                           "size of both curves, or 0 for 1e-4",
                           tol);
    IX_TRY(ix_bisect_crv_crv(c->ctx, 1, &a, 1, &z, tol, &b));
    st = chains(c, &b);
    ix_bisector_free(c->ctx, &b);
    return st;
}

/* Ends of both curves: "FP", "NFP1", "NFP2". */
static ix_status set_ends(ix_call *c, const ix_bisector *b)
{
    static const char *const names[] = {"FP", "NFP1", "NFP2"};
    ix_end_class end[4];
    ix_obj *l = ix__obj_list(c->ctx);
    ix_status st = l ? IX_OK : IX_ENOMEM;

    ix_bisector_ends(b, ix__arg_mv(c, 0), ix__arg_mv(c, 1), end);
    for (int i = 0; st == IX_OK && i < 4; i++)
        st = ix__list_add(
            c->ctx, l,
            ix__obj_string(c->ctx, names[end[i]], strlen(names[end[i]])));
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, &c->result->attrs, "Ends", l);
    ix__obj_unref(c->ctx, l);
    return st;
}

static ix_status segbisect(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0), *z = ix__arg_mv(c, 1);
    ix_bisector b;
    ix_status st;

    IX_TRY(ix_bisect_crv_crv(c->ctx, 1, &a, 1, &z, 0, &b));
    st = pieces(c, &b);
    if (st == IX_OK)
        st = set_ends(c, &b);
    ix_bisector_free(c->ctx, &b);
    return st;
}

/* A point of a piece of SEGBISECT: of an exact one the value, else the circle
 * that touches both curves. */
static ix_status bisecteval(ix_call *c)
{
    const ix_mv *piece = ix__arg_mv(c, 0);
    const ix_attr *a = ix__attr_find(c->argv[0]->attrs, "Feet");
    const ix_attr *side = ix__attr_find(c->argv[0]->attrs, "Side");
    double t = ix__arg_num(c, 3), foot[2], p[3] = {0, 0, 0}, r;

    if (piece->ncoords != 2)
        return IX_ARG_FAIL(c, 0,
                           "a curve of %d coordinates; a piece of a planar "
                           "bisector, as SEGBISECT gives it, is wanted",
                           piece->ncoords);
    if (!a || a->type != IX_ATTR_OBJ || a->obj->type != IX_OBJ_CURVE) {
        IX_TRY(ix_mv_point(c->ctx, piece, &t, p));
        return ix__ret(c, ix__obj_point(c->ctx, p));
    }
    if (ix__obj_first_mv(a->obj)->ncoords != 2)
        return IX_ARG_FAIL(c, 0,
                           "its attribute Feet has %d coordinates; a curve of "
                           "parameters on both curves is wanted",
                           ix__obj_first_mv(a->obj)->ncoords);
    IX_TRY(ix_mv_point(c->ctx, ix__obj_first_mv(a->obj), &t, foot));
    IX_TRY(ix_bisector_touch(
        c->ctx, ix__arg_mv(c, 1), ix__arg_mv(c, 2),
        side && side->type == IX_ATTR_INT && side->i < 0 ? -1 : 1, foot, p,
        &r));
    return ix__ret(c, ix__obj_point(c->ctx, p));
}

/* --- the functions of IRIT -------------------------------------------------
 */

/* Polylines as curves of order 2. */
static ix_status ret_lines(ix_call *c, const ix_lines *l)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;
    const double(*p)[3] = (const double(*)[3])l->pt;
    double *x, *u;
    ix_mv *m;

    for (int i = 0; st == IX_OK && i < l->n; p += l->count[i], i++) {
        int n = l->count[i];

        x = ix__scratch(c->ctx, 3 * (size_t)n, sizeof *x);
        if (!x) {
            st = IX_ENOMEM;
            break;
        }
        u = x + 2 * n;
        for (int j = 0; j < n; j++)
            memcpy(x + 2 * j, p[j], 2 * sizeof(double));
        n = by_length(n, x, NULL, u);
        st = polyline(c->ctx, n, u, x, &m);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list,
                              ix__obj_mv(c->ctx, IX_OBJ_CURVE, m));
    }
    return ix__ret_list(c, list, st);
}

static ix_status two_curves(ix_call *c, const ix_mv *a, const ix_mv *b,
                            int func)
{
    ix_op_opts o = ix__op_opts(c);
    ix_status st;
    ix_lines l;
    ix_mv *m;

    if (ix__arg_bool(c, 1)) {
        if (func == 3)
            o.max_cont = 0; /* as IRIT, with every product method */
        IX_TRY(ix_cbisector2d(c->ctx, a, b, func, &o, &m));
        return ix__ret_mv(c, -1, m);
    }
    IX_TRY(ix_cbisector2d_curves(c->ctx, a, b, 0, ix__arg_bool(c, 5), &l));
    st = ret_lines(c, &l);
    ix_lines_free(c->ctx, &l);
    return st;
}

static ix_status cbisector2d(ix_call *c)
{
    static const char what[] = "list(curve, curve), list(curve, point) or a "
                               "curve";
    ix_op_opts o = ix__op_opts(c);
    ix_operand x[2];
    ix_mv *m;
    int func;

    IX_TRY(ix__arg_int(c, 2, 1, 3, &func));
    if (c->argv[0]->type == IX_OBJ_CURVE) {
        if (!ix__arg_bool(c, 1))
            return IX_ARG_FAIL(c, 0,
                               "the bisector of a curve with itself is what "
                               "MEDIALAXIS gives");
        return two_curves(c, ix__arg_mv(c, 0), ix__arg_mv(c, 0), func);
    }
    IX_TRY(ix__arg_operands(c, 0, IX_OBJ_CURVE, 2, what, x));
    if (x[1].mv)
        return two_curves(c, x[0].mv, x[1].mv, func);
    IX_TRY(ix_pt_crv_bisector(c->ctx, x[0].mv, x[1].pt, 0.5, &o, NULL, &m));
    IX_TRY(ix__ret_mv(c, -1, m));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

/* --- regions ---------------------------------------------------------------
 */

static ix_obj *node_object(ix_ctx *ctx, const ix_medial_node *n)
{
    const double x[3] = {n->x[0], n->x[1], 0.0};
    ix_obj *o = ix__obj_point(ctx, x);
    ix_status st = o ? ix__attr_set_int(ctx, &o->attrs, "Degree", n->degree)
                     : IX_ENOMEM;

    if (st == IX_OK)
        st = ix__attr_set_real(ctx, &o->attrs, "Radius", n->r);
    if (st == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

/* An E3 curve of order 2: centre and radius. */
static ix_status branch_curve(ix_ctx *ctx, const ix_medial_branch *b,
                              ix_mv **out)
{
    ix_dir d = {.basis = IX_BSPLINE, .order = 2, .length = b->n};
    double *knots, *pts;

    IX_SCRATCH(ctx, knots, b->n + 2);
    IX_SCRATCH(ctx, pts, 3 * b->n);
    for (int i = 0; i < b->n; i++) {
        knots[i + 1] = (double)i / (b->n - 1);
        for (int k = 0; k < 3; k++)
            pts[k * b->n + i] = b->x[3 * i + k];
    }
    knots[0] = 0.0;
    knots[b->n + 1] = 1.0;
    d.knots = knots;
    return ix_mv_new(ctx, 1, &d, 3, false, pts, out);
}

static ix_status branch_object(ix_ctx *ctx, const ix_medial_branch *b,
                               ix_obj **out)
{
    const double *z = b->foot + 2 * (b->n - 1);
    ix_status st;
    ix_mv *m;

    *out = NULL;
    IX_TRY(branch_curve(ctx, b, &m));
    *out = ix__obj_mv(ctx, IX_OBJ_CURVE, m);
    st = *out ? set_pair(ctx, *out, "Foot2", b->foot[1], z[1]) : IX_ENOMEM;
    if (st == IX_OK)
        st = set_pair(ctx, *out, "Foot1", b->foot[0], z[0]);
    if (st == IX_OK)
        st = set_pair(ctx, *out, "Curves", b->curve[0] + 1, b->curve[1] + 1);
    if (st == IX_OK)
        st = set_pair(ctx, *out, "Nodes", b->node[0] + 1, b->node[1] + 1);
    if (st == IX_OK)
        return IX_OK;
    ix__obj_unref(ctx, *out);
    return st;
}

static ix_status medial_lists(ix_call *c, const ix_medial_axis *m, ix_obj *list,
                              ix_obj *branches, ix_obj *nodes)
{
    ix_obj *o;

    for (int i = 0; i < m->nbranches; i++) {
        IX_TRY(branch_object(c->ctx, &m->branch[i], &o));
        IX_TRY(ix__list_add(c->ctx, branches, o));
    }
    for (int i = 0; i < m->nnodes; i++)
        IX_TRY(ix__list_add(c->ctx, nodes, node_object(c->ctx, &m->node[i])));
    IX_TRY(ix__list_add(c->ctx, list, ix__obj_ref(branches)));
    return ix__list_add(c->ctx, list, ix__obj_ref(nodes));
}

static ix_status medialaxis(ix_call *c)
{
    ix_obj *part[3] = {NULL, NULL, NULL};
    double tol = ix__arg_num(c, 1);
    const ix_mv **crv;
    ix_medial_axis m;
    ix_status st = IX_OK;
    int n;

    if (!(tol >= 0.0 && isfinite(tol)))
        return IX_ARG_FAIL(c, 1,
                           "a tolerance of %g: positive, relative to the "
                           "size, or 0 for 1e-4",
                           tol);
    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
    IX_TRY(ix_medial_axis_of(c->ctx, n, crv, tol, &m));
    for (int i = 0; i < 3; i++)
        if (!(part[i] = ix__obj_list(c->ctx)))
            st = IX_ENOMEM;
    if (st == IX_OK)
        st = medial_lists(c, &m, part[0], part[1], part[2]);
    ix_medial_axis_free(c->ctx, &m);
    ix__obj_unref(c->ctx, part[1]);
    ix__obj_unref(c->ctx, part[2]);
    return ix__ret_list(c, part[0], st);
}

/* Pieces of curve and curve carry CV_CV, as in IRIT. */
static ix_status mark_cells(ix_call *c, const ix_bisector *b)
{
    for (int i = 0; i < b->n; i++)
        if (b->piece[i].kind == IX_CURVE_CURVE)
            IX_TRY(ix__attr_set_int(c->ctx, &c->result->u.list.item[i]->attrs,
                                    "CV_CV", 1));
    return IX_OK;
}

static ix_status cvoronoicell(ix_call *c)
{
    const ix_mv **crv;
    ix_bisector b;
    ix_status st;
    int n;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
    if (n < 2)
        return IX_ARG_FAIL(c, 0, "a list of two curves or more, got %d", n);
    IX_TRY(ix_bisect_crv_crv(c->ctx, 1, crv, n - 1, crv + 1, 0, &b));
    st = pieces(c, &b);
    if (st == IX_OK)
        st = mark_cells(c, &b);
    ix_bisector_free(c->ctx, &b);
    return st;
}

static ix_status plnbisect(ix_call *c)
{
    double error;
    ix_status st;
    ix_lines l;
    int how;

    IX_TRY(ix__arg_int(c, 3, 0, 1, &how));
    IX_TRY(ix_pln_bisect(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                         ix__arg_num(c, 2), how == 1, 0, &l, &error));
    st = ret_lines(c, &l);
    if (st == IX_OK && isfinite(error))
        st = ix__attr_set_real(c->ctx, &c->result->attrs, "Error", error);
    ix_lines_free(c->ctx, &l);
    return st;
}

/* --- table -----------------------------------------------------------------
 */

#define ARCH                                                          \
    "c = cbezier(list(ctlpt(E2, -1, 1), ctlpt(E2, 0, -1), ctlpt(E2, " \
    "1, 1))); "
#define TWO                                                                    \
    ARCH "d = cbezier(list(ctlpt(E2, -1, -1), ctlpt(E2, 0, -2), ctlpt(E2, 2, " \
         "-1))); "

const ix_builtin ix__builtins_bisect2d[] = {
    {"CBISECTOR2D",
     "x:curve|list zero:bool func:num tol:num improve:bool facing:bool -> "
     "curve|surface|list",
     "Untrimmed bisectors in the plane: of list(curve, point) an exact curve; "
     "of list(curve, curve) polylines through exact points, with facing only "
     "where the tangents make no acute angle; with zero the function 1, 2 or 3 "
     "whose zeros are the pairs of feet, weights included (a curve: with "
     "itself). tol and improve are not needed.",
     TWO "l = cbisector2d(list(c, d), false, 3, 10, true, true);", cbisector2d,
     0, 21},
    {"PTCRVBISECT", "c:curve pt:pt3 trim:num -> curve|list",
     "What is equally far from a point and a planar curve: trim 0 the whole "
     "rational curve of normals; 1 the true bisector with the distance to the "
     "segment c, a list of exact pieces; 2 with the distance to the carrier of "
     "c, which goes on to infinity.",
     ARCH "b = ptcrvbisect(c, point(0.2, 0.5, 0), 1);", ptcrvbisect, 0, 21},
    {"PTCRVSPECIAL", "c:curve pt:pt3 -> list",
     "Parameters at which the untrimmed bisector of a point and a curve is "
     "special, with attributes Kind (inflection, infinity, pole, cusp, "
     "extraordinary, crossing), Point and Partner.",
     ARCH "l = ptcrvspecial(c, point(0.2, 0.5, 0));", ptcrvspecial, 0, 21},
    {"CRVBISECT", "c1:curve c2:curve tol:num -> list",
     "The true bisector of two planar curves as polylines (curves of order 2) "
     "within tol, relative to the size of both (0: 1e-4), one for each "
     "connected part.",
     TWO "l = crvbisect(c, d, 1e-3);", crvbisect, 0, 21},
    {"SEGBISECT", "c1:curve c2:curve -> list",
     "The components of the bisector of two curve segments, in order: Kind "
     "point-point, point-curve (both exact) or curve-curve (polylines with "
     "Feet; of lines and arcs of circles also the conic, as Exact), with the "
     "parameters of the feet as Foot1, Foot2.",
     TWO "l = segbisect(c, d);", segbisect, 0, 21},
    {"BISECTEVAL", "piece:curve c1:curve c2:curve t:num -> point",
     "The exact point at t of a component of SEGBISECT(c1, c2).",
     TWO "l = segbisect(c, d); p = bisecteval(nth(l, 2), c, d, 0.5);",
     bisecteval, 0, 21},
    {"CVORONOICELL", "curves:list -> list",
     "The border of the Voronoi cell of the first curve among the others: "
     "components as SEGBISECT gives them, those of curve and curve with CV_CV "
     "1.",
     "l = cvoronoicell(list(pcircle(vector(0, 0, 0), 1), pcircle(vector(4, 0, "
     "0), 1), pcircle(vector(0, 5, 0), 2)));",
     cvoronoicell, 0, 21},
    {"MEDIALAXIS", "curves:list tol:num -> list",
     "The medial axis of the region that closed curves bound: list(branches, "
     "nodes). Branches are curves (x, y, radius) of order 2 with attributes "
     "Nodes, Curves, Foot1, Foot2; nodes are points with Radius and Degree.",
     "l = medialaxis(list(pcircle(vector(0, 0, 0), 2) * sx(2), "
     "pcircle(vector(1, 0, 0), 0.5)), 1e-3);",
     medialaxis, 0, 21},
    {"PLNBISECT", "c1:curve c2:curve eps:num how:num -> list",
     "The untrimmed bisector of coplanar curves cut out of the bisector "
     "surface of space curves: c2 tilted by eps degrees (how 0) or lifted by "
     "eps (1). Attribute Error: distance of the true bisector from it.",
     TWO "l = plnbisect(c, d, 0.5, 1);", plnbisect, 0, 21},
    {0}};
