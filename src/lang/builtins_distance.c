/* builtins_distance.c - distances, tangents, inclusion, intersections, contours
 * (chapters 9, 13 and 22 of spec/functions). All of it is exact to rounding:
 * the tolerances that scripts give are accepted and not needed. */
#include <math.h>
#include <string.h>

#include "iritx/contour.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/contour_cone.h"
#include "lang/interp.h"
#include "lang/poly_lines.h"
#include "mv/mv.h"

/* --- points on curves
 * ---------------------------------------------------------- */

static ix_status ret_roots(ix_call *c, const ix_root *r, int n)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add_num(c->ctx, list, r[i].t);
    return ix__ret_list(c, list, st);
}

/* Argument epsarg positive: the nearest or farthest parameter; negative: all
 * parameters where the distance is stationary. */
static ix_status crv_distance(ix_call *c, const double *dir, int minarg)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double p[3], t, d;
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix__arg_pt3(c, 1, p));
    if (ix__arg_num(c, minarg + 1) >= 0) {
        IX_TRY(ix_crv_nearest(c->ctx, m, p, dir, !ix__arg_bool(c, minarg), &t,
                              &d));
        return ix__ret_num(c, t);
    }
    IX_TRY(ix_crv_feet(c->ctx, m, p, dir, &r, &n));
    st = ret_roots(c, r, n);
    ix_roots_free(c->ctx, r, n);
    return st;
}

static ix_status crvptdst(ix_call *c)
{
    return crv_distance(c, NULL, 2);
}

static ix_status crvlndst(ix_call *c)
{
    double dir[3];

    IX_TRY(ix__arg_vec3(c, 2, dir));
    return crv_distance(c, dir, 3);
}

static ix_status crvpttan(ix_call *c)
{
    double p[3];
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix__arg_pt3(c, 1, p));
    IX_TRY(ix_crv_tangents_from(c->ctx, ix__arg_mv(c, 0), p, &r, &n));
    st = ret_roots(c, r, n);
    ix_roots_free(c->ctx, r, n);
    return st;
}

static ix_status cpinclude(ix_call *c)
{
    double p[3];
    int where;

    IX_TRY(ix__arg_pt3(c, 1, p));
    IX_TRY(ix_crv_encloses(c->ctx, ix__arg_mv(c, 0), p, ix__arg_num(c, 2),
                           &where));
    return ix__ret_num(c, where);
}

/* --- pairs of parameters
 * ---------------------------------------------------------- */

static ix_obj *pair_object(ix_ctx *ctx, const ix_solution *s)
{
    const double p[3] = {s->x[0], s->x[1], 0};
    ix_obj *o = ix__obj_point(ctx, p);

    if (!o || s->certified)
        return o;
    if (ix__attr_set_int(ctx, &o->attrs, "SingleSol", 0) == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status ret_pairs(ix_call *c, const ix_solutions *s)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    if (!s->complete)
        ix__remark(c->in,
                   "stopped after %zu boxes: the freeforms overlap, or "
                   "nearly so",
                   s->boxes);
    for (int i = 0; st == IX_OK && i < s->n; i++)
        st = ix__list_add(c->ctx, list, pair_object(c->ctx, &s->sol[i]));
    return ix__ret_list(c, list, st);
}

/* The squared distance over (t1, t2) as a graph (t1, t2, value): the nodes of
 * both directions are the control values of the parameters. */
static ix_status distance_graph(ix_call *c, const ix_mv *a, const ix_mv *b)
{
    ix_mv *d, *g;
    double *node[2];

    IX_TRY(ix_srf_distance(c->ctx, a, b, IX_DIST_SQUARED, &d));
    for (int k = 0; k < 2; k++) {
        node[k] = ix__scratch(c->ctx, (size_t)d->dirs[k].length, sizeof **node);
        if (!node[k] ||
            (k == 1 && ix_mv_coerce(c->ctx, d, 3, d->rational, &g) != IX_OK)) {
            ix_mv_unref(c->ctx, d);
            return IX_ENOMEM;
        }
        ix_knots_nodes(&d->dirs[k], node[k]);
    }
    for (size_t i = 0; i < d->npts; i++) {
        double w = d->rational ? ix_mv_weights(d)[i] : 1;
        double *p = g->pts + i + (d->rational ? d->npts : 0);
        size_t n = (size_t)d->dirs[0].length;

        p[0] = w * node[0][i % n];
        p[d->npts] = w * node[1][i / n];
        p[2 * d->npts] = ix_mv_coord(d, 0)[i];
    }
    ix_mv_unref(c->ctx, d);
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_SURFACE, g));
}

