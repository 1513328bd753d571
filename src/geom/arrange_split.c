/* arrange_split.c - cutting the curves of an arrangement: at given parameters,
 * corners, places near points, and where curves meet.
 *
 * Every step marks parameters on all curves first, thins the marks, and then
 * cuts once. */
#include <math.h>

#include "geom/arrange_edges.h"
#include "iritx/distance.h"

/* --- marks on all edges
 * ---------------------------------------------------------- */

static ix_status marks_of(ix_ctx *ctx, const ix_arrangement *a, ix__marks **m)
{
    IX_SCRATCH(ctx, *m, a->nedges);
    for (int i = 0; i < a->nedges; i++)
        IX_TRY(ix__marks_ends(ctx, a->edge[i].crv, &(*m)[i]));
    return IX_OK;
}

/* *cut (may be NULL) tells whether anything was cut. */
static ix_status cut_all(ix_ctx *ctx, ix_arrangement *a, ix__marks *m,
                         double tol, bool *cut)
{
    ix__edges l = {.ctx = ctx};
    int before = a->nedges;
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < a->nedges; i++) {
        ix__marks_thin(&m[i], tol);
        st = ix__edges_add_pieces(&l, &a->edge[i], &m[i]);
    }
    if (cut)
        *cut = l.n > before;
    return ix__edges_take(&l, a, st);
}

static ix_status check_tol(ix_ctx *ctx, double tol, bool zero)
{
    if ((tol > 0 || (zero && tol >= 0)) && isfinite(tol))
        return IX_OK;
    return IX_FAIL(ctx, IX_EARG, "a tolerance of %g; it must be %s", tol,
                   zero ? "0 or more" : "positive");
}

/* --- parameters, corners, points
 * ------------------------------------------------- */

static ix_status split_at(ix_ctx *ctx, ix_arrangement *a, int edge, int n,
                          const double *t, double tol)
{
    ix__marks *m;

    IX_TRY(check_tol(ctx, tol, true));
    if (edge < 0 || edge >= a->nedges)
        return IX_FAIL(ctx, IX_EARG, "edge %d of %d", edge, a->nedges);
    IX_TRY(marks_of(ctx, a, &m));
    for (int i = 0; i < n; i++) {
        if (!(t[i] >= m[edge].dom[0] && t[i] <= m[edge].dom[1]))
            return IX_FAIL(ctx, IX_EARG,
                           "parameter %g outside the domain [%g, %g]", t[i],
                           m[edge].dom[0], m[edge].dom[1]);
        IX_TRY(ix__marks_add(&m[edge], t[i]));
    }
    return cut_all(ctx, a, m, tol, NULL);
}

ix_status ix_arrangement_split(ix_ctx *ctx, ix_arrangement *a, int edge, int n,
                               const double *t, double tol)
{
    IX_RETURN_SCOPED(ctx, split_at(ctx, a, edge, n, t, tol));
}

static ix_status corners(ix_ctx *ctx, ix_arrangement *a, double angle)
{
    ix__marks *m;

    if (!(angle >= 0))
        return IX_FAIL(ctx, IX_EARG, "an angle of %g; it must not be negative",
                       angle);
    IX_TRY(marks_of(ctx, a, &m));
    for (int i = 0; i < a->nedges; i++)
        IX_TRY(ix__marks_add_corners(&m[i], angle));
    return cut_all(ctx, a, m, 0, NULL);
}

ix_status ix_arrangement_split_corners(ix_ctx *ctx, ix_arrangement *a,
                                       double angle)
{
    IX_RETURN_SCOPED(ctx, corners(ctx, a, angle));
}

/* Feet of the point at which the distance is least. */
static ix_status mark_near(ix__marks *m, const double p[3], double tol)
{
    const double at[3] = {p[0], p[1], 0};
    ix_root *r;
    ix_status st;
    int n;

    st = ix_crv_feet(m->ctx, m->crv, at, NULL, &r, &n);
    for (int i = 0; st == IX_OK && i < n; i++) {
        double x[IX_MAX_COORDS];

        ix__path_point(&m->path, r[i].t, x);
        if (r[i].kind != IX_ROOT_INTERVAL && r[i].before <= 0 &&
            r[i].after >= 0 && hypot(x[0] - p[0], x[1] - p[1]) <= tol)
            st = ix__marks_add(m, r[i].t);
    }
    ix_roots_free(m->ctx, r, n);
    return st;
}

static ix_status near_points(ix_ctx *ctx, ix_arrangement *a, int n,
                             const double (*p)[3], double tol)
{
    ix__marks *m;

    IX_TRY(check_tol(ctx, tol, true));
    IX_TRY(marks_of(ctx, a, &m));
    for (int i = 0; i < a->nedges; i++)
        for (int k = 0; k < n; k++)
            IX_TRY(mark_near(&m[i], p[k], tol));
    return cut_all(ctx, a, m, a->tol, NULL);
}

