/* crv_view_map.c - silhouettes of a planar curve and their shadows, for all
 * directions of view at once.
 *
 * C(t) is a silhouette for the view V(v) where T(t) x V(v) = 0, a curve in the
 * plane of (t, v). The line of sight through it is its tangent; it meets the
 * curve again at r where (C(t) - C(r)) x T(t) = 0, from which (t - r)^2 is
 * divided out on each span. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "geom/crv_pairs.h"
#include "geom/crvs.h"
#include "geom/lines.h"
#include "geom/marks.h"
#include "geom/unit_solve.h"
#include "iritx/visible.h"

#define NEAR                                                         \
    1e-6 /* of the size: nearer to the silhouette a meeting with its \
            tangent is the contact itself, split by rounding */

typedef struct {
    ix_ctx *ctx;
    const ix_mv *crv, *view; /* open B-splines */
    bool trim;
    ix_curves_opts o;
    ix__marks m;
    ix_path sight;
    int n, room, nlines, line_room;
    int *count;
    double (*p)[3];
} map;

/* --- polylines that grow
 * -------------------------------------------------------- */

static ix_status put(map *w, const double x[3])
{
    IX_GROW(w->ctx, w->p, w->n, w->room);
    memcpy(w->p[w->n++], x, sizeof *w->p);
    w->count[w->nlines]++;
    return IX_OK;
}

/* The next line begins; one of a single point is forgotten. */
static ix_status next_line(map *w)
{
    int *n = w->nlines >= 0 ? &w->count[w->nlines] : NULL;

    if (n && *n < 2) {
        w->n -= *n;
        *n = 0;
        return IX_OK;
    }
    w->nlines++;
    IX_GROW(w->ctx, w->count, w->nlines, w->line_room);
    w->count[w->nlines] = 0;
    return IX_OK;
}

/* --- what is seen
 * --------------------------------------------------------------- */

/* Nothing before C(t) towards the viewer, and for a shadow (r other than t)
 * nothing between it and C(r), which lies behind. */
static ix_status is_seen(const map *w, const double x[3], bool *seen)
{
    double c[IX_MAX_COORDS], q[IX_MAX_COORDS], v[IX_MAX_COORDS], len, depth = 0;
    double normal[2], tie = NEAR * w->m.size;
    ix_root *r;
    int n;

    ix__path_point(&w->m.path, x[0], c);
    ix__path_point(&w->sight, x[1], v);
    len = hypot(v[0], v[1]);
    normal[0] = -v[1] / len;
    normal[1] = v[0] / len;
    if (x[2] < x[0] || x[2] > x[0]) {
        ix__path_point(&w->m.path, x[2], q);
        depth = ((q[0] - c[0]) * v[0] + (q[1] - c[1]) * v[1]) / len;
        *seen = depth < -tie;
        if (!*seen)
            return IX_OK;
    }
    IX_TRY(ix__marks_line(&w->m, c, normal, false, &r, &n));
    *seen = true;
    for (int i = 0; i < n; i++) {
        double along;

        ix__path_point(&w->m.path, r[i].t, q);
        along = ((q[0] - c[0]) * v[0] + (q[1] - c[1]) * v[1]) / len;
        *seen = *seen && !(along > tie) &&
                !(along < -tie && along > depth + tie);
    }
    ix_roots_free(w->ctx, r, n);
    return IX_OK;
}

/* Newton's method for (X(u) - from) x dir = 0 along a path, within reach of
 * where it begins; false if it does not get there. */
static bool newton(const ix_path *p, const double from[2], const double dir[2],
                   double reach, double *u)
{
    double start = *u, size = hypot(dir[0], dir[1]) * ix__path_size(p);

    for (int step = 0; step < 6; step++) {
        double d[2][3], f;

        ix__path_derivs3(p, ix__path_span(p, *u), *u, 1, d);
        f = (d[0][0] - from[0]) * dir[1] - (d[0][1] - from[1]) * dir[0];
        if (fabs(f) <= 1e-12 * size)
            return true;
        *u -= f / (d[1][0] * dir[1] - d[1][1] * dir[0]);
        if (!(fabs(*u - start) <= reach && *u >= p->breaks[0] &&
              *u <= p->breaks[p->nspans]))
            return false;
    }
    return false;
}

