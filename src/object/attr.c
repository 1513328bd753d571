/* attr.c - attributes: a linked list of named values, the newest first.
 *
 * Names are compared without case and keep the spelling of their first
 * setting; a value that is set again is replaced where it stands. */
#include <string.h>

#include "object/release_impl.h"

static int upper(char c)
{
    return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : (unsigned char)c;
}

int ix__name_cmp(const char *a, const char *b)
{
    while (*a && upper(*a) == upper(*b)) {
        a++;
        b++;
    }
    return upper(*a) - upper(*b);
}

ix_attr *ix__attr_find(ix_attr *list, const char *name)
{
    while (list && ix__name_cmp(list->name, name) != 0)
        list = list->next;
    return list;
}

static void drop_value(ix_ctx *ctx, ix_attr *a, ix_obj **dead)
{
    ix__strfree(ctx, a->s);
    ix__obj_drop(ctx, a->obj, dead);
    a->s = NULL;
    a->obj = NULL;
}

static void drop_attr(ix_ctx *ctx, ix_attr *a, ix_obj **dead)
{
    drop_value(ctx, a, dead);
    ix__strfree(ctx, a->name);
    ix__free(ctx, a, sizeof *a);
}

static ix_attr *new_attr(ix_ctx *ctx, const char *name)
{
    ix_attr *a = ix__alloc(ctx, sizeof *a);

    if (!a)
        return NULL;
    *a = (ix_attr){.name = ix__strdup(ctx, name)};
    if (a->name)
        return a;
    ix__free(ctx, a, sizeof *a);
    return NULL;
}

/* The attribute of that name with its old value dropped, or a new first one. */
static ix_attr *fresh_attr(ix_ctx *ctx, ix_attr **list, const char *name)
{
    ix_attr *a = ix__attr_find(*list, name);
    ix_obj *dead = NULL;

    if (a) {
        drop_value(ctx, a, &dead);
        ix__obj_release_dead(ctx, dead);
        return a;
    }
    a = new_attr(ctx, name);
    if (a) {
        a->next = *list;
        *list = a;
    }
    return a;
}

ix_status ix__attr_set_string(ix_ctx *ctx, ix_attr **list, const char *name,
                              const char *s)
{
    char *copy = ix__strdup(ctx, s);
    ix_attr *a = copy ? fresh_attr(ctx, list, name) : NULL;

    if (!a) {
        ix__strfree(ctx, copy);
        return IX_ENOMEM;
    }
    a->type = IX_ATTR_STRING;
    a->s = copy;
    return IX_OK;
}

ix_status ix__attr_set_int(ix_ctx *ctx, ix_attr **list, const char *name,
                           long long v)
{
    ix_attr *a = fresh_attr(ctx, list, name);

    if (!a)
        return IX_ENOMEM;
    a->type = IX_ATTR_INT;
    a->i = v;
    return IX_OK;
}

ix_status ix__attr_set_real(ix_ctx *ctx, ix_attr **list, const char *name,
                            double v)
{
    ix_attr *a = fresh_attr(ctx, list, name);

    if (!a)
        return IX_ENOMEM;
    a->type = IX_ATTR_REAL;
    a->r = v;
    return IX_OK;
}

ix_status ix__attr_set_obj(ix_ctx *ctx, ix_attr **list, const char *name,
                           ix_obj *o)
{
    ix_attr *a;

    (void)ix__obj_ref(o); /* first: the old value may be o itself */
    a = fresh_attr(ctx, list, name);
    if (!a) {
        ix__obj_unref(ctx, o);
        return IX_ENOMEM;
    }
    a->type = IX_ATTR_OBJ;
    a->obj = o;
    return IX_OK;
}

void ix__attr_remove(ix_ctx *ctx, ix_attr **list, const char *name)
{
    ix_obj *dead = NULL;

    while (*list && ix__name_cmp((*list)->name, name) != 0)
        list = &(*list)->next;
    if (*list) {
        ix_attr *a = *list;

        *list = a->next;
        drop_attr(ctx, a, &dead);
        ix__obj_release_dead(ctx, dead);
    }
}

static ix_attr *copy_attr(ix_ctx *ctx, const ix_attr *from)
{
    ix_attr *a = new_attr(ctx, from->name);

    if (!a)
        return NULL;
    a->type = from->type;
    a->i = from->i;
    a->r = from->r;
    a->obj = from->obj ? ix__obj_ref(from->obj) : NULL;
    a->s = from->s ? ix__strdup(ctx, from->s) : NULL;
    if (!from->s || a->s)
        return a;
    ix__attr_free_all(ctx, &a);
    return NULL;
}

ix_status ix__attr_copy_all(ix_ctx *ctx, const ix_attr *from, ix_attr **to)
{
    ix_attr *copy = NULL, **end = &copy;

    for (; from; from = from->next) {
        if (from->name[0] == '_')
            continue;
        *end = copy_attr(ctx, from);
        if (!*end) {
            ix__attr_free_all(ctx, &copy);
            return IX_ENOMEM;
        }
        end = &(*end)->next;
    }
    ix__attr_free_all(ctx, to);
    *to = copy;
    return IX_OK;
}

void ix__attr_first_to_last(ix_attr **list)
{
    ix_attr *a = *list, **end = list;

    if (!a || !a->next)
        return;
    while (*end)
        end = &(*end)->next;
    *list = a->next;
    *end = a;
    a->next = NULL;
}

void ix__attr_drop_all(ix_ctx *ctx, ix_attr **list, ix_obj **dead)
{
    while (*list) {
        ix_attr *a = *list;

        *list = a->next;
        drop_attr(ctx, a, dead);
    }
}

void ix__attr_free_all(ix_ctx *ctx, ix_attr **list)
{
    ix_obj *dead = NULL;

    ix__attr_drop_all(ctx, list, &dead);
    ix__obj_release_dead(ctx, dead);
}
