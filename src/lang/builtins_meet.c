/* builtins_meet.c - intersections of several freeforms, pairs of points of one
 * curve, distances of two freeforms (chapters 9, 13 and 22 of spec/functions).
 * Tolerances that scripts give for the subdivision are not needed. */
#include <math.h>
#include <string.h>

#include "iritx/contour.h"
#include "iritx/distance.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "mv/mv.h"

/* --- solutions as control points
 * ------------------------------------------------- */

static ix_obj *params_object(ix_ctx *ctx, const double *x, int n)
{
    ix_ctlpt p = {.ncoords = n};

    memcpy(p.v, x, (size_t)n * sizeof *p.v);
    return ix__obj_ctlpt(ctx, &p);
}

static ix_obj *solution_object(ix_ctx *ctx, const ix_solution *s, int n)
{
    ix_obj *o = params_object(ctx, s->x, n);

    if (!o)
        return NULL;
    if (ix__attr_set_int(ctx, &o->attrs, "SingleSol", s->certified) == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static void remark_open(ix_call *c, const ix_solutions *s)
{
    if (!s->complete)
        ix__remark(c->in,
                   "stopped after %zu boxes: there may be infinitely many "
                   "solutions",
                   s->boxes);
}

/* The solutions are released. */
static ix_status ret_solutions(ix_call *c, ix_solutions *s)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    remark_open(c, s);
    for (int i = 0; st == IX_OK && i < s->n; i++)
        st = ix__list_add(c->ctx, list,
                          solution_object(c->ctx, &s->sol[i], s->unknowns));
    ix_solutions_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

static ix_obj *pair_point(ix_ctx *ctx, const ix_solution *s)
{
    const double p[3] = {s->x[0], s->x[1], 0};

    return ix__obj_point(ctx, p);
}

/* Points (t, r, 0); the solutions are released. */
static ix_status ret_points(ix_call *c, ix_solutions *s)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    remark_open(c, s);
    for (int i = 0; st == IX_OK && i < s->n; i++)
        st = ix__list_add(c->ctx, list, pair_point(c->ctx, &s->sol[i]));
    ix_solutions_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

/* --- pairs of points of one curve
 * ------------------------------------------------- */

static ix_status antipodal(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_solutions s;

    if (m->ndirs == 2)
        IX_TRY(ix_srf_antipodal(c->ctx, m, &s));
    else
        IX_TRY(ix_crv_antipodal(c->ctx, m, &s));
    return ret_solutions(c, &s);
}

static ix_status crv2tans(ix_call *c)
{
    ix_solutions s;

    IX_TRY(ix_crv_bitangents(c->ctx, ix__arg_mv(c, 0), &s));
    return ret_points(c, &s);
}

static ix_status chord_of(ix_call *c, const ix_mv *m, const double *tr,
                          double *len)
{
    double a[IX_MAX_COORDS] = {0}, b[IX_MAX_COORDS] = {0}, s = 0;

    IX_TRY(ix_mv_point(c->ctx, m, &tr[0], a));
    IX_TRY(ix_mv_point(c->ctx, m, &tr[1], b));
    for (int k = 0; k < m->ncoords; k++)
        s += (a[k] - b[k]) * (a[k] - b[k]);
    *len = sqrt(s);
    return IX_OK;
}

static ix_status extreme_chord(ix_call *c, const ix_mv *m, bool largest,
                               const ix_solutions *s)
{
    double best = 0, len;
    int at = -1;

    for (int i = 0; i < s->n; i++) {
        IX_TRY(chord_of(c, m, s->sol[i].x, &len));
        if (at < 0 || (largest ? len > best : len < best)) {
            best = len;
            at = i;
        }
    }
    return at < 0 ? IX_OK : ix__ret(c, pair_point(c->ctx, &s->sol[at]));
}

static ix_status crvdiamtr(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_solutions s;
    ix_status st;
    int which;

    IX_TRY(ix__arg_int(c, 3, 0, 2, &which));
    IX_TRY(ix_crv_antipodal(c->ctx, m, &s));
    if (which == 2)
        return ret_points(c, &s);
    remark_open(c, &s);
    st = extreme_chord(c, m, which == 1, &s);
    ix_solutions_free(c->ctx, &s);
    return st;
}

static ix_status ret_crossings(ix_call *c, const ix_mv *m, ix_solutions *s)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < s->n; i++) {
        double x[IX_MAX_COORDS] = {0};

        st = ix_mv_point(c->ctx, m, s->sol[i].x, x);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, x));
    }
    ix_solutions_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

/* --- circles and light
 * -------------------------------------------------------- */