/* Moves a point between two neighbouring vertices a, b onto the solution, t as
 * it is. */
static bool settle(const map *w, const double a[3], const double b[3],
                   double x[3])
{
    const double zero[2] = {0, 0};
    bool own = x[2] < x[0] || x[2] > x[0];
    double d[2][3];

    ix__path_derivs3(&w->m.path, ix__path_span(&w->m.path, x[0]), x[0], 1, d);
    return newton(&w->sight, zero, d[1], fabs(b[1] - a[1]), &x[1]) &&
           (!own || newton(&w->m.path, d[0], d[1], fabs(b[2] - a[2]), &x[2]));
}

/* Between a vertex that is seen and one that is not: the last that is. */
static ix_status last_seen(const map *w, const double in[3],
                           const double out[3], double x[3])
{
    double a[3], b[3];

    memcpy(a, in, sizeof a);
    memcpy(b, out, sizeof b);
    for (int step = 0; step < 30; step++) {
        bool seen = false;

        for (int k = 0; k < 3; k++)
            x[k] = (a[k] + b[k]) / 2;
        if (settle(w, in, out, x))
            IX_TRY(is_seen(w, x, &seen));
        memcpy(seen ? a : b, x, sizeof a);
    }
    memcpy(x, a, sizeof a);
    return IX_OK;
}

static ix_status add_vertices(map *w, int n, const double (*x)[3])
{
    bool before = false;

    for (int i = 0; i < n; i++) {
        bool seen = true;
        double end[3];

        if (w->trim)
            IX_TRY(is_seen(w, x[i], &seen));
        if (i > 0 && seen != before) {
            IX_TRY(last_seen(w, x[seen ? i : i - 1], x[seen ? i - 1 : i], end));
            IX_TRY(put(w, end));
        }
        if (seen)
            IX_TRY(put(w, x[i]));
        else
            IX_TRY(next_line(w));
        before = seen;
    }
    return next_line(w);
}

/* Of unknowns (t, v), or (t, r, v). */
static ix_status add_curves(map *w, const ix_solution_curves *s)
{
    double(*x)[3];

    if (!s->complete)
        return IX_FAIL(w->ctx, IX_EUNABLE,
                       "stopped after %zu cells: the silhouettes are not known "
                       "completely",
                       s->boxes);
    for (int i = 0; i < s->ncurves; i++) {
        const ix_solution_curve *c = &s->curve[i];
        int u = s->unknowns;

        IX_SCRATCH(w->ctx, x, c->n);
        for (int k = 0; k < c->n; k++) {
            const double *at = c->x + (size_t)u * (size_t)k;

            x[k][0] = at[0];
            x[k][1] = at[u - 1];
            x[k][2] = u == 2 ? at[0] : at[1];
        }
        IX_TRY(add_vertices(w, c->n, (const double(*)[3])x));
    }
    return IX_OK;
}

/* --- equations -------------------------------------------------------------
 */

/* T(t) x V(v), of one span, in n unknowns: t the first, v the last. */
static const ix_mv *silhouette(const map *w, ix_pool *q, const ix_mv *span,
                               int n)
{
    const ix_mv *view = ix__pool_unit(q, w->view);
    ix__vec t, v;

    if (!view)
        return NULL;
    t = ix__vec_of(q, span);
    t.x[2] = NULL;
    v = ix__vec_of(q, view);
    v.w = NULL; /* of one sign: a direction has no weight */
    v.x[2] = NULL;
    return ix__vec_cross2(q, ix__vec_promote(q, ix__vec_tangent(q, t, 0), n, 0),
                          ix__vec_promote(q, v, n, n - 1));
}

static void domain_of(const map *w, int span, double dom[2])
{
    dom[0] = w->m.path.breaks[span];
    dom[1] = w->m.path.breaks[span + 1];
}

