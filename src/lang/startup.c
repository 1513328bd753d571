/* startup.c - the start-up library: what is native, and the text of the rest.
 *
 * Native are numbers, points, matrices and polygons; surfaces are written in
 * the language itself, which states their geometry best. The texts call only
 * built-ins and each other; they read no global variable. */
#include "lang/startup.h"

#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"
#include "lang/clients.h"
#include "lang/deep_copy.h"
#include "lang/interp.h"

/* --- numbers
 * ------------------------------------------------------------------- */

static ix_status b_min(ix_call *c)
{
    double a = ix__arg_num(c, 0), b = ix__arg_num(c, 1);

    return ix__ret_num(c, a > b ? b : a);
}

static ix_status b_max(ix_call *c)
{
    double a = ix__arg_num(c, 0), b = ix__arg_num(c, 1);

    return ix__ret_num(c, a > b ? a : b);
}

static ix_status b_mod(ix_call *c)
{
    double x = ix__arg_num(c, 0), n = ix__arg_num(c, 1);

    if (n == 0)
        return IX_ARG_FAIL(c, 1, "Division by zero");
    return ix__ret_num(c, x - floor(x / n) * n);
}

static ix_status b_iseven(ix_call *c)
{
    double x = ix__arg_num(c, 0);

    return ix__ret_num(c, floor(x / 2) * 2 == x);
}

static ix_status b_sqr(ix_call *c)
{
    const ix_obj *o = c->argv[0];

    if (o->type == IX_OBJ_NUMBER)
        return ix__ret_num(c, o->u.num * o->u.num);
    return ix__ret_num(c, ix__dot3(o->u.pt, o->u.pt));
}

/* --- points
 * ---------------------------------------------------------------------- */

static ix_status b_dstptpt(ix_call *c)
{
    return ix__ret_num(c, ix__dist3(c->argv[0]->u.pt, c->argv[1]->u.pt));
}

/* (1 - t) p + t q */
static ix_status ret_between(ix_call *c, double t)
{
    const double *p = c->argv[0]->u.pt, *q = c->argv[1]->u.pt;
    double v[3];

    for (int i = 0; i < 3; i++)
        v[i] = (1 - t) * p[i] + t * q[i];
    return ix__ret(c, ix__obj_vector(c->ctx, v));
}

static ix_status b_interppoint(ix_call *c)
{
    return ret_between(c, ix__arg_num(c, 2));
}

static ix_status b_midpoint(ix_call *c)
{
    return ret_between(c, 0.5);
}

static ix_status b_normalize(ix_call *c)
{
    const ix_obj *o = c->argv[0];
    double u[3], len;

    if (o->type != IX_OBJ_POINT && o->type != IX_OBJ_VECTOR) {
        ix__remark(c->in, "NORMALIZE needs a point or a vector, not %s",
                   ix__obj_type_name(o->type));
        return ix__ret_num(c, 1);
    }
    len = ix__unit3(o->u.pt, u);
    if (!(len > 0) || !isfinite(len))
        return IX_ARG_FAIL(c, 0, "(%g, %g, %g) has no direction", o->u.pt[0],
                           o->u.pt[1], o->u.pt[2]);
    return ix__ret(c, o->type == IX_OBJ_POINT ? ix__obj_point(c->ctx, u)
                                              : ix__obj_vector(c->ctx, u));
}

/* --- matrices
 * ---------------------------------------------------------------------- */

static ix_status ret_matrix(ix_call *c, const double m[16])
{
    return ix__ret(c, ix__obj_matrix(c->ctx, m));
}

static ix_status translation(ix_call *c, int axis)
{
    double v[3] = {0, 0, 0}, m[16];

    v[axis] = ix__arg_num(c, 0);
    ix__mat_translate(v, m);
    return ret_matrix(c, m);
}

static ix_status scaling(ix_call *c, int axis)
{
    double v[3] = {1, 1, 1}, m[16];

    v[axis] = ix__arg_num(c, 0);
    ix__mat_scale(v, m);
    return ret_matrix(c, m);
}

static ix_status rotation(ix_call *c, int axis)
{
    double m[16];

    ix__mat_rotate(axis, ix__arg_num(c, 0), m);
    return ret_matrix(c, m);
}

#define AXIS_FN(name, make, axis)         \
    static ix_status b_##name(ix_call *c) \
    {                                     \
        return make(c, axis);             \
    }
AXIS_FN(tx, translation, 0)
AXIS_FN(ty, translation, 1)
AXIS_FN(tz, translation, 2)
AXIS_FN(sx, scaling, 0)
AXIS_FN(sy, scaling, 1)
AXIS_FN(sz, scaling, 2)
AXIS_FN(rx, rotation, 0)
AXIS_FN(ry, rotation, 1)
AXIS_FN(rz, rotation, 2)

static ix_status b_sc(ix_call *c)
{
    double s = ix__arg_num(c, 0), m[16];

    ix__mat_scale((double[3]){s, s, s}, m);
    return ret_matrix(c, m);
}

