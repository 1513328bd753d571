/* plane_chain.c - runs in the order in which they follow one another along the
 * bisector. Around the border of a curve that does not cross itself that is
 * their order there; where it does, what is free of its border at one circle
 * that touches three times need not come next around it. */
#include "ops/plane_walk_impl.h"

/* Runs first[i] .. first[i + 1] - 1, each joined to that before it. */
typedef struct {
    const ix__walked *w;
    int n;
    int *first;
    int *next, *last; /* blocks behind and before it; -1: none */
} blocks;

/* The centre where block i begins (end 0) or ends (1); NULL: at infinity. */
static const ix__sample *end_of(const blocks *b, int i, int end)
{
    const ix__run *r = &b->w->run[end ? b->first[i + 1] - 1 : b->first[i]];

    return r->far[end] ? NULL : ix__run_at(b->w, r, end ? r->count - 1 : 0);
}

static ix_status find_blocks(ix_ctx *ctx, const ix__walked *w, blocks *b)
{
    *b = (blocks){.w = w};
    IX_SCRATCH(ctx, b->first, w->nruns + 1);
    IX_SCRATCH(ctx, b->next, w->nruns + 1);
    IX_SCRATCH(ctx, b->last, w->nruns + 1);
    for (int i = 0; i < w->nruns; i++)
        if (i == 0 || !w->run[i].joined) {
            b->next[b->n] = b->last[b->n] = -1;
            b->first[b->n++] = i;
        }
    b->first[b->n] = w->nruns;
    return IX_OK;
}

/* The block that begins where block i ends, if nothing else begins or ends
 * there; -1 otherwise. */
static int follower(const blocks *b, int i)
{
    const ix__sample *at = end_of(b, i, 1);
    int found = -1;

    for (int j = 0; at && j < b->n; j++)
        for (int e = 0; e < 2; e++) {
            const ix__sample *s = end_of(b, j, e);

            if ((j == i && e == 1) || !s || !ix__centres_meet(at, s))
                continue;
            if (e == 1 || found >= 0)
                return -1;
            found = j;
        }
    return found == i ? -1 : found;
}

/* Block i and those behind it, as far as they are not out already. */
static void put_chain(const blocks *b, int i, bool *done, ix__run *out, int *n)
{
    bool joined = false;

    while (i >= 0 && !done[i]) {
        int at = *n;

        for (int j = b->first[i]; j < b->first[i + 1]; j++)
            out[(*n)++] = b->w->run[j];
        out[at].joined = joined;
        joined = true;
        done[i] = true;
        i = b->next[i];
    }
}

ix_status ix__walked_chain(ix_ctx *ctx, ix__walked *w)
{
    int n = 0;
    ix__run *out;
    bool *done;
    blocks b;

    IX_TRY(find_blocks(ctx, w, &b));
    IX_SCRATCH_ZERO(ctx, done, b.n + 1);
    IX_SCRATCH(ctx, out, w->nruns + 1);
    for (int i = 0; i < b.n; i++) {
        int j = follower(&b, i);

        b.next[i] = j;
        if (j >= 0)
            b.last[j] = i;
    }
    for (int pass = 0; pass < 2; pass++) /* what is closed begins anywhere */
        for (int i = 0; i < b.n; i++)
            if (pass == 1 || b.last[i] < 0)
                put_chain(&b, i, done, out, &n);
    w->run = out;
    w->room = w->nruns + 1;
    return IX_OK;
}
