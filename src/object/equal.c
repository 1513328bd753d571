/* equal.c - do two objects have the same value? Lists are compared pair by
 * pair, each pair once, however often shared elements lead to it. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "object/object.h"

/* --- values without children ------------------------------------------ */

/* Closer than eps counts as equal (spec/language 5.6), and so does equal. */
static bool near(int n, const double *a, const double *b, double eps)
{
    for (int i = 0; i < n; i++)
        if (!(fabs(a[i] - b[i]) < eps || a[i] == b[i]))
            return false;
    return true;
}

/* A plane is its negation as well. */
static bool same_plane(const double *a, const double *b, double eps)
{
    double neg[4] = {-b[0], -b[1], -b[2], -b[3]};

    return near(4, a, b, eps) || near(4, a, neg, eps);
}

static bool same_ctlpt(const ix_ctlpt *a, const ix_ctlpt *b, double eps)
{
    return a->ncoords == b->ncoords && a->rational == b->rational &&
           near(a->ncoords + a->rational, a->v, b->v, eps);
}

static bool same_poly(const ix_poly *a, const ix_poly *b, double eps)
{
    if (a->n != b->n)
        return false;
    for (int i = 0; i < a->n; i++) {
        const ix_polygon *p = &a->poly[i], *q = &b->poly[i];

        if (p->kind != q->kind || p->n != q->n)
            return false;
        for (int k = 0; k < p->n; k++)
            if (!near(3, p->v[k].p, q->v[k].p, eps))
                return false;
    }
    return true;
}

static bool same_mv(const ix_mv *a, const ix_mv *b, double eps)
{
    if (a == b || !a || !b)
        return a == b;
    return ix_mv_equal(a, b, eps);
}

static bool same_trimsrf(const ix_trimsrf *a, const ix_trimsrf *b, double eps)
{
    if (a->nloops != b->nloops || !same_mv(a->srf, b->srf, eps))
        return false;
    for (int i = 0; i < a->nloops; i++) {
        const ix_trimloop *p = &a->loop[i], *q = &b->loop[i];

        if (p->n != q->n)
            return false;
        for (int k = 0; k < p->n; k++)
            if (!same_mv(p->seg[k].uv, q->seg[k].uv, eps) ||
                !same_mv(p->seg[k].euclid, q->seg[k].euclid, eps))
                return false;
    }
    return true;
}

static bool same_trisrf(const ix_trisrf *a, const ix_trisrf *b, double eps)
{
    return a->kind == b->kind && a->length == b->length &&
           a->order == b->order && a->ncoords == b->ncoords &&
           a->rational == b->rational &&
           near(a->nknots, a->knots, b->knots, eps) &&
           near(a->npts * (a->ncoords + a->rational), a->pts, b->pts, eps);
}

static bool same_model_srf(const ix_model_srf *a, const ix_model_srf *b,
                           double eps)
{
    if (a->nloops != b->nloops || !same_mv(a->srf, b->srf, eps))
        return false;
    for (int i = 0; i < a->nloops; i++)
        if (a->nseg[i] != b->nseg[i] ||
            (a->nseg[i] > 0 && memcmp(a->seg[i], b->seg[i],
                                      (size_t)a->nseg[i] * sizeof(int)) != 0))
            return false;
    return true;
}

static bool same_model(const ix_model *a, const ix_model *b, double eps)
{
    if (a->nsrf != b->nsrf || a->nseg != b->nseg)
        return false;
    for (int i = 0; i < a->nsrf; i++)
        if (!same_model_srf(&a->srf[i], &b->srf[i], eps))
            return false;
    for (int i = 0; i < a->nseg; i++) {
        const ix_model_seg *p = &a->seg[i], *q = &b->seg[i];

        if (p->s1 != q->s1 || p->s2 != q->s2 || !same_mv(p->uv1, q->uv1, eps) ||
            !same_mv(p->uv2, q->uv2, eps) ||
            !same_mv(p->euclid, q->euclid, eps))
            return false;
    }
    return true;
}

static bool same_item(ix_obj_type type, const void *a, const void *b,
                      double eps)
{
    switch (type) {
    case IX_OBJ_TRIMSRF:
        return a == b || same_trimsrf(a, b, eps);
    case IX_OBJ_TRISRF:
        return a == b || same_trisrf(a, b, eps);
    case IX_OBJ_MODEL:
        return a == b || same_model(a, b, eps);
    default:
        return same_mv(a, b, eps);
    }
}

static bool same_sequence(const ix_obj *a, const ix_obj *b, double eps)
{
    int n = ix__seq_count(a);

    if (n != ix__seq_count(b))
        return false;
    for (int i = 0; i < n; i++)
        if (!same_item(a->type, ix__seq_item(a, i), ix__seq_item(b, i), eps))
            return false;
    return true;
}

static bool same_text(const ix_obj *a, const ix_obj *b)
{
    return a->u.str.len == b->u.str.len &&
           memcmp(a->u.str.s, b->u.str.s, a->u.str.len) == 0;
}

