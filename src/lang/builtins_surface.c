/* builtins_surface.c - surfaces: construction, editing, evaluation, trimming
 * (chapters 11 to 14 of spec/functions). Geometry is made by geom/; here are
 * arguments, the GeomType marks, and the polygons that some constructors
 * accept in place of curves. */
#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "lang/poly_rows.h"
#include "lang/prims_freeform.h"
#include "lang/prims_surface.h"

/* --- control meshes ---------------------------------------------------- */

static ix_status sbezier(ix_call *c)
{
    return ix__ret_mesh(c, 2, IX_BEZIER);
}

static ix_status spower(ix_call *c)
{
    return ix__ret_mesh(c, 2, IX_POWER);
}

static ix_status sbspline(ix_call *c)
{
    return ix__ret_bspline(c, 2, "surface");
}

/* --- ruled, extruded --------------------------------------------------- */

/* Row 1 holds the vertices of another polygon. */
static void ruled_row(const void *arg, int k, int vertex, const double p[3],
                      double out[3])
{
    const ix_polygon *other = arg;

    memcpy(out, k ? other->v[vertex].p : p, 3 * sizeof *out);
}

/* Two polylines of as many vertices as the polygons between them. */
static ix_status ruled_polys(ix_call *c)
{
    const ix_poly *a = c->argv[0]->u.poly, *b = c->argv[1]->u.poly;
    ix_poly *out;

    if (a->n != 1 || b->n != 1 || a->poly[0].n != b->poly[0].n)
        return IX_ARG_FAIL(c, 1,
                           "two polylines with equally many vertices are "
                           "needed, got %d and %d",
                           a->n == 1 ? a->poly[0].n : 0,
                           b->n == 1 ? b->poly[0].n : 0);
    IX_TRY(ix__poly_rows(c->ctx, a, 2, false, ruled_row, &b->poly[0], &out));
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

static ix_status ruledsrf(ix_call *c)
{
    ix_mv *out;

    if (c->argv[0]->type != c->argv[1]->type)
        return IX_ARG_FAIL(c, 1, "a %s and a %s do not go together",
                           ix__obj_type_name(c->argv[0]->type),
                           ix__obj_type_name(c->argv[1]->type));
    if (c->argv[0]->type == IX_OBJ_POLY)
        return ruled_polys(c);
    IX_TRY(ix_srf_ruled(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_RULED);
}

static void moved_row(const void *arg, int k, int vertex, const double p[3],
                      double out[3])
{
    const double *v = arg;

    (void)vertex;
    for (int i = 0; i < 3; i++)
        out[i] = p[i] + k * v[i];
}

static ix_status add_cap(ix_call *c, ix_obj *list, const ix_mv *crv,
                         const char *name)
{
    ix_mv *cap = NULL;
    ix_obj *o;
    ix_status st;

    c->bad_arg = 1;
    IX_TRY(ix_srf_boolone(c->ctx, crv, &cap));
    c->bad_arg = 0;
    o = ix__obj_mv(c->ctx, IX_OBJ_SURFACE, cap);
    if (!o)
        return IX_ENOMEM;
    st = ix__obj_set_name(c->ctx, o, name);
    if (st == IX_OK)
        st = ix__list_add(c->ctx, list, ix__obj_ref(o));
    ix__obj_unref(c->ctx, o);
    return st;
}

/* list(side, bottom and top as far as they are wanted); takes over side. */
static ix_status capped(ix_call *c, const ix_mv *crv, ix_mv *side,
                        const double v[3], int caps)
{
    const double mat[16] = {1, 0, 0, 0, 0,    1,    0,    0,
                            0, 0, 1, 0, v[0], v[1], v[2], 1};
    ix_obj *list = ix__obj_list(c->ctx);
    ix_mv *wide = NULL, *top = NULL;
    ix_status st;

    st = ix_mv_coerce(c->ctx, crv, side->ncoords, crv->rational, &wide);
    if (st == IX_OK)
        st = ix_mv_transform(c->ctx, wide, mat, &top);
    if (st == IX_OK)
        st = ix__list_add(c->ctx, list,
                          ix__obj_mv(c->ctx, IX_OBJ_SURFACE, ix_mv_ref(side)));
    if (st == IX_OK && (caps & 1))
        st = add_cap(c, list, wide, "Base1");
    if (st == IX_OK && (caps & 2))
        st = add_cap(c, list, top, "Base2");
    ix_mv_unref(c->ctx, side);
    ix_mv_unref(c->ctx, wide);
    ix_mv_unref(c->ctx, top);
    return ix__ret_list(c, list, st);
}

static ix_status extrude_one(ix_call *c, const ix_obj *o, const double v[3],
                             int caps)
{
    const ix_mv *m = ix__obj_first_mv(o);
    ix_poly *poly;
    ix_mv *out;

    if (o->type == IX_OBJ_POLY) {
        IX_TRY(ix__poly_rows(c->ctx, o->u.poly, 2, true, moved_row, v, &poly));
        return ix__ret(c, ix__obj_poly(c->ctx, poly));
    }
    if (!m || m->ndirs > 2)
        return IX_ARG_FAIL(c, 0, "a %s cannot be extruded",
                           ix__obj_type_name(o->type));
    IX_TRY(ix_srf_extrude(c->ctx, m, v, &out));
    if (caps && o->type == IX_OBJ_CURVE)
        return capped(c, m, out, v, caps);
    return ix__ret_geom(c, -1, out, IX__GEOM_EXTRUSION);
}

/* Element by element; a list inside a list is not entered. */
static ix_status extrude_list(ix_call *c, const double v[3], int caps)
{
    const ix_list *l = &c->argv[0]->u.list;
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; i < l->n && st == IX_OK; i++) {
        st = extrude_one(c, l->item[i], v, caps);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, c->result);
        c->result = NULL;
    }
    return ix__ret_list(c, list, st);
}

