/* arrange_faces.c - the faces of an arrangement.
 *
 * Edges that meet in their ends only leave a vertex in a cyclic order. Walking
 * along a half edge and on, at its end, with the next one clockwise from where
 * one came, closes a loop around the face on the left. Each component has one
 * loop that runs around it, the only one of negative area; all others bound a
 * face of their own from outside. Where a component lies in a face of another
 * one, its outer loop is a hole of that face. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/arrange_edges.h"
#include "geom/quad.h"
#include "iritx/distance.h"
#include "iritx/sym.h"

typedef struct {
    ix_ctx *ctx;
    const ix_arrangement *a;
    int nv;
    int *vertex; /* [2 edges] */
    double (*p)[2];
    bool *out;      /* [edges]: ignored */
    double *reach;  /* [edges][2]: farthest distance from either end's vertex */
    double *angle;  /* [half edges]: of leaving */
    int *next;      /* [half edges] */
    int *component; /* [vertices] */
    ix_arr_loop *loop;
    int *half, nloops, nhalf;
    ix_arr_face *face;
    int nfaces, ncomponents;
} faces;

static int start_of(const faces *w, int h)
{
    return w->vertex[h];
}

/* --- edges that take part
 * ------------------------------------------------------- */

/* Farthest distances of an edge's points from the vertices at its ends, as
 * seen at 16 places of each span: attained, if not the largest. */
static ix_status reach_of(faces *w, int e)
{
    ix_path p;

    IX_TRY(ix__path_new(w->ctx, w->a->edge[e].crv, &p));
    for (int i = 0; i <= 16 * p.nspans; i++) {
        int s = i / 16 < p.nspans ? i / 16 : p.nspans - 1;
        double u = (i - 16 * s) / 16.0, x[IX_MAX_COORDS];

        ix__path_point(&p, (1 - u) * p.breaks[s] + u * p.breaks[s + 1], x);
        for (int k = 0; k < 2; k++) {
            const double *v = w->p[w->vertex[2 * e + k]];
            double *r = &w->reach[2 * e + k];

            *r = fmax(*r, hypot(x[0] - v[0], x[1] - v[1]));
        }
    }
    /* all of it at one vertex */
    w->out[e] = w->vertex[2 * e] == w->vertex[2 * e + 1] &&
                w->reach[2 * e] <= 2 * w->a->tol;
    return IX_OK;
}

static void ignore_hanging(faces *w, int *degree)
{
    bool more = true;

    while (more) {
        more = false;
        for (int e = 0; e < w->a->nedges; e++) {
            int v[2] = {w->vertex[2 * e], w->vertex[2 * e + 1]};

            if (w->out[e] || (degree[v[0]] > 1 && degree[v[1]] > 1))
                continue;
            w->out[e] = more = true;
            degree[v[0]]--;
            degree[v[1]]--;
        }
    }
}

static ix_status choose(faces *w, bool ignore)
{
    int n = w->a->nedges, *degree;

    IX_SCRATCH(w->ctx, w->out, n);
    IX_SCRATCH_ZERO(w->ctx, w->reach, 2 * n);
    IX_SCRATCH_ZERO(w->ctx, degree, w->nv);
    for (int e = 0; e < n; e++)
        IX_TRY(reach_of(w, e));
    for (int h = 0; h < 2 * n; h++)
        degree[w->vertex[h]] += !w->out[h / 2];
    if (ignore)
        ignore_hanging(w, degree);
    return IX_OK;
}

/* --- the order around a vertex
 * -------------------------------------------------- */

/* |C - v|^2 as a scalar of t. */
static ix_status distance_field(ix_ctx *ctx, const ix_mv *crv,
                                const double v[2], ix_mv **out)
{
    const double m[16] = {1, 0, 0, 0, 0,     1,     0, 0,
                          0, 0, 1, 0, -v[0], -v[1], 0, 1};
    ix_mv *moved;
    ix_status st;

    IX_TRY(ix_mv_transform(ctx, crv, m, &moved));
    st = ix_sym_dot(ctx, moved, moved, NULL, out);
    ix_mv_unref(ctx, moved);
    return st;
}

