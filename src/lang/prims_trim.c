/* prims_trim.c - trimmed surfaces from surfaces and closed curves, and back.
 * A loop is one closed curve, or consecutive open ones that close together. */
#include <math.h>
#include <string.h>

#include "iritx/regions.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/prims_surface.h"

/* The reference snaps ends of trimming curves that are this near. */
#define TRIM_EPS 1e-4

/* --- loops ------------------------------------------------------------- */

static ix_status ends(ix_ctx *ctx, const ix_mv *c, double p[2][2])
{
    double dom[2], q[IX_MAX_COORDS];

    ix_mv_domain(c, 0, dom);
    for (int e = 0; e < 2; e++) {
        IX_TRY(ix_mv_point(ctx, c, &dom[e], q));
        memcpy(p[e], q, sizeof p[e]);
    }
    return IX_OK;
}

static bool meet(const double p[2], const double q[2], const double size[2])
{
    return fabs(p[0] - q[0]) <= TRIM_EPS * size[0] &&
           fabs(p[1] - q[1]) <= TRIM_EPS * size[1];
}

/* first[l] is the first curve of loop l, first[*nloops] = n. */
static ix_status find_loops(ix_call *c, int n, const ix_mv *const *crv,
                            const double size[2], int *nloops, int *first)
{
    double start[2] = {0}, p[2][2], last[2] = {0};
    bool open = false;

    *nloops = 0;
    for (int i = 0; i < n; i++) {
        IX_TRY(ends(c->ctx, crv[i], p));
        if (!open) {
            first[(*nloops)++] = i;
            memcpy(start, p[0], sizeof start);
        } else if (!meet(last, p[0], size)) {
            return IX_ARG_FAIL(c, 1,
                               "trimming curve %d begins at (%g, %g), the one "
                               "before ends at (%g, %g) and its loop is open",
                               i + 1, p[0][0], p[0][1], last[0], last[1]);
        }
        memcpy(last, p[1], sizeof last);
        open = !meet(start, last, size);
    }
    if (open)
        return IX_ARG_FAIL(c, 1,
                           "the trimming curves do not close: (%g, %g) to "
                           "(%g, %g)",
                           start[0], start[1], last[0], last[1]);
    first[*nloops] = n;
    return IX_OK;
}

/* Side k of the parameter domain, counter-clockwise. */
static ix_status domain_side(ix_ctx *ctx, const ix_mv *srf, int k, ix_mv **out)
{
    ix_dir dir = {.basis = IX_BEZIER, .order = 2, .length = 2};
    double u[2], v[2], pts[4];

    ix_mv_domain(srf, 0, u);
    ix_mv_domain(srf, 1, v);
    for (int e = 0; e < 2; e++) {
        int corner = (k + e) % 4;

        pts[e] = u[corner == 1 || corner == 2];
        pts[2 + e] = v[corner >= 2];
    }
    return ix_mv_new(ctx, 1, &dir, 2, false, pts, out);
}

static ix_status outer_loop(ix_ctx *ctx, ix_trimsrf *t)
{
    IX_TRY(ix__trimloop_segs(ctx, &t->loop[0], 4));
    for (int k = 0; k < 4; k++) {
        ix_mv *side = NULL;

        IX_TRY(domain_side(ctx, t->srf, k, &side));
        t->loop[0].seg[k].uv = side;
    }
    return IX_OK;
}

static ix_status fill_loops(ix_ctx *ctx, ix_trimsrf *t, int skip, int nloops,
                            const int *first, const ix_mv *const *crv)
{
    for (int l = 0; l < nloops; l++) {
        ix_trimloop *loop = &t->loop[skip + l];

        IX_TRY(ix__trimloop_segs(ctx, loop, first[l + 1] - first[l]));
        for (int k = 0; k < loop->n; k++) {
            const ix_mv *src = crv[first[l] + k];
            ix_mv *uv = NULL;

            IX_TRY(ix_mv_coerce(ctx, src, 2, src->rational, &uv));
            loop->seg[k].uv = uv;
        }
    }
    return IX_OK;
}

/* --- primitives -------------------------------------------------------- */

/* The curves of argument 1, checked to be planar. */
static ix_status trim_curves(ix_call *c, int *n, const ix_mv ***crv)
{
    const ix_mvs *one;

    if (c->argv[1]->type == IX_OBJ_LIST) {
        IX_TRY(ix__arg_mvs(c, 1, IX_OBJ_CURVE, n, crv));
    } else {
        one = c->argv[1]->u.mvs;
        *n = one->n;
        IX_SCRATCH(c->ctx, *crv, one->n);
        for (int i = 0; i < one->n; i++)
            (*crv)[i] = one->mv[i];
    }
    for (int i = 0; i < *n; i++)
        if ((*crv)[i]->ncoords < 2)
            return IX_ARG_FAIL(c, 1,
                               "trimming curve %d has one coordinate, "
                               "u and v are needed",
                               i + 1);
    return IX_OK;
}

