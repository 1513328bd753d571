/* recognize_obj.c - the result of geom/recognize as a script list. */
#include "lang/recognize_obj.h"

#include "geom/recognize.h"
#include "lang/builtin.h"

/* The parameters of a kind behind the flag. */
static ix_status add_params(ix_ctx *ctx, ix_obj *list, int kind,
                            const ix__geom_fit *f)
{
    switch (kind) {
    case IX_KIND_CONST:
        return ix__list_add(ctx, list, ix__obj_point(ctx, f->point));
    case IX_KIND_LINEAR:
    case IX_KIND_REVOLUTION:
        IX_TRY(ix__list_add(ctx, list, ix__obj_point(ctx, f->point)));
        return ix__list_add(ctx, list, ix__obj_vector(ctx, f->dir));
    case IX_KIND_CIRCULAR:
    case IX_KIND_SPHERICAL:
        IX_TRY(ix__list_add(ctx, list, ix__obj_point(ctx, f->point)));
        return ix__list_add_num(ctx, list, f->radius);
    case IX_KIND_PLANAR:
        return ix__list_add(ctx, list, ix__obj_plane(ctx, f->plane));
    case IX_KIND_EXTRUSION:
        return ix__list_add(ctx, list, ix__obj_vector(ctx, f->dir));
    default:
        return IX_OK;
    }
}

ix_status ix__recognize_obj(ix_ctx *ctx, const ix_obj *o, int kind, double eps,
                            ix_obj **out)
{
    ix__geom_fit fit;
    ix_obj *list;
    ix_status st;

    if ((o->type != IX_OBJ_CURVE && o->type != IX_OBJ_SURFACE) ||
        o->u.mvs->n != 1)
        return IX_FAIL(ctx, IX_EARG, "a single curve or surface is needed");
    IX_TRY(ix__recognize(ctx, o->u.mvs->mv[0], (ix__geom_kind)kind, eps, &fit));
    list = ix__obj_list(ctx);
    if (!list)
        return IX_ENOMEM;
    st = ix__list_add_num(ctx, list, fit.flag);
    if (st == IX_OK && fit.flag)
        st = add_params(ctx, list, kind, &fit);
    if (st == IX_OK)
        *out = list;
    else
        ix__obj_unref(ctx, list);
    return st;
}
