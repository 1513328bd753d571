/* builtins_solid.c - chapter 24 of spec/functions: polygonal solids, tool
 * paths, images. Primitives are real, as polygons, because scripts use them as
 * data; what works on solids answers that this program does not. */
#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "lang/poly_rows.h"

/* --- bodies of revolution ------------------------------------------------ */

/* A profile (radius, height) about the Z axis, turned and moved by mat. */
typedef struct {
    int n; /* steps of a turn */
    double mat[16];
} body;

static void body_row(const void *arg, int k, int vertex, const double p[3],
                     double out[3])
{
    const body *b = arg;
    double s, co, q[3];

    (void)vertex;
    /* the last copy is the first one, bit for bit */
    ix__sincos_deg(360.0 * (k % b->n) / b->n, &s, &co);
    q[0] = p[0] * co;
    q[1] = p[0] * s;
    q[2] = p[2];
    memcpy(out, q, sizeof q);
    (void)ix__mat_point(q, b->mat, out);
}

/* +Z to the axis, the origin to the centre. */
static ix_status body_frame(ix_call *c, const double center[3],
                            const double axis[3], body *b)
{
    static const double z[3] = {0, 0, 1};
    double move[16];

    IX_TRY(ix__mat_turn(c->ctx, z, axis, b->mat));
    ix__mat_translate(center, move);
    ix__mat_mul(b->mat, move, b->mat);
    return IX_OK;
}

static int steps(const ix_call *c)
{
    return (int)fmin(fmax(ix__var_num(c->in, "RESOLUTION", 20), 4), 1000);
}

