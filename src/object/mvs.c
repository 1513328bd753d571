/* mvs.c - a linked sequence of freeforms as one counted block. */
#include "object/release_impl.h"

static size_t mvs_bytes(int n)
{
    return sizeof(ix_mvs) + (size_t)n * sizeof(const ix_mv *);
}

const ix_mvs *ix__mvs_new(ix_ctx *ctx, int n, const ix_mv *const *mv)
{
    ix_mvs *m = ix__alloc(ctx, mvs_bytes(n));

    if (!m)
        return NULL;
    *m = (ix_mvs){.refs = 1, .n = n, .mv = (const ix_mv **)(m + 1)};
    for (int i = 0; i < n; i++)
        m->mv[i] = ix_mv_ref(mv[i]);
    return m;
}

const ix_mvs *ix__mvs_ref(const ix_mvs *m)
{
    IX_MUTABLE(ix_mvs, m)->refs++;
    return m;
}

void ix__mvs_unref(ix_ctx *ctx, const ix_mvs *m)
{
    ix_mvs *b = IX_MUTABLE(ix_mvs, m);

    if (!b || --b->refs > 0)
        return;
    for (int i = 0; i < b->n; i++)
        ix_mv_unref(ctx, b->mv[i]);
    ix__free(ctx, b, mvs_bytes(b->n));
}
