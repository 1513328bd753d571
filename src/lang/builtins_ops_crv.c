/* builtins_ops_crv.c - differential geometry of curves (chapters 9 and 19 of
 * spec/functions): special points, fields, evolutes, developables. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "iritx/ops_crv.h"
#include "iritx/ops_srf.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"
#include "lang/op_args.h"

/* --- fields and special points ------------------------------------------- */

static ix_status ret_graph(ix_call *c, ix_crv_field_kind kind)
{
    ix_op_opts o = ix__op_opts(c);
    ix_mv *f, *g;
    ix_status st;

    IX_TRY(ix_crv_field(c->ctx, ix__arg_mv(c, 0), kind, &o, NULL, &f));
    st = ix_crv_graph(c->ctx, f, o.form == IX_FORM_IRIT, &g);
    ix_mv_unref(c->ctx, f);
    IX_TRY(st);
    return ix__ret_mv(c, 0, g);
}

/* Parameters with what is known of each: numbers in a list, or places to
 * split. */
typedef struct {
    int n;
    const double *t;
    const char *const *kind; /* NULL: simple */
    const int *type;         /* ExtremType; NULL: none */
} places;

static const char *root_kind(const ix_root *r)
{
    static const char *const kinds[] = {NULL, "touch", "cluster", "jump",
                                        "interval"};

    return kinds[r->kind];
}

static ix_obj *place_object(ix_ctx *ctx, const places *p, int i)
{
    ix_obj *o = ix__obj_number(ctx, p->t[i]);
    ix_status st = IX_OK;

    if (o && p->kind[i])
        st = ix__attr_set_string(ctx, &o->attrs, "RootKind", p->kind[i]);
    if (o && p->type && st == IX_OK)
        st = ix__attr_set_int(ctx, &o->attrs, "ExtremType", p->type[i]);
    if (st == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status ret_places(ix_call *c, const places *p)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < p->n; i++)
        st = ix__list_add(c->ctx, list, place_object(c->ctx, p, i));
    return ix__ret_list(c, list, st);
}

/* The parts of the curve between the places; those nearer than 10 eps to each
 * other or to an end do not count (spec/operators 2.3). */
static ix_status ret_parts(ix_call *c, const places *p, double eps)
{
    const ix_mv *crv = ix__arg_mv(c, 0);
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;
    double dom[2], from;

    ix_mv_domain(crv, 0, dom);
    from = dom[0];
    for (int i = 0; st == IX_OK && i <= p->n; i++) {
        double to = i < p->n ? p->t[i] : dom[1];
        ix_mv *part;

        if (i < p->n && !(to - from > 10 * eps && dom[1] - to > 10 * eps))
            continue;
        st = ix_mv_region(c->ctx, crv, 0, from, to, &part);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list,
                              ix__obj_mv(c->ctx, IX_OBJ_CURVE, part));
        from = to;
    }
    return ix__ret_list(c, list, st);
}

static ix_status ret_either(ix_call *c, const places *p, int op)
{
    return op == 2 ? ret_places(c, p) : ret_parts(c, p, ix__arg_num(c, 1));
}

/* Zeros, with both ends of intervals. */
static ix_status ret_roots(ix_call *c, const ix_root *r, int n, int op)
{
    const char **kind;
    places p = {.n = 0};
    double *t;

    IX_SCRATCH(c->ctx, t, 2 * n);
    IX_SCRATCH(c->ctx, kind, 2 * n);
    for (int i = 0; i < n; i++) {
        bool interval = r[i].kind == IX_ROOT_INTERVAL;

        kind[p.n] = root_kind(&r[i]);
        t[p.n++] = interval ? r[i].lo : r[i].t;
        kind[p.n] = root_kind(&r[i]);
        if (interval)
            t[p.n++] = r[i].hi;
    }
    p.t = t;
    p.kind = kind;
    return ret_either(c, &p, op);
}

typedef ix_status (*roots_fn)(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                              int *n);

static ix_status roots_of(ix_call *c, roots_fn fn, int op)
{
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(fn(c->ctx, ix__arg_mv(c, 0), &r, &n));
    st = ret_roots(c, r, n, op);
    ix_roots_free(c->ctx, r, n);
    return st;
}

