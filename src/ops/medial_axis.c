/* medial_axis.c - the medial axis of a region of the plane.
 *
 * Each place of the border has one largest circle inside the region that
 * touches there: the walk of plane_walk.h with one set for both. It runs around
 * the axis as around a tree, along every branch twice, once for each foot; the
 * runs are its branches, the places where they meet its nodes. */
#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "iritx/distance.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"

/* Samples of each side of a span, before any refinement. */
enum { GRID = 6 };
/* Ends of branches that are nearer are one node: well above the place of an end
 * (1e-10 at a vertex of curvature), below any real branch. */
#define SAME_NODE 1e-6
/* A branch from a node to itself that is shorter is none: one around a hole
 * keeps half way to what is around that. */
#define LOOP 1e-4

void ix_medial_axis_free(ix_ctx *ctx, ix_medial_axis *m)
{
    ix__free(ctx, m->branch, m->bytes);
    *m = (ix_medial_axis){0};
}

/* --- which runs ------------------------------------------------------------
 */

/* A number for each place of the border, the same seen as own or other foot:
 * span + parameter, vertices behind all spans. */
static double own_place(const ix__set *s, const ix__sample *a)
{
    const ix__border *e = &s->border[a->border];

    if (e->kind == IX__FAN)
        return s->nspans + e->index;
    return e->index + (e->side > 0 ? a->at : 1.0 - a->at);
}

static double other_place(const ix__set *s, const ix__sample *a)
{
    return a->vertex >= 0 ? s->nspans + a->vertex : a->foot.span + a->foot.u;
}

/* Is no centre of r farther than d from the first one? */
static bool within(const ix__walked *w, const ix__run *r, double d)
{
    const ix__sample *a = ix__run_at(w, r, 0);

    for (int i = 1; i < r->count; i++) {
        const ix__sample *b = ix__run_at(w, r, i);

        if (!(hypot(a->b[0] - b->b[0], a->b[1] - b->b[1]) <= d))
            return false;
    }
    return true;
}

/* Does the way from a to z go forward in the plane? The directions that decide
 * are along no line that a drawing is likely to have. */
static bool forward(const ix__sample *a, const ix__sample *z)
{
    const double c = 0.8146123, s = 0.5800067;
    double x = z->b[0] - a->b[0], y = z->b[1] - a->b[1], d = c * x + s * y;

    return (fabs(d) > 1e-3 * hypot(x, y) ? d : c * y - s * x) > 0.0;
}

/* Each branch is run along from both feet, in opposite senses: the run that
 * goes forward counts; of closed ones, around a hole, that with the smaller
 * place in the middle. */
static bool counts(const ix__set *s, const ix__walked *w, const ix__run *r)
{
    const ix__sample *a = ix__run_at(w, r, 0);
    const ix__sample *z = ix__run_at(w, r, r->count - 1);
    const ix__sample *m = ix__run_at(w, r, r->count / 2);

    if (m->own_circle)
        return false;
    if (hypot(a->b[0] - z->b[0], a->b[1] - z->b[1]) > SAME_NODE)
        return forward(a, z);
    return own_place(s, m) < other_place(s, m);
}

/* --- inside ----------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    int n;
    const ix_mv *const *crv;
    ix_frame frame;
    ix__set set;
    double tol;
} region;

static ix_status inside(const region *g, const double x[2], bool *out)
{
    double p[3] = {ldexp(x[0], g->frame.exp) + g->frame.shift[0],
                   ldexp(x[1], g->frame.exp) + g->frame.shift[1], 0.0};
    int where, turns = 0;

    for (int i = 0; i < g->n; i++) {
        IX_TRY(ix_crv_encloses(g->ctx, g->crv[i], p, 0.0, &where));
        turns += where > 0;
    }
    *out = turns % 2 == 1;
    return IX_OK;
}

/* Is the side of the border that loop walks along in the region? By the first
 * centre that it finds; without one (all circles are lines) it is not. */
static ix_status loop_inside(const region *g, const ix__walk *w, int loop,
                             bool *out)
{
    const ix__loop *l = &g->set.loop[loop];
    ix__sample s;

    *out = false;
    for (int i = l->first; i < l->first + l->count; i++)
        for (int j = 1; j < 8; j++) {
            ix__walk_sample(w, i, j / 8.0, &s);
            if (s.far)
                return IX_OK;
            if (s.valid && s.r > 1e-9)
                return inside(g, s.b, out);
        }
    return IX_OK;
}

