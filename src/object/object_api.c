/* object_api.c - the public face of objects (iritx/object.h). */
#include <math.h>
#include <string.h>

#include "object/object.h"

ix_obj *ix_obj_number(ix_ctx *ctx, double v)
{
    return ix__obj_number(ctx, v);
}

ix_obj *ix_obj_string(ix_ctx *ctx, const char *s)
{
    return ix__obj_string(ctx, s, strlen(s));
}

ix_obj *ix_obj_point(ix_ctx *ctx, const double p[3])
{
    return ix__obj_point(ctx, p);
}

ix_obj *ix_obj_vector(ix_ctx *ctx, const double v[3])
{
    return ix__obj_vector(ctx, v);
}

ix_obj *ix_obj_freeform(ix_ctx *ctx, const ix_mv *m)
{
    return ix__obj_mv(ctx, ix__obj_type_of_mv(m), m);
}

ix_obj *ix_obj_list(ix_ctx *ctx)
{
    return ix__obj_list(ctx);
}

static ix_status append(ix_ctx *ctx, ix_obj *list, ix_obj *o)
{
    if (list->type != IX_OBJ_LIST)
        return IX_FAIL(ctx, IX_EARG, "a list is needed, not a %s",
                       ix__obj_type_name(list->type));
    if (ix__obj_contains(o, list))
        return IX_FAIL(ctx, IX_EARG, "the list would hold itself");
    return ix__obj_append(ctx, list, o);
}

ix_status ix_obj_list_add(ix_ctx *ctx, ix_obj *list, ix_obj *o)
{
    ix_status st = IX_ENOMEM;

    if (o && list)
        st = append(ctx, list, o);
    ix__obj_unref(ctx, o);
    return st;
}

ix_obj *ix_obj_ref(ix_obj *o)
{
    return ix__obj_ref(o);
}

void ix_obj_unref(ix_ctx *ctx, ix_obj *o)
{
    ix__obj_unref(ctx, o);
}

ix_obj_type ix_obj_type_of(const ix_obj *o)
{
    return o->type;
}

const char *ix_obj_name(const ix_obj *o)
{
    return o->name ? o->name : "";
}

ix_status ix_obj_set_name(ix_ctx *ctx, ix_obj *o, const char *name)
{
    return ix__obj_set_name(ctx, o, name);
}

int ix_obj_list_size(const ix_obj *list)
{
    return list->type == IX_OBJ_LIST ? list->u.list.n : 0;
}

ix_obj *ix_obj_list_item(const ix_obj *list, int i)
{
    return i >= 0 && i < ix_obj_list_size(list) ? list->u.list.item[i] : NULL;
}

double ix_obj_num(const ix_obj *o)
{
    return o->type == IX_OBJ_NUMBER ? o->u.num : (double)NAN;
}

const char *ix_obj_str(const ix_obj *o)
{
    return o->type == IX_OBJ_STRING ? o->u.str.s : NULL;
}

bool ix_obj_xyz(const ix_obj *o, double xyz[3])
{
    if (o->type != IX_OBJ_POINT && o->type != IX_OBJ_VECTOR)
        return false;
    memcpy(xyz, o->u.pt, sizeof o->u.pt);
    return true;
}

int ix_obj_mv_count(const ix_obj *o)
{
    return ix__obj_is_freeform(o) ? o->u.mvs->n : 0;
}

const ix_mv *ix_obj_mv(const ix_obj *o, int i)
{
    return i >= 0 && i < ix_obj_mv_count(o) ? o->u.mvs->mv[i] : NULL;
}

ix_status ix_obj_set_attr(ix_ctx *ctx, ix_obj *o, const char *name,
                          const char *value)
{
    return ix__attr_set_string(ctx, &o->attrs, name, value);
}