static ix_status silhouettes_of(map *w, const ix_mv *span, int i)
{
    ix_pool q = {.ctx = w->ctx};
    const ix_mv *f = silhouette(w, &q, span, 2);
    double dom[2][2];
    ix_solution_curves s;
    ix_status st;

    domain_of(w, i, dom[0]);
    ix_mv_domain(w->view, 0, dom[1]);
    IX_TRY(ix__unit_curves(&q, 1, &f, (const double(*)[2])dom, &w->o, &s));
    st = add_curves(w, &s);
    ix_solution_curves_free(w->ctx, &s);
    return st;
}

static ix_status shadows_of(map *w, const ix_mv *span, int i, int j)
{
    ix_pool q = {.ctx = w->ctx};
    const ix_mv *f[2] = {NULL, NULL};
    double dom[3][2];
    ix_solution_curves s;
    ix_status st;
    ix_mv *g;

    IX_TRY(ix__tangent_chords(w->ctx, w->crv, i, j, &g));
    if (!g) /* straight: its tangent is itself */
        return IX_OK;
    f[0] = silhouette(w, &q, span, 3);
    f[1] = ix__pool_promote(&q, g, 3, 0);
    domain_of(w, i, dom[0]);
    domain_of(w, j, dom[1]);
    ix_mv_domain(w->view, 0, dom[2]);
    st = ix__unit_curves(&q, 2, f, (const double(*)[2])dom, &w->o, &s);
    ix_mv_unref(w->ctx, g);
    IX_TRY(st);
    st = add_curves(w, &s);
    ix_solution_curves_free(w->ctx, &s);
    return st;
}

static ix_status solve(map *w)
{
    ix_mv_pieces p;
    ix_status st;

    IX_TRY(ix_mv_to_bezier(w->ctx, w->crv, &p));
    st = (int)p.count == w->m.path.nspans
             ? IX_OK
             : IX_FAIL(w->ctx, IX_EUNABLE, "%zu pieces of %d spans", p.count,
                       w->m.path.nspans);
    for (int i = 0; st == IX_OK && i < (int)p.count; i++)
        st = silhouettes_of(w, p.piece[i], i);
    for (int i = 0; st == IX_OK && i < (int)p.count; i++)
        for (int j = 0; st == IX_OK && j < (int)p.count; j++)
            st = shadows_of(w, p.piece[i], i, j);
    ix_mv_pieces_free(w->ctx, &p);
    return st;
}

static ix_status run(map *w, ix_lines *out)
{
    w->nlines = -1;
    IX_TRY(next_line(w));
    IX_TRY(ix__marks_ends(w->ctx, w->crv, &w->m));
    IX_TRY(ix__path_new(w->ctx, w->view, &w->sight));
    IX_TRY(ix__path_no_poles(w->ctx, &w->sight));
    IX_TRY(solve(w));
    IX_TRY(ix__lines_new(w->ctx, (size_t)w->n, out));
    out->n = w->nlines;
    if (w->n) {
        memcpy(out->count, w->count, (size_t)w->nlines * sizeof *out->count);
        memcpy(out->pt, w->p, (size_t)w->n * sizeof *out->pt);
    }
    return IX_OK;
}

static ix_status open_one(ix_ctx *ctx, const ix_mv *c, ix_mv **out)
{
    ix_status st;
    ix_mv *b;

    IX_TRY(ix_mv_to_bspline(ctx, c, &b));
    st = ix_mv_to_open(ctx, b, out);
    ix_mv_unref(ctx, b);
    return st;
}

ix_status ix_crv_view_map(ix_ctx *ctx, const ix_mv *crv, const ix_mv *view,
                          bool trim, double tol, ix_lines *out)
{
    map w = {.ctx = ctx, .trim = trim, .o = {.tol = tol}};
    ix_mv *c, *v = NULL;
    ix_mark mk;
    ix_status st;

    *out = (ix_lines){0};
    IX_TRY(ix__check_planar(ctx, crv));
    IX_TRY(ix__check_planar(ctx, view));
    IX_TRY(open_one(ctx, crv, &c));
    st = open_one(ctx, view, &v);
    w.crv = c;
    w.view = v;
    mk = ix__scratch_mark(ctx);
    if (st == IX_OK)
        st = run(&w, out);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, v);
    return st;
}
