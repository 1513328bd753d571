/* model.c - models: surfaces bounded by loops of shared segments. Immutable
 * once built, counted; surfaces and segments lie in the model's own block. */
#include <string.h>

#include "object/release_impl.h"

static size_t model_bytes(int nsrf, int nseg)
{
    return sizeof(ix_model) + (size_t)nsrf * sizeof(ix_model_srf) +
           (size_t)nseg * sizeof(ix_model_seg);
}

ix_model *ix__model_new(ix_ctx *ctx, int nsrf, int nseg)
{
    ix_model *m = ix__alloc(ctx, model_bytes(nsrf, nseg));

    if (!m)
        return NULL;
    memset(m, 0, model_bytes(nsrf, nseg));
    m->refs = 1;
    m->nsrf = nsrf;
    m->nseg = nseg;
    m->srf = (ix_model_srf *)(m + 1);
    m->seg = (ix_model_seg *)(m->srf + nsrf);
    return m;
}

ix_status ix__model_loops(ix_ctx *ctx, ix_model_srf *s, int n)
{
    size_t count = (size_t)n;

    if (n == 0)
        return IX_OK;
    s->nseg = ix__alloc(ctx, count * sizeof *s->nseg);
    if (!s->nseg)
        return IX_ENOMEM;
    s->seg = ix__alloc(ctx, count * sizeof *s->seg);
    if (!s->seg) {
        ix__free(ctx, s->nseg, count * sizeof *s->nseg);
        s->nseg = NULL;
        return IX_ENOMEM;
    }
    memset(s->nseg, 0, count * sizeof *s->nseg);
    memset(s->seg, 0, count * sizeof *s->seg);
    s->nloops = n;
    return IX_OK;
}

ix_status ix__model_loop_segs(ix_ctx *ctx, ix_model_srf *s, int loop, int n)
{
    if (n == 0)
        return IX_OK;
    s->seg[loop] = ix__alloc(ctx, (size_t)n * sizeof *s->seg[loop]);
    if (!s->seg[loop])
        return IX_ENOMEM;
    memset(s->seg[loop], 0, (size_t)n * sizeof *s->seg[loop]);
    s->nseg[loop] = n;
    return IX_OK;
}

const ix_model *ix__model_ref(const ix_model *m)
{
    IX_MUTABLE(ix_model, m)->refs++;
    return m;
}

static void drop_surface(ix_ctx *ctx, ix_model_srf *s)
{
    for (int i = 0; i < s->nloops; i++)
        ix__free(ctx, s->seg[i], (size_t)s->nseg[i] * sizeof *s->seg[i]);
    ix__free(ctx, s->seg, (size_t)s->nloops * sizeof *s->seg);
    ix__free(ctx, s->nseg, (size_t)s->nloops * sizeof *s->nseg);
    ix_mv_unref(ctx, s->srf);
}

void ix__model_unref(ix_ctx *ctx, const ix_model *m)
{
    ix_model *b = IX_MUTABLE(ix_model, m);

    if (!b || --b->refs > 0)
        return;
    for (int i = 0; i < b->nsrf; i++)
        drop_surface(ctx, &b->srf[i]);
    for (int i = 0; i < b->nseg; i++) {
        ix_mv_unref(ctx, b->seg[i].uv1);
        ix_mv_unref(ctx, b->seg[i].uv2);
        ix_mv_unref(ctx, b->seg[i].euclid);
    }
    ix__free(ctx, b, model_bytes(b->nsrf, b->nseg));
}
