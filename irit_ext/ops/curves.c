/* curves.c - differential geometry of curves (chapters 9 and 19 of the
 * reference): special points, fields, evolutes, developables. */
#include <string.h>

#include "irit_ext/ops/ops.h"
#include "iritx/ops_crv.h"
#include "iritx/ops_srf.h"

/* --- fields and special points ------------------------------------------- */

static ix_status ret_graph(const ix_host *h, ix_call *c, ix_crv_field_kind kind)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *f, *g;
    ix_status st;

    IX_TRY(ix_crv_field(h->ctx(c), h->arg_mv(c, 0), kind, &o, NULL, &f));
    st = ix_crv_graph(h->ctx(c), f, o.form == IX_FORM_IRIT, &g);
    ix_mv_unref(h->ctx(c), f);
    IX_TRY(st);
    return h->ret_mv(c, 0, g);
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

static ix_obj *place_object(const ix_host *h, ix_ctx *ctx, const places *p,
                            int i)
{
    ix_obj *o = h->number(ctx, p->t[i]);
    ix_status st = IX_OK;

    if (o && p->kind[i])
        st = h->attr_set_str(ctx, o, "RootKind", p->kind[i]);
    if (o && p->type && st == IX_OK)
        st = h->attr_set_int(ctx, o, "ExtremType", p->type[i]);
    if (st == IX_OK)
        return o;
    h->unref(ctx, o);
    return NULL;
}

static ix_status ret_places(const ix_host *h, ix_call *c, const places *p)
{
    ix_obj *list = h->list(h->ctx(c));
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < p->n; i++)
        st = h->list_add(h->ctx(c), list, place_object(h, h->ctx(c), p, i));
    return h->ret_list(c, list, st);
}

/* The parts of the curve between the places; those nearer than 10 eps to each
 * other or to an end do not count (spec/operators 2.3). */
static ix_status ret_parts(const ix_host *h, ix_call *c, const places *p,
                           double eps)
{
    const ix_mv *crv = h->arg_mv(c, 0);
    ix_obj *list = h->list(h->ctx(c));
    ix_status st = list ? IX_OK : IX_ENOMEM;
    double dom[2], from;

    ix_mv_domain(crv, 0, dom);
    from = dom[0];
    for (int i = 0; st == IX_OK && i <= p->n; i++) {
        double to = i < p->n ? p->t[i] : dom[1];
        ix_mv *part;

        if (i < p->n && !(to - from > 10 * eps && dom[1] - to > 10 * eps))
            continue;
        st = ix_mv_region(h->ctx(c), crv, 0, from, to, &part);
        if (st == IX_OK)
            st = h->list_add(h->ctx(c), list,
                             h->freeform(h->ctx(c), IX_OBJ_CURVE, part));
        from = to;
    }
    return h->ret_list(c, list, st);
}

static ix_status ret_either(const ix_host *h, ix_call *c, const places *p,
                            int op)
{
    return op == 2 ? ret_places(h, c, p) : ret_parts(h, c, p, h->arg_num(c, 1));
}

/* Zeros, with both ends of intervals. */
static ix_status ret_roots(const ix_host *h, ix_call *c, const ix_root *r,
                           int n, int op)
{
    const char **kind;
    places p = {.n = 0};
    double *t;

    SCRATCH(h, c, t, 2 * n);
    SCRATCH(h, c, kind, 2 * n);
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
    return ret_either(h, c, &p, op);
}

typedef ix_status (*roots_fn)(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                              int *n);

static ix_status roots_of(const ix_host *h, ix_call *c, roots_fn fn, int op)
{
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(fn(h->ctx(c), h->arg_mv(c, 0), &r, &n));
    st = ret_roots(h, c, r, n, op);
    ix_roots_free(h->ctx(c), r, n);
    return st;
}

static ix_status cinflect(const ix_host *h, ix_call *c)
{
    int op;

    IX_TRY(h->arg_int(c, 2, 1, 3, &op));
    return op == 1 ? ret_graph(h, c, IX_CRV_INFLECTION)
                   : roots_of(h, c, ix_crv_inflections, op);
}

