/* trimsrf.c - trimmed surfaces: a surface and loops of curves in its
 * parameter plane. Immutable once built, counted. */
#include <string.h>

#include "object/release_impl.h"

static size_t trimsrf_bytes(int nloops)
{
    return sizeof(ix_trimsrf) + (size_t)nloops * sizeof(ix_trimloop);
}

ix_trimsrf *ix__trimsrf_new(ix_ctx *ctx, const ix_mv *srf, int nloops)
{
    ix_trimsrf *t = ix__alloc(ctx, trimsrf_bytes(nloops));

    if (!t)
        return NULL;
    memset(t, 0, trimsrf_bytes(nloops));
    t->refs = 1;
    t->srf = ix_mv_ref(srf);
    t->nloops = nloops;
    t->loop = (ix_trimloop *)(t + 1);
    return t;
}

ix_status ix__trimloop_segs(ix_ctx *ctx, ix_trimloop *l, int n)
{
    size_t bytes = (size_t)n * sizeof *l->seg;

    if (n == 0)
        return IX_OK;
    l->seg = ix__alloc(ctx, bytes);
    if (!l->seg)
        return IX_ENOMEM;
    memset(l->seg, 0, bytes);
    l->n = n;
    return IX_OK;
}

const ix_trimsrf *ix__trimsrf_ref(const ix_trimsrf *t)
{
    IX_MUTABLE(ix_trimsrf, t)->refs++;
    return t;
}

static void drop_loop(ix_ctx *ctx, ix_trimloop *l)
{
    for (int i = 0; i < l->n; i++) {
        ix_mv_unref(ctx, l->seg[i].uv);
        ix_mv_unref(ctx, l->seg[i].euclid);
    }
    ix__free(ctx, l->seg, (size_t)l->n * sizeof *l->seg);
}

void ix__trimsrf_unref(ix_ctx *ctx, const ix_trimsrf *t)
{
    ix_trimsrf *b = IX_MUTABLE(ix_trimsrf, t);

    if (!b || --b->refs > 0)
        return;
    for (int i = 0; i < b->nloops; i++)
        drop_loop(ctx, &b->loop[i]);
    ix_mv_unref(ctx, b->srf);
    ix__free(ctx, b, trimsrf_bytes(b->nloops));
}
