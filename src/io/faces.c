/* faces.c - triangles of trimmed surfaces and models. An edge of a model is
 * sampled once for all faces that it bounds: at the parameters that each of
 * them needs. */
#include "io/faces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- loops --------------------------------------------------------------- */

static ix_status check_curve(ix_ctx *ctx, const ix_mv *uv)
{
    if (ix_mv_ndirs(uv) != 1 || ix_mv_ncoords(uv) < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "a trimming curve has %d parameters and %d coordinates, "
                       "not 1 and 2",
                       ix_mv_ndirs(uv), ix_mv_ncoords(uv));
    if (ix_mv_has_poles(uv))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "a trimming curve has weights of both signs or zero");
    return IX_OK;
}

/* Beginning and end of the way through a curve. */
static ix_status ends_of(ix_ctx *ctx, const ix__face_curve *c, double p[2][2])
{
    double dom[2], v[IX_MAX_COORDS];

    ix_mv_domain(c->uv, 0, dom);
    for (int e = 0; e < 2; e++) {
        IX_TRY(ix_mv_point(ctx, c->uv, &dom[e != c->back], v));
        memcpy(p[e], v, sizeof p[e]);
    }
    return IX_OK;
}

static double apart(const double a[2], const double b[2])
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

static double from_ends(const double p[2], double q[2][2])
{
    return fmin(apart(p, q[0]), apart(p, q[1]));
}

/* Turns curves that run against the others. */
static ix_status chain(ix_ctx *ctx, ix__face_loop *l)
{
    double p[2][2], q[2][2];

    for (int i = 0; i + 1 < l->n; i++) {
        IX_TRY(ends_of(ctx, &l->curve[i], p));
        IX_TRY(ends_of(ctx, &l->curve[i + 1], q));
        if (i == 0 && from_ends(p[0], q) < from_ends(p[1], q)) {
            l->curve[0].back = true;
            memcpy(p[1], p[0], sizeof p[1]);
        }
        l->curve[i + 1].back = apart(p[1], q[1]) < apart(p[1], q[0]);
    }
    return IX_OK;
}

ix_status ix__face_of_trimsrf(ix_ctx *ctx, const ix_trimsrf *t, ix__face *out)
{
    *out = (ix__face){.srf = t->srf, .nloops = t->nloops};
    IX_SCRATCH(ctx, out->loop, t->nloops);
    for (int i = 0; i < t->nloops; i++) {
        ix__face_loop *l = &out->loop[i];

        l->n = t->loop[i].n;
        IX_SCRATCH_ZERO(ctx, l->curve, l->n);
        for (int k = 0; k < l->n; k++) {
            l->curve[k].uv = t->loop[i].seg[k].uv;
            l->curve[k].euclid = t->loop[i].seg[k].euclid;
            l->curve[k].edge = -1;
            IX_TRY(check_curve(ctx, l->curve[k].uv));
        }
        IX_TRY(chain(ctx, l));
    }
    return IX_OK;
}

/* Edge e (from 1 on; negative: backwards) on face f. A seam has both curves
 * there: the second one is for the way back. */
static ix__face_curve curve_on(const ix_model *m, int e, int f)
{
    int at = (e < 0 ? -e : e) - 1;
    const ix_model_seg *s = &m->seg[at];
    bool seam = s->s1 == f + 1 && s->s2 == f + 1;
    bool second = seam ? e < 0 && s->uv2 : s->s1 != f + 1;

    return (ix__face_curve){.uv = !second          ? s->uv1
                                  : s->s2 == f + 1 ? s->uv2
                                                   : NULL,
                            .euclid = s->euclid,
                            .back = e < 0,
                            .edge = at,
                            .second = second};
}

static ix_status face_of_model(ix_ctx *ctx, const ix_model *m, int f,
                               ix__face *out)
{
    const ix_model_srf *s = &m->srf[f];

    *out = (ix__face){.srf = s->srf};
    IX_SCRATCH(ctx, out->loop, s->nloops);
    for (int i = 0; i < s->nloops; i++) {
        ix__face_loop *l = &out->loop[out->nloops];

        l->n = 0;
        IX_SCRATCH(ctx, l->curve, s->nseg[i]);
        for (int k = 0; k < s->nseg[i]; k++) {
            ix__face_curve c = curve_on(m, s->seg[i][k], f);

            if (!c.uv)
                continue;
            IX_TRY(check_curve(ctx, c.uv));
            l->curve[l->n++] = c;
        }
        out->nloops += l->n > 0;
    }
    return IX_OK;
}

