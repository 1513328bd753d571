/* trim_mesh.c - triangles of the part of a surface that loops enclose.
 *
 * Loops are cut at the lines of the surface's grid. A cell that none of them
 * touches is two triangles as without trimming; the others are triangulated
 * with the pieces of the loops as edges. Going up each column of cells from
 * outside of the domain, every edge of a loop that is crossed changes between
 * outside and inside: no geometric test decides that, so that nearly touching
 * loops cannot turn a region inside out. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/buf.h"
#include "mv/cdt.h"
#include "mv/tess_impl.h"

#define SIDE ((int64_t)IX__CDT_SIDE)

/* A point of a loop, or of one of its edges on a line of the grid. */
typedef struct {
    int64_t x, y;
    const double *uv, *xyz; /* NULL: by x, y; on the surface */
    size_t seq;
    uint32_t vertex;
} node;

/* An edge, or (a == b) a point on its border, for the cell key = column *
 * rows + row. */
typedef struct {
    size_t key, a, b; /* places in nodes */
} item;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *srf;
    const ix__tess_grid *g;
    int64_t ncols, nrows;
    ix_buf path;  /* node[]: loops one after the other */
    ix_buf extra; /* int64_t[][2]: where loops cross each other */
    ix_buf tri;   /* uint32_t[][3] */
    size_t nnodes;
    uint32_t nverts; /* vertices: of the grid, of nodes, extra */
    node *nodes;
    size_t nitems;
    item *items;
} part;

/* --- loops, cut at the grid ---------------------------------------------- */

static int64_t clamp(int64_t x, int64_t n)
{
    return x < 0 ? 0 : x > n * SIDE ? n * SIDE : x;
}

static void add_node(part *p, node n)
{
    n.x = clamp(n.x, p->ncols);
    n.y = clamp(n.y, p->nrows);
    n.seq = p->path.len / sizeof n;
    ix__buf_add(&p->path, (const char *)&n, sizeof n);
}

/* The lines that an edge crosses in one direction: the next one, and where on
 * the edge, 2 behind the last. */
typedef struct {
    int64_t from, to, n, line;
    double at;
} crossing;

static void find_at(crossing *c)
{
    int64_t x = c->line * SIDE;
    bool there = c->from < c->to ? x < c->to : x > c->to;

    if (c->from == c->to || !there || c->line < 0 || c->line > c->n)
        c->at = 2;
    else
        c->at = (double)(x - c->from) / (double)(c->to - c->from);
}

static crossing first_crossing(int64_t from, int64_t to, int64_t n)
{
    crossing c = {.from = from, .to = to, .n = n};

    if (from < to)
        c.line = from < 0 ? 0 : (from >> IX__CDT_BITS) + 1;
    else
        c.line = from > n * SIDE ? n : ((from + SIDE - 1) >> IX__CDT_BITS) - 1;
    find_at(&c);
    return c;
}

static void next_crossing(crossing *c)
{
    c->line += c->from < c->to ? 1 : -1;
    find_at(c);
}

/* The other coordinate there; a line that it reaches so is passed, too. */
static int64_t meet(double at, crossing *c)
{
    double d = at * (double)(c->to - c->from);
    int64_t x = ix__tess_snap(c->from + (int64_t)llrint(d));

    if (c->at < 2 && x == c->line * SIDE)
        next_crossing(c);
    return x;
}

static void add_edge(part *p, const node *a, const node *b)
{
    crossing x = first_crossing(a->x, b->x, p->ncols);
    crossing y = first_crossing(a->y, b->y, p->nrows);

    while (x.at < 2 || y.at < 2) {
        node n = {0};

        if (x.at <= y.at) {
            n.x = x.line * SIDE;
            n.y = meet(x.at, &y);
            next_crossing(&x);
        } else {
            n.y = y.line * SIDE;
            n.x = meet(y.at, &x);
            next_crossing(&y);
        }
        add_node(p, n);
    }
    add_node(p, *b);
}

static node node_of(const part *p, const ix__trim_loop *l, size_t i)
{
    const double *uv = l->uv + 2 * i;

    return (node){.x = ix__tess_place(&p->g->d[0], uv[0]),
                  .y = ix__tess_place(&p->g->d[1], uv[1]),
                  .uv = uv,
                  .xyz = l->xyz ? l->xyz + 3 * i : NULL};
}

