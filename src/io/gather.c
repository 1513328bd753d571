/* gather.c - growing arrays in scratch memory. What they grew out of stays
 * there until the reader of the object releases it. */
#include "io/gather.h"

#include <limits.h>
#include <string.h>

ix_status ix__gather(ix_ctx *ctx, int n, int *cap, size_t size, void *items)
{
    void *old, *fresh;

    if (n < *cap)
        return IX_OK;
    if (*cap > INT_MAX / 2 - 8)
        return IX_FAIL(ctx, IX_ENOMEM, "more than %d items", *cap);
    fresh = ix__scratch(ctx, 2 * (size_t)*cap + 8, size);
    if (!fresh)
        return IX_ENOMEM;
    memcpy(&old, items, sizeof old);
    if (n > 0)
        memcpy(fresh, old, (size_t)n * size);
    memcpy(items, &fresh, sizeof fresh);
    *cap = 2 * *cap + 8;
    return IX_OK;
}

ix_status ix__trimming_seg(ix_ctx *ctx, ix__trimming *t, ix_trimseg **s)
{
    IX_TRY(ix__gather(ctx, t->nsegs, &t->seg_cap, sizeof *t->seg,
                      (void *)&t->seg));
    *s = &t->seg[t->nsegs++];
    **s = (ix_trimseg){0};
    return IX_OK;
}

ix_status ix__trimming_loop(ix_ctx *ctx, ix__trimming *t, int first)
{
    IX_TRY(ix__gather(ctx, t->nloops, &t->loop_cap, sizeof *t->size,
                      (void *)&t->size));
    t->size[t->nloops++] = t->nsegs - first;
    return IX_OK;
}

static ix_status fill(ix_ctx *ctx, ix__trimming *t, ix_trimsrf *out)
{
    ix_trimseg *from = t->seg;

    for (int i = 0; i < t->nloops; i++) {
        size_t bytes = (size_t)t->size[i] * sizeof *from;

        IX_TRY(ix__trimloop_segs(ctx, &out->loop[i], t->size[i]));
        memcpy(out->loop[i].seg, from, bytes);
        memset(from, 0, bytes); /* the references have moved */
        from += t->size[i];
    }
    return IX_OK;
}

ix_status ix__trimming_make(ix_ctx *ctx, ix__trimming *t, ix_trimsrf **out)
{
    ix_trimsrf *made = ix__trimsrf_new(ctx, t->srf, t->nloops);
    ix_status st = made ? fill(ctx, t, made) : IX_ENOMEM;

    *out = st == IX_OK ? made : NULL;
    if (st != IX_OK && made)
        ix__trimsrf_unref(ctx, made);
    return st;
}

void ix__trimming_drop(ix_ctx *ctx, ix__trimming *t)
{
    for (int i = 0; i < t->nsegs; i++) {
        ix_mv_unref(ctx, t->seg[i].uv);
        ix_mv_unref(ctx, t->seg[i].euclid);
    }
    ix_mv_unref(ctx, t->srf);
    *t = (ix__trimming){0};
}
