/* builtins_visible.c - chapters 9, 10 and 24 of spec/functions: what is seen of
 * curves, convex hulls, pairs of tangents. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/hull3.h"
#include "geom/matrix.h"
#include "geom/vec3.h"
#include "iritx/contour.h"
#include "iritx/visible.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"
#include "lang/poly_rows.h"
#include "mv/tessellate.h"

static ix_status cvisible(ix_call *c)
{
    double v[3];
    ix_crvs p;

    IX_TRY(ix__arg_vec3(c, 1, v));
    if (v[2] != 0 && v[2] != 1)
        return IX_ARG_FAIL(c, 1,
                           "a third coordinate of %g; (x, y, 1) is a viewer, "
                           "(x, y, 0) a direction",
                           v[2]);
    IX_TRY(ix_crv_visible(c->ctx, ix__arg_mv(c, 0), v, v[2] != 0, &p));
    return ix__ret_crvs(c, &p);
}

static ix_status cviewmap(ix_call *c)
{
    ix_lines l;
    ix_status st;

    IX_TRY(ix_crv_view_map(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                           ix__arg_bool(c, 4), ix__contour_tolerance(c), &l));
    st = l.n ? ix__ret_lines(c, &l, IX_POLYLINE) : IX_OK;
    ix_lines_free(c->ctx, &l);
    return st;
}

/* The region as a trimmed surface with its direction. */
static ix_status add_region(ix_call *c, const ix_view_region *r, ix_obj *list)
{
    ix_obj *dir = ix__obj_vector(c->ctx, r->dir), *o = NULL;
    ix_status st = dir ? IX_OK : IX_ENOMEM;

    if (st == IX_OK)
        st = ix__region_obj(c->ctx, ix__arg_mv(c, 0), &r->border, &o);
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, &o->attrs, "ViewDir", dir);
    ix__obj_unref(c->ctx, dir);
    if (st == IX_OK)
        return ix__list_add(c->ctx, list, o);
    ix__obj_unref(c->ctx, o);
    return st;
}

static ix_status svisible(ix_call *c)
{
    double deg = ix__arg_num(c, 2);
    ix_view_regions r;
    ix_obj *list;
    ix_status st;
    int cells;

    IX_TRY(ix__arg_int(c, 1, 1, 100, &cells));
    if (!(deg >= 0.1 && deg <= 90))
        return IX_ARG_FAIL(c, 2, "a cone of %g degrees; 0.1 to 90 are possible",
                           deg);
    IX_TRY(ix_srf_view_regions(c->ctx, ix__arg_mv(c, 0), cells,
                               deg * (acos(-1) / 180), ix__contour_tolerance(c),
                               &r));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < r.n; i++)
        st = add_region(c, &r.region[i], list);
    ix_view_regions_free(c->ctx, &r);
    return ix__ret_list(c, list, st);
}

/* --- convex hulls --------------------------------------------------------- */

static int by_place(const void *a, const void *b)
{
    const double *p = a, *q = b;
    int k = p[0] < q[0] || p[0] > q[0] ? 0 : 1;

    return p[k] < q[k] ? -1 : p[k] > q[k];
}

/* Twice the area of the triangle o, a, b. */
static double turn(const double *o, const double *a, const double *b)
{
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/* The hull of n points, counter-clockwise, in out[2 n]; points on its edges are
 * left out (Andrew 1979). */
static int hull_points(int n, double (*p)[3], double (*out)[3])
{
    int k = 0;

    qsort(p, (size_t)n, sizeof *p, by_place);
    for (int pass = 0; pass < 2; pass++) {
        int least = k + 2;

        for (int i = 0; i < n; i++) {
            const double *q = p[pass ? n - 1 - i : i];

            while (k >= least && !(turn(out[k - 2], out[k - 1], q) > 0))
                k--;
            memcpy(out[k++], q, sizeof *out);
        }
        k--; /* the other pass begins with it */
    }
    return k;
}

static ix_status poly_hull(ix_call *c)
{
    double(*p)[3], (*out)[3];
    ix_status st;
    ix_poly *res;
    int n;

    IX_TRY(ix__arg_vertices(c, 0, &n, &p));
    IX_SCRATCH(c->ctx, out, 2 * n + 2);
    n = hull_points(n, p, out);
    if (n < 3)
        return IX_ARG_FAIL(c, 0, "all vertices on one line have no hull");
    res = ix__poly_new(c->ctx, 1);
    st = res ? ix__polygon_fill(c->ctx, &res->poly[0], IX_POLYGON, n,
                                (const double(*)[3])out)
             : IX_ENOMEM;
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, res));
    if (res)
        ix__poly_unref(c->ctx, res);
    return st;
}