/* Where half edge h first leaves the circle of radius r around its vertex. */
static ix_status leaving(faces *w, int h, double r, double *t)
{
    const ix_mv *crv = w->a->edge[h / 2].crv;
    const ix_root_opts o = {.lo = 1, .hi = 0, .level = r * r};
    bool back = h & 1, found = false;
    ix_root *root;
    ix_status st;
    ix_mv *f;
    int n;

    IX_TRY(distance_field(w->ctx, crv, w->p[start_of(w, h)], &f));
    st = ix_roots(w->ctx, f, ix_mv_rational(f), &o, &root, &n);
    ix_mv_unref(w->ctx, f);
    IX_TRY(st);
    for (int i = 0; !found && i < n; i++) {
        const ix_root *z = &root[back ? n - 1 - i : i];

        found = back ? z->after < 0 && z->before > 0
                     : z->before < 0 && z->after > 0;
        *t = z->t;
    }
    ix_roots_free(w->ctx, root, n);
    return found ? IX_OK
                 : IX_FAIL(w->ctx, IX_EUNABLE,
                           "curve %d begins or ends farther from the others "
                           "than it reaches: the tolerance %g is too large",
                           h / 2 + 1, w->a->tol);
}

static ix_status angles_at(faces *w, const int *h, int n)
{
    const double *v = w->p[start_of(w, h[0])];
    double r = HUGE_VAL;

    for (int i = 0; i < n; i++)
        r = fmin(r, w->reach[h[i]]);
    for (int i = 0; i < n; i++) {
        double t, x[2];

        IX_TRY(leaving(w, h[i], r / 2, &t));
        IX_TRY(ix_mv_point(w->ctx, w->a->edge[h[i] / 2].crv, &t, x));
        w->angle[h[i]] = atan2(x[1] - v[1], x[0] - v[0]);
    }
    return IX_OK;
}

/* Rising angle; n is small. */
static void sort_by_angle(const faces *w, int *h, int n)
{
    for (int i = 1; i < n; i++)
        for (int k = i; k > 0 && w->angle[h[k]] < w->angle[h[k - 1]]; k--) {
            int swap = h[k];

            h[k] = h[k - 1];
            h[k - 1] = swap;
        }
}

/* Half edges h[n] leave one vertex: who arrives against h[i] goes on with the
 * one before it. Angles are known to the accuracy of the roots; 1e-9 is far
 * above it. */
static ix_status order(faces *w, int *h, int n)
{
    if (n > 1)
        IX_TRY(angles_at(w, h, n));
    sort_by_angle(w, h, n);
    for (int i = 0; i < n; i++) {
        int before = h[(i + n - 1) % n];

        if (i > 0 && !(w->angle[h[i]] - w->angle[before] > 1e-9))
            return IX_FAIL(w->ctx, IX_EUNABLE,
                           "curves %d and %d run together: copies are to be "
                           "dropped, or they still cross",
                           before / 2 + 1, h[i] / 2 + 1);
        w->next[h[i] ^ 1] = before;
    }
    return IX_OK;
}

static ix_status orders(faces *w)
{
    int n = 2 * w->a->nedges, *first, *at;

    IX_SCRATCH(w->ctx, w->angle, n);
    IX_SCRATCH(w->ctx, w->next, n);
    IX_SCRATCH_ZERO(w->ctx, first, w->nv + 2);
    IX_SCRATCH(w->ctx, at, n);
    for (int h = 0; h < n; h++)
        first[w->vertex[h] + 2] += !w->out[h / 2];
    for (int v = 0; v < w->nv; v++)
        first[v + 2] += first[v + 1];
    for (int h = 0; h < n; h++)
        if (!w->out[h / 2])
            at[first[w->vertex[h] + 1]++] = h;
    for (int v = 0; v < w->nv; v++) {
        IX_TRY(ix__poll(w->ctx));
        if (first[v + 1] > first[v])
            IX_TRY(order(w, at + first[v], first[v + 1] - first[v]));
    }
    return IX_OK;
}

/* --- loops -----------------------------------------------------------------
 */

typedef struct {
    const ix_path *p;
    int span;
    double at[2];
} sweep;

/* Speed times distance, for the scale, and the area that the ray sweeps, by the
 * span's own parameter in [0, 1]. */