static ix_status cinflect(ix_call *c)
{
    int op;

    IX_TRY(ix__arg_int(c, 2, 1, 3, &op));
    return op == 1 ? ret_graph(c, IX_CRV_INFLECTION)
                   : roots_of(c, ix_crv_inflections, op);
}

static ix_status ctorsion(ix_call *c)
{
    int op;

    IX_TRY(ix__arg_int(c, 2, 1, 4, &op));
    if (op == 1 || op == 4)
        return ret_graph(c, op == 1 ? IX_CRV_TORSION : IX_CRV_TORSION_ZERO);
    return roots_of(c, ix_crv_torsion_zeros, op);
}

/* Extrema and zeros of the curvature; what is only stationary is neither. */
static ix_status ret_features(ix_call *c, const ix_crv_feature *f, int n,
                              int op)
{
    static const int types[] = {
        [IX_CRV_FLAT] = 0, [IX_CRV_MAX] = 1, [IX_CRV_MIN] = -1};
    const char **kind;
    places p = {.n = 0};
    double *t;
    int *type;

    IX_SCRATCH(c->ctx, t, n);
    IX_SCRATCH(c->ctx, kind, n);
    IX_SCRATCH(c->ctx, type, n);
    for (int i = 0; i < n; i++) {
        if (f[i].mark == IX_CRV_STATIONARY)
            continue;
        t[p.n] = f[i].root.t;
        kind[p.n] = root_kind(&f[i].root);
        type[p.n++] = types[f[i].mark];
    }
    p.t = t;
    p.kind = kind;
    p.type = type;
    return ret_either(c, &p, op);
}

static ix_status ccrvtr(ix_call *c)
{
    ix_crv_feature *f;
    ix_status st;
    int op, n;

    IX_TRY(ix__arg_int(c, 2, 1, 4, &op));
    if (op == 1 || op == 4)
        return ret_graph(c, op == 1 ? IX_CRV_CURVATURE_SQR : IX_CRV_CRITICAL);
    IX_TRY(ix_crv_features(c->ctx, ix__arg_mv(c, 0), &f, &n));
    st = ret_features(c, f, n, op);
    ix_crv_features_free(c->ctx, f, n);
    return st;
}

static ix_status ccrvtreval(ix_call *c)
{
    double k;

    IX_TRY(ix_crv_curvature(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1), &k));
    return ix__ret_num(c, k);
}

/* --- curves -------------------------------------------------------------- */

static ix_status cnrmlcrv(ix_call *c)
{
    ix_op_opts o = ix__op_opts(c);
    ix_mv *out;

    IX_TRY(ix_crv_normal_field(c->ctx, ix__arg_mv(c, 0), &o, NULL, &out));
    return ix__ret_mv(c, 0, out);
}

/* The mean evolute. */
static ix_status surface_evolute(ix_call *c, const ix_op_opts *o)
{
    ix_mv *out;

    IX_TRY(ix_srf_evolute(c->ctx, ix__arg_mv(c, 0), o, NULL, &out));
    return ix__ret_mv(c, 0, out);
}

/* Several curves, each with its poles. */
static ix_status ret_pieces(ix_call *c, ix_crvs *e)
{
    IX_TRY(ix__ret_crvs(c, e));
    for (int i = 0; i < c->result->u.list.n; i++) {
        ix_obj *o = c->result->u.list.item[i];

        IX_TRY(ix__tell_poles(c, o, ix__obj_first_mv(o)));
    }
    return IX_OK;
}

