/* arrange.c - arrangements as containers: making, copying, replacing edges.
 *
 * The edges and what is evaluated of them are two blocks; only this file and
 * arrange_faces.c know how large these are. */
#include "iritx/arrange.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/arrange_edges.h"
#include "geom/crvs.h"

/* --- edges -----------------------------------------------------------------
 */

ix_status ix__edges_add(ix__edges *l, const ix_mv *crv, int source, int turns)
{
    if (l->n == l->room) {
        int room = 2 * l->room + 32;
        ix_arr_edge *more = ix__scratch(l->ctx, (size_t)room, sizeof *more);

        if (!more) {
            ix_mv_unref(l->ctx, crv);
            return IX_ENOMEM;
        }
        if (l->n)
            memcpy(more, l->e, (size_t)l->n * sizeof *more);
        l->e = more;
        l->room = room;
    }
    l->e[l->n++] = (ix_arr_edge){.crv = crv,
                                 .source = source,
                                 .turns = turns,
                                 .vertex = {-1, -1},
                                 .face = {-1, -1}};
    return IX_OK;
}

ix_status ix__edges_add_pieces(ix__edges *l, const ix_arr_edge *e,
                               const ix__marks *m)
{
    if (m->n <= 2)
        return ix__edges_add(l, ix_mv_ref(e->crv), e->source, e->turns);
    for (int i = 0; i + 1 < m->n; i++) {
        ix_mv *piece;

        IX_TRY(ix_mv_region(l->ctx, e->crv, 0, m->t[i], m->t[i + 1], &piece));
        IX_TRY(ix__edges_add(l, piece, e->source, e->turns));
    }
    return IX_OK;
}

static void free_edges(ix_ctx *ctx, ix_arrangement *a)
{
    for (int i = 0; i < a->nedges; i++)
        ix_mv_unref(ctx, a->edge[i].crv);
    ix__free(ctx, a->edge, (size_t)a->nedges * sizeof *a->edge);
    a->edge = NULL;
    a->nedges = 0;
}

ix_status ix__edges_take(ix__edges *l, ix_arrangement *a, ix_status st)
{
    size_t bytes = (size_t)l->n * sizeof *l->e;
    ix_arr_edge *e = NULL;

    if (st == IX_OK && l->n) {
        e = ix__alloc(l->ctx, bytes);
        st = e ? IX_OK : IX_ENOMEM;
    }
    if (st != IX_OK) {
        for (int i = 0; i < l->n; i++)
            ix_mv_unref(l->ctx, l->e[i].crv);
        return st;
    }
    ix__arr_forget(l->ctx, a);
    free_edges(l->ctx, a);
    if (e)
        memcpy(e, l->e, bytes);
    a->edge = e;
    a->nedges = l->n;
    return IX_OK;
}

/* --- making ----------------------------------------------------------------
 */

/* Do the ends meet, and is there more to it than a point? */
static bool is_closed(const ix__marks *m, double tol)
{
    double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

    ix__path_point(&m->path, m->dom[0], p);
    ix__path_point(&m->path, m->dom[1], q);
    return hypot(p[0] - q[0], p[1] - q[1]) <= tol && m->size > tol;
}

/* An open B-spline of two coordinates. */
static ix_status plain(ix_ctx *ctx, const ix_mv *crv, ix_mv **out)
{
    ix_mv *step[3] = {NULL};
    ix_status st = IX_OK;

    if (ix_mv_dir(crv, 0).basis == IX_POWER)
        st = ix_mv_power_to_bezier(ctx, crv, &step[0]);
    else
        step[0] = ix_mv_ref(crv);
    if (st == IX_OK)
        st = ix_mv_coerce(ctx, step[0], 2, ix_mv_rational(crv), &step[1]);
    if (st == IX_OK)
        st = ix_mv_to_bspline(ctx, step[1], &step[2]);
    if (st == IX_OK)
        st = ix_mv_to_open(ctx, step[2], out);
    for (int k = 0; k < 3; k++)
        ix_mv_unref(ctx, step[k]);
    return st;
}

static ix_status add_curve(ix__edges *l, const ix_mv *crv, int source,
                           double tol)
{
    ix__marks m;
    ix_mv *own;
    ix_status st;

    if (ix_mv_ndirs(crv) != 1 || ix_mv_ncoords(crv) < 2 ||
        ix_mv_ncoords(crv) > 3)
        return IX_FAIL(l->ctx, IX_EARG,
                       "curve %d has %d directions and %d coordinates; a curve "
                       "of 2 or 3 is wanted",
                       source + 1, ix_mv_ndirs(crv), ix_mv_ncoords(crv));
    IX_TRY(plain(l->ctx, crv, &own));
    st = ix__marks_ends(l->ctx, own, &m);
    if (st != IX_OK) {
        ix_mv_unref(l->ctx, own);
        return st;
    }
    return ix__edges_add(l, own, source, is_closed(&m, tol));
}

static ix_status make(ix_ctx *ctx, int n, const ix_mv *const *crv, double tol,
                      ix_arrangement **out)
{
    ix_arrangement *a = ix__alloc(ctx, sizeof *a);
    ix__edges l = {.ctx = ctx};
    ix_status st = IX_OK;

    if (!a)
        return IX_ENOMEM;
    *a = (ix_arrangement){.tol = tol};
    for (int i = 0; st == IX_OK && i < n; i++)
        st = add_curve(&l, crv[i], i, tol);
    st = ix__edges_take(&l, a, st);
    if (st == IX_OK)
        *out = a;
    else
        ix_arrangement_free(ctx, a);
    return st;
}

