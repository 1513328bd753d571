/* builtins_mbisect.c - bisectors by equations: MBISECTOR, MTRISECTOR, SKEL2DINT
 * (chapter 21 of spec/functions). */
#include <math.h>
#include <string.h>

#include "iritx/ops_mbisect.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"

/* --- MBISECTOR ---------------------------------------------------------------
 */

/* The rational bisector: of two curves in space that of CBISECTOR3D. */
static ix_status exact(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0), *b = ix__arg_mv(c, 1);
    ix_mv *m;

    if (a->ndirs == 1 && b->ndirs == 1)
        IX_TRY(ix_cbisector3d(c->ctx, a, b, NULL, NULL, &m));
    else
        IX_TRY(ix_mbisector_exact(c->ctx, a, b, &m));
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_MULTIVAR, m));
}

/* The equations, linked in one object. */
static ix_status equations(ix_call *c)
{
    ix_mv *f[2];
    const ix_mvs *both;
    const ix_mv *list[2];
    int n;

    IX_TRY(
        ix_mbisector_fields(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), f, &n));
    for (int i = 0; i < n; i++)
        list[i] = f[i];
    both = ix__mvs_new(c->ctx, n, list);
    for (int i = 0; i < n; i++)
        ix_mv_unref(c->ctx, f[i]);
    if (!both)
        return IX_ENOMEM;
    return ix__ret(c, ix__obj_mvs(c->ctx, IX_OBJ_MULTIVAR, both));
}

static ix_obj *point_object(ix_ctx *ctx, const ix_bisector_point *p, int type)
{
    ix_ctlpt q = {.ncoords = 5, .rational = false};

    if (type == 2)
        return ix__obj_point(ctx, p->x);
    memcpy(q.v, p->uv, sizeof p->uv);
    memcpy(q.v + 2, p->x, sizeof p->x);
    return ix__obj_ctlpt(ctx, &q);
}

static ix_status point_list(ix_call *c, const ix_bisector_point *p, int n,
                            int type)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add(c->ctx, list, point_object(c->ctx, &p[i], type));
    return ix__ret_list(c, list, st);
}

/* Grid node of a point, in steps of 1 / n. */
static void node_of(const ix_mv *srf, int n, const ix_bisector_point *p,
                    int out[2])
{
    for (int k = 0; k < 2; k++) {
        double dom[2];

        ix_mv_domain(srf, k, dom);
        out[k] = (int)lround((p->uv[k] - dom[0]) / (dom[1] - dom[0]) * n);
    }
}

/* Cells over whose four corners there are as many sheets: a quadrangle each. */
static ix_status quadrangles(ix_call *c, const ix_mv *srf, int n,
                             const ix_bisector_point *p, int count)
{
    int *first, *sheets, nodes = (n + 1) * (n + 1), total = 0;
    ix_lines l = {.n = 0};
    int at[2];

    IX_SCRATCH(c->ctx, first, nodes);
    IX_SCRATCH(c->ctx, sheets, nodes);
    memset(sheets, 0, (size_t)nodes * sizeof *sheets);
    for (int i = 0; i < count; i++) {
        node_of(srf, n, &p[i], at);
        if (sheets[at[1] * (n + 1) + at[0]]++ == 0)
            first[at[1] * (n + 1) + at[0]] = i;
    }
    IX_SCRATCH(c->ctx, l.count, count + 1);
    IX_SCRATCH(c->ctx, l.pt, 4 * (size_t)count + 4);
    for (int i = 0; i < n * n; i++) {
        int a = i / n * (n + 1) + i % n;
        const int corner[4] = {a, a + 1, a + n + 2, a + n + 1};
        bool same = true;

        for (int k = 1; k < 4; k++)
            same = same && sheets[corner[k]] == sheets[a];
        for (int s = 0; same && s < sheets[a]; s++) {
            for (int k = 0; k < 4; k++)
                memcpy(l.pt[total++], p[first[corner[k]] + s].x,
                       sizeof l.pt[0]);
            l.count[l.n++] = 4;
        }
    }
    return l.n > 0 ? ix__ret_lines(c, &l, IX_POLYGON) : IX_OK;
}

static ix_status sampled(ix_call *c, int type, double step)
{
    const ix_mv *a = ix__arg_mv(c, 0), *b = ix__arg_mv(c, 1);
    int n = step >= 1.0 ? 1 : (int)ceil(1.0 / step), count;
    ix_bisector_point *p;
    ix_status st;

    n = n > 256 ? 256 : n;
    IX_TRY(ix_mbisector_points(c->ctx, a, b, n, &p, &count));
    if (count == 0)
        st = IX_OK; /* no value */
    else if (type == 4)
        st = quadrangles(c, a->ndirs == 2 ? a : b, n, p, count);
    else
        st = point_list(c, p, count, type);
    ix_bisector_points_free(c->ctx, p, count);
    return st;
}

