/* plane_runs.c - where else to look, and runs of samples on which nothing
 * changes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "ops/plane_walk_impl.h"

/* Pieces that were found lead to others; so often at most. */
enum { ROUNDS = 8 };
/* Where to look is found with this tolerance, if a smaller one is wanted. */
#define COARSE 1e-4
/* What a vertex takes: its sample, itself, its distance and feet. */
#define BYTES_EACH    220.0
#define MOST_VERTICES 1e7

/* --- seeds -----------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    int n, room;
    ix__place *p;
} places;

static ix_status add_place(places *l, ix__place p)
{
    IX_GROW(l->ctx, l->p, l->n, l->room);
    l->p[l->n++] = p;
    return IX_OK;
}

static int by_place(const void *a, const void *b)
{
    const ix__place *p = a, *q = b;

    if (p->border != q->border)
        return p->border < q->border ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

/* Places of the own border that are seen from the other one. */
static ix_status seeds_from_other(ix_ctx *ctx, const ix__walk *w, places *l)
{
    ix__walk back = {w->other, w->own, w->tol, w->grid, w->meeting, w->size};
    ix__sample s;
    ix__place p;

    for (int i = 0; i < w->other->nborders; i++)
        for (int j = 0; j <= w->grid; j++) {
            IX_TRY(ix__poll(ctx));
            ix__walk_sample(&back, i, (double)j / w->grid, &s);
            if (s.valid && ix__border_place(w->own, &s.foot, s.b, &p))
                IX_TRY(add_place(l, p));
        }
    return IX_OK;
}

/* --- runs ------------------------------------------------------------------
 */

/* Is there a corner without a fan, of less than 180 degrees, between two sides?
 * However shallow it is, no circle touches there. */
static bool at_corner(const ix__walk *w, const ix__sample *a,
                      const ix__sample *b)
{
    const ix__border *e = &w->own->border[a->border];

    return a->border != b->border && e->kind == IX__SIDE &&
           w->own->span[e->index].vertex[e->side > 0] >= 0;
}

static bool joins(const ix__walk *w, const ix__sample *a, const ix__sample *b)
{
    const ix__border *ea = &w->own->border[a->border];
    const ix__border *eb = &w->own->border[b->border];

    if (!a->valid || !b->valid || a->cut || !ix__same_feet(w, a, b) ||
        ix__walk_turns(w, a, b) || ix__passes_seam(w, a, b) ||
        at_corner(w, a, b))
        return false;
    if (ea->kind != eb->kind)
        return false;
    return ea->kind == IX__SIDE || ea->index == eb->index;
}

bool ix__centres_meet(const ix__sample *a, const ix__sample *b)
{
    double tol = ix__near_feet(a) || ix__near_feet(b) ? 1e-6 : 1e-7;

    return hypot(a->b[0] - b->b[0], a->b[1] - b->b[1]) <=
           tol * fmax(1.0, a->b[0] * a->b[0] + a->b[1] * a->b[1]);
}

/* Length along the samples: runs between two neighbours in double are none, nor
 * those at infinity that are one place of the border, nor those that rounding
 * makes of a place where both feet come together. */
static bool has_length(const ix__walked *o, const ix__run *r)
{
    const ix__sample *first = ix__run_at(o, r, 0);
    const ix__sample *last = ix__run_at(o, r, r->count - 1);
    bool vague = ix__near_feet(first) && !first->own_circle && first->r > 1e-6;
    double len = 0.0, least = vague ? 1e-7 : 1e-11;

    if (first->normal)
        return true;
    /* one that goes all the way round ends before its beginning */
    if (first->border == last->border && last->at >= first->at &&
        last->at - first->at <= 1e-12)
        return false;
    for (int i = 1; i < r->count && len <= least; i++) {
        const ix__sample *b = ix__run_at(o, r, i);

        len = fmax(len, hypot(b->b[0] - first->b[0], b->b[1] - first->b[1]));
    }
    return len > least;
}

/* A run without length at infinity is the end of that before or behind it.
 * *gap: whether the run before r was such a one. */
static ix_status add_run(ix_ctx *ctx, ix__walked *o, ix__run r, bool *gap)
{
    ix__run *before = o->nruns ? &o->run[o->nruns - 1] : NULL;
    int n = o->loop[r.loop].n;

    r.far[0] = r.far[0] || *gap;
    *gap = false;
    if (!has_length(o, &r)) {
        *gap = r.far[0];
        if (r.far[1] && before && before->loop == r.loop &&
            (before->first + before->count) % n == r.first)
            before->far[1] = true;
        return IX_OK;
    }
    if (before && before->loop == r.loop)
        r.joined = !before->far[1] && !r.far[0] &&
                   ix__centres_meet(ix__run_at(o, before, before->count - 1),
                                    ix__run_at(o, &r, 0));
    IX_GROW(ctx, o->run, o->nruns, o->room);
    o->run[o->nruns++] = r;
    return IX_OK;
}