static ix_status ctorsion(const ix_host *h, ix_call *c)
{
    int op;

    IX_TRY(h->arg_int(c, 2, 1, 4, &op));
    if (op == 1 || op == 4)
        return ret_graph(h, c, op == 1 ? IX_CRV_TORSION : IX_CRV_TORSION_ZERO);
    return roots_of(h, c, ix_crv_torsion_zeros, op);
}

/* Extrema and zeros of the curvature; what is only stationary is neither. */
static ix_status ret_features(const ix_host *h, ix_call *c,
                              const ix_crv_feature *f, int n, int op)
{
    static const int types[] = {
        [IX_CRV_FLAT] = 0, [IX_CRV_MAX] = 1, [IX_CRV_MIN] = -1};
    const char **kind;
    places p = {.n = 0};
    double *t;
    int *type;

    SCRATCH(h, c, t, n);
    SCRATCH(h, c, kind, n);
    SCRATCH(h, c, type, n);
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
    return ret_either(h, c, &p, op);
}

static ix_status ccrvtr(const ix_host *h, ix_call *c)
{
    ix_crv_feature *f;
    ix_status st;
    int op, n;

    IX_TRY(h->arg_int(c, 2, 1, 4, &op));
    if (op == 1 || op == 4)
        return ret_graph(h, c,
                         op == 1 ? IX_CRV_CURVATURE_SQR : IX_CRV_CRITICAL);
    IX_TRY(ix_crv_features(h->ctx(c), h->arg_mv(c, 0), &f, &n));
    st = ret_features(h, c, f, n, op);
    ix_crv_features_free(h->ctx(c), f, n);
    return st;
}

static ix_status ccrvtreval(const ix_host *h, ix_call *c)
{
    double k;

    IX_TRY(ix_crv_curvature(h->ctx(c), h->arg_mv(c, 0), h->arg_num(c, 1), &k));
    return h->ret_num(c, k);
}

/* --- curves -------------------------------------------------------------- */

static ix_status cnrmlcrv(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;

    IX_TRY(ix_crv_normal_field(h->ctx(c), h->arg_mv(c, 0), &o, NULL, &out));
    return h->ret_mv(c, 0, out);
}

/* The mean evolute. */
static ix_status surface_evolute(const ix_host *h, ix_call *c,
                                 const ix_op_opts *o)
{
    ix_mv *out;

    IX_TRY(ix_srf_evolute(h->ctx(c), h->arg_mv(c, 0), o, NULL, &out));
    return h->ret_mv(c, 0, out);
}

/* Several curves, each with its poles. */
static ix_status ret_pieces(const ix_host *h, ix_call *c, ix_crvs *e)
{
    ix_ctx *ctx = h->ctx(c);
    ix_obj *list = h->list(ctx), *o;
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < e->n; i++) {
        o = h->freeform(ctx, IX_OBJ_CURVE, ix_mv_ref(e->crv[i]));
        st = h->list_add(ctx, list, h->ref(o));
        if (st == IX_OK)
            st = h->set_poles(c, o, e->crv[i]);
        h->unref(ctx, o);
    }
    ix_crvs_free(ctx, e);
    return h->ret_list(c, list, st);
}

/* The only piece, or all of them with a remark. */
static ix_status evolute(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    double dom[2];
    ix_mv *only;
    ix_crvs e;

    if (ix_mv_ndirs(h->arg_mv(c, 0)) == 2)
        return surface_evolute(h, c, &o);
    IX_TRY(ix_evolute_pieces(h->ctx(c), h->arg_mv(c, 0), &o, &e));
    if (e.n == 0)
        return h->arg_fail(c, 0, "a straight line: its evolute is at infinity");
    ix_mv_domain(h->arg_mv(c, 0), 0, dom);
    if (e.t[0] > dom[0] || e.t[2 * e.n - 1] < dom[1] || e.n > 1)
        h->remark(c, "straight parts are left out: %d piece%s", e.n,
                  e.n > 1 ? "s" : "");
    if (e.n > 1)
        return ret_pieces(h, c, &e);
    only = ix_mv_ref(e.crv[0]);
    ix_crvs_free(h->ctx(c), &e);
    IX_TRY(h->ret_mv(c, 0, only));
    return h->set_poles(c, h->result(c), h->mv_of(h->result(c)));
}