static ix_status mbisector(ix_call *c)
{
    double step = ix__arg_num(c, 3);
    int type;

    IX_TRY(ix__arg_int(c, 2, 1, 4, &type));
    if (!(step >= 0.0))
        return IX_ARG_FAIL(c, 3, "a step of %g must not be negative", step);
    if (step == 0.0)
        return exact(c);
    return type == 1 ? equations(c) : sampled(c, type, step);
}

/* --- MTRISECTOR --------------------------------------------------------------
 */

/* A point as a curve of order 1; else the operand itself. */
static ix_status operand_of(ix_call *c, int i, ix_mv **out)
{
    static const ix_dir d = {IX_BEZIER, 1, 1, false, NULL};
    const ix_mv *m = ix__obj_first_mv(c->argv[i]);
    double p[3];

    if (m) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix__arg_pt3(c, i, p));
    return ix_mv_new(c->ctx, 1, &d, 3, false, p, out);
}

static ix_status trisector(ix_call *c, const ix_mv *const m[3],
                           const double box[6], double step)
{
    bool complete;
    ix_status st;
    ix_lines l;

    IX_TRY(ix_trisector(c->ctx, m, step * step, box, &l, &complete));
    if (!complete)
        ix__remark(c->in, "the search was stopped: curves may be missing");
    st = l.n > 0 ? ix__ret_lines(c, &l, IX_POLYLINE) : IX_OK;
    ix_lines_free(c->ctx, &l);
    return st;
}

static ix_status mtrisector(ix_call *c)
{
    ix_mv *m[3] = {NULL, NULL, NULL};
    double step = ix__arg_num(c, 3), box[6];
    ix_status st = IX_OK;

    if (!(step > 0.0))
        return IX_ARG_FAIL(c, 3, "a step of %g must be positive", step);
    IX_TRY(ix__arg_vec3(c, 6, box));
    IX_TRY(ix__arg_vec3(c, 7, box + 3));
    for (int i = 0; i < 3 && st == IX_OK; i++)
        st = operand_of(c, i, &m[i]);
    if (st == IX_OK)
        st = trisector(c, (const ix_mv *const *)m, box, step);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(c->ctx, m[i]);
    return st;
}

/* --- SKEL2DINT ---------------------------------------------------------------
 */

/* A point with the feet as attributes. */
static ix_obj *skeleton_object(ix_ctx *ctx, const ix_skeleton_point *p)
{
    static const char *const names[3] = {"Prim1Pos", "Prim2Pos", "Prim3Pos"};
    double x[3] = {p->center[0], p->center[1], 0};
    ix_obj *o = ix__obj_point(ctx, x), *foot;

    for (int i = 0; o && i < 3; i++) {
        double f[3] = {p->foot[i][0], p->foot[i][1], 0};
        ix_status st = IX_ENOMEM;

        foot = ix__obj_point(ctx, f);
        if (foot)
            st = ix__attr_set_obj(ctx, &o->attrs, names[i], foot);
        ix__obj_unref(ctx, foot);
        if (st != IX_OK) {
            ix__obj_unref(ctx, o);
            return NULL;
        }
    }
    return o;
}

static ix_status skel2dint(ix_call *c)
{
    const ix_mv *m[3] = {NULL, NULL, NULL};
    double q[3][2] = {{0}}, p[3];
    ix_skeleton_point *s;
    ix_obj *list;
    ix_status st;
    bool complete;
    int n;

    for (int i = 0; i < 3; i++) {
        m[i] = ix__obj_first_mv(c->argv[i]);
        if (m[i])
            continue;
        IX_TRY(ix__arg_pt3(c, i, p));
        memcpy(q[i], p, sizeof q[i]);
    }
    IX_TRY(ix_skeleton_points(c->ctx, m, (const double(*)[2])q,
                              ix__arg_num(c, 3), ix__arg_num(c, 4), &s, &n,
                              &complete));
    if (!complete)
        ix__remark(c->in, "the search was stopped: points may be missing");
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add(c->ctx, list, skeleton_object(c->ctx, &s[i]));
    ix_skeleton_points_free(c->ctx, s, n);
    return ix__ret_list(c, list, st);
}

/* --- SKELNDINT ---------------------------------------------------------------
 */

/* The coordinates of a point among the operands, dim of them. */
static ix_status point_coords(ix_call *c, int i, const ix_obj *o, int dim,
                              double *q)
{
    int n = o->type == IX_OBJ_CTLPT ? o->u.ctlpt->ncoords : 3;

    if (o->type != IX_OBJ_CTLPT && o->type != IX_OBJ_POINT &&
        o->type != IX_OBJ_VECTOR)
        return ix__wrong_element(c, 0, i, o, "a point, curve or surface");
    if (n < dim)
        return IX_ARG_FAIL(c, 0, "element %d has %d coordinates: %d are needed",
                           i + 1, n, dim);
    for (int k = 0; k < dim; k++)
        q[k] = o->type != IX_OBJ_CTLPT ? o->u.pt[k]
               : o->u.ctlpt->rational  ? o->u.ctlpt->v[k + 1] / o->u.ctlpt->v[0]
                                       : o->u.ctlpt->v[k];
    return IX_OK;
}

