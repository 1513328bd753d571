/* object.c - the box: making, counting, copying, assigning.
 *
 * Scripts make and drop a box for every number, so released boxes are kept
 * for reuse in the context. Release works off a list of dead boxes: no depth
 * of lists or attributes reaches the C stack. */
#include "object/object.h"

#include <limits.h>
#include <string.h>

#include "object/release_impl.h"

#ifdef IX_HARDTEST
#define MAX_FREE 0 /* use after release meets ASan */
#else
#define MAX_FREE 4096 /* boxes kept for reuse: 0.7 MB */
#endif

/* --- the box's memory ------------------------------------------------- */

static void free_list_drop(ix_ctx *ctx)
{
    while (ctx->free_list) {
        ix_obj *o = ctx->free_list;

        ctx->free_list = o->link;
        ix__free(ctx, o, sizeof *o);
    }
    ctx->free_count = 0;
}

/* The value is left unset. */
static ix_obj *new_box(ix_ctx *ctx, ix_obj_type type)
{
    ix_obj *o = ctx->free_list;

    if (o) {
        ctx->free_list = o->link;
        ctx->free_count--;
    } else {
        o = ix__alloc(ctx, sizeof *o);
        if (!o)
            return NULL;
    }
    o->refs = 1;
    o->type = type;
    o->name = NULL;
    o->attrs = NULL;
    o->mark = NULL;
    return o;
}

static void free_box(ix_ctx *ctx, ix_obj *o)
{
    if (ctx->free_count >= MAX_FREE) {
        ix__free(ctx, o, sizeof *o);
        return;
    }
    o->link = ctx->free_list;
    ctx->free_list = o;
    ctx->free_list_drop = free_list_drop;
    ctx->free_count++;
}

/* --- release ---------------------------------------------------------- */

static void drop_list(ix_ctx *ctx, ix_list *l, ix_obj **dead)
{
    for (int i = 0; i < l->n; i++)
        ix__obj_drop(ctx, l->item[i], dead);
    ix__free(ctx, l->item, (size_t)l->cap * sizeof *l->item);
}

static void drop_trims(ix_ctx *ctx, ix_obj *o)
{
    for (int i = 0; i < o->u.trim.n; i++)
        ix__trimsrf_unref(ctx, o->u.trim.item[i]);
    ix__free(ctx, o->u.trim.item, (size_t)o->u.trim.n * sizeof(void *));
}

static void drop_tris(ix_ctx *ctx, ix_obj *o)
{
    for (int i = 0; i < o->u.tri.n; i++)
        ix__trisrf_unref(ctx, o->u.tri.item[i]);
    ix__free(ctx, o->u.tri.item, (size_t)o->u.tri.n * sizeof(void *));
}

static void drop_models(ix_ctx *ctx, ix_obj *o)
{
    for (int i = 0; i < o->u.model.n; i++)
        ix__model_unref(ctx, o->u.model.item[i]);
    ix__free(ctx, o->u.model.item, (size_t)o->u.model.n * sizeof(void *));
}

/* Leaves o without a value. */
static void drop_value(ix_ctx *ctx, ix_obj *o, ix_obj **dead)
{
    switch (o->type) {
    case IX_OBJ_POLY:
        ix__poly_drop(ctx, o->u.poly, dead);
        break;
    case IX_OBJ_STRING:
        ix__free(ctx, o->u.str.s, o->u.str.len + 1);
        break;
    case IX_OBJ_LIST:
        drop_list(ctx, &o->u.list, dead);
        break;
    case IX_OBJ_CTLPT:
        ix__free(ctx, o->u.ctlpt, sizeof *o->u.ctlpt);
        break;
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        ix__mvs_unref(ctx, o->u.mvs);
        break;
    case IX_OBJ_TRIMSRF:
        drop_trims(ctx, o);
        break;
    case IX_OBJ_TRISRF:
        drop_tris(ctx, o);
        break;
    case IX_OBJ_MODEL:
        drop_models(ctx, o);
        break;
    case IX_OBJ_INSTANCE:
        ix__strfree(ctx, o->u.inst->target);
        ix__free(ctx, o->u.inst, sizeof *o->u.inst);
        break;
    case IX_OBJ_UNDEF:
    case IX_OBJ_NUMBER:
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
    case IX_OBJ_PLANE:
    case IX_OBJ_MATRIX:
        break;
    }
    o->type = IX_OBJ_UNDEF;
}

