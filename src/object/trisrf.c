/* trisrf.c - triangular surfaces as one counted block: header, knots, points
 * double[axes][npts] with the weight first. Rows of decreasing length; the
 * second points of Gregory twists come last. */
#include <string.h>

#include "object/release_impl.h"

static int trisrf_npts(ix_tri_kind kind, int length)
{
    return length * (length + 1) / 2 + (kind == IX_TRI_GREGORY ? 3 : 0);
}

static size_t trisrf_bytes(const ix_trisrf *t)
{
    size_t axes = (size_t)t->ncoords + (t->rational ? 1 : 0);

    return sizeof *t +
           ((size_t)t->nknots + axes * (size_t)t->npts) * sizeof(double);
}

ix_trisrf *ix__trisrf_new(ix_ctx *ctx, ix_tri_kind kind, int length, int order,
                          int ncoords, bool rational)
{
    ix_trisrf shape = {.refs = 1,
                       .kind = kind,
                       .length = length,
                       .order = order,
                       .ncoords = ncoords,
                       .rational = rational};
    ix_trisrf *t;

    shape.nknots = kind == IX_TRI_BSPLINE ? length + order : 0;
    shape.npts = trisrf_npts(kind, length);
    t = ix__alloc(ctx, trisrf_bytes(&shape));
    if (!t)
        return NULL;
    memset(t, 0, trisrf_bytes(&shape));
    *t = shape;
    t->knots = (double *)(t + 1);
    t->pts = t->knots + t->nknots;
    return t;
}

const ix_trisrf *ix__trisrf_ref(const ix_trisrf *t)
{
    IX_MUTABLE(ix_trisrf, t)->refs++;
    return t;
}

void ix__trisrf_unref(ix_ctx *ctx, const ix_trisrf *t)
{
    ix_trisrf *b = IX_MUTABLE(ix_trisrf, t);

    if (b && --b->refs == 0)
        ix__free(ctx, b, trisrf_bytes(b));
}
