/* builtins_poly.c - polylines and polygons as data (chapter 23 of
 * spec/functions). The polygonal values are immutable: what changes an object
 * puts a new value into its box. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "geom/connect.h"
#include "geom/vec3.h"
#include "lang/args_freeform.h"
#include "lang/poly_rows.h"

/* --- POLY -------------------------------------------------------------- */

/* Vertices that an element of the list contributes; -1: it has no place. */
static int vertices_of(const ix_obj *o)
{
    int n = 0;

    if (o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR ||
        o->type == IX_OBJ_CTLPT)
        return 1;
    if (o->type != IX_OBJ_POLY)
        return -1;
    for (int i = 0; i < o->u.poly->n; i++)
        n += o->u.poly->poly[i].n;
    return n;
}

/* Takes a "normal" attribute, a vector or "x,y,z", out of the list. */
static void take_normal(ix_ctx *ctx, ix_vertex *v)
{
    ix_attr *a = ix__attr_find(v->attrs, "normal");

    if (!a || a->type != IX_ATTR_OBJ ||
        (a->obj->type != IX_OBJ_VECTOR && a->obj->type != IX_OBJ_POINT))
        return;
    if (ix__unit3(a->obj->u.pt, v->normal) > 0)
        v->has_normal = true;
    ix__attr_remove(ctx, &v->attrs, "normal");
}

static ix_status copy_vertices(ix_ctx *ctx, const ix_polygon *from,
                               ix_vertex *to)
{
    for (int k = 0; k < from->n; k++) {
        ix_attr *none = to[k].attrs;

        to[k] = from->v[k];
        to[k].attrs = none;
        IX_TRY(ix__attr_copy_all(ctx, from->v[k].attrs, &to[k].attrs));
    }
    return IX_OK;
}

/* Puts the vertices of element i of the list at v. */
static ix_status put_element(ix_call *c, int i, ix_obj *o, ix_vertex *v)
{
    if (o->type == IX_OBJ_POLY) {
        for (int k = 0; k < o->u.poly->n; k++) {
            IX_TRY(copy_vertices(c->ctx, &o->u.poly->poly[k], v));
            v += o->u.poly->poly[k].n;
        }
        return IX_OK;
    }
    if (o->type == IX_OBJ_CTLPT) {
        const ix_ctlpt *q = o->u.ctlpt;
        double w = q->rational ? q->v[0] : 1;

        if (w == 0)
            return IX_ARG_FAIL(c, 0, "element %d has weight 0", i + 1);
        for (int k = 0; k < 3; k++)
            v->p[k] = k < q->ncoords ? q->v[q->rational + k] / w : 0;
    } else {
        memcpy(v->p, o->u.pt, sizeof v->p);
    }
    IX_TRY(ix__attr_copy_all(c->ctx, o->attrs, &v->attrs));
    take_normal(c->ctx, v);
    return IX_OK;
}

static ix_status fill_poly(ix_call *c, int total, ix_poly_kind kind,
                           ix_polygon *pg)
{
    const ix_list *l = &c->argv[0]->u.list;
    int at = 0;

    IX_TRY(ix__poly_vertices(c->ctx, pg, total));
    pg->kind = kind;
    for (int i = 0; i < l->n; i++) {
        IX_TRY(put_element(c, i, l->item[i], pg->v + at));
        at += vertices_of(l->item[i]);
    }
    if (kind == IX_POLYGON && !ix__polygon_plane(pg, pg->plane))
        return IX_ARG_FAIL(c, 0, "the polygon's %d vertices span no plane",
                           total);
    pg->has_plane = kind == IX_POLYGON;
    return IX_OK;
}

static ix_status poly(ix_call *c)
{
    const ix_list *l = &c->argv[0]->u.list;
    ix_poly_kind kind = ix__arg_bool(c, 1) ? IX_POLYLINE : IX_POLYGON;
    size_t total = 0;
    ix_poly *p;
    ix_status st;

    for (int i = 0; i < l->n; i++) {
        int n = vertices_of(l->item[i]);

        if (n < 0)
            return ix__wrong_element(c, 0, i, l->item[i],
                                     "a point, vector, control point or poly");
        total += (size_t)n;
    }
    if (total < (kind == IX_POLYGON ? 3 : 1) || total > INT_MAX)
        return IX_ARG_FAIL(c, 0, "%zu vertices do not make a %s", total,
                           kind == IX_POLYGON ? "polygon" : "polyline");
    p = ix__poly_new(c->ctx, 1);
    if (!p)
        return IX_ENOMEM;
    st = fill_poly(c, (int)total, kind, &p->poly[0]);
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    ix__poly_unref(c->ctx, p);
    return st;
}