void ix__obj_drop(ix_ctx *ctx, ix_obj *o, ix_obj **dead)
{
    if (!o || --o->refs > 0)
        return;
    ix__strfree(ctx, o->name);
    o->link = *dead;
    *dead = o;
}

void ix__obj_release_dead(ix_ctx *ctx, ix_obj *dead)
{
    while (dead) {
        ix_obj *o = dead;

        dead = o->link;
        drop_value(ctx, o, &dead);
        if (o->attrs)
            ix__attr_drop_all(ctx, &o->attrs, &dead);
        free_box(ctx, o);
    }
}

void ix__obj_unref(ix_ctx *ctx, ix_obj *o)
{
    ix_obj *dead = NULL;

    ix__obj_drop(ctx, o, &dead);
    if (dead)
        ix__obj_release_dead(ctx, dead);
}

ix_obj *ix__obj_ref(ix_obj *o)
{
    o->refs++;
    return o;
}

/* --- making ----------------------------------------------------------- */

ix_obj *ix__obj_undef(ix_ctx *ctx)
{
    return new_box(ctx, IX_OBJ_UNDEF);
}

ix_obj *ix__obj_number(ix_ctx *ctx, double v)
{
    ix_obj *o = new_box(ctx, IX_OBJ_NUMBER);

    if (o)
        o->u.num = v;
    return o;
}

ix_obj *ix__obj_point(ix_ctx *ctx, const double p[3])
{
    ix_obj *o = new_box(ctx, IX_OBJ_POINT);

    if (o)
        memcpy(o->u.pt, p, sizeof o->u.pt);
    return o;
}

ix_obj *ix__obj_vector(ix_ctx *ctx, const double p[3])
{
    ix_obj *o = ix__obj_point(ctx, p);

    if (o)
        o->type = IX_OBJ_VECTOR;
    return o;
}

ix_obj *ix__obj_plane(ix_ctx *ctx, const double p[4])
{
    ix_obj *o = new_box(ctx, IX_OBJ_PLANE);

    if (o)
        memcpy(o->u.plane, p, sizeof o->u.plane);
    return o;
}

ix_obj *ix__obj_matrix(ix_ctx *ctx, const double m[16])
{
    ix_obj *o = new_box(ctx, IX_OBJ_MATRIX);

    if (o)
        memcpy(o->u.mat, m, sizeof o->u.mat);
    return o;
}

ix_obj *ix__obj_list(ix_ctx *ctx)
{
    ix_obj *o = new_box(ctx, IX_OBJ_LIST);

    if (o)
        o->u.list = (ix_list){0};
    return o;
}

/* Makes o a box of that type, or frees it if its value could not be made. */
static ix_obj *with_value(ix_ctx *ctx, ix_obj *o, ix_obj_type type,
                          const void *value)
{
    if (value) {
        o->type = type;
        return o;
    }
    free_box(ctx, o);
    return NULL;
}

ix_obj *ix__obj_string(ix_ctx *ctx, const char *s, size_t len)
{
    ix_obj *o = new_box(ctx, IX_OBJ_UNDEF);
    char *copy;

    if (!o)
        return NULL;
    copy = ix__alloc(ctx, len + 1);
    if (copy) {
        if (len > 0)
            memcpy(copy, s, len);
        copy[len] = '\0';
        o->u.str.s = copy;
        o->u.str.len = len;
    }
    return with_value(ctx, o, IX_OBJ_STRING, copy);
}

