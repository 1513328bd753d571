/* poly.c - polygonal data: one block for the polygons, one for the vertices
 * of each. Immutable once its builder has handed it on; copies share it. */
#include <math.h>
#include <string.h>

#include "object/release_impl.h"

static size_t poly_bytes(int n)
{
    return sizeof(ix_poly) + (size_t)n * sizeof(ix_polygon);
}

ix_poly *ix__poly_new(ix_ctx *ctx, int npolys)
{
    ix_poly *p = ix__alloc(ctx, poly_bytes(npolys));

    if (!p)
        return NULL;
    memset(p, 0, poly_bytes(npolys));
    p->refs = 1;
    p->n = npolys;
    p->poly = (ix_polygon *)(p + 1);
    return p;
}

ix_status ix__poly_vertices(ix_ctx *ctx, ix_polygon *pg, int n)
{
    size_t bytes = (size_t)n * sizeof *pg->v;

    if (n == 0)
        return IX_OK;
    pg->v = ix__alloc(ctx, bytes);
    if (!pg->v)
        return IX_ENOMEM;
    memset(pg->v, 0, bytes);
    pg->n = n;
    return IX_OK;
}

static void drop_polygon(ix_ctx *ctx, ix_polygon *pg, ix_obj **dead)
{
    for (int i = 0; i < pg->n; i++)
        ix__attr_drop_all(ctx, &pg->v[i].attrs, dead);
    ix__attr_drop_all(ctx, &pg->attrs, dead);
    ix__free(ctx, pg->v, (size_t)pg->n * sizeof *pg->v);
}

void ix__poly_drop(ix_ctx *ctx, const ix_poly *p, ix_obj **dead)
{
    ix_poly *m = IX_MUTABLE(ix_poly, p);

    if (!m || --m->refs > 0)
        return;
    for (int i = 0; i < m->n; i++)
        drop_polygon(ctx, &m->poly[i], dead);
    ix__free(ctx, m, poly_bytes(m->n));
}

void ix__poly_unref(ix_ctx *ctx, const ix_poly *p)
{
    ix_obj *dead = NULL;

    ix__poly_drop(ctx, p, &dead);
    ix__obj_release_dead(ctx, dead);
}

const ix_poly *ix__poly_ref(const ix_poly *p)
{
    IX_MUTABLE(ix_poly, p)->refs++;
    return p;
}

ix_status ix__polygon_dup(ix_ctx *ctx, const ix_polygon *from, ix_polygon *to)
{
    to->kind = from->kind;
    to->has_plane = from->has_plane;
    memcpy(to->plane, from->plane, sizeof to->plane);
    IX_TRY(ix__attr_copy_all(ctx, from->attrs, &to->attrs));
    IX_TRY(ix__poly_vertices(ctx, to, from->n));
    for (int i = 0; i < from->n; i++) {
        to->v[i] = from->v[i];
        to->v[i].attrs = NULL;
    }
    for (int i = 0; i < from->n; i++)
        IX_TRY(ix__attr_copy_all(ctx, from->v[i].attrs, &to->v[i].attrs));
    return IX_OK;
}

ix_poly *ix__poly_dup(ix_ctx *ctx, const ix_poly *p)
{
    ix_poly *q = ix__poly_new(ctx, p->n);

    for (int i = 0; q && i < p->n; i++) {
        if (ix__polygon_dup(ctx, &p->poly[i], &q->poly[i]) != IX_OK) {
            ix__poly_unref(ctx, q);
            q = NULL;
        }
    }
    return q;
}

/* Newell's sum (Sutherland, Sproull, Schumacker 1974): twice the area vector,
 * taken about the first vertex so that far polygons keep their digits. */
bool ix__polygon_plane(const ix_polygon *pg, double plane[4])
{
    double n[3] = {0, 0, 0}, c[3] = {0, 0, 0}, size = 0, len;

    for (int i = 0; i < pg->n; i++) {
        const double *o = pg->v[0].p, *p = pg->v[i].p;
        const double *q = pg->v[(i + 1) % pg->n].p;

        for (int k = 0; k < 3; k++) {
            int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            double t = (p[k1] - o[k1]) * (q[k2] - o[k2]) -
                       (p[k2] - o[k2]) * (q[k1] - o[k1]);

            n[k] += t;
            size += fabs(t);
            c[k] += p[k] / pg->n;
        }
    }
    len = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    /* Below n rounding errors of the sum nothing is left of the area. */
    if (!(len > size * 4 * pg->n * 0x1p-53))
        return false;
    for (int k = 0; k < 3; k++)
        plane[k] = n[k] / len;
    plane[3] = 0 - (plane[0] * c[0] + plane[1] * c[1] + plane[2] * c[2]);
    return isfinite(plane[3]);
}