/* --- several in one ---------------------------------------------------- */

/* All polygons of n values in one. */
static ix_status join(ix_ctx *ctx, int n, const ix_poly *const *p,
                      ix_poly **out)
{
    size_t total = 0;
    int at = 0;

    *out = NULL;
    for (int i = 0; i < n; i++)
        total += (size_t)p[i]->n;
    if (total > INT_MAX)
        return IX_FAIL(ctx, IX_EARG, "%zu polygons are too many", total);
    *out = ix__poly_new(ctx, (int)total);
    if (!*out)
        return IX_ENOMEM;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < p[i]->n; k++)
            if (ix__polygon_dup(ctx, &p[i]->poly[k], &(*out)->poly[at++]) !=
                IX_OK) {
                ix__poly_unref(ctx, *out);
                *out = NULL;
                return IX_ENOMEM;
            }
    return IX_OK;
}

/* The polygonal values of a list, borrowed. */
static ix_status poly_list(ix_call *c, int *n, const ix_poly ***out)
{
    const ix_list *l = &c->argv[0]->u.list;

    IX_SCRATCH(c->ctx, *out, l->n);
    for (int i = 0; i < l->n; i++) {
        if (l->item[i]->type != IX_OBJ_POLY)
            return ix__wrong_element(c, 0, i, l->item[i], "a poly");
        (*out)[i] = l->item[i]->u.poly;
    }
    *n = l->n;
    return IX_OK;
}

static ix_status mergepoly(ix_call *c)
{
    const ix_poly **p;
    ix_poly *out;
    int n;

    IX_TRY(poly_list(c, &n, &p));
    IX_TRY(join(c->ctx, n, p, &out));
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

/* The box of the second argument gets a value with the polygons of both. */
static ix_status insertpoly(ix_call *c)
{
    const ix_poly *const p[2] = {c->argv[0]->u.poly, c->argv[1]->u.poly};
    ix_poly *out;

    IX_TRY(join(c->ctx, 2, p, &out));
    ix__poly_unref(c->ctx, c->argv[1]->u.poly);
    c->argv[1]->u.poly = out;
    return IX_OK;
}

/* --- chains ------------------------------------------------------------ */

/* Polylines in the making: positions of pieces in the order of the chain. */
typedef struct {
    const ix_polygon *pg;
    bool used, reversed;
    int next; /* piece after this one, -1: none */
} piece;

static const double *piece_end(const piece *p, bool last)
{
    bool at_last = last != p->reversed;

    return p->pg->v[at_last ? p->pg->n - 1 : 0].p;
}

/* The unused piece with an end nearest to x within eps, turned so that it
 * begins (or with at_last ends) there; -1 if there is none. */
static int nearest(piece *p, int n, const double x[3], bool at_last, double eps)
{
    double best = eps;
    int found = -1;

    for (int i = 0; i < n; i++)
        for (int e = 0; e < 2 && !p[i].used; e++) {
            const double *q = p[i].pg->v[e ? p[i].pg->n - 1 : 0].p;
            double d = ix__dist3(x, q);

            if (d <= best) {
                best = d;
                found = i;
                p[i].reversed = (e == 1) != at_last;
            }
        }
    return found;
}

/* Grows a chain from piece i at both ends; its first piece is returned. */
static ix_status grow(ix_ctx *ctx, piece *p, int n, int i, double eps,
                      int *first)
{
    int last = i, k;

    p[i].used = true;
    *first = i;
    while ((k = nearest(p, n, piece_end(&p[last], true), false, eps)) >= 0) {
        IX_TRY(ix__poll(ctx));
        p[k].used = true;
        p[last].next = k;
        last = k;
    }
    while ((k = nearest(p, n, piece_end(&p[*first], false), true, eps)) >= 0) {
        IX_TRY(ix__poll(ctx));
        p[k].used = true;
        p[k].next = *first;
        *first = k;
    }
    return IX_OK;
}

/* Vertices that a piece adds to its chain: the first one of a polyline is the
 * last one of the piece before, single points are all kept. */
static int skipped(const piece *p, int i, int first)
{
    return i != first && p[i].pg->n > 1;
}

static ix_status write_chain(ix_ctx *ctx, const piece *p, int first,
                             ix_polygon *out)
{
    size_t total = 0;
    int at = 0;

    for (int i = first; i >= 0; i = p[i].next)
        total += (size_t)(p[i].pg->n - skipped(p, i, first));
    if (total > INT_MAX)
        return IX_FAIL(ctx, IX_EARG, "%zu vertices are too many", total);
    IX_TRY(ix__poly_vertices(ctx, out, (int)total));
    out->kind = IX_POLYLINE;
    for (int i = first; i >= 0; i = p[i].next)
        for (int k = skipped(p, i, first); k < p[i].pg->n; k++)
            memcpy(out->v[at++].p,
                   p[i].pg->v[p[i].reversed ? p[i].pg->n - 1 - k : k].p,
                   sizeof out->v[0].p);
    return IX_OK;
}

static ix_status chain_all(ix_call *c, piece *p, int n, double eps)
{
    int *first, nchains = 0;
    ix_status st = IX_OK;
    ix_poly *out;

    IX_SCRATCH(c->ctx, first, n);
    for (int i = 0; i < n; i++)
        if (!p[i].used)
            IX_TRY(grow(c->ctx, p, n, i, eps, &first[nchains++]));
    out = ix__poly_new(c->ctx, nchains);
    if (!out)
        return IX_ENOMEM;
    for (int i = 0; i < nchains && st == IX_OK; i++)
        st = write_chain(c->ctx, p, first[i], &out->poly[i]);
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, out));
    ix__poly_unref(c->ctx, out);
    return st;
}

