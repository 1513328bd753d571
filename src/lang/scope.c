/* scope.c - global symbols, the stack of locals, assignment.
 *
 * A slot is where a variable's box is kept: in a symbol or in the stack. The
 * box of a defined variable stays the same under assignment, unless the new
 * value holds that very box. */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <string.h>
#include <time.h>

#include "lang/interp_impl.h"

/* --- symbols
 * ------------------------------------------------------------------- */

static size_t hash(const char *name)
{
    size_t h = 2166136261u;

    for (; *name; name++)
        h = (h ^ (size_t)toupper((unsigned char)*name)) * 16777619u;
    return h;
}

static bool same_name(const char *upper, const char *name)
{
    while (*upper && *upper == (char)toupper((unsigned char)*name))
        upper++, name++;
    return !*upper && !*name;
}

ix__sym *ix__sym_find(ix_interp *in, const char *name)
{
    ix__sym *s;

    if (!in->nbuckets)
        return NULL;
    s = in->bucket[hash(name) & (in->nbuckets - 1)];
    while (s && !same_name(s->name, name))
        s = s->next;
    return s;
}

void *ix__grow(ix_ctx *ctx, void *p, size_t *cap, size_t item)
{
    size_t more = *cap ? 2 * *cap : 64;
    void *q = ix__realloc(ctx, p, *cap * item, more * item);

    if (q)
        *cap = more;
    return q;
}

static bool rehash(ix_interp *in)
{
    size_t n = in->nbuckets ? 2 * in->nbuckets : 256;
    ix__sym **b = ix__alloc(in->ctx, n * sizeof *b);

    if (!b)
        return false;
    memset(b, 0, n * sizeof *b);
    for (size_t i = 0; i < in->nsyms; i++) {
        ix__sym *s = in->sym[i];
        size_t h = hash(s->name) & (n - 1);

        s->next = b[h];
        b[h] = s;
    }
    ix__free(in->ctx, in->bucket, in->nbuckets * sizeof *b);
    in->bucket = b;
    in->nbuckets = n;
    return true;
}

static size_t sym_size(const char *name)
{
    return sizeof(ix__sym) + strlen(name) + 1;
}

ix__sym *ix__sym_get(ix_interp *in, const char *name)
{
    ix__sym *s = ix__sym_find(in, name);
    size_t h;

    if (s)
        return s;
    if (in->nsyms >= in->nbuckets && !rehash(in))
        return NULL;
    if (in->nsyms == in->cap_syms) {
        ix__sym **more = ix__grow(in->ctx, in->sym, &in->cap_syms,
                                  sizeof *more);

        if (!more)
            return NULL;
        in->sym = more;
    }
    s = ix__alloc(in->ctx, sym_size(name));
    if (!s)
        return NULL;
    *s = (ix__sym){.box = NULL};
    for (size_t i = 0; i <= strlen(name); i++)
        s->name[i] = (char)toupper((unsigned char)name[i]);
    h = hash(name) & (in->nbuckets - 1);
    s->next = in->bucket[h];
    in->bucket[h] = s;
    in->sym[in->nsyms++] = s;
    return s;
}

void ix__syms_free(ix_interp *in)
{
    for (size_t i = 0; i < in->nsyms; i++) {
        ix__sym *s = in->sym[i];

        ix__obj_unref(in->ctx, s->box);
        if (s->fn)
            ix__unit_unref(s->fn->unit);
        ix__free(in->ctx, s, sym_size(s->name));
    }
    ix__free(in->ctx, in->sym, in->cap_syms * sizeof *in->sym);
    ix__free(in->ctx, in->bucket, in->nbuckets * sizeof *in->bucket);
    for (size_t i = 0; i < in->nfiles; i++)
        ix__strfree(in->ctx, in->file_name[i]);
    ix__free(in->ctx, in->file_name, in->cap_files * sizeof *in->file_name);
}