/* n triangles of points, or one polygon of them, as an object. */
static ix_status ret_corners(ix_call *c, const double (*p)[3], int npolys,
                             int corners, const int *at)
{
    ix_poly *res = ix__poly_new(c->ctx, npolys);
    ix_status st = res ? IX_OK : IX_ENOMEM;
    double(*v)[3];

    if (res) {
        v = ix__scratch(c->ctx, (size_t)corners, sizeof *v);
        st = v ? IX_OK : IX_ENOMEM;
    }
    for (int i = 0; st == IX_OK && i < npolys; i++) {
        for (int k = 0; k < corners; k++)
            memcpy(v[k], p[at[i * corners + k]], sizeof *v);
        st = ix__polygon_fill(c->ctx, &res->poly[i], IX_POLYGON, corners,
                              (const double(*)[3])v);
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, res));
    if (res)
        ix__poly_unref(c->ctx, res);
    return st;
}

/* Points of a plane with the unit normal n: one polygon around that normal. */
static ix_status flat_hull(ix_call *c, int n, const double (*p)[3],
                           const double normal[3])
{
    double(*flat)[3], (*out)[3], e[2][3];
    int *at;

    ix__perp3(normal, e[0]);
    ix__cross3(normal, e[0], e[1]);
    IX_SCRATCH(c->ctx, flat, n);
    IX_SCRATCH(c->ctx, out, 2 * n + 2);
    IX_SCRATCH(c->ctx, at, 2 * n + 2);
    for (int i = 0; i < n; i++) {
        flat[i][0] = ix__dot3(p[i], e[0]);
        flat[i][1] = ix__dot3(p[i], e[1]);
        flat[i][2] = i; /* which it is */
    }
    n = hull_points(n, flat, out);
    for (int i = 0; i < n; i++)
        at[i] = (int)out[i][2];
    return ret_corners(c, p, 1, n, at);
}

/* Triangles around points of the surface that leave it out by size / 4 f^2 at
 * most: chords of 1 / f of the size on a circle of that diameter. */
static ix_status surface_hull(ix_call *c, const ix_mv *s)
{
    double f = ix__arg_num(c, 1), normal[3];
    double lo[IX_MAX_COORDS] = {0}, hi[IX_MAX_COORDS] = {0};
    double(*xyz)[3];
    int nf, (*face)[3];
    const double(*p)[3];
    ix_status st;
    ix__mesh m;

    if (!(f >= 1))
        return IX_ARG_FAIL(c, 1,
                           "a fineness of %g; the number of chords across a "
                           "surface is 1 or more",
                           f);
    IX_TRY(ix_mv_bbox(c->ctx, s, lo, hi));
    IX_TRY(ix__mesh_of_srf(c->ctx, s, ix__dist3(lo, hi) / (4 * f * f), &m));
    xyz = (double(*)[3])(void *)m.xyz;
    p = (const double(*)[3])xyz;
    st = ix__hull3(c->ctx, (int)m.nverts, p, &nf, &face, normal);
    if (st == IX_OK)
        st = nf ? ret_corners(c, p, nf, 3, (const int *)face)
                : flat_hull(c, (int)m.nverts, p, normal);
    ix__mesh_free(c->ctx, &m);
    return st;
}