ix_status ix__prim_trimsrf(ix_call *c)
{
    const ix_mv *srf = ix__arg_mv(c, 0), **crv;
    int n, nloops, *first, outer = !ix__arg_bool(c, 2);
    double dom[2][2];
    ix_trimsrf *t;
    ix_status st = IX_OK;

    IX_TRY(trim_curves(c, &n, &crv));
    IX_SCRATCH(c->ctx, first, n + 1);
    for (int d = 0; d < 2; d++)
        ix_mv_domain(srf, d, dom[d]);
    IX_TRY(find_loops(
        c, n, crv,
        (const double[2]){dom[0][1] - dom[0][0], dom[1][1] - dom[1][0]},
        &nloops, first));
    t = ix__trimsrf_new(c->ctx, srf, nloops + outer);
    if (!t)
        return IX_ENOMEM;
    if (outer)
        st = outer_loop(c->ctx, t);
    if (st == IX_OK)
        st = fill_loops(c->ctx, t, outer, nloops, first, crv);
    if (st == IX_OK)
        return ix__ret(c, ix__obj_trimsrf(c->ctx, t));
    ix__trimsrf_unref(c->ctx, t);
    return st;
}

/* The curve of order 2 through n points, a knot at each. */
static ix_status through_points(ix_ctx *ctx, int n, const double (*p)[3],
                                ix_mv **out)
{
    ix_dir d = {.basis = IX_BSPLINE, .order = 2, .length = n};
    double *kv, *pts;

    IX_SCRATCH(ctx, kv, n + 2);
    IX_SCRATCH(ctx, pts, 2 * (size_t)n);
    for (int i = 0; i < n + 2; i++)
        kv[i] = i < 1 ? 0 : i > n ? n - 1 : i - 1;
    for (int i = 0; i < 2 * n; i++)
        pts[i] = p[i % n][i / n];
    d.knots = kv;
    return ix_mv_new(ctx, 1, &d, 2, false, pts, out);
}

ix_status ix__region_obj(ix_ctx *ctx, const ix_mv *srf, const ix_lines *l,
                         ix_obj **out)
{
    const double(*p)[3] = (const double(*)[3])l->pt;
    ix_trimsrf *t = ix__trimsrf_new(ctx, srf, l->n);
    ix_status st = t ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < l->n; p += l->count[i], i++) {
        ix_mv *uv = NULL;

        st = ix__trimloop_segs(ctx, &t->loop[i], 1);
        if (st == IX_OK)
            st = through_points(ctx, l->count[i], p, &uv);
        if (st == IX_OK)
            t->loop[i].seg[0].uv = uv;
    }
    if (st == IX_OK) {
        *out = ix__obj_trimsrf(ctx, t);
        return *out ? IX_OK : IX_ENOMEM;
    }
    if (t)
        ix__trimsrf_unref(ctx, t);
    return st;
}

/* --- pieces ------------------------------------------------------------ */

/* Curves that contours give: those of curve objects borrowed, those through the
 * vertices of polylines made here. */
typedef struct {
    int n, nmade, room;
    const ix_mv **crv;
    ix_mv **made;
} contours;

/* How many curves o stands for; -1 if it is no contour. */
static int contours_of(const ix_obj *o)
{
    int n = 0;

    if (o->type == IX_OBJ_CURVE)
        return o->u.mvs->n;
    if (o->type == IX_OBJ_POLY)
        return o->u.poly->n;
    if (o->type != IX_OBJ_LIST)
        return -1;
    for (int i = 0; i < o->u.list.n; i++) {
        int k = contours_of(o->u.list.item[i]);

        if (k < 0)
            return -1;
        n += k;
    }
    return n;
}

static ix_status add_polyline(ix_call *c, const ix_polygon *pg, contours *k)
{
    int n = pg->n + (pg->kind == IX_POLYGON && pg->n > 0);
    ix_mv *m = NULL;
    double(*p)[3];

    if (pg->n < 2)
        return IX_ARG_FAIL(c, 1, "a contour of %d vertices", pg->n);
    IX_SCRATCH(c->ctx, p, n);
    for (int i = 0; i < n; i++)
        memcpy(p[i], pg->v[i % pg->n].p, sizeof p[i]);
    IX_TRY(through_points(c->ctx, n, (const double(*)[3])p, &m));
    k->made[k->nmade++] = m;
    k->crv[k->n++] = m;
    return IX_OK;
}