/* A centre with both parameters. */
static ix_obj *center_object(ix_ctx *ctx, const ix_solution *s)
{
    const double p[3] = {s->x[2], s->x[3], 0};
    ix_obj *o = ix__obj_point(ctx, p), *params = pair_point(ctx, s);
    ix_status st = IX_ENOMEM;

    if (o && params)
        st = ix__attr_set_obj(ctx, &o->attrs, "Params", params);
    ix__obj_unref(ctx, params);
    if (st == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status crc2crvtan(ix_call *c)
{
    ix_solutions s;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix_crv_tangent_circles(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                                  ix__arg_num(c, 2), &s));
    remark_open(c, &s);
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < s.n; i++)
        st = ix__list_add(c->ctx, list, center_object(c->ctx, &s.sol[i]));
    ix_solutions_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

static bool all_have(const ix_mv **mv, int n, int ndirs)
{
    for (int i = 0; i < n; i++)
        if (mv[i]->ndirs != ndirs)
            return false;
    return true;
}

static ix_status raytraps(ix_call *c)
{
    const ix_mv **crv;
    ix_solutions s;
    int n;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_UNDEF, &n, &crv));
    if (n > 0 && all_have(crv, n, 1)) {
        IX_TRY(ix_crv_ray_traps(c->ctx, n, crv, &s));
    } else {
        if (n != 2 || !all_have(crv, n, 2))
            return IX_ARG_FAIL(c, 0,
                               "%d freeforms; 2 to %d curves, or 2 surfaces, "
                               "are wanted",
                               n, IX_MAX_UNKNOWNS);
        IX_TRY(ix_srf_ray_traps(c->ctx, crv[0], crv[1], &s));
    }
    return ret_solutions(c, &s);
}

/* --- several freeforms
 * -------------------------------------------------------------- */

/* Vertices of the intersection curves of two surfaces as control points. */
static ix_status meeting_cloud(ix_call *c, const ix_mv **mv, double cell)
{
    ix_solution_curves s;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix_srf_srf_meet(c->ctx, mv[0], mv[1], fmin(cell * cell, 1e-2), &s));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; i < s.ncurves; i++)
        for (int k = 0; st == IX_OK && k < s.curve[i].n; k++)
            st = ix__list_add(
                c->ctx, list,
                params_object(c->ctx, s.curve[i].x + (size_t)k * 4, 4));
    ix_solution_curves_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

static ix_status mvinter(ix_call *c)
{
    ix_solutions s;
    const ix_mv **mv;
    int n;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_UNDEF, &n, &mv));
    if (n == 2 && all_have(mv, n, 1)) {
        IX_TRY(ix_crv_crv_meet(c->ctx, mv[0], mv[1], NULL, &s));
        return ret_solutions(c, &s);
    }
    if (n == 2 && all_have(mv, n, 2))
        return meeting_cloud(c, mv, fmax(ix__arg_num(c, 1), 1e-4));
    if (n == 3 && all_have(mv, n, 2)) {
        IX_TRY(ix_srf3_meet(c->ctx, mv, &s));
        return ret_solutions(c, &s);
    }
    return IX_ARG_FAIL(
        c, 0, "%d freeforms; 2 curves, or 2 or 3 surfaces are wanted", n);
}

static ix_status point_on(ix_call *c, const ix_mv *m, const double *uv,
                          double p[3])
{
    double x[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(c->ctx, m, uv, x));
    memcpy(p, x, 3 * sizeof *p);
    return IX_OK;
}

/* Polylines on m, or (first, first + 1) of the parameters if m is NULL. */
static ix_status polylines(ix_call *c, const ix_solution_curves *s,
                           const ix_mv *m, int first, ix_obj **out)
{
    ix_poly *p = ix__poly_new(c->ctx, s->ncurves);
    ix_status st = p ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < s->ncurves; i++) {
        const ix_solution_curve *k = &s->curve[i];

        p->poly[i].kind = IX_POLYLINE;
        st = ix__poly_vertices(c->ctx, &p->poly[i], k->n);
        for (int v = 0; st == IX_OK && v < k->n; v++) {
            const double *x = k->x + (size_t)v * 4 + first;

            if (m)
                st = point_on(c, m, x, p->poly[i].v[v].p);
            else
                memcpy(p->poly[i].v[v].p, x, 2 * sizeof *x);
        }
    }
    if (st != IX_OK) {
        if (p)
            ix__poly_unref(c->ctx, p);
        return st;
    }
    *out = ix__obj_poly(c->ctx, p);
    return *out ? IX_OK : IX_ENOMEM;
}