const char *ix__intern_file(ix_interp *in, const char *name)
{
    char *copy;

    for (size_t i = 0; i < in->nfiles; i++)
        if (strcmp(in->file_name[i], name) == 0)
            return in->file_name[i];
    if (in->nfiles == in->cap_files) {
        char **more = ix__grow(in->ctx, in->file_name, &in->cap_files,
                               sizeof *more);

        if (!more)
            return NULL;
        in->file_name = more;
    }
    copy = ix__strdup(in->ctx, name);
    if (copy)
        in->file_name[in->nfiles++] = copy;
    return copy;
}

/* --- slots
 * ---------------------------------------------------------------------- */

static ix_status rename_box(ix_interp *in, ix_obj *o, const char *name)
{
    if (!name && !o->name)
        return IX_OK;
    return ix__obj_set_name(in->ctx, o, name);
}

/* A box of its own for the slot, as the value is o. */
static ix_status fresh_box(ix_interp *in, ix_obj **slot, const char *name,
                           ix_obj *o)
{
    ix_obj *box = o;
    ix_status st;

    if (o->refs > 1) {
        box = ix__obj_copy(in->ctx, o);
        ix__obj_unref(in->ctx, o);
        if (!box)
            return IX_ENOMEM;
    }
    st = rename_box(in, box, name);
    if (st != IX_OK) {
        ix__obj_unref(in->ctx, box);
        return st;
    }
    ix__obj_unref(in->ctx, *slot);
    *slot = box;
    return IX_OK;
}

ix_status ix__slot_take(ix_interp *in, ix_obj **slot, const char *name,
                        ix_obj *o)
{
    ix_obj *dst = *slot;

    if (dst == o) {
        ix__obj_unref(in->ctx, o);
        return IX_OK;
    }
    if (!dst ||
        (o->type == IX_OBJ_LIST && dst->refs > 1 && ix__obj_contains(o, dst)))
        return fresh_box(in, slot, name, o);
    return ix__obj_move(in->ctx, dst, o);
}

ix_status ix__slot_number(ix_interp *in, ix_obj **slot, const char *name,
                          double v)
{
    ix_obj *o = *slot;

    if (o && o->type == IX_OBJ_NUMBER && !o->attrs) {
        o->u.num = v;
        return IX_OK;
    }
    o = ix__obj_number(in->ctx, v);
    return o ? ix__slot_take(in, slot, name, o) : IX_ENOMEM;
}

bool ix__slot_outer(const ix_interp *in, const char *name, size_t *slot)
{
    for (int f = in->nframes - 1; f >= 0; f--) {
        const ix__fn *fn = in->frame[f].fn;

        for (int i = 0; i < fn->nslots; i++) {
            if (same_name(fn->slot_name[i], name)) {
                *slot = in->frame[f].base + (size_t)i;
                return true;
            }
        }
    }
    return false;
}

ix_obj **ix__slot_find(ix_interp *in, const char *name)
{
    size_t slot;
    ix__sym *s;

    if (in->nframes && ix__slot_outer(in, name, &slot))
        return &in->stack[slot];
    s = ix__sym_find(in, name);
    return s ? &s->box : NULL;
}

ix_status ix__stack_push(ix_interp *in, size_t n)
{
    while (in->cap_stack - in->top < n) {
        ix_obj **more = ix__grow(in->ctx, in->stack, &in->cap_stack,
                                 sizeof *more);

        if (!more)
            return IX_ENOMEM;
        in->stack = more;
    }
    while (n-- > 0)
        in->stack[in->top++] = NULL;
    return IX_OK;
}

void ix__stack_pop(ix_interp *in, size_t n)
{
    for (size_t i = 0; i < n; i++)
        ix__obj_unref(in->ctx, in->stack[--in->top]);
}

/* --- what primitives may do with variables
 * ---------------------------------------- */

ix_obj *ix__var_find(ix_interp *in, const char *name)
{
    ix_obj **slot = ix__slot_find(in, name);

    return slot ? *slot : NULL;
}