static ix_status cnvxhull(ix_call *c)
{
    ix_mv *m;

    if (c->argv[0]->type == IX_OBJ_SURFACE)
        return surface_hull(c, ix__arg_mv(c, 0));

    if (c->argv[0]->type == IX_OBJ_POLY)
        return poly_hull(c);
    IX_TRY(ix_crv_hull(c->ctx, ix__arg_mv(c, 0), &m));
    return ix__ret_mv(c, 0, m);
}

/* --- pairs of tangents ---------------------------------------------------- */

/* One polyline as an object at the end of the list. */
static ix_status add_line(ix_call *c, ix_obj *list, int n, const double (*p)[3])
{
    ix_poly *line = ix__poly_new(c->ctx, 1);
    ix_status st = line ? ix__polygon_fill(c->ctx, &line->poly[0], IX_POLYLINE,
                                           n, p)
                        : IX_ENOMEM;

    if (st == IX_OK)
        return ix__list_add(c->ctx, list, ix__obj_poly(c->ctx, line));
    if (line)
        ix__poly_unref(c->ctx, line);
    return st;
}

static ix_status add_diagonal(ix_call *c, ix_obj *list, int n)
{
    double dom[2], (*p)[3];

    IX_SCRATCH(c->ctx, p, n);
    ix_mv_domain(ix__arg_mv(c, 0), 0, dom);
    for (int i = 0; i < n; i++) {
        p[i][0] = p[i][1] = dom[0] + (dom[1] - dom[0]) * i / (n - 1);
        p[i][2] = 0;
    }
    return add_line(c, list, n, (const double(*)[3])p);
}

static ix_status angle_lines(ix_call *c, double theta, double tol, int diag)
{
    ix_obj *list;
    ix_status st;
    ix_lines l;
    int at = 0;

    IX_TRY(ix_crv_angle_pairs(c->ctx, ix__arg_mv(c, 0), theta, tol, &l));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < l.n; at += l.count[i++])
        st = add_line(c, list, l.count[i], (const double(*)[3])(l.pt + at));
    if (st == IX_OK && diag > 1 && fabs(sin(theta)) <= 1e-12)
        st = add_diagonal(c, list, diag);
    ix_lines_free(c->ctx, &l);
    return ix__ret_list(c, list, st);
}

static ix_status canglemap(ix_call *c)
{
    double tol = ix__arg_num(c, 1), theta = IX__RADIANS(ix__arg_num(c, 2));
    int diag;
    ix_mv *f;

    IX_TRY(ix__arg_int(c, 3, 0, 1 << 20, &diag));
    if (tol < 0) {
        IX_TRY(ix_crv_angle_field(c->ctx, ix__arg_mv(c, 0), theta, &f));
        return ix__ret_mv(c, -1, f);
    }
    if (!(tol > 0))
        return IX_ARG_FAIL(c, 1,
                           "a tolerance of 0; samples of a turn (1 or "
                           "more) or a distance are wanted");
    /* tol of 1 and more is a number of samples, as that of RESOLUTION */
    return angle_lines(c, theta, tol >= 1 ? 1 / (8 * tol * tol) : tol,
                       diag == 1 ? 2 : diag);
}

/* --- a polygon -------------------------------------------------------------
 */

static ix_status circpoly(ix_call *c)
{
    int n = (int)fmin(fmax(ix__var_num(c->in, "RESOLUTION", 20), 4), 1000);
    double normal[3], center[3], r = ix__arg_num(c, 2), turned[16], (*p)[3];
    static const double z[3] = {0, 0, 1};
    ix_poly *out;
    ix_status st;

    IX_TRY(ix__arg_vec3(c, 0, normal));
    IX_TRY(ix__arg_vec3(c, 1, center));
    if (!(r > 0))
        return IX_ARG_FAIL(c, 2, "a radius of %g; it must be positive", r);
    IX_TRY(ix__mat_turn(c->ctx, z, normal, turned));
    IX_SCRATCH(c->ctx, p, n);
    for (int i = 0; i < n; i++) {
        double s, co;

        ix__sincos_deg(360.0 * i / n, &s, &co);
        const double q[3] = {r * co, r * s, 0};
        (void)ix__mat_point(q, turned, p[i]);
        for (int k = 0; k < 3; k++)
            p[i][k] += center[k];
    }
    out = ix__poly_new(c->ctx, 1);
    st = out ? ix__polygon_fill(c->ctx, &out->poly[0], IX_POLYGON, n,
                                (const double(*)[3])p)
             : IX_ENOMEM;
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, out));
    if (out)
        ix__poly_unref(c->ctx, out);
    return st;
}