static const double z_axis[3] = {0, 0, 1};

static ix_status b_rotvec2z(ix_call *c)
{
    double m[16];

    IX_TRY(ix__mat_turn(c->ctx, c->argv[0]->u.pt, z_axis, m));
    return ret_matrix(c, m);
}

static ix_status b_rotz2vec(ix_call *c)
{
    double m[16];

    IX_TRY(ix__mat_turn(c->ctx, z_axis, c->argv[0]->u.pt, m));
    return ret_matrix(c, m);
}

static ix_status b_rotline(ix_call *c)
{
    const double *p = c->argv[0]->u.pt, back[3] = {-p[0], -p[1], -p[2]};
    double to[16], r[16], m[16];

    IX_TRY(
        ix__mat_rotate_about(c->ctx, c->argv[1]->u.pt, ix__arg_num(c, 2), r));
    ix__mat_translate(back, to);
    ix__mat_mul(to, r, m);
    ix__mat_translate(p, to);
    ix__mat_mul(m, to, m);
    return ret_matrix(c, m);
}

/* --- polygons
 * ------------------------------------------------------------------------ */

/* Replaces the polygons of a box that belongs to this call alone. */
static ix_status set_normals(ix_ctx *ctx, ix_obj *o, const double n[3])
{
    ix_poly *p = ix__poly_dup(ctx, o->u.poly);

    if (!p)
        return IX_ENOMEM;
    for (int k = 0; k < p->n; k++)
        for (int i = 0; i < p->poly[k].n; i++) {
            memcpy(p->poly[k].v[i].normal, n, 3 * sizeof *n);
            p->poly[k].v[i].has_normal = true;
        }
    ix__poly_unref(ctx, o->u.poly);
    o->u.poly = p;
    return IX_OK;
}

static ix_status b_setnormals(ix_call *c)
{
    ix_obj *copy, **leaf;
    ix_status st = IX_OK;
    int n;

    IX_TRY(ix__deep_copy(c->ctx, c->argv[0], &copy));
    IX_TRY(ix__ret(c, copy));
    IX_TRY(ix__leaves(c->ctx, copy, &n, &leaf));
    for (int i = 0; i < n && st == IX_OK; i++)
        if (leaf[i]->type == IX_OBJ_POLY)
            st = set_normals(c->ctx, leaf[i], c->argv[1]->u.pt);
    return st;
}

/* Copies vertices; first once more at the end if closed. */
static ix_status copy_vertices(ix_ctx *ctx, const ix_polygon *from,
                               ix_poly_kind kind, ix_polygon *to)
{
    bool again = kind == IX_POLYLINE && from->n > 0;
    int n = from->n;

    /* A polygon does not repeat the first vertex of a closed polyline. */
    if (kind == IX_POLYGON && n > 1 &&
        ix__dist3(from->v[0].p, from->v[n - 1].p) <= 1e-5) /* spec/model 2 */
        n--;
    IX_TRY(ix__poly_vertices(ctx, to, n + again));
    to->kind = kind;
    for (int i = 0; i < n + again; i++) {
        const ix_vertex *v = &from->v[i % n];

        memcpy(to->v[i].p, v->p, sizeof v->p);
        memcpy(to->v[i].normal, v->normal, sizeof v->normal);
        to->v[i].has_normal = v->has_normal;
        IX_TRY(ix__attr_copy_all(ctx, v->attrs, &to->v[i].attrs));
    }
    if (kind == IX_POLYGON)
        to->has_plane = ix__polygon_plane(to, to->plane);
    return IX_OK;
}

/* All polygons of the argument, which may be a list, as one poly of a kind. */
static ix_status ret_polys(ix_call *c, ix_poly_kind kind)
{
    ix_obj **leaf;
    ix_poly *p;
    int n, total = 0, at = 0;
    ix_status st = IX_OK;

    IX_TRY(ix__leaves(c->ctx, c->argv[0], &n, &leaf));
    for (int i = 0; i < n; i++) {
        if (leaf[i]->type != IX_OBJ_POLY)
            return ix__wrong_element(c, 0, i, leaf[i], "a poly");
        total += leaf[i]->u.poly->n;
    }
    p = ix__poly_new(c->ctx, total);
    if (!p)
        return IX_ENOMEM;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < leaf[i]->u.poly->n && st == IX_OK; k++)
            st = copy_vertices(c->ctx, &leaf[i]->u.poly->poly[k], kind,
                               &p->poly[at++]);
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    ix__poly_unref(c->ctx, p);
    return st;
}

static ix_status b_genplgonstopllns(ix_call *c)
{
    return ret_polys(c, IX_POLYLINE);
}

static ix_status b_genpllnstoplgons(ix_call *c)
{
    return ret_polys(c, IX_POLYGON);
}

#define LIB(name, sig, summary, example, fn)              \
    {                                                     \
        name, sig, summary, example, fn, IX_B_LIBRARY, 25 \
    }
