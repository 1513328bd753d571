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

/* --- how large an object is when written out -------------------------- */

/* A box on the way: its children are looked at once, its totals added for
 * each reference to it. */
typedef struct node node;
struct node {
    ix_obj *box;
    node *up;  /* the box whose children led here */
    node *all; /* the node made before */
    const ix_attr *attr;
    int item;
    bool done;
    int depth;    /* of what is below */
    double bytes; /* lower estimate of the text */
};

typedef struct {
    ix_ctx *ctx;
    node *top, *all;
    int max_depth;
    int at_depth;
} sizing;

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
static double leaf_bytes(const ix_obj *o)
{
    const double header = 20;

    switch (o->type) {
    case IX_OBJ_STRING:
        return header + (double)o->u.str.len;
    case IX_OBJ_POLY:
        return header + 2 * poly_values(o->u.poly);
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return header + 2 * mvs_values(o->u.mvs);
    case IX_OBJ_TRIMSRF:
        return header + 2 * (double)ix_mv_npts(o->u.trim.item[0]->srf);
    case IX_OBJ_TRISRF:
        return header + 2.0 * o->u.tri.item[0]->npts;
    default:
        return header;
    }
}

static void add_total(node *to, double bytes, int depth)
{
    to->bytes += bytes;
    if (to->depth < depth)
        to->depth = depth;
}

/* Counts o for the box on top, or puts it on top to be counted first. */
static ix_status enter(sizing *z, ix_obj *o)
{
    node *n = o->mark;

    if (!holds_boxes(o)) {
        add_total(z->top, leaf_bytes(o), 1);
        return IX_OK;
    }
    if (n && !n->done)
        return IX_FAIL(z->ctx, IX_EUNABLE, "a list contains itself");
    if (n) {
        add_total(z->top, n->bytes, n->depth);
        return IX_OK;
    }
    if (z->at_depth == z->max_depth)
        return IX_FAIL(z->ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       z->max_depth);
    IX_SCRATCH_ZERO(z->ctx, n, 1);
    n->box = o;
    n->attr = o->attrs;
    n->bytes = leaf_bytes(o);
    n->up = z->top;
    n->all = z->all;
    z->all = z->top = n;
    z->at_depth++;
    o->mark = n;
    return ix__poll(z->ctx);
}

static void leave(sizing *z)
{
    node *n = z->top;

    n->done = true;
    n->depth++;
    z->top = n->up;
    z->at_depth--;
    if (z->top)
        add_total(z->top, n->bytes, n->depth);
}

static ix_status sizing_step(sizing *z)
{
    node *n = z->top;

    if (n->attr) {
        ix_obj *o = n->attr->obj;

        n->attr = n->attr->next;
        return o ? enter(z, o) : IX_OK;
    }
    if (n->box->type == IX_OBJ_LIST && n->item < n->box->u.list.n)
        return enter(z, n->box->u.list.item[n->item++]);
    leave(z);
    return IX_OK;
}

static ix_status measure(sizing *z, const ix_obj *o, node *total)
{
    IX_TRY(enter(z, IX_MUTABLE(ix_obj, o)));
    while (z->top)
        IX_TRY(sizing_step(z));
    *total = *(const node *)o->mark;
    return IX_OK;
}

ix_status ix__obj_check_size(ix_ctx *ctx, const ix_obj *o, int max_depth,
                             size_t max_bytes)
{
    sizing z = {.ctx = ctx, .max_depth = max_depth};
    node total = {0};
    ix_mark mk;
    ix_status st;

    if (!holds_boxes(o))
        return IX_OK;
    mk = ix__scratch_mark(ctx);
    st = measure(&z, o, &total);
    for (node *n = z.all; n; n = n->all)
        n->box->mark = NULL;
    ix__scratch_release(ctx, mk);
    if (st == IX_OK && total.depth > max_depth)
        return IX_FAIL(ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       max_depth);
    if (st == IX_OK && !(total.bytes <= (double)max_bytes))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "written out, shared lists would take %.3g bytes or "
                       "more; the limit is %zu",
                       total.bytes, max_bytes);
    return st;
}