ix_obj *ix__obj_ctlpt(ix_ctx *ctx, const ix_ctlpt *p)
{
    ix_obj *o = new_box(ctx, IX_OBJ_UNDEF);

    if (!o)
        return NULL;
    o->u.ctlpt = ix__alloc(ctx, sizeof *p);
    if (o->u.ctlpt)
        *o->u.ctlpt = *p;
    return with_value(ctx, o, IX_OBJ_CTLPT, o->u.ctlpt);
}

ix_obj *ix__obj_instance(ix_ctx *ctx, const char *target, const double m[16])
{
    ix_obj *o = new_box(ctx, IX_OBJ_UNDEF);
    ix_instance *inst;

    if (!o)
        return NULL;
    inst = ix__alloc(ctx, sizeof *inst);
    if (inst) {
        memcpy(inst->mat, m, sizeof inst->mat);
        inst->target = ix__strdup(ctx, target);
        if (!inst->target) {
            ix__free(ctx, inst, sizeof *inst);
            inst = NULL;
        }
    }
    o->u.inst = inst;
    if (inst)
        ix__name_upper(inst->target);
    return with_value(ctx, o, IX_OBJ_INSTANCE, inst);
}

ix_obj *ix__obj_mvs(ix_ctx *ctx, ix_obj_type type, const ix_mvs *m)
{
    ix_obj *o = m ? new_box(ctx, type) : NULL;

    if (o)
        o->u.mvs = m;
    else
        ix__mvs_unref(ctx, m);
    return o;
}

ix_obj *ix__obj_mv(ix_ctx *ctx, ix_obj_type type, const ix_mv *m)
{
    const ix_mvs *ms = ix__mvs_new(ctx, 1, &m);

    ix_mv_unref(ctx, m); /* the sequence has its own reference */
    return ix__obj_mvs(ctx, type, ms);
}

ix_obj *ix__obj_poly(ix_ctx *ctx, const ix_poly *p)
{
    ix_obj *o = p ? new_box(ctx, IX_OBJ_POLY) : NULL;

    if (o)
        o->u.poly = p;
    else
        ix__poly_unref(ctx, p);
    return o;
}

ix_obj *ix__obj_trimsrfs(ix_ctx *ctx, int n, const ix_trimsrf *const *t)
{
    ix_obj *o = new_box(ctx, IX_OBJ_UNDEF);

    if (!o)
        return NULL;
    o->u.trim.n = n;
    o->u.trim.item = ix__alloc(ctx, (size_t)n * sizeof(void *));
    for (int i = 0; o->u.trim.item && i < n; i++)
        o->u.trim.item[i] = ix__trimsrf_ref(t[i]);
    return with_value(ctx, o, IX_OBJ_TRIMSRF, o->u.trim.item);
}

ix_obj *ix__obj_trisrfs(ix_ctx *ctx, int n, const ix_trisrf *const *t)
{
    ix_obj *o = new_box(ctx, IX_OBJ_UNDEF);

    if (!o)
        return NULL;
    o->u.tri.n = n;
    o->u.tri.item = ix__alloc(ctx, (size_t)n * sizeof(void *));
    for (int i = 0; o->u.tri.item && i < n; i++)
        o->u.tri.item[i] = ix__trisrf_ref(t[i]);
    return with_value(ctx, o, IX_OBJ_TRISRF, o->u.tri.item);
}

ix_obj *ix__obj_models(ix_ctx *ctx, int n, const ix_model *const *m)
{
    ix_obj *o = new_box(ctx, IX_OBJ_UNDEF);

    if (!o)
        return NULL;
    o->u.model.n = n;
    o->u.model.item = ix__alloc(ctx, (size_t)n * sizeof(void *));
    for (int i = 0; o->u.model.item && i < n; i++)
        o->u.model.item[i] = ix__model_ref(m[i]);
    return with_value(ctx, o, IX_OBJ_MODEL, o->u.model.item);
}