static ix_status mergeplln(ix_call *c)
{
    const ix_poly **p;
    size_t total = 0;
    piece *pieces;
    int n = 1, at = 0;

    if (c->argv[0]->type == IX_OBJ_LIST) {
        IX_TRY(poly_list(c, &n, &p));
    } else {
        IX_SCRATCH(c->ctx, p, 1);
        p[0] = c->argv[0]->u.poly;
    }
    for (int i = 0; i < n; i++)
        total += (size_t)p[i]->n;
    IX_SCRATCH_ZERO(c->ctx, pieces, total);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < p[i]->n; k++)
            if (p[i]->poly[k].n > 0)
                pieces[at++] = (piece){.pg = &p[i]->poly[k], .next = -1};
    return chain_all(c, pieces, at, ix__arg_num(c, 1));
}

/* --- points ------------------------------------------------------------- */

/* Polylines through chains of points double[n][dim]: `use` coordinates from the
 * skip-th on, the others 0. */
static ix_status chain_polys(ix_ctx *ctx, const ix__chains *ch, int dim,
                             const double *p, int skip, int use, ix_poly **out)
{
    const int *point = ch->point;

    *out = ix__poly_new(ctx, ch->n);
    if (!*out)
        return IX_ENOMEM;
    for (int k = 0; k < ch->n; k++) {
        int n = ch->count[k], m = n + ch->closed[k];
        ix_polygon *pg = &(*out)->poly[k];

        if (ix__poly_vertices(ctx, pg, m) != IX_OK) {
            ix__poly_unref(ctx, *out);
            return IX_ENOMEM;
        }
        pg->kind = IX_POLYLINE;
        for (int i = 0; i < m; i++)
            memcpy(pg->v[i].p, p + (size_t)point[i % n] * (size_t)dim + skip,
                   (size_t)use * sizeof *p);
        point += n;
    }
    return IX_OK;
}

/* dim coordinates of a control point, projected; missing ones 0. */
static ix_status ctlpt_place(ix_call *c, int i, const ix_ctlpt *q, int dim,
                             double *out)
{
    double w = q->rational ? q->v[0] : 1;

    if (w == 0)
        return IX_ARG_FAIL(c, 0, "element %d has weight 0", i + 1);
    for (int k = 0; k < dim; k++)
        out[k] = k < q->ncoords ? q->v[q->rational + k] / w : 0;
    return IX_OK;
}

static ix_status tolerance(ix_call *c, double *tol)
{
    *tol = ix__arg_num(c, 1);
    if (!(*tol >= 0))
        return IX_ARG_FAIL(c, 1, "a tolerance of %g; it cannot be negative",
                           *tol);
    return IX_OK;
}

static ix_status pts2plln(ix_call *c)
{
    const ix_list *l = &c->argv[0]->u.list;
    ix_poly *out;
    ix__chains ch;
    double *p, tol;

    IX_TRY(tolerance(c, &tol));
    IX_SCRATCH_ZERO(c->ctx, p, 3 * (size_t)l->n);
    for (int i = 0; i < l->n; i++) {
        const ix_obj *o = l->item[i];

        if (o->type == IX_OBJ_POLY || vertices_of(o) != 1)
            return ix__wrong_element(c, 0, i, o,
                                     "a point, vector or control point");
        if (o->type == IX_OBJ_CTLPT)
            IX_TRY(ctlpt_place(c, i, o->u.ctlpt, 3, p + 3 * i));
        else
            memcpy(p + 3 * i, o->u.pt, 3 * sizeof *p);
    }
    IX_TRY(ix__connect(c->ctx, l->n, 3, p, tol, &ch));
    IX_TRY(chain_polys(c->ctx, &ch, 3, p, 0, 3, &out));
    return ix__ret(c, ix__obj_poly(c->ctx, out));
}