static ix_status ccinter(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0), *b = ix__arg_mv(c, 1);
    ix_solutions s;
    ix_status st;

    if (!(ix__arg_num(c, 2) > 0))
        return distance_graph(c, a, b);
    if (ix__arg_bool(c, 3))
        IX_TRY(ix_crv_self_meet(c->ctx, a, &s));
    else
        IX_TRY(ix_crv_crv_meet(c->ctx, a, b, NULL, &s));
    st = ret_pairs(c, &s);
    ix_solutions_free(c->ctx, &s);
    return st;
}

/* From a point, or from a line if dir is given; argument minarg tells whether
 * the nearest or the farthest is wanted. */
static ix_status srf_distance(ix_call *c, const double *dir, int minarg)
{
    const ix_mv *s = ix__arg_mv(c, 0);
    bool farthest = !ix__arg_bool(c, minarg);
    double p[3], uv[3] = {0, 0, 0}, d;
    ix_solutions sol;
    ix_status st;

    IX_TRY(ix__arg_pt3(c, 1, p));
    if (ix__arg_num(c, minarg + 1) >= 0) {
        st = dir ? ix_srf_line_nearest(c->ctx, s, p, dir, farthest, uv, &d)
                 : ix_srf_nearest(c->ctx, s, p, farthest, uv, &d);
        IX_TRY(st);
        return ix__ret(c, ix__obj_point(c->ctx, uv));
    }
    st = dir ? ix_srf_line_feet(c->ctx, s, p, dir, &sol)
             : ix_srf_feet(c->ctx, s, p, &sol);
    IX_TRY(st);
    st = ret_pairs(c, &sol);
    ix_solutions_free(c->ctx, &sol);
    return st;
}

static ix_status srfptdst(ix_call *c)
{
    return srf_distance(c, NULL, 2);
}

static ix_status srflndst(ix_call *c)
{
    double dir[3];

    IX_TRY(ix__arg_vec3(c, 2, dir));
    return srf_distance(c, dir, 3);
}

/* --- contours
 * ------------------------------------------------------------------------ */

/* Resolution samples for a turn of the curve: half a step's sag. */
double ix__contour_tolerance(const ix_call *c)
{
    double n = fmax(ix__var_num(c->in, "RESOLUTION", 20), 2);

    return 1 / (8 * n * n);
}

/* One vertex: (u, v, 0), or the point of m there. */
static ix_status put_vertex(ix_call *c, const ix_mv *m, const double *uv,
                            double p[3])
{
    double x[IX_MAX_COORDS] = {0};

    if (!m) {
        p[0] = uv[0];
        p[1] = uv[1];
        return IX_OK;
    }
    IX_TRY(ix_mv_point(c->ctx, m, uv, x));
    memcpy(p, x, 3 * sizeof *p);
    return IX_OK;
}

/* Polylines in the parameter plane or on m; no value if there is no curve. */
ix_status ix__ret_contours(ix_call *c, const ix_solution_curves *s,
                           const ix_mv *m)
{
    ix_status st = IX_OK;
    ix_poly *p;

    if (!s->complete)
        ix__remark(c->in, "stopped after %zu cells: curves may be missing",
                   s->boxes);
    if (s->area)
        ix__remark(c->in,
                   "the condition holds on whole patches, of which there "
                   "are no curves");
    if (s->ncurves == 0)
        return IX_OK;
    p = ix__poly_new(c->ctx, s->ncurves);
    if (!p)
        return IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < s->ncurves; i++) {
        const ix_solution_curve *k = &s->curve[i];

        p->poly[i].kind = IX_POLYLINE;
        st = ix__poly_vertices(c->ctx, &p->poly[i], k->n);
        for (int v = 0; st == IX_OK && v < k->n; v++)
            st = put_vertex(c, m, k->x + 2 * (size_t)v, p->poly[i].v[v].p);
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    ix__poly_unref(c->ctx, p);
    return st;
}

