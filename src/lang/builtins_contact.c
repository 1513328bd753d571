/* builtins_contact.c - planes, motions and rays that touch surfaces, curves
 * projected on them, what they mirror, ruled and ringed surfaces that meet
 * (chapters 13 and 22 of spec/functions). Tolerances that scripts give for the
 * subdivision are not needed; RESOLUTION sets how fine curves are. */
#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/contact.h"
#include "geom/meet_fields.h"
#include "geom/reflection.h"
#include "geom/vec3.h"
#include "iritx/contour.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "lang/ret_solutions.h"
#include "mv/mv.h"

/* --- common tangent planes
 * ----------------------------------------------------- */

static ix_status arg_surfaces(ix_call *c, int want, const ix_mv ***s)
{
    int n;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_SURFACE, &n, s));
    if (n != want)
        return IX_ARG_FAIL(c, 0, "%d surfaces; %d are wanted", n, want);
    return IX_OK;
}

/* Do the normals of all surfaces at x point the way that argument 1 says? */
static ix_status oriented(ix_call *c, const double *x, bool *out)
{
    double want = ix__arg_num(c, 1), n[2][3];
    const ix_mv **s;
    int count;

    *out = true;
    if (want == 0)
        return IX_OK;
    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_SURFACE, &count, &s));
    IX_TRY(ix_srf_normal(c->ctx, s[0], x[0], x[1], n[0]));
    for (int k = 1; *out && k < count; k++) {
        IX_TRY(ix_srf_normal(c->ctx, s[k], x[2 * k], x[2 * k + 1], n[1]));
        *out = ix__dot3(n[0], n[1]) * want > 0;
    }
    return IX_OK;
}

static ix_status srf2tans(ix_call *c)
{
    ix_solution_curves s;
    const ix_mv **m;

    IX_TRY(arg_surfaces(c, 2, &m));
    IX_TRY(
        ix__srf_bitangents(c->ctx, m[0], m[1], ix__contour_tolerance(c), &s));
    return ix__ret_curves(c, &s, (ix__unknowns){.count = 4}, oriented);
}

static ix_status srf3tans(ix_call *c)
{
    const ix_mv **m;
    ix_solutions s;

    IX_TRY(arg_surfaces(c, 3, &m));
    IX_TRY(ix__srf_tritangents(c->ctx, m, &s));
    return ix__ret_points(c, &s, oriented);
}

/* --- motions
 * ---------------------------------------------------------------- */

/* The curve of the list that has a name; NULL if there is none. */
static const ix_mv *named(const ix_list *l, const char *name)
{
    for (int i = 0; i < l->n; i++)
        if (l->item[i]->type == IX_OBJ_CURVE && l->item[i]->name &&
            ix__name_cmp(l->item[i]->name, name) == 0)
            return ix__obj_first_mv(l->item[i]);
    return NULL;
}

static ix_status mvcontact(ix_call *c)
{
    const ix_list *l = &c->argv[2]->u.list;
    const ix_mv *mov = named(l, "MOV_XYZ"), *scl = named(l, "SCL");
    ix_solutions s;

    if (!mov && !scl)
        return IX_ARG_FAIL(c, 2,
                           "no curve of the list has the name MOV_XYZ or SCL");
    IX_TRY(ix__srf_contacts(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), mov,
                            scl, &s));
    return ix__ret_points(c, &s, NULL);
}

/* --- rays, feet
 * ------------------------------------------------------------- */

static ix_status saccess(ix_call *c)
{
    const ix_obj *o = c->argv[1];
    const double *dir = NULL;
    ix_solution_curves s;

    if (o->type == IX_OBJ_VECTOR || o->type == IX_OBJ_POINT)
        dir = o->u.pt;
    else if (o->type != IX_OBJ_NUMBER || o->u.num != 0)
        return IX_ARG_FAIL(c, 1, "a vector, or 0 for the normals, is wanted");
    if (c->argv[3]->type != IX_OBJ_NUMBER || c->argv[3]->u.num != 0)
        return IX_ARG_FAIL(c, 3, "limits are not known here; 0 is wanted");
    IX_TRY(ix__srf_access(c->ctx, ix__arg_mv(c, 0), dir, ix__arg_mv(c, 2),
                          ix__contour_tolerance(c), &s));
    return ix__ret_curves(c, &s, (ix__unknowns){.count = 4}, NULL);
}

