/* srf_pairs.c - patches of a surface, paired. Closed directions get three
 * spans or more, so that two patches have one edge in common at most. */
#include "geom/srf_pairs.h"

#include <math.h>

#include "bsp/spans.h"
#include "geom/parts.h"

#define JOINED 1e-9 /* of the surface's size: ends that are one curve */

typedef struct {
    ix_mv_pieces p;
    int n[2];
    bool closed[2];
    double (*box)[2][3]; /* [patch]: lo, hi of the control points */
} patches;

/* --- patches ---------------------------------------------------------------
 */

static double coord(const ix_mv *m, int k, size_t i)
{
    if (k >= m->ncoords)
        return 0;
    return ix_mv_coord(m, k)[i] / (m->rational ? ix_mv_weights(m)[i] : 1);
}

/* Largest projected control coordinate. */
static double size_of(const ix_mv *m)
{
    double s = 0;

    for (int k = 0; k < m->ncoords; k++)
        for (size_t i = 0; i < m->npts; i++)
            s = fmax(s, fabs(coord(m, k, i)));
    return s;
}

/* Do both ends of direction d agree, control point by control point? */
static bool is_closed(const ix_mv *m, int d, double size)
{
    size_t n = (size_t)m->dirs[d].length, nu = (size_t)m->dirs[0].length;
    size_t rows = m->npts / n, step = d ? nu : 1, across = d ? 1 : nu;

    for (size_t r = 0; r < rows; r++)
        for (int k = 0; k < m->ncoords; k++) {
            size_t a = r * across, b = a + (n - 1) * step;

            if (!(fabs(coord(m, k, a) - coord(m, k, b)) <= JOINED * size))
                return false;
        }
    return true;
}

/* *m with at least three spans in the closed directions. */
static ix_status split_closed(ix_ctx *ctx, ix_mv **m, const bool closed[2])
{
    for (int d = 0; d < 2; d++) {
        double dom[2], knots[2];
        ix_mv *next;
        ix_spans sp;
        ix_mark mk = ix__scratch_mark(ctx);
        ix_status st = ix__spans_of(ctx, &(*m)->dirs[d], &sp);
        int n = st == IX_OK ? sp.nspans : 0;

        ix__scratch_release(ctx, mk);
        IX_TRY(st);
        if (!closed[d] || n > 2)
            continue;
        ix_mv_domain(*m, d, dom);
        for (int i = 0; i < 2; i++)
            knots[i] = dom[0] + (dom[1] - dom[0]) * (0.3203 + 0.3594 * i);
        IX_TRY(ix__mv_step(ctx, m, &next,
                           ix_mv_insert_knots(ctx, *m, d, 2, knots, &next)));
    }
    return IX_OK;
}

static void measure(const ix_mv *m, double box[2][3])
{
    for (int k = 0; k < 3; k++) {
        box[0][k] = HUGE_VAL;
        box[1][k] = -HUGE_VAL;
        for (size_t i = 0; i < m->npts; i++) {
            double x = coord(m, k, i);

            box[0][k] = fmin(box[0][k], x);
            box[1][k] = fmax(box[1][k], x);
        }
    }
}

static ix_status cut(ix_ctx *ctx, const ix_mv *open, ix__srf_walk *w,
                     patches *ps)
{
    ix_mv *m = ix_mv_ref(open);
    ix_status st;

    w->size = size_of(m);
    for (int d = 0; d < 2; d++) {
        ps->closed[d] = is_closed(m, d, w->size);
        ix_mv_domain(m, d, w->dom[d]);
    }
    IX_TRY(split_closed(ctx, &m, ps->closed));
    st = ix_mv_to_bezier(ctx, m, &ps->p);
    ix_mv_unref(ctx, m);
    IX_TRY(st);
    while ((size_t)ps->n[0] < ps->p.count &&
           ps->p.lo[2 * ps->n[0] + 1] <= ps->p.lo[1])
        ps->n[0]++;
    ps->n[1] = (int)(ps->p.count / (size_t)ps->n[0]);
    ps->box = ix__scratch(ctx, ps->p.count, sizeof *ps->box);
    for (size_t i = 0; ps->box && i < ps->p.count; i++)
        measure(ps->p.piece[i], ps->box[i]);
    return ps->box ? IX_OK : IX_ENOMEM;
}

/* --- pairs -----------------------------------------------------------------
 */

/* 0: the same place, 1: b follows a, -1: a follows b, 2: neither. */
static int step_of(const patches *ps, int d, int a, int b)
{
    int n = ps->n[d];

    if (a == b)
        return 0;
    if (b == a + 1 || (ps->closed[d] && a == n - 1 && b == 0))
        return 1;
    if (a == b + 1 || (ps->closed[d] && b == n - 1 && a == 0))
        return -1;
    return 2;
}

static bool may_meet(const patches *ps, int i, int j, double size)
{
    for (int k = 0; k < 3; k++)
        if (ps->box[i][0][k] > ps->box[j][1][k] + JOINED * size ||
            ps->box[j][0][k] > ps->box[i][1][k] + JOINED * size)
            return false;
    return true;
}

