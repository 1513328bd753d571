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

/* Shorter than what is one node: as a circle that touches both at a corner and
 * beside it, within rounding, while its foot goes from the one to the other. */
static bool is_node(const ix__walked *w, const ix__run *r)
{
    const ix__sample *a = ix__run_at(w, r, 0);

    for (int i = 1; i < r->count; i++) {
        const ix__sample *b = ix__run_at(w, r, i);

        if (!(hypot(a->b[0] - b->b[0], a->b[1] - b->b[1]) <= SAME_NODE))
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
} maker;

static int node_at(maker *k, const ix__sample *s)
{
    ix_medial_axis *m = k->out;
    double x[2], tol = SAME_NODE * m->size;

    for (int i = 0; i < 2; i++)
        x[i] = ldexp(s->b[i], k->g->frame.exp) + k->g->frame.shift[i];
    for (int i = 0; i < m->nnodes; i++)
        if (hypot(m->node[i].x[0] - x[0], m->node[i].x[1] - x[1]) <= tol) {
            m->node[i].degree++;
            return i;
        }
    m->node[m->nnodes] = (ix_medial_node){
        {x[0], x[1]}, ldexp(s->r, k->g->frame.exp), 1};
    return m->nnodes++;
}

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

static void add_branch(maker *k, int index)
{
    const ix__run *r = &k->w->run[index];
    ix__walk walk = {&k->g->set, &k->g->set, k->g->tol, GRID, false, 0.0};
    const ix__set *s = &k->g->set;
    ix_medial_branch *b = &k->out->branch[k->out->nbranches++];
    const ix__sample *a = ix__run_at(k->w, r, 0);
    const ix__border *e = &s->border[a->border];
    double *x = k->data, *foot = x + 3 * (r->count + 2);
    ix__sample end;

    *b = (ix_medial_branch){.x = x, .foot = foot};
    b->point[0] = e->kind == IX__FAN;
    b->point[1] = a->vertex >= 0;
    b->curve[0] = e->kind == IX__FAN ? s->vertex[e->index].curve
                                     : s->span[e->index].curve;
    b->curve[1] = s->span[a->foot.span].curve;
    if (tip(k, &walk, index, -1, &end))
        add_vertex(k, &end, b, x, foot);
    else
        end = *a;
    b->node[0] = node_at(k, &end);
    for (int i = 0; i < r->count; i++)
        add_vertex(k, ix__run_at(k->w, r, i), b, x, foot);
    if (tip(k, &walk, index, 1, &end))
        add_vertex(k, &end, b, x, foot);
    else
        end = *ix__run_at(k->w, r, r->count - 1);
    b->node[1] = node_at(k, &end);
    k->data = foot + 2 * (r->count + 2);
}

/* A region whose circles are all one: its centre. */
static void only_node(maker *k)
{
    for (int i = 0; i < k->w->nloops; i++)
        for (int j = 0; j < k->w->loop[i].n; j++) {
            const ix__sample *a = ix__sample_at(&k->w->loop[i], j);

            if (!a->valid)
                continue;
            (void)node_at(k, a);
            k->out->node[0].degree = 0;
            return;
        }
}

static ix_status make(region *g, const ix__walked *w, ix_medial_axis *out)
{
    maker k = {.g = g, .w = w, .out = out};
    size_t n = (size_t)w->nruns + 1, total = 0;

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
    for (int i = 0; i < w->nruns; i++)
        if (counts(&g->set, w, &w->run[i]) && !is_node(w, &w->run[i]))
            add_branch(&k, i);
    if (out->nbranches == 0)
        only_node(&k);
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
