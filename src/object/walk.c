/* walk.c - walks over lists and object attributes; what an object contains,
 * and how large it is when written out. */
#include "object/walk.h"

#include "object/release_impl.h"

/* --- breadth first, without memory ------------------------------------ */

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

static ix_obj *queue_next(const ix_obj *o)
{
    return o->mark == o ? NULL : o->mark;
}

static void queue_clear(queue *q)
{
    ix_obj *o = q->first;

    while (o) {
        ix_obj *next = queue_next(o);

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
        if (a->obj && a->obj == x)
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
    bool found = false;

    if (o == x)
        return true;
    if (!holds_boxes(o))
        return false;
    queue_add(&q, IX_MUTABLE(ix_obj, o));
    for (ix_obj *at = q.first; at && !found; at = queue_next(at))
        found = add_children(&q, at, x);
    queue_clear(&q);
    return found;
}

static ix_status visit_items(queue *q, const ix_list *l, ix__leaf_fn fn,
                             void *arg)
{
    for (int i = 0; i < l->n; i++) {
        if (l->item[i]->type == IX_OBJ_LIST)
            queue_add(q, l->item[i]);
        else
            IX_TRY(fn(arg, l->item[i]));
    }
    return IX_OK;
}

ix_status ix__walk_leaves(const ix_obj *o, ix__leaf_fn fn, void *arg)
{
    queue q = {NULL, NULL};
    ix_status st = IX_OK;

    if (o->type != IX_OBJ_LIST)
        return fn(arg, o);
    queue_add(&q, IX_MUTABLE(ix_obj, o));
    for (ix_obj *at = q.first; at && st == IX_OK; at = queue_next(at))
        st = visit_items(&q, &at->u.list, fn, arg);
    queue_clear(&q);
    return st;
}

/* --- depth first, with a node for each box ---------------------------- */

bool ix__walk_inner(const ix__walk *w, const ix_obj *o)
{
    return o->type == IX_OBJ_LIST || (w->attrs && o->attrs);
}

static ix_status push(ix__walk *w, ix_obj *o)
{
    ix__node *n;

    if (w->max_depth > 0 && w->depth == w->max_depth)
        return IX_FAIL(w->ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       w->max_depth);
    IX_TRY(ix__poll(w->ctx));
    IX_SCRATCH_ZERO(w->ctx, n, 1);
    n->box = o;
    n->attr = w->attrs ? o->attrs : NULL;
    n->up = w->top;
    n->all = w->all;
    w->all = w->top = n;
    w->depth++;
    o->mark = n;
    return w->ops->enter(w);
}

static ix_status child(ix__walk *w, ix_obj *o)
{
    ix__node *n = o->mark;

    if (!ix__walk_inner(w, o))
        return w->ops->leaf(w, o);
    if (!n)
        return push(w, o);
    if (!n->done)
        return IX_FAIL(w->ctx, IX_EUNABLE, "a list contains itself");
    return w->ops->join(w, n);
}

static ix_status pop(ix__walk *w)
{
    ix__node *n = w->top;

    n->done = true;
    w->top = n->up;
    w->depth--;
    return w->top ? w->ops->join(w, n) : IX_OK;
}

static ix_status step(ix__walk *w)
{
    ix__node *n = w->top;
    const ix_obj *o = n->box;

    if (n->attr) {
        ix_obj *value = n->attr->obj;

        n->attr = n->attr->next;
        return value ? child(w, value) : IX_OK;
    }
    if (o->type == IX_OBJ_LIST && n->item < o->u.list.n)
        return child(w, o->u.list.item[n->item++]);
    return pop(w);
}

ix_status ix__walk_run(ix__walk *w, const ix_obj *root, ix__node **node)
{
    IX_TRY(push(w, IX_MUTABLE(ix_obj, root)));
    *node = w->top;
    while (w->top)
        IX_TRY(step(w));
    return IX_OK;
}

void ix__walk_end(ix__walk *w)
{
    for (ix__node *n = w->all; n; n = n->all)
        n->box->mark = NULL;
}

/* --- the size of an object in a file ---------------------------------- */

static double mvs_values(const ix_mvs *m)
{
    double n = 0;

    for (int i = 0; i < m->n; i++)
        n += (double)ix_mv_npts(m->mv[i]) * ix_mv_naxes(m->mv[i]);
    return n;
}

static double poly_values(const ix_poly *p)
{
    double n = 0;

    for (int i = 0; i < p->n; i++)
        n += 3.0 * p->poly[i].n;
    return n;
}

/* At least this many characters: a header, two for each number. */
static double own_bytes(const ix_obj *o)
{
    const double head = 20;

    switch (o->type) {
    case IX_OBJ_STRING:
        return head + (double)o->u.str.len;
    case IX_OBJ_POLY:
        return head + 2 * poly_values(o->u.poly);
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return head + 2 * mvs_values(o->u.mvs);
    case IX_OBJ_TRIMSRF:
        return head + 2 * (double)ix_mv_npts(o->u.trim.item[0]->srf);
    case IX_OBJ_TRISRF:
        return head + 2.0 * o->u.tri.item[0]->npts;
    default:
        return head;
    }
}

static void add_child(ix__node *to, double bytes, int depth)
{
    to->bytes += bytes;
    if (to->depth < depth + 1)
        to->depth = depth + 1;
}

static ix_status size_enter(ix__walk *w)
{
    w->top->bytes = own_bytes(w->top->box);
    w->top->depth = 1;
    return IX_OK;
}

static ix_status size_leaf(ix__walk *w, const ix_obj *o)
{
    add_child(w->top, own_bytes(o), 1);
    return IX_OK;
}

static ix_status size_join(ix__walk *w, const ix__node *n)
{
    add_child(w->top, n->bytes, n->depth);
    return IX_OK;
}

static ix_status check_total(ix_ctx *ctx, const ix__node *n, int max_depth,
                             size_t max_bytes)
{
    if (n->depth > max_depth)
        return IX_FAIL(ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       max_depth);
    if (!(n->bytes <= (double)max_bytes))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "written out, shared lists would take %.3g bytes or "
                       "more; the limit is %zu",
                       n->bytes, max_bytes);
    return IX_OK;
}

ix_status ix__obj_check_size(ix_ctx *ctx, const ix_obj *o, int max_depth,
                             size_t max_bytes)
{
    static const ix__walk_ops ops = {size_enter, size_leaf, size_join};
    ix__walk w = {
        .ctx = ctx, .ops = &ops, .attrs = true, .max_depth = max_depth};
    ix__node *root;
    ix_mark mk;
    ix_status st;

    if (!ix__walk_inner(&w, o))
        return IX_OK;
    mk = ix__scratch_mark(ctx);
    st = ix__walk_run(&w, o, &root);
    if (st == IX_OK)
        st = check_total(ctx, root, max_depth, max_bytes);
    ix__walk_end(&w);
    ix__scratch_release(ctx, mk);
    return st;
}
