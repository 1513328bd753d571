/* animate.c - evaluating animation curves and applying their matrices. The
 * recursion over lists is bounded by the depth that files can have. */
#include "lang/animate.h"

#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "io/io.h"

/* Value of a curve at t, clamped to its domain: its first coordinates, zeros
 * behind them. */
static ix_status value_at(ix_ctx *ctx, const ix_obj *o, double t, double x[3])
{
    const ix_mv *m = ix__obj_first_mv(o);
    double dom[2], *v;

    ix_mv_domain(m, 0, dom);
    t = fmin(fmax(t, dom[0]), dom[1]);
    IX_SCRATCH(ctx, v, ix_mv_ncoords(m));
    IX_TRY(ix_mv_point(ctx, m, &t, v));
    for (int i = 0; i < 3; i++)
        x[i] = i < ix_mv_ncoords(m) ? v[i] : 0;
    return IX_OK;
}

/* The matrix of a curve of that name with value x; false if none has it. */
static bool curve_matrix(const char *name, const double x[3], double m[16])
{
    int axis = name[0] && name[1] ? name[strlen(name) - 1] - 'X' : -1;
    double v[3] = {0, 0, 0}, one[3] = {1, 1, 1};

    if (strcmp(name, "MOV_XYZ") == 0) {
        ix__mat_translate(x, m);
        return true;
    }
    if (strcmp(name, "SCL") == 0) {
        v[0] = v[1] = v[2] = x[0];
        ix__mat_scale(v, m);
        return true;
    }
    if (strlen(name) != 5 || axis < 0 || axis > 2)
        return false;
    v[axis] = one[axis] = x[0];
    if (strncmp(name, "MOV_", 4) == 0)
        ix__mat_translate(v, m);
    else if (strncmp(name, "ROT_", 4) == 0)
        ix__mat_rotate(axis, x[0], m);
    else if (strncmp(name, "SCL_", 4) == 0)
        ix__mat_scale(one, m);
    else
        return false;
    return true;
}

/* One entry of an animation: m is multiplied by it, or visible set. */
static ix_status apply_entry(ix_ctx *ctx, const ix_obj *e, double t,
                             double m[16], bool *visible)
{
    const char *name = e->name ? e->name : "";
    double x[3], f[16];

    if (e->type == IX_OBJ_MATRIX) {
        ix__mat_mul(m, e->u.mat, m);
        return IX_OK;
    }
    if (e->type != IX_OBJ_CURVE)
        return IX_FAIL(ctx, IX_EARG,
                       "an animation holds curves and matrices, not %s",
                       ix__obj_type_name(e->type));
    IX_TRY(value_at(ctx, e, t, x));
    if (strcmp(name, "VISIBLE") == 0) {
        *visible = x[0] > 0;
        return IX_OK;
    }
    if (!curve_matrix(name, x, f))
        return IX_FAIL(ctx, IX_EARG,
                       "an animation curve is named MOV_X, ROT_Y, SCL, ..., "
                       "not \"%.40s\"",
                       name);
    ix__mat_mul(m, f, m);
    return IX_OK;
}

/* The matrix of o's own animation at t. */
static ix_status own_matrix(ix_ctx *ctx, const ix_obj *o, double t,
                            double m[16], bool *visible)
{
    const ix_attr *a = ix__attr_find(o->attrs, "animation");

    ix__mat_identity(m);
    *visible = true;
    if (!a || a->type != IX_ATTR_OBJ)
        return IX_OK;
    if (a->obj->type != IX_OBJ_LIST)
        return apply_entry(ctx, a->obj, t, m, visible);
    for (int i = 0; i < a->obj->u.list.n; i++)
        IX_TRY(apply_entry(ctx, a->obj->u.list.item[i], t, m, visible));
    return IX_OK;
}

typedef struct {
    ix_ctx *ctx;
    double t;
    bool matrices;
} anim;

/* o under matrix m; values without a place stay as they are. */
static ix_status transformed(const anim *a, const ix_obj *o, const double m[16],
                             ix_obj **out)
{
    if (a->matrices) {
        *out = ix__obj_matrix(a->ctx, m);
        return *out ? IX_OK : IX_ENOMEM;
    }
    if (o->type == IX_OBJ_NUMBER || o->type == IX_OBJ_STRING ||
        o->type == IX_OBJ_MATRIX) {
        *out = ix__obj_copy(a->ctx, o);
        return *out ? IX_OK : IX_ENOMEM;
    }
    IX_TRY(ix__obj_transform(a->ctx, o, m, out));
    ix__attr_remove(a->ctx, &(*out)->attrs, "animation"); /* it is done */
    return IX_OK;
}

/* *out is NULL for what is not visible. outer: what comes after o's own. */
static ix_status animate(const anim *a, const ix_obj *o, const double outer[16],
                         int depth, ix_obj **out)
{
    double m[16];
    bool visible;
    ix_obj *list, *item;
    ix_status st;

    *out = NULL;
    if (depth > IX_MAX_DEPTH)
        return IX_FAIL(a->ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       IX_MAX_DEPTH);
    IX_TRY(own_matrix(a->ctx, o, a->t, m, &visible));
    if (!visible)
        return IX_OK;
    ix__mat_mul(m, outer, m);
    if (o->type != IX_OBJ_LIST)
        return transformed(a, o, m, out);
    list = ix__obj_list(a->ctx);
    st = list ? ix__attr_copy_all(a->ctx, o->attrs, &list->attrs) : IX_ENOMEM;
    if (st == IX_OK)
        ix__attr_remove(a->ctx, &list->attrs, "animation");
    for (int i = 0; i < o->u.list.n && st == IX_OK; i++) {
        st = animate(a, o->u.list.item[i], m, depth + 1, &item);
        if (st == IX_OK && item) {
            st = ix__obj_append(a->ctx, list, item);
            ix__obj_unref(a->ctx, item);
        }
    }
    if (st == IX_OK)
        *out = list;
    else
        ix__obj_unref(a->ctx, list);
    return st;
}

ix_status ix__animate(ix_ctx *ctx, const ix_obj *o, double t, bool matrices,
                      ix_obj **out)
{
    anim a = {ctx, t, matrices};
    double one[16];
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    ix__mat_identity(one);
    st = animate(&a, o, one, 1, out);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK && !*out) {
        *out = ix__obj_list(ctx);
        return *out ? IX_OK : IX_ENOMEM;
    }
    return st;
}