/* --- loops in each other ---------------------------------------------------
 */

typedef struct {
    size_t n;
    double *uv; /* [n][2] */
} polygon;

/* 16 points of each curve, and some for each control point. */
static size_t samples_of(const ix__face_curve *c)
{
    return 16 + 4 * ix_mv_npts(c->uv);
}

static ix_status sampled(ix_ctx *ctx, const ix__face_loop *l, polygon *out)
{
    double dom[2], p[IX_MAX_COORDS];

    *out = (polygon){0};
    for (int k = 0; k < l->n; k++)
        out->n += samples_of(&l->curve[k]);
    IX_SCRATCH(ctx, out->uv, 2 * out->n);
    out->n = 0;
    for (int k = 0; k < l->n; k++) {
        const ix__face_curve *c = &l->curve[k];
        size_t n = samples_of(c);

        ix_mv_domain(c->uv, 0, dom);
        for (size_t i = 0; i < n; i++) {
            double s = (double)(c->back ? n - i : i) / (double)n;
            double t = dom[0] + (dom[1] - dom[0]) * s;

            IX_TRY(ix_mv_point(ctx, c->uv, &t, p));
            memcpy(out->uv + 2 * out->n++, p, 2 * sizeof *p);
        }
    }
    return IX_OK;
}

static double area(const polygon *g)
{
    double sum = 0;

    for (size_t i = 0; i < g->n; i++) {
        const double *o = g->uv, *p = g->uv + 2 * i;
        const double *q = g->uv + 2 * ((i + 1) % g->n);

        sum += (p[0] - o[0]) * (q[1] - o[1]) - (q[0] - o[0]) * (p[1] - o[1]);
    }
    return sum / 2;
}

