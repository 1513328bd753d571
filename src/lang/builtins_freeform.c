/* builtins_freeform.c - questions that all freeforms answer: domains, orders,
 * knots, control points, bounds, coordinates apart and together (chapter 10
 * of spec/functions). Nothing here changes its arguments. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"

/* The map of a freeform or the surface under a trimmed one. */
static const ix_mv *shape(const ix_call *c, int i)
{
    const ix_obj *o = c->argv[i];

    return o->type == IX_OBJ_TRIMSRF ? o->u.trim.item[0]->srf
                                     : ix__arg_mv(c, i);
}

/* --- domains, sizes, types --------------------------------------------- */

static ix_status pdomain(ix_call *c)
{
    static const double barycentric[6] = {0, 1, 0, 1, 0, 1};
    double dom[2 * IX_MAX_DIRS];
    const ix_mv *m;

    if (c->argv[0]->type == IX_OBJ_TRISRF)
        return ix__ret_nums(c, 6, barycentric);
    m = shape(c, 0);
    for (int d = 0; d < m->ndirs; d++)
        ix_mv_domain(m, d, dom + 2 * d);
    return ix__ret_nums(c, 2 * m->ndirs, dom);
}

static ix_status fforder(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double v[IX_MAX_DIRS];

    for (int d = 0; d < m->ndirs; d++)
        v[d] = m->dirs[d].order;
    return ix__ret_nums(c, m->ndirs, v);
}

static ix_status ffmsize(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double v[IX_MAX_DIRS];

    for (int d = 0; d < m->ndirs; d++)
        v[d] = m->dirs[d].length;
    return ix__ret_nums(c, m->ndirs, v);
}

static ix_status meshsize(ix_call *c)
{
    const ix_mv *m;
    int dir;

    if (c->argv[0]->type == IX_OBJ_TRISRF)
        return ix__ret_num(c, c->argv[0]->u.tri.item[0]->length);
    m = shape(c, 0);
    IX_TRY(ix__arg_dir(c, 1, m->ndirs, &dir));
    return ix__ret_num(c, m->dirs[dir].length);
}

static ix_status ffpttype(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);

    return ix__ret_num(c,
                       (m->rational ? IX__P1 : IX__E1) + 2 * (m->ncoords - 1));
}

static ix_status ffgtype(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    int type = IX__BEZIER_TYPE;

    for (int d = 0; d < m->ndirs; d++)
        if (m->dirs[d].basis == IX_POWER)
            type = IX__POWER_TYPE;
        else if (m->dirs[d].basis == IX_BSPLINE)
            return ix__ret_num(c, IX__BSPLINE_TYPE);
    return ix__ret_num(c, type);
}

static ix_status ffpoles(ix_call *c)
{
    return ix__ret_num(c, ix_mv_has_poles(ix__arg_mv(c, 0)));
}

/* --- knots and control points ------------------------------------------ */

static ix_status add_knots(ix_ctx *ctx, ix_obj *list, const ix_dir *dir)
{
    ix_obj *kv = ix__obj_list(ctx);
    ix_status st = IX_OK;

    for (int i = 0; i < ix_knots_count(dir) && st == IX_OK; i++)
        st = ix__list_add_num(ctx, kv, dir->knots[i]);
    if (st == IX_OK)
        return ix__list_add(ctx, list, kv);
    ix__obj_unref(ctx, kv);
    return st;
}

static ix_status ffkntvec(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_status st = IX_OK;
    ix_obj *list;

    for (int d = 0; d < m->ndirs; d++)
        if (m->dirs[d].basis != IX_BSPLINE)
            return IX_ARG_FAIL(c, 0,
                               "a Bezier or power basis freeform has no "
                               "knot vectors");
    list = ix__obj_list(c->ctx);
    for (int d = 0; d < m->ndirs && st == IX_OK; d++)
        st = add_knots(c->ctx, list, &m->dirs[d]);
    return ix__ret_list(c, list, st);
}