static ix_status add_contours(ix_call *c, const ix_obj *o, contours *k)
{
    if (o->type == IX_OBJ_CURVE)
        for (int i = 0; i < o->u.mvs->n; i++)
            k->crv[k->n++] = o->u.mvs->mv[i];
    else if (o->type == IX_OBJ_POLY)
        for (int i = 0; i < o->u.poly->n; i++)
            IX_TRY(add_polyline(c, &o->u.poly->poly[i], k));
    else
        for (int i = 0; i < o->u.list.n; i++)
            IX_TRY(add_contours(c, o->u.list.item[i], k));
    return IX_OK;
}

/* Loops first .. last - 1 of regions as a trimmed surface. */
static ix_status loops_piece(ix_ctx *ctx, const ix_mv *srf, const ix_regions *r,
                             int first, int last, ix_trimsrf **out)
{
    *out = ix__trimsrf_new(ctx, srf, last - first);
    if (!*out)
        return IX_ENOMEM;
    for (int l = 0; l < last - first; l++) {
        int at = r->first_crv[first + l];
        int m = r->first_crv[first + l + 1] - at;
        ix_status st = ix__trimloop_segs(ctx, &(*out)->loop[l], m);

        if (st != IX_OK) {
            ix__trimsrf_unref(ctx, *out);
            *out = NULL;
            return st;
        }
        for (int k = 0; k < m; k++)
            (*out)->loop[l].seg[k].uv = ix_mv_ref(r->crv[at + k]);
    }
    return IX_OK;
}

static ix_status ret_pieces(ix_call *c, const ix_mv *srf, const ix_regions *r)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < r->n; i++) {
        ix_trimsrf *t;

        st = loops_piece(c->ctx, srf, r, r->first_loop[i], r->first_loop[i + 1],
                         &t);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, ix__obj_trimsrf(c->ctx, t));
    }
    return ix__ret_list(c, list, st);
}

static ix_status divide_srf(ix_call *c, contours *k, ix_regions *r)
{
    double box[2][2];

    IX_TRY(add_contours(c, c->argv[1], k));
    for (int d = 0; d < 2; d++)
        ix_mv_domain(ix__arg_mv(c, 0), d, box[d]);
    c->bad_arg = 2;
    IX_TRY(ix_divide_box(c->ctx, (const double(*)[2])box, k->n, k->crv, r));
    c->bad_arg = 0;
    return IX_OK;
}

ix_status ix__prim_trmsrfs(ix_call *c)
{
    contours k = {.room = contours_of(c->argv[1])};
    ix_regions r = {.n = 0};
    ix_status st;

    if (k.room < 0)
        return IX_ARG_FAIL(c, 1,
                           "a list with something that is neither a curve nor "
                           "a polyline");
    IX_SCRATCH(c->ctx, k.crv, k.room);
    IX_SCRATCH(c->ctx, k.made, k.room);
    st = divide_srf(c, &k, &r);
    if (st == IX_OK)
        st = ret_pieces(c, ix__arg_mv(c, 0), &r);
    for (int i = 0; i < k.nmade; i++)
        ix_mv_unref(c->ctx, k.made[i]);
    ix_regions_free(c->ctx, &r);
    return st;
}

ix_status ix__prim_strimsrf(ix_call *c)
{
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_SURFACE,
                                 ix_mv_ref(c->argv[0]->u.trim.item[0]->srf)));
}

ix_status ix__prim_ctrimsrf(ix_call *c)
{
    return ix__ret_trim_curves(c, c->argv[0]->u.trim.item[0],
                               ix__arg_bool(c, 1));
}

static ix_status map_loop(ix_ctx *ctx, const ix_trimloop *from,
                          const double mat[16], ix_trimloop *to)
{
    IX_TRY(ix__trimloop_segs(ctx, to, from->n));
    for (int k = 0; k < from->n; k++) {
        ix_mv *uv = NULL;

        IX_TRY(ix_mv_transform(ctx, from->seg[k].uv, mat, &uv));
        to->seg[k].uv = uv;
        if (from->seg[k].euclid)
            to->seg[k].euclid = ix_mv_ref(from->seg[k].euclid);
    }
    return IX_OK;
}

ix_status ix__trim_mapped(ix_ctx *ctx, const ix_trimsrf *t, const ix_mv *srf,
                          const double mat[16], ix_trimsrf **out)
{
    *out = ix__trimsrf_new(ctx, srf, t->nloops);
    if (!*out)
        return IX_ENOMEM;
    for (int l = 0; l < t->nloops; l++) {
        ix_status st = map_loop(ctx, &t->loop[l], mat, &(*out)->loop[l]);

        if (st != IX_OK) {
            ix__trimsrf_unref(ctx, *out);
            *out = NULL;
            return st;
        }
    }
    return IX_OK;
}