static bool is_inside(const double p[2], const polygon *g)
{
    bool in = false;

    for (size_t i = 0; i < g->n; i++) {
        const double *a = g->uv + 2 * i, *b = g->uv + 2 * ((i + 1) % g->n);

        if ((a[1] > p[1]) != (b[1] > p[1]) &&
            p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
            in = !in;
    }
    return in;
}

/* Are most points of a loop inside another, larger one? */
static bool lies_in(const polygon *g, const polygon *around)
{
    size_t n = 0;

    if (!(fabs(area(g)) < fabs(area(around))))
        return false;
    for (size_t i = 0; i < g->n; i++)
        n += is_inside(g->uv + 2 * i, around);
    return 2 * n > g->n;
}

ix_status ix__face_nesting(ix_ctx *ctx, const ix__face *f, ix__nesting **out)
{
    polygon *g;

    IX_SCRATCH_ZERO(ctx, *out, f->nloops);
    IX_SCRATCH(ctx, g, f->nloops);
    for (int i = 0; i < f->nloops; i++)
        IX_TRY(sampled(ctx, &f->loop[i], &g[i]));
    for (int i = 0; i < f->nloops; i++) {
        ix__nesting *l = &(*out)[i];
        double least = HUGE_VAL;

        l->outer = i;
        for (int k = 0; k < f->nloops; k++) {
            if (k == i || !lies_in(&g[i], &g[k]))
                continue;
            l->depth++;
            if (fabs(area(&g[k])) < least) {
                least = fabs(area(&g[k]));
                l->outer = k;
            }
        }
        if (l->depth % 2 == 0)
            l->outer = i;
        l->turn = (area(&g[i]) < 0) != (l->depth % 2 == 1);
    }
    return IX_OK;
}

/* --- models ----------------------------------------------------------------
 */

/* No edge is run through twice in the same sense. */
static ix_status is_oriented(ix_ctx *ctx, const ix_model *m, const ix__face *f,
                             bool *is)
{
    bool(*seen)[2];

    IX_SCRATCH_ZERO(ctx, seen, m->nseg);
    *is = true;
    for (int i = 0; i < m->nsrf; i++)
        for (int l = 0; l < f[i].nloops; l++)
            for (int k = 0; k < f[i].loop[l].n; k++) {
                const ix__face_curve *c = &f[i].loop[l].curve[k];

                *is = *is && !seen[c->edge][c->back];
                seen[c->edge][c->back] = true;
            }
    return IX_OK;
}

ix_status ix__faces_of_model(ix_ctx *ctx, const ix_model *m, ix__face **out)
{
    bool oriented;

    IX_SCRATCH(ctx, *out, m->nsrf);
    for (int f = 0; f < m->nsrf; f++)
        IX_TRY(face_of_model(ctx, m, f, &(*out)[f]));
    IX_TRY(is_oriented(ctx, m, *out, &oriented));
    for (int f = 0; f < m->nsrf && oriented; f++) {
        ix__nesting *nest;

        IX_TRY(ix__face_nesting(ctx, &(*out)[f], &nest));
        for (int l = 0; l < (*out)[f].nloops; l++)
            if (nest[l].depth == 0)
                (*out)[f].reversed = nest[l].turn;
    }
    return IX_OK;
}

/* --- samples of the curves ------------------------------------------------ */

/* Of the tolerance, the grid of a surface takes GRID and the trimming curves
 * the rest: a border edge is off by both, at most. */
#define GRID 0.7

/* A curve of a face. Those of one edge of a model form a ring. */
typedef struct use use;
struct use {
    const ix__face_curve *c;
    int face;
    double dom[2];
    size_t n;
    double *t, *uv, *xyz; /* [n], [n][2], [n][3] */
    use *next;
    bool done;
};

typedef struct {
    ix_ctx *ctx;
    int n;
    const ix__face *face;
    double tol;       /* with steps: within which edges are one */
    const int *steps; /* NULL, or instead of the tolerance */
    ix__tess_grid **grid;
    size_t nuses;
    use *uses; /* in the order of faces, loops, curves */
} mesher;

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static double mapped(double t, const double from[2], const double to[2])
{
    if (t == from[1])
        return to[1];
    return to[0] + (to[1] - to[0]) * ((t - from[0]) / (from[1] - from[0]));
}

/* Parameters that are nearer to each other, as parts of the domain, are one. */
#define SAME_PARAMETER 1e-12

/* All parameters of a ring, in the domain of u, become u's. */
static ix_status unite(ix_ctx *ctx, use *u)
{
    const use *v = u;
    double least = SAME_PARAMETER * (u->dom[1] - u->dom[0]), *t;
    size_t all = 0, k = 0;

    do
        all += v->n;
    while ((v = v->next) != u);
    IX_SCRATCH(ctx, t, all);
    all = 0;
    do
        for (size_t i = 0; i < v->n; i++)
            t[all++] = mapped(v->t[i], v->dom, u->dom);
    while ((v = v->next) != u);
    qsort(t, all, sizeof *t, compare);
    for (size_t i = 0; i < all; i++)
        if (k == 0 || t[i] > t[k - 1] + least)
            t[k++] = t[i];
    if (k > 0)
        t[k - 1] = t[all - 1];
    u->n = k;
    u->t = t;
    return IX_OK;
}

/* The places of sample i in the grid of its face. */
static void place_of(const mesher *m, const use *u, size_t i, int64_t x[2])
{
    ix__trim_place(m->grid[u->face], u->uv + 2 * i, x);
}

/* In some face of the ring, i and k are one vertex; lines[0], lines[1]: on how
 * many lines of grids, of the other faces, each of them is. */
static bool coincide(const mesher *m, const use *first, size_t i, size_t k,
                     int lines[2])
{
    const use *u = first;
    bool any = false;

    lines[0] = lines[1] = 0;
    do {
        int64_t x[2], y[2];
        bool same;

        place_of(m, u, i, x);
        place_of(m, u, k, y);
        same = x[0] == y[0] && x[1] == y[1];
        any = any || same;
        for (int d = 0; d < 2 && !same; d++) {
            lines[0] += ix__trim_on_line(x[d]);
            lines[1] += ix__trim_on_line(y[d]);
        }
    } while ((u = u->next) != first);
    return any;
}

static void keep_only(use *first, size_t n, const size_t *kept)
{
    use *u = first;

    do {
        for (size_t i = 0; i < n; i++) {
            u->t[i] = u->t[kept[i]];
            memmove(u->uv + 2 * i, u->uv + 2 * kept[i], 2 * sizeof *u->uv);
            memmove(u->xyz + 3 * i, u->xyz + 3 * kept[i], 3 * sizeof *u->xyz);
        }
        u->n = n;
    } while ((u = u->next) != first);
}

/* Samples that are one vertex in some face become one in all of them: the one
 * that is on the lines of the others' grids stays. The ends stay, too. */
static ix_status drop_doubles(mesher *m, use *first)
{
    size_t *kept, n = 1;
    int lines[2];

    IX_SCRATCH(m->ctx, kept, first->n);
    kept[0] = 0;
    for (size_t i = 1; i < first->n; i++) {
        bool end = i + 1 == first->n;

        if (!coincide(m, first, kept[n - 1], i, lines))
            kept[n++] = i;
        else if (n > 1 && (end || lines[1] > lines[0]))
            kept[n - 1] = i;
        else if (end)
            kept[n++] = i;
    }
    keep_only(first, n, kept);
    return IX_OK;
}

/* Both see the same parameters, then crossings of their own grids: a few rounds
 * do, as crossings of one grid hardly move those of the other. */
enum { ROUNDS = 4 };

static int most_steps(const mesher *m)
{
    return !m->steps                   ? 0
           : m->steps[0] > m->steps[1] ? m->steps[0]
                                       : m->steps[1];
}

static ix_status sample_ring(mesher *m, use *first)
{
    use *u = first;

    do {
        IX_TRY(ix__trim_samples(m->ctx, m->grid[u->face], u->c->uv,
                                (1 - GRID) * m->tol, most_steps(m), &u->n,
                                &u->t));
        ix_mv_domain(u->c->uv, 0, u->dom);
        u->done = true;
    } while ((u = u->next) != first);
    for (int round = 0; round < ROUNDS; round++) {
        size_t before = first->n;

        do {
            if (u->next != u)
                IX_TRY(unite(m->ctx, u));
            IX_TRY(ix__trim_crossings(m->ctx, m->grid[u->face], u->c->uv, &u->n,
                                      &u->t));
        } while ((u = u->next) != first);
        if (u->next == u || (first->n == before && first->next->n == before))
            break;
    }
    do
        if (u->next != u)
            IX_TRY(unite(m->ctx, u));
    while ((u = u->next) != first);
    return IX_OK;
}

/* uv and points of a curve at its parameters. */
static ix_status points_of(mesher *m, use *u)
{
    const ix_mv *srf = m->face[u->face].srf;
    size_t n = u->n;
    double *uv, *p, dom[2];

    IX_SCRATCH(m->ctx, uv, n * (size_t)ix_mv_ncoords(u->c->uv));
    IX_SCRATCH(m->ctx, p, n * (size_t)ix_mv_ncoords(srf));
    IX_SCRATCH(m->ctx, u->uv, 2 * n);
    IX_SCRATCH_ZERO(m->ctx, u->xyz, 3 * n);
    IX_TRY(ix_mv_point_many(m->ctx, u->c->uv, n, u->t, uv));
    for (size_t i = 0; i < 2 * n; i++)
        u->uv[2 * (i % n) + i / n] = uv[i];
    for (int d = 0; d < 2; d++) {
        ix_mv_domain(srf, d, dom);
        for (size_t i = 0; i < n; i++)
            uv[(size_t)d * n + i] = fmin(fmax(uv[(size_t)d * n + i], dom[0]),
                                         dom[1]);
    }
    IX_TRY(ix_mv_point_many(m->ctx, srf, n, uv, p));
    for (size_t c = 0; c < 3 && (int)c < ix_mv_ncoords(srf); c++)
        for (size_t i = 0; i < n; i++)
            u->xyz[3 * i + c] = p[c * n + i];
    return IX_OK;
}

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static double gap_of(const use *a, const use *b)
{
    double gap = 0;

    for (size_t i = 0; i < a->n; i++)
        gap = fmax(gap, distance(a->xyz + 3 * i, b->xyz + 3 * i));
    return gap;
}

/* All curves of a ring get the first one's points, unless they are too far
 * away. */
static ix_status share_points(mesher *m, use *first)
{
    for (use *u = first->next; u != first; u = u->next)
        if (u->n != first->n || !(gap_of(first, u) <= m->tol)) {
            ix__note(m->ctx, "warning: faces of a model do not meet along an "
                             "edge: they stay apart");
            return IX_OK;
        }
    IX_TRY(drop_doubles(m, first));
    for (use *u = first->next; u != first; u = u->next)
        memcpy(u->xyz, first->xyz, 3 * u->n * sizeof *u->xyz);
    return IX_OK;
}

/* --- corners of models ---------------------------------------------------- */

static double *end_of(const use *u, bool last)
{
    return u->xyz + 3 * (last != u->c->back ? u->n - 1 : 0);
}

/* The point at which a curve of a model ends and the next one of its loop
 * begins is the same for all: the first that was seen. Ends are those of
 * edges, two each. */
typedef struct {
    int *up; /* [2 edges]: union-find */
    const double **at;
} corners;

static int root(corners *c, int i)
{
    while (c->up[i] != i)
        i = c->up[i] = c->up[c->up[i]];
    return i;
}

static int end_id(const use *u, bool last)
{
    return 2 * u->c->edge + (last != u->c->back);
}

static void join_ends(mesher *m, corners *c, const use *a, const use *b)
{
    int i, k;

    if (a->n == 0 || b->n == 0 ||
        !(distance(end_of(a, true), end_of(b, false)) <= m->tol))
        return;
    i = root(c, end_id(a, true));
    k = root(c, end_id(b, false));
    c->up[i > k ? i : k] = i > k ? k : i;
}

/* The use of curve k of loop l of face f comes at a place that is counted. */
static void each_pair(mesher *m, corners *c)
{
    const use *u = m->uses;

    for (int f = 0; f < m->n; f++)
        for (int l = 0; l < m->face[f].nloops; l++) {
            int n = m->face[f].loop[l].n;

            for (int k = 0; k < n; k++)
                if (u[k].c->edge >= 0)
                    join_ends(m, c, &u[k], &u[(k + 1) % n]);
            u += n;
        }
}

static ix_status unite_corners(mesher *m)
{
    int nedges = 0;
    corners c;

    for (size_t i = 0; i < m->nuses; i++)
        if (m->uses[i].c->edge >= nedges)
            nedges = m->uses[i].c->edge + 1;
    IX_SCRATCH(m->ctx, c.up, 2 * (size_t)nedges);
    IX_SCRATCH_ZERO(m->ctx, c.at, 2 * (size_t)nedges);
    for (int i = 0; i < 2 * nedges; i++)
        c.up[i] = i;
    each_pair(m, &c);
    for (size_t i = 0; i < m->nuses; i++)
        for (int last = 0; last < 2; last++) {
            const use *u = &m->uses[i];
            int r;

            if (u->c->edge < 0 || u->n == 0)
                continue;
            r = root(&c, end_id(u, last));
            if (!c.at[r])
                c.at[r] = end_of(u, last);
            else if (distance(c.at[r], end_of(u, last)) <= m->tol)
                memmove(end_of(u, last), c.at[r], 3 * sizeof(double));
        }
    return IX_OK;
}

/* --- all faces ------------------------------------------------------------ */

static void link_rings(mesher *m, use **last)
{
    for (size_t i = 0; i < m->nuses; i++) {
        use *u = &m->uses[i];
        int e = u->c->edge;

        u->next = u;
        if (e < 0)
            continue;
        if (last[e]) {
            u->next = last[e]->next;
            last[e]->next = u;
        }
        last[e] = u;
    }
}

static ix_status list_uses(mesher *m)
{
    size_t nedges = 0;
    use **last;

    for (int f = 0; f < m->n; f++)
        for (int l = 0; l < m->face[f].nloops; l++)
            m->nuses += (size_t)m->face[f].loop[l].n;
    IX_SCRATCH_ZERO(m->ctx, m->uses, m->nuses);
    m->nuses = 0;
    for (int f = 0; f < m->n; f++)
        for (int l = 0; l < m->face[f].nloops; l++)
            for (int k = 0; k < m->face[f].loop[l].n; k++) {
                const ix__face_curve *c = &m->face[f].loop[l].curve[k];

                m->uses[m->nuses++] = (use){.c = c, .face = f};
                if (c->edge >= 0 && (size_t)c->edge >= nedges)
                    nedges = (size_t)c->edge + 1;
            }
    IX_SCRATCH_ZERO(m->ctx, last, nedges);
    link_rings(m, last);
    return IX_OK;
}

static ix_status make_grid(mesher *m, int f)
{
    ix_status st;

    if (m->steps)
        return ix__mesh_grid_even(m->ctx, m->face[f].srf, m->steps,
                                  &m->grid[f]);
    st = ix__mesh_grid(m->ctx, m->face[f].srf, GRID * m->tol, &m->grid[f]);
    if (st == IX_EUNABLE) /* the caller knows the whole tolerance only */
        return IX_FAIL(m->ctx, st,
                       "the tolerance %g would need too many points", m->tol);
    return st;
}

static ix_status sample_all(mesher *m)
{
    IX_SCRATCH(m->ctx, m->grid, m->n);
    for (int f = 0; f < m->n; f++)
        IX_TRY(make_grid(m, f));
    IX_TRY(list_uses(m));
    for (size_t i = 0; i < m->nuses; i++)
        if (!m->uses[i].done)
            IX_TRY(sample_ring(m, &m->uses[i]));
    for (size_t i = 0; i < m->nuses; i++)
        IX_TRY(points_of(m, &m->uses[i]));
    for (size_t i = 0; i < m->nuses; i++) {
        bool first = true;

        for (const use *u = m->uses[i].next; u != &m->uses[i]; u = u->next)
            first = first && u > &m->uses[i];
        if (first && m->uses[i].next != &m->uses[i])
            IX_TRY(share_points(m, &m->uses[i]));
    }
    return unite_corners(m);
}

/* The points of n curves of a loop, one after the other. */
static ix_status join_curves(ix_ctx *ctx, int n, const use *u,
                             ix__trim_loop *out)
{
    double *uv, *xyz;
    size_t all = 0, at = 0;

    for (int k = 0; k < n; k++)
        all += u[k].n;
    IX_SCRATCH(ctx, uv, 2 * all);
    IX_SCRATCH(ctx, xyz, 3 * all);
    for (int k = 0; k < n; k++)
        for (size_t i = 0; i < u[k].n; i++, at++) {
            size_t from = u[k].c->back ? u[k].n - 1 - i : i;

            memcpy(uv + 2 * at, u[k].uv + 2 * from, 2 * sizeof *uv);
            memcpy(xyz + 3 * at, u[k].xyz + 3 * from, 3 * sizeof *xyz);
        }
    *out = (ix__trim_loop){all, uv, xyz};
    return IX_OK;
}

static ix_status loops_of(mesher *m, int f, const use **u, ix__trim_loop **out)
{
    const ix__face *face = &m->face[f];

    IX_SCRATCH(m->ctx, *out, face->nloops);
    for (int l = 0; l < face->nloops; l++) {
        IX_TRY(join_curves(m->ctx, face->loop[l].n, *u, &(*out)[l]));
        *u += face->loop[l].n;
    }
    return IX_OK;
}

static void turn_over(ix__mesh *m)
{
    for (size_t i = 0; i < m->ntris; i++) {
        uint32_t v = m->tri[i][1];

        m->tri[i][1] = m->tri[i][2];
        m->tri[i][2] = v;
    }
}

static ix_status mesh_faces(mesher *m, ix__mesh *out)
{
    const use *u;

    IX_TRY(sample_all(m));
    u = m->uses;
    for (int f = 0; f < m->n; f++) {
        ix__trim_loop *loop;

        IX_TRY(loops_of(m, f, &u, &loop));
        IX_TRY(ix__mesh_of_part(m->ctx, m->face[f].srf, m->grid[f],
                                m->face[f].nloops, loop, &out[f]));
        if (m->face[f].reversed)
            turn_over(&out[f]);
    }
    return IX_OK;
}

ix_status ix__mesh_of_faces(ix_ctx *ctx, int n, const ix__face *face,
                            double tol, const int *steps, ix__mesh **out)
{
    mesher m = {.ctx = ctx, .n = n, .face = face, .tol = tol, .steps = steps};
    ix_mark mk;
    ix_status st;

    IX_SCRATCH_ZERO(ctx, *out, n);
    mk = ix__scratch_mark(ctx);
    st = mesh_faces(&m, *out);
    ix__scratch_release(ctx, mk);
    for (int f = 0; f < n && st != IX_OK; f++)
        ix__mesh_free(ctx, &(*out)[f]);
    return st;
}

/* --- border lines --------------------------------------------------------- */

static ix_status border(mesher *m, ix__lines *out)
{
    const use *u;
    ix__trim_loop *loop;
    size_t all = 0;

    IX_TRY(sample_all(m));
    u = m->uses;
    IX_TRY(loops_of(m, 0, &u, &loop));
    for (int l = 0; l < m->face->nloops; l++)
        all += loop[l].n;
    IX_TRY(ix__lines_alloc(m->ctx, (size_t)m->face->nloops, all, out));
    all = 0;
    for (int l = 0; l < m->face->nloops; l++) {
        out->start[l] = all;
        memcpy(out->xyz + 3 * all, loop[l].xyz,
               3 * loop[l].n * sizeof *out->xyz);
        for (size_t i = 0; i < loop[l].n; i++)
            out->t[all++] = (double)i;
    }
    out->start[m->face->nloops] = all;
    return IX_OK;
}

ix_status ix__lines_of_face(ix_ctx *ctx, const ix__face *f, double tol,
                            ix__lines *out)
{
    mesher m = {.ctx = ctx, .n = 1, .face = f, .tol = tol};

    *out = (ix__lines){0};
    IX_RETURN_SCOPED(ctx, border(&m, out));
}