/* first[k] is where loop k begins in the path; its first node comes again at
 * its end. */
static ix_status cut_loops(part *p, int nloops, const ix__trim_loop *loop,
                           size_t *first)
{
    for (int k = 0; k < nloops; k++) {
        node a, b;

        first[k] = p->path.len / sizeof a;
        if (loop[k].n == 0)
            continue;
        a = node_of(p, &loop[k], 0);
        add_node(p, a);
        for (size_t i = 1; i <= loop[k].n; i++, a = b) {
            b = node_of(p, &loop[k], i % loop[k].n);
            add_edge(p, &a, &b);
        }
        IX_TRY(ix__poll(p->ctx));
    }
    first[nloops] = p->path.len / sizeof(node);
    if (first[nloops] > IX__TESS_MOST)
        return IX_FAIL(p->ctx, IX_EUNABLE,
                       "the trimming curves would need %zu points; the most is "
                       "%zu",
                       first[nloops], IX__TESS_MOST);
    return ix__buf_check(&p->path);
}

/* --- vertices ------------------------------------------------------------ */

static int by_place(const void *a, const void *b)
{
    const node *p = a, *q = b;
    int given = (p->xyz == NULL) - (q->xyz == NULL);

    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    if (given != 0)
        return given;
    if ((p->uv == NULL) != (q->uv == NULL))
        return p->uv ? -1 : 1;
    return p->seq < q->seq ? -1 : p->seq > q->seq;
}

static bool is_corner(const node *n)
{
    return n->x % SIDE == 0 && n->y % SIDE == 0;
}

static uint32_t corner_vertex(const part *p, int64_t col, int64_t row)
{
    return (uint32_t)(row * p->g->d[0].nsamples + col);
}

/* Nodes at the same place become one: of[seq] is its place in nodes. */
static ix_status unite(part *p, size_t **of)
{
    size_t n = p->path.len / sizeof(node), k = 0;
    node *all;

    IX_SCRATCH(p->ctx, all, n);
    IX_SCRATCH(p->ctx, *of, n);
    if (n > 0)
        memcpy(all, p->path.data, n * sizeof *all);
    qsort(all, n, sizeof *all, by_place);
    for (size_t i = 0; i < n; i++) {
        if (k == 0 || all[i].x != all[k - 1].x || all[i].y != all[k - 1].y)
            all[k++] = all[i];
        (*of)[all[i].seq] = k - 1;
    }
    p->nodes = all;
    p->nnodes = k;
    for (size_t i = 0; i < k; i++)
        all[i].vertex = is_corner(&all[i])
                            ? corner_vertex(p, all[i].x / SIDE, all[i].y / SIDE)
                            : p->nverts++;
    return IX_OK;
}

/* --- what lies in which cell --------------------------------------------- */

/* Adds an item to the cells around the middle (x, y) of it, in halves. */
static void add_items(part *p, size_t a, size_t b)
{
    int64_t x = p->nodes[a].x + p->nodes[b].x;
    int64_t y = p->nodes[a].y + p->nodes[b].y;
    bool onx = p->nodes[a].x == p->nodes[b].x && p->nodes[a].x % SIDE == 0;
    bool ony = p->nodes[a].y == p->nodes[b].y && p->nodes[a].y % SIDE == 0;
    int64_t col = x / (2 * SIDE), row = y / (2 * SIDE);

    for (int64_t c = col - onx; c <= col; c++)
        for (int64_t r = row - ony; r <= row; r++)
            if (c >= 0 && r >= 0 && c < p->ncols && r < p->nrows)
                p->items[p->nitems++] = (item){(size_t)(c * p->nrows + r), a,
                                               b};
}

static int by_cell(const void *a, const void *b)
{
    const item *p = a, *q = b;

    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    return p->b < q->b ? -1 : p->b > q->b;
}