#define CLIENT(name)                                                           \
    {                                                                          \
        name, "arguments:any... -> any",                                       \
            "Talks to a display client, of which there is none.", name "(0);", \
            ix__no_client, IX_B_LIBRARY | IX_B_SOFT | IX_B_LOCAL, 25           \
    }

const ix_builtin ix__builtins_startup[] = {
    LIB("DSTPTPT", "p:pv q:pv -> num", "The distance of two points.",
        "dstptpt(point(1, 2, 2), point(3, 4, 3));", b_dstptpt),
    LIB("GENPLGONSTOPLLNS", "p:poly|list -> poly",
        "Polygons as closed polylines.",
        "genplgonstopllns(poly(list(point(0, 0, 0), "
        "point(1, 0, 0), point(0, 1, 0)), false));",
        b_genplgonstopllns),
    LIB("GENPLLNSTOPLGONS", "l:poly|list -> poly", "Polylines as polygons.",
        "genpllnstoplgons(poly(list(point(0, 0, 0), point(1, 0, 0), "
        "point(0, 1, 0)), true));",
        b_genpllnstoplgons),
    LIB("INTERPPOINT", "p:pv q:pv t:num -> vector", "(1 - t) p + t q.",
        "interppoint(point(0, 0, 0), point(4, 0, 0), 0.25);", b_interppoint),
    LIB("ISEVEN", "x:num -> num", "1 if x is an even integer, else 0.",
        "iseven(4);", b_iseven),
    LIB("MAX", "a:num b:num -> num", "The larger of two numbers.", "max(3, 2);",
        b_max),
    LIB("MIDPOINT", "p:pv q:pv -> vector", "(p + q) / 2.",
        "midpoint(point(0, 0, 0), point(4, 0, 0));", b_midpoint),
    LIB("MIN", "a:num b:num -> num", "The smaller of two numbers.",
        "min(3, 2);", b_min),
    LIB("MOD", "x:num n:num -> num", "x - floor(x / n) n.", "mod(-1, 3);",
        b_mod),
    LIB("NORMALIZE", "v:any -> any",
        "The point or vector of length 1 in the direction of v.",
        "normalize(vector(3, 4, 0));", b_normalize),
    LIB("ROTLINE", "pt:pv dir:pv deg:num -> matrix",
        "The rotation about the line through pt in direction dir.",
        "rotline(point(1, 0, 0), vector(0, 0, 1), 90);", b_rotline),
    LIB("ROTVEC2Z", "w:pv -> matrix", "The least rotation that takes w to +z.",
        "rotvec2z(vector(1, 1, 1));", b_rotvec2z),
    LIB("ROTZ2VEC", "w:pv -> matrix", "The least rotation that takes +z to w.",
        "rotz2vec(vector(1, 1, 1));", b_rotz2vec),
    LIB("RX", "deg:num -> matrix", "rotx(deg).", "rx(90);", b_rx),
    LIB("RY", "deg:num -> matrix", "roty(deg).", "ry(90);", b_ry),
    LIB("RZ", "deg:num -> matrix", "rotz(deg).", "rz(90);", b_rz),
    LIB("SC", "s:num -> matrix", "scale(vector(s, s, s)).", "sc(2);", b_sc),
    LIB("SETNORMALSINOBJLIST", "l:any n:pv -> any",
        "A copy with the normal n at all vertices of all polys in a list.",
        "setnormalsinobjlist(list(poly(list(point(0, 0, 0), point(1, 0, 0), "
        "point(0, 1, 0)), false)), vector(0, 0, 1));",
        b_setnormals),
    LIB("SETNORMALSINPOLY", "p:poly n:pv -> poly",
        "A copy with the normal n at all vertices.",
        "setnormalsinpoly(poly(list(point(0, 0, 0), point(1, 0, 0), "
        "point(0, 1, 0)), false), vector(0, 0, 1));",
        b_setnormals),
    LIB("SETNORMALSINPOLYOBJ", "p:poly n:pv -> poly",
        "A copy with the normal n at all vertices of all polygons.",
        "setnormalsinpolyobj(poly(list(point(0, 0, 0), point(1, 0, 0), "
        "point(0, 1, 0)), false), vector(0, 0, 1));",
        b_setnormals),
    LIB("SQR", "x:num|pv -> num",
        "x * x; the squared length of a point or vector.", "sqr(5);", b_sqr),
    LIB("SX", "s:num -> matrix", "scale(vector(s, 1, 1)).", "sx(2);", b_sx),
    LIB("SY", "s:num -> matrix", "scale(vector(1, s, 1)).", "sy(2);", b_sy),
    LIB("SZ", "s:num -> matrix", "scale(vector(1, 1, s)).", "sz(2);", b_sz),
    LIB("TX", "t:num -> matrix", "trans(vector(t, 0, 0)).", "tx(2);", b_tx),
    LIB("TY", "t:num -> matrix", "trans(vector(0, t, 0)).", "ty(2);", b_ty),
    LIB("TZ", "t:num -> matrix", "trans(vector(0, 0, t)).", "tz(2);", b_tz),
    CLIENT("CLNTANIM"),
    CLIENT("CLNTCLEAR"),
    CLIENT("CLNTCLONEOBJ"),
    CLIENT("CLNTDCLEAR"),
    CLIENT("CLNTDISC"),
    CLIENT("CLNTEDITCRV"),
    CLIENT("CLNTEDITOBJ"),
    CLIENT("CLNTEDITSRF"),
    CLIENT("CLNTEXIT"),
    CLIENT("CLNTGETOBJ"),
    CLIENT("CLNTHIGH1"),
    CLIENT("CLNTHIGH2"),
    CLIENT("CLNTIMGSAVE"),
    CLIENT("CLNTMSAVE"),
    CLIENT("CLNTPICKCRSR"),
    CLIENT("CLNTPICKDONE"),
    CLIENT("CLNTPICKNAME"),
    CLIENT("CLNTPICKOBJ"),
    CLIENT("CLNTREMOVE"),
    CLIENT("CLNTSTATE"),
    CLIENT("CLNTUNHIGH"),
    CLIENT("CLNTVIEW"),
    CLIENT("CNTRINTR"),
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};

