/* box.c - boxes, and the search by halving.
 *
 * Invariant: |true coefficient - stored one| <= err of its tensor, whatever
 * has been done to the box since the equations were decomposed. */
#include "solve/box.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define UNIT  (DBL_EPSILON / 2)
#define HALF  0x1p-26
#define CROWD 64 /* undecided boxes before the smallest size doubles */
#define CROWDED                                                           \
    0x1p-9 /* a smallest size that only a curve drives cells to: multiple \
               points are hidden by rounding in less than that */

void ix__box_measure(const ix__task *t, ix__box *b)
{
    for (int i = 0; i < t->nall; i++)
        b->mag[i] = ix__tensor_size(&t->shape,
                                    b->c + (size_t)i * t->shape.size);
}

bool ix__box_signs_allow(const ix__task *t, ix__box *b)
{
    for (int i = 0; i < t->nall; i++) {
        const double *c = b->c + (size_t)i * t->shape.size;
        double lo, hi;

        ix__tensor_measure(&t->shape, c, &lo, &hi, &b->mag[i]);
        if (hi < -b->err[i] || (i < t->neq && lo > b->err[i]))
            return false;
    }
    return true;
}

/* A de Casteljau pass of dims - 1 layers commits at most 3 roundings in each,
 * relative to the sums of the sizes of what it combines; moving the constants
 * of a sum one for each line. */
void ix__box_cut(const ix__task *t, ix__box *b, int j, double a, double e)
{
    double w = b->hi[j] - b->lo[j], lo = b->lo[j];
    int passes = (a > 0) + (e < 1);

    for (int i = 0; i < t->nall; i++) {
        double *c = b->c + (size_t)i * t->shape.size;

        b->mag[i] = ix__tensor_restrict_size(&t->shape, c, j, a, e);
        b->err[i] += (3 * passes * (t->shape.dims[j] - 1) +
                      (t->shape.sum ? t->shape.n : 0)) *
                     UNIT * b->mag[i];
        ix__tensor_restrict(&t->shape, c, j, a, e);
        ix__tensor_center(&t->shape, c);
    }
    b->hi[j] = e < 1 ? lo + e * w : b->hi[j];
    b->lo[j] = a > 0 ? lo + a * w : lo;
    b->cuts++;
}

double ix__box_drift(const ix__task *t, const ix__box *b, int j)
{
    double x = ix__larger(fabs(b->lo[j]), fabs(b->hi[j]));

    return UNIT * ((b->cuts + 4) * x + 12 * t->edge[j]);
}

/* Whether a refresh is worth while: errors above HALF of the digits, several
 * cuts in each direction since the last, ends known to a part of the edges. */
static bool stale(const ix__task *t, const ix__box *b)
{
    bool noisy = false;

    if (b->cuts - b->fresh < 2 * t->shape.n)
        return false;
    for (int i = 0; i < t->nall; i++)
        noisy |= b->err[i] > HALF * b->mag[i];
    for (int j = 0; noisy && j < t->shape.n; j++)
        noisy = ix__box_drift(t, b, j) < 1e-4 * (b->hi[j] - b->lo[j]);
    return noisy;
}

void ix__box_refresh(const ix__task *t, const ix__box *patch, ix__box *b)
{
    ix__box old = *b;

    if (!stale(t, b))
        return;
    *b = *patch;
    b->c = old.c;
    memcpy(b->c, patch->c, (size_t)t->nall * t->shape.size * sizeof *b->c);
    for (int j = 0; j < t->shape.n; j++) {
        double w = patch->hi[j] - patch->lo[j];
        double drift = 2 * ix__box_drift(t, &old, j);
        double a = (old.lo[j] - drift - patch->lo[j]) / w;
        double e = (old.hi[j] + drift - patch->lo[j]) / w;

        ix__box_cut(t, b, j, ix__larger(a, 0), ix__smaller(e, 1));
    }
    b->fresh = b->cuts;
}

double ix__box_part(const ix__task *t, const ix__box *b, int j)
{
    return (b->hi[j] - b->lo[j]) / t->edge[j];
}

int ix__box_longest(const ix__task *t, const ix__box *b, double *len)
{
    int best = 0;

    *len = 0;
    for (int j = 0; j < t->shape.n; j++) {
        double w = ix__box_part(t, b, j);

        if (w > *len) {
            *len = w;
            best = j;
        }
    }
    return best;
}

ix_status ix__open_box(ix__task *t, const ix__box *b, ix__found *f)
{
    ix_solution r = {.certified = false};

    for (int j = 0; j < t->shape.n; j++) {
        double drift = ix__box_drift(t, b, j);

        r.lo[j] = b->lo[j] - drift;
        r.hi[j] = b->hi[j] + drift;
        r.x[j] = 0.5 * (b->lo[j] + b->hi[j]);
    }
    if (++t->open % (t->crowd ? t->crowd : CROWD) == 0) {
        t->cell *= 2;
        t->crowded |= t->cell >= CROWDED;
    }
    return ix__found_add(f, &r);
}

/* --- the stack ------------------------------------------------------------ */

static size_t numbers(const ix__task *t)
{
    return (size_t)t->nall * t->shape.size;
}

ix_status ix__stack_make(const ix__task *t, ix__stack *k)
{
    IX_SCRATCH(t->ctx, k->box, IX__MAX_DEPTH);
    IX_SCRATCH(t->ctx, k->box[0].c, numbers(t));
    k->made = 1;
    k->top = -1;
    return IX_OK;
}

static void copy_box(const ix__task *t, const ix__box *from, ix__box *to)
{
    double *c = to->c;

    *to = *from;
    to->c = c;
    memcpy(c, from->c, numbers(t) * sizeof *c);
}

void ix__stack_start(const ix__task *t, ix__stack *k, const ix__box *b)
{
    k->top = 0;
    copy_box(t, b, &k->box[0]);
    ix__box_measure(t, &k->box[0]);
}

ix_status ix__stack_halve(const ix__task *t, ix__stack *k, int j, double ratio)
{
    ix__box *b = &k->box[k->top], *c = b + 1;

    if (k->top + 1 == k->made) {
        IX_SCRATCH(t->ctx, c->c, numbers(t));
        k->made++;
    }
    copy_box(t, b, c);
    ix__box_cut(t, b, j, ratio, 1);
    ix__box_cut(t, c, j, 0, ratio);
    k->top++;
    return IX_OK;
}

static ix_status report_rest(ix__task *t, ix__stack *k, ix__found *found)
{
    for (; k->top >= 0; k->top--)
        IX_TRY(ix__open_box(t, &k->box[k->top], found));
    return IX_OK;
}

ix_status ix__stack_run(ix__task *t, ix__stack *k,
                        ix_status (*examine)(void *self), void *self,
                        ix__found *found)
{
    while (k->top >= 0) {
        ix_status st;

        if (t->boxes >= t->max_boxes || t->interrupted)
            return report_rest(t, k, found);
        st = examine(self);
        if (st == IX_OK)
            st = ix__poll(t->ctx);
        if (st == IX_ECANCEL && t->keep)
            t->interrupted = true;
        else if (st != IX_OK)
            return st;
    }
    return IX_OK;
}