static ix_status list_items(part *p, int nloops, const size_t *first,
                            const size_t *of)
{
    IX_SCRATCH(p->ctx, p->items, 2 * (p->nnodes + first[nloops]));
    for (size_t i = 0; i < p->nnodes; i++)
        if (!is_corner(&p->nodes[i]) &&
            (p->nodes[i].x % SIDE == 0 || p->nodes[i].y % SIDE == 0))
            add_items(p, i, i);
    for (int k = 0; k < nloops; k++)
        for (size_t i = first[k]; i + 1 < first[k + 1]; i++)
            if (of[i] != of[i + 1])
                add_items(p, of[i], of[i + 1]);
    qsort(p->items, p->nitems, sizeof *p->items, by_cell);
    return IX_OK;
}

/* --- one cell ------------------------------------------------------------ */

/* A cell, its items, and whether what lies below its lower left end is in. */
typedef struct {
    int64_t col, row;
    bool keep, in;
    size_t n;
    const item *items;
} cell;

static void add_triangle(part *p, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t t[3] = {a, b, c};

    ix__buf_add(&p->tri, (const char *)t, sizeof t);
}

static void corners_of(const part *p, const cell *c, uint32_t v[4])
{
    v[0] = corner_vertex(p, c->col, c->row);
    v[1] = v[0] + 1;
    v[3] = corner_vertex(p, c->col, c->row + 1);
    v[2] = v[3] + 1;
}

/* Without edges inside. */
static void whole_cell(part *p, cell *c)
{
    uint32_t v[4], t[2][3];
    size_t n;

    corners_of(p, c, v);
    for (size_t i = 0; i < c->n; i++)
        if (p->nodes[c->items[i].a].y == c->row * SIDE &&
            p->nodes[c->items[i].b].y == c->row * SIDE)
            c->in = !c->in;
    if (!c->in || !c->keep)
        return;
    n = ix__tess_cut_cell(p->g->xyz, v, t);
    ix__buf_add(&p->tri, (const char *)t, n * sizeof *t);
}

static bool is_whole(const part *p, const cell *c)
{
    for (size_t i = 0; i < c->n; i++) {
        const node *a = &p->nodes[c->items[i].a], *b = &p->nodes[c->items[i].b];

        if (!is_corner(a) || !is_corner(b) || (a->x != b->x && a->y != b->y))
            return false;
    }
    return true;
}

static ix_status insert_node(const part *p, const cell *c, ix__cdt *d,
                             size_t at, int *id)
{
    const node *n = &p->nodes[at];
    const ix__cdt_point q = {(int32_t)(n->x - c->col * SIDE),
                             (int32_t)(n->y - c->row * SIDE)};

    return ix__cdt_point_at(d, q, id);
}

/* All points, then all edges. Vertices of the points so far: vertex[]. */
static ix_status insert_items(part *p, const cell *c, ix__cdt *d, int *nknown,
                              uint32_t *vertex)
{
    int a, b;

    corners_of(p, c, vertex);
    for (size_t i = 0; i < c->n; i++) {
        IX_TRY(insert_node(p, c, d, c->items[i].a, &a));
        vertex[a] = p->nodes[c->items[i].a].vertex;
        IX_TRY(insert_node(p, c, d, c->items[i].b, &b));
        vertex[b] = p->nodes[c->items[i].b].vertex;
    }
    *nknown = d->npts;
    for (size_t i = 0; i < c->n; i++) {
        IX_TRY(insert_node(p, c, d, c->items[i].a, &a));
        IX_TRY(insert_node(p, c, d, c->items[i].b, &b));
        IX_TRY(ix__cdt_toggle(d, a, b));
    }
    return IX_OK;
}

/* The last triangle around a point, counter-clockwise. */
static int last_at(const ix__cdt *d, int v)
{
    int side, t = ix__cdt_border(d, v, &side);

    for (;;) {
        int k = d->t[t].v[0] == v ? 0 : d->t[t].v[1] == v ? 1 : 2;
        int next = d->t[t].n[(k + 1) % 3];

        if (next < 0)
            return t;
        t = next;
    }
}

/* in[t]: 1 inside, 0 outside; from the lower left end of the border on. */
static ix_status find_inside(part *p, cell *c, const ix__cdt *d,
                             unsigned char *in)
{
    int *queue, n = 0, side, t = ix__cdt_border(d, 0, &side);

    IX_SCRATCH(p->ctx, queue, d->ntris);
    memset(in, 2, (size_t)d->ntris);
    in[t] = c->in ^ d->t[t].odd[side];
    queue[n++] = t;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            const ix__cdt_tri *r = &d->t[queue[i]];

            if (r->n[k] < 0 || in[r->n[k]] != 2)
                continue;
            in[r->n[k]] = in[queue[i]] ^ r->odd[k];
            queue[n++] = r->n[k];
        }
    c->in = in[last_at(d, 3)] == 1;
    return IX_OK;
}