static ix_obj *point_box(ix_ctx *ctx, const ix_mv *m, size_t i)
{
    ix_ctlpt p = {.ncoords = m->ncoords, .rational = m->rational};

    for (int k = 0; k < m->naxes; k++)
        p.v[k] = ix_mv_axis(m, k)[i];
    return ix__obj_ctlpt(ctx, &p);
}

static ix_status ffctlpts(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = IX_OK;

    for (size_t i = 0; i < m->npts && st == IX_OK; i++)
        st = ix__list_add(c->ctx, list, point_box(c->ctx, m, i));
    return ix__ret_list(c, list, st);
}

/* Euclidean position; a weight of zero counts as 1e-14 (spec/model 4). */
static void euclidean(const ix_mv *m, size_t i, double p[3])
{
    double w = m->rational ? ix_mv_weights(m)[i] : 1;

    for (int k = 0; k < 3; k++)
        p[k] = k < m->ncoords ? ix_mv_coord(m, k)[i] / (w != 0 ? w : 1e-14) : 0;
}

/* One polyline for each row of control points in direction dir. */
static ix_status mesh_rows(ix_ctx *ctx, const ix_mv *m, int dir, ix_polygon *pg)
{
    size_t stride = ix__mv_stride(m, dir);
    int length = m->dirs[dir].length;

    for (size_t i = 0; i < m->npts; i++) {
        if (i / stride % (size_t)length != 0)
            continue;
        IX_TRY(ix__poly_vertices(ctx, pg, length));
        pg->kind = IX_POLYLINE;
        for (int k = 0; k < length; k++)
            euclidean(m, i + (size_t)k * stride, pg->v[k].p);
        pg++;
    }
    return IX_OK;
}

static ix_status ffmesh(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    size_t total = 0, at = 0;
    ix_poly *p;

    for (int d = 0; d < m->ndirs; d++)
        total += m->npts / (size_t)m->dirs[d].length;
    if (total > INT_MAX)
        return IX_ARG_FAIL(c, 0, "%zu mesh lines are too many", total);
    p = ix__poly_new(c->ctx, (int)total);
    if (!p)
        return IX_ENOMEM;
    for (int d = 0; d < m->ndirs; d++) {
        ix_status st = mesh_rows(c->ctx, m, d, p->poly + at);

        if (st != IX_OK) {
            ix__poly_unref(c->ctx, p);
            return st;
        }
        at += m->npts / (size_t)m->dirs[d].length;
    }
    return ix__ret(c, ix__obj_poly(c->ctx, p));
}

static ix_status ffextreme(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

    c->bad_arg = 1;
    IX_TRY(ix_mv_bbox(c->ctx, m, lo, hi));
    c->bad_arg = 0;
    return ix__ret_ctlpt(c, m->ncoords, false, ix__arg_bool(c, 1) ? lo : hi);
}

/* --- coordinates apart and together ------------------------------------ */

static ix_status ffsplit(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_obj_type type = c->argv[0]->type;
    int n = m->naxes, most = m->rational ? 4 : 3;
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = IX_OK;

    if (type != IX_OBJ_MULTIVAR && n > most)
        n = most;
    for (int k = 0; k < n && st == IX_OK; k++) {
        ix_mv *s = NULL;

        st = ix_mv_scalar(c->ctx, m, k, &s);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, ix__obj_mv(c->ctx, type, s));
    }
    return ix__ret_list(c, list, st);
}

static ix_status ffmerge(ix_call *c)
{
    int n, ncoords;
    const ix_mv **m;
    bool rational;
    ix_mv *out;

    IX_TRY(ix__arg_pttype(c, 1, &ncoords, &rational));
    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_UNDEF, &n, &m));
    if (n != ncoords + rational)
        return IX_ARG_FAIL(c, 0, "%d scalars, %c%d takes %d", n,
                           rational ? 'P' : 'E', ncoords, ncoords + rational);
    for (int k = 0; k < n; k++)
        if (m[k]->naxes != 1)
            return IX_ARG_FAIL(c, 0, "element %d is of type %c%d, not E1",
                               k + 1, m[k]->rational ? 'P' : 'E',
                               m[k]->ncoords);
    c->bad_arg = 1;
    IX_TRY(ix_mv_join_scalars(c->ctx, n, m, rational, &out));
    c->bad_arg = 0;
    return ix__ret(c,
                   ix__obj_mv(c->ctx, c->argv[0]->u.list.item[0]->type, out));
}

