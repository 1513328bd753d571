/* trisector_search.c - points on all curves of a trisector.
 *
 * Boxes of the centre carry boxes of the parameters of their feet
 * (trisector_feet.c) and are halved. Where few feet are left, the equations are
 * linearised on the box and one foot of each object: with the inverse A of the
 * Jacobian in the middle without one column, f(z) = 0 is
 *
 *   z_j = -(A f(0))_j - (A J)_jk z_k - sum over l of (A J - 1)_jl z_l,
 *
 * J within bounds over the whole box. Either no z is in it; or the right-hand
 * side stays within a box a little larger, whatever z_k: then there is exactly
 * one z for each z_k (Krawczyk), so one arc and no loop, and each of its points
 * leads to the curve; or the box is halved further. So all curves are found but
 * those in the smallest boxes, which have not been decided: at singular points.
 * Bounds are those of Bernstein coefficients, in rounded arithmetic. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/trisector_impl.h"

enum { NV = IX__TRI_VARS };

typedef struct {
    ix__tri_box b;
    int n[3];
    size_t first; /* the three lists of feet, one after another */
} item;

/* Boxes that are halved as often, and their lists. */
typedef struct {
    item *item;
    size_t n, cap;
    ix__tri_place *list;
    size_t nlist, list_cap;
} generation;

typedef struct {
    ix__tri_task *k;
    generation now, next;
    ix__tri_feet feet[3]; /* of the box that is looked at */
    size_t work;          /* linear systems and boxes of feet */
} search;

/* --- generations ------------------------------------------------------------
 */

static ix_status room(ix_ctx *ctx, generation *g, size_t need)
{
    size_t n = g->list_cap ? g->list_cap : 1024,
           cap = g->cap ? 2 * g->cap : 256;
    ix__tri_place *more;
    item *items;

    if (need > g->list_cap) {
        while (n < need)
            n *= 2;
        IX_SCRATCH(ctx, more, n);
        if (g->nlist > 0)
            memcpy(more, g->list, g->nlist * sizeof *more);
        g->list = more;
        g->list_cap = n;
    }
    if (g->n < g->cap)
        return IX_OK;
    IX_SCRATCH(ctx, items, cap);
    if (g->n > 0)
        memcpy(items, g->item, g->n * sizeof *items);
    g->item = items;
    g->cap = cap;
    return IX_OK;
}

static ix__tri_place place_of(const ix__tri_foot *f)
{
    ix__tri_place p = {.span = f->span};

    memcpy(p.mid, f->mid, sizeof p.mid);
    memcpy(p.half, f->half, sizeof p.half);
    return p;
}

/* A box with n[i] feet of each object, for later. */
static ix_status push(search *s, const ix__tri_box *b, const int n[3],
                      const ix__tri_foot *const list[3])
{
    size_t total = (size_t)n[0] + (size_t)n[1] + (size_t)n[2];
    generation *g = &s->next;
    item *i;

    IX_TRY(room(s->k->ctx, g, g->nlist + total));
    i = &g->item[g->n++];
    *i = (item){.b = *b, .first = g->nlist};
    for (int o = 0; o < 3; o++) {
        i->n[o] = n[o];
        for (int k = 0; k < n[o]; k++)
            g->list[g->nlist++] = place_of(&list[o][k]);
    }
    return IX_OK;
}

/* Both halves across an axis, or, if that is negative, the longest edge. */
static ix_status push_halves(search *s, const ix__tri_box *b, int axis,
                             const int n[3], const ix__tri_foot *const list[3])
{
    ix__tri_box half = *b;

    if (axis < 0 || axis > 2)
        axis = b->h[0] >= b->h[1] && b->h[0] >= b->h[2] ? 0
               : b->h[1] >= b->h[2]                     ? 1
                                                        : 2;
    half.h[axis] *= 0.5;
    half.c[axis] = b->c[axis] - half.h[axis];
    IX_TRY(push(s, &half, n, list));
    half.c[axis] = b->c[axis] + half.h[axis];
    return push(s, &half, n, list);
}

/* --- feet -------------------------------------------------------------------
 */

/* Leaves out feet whose distances no foot of another object has; false if none
 * are left. */
static bool compare(search *s, const ix__tri_box *b, double range[2])
{
    double d[2];

    range[0] = 0.0;
    range[1] = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double lo = HUGE_VAL, hi = 0.0;

        for (int k = 0; k < s->feet[i].n; k++) {
            ix__tri_distances(b, &s->feet[i].f[k], d);
            lo = fmin(lo, d[0]);
            hi = fmax(hi, d[1]);
        }
        range[0] = fmax(range[0], lo);
        range[1] = fmin(range[1], hi);
    }
    for (int i = 0; i < 3; i++) {
        ix__tri_feet *l = &s->feet[i];
        int n = 0;

        for (int k = 0; k < l->n; k++) {
            ix__tri_distances(b, &l->f[k], d);
            if (d[0] <= range[1] && d[1] >= range[0])
                l->f[n++] = l->f[k];
        }
        l->n = n;
        if (n == 0)
            return false;
    }
    return range[1] > IX__TRI_TINY * s->k->size;
}

