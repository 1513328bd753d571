/* chain_segments.c - see the header. Ends are sorted on a grid far finer than
 * what is meant to differ. */
#include "geom/chain_segments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/lines.h"

typedef struct {
    double cell[3]; /* the place on the grid */
    int h;          /* end 2 s, 2 s + 1 of segment s */
} place;

typedef struct {
    int n;
    const double (*seg)[2][3];
    int *node;    /* [2 n]: number of the place; -1: no segment */
    int *degree;  /* [nodes] */
    int (*at)[2]; /* [nodes]: the first two ends there */
    bool *done;   /* [n] */
} chains;

static int by_cell(const void *a, const void *b)
{
    const place *p = a, *q = b;

    for (int k = 0; k < 3; k++)
        if (p->cell[k] < q->cell[k] || p->cell[k] > q->cell[k])
            return p->cell[k] < q->cell[k] ? -1 : 1;
    return p->h - q->h;
}

static double extent(int n, const double (*seg)[2][3])
{
    double size = 0;

    for (int k = 0; k < 3; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;

        for (int i = 0; i < 2 * n; i++) {
            lo = fmin(lo, seg[i / 2][i % 2][k]);
            hi = fmax(hi, seg[i / 2][i % 2][k]);
        }
        size = fmax(size, hi - lo);
    }
    return size;
}

/* Numbers the places. */
static ix_status number(ix_ctx *ctx, chains *c)
{
    double step = 1e-9 * extent(c->n, c->seg);
    int nodes = 0;
    place *p;

    IX_SCRATCH(ctx, p, 2 * c->n);
    IX_SCRATCH(ctx, c->node, 2 * c->n);
    for (int h = 0; h < 2 * c->n; h++) {
        for (int k = 0; k < 3; k++)
            p[h].cell[k] = step > 0
                               ? floor(c->seg[h / 2][h % 2][k] / step + 0.5)
                               : 0;
        p[h].h = h;
    }
    qsort(p, 2 * (size_t)c->n, sizeof *p, by_cell);
    for (int i = 0; i < 2 * c->n; i++) {
        if (i > 0 && memcmp(p[i].cell, p[i - 1].cell, sizeof p[i].cell) != 0)
            nodes++;
        c->node[p[i].h] = nodes;
    }
    IX_SCRATCH_ZERO(ctx, c->degree, nodes + 1);
    IX_SCRATCH(ctx, c->at, nodes + 1);
    IX_SCRATCH_ZERO(ctx, c->done, c->n);
    return IX_OK;
}

static void link_ends(chains *c)
{
    for (int s = 0; s < c->n; s++) {
        c->done[s] = c->node[2 * s] == c->node[2 * s + 1];
        for (int e = 0; e < 2 && !c->done[s]; e++) {
            int v = c->node[2 * s + e];

            if (c->degree[v] < 2)
                c->at[v][c->degree[v]] = 2 * s + e;
            c->degree[v]++;
        }
    }
}

/* From end h on to the other end of its segment and further, until a place
 * where not two meet, or the start. */
static void walk(chains *c, int h, ix_lines *out, int *at)
{
    int k = out->n++, start = c->node[h], v;

    memcpy(out->pt[(*at)++], c->seg[h / 2][h % 2], sizeof out->pt[0]);
    out->count[k] = 1;
    for (;;) {
        c->done[h / 2] = true;
        h ^= 1;
        v = c->node[h];
        memcpy(out->pt[(*at)++], c->seg[h / 2][h % 2], sizeof out->pt[0]);
        out->count[k]++;
        if (v == start || c->degree[v] != 2)
            return;
        h = c->at[v][c->at[v][0] == h];
        if (c->done[h / 2])
            return;
    }
}

static ix_status chain(ix_ctx *ctx, chains *c, ix_lines *out)
{
    int at = 0;

    IX_TRY(number(ctx, c));
    link_ends(c);
    IX_TRY(ix__lines_new(ctx, 2 * (size_t)c->n, out));
    for (int round = 0; round < 2; round++) /* open lines first, then rings */
        for (int h = 0; h < 2 * c->n; h++)
            if (!c->done[h / 2] && (round || c->degree[c->node[h]] != 2))
                walk(c, h, out, &at);
    return IX_OK;
}

ix_status ix__chain_segments(ix_ctx *ctx, int n, const double (*seg)[2][3],
                             ix_lines *out)
{
    chains c = {.n = n, .seg = seg};

    *out = (ix_lines){0};
    if (n == 0)
        return IX_OK;
    IX_RETURN_SCOPED(ctx, chain(ctx, &c, out));
}