static void swept(void *arg, double u, double *f)
{
    const sweep *s = arg;
    double a = s->p->breaks[s->span], h = s->p->breaks[s->span + 1] - a;
    double d[2][3];

    ix__path_derivs3(s->p, s->span, a + h * u, 1, d);
    d[0][0] -= s->at[0];
    d[0][1] -= s->at[1];
    f[0] = h * hypot(d[0][0], d[0][1]) * hypot(d[1][0], d[1][1]);
    f[1] = h / 2 * (d[0][0] * d[1][1] - d[0][1] * d[1][0]);
}

static double triangle(const double *o, const double *a, const double *b)
{
    return ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])) / 2;
}

/* What can be asked of the quadrature of a span: derivatives of one far shorter
 * than its distance from the origin are known to that ratio of rounding only.
 */
static double accuracy(const ix_path *p, int span)
{
    double a = p->breaks[span], b = p->breaks[span + 1], size = 0;
    double x[3][IX_MAX_COORDS];

    for (int k = 0; k < 3; k++)
        ix__path_point(p, a + (b - a) * k / 2, x[k]);
    for (int k = 1; k < 3; k++)
        size = fmax(size, hypot(x[k][0] - x[0][0], x[k][1] - x[0][1]));
    return 1e-12 + 1e-14 * hypot(x[0][0], x[0][1]) / fmax(size, 1e-300);
}

/* Area that the ray from `at` along edge e sweeps, chords to its vertices
 * included. What is beside the chord of the edge is measured from its start. */
static ix_status edge_area(const faces *w, int e, const double at[2],
                           double *out)
{
    const double *v[2] = {w->p[w->vertex[2 * e]], w->p[w->vertex[2 * e + 1]]};
    double x[2][IX_MAX_COORDS], f[2];
    sweep s = {.span = 0};
    ix_path p;

    IX_TRY(ix__path_new(w->ctx, w->a->edge[e].crv, &p));
    for (int k = 0; k < 2; k++)
        ix__path_point(&p, p.breaks[k ? p.nspans : 0], x[k]);
    s.p = &p;
    memcpy(s.at, x[0], sizeof s.at);
    *out = triangle(at, v[0], x[0]) + triangle(at, x[0], x[1]) +
           triangle(at, x[1], v[1]);
    for (; s.span < p.nspans; s.span++) {
        ix__quad(swept, &s, 2, 0, 1, accuracy(&p, s.span), f);
        *out += f[1];
    }
    return IX_OK;
}

static ix_status areas(const faces *w, double *area)
{
    for (int e = 0; e < w->a->nedges; e++) {
        ix_mark mk = ix__scratch_mark(w->ctx);
        ix_status st = w->out[e] ? IX_OK : edge_area(w, e, w->p[0], &area[e]);

        ix__scratch_release(w->ctx, mk);
        IX_TRY(st);
    }
    return IX_OK;
}

static ix_status walk_loops(faces *w)
{
    int n = 2 * w->a->nedges;
    double *area;
    bool *used;

    IX_SCRATCH_ZERO(w->ctx, used, n);
    IX_SCRATCH(w->ctx, area, n);
    IX_SCRATCH(w->ctx, w->loop, n);
    IX_SCRATCH(w->ctx, w->half, n);
    IX_TRY(areas(w, area));
    for (int h0 = 0; h0 < n; h0++) {
        ix_arr_loop *l = &w->loop[w->nloops];

        if (used[h0] || w->out[h0 / 2])
            continue;
        *l = (ix_arr_loop){.first = w->nhalf, .face = -1};
        l->component = w->component[start_of(w, h0)];
        for (int h = h0; !used[h]; h = w->next[h]) {
            used[h] = true;
            w->half[w->nhalf++] = h;
            l->area += h & 1 ? -area[h / 2] : area[h / 2];
        }
        l->n = w->nhalf - l->first;
        w->nloops++;
    }
    return IX_OK;
}