/* A curve and a plane: the parameters as points (t, 0, 0). */
static ix_status curve_contour(ix_call *c, const ix_mv *m, const double *plane)
{
    ix_obj *list;
    ix_status st = IX_OK;
    ix_mv *f;
    ix_root *r;
    int n;

    IX_TRY(ix_contour_field(c->ctx, m, plane, &f));
    st = ix_roots(c->ctx, f, 0, NULL, &r, &n);
    ix_mv_unref(c->ctx, f);
    IX_TRY(st);
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++) {
        const double p[3] = {r[i].t, 0, 0};

        st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, p));
    }
    ix_roots_free(c->ctx, r, n);
    return ix__ret_list(c, list, st);
}

/* Polygons and polylines: only by the plane. */
static ix_status poly_contour(ix_call *c, const double *plane)
{
    if (c->argc > 2)
        return IX_ARG_FAIL(c, 2, "polygons are not mapped to a surface");
    return ix__ret_poly_contour(c, c->argv[0]->u.poly, plane);
}

static ix_status contour(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0), *on;
    const double *plane = c->argv[1]->u.plane;
    ix_solution_curves s;
    ix__cone k = {.on = NULL};
    ix_status st;

    if (c->argv[0]->type == IX_OBJ_POLY)
        return poly_contour(c, plane);
    if (m->ndirs == 1)
        return curve_contour(c, m, plane);
    /* a scalar surface answers in its parameters, another on itself */
    on = c->argc > 2 ? ix__arg_mv(c, 2) : m->ncoords == 1 ? NULL : m;
    if (on && on->ndirs != 2)
        return IX_ARG_FAIL(c, 2,
                           "a freeform of %d directions; a surface is "
                           "wanted",
                           on->ndirs);
    if (c->argc > 3)
        IX_TRY(ix__arg_cone(c, 3, on, &k));
    IX_TRY(ix_contour_on(c->ctx, m, plane, on, ix__contour_tolerance(c), &s));
    st = k.on ? ix__ret_in_cone(c, &s, &k) : ix__ret_contours(c, &s, on);
    ix_solution_curves_free(c->ctx, &s);
    return st;
}

/* The curves in the parameters of m, or on it where argument euclid is on;
 * released, if st says that there are any. */
static ix_status ret_on_surface(ix_call *c, ix_status st, ix_solution_curves *s,
                                const ix_mv *m, int euclid)
{
    IX_TRY(st);
    st = ix__ret_contours(c, s, ix__arg_bool(c, euclid) ? m : NULL);
    ix_solution_curves_free(c->ctx, s);
    return st;
}

typedef ix_status (*silhouette_fn)(ix_ctx *, const ix_mv *, const double *,
                                   double, ix_solution_curves *);

static ix_status along_vector(ix_call *c, silhouette_fn fn)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_solution_curves s;
    double v[3];

    IX_TRY(ix__arg_vec3(c, 1, v));
    return ret_on_surface(c, fn(c->ctx, m, v, ix__contour_tolerance(c), &s), &s,
                          m, 2);
}

static ix_status silhouette(ix_call *c)
{
    double v[3];

    if (c->argv[0]->type == IX_OBJ_POLY) {
        IX_TRY(ix__arg_vec3(c, 1, v));
        if (!ix__arg_bool(c, 2))
            return IX_ARG_FAIL(c, 2,
                               "polygons have no parameters; true is "
                               "wanted");
        return ix__ret_poly_silhouette(c, c->argv[0]->u.poly, v);
    }
    return along_vector(c, ix_silhouette);
}

static ix_status polarsil(ix_call *c)
{
    return along_vector(c, ix_polar_silhouette);
}

/* The part of m on which the angle is below theta (sign 1), or above it; NULL
 * if there is none. */
