/* set_cover.c - exact set cover on the line.
 *
 * The end points cut the line into cells; a set is a bit mask of the cells it
 * covers. Cells not longer than the tolerance do not count. Invariant of the
 * search: best holds a complete cover, used one that may become smaller. */
#include "geom/set_cover.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A node of the search: sets from next on are still to be tried for cell. */
typedef struct {
    int cell, next;
} level;

typedef struct {
    ix_ctx *ctx;
    int ncells, nsets;
    size_t nwords;
    uint64_t *mask; /* [nsets][nwords] */
    uint64_t *left; /* [nbest + 1][nwords]: open cells at each depth */
    int *used, *best, nbest;
} cover;

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static const uint64_t *mask_of(const cover *c, int s)
{
    return c->mask + (size_t)s * c->nwords;
}

static bool covers(const cover *c, int s, int cell)
{
    return mask_of(c, s)[cell / 64] >> (cell % 64) & 1;
}

/* Cells of the open ones that m covers. */
static int count(const cover *c, const uint64_t *m, const uint64_t *open)
{
    int n = 0;

    for (size_t i = 0; i < c->nwords; i++)
        for (uint64_t w = m[i] & open[i]; w; w &= w - 1)
            n++;
    return n;
}

/* Sorted end points to cells longer than tol; returns their number. */
static int make_cells(const double *ends, int n, double tol, double *lo,
                      double *hi)
{
    int k = 0;
    double start = n ? ends[0] : 0;

    for (int i = 1; i < n; i++)
        if (ends[i] - start > tol) {
            lo[k] = start;
            hi[k++] = ends[i];
            start = ends[i];
        }
    return k;
}

/* A range covers a cell if at most tol of it sticks out on either side. */
static void make_masks(cover *c, int n, const ix__range *r, double tol,
                       const double *lo, const double *hi)
{
    for (int i = 0; i < n; i++) {
        uint64_t *m = c->mask + (size_t)r[i].set * c->nwords;

        for (int k = 0; k < c->ncells; k++)
            if (r[i].lo <= lo[k] + tol && r[i].hi >= hi[k] - tol)
                m[k / 64] |= (uint64_t)1 << (k % 64);
    }
}

/* All cells that some set covers. */
static void all_cells(const cover *c, uint64_t *open)
{
    memset(open, 0, c->nwords * sizeof *open);
    for (int s = 0; s < c->nsets; s++)
        for (size_t i = 0; i < c->nwords; i++)
            open[i] |= mask_of(c, s)[i];
}

static int first_open(const cover *c, const uint64_t *open)
{
    for (int k = 0; k < c->ncells; k++)
        if (open[k / 64] >> (k % 64) & 1)
            return k;
    return -1;
}

/* The set that covers most open cells, among those with the given cell
 * (-1: among all). */
static int largest(const cover *c, const uint64_t *open, int cell)
{
    int top = 0, most = 0;

    for (int s = 0; s < c->nsets; s++) {
        int n = cell < 0 || covers(c, s, cell) ? count(c, mask_of(c, s), open)
                                               : 0;

        if (n > most) {
            most = n;
            top = s;
        }
    }
    return top;
}

/* A first cover. If every set is one range, taking the leftmost open cell and
 * the range that reaches farthest from it is exact. */
static ix_status greedy(cover *c, bool single)
{
    int cell;

    all_cells(c, c->left);
    c->nbest = 0;
    while ((cell = first_open(c, c->left)) >= 0) {
        int s = largest(c, c->left, single ? cell : -1);

        IX_TRY(ix__poll(c->ctx));
        c->best[c->nbest++] = s;
        for (size_t i = 0; i < c->nwords; i++)
            c->left[i] &= ~mask_of(c, s)[i];
    }
    return IX_OK;
}

/* The open cell that fewest sets cover: the best to branch on. */
static int rarest(const cover *c, const uint64_t *open)
{
    int cell = -1, least = c->nsets + 1;

    for (int k = 0; k < c->ncells; k++) {
        int n = 0;

        for (int s = 0; s < c->nsets && open[k / 64] >> (k % 64) & 1; s++)
            n += covers(c, s, k);
        if (n > 0 && n < least) {
            least = n;
            cell = k;
        }
    }
    return cell;
}