static ix_status csrfproj(ix_call *c)
{
    const ix_mv *srf = ix__arg_mv(c, 1);
    double tol = ix__arg_num(c, 2);
    bool euclid = ix__arg_bool(c, 3);
    ix_solution_curves s;

    if (!(tol > 0))
        return IX_ARG_FAIL(c, 2, "a tolerance of %g; it must be positive", tol);
    IX_TRY(
        ix__crv_srf_feet(c->ctx, ix__arg_mv(c, 0), srf, fmin(tol, 1e-2), &s));
    return ix__ret_curves(
        c, &s, (ix__unknowns){.first = 1, .count = 2, .m = euclid ? srf : NULL},
        NULL);
}

/* --- reflections
 * -------------------------------------------------------------- */

/* One element: the line through a point, or the circle of an angle. */
static ix_status reflected(ix_call *c, const double v[3], const ix_obj *first,
                           const ix_obj *o, ix_mv **f)
{
    const ix_mv *s = ix__arg_mv(c, 0);

    if (o->type == IX_OBJ_NUMBER)
        return ix__reflected_circle(c->ctx, s, v, first->u.pt,
                                    IX__RADIANS(o->u.num), f);
    if (o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR)
        return ix__reflected_line(c->ctx, s, v, o->u.pt, first->u.pt, f);
    return IX_ARG_FAIL(c, 2, "a %s where a point or an angle is wanted",
                       ix__obj_type_name(o->type));
}

static ix_status add_reflected(ix_call *c, const double v[3],
                               const ix_obj *first, const ix_obj *o,
                               ix_obj *list)
{
    static const double value[4] = {1, 0, 0, 0};
    ix_solution_curves s;
    ix_status st;
    ix_mv *f;

    IX_TRY(reflected(c, v, first, o, &f));
    st = ix_contour(c->ctx, f, value, ix__contour_tolerance(c), &s);
    ix_mv_unref(c->ctx, f);
    IX_TRY(st);
    st = ix__ret_contours(c, &s, ix__arg_bool(c, 3) ? ix__arg_mv(c, 0) : NULL);
    ix_solution_curves_free(c->ctx, &s);
    if (st == IX_OK && c->result)
        st = ix__list_add(c->ctx, list, c->result);
    c->result = NULL;
    return st;
}

static ix_status rflctln(ix_call *c)
{
    const ix_list *l = &c->argv[2]->u.list;
    ix_obj *list;
    double v[3];
    ix_status st;

    IX_TRY(ix__arg_vec3(c, 1, v));
    if (l->n != 2 ||
        (l->item[0]->type != IX_OBJ_VECTOR &&
         l->item[0]->type != IX_OBJ_POINT) ||
        l->item[1]->type != IX_OBJ_LIST)
        return IX_ARG_FAIL(c, 2,
                           "list(direction, list(points)) or list(axis, "
                           "list(angles)) is wanted");
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < l->item[1]->u.list.n; i++)
        st = add_reflected(c, v, l->item[0], l->item[1]->u.list.item[i], list);
    return ix__ret_list(c, list, st);
}

/* --- ruled and ringed surfaces
 * --------------------------------------------------- */

/* Lists of the curves in space and in the parameters of either surface. */
typedef struct {
    ix_obj *list[3];
    int n;
} results;

static ix_status results_new(ix_call *c, int n, results *r)
{
    *r = (results){.n = n};
    for (int k = 0; k < n; k++)
        if (!(r->list[k] = ix__obj_list(c->ctx)))
            return IX_ENOMEM;
    return IX_OK;
}