/* --- parts of trimmed surfaces ------------------------------------------ */

/* The loops of t as first[nloops + 1] and crv. */
static ix_status list_loops(ix_ctx *ctx, const ix_trimsrf *t, int **first,
                            const ix_mv ***crv)
{
    int n = 0;

    IX_SCRATCH(ctx, *first, t->nloops + 1);
    for (int l = 0; l < t->nloops; l++) {
        (*first)[l] = n;
        n += t->loop[l].n;
    }
    (*first)[t->nloops] = n;
    IX_SCRATCH(ctx, *crv, n);
    for (int l = 0, k = 0; l < t->nloops; l++)
        for (int i = 0; i < t->loop[l].n; i++)
            (*crv)[k++] = t->loop[l].seg[i].uv;
    return IX_OK;
}

/* The regions of t over the interval, on srf, the part of its surface there,
 * whose domain may be another. */
static ix_status part_of(ix_ctx *ctx, const ix_mv *srf, const ix_regions *r,
                         int dir, const double from[2], ix_trimsrf **out)
{
    double mat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, to[2];
    ix_trimsrf *whole;
    ix_status st;

    IX_TRY(loops_piece(ctx, srf, r, 0, r->nloops, &whole));
    ix_mv_domain(srf, dir, to);
    mat[5 * dir] = (to[1] - to[0]) / (from[1] - from[0]);
    mat[12 + dir] = to[0] - from[0] * mat[5 * dir];
    st = ix__trim_mapped(ctx, whole, srf, mat, out);
    ix__trimsrf_unref(ctx, whole);
    return st;
}

/* The part of the trimmed surface over [t0, t1] of direction dir; NULL if there
 * is none. */
static ix_status cut_trimmed(ix_call *c, int dir, double t0, double t1,
                             ix_trimsrf **out)
{
    const ix_trimsrf *t = c->argv[0]->u.trim.item[0];
    double box[2][2], from[2] = {fmin(t0, t1), fmax(t0, t1)};
    const ix_mv **crv;
    ix_regions r;
    ix_status st;
    ix_mv *srf;
    int *first;

    *out = NULL;
    IX_TRY(list_loops(c->ctx, t, &first, &crv));
    for (int d = 0; d < 2; d++)
        ix_mv_domain(t->srf, d, box[d]);
    memcpy(box[dir], from, sizeof from);
    IX_TRY(ix_mv_region(c->ctx, t->srf, dir, t0, t1, &srf));
    st = ix_trim_box(c->ctx, (const double(*)[2])box, t->nloops, first, crv,
                     &r);
    if (st == IX_OK && r.n > 0)
        st = part_of(c->ctx, srf, &r, dir, from, out);
    ix_regions_free(c->ctx, &r);
    ix_mv_unref(c->ctx, srf);
    return st;
}

ix_status ix__prim_trim_region(ix_call *c)
{
    double t0 = ix__arg_num(c, 2), t1 = ix__arg_num(c, 3);
    ix_trimsrf *out;
    int dir;

    IX_TRY(ix__arg_dir(c, 1, 2, &dir));
    IX_TRY(cut_trimmed(c, dir, t0, t1, &out));
    if (!out)
        return IX_FAIL(c->ctx, IX_EDOMAIN,
                       "nothing of the trimmed surface is between %g and %g",
                       t0, t1);
    return ix__ret(c, ix__obj_trimsrf(c->ctx, out));
}

ix_status ix__prim_trim_divide(ix_call *c)
{
    double t = ix__arg_num(c, 2), dom[2];
    ix_obj *list;
    ix_status st;
    int dir;

    IX_TRY(ix__arg_dir(c, 1, 2, &dir));
    ix_mv_domain(c->argv[0]->u.trim.item[0]->srf, dir, dom);
    if (!(t > dom[0] && t < dom[1]))
        return IX_ARG_FAIL(c, 2, "%g is not inside the domain [%g, %g]", t,
                           dom[0], dom[1]);
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int e = 0; e < 2 && st == IX_OK; e++) {
        ix_trimsrf *out;

        st = cut_trimmed(c, dir, e ? t : dom[0], e ? dom[1] : t, &out);
        if (st == IX_OK && out)
            st = ix__list_add(c->ctx, list, ix__obj_trimsrf(c->ctx, out));
    }
    return ix__ret_list(c, list, st);
}
