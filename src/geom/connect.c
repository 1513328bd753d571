/* connect.c - see the header. Candidates are the few nearest neighbours of each
 * point that can still be joined; rounds of these go on until none is left. */
#include "geom/connect.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NEAR = 4 }; /* neighbours of a point that a round looks at */

typedef struct {
    double d;
    int a, b; /* a < b */
} gap;

typedef struct {
    double x; /* the coordinate that points are sorted by */
    int i;
} place;

typedef struct {
    int n, dim;
    const double *p;
    double tol;
    place *sorted;
    int (*next)[2]; /* neighbours of a point, -1: none */
    int *root;      /* a forest: chains */
    gap *gaps;      /* [NEAR n] */
} cloud;

static int by_place(const void *a, const void *b)
{
    const place *p = a, *q = b;

    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : p->i - q->i;
}

static int by_gap(const void *a, const void *b)
{
    const gap *p = a, *q = b;

    return p->d != q->d   ? (p->d > q->d) - (p->d < q->d)
           : p->a != q->a ? p->a - q->a
                          : p->b - q->b;
}

static double distance(const cloud *c, int i, int j)
{
    double sum = 0;

    for (int k = 0; k < c->dim; k++) {
        double d = c->p[i * c->dim + k] - c->p[j * c->dim + k];

        sum += d * d;
    }
    return sqrt(sum);
}

/* The coordinate with the widest range. */
static int widest(const cloud *c)
{
    double most = -1;
    int best = 0;

    for (int k = 0; k < c->dim; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;

        for (int i = 0; i < c->n; i++) {
            lo = fmin(lo, c->p[i * c->dim + k]);
            hi = fmax(hi, c->p[i * c->dim + k]);
        }
        if (hi - lo > most) {
            most = hi - lo;
            best = k;
        }
    }
    return best;
}

static int root_of(cloud *c, int i)
{
    while (c->root[i] != i)
        i = c->root[i] = c->root[c->root[i]];
    return i;
}

static bool is_end(const cloud *c, int i)
{
    return c->next[i][1] < 0;
}

/* Adds the gap from point a to point b to the nearest ones of a, near[*m]. */
static void offer(int a, int b, double d, gap *near, int *m)
{
    int k = *m;

    if (k == NEAR && d >= near[k - 1].d)
        return;
    if (k == NEAR)
        k--;
    else
        (*m)++;
    for (; k > 0 && near[k - 1].d > d; k--)
        near[k] = near[k - 1];
    near[k] = (gap){d, a < b ? a : b, a < b ? b : a};
}

/* The nearest points that the one at sorted place s can be joined to. */
static int neighbours(cloud *c, int s, gap *near)
{
    int a = c->sorted[s].i, m = 0;

    for (int way = -1; way <= 1; way += 2)
        for (int q = s + way; q >= 0 && q < c->n; q += way) {
            double reach = m == NEAR ? near[NEAR - 1].d : c->tol;
            int b = c->sorted[q].i;

            if (!(fabs(c->sorted[q].x - c->sorted[s].x) <= reach))
                break;
            if (!is_end(c, b) || root_of(c, a) == root_of(c, b))
                continue;
            if (distance(c, a, b) <= c->tol)
                offer(a, b, distance(c, a, b), near, &m);
        }
    return m;
}

static void join(cloud *c, int a, int b)
{
    c->next[a][c->next[a][0] >= 0] = b;
    c->next[b][c->next[b][0] >= 0] = a;
    c->root[root_of(c, b)] = root_of(c, a);
}

/* One round; how many gaps were closed. */
static ix_status join_nearest(ix_ctx *ctx, cloud *c, int *joined)
{
    size_t m = 0;

    for (int s = 0; s < c->n; s++) {
        if (s % 256 == 0)
            IX_TRY(ix__poll(ctx));
        if (is_end(c, c->sorted[s].i))
            m += (size_t)neighbours(c, s, c->gaps + m);
    }
    if (m > 0)
        qsort(c->gaps, m, sizeof *c->gaps, by_gap);
    *joined = 0;
    for (size_t k = 0; k < m; k++) {
        const gap *g = &c->gaps[k];

        if (is_end(c, g->a) && is_end(c, g->b) &&
            root_of(c, g->a) != root_of(c, g->b)) {
            join(c, g->a, g->b);
            ++*joined;
        }
    }
    return IX_OK;
}

/* The chain from its end i, at point[]; true if it is to be closed. */
static bool walk(const cloud *c, int i, int *point, int *count)
{
    double longest = 0, d;
    int before = -1, m = 0;

    while (i >= 0) {
        int go = c->next[i][0] == before && before >= 0 ? c->next[i][1]
                                                        : c->next[i][0];

        if (m > 0)
            longest = fmax(longest, distance(c, i, before));
        point[m++] = i;
        before = i;
        i = go;
    }
    *count = m;
    d = distance(c, point[0], point[m - 1]);
    return m > 2 && d <= c->tol && d <= 1.5 * longest;
}

static ix_status write_chains(ix_ctx *ctx, cloud *c, ix__chains *out)
{
    int at = 0;
    bool *done;

    out->n = 0;
    IX_SCRATCH(ctx, out->count, c->n);
    IX_SCRATCH(ctx, out->point, c->n);
    IX_SCRATCH(ctx, out->closed, c->n);
    IX_SCRATCH_ZERO(ctx, done, c->n);
    for (int i = 0; i < c->n; i++)
        if (!done[i] && is_end(c, i)) {
            int k = out->n++;

            out->closed[k] = walk(c, i, out->point + at, &out->count[k]);
            at += out->count[k];
            done[out->point[at - 1]] = true;
        }
    return IX_OK;
}

ix_status ix__connect(ix_ctx *ctx, int n, int dim, const double *p, double tol,
                      ix__chains *out)
{
    cloud c = {.n = n, .dim = dim, .p = p, .tol = tol};
    int axis = widest(&c), joined = 1;

    IX_SCRATCH(ctx, c.sorted, n);
    IX_SCRATCH(ctx, c.next, n);
    IX_SCRATCH(ctx, c.root, n);
    IX_SCRATCH(ctx, c.gaps, (size_t)NEAR * (size_t)n);
    for (int i = 0; i < n; i++) {
        c.sorted[i] = (place){p[i * dim + axis], i};
        c.next[i][0] = c.next[i][1] = -1;
        c.root[i] = i;
    }
    if (n > 0)
        qsort(c.sorted, (size_t)n, sizeof *c.sorted, by_place);
    while (joined > 0)
        IX_TRY(join_nearest(ctx, &c, &joined));
    return write_chains(ctx, &c, out);
}
