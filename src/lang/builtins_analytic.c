/* builtins_analytic.c - points, vectors, planes, matrices, analytic geometry
 * (chapter 6). The mathematics is in geom/; here arguments are fetched. */
#include <string.h>

#include "geom/analytic.h"
#include "geom/matrix.h"
#include "geom/sphere_points.h"
#include "lang/animate.h"
#include "lang/coerce.h"
#include "lang/interp.h"
#include "lang/recognize_obj.h"

/* x, y, z of an argument that the signature makes a point or vector. */
static const double *xyz(const ix_call *c, int i)
{
    return c->argv[i]->u.pt;
}

static ix_status ret_point(ix_call *c, const double p[3])
{
    return ix__ret(c, ix__obj_point(c->ctx, p));
}

static ix_status ret_matrix(ix_call *c, const double m[16])
{
    return ix__ret(c, ix__obj_matrix(c->ctx, m));
}

/* A function of geom/ that makes matrix m, then the result. */
#define RET_MATRIX(c, expr)          \
    do {                             \
        IX_TRY(expr);                \
        return ret_matrix((c), (m)); \
    } while (0)

/* --- simple values -----------------------------------------------------------
 */

static ix_status b_point(ix_call *c)
{
    const double p[3] = {ix__arg_num(c, 0), ix__arg_num(c, 1),
                         ix__arg_num(c, 2)};

    return ret_point(c, p);
}

static ix_status b_vector(ix_call *c)
{
    const double p[3] = {ix__arg_num(c, 0), ix__arg_num(c, 1),
                         ix__arg_num(c, 2)};

    return ix__ret(c, ix__obj_vector(c->ctx, p));
}

static ix_status b_plane(ix_call *c)
{
    const double p[4] = {ix__arg_num(c, 0), ix__arg_num(c, 1),
                         ix__arg_num(c, 2), ix__arg_num(c, 3)};

    return ix__ret(c, ix__obj_plane(c->ctx, p));
}

static ix_status b_ctlpt(ix_call *c)
{
    ix__code code = ix__code_of(ix__arg_num(c, 0));
    ix_ctlpt p = {.ncoords = code.ncoords, .rational = code.rational};
    int want = code.ncoords + code.rational;

    if (code.kind != IX_CODE_POINT)
        return IX_ARG_FAIL(c, 0, "%g is no point type", ix__arg_num(c, 0));
    if (c->argc - 1 != want) {
        char name[8];

        ix__code_point_name(code.ncoords, code.rational, name);
        return IX_ARG_FAIL(c, 0, "%s takes %d numbers, not %d", name, want,
                           c->argc - 1);
    }
    for (int i = 0; i < want; i++)
        p.v[i] = ix__arg_num(c, i + 1);
    return ix__ret(c, ix__obj_ctlpt(c->ctx, &p));
}

static ix_status b_instance(ix_call *c)
{
    return ix__ret(
        c, ix__obj_instance(c->ctx, ix__arg_str(c, 0), c->argv[1]->u.mat));
}

static ix_status b_bbox(ix_call *c)
{
    double box[6];

    IX_TRY(ix__obj_bbox(c->ctx, c->argv[0], box));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < 6; i++)
        IX_TRY(ix__list_add_num(c->ctx, c->result, box[i]));
    return IX_OK;
}

/* --- matrices
 * ------------------------------------------------------------------ */

static ix_status b_trans(ix_call *c)
{
    double m[16];

    ix__mat_translate(xyz(c, 0), m);
    return ret_matrix(c, m);
}

static ix_status b_scale(ix_call *c)
{
    double m[16];

    ix__mat_scale(xyz(c, 0), m);
    return ret_matrix(c, m);
}

static ix_status rotation(ix_call *c, int axis)
{
    double m[16];

    ix__mat_rotate(axis, ix__arg_num(c, 0), m);
    return ret_matrix(c, m);
}

static ix_status b_rotx(ix_call *c)
{
    return rotation(c, 0);
}

static ix_status b_roty(ix_call *c)
{
    return rotation(c, 1);
}