static void remark_curves(ix_call *c, const ix_solution_curves *s)
{
    if (s->area)
        ix__remark(c->in, "the surfaces lie, in part, in one plane: where they "
                          "cover each other there are no curves");
    else if (!s->complete)
        ix__remark(c->in,
                   "stopped after %zu cells: the surfaces touch along a curve, "
                   "or coincide, or nearly so",
                   s->boxes);
}

static ix_status meeting_lines(ix_call *c, const ix_solution_curves *s,
                               const ix_mv *a, bool euclid)
{
    ix_obj *list, *o;
    ix_status st;

    if (euclid) {
        IX_TRY(polylines(c, s, a, 0, &o));
        return ix__ret(c, o);
    }
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int k = 0; st == IX_OK && k < 2; k++) {
        st = polylines(c, s, NULL, 2 * k, &o);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, o);
    }
    return ix__ret_list(c, list, st);
}

static ix_status ssintr2(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0);
    double step = ix__arg_num(c, 2);
    ix_solution_curves s;
    ix_status st = IX_OK;

    if (!(step > 0))
        return IX_ARG_FAIL(c, 2, "a step of %g; it must be positive", step);
    /* chords of that length on a circle as large as the domain */
    IX_TRY(ix_srf_srf_meet(c->ctx, a, ix__arg_mv(c, 1),
                           fmin(step * step / 8, 1e-2), &s));
    remark_curves(c, &s);
    if (s.ncurves > 0)
        st = meeting_lines(c, &s, a, ix__arg_bool(c, 5));
    ix_solution_curves_free(c->ctx, &s);
    return st;
}

/* One polyline as a curve of order 2 through its vertices: in space on m, or
 * in the parameter plane. */
static ix_status line_curve(ix_call *c, const ix_solution_curve *k,
                            const ix_mv *m, int first, ix_obj **out)
{
    int nc = m ? 3 : 2, n = k->n;
    double *pts;

    IX_SCRATCH(c->ctx, pts, (size_t)nc * (size_t)n);
    for (int i = 0; i < n; i++) {
        const double *x = k->x + (size_t)i * 4 + first;
        double p[3] = {x[0], x[1], 0};

        if (m)
            IX_TRY(point_on(c, m, x, p));
        for (int e = 0; e < nc; e++)
            pts[(size_t)e * (size_t)n + (size_t)i] = p[e];
    }
    return ix__polyline_curve(c, n, nc, pts, out);
}

static ix_status curves_on(ix_call *c, const ix_solution_curves *s,
                           const ix_mv *m, int first, ix_obj **out)
{
    ix_obj *list = ix__obj_list(c->ctx), *o;
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < s->ncurves; i++) {
        st = line_curve(c, &s->curve[i], m, first, &o);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, o);
    }
    if (st != IX_OK && list)
        ix__obj_unref(c->ctx, list);
    *out = st == IX_OK ? list : NULL;
    return st;
}

static ix_status ssinter(ix_call *c)
{
    const ix_mv *m[2] = {ix__arg_mv(c, 0), ix__arg_mv(c, 1)};
    double eps = ix__arg_num(c, 3);
    bool euclid = ix__arg_bool(c, 2);
    ix_solution_curves s;
    ix_obj *list, *o;
    ix_status st;

    if (!(eps > 0))
        return IX_ARG_FAIL(c, 3, "a tolerance of %g; it must be positive", eps);
    IX_TRY(ix_srf_srf_meet(c->ctx, m[0], m[1], fmin(eps, 1e-2), &s));
    remark_curves(c, &s);
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int k = 0; st == IX_OK && k < 2; k++) {
        st = curves_on(c, &s, euclid ? m[k] : NULL, 2 * k, &o);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, o);
    }
    ix_solution_curves_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

/* --- one freeform with itself
 * ------------------------------------------------- */

/* Curves of a surface in space, or in both pairs of parameters. */
static ix_status srf_selfinter(ix_call *c, const ix_mv *m)
{
    double step = fabs(ix__arg_num(c, 1));
    ix_solution_curves s;
    ix_status st = IX_OK;

    /* chords of that length on a circle as large as the domain */
    IX_TRY(ix_srf_self_meet(c->ctx, m, fmin(fmax(step * step / 8, 1e-6), 1e-2),
                            &s));
    remark_curves(c, &s);
    if (s.ncurves > 0)
        st = meeting_lines(c, &s, m, ix__arg_bool(c, 4));
    ix_solution_curves_free(c->ctx, &s);
    return st;
}

static ix_status selfinter(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_solutions s;

    if (m->ndirs == 2)
        return srf_selfinter(c, m);
    IX_TRY(ix_crv_self_meet(c->ctx, m, &s));
    if (!ix__arg_bool(c, 4))
        return ret_solutions(c, &s);
    remark_open(c, &s);
    return ret_crossings(c, m, &s);
}