/* Sample i, counted around. */
static const ix__sample *around(const ix__samples *s, int i)
{
    return ix__sample_at(s, i % s->n);
}

/* Where to begin: behind a place at infinity, else behind any break. */
static int beginning(const ix__walk *w, const ix__samples *s)
{
    int at = 0, n = s->n;

    for (int i = 0; i < n; i++)
        if (around(s, i)->far && around(s, i + 1)->valid)
            return (i + 1) % n;
    for (int i = 0; i < n; i++)
        if (!around(s, i)->valid && around(s, i + 1)->valid)
            return (i + 1) % n;
    for (int i = 0; i < n; i++)
        if (!joins(w, around(s, i), around(s, i + 1)))
            at = (i + 1) % n;
    return at;
}

/* Does the centre go to infinity between end and what is next to it? Where a
 * curve turns back it jumps there. */
static bool goes_far(const ix__sample *end, const ix__sample *next)
{
    return next->far && end->r > IX__FAR;
}

static ix_status runs_of_loop(ix_ctx *ctx, const ix__walk *w, int loop,
                              ix__walked *o)
{
    const ix__samples *s = &o->loop[loop];
    int n = s->n, i = 0, begin;
    bool gap = false;

    if (n == 0)
        return IX_OK;
    begin = beginning(w, s);
    while (i < n) {
        ix__run r = {.first = (begin + i) % n, .count = 1, .loop = loop};

        if (!around(s, r.first)->valid) {
            gap = false;
            i++;
            continue;
        }
        while (i + r.count < n && joins(w, around(s, r.first + r.count - 1),
                                        around(s, r.first + r.count)))
            r.count++;
        r.far[0] = goes_far(around(s, r.first), around(s, r.first + n - 1));
        r.far[1] = goes_far(around(s, r.first + r.count - 1),
                            around(s, r.first + r.count));
        IX_TRY(add_run(ctx, o, r, &gap));
        i += r.count;
    }
    return IX_OK;
}

/* Is m, between two samples of a run, what they lead to expect? */
static bool as_expected(const ix__walk *w, const ix__sample *a,
                        const ix__sample *m, const ix__sample *b)
{
    double d[2] = {b->b[0] - a->b[0], b->b[1] - a->b[1]};
    double e[2] = {m->b[0] - a->b[0], m->b[1] - a->b[1]};
    double len = hypot(d[0], d[1]), tol = 2.0 * ix__walk_room(w, m);

    if (!m->valid || !ix__same_feet(w, a, m))
        return false;
    return hypot(e[0], e[1]) <= len + tol &&
           fabs(d[0] * e[1] - d[1] * e[0]) <= tol * fmax(len, tol);
}

/* Is what is at that place known from the samples around it? */
static bool explored(const ix__walk *w, const ix__walked *o, ix__place p)
{
    ix__sample s;

    ix__walk_sample(w, p.border, p.at, &s);
    for (int i = 0; i < o->nloops; i++) {
        const ix__loop *l = &w->own->loop[i];
        const ix__samples *at = &o->loop[i];
        int lo = 0, hi = at->n - 1;

        if (p.border < l->first || p.border >= l->first + l->count || hi < 1)
            continue;
        while (hi - lo > 1) {
            int m = (lo + hi) / 2;
            const ix__sample *a = ix__sample_at(at, m);
            ix__place q = {a->border, a->at};

            if (by_place(&q, &p) <= 0)
                lo = m;
            else
                hi = m;
        }
        if (joins(w, ix__sample_at(at, lo), ix__sample_at(at, hi)))
            return as_expected(w, ix__sample_at(at, lo), &s,
                               ix__sample_at(at, hi));
    }
    return !s.valid;
}

/* Places around p on which nothing is known; *added counts them. The place
 * itself is where three feet are equally far, known to 1e-7 where the circle
 * touches at the end of one of the curves. */