static ix_status ret_results(ix_call *c, results *r, ix_status st)
{
    ix_obj *all = st == IX_OK ? ix__obj_list(c->ctx) : NULL;

    if (st == IX_OK && !all)
        st = IX_ENOMEM;
    for (int k = 0; k < r->n; k++) {
        if (st == IX_OK)
            st = ix__obj_append(c->ctx, all, r->list[k]);
        ix__obj_unref(c->ctx, r->list[k]);
    }
    if (st == IX_OK)
        return ix__ret(c, all);
    ix__obj_unref(c->ctx, all);
    return st;
}

/* Both surfaces between their curves. */
static ix_status bounded_ruled(ix_call *c, const ix_mv *const m[4],
                               ix_mv *srf[2], results *r)
{
    ix_solution_curves s;
    ix_status st = IX_OK;

    for (int k = 0; k < 2; k++)
        IX_TRY(ix_srf_ruled(c->ctx, m[2 * k], m[2 * k + 1], &srf[k]));
    IX_TRY(
        ix_srf_srf_meet(c->ctx, srf[0], srf[1], ix__contour_tolerance(c), &s));
    ix__remark_open(c, s.complete, s.boxes);
    for (int i = 0; st == IX_OK && i < s.ncurves; i++) {
        st = ix__add_solution_curve(
            c, &s.curve[i], (ix__unknowns){4, 0, 2, srf[0]}, r->list[0]);
        for (int k = 0; st == IX_OK && k < 2; k++)
            st = ix__add_solution_curve(c, &s.curve[i],
                                        (ix__unknowns){4, 2 * k, 2, NULL},
                                        r->list[k + 1]);
    }
    ix_solution_curves_free(c->ctx, &s);
    return st;
}

/* Vertices of a curve (u, v) of the field's zeros: points in space, parameters
 * on both surfaces. */
typedef struct {
    bool found;
    double at[3][3];
} vertex;

/* Ruled (side 0) or ringed, whose circles may meet on either side. */
static ix_status locate(ix_call *c, const ix_mv *const m[4], const double *uv,
                        int side, vertex *x)
{
    double along[2] = {uv[1], uv[0]};

    if (side)
        IX_TRY(ix__ring_meet_point(c->ctx, m, uv[0], uv[1], side, x->at[0],
                                   &x->found));
    else
        IX_TRY(ix__ruled_meet_point(c->ctx, m, uv[0], uv[1], x->at[0], along,
                                    &x->found));
    for (int e = 0; e < 2; e++) {
        x->at[e + 1][0] = uv[e];
        x->at[e + 1][1] = along[e];
    }
    return IX_OK;
}

/* n > 1 vertices in a row as a curve of each list. */
static ix_status add_run(ix_call *c, int n, const vertex *x, results *r)
{
    double *pts;

    IX_SCRATCH(c->ctx, pts, 3 * (size_t)n);
    for (int e = 0; e < r->n; e++) {
        int nc = e ? 2 : 3;
        ix_obj *o;

        for (int i = 0; i < n; i++)
            for (int k = 0; k < nc; k++)
                pts[k * n + i] = x[i].at[e][k];
        IX_TRY(ix__polyline_curve(c, n, nc, pts, &o));
        IX_TRY(ix__list_add(c->ctx, r->list[e], o));
    }
    return IX_OK;
}

static ix_status add_zero_curve(ix_call *c, const ix_mv *const m[4],
                                const ix_solution_curve *k, int side,
                                results *r)
{
    vertex *x;
    int run = 0;

    IX_SCRATCH(c->ctx, x, k->n);
    for (int i = 0; i < k->n; i++) {
        IX_TRY(locate(c, m, k->x + 2 * (size_t)i, side, &x[i]));
        run = x[i].found ? run + 1 : 0;
        if (run > 1 && i + 1 == k->n)
            IX_TRY(add_run(c, run, x + i + 1 - run, r));
        if (!x[i].found && i > 0 && x[i - 1].found) {
            int first = i - 1;

            while (first > 0 && x[first - 1].found)
                first--;
            if (i - first > 1)
                IX_TRY(add_run(c, i - first, x + first, r));
        }
    }
    return IX_OK;
}