static ix_status extrude(ix_call *c)
{
    double v[3];
    int caps;

    IX_TRY(ix__arg_vec3(c, 1, v));
    IX_TRY(ix__arg_int(c, 2, 0, 3, &caps));
    if (c->argv[0]->type == IX_OBJ_LIST)
        return extrude_list(c, v, caps);
    return extrude_one(c, c->argv[0], v, caps);
}

/* --- revolution -------------------------------------------------------- */

typedef struct {
    int n;
    double (*mat)[16];
} turn;

static void turned_row(const void *arg, int k, int vertex, const double p[3],
                       double out[3])
{
    const turn *t = arg;

    (void)vertex;
    memcpy(out, p, 3 * sizeof *out);
    (void)ix__mat_point(p, t->mat[k], out);
}

/* Polygons or polylines turned in steps of 360 / RESOLUTION degrees. */
static ix_status revolve_poly(ix_call *c, const double axis[3], double a0,
                              double a1)
{
    double per_turn = ix__var_num(c->in, "RESOLUTION", 20);
    int n = (int)ceil(fmin(fmax(per_turn, 4), 10000) * fabs(a1 - a0) / 360);
    turn t = {.n = n < 1 ? 1 : n};
    ix_poly *out;

    IX_SCRATCH(c->ctx, t.mat, t.n + 1);
    for (int k = 0; k <= t.n; k++)
        IX_TRY(ix__mat_rotate_about(c->ctx, axis, a0 + (a1 - a0) * k / t.n,
                                    t.mat[k]));
    IX_TRY(ix__poly_rows(c->ctx, c->argv[0]->u.poly, t.n + 1,
                         fabs(a1 - a0) < 360, turned_row, &t, &out));
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

static const double z_axis[3] = {0, 0, 1};

static ix_status surfrev_as(ix_call *c, ix_turn how)
{
    ix_mv *out;

    IX_TRY(ix_srf_revolve(c->ctx, ix__arg_mv(c, 0), how, &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_SRF_OF_REV);
}

static ix_status surfrev(ix_call *c)
{
    bool exact = ix__states(c->in)->prim_rat_srfs;

    if (c->argv[0]->type == IX_OBJ_POLY)
        return revolve_poly(c, z_axis, 0, 360);
    return surfrev_as(c, exact || ix__arg_mv(c, 0)->rational
                             ? IX_TURN_RATIONAL
                             : IX_TURN_POLYNOMIAL);
}

static ix_status surfprev(ix_call *c)
{
    return surfrev_as(c, IX_TURN_POLYNOMIAL);
}

static ix_status revolve_axis(ix_call *c, double a0, double a1, int axis_arg)
{
    double axis[3] = {0, 0, 1};
    ix_mv *out;

    if (axis_arg > 0)
        IX_TRY(ix__arg_vec3(c, axis_arg, axis));
    if (c->argv[0]->type == IX_OBJ_POLY)
        return revolve_poly(c, axis, a0, a1);
    IX_TRY(ix_srf_revolve_axis(c->ctx, ix__arg_mv(c, 0), a0, a1, axis, &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_SRF_OF_REV);
}

static ix_status surfrev2(ix_call *c)
{
    return revolve_axis(c, ix__arg_num(c, 1), ix__arg_num(c, 2), 0);
}

static ix_status surfrevaxs(ix_call *c)
{
    return revolve_axis(c, 0, 360, 1);
}

static ix_status surfrevax2(ix_call *c)
{
    return revolve_axis(c, ix__arg_num(c, 1), ix__arg_num(c, 2), 3);
}

/* --- patches, sums ----------------------------------------------------- */

static ix_status boolsum(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_srf_boolsum(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                          ix__arg_mv(c, 2), ix__arg_mv(c, 3), &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_BOOL_SUM);
}

static ix_status boolone(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_srf_boolone(c->ctx, ix__arg_mv(c, 0), &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_BOOL_SUM);
}

static ix_status algsum(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_srf_algsum(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status swungasum(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_srf_swung(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status hermite_points(ix_call *c)
{
    double p[4][3];
    ix_mv *out;

    for (int i = 0; i < 4; i++)
        IX_TRY(ix__arg_vec3(c, i, p[i]));
    IX_TRY(ix_hermite(c->ctx, p[0], p[1], p[2], p[3], &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status hermite(ix_call *c)
{
    ix_mv *out;

    if (c->argv[0]->type != IX_OBJ_CURVE)
        return hermite_points(c);
    for (int i = 1; i < 4; i++)
        if (c->argv[i]->type != IX_OBJ_CURVE)
            return IX_ARG_FAIL(c, i,
                               "four curves, or two points and two "
                               "vectors, are needed");
    IX_TRY(ix_srf_hermite(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                          ix__arg_mv(c, 2), ix__arg_mv(c, 3), &out));
    return ix__ret_mv(c, -1, out);
}

/* --- quadrics ----------------------------------------------------------- */

static ix_status quadric(ix_call *c)
{
    double *v;
    ix_mv *out;
    int n;

    IX_TRY(ix__arg_nums(c, 0, &n, &v));
    if (n == 7)
        IX_TRY(ix_srf_conic_cylinder(c->ctx, v, v[6], &out));
    else if (n == 10)
        IX_TRY(ix_srf_quadric(c->ctx, v, &out));
    else
        return IX_ARG_FAIL(c, 0,
                           "%d coefficients, 10 of a quadric or 6 of a "
                           "conic and a height are needed",
                           n);
    return ix__ret_mv(c, -1, out);
}

/* --- sweeps ------------------------------------------------------------ */

/* One curve, or the curves of a list, in scratch. */
static ix_status sections(ix_call *c, ix_sweep *s)
{
    const ix_mv **crvs;

    s->nsections = 1;
    if (c->argv[0]->type == IX_OBJ_LIST) {
        IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &s->nsections, &crvs));
    } else {
        IX_SCRATCH(c->ctx, crvs, 1);
        crvs[0] = ix__arg_mv(c, 0);
    }
    s->sections = crvs;
    return IX_OK;
}

/* OFF, a binormal, or a field of binormals. */
static ix_status frame(ix_call *c, int i, ix_sweep *s)
{
    switch (c->argv[i]->type) {
    case IX_OBJ_NUMBER:
        s->frame = IX_FRAME_MINIMAL;
        return IX_OK;
    case IX_OBJ_CURVE:
        s->frame = IX_FRAME_CURVE;
        s->field = ix__arg_mv(c, i);
        return IX_OK;
    default:
        s->frame = IX_FRAME_VECTOR;
        return ix__arg_vec3(c, i, s->vec);
    }
}

static ix_status sweep(ix_call *c, ix_sweep *s, int frame_arg)
{
    ix_mv *out;

    IX_TRY(sections(c, s));
    s->axis = ix__arg_mv(c, 1);
    IX_TRY(frame(c, frame_arg, s));
    IX_TRY(ix_srf_sweep(c->ctx, s, &out));
    return ix__ret_geom(c, -1, out, IX__GEOM_SWEEP);
}

static ix_status sweepsrf(ix_call *c)
{
    ix_sweep s = {.factor = 1};

    return sweep(c, &s, 2);
}

static ix_status swpsclsrf(ix_call *c)
{
    ix_sweep s = {.factor = 1};

    if (c->argv[2]->type == IX_OBJ_NUMBER)
        s.factor = ix__arg_num(c, 2);
    else
        s.scale = ix__arg_mv(c, 2);
    IX_TRY(ix__arg_int(c, 4, 0, 10000, &s.refine));
    return sweep(c, &s, 3);
}

/* --- curves ------------------------------------------------------------- */

static ix_status triangle_curve(ix_call *c)
{
    const ix_trisrf *t = c->argv[0]->u.tri.item[0];
    ix_dir dir = {.basis = IX_BEZIER, .order = t->order, .length = t->order};
    int naxes = t->ncoords + t->rational, d;
    double *pts;
    ix_mv *out;

    if (t->kind != IX_TRI_BEZIER)
        return IX_ARG_FAIL(c, 0,
                           "only triangular Bezier patches can be evaluated");
    IX_TRY(ix__arg_dir(c, 1, 3, &d));
    IX_SCRATCH(c->ctx, pts, naxes * t->order);
    c->bad_arg = 3;
    IX_TRY(
        ix_tri_iso(c->ctx, t->order, naxes, d, ix__arg_num(c, 2), t->pts, pts));
    c->bad_arg = 0;
    IX_TRY(ix_mv_new(c->ctx, 1, &dir, t->ncoords, t->rational, pts, &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status csurface(ix_call *c)
{
    return c->argv[0]->type == IX_OBJ_TRISRF ? triangle_curve(c)
                                             : ix__prim_fix(c);
}

/* --- table ------------------------------------------------------------- */

#define C \
    "c = cbezier(list(ctlpt(E3,1,0,0), ctlpt(E3,2,0,1), ctlpt(E3,1,0,2))); "
#define S                                                       \
    "s = sbezier(list(list(ctlpt(E3,0,0,0), ctlpt(E3,1,0,0)), " \
    "list(ctlpt(E3,0,1,0), ctlpt(E3,1,1,1)))); "
#define SIDES                                                       \
    "a = ctlpt(E3,0,0,0) + ctlpt(E3,1,0,0); b = ctlpt(E3,0,1,0) + " \
    "ctlpt(E3,1,1,1); d = ctlpt(E3,0,0,0) + ctlpt(E3,0,1,0); e = "  \
    "ctlpt(E3,1,0,0) + ctlpt(E3,1,1,1); "
#define TS S "ts = trimsrf(s, circle(vector(0.5,0.5,0), 0.3), false); "

const ix_builtin ix__builtins_surface[] = {
    {"RULEDSRF", "a:poly|curve b:poly|curve -> any",
     "Ruled surface: u along the curves, v from a to b. Two polylines with "
     "equally many vertices give polygons.",
     C "s = ruledsrf(c, c * trans(vector(0,1,0)));", ruledsrf, 0, 11},
    {"SFROMCRVS", "curves:list order:num kv:num -> surface",
     "Surface with the curves as control rows along v, KV_OPEN, KV_FLOAT or "
     "KV_PERIODIC.",
     C "s = sfromcrvs(list(c, c * trans(vector(0,1,0)), c * "
       "trans(vector(0,2,1))), 3, KV_OPEN);",
     ix__prim_layers, 0, 11},
    {"SURFREV", "c:poly|curve -> any",
     "Surface of revolution about Z: u the rotation over [0, 4], v the "
     "profile. Polygons are turned in RESOLUTION steps.",
     C "s = surfrev(c);", surfrev, 0, 11},
    {"SURFPREV", "c:curve -> surface",
     "The same with a polynomial approximation of the circle.",
     C "s = surfprev(c);", surfprev, 0, 11},
    {"SURFREV2", "c:poly|curve a0:num a1:num -> any",
     "The part of the surface of revolution between two angles in degrees.",
     C "s = surfrev2(c, 0, 90);", surfrev2, 0, 11},
    {"SURFREVAXS", "c:poly|curve axis:vector -> any",
     "Surface of revolution about an axis through the origin.",
     C "s = surfrevaxs(c, vector(1,0,1));", surfrevaxs, 0, 11},
    {"SURFREVAX2", "c:poly|curve a0:num a1:num axis:vector -> any",
     "The part of it between two angles in degrees.",
     C "s = surfrevax2(c, 0, 90, vector(1,0,1));", surfrevax2, 0, 11},
    {"SBEZIER", "mesh:list -> surface",
     "Bezier surface; the inner lists of control points run along u.", S,
     sbezier, 0, 11},
    {"SBSPLINE", "uOrder:num vOrder:num mesh:list kvs:list -> surface",
     "B-spline surface; each knot vector is list(KV_*) or its knots.",
     "s = sbspline(2, 2, list(list(ctlpt(E1,0), ctlpt(E1,1)), "
     "list(ctlpt(E1,1), ctlpt(E1,3))), list(list(KV_OPEN), list(KV_OPEN)));",
     sbspline, 0, 11},
    {"SPOWER", "mesh:list -> surface",
     "Surface in the monomial basis; inner lists hold the powers of u.",
     "s = spower(list(list(ctlpt(E1, 0), ctlpt(E1, 1)), list(ctlpt(E1, 1), "
     "ctlpt(E1, 0))));",
     spower, 0, 11},
    {"EXTRUDE", "x:list|poly|curve|surface dir:vector caps:num -> any",
     "A curve to a surface, a surface to a trivariate, polygons to a solid; "
     "caps 1 bottom, 2 top, 3 both close a closed curve.",
     C "s = extrude(c, vector(0, 1, 0), 0);", extrude, 0, 11},
    {"SWPSCLSRF",
     "cross:curve|list axis:curve scale:curve|num frame:curve|pv|num "
     "refine:num -> surface",
     "Sweep of scaled sections along an axis; frame OFF minimises rotation, "
     "a vector or a curve gives binormals; refine inserts knots in the axis.",
     "s = swpsclsrf(circle(vector(0,0,0), 1), cbezier(list(point(0,0,0), "
     "point(0,0,4))), 0.1, off, 1);",
     swpsclsrf, 0, 11},
    {"SWEEPSRF", "cross:curve|list axis:curve frame:curve|pv|num -> surface",
     "SWPSCLSRF with scale 1 and no refinement.",
     "s = sweepsrf(circle(vector(0,0,0), 0.1), cbezier(list(point(0,0,0), "
     "point(1,0,1), point(0,0,4))), off);",
     sweepsrf, 0, 11},
    {"HERMITE", "b1:curve|pv b2:curve|pv t1:curve|pv t2:curve|pv -> any",
     "Cubic between two points with two end derivatives; of four curves the "
     "surface with u across and v along them.",
     "c = hermite(point(0,0,0), point(1,1,0), vector(1,0,0), vector(0,1,0));",
     hermite, 0, 11},
    {"BOOLSUM", "c1:curve c2:curve c3:curve c4:curve -> surface",
     "Coons patch with S(.,0) = c1, S(.,1) = c2, S(0,.) = c3, S(1,.) = c4.",
     SIDES "s = boolsum(a, b, d, e);", boolsum, 0, 11},
    {"BOOLONE", "c:curve -> surface",
     "Coons patch of the four quarters of a closed curve.",
     "s = boolone(circle(vector(0,0,0), 1));", boolone, 0, 11},
    {"ALGSUM", "c1:curve c2:curve -> surface", "S(u, v) = c1(u) + c2(v).",
     C "s = algsum(c, circle(vector(0,0,0), 0.2));", algsum, 0, 11},
    {"SWUNGASUM", "c1:curve c2:curve -> surface",
     "S(u, v) = (x1 x2, x1 y2, y1): profile c1 = (radius, height)(u), "
     "trajectory c2 = (x2, y2)(v).",
     "s = swungasum(ctlpt(E2,1,0) + ctlpt(E2,2,1), circle(vector(0,0,0), 1));",
     swungasum, 0, 11},

    {"SINTPCRVS", "curves:list order:num kv:num param:num -> surface",
     "Surface through all curves, v spaced by PARAM_*.",
     C "s = sintpcrvs(list(c, c * trans(vector(0,1,0)), c * "
       "trans(vector(0,2,1))), 3, KV_OPEN, PARAM_UNIFORM);",
     ix__prim_skin, 0, 11},
    {"QUADRIC", "coefs:list -> surface",
     "Patch of the quadric A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + "
     "H y + I z + J = 0; of 7 numbers, the cylinder from 0 to z over the conic "
     "A x^2 + B xy + C y^2 + D x + E y + F = 0.",
     "s = quadric(list(1, 1, 4, 0, 0, 0, 0, 0, 0, -1));", quadric, 0, 11},

    {"SREGION", "s:trimsrf|surface dir:num t0:num t1:num -> any",
     "The part between two parameters; COL is u, ROW is v. A trimmed surface "
     "stays trimmed.",
     S "r = sregion(s, ROW, 0.2, 0.6);", ix__prim_region, 0, 12},
    {"SREPARAM", "s:trimsrf|surface dir:num t0:num t1:num -> any",
     "The same shape with the domain of one direction moved to [t0, t1].",
     S "r = sreparam(s, ROW, 0, 5);", ix__prim_sreparam, 0, 12},
    {"SEDITPT", "s:surface p:ctlpt i:num j:num -> surface",
     "A copy with control point (i, j), counted from 0, replaced.",
     S "r = seditpt(s, ctlpt(E3, 9, 9, 9), 1, 0);", ix__prim_edit, 0, 12},
    {"SREFINE", "s:surface dir:num replace:bool knots:list -> surface",
     "Knots inserted, or with replace the whole knot vector exchanged.",
     S "r = srefine(s, COL, false, list(0.5));", ix__prim_refine, 0, 12},
    {"SRAISE", "s:surface dir:num order:num -> surface",
     "The same shape with a higher order in one direction.",
     S "r = sraise(s, COL, 5);", ix__prim_raise, IX_B_SOFT, 12},
    {"SDIVIDE", "s:trimsrf|surface dir:num t:num -> list",
     "The two parts below and above a parameter; of a trimmed surface those "
     "of which something is left.",
     S "l = sdivide(s, COL, 0.5);", ix__prim_divide, 0, 12},
    {"SMORPH", "s1:surface s2:surface blend:num -> surface",
     "(1 - blend) s1 + blend s2, which must be compatible (FFCOMPAT).",
     S "r = smorph(s, s * scale(vector(1,1,2)), 0.5);", ix__prim_morph, 0, 12},
    {"SMERGE", "s1:surface s2:surface dir:num same:bool -> surface",
     "s2 after s1 in one direction; without same a ruled bridge joins them.",
     S "r = smerge(s, s * trans(vector(0,2,0)), ROW, false);", ix__prim_smerge,
     0, 12},
    {"SREVERSE", "s:trimsrf|surface -> any", "u and v exchanged.",
     S "r = sreverse(s);", ix__prim_sreverse, 0, 12},
    {"SMOEBIUS", "s:surface ratio:num dir:num -> surface",
     "Moebius reparametrisation that makes the last weight ratio times the "
     "first one; 0: equal.",
     "r = smoebius(surfrev(ctlpt(E3,1,0,0) + ctlpt(E3,1,0,1)), 2, ROW);",
     ix__prim_moebius, 0, 12},

    {"SEVAL", "s:trimsrf|surface u:num v:num -> ctlpt",
     "The point at (u, v), not projected.", S "q = seval(s, 0.5, 0.5);",
     ix__prim_eval, 0, 13},
    {"CSURFACE", "s:surface|trisrf dir:num t:num -> curve",
     "Curve of constant u (COL) or constant v (ROW), of a triangular Bezier "
     "patch also w (DEPTH): there the first of the two other parameters falls "
     "while the second grows.",
     S "c = csurface(s, COL, 0.25);", csurface, 0, 13},
    {"CMESH", "s:surface dir:num i:num -> curve",
     "Curve of the control points with constant first (COL) or second (ROW) "
     "index, counted from 0.",
     S "c = cmesh(s, ROW, 0);", ix__prim_layer, 0, 13},
    {"SDERIVE", "s:surface dir:num -> surface",
     "Partial derivative with respect to u (COL) or v (ROW).",
     S "d = sderive(s, COL);", ix__prim_derive, 0, 13},
    {"SINTEG", "s:surface dir:num -> surface",
     "Indefinite integral in one direction, 0 at its lower end.",
     S "d = sinteg(s, COL);", ix__prim_integrate, 0, 13},
    {"SNORMAL", "s:trimsrf|surface u:num v:num -> vector",
     "Unit normal, dS/dv x dS/du.", S "n = snormal(s, 0.5, 0.5);",
     ix__prim_snormal, 0, 13},
    {"SNRMLSRF", "s:surface -> surface",
     "Normal field dS/dv x dS/du, not normalised.", S "n = snrmlsrf(s);",
     ix__prim_snrmlsrf, 0, 13},
    {"STANGENT",
     "s:trimsrf|surface dir:num u:num v:num normalize:bool -> vector",
     "Tangent of the curve of constant u (COL, dS/dv) or v (ROW, dS/du).",
     S "t = stangent(s, COL, 0.5, 0.5, true);", ix__prim_stangent, 0, 13},
    {"NRMLCONE", "s:surface -> list",
     "Axis and half angle (radians) of a cone that holds all normals.",
     S "l = nrmlcone(s);", ix__prim_nrmlcone, 0, 13},
    {"SVOLUME", "s:surface method:num eval:bool -> num|surface",
     "Volume between the surface and the XY plane (1) or the origin (2), "
     "signed "
     "by its orientation; without eval the integral as a surface.",
     S "d = svolume(s, 1, true);", ix__prim_svolume, 0, 13},
    {"SMOMENTS",
     "s:surface order:num axis1:num axis2:num eval:bool -> num|surface",
     "First moment (order 1, axis1) or second moment (order 2, axis1 and "
     "axis2) of the space between the surface and the XY plane; axes 1, 2, 3.",
     S "d = smoments(s, 1, 1, 1, true);", ix__prim_smoments, 0, 13},

    {"TRIMSRF", "s:surface curves:curve|list hasUpper:bool -> trimsrf",
     "Surface trimmed by closed curves in its (u, v) plane; without hasUpper "
     "the domain's boundary is added and the curves are holes.",
     TS, ix__prim_trimsrf, 0, 14},
    {"STRIMSRF", "ts:trimsrf -> surface", "The surface without its trimming.",
     TS "s = strimsrf(ts);", ix__prim_strimsrf, 0, 14},
    {"CTRIMSRF", "ts:trimsrf param:bool -> list",
     "The trimming curves in the (u, v) plane (param) or on the surface.",
     TS "l = ctrimsrf(ts, true);", ix__prim_ctrimsrf, 0, 14},
    {"TRMSRFS", "s:surface contours:curve|poly|list -> list",
     "The trimmed surfaces into which contours in the (u, v) plane divide s: "
     "curves and polylines, also in lists, that close or go from border to "
     "border or from one to another. They may cross each other and themselves, "
     "and leave the domain; what divides nothing is ignored, with a remark.",
     S "l = trmsrfs(s, list(poly(list(point(0,0.2,0), point(1,0.5,0)), true), "
       "circle(vector(0.5,0.7,0), 0.2)));",
     ix__prim_trmsrfs, 0, 14},
    {0}};