/* The feet of an item; false if there are none. */
static ix_status feet_of(search *s, const item *it, bool *left)
{
    const ix__tri_place *from = s->now.list + it->first;
    double range[2] = {0.0, HUGE_VAL};

    *left = true;
    for (int i = 0; i < 3 && *left; i++) {
        double d[2], lo = HUGE_VAL, hi = 0.0;

        s->feet[i].n = 0;
        IX_TRY(ix__tri_feet_in(s->k->ctx, &s->k->object[i], &it->b, range, from,
                               it->n[i], &s->feet[i]));
        from += it->n[i];
        s->work += (size_t)s->feet[i].n;
        for (int k = 0; k < s->feet[i].n; k++) {
            ix__tri_distances(&it->b, &s->feet[i].f[k], d);
            lo = fmin(lo, d[0]);
            hi = fmax(hi, d[1]);
        }
        range[0] = fmax(range[0], lo);
        range[1] = fmin(range[1], hi);
        *left = s->feet[i].n > 0;
    }
    if (*left)
        *left = compare(s, &it->b, range);
    return IX_OK;
}

/* --- points of arcs ---------------------------------------------------------
 */

enum { SAMPLES = 8 };

/* Whether the arc's box is in the whole box and in its spans. */
static bool is_inner(const search *s, const ix__tri_box *b,
                     const ix__tri_linear *l)
{
    const double *box = s->k->box;

    for (int c = 0; c < 3; c++)
        if (b->c[c] - (1.0 + IX__TRI_MARGIN) * b->h[c] < box[c] ||
            b->c[c] + (1.0 + IX__TRI_MARGIN) * b->h[c] > box[3 + c])
            return false;
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < s->k->shape.ndirs[i]; a++)
            if (fabs(l->p[i]->mid[a] - 0.5) +
                    (1.0 + IX__TRI_MARGIN) * l->p[i]->half[a] >
                0.5)
                return false;
    return true;
}

/* Points of an arc that are inside, of which curves start; *found if there are
 * any. */
static ix_status start(search *s, const ix__tri_box *b, const ix__tri_linear *l,
                       bool *found)
{
    const ix__tri_shape *sh = &s->k->shape;
    const double *range = l->range[l->inv.free];
    const int span[3] = {l->p[0]->span, l->p[1]->span, l->p[2]->span};

    int samples = is_inner(s, b, l) ? 1 : SAMPLES + 1;

    *found = false;
    for (int i = 0; i < samples; i++) {
        double x[NV], z[NV];
        double free = range[0] + (range[1] - range[0]) * (i + 0.5) / samples;

        x[l->inv.free] = free;
        for (int r = 0; r < sh->neqs; r++)
            x[l->inv.of[r]] = l->at0[r] - l->inv.slope[r] * free;
        for (int k = 0; k < 3; k++) {
            z[k] = b->c[k] + l->half[k] * x[k];
            for (int a = 0; a < sh->ndirs[k]; a++) {
                int at = sh->at[k] + a;

                z[at] = l->p[k]->mid[a] + l->half[at] * x[at];
            }
        }
        if (!ix__tri_correct(s->k, span, l->inv.free, z) ||
            !ix__tri_inside(s->k, span, z))
            continue;
        *found = true;
        IX_TRY(ix__tri_trace(s->k, span, z));
    }
    return IX_OK;
}

/* --- all boxes --------------------------------------------------------------
 */

/* Boxes of the centre smaller than this part of the whole that stay undecided
 * are singular points. */
#define SMALLEST 1e-6

/* Of its volume what a box must lose not to be halved. */
#define GAIN 0.4

/* Of a span: parameters in boxes so small are not told apart. */
#define FINEST 1e-9

/* Both halves of the parameter's box. */
static ix_status push_foot_halves(search *s, const ix__tri_box *b,
                                  ix__tri_foot f[3], int unknown)
{
    static const int one[3] = {1, 1, 1};
    const ix__tri_foot *const list[3] = {&f[0], &f[1], &f[2]};
    const ix__tri_shape *sh = &s->k->shape;
    int i = 0, a;
    double mid;

    while (i < 2 && unknown >= sh->at[i] + sh->ndirs[i])
        i++;
    a = unknown - sh->at[i];
    mid = f[i].mid[a];
    f[i].half[a] *= 0.5;
    f[i].mid[a] = mid - f[i].half[a];
    IX_TRY(push(s, b, one, list));
    f[i].mid[a] = mid + f[i].half[a];
    return push(s, b, one, list);
}