/* --- blossoms ---------------------------------------------------------- */

/* The order - 1 numbers of direction d. */
static ix_status blossom_args(ix_call *c, const ix_obj *list, const ix_mv *m,
                              int d, double *out)
{
    int n = m->dirs[d].order - 1;

    if (list->type != IX_OBJ_LIST || list->u.list.n != n)
        return IX_ARG_FAIL(c, 1, "direction %d needs a list of %d parameters",
                           d + 1, n);
    for (int i = 0; i < n; i++) {
        const ix_obj *o = list->u.list.item[i];

        if (o->type != IX_OBJ_NUMBER || !isfinite(o->u.num))
            return IX_ARG_FAIL(c, 1,
                               "parameter %d of direction %d is no "
                               "finite number",
                               i + 1, d + 1);
        out[i] = o->u.num;
    }
    return IX_OK;
}

static ix_status blossom(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    const ix_obj *list = c->argv[1];
    const double *args[2] = {NULL, NULL};
    double v[IX_MAX_COORDS + 1];

    if (m->ndirs == 2 && list->u.list.n != 2)
        return IX_ARG_FAIL(c, 1, "a surface needs two lists of parameters");
    for (int d = 0; d < m->ndirs; d++) {
        double *a;

        IX_SCRATCH(c->ctx, a, m->dirs[d].order);
        IX_TRY(blossom_args(c, m->ndirs == 2 ? list->u.list.item[d] : list, m,
                            d, a));
        args[d] = a;
    }
    IX_TRY(ix_mv_blossom(c->ctx, m, args, v));
    return ix__ret_ctlpt(c, m->ncoords, m->rational, v);
}

/* --- boundaries -------------------------------------------------------- */

/* Both ends of all directions: 4 curves or 6 surfaces. */
static ix_status shape_boundary(ix_call *c, const ix_mv *m)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = IX_OK;

    for (int e = 0; e < 2 * m->ndirs && st == IX_OK; e++) {
        ix_mv *side = NULL;
        double dom[2];

        ix_mv_domain(m, e / 2, dom);
        st = ix_mv_fix(c->ctx, m, e / 2, dom[e % 2], &side);
        if (st == IX_OK)
            st = ix__list_add(
                c->ctx, list,
                ix__obj_mv(c->ctx, ix__obj_type_of_mv(side), side));
    }
    return ix__ret_list(c, list, st);
}

typedef struct {
    const double *a, *b;
    double key; /* a.x + b.x: nearly equal for equal edges */
    size_t index;
    bool shared;
} edge;

/* The reference's tolerance for the identity of points (spec/model 2). */
#define SAME_POINT 1e-6

static bool same_point(const double *p, const double *q)
{
    return fabs(p[0] - q[0]) < SAME_POINT && fabs(p[1] - q[1]) < SAME_POINT &&
           fabs(p[2] - q[2]) < SAME_POINT;
}

static bool same_edge(const edge *e, const edge *f)
{
    return (same_point(e->a, f->a) && same_point(e->b, f->b)) ||
           (same_point(e->a, f->b) && same_point(e->b, f->a));
}

static int by_key(const void *p, const void *q)
{
    const edge *e = p, *f = q;

    if (e->key != f->key)
        return e->key < f->key ? -1 : 1;
    return e->index < f->index ? -1 : 1;
}

static int by_index(const void *p, const void *q)
{
    const edge *e = p, *f = q;

    return e->index < f->index ? -1 : e->index > f->index;
}

/* Pairs equal edges; equal ones have keys within twice the tolerance. */
static void pair_edges(size_t n, edge *e)
{
    qsort(e, n, sizeof *e, by_key);
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1;
             j < n && !e[i].shared && e[j].key - e[i].key < 2 * SAME_POINT; j++)
            if (!e[j].shared && same_edge(&e[i], &e[j]))
                e[i].shared = e[j].shared = true;
    qsort(e, n, sizeof *e, by_index);
}

