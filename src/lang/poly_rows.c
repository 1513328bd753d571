/* poly_rows.c - polygons between moved copies of polygons or polylines. The
 * polygons are gathered in scratch first, because their number is not known
 * before degenerate ones have been left out. */
#include "lang/poly_rows.h"

#include <limits.h>
#include <string.h>

typedef struct {
    int n;
    double p[4][3];
} quad;

/* Drops corners equal to their predecessor; false if fewer than 3 stay. */
static bool clean(quad *q)
{
    int n = 0;

    for (int i = 0; i < 4; i++) {
        const double *before = n ? q->p[n - 1] : q->p[3];

        if (memcmp(q->p[i], before, sizeof q->p[i]) != 0)
            memmove(q->p[n++], q->p[i], sizeof q->p[i]);
    }
    q->n = n;
    return n >= 3;
}

/* Edges of a polygon, or of a polyline, that rows are made of. */
static int edges(const ix_polygon *pg)
{
    return pg->kind == IX_POLYGON ? pg->n : pg->n > 0 ? pg->n - 1 : 0;
}

static ix_status gather(ix_ctx *ctx, const ix_poly *p, int ncopies,
                        ix__row_fn fn, const void *arg, size_t *count,
                        quad **out)
{
    size_t most = 0, n = 0;
    quad *q;

    for (int i = 0; i < p->n; i++)
        most += (size_t)edges(&p->poly[i]) * (size_t)(ncopies - 1);
    IX_SCRATCH(ctx, q, most);
    for (int i = 0; i < p->n; i++)
        for (int k = 0; k + 1 < ncopies; k++)
            for (int e = 0; e < edges(&p->poly[i]); e++) {
                const ix_vertex *v = p->poly[i].v;
                int f = (e + 1) % p->poly[i].n;

                fn(arg, k, e, v[e].p, q[n].p[0]);
                fn(arg, k, f, v[f].p, q[n].p[1]);
                fn(arg, k + 1, f, v[f].p, q[n].p[2]);
                fn(arg, k + 1, e, v[e].p, q[n].p[3]);
                n += clean(&q[n]);
            }
    *count = n;
    *out = q;
    return IX_OK;
}

ix_status ix__polygon_fill(ix_ctx *ctx, ix_polygon *pg, ix_poly_kind kind,
                           int n, const double (*pts)[3])
{
    IX_TRY(ix__poly_vertices(ctx, pg, n));
    pg->kind = kind;
    for (int i = 0; i < n; i++)
        memcpy(pg->v[i].p, pts[i], sizeof pg->v[i].p);
    if (kind == IX_POLYGON)
        pg->has_plane = ix__polygon_plane(pg, pg->plane);
    return IX_OK;
}

static ix_status add_cap(ix_ctx *ctx, const ix_polygon *from, int k,
                         bool reversed, ix__row_fn fn, const void *arg,
                         ix_polygon *pg)
{
    double(*pts)[3];

    IX_SCRATCH(ctx, pts, from->n);
    for (int i = 0; i < from->n; i++) {
        int v = reversed ? from->n - 1 - i : i;

        fn(arg, k, v, from->v[v].p, pts[i]);
    }
    return ix__polygon_fill(ctx, pg, IX_POLYGON, from->n,
                            (const double(*)[3])pts);
}

static ix_status fill(ix_ctx *ctx, const ix_poly *p, int ncopies, bool caps,
                      ix__row_fn fn, const void *arg, size_t n, const quad *q,
                      ix_poly *out)
{
    ix_polygon *pg = out->poly;

    for (size_t i = 0; i < n; i++)
        IX_TRY(ix__polygon_fill(ctx, pg++, IX_POLYGON, q[i].n,
                                (const double(*)[3])q[i].p));
    for (int i = 0; caps && i < p->n; i++) {
        if (p->poly[i].kind != IX_POLYGON)
            continue;
        IX_TRY(add_cap(ctx, &p->poly[i], 0, true, fn, arg, pg++));
        IX_TRY(add_cap(ctx, &p->poly[i], ncopies - 1, false, fn, arg, pg++));
    }
    return IX_OK;
}

ix_status ix__poly_rows(ix_ctx *ctx, const ix_poly *p, int ncopies, bool caps,
                        ix__row_fn fn, const void *arg, ix_poly **out)
{
    size_t n, ncaps = 0;
    ix_status st;
    quad *q;

    *out = NULL;
    for (int i = 0; caps && i < p->n; i++)
        ncaps += p->poly[i].kind == IX_POLYGON ? 2 : 0;
    IX_TRY(gather(ctx, p, ncopies, fn, arg, &n, &q));
    if (n + ncaps > INT_MAX)
        return IX_FAIL(ctx, IX_EARG, "%zu polygons are too many", n);
    *out = ix__poly_new(ctx, (int)(n + ncaps));
    if (!*out)
        return IX_ENOMEM;
    st = fill(ctx, p, ncopies, caps, fn, arg, n, q, *out);
    if (st == IX_OK)
        return IX_OK;
    ix__poly_unref(ctx, *out);
    *out = NULL;
    return st;
}