/* What is left of an undecided box with one foot of each, for later. */
static ix_status postpone(search *s, const ix__tri_box *b,
                          const ix__tri_linear *l)
{
    static const int one[3] = {1, 1, 1};
    const ix__tri_shape *sh = &s->k->shape;
    ix__tri_foot f[3] = {*l->p[0], *l->p[1], *l->p[2]};
    const ix__tri_foot *const list[3] = {&f[0], &f[1], &f[2]};
    ix__tri_box r = *b;
    double part = 1.0;

    for (int c = 0; c < 3; c++) {
        const double *x = l->range[c];

        r.c[c] = b->c[c] + 0.5 * (x[0] + x[1]) * b->h[c];
        r.h[c] = 0.5 * (x[1] - x[0]) * b->h[c];
        part *= 0.5 * (x[1] - x[0]);
    }
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < sh->ndirs[i]; a++) {
            const double *x = l->range[sh->at[i] + a];

            f[i].mid[a] += 0.5 * (x[0] + x[1]) * f[i].half[a];
            f[i].half[a] *= 0.5 * (x[1] - x[0]);
        }
    if (ix__tri_diameter(&r) < SMALLEST * s->k->size)
        return IX_OK;
    if (part < GAIN)
        return push(s, &r, one, list);
    if (!ix__tri_is_tube(s->k, l))
        return push_halves(s, &r, -1, one, list);
    if (l->inv.free >= 3 && l->half[l->inv.free] > FINEST)
        return push_foot_halves(s, &r, f, l->inv.free);
    return push_halves(s, &r, l->inv.free, one, list);
}

static ix_status decide(search *s, const ix__tri_box *b,
                        const ix__tri_foot *const one[3])
{
    bool found = true;
    ix__tri_linear l;
    ix__tri_verdict v;

    memcpy(l.p, one, sizeof l.p);
    s->work++;
    v = ix__tri_judge(s->k, b, &l);
    if (v == IX__TRI_ARC)
        IX_TRY(start(s, b, &l, &found));
    return v == IX__TRI_NONE || (v == IX__TRI_ARC && found)
               ? IX_OK
               : postpone(s, b, &l);
}

/* Triples of feet: with more the box is halved first. */
enum { FEW = 16 };

static ix_status decide_all(search *s, const ix__tri_box *b, const int n[3],
                            const ix__tri_foot *const list[3])
{
    for (int i = 0; i < n[0]; i++)
        for (int j = 0; j < n[1]; j++)
            for (int k = 0; k < n[2]; k++) {
                const ix__tri_foot *const one[3] = {&list[0][i], &list[1][j],
                                                    &list[2][k]};

                IX_TRY(decide(s, b, one));
            }
    return IX_OK;
}

static ix_status look(search *s, const item *it)
{
    const ix__tri_foot *list[3];
    double triples = 1.0;
    bool left;
    int n[3];

    IX_TRY(ix__poll(s->k->ctx));
    IX_TRY(feet_of(s, it, &left));
    if (!left)
        return IX_OK;
    for (int i = 0; i < 3; i++) {
        list[i] = s->feet[i].f;
        n[i] = s->feet[i].n;
        triples *= n[i];
    }
    return triples > FEW && ix__tri_diameter(&it->b) > SMALLEST * s->k->size
               ? push_halves(s, &it->b, -1, n, list)
               : decide_all(s, &it->b, n, list);
}

/* The whole box and all spans. */
static ix_status begin(search *s)
{
    ix__tri_task *k = s->k;
    ix__tri_foot *f[3];
    ix__tri_box all;
    int n[3];

    for (int i = 0; i < 3; i++) {
        all.c[i] = 0.5 * (k->box[i] + k->box[3 + i]);
        all.h[i] = 0.5 * (k->box[3 + i] - k->box[i]);
        n[i] = k->object[i].nspans;
        IX_SCRATCH_ZERO(k->ctx, f[i], n[i]);
        for (int j = 0; j < n[i]; j++) {
            f[i][j].span = j;
            for (int a = 0; a < 2; a++)
                f[i][j].mid[a] = f[i][j].half[a] = 0.5;
        }
    }
    return push(s, &all, n, (const ix__tri_foot *const *)f);
}

/* Some ten seconds. */
enum { MOST_WORK = 1000000 };

ix_status ix__tri_search(ix__tri_task *k)
{
    search s = {.k = k};
    size_t at = 0;

    IX_TRY(begin(&s));
    while (at < s.now.n || s.next.n > 0) {
        if (at == s.now.n) {
            generation used = s.now;

            s.now = s.next;
            s.next = used;
            s.next.n = s.next.nlist = 0;
            at = 0;
        }
        if (s.work > MOST_WORK) {
            k->complete = false;
            return IX_OK;
        }
        IX_TRY(look(&s, &s.now.item[at++]));
    }
    return IX_OK;
}