static ix_status ciextreme(ix_call *c)
{
    ix_solutions s;
    int dir;

    IX_TRY(ix__arg_dir(c, 1, 2, &dir));
    IX_TRY(ix_implicit_extremes(c->ctx, ix__arg_mv(c, 0), dir, &s));
    return ret_solutions(c, &s);
}

/* --- distances of two freeforms
 * ----------------------------------------------------- */

/* A point becomes a curve of order 1; new reference. */
static ix_status arg_any(ix_call *c, int i, ix_mv **out)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 1, .length = 1};
    double p[3];

    if (c->argv[i]->type == IX_OBJ_CURVE ||
        c->argv[i]->type == IX_OBJ_SURFACE) {
        *out = ix_mv_ref(ix__arg_mv(c, i));
        return IX_OK;
    }
    IX_TRY(ix__arg_pt3(c, i, p));
    return ix_mv_new(c->ctx, 1, &d, 3, false, p, out);
}

/* The parameters in a list, which is empty for a point. */
static ix_status add_params(ix_call *c, ix_obj *list, const ix_mv *m,
                            const double *t)
{
    ix_obj *own = ix__obj_list(c->ctx);
    ix_status st = own ? IX_OK : IX_ENOMEM;

    if (st == IX_OK && (m->ndirs > 1 || m->dirs[0].order > 1))
        st = ix__list_add(c->ctx, own, params_object(c->ctx, t, m->ndirs));
    if (st == IX_OK)
        return ix__list_add(c->ctx, list, own);
    if (own)
        ix__obj_unref(c->ctx, own);
    return st;
}

static ix_status ret_distance(ix_call *c, const ix_mv *a, const ix_mv *b,
                              const ix_distance *d)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    if (st == IX_OK)
        st = ix__list_add_num(c->ctx, list, d->distance);
    if (st == IX_OK)
        st = add_params(c, list, a, d->a);
    if (st == IX_OK)
        st = add_params(c, list, b, d->b);
    return ix__ret_list(c, list, st);
}

static ix_status two_distance(ix_call *c, bool least)
{
    double eps = ix__arg_num(c, 2);
    ix_distance d;
    ix_mv *a, *b;
    ix_status st;

    IX_TRY(arg_any(c, 0, &a));
    st = arg_any(c, 1, &b);
    if (st == IX_OK) {
        st = least
                 ? ix_distance_least(c->ctx, a, b, &d)
                 : ix_distance_hausdorff(c->ctx, a, b, ix__arg_bool(c, 3), &d);
        if (st == IX_OK && d.error > fabs(eps))
            ix__remark(c->in, "the distance may be off by %g", d.error);
        if (st == IX_OK)
            st = ret_distance(c, a, b, &d);
        ix_mv_unref(c->ctx, b);
    }
    ix_mv_unref(c->ctx, a);
    return st;
}

static ix_status mindist2ff(ix_call *c)
{
    return two_distance(c, true);
}

static ix_status hausdorff(ix_call *c)
{
    return two_distance(c, false);
}

#define C "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,3,0))); "
#define S                                                               \
    "s = sbezier(list(list(point(0,0,0), point(1,0,1), point(2,0,0)), " \
    "list(point(0,1,0), point(1,1,2), point(2,1,1)))); "                \
    "s2 = sbezier(list(list(point(0,0,0.5), point(2,0,0.5)), "          \
    "list(point(0,1,0.5), point(2,1,0.5)))); "