double ix__var_num(ix_interp *in, const char *name, double dflt)
{
    const ix_obj *o = ix__var_find(in, name);

    return o && o->type == IX_OBJ_NUMBER ? o->u.num : dflt;
}

ix_status ix__var_set(ix_interp *in, const char *name, const ix_obj *o)
{
    ix__sym *s = ix__sym_get(in, name);
    ix_obj *copy;

    if (!s)
        return IX_ENOMEM;
    copy = ix__obj_copy(in->ctx, o);
    return copy ? ix__slot_take(in, &s->box, s->name, copy) : IX_ENOMEM;
}

ix_status ix__var_free(ix_interp *in, const char *name)
{
    ix_obj **slot = ix__slot_find(in, name);

    if (!slot || !*slot)
        return IX_FAIL(in->ctx, IX_EARG, "there is no variable %s", name);
    ix__obj_unref(in->ctx, *slot);
    *slot = NULL;
    return IX_OK;
}

ix_status ix__var_rename(ix_interp *in, const char *from, const char *to)
{
    ix__sym *s = ix__sym_find(in, from), *t = ix__sym_get(in, to);

    if (!t)
        return IX_ENOMEM;
    if (!s || !s->box)
        return IX_FAIL(in->ctx, IX_EARG, "there is no variable %s", from);
    IX_TRY(ix__obj_set_name(in->ctx, s->box, t->name));
    if (s == t)
        return IX_OK;
    ix__obj_unref(in->ctx, t->box);
    t->box = s->box;
    s->box = NULL;
    return IX_OK;
}

ix_obj *ix__var_at(ix_interp *in, size_t i)
{
    for (size_t k = 0; k < in->nsyms; k++)
        if (in->sym[k]->box && i-- == 0)
            return in->sym[k]->box;
    return NULL;
}

const char *ix__fn_at(ix_interp *in, size_t i)
{
    for (size_t k = 0; k < in->nsyms; k++)
        if (in->sym[k]->fn && !in->sym[k]->fn->is_startup && i-- == 0)
            return in->sym[k]->name;
    return NULL;
}

/* --- functions
 * ---------------------------------------------------------------------- */

static ix_status append_name(ix_interp *in, const char *name)
{
    ix__sym *s = ix__sym_get(in, "USR_FN_LIST");
    ix_obj *text;
    ix_status st;

    if (!s)
        return IX_ENOMEM;
    if (!s->box || s->box->type != IX_OBJ_LIST) {
        ix_obj *list = ix__obj_list(in->ctx);

        if (!list)
            return IX_ENOMEM;
        IX_TRY(ix__slot_take(in, &s->box, s->name, list));
    }
    text = ix__obj_string(in->ctx, name, strlen(name));
    if (!text)
        return IX_ENOMEM;
    st = ix__obj_append(in->ctx, s->box, text);
    ix__obj_unref(in->ctx, text);
    return st;
}

ix_status ix__fn_define(ix_interp *in, ix__fn *fn)
{
    ix__sym *s = ix__sym_get(in, fn->name);

    if (!s)
        return IX_ENOMEM;
    if (!fn->is_startup)
        IX_TRY(append_name(in, fn->name));
    (void)ix__unit_ref(fn->unit);
    if (s->fn)
        ix__unit_unref(s->fn->unit);
    s->fn = fn;
    return IX_OK;
}

static void drop_fn(ix__sym *s)
{
    ix__unit *u = s->fn->unit;

    s->fn = NULL;
    s->no_startup = true;
    ix__unit_unref(u);
}

/* Frees all functions that USR_FN_LIST names, and empties it. */
static ix_status free_listed(ix_interp *in)
{
    ix__sym *s = ix__sym_find(in, "USR_FN_LIST");
    ix_obj *empty;

    if (!s || !s->box || s->box->type != IX_OBJ_LIST)
        return IX_OK;
    for (int i = 0; i < s->box->u.list.n; i++) {
        const ix_obj *o = s->box->u.list.item[i];
        ix__sym *f = o->type == IX_OBJ_STRING ? ix__sym_find(in, o->u.str.s)
                                              : NULL;

        if (f && f->fn)
            drop_fn(f);
    }
    empty = ix__obj_list(in->ctx);
    return empty ? ix__slot_take(in, &s->box, s->name, empty) : IX_ENOMEM;
}