/* m with the edge that the other patch has in common at u = 0; new reference.
 */
static ix_status turn(ix_ctx *ctx, const ix_mv *m, int dir, bool at_end,
                      ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(m), *next;

    if (at_end)
        IX_TRY(
            ix__mv_step(ctx, &cur, &next, ix_mv_reverse(ctx, cur, dir, &next)));
    if (dir == 1)
        IX_TRY(ix__mv_step(ctx, &cur, &next,
                           ix_mv_swap_dirs(ctx, cur, 0, 1, &next)));
    *out = cur;
    return IX_OK;
}

static ix_status visit(ix_ctx *ctx, const ix__srf_walk *w, const patches *ps,
                       int i, int j, ix__srf_pair *p)
{
    const int at[2] = {i, j};
    ix_pool q = {.ctx = ctx};
    ix_mv *m[2] = {NULL};
    ix_status st = IX_OK;

    for (int e = 0; e < 2; e++)
        for (int d = 0; d < 2; d++) {
            p->lo[e][d] = ps->p.lo[2 * at[e] + d];
            p->hi[e][d] = ps->p.hi[2 * at[e] + d];
        }
    for (int e = 0; st == IX_OK && e < 2; e++) {
        const ix_mv *f = ps->p.piece[at[e]];

        if (p->kind == IX__PAIR_EDGE)
            st = turn(ctx, f, p->dir, p->reversed == (e == 0), &m[e]);
        else
            m[e] = ix_mv_ref(f);
    }
    if (st == IX_OK) {
        ix__pair_make(&q, p->kind, m[0], m[1], &p->eq);
        st = q.st;
    }
    if (st == IX_OK)
        st = w->visit(ctx, w->arg, p);
    ix__pool_free(&q);
    ix__mv_unref_all(ctx, m, 2);
    return st;
}

static ix_status one_pair(ix_ctx *ctx, const ix__srf_walk *w, const patches *ps,
                          int i, int j)
{
    int su = step_of(ps, 0, i % ps->n[0], j % ps->n[0]);
    int sv = step_of(ps, 1, i / ps->n[0], j / ps->n[0]);
    ix__srf_pair p = {.kind = IX__PAIR_APART};

    if (i == j)
        p.kind = IX__PAIR_SAME;
    else if (!w->all && !may_meet(ps, i, j, w->size))
        return IX_OK;
    else if (su < 2 && sv < 2)
        p.corner = su && sv;
    if (i == j || p.corner || su == 2 || sv == 2)
        return visit(ctx, w, ps, i, j, &p);
    p.kind = IX__PAIR_EDGE;
    p.dir = su ? 0 : 1;
    p.reversed = (su ? su : sv) == 1; /* the first one ends there */
    IX_TRY(visit(ctx, w, ps, i, j, &p));
    p.reversed = !p.reversed;
    return visit(ctx, w, ps, j, i, &p);
}

static ix_status all_pairs(ix_ctx *ctx, const ix_mv *open, ix__srf_walk *w)
{
    patches ps = {.n = {0}};
    ix_status st = cut(ctx, open, w, &ps);
    int n = (int)ps.p.count;

    for (int i = 0; st == IX_OK && i < n; i++)
        for (int j = i; st == IX_OK && j < n; j++)
            st = one_pair(ctx, w, &ps, i, j);
    ix_mv_pieces_free(ctx, &ps.p);
    return st;
}

ix_status ix__srf_pairs(ix_ctx *ctx, const ix_mv *srf, ix__srf_walk *w)
{
    ix_status st;
    ix_mv *open;

    if (srf->ndirs != 2 || srf->ncoords > 3 || srf->dirs[0].order < 2 ||
        srf->dirs[1].order < 2 || ix__mv_has_basis(srf, IX_POWER))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "surface of at most 3 and orders of 2 or more is wanted",
                       srf->ndirs, srf->ncoords);
    IX_TRY(ix_mv_to_open(ctx, srf, &open));
    st = all_pairs(ctx, open, w); /* scratch stays: visit may keep some */
    ix_mv_unref(ctx, open);
    return st;
}

/* --- the way back ----------------------------------------------------------
 */

static double at(const ix__srf_pair *p, int patch, int d, double t)
{
    double a = p->lo[patch][d], b = p->hi[patch][d];

    return t >= 1 ? b : a + t * (b - a);
}

void ix__srf_pair_map(const ix__srf_pair *p, const double *own, double *out)
{
    if (p->kind != IX__PAIR_EDGE) { /* (u, s, v, t) */
        for (int k = 0; k < 4; k++)
            out[k] = at(p, k / 2, k % 2, own[k / 2 + 2 * (k % 2)]);
        return;
    }
    for (int e = 0; e < 2; e++) { /* (s, m, v, t) */
        double across = e ? own[0] * own[1] : own[0];

        if (p->reversed == (e == 0))
            across = 1 - across;
        out[2 * e + p->dir] = at(p, e, p->dir, across);
        out[2 * e + 1 - p->dir] = at(p, e, 1 - p->dir, own[2 + e]);
    }
}