static ix_status b_rotz(ix_call *c)
{
    return rotation(c, 2);
}

static ix_status b_rotvec(ix_call *c)
{
    double m[16];

    RET_MATRIX(c,
               ix__mat_rotate_about(c->ctx, xyz(c, 0), ix__arg_num(c, 1), m));
}

static ix_status b_rotv2v(ix_call *c)
{
    double m[16];

    RET_MATRIX(c, ix__mat_turn(c->ctx, xyz(c, 0), xyz(c, 1), m));
}

static ix_status b_rotz2v(ix_call *c)
{
    static const double z[3] = {0, 0, 1};
    double m[16];

    RET_MATRIX(c, ix__mat_turn(c->ctx, z, xyz(c, 0), m));
}

static ix_status b_rotz2v2(ix_call *c)
{
    double m[16];

    RET_MATRIX(c, ix__mat_frame(c->ctx, xyz(c, 0), xyz(c, 1), m));
}

static ix_status b_homomat(ix_call *c)
{
    const ix_list *rows = &c->argv[0]->u.list;
    double m[16];

    if (rows->n != 4)
        return IX_ARG_FAIL(c, 0, "4 rows are needed, not %d", rows->n);
    for (int i = 0; i < 4; i++) {
        const ix_obj *row = rows->item[i];

        if (row->type != IX_OBJ_LIST || row->u.list.n != 4)
            return IX_ARG_FAIL(c, 0, "row %d is no list of 4 numbers", i + 1);
        for (int j = 0; j < 4; j++) {
            if (row->u.list.item[j]->type != IX_OBJ_NUMBER)
                return IX_ARG_FAIL(c, 0, "element %d of row %d is no number",
                                   j + 1, i + 1);
            m[4 * i + j] = row->u.list.item[j]->u.num;
        }
    }
    return ret_matrix(c, m);
}

static ix_status b_projmat(ix_call *c)
{
    const double *e = xyz(c, 1), eye[4] = {e[0], e[1], e[2], ix__arg_num(c, 2)};
    double m[16];

    RET_MATRIX(c, ix__mat_project(c->ctx, c->argv[0]->u.plane, eye, m));
}

static ix_status b_rflctmat(ix_call *c)
{
    double m[16];

    RET_MATRIX(c, ix__mat_reflect(c->ctx, c->argv[0]->u.plane, m));
}

static ix_status b_matposdir(ix_call *c)
{
    double m[16];

    RET_MATRIX(c, ix__mat_view(c->ctx, xyz(c, 0), xyz(c, 1), xyz(c, 2), m));
}

static ix_status b_map3pt2eql(ix_call *c)
{
    double p[3][3], m[16];

    for (int i = 0; i < 3; i++)
        memcpy(p[i], xyz(c, i), sizeof p[i]);
    RET_MATRIX(c, ix__mat_equilateral(c->ctx, p, m));
}

static ix_status b_matdecomp(ix_call *c)
{
    ix__mat_parts p;

    IX_TRY(ix__mat_decompose(c->ctx, c->argv[0]->u.mat, &p));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(ix__list_add(c->ctx, c->result, ix__obj_vector(c->ctx, p.scale)));
    IX_TRY(ix__list_add(c->ctx, c->result, ix__obj_vector(c->ctx, p.trans)));
    return ix__list_add(c->ctx, c->result, ix__obj_matrix(c->ctx, p.rot));
}

static ix_status b_matdecomp2(ix_call *c)
{
    double v[7];

    IX_TRY(ix__mat_to_euler(c->ctx, c->argv[0]->u.mat, v));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < 7; i++)
        IX_TRY(ix__list_add_num(c->ctx, c->result, v[i]));
    return IX_OK;
}

static ix_status b_matrecomp(ix_call *c)
{
    double *v, m[16];
    int n;

    IX_TRY(ix__arg_nums(c, 0, &n, &v));
    if (n != 7)
        return IX_ARG_FAIL(c, 0, "7 numbers are needed, not %d", n);
    ix__mat_from_euler(v, m);
    return ret_matrix(c, m);
}