const ix_builtin ix__builtins_meet[] = {
    {"ANTIPODAL", "x:curve|surface subdiv:num numer:num -> list",
     "Pairs of parameters whose points are connected by a line that is normal "
     "to the curve or surface at both, as control points (t1, t2) or (u1, v1, "
     "u2, v2), each pair once; the tolerances are not needed.",
     "l = antipodal(circle(vector(0, 0, 0), 1) * sx(2), 0.01, -1e-8);",
     antipodal, IX_B_SOFT, 22},
    {"CRV2TANS", "c:curve fineness:num -> list",
     "Pairs of parameters with one tangent line in common, in the XY plane, as "
     "points (t1, t2, 0); fineness is not needed.",
     "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,3), ctlpt(E2,2,-4), "
     "ctlpt(E2,3,3), ctlpt(E2,4,0))); l = crv2tans(c, 10);",
     crv2tans, 0, 9},
    {"CRC2CRVTAN", "c1:curve c2:curve r:num tol:num -> list",
     "The centres of all circles of radius r that touch both curves, in the XY "
     "plane; the attribute Params is the point (t1, t2, 0) of the parameters. "
     "tol is not needed.",
     C "l = crc2crvtan(c, c * ty(1), 0.3, 1e-3); "
       "t = getattr(nth(l, 1), \"Params\");",
     crc2crvtan, 0, 9},
    {"RAYTRAPS", "l:list orient:num subdiv:num numer:num trees:num -> list",
     "Closed paths of light that bounce once on each of 2 to 6 curves, in the "
     "order of the list, in the XY plane, or between 2 surfaces: control "
     "points "
     "of the parameters. The other arguments are not needed.",
     "a = cbezier(list(ctlpt(E2,-1,1), ctlpt(E2,0,0.2), ctlpt(E2,1,1))); "
     "l = raytraps(list(a, a * ty(-3)), true, 0.1, -1e-6, true);",
     raytraps, 0, 22},
    {"CRVDIAMTR", "c:curve subdiv:num numer:num which:num -> point|list",
     "The pairs of ANTIPODAL as points (t1, t2, 0): the shortest (which 0), "
     "the "
     "longest (1), or the list of all (2).",
     "q = crvdiamtr(circle(vector(0, 0, 0), 1) * sx(2), 0.01, 1e-8, 1);",
     crvdiamtr, 0, 9},
    {"SELFINTER",
     "x:curve|surface subdiv:num numer:num mindev:num euclid:bool -> list|poly",
     "Self-intersections: of a planar curve as pairs of parameters (control "
     "points) or, with euclid, as points; of a surface as polylines in space, "
     "or as a list of polylines (u1, v1, 0) and (u2, v2, 0), with chords of "
     "about subdiv, and no value if there are none. Points that are their own "
     "partner are divided out algebraically, whatever mindev is.",
     "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,3,2), ctlpt(E2,-2,2), "
     "ctlpt(E2,1,0))); l = selfinter(c, 0.001, 1e-8, 15, true);",
     selfinter, 0, 22},
    {"MVINTER", "l:list subdiv:num numer:num trees:bool -> list",
     "Intersections of two planar curves (t1, t2), of two surfaces (u1, v1, "
     "u2, v2: vertices of the curves, as dense as subdiv asks for) or of three "
     "surfaces (E6), as control points.",
     C "l = mvinter(list(c, c * rotz(10)), 0.01, -1e-8, true);", mvinter, 0,
     22},
    {"SSINTR2",
     "s1:surface s2:surface step:num subdiv:num numer:num euclid:bool -> "
     "poly|list",
     "The intersection of two surfaces as polylines in space, or as a list of "
     "polylines (u1, v1, 0) and (u2, v2, 0); no value if there is none.",
     S "o = ssintr2(s, s2, 0.1, 0.01, 1e-8, true);", ssintr2, 0, 13},
    {"SSINTER", "s1:surface s2:surface euclid:bool eps:num align:bool -> list",
     "The intersection of two surfaces: a list of the curves on s1 and of "
     "those on s2, of order 2, in space or in the parameters.",
     S "l = ssinter(s, s2, true, 0.01, false);", ssinter, 0, 13},
    {"CIEXTREME", "s:surface dir:num subdiv:num numer:num -> list",
     "The points of the curve s(u, v) = 0 where u (dir COL) or v (ROW) is "
     "stationary along it, as control points.",
     "s = sbezier(list(list(ctlpt(E1,1), ctlpt(E1,-1), ctlpt(E1,1)), "
     "list(ctlpt(E1,-1), ctlpt(E1,-3), ctlpt(E1,-1)), list(ctlpt(E1,1), "
     "ctlpt(E1,-1), ctlpt(E1,1)))); l = ciextreme(s, COL, 0.01, 1e-8);",
     ciextreme, 0, 9},
    {"MINDIST2FF",
     "a:point|vector|ctlpt|curve|surface b:point|vector|ctlpt|curve|surface "
     "eps:num -> list",
     "The least distance, with lists of the parameters on a and on b; bounded "
     "to rounding, eps only decides whether a remark is made.",
     C "l = mindist2ff(c, point(1, 4, 0), 0.001);", mindist2ff, 0, 22},
    {"HAUSDORFF",
     "a:point|vector|ctlpt|curve|surface b:point|vector|ctlpt|curve|surface "
     "eps:num onesided:bool -> list",
     "The Hausdorff distance (one-sided: the largest distance of a point of a "
     "from b), with lists of the parameters on a and on b; as MINDIST2FF.",
     C "l = hausdorff(c, c * rotz(10), 0.001, true);", hausdorff, 0, 22},
    {0}};