/* At least this many more sets are needed; 0 if nothing is open. */
static int lower_bound(const cover *c, const uint64_t *open)
{
    int n = count(c, open, open);
    int most = count(c, mask_of(c, largest(c, open, -1)), open);

    return n ? (n + most - 1) / most : 0;
}

static int next_set(const cover *c, level *l)
{
    while (l->next < c->nsets)
        if (covers(c, l->next++, l->cell))
            return l->next - 1;
    return -1;
}

/* Depth first over the sets that cover the rarest open cell; a branch ends
 * where the bound says that it cannot beat best. */
static ix_status branch_and_bound(cover *c)
{
    int d = 0;
    level *stack;

    IX_SCRATCH(c->ctx, stack, c->nbest + 1);
    IX_SCRATCH(c->ctx, c->left, (size_t)(c->nbest + 1) * c->nwords);
    all_cells(c, c->left);
    stack[0] = (level){rarest(c, c->left), 0};
    while (d >= 0) {
        uint64_t *open = c->left + (size_t)d * c->nwords, *now;
        int s = next_set(c, &stack[d]), need;

        if (s < 0) {
            d--;
            continue;
        }
        IX_TRY(ix__poll(c->ctx));
        now = open + c->nwords;
        for (size_t i = 0; i < c->nwords; i++)
            now[i] = open[i] & ~mask_of(c, s)[i];
        c->used[d] = s;
        need = lower_bound(c, now);
        if (d + 1 + need >= c->nbest)
            continue;
        if (need == 0) {
            c->nbest = d + 1;
            memcpy(c->best, c->used, (size_t)c->nbest * sizeof *c->best);
        } else {
            stack[++d] = (level){rarest(c, now), 0};
        }
    }
    return IX_OK;
}

static ix_status prepare(cover *c, int n, const ix__range *r, double tol)
{
    double *ends, *lo, *hi;

    IX_SCRATCH(c->ctx, ends, 2 * (size_t)n);
    IX_SCRATCH(c->ctx, lo, 2 * (size_t)n);
    IX_SCRATCH(c->ctx, hi, 2 * (size_t)n);
    for (int i = 0; i < n; i++) {
        if (!isfinite(r[i].lo) || !isfinite(r[i].hi))
            return IX_FAIL(c->ctx, IX_EARG, "range [%g, %g] is not finite",
                           r[i].lo, r[i].hi);
        ends[2 * i] = r[i].lo;
        ends[2 * i + 1] = r[i].hi;
    }
    qsort(ends, 2 * (size_t)n, sizeof *ends, by_value);
    c->ncells = make_cells(ends, 2 * n, tol, lo, hi);
    c->nwords = (size_t)c->ncells / 64 + 1;
    IX_SCRATCH_ZERO(c->ctx, c->mask, (size_t)c->nsets * c->nwords);
    IX_SCRATCH_ZERO(c->ctx, c->left, c->nwords);
    IX_SCRATCH(c->ctx, c->used, c->nsets);
    IX_SCRATCH(c->ctx, c->best, c->nsets);
    make_masks(c, n, r, tol, lo, hi);
    return IX_OK;
}

static ix_status solve(ix_ctx *ctx, int n, const ix__range *r, int nsets,
                       double tol, char *pick)
{
    cover c = {.ctx = ctx, .nsets = nsets};
    bool single = true;
    char *seen;

    IX_SCRATCH_ZERO(ctx, seen, nsets);
    IX_TRY(prepare(&c, n, r, tol));
    for (int i = 0; i < n; i++)
        single = single && !seen[r[i].set]++;
    IX_TRY(greedy(&c, single));
    if (!single && c.nbest > 1)
        IX_TRY(branch_and_bound(&c));
    memset(pick, 0, (size_t)nsets);
    for (int i = 0; i < c.nbest; i++)
        pick[c.best[i]] = 1;
    return IX_OK;
}

ix_status ix__set_cover(ix_ctx *ctx, int nranges, const ix__range *ranges,
                        int nsets, double tol, char *pick)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = solve(ctx, nranges, ranges, nsets, tol, pick);

    ix__scratch_release(ctx, mk);
    return st;
}