/* --- points, lines, planes
 * -------------------------------------------------------- */

static ix_status b_ptlnpln(ix_call *c)
{
    double p[3];

    IX_TRY(
        ix__line_plane(c->ctx, xyz(c, 0), xyz(c, 1), c->argv[2]->u.plane, p));
    return ret_point(c, p);
}

static ix_status b_ptptln(ix_call *c)
{
    double p[3];

    IX_TRY(ix__line_foot(c->ctx, xyz(c, 0), xyz(c, 1), xyz(c, 2), p));
    return ret_point(c, p);
}

static ix_status add_point(ix_call *c, const double p[3])
{
    return ix__list_add(c->ctx, c->result, ix__obj_point(c->ctx, p));
}

static ix_status b_ptslnln(ix_call *c)
{
    double p[3], q[3];

    IX_TRY(ix__lines_near(c->ctx, xyz(c, 0), xyz(c, 1), xyz(c, 2), xyz(c, 3), p,
                          q));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(add_point(c, p));
    return add_point(c, q);
}

static ix_status b_dstlnln(ix_call *c)
{
    double p[3], q[3], d;

    IX_TRY(ix__lines_near(c->ctx, xyz(c, 0), xyz(c, 1), xyz(c, 2), xyz(c, 3), p,
                          q));
    /* From q to the first line: exact also for nearly parallel lines. */
    IX_TRY(ix__line_dist(c->ctx, q, xyz(c, 0), xyz(c, 1), &d));
    return ix__ret_num(c, d);
}

static ix_status b_dstptln(ix_call *c)
{
    double d;

    IX_TRY(ix__line_dist(c->ctx, xyz(c, 0), xyz(c, 1), xyz(c, 2), &d));
    return ix__ret_num(c, d);
}

static ix_status b_dstptpln(ix_call *c)
{
    double d;

    IX_TRY(ix__plane_dist(c->ctx, xyz(c, 0), c->argv[1]->u.plane, &d));
    return ix__ret_num(c, d);
}

static void three_points(const ix_call *c, double p[3][3])
{
    for (int i = 0; i < 3; i++)
        memcpy(p[i], xyz(c, i), sizeof p[i]);
}

static ix_status b_pln3pts(ix_call *c)
{
    double p[3][3], plane[4];

    three_points(c, p);
    IX_TRY(ix__plane_through(c->ctx, (const double(*)[3])p, plane));
    return ix__ret(c, ix__obj_plane(c->ctx, plane));
}

static ix_status b_pt3bary(ix_call *c)
{
    double p[3][3], w[3];

    three_points(c, p);
    IX_TRY(ix__barycentric(c->ctx, (const double(*)[3])p, xyz(c, 3), w));
    return ret_point(c, w);
}

/* --- circles
 * ------------------------------------------------------------------------ */

static ix__circle3 circle_arg(const ix_call *c, int i)
{
    ix__circle3 r = {.radius = ix__arg_num(c, i + 2)};

    memcpy(r.centre, xyz(c, i), sizeof r.centre);
    memcpy(r.normal, xyz(c, i + 1), sizeof r.normal);
    return r;
}

static ix_status b_ptscrcr(ix_call *c)
{
    ix__circle3 a = circle_arg(c, 0), b = circle_arg(c, 3);
    double p[2][3];
    int n;

    /* spec/model 2: points within 1e-5 are approximately equal. */
    IX_TRY(ix__circles_meet(c->ctx, &a, &b, 1e-5, &n, p));
    if (n == 0)
        return IX_FAIL(c->ctx, IX_EDOMAIN, "the circles do not meet");
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < n; i++)
        IX_TRY(add_point(c, p[i]));
    return IX_OK;
}

static ix_obj *segment(ix_ctx *ctx, double p[2][3])
{
    ix_poly *poly = ix__poly_new(ctx, 1);

    if (!poly)
        return NULL;
    poly->poly[0].kind = IX_POLYLINE;
    if (ix__poly_vertices(ctx, &poly->poly[0], 2) != IX_OK) {
        ix__poly_unref(ctx, poly);
        return NULL;
    }
    for (int i = 0; i < 2; i++)
        memcpy(poly->poly[0].v[i].p, p[i], sizeof p[i]);
    return ix__obj_poly(ctx, poly);
}