ix_status ix_arrangement_split_near(ix_ctx *ctx, ix_arrangement *a, int n,
                                    const double (*p)[3], double tol)
{
    IX_RETURN_SCOPED(ctx, near_points(ctx, a, n, p, tol));
}

/* --- meetings --------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    ix_arrangement *a;
    double tol;
    ix__marks *m;
    double (*box)[4]; /* x from, y from, x to, y to */
    char *same;       /* [n][n]: the two are copies */
} meetings;

static bool apart(const double *p, const double *q, double tol)
{
    return p[0] > q[2] + tol || q[0] > p[2] + tol || p[1] > q[3] + tol ||
           q[1] > p[3] + tol;
}

static ix_status load(meetings *w)
{
    int n = w->a->nedges;

    IX_TRY(marks_of(w->ctx, w->a, &w->m));
    IX_SCRATCH(w->ctx, w->box, n);
    IX_SCRATCH_ZERO(w->ctx, w->same, (size_t)n * (size_t)n);
    for (int i = 0; i < n; i++)
        IX_TRY(ix_mv_bbox(w->ctx, w->a->edge[i].crv, w->box[i], w->box[i] + 2));
    return IX_OK;
}

/* Is no part of the curve beyond the two parameters longer than tol? */
static ix_status covers(const meetings *w, int i, const double ends[2],
                        bool *out)
{
    ix__marks m;

    IX_TRY(ix__marks_ends(w->ctx, w->a->edge[i].crv, &m));
    IX_TRY(ix__marks_add(&m, ends[0]));
    IX_TRY(ix__marks_add(&m, ends[1]));
    ix__marks_thin(&m, w->tol);
    *out = m.n == 2;
    return IX_OK;
}

/* The longest part that two curves have in common, and whether that is all of
 * both. */
static ix_status common(const meetings *w, int i, int j, ix_overlap *o,
                        bool *same)
{
    bool all[2];

    IX_TRY(ix_crv_overlap(w->ctx, w->a->edge[i].crv, w->a->edge[j].crv, w->tol,
                          o));
    *same = o->relation == IX_CRVS_SAME;
    if (o->relation != IX_CRVS_OVERLAP)
        return IX_OK;
    IX_TRY(covers(w, i, o->a, &all[0]));
    IX_TRY(covers(w, j, o->b, &all[1]));
    *same = all[0] && all[1];
    return IX_OK;
}

static ix_status overlap(meetings *w, int i, int j)
{
    ix_overlap o;
    bool same;

    IX_TRY(common(w, i, j, &o, &same));
    if (same)
        w->same[(size_t)i * (size_t)w->a->nedges + (size_t)j] = 1;
    for (int e = 0; !same && o.relation == IX_CRVS_OVERLAP && e < 2; e++) {
        IX_TRY(ix__marks_add(&w->m[i], o.a[e]));
        IX_TRY(ix__marks_add(&w->m[j], o.b[e]));
    }
    return IX_OK;
}

/* Cuts at the ends of overlaps until each pair of curves is the same, or runs
 * together nowhere. Of a pair with several overlaps one goes in each round. The
 * last round, which cuts nothing, leaves w as the next step needs it. */
static ix_status cut_overlaps(meetings *w)
{
    bool cut = true;

    for (int round = 0; cut; round++) {
        if (round == 100)
            return IX_FAIL(w->ctx, IX_EUNABLE,
                           "curves still run together after %d cuts", round);
        IX_TRY(load(w));
        for (int i = 0; i < w->a->nedges; i++)
            for (int j = i + 1; j < w->a->nedges; j++) {
                IX_TRY(ix__poll(w->ctx));
                if (!apart(w->box[i], w->box[j], w->tol))
                    IX_TRY(overlap(w, i, j));
            }
        IX_TRY(cut_all(w->ctx, w->a, w->m, w->tol, &cut));
    }
    return IX_OK;
}

static ix_status mark_pairs(meetings *w, int i, int j, const ix_solutions *s)
{
    if (!s->complete)
        return IX_FAIL(w->ctx, IX_EUNABLE,
                       "where curves %d and %d meet is not known completely: "
                       "they run together, or nearly",
                       i + 1, j + 1);
    for (int k = 0; k < s->n; k++) {
        double p[IX_MAX_COORDS], q[IX_MAX_COORDS];
        const double *x = s->sol[k].x;

        ix__path_point(&w->m[i].path, x[0], p);
        ix__path_point(&w->m[j].path, x[1], q);
        if (!(hypot(p[0] - q[0], p[1] - q[1]) <= w->tol))
            continue; /* a box that could not be decided */
        IX_TRY(ix__marks_add(&w->m[i], x[0]));
        IX_TRY(ix__marks_add(&w->m[j], x[1]));
    }
    return IX_OK;
}

