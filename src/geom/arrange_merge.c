/* arrange_merge.c - longer and simpler curves in an arrangement. */
#include <math.h>

#include "geom/arrange_edges.h"
#include "geom/vec3.h"

typedef struct {
    ix_ctx *ctx;
    double angle;
    ix__edges l;  /* the curves so far */
    int (*at)[2]; /* the vertices at their ends; -1, -1: gone */
    int nvertices;
} joining;

/* Tangent at end e, in the curve's direction. */
static ix_status end_tangent(ix_ctx *ctx, const ix_mv *crv, int e, double u[3])
{
    ix_path p;
    int s;

    IX_TRY(ix__path_new(ctx, crv, &p));
    s = e ? p.nspans - 1 : 0;
    if (!ix__path_tangent3(&p, s, p.breaks[e ? p.nspans : 0], e, u))
        u[0] = u[1] = u[2] = NAN;
    return IX_OK;
}

/* The only two ends at v: edge[k], end[k]; false unless they are of two
 * curves. */
static bool two_ends(const joining *w, int v, int edge[2], int end[2])
{
    int n = 0;

    for (int i = 0; i < w->l.n; i++)
        for (int e = 0; e < 2; e++)
            if (w->at[i][e] == v) {
                if (n == 2)
                    return false;
                edge[n] = i;
                end[n++] = e;
            }
    return n == 2 && edge[0] != edge[1];
}

/* Curve i passes the vertex at its end e0, curve j at e1: is the way from one
 * to the other straight on? */
static ix_status straight(const joining *w, int i, int e0, int j, int e1,
                          bool *out)
{
    const ix_arr_edge *a = &w->l.e[i], *b = &w->l.e[j];
    double u[3], v[3], c[3], s = e0 == e1 ? -1 : 1;

    *out = b->turns == (e0 == e1 ? -a->turns : a->turns);
    if (!*out)
        return IX_OK;
    IX_TRY(end_tangent(w->ctx, a->crv, e0, u));
    IX_TRY(end_tangent(w->ctx, b->crv, e1, v));
    ix__cross3(u, v, c);
    *out = atan2(ix__len3(c), s * ix__dot3(u, v)) <= w->angle;
    return IX_OK;
}

/* Curve j, turned if need be, is put to end e0 of curve i. */
static ix_status join(joining *w, int i, int e0, int j, int e1)
{
    ix_mv *b = NULL, *sum;
    ix_status st = IX_OK;

    if (e0 == e1)
        st = ix_mv_reverse(w->ctx, w->l.e[j].crv, 0, &b);
    else
        b = ix_mv_ref(w->l.e[j].crv);
    if (st == IX_OK)
        st = e0 ? ix__crv_chain(w->ctx, w->l.e[i].crv, b, &sum)
                : ix__crv_chain(w->ctx, b, w->l.e[i].crv, &sum);
    ix_mv_unref(w->ctx, b);
    IX_TRY(st);
    ix_mv_unref(w->ctx, w->l.e[i].crv);
    w->l.e[i].crv = sum;
    ix_mv_unref(w->ctx, w->l.e[j].crv);
    w->l.e[j].crv = NULL;
    w->at[i][e0] = w->at[j][!e1];
    w->at[j][0] = w->at[j][1] = -1;
    return IX_OK;
}

static ix_status join_all(joining *w)
{
    for (int v = 0; v < w->nvertices; v++) {
        int edge[2], end[2];
        bool on;

        IX_TRY(ix__poll(w->ctx));
        if (!two_ends(w, v, edge, end))
            continue;
        IX_TRY(straight(w, edge[0], end[0], edge[1], end[1], &on));
        if (on)
            IX_TRY(join(w, edge[0], end[0], edge[1], end[1]));
    }
    return IX_OK;
}

static ix_status start_joining(joining *w, const ix_arrangement *a)
{
    double(*p)[2];
    int *vertex;

    IX_TRY(ix__arr_vertices(w->ctx, a, &vertex, &w->nvertices, &p));
    IX_SCRATCH(w->ctx, w->at, a->nedges);
    for (int i = 0; i < a->nedges; i++) {
        w->at[i][0] = vertex[2 * i];
        w->at[i][1] = vertex[2 * i + 1];
        IX_TRY(ix__edges_add(&w->l, ix_mv_ref(a->edge[i].crv),
                             a->edge[i].source, a->edge[i].turns));
    }
    return IX_OK;
}