ix_obj *ix__obj_trimsrf(ix_ctx *ctx, const ix_trimsrf *t)
{
    ix_obj *o = t ? ix__obj_trimsrfs(ctx, 1, &t) : NULL;

    ix__trimsrf_unref(ctx, t);
    return o;
}

ix_obj *ix__obj_trisrf(ix_ctx *ctx, const ix_trisrf *t)
{
    ix_obj *o = t ? ix__obj_trisrfs(ctx, 1, &t) : NULL;

    ix__trisrf_unref(ctx, t);
    return o;
}

ix_obj *ix__obj_model(ix_ctx *ctx, const ix_model *m)
{
    ix_obj *o = m ? ix__obj_models(ctx, 1, &m) : NULL;

    ix__model_unref(ctx, m);
    return o;
}

ix_status ix__obj_append(ix_ctx *ctx, ix_obj *list, ix_obj *item)
{
    ix_list *l = &list->u.list;

    if (l->n == l->cap) {
        int cap = l->cap ? l->cap : 2;
        ix_obj **p;

        if (cap > INT_MAX / 2)
            return IX_FAIL(ctx, IX_ENOMEM, "list of %d elements is full", cap);
        cap += cap;
        p = ix__realloc(ctx, l->item, (size_t)l->cap * sizeof *p,
                        (size_t)cap * sizeof *p);
        if (!p)
            return IX_ENOMEM;
        l->item = p;
        l->cap = cap;
    }
    l->item[l->n++] = ix__obj_ref(item);
    return IX_OK;
}

/* --- copying ---------------------------------------------------------- */

static ix_obj *copy_list(ix_ctx *ctx, const ix_obj *src)
{
    ix_obj *o = ix__obj_list(ctx);
    const ix_list *from = &src->u.list;

    if (!o || from->n == 0)
        return o;
    o->u.list.item = ix__alloc(ctx, (size_t)from->n * sizeof *from->item);
    if (!o->u.list.item) {
        free_box(ctx, o);
        return NULL;
    }
    o->u.list.n = o->u.list.cap = from->n;
    for (int i = 0; i < from->n; i++)
        o->u.list.item[i] = ix__obj_ref(from->item[i]);
    return o;
}

static ix_obj *copy_value(ix_ctx *ctx, const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_UNDEF:
        return ix__obj_undef(ctx);
    case IX_OBJ_NUMBER:
        return ix__obj_number(ctx, o->u.num);
    case IX_OBJ_POINT:
        return ix__obj_point(ctx, o->u.pt);
    case IX_OBJ_VECTOR:
        return ix__obj_vector(ctx, o->u.pt);
    case IX_OBJ_PLANE:
        return ix__obj_plane(ctx, o->u.plane);
    case IX_OBJ_MATRIX:
        return ix__obj_matrix(ctx, o->u.mat);
    case IX_OBJ_STRING:
        return ix__obj_string(ctx, o->u.str.s, o->u.str.len);
    case IX_OBJ_LIST:
        return copy_list(ctx, o);
    case IX_OBJ_CTLPT:
        return ix__obj_ctlpt(ctx, o->u.ctlpt);
    case IX_OBJ_POLY:
        return ix__obj_poly(ctx, ix__poly_ref(o->u.poly));
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return ix__obj_mvs(ctx, o->type, ix__mvs_ref(o->u.mvs));
    case IX_OBJ_TRIMSRF:
        return ix__obj_trimsrfs(ctx, o->u.trim.n, o->u.trim.item);
    case IX_OBJ_TRISRF:
        return ix__obj_trisrfs(ctx, o->u.tri.n, o->u.tri.item);
    case IX_OBJ_MODEL:
        return ix__obj_models(ctx, o->u.model.n, o->u.model.item);
    case IX_OBJ_INSTANCE:
        return ix__obj_instance(ctx, o->u.inst->target, o->u.inst->mat);
    }
    return NULL; /* not reached: every type has its case */
}

