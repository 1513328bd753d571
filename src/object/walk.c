/* walk.c - looking through an object's lists and object attributes.
 *
 * Lists may share elements, so that n boxes can stand for 2^n paths; every
 * walk here marks the boxes that it has met and clears the marks at its end. */
#include "object/release_impl.h"

/* A queue of marked boxes: each mark points to the next, the last to itself. */
typedef struct {
    ix_obj *first, *last;
} queue;

static void queue_add(queue *q, ix_obj *o)
{
    if (o->mark)
        return;
    if (q->last)
        q->last->mark = o;
    else
        q->first = o;
    q->last = o;
    o->mark = o;
}

static void queue_clear(queue *q)
{
    ix_obj *o = q->first;

    while (o) {
        ix_obj *next = o->mark == o ? NULL : o->mark;

        o->mark = NULL;
        o = next;
    }
}

static bool holds_boxes(const ix_obj *o)
{
    return o->type == IX_OBJ_LIST || o->attrs;
}

/* Adds what o holds to the queue; true if x is among it. */
static bool add_children(queue *q, const ix_obj *o, const ix_obj *x)
{
    for (const ix_attr *a = o->attrs; a; a = a->next) {
        if (a->obj == x)
            return true;
        if (a->obj && holds_boxes(a->obj))
            queue_add(q, a->obj);
    }
    if (o->type != IX_OBJ_LIST)
        return false;
    for (int i = 0; i < o->u.list.n; i++) {
        ix_obj *item = o->u.list.item[i];

        if (item == x)
            return true;
        if (holds_boxes(item))
            queue_add(q, item);
    }
    return false;
}

bool ix__obj_contains(const ix_obj *o, const ix_obj *x)
{
    queue q = {NULL, NULL};
    ix_obj *at;
    bool found = false;

    if (o == x)
        return true;
    if (!holds_boxes(o))
        return false;
    queue_add(&q, IX_MUTABLE(ix_obj, o));
    for (at = q.first; !found; at = at->mark) {
        found = add_children(&q, at, x);
        if (at->mark == at)
            break;
    }
    queue_clear(&q);
    return found;
}