/* Numbers of the connected components of edges that take part. */
static ix_status components(faces *w)
{
    bool more = true;
    int n = 0;

    IX_SCRATCH(w->ctx, w->component, w->nv);
    for (int v = 0; v < w->nv; v++)
        w->component[v] = v;
    while (more) { /* the smallest number spreads both ways along the row */
        more = false;
        for (int i = 0; i < 2 * w->a->nedges; i++) {
            int e = i < w->a->nedges ? i : 2 * w->a->nedges - 1 - i;
            int *c = &w->component[w->vertex[2 * e]];
            int *d = &w->component[w->vertex[2 * e + 1]];

            if (w->out[e] || *c == *d)
                continue;
            *c = *d = *c < *d ? *c : *d;
            more = true;
        }
    }
    for (int v = 0; v < w->nv; v++)
        w->component[v] = w->component[v] == v ? n++
                                               : w->component[w->component[v]];
    return IX_OK;
}

/* --- faces -----------------------------------------------------------------
 */

/* In half and loop already; the curve from these half edges, closed. */
static ix_status add_half(ix_ctx *ctx, const ix_arrangement *a, int h,
                          ix_mv **sum)
{
    ix_mv *own = NULL, *next;
    ix_status st = IX_OK;

    if (h & 1)
        st = ix_mv_reverse(ctx, a->edge[h / 2].crv, 0, &own);
    else
        own = ix_mv_ref(a->edge[h / 2].crv);
    if (st != IX_OK || !*sum) {
        *sum = st == IX_OK ? own : *sum;
        return st;
    }
    st = ix__crv_chain(ctx, *sum, own, &next);
    ix_mv_unref(ctx, own);
    IX_TRY(st);
    ix_mv_unref(ctx, *sum);
    *sum = next;
    return IX_OK;
}

/* A straight line back to the start if the ends are apart. */
static ix_status close_up(ix_ctx *ctx, ix_mv **crv)
{
    double dom[2], p[2], q[2], start[3], size = 0;
    ix_mv *next;

    ix_mv_domain(*crv, 0, dom);
    IX_TRY(ix_mv_point(ctx, *crv, &dom[0], p));
    IX_TRY(ix_mv_point(ctx, *crv, &dom[1], q));
    for (int k = 0; k < 2; k++)
        size = fmax(size, fmax(fabs(p[k]), fabs(q[k])));
    if (hypot(p[0] - q[0], p[1] - q[1]) <= 1e-9 * size)
        return IX_OK;
    IX_TRY(ix_mv_eval(ctx, *crv, &dom[0], start));
    IX_TRY(ix_mv_add_point(ctx, *crv, start, false, &next));
    ix_mv_unref(ctx, *crv);
    *crv = next;
    return IX_OK;
}

static ix_status loop_curve(ix_ctx *ctx, const ix_arrangement *a,
                            const int *half, int n, ix_mv **out)
{
    ix_mv *sum = NULL;
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < n; i++)
        st = add_half(ctx, a, half[i], &sum);
    if (st == IX_OK)
        st = close_up(ctx, &sum);
    if (st == IX_OK)
        *out = sum;
    else
        ix_mv_unref(ctx, sum);
    return st;
}

/* The faces of a component but the one outside; its loop of least area, which
 * is the only one that is not positive, runs around it. */
static ix_status number_faces(faces *w, int *around)
{
    for (int c = 0; c < w->ncomponents; c++)
        around[c] = -1;
    for (int l = 0; l < w->nloops; l++) {
        int *best = &around[w->loop[l].component];

        if (*best < 0 || w->loop[l].area < w->loop[*best].area)
            *best = l;
    }
    w->face[0] = (ix_arr_face){.outer = -1, .parent = -1, .area = HUGE_VAL};
    w->nfaces = 1;
    for (int l = 0; l < w->nloops; l++) {
        ix_arr_loop *p = &w->loop[l];

        if (around[p->component] == l)
            continue;
        if (!(p->area > 0))
            return IX_FAIL(w->ctx, IX_EUNABLE,
                           "the loop along curve %d has an area of %g: curves "
                           "cross or run together",
                           w->half[p->first] / 2 + 1, p->area);
        w->face[w->nfaces] = (ix_arr_face){.outer = l, .area = p->area};
        p->face = w->nfaces++;
    }
    return IX_OK;
}