/* The points as double[n][*dim], *dim 4 or 6. */
static ix_status double_places(ix_call *c, int *dim, double **p)
{
    const ix_list *l = &c->argv[0]->u.list;

    *dim = l->n > 0 && l->item[0]->type == IX_OBJ_CTLPT
               ? l->item[0]->u.ctlpt->ncoords
               : 4;
    IX_SCRATCH(c->ctx, *p, (size_t)l->n * 6);
    for (int i = 0; i < l->n; i++) {
        const ix_obj *o = l->item[i];

        if (o->type != IX_OBJ_CTLPT ||
            (o->u.ctlpt->ncoords != 4 && o->u.ctlpt->ncoords != 6))
            return IX_ARG_FAIL(c, 0,
                               "element %d is no control point of 4 or 6 "
                               "coordinates",
                               i + 1);
        if (o->u.ctlpt->ncoords != *dim)
            return IX_ARG_FAIL(c, 0, "element %d has %d coordinates, not %d",
                               i + 1, o->u.ctlpt->ncoords, *dim);
        IX_TRY(
            ctlpt_place(c, i, o->u.ctlpt, *dim, *p + (size_t)i * (size_t)*dim));
    }
    return IX_OK;
}

/* Points of two planes, or of two spaces, at once: joined in all coordinates,
 * told half by half. */
static ix_status pts2plys(ix_call *c)
{
    ix_obj *list;
    ix__chains ch;
    ix_status st;
    double *p, tol;
    int dim;

    IX_TRY(tolerance(c, &tol));
    IX_TRY(double_places(c, &dim, &p));
    IX_TRY(ix__connect(c->ctx, c->argv[0]->u.list.n, dim, p, tol, &ch));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int k = 0; st == IX_OK && k < 2; k++) {
        ix_poly *half;

        st = chain_polys(c->ctx, &ch, dim, p, k * dim / 2, dim / 2, &half);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, ix__obj_poly(c->ctx, half));
    }
    return ix__ret_list(c, list, st);
}

/* --- table ------------------------------------------------------------- */

#define P "p = poly(list(point(0,0,0), point(1,0,0), point(1,1,0)), false); "

const ix_builtin ix__builtins_poly[] = {
    {"POLY", "vertices:list isPolyline:bool -> poly",
     "A polygon or polyline through points, vectors, control points, or the "
     "vertices of other polys.",
     P, poly, 0, 23},
    {"MERGEPOLY", "polys:list -> poly", "All polygons in one object.",
     P "o = mergepoly(list(p, p * trans(vector(1,0,0))));", mergepoly, 0, 23},
    {"INSERTPOLY", "p:poly into:poly -> nothing",
     "Adds the polygons of p to those of into, in place.",
     P "q = p * trans(vector(0,0,1)); insertpoly(q, p);", insertpoly, 0, 23},
    {"MERGEPLLN", "polys:poly|list eps:num -> poly",
     "Polylines chained where their ends are within eps of each other.",
     "o = mergeplln(list(poly(list(point(0,0,0), point(1,0,0)), true), "
     "poly(list(point(1,0,0), point(1,1,0)), true)), 1e-6);",
     mergeplln, 0, 23},
    {"PTS2PLLN", "pts:list maxTol:num -> poly",
     "Points without order joined to polylines where they are within maxTol, "
     "shortest gaps first; a chain whose ends are that near (and not much "
     "farther apart than its points) is closed.",
     "o = pts2plln(list(point(0,0,0), point(.1,0,0), point(.2,0,0)), 0.15);",
     pts2plln, 0, 23},
    {"PTS2PLYS", "pts:list tol:num -> list",
     "The same for control points (u, v, s, t) or (x, y, z, x', y', z'), as "
     "points of curves in two parameter planes or two spaces: joined in all "
     "coordinates; list(polylines of the first half, of the second), vertex "
     "for vertex.",
     "l = pts2plys(list(ctlpt(E4,0,0,1,1), ctlpt(E4,0.2,0,1,1.2), "
     "ctlpt(E4,0.1,0,1,1.1)), 0.15);",
     pts2plys, 0, 23},
    {0}};
