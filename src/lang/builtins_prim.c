/* builtins_prim.c - bisectors of points, lines, planes, spheres, cylinders,
 * cones and tori (chapter 21 of spec/functions). */

#include "geom/vec3.h"
#include "iritx/ops_prim.h"
#include "lang/args_freeform.h"
#include "lang/op_args.h"

/* What the arguments of a function are: of each primitive p a position, d a
 * direction, r a radius, m a major radius, a an angle, z (no argument) the
 * direction of z; last s, the size. */
typedef struct {
    ix_prim_kind kind;
    const char *args;
} recipe;

/* Reads the arguments of one primitive from *i on. */
static ix_status arg_prim(ix_call *c, int *i, const recipe *r, ix_prim *p)
{
    *p = (ix_prim){.kind = r->kind};
    for (const char *s = r->args; *s; s++) {
        if (*s == 'z')
            p->dir[2] = 1;
        else if (*s == 'p' || *s == 'd')
            IX_TRY(ix__arg_pt3(c, (*i)++, *s == 'p' ? p->pos : p->dir));
        else if (*s == 'r')
            p->radius = ix__arg_num(c, (*i)++);
        else if (*s == 'm')
            p->major = ix__arg_num(c, (*i)++);
        else
            p->degrees = ix__arg_num(c, (*i)++);
    }
    return IX_OK;
}

/* One surface, or a list of several; takes over s. */
static ix_status ret_surfaces(ix_call *c, ix_crvs *s)
{
    ix_obj *list;
    ix_status st;
    ix_mv *m;

    if (s->n == 1) {
        m = ix_mv_ref(s->crv[0]);
        ix_crvs_free(c->ctx, s);
        return ix__ret_mv(c, -1, m);
    }
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < s->n; i++)
        st = ix__list_add(
            c->ctx, list,
            ix__obj_mv(c->ctx, IX_OBJ_SURFACE, ix_mv_ref(s->crv[i])));
    ix_crvs_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

/* Without a size argument: the distance of both. */
static ix_status bisector(ix_call *c, const recipe *ra, const recipe *rb)
{
    ix_op_opts o = ix__op_opts(c);
    ix_prim a, b;
    double size;
    ix_crvs s;
    int i = 0;

    IX_TRY(arg_prim(c, &i, ra, &a));
    IX_TRY(arg_prim(c, &i, rb, &b));
    size = i < c->argc ? ix__arg_num(c, i) : 1.0 + ix__dist3(a.pos, b.pos);
    if (ra->kind == IX_PRIM_PLANE && rb->kind == IX_PRIM_POINT)
        size *= 2.0 * fmax(fabs(b.pos[0]), fabs(b.pos[1])) + 1.0;
    IX_TRY(ix_prim_bisector(c->ctx, &a, &b, size, &o, &s));
    return ret_surfaces(c, &s);
}