static ix_status crossings(meetings *w, int i, int j)
{
    const ix_mv *a = w->a->edge[i].crv, *b = w->a->edge[j].crv;
    ix_solutions s;
    ix_status st;

    if (i == j)
        IX_TRY(ix_crv_self_meet(w->ctx, a, &s));
    else
        IX_TRY(ix_crv_crv_meet(w->ctx, a, b, NULL, &s));
    st = mark_pairs(w, i, j, &s);
    ix_solutions_free(w->ctx, &s);
    return st;
}

/* Ends of i on j. */
static ix_status end_on(meetings *w, int i, int j)
{
    for (int e = 0; e < 2; e++) {
        double p[IX_MAX_COORDS] = {0}, box[4], t, d;

        ix__path_point(&w->m[i].path, w->m[i].dom[e], p);
        for (int k = 0; k < 4; k++)
            box[k] = p[k % 2];
        if (apart(box, w->box[j], w->tol))
            continue;
        IX_TRY(
            ix_crv_nearest(w->ctx, w->a->edge[j].crv, p, NULL, false, &t, &d));
        if (d <= w->tol)
            IX_TRY(ix__marks_add(&w->m[j], t));
    }
    return IX_OK;
}

static ix_status cut_meetings(meetings *w)
{
    int n = w->a->nedges;

    for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++) {
            if (apart(w->box[i], w->box[j], w->tol) ||
                w->same[(size_t)i * (size_t)n + (size_t)j])
                continue;
            IX_TRY(crossings(w, i, j));
            if (i != j) {
                IX_TRY(end_on(w, i, j));
                IX_TRY(end_on(w, j, i));
            }
        }
    return cut_all(w->ctx, w->a, w->m, w->tol, NULL);
}

/* On a copy, as it goes in several steps. */
static ix_status on_copy(ix_ctx *ctx, ix_arrangement *a, double tol,
                         ix_status (*step)(meetings *w))
{
    meetings w = {.ctx = ctx, .tol = tol};
    ix_arrangement *b, old;
    ix_status st;

    IX_TRY(ix_arrangement_copy(ctx, a, &b));
    w.a = b;
    st = step(&w);
    if (st == IX_OK) { /* exchange: the old one is freed */
        b->tol = fmax(a->tol, tol);
        old = *a;
        *a = *b;
        *b = old;
    }
    ix_arrangement_free(ctx, b);
    return st;
}

static ix_status all_meetings(meetings *w)
{
    IX_TRY(cut_overlaps(w));
    return cut_meetings(w);
}

static ix_status no_overlaps(meetings *w)
{
    IX_TRY(cut_overlaps(w));
    return ix_arrangement_drop_copies(w->ctx, w->a, w->tol);
}

ix_status ix_arrangement_split_meetings(ix_ctx *ctx, ix_arrangement *a,
                                        double tol)
{
    IX_TRY(check_tol(ctx, tol, false));
    IX_RETURN_SCOPED(ctx, on_copy(ctx, a, tol, all_meetings));
}

ix_status ix_arrangement_drop_overlaps(ix_ctx *ctx, ix_arrangement *a,
                                       double tol)
{
    IX_TRY(check_tol(ctx, tol, false));
    IX_RETURN_SCOPED(ctx, on_copy(ctx, a, tol, no_overlaps));
}

/* --- copies ----------------------------------------------------------------
 */

static ix_status fold_copies(meetings *w, ix__edges *l)
{
    int n = w->a->nedges, *turns;
    char *gone;

    IX_SCRATCH_ZERO(w->ctx, gone, n);
    IX_SCRATCH(w->ctx, turns, n);
    for (int i = 0; i < n; i++)
        turns[i] = w->a->edge[i].turns;
    for (int i = 0; i < n; i++) {
        for (int j = i + 1; !gone[i] && j < n; j++) {
            ix_overlap o;
            bool same;

            if (gone[j] || apart(w->box[i], w->box[j], w->tol))
                continue;
            IX_TRY(common(w, i, j, &o, &same));
            if (!same)
                continue;
            gone[j] = 1;
            turns[i] += o.b[0] <= o.b[1] ? turns[j] : -turns[j];
        }
        if (!gone[i])
            IX_TRY(ix__edges_add(l, ix_mv_ref(w->a->edge[i].crv),
                                 w->a->edge[i].source, turns[i]));
    }
    return IX_OK;
}

static ix_status drop_copies(ix_ctx *ctx, ix_arrangement *a, double tol)
{
    meetings w = {.ctx = ctx, .a = a, .tol = tol};
    ix__edges l = {.ctx = ctx};
    ix_status st = load(&w);

    if (st == IX_OK)
        st = fold_copies(&w, &l);
    return ix__edges_take(&l, a, st);
}

ix_status ix_arrangement_drop_copies(ix_ctx *ctx, ix_arrangement *a, double tol)
{
    IX_TRY(check_tol(ctx, tol, true));
    IX_RETURN_SCOPED(ctx, drop_copies(ctx, a, tol));
}