/* The only piece, or all of them with a remark. */
static ix_status evolute(ix_call *c)
{
    ix_op_opts o = ix__op_opts(c);
    double dom[2];
    ix_mv *only;
    ix_crvs e;

    if (ix__arg_mv(c, 0)->ndirs == 2)
        return surface_evolute(c, &o);
    IX_TRY(ix_evolute_pieces(c->ctx, ix__arg_mv(c, 0), &o, &e));
    if (e.n == 0)
        return IX_ARG_FAIL(c, 0, "a straight line: its evolute is at infinity");
    ix_mv_domain(ix__arg_mv(c, 0), 0, dom);
    if (e.t[0] > dom[0] || e.t[2 * e.n - 1] < dom[1] || e.n > 1)
        ix__remark(c->in, "straight parts are left out: %d piece%s", e.n,
                   e.n > 1 ? "s" : "");
    if (e.n > 1)
        return ret_pieces(c, &e);
    only = ix_mv_ref(e.crv[0]);
    ix_crvs_free(c->ctx, &e);
    IX_TRY(ix__ret_mv(c, 0, only));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

static ix_status focalcrv(ix_call *c)
{
    ix_op_opts o = ix__op_opts(c);
    ix_mv *out;

    IX_TRY(ix_focal_crv(c->ctx, ix__arg_mv(c, 0), &o, NULL, &out));
    IX_TRY(ix__ret_mv(c, 0, out));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

/* --- ruled surfaces ------------------------------------------------------- */

static ix_status ret_ruled(ix_call *c, ix_ruled_kind kind)
{
    double range[2] = {ix__arg_num(c, 1), ix__arg_num(c, 2)};
    bool scroll = kind == IX_RULED_NORMAL || kind == IX_RULED_BINORMAL;
    ix_op_opts o = ix__op_opts(c);
    ix_mv *out;

    IX_TRY(ix_crv_ruled(c->ctx, ix__arg_mv(c, 0), kind, range, &o, NULL, &out));
    IX_TRY(
        ix__ret_geom(c, -1, out, scroll ? IX__GEOM_RULED : IX__GEOM_DEVELOP));
    return ix__tell_poles(c, c->result, ix__obj_first_mv(c->result));
}

static ix_status tandevsrf(ix_call *c)
{
    return ret_ruled(c, IX_RULED_TANGENT);
}

static ix_status nrmlscroll(ix_call *c)
{
    return ret_ruled(c, IX_RULED_NORMAL);
}

static ix_status binrmlscroll(ix_call *c)
{
    return ret_ruled(c, IX_RULED_BINORMAL);
}

static ix_status rectdevsrf(ix_call *c)
{
    return ret_ruled(c, IX_RULED_RECTIFYING);
}

static ix_status focalsrf(ix_call *c)
{
    return ret_ruled(c, IX_RULED_POLAR);
}

static ix_status cfncrvtr(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    int n, order;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 1, 1, 1000000, &n));
    IX_TRY(ix__arg_int(c, 2, 2, IX_MAX_ORDER, &order));
    if (m->ncoords == 1)
        IX_TRY(ix_curve_of_curvature(c->ctx, m, n, ix__arg_bool(c, 3), &out));
    else
        IX_TRY(ix_curvature_function(c->ctx, m, n, order, ix__arg_bool(c, 3),
                                     &out));
    return ix__ret_mv(c, 0, out);
}

/* --- degrees -------------------------------------------------------------- */

static ix_status ffreduce(ix_call *c)
{
    double tol = ix__arg_num(c, 1);
    ix_mv *out;

    if (!(tol >= 0 && tol < 1))
        return IX_ARG_FAIL(c, 1,
                           "a tolerance of %g; it is relative, 0 for "
                           "rounding only",
                           tol);
    IX_TRY(ix_sym_reduce(c->ctx, ix__arg_mv(c, 0), tol, NULL, &out));
    return ix__ret_mv(c, 0, out);
}

/* --- table --------------------------------------------------------------- */

#define CUBIC                                                       \
    "c = cbezier(list(ctlpt(E2, 0, 0), ctlpt(E2, 1, 3), ctlpt(E2, " \
    "2, -3), ctlpt(E2, 3.5, 1))); "
#define SPACE                                                           \
    "c = cbezier(list(point(0, 0, 0), point(1, 0, 1), point(2, 2, 0), " \
    "point(0, 3, 1))); "