static ix_status zero_curves(ix_call *c, const ix_mv *const m[4],
                             const ix_mv *f, bool ringed, results *r)
{
    static const double value[4] = {1, 0, 0, 0};
    ix_solution_curves s;
    ix_status st = IX_OK;

    IX_TRY(ix_contour(c->ctx, f, value, ix__contour_tolerance(c), &s));
    ix__remark_open(c, s.complete, s.boxes);
    for (int i = 0; st == IX_OK && i < s.ncurves; i++) {
        st = add_zero_curve(c, m, &s.curve[i], ringed, r);
        if (st == IX_OK && ringed)
            st = add_zero_curve(c, m, &s.curve[i], -1, r);
    }
    ix_solution_curves_free(c->ctx, &s);
    return st;
}

static ix_status meet_by_field(ix_call *c, bool ringed)
{
    const ix_mv *const m[4] = {ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                               ix__arg_mv(c, 2), ix__arg_mv(c, 3)};
    results r = {.n = 0};
    ix_status st;
    ix_mv *f;

    if (ringed)
        IX_TRY(ix__ring_meet_field(c->ctx, m, &f));
    else
        IX_TRY(ix__ruled_meet_field(c->ctx, m, &f));
    if (ix__arg_bool(c, 5))
        return ix__ret_mv(c, -1, f);
    st = results_new(c, ringed ? 2 : 3, &r);
    if (st == IX_OK)
        st = zero_curves(c, m, f, ringed, &r);
    ix_mv_unref(c->ctx, f);
    return ret_results(c, &r, st);
}

static ix_status rrinter(ix_call *c)
{
    const ix_mv *const m[4] = {ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                               ix__arg_mv(c, 2), ix__arg_mv(c, 3)};
    ix_mv *srf[2] = {NULL, NULL};
    ix_status st;
    results r;

    if (ix__arg_bool(c, 5) || ix__arg_num(c, 4) < 0)
        return meet_by_field(c, false);
    st = results_new(c, 3, &r);
    if (st == IX_OK)
        st = bounded_ruled(c, m, srf, &r);
    for (int k = 0; k < 2; k++)
        ix_mv_unref(c->ctx, srf[k]);
    return ret_results(c, &r, st);
}

static ix_status gginter(ix_call *c)
{
    return meet_by_field(c, true);
}

/* --- table ------------------------------------------------------------- */

#define BUMP                                                            \
    "s = sbezier(list(list(point(0,0,0), point(1,0,0), point(2,0,0)), " \
    "list(point(0,1,0), point(1,1,4), point(2,1,0)), "                  \
    "list(point(0,2,0), point(1,2,0), point(2,2,0)))); "
#define CAP                                                              \
    "p = sbezier(list(list(point(-1,-1,-2), point(0,-1,0), "             \
    "point(1,-1,-2)), list(point(-1,0,0), point(0,0,2), point(1,0,0)), " \
    "list(point(-1,1,-2), point(0,1,0), point(1,1,-2)))); "
#define LINES                                                       \
    "a = ctlpt(E3,0,0,0) + ctlpt(E3,4,0,0); b = ctlpt(E3,0,4,1) + " \
    "ctlpt(E3,4,4,0); d = ctlpt(E3,1,1,-2) + ctlpt(E3,1,1,2); e = " \
    "ctlpt(E3,3,2,-2) + ctlpt(E3,3,3,2); "