/* Edges of polygons that are not shared by pairs; in scratch. */
static ix_status free_edges(ix_ctx *ctx, const ix_poly *p, size_t *n,
                            edge **out)
{
    size_t total = 0, m = 0;
    edge *e;

    for (int i = 0; i < p->n; i++)
        total += (size_t)p->poly[i].n;
    IX_SCRATCH(ctx, e, total);
    total = 0;
    for (int i = 0; i < p->n; i++)
        for (int k = 0; k < p->poly[i].n; k++, total++) {
            const double *a = p->poly[i].v[k].p;
            const double *b = p->poly[i].v[(k + 1) % p->poly[i].n].p;

            e[total] = (edge){a, b, a[0] + b[0], total, false};
        }
    pair_edges(total, e);
    for (size_t i = 0; i < total; i++)
        if (!e[i].shared)
            e[m++] = e[i];
    *n = m;
    *out = e;
    return IX_OK;
}

static ix_status poly_boundary(ix_call *c, const ix_poly *p)
{
    ix_poly *out;
    size_t n;
    edge *e;

    IX_TRY(free_edges(c->ctx, p, &n, &e));
    if (n > INT_MAX)
        return IX_ARG_FAIL(c, 0, "%zu boundary edges are too many", n);
    out = ix__poly_new(c->ctx, (int)n);
    if (!out)
        return IX_ENOMEM;
    for (size_t i = 0; i < n; i++) {
        if (ix__poly_vertices(c->ctx, &out->poly[i], 2) != IX_OK) {
            ix__poly_unref(c->ctx, out);
            return IX_ENOMEM;
        }
        out->poly[i].kind = IX_POLYLINE;
        memcpy(out->poly[i].v[0].p, e[i].a, 3 * sizeof(double));
        memcpy(out->poly[i].v[1].p, e[i].b, 3 * sizeof(double));
    }
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

static ix_status boundary(ix_call *c)
{
    const ix_obj *o = c->argv[0];

    if (o->type == IX_OBJ_POLY)
        return poly_boundary(c, o->u.poly);
    if (o->type == IX_OBJ_TRIMSRF)
        return ix__ret_trim_curves(c, o->u.trim.item[0], false);
    return shape_boundary(c, ix__arg_mv(c, 0));
}

/* --- sampling, similarity ---------------------------------------------- */

static ix_status ffptdist(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_obj *list;
    ix_status st = IX_OK;
    double *t;
    int n;

    IX_TRY(ix__arg_int(c, 2, 0, 10000000, &n));
    IX_SCRATCH(c->ctx, t, (size_t)m->ndirs * (size_t)n);
    IX_TRY(ix_spread(c->ctx, m, !ix__arg_bool(c, 1), n,
                     &ix__states(c->in)->random, t));
    list = ix__obj_list(c->ctx);
    for (int i = 0; i < n && st == IX_OK; i++) {
        double p[3] = {t[i], m->ndirs > 1 ? t[n + i] : 0, 0};

        st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, p));
    }
    return ix__ret_list(c, list, st);
}

static ix_status ffrigidsim(ix_call *c)
{
    double p[3] = {0, 0, 0};
    ix_similarity s;
    ix_obj *list;
    ix_status st;
    bool found;

    IX_TRY(ix_similar(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                      ix__arg_num(c, 2), &found, &s));
    if (!found)
        return ix__ret_num(c, 0);
    memcpy(p, s.shift, sizeof s.shift);
    list = ix__obj_list(c->ctx);
    st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, p));
    if (st == IX_OK)
        st = ix__list_add_num(c->ctx, list, s.scale);
    if (st == IX_OK)
        st = ix__list_add_num(c->ctx, list, s.degrees);
    return ix__ret_list(c, list, st);
}

/* --- table ------------------------------------------------------------- */