/* The box of a loop's control points. */
static ix_status loop_box(const faces *w, const ix_arr_loop *l, double box[4])
{
    box[0] = box[1] = HUGE_VAL;
    box[2] = box[3] = -HUGE_VAL;
    for (int i = 0; i < l->n; i++) {
        double lo[2], hi[2];

        IX_TRY(ix_mv_bbox(w->ctx, w->a->edge[w->half[l->first + i] / 2].crv, lo,
                          hi));
        for (int k = 0; k < 2; k++) {
            box[k] = fmin(box[k], lo[k]);
            box[2 + k] = fmax(box[2 + k], hi[k]);
        }
    }
    return IX_OK;
}

/* Does loop l run around p? */
static ix_status is_around(const faces *w, int l, const double p[2], bool *out)
{
    const double at[3] = {p[0], p[1], 0};
    const ix_arr_loop *lp = &w->loop[l];
    double box[4];
    int where = -1;
    ix_status st;
    ix_mv *crv;

    *out = false;
    IX_TRY(loop_box(w, lp, box));
    if (p[0] < box[0] || p[0] > box[2] || p[1] < box[1] || p[1] > box[3])
        return IX_OK;
    IX_TRY(loop_curve(w->ctx, w->a, w->half + lp->first, lp->n, &crv));
    st = ix_crv_encloses(w->ctx, crv, at, 0, &where);
    ix_mv_unref(w->ctx, crv);
    *out = where >= 0;
    return st;
}

/* The smallest face of other components than `but` (-1: any) that holds p; 0
 * if there is none. */
static ix_status face_at(const faces *w, const double p[2], int but, int *out)
{
    double least = HUGE_VAL;

    *out = 0;
    for (int l = 0; l < w->nloops; l++) {
        const ix_arr_loop *lp = &w->loop[l];
        bool in;

        if (w->face[lp->face].outer != l || lp->component == but ||
            lp->area >= least)
            continue;
        IX_TRY(is_around(w, l, p, &in));
        if (!in)
            continue;
        least = lp->area;
        *out = lp->face;
    }
    return IX_OK;
}

/* Outer loops become holes of the faces that they lie in. */
static ix_status nest(faces *w, const int *around)
{
    for (int c = 0; c < w->ncomponents; c++)
        w->loop[around[c]].face = 0; /* until it is known */
    for (int c = 0; c < w->ncomponents; c++) {
        ix_arr_loop *l = &w->loop[around[c]];

        IX_TRY(face_at(w, w->p[start_of(w, w->half[l->first])], c, &l->face));
        if (l->face)
            w->face[l->face].area += l->area;
    }
    for (int f = 1; f < w->nfaces; f++)
        w->face[f].parent =
            w->loop[around[w->loop[w->face[f].outer].component]].face;
    return IX_OK;
}

/* Components of vertices that no edge reaches do not count. */
static void renumber(faces *w, int *number)
{
    int n = 0;

    for (int v = 0; v < w->nv; v++)
        number[v] = -1;
    for (int l = 0; l < w->nloops; l++) {
        int *c = &number[w->loop[l].component];

        if (*c < 0)
            *c = n++;
        w->loop[l].component = *c;
    }
    w->ncomponents = n;
}

static ix_status find(faces *w, bool ignore)
{
    int *around, *number;

    IX_TRY(ix__arr_vertices(w->ctx, w->a, &w->vertex, &w->nv, &w->p));
    IX_TRY(choose(w, ignore));
    IX_TRY(components(w));
    IX_TRY(orders(w));
    IX_TRY(walk_loops(w));
    IX_SCRATCH(w->ctx, number, w->nv);
    renumber(w, number);
    IX_SCRATCH(w->ctx, around, w->ncomponents);
    IX_SCRATCH(w->ctx, w->face, w->nloops + 1);
    IX_TRY(number_faces(w, around));
    return nest(w, around);
}

/* --- the result
 * ------------------------------------------------------------------ */

static void name_edges(ix_arrangement *a, const faces *w)
{
    for (int e = 0; e < a->nedges; e++)
        for (int k = 0; k < 2; k++) {
            a->edge[e].vertex[k] = w->vertex[2 * e + k];
            a->edge[e].face[k] = -1;
        }
    for (int l = 0; l < a->nloops; l++)
        for (int i = 0; i < a->loop[l].n; i++) {
            int h = a->half[a->loop[l].first + i];

            a->edge[h / 2].face[h & 1] = a->loop[l].face;
        }
}