static uint32_t new_vertex(part *p, const cell *c, ix__cdt_point q)
{
    const int64_t x[2] = {c->col * SIDE + q.x, c->row * SIDE + q.y};

    ix__buf_add(&p->extra, (const char *)x, sizeof x);
    return p->nverts++;
}

static ix_status cut_cell(part *p, cell *c)
{
    unsigned char *in;
    uint32_t *vertex, *all;
    int nknown;
    ix__cdt d;

    IX_TRY(ix__cdt_init(p->ctx, 4 + 2 * (int)c->n, &d));
    IX_SCRATCH(p->ctx, vertex, 4 + 2 * c->n);
    IX_TRY(insert_items(p, c, &d, &nknown, vertex));
    IX_SCRATCH(p->ctx, in, d.ntris);
    IX_TRY(find_inside(p, c, &d, in));
    if (!c->keep)
        return IX_OK;
    IX_SCRATCH(p->ctx, all, d.npts);
    memcpy(all, vertex, (size_t)nknown * sizeof *all);
    for (int i = nknown; i < d.npts; i++)
        all[i] = new_vertex(p, c, d.p[i]);
    for (int i = 0; i < d.ntris; i++)
        if (in[i])
            add_triangle(p, all[d.t[i].v[0]], all[d.t[i].v[1]],
                         all[d.t[i].v[2]]);
    return IX_OK;
}

static ix_status all_cells(part *p)
{
    size_t at = 0;

    for (int64_t col = 0; col < p->ncols; col++) {
        bool in = false;

        IX_TRY(ix__poll(p->ctx));
        for (int64_t row = 0; row < p->nrows; row++) {
            size_t key = (size_t)(col * p->nrows + row);
            cell c = {col, row, p->g->cell[row * p->ncols + col] == 1,
                      in,  0,   p->items + at};
            ix_mark mk = ix__scratch_mark(p->ctx);
            ix_status st = IX_OK;

            for (; at < p->nitems && p->items[at].key == key; at++)
                c.n++;
            if (is_whole(p, &c))
                whole_cell(p, &c);
            else
                st = cut_cell(p, &c);
            ix__scratch_release(p->ctx, mk);
            IX_TRY(st);
            in = c.in;
        }
    }
    IX_TRY(ix__buf_check(&p->extra));
    return ix__buf_check(&p->tri);
}

/* --- points -------------------------------------------------------------- */

/* Parameters of a node: on a line of the grid, the line's. */
static void param_of(const part *p, const node *n, double *uv)
{
    const int64_t x[2] = {n->x, n->y};
    const int64_t most[2] = {p->ncols * SIDE, p->nrows * SIDE};

    for (int d = 0; d < 2; d++) {
        bool given = n->uv && x[d] % SIDE != 0 && x[d] < most[d];

        uv[d] = given ? n->uv[d] : ix__tess_param(&p->g->d[d], x[d]);
    }
}

/* uv double[n][2] on the surface: xyz double[n][3]. */
static ix_status points_at(part *p, size_t n, const double *uv, double *xyz)
{
    double *t, *out;

    IX_SCRATCH(p->ctx, t, 2 * n);
    IX_SCRATCH(p->ctx, out, n * (size_t)p->srf->ncoords);
    for (size_t i = 0; i < n; i++) {
        t[i] = uv[2 * i];
        t[n + i] = uv[2 * i + 1];
    }
    IX_TRY(ix_mv_point_many(p->ctx, p->srf, n, t, out));
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < 3; c++)
            xyz[3 * i + c] = (int)c < p->srf->ncoords ? out[c * n + i] : 0;
    return IX_OK;
}