static ix_status isocline_region(ix_call *c, const ix_mv *m, const double *view,
                                 double theta, double sign, ix_obj **out)
{
    ix_status st;
    ix_lines l;
    ix_mv *f, *g = NULL;

    *out = NULL;
    IX_TRY(ix_isocline_field(c->ctx, m, view, theta, &f));
    st = ix_sym_dot_vector(c->ctx, f, &sign, &g);
    ix_mv_unref(c->ctx, f);
    IX_TRY(st);
    st = ix_positive_region(c->ctx, g, ix__contour_tolerance(c), &l);
    ix_mv_unref(c->ctx, g);
    IX_TRY(st);
    st = l.n ? ix__region_obj(c->ctx, m, &l, out) : IX_OK;
    ix_lines_free(c->ctx, &l);
    return st;
}

/* The surface between two polylines of n points, linear in both directions. */
static ix_status between_lines(ix_call *c, int n, const double (*p)[3],
                               ix_obj **out)
{
    double kw[4] = {0, 0, 1, 1}, *kv, *pts;
    ix_dir d[2] = {{IX_BSPLINE, 2, n, false, NULL},
                   {IX_BSPLINE, 2, 2, false, kw}};
    ix_mv *m;

    IX_SCRATCH(c->ctx, kv, n + 2);
    IX_SCRATCH(c->ctx, pts, 6 * (size_t)n);
    for (int i = 0; i < n + 2; i++)
        kv[i] = i < 1 ? 0 : i > n ? n - 1 : i - 1;
    for (int i = 0; i < 6 * n; i++)
        pts[i] = p[i % (2 * n)][i / (2 * n)];
    d[0].knots = kv;
    IX_TRY(ix_mv_new(c->ctx, 2, d, 3, false, pts, &m));
    *out = ix__obj_mv(c->ctx, IX_OBJ_SURFACE, m);
    return *out ? IX_OK : IX_ENOMEM;
}

/* The region and, behind it, the ruled surfaces that go on from it. */
static ix_status isocline_drafts(ix_call *c, const ix_mv *m, const double *view,
                                 double theta, ix_obj *region, int mode)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;
    const double(*p)[3];
    ix_lines l = {0};

    if (region && st == IX_OK)
        st = ix__list_add(c->ctx, list, ix__obj_ref(region));
    if (st == IX_OK)
        st = ix_isocline_drafts(c->ctx, m, view, theta, mode < 0,
                                ix__contour_tolerance(c), &l);
    p = (const double(*)[3])l.pt;
    for (int i = 0; st == IX_OK && i < l.n; p += 2 * l.count[i], i += 2) {
        ix_obj *ruled = NULL;

        st = between_lines(c, l.count[i], p, &ruled);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, ruled);
    }
    ix_lines_free(c->ctx, &l);
    return ix__ret_list(c, list, st);
}

static ix_status isocline(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double view[3], theta = ix__arg_num(c, 2) * (acos(-1) / 180);
    ix_solution_curves s;
    ix_obj *region;
    ix_status st;
    int mode;

    IX_TRY(ix__arg_vec3(c, 1, view));
    IX_TRY(ix__arg_int(c, 4, -2, 2, &mode));
    if (mode) {
        IX_TRY(isocline_region(c, m, view, theta, mode, &region));
        if (mode == 1 || mode == -1)
            return region ? ix__ret(c, region) : IX_OK;
        st = isocline_drafts(c, m, view, theta, region, mode);
        ix__obj_unref(c->ctx, region);
        return st;
    }
    return ret_on_surface(
        c, ix_isocline(c->ctx, m, view, theta, ix__contour_tolerance(c), &s),
        &s, m, 3);
}

#define C "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,3,0))); "
#define S                                                               \
    "s = sbezier(list(list(point(0,0,0), point(1,0,1), point(2,0,0)), " \
    "list(point(0,1,0), point(1,1,2), point(2,1,1)))); "