/* Loops outside are taken out of the set. */
static ix_status keep_inside(region *g, const ix__walk *w)
{
    int n = 0;

    for (int i = 0; i < g->set.nloops; i++) {
        bool in;

        IX_TRY(loop_inside(g, w, i, &in));
        if (in)
            g->set.loop[n++] = g->set.loop[i];
    }
    g->set.nloops = n;
    return IX_OK;
}

/* --- the graph -------------------------------------------------------------
 */

typedef struct {
    region *g;
    const ix__walked *w;
    ix_medial_axis *out;
    double *data;
    ix__sample *end; /* [2 nruns], of the runs that count */
    int *root;       /* [2 nruns]: of the set of ends that are one node; its
                        own index: the first of them; -1: no end */
    int *node;       /* [2 nruns], of a root; -1: none yet */
} maker;

/* The first and last run of the loop of run i. */
static void loop_runs(const ix__walked *w, int i, int out[2])
{
    out[0] = out[1] = i;
    while (out[0] > 0 && w->run[out[0] - 1].loop == w->run[i].loop)
        out[0]--;
    while (out[1] + 1 < w->nruns && w->run[out[1] + 1].loop == w->run[i].loop)
        out[1]++;
}

/* Puts the smallest circle between a and b into *out, if it is smaller: golden
 * section, as the radius has one minimum in so short an interval. */
static void smallest(const ix__walk *walk, const ix__sample *a,
                     const ix__sample *b, ix__sample *out)
{
    const double g = 0.6180339887498949;
    double lo = a->at, hi = b->at;
    ix__sample s[2];

    if (a->border != b->border)
        return;
    for (int i = 0; i < 40 && hi - lo > 1e-12; i++) {
        ix__walk_sample(walk, a->border, hi - g * (hi - lo), &s[0]);
        ix__walk_sample(walk, a->border, lo + g * (hi - lo), &s[1]);
        if (s[0].r < s[1].r)
            hi = s[1].at;
        else
            lo = s[0].at;
        for (int e = 0; e < 2; e++)
            if (s[e].valid && s[e].r < out->r)
                *out = s[e];
    }
    if (a->r < out->r)
        *out = *a;
    if (b->r < out->r)
        *out = *b;
}

/* Where the run next to run i, in direction step, is one of circles of
 * curvature: the smallest of them, the end of the branch. */
static bool tip(const maker *k, const ix__walk *walk, int i, int step,
                ix__sample *out)
{
    int ends[2], j = i + step, best = 0;
    const ix__run *r;

    loop_runs(k->w, i, ends);
    j = j < ends[0] ? ends[1] : j > ends[1] ? ends[0] : j;
    r = &k->w->run[j];
    if (!ix__run_at(k->w, r, r->count / 2)->own_circle)
        return false;
    for (int m = 1; m < r->count; m++)
        if (ix__run_at(k->w, r, m)->r < ix__run_at(k->w, r, best)->r)
            best = m;
    *out = *ix__run_at(k->w, r, best);
    for (int m = best - 1; m <= best; m++)
        if (m >= 0 && m + 1 < r->count)
            smallest(walk, ix__run_at(k->w, r, m), ix__run_at(k->w, r, m + 1),
                     out);
    return true;
}

static void add_vertex(maker *k, const ix__sample *a, ix_medial_branch *b,
                       double *x, double *foot)
{
    const ix__set *s = &k->g->set;

    for (int c = 0; c < 2; c++)
        x[3 * b->n + c] = ldexp(a->b[c], k->g->frame.exp) +
                          k->g->frame.shift[c];
    x[3 * b->n + 2] = ldexp(a->r, k->g->frame.exp);
    foot[2 * b->n] = ix__own_parameter(s, a);
    foot[2 * b->n + 1] = ix__other_parameter(s, a);
    b->n++;
}

static int root_of(const maker *k, int i)
{
    while (k->root[i] != i)
        i = k->root[i];
    return i;
}