static ix_status all_points(part *p, double **xyz, double **uv)
{
    size_t ng = p->g->nverts;
    size_t nextra = p->extra.len / (2 * sizeof(int64_t));

    IX_SCRATCH(p->ctx, *xyz, 3 * p->nverts);
    IX_SCRATCH(p->ctx, *uv, 2 * p->nverts);
    memcpy(*xyz, p->g->xyz, 3 * ng * sizeof **xyz);
    ix__tess_put_uv(p->g, *uv);
    for (size_t i = 0; i < p->nnodes; i++)
        param_of(p, &p->nodes[i], *uv + 2 * p->nodes[i].vertex);
    for (size_t i = 0; i < nextra; i++) {
        node n = {0};

        memcpy(&n.x, p->extra.data + 2 * i * sizeof n.x, sizeof n.x);
        memcpy(&n.y, p->extra.data + (2 * i + 1) * sizeof n.y, sizeof n.y);
        param_of(p, &n, *uv + 2 * (p->nverts - nextra + i));
    }
    IX_TRY(points_at(p, p->nverts - ng, *uv + 2 * ng, *xyz + 3 * ng));
    for (size_t i = 0; i < p->nnodes; i++)
        if (p->nodes[i].xyz)
            memcpy(*xyz + 3 * p->nodes[i].vertex, p->nodes[i].xyz,
                   3 * sizeof **xyz);
    return IX_OK;
}

/* --- all of it ----------------------------------------------------------- */

static ix_status finish(part *p, ix__mesh *out)
{
    size_t ntris = p->tri.len / (3 * sizeof(uint32_t)), n = 0;
    double *xyz, *uv;
    uint32_t(*tri)[3];

    IX_TRY(all_points(p, &xyz, &uv));
    tri = ix__scratch(p->ctx, ntris + 1, sizeof *tri);
    if (!tri)
        return IX_ENOMEM;
    for (size_t i = 0; i < ntris; i++) {
        memcpy(tri[n], p->tri.data + i * sizeof *tri, sizeof *tri);
        n += !ix__tess_degenerate(xyz, tri[n]);
    }
    IX_TRY(ix__mesh_pack(p->ctx, p->nverts, xyz, uv, n,
                         (const uint32_t(*)[3])tri, out));
    out->nleft = p->g->nleft;
    ix__tess_note(p->ctx, out->nleft);
    return IX_OK;
}

static ix_status make_part(part *p, int nloops, const ix__trim_loop *loop,
                           ix__mesh *out)
{
    size_t *first, *of;

    for (int d = 0; d < 2; d++)
        for (int i = 0; i + 1 < p->g->d[d].nsamples; i++)
            if (!p->g->d[d].joined[i])
                return IX_FAIL(p->ctx, IX_EUNABLE,
                               "the trimmed surface jumps at %c = %g",
                               d ? 'v' : 'u', p->g->d[d].t[i]);
    IX_SCRATCH(p->ctx, first, nloops + 1);
    IX_TRY(cut_loops(p, nloops, loop, first));
    IX_TRY(unite(p, &of));
    IX_TRY(list_items(p, nloops, first, of));
    IX_TRY(all_cells(p));
    return finish(p, out);
}

static ix_status mesh_of_part(ix_ctx *ctx, const ix_mv *srf,
                              const ix__tess_grid *g, int nloops,
                              const ix__trim_loop *loop, ix__mesh *out)
{
    part p = {.ctx = ctx,
              .g = g,
              .ncols = g->d[0].nsamples - 1,
              .nrows = g->d[1].nsamples - 1,
              .nverts = (uint32_t)g->nverts};
    ix_mv *plain;
    ix_status st;

    IX_TRY(ix__mv_no_power(ctx, srf, &plain));
    p.srf = plain;
    ix__buf_init(&p.path, ctx);
    ix__buf_init(&p.extra, ctx);
    ix__buf_init(&p.tri, ctx);
    st = make_part(&p, nloops, loop, out);
    ix__buf_free(&p.path);
    ix__buf_free(&p.extra);
    ix__buf_free(&p.tri);
    ix_mv_unref(ctx, plain);
    return st;
}

ix_status ix__mesh_of_part(ix_ctx *ctx, const ix_mv *srf,
                           const ix__tess_grid *g, int nloops,
                           const ix__trim_loop *loop, ix__mesh *out)
{
    *out = (ix__mesh){0};
    if (nloops == 0)
        return ix__mesh_of_grid(ctx, g, out);
    IX_RETURN_SCOPED(ctx, mesh_of_part(ctx, srf, g, nloops, loop, out));
}