const ix_builtin ix__builtins_distance[] = {
    {"CRVPTDST", "c:curve p:pt3 min:bool eps:num -> num|list",
     "The parameter of the point of a curve nearest to p (farthest if min is "
     "off), ends included; with eps < 0 the list of all parameters where the "
     "distance is stationary. Time is linear in the number of spans.",
     C "t = crvptdst(c, point(1, 3, 0), true, 1e-5);", crvptdst, 0, 9},
    {"CRVLNDST", "c:curve p:pt3 d:pv min:bool eps:num -> num|list",
     "As CRVPTDST, for the distance from the line through p in direction d.",
     C "t = crvlndst(c, point(0, 5, 0), vector(1, 0, 0), true, 1e-5);",
     crvlndst, 0, 9},
    {"CRVPTTAN", "c:curve p:pt3 fineness:num -> list",
     "The parameters at which the tangent line of a planar curve passes "
     "through p.",
     C "l = crvpttan(c, point(1, 5, 0), 0.01);", crvpttan, 0, 9},
    {"CPINCLUDE", "c:curve p:pt3 eps:num -> num",
     "1 if p is inside a closed planar curve, -1 outside, 0 if it is within "
     "eps of the curve.",
     "i = cpinclude(circle(vector(0, 0, 0), 1), point(0.1, 0, 0), 1e-5);",
     cpinclude, 0, 9},
    {"CCINTER", "c1:curve c2:curve eps:num self:bool -> list|surface",
     "All intersections of two curves in the XY plane as points (t1, t2, 0); "
     "with self on, of c1 with itself. With eps <= 0 the squared distance as "
     "the surface (t1, t2, distance). Time grows as spans and crossings of two "
     "curves do (n log n), with self on as the square.",
     C "i = ccinter(c, c * rotz(10), 1e-5, false);", ccinter, 0, 9},
    {"SRFPTDST", "s:surface p:pt3 min:bool subdiv:num numer:num -> point|list",
     "The parameters (u, v, 0) of the point of a surface nearest to p "
     "(farthest if min is off); with subdiv < 0 the list of all interior ones "
     "where the distance is stationary. Time is linear in the number of "
     "patches.",
     S "q = srfptdst(s, point(1, 1, 5), true, 0.1, 1e-6);", srfptdst, 0, 13},
    {"SRFLNDST",
     "s:surface p:pt3 d:pv min:bool subdiv:num numer:num -> point|list",
     "As SRFPTDST, for the distance from the line through p in direction d.",
     S "q = srflndst(s, point(1, 1, 5), vector(1, 0, 0), true, 0.1, 1e-6);",
     srflndst, 0, 13},
    {"CONTOUR",
     "x:poly|curve|surface pl:plane [mapped:surface] [cone:list] -> poly|list",
     "Where the plane cuts x, as polylines: (u, v, 0) of a scalar surface "
     "(its value is x: use plane(1, 0, 0, -level)), else points of x, or of "
     "mapped, and with cone = list(direction, degrees) only those where its "
     "normal is that near to the direction. Of a curve the parameters, as "
     "points; polygons are cut as such. No value if there is no such curve.",
     S "o = contour(s, plane(0, 0, 1, -0.5));", contour, 0, 13},
    {"SILHOUETTE", "s:poly|surface view:pv euclid:bool -> poly",
     "Where the normal of a surface is perpendicular to view, as polylines on "
     "the surface or, with euclid off, in its parameters; of polygons the "
     "edges between those that face the view and those that do not.",
     S "o = silhouette(s, vector(1, 1, 0), true);", silhouette, 0, 13},
    {"ISOCLINE",
     "s:surface dir:pv theta:num euclid:bool mode:num -> poly|trimsrf|list",
     "Where the line of the normal of a surface makes the angle theta "
     "(degrees) "
     "with dir: mode 0 the curves, as SILHOUETTE; mode 1 the part of the "
     "surface, trimmed, in which the angle is less (of 90 degrees: the normal "
     "points along dir), mode -1 the rest of it. No value if there is none. "
     "Modes 2 and -2 give a list of that part and of ruled surfaces of "
     "constant "
     "slope that go on from it, tangent to it, where the rest is cut off: to "
     "the level, along dir, of the farthest control point.",
     S "o = isocline(s, vector(0, 0, 1), 30, true, 0); "
       "t = isocline(s, vector(0, 0, 1), 40, true, 1); "
       "l = isocline(s, vector(0, 0, 1), 40, true, -2);",
     isocline, 0, 13},
    {"POLARSIL", "s:surface axis:pv euclid:bool -> poly",
     "Where (S x normal) is perpendicular to axis: the silhouette that the "
     "surface makes when it turns about the axis through the origin.",
     S "o = polarsil(s, vector(0, 0, 1), true);", polarsil, 0, 13},
    {0}};