static void unite(maker *k, int i, int j)
{
    int a = root_of(k, i), b = root_of(k, j);

    if (a < b)
        k->root[b] = a;
    else
        k->root[a] = b;
}

/* Both ends of the runs that count. A tip takes the place of the last circle
 * that touches twice. */
static void find_ends(maker *k)
{
    ix__walk walk = {&k->g->set, &k->g->set, k->g->tol, GRID, false, 0.0};

    for (int i = 0; i < k->w->nruns; i++) {
        const ix__run *r = &k->w->run[i];
        bool in = counts(&k->g->set, k->w, r);

        for (int e = 0; e < 2; e++) {
            int j = 2 * i + e;

            k->node[j] = -1;
            k->root[j] = in ? j : -1;
            if (in && !tip(k, &walk, i, e ? 1 : -1, &k->end[j]))
                k->end[j] = *ix__run_at(k->w, r, e ? r->count - 1 : 0);
        }
    }
}

/* Ends that are near each other are one node; so are both ends of a run that is
 * no longer than that: as a circle that touches both at a corner and beside it,
 * within rounding, while its foot goes from the one to the other. */
static void join_ends(maker *k)
{
    for (int j = 0; j < 2 * k->w->nruns; j++) {
        const ix__sample *b = &k->end[j];

        for (int i = 0; i < j && k->root[j] >= 0; i++)
            if (k->root[i] >= 0 && hypot(k->end[i].b[0] - b->b[0],
                                         k->end[i].b[1] - b->b[1]) <= SAME_NODE)
                unite(k, i, j);
    }
    for (int i = 0; i < k->w->nruns; i++)
        if (k->root[2 * i] >= 0 && within(k->w, &k->w->run[i], SAME_NODE))
            unite(k, 2 * i, 2 * i + 1);
}

static int add_node(maker *k, const ix__sample *s, int degree)
{
    ix_medial_axis *m = k->out;
    ix_medial_node *n = &m->node[m->nnodes];

    for (int i = 0; i < 2; i++)
        n->x[i] = ldexp(s->b[i], k->g->frame.exp) + k->g->frame.shift[i];
    n->r = ldexp(s->r, k->g->frame.exp);
    n->degree = degree;
    return m->nnodes++;
}

/* The node at end j. */
static int node_of(maker *k, int j)
{
    int i = root_of(k, j);

    if (k->node[i] < 0)
        k->node[i] = add_node(k, &k->end[i], 0);
    k->out->node[k->node[i]].degree++;
    return k->node[i];
}

/* Is the end of a run another circle than its last one: a tip? */
static bool apart(const ix__sample *end, const ix__sample *last)
{
    return end->border != last->border || end->at != last->at;
}

static void add_branch(maker *k, int index)
{
    const ix__run *r = &k->w->run[index];
    const ix__set *s = &k->g->set;
    ix_medial_branch *b = &k->out->branch[k->out->nbranches++];
    const ix__sample *a = ix__run_at(k->w, r, 0);
    const ix__sample *end = &k->end[2 * index];
    const ix__border *e = &s->border[a->border];
    double *x = k->data, *foot = x + 3 * (r->count + 2);

    *b = (ix_medial_branch){.x = x, .foot = foot};
    b->point[0] = e->kind == IX__FAN;
    b->point[1] = a->vertex >= 0;
    b->curve[0] = e->kind == IX__FAN ? s->vertex[e->index].curve
                                     : s->span[e->index].curve;
    b->curve[1] = s->span[a->foot.span].curve;
    for (int i = 0; i < 2; i++)
        b->node[i] = node_of(k, 2 * index + i);
    if (apart(&end[0], a))
        add_vertex(k, &end[0], b, x, foot);
    for (int i = 0; i < r->count; i++)
        add_vertex(k, ix__run_at(k->w, r, i), b, x, foot);
    if (apart(&end[1], ix__run_at(k->w, r, r->count - 1)))
        add_vertex(k, &end[1], b, x, foot);
    k->data = foot + 2 * (r->count + 2);
}

/* A part of the region whose circles are all one, as far as nodes go, is a
 * disc: its centre. */