ix_status ix__fn_free(ix_interp *in, const char *name)
{
    ix__sym *s;

    if (!*name)
        return free_listed(in);
    IX_TRY(ix__fn_lookup(in, name, &s));
    if (!s)
        return IX_FAIL(in->ctx, IX_EARG, "there is no user function %s", name);
    drop_fn(s);
    return IX_OK;
}

/* --- predefined variables
 * ------------------------------------------------------------- */

static ix_status define(ix_interp *in, const char *name, ix_obj *o)
{
    ix__sym *s;

    if (!o)
        return IX_ENOMEM;
    s = ix__sym_get(in, name);
    if (!s) {
        ix__obj_unref(in->ctx, o);
        return IX_ENOMEM;
    }
    return ix__slot_take(in, &s->box, s->name, o);
}

/* Three polylines from the origin along x, y and z. */
static ix_obj *axes(ix_ctx *ctx)
{
    ix_poly *p = ix__poly_new(ctx, 3);

    if (!p)
        return NULL;
    for (int i = 0; i < 3; i++) {
        p->poly[i].kind = IX_POLYLINE;
        if (ix__poly_vertices(ctx, &p->poly[i], 2) != IX_OK) {
            ix__poly_unref(ctx, p);
            return NULL;
        }
        p->poly[i].v[1].p[i] = 1;
    }
    return ix__obj_poly(ctx, p);
}

ix_status ix__predefine(ix_interp *in)
{
    static const struct {
        const char *name;
        double v;
    } numbers[] = {
        {"RESOLUTION", 20},       {"DRAWCTLPT", 0},
        {"FLAT4PLY", 0},          {"POLY_APPROX_OPT", 0},
        {"POLY_APPROX_UV", 0},    {"POLY_APPROX_TRI", 0},
        {"POLY_APPROX_TOL", 0.3}, {"POLY_MERGE_COPLANAR", 1},
        {"MACHINE", 12},          {"DUMMY", 0},
    };
    /* The isometric view looks along (1, 1, 1): rows of a rotation. */
    static const double view[16] = {-0.70710678118654752,
                                    -0.40824829046386302,
                                    0.57735026918962576,
                                    0,
                                    0.70710678118654752,
                                    -0.40824829046386302,
                                    0.57735026918962576,
                                    0,
                                    0,
                                    0.81649658092772603,
                                    0.57735026918962576,
                                    0,
                                    0,
                                    0,
                                    0,
                                    1};
    static const double persp[16] = {1, 0, 0,   0,     0, 1, 0,    0,
                                     0, 0, 0.1, -0.35, 0, 0, 0.35, 1};
    static const double unit[16] = {1, 0, 0, 0, 0, 1, 0, 0,
                                    0, 0, 1, 0, 0, 0, 0, 1};
    ix_ctx *ctx = in->ctx;

    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        IX_TRY(define(in, numbers[i].name, ix__obj_number(ctx, numbers[i].v)));
    IX_TRY(define(in, "VIEW_MAT", ix__obj_matrix(ctx, view)));
    IX_TRY(define(in, "PRSP_MAT", ix__obj_matrix(ctx, persp)));
    IX_TRY(define(in, "PRINTABLEA4UNITMAT", ix__obj_matrix(ctx, unit)));
    IX_TRY(define(in, "AXES", axes(ctx)));
    return define(in, "USR_FN_LIST", ix__obj_list(ctx));
}

ix_status ix__var_reset(ix_interp *in)
{
    for (size_t i = 0; i < in->nsyms; i++) {
        ix__obj_unref(in->ctx, in->sym[i]->box);
        in->sym[i]->box = NULL;
    }
    return ix__predefine(in);
}