static ix_status b_tnscrcr(ix_call *c)
{
    double t[2][2][3];

    IX_TRY(ix__circles_tangents(c->ctx, xyz(c, 0), ix__arg_num(c, 1), xyz(c, 2),
                                ix__arg_num(c, 3), ix__arg_bool(c, 4), t));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(ix__list_add(c->ctx, c->result, segment(c->ctx, t[0])));
    return ix__list_add(c->ctx, c->result, segment(c->ctx, t[1]));
}

/* --- spheres of points
 * ------------------------------------------------------------------ */

static ix_status b_pthmspr(ix_call *c)
{
    double(*p)[3];
    int n;

    IX_TRY(ix__hemisphere_points(c->ctx, ix__arg_num(c, 0), &n, &p));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < n; i++)
        IX_TRY(add_point(c, p[i]));
    return IX_OK;
}

static ix_status b_uvecsonspr(ix_call *c)
{
    double(*p)[3];
    int n;

    IX_TRY(ix__arg_int(c, 0, 1, 1000000, &n));
    IX_SCRATCH(c->ctx, p, n);
    ix__sphere_points(n, p);
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(ix__list_add_num(c->ctx, c->result, n));
    for (int i = 0; i < n; i++)
        IX_TRY(ix__list_add(c->ctx, c->result, ix__obj_vector(c->ctx, p[i])));
    return IX_OK;
}

/* --- objects
 * ------------------------------------------------------------------------------
 */

static ix_status b_animeval(ix_call *c)
{
    ix_obj *o;

    IX_TRY(ix__animate(c->ctx, c->argv[1], ix__arg_num(c, 0),
                       ix__arg_bool(c, 2), &o));
    return ix__ret(c, o);
}

static ix_status b_isgeom(ix_call *c)
{
    ix_obj *o;
    int kind;

    IX_TRY(ix__arg_int(c, 1, 0, 15, &kind));
    IX_TRY(ix__recognize_obj(c->ctx, c->argv[0], kind, ix__arg_num(c, 2), &o));
    return ix__ret(c, o);
}