static ix_status unexplored(const ix__walk *w, const ix__walked *o, ix__place p,
                            places *l, int *added)
{
    static const double step[] = {0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3};

    for (size_t i = 0; i < sizeof step / sizeof *step; i++) {
        ix__place q = {p.border, p.at + step[i]};

        if (!(q.at > 0.0 && q.at < 1.0) || explored(w, o, q))
            continue;
        IX_TRY(add_place(l, q));
        ++*added;
    }
    return IX_OK;
}

/* Where the own set blocks, the bisector goes on from what blocks it. */
static ix_status seeds_from_blocks(const ix__walk *w, const ix__walked *o,
                                   int loop, places *l, int *added)
{
    const ix__samples *s = &o->loop[loop];

    for (int i = 0; i < s->n; i++) {
        const ix__sample *a = around(s, i), *b = around(s, i + 1), *bad, *good;
        ix__place p;

        if (a->valid == b->valid)
            continue;
        good = a->valid ? a : b;
        bad = a->valid ? b : a;
        if (bad->blocked && ix__border_place(w->own, &bad->foot, good->b, &p))
            IX_TRY(unexplored(w, o, p, l, added));
    }
    return IX_OK;
}

static ix_status walk_loops(ix_ctx *ctx, const ix__walk *w, places *seeds,
                            ix__walked *out)
{
    if (seeds->n)
        qsort(seeds->p, (size_t)seeds->n, sizeof *seeds->p, by_place);
    for (int i = 0; i < out->nloops; i++)
        IX_TRY(ix__walk_loop(ctx, w, i, seeds->n, seeds->p, &out->loop[i]));
    out->nruns = 0;
    for (int i = 0; i < out->nloops; i++)
        IX_TRY(runs_of_loop(ctx, w, i, out));
    return IX_OK;
}

/* Walks all loops until what was found leads to nothing else. */
static ix_status explore(ix_ctx *ctx, const ix__walk *w, places *seeds,
                         ix__walked *out)
{
    IX_TRY(walk_loops(ctx, w, seeds, out));
    for (int i = 0; w->own != w->other && i < ROUNDS; i++) {
        int added = 0;

        for (int j = 0; j < out->nloops; j++)
            IX_TRY(seeds_from_blocks(w, out, j, seeds, &added));
        if (added == 0)
            break;
        IX_TRY(walk_loops(ctx, w, seeds, out));
    }
    return IX_OK;
}

/* How many vertices runs need that were found with a larger tolerance: the
 * error of a chord falls with the square of its length, and halving gives
 * chords that are up to half as long as need be. */
static double vertices_needed(const ix__walk *w, const ix__walked *coarse)
{
    const double halving = 1.7;
    double n = 0.0;

    for (int i = 0; i < coarse->nruns; i++)
        for (int j = 0; j + 1 < coarse->run[i].count; j++) {
            const ix__sample *a = ix__run_at(coarse, &coarse->run[i], j);
            const ix__sample *b = ix__run_at(coarse, &coarse->run[i], j + 1);

            n += fmax(1.0, halving * sqrt(ix__walk_share(w, a, b)));
        }
    return n;
}

/* Are they too many, for the context's memory too? */
static ix_status check_amount(ix_ctx *ctx, const ix__walk *w,
                              const ix__walked *coarse)
{
    double n = vertices_needed(w, coarse), most = MOST_VERTICES;

    if (ctx->limit)
        most = fmin(most, (double)(ctx->limit - ctx->live) / BYTES_EACH);
    if (!(n <= most))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "a tolerance of %g takes %.2f million vertices, %.2f "
                       "are possible: %.1g would do, and BISECTEVAL gives "
                       "exact points between those of any tolerance",
                       w->tol, 1e-6 * n, 1e-6 * most,
                       w->tol * pow(1.1 * n / most, 2.0));
    return IX_OK;
}

ix_status ix__walk_all(ix_ctx *ctx, const ix__walk *w, int nseeds,
                       const ix__place *first, ix__walked *out)
{
    places seeds = {.ctx = ctx};
    ix__walk coarse = *w;

    *out = (ix__walked){.nloops = w->own->nloops};
    IX_SCRATCH(ctx, out->loop, out->nloops);
    for (int i = 0; i < nseeds; i++)
        IX_TRY(add_place(&seeds, first[i]));
    if (w->own != w->other)
        IX_TRY(seeds_from_other(ctx, w, &seeds));
    if (w->tol < COARSE) { /* where to look is found with fewer vertices */
        coarse.tol = COARSE;
        IX_TRY(explore(ctx, &coarse, &seeds, out));
        IX_TRY(check_amount(ctx, w, out));
    }
    return explore(ctx, w, &seeds, out);
}