static void add_centre(maker *k, int loop)
{
    const ix__sample *first = NULL;

    for (int j = 0; j < k->w->loop[loop].n; j++) {
        const ix__sample *s = ix__sample_at(&k->w->loop[loop], j);

        if (!s->valid)
            continue;
        if (!first)
            first = s;
        if (!(hypot(s->b[0] - first->b[0], s->b[1] - first->b[1]) <= SAME_NODE))
            return;
    }
    if (first)
        (void)add_node(k, first, 0);
}

static void add_all(maker *k)
{
    for (int i = 0; i < k->w->nruns; i++) {
        bool loop = k->root[2 * i] >= 0 &&
                    root_of(k, 2 * i) == root_of(k, 2 * i + 1);

        if (k->root[2 * i] >= 0 && !(loop && within(k->w, &k->w->run[i], LOOP)))
            add_branch(k, i);
    }
    for (int i = 0; i < k->w->nloops; i++)
        add_centre(k, i);
}

static ix_status make(region *g, const ix__walked *w, ix_medial_axis *out)
{
    maker k = {.g = g, .w = w, .out = out};
    size_t n = (size_t)w->nruns + (size_t)w->nloops, total = 0;

    IX_SCRATCH(g->ctx, k.end, 2 * n);
    IX_SCRATCH(g->ctx, k.root, 2 * n);
    IX_SCRATCH(g->ctx, k.node, 2 * n);
    for (int i = 0; i < w->nruns; i++)
        total += (size_t)w->run[i].count + 2;
    *out = (ix_medial_axis){
        .size = ldexp(ix__sets_size(&g->set, &g->set), g->frame.exp)};
    out->bytes = n * (sizeof *out->branch + 2 * sizeof *out->node) +
                 5 * total * sizeof(double);
    out->branch = ix__alloc(g->ctx, out->bytes);
    if (!out->branch)
        return IX_ENOMEM;
    out->node = (ix_medial_node *)(void *)(out->branch + n);
    k.data = (double *)(void *)(out->node + 2 * n);
    find_ends(&k);
    join_ends(&k);
    add_all(&k);
    return IX_OK;
}

/* --- entry -----------------------------------------------------------------
 */

static ix_status check_closed(const region *g)
{
    for (int i = 0; i < g->set.nstrands; i++)
        if (!g->set.strand[i].closed)
            return IX_FAIL(g->ctx, IX_EARG,
                           "curve %d is not closed: the border of a region is",
                           g->set.span[g->set.strand[i].first].curve + 1);
    return IX_OK;
}

static ix_status run(region *g, ix_medial_axis *out)
{
    ix__walk w = {&g->set, &g->set, g->tol, GRID, false, 0.0};
    ix__walked done;

    IX_TRY(ix__plane_frame(g->ctx, g->n, g->crv, 0, NULL, &g->frame));
    IX_TRY(ix__set_of_curves(g->ctx, g->n, g->crv, &g->frame, (ix__set_opts){0},
                             &g->set));
    IX_TRY(check_closed(g));
    w.size = ix__sets_size(&g->set, &g->set);
    IX_TRY(keep_inside(g, &w));
    if (g->set.nloops == 0)
        return IX_FAIL(g->ctx, IX_EDOMAIN, "the curves enclose nothing");
    IX_TRY(ix__walk_all(g->ctx, &w, 0, NULL, &done));
    return make(g, &done, out);
}

static ix_status scoped(ix_ctx *ctx, int n, const ix_mv *const *crv, double tol,
                        ix_medial_axis *out)
{
    region g = {.ctx = ctx, .n = n};
    ix_mv **flat;
    ix_status st;

    IX_TRY(ix__bisector_tol(ctx, tol, &g.tol));
    IX_TRY(ix__plane_curves(ctx, n, crv, &flat));
    g.crv = (const ix_mv *const *)flat;
    st = run(&g, out);
    ix__mv_unref_all(ctx, flat, n);
    return st;
}

ix_status ix_medial_axis_of(ix_ctx *ctx, int n, const ix_mv *const *crv,
                            double tol, ix_medial_axis *out)
{
    *out = (ix_medial_axis){0};
    if (n < 1)
        return IX_FAIL(ctx, IX_EARG, "no curves");
    IX_RETURN_SCOPED(ctx, scoped(ctx, n, crv, tol, out));
}