const ix_builtin ix__builtins_analytic[] = {
    {"ANIMEVAL", "t:num x:any matrices:num -> any",
     "The object x at time t of its \"animation\" attributes (curves MOV_X, "
     "MOV_Y, MOV_Z, MOV_XYZ, ROT_X, ROT_Y, ROT_Z, SCL, SCL_X, SCL_Y, SCL_Z, "
     "VISIBLE, and matrices), or with matrices not 0 the matrices themselves.",
     "mov_x = cbezier(list(ctlpt(E1, 0), ctlpt(E1, 1))): "
     "attrib(axes, \"animation\", list(mov_x)): "
     "m = animeval(0.5, axes, true);",
     b_animeval, 0, 6},
    {"BBOX", "x:geom -> list",
     "xmin, xmax, ymin, ymax, zmin, zmax of points, polygons and control "
     "points.",
     "bbox(list(point(0, 0, 0), point(1, 2, 3)));", b_bbox, 0, 6},
    {"CTLPT", "type:num coordinates:num... -> ctlpt",
     "A control point: ctlpt(E2, x, y), ctlpt(P2, w, w x, w y).",
     "ctlpt(P3, 1, 0, 0, 1);", b_ctlpt, 0, 6},
    {"DSTLNLN", "p1:point d1:vector p2:point d2:vector -> num",
     "The distance of two lines, each a point and a direction.",
     "dstlnln(point(0, 0, 0), vector(1, 0, 0), point(0, 0, 2), "
     "vector(0, 1, 0));",
     b_dstlnln, 0, 6},
    {"DSTPTLN", "p:point lp:point ld:vector -> num",
     "The distance of a point from a line.",
     "dstptln(point(0, 3, 0), point(0, 0, 0), vector(1, 0, 0));", b_dstptln, 0,
     6},
    {"DSTPTPLN", "p:point plane:plane -> num",
     "The distance of a point from a plane.",
     "dstptpln(point(0, 0, 5), plane(0, 0, 1, 0));", b_dstptpln, 0, 6},
    {"HOMOMAT", "rows:list -> matrix",
     "The matrix of four lists of four numbers; points are row vectors, so "
     "the translation is the fourth row.",
     "homomat(list(list(2, 0, 0, 0), list(0, 1, 0, 0), list(0, 0, 1, 0), "
     "list(5, 0, 0, 1)));",
     b_homomat, 0, 6},
    {"INSTANCE", "name:str m:matrix -> instance",
     "The object of that name, moved by a matrix.",
     "instance(\"AXES\", trans(vector(1, 0, 0)));", b_instance, 0, 6},
    {"ISGEOM", "x:any kind:num eps:num -> list",
     "Whether x is within eps of a kind of geometry GEOM_...: list(0), or "
     "list(1, parameters...), the first number being 1 or 2 for the straight "
     "or circular direction U or V of a surface.",
     "isgeom(circle(vector(1, 2, 3), 2), GEOM_CIRCULAR, 1e-5);", b_isgeom, 0,
     6},
    {"MAP3PT2EQL", "p1:point p2:point p3:point -> matrix",
     "The affine map that takes three points to an equilateral triangle "
     "around the origin.",
     "map3pt2eql(point(0, 0, 0), point(2, 0, 0), point(0, 1, 0));",
     b_map3pt2eql, IX_B_SOFT, 6},
    {"MATDECOMP", "m:matrix -> list",
     "Scale vector s, translation vector t, rotation r with "
     "m = r * scale(s) * trans(t) (scale(s) * r when only that is possible).",
     "matdecomp(rotx(45) * scale(vector(1, 3, 1)));", b_matdecomp, IX_B_SOFT,
     6},
    {"MATDECOMP2", "m:matrix -> list",
     "Angles a, b, c in radians, scale s and x, y, z of m = rotx(a) roty(b) "
     "rotz(c) sc(s) trans(vector(x, y, z)).",
     "matdecomp2(rotx(90) * trans(vector(5, 0, 0)));", b_matdecomp2, IX_B_SOFT,
     6},
    {"MATPOSDIR", "pos:point dir:vector up:vector -> matrix",
     "The rigid map of an eye at pos that looks along dir: pos goes to the "
     "origin, dir to -z, up to +y.",
     "matposdir(point(0, 0, 5), vector(0, 0, -1), vector(0, 1, 0));",
     b_matposdir, 0, 6},
    {"MATRECOMP", "l:list -> matrix",
     "The matrix of the seven numbers of MATDECOMP2.",
     "matrecomp(list(0, 0, 0, 2, 1, 1, 1));", b_matrecomp, 0, 6},
    {"PLANE", "a:num b:num c:num d:num -> plane",
     "The plane a x + b y + c z + d = 0.", "plane(0, 0, 1, -2);", b_plane, 0,
     6},
    {"PLN3PTS", "p1:point p2:point p3:point -> plane",
     "The plane through three points.",
     "pln3pts(point(0, 0, 0), point(1, 0, 0), point(0, 1, 0));", b_pln3pts,
     IX_B_SOFT, 6},
    {"POINT", "x:num y:num z:num -> point", "A point.", "point(1, 2, 3);",
     b_point, 0, 6},
    {"PROJMAT", "plane:plane eye:vector weight:num -> matrix",
     "The projection onto a plane from the point eye / weight; weight 0 is "
     "parallel along eye.",
     "projmat(plane(0, 0, 1, 0), vector(0, 0, 1), 0);", b_projmat, 0, 6},
    {"PT3BARY", "p1:point p2:point p3:point p:point -> point",
     "The barycentric coordinates of p in the triangle p1, p2, p3.",
     "pt3bary(point(0, 0, 0), point(2, 0, 0), point(0, 3, 0), "
     "point(0.5, 0.6, 0));",
     b_pt3bary, IX_B_SOFT, 6},
    {"PTHMSPR", "spacing:num -> list",
     "Points on the unit hemisphere z >= 0, at most spacing radians apart.",
     "pthmspr(0.8);", b_pthmspr, 0, 6},
    {"PTLNPLN", "lp:point ld:vector plane:plane -> point",
     "The intersection of a line and a plane.",
     "ptlnpln(point(0, 0, 5), vector(0, 0, 1), plane(0, 0, 1, -1));", b_ptlnpln,
     IX_B_SOFT, 6},
    {"PTPTLN", "p:point lp:point ld:vector -> point",
     "The point of a line nearest to p.",
     "ptptln(point(0, 3, 0), point(0, 0, 0), vector(1, 0, 0));", b_ptptln, 0,
     6},
    {"PTSCRCR", "c1:point n1:vector r1:num c2:point n2:vector r2:num -> list",
     "The common points of two circles in space, each a centre, a normal and "
     "a radius; none is a soft error.",
     "ptscrcr(point(0, 0, 0), vector(0, 0, 1), 1, point(1, 0, 0), "
     "vector(0, 0, 1), 1);",
     b_ptscrcr, IX_B_SOFT, 6},
    {"PTSLNLN", "p1:point d1:vector p2:point d2:vector -> list",
     "The points of two lines nearest to each other.",
     "ptslnln(point(0, 0, 0), vector(1, 0, 0), point(0, 0, 2), "
     "vector(0, 1, 0));",
     b_ptslnln, 0, 6},
    {"RFLCTMAT", "plane:plane -> matrix", "The mirror image at a plane.",
     "rflctmat(plane(1, 0, 0, -2));", b_rflctmat, 0, 6},
    {"ROTVEC", "axis:vector deg:num -> matrix",
     "The right-handed rotation about an axis through the origin, in degrees.",
     "rotvec(vector(1, 1, 1), 120);", b_rotvec, 0, 6},
    {"ROTV2V", "v1:vector v2:vector -> matrix",
     "The least rotation that takes the direction v1 to v2.",
     "rotv2v(vector(1, 0, 0), vector(0, 1, 0));", b_rotv2v, 0, 6},
    {"ROTX", "deg:num -> matrix", "The rotation about x, in degrees.",
     "rotx(90);", b_rotx, 0, 6},
    {"ROTY", "deg:num -> matrix", "The rotation about y, in degrees.",
     "roty(45);", b_roty, 0, 6},
    {"ROTZ", "deg:num -> matrix", "The rotation about z, in degrees.",
     "rotz(30);", b_rotz, 0, 6},
    {"ROTZ2V", "dir:vector -> matrix",
     "The least rotation that takes +z to dir.", "rotz2v(vector(1, 1, 1));",
     b_rotz2v, 0, 6},
    {"ROTZ2V2", "dir:vector dir2:vector -> matrix",
     "The rotation that takes +z to dir and +x towards dir2.",
     "rotz2v2(vector(1, 0, 0), vector(0, 1, 0));", b_rotz2v2, 0, 6},
    {"SCALE", "v:vector -> matrix", "The scaling by x, y, z of a vector.",
     "scale(vector(1, 1, 2));", b_scale, 0, 6},
    {"TNSCRCR", "c1:point r1:num c2:point r2:num outer:num -> list",
     "The two outer (or inner) common tangents of two circles in the plane, "
     "as polylines from one to the other; none is a soft error.",
     "tnscrcr(point(-2, 0, 0), 0.5, point(1, 0, 0), 0.7, true);", b_tnscrcr,
     IX_B_SOFT, 6},
    {"TRANS", "v:vector -> matrix", "The translation by a vector.",
     "trans(vector(1, 2, 3));", b_trans, 0, 6},
    {"UVECSONSPR", "n:num -> list",
     "n, then n unit vectors spread evenly over the sphere.", "uvecsonspr(5);",
     b_uvecsonspr, 0, 6},
    {"VECTOR", "x:num y:num z:num -> vector", "A vector.", "vector(1, 0, 0);",
     b_vector, 0, 6},
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};