/* Of one type, which is no list. */
static bool same_leaf(const ix_obj *a, const ix_obj *b, double eps)
{
    switch (a->type) {
    case IX_OBJ_NUMBER:
        return near(1, &a->u.num, &b->u.num, eps);
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        return near(3, a->u.pt, b->u.pt, eps);
    case IX_OBJ_PLANE:
        return same_plane(a->u.plane, b->u.plane, eps);
    case IX_OBJ_MATRIX:
        return near(16, a->u.mat, b->u.mat, eps);
    case IX_OBJ_STRING:
        return same_text(a, b);
    case IX_OBJ_CTLPT:
        return same_ctlpt(a->u.ctlpt, b->u.ctlpt, eps);
    case IX_OBJ_POLY:
        return same_poly(a->u.poly, b->u.poly, eps);
    case IX_OBJ_INSTANCE:
        return strcmp(a->u.inst->target, b->u.inst->target) == 0 &&
               near(16, a->u.inst->mat, b->u.inst->mat, eps);
    default:
        return same_sequence(a, b, eps);
    }
}

/* --- lists ------------------------------------------------------------ */

/* The pairs of lists met so far: an array, looked through by a hash table of
 * indices + 1, which is at most half full. The pairs from `next` on are still
 * to be compared. */
typedef struct {
    const ix_obj *a, *b;
} pair;
typedef struct {
    ix_ctx *ctx;
    double eps;
    size_t n, cap, next;
    pair *pairs;   /* [cap] */
    size_t *table; /* [2 cap], cap a power of two */
} comparing;

static size_t slot_of(const comparing *c, pair p)
{
    uint64_t h = ((uint64_t)(uintptr_t)p.a >> 4) * 0x9e3779b97f4a7c15u;

    h = (h ^ ((uint64_t)(uintptr_t)p.b >> 4)) * 0xbf58476d1ce4e5b9u;
    return (size_t)(h >> 32) & (2 * c->cap - 1);
}

/* The slot that holds p or where it would be put. */
static size_t *find_slot(const comparing *c, pair p)
{
    size_t i = slot_of(c, p);

    while (c->table[i] && (c->pairs[c->table[i] - 1].a != p.a ||
                           c->pairs[c->table[i] - 1].b != p.b))
        i = (i + 1) & (2 * c->cap - 1);
    return &c->table[i];
}

static ix_status make_room(comparing *c)
{
    pair *old = c->pairs;

    if (c->n < c->cap)
        return IX_OK;
    c->cap = c->cap ? 2 * c->cap : 64;
    IX_SCRATCH(c->ctx, c->pairs, c->cap);
    IX_SCRATCH_ZERO(c->ctx, c->table, 2 * c->cap);
    if (c->n > 0)
        memcpy(c->pairs, old, c->n * sizeof *old);
    for (size_t i = 0; i < c->n; i++)
        *find_slot(c, c->pairs[i]) = i + 1;
    return IX_OK;
}

static ix_status add_pair(comparing *c, const ix_obj *a, const ix_obj *b)
{
    pair p = {a, b};
    size_t *slot;

    IX_TRY(make_room(c));
    slot = find_slot(c, p);
    if (*slot == 0) {
        c->pairs[c->n++] = p;
        *slot = c->n;
    }
    return IX_OK;
}

/* Elements beyond the left list's length are not looked at. */
static ix_status compare_items(comparing *c, pair p, bool *equal)
{
    const ix_list *a = &p.a->u.list, *b = &p.b->u.list;

    *equal = a->n <= b->n;
    for (int i = 0; *equal && i < a->n; i++) {
        const ix_obj *x = a->item[i], *y = b->item[i];

        if (x == y)
            continue;
        *equal = x->type == y->type;
        if (!*equal)
            break;
        if (x->type == IX_OBJ_LIST)
            IX_TRY(add_pair(c, x, y));
        else
            *equal = same_leaf(x, y, c->eps);
    }
    return IX_OK;
}

static ix_status compare_lists(comparing *c, const ix_obj *a, const ix_obj *b,
                               bool *equal)
{
    IX_TRY(add_pair(c, a, b));
    while (*equal && c->next < c->n) {
        IX_TRY(ix__poll(c->ctx));
        IX_TRY(compare_items(c, c->pairs[c->next++], equal));
    }
    return IX_OK;
}

ix_status ix__obj_equal(ix_ctx *ctx, const ix_obj *a, const ix_obj *b,
                        double eps, bool *equal)
{
    comparing c = {.ctx = ctx, .eps = eps};
    ix_mark mk;
    ix_status st;

    *equal = a == b;
    if (a->type != b->type)
        return IX_FAIL(ctx, IX_EARG, "%s cannot be compared with %s",
                       ix__obj_type_name(a->type), ix__obj_type_name(b->type));
    if (a == b)
        return IX_OK;
    *equal = true;
    if (a->type != IX_OBJ_LIST) {
        *equal = same_leaf(a, b, eps);
        return IX_OK;
    }
    mk = ix__scratch_mark(ctx);
    st = compare_lists(&c, a, b, equal);
    ix__scratch_release(ctx, mk);
    return st;
}