#define PAIR(fn, ka, aa, kb, ab)                                            \
    static ix_status fn(ix_call *c)                                         \
    {                                                                       \
        static const recipe a = {IX_PRIM_##ka, aa}, b = {IX_PRIM_##kb, ab}; \
                                                                            \
        return bisector(c, &a, &b);                                         \
    }

PAIR(bsctplnpt, PLANE, "z", POINT, "p")
PAIR(bsctcylpt, CYLINDER, "pdr", POINT, "p")
PAIR(bsctconpt, CONE, "pda", POINT, "p")
PAIR(bsctsprpt, SPHERE, "pr", POINT, "p")
PAIR(bscttrspt, TORUS, "pdmr", POINT, "p")
PAIR(bsctplnln, PLANE, "z", LINE, "d")
PAIR(bsctconln, CONE, "da", LINE, "d")
PAIR(bsctsprln, SPHERE, "pr", LINE, "z")
PAIR(bsctsprpl, SPHERE, "pr", PLANE, "z")
PAIR(bsctcylpl, CYLINDER, "pdr", PLANE, "z")
PAIR(bsctconpl, CONE, "pda", PLANE, "z")
PAIR(bsctconcon, CONE, "da", CONE, "da")
PAIR(bsctsprspr, SPHERE, "pr", SPHERE, "pr")
PAIR(bsctcylspr, CYLINDER, "pdr", SPHERE, "pr")
PAIR(bsctconspr, CONE, "pda", SPHERE, "pr")
PAIR(bscttrsspr, TORUS, "pdmr", SPHERE, "pr")
PAIR(bsctcylcyl, CYLINDER, "pdr", CYLINDER, "pdr")
PAIR(bsctconcyl, CONE, "pda", CYLINDER, "pdr")
PAIR(bsctconcn2, CONE, "pda", CONE, "pda")
PAIR(bsctplnpln, PLANE, "pd", PLANE, "pd")
PAIR(bscttrscyl, TORUS, "pdmr", CYLINDER, "pdr")
PAIR(bscttrspl, TORUS, "pdmr", PLANE, "z")
PAIR(bscttrsln, TORUS, "pdmr", LINE, "pd")
PAIR(bscttrscon, TORUS, "pdmr", CONE, "pda")
PAIR(bscttrstrs, TORUS, "pdmr", TORUS, "pdmr")

/* --- table -----------------------------------------------------------------
 */

const ix_builtin ix__builtins_prim[] = {
    {"BSCTPLNPT", "p:pt3 size:num -> surface|list",
     "Bisector of the plane z = 0 and a point. A paraboloid.",
     "b = bsctplnpt(point(0.3, 0, 2), 1.5);", bsctplnpt, 0, 21},
    {"BSCTCYLPT", "pos:pt3 dir:pt3 rad:num p:pt3 size:num -> surface|list",
     "Bisector of a cylinder and a point.",
     "b = bsctcylpt(point(0, 0, 0), vector(0, 0, 2), 0.3, point(0.8, 0, 1), "
     "1.5);",
     bsctcylpt, 0, 21},
    {"BSCTCONPT", "apex:pt3 dir:pt3 ang:num p:pt3 size:num -> surface|list",
     "Bisector of a cone and a point.",
     "b = bsctconpt(point(0, 0, 0.5), vector(0, 0, 1), 30, point(0.5, 0, 1), "
     "1.5);",
     bsctconpt, 0, 21},
    {"BSCTSPRPT", "center:pt3 rad:num p:pt3 -> surface|list",
     "Bisector of a sphere and a point.",
     "b = bsctsprpt(point(0.5, 0, 0), 0.4, point(0, 2, 1));", bsctsprpt, 0, 21},
    {"BSCTTRSPT", "pos:pt3 dir:pt3 major:num minor:num p:pt3 -> surface|list",
     "Bisector of a torus and a point.",
     "b = bscttrspt(point(0, 0, 0), vector(0, 0, 1), 1, 0.3, point(0.5, 2, "
     "0.5));",
     bscttrspt, 0, 21},
    {"BSCTPLNLN", "dir:pt3 size:num -> list|surface",
     "Bisector of the plane z = 0 and a line through the origin: both nappes.",
     "l = bsctplnln(vector(0.2, 0, 1), 2);", bsctplnln, 0, 21},
    {"BSCTCONLN", "cdir:pt3 ang:num ldir:pt3 size:num -> list|surface",
     "Bisector of a cone with its apex at the origin and a line through it: "
     "both nappes.",
     "l = bsctconln(vector(0, 0, 1), 30, vector(0.3, 0, 1), 2);", bsctconln, 0,
     21},
    {"BSCTSPRLN", "center:pt3 rad:num size:num -> surface|list",
     "Bisector of a sphere and the z axis.",
     "b = bsctsprln(point(1.5, 0.5, 0), 0.4, 2);", bsctsprln, 0, 21},
    {"BSCTSPRPL", "center:pt3 rad:num size:num -> surface|list",
     "Bisector of a sphere and the plane z = 0.",
     "b = bsctsprpl(point(0.5, 0, 2), 0.6, 1);", bsctsprpl, 0, 21},
    {"BSCTCYLPL", "pos:pt3 dir:pt3 rad:num size:num -> list|surface",
     "Bisector of a cylinder and the plane z = 0: one surface on each side of "
     "the plane; of a parallel axis parabolic cylinders.",
     "l = bsctcylpl(point(0.3, 0, 2), vector(0, 0.2, 1), 0.4, 2);", bsctcylpl,
     0, 21},
    {"BSCTCONPL", "apex:pt3 dir:pt3 ang:num size:num -> list|surface",
     "Bisector of a cone and the plane z = 0: both nappes.",
     "l = bsctconpl(point(0.2, 0, 1), vector(0, 0.3, 1), 25, 2);", bsctconpl, 0,
     21},
    {"BSCTCONCON",
     "dir1:pt3 ang1:num dir2:pt3 ang2:num size:num -> list|surface",
     "Bisector of two cones with their apex at the origin: both nappes. Angles "
     "are half the opening, in degrees.",
     "l = bsctconcon(vector(0.1, 0, 1), 35, vector(0, 0.3, 1), 15, 2);",
     bsctconcon, 0, 21},
    {"BSCTSPRSPR", "c1:pt3 r1:num c2:pt3 r2:num -> surface|list",
     "Bisector of two spheres.",
     "b = bsctsprspr(point(0, 0, 0), 0.5, point(0, 2, 0), 0.3);", bsctsprspr, 0,
     21},
    {"BSCTCYLSPR",
     "pos:pt3 dir:pt3 rad:num center:pt3 sprrad:num size:num -> surface|list",
     "Bisector of a cylinder and a sphere.",
     "b = bsctcylspr(point(0, 0, 2), vector(0, 0, 2), 0.3, point(0.2, 0, 0), "
     "0.5, 2);",
     bsctcylspr, 0, 21},
    {"BSCTCONSPR",
     "apex:pt3 dir:pt3 ang:num center:pt3 rad:num size:num -> surface|list",
     "Bisector of a cone and a sphere.",
     "b = bsctconspr(point(0, 0, 0), vector(0, 0, 1), 30, point(0, 0, 2), 0.4, "
     "1.5);",
     bsctconspr, 0, 21},
    {"BSCTTRSSPR",
     "pos:pt3 dir:pt3 major:num minor:num center:pt3 rad:num -> surface|list",
     "Bisector of a torus and a sphere.",
     "b = bscttrsspr(point(0, 0, 0), vector(0, 0, 1), 0.7, 0.2, point(2, 0, "
     "0), 0.3);",
     bscttrsspr, 0, 21},
    {"BSCTCYLCYL", "p1:pt3 d1:pt3 r1:num p2:pt3 d2:pt3 r2:num -> surface|list",
     "Bisector of two cylinders. Over [0, 1]^2, a circle of each; of parallel "
     "axes a plane, a hyperbolic, an elliptic cylinder, or two of them.",
     "b = bsctcylcyl(point(0, 0, 0), vector(0, 0, 1), 0.3, point(2, 0, 0), "
     "vector(0, 1, 0), 0.3);",
     bsctcylcyl, 0, 21},
    {"BSCTCONCYL",
     "apex:pt3 dir:pt3 ang:num pt:pt3 cdir:pt3 rad:num -> surface|list",
     "Bisector of a cone and a cylinder.",
     "b = bsctconcyl(point(0, 0, 0), vector(0, 0, 1), 20, point(3, 0, 0), "
     "vector(0, 1, 0), 0.3);",
     bsctconcyl, 0, 21},
    {"BSCTCONCN2",
     "apex1:pt3 dir1:pt3 ang1:num apex2:pt3 dir2:pt3 ang2:num -> surface|list",
     "Bisector of two cones.",
     "b = bsctconcn2(point(0, 0, 0), vector(0, 0, 1), 20, point(3, 0, 0), "
     "vector(0, 1, 1), 20);",
     bsctconcn2, 0, 21},
    {"BSCTPLNPLN", "p1:pt3 n1:pt3 p2:pt3 n2:pt3 size:num -> list|surface",
     "Bisector of two planes, given by points and normals: both planes between "
     "them, or the one halfway if they are parallel.",
     "l = bsctplnpln(point(0, 0, 0), vector(0, 0, 1), point(0, 0, 1), "
     "vector(1, 0, 1), 2);",
     bsctplnpln, 0, 21},
    {"BSCTTRSPL",
     "pos:pt3 dir:pt3 major:num minor:num size:num -> surface|list",
     "Bisector of a torus and the plane z = 0: a biquadratic surface on each "
     "side of the plane that has a part of the torus. It is unbounded where "
     "the normals of both are one; of an axis along z it is turned parabolas, "
     "as far as size.",
     "b = bscttrspl(point(0, 0, 2), vector(0, 1, 1), 1, 0.3, 2);", bscttrspl, 0,
     21},
    {"BSCTTRSLN",
     "pos:pt3 dir:pt3 major:num minor:num pt:pt3 ldir:pt3 size:num -> "
     "surface|list",
     "Bisector of a torus and its axis: a turned parabola; of a circle (minor "
     "radius 0) and any line.",
     "b = bscttrsln(point(0, 0, 0), vector(0, 0, 1), 1, 0.3, point(0, 0, 0), "
     "vector(0, 0, 1), 2);",
     bscttrsln, 0, 21},
    {"BSCTTRSCON",
     "pos:pt3 dir:pt3 major:num minor:num apex:pt3 cdir:pt3 ang:num size:num "
     "-> surface|list",
     "Bisector of a torus and a cone around its axis: turned parabolas.",
     "b = bscttrscon(point(0, 0, 0), vector(0, 0, 1), 1, 0.3, point(0, 0, -2), "
     "vector(0, 0, 1), 15, 2);",
     bscttrscon, 0, 21},
    {"BSCTTRSCYL",
     "pos:pt3 dir:pt3 major:num minor:num pt:pt3 cdir:pt3 rad:num size:num -> "
     "surface|list",
     "Bisector of a torus and a cylinder of the same (minor) radius: that of "
     "circle and axis; or around its axis: turned parabolas.",
     "b = bscttrscyl(point(0, 0, 0), vector(0, 0, 1), 1, 0.2, point(0.5, 0, "
     "1), vector(0, 1, 0), 0.2, 2);",
     bscttrscyl, 0, 21},
    {"BSCTTRSTRS",
     "pos1:pt3 dir1:pt3 major1:num minor1:num pos2:pt3 dir2:pt3 major2:num "
     "minor2:num -> surface|list",
     "Bisector of two tori of the same minor radius: that of their circles; or "
     "around one axis: a turned hyperbola, ellipse, or both.",
     "b = bscttrstrs(point(0, 0, 0), vector(0, 0, 1), 1, 0.2, point(2, 0, 1), "
     "vector(1, 0, 0), 1, 0.2);",
     bscttrstrs, 0, 21},
    {0}};
