/* sequence.c - linked sequences: the geometries that one object holds, seen
 * alike whatever their type. */
#include "object/object.h"

int ix__seq_count(const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return o->u.mvs->n;
    case IX_OBJ_TRIMSRF:
        return o->u.trim.n;
    case IX_OBJ_TRISRF:
        return o->u.tri.n;
    case IX_OBJ_MODEL:
        return o->u.model.n;
    default:
        return 0;
    }
}

const void *ix__seq_item(const ix_obj *o, int i)
{
    switch (o->type) {
    case IX_OBJ_TRIMSRF:
        return o->u.trim.item[i];
    case IX_OBJ_TRISRF:
        return o->u.tri.item[i];
    case IX_OBJ_MODEL:
        return o->u.model.item[i];
    default:
        return o->u.mvs->mv[i];
    }
}

void ix__seq_unref(ix_ctx *ctx, ix_obj_type type, const void *item)
{
    switch (type) {
    case IX_OBJ_TRIMSRF:
        ix__trimsrf_unref(ctx, item);
        break;
    case IX_OBJ_TRISRF:
        ix__trisrf_unref(ctx, item);
        break;
    case IX_OBJ_MODEL:
        ix__model_unref(ctx, item);
        break;
    default:
        ix_mv_unref(ctx, item);
        break;
    }
}

ix_obj *ix__seq_new(ix_ctx *ctx, ix_obj_type type, int n, void *items)
{
    switch (type) {
    case IX_OBJ_TRIMSRF:
        return ix__obj_trimsrfs(ctx, n, items);
    case IX_OBJ_TRISRF:
        return ix__obj_trisrfs(ctx, n, items);
    case IX_OBJ_MODEL:
        return ix__obj_models(ctx, n, items);
    default:
        return ix__obj_mvs(ctx, type, ix__mvs_new(ctx, n, items));
    }
}
