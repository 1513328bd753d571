/* system_found.c - the list of solutions, and making one of what several
 * boxes reported. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "solve/box.h"

ix_status ix__found_add(ix__found *f, const ix_solution *s)
{
    IX_GROW(f->ctx, f->sol, f->n, f->cap);
    f->sol[f->n++] = *s;
    return IX_OK;
}

static bool meet(const ix_solution *a, const ix_solution *b, int n,
                 const double *edge, double gap)
{
    for (int j = 0; j < n; j++)
        if (!(a->lo[j] <= b->hi[j] + gap * edge[j] &&
              b->lo[j] <= a->hi[j] + gap * edge[j]))
            return false;
    return true;
}

static void join_boxes(ix_solution *a, const ix_solution *b, int n)
{
    for (int j = 0; j < n; j++) {
        a->lo[j] = fmin(a->lo[j], b->lo[j]);
        a->hi[j] = fmax(a->hi[j], b->hi[j]);
        a->x[j] = 0.5 * (a->lo[j] + a->hi[j]);
    }
}

static int root_of(int *up, int i)
{
    while (up[i] != i)
        i = up[i] = up[up[i]];
    return i;
}

static bool before(const ix_solution *a, const ix_solution *b, int n)
{
    for (int j = 0; j < n; j++)
        if (a->x[j] < b->x[j] || a->x[j] > b->x[j])
            return a->x[j] < b->x[j];
    return a->certified && !b->certified;
}

/* Shell sort by Ciura's gaps: deterministic, in place, n^1.3. */
static void sort(ix_solution *s, int count, int n)
{
    static const int gaps[] = {301705, 132, 57, 23, 10, 4, 1};
    int gap = count;

    for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++) {
        gap = gaps[g];
        for (int i = gap; i < count; i++) {
            ix_solution t = s[i];
            int k = i;

            for (; k >= gap && before(&t, &s[k - gap], n); k -= gap)
                s[k] = s[k - gap];
            s[k] = t;
        }
    }
}

/* The largest edge of a box, as a part of the domain's. */
static double size_of(const ix_solution *s, int n, const double *edge)
{
    double size = 0;

    for (int j = 0; j < n; j++)
        size = fmax(size, (s->hi[j] - s->lo[j]) / edge[j]);
    return size;
}

#define WIDE                                                                 \
    0x1p-4 /* of the domain: a box of that size is no multiple root but part \
              of a set of solutions, which is not scattered */

/* How far a box of that size reaches: twice its size, as what one multiple root
 * leaves behind is scattered by rounding. */
static double reach_of(double size)
{
    return size < WIDE ? 2 * size : 0;
}

/* One round of joining undecided boxes that reach each other. Sorted by x[0],
 * so only a window of width reach is compared. */
static int join_round(ix__found *f, int n, const double *edge, int *up)
{
    double reach = 0;
    int out = 0;

    for (int i = 0; i < f->n; i++) {
        up[i] = i;
        if (!f->sol[i].certified)
            reach = fmax(reach, 3 * size_of(&f->sol[i], n, edge));
    }
    for (int i = 0; i < f->n; i++) {
        double own = size_of(&f->sol[i], n, edge);

        for (int k = i - 1; k >= 0 && !f->sol[i].certified; k--) {
            double gap = fmax(reach_of(own),
                              reach_of(size_of(&f->sol[k], n, edge)));

            if (f->sol[i].x[0] - f->sol[k].x[0] > 2 * reach * edge[0])
                break;
            if (!f->sol[k].certified &&
                meet(&f->sol[i], &f->sol[k], n, edge, fmax(gap, 1e-9)))
                up[root_of(up, i)] = root_of(up, k);
        }
    }
    for (int i = 0; i < f->n; i++) {
        int r = root_of(up, i);

        if (r != i)
            join_boxes(&f->sol[r], &f->sol[i], n);
    }
    for (int i = 0; i < f->n; i++)
        if (root_of(up, i) == i)
            f->sol[out++] = f->sol[i];
    return out;
}

/* Until nothing changes: joined boxes are larger and reach further. */
static ix_status merge_open(ix__found *f, int n, const double *edge)
{
    int *up;

    IX_SCRATCH(f->ctx, up, f->n);
    for (;;) {
        int left = join_round(f, n, edge, up);

        if (left == f->n)
            return IX_OK;
        f->n = left;
        sort(f->sol, f->n, n);
    }
}

/* Two certified boxes that meet hold the same solution: each excludes a
 * second one from a box many times its own size. */
static void drop_doubles(ix__found *f, int n, const double *edge)
{
    int out = 0;

    for (int i = 0; i < f->n; i++) {
        bool same = false;

        for (int k = out - 1; k >= 0 && !same && f->sol[i].certified; k--) {
            if (f->sol[i].lo[0] > f->sol[k].hi[0] + 1e-9 * edge[0])
                break;
            same = f->sol[k].certified &&
                   meet(&f->sol[i], &f->sol[k], n, edge, 0);
        }
        if (!same)
            f->sol[out++] = f->sol[i];
    }
    f->n = out;
}

ix_status ix__found_merge(ix__found *f, int n, const double *edge)
{
    sort(f->sol, f->n, n);
    drop_doubles(f, n, edge);
    IX_TRY(merge_open(f, n, edge));
    sort(f->sol, f->n, n);
    return IX_OK;
}
