/* poly_lines.c - see the header. */
#include "lang/poly_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/chain_segments.h"
#include "geom/vec3.h"
#include "lang/args_freeform.h"

typedef double segment[2][3];

static ix_status ret_segments(ix_call *c, int n, const segment *seg)
{
    ix_lines l;
    ix_status st;

    IX_TRY(ix__chain_segments(c->ctx, n, (const double(*)[2][3])seg, &l));
    st = l.n ? ix__ret_lines(c, &l, IX_POLYLINE) : IX_OK;
    ix_lines_free(c->ctx, &l);
    return st;
}

/* Edges of a polygon, one less of a polyline, none of points. */
static int edges_of(const ix_polygon *pg)
{
    return pg->kind == IX_POLYGON    ? pg->n
           : pg->kind == IX_POLYLINE ? pg->n - (pg->n > 0)
                                     : 0;
}

static int all_edges(const ix_poly *p)
{
    int n = 0;

    for (int i = 0; i < p->n; i++)
        n += edges_of(&p->poly[i]);
    return n;
}

/* --- planes ------------------------------------------------------------- */

static double height(const double plane[4], const double p[3])
{
    return ix__dot3(plane, p) + plane[3];
}

/* Where the edge from vertex k crosses the plane; false if it does not. The
 * same bits whichever way the edge runs. */
static bool crossing(const ix_polygon *pg, int k, const double plane[4],
                     double out[3])
{
    const double *a = pg->v[k].p, *b = pg->v[(k + 1) % pg->n].p;
    double ha = height(plane, a), hb = height(plane, b);

    if ((ha < 0) == (hb < 0))
        return false;
    if (hb < 0) {
        const double *p = a;
        double h = ha;

        a = b;
        b = p;
        ha = hb;
        hb = h;
    }
    for (int i = 0; i < 3; i++)
        out[i] = b[i] + (a[i] - b[i]) * (hb / (hb - ha));
    return true;
}

typedef struct {
    double s, p[3];
} mark;

static int by_s(const void *a, const void *b)
{
    const mark *p = a, *q = b;

    return (p->s > q->s) - (p->s < q->s);
}

/* The plane cuts the polygon's own along a line; crossings in order along it
 * bound what is inside pair by pair, also where it is not convex. */
static int cut(const ix_polygon *pg, const double plane[4], mark *m,
               segment *seg)
{
    double along[3], n[3];
    int k = 0;

    for (int i = 0; i < pg->n; i++)
        k += crossing(pg, i, plane, m[k].p);
    memcpy(n, pg->plane, sizeof n);
    ix__cross3(n, plane, along);
    for (int i = 0; i < k; i++)
        m[i].s = ix__dot3(along, m[i].p);
    qsort(m, (size_t)k, sizeof *m, by_s);
    for (int i = 0; i + 1 < k; i += 2) {
        memcpy(seg[i / 2][0], m[i].p, sizeof seg[0][0]);
        memcpy(seg[i / 2][1], m[i + 1].p, sizeof seg[0][0]);
    }
    return k / 2;
}

/* Crossings of polylines as a list of points. */
static ix_status ret_points(ix_call *c, const ix_poly *p, const double plane[4])
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; i < p->n; i++)
        for (int k = 0; k < edges_of(&p->poly[i]) && st == IX_OK; k++) {
            double x[3];

            if (crossing(&p->poly[i], k, plane, x))
                st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, x));
        }
    return ix__ret_list(c, list, st);
}

ix_status ix__ret_poly_contour(ix_call *c, const ix_poly *p,
                               const double plane[4])
{
    int n = all_edges(p), nseg = 0;
    segment *seg;
    mark *m;

    if (p->n > 0 && p->poly[0].kind == IX_POLYLINE)
        return ret_points(c, p, plane);
    IX_SCRATCH(c->ctx, seg, n);
    IX_SCRATCH(c->ctx, m, n + 1); /* the last is written before it is counted */
    for (int i = 0; i < p->n; i++) {
        IX_TRY(ix__poll(c->ctx));
        if (p->poly[i].kind == IX_POLYGON)
            nseg += cut(&p->poly[i], plane, m, seg + nseg);
    }
    return ret_segments(c, nseg, (const segment *)seg);
}

/* --- silhouettes ---------------------------------------------------------- */

/* An edge with its ends in order on the grid, and whether its polygon faces the
 * view. */
typedef struct {
    double cell[2][3];
    const double *end[2];
    bool front;
} edge;

static int by_cells(const void *a, const void *b)
{
    const edge *p = a, *q = b;

    for (int k = 0; k < 6; k++) {
        double x = p->cell[k / 3][k % 3], y = q->cell[k / 3][k % 3];

        if (x < y || x > y)
            return x < y ? -1 : 1;
    }
    return 0;
}

static double extent(const ix_poly *p)
{
    double size = 0;

    for (int k = 0; k < 3; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;

        for (int i = 0; i < p->n; i++)
            for (int v = 0; v < p->poly[i].n; v++) {
                lo = fmin(lo, p->poly[i].v[v].p[k]);
                hi = fmax(hi, p->poly[i].v[v].p[k]);
            }
        size = fmax(size, hi - lo);
    }
    return size;
}

static void make_edge(const double *a, const double *b, double step, edge *e)
{
    const double *end[2] = {a, b};

    for (int k = 0; k < 6; k++)
        e->cell[k / 3][k % 3] = floor(end[k / 3][k % 3] / step + 0.5);
    memcpy(e->end, end, sizeof end);
    for (int k = 0; k < 3; k++) {
        double x = e->cell[0][k], y = e->cell[1][k];

        if (x < y)
            return;
        if (x > y) {
            double t[3];

            memcpy(t, e->cell[0], sizeof t);
            memcpy(e->cell[0], e->cell[1], sizeof t);
            memcpy(e->cell[1], t, sizeof t);
            e->end[0] = b;
            e->end[1] = a;
            return;
        }
    }
}

static int collect_edges(const ix_poly *p, const double view[3], edge *e)
{
    double step = 1e-9 * extent(p);
    int n = 0;

    for (int i = 0; i < p->n && step > 0; i++) {
        const ix_polygon *pg = &p->poly[i];

        if (pg->kind != IX_POLYGON || !pg->has_plane)
            continue;
        for (int k = 0; k < pg->n; k++) {
            make_edge(pg->v[k].p, pg->v[(k + 1) % pg->n].p, step, &e[n]);
            e[n++].front = ix__dot3(pg->plane, view) > 0;
        }
    }
    return n;
}

ix_status ix__ret_poly_silhouette(ix_call *c, const ix_poly *p,
                                  const double view[3])
{
    int n = all_edges(p), nseg = 0;
    segment *seg;
    edge *e;

    IX_SCRATCH(c->ctx, e, n);
    IX_SCRATCH(c->ctx, seg, n);
    n = collect_edges(p, view, e);
    if (n > 0)
        qsort(e, (size_t)n, sizeof *e, by_cells);
    for (int i = 0; i + 1 < n; i++) {
        if (by_cells(&e[i], &e[i + 1]) != 0)
            continue;
        if (e[i].front != e[i + 1].front) {
            memcpy(seg[nseg][0], e[i].end[0], sizeof seg[0][0]);
            memcpy(seg[nseg++][1], e[i].end[1], sizeof seg[0][0]);
        }
        i++;
    }
    return ret_segments(c, nseg, (const segment *)seg);
}
