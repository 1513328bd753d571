/* ast.c - units: the arena of a statement, its source lines, its literals. */
#include "lang/ast_impl.h"

#include <string.h>

#define BLOCK 4000u

struct ix__block {
    ix__block *next;
    size_t size, used;
    double data[]; /* aligned for anything kept in nodes */
};

static ix__block *block_new(ix_ctx *ctx, size_t size)
{
    ix__block *b = ix__alloc(ctx, sizeof *b + size);

    if (b)
        *b = (ix__block){.size = size};
    return b;
}

ix__unit *ix__unit_new(ix_ctx *ctx)
{
    ix__unit *u = ix__alloc(ctx, sizeof *u);

    if (u)
        *u = (ix__unit){.refs = 1, .ctx = ctx};
    return u;
}

ix__unit *ix__unit_ref(ix__unit *u)
{
    u->refs++;
    return u;
}

static void drop_literals(ix__unit *u)
{
    for (ix__node *n = u->lits; n; n = n->next_lit)
        ix__obj_unref(u->ctx, n->box);
    u->lits = NULL;
}

/* Frees the blocks before keep (NULL: all of them). */
static void drop_blocks(ix__unit *u, const ix__block *keep)
{
    while (u->blocks != keep) {
        ix__block *b = u->blocks;

        u->blocks = b->next;
        ix__free(u->ctx, b, sizeof *b + b->size);
    }
}

void ix__unit_clear(ix__unit *u)
{
    ix__block *first = u->blocks;

    drop_literals(u);
    while (first && first->next)
        first = first->next;
    drop_blocks(u, first);
    if (first)
        first->used = 0;
    u->line = NULL;
    u->nlines = u->cap_lines = 0;
}

void ix__unit_unref(ix__unit *u)
{
    if (!u || --u->refs)
        return;
    drop_literals(u);
    drop_blocks(u, NULL);
    ix__free(u->ctx, u, sizeof *u);
}

void *ix__unit_alloc(ix__unit *u, size_t size)
{
    ix__block *b = u->blocks;
    char *p;

    size = (size + sizeof(double) - 1) / sizeof(double) * sizeof(double);
    if (!b || b->size - b->used < size) {
        b = block_new(u->ctx, size > BLOCK ? size : BLOCK);
        if (!b)
            return NULL;
        b->next = u->blocks;
        u->blocks = b;
    }
    p = (char *)b->data + b->used;
    b->used += size;
    return memset(p, 0, size);
}

const char *ix__unit_text(ix__unit *u, const char *s, size_t n)
{
    char *t = ix__unit_alloc(u, n + 1);

    if (t)
        memcpy(t, s, n);
    return t;
}

ix_status ix__unit_add_line(ix__unit *u, const char *file, int number,
                            const char *text, size_t n)
{
    const char *copy;

    if (u->nlines == u->cap_lines) {
        unsigned cap = u->cap_lines ? 2 * u->cap_lines : 4;
        ix__line *more = ix__unit_alloc(u, cap * sizeof *more);

        if (!more)
            return IX_ENOMEM;
        if (u->nlines)
            memcpy(more, u->line, u->nlines * sizeof *more);
        u->line = more;
        u->cap_lines = cap;
    }
    copy = ix__unit_text(u, text, n);
    if (!copy)
        return IX_ENOMEM;
    u->line[u->nlines++] = (ix__line){file, number, copy};
    return IX_OK;
}

ix_obj *ix__node_box(ix__unit *u, ix__node *n)
{
    ix_obj *fresh;

    if (n->box && n->box->refs == 1 && !n->box->name && !n->box->attrs)
        return n->box;
    fresh = n->kind == N_NUM ? ix__obj_number(u->ctx, n->u.lit.num)
                             : ix__obj_string(u->ctx, n->u.str.s, n->u.str.len);
    if (!fresh)
        return NULL;
    if (n->box) {
        ix__obj_unref(u->ctx, n->box);
    } else {
        n->next_lit = u->lits;
        u->lits = n;
    }
    n->box = fresh;
    return fresh;
}

bool ix__node_is_var(const ix__node *n)
{
    return n->kind >= N_GLOBAL && n->kind <= N_UNBOUND;
}

int ix__fn_slot(const ix__fn *fn, const char *name)
{
    for (int i = 0; i < fn->nslots; i++)
        if (strcmp(fn->slot_name[i], name) == 0)
            return i;
    return -1;
}

ix_status ix__fn_add_slot(ix__fn *fn, const char *name)
{
    if (fn->nslots == fn->cap_slots) {
        int cap = fn->cap_slots ? 2 * fn->cap_slots : 8;
        const char **more = ix__unit_alloc(fn->unit,
                                           (size_t)cap * sizeof *more);

        if (!more)
            return IX_ENOMEM;
        if (fn->nslots)
            memcpy(more, fn->slot_name, (size_t)fn->nslots * sizeof *more);
        fn->slot_name = more;
        fn->cap_slots = cap;
    }
    fn->slot_name[fn->nslots++] = name;
    return IX_OK;
}