static ix_status merge(ix_ctx *ctx, ix_arrangement *a, double angle)
{
    joining w = {.ctx = ctx, .angle = angle, .l = {.ctx = ctx}};
    ix_status st = start_joining(&w, a);
    int n = 0;

    if (st == IX_OK)
        st = join_all(&w);
    for (int i = 0; i < w.l.n; i++)
        if (w.l.e[i].crv)
            w.l.e[n++] = w.l.e[i];
    w.l.n = n;
    return ix__edges_take(&w.l, a, st);
}

ix_status ix_arrangement_merge(ix_ctx *ctx, ix_arrangement *a, double angle)
{
    if (!(angle >= 0))
        return IX_FAIL(ctx, IX_EARG, "an angle of %g; it must not be negative",
                       angle);
    IX_RETURN_SCOPED(ctx, merge(ctx, a, angle));
}

/* --- simpler curves --------------------------------------------------------
 */

#define MOST_POINTS 512

/* Knots for k equal intervals in each span of the curve, which meet in C0
 * knots: its speed may jump there, and then uniform knots come near only
 * slowly. */
static ix_status span_knots(ix_ctx *ctx, const ix_path *p, int order, int k,
                            ix_interpolate_opts *o)
{
    int n = 0;
    double *kv;

    o->size = order + p->nspans * (k - 1) + (p->nspans - 1) * (order - 1);
    o->nknots = o->size + order;
    IX_SCRATCH(ctx, kv, o->nknots);
    for (int s = 0; s <= p->nspans; s++) {
        bool end = s == 0 || s == p->nspans;

        for (int i = 0; i < (end ? order : order - 1); i++)
            kv[n++] = p->breaks[s];
        for (int i = 1; s < p->nspans && i < k; i++)
            kv[n++] = p->breaks[s] + (p->breaks[s + 1] - p->breaks[s]) * i / k;
    }
    o->knots = kv;
    return IX_OK;
}

/* Is it within the tolerance? Else *out stays NULL. */
static ix_status attempt(ix_ctx *ctx, const ix_mv *crv,
                         const ix_interpolate_opts *o, double tol,
                         double *least, ix_mv **out)
{
    double err;

    IX_TRY(ix_fit_curve(ctx, crv, o, &err, out));
    *least = fmin(*least, err);
    if (err <= tol)
        return IX_OK;
    ix_mv_unref(ctx, *out);
    *out = NULL;
    return IX_OK;
}

static ix_status fit_one(ix_ctx *ctx, const ix_mv *crv, int number, double tol,
                         int order, ix_mv **out)
{
    double least = HUGE_VAL;
    ix_path p;

    *out = NULL;
    IX_TRY(ix__path_new(ctx, crv, &p));
    for (int k = 1; !*out && k <= MOST_POINTS; k *= 2) {
        ix_interpolate_opts o = {.order = order, .size = order + k - 1};

        if (o.size <= MOST_POINTS)
            IX_TRY(attempt(ctx, crv, &o, tol, &least, out));
        if (*out)
            break;
        IX_TRY(span_knots(ctx, &p, order, k, &o));
        if (o.size <= MOST_POINTS)
            IX_TRY(attempt(ctx, crv, &o, tol, &least, out));
    }
    if (*out)
        return IX_OK;
    return IX_FAIL(ctx, IX_EUNABLE,
                   "curve %d: more than %d control points are needed for a "
                   "tolerance of %g (%g is reached)",
                   number, MOST_POINTS, tol, least);
}

static ix_status fit(ix_ctx *ctx, ix_arrangement *a, double tol, int order)
{
    ix__edges l = {.ctx = ctx};
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < a->nedges; i++) {
        const ix_arr_edge *e = &a->edge[i];
        ix_mv *crv;

        st = fit_one(ctx, e->crv, i + 1, tol, order, &crv);
        if (st == IX_OK)
            st = ix__edges_add(&l, crv, e->source, e->turns);
    }
    return ix__edges_take(&l, a, st);
}

ix_status ix_arrangement_fit(ix_ctx *ctx, ix_arrangement *a, double tol,
                             int order)
{
    if (!(tol > 0) || order < 2 || order > 32)
        return IX_FAIL(ctx, IX_EARG,
                       "tolerance %g and order %d; a positive one and 2 to 32 "
                       "are wanted",
                       tol, order);
    IX_RETURN_SCOPED(ctx, fit(ctx, a, tol, order));
}