static ix_status focalcrv(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;

    IX_TRY(ix_focal_crv(h->ctx(c), h->arg_mv(c, 0), &o, NULL, &out));
    IX_TRY(h->ret_mv(c, 0, out));
    return h->set_poles(c, h->result(c), h->mv_of(h->result(c)));
}

/* --- ruled surfaces ------------------------------------------------------- */

static ix_status ret_ruled(const ix_host *h, ix_call *c, ix_ruled_kind kind)
{
    double range[2] = {h->arg_num(c, 1), h->arg_num(c, 2)};
    bool scroll = kind == IX_RULED_NORMAL || kind == IX_RULED_BINORMAL;
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;

    IX_TRY(
        ix_crv_ruled(h->ctx(c), h->arg_mv(c, 0), kind, range, &o, NULL, &out));
    IX_TRY(h->ret_geom(c, -1, out, scroll ? GEOM_RULED : GEOM_DEVELOP));
    return h->set_poles(c, h->result(c), h->mv_of(h->result(c)));
}

static ix_status tandevsrf(const ix_host *h, ix_call *c)
{
    return ret_ruled(h, c, IX_RULED_TANGENT);
}

static ix_status nrmlscroll(const ix_host *h, ix_call *c)
{
    return ret_ruled(h, c, IX_RULED_NORMAL);
}

static ix_status binrmlscroll(const ix_host *h, ix_call *c)
{
    return ret_ruled(h, c, IX_RULED_BINORMAL);
}

static ix_status rectdevsrf(const ix_host *h, ix_call *c)
{
    return ret_ruled(h, c, IX_RULED_RECTIFYING);
}

static ix_status focalsrf(const ix_host *h, ix_call *c)
{
    return ret_ruled(h, c, IX_RULED_POLAR);
}

static ix_status cfncrvtr(const ix_host *h, ix_call *c)
{
    const ix_mv *m = h->arg_mv(c, 0);
    int n, order;
    ix_mv *out;

    IX_TRY(h->arg_int(c, 1, 1, 1000000, &n));
    IX_TRY(h->arg_int(c, 2, 2, IX_MAX_ORDER, &order));
    if (ix_mv_ncoords(m) == 1)
        IX_TRY(ix_curve_of_curvature(h->ctx(c), m, n, h->arg_bool(c, 3), &out));
    else
        IX_TRY(ix_curvature_function(h->ctx(c), m, n, order, h->arg_bool(c, 3),
                                     &out));
    return h->ret_mv(c, 0, out);
}

/* --- degrees -------------------------------------------------------------- */

static ix_status ffreduce(const ix_host *h, ix_call *c)
{
    double tol = h->arg_num(c, 1);
    ix_mv *out;

    if (!(tol >= 0 && tol < 1))
        return h->arg_fail(c, 1,
                           "a tolerance of %g; it is relative, 0 for "
                           "rounding only",
                           tol);
    IX_TRY(ix_sym_reduce(h->ctx(c), h->arg_mv(c, 0), tol, NULL, &out));
    return h->ret_mv(c, 0, out);
}

/* --- table --------------------------------------------------------------- */

#define CUBIC                                                       \
    "c = cbezier(list(ctlpt(E2, 0, 0), ctlpt(E2, 1, 3), ctlpt(E2, " \
    "2, -3), ctlpt(E2, 3.5, 1))); "
#define SPACE                                                           \
    "c = cbezier(list(point(0, 0, 0), point(1, 0, 1), point(2, 2, 0), " \
    "point(0, 3, 1))); "

static const ix_plugin_row rows[] = {
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

ix_status ix__ops_curves(const ix_host *h, ix_registry *r)
{
    return h->add(r, IX_PLUGIN_VERSION, rows);
}