const ix_builtin ix__builtins_ops_crv[] = {
    {"CINFLECT", "c:curve eps:num op:num -> curve|list",
     "Inflections in the xy plane: 1 the field as a graph (t, value), 2 its "
     "zeros, 3 the curve split there; exact to rounding, eps only merges "
     "splits.",
     CUBIC "l = cinflect(c, 1e-6, 2);", cinflect, 0, 9},
    {"CCRVTR", "c:curve eps:num op:num -> curve|list",
     "Curvature: 1 its square as a graph, 2 the parameters of its extrema and "
     "zeros (ExtremType 1 maximum, -1 minimum, 0 zero), 3 the curve split "
     "there, 4 the field whose zeros the extrema are, as a graph.",
     CUBIC "l = ccrvtr(c, 1e-6, 2);", ccrvtr, 0, 19},
    {"CTORSION", "c:curve eps:num op:num -> curve|list",
     "Torsion: 1 as a graph (t, value), 2 the parameters where it is zero, 3 "
     "the curve split there, 4 the field with these zeros as a graph.",
     SPACE "g = ctorsion(c, 1e-6, 1);", ctorsion, 0, 19},
    {"CCRVTREVAL", "c:curve t:num -> num", "The absolute curvature at t.",
     CUBIC "k = ccrvtreval(c, 0.5);", ccrvtreval, 0, 19},
    {"CNRMLCRV", "c:curve -> curve",
     "The vector of curvature, kappa N, as an exact rational curve in space.",
     CUBIC "n = cnrmlcrv(c);", cnrmlcrv, 0, 9},
    {"EVOLUTE", "x:curve|surface -> curve|surface|list",
     "The centres of curvature, exactly; a list of curves if straight parts "
     "are left out. It passes through infinity at the parameters that the "
     "attribute Poles lists; Finite lists the ranges between. Of a surface: "
     "the mean evolute S + n / (2H).",
     CUBIC "e = evolute(c);", evolute, 0, 19},
    {"FOCALCRV", "c:curve -> curve",
     "The centres of the osculating spheres of a space curve, an exact "
     "rational curve; at zero torsion (attributes Poles, Finite) it is at "
     "infinity.",
     SPACE "f = focalcrv(c);", focalcrv, 0, 19},
    {"FOCALSRF", "c:curve min:num max:num -> surface",
     "The polar developable: the axes of the circles of curvature, between "
     "two planes at the distances min and max from one through the middle of "
     "the control points; Poles and Finite as for EVOLUTE.",
     SPACE "s = focalsrf(c, -1, 1);", focalsrf, 0, 19},
    {"TANDEVSRF", "c:curve min:num max:num -> surface",
     "The tangent developable, c + r c' (times the weight) with r from min to "
     "max; direction 1 along the curve, 2 along the rulings.",
     SPACE "s = tandevsrf(c, 0, 1);", tandevsrf, 0, 19},
    {"NRMLSCROLL", "c:curve min:num max:num -> surface",
     "The ruled surface of the principal normals, c + r (c' x c'') x c'.",
     SPACE "s = nrmlscroll(c, 0, 0.01);", nrmlscroll, 0, 19},
    {"BINRMLSCROLL", "c:curve min:num max:num -> surface",
     "The ruled surface of the binormals, c + r c' x c''.",
     SPACE "s = binrmlscroll(c, 0, 0.1);", binrmlscroll, 0, 19},
    {"RECTDEVSRF", "c:curve min:num max:num -> surface",
     "The rectifying developable, on which the curve is a geodesic: rulings "
     "along the Darboux vector.",
     SPACE "s = rectdevsrf(c, 0, 1e-6);", rectdevsrf, 0, 19},
    {"CFNCRVTR", "c:curve n:num order:num flag:num -> curve",
     "Signed curvature of a planar curve as a function of n samples (flag: by "
     "arc length); of a scalar function k(s): the planar curve with that "
     "curvature, n pieces (flag: closed).",
     CUBIC "k = cfncrvtr(c, 100, 4, false);", cfncrvtr, 0, 19},
    {"FFREDUCE", "f:freeform tol:num -> freeform",
     "The same map in the least degrees and with the fewest knots: leading "
     "coefficients, common factors, knots that vanish within tol (relative; 0: "
     "rounding) are removed.",
     "e = ffreduce(evolute(circle(vector(1, 2, 0), 3)), 0);", ffreduce, 0, 18},
    {0}};