static void fill_vertices(ix_arrangement *a, const faces *w)
{
    for (int v = 0; v < a->nvertices; v++)
        a->vertex[v] = (ix_arr_vertex){.p = {w->p[v][0], w->p[v][1]}};
    for (int h = 0; h < 2 * a->nedges; h++)
        a->vertex[w->vertex[h]].degree += !w->out[h / 2];
}

/* One block: loops, faces (the doubles), vertices, half edges. */
static ix_status give(ix_arrangement *a, const faces *w)
{
    size_t loops = (size_t)w->nloops * sizeof *w->loop;
    size_t fs = (size_t)w->nfaces * sizeof *w->face;
    size_t vs = (size_t)w->nv * sizeof *a->vertex;
    size_t hs = (size_t)w->nhalf * sizeof *w->half;
    char *block = ix__alloc(w->ctx, loops + fs + vs + hs);

    if (!block)
        return IX_ENOMEM;
    ix__arr_forget(w->ctx, a);
    a->bytes = loops + fs + vs + hs;
    a->loop = (ix_arr_loop *)(void *)block;
    a->face = (ix_arr_face *)(void *)(block + loops);
    a->vertex = (ix_arr_vertex *)(void *)(block + loops + fs);
    a->half = (int *)(void *)(block + loops + fs + vs);
    if (w->nloops) {
        memcpy(a->loop, w->loop, loops);
        memcpy(a->half, w->half, hs);
    }
    memcpy(a->face, w->face, fs);
    a->nloops = w->nloops;
    a->nfaces = w->nfaces;
    a->nvertices = w->nv;
    a->nhalf = w->nhalf;
    a->ncomponents = w->ncomponents;
    fill_vertices(a, w);
    name_edges(a, w);
    a->evaluated = true;
    return IX_OK;
}

void ix__arr_forget(ix_ctx *ctx, ix_arrangement *a)
{
    ix__free(ctx, a->loop, a->bytes);
    a->bytes = 0;
    a->loop = NULL;
    a->face = NULL;
    a->vertex = NULL;
    a->half = NULL;
    a->nloops = a->nfaces = a->nvertices = a->nhalf = a->ncomponents = 0;
    a->evaluated = a->classified = false;
    for (int e = 0; e < a->nedges; e++)
        for (int k = 0; k < 2; k++)
            a->edge[e].vertex[k] = a->edge[e].face[k] = -1;
}

static ix_status evaluate(ix_ctx *ctx, ix_arrangement *a, bool ignore)
{
    faces w = {.ctx = ctx, .a = a};

    IX_TRY(find(&w, ignore));
    return give(a, &w);
}

ix_status ix_arrangement_evaluate(ix_ctx *ctx, ix_arrangement *a,
                                  bool ignore_hanging)
{
    IX_RETURN_SCOPED(ctx, evaluate(ctx, a, ignore_hanging));
}

ix_status ix__arr_check_evaluated(ix_ctx *ctx, const ix_arrangement *a)
{
    if (!a->evaluated)
        return IX_FAIL(ctx, IX_EARG,
                       "the arrangement has not been evaluated since it was "
                       "changed");
    return IX_OK;
}

ix_status ix_arrangement_loop_curve(ix_ctx *ctx, const ix_arrangement *a,
                                    int loop, ix_mv **out)
{
    *out = NULL;
    IX_TRY(ix__arr_check_evaluated(ctx, a));
    if (loop < 0 || loop >= a->nloops)
        return IX_FAIL(ctx, IX_EARG, "loop %d of %d", loop, a->nloops);
    return loop_curve(ctx, a, a->half + a->loop[loop].first, a->loop[loop].n,
                      out);
}

ix_status ix_arrangement_locate(ix_ctx *ctx, const ix_arrangement *a,
                                const double p[2], int *face)
{
    faces w = {.ctx = ctx};

    *face = 0;
    IX_TRY(ix__arr_check_evaluated(ctx, a));
    w.a = a;
    w.loop = a->loop;
    w.nloops = a->nloops;
    w.half = a->half;
    w.face = a->face;
    return face_at(&w, p, -1, face);
}