const ix_builtin ix__builtins_contact[] = {
    {"RRINTER",
     "a1:curve a2:curve b1:curve b2:curve tol:num zeroFunc:bool -> "
     "list|surface",
     "Where the ruled surfaces between a1, a2 and b1, b2 meet: lists of the "
     "curves in space, of those in (u, ruling) of the first and of the second; "
     "with tol < 0 the rulings are whole lines. With zeroFunc the scalar "
     "surface F(u1, u2) that vanishes where rulings meet.",
     LINES "l = rrinter(a, b, d, e, 20, false);", rrinter, 0, 13},
    {"GGINTER",
     "axis1:curve rad1:curve axis2:curve rad2:curve tol:num zeroFunc:bool -> "
     "list|surface",
     "Where two ringed surfaces (circles in the normal planes of an axis, "
     "their radius a scalar polynomial curve) meet: lists of the curves in "
     "space and of those in both axes' parameters; or with zeroFunc the scalar "
     "surface that vanishes where circles meet, or, if both axes lie in one "
     "plane, where their planes and the radical plane share a line. Circles in "
     "parallel planes are left out; curves end at the last of their vertices "
     "where circles meet.",
     LINES "r = ctlpt(E1,0.8) + ctlpt(E1,0.8); l = gginter(a, r, d, r, 20, "
           "false);",
     gginter, 0, 13},
    {"RFLCTLN", "s:surface view:vector src:list euclid:bool -> list",
     "What s mirrors when seen along view: of parallel lines, src = list("
     "direction, list(points)), or of circles far away, src = list(axis, "
     "list(angles in degrees)); a polyline object for each, on s or in its "
     "parameters. It is not looked at whether the line is in front of s.",
     BUMP "l = rflctln(s, vector(0,0,-1), list(vector(1,0,0), "
          "list(point(0,1,5), point(0,2,5))), true);",
     rflctln, 0, 13},
    {"CSRFPROJ", "c:curve s:surface tol:num euclid:bool -> list",
     "All feet of perpendiculars from a curve to the interior of a surface: "
     "curves of order 2 in the parameters of s, or on it; tol is that of the "
     "polylines, as a part of the domain.",
     BUMP "c = ctlpt(E3,0,0,3) + ctlpt(E3,2,2,3); l = csrfproj(c, s, 1e-3, "
          "true);",
     csrfproj, 0, 13},
    {"SRF2TANS", "srfs:list orient:num subdiv:num numer:num merge:num -> list",
     "Planes that touch both surfaces of a list: curves (u1, v1, u2, v2) of "
     "order 2; orient 1 or -1: only where their normals agree, or are "
     "opposite. The other numbers are not needed.",
     CAP "l = srf2tans(list(p, p * tx(3)), 0, 0.1, -1e-6, 0.1);", srf2tans, 0,
     13},
    {"SRF3TANS", "srfs:list orient:num subdiv:num numer:num -> list",
     "Planes that touch all three surfaces of a list: control points (u1, v1, "
     "u2, v2, u3, v3); orient as of SRF2TANS.",
     CAP "l = srf3tans(list(p, p * tx(3), p * ty(4)), 0, 0.5, -1e-6);",
     srf3tans, 0, 13},
    {"MVCONTACT",
     "s1:surface s2:surface motion:list subdiv:num numer:num trees:bool -> "
     "list",
     "Where s1 touches the moving s2, tangent planes in common: control points "
     "(u1, v1, u2, v2, t). The motion is a curve named MOV_XYZ (translation) "
     "and/or one named SCL (scale, before it), with one domain.",
     CAP "mov_xyz = ctlpt(E3,0,0,4) + ctlpt(E3,0,0,-2); l = mvcontact(p, p * "
         "sz(-1), list(mov_xyz), 0.2, -1e-6, true);",
     mvcontact, 0, 22},
    {"SACCESS",
     "s:surface orient:any check:surface limit:any subdiv:num numer:num -> "
     "list",
     "The boundary of what of s can be reached along its normals (orient 0) or "
     "a vector: lines through points of s that touch check, as curves (u, v, "
     "r, t) of order 2. limit is 0; the other numbers are not needed.",
     CAP "l = saccess(p * ty(3) * tz(0.5), vector(0,-1,0), p, 0, 0.1, 1e-5);",
     saccess, 0, 13},
    {0}};