#define LOOP                                                            \
    "c = cbspline(3, list(ctlpt(E2,0,0), ctlpt(E2,2,0), ctlpt(E2,1,1)," \
    " ctlpt(E2,2,2), ctlpt(E2,0,2)), list(KV_PERIODIC)); "

const ix_builtin ix__builtins_visible[] = {
    {"CVIEWMAP", "c:curve viewCrv:curve subdiv:num numer:num trim:bool -> poly",
     "Silhouettes of a planar curve for all directions of view, those that the "
     "positions of viewCrv are (towards the viewer), and their shadows: "
     "polylines (t, v, r), first with r = t where the tangent at c(t) has the "
     "direction viewCrv(v), then where that line of sight meets the curve "
     "again "
     "at c(r). With trim only silhouettes that nothing hides and the first "
     "place "
     "behind them; no value if there is none. subdiv and numer are not needed.",
     "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,2,-2), "
     "ctlpt(E2,3,1))); o = cviewmap(c, pcircle(vector(0,0,0), 1), 0.05, 1e-5, "
     "0);",
     cviewmap, 0, 9},
    {"SVISIBLE", "s:surface resolution:num coneDeg:num -> list",
     "Few directions such that every normal (as SNORMAL) is within coneDeg "
     "degrees of one of them, and the parts where it is: trimmed surfaces with "
     "attribute ViewDir, which cover s and overlap. The domain is cut into "
     "about resolution x resolution cells first, then further as its normals "
     "need it.",
     "s = spheresrf(1); l = svisible(s, 4, 60);", svisible, 0, 13},
    {"CVISIBLE", "c:curve view:pt3 eps:num -> list",
     "The parts of a planar curve that nothing of it hides from the viewer at "
     "view = (x, y, 1), or from far away where view = (x, y, 0) points to, on "
     "their parameter intervals, in the order of the curve. Straight parts "
     "along the line of sight are not seen; eps is not needed.",
     LOOP "l = cvisible(c, vector(1, 0, 0), 1e-5);", cvisible, 0, 9},
    {"CANGLEMAP", "c:curve tol:num angle:num diag:num -> surface|list",
     "Where the tangent lines at parameters t and r of a planar curve make an "
     "angle (degrees): a list of polylines (t, r, 0), tol being a number of "
     "samples of a turn (1 or more) or a distance as a part of the domain; "
     "with tol < 0 the scalar surface that vanishes there. For angle 0, diag "
     "adds the trivial pairs t = r with so many samples.",
     "l = canglemap(circle(vector(0, 0, 0), 1), 20, 60, false);", canglemap, 0,
     9},
    {"CNVXHULL", "x:curve|surface|poly fineness:num -> curve|poly",
     "The convex hull in the XY plane, counter-clockwise: of a closed curve "
     "one B-spline of arcs of it and straight bridges, of all vertices of "
     "polygons one polygon. Of a surface its hull in space, as triangles "
     "between points of it (of a flat one, one polygon) that leave out 1 / (4 "
     "fineness^2) of its size at most.",
     LOOP "h = cnvxhull(c, 10); b = cnvxhull(spheresrf(1), 10);", cnvxhull, 0,
     10},
    {"CIRCPOLY", "normal:pv center:pv r:num -> poly",
     "A regular polygon of RESOLUTION vertices on a circle, "
     "counter-clockwise around normal.",
     "p = circpoly(vector(0, 0, 1), vector(1, 2, 3), 0.5);", circpoly, 0, 24},
    {0}};