ix_status ix_arrangement_new(ix_ctx *ctx, int n, const ix_mv *const *crv,
                             double tol, ix_arrangement **out)
{
    *out = NULL;
    if (n < 0 || !(tol > 0) || !isfinite(tol))
        return IX_FAIL(ctx, IX_EARG,
                       "%d curves, tolerance %g; a positive one is wanted", n,
                       tol);
    IX_RETURN_SCOPED(ctx, make(ctx, n, crv, tol, out));
}

static ix_status copy(ix_ctx *ctx, const ix_arrangement *a,
                      ix_arrangement **out)
{
    ix_arrangement *b;
    ix__edges l = {.ctx = ctx};
    ix_status st = IX_OK;

    IX_TRY(make(ctx, 0, NULL, a->tol, &b));
    for (int i = 0; st == IX_OK && i < a->nedges; i++)
        st = ix__edges_add(&l, ix_mv_ref(a->edge[i].crv), a->edge[i].source,
                           a->edge[i].turns);
    st = ix__edges_take(&l, b, st);
    if (st == IX_OK)
        *out = b;
    else
        ix_arrangement_free(ctx, b);
    return st;
}

ix_status ix_arrangement_copy(ix_ctx *ctx, const ix_arrangement *a,
                              ix_arrangement **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, copy(ctx, a, out));
}

void ix_arrangement_free(ix_ctx *ctx, ix_arrangement *a)
{
    if (!a)
        return;
    ix__arr_forget(ctx, a);
    free_edges(ctx, a);
    ix__free(ctx, a, sizeof *a);
}

/* --- vertices --------------------------------------------------------------
 */

typedef struct {
    double x, y;
    int end;
} place;

static int by_x(const void *a, const void *b)
{
    const place *p = a, *q = b;

    if (p->x < q->x || p->x > q->x)
        return p->x < q->x ? -1 : 1;
    return p->end - q->end;
}

static int root_of(int *up, int i)
{
    while (up[i] != i)
        i = up[i] = up[up[i]];
    return i;
}

static ix_status ends_of(ix_ctx *ctx, const ix_arrangement *a, place *p)
{
    for (int e = 0; e < a->nedges; e++) {
        double dom[2], x[2];

        ix_mv_domain(a->edge[e].crv, 0, dom);
        for (int k = 0; k < 2; k++) {
            IX_TRY(ix_mv_point(ctx, a->edge[e].crv, &dom[k], x));
            p[2 * e + k] = (place){x[0], x[1], 2 * e + k};
        }
    }
    return IX_OK;
}

/* Neighbours along a sweep in x fall into one set. */
static void cluster(const place *p, int n, double tol, int *up)
{
    for (int i = 0; i < n; i++)
        up[i] = i;
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n && p[j].x - p[i].x <= tol; j++)
            if (hypot(p[j].x - p[i].x, p[j].y - p[i].y) <= tol) {
                int r = root_of(up, p[i].end), s = root_of(up, p[j].end);

                up[r > s ? r : s] = r > s ? s : r;
            }
}

ix_status ix__arr_vertices(ix_ctx *ctx, const ix_arrangement *a, int **vertex,
                           int *n, double (**mean)[2])
{
    int ends = 2 * a->nedges, *up, *count;
    place *p;

    *n = 0;
    IX_SCRATCH(ctx, *vertex, ends);
    IX_SCRATCH_ZERO(ctx, *mean, ends);
    IX_SCRATCH_ZERO(ctx, count, ends);
    IX_SCRATCH(ctx, up, ends);
    IX_SCRATCH(ctx, p, ends);
    if (!ends)
        return IX_OK;
    IX_TRY(ends_of(ctx, a, p));
    qsort(p, (size_t)ends, sizeof *p, by_x);
    cluster(p, ends, a->tol, up);
    for (int i = 0; i < ends; i++) /* roots are the smallest of their sets */
        (*vertex)[i] = root_of(up, i) == i ? (*n)++ : (*vertex)[root_of(up, i)];
    for (int i = 0; i < ends; i++) {
        int v = (*vertex)[p[i].end];

        count[v]++;
        (*mean)[v][0] += (p[i].x - (*mean)[v][0]) / count[v];
        (*mean)[v][1] += (p[i].y - (*mean)[v][1]) / count[v];
    }
    return IX_OK;
}

/* --- end to end ------------------------------------------------------------
 */

ix_status ix__crv_chain(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        ix_mv **out)
{
    double da[2], db[2], p[2], q[2], size = 0;

    ix_mv_domain(a, 0, da);
    ix_mv_domain(b, 0, db);
    IX_TRY(ix_mv_point(ctx, a, &da[1], p));
    IX_TRY(ix_mv_point(ctx, b, &db[0], q));
    for (int k = 0; k < 2; k++)
        size = fmax(size, fmax(fabs(p[k]), fabs(q[k])));
    return ix_mv_merge(ctx, a, b, 0,
                       hypot(p[0] - q[0], p[1] - q[1]) <= 1e-9 * size
                           ? IX_JOIN_SHARED
                           : IX_JOIN_BRIDGE,
                       out);
}
