/* deep_copy.c - copying and walking hierarchies of lists box by box. The
 * recursion is bounded by the depth that files can have, too. */
#include "lang/deep_copy.h"

#include "io/io.h"

/* Boxes that one object may spread out to: 200 MB of copies. */
#define MAX_BOXES 1000000

typedef struct {
    ix_ctx *ctx;
    int boxes; /* met so far */
    ix_obj **leaf;
    int nleaves;
} walk;

static ix_status step(walk *w, int depth)
{
    if (depth > IX_MAX_DEPTH)
        return IX_FAIL(w->ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       IX_MAX_DEPTH);
    if (++w->boxes > MAX_BOXES)
        return IX_FAIL(w->ctx, IX_EUNABLE,
                       "shared lists spread out to more than %d objects",
                       MAX_BOXES);
    return IX_OK;
}

static ix_status copy(walk *w, const ix_obj *o, int depth, ix_obj **out)
{
    ix_obj *c;

    IX_TRY(step(w, depth));
    c = ix__obj_copy(w->ctx, o);
    if (!c)
        return IX_ENOMEM;
    for (int i = 0; c->type == IX_OBJ_LIST && i < c->u.list.n; i++) {
        ix_obj *shared = c->u.list.item[i], *own;
        ix_status st = copy(w, shared, depth + 1, &own);

        if (st != IX_OK) {
            ix__obj_unref(w->ctx, c);
            return st;
        }
        c->u.list.item[i] = own;
        ix__obj_unref(w->ctx, shared);
    }
    *out = c;
    return IX_OK;
}

ix_status ix__deep_copy(ix_ctx *ctx, const ix_obj *o, ix_obj **out)
{
    walk w = {.ctx = ctx};

    return copy(&w, o, 1, out);
}

/* Counts the leaves; stores them where there is room. */
static ix_status collect(walk *w, ix_obj *o, int depth)
{
    IX_TRY(step(w, depth));
    if (o->type != IX_OBJ_LIST) {
        if (w->leaf)
            w->leaf[w->nleaves] = o;
        w->nleaves++;
        return IX_OK;
    }
    for (int i = 0; i < o->u.list.n; i++)
        IX_TRY(collect(w, o->u.list.item[i], depth + 1));
    return IX_OK;
}

ix_status ix__leaves(ix_ctx *ctx, ix_obj *o, int *n, ix_obj ***out)
{
    walk count = {.ctx = ctx}, fill = {.ctx = ctx};

    IX_TRY(collect(&count, o, 1));
    IX_SCRATCH(ctx, fill.leaf, count.nleaves);
    IX_TRY(collect(&fill, o, 1));
    *n = fill.nleaves;
    *out = fill.leaf;
    return IX_OK;
}