/* The polygons between n points (radius, 0, height), turned. */
static ix_status ret_body(ix_call *c, body *b, int n, const double (*prof)[3])
{
    ix_poly *line = ix__poly_new(c->ctx, 1), *out = NULL;
    ix_status st;

    if (!line)
        return IX_ENOMEM;
    b->n = steps(c);
    st = ix__polygon_fill(c->ctx, &line->poly[0], IX_POLYLINE, n, prof);
    if (st == IX_OK)
        st = ix__poly_rows(c->ctx, line, b->n + 1, false, body_row, b, &out);
    ix__poly_unref(c->ctx, line);
    IX_TRY(st);
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

static ix_status arg_length(ix_call *c, int i, bool zero, double *out)
{
    *out = ix__arg_num(c, i);
    if (!(*out > 0 || (zero && *out == 0)))
        return IX_ARG_FAIL(c, i, "%g; a positive length is wanted", *out);
    return IX_OK;
}

/* Radii r0 at the centre and r1 at centre + axis; caps: bit 0 the first. */
static ix_status frustum(ix_call *c, double r0, double r1, int caps)
{
    double center[3], axis[3], prof[4][3], h;
    int n = 0;
    body b;

    IX_TRY(ix__arg_vec3(c, 0, center));
    IX_TRY(ix__arg_vec3(c, 1, axis));
    IX_TRY(body_frame(c, center, axis, &b));
    h = ix__len3(axis);
    memset(prof, 0, sizeof prof);
    if (caps & 1 && r0 > 0)
        n++;
    prof[n++][0] = r0;
    prof[n][0] = r1;
    prof[n++][2] = h;
    if (caps & 2 && r1 > 0)
        prof[n++][2] = h;
    return ret_body(c, &b, n, (const double(*)[3])prof);
}

static ix_status cylin(ix_call *c)
{
    double r;
    int caps;

    IX_TRY(arg_length(c, 2, false, &r));
    IX_TRY(ix__arg_int(c, 3, 0, 3, &caps));
    return frustum(c, r, r, caps);
}

static ix_status cone(ix_call *c)
{
    double r;
    int caps;

    IX_TRY(arg_length(c, 2, false, &r));
    IX_TRY(ix__arg_int(c, 3, 0, 3, &caps));
    return frustum(c, r, 0, caps & 1);
}

static ix_status con2(ix_call *c)
{
    double r0, r1;
    int caps;

    IX_TRY(arg_length(c, 2, true, &r0));
    IX_TRY(arg_length(c, 3, r0 > 0, &r1));
    IX_TRY(ix__arg_int(c, 4, 0, 3, &caps));
    return frustum(c, r0, r1, caps);
}

/* The arc of radius r from a0 to a1 degrees (0: +z) about (x, 0, 0). */
static void arc(double x, double r, double a0, double a1, int n,
                double (*out)[3])
{
    for (int i = 0; i <= n; i++) {
        double s, co;

        ix__sincos_deg(a0 + (a1 - a0) * i / n, &s, &co);
        out[i][0] = x + r * s;
        out[i][1] = 0;
        out[i][2] = r * co;
    }
}

static ix_status sphere(ix_call *c)
{
    double center[3], r, (*prof)[3];
    int n = (steps(c) + 1) / 2;
    body b;

    IX_TRY(ix__arg_vec3(c, 0, center));
    IX_TRY(arg_length(c, 1, false, &r));
    IX_TRY(body_frame(c, center, (const double[3]){0, 0, 1}, &b));
    IX_SCRATCH(c->ctx, prof, n + 1);
    arc(0, r, 180, 0, n, prof);
    return ret_body(c, &b, n + 1, (const double(*)[3])prof);
}

static ix_status torus(ix_call *c)
{
    double center[3], normal[3], big, r, (*prof)[3];
    int n = steps(c);
    body b;

    IX_TRY(ix__arg_vec3(c, 0, center));
    IX_TRY(ix__arg_vec3(c, 1, normal));
    IX_TRY(arg_length(c, 2, false, &big));
    IX_TRY(arg_length(c, 3, false, &r));
    if (!(r < big))
        return IX_ARG_FAIL(c, 3,
                           "a tube of radius %g about a circle of %g; it "
                           "must be smaller",
                           r, big);
    IX_TRY(body_frame(c, center, normal, &b));
    IX_SCRATCH(c->ctx, prof, n + 1);
    arc(big, r, 360, 0, n, prof);
    memcpy(prof[n], prof[0], sizeof prof[0]);
    return ret_body(c, &b, n + 1, (const double(*)[3])prof);
}

/* --- boxes -----------------------------------------------------------------
 */

/* Six faces whose normals point outwards, v spanning a right-handed box. */
static ix_status ret_box(ix_call *c, const double at[3], const double v[3][3])
{
    static const int walk[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    ix_poly *p = ix__poly_new(c->ctx, 6);
    ix_status st = p ? IX_OK : IX_ENOMEM;

    for (int f = 0; st == IX_OK && f < 6; f++) {
        const double *a = v[(f / 2 + 1) % 3], *b = v[(f / 2 + 2) % 3];
        double q[4][3];

        for (int i = 0; i < 4; i++) {
            /* the near face is seen from behind */
            const int *w = walk[f % 2 ? 3 - i : i];

            ix__axpy3(at, f % 2, v[f / 2], q[i]);
            ix__axpy3(q[i], w[0], a, q[i]);
            ix__axpy3(q[i], w[1], b, q[i]);
        }
        st = ix__polygon_fill(c->ctx, &p->poly[f], IX_POLYGON, 4,
                              (const double(*)[3])q);
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    if (p)
        ix__poly_unref(c->ctx, p);
    return st;
}

static ix_status box(ix_call *c)
{
    double at[3], v[3][3] = {{0}};

    IX_TRY(ix__arg_vec3(c, 0, at));
    for (int k = 0; k < 3; k++) {
        double d = ix__arg_num(c, k + 1);

        if (!(d > 0 || d < 0))
            return IX_ARG_FAIL(c, k + 1, "an edge of length %g", d);
        at[k] += fmin(d, 0); /* from the other corner */
        v[k][k] = fabs(d);
    }
    return ret_box(c, at, (const double(*)[3])v);
}

static ix_status gbox(ix_call *c)
{
    double at[3], v[3][3], n[3], vol;

    IX_TRY(ix__arg_vec3(c, 0, at));
    for (int k = 0; k < 3; k++)
        IX_TRY(ix__arg_vec3(c, k + 1, v[k]));
    ix__cross3(v[0], v[1], n);
    vol = ix__dot3(n, v[2]);
    if (!(fabs(vol) > 1e-12 * ix__len3(v[0]) * ix__len3(v[1]) * ix__len3(v[2])))
        return IX_ARG_FAIL(c, 3, "the three edges lie in one plane");
    if (vol < 0) {
        memcpy(n, v[0], sizeof n);
        memcpy(v[0], v[1], sizeof n);
        memcpy(v[1], n, sizeof n);
    }
    return ret_box(c, at, (const double(*)[3])v);
}

/* --- measures
 * ---------------------------------------------------------------- */

static ix_status polygons_of(ix_call *c, const ix_poly **out)
{
    *out = c->argv[0]->u.poly;
    for (int i = 0; i < (*out)->n; i++)
        if ((*out)->poly[i].kind != IX_POLYGON)
            return IX_ARG_FAIL(c, 0, "element %d is not a polygon", i + 1);
    return IX_OK;
}

/* Twice the area vector of a polygon: the sum of p_i x p_(i+1), taken from its
 * first vertex. */
static void area_vector(const ix_polygon *pg, double out[3])
{
    memset(out, 0, 3 * sizeof *out);
    for (int i = 1; i + 1 < pg->n; i++) {
        double a[3], b[3], n[3];

        ix__sub3(pg->v[i].p, pg->v[0].p, a);
        ix__sub3(pg->v[i + 1].p, pg->v[0].p, b);
        ix__cross3(a, b, n);
        ix__axpy3(out, 1, n, out);
    }
}

static ix_status area(ix_call *c)
{
    const ix_poly *p;
    double sum = 0, n[3];

    IX_TRY(polygons_of(c, &p));
    for (int i = 0; i < p->n; i++) {
        area_vector(&p->poly[i], n);
        sum += ix__len3(n) / 2;
    }
    return ix__ret_num(c, sum);
}

/* The sum of the pyramids over planar polygons from one point of them. */
static ix_status volume(ix_call *c)
{
    const ix_poly *p;
    double sum = 0, n[3], d[3];

    IX_TRY(polygons_of(c, &p));
    for (int i = 0; i < p->n; i++) {
        if (p->poly[i].n < 3)
            continue;
        area_vector(&p->poly[i], n);
        ix__sub3(p->poly[i].v[0].p, p->poly[0].v[0].p, d);
        sum += ix__dot3(n, d) / 6;
    }
    return ix__ret_num(c, fabs(sum));
}

static ix_status cpoly(ix_call *c)
{
    return ix__ret_num(c, c->argv[0]->u.poly->n);
}

static ix_status pmorph(ix_call *c)
{
    const ix_poly *a = c->argv[0]->u.poly, *b = c->argv[1]->u.poly;
    double t = ix__arg_num(c, 2);
    ix_poly *out;

    for (int i = 0; i < a->n || i < b->n; i++)
        if (a->n != b->n || a->poly[i].n != b->poly[i].n)
            return IX_ARG_FAIL(c, 1,
                               "%d polygons, the first has %d: both need as "
                               "many, with as many vertices each",
                               b->n, a->n);
    out = ix__poly_dup(c->ctx, a);
    if (!out)
        return IX_ENOMEM;
    for (int i = 0; i < a->n; i++) {
        ix_polygon *pg = &out->poly[i];

        for (int k = 0; k < pg->n; k++) {
            const double *q = b->poly[i].v[k].p;

            for (int e = 0; e < 3; e++)
                pg->v[k].p[e] = (1 - t) * pg->v[k].p[e] + t * q[e];
            pg->v[k].has_normal = false;
        }
        pg->has_plane = pg->kind == IX_POLYGON &&
                        ix__polygon_plane(pg, pg->plane);
    }
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

/* --- what is not done
 * -------------------------------------------------------- */

static ix_status no_solids(ix_call *c)
{
    return IX_FAIL(c->ctx, IX_EUNABLE,
                   "this program does not do polygonal solids: its subject is "
                   "the exact geometry of curves and surfaces");
}

static ix_status no_images(ix_call *c)
{
    return IX_FAIL(c->ctx, IX_EUNABLE,
                   "this program does not do images and volume data");
}

static ix_status no_paths(ix_call *c)
{
    return IX_FAIL(c->ctx, IX_EUNABLE,
                   "this program does not do tool paths of machines");
}

#define BOX    "b = box(vector(0,0,0), 1, 2, 3); "
#define SOLID  "Works on polygonal solids, which this program does not do."
#define IMAGES "Works on images or volumes, which this program does not do."
#define PATHS  "Makes tool paths of machines, which this program does not do."

#define NO(name, sig, ex)                              \
    {                                                  \
        name, sig, SOLID, ex, no_solids, IX_B_SOFT, 24 \
    }
#define NO_IMAGE(name, sig, ex)                         \
    {                                                   \
        name, sig, IMAGES, ex, no_images, IX_B_SOFT, 24 \
    }

const ix_builtin ix__builtins_solid[] = {
    {"BOX", "corner:vector dx:num dy:num dz:num -> poly",
     "The six faces of a box, as polygons with normals that point outwards.",
     BOX, box, 0, 24},
    {"GBOX", "corner:vector v1:vector v2:vector v3:vector -> poly",
     "The six faces of a parallelepiped, as polygons.",
     "b = gbox(vector(0,0,0), vector(1,0,0), vector(0,1,0), vector(0,1,1));",
     gbox, 0, 24},
    {"CYLIN", "center:vector axis:vector r:num caps:num -> poly",
     "A cylinder from center to center + axis as polygons, RESOLUTION around; "
     "caps: 0 none, 1 base, 2 top, 3 both.",
     "p = cylin(vector(0,0,0), vector(0,0,2), 1, 3);", cylin, 0, 24},
    {"CONE", "center:vector axis:vector r:num caps:num -> poly",
     "A cone with its base at center and its apex at center + axis; as CYLIN.",
     "p = cone(vector(0,0,0), vector(0,0,2), 1, 1);", cone, 0, 24},
    {"CON2", "center:vector axis:vector r1:num r2:num caps:num -> poly",
     "A truncated cone; as CYLIN.",
     "p = con2(vector(0,0,0), vector(0,0,2), 1, 0.5, 3);", con2, 0, 24},
    {"SPHERE", "center:vector r:num -> poly",
     "A sphere as polygons, RESOLUTION around.",
     "p = sphere(vector(0,0,0), 1);", sphere, 0, 24},
    {"TORUS", "center:vector normal:vector R:num r:num -> poly",
     "A torus as polygons, RESOLUTION in both directions.",
     "p = torus(vector(0,0,0), vector(0,0,1), 2, 0.5);", torus, 0, 24},
    {"AREA", "p:poly -> num", "The area of all polygons together.",
     BOX "a = area(b);", area, 0, 24},
    {"VOLUME", "p:poly -> num",
     "The volume inside closed polygons, all turned the same way.",
     BOX "v = volume(b);", volume, 0, 24},
    {"CPOLY", "p:poly -> num", "The number of polygons.", BOX "n = cpoly(b);",
     cpoly, 0, 24},
    {"PMORPH", "p1:poly p2:poly t:num -> poly",
     "(1 - t) p1 + t p2, vertex by vertex.",
     BOX "m = pmorph(b, b * sc(2), 0.5);", pmorph, 0, 24},

    NO("CONVEX", "p:poly|list -> poly|list", BOX "c = convex(b);"),
    NO("COVERPT", "p:poly n:num dir:vector -> poly",
       BOX "c = coverpt(b, 10, vector(0,0,1));"),
    NO("CROSSEC", "p:poly|curve -> poly", BOX "c = crossec(b);"),
    NO("FITPMODEL", "p:poly a:num b:num c:num -> list",
       BOX "l = fitpmodel(b, 1, 1, 1);"),
    NO("FIXPLGEOM", "p:poly|list op:num eps:num -> poly|list",
       BOX "c = fixplgeom(b, 1, 1e-6);"),
    NO("FIXPLNRML", "p:poly|list a:num -> poly|list",
       BOX "c = fixplnrml(b, 1);"),
    NO("MAXEDGELEN", "p:poly len:num -> poly", BOX "c = maxedgelen(b, 0.1);"),
    NO("PCRVTR", "p:poly a:num b:num -> poly", BOX "c = pcrvtr(b, 1, 1);"),
    NO("PDECIMATE", "p:poly a:num b:num -> poly",
       BOX "c = pdecimate(b, 1, 1);"),
    NO("PIMPRTNC", "p:poly a:num -> poly", BOX "c = pimprtnc(b, 1);"),
    NO("PLANECLIP", "p:poly pl:plane -> list",
       BOX "l = planeclip(b, plane(1,0,0,-0.5));"),
    NO("POLYHOLES", "p:poly holes:poly|list -> poly",
       BOX "c = polyholes(b, b);"),
    NO("PPINCLUDE", "p:poly pt:pt3 -> num",
       BOX "n = ppinclude(b, point(0,0,0));"),
    NO("PPINTER", "p1:poly p2:poly -> poly", BOX "c = ppinter(b, b);"),
    NO("PPROPFTCH", "p:poly type:num params:list -> poly",
       BOX "c = ppropftch(b, 1, nil());"),
    NO("PRINTER", "p:poly pt:pt3 axis:num -> num",
       BOX "n = printer(b, point(0,0,0), 0);"),
    NO("SDDMMAP", "p:poly|surface x:any a:num b:num c:num -> any",
       BOX "x = sddmmap(b, b, 1, 1, 1);"),
    NO("SMOOTHNRML", "p:poly|list deg:num -> poly|list",
       BOX "c = smoothnrml(b, 30);"),
    NO("TRIANGL", "p:poly opt:num -> poly", BOX "c = triangl(b, 1);"),
    NO("UVPOLY", "p:poly a:list b:list -> poly",
       BOX "c = uvpoly(b, list(1,1), list(0,0));"),
    NO("ZCOLLIDE", "a:any b:any res:num n:num -> num",
       BOX "n = zcollide(b, b, 0.1, 10);"),

    NO_IMAGE("BFROM2IMG",
             "im1:str im2:str a:num b:num c:num d:num e:num f:num -> any",
             "b = bfrom2img(\"a.ppm\", \"b.ppm\", 0, 0, 0, 0, 0, 0);"),
    NO_IMAGE("BFROM3IMG",
             "im1:str im2:str im3:str a:num b:num c:num d:num e:num f:num -> "
             "any",
             "b = bfrom3img(\"a.ppm\", \"b.ppm\", \"c.ppm\", 0, 0, 0, 0, 0, "
             "0);"),
    NO_IMAGE("MFROM2IMG",
             "im1:str im2:str a:num x:any b:num c:num d:num e:num f:num g:num "
             "h:num -> list",
             "l = mfrom2img(\"a.ppm\", \"b.ppm\", 0, 0, 0, 0, 0, 0, 0, 0, "
             "0);"),
    NO_IMAGE("MFROM3IMG",
             "im1:str im2:str im3:str a:num x:any b:num c:num d:num e:num "
             "f:num g:num h:num -> list",
             "l = mfrom3img(\"a.ppm\", \"b.ppm\", \"c.ppm\", 0, 0, 0, 0, 0, 0, "
             "0, 0, 0);"),
    NO_IMAGE("MRCHCUBE", "vol:list cell:pt3 skip:num iso:num -> poly",
             "p = mrchcube(list(\"vol\", 1, 8, 8, 8), point(1,1,1), 1, 0.5);"),
    NO_IMAGE("COVERISO",
             "t:trivar n:num type:num lens:vector step:num iso:num "
             "view:vector -> curve",
             "t = tbezier(list(list(list(ctlpt(E1,0), ctlpt(E1,1))))); c = "
             "coveriso(t, 10, 1, vector(0.1,0.3,1), 0.02, 0.5, "
             "vector(0,0,1));"),
    NO_IMAGE("TVLOAD", "file:str type:num size:vector orders:vector -> trivar",
             "t = tvload(\"vol.asc\", 1, vector(8,8,8), vector(3,3,3));"),
    {"NCCNTRPATH", "x:any a:num b:num c:num d:num -> poly", PATHS,
     BOX "p = nccntrpath(b, 1, 1, 1, 1);", no_paths, IX_B_SOFT, 24},
    {"NCPCKTPATH", "x:any a:num b:num c:num d:num e:num f:num -> poly", PATHS,
     BOX "p = ncpcktpath(b, 1, 1, 1, 1, 1, 1);", no_paths, IX_B_SOFT, 24},
    {0}};