ix_obj *ix__obj_copy(ix_ctx *ctx, const ix_obj *o)
{
    ix_obj *c = copy_value(ctx, o);

    if (!c || (!o->name && !o->attrs))
        return c;
    if (o->name)
        c->name = ix__strdup(ctx, o->name);
    if ((o->name && !c->name) ||
        ix__attr_copy_all(ctx, o->attrs, &c->attrs) != IX_OK) {
        ix__obj_unref(ctx, c);
        return NULL;
    }
    return c;
}

/* Exchanges values and attributes of two boxes. */
static void swap_values(ix_obj *a, ix_obj *b)
{
    ix_obj t = *a;

    a->type = b->type;
    a->attrs = b->attrs;
    a->u = b->u;
    b->type = t.type;
    b->attrs = t.attrs;
    b->u = t.u;
}

ix_status ix__obj_assign(ix_ctx *ctx, ix_obj *dst, const ix_obj *src)
{
    ix_obj *copy;

    if (dst == src)
        return IX_OK;
    if (dst->type == IX_OBJ_NUMBER && src->type == IX_OBJ_NUMBER &&
        !dst->attrs && !src->attrs) {
        dst->u.num = src->u.num;
        return IX_OK;
    }
    copy = copy_value(ctx, src);
    if (!copy)
        return IX_ENOMEM;
    if (src->attrs &&
        ix__attr_copy_all(ctx, src->attrs, &copy->attrs) != IX_OK) {
        ix__obj_unref(ctx, copy);
        return IX_ENOMEM;
    }
    swap_values(dst, copy);
    ix__obj_unref(ctx, copy);
    return IX_OK;
}

ix_status ix__obj_move(ix_ctx *ctx, ix_obj *dst, ix_obj *src)
{
    ix_status st = IX_OK;

    if (src->refs == 1 && src != dst)
        swap_values(dst, src);
    else
        st = ix__obj_assign(ctx, dst, src);
    ix__obj_unref(ctx, src);
    return st;
}

/* --- names and types -------------------------------------------------- */

void ix__name_upper(char *s)
{
    for (; *s; s++)
        if (*s >= 'a' && *s <= 'z')
            *s = (char)(*s - 'a' + 'A');
}

ix_status ix__obj_set_name(ix_ctx *ctx, ix_obj *o, const char *name)
{
    char *copy = NULL;

    if (name && *name && ix__name_cmp(name, "NONE") != 0) {
        copy = ix__strdup(ctx, name);
        if (!copy)
            return IX_ENOMEM;
        ix__name_upper(copy);
    }
    ix__strfree(ctx, o->name);
    o->name = copy;
    return IX_OK;
}

const char *ix__obj_type_name(ix_obj_type t)
{
    static const char *const names[] = {
        "Undefined",   "Poly",        "Numeric",     "Point",
        "Vector",      "Plane",       "Matrix",      "Curve",
        "Surface",     "String",      "Object List", "CtlPt",
        "Trimmed Srf", "Trivariate",  "Instance",    "Triangular Surface",
        "Model",       "Multivariate"};

    return (unsigned)t < sizeof names / sizeof *names ? names[t] : "?";
}

ix_obj_type ix__obj_type_of_mv(const ix_mv *m)
{
    switch (ix_mv_ndirs(m)) {
    case 1:
        return IX_OBJ_CURVE;
    case 2:
        return IX_OBJ_SURFACE;
    case 3:
        return IX_OBJ_TRIVAR;
    default:
        return IX_OBJ_MULTIVAR;
    }
}

bool ix__obj_is_freeform(const ix_obj *o)
{
    return o->type == IX_OBJ_CURVE || o->type == IX_OBJ_SURFACE ||
           o->type == IX_OBJ_TRIVAR || o->type == IX_OBJ_MULTIVAR;
}

const ix_mv *ix__obj_first_mv(const ix_obj *o)
{
    return ix__obj_is_freeform(o) ? o->u.mvs->mv[0] : NULL;
}