/* A control point with the radius, and the feet's parameters. */
static ix_obj *centre_object(ix_ctx *ctx, const ix_centre *p, int dim)
{
    ix_ctlpt q = {.ncoords = dim};
    ix_obj *o;

    memcpy(q.v, p->x, (size_t)dim * sizeof *q.v);
    o = ix__obj_ctlpt(ctx, &q);
    if (o && ix__attr_set_real(ctx, &o->attrs, "radius", p->radius) == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status skelndint(ix_call *c)
{
    const ix_list *l = &c->argv[0]->u.list;
    const ix_mv *m[IX_CENTRE_OBJECTS] = {NULL};
    double q[IX_CENTRE_OBJECTS * IX_CENTRE_OBJECTS];
    ix_centre *p;
    ix_obj *list;
    bool complete;
    ix_status st;
    int n;

    if (l->n < 3 || l->n > IX_CENTRE_OBJECTS)
        return IX_ARG_FAIL(c, 0, "3 to %d objects are needed, got %d",
                           IX_CENTRE_OBJECTS, l->n);
    for (int i = 0; i < l->n; i++) {
        m[i] = ix__obj_first_mv(l->item[i]);
        if (!m[i])
            IX_TRY(
                point_coords(c, i, l->item[i], l->n - 1, q + i * (l->n - 1)));
    }
    IX_TRY(ix_equidistant_centres(c->ctx, l->n, m, q, &p, &n, &complete));
    if (!complete)
        ix__remark(c->in, "the search was stopped: centres may be missing");
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add(c->ctx, list, centre_object(c->ctx, &p[i], l->n - 1));
    ix_centres_free(c->ctx, p, n);
    return ix__ret_list(c, list, st);
}

/* --- table -------------------------------------------------------------------
 */

#define SURFACE                                                              \
    "s = sbezier(list(list(point(0,0,0), point(1,0,0.2)), list(point(0,1,0)" \
    ", point(1,1,0.5)))); "

const ix_builtin ix__builtins_mbisect[] = {
    {"MBISECTOR",
     "a:curve|surface|mv b:curve|surface|mv type:num step:num numer:num -> any",
     "Bisector in space of a curve and a surface, or two surfaces: 1 the "
     "equations between their parameters, linked in one object, 2 points, 3 "
     "control points (u, v, x, y, z), 4 polygons, over a grid on the surface "
     "of "
     "that step (of the domain). Step 0: the rational bisector of two curves "
     "in "
     "R^3, curve and surface in R^4, two surfaces in R^5.",
     SURFACE "c = cbezier(list(point(0,0,2), point(1,1,3))); l = mbisector(s, "
             "c, 2, 0.25, 1e-8);",
     mbisector, IX_B_SOFT, 21},
    {"MTRISECTOR",
     "a:pt3|curve|surface|mv b:pt3|curve|surface|mv c:pt3|curve|surface|mv "
     "step:num subdiv:num numer:num lo:vector|point hi:vector|point -> poly",
     "The curves equally far, along normals, from three points, curves and "
     "surfaces in any combination, as polylines within the box from lo to hi; "
     "step is that of the polylines in the parameters. No value if there are "
     "none.",
     "a = cbezier(list(point(0,0,-1), point(0,0,1))); b = cbezier(list(point("
     "2,-1,0), point(2,1,0.5))); c = cbezier(list(point(0,2,0), point(1,2,1)));"
     " o = mtrisector(a, b, c, 0.05, 0.1, 1e-6, vector(-3,-3,-3), "
     "vector(3,3,3));",
     mtrisector, IX_B_SOFT, 21},
    {"SKEL2DINT",
     "a:pt3|curve b:pt3|curve c:pt3|curve extent:num eps:num fineness:num "
     "tols:list -> list",
     "The points of the plane equally far, along normals, from three points "
     "and "
     "curves, within extent of the origin and with distances that differ by at "
     "most eps; attributes Prim1Pos .. Prim3Pos are the feet.",
     "l = skel2dint(point(0,0,0), point(2,0,0), point(0,2,0), 10, 0.1, 100, "
     "list(1e-3, -1e-9));",
     skel2dint, 0, 21},
    {"SKELNDINT", "objects:list subdiv:num numer:num exprTrees:bool -> list",
     "The points of R^n equally far, along normals, from n + 1 points, curves "
     "and surfaces with n coordinates (2 to 5): control points with the "
     "attribute radius. The tolerances are not needed.",
     "a = cbezier(list(ctlpt(E2,-2,-1), ctlpt(E2,0,-2), ctlpt(E2,2,-1))); b = "
     "cbezier(list(ctlpt(E2,-2,1), ctlpt(E2,2,2))); l = skelndint(list(a, b, "
     "point(3,0,0)), 0.1, 1e-6, false);",
     skelndint, 0, 21},
    {0}};