#define C "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,2,0))); "
#define S                                                       \
    "s = sbezier(list(list(ctlpt(E3,0,0,0), ctlpt(E3,1,0,0)), " \
    "list(ctlpt(E3,0,1,0), ctlpt(E3,1,1,1)))); "

const ix_builtin ix__builtins_freeform[] = {
    {"PDOMAIN", "ff:freeform|trimsrf|trisrf -> list",
     "Ends of the parameter domain of each direction: u0, u1, v0, v1, ...",
     S "l = pdomain(s);", pdomain, 0, 10},
    {"FFMSIZE", "ff:freeform -> list",
     "Number of control points in each direction.", S "l = ffmsize(s);",
     ffmsize, 0, 10},
    {"FFORDER", "ff:freeform -> list", "Order of each direction.",
     S "l = fforder(s);", fforder, 0, 10},
    {"FFCTLPTS", "ff:freeform -> list",
     "All control points, the first direction fastest.", C "l = ffctlpts(c);",
     ffctlpts, 0, 10},
    {"FFMERGE", "scalars:list type:num -> any",
     "The freeform of the given point type whose coordinates are E1 curves, "
     "surfaces or multivariates; for P types the first is the weight.",
     C "d = ffmerge(ffsplit(c), E2);", ffmerge, 0, 10},
    {"FFMESH", "ff:freeform -> poly",
     "Control polygon or control mesh as polylines.", S "o = ffmesh(s);",
     ffmesh, 0, 10},
    {"FFKNTVEC", "ff:freeform -> list",
     "Knot vectors of a B-spline, one list for each direction.",
     "l = ffkntvec(circle(vector(0,0,0), 1));", ffkntvec, 0, 10},
    {"FFSPLIT", "ff:freeform -> list",
     "Coordinates as scalar (E1) freeforms, the weight first; of curves and "
     "surfaces at most W, X, Y, Z.",
     C "l = ffsplit(c);", ffsplit, 0, 10},
    {"FFEXTREME", "ff:freeform min:bool -> ctlpt",
     "Least or largest coordinates of the control points, a bound of the "
     "freeform.",
     C "q = ffextreme(c, true);", ffextreme, 0, 10},
    {"FFPOLES", "ff:freeform -> bool",
     "True if a weight is zero or the weights have both signs.",
     C "b = ffpoles(c);", ffpoles, 0, 10},
    {"FFPTTYPE", "ff:freeform -> num", "The point type, E1 .. P18.",
     C "t = ffpttype(c);", ffpttype, 0, 10},
    {"FFGTYPE", "ff:freeform -> num",
     "BEZIER_TYPE, BSPLINE_TYPE or POWER_TYPE.", C "t = ffgtype(c);", ffgtype,
     0, 10},
    {"BLOSSOM", "ff:curve|surface params:list -> ctlpt",
     "Polar form at order - 1 parameters; of a surface, at two lists of them.",
     C "q = blossom(c, list(0, 1));", blossom, 0, 10},
    {"MESHSIZE", "ff:freeform|trimsrf|trisrf dir:num -> num",
     "Number of control points in one direction (COL, ROW, DEPTH; a "
     "multivariate's directions count from 0).",
     S "n = meshsize(s, COL);", meshsize, 0, 10},
    {"BOUNDARY", "x:poly|surface|trimsrf|trivar -> any",
     "Boundary curves of a surface (u min, u max, v min, v max), boundary "
     "surfaces of a trivariate, trimming curves on a trimmed surface, free "
     "edges of polygons.",
     S "l = boundary(s);", boundary, 0, 10},
    {"FFPTDIST", "ff:curve|surface param:bool n:num -> list",
     "n random parameter values as points (u, v, 0), uniform in the domain "
     "(param) or in length or area.",
     C "l = ffptdist(c, false, 10);", ffptdist, 0, 10},
    {"FFRIGIDSIM", "a:curve|surface b:curve|surface eps:num -> num|list",
     "list(translation, scale, rotation in degrees) if b is a similar copy of "
     "a in the XY plane, else 0.",
     C "o = ffrigidsim(c, c * rotz(30), 1e-5);", ffrigidsim, 0, 10},
    {0}};