/* --- the texts
 * -------------------------------------------------------------------------- */

/* A command of one word or of a word and an argument for display devices. */
#define COMMAND(name, word, summary, example)                         \
    {                                                                 \
        name,                                                         \
            name " = procedure():command_: command_ = \"" word "\": " \
                 "viewobj(command_);",                                \
            summary, example                                          \
    }
#define COMMAND_OF(name, word, summary, example)                            \
    {                                                                       \
        name,                                                               \
            name " = procedure(x):command_: command_ = \"" word " \" + x: " \
                 "viewobj(command_);",                                      \
            summary, example                                                \
    }

const ix__startup_fn ix__startup_text[] = {
    /* displays */
    COMMAND("BEEP", "BEEP", "Rings the bell of displays.", "beep();"),
    COMMAND("VIEWCLEAR", "CLEAR", "Clears displays.", "viewclear();"),
    COMMAND("VIEWDCLEAR", "DCLEAR",
            "Clears displays when something is shown next.", "viewdclear();"),
    COMMAND("VIEWDISC", "DISCONNECT", "Leaves displays to themselves.",
            "viewdisc();"),
    COMMAND("VIEWEXIT", "EXIT", "Ends displays.", "viewexit();"),
    COMMAND_OF("VIEWCLONEOBJ", "CLONEOBJ",
               "Displays copy the object of that name.",
               "viewcloneobj(\"AXES\");"),
    COMMAND_OF("VIEWEDITCRV", "EDITCRV",
               "Displays edit the curve of that name.", "vieweditcrv(\"C\");"),
    COMMAND_OF("VIEWEDITOBJ", "EDITOBJ",
               "Displays edit the object of that name.",
               "vieweditobj(\"AXES\");"),
    COMMAND_OF("VIEWEDITSRF", "EDITSRF",
               "Displays edit the surface of that name.",
               "vieweditsrf(\"S\");"),
    COMMAND_OF("VIEWIMGSAVE", "IMGSAVE", "Displays save their image.",
               "viewimgsave(\"image.ppm\");"),
    COMMAND_OF("VIEWMSAVE", "MSAVE", "Displays save their matrix.",
               "viewmsave(\"view.imd\");"),
    COMMAND_OF("VIEWREMOVE", "REMOVE",
               "Displays remove the object of that name.",
               "viewremove(\"AXES\");"),
    {"VIEWANIM",
     "viewanim = procedure(t0, t1, dt):command_: "
     "command_ = \"ANIMATE \" + t0 ^ \" \" ^ t1 ^ \" \" ^ dt: "
     "viewobj(command_);",
     "Displays run the animation from t0 to t1 in steps dt.",
     "viewanim(0, 1, 0.01);"},
    {"VIEWSTATE",
     "viewstate = procedure(name, value):command_: "
     "command_ = \"STATE \" + name + \" \" + value: "
     "viewobj(command_);",
     "Sets a state of displays.", "viewstate(\"DSrfMesh\", 1);"},
    {"VIEW",
     "view = procedure(obj, clear): "
     "if (clear != 0, viewdclear()): viewobj(obj);",
     "Shows an object, alone if clear is not 0.", "view(axes, on);"},
    {"PAUSE", "pause = procedure():t: t = 0;",
     "Waits for the user; scripts that run on their own do not wait.",
     "pause();"},
    {"MILISLEEP", "milisleep = procedure(ms): msleep(ms);",
     "Waits like MSLEEP.", "milisleep(10);"},
    {"INTERACT",
     "interact = procedure(obj): viewdclear(): viewobj(obj): "
     "pause();",
     "Shows an object alone, then PAUSE.", "interact(axes);"},
    {"DEMO", "demo = procedure(): include(\"demo.irt\");",
     "Runs the script demo.irt.", "demo();"},

    /* functions */
    {"FREEALLUSERDEFFUNCS", "freealluserdeffuncs = procedure(): fnfree(\"\");",
     "Removes all user functions.", "freealluserdeffuncs();"},
    {"FREEUSERDEFFUNCS",
     "freeuserdeffuncs = procedure(names):i: "
     "for (i = 1, 1, sizeof(names), fnfree(nth(names, i)));",
     "Removes the user functions of a list of names.",
     "f = function(x): return = x; freeuserdeffuncs(list(\"f\"));"},
    {"GENRANDOMCOLOR",
     "genrandomcolor = function(): return = floor(random(100, 256)) + \",\" + "
     "floor(random(100, 256)) + \",\" + floor(random(100, 256));",
     "A random light colour as \"r,g,b\", each from 100 to 255.",
     "genrandomcolor();"},

    /* edges and grids */
    {"EDGE2D",
     "edge2d = function(x1, y1, x2, y2): "
     "return = ctlpt(E2, x1, y1) + ctlpt(E2, x2, y2);",
     "The segment from (x1, y1) to (x2, y2).", "edge2d(0, 0, 1, 2);"},
    {"EDGE3D",
     "edge3d = function(x1, y1, z1, x2, y2, z2): "
     "return = ctlpt(E3, x1, y1, z1) + ctlpt(E3, x2, y2, z2);",
     "The segment from (x1, y1, z1) to (x2, y2, z2).",
     "edge3d(0, 0, 0, 1, 2, 3);"},
    {"GRIDXY",
     "gridxy = function(n):i:x: return = nil(): "
     "for (i = 0, 1, n, x = 2 * i / n - 1: "
     "snoc(ctlpt(E3, x, -1, 0) + ctlpt(E3, x, 1, 0), return): "
     "snoc(ctlpt(E3, -1, x, 0) + ctlpt(E3, 1, x, 0), return));",
     "n + 1 lines in each direction on the square [-1, 1] x [-1, 1].",
     "g = gridxy(4);"},
    {"GRIDXYZ",
     "gridxyz = function(n):i:x:g: return = nil(): g = gridxy(n): "
     "for (i = 0, 1, n, x = 2 * i / n - 1: "
     "snoc(g * tz(x), return): snoc(g * rx(90) * ty(x), return));",
     "GRIDXY at n + 1 heights and the lines between.", "g = gridxyz(2);"},
    {"MAKEPOLYNSIDES",
     "makepolynsides = function(n):i:pts: pts = nil(): "
     "for (i = 0, 1, n - 1, "
     "snoc(vector(cos(2 * pi * i / n), sin(2 * pi * i / n), 0), pts)): "
     "return = poly(pts, false);",
     "A regular polygon on the unit circle.", "p = makepolynsides(6);"},
    {"MAKEKVMARKERS",
     "makekvmarkers = function(kv, order, vspace):i:m:t:last: "
     "return = list(ctlpt(E2, nth(kv, 1), 0) + "
     "ctlpt(E2, nth(kv, sizeof(kv)), 0)): m = 0: last = nth(kv, 1): "
     "for (i = 1, 1, sizeof(kv), t = nth(kv, i): "
     "if (i > 1, if (abs(t - last) < 1e-14, m = m + 1, m = 0)): last = t: "
     "snoc(ctlpt(E2, t, -(m + 1) * vspace) + ctlpt(E2, t, -m * vspace), "
     "return));",
     "A diagram of a knot vector: an axis, and a tick for each knot, multiple "
     "ones below each other.",
     "l = makekvmarkers(list(0, 0, 0, 1, 1, 1), 3, 0.1);"},
    {"TRANSPGRIDAUX",
     "transpgridaux = function(n, m, scl, even):i:j: return = nil(): "
     "for (i = 0, 1, n - 1, for (j = 0, 1, m - 1, "
     "if (iseven(i + j) == even, snoc(poly(list("
     "point(i * scl, j * scl, 0), point((i + 1) * scl, j * scl, 0), "
     "point((i + 1) * scl, (j + 1) * scl, 0), "
     "point(i * scl, (j + 1) * scl, 0)), false), return))));",
     "The squares of one colour of a checkerboard.",
     "l = transpgridaux(2, 2, 1, 0);"},
    {"TRANSPGRIDTICKS",
     "transpgridticks = function(n, m, scl, dup):i: return = nil(): "
     "for (i = 0, 1, n * dup, snoc(poly(list(point(i * scl / dup, 0, 0), "
     "point(i * scl / dup, -scl / 4, 0)), true), return)): "
     "for (i = 0, 1, m * dup, snoc(poly(list(point(0, i * scl / dup, 0), "
     "point(-scl / 4, i * scl / dup, 0)), true), return)): "
     "return = mergepoly(return): attrib(return, \"rgb\", \"64,64,64\");",
     "Ticks beside a checkerboard, dup for each square.",
     "p = transpgridticks(2, 2, 1, 5);"},
    {"TRANSPGRID",
     "transpgrid = function(n, m, scale, ticks):a:b: "
     "a = mergepoly(transpgridaux(n, m, scale, 0)): "
     "b = mergepoly(transpgridaux(n, m, scale, 1)): "
     "attrib(a, \"rgb\", \"100,100,255\"): attrib(a, \"transp\", 0.75): "
     "attrib(b, \"rgb\", \"255,255,255\"): attrib(b, \"transp\", 0.75): "
     "return = list(a, b): "
     "if (ticks > 0, snoc(transpgridticks(n, m, scale, ticks), return));",
     "A transparent checkerboard of n x m squares with ticks.",
     "l = transpgrid(4, 4, 1, 0);"},

    /* control points and samples */
    {"GETCTLPOINTS",
     "getctlpoints = function(crv, asvec):i:p:type: type = point_type: "
     "if (asvec != 0, type = vector_type): return = nil(): "
     "for (i = 0, 1, sizeof(crv) - 1, p = coerce(coord(crv, i), type): "
     "snoc(p, return));",
     "The control points of a curve, as points or (asvec) vectors.",
     "l = getctlpoints(circle(vector(0, 0, 0), 1), false);"},
    {"GETCTLPOLYGON",
     "getctlpolygon = function(crv): "
     "return = poly(getctlpoints(crv, false), true);",
     "The control polygon of a curve as a polyline.",
     "p = getctlpolygon(circle(vector(0, 0, 0), 1));"},
    {"GETCTLMESHPTS",
     "getctlmeshpts = function(srf, asvec):i:p:type: type = point_type: "
     "if (asvec != 0, type = vector_type): return = nil(): "
     "for (i = 0, 1, meshsize(srf, col) * meshsize(srf, row) - 1, "
     "p = coerce(coord(srf, i), type): snoc(p, return));",
     "The control points of a surface, as points or (asvec) vectors.",
     "l = getctlmeshpts(planesrf(0, 0, 1, 1), false);"},
    {"GETCTLMESH",
     "getctlmesh = function(srf):i:j:n:m:l: n = meshsize(srf, col): "
     "m = meshsize(srf, row): return = nil(): "
     "for (j = 0, 1, m - 1, l = nil(): for (i = 0, 1, n - 1, "
     "snoc(coerce(coord(srf, j * n + i), point_type), l)): "
     "snoc(poly(l, true), return)): "
     "for (i = 0, 1, n - 1, l = nil(): for (j = 0, 1, m - 1, "
     "snoc(coerce(coord(srf, j * n + i), point_type), l)): "
     "snoc(poly(l, true), return));",
     "The rows and columns of the control mesh as polylines.",
     "l = getctlmesh(planesrf(0, 0, 1, 1));"},
    {"GETISOCURVES",
     "getisocurves = function(srf, nu, nv):i:d: d = pdomain(srf): "
     "return = nil(): "
     "for (i = 0, 1, nu, snoc(csurface(srf, col, "
     "nth(d, 1) + (nth(d, 2) - nth(d, 1)) * i / nu), return)): "
     "for (i = 0, 1, nv, snoc(csurface(srf, row, "
     "nth(d, 3) + (nth(d, 4) - nth(d, 3)) * i / nv), return));",
     "nu + 1 curves of constant u and nv + 1 of constant v.",
     "l = getisocurves(planesrf(0, 0, 1, 1), 2, 2);"},
    {"GETISOCURVETUBES",
     "getisocurvetubes = function(srf, nu, nv, rad):i:l: "
     "l = getisocurves(srf, nu, nv): return = nil(): "
     "for (i = 1, 1, sizeof(l), "
     "snoc(swpcircsrf(nth(l, i), rad, 0), return));",
     "The curves of GETISOCURVES as tubes of a radius.",
     "l = getisocurvetubes(planesrf(0, 0, 1, 1) * tz(0), 1, 1, 0.1);"},
    {"CNVRTCRVTOPOLYGON",
     "cnvrtcrvtopolygon = function(crv, n, ispolyline):i:a:b:m:t:pts: "
     "a = nth(pdomain(crv), 1): b = nth(pdomain(crv), 2): m = n - 1: "
     "if (ispolyline == 0, if (dstptpt(coerce(ceval(crv, a), point_type), "
     "coerce(ceval(crv, b), point_type)) < 1e-5, m = n)): pts = nil(): "
     "for (i = 0, 1, n - 1, t = a + (b - a) * i / m: "
     "snoc(ceval(crv, t), pts)): return = poly(pts, ispolyline);",
     "n points of a curve as a polyline, or a polygon if isPolyline is 0.",
     "p = cnvrtcrvtopolygon(circle(vector(0, 0, 0), 1), 10, false);"},
    {"CNVRTPOLYTOPTLIST",
     "cnvrtpolytoptlist = function(poly):i: return = nil(): "
     "for (i = 0, 1, sizeof(poly) - 1, snoc(coord(poly, i), return));",
     "The vertices of a single polygon or polyline.",
     "l = cnvrtpolytoptlist(makepolynsides(4));"},
    {"CNVRTPOLYTOCRV",
     "cnvrtpolytocrv = function(poly, order, kv): "
     "return = cbspline(order, cnvrtpolytoptlist(poly), list(kv));",
     "The B-spline curve with the vertices as control points.",
     "c = cnvrtpolytocrv(makepolynsides(5), 3, KV_OPEN);"},
    {"CNVRTPOLYTOTUBE",
     "cnvrtpolytotube = function(poly, rad, minpt, maxpt):n: "
     "n = sizeof(poly): return = nil(): "
     "if (n >= minpt, return = swpcircsrf(cinterp(cnvrtpolytoptlist(poly), "
     "min(4, n), min(n, maxpt), param_chord, false), rad, 0));",
     "A tube along a smooth curve through a polyline, of at most maxPt control "
     "points; nothing if it has fewer than minPt points.",
     "s = cnvrtpolytotube(poly(list(point(0, 0, 0), point(1, 0, 0), point(2, "
     "1, 1), point(3, 1, 2)), true), 0.1, 3, 10);"},
    {"PUTCRVMARKERS",
     "putcrvmarkers = function(crv, n, size):i:a:b:t:p:v: "
     "a = nth(pdomain(crv), 1): b = nth(pdomain(crv), 2): return = nil(): "
     "for (i = 0, 1, n, t = a + (b - a) * i / n: "
     "p = coerce(ceval(crv, t), vector_type): v = cnormal(crv, t) * size: "
     "snoc(coerce(p - v, E3) + coerce(p + v, E3), return));",
     "n + 1 short segments across a curve.",
     "l = putcrvmarkers(circle(vector(0, 0, 0), 1), 8, 0.1);"},
    /* surfaces */
    {"PLANESRF",
     "planesrf = function(x1, y1, x2, y2): return = ruledsrf("
     "ctlpt(E2, x1, y1) + ctlpt(E2, x2, y1), "
     "ctlpt(E2, x1, y2) + ctlpt(E2, x2, y2));",
     "The rectangle with corners (x1, y1) and (x2, y2).",
     "s = planesrf(0, 0, 2, 1);"},
    {"FLATSRF",
     "flatsrf = function(uorder, vorder): return = sbezier(list("
     "list(ctlpt(E3, -1, -1, 0), ctlpt(E3, -1, 1, 0)), "
     "list(ctlpt(E3, 1, -1, 0), ctlpt(E3, 1, 1, 0)))): "
     "if (uorder > 2, return = sraise(return, row, uorder)): "
     "if (vorder > 2, return = sraise(return, col, vorder));",
     "The square [-1, 1] x [-1, 1], u along y, raised to the orders.",
     "s = flatsrf(3, 4);"},
    {"SPHERESRF",
     "spheresrf = function(r):s: s = sin(pi / 4): return = surfrev(cbspline("
     "3, list(ctlpt(P3, 1, 0, 0, -1), ctlpt(P3, s, -s, 0, -s), "
     "ctlpt(P3, 1, -1, 0, 0), ctlpt(P3, s, -s, 0, s), "
     "ctlpt(P3, 1, 0, 0, 1)), list(0, 0, 0, 1, 1, 2, 2, 2))) * "
     "scale(vector(r, r, r));",
     "A sphere round the origin: direction U turns from -x, V goes from the "
     "lower pole to the upper.",
     "s = spheresrf(2);"},
    {"CYLINSRF",
     "cylinsrf = function(h, r): return = surfrev(ctlpt(E3, 0, 0, 0) + "
     "ctlpt(E3, r, 0, 0) + ctlpt(E3, r, 0, h) + ctlpt(E3, 0, 0, h));",
     "A closed cylinder of height h and radius r on the xy plane.",
     "s = cylinsrf(2, 1);"},
    {"CONESRF",
     "conesrf = function(h, r): return = surfrev("
     "ctlpt(E3, 0, 0, 0) + ctlpt(E3, r, 0, 0) + "
     "ctlpt(E3, 0, 0, h));",
     "A closed cone of height h on a disc of radius r in the xy plane.",
     "s = conesrf(2, 1);"},
    {"CONE2SRF",
     "cone2srf = function(h, r1, r2): return = surfrev(ctlpt(E3, 0, 0, 0) + "
     "ctlpt(E3, r1, 0, 0) + ctlpt(E3, r2, 0, h) + ctlpt(E3, 0, 0, h));",
     "A closed truncated cone of height h with radii r1 below and r2 above.",
     "s = cone2srf(2, 1, 0.5);"},
    {"SWPCIRCSRF",
     "swpcircsrf = function(axis, scale, refine): return = swpsclsrf("
     "circle(vector(0, 0, 0), 1), axis, scale, off, refine);",
     "A tube along a curve: SWPSCLSRF of the unit circle.",
     "s = swpcircsrf(cbezier(list(point(0, 0, 0), point(1, 0, 1), point(3, 0, "
     "0))), 0.1, 0);"},
    {"TORUSSRF",
     "torussrf = function(r1, r2): "
     "return = swpcircsrf(circle(vector(0, 0, 0), r1), r2, 0);",
     "A torus as a tube of radius r2 along the circle of radius r1 (an "
     "approximation).",
     "s = torussrf(2, 0.5);"},
    /* normals S_v x S_u point outwards */
    {"BOXSRF",
     "boxsrf = function(w, d, h):a:b:c: "
     "a = coerce(planesrf(0, 0, w, d), E3): "
     "b = coerce(planesrf(0, 0, w, h), E3) * rotx(90): "
     "c = coerce(planesrf(0, 0, h, d), E3) * roty(-90): "
     "return = list(a, -a * trans(vector(0, 0, h)), "
     "-b, b * trans(vector(0, d, 0)), "
     "-c, c * trans(vector(w, 0, 0)));",
     "The six faces of a box from the origin to (w, d, h), their normals "
     "pointing outwards.",
     "l = boxsrf(1, 2, 3);"},
    {"ARROW3D",
     "arrow3d = function(pt, dir, len, w, headlen, headw):m: "
     "m = rotz2vec(dir) * trans(coerce(pt, vector_type)): "
     "return = list(cylinsrf(len - headlen, w) * m, "
     "conesrf(headlen, headw) * tz(len - headlen) * m);",
     "An arrow from pt along dir: a cylinder and a cone, len long together.",
     "l = arrow3d(point(0, 0, 0), vector(0, 0, 1), 2, 0.05, 0.3, 0.1);"},
    {"CURVEARROWEND",
     "curvearrowend = function(crv, end, headlen, headw):t:v: "
     "t = nth(pdomain(crv), 1): if (end != 0, t = nth(pdomain(crv), 2)): "
     "v = ctangent(crv, t, true): if (end == 0, v = -v): "
     "return = conesrf(headlen, headw) * rotz2vec(v) * "
     "trans(coerce(ceval(crv, t), vector_type));",
     "An arrow head on the end of a curve, or on its start if end is 0.",
     "s = curvearrowend(cbezier(list(point(0, 0, 0), point(1, 0, 1), point(3, "
     "0, 0))), true, 0.3, 0.1);"},
    {"CREATEBBOXBOX",
     "createbboxbox = function(obj):b: b = bbox(obj): return = box("
     "vector(nth(b, 1), nth(b, 3), nth(b, 5)), nth(b, 2) - nth(b, 1), "
     "nth(b, 4) - nth(b, 3), nth(b, 6) - nth(b, 5));",
     "The box that bounds an object.", NULL},

    {"PROCESSOBJSMAXEDGELEN",
     "processobjsmaxedgelen = function(obj, len): "
     "return = maxedgelen(obj, len): cpattr(return, obj);",
     "Polygons with edges of at most a length, attributes kept.", NULL},

    /* expressions */
    {"UNIVARIATE2BEZIER",
     "univariate2bezier = function(str, deg):i:x:y:pts: pts = nil(): y = 0: "
     "for (i = 0, 1, deg, x = i / deg: exec(\"y = \" + str): "
     "snoc(ctlpt(E1, y), pts)): return = coerce(cinterp(pts, deg + 1, "
     "deg + 1, param_uniform, false), bezier_type);",
     "The Bezier curve of a degree that agrees with an expression in x at "
     "equal steps of [0, 1].",
     "c = univariate2bezier(\"x * x + 1\", 2);"},
    {"BIVARIATE2BEZIER",
     "bivariate2bezier = function(str, dx, dy):i:j:x:y:z:row_:pts: "
     "pts = nil(): z = 0: for (j = 0, 1, dy, row_ = nil(): y = j / dy: "
     "for (i = 0, 1, dx, x = i / dx: exec(\"z = \" + str): "
     "snoc(ctlpt(E3, x, y, z), row_)): snoc(row_, pts)): "
     "return = coerce(sinterp(pts, dx + 1, dy + 1, dx + 1, dy + 1, "
     "param_uniform), bezier_type);",
     "The Bezier surface (x, y, z) of degrees dx, dy that agrees with an "
     "expression in x and y on a grid of the unit square.",
     "s = bivariate2bezier(\"x * y\", 2, 2);"},
    {NULL, NULL, NULL, NULL}};

const ix__startup_fn *ix__startup_find(const char *name)
{
    for (const ix__startup_fn *f = ix__startup_text; f->name; f++)
        if (ix__name_cmp(f->name, name) == 0)
            return f;
    return NULL;
}
