/* tess_grid.c - the parameters at which a curve or surface is sampled, the same
 * for all patches in a row. Each span is bisected until its pieces need few
 * samples, so that the bounds become sharp; a piece is then cut evenly. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "mv/tess_impl.h"

/* Pieces that need more parts are bisected, down to this depth; near poles no
 * deeper than POLE_DEPTH: there the weight is below 2^-POLE_DEPTH of its
 * largest value, or changes sign. */
enum { PARTS = 2, DEPTH = 12, POLE_DEPTH = 6 };

/* Boxes of pieces, at most. */
#define MOST_BOXES ((size_t)1 << 20)

typedef struct {
    int span, depth;
    double a, b; /* in the span's [0, 1] */
    double e;    /* largest need of its boxes, the piece being [0, 1] */
    int split;   /* to be halved so many times */
    bool pole;
} piece;

typedef struct {
    int n;
    piece *p;
} pieces;

typedef struct {
    ix_ctx *ctx;
    const ix__bernstein *c;
    double tol;
    const int *steps; /* of each direction, instead of the tolerance; or NULL */
    double least;     /* smallest |weight| that is kept, 0 without poles */
    pieces d[2];
    double budget[2]; /* of 8 tol, for each direction */
    int order[2], nspans[2];
    ix__tess_box box;
    double *row;         /* boxes of one piece of direction 0, all spans of 1 */
    unsigned char *pole; /* [d[1].n][d[0].n], of the last round */
    double slope[2];
} gridder;

/* --- boxes ------------------------------------------------------------- */

/* The coefficients of the span's boxes over [a, b] of direction 0:
 * double[nspans of 1][naxes][o1][o0]. */
static void restrict_row(gridder *g, const piece *p)
{
    size_t o0 = (size_t)g->order[0], o1 = (size_t)g->order[1];
    size_t line = (size_t)g->nspans[0] * o0;
    double *out = g->row;

    for (size_t s = 0; s < (size_t)g->nspans[1]; s++)
        for (size_t a = 0; a < (size_t)g->c->m->naxes; a++)
            for (size_t j = 0; j < o1; j++, out += o0)
                ix__bern_restrict(g->order[0] - 1, p->a, p->b, 1,
                                  g->c->coefs + a * g->c->axis +
                                      (s * o1 + j) * line +
                                      (size_t)p->span * o0,
                                  out);
}

static void restrict_box(gridder *g, const piece *q)
{
    size_t plane = (size_t)g->order[0] * (size_t)g->order[1];
    size_t naxes = (size_t)g->c->m->naxes;
    const double *in = g->row + (size_t)q->span * naxes * plane;

    for (size_t a = 0; a < naxes; a++)
        ix__bern_restrict(g->order[1] - 1, q->a, q->b, (size_t)g->order[0],
                          in + a * plane, g->box.net + a * plane);
}

static double width(const gridder *g, int d, const piece *p)
{
    const double *br = d < g->c->m->ndirs ? g->c->sp[d].breaks : NULL;

    return br ? (br[p->span + 1] - br[p->span]) * (p->b - p->a) : 1;
}

/* --- what each box wants ------------------------------------------------ */

/* Halving makes the bounds sharper, too, so that less may do than they ask for
 * now. */
static void want(const gridder *g, piece *p, double e)
{
    double parts = sqrt(e / (4 * g->tol)), levels;

    p->e = fmax(p->e, e);
    if (!(parts > PARTS))
        return;
    levels = fmax(floor(log2(parts / PARTS)) - 1, 1);
    levels = fmin(levels, DEPTH - p->depth);
    if (levels > p->split)
        p->split = (int)levels;
}

static void want_small(piece *p)
{
    if (p->split == 0 && p->depth < POLE_DEPTH)
        p->split = 1;
    p->pole = true;
}

/* Is there a pole, or nearly? Then the pieces are cut, but not sampled for it.
 */
static bool look(gridder *g, piece *p, piece *q)
{
    ix__tess_bound b;
    double e[2];

    restrict_box(g, q);
    if (ix__tess_weights(&g->box, g->least) == IX__TESS_POLE) {
        want_small(p);
        want_small(q);
        return true;
    }
    b = ix__tess_bounds(&g->box);
    g->slope[0] = fmax(g->slope[0], b.u / width(g, 0, p));
    g->slope[1] = fmax(g->slope[1], b.v / width(g, 1, q));
    ix__tess_needs(&b, e);
    want(g, p, e[0]);
    want(g, q, e[1]);
    return false;
}

static void forget(pieces *d)
{
    for (int i = 0; i < d->n; i++) {
        d->p[i].e = 0;
        d->p[i].split = 0;
        d->p[i].pole = false;
    }
}

static ix_status too_fine(const gridder *g)
{
    return IX_FAIL(g->ctx, IX_EUNABLE,
                   "the tolerance %g would need too many points", g->tol);
}

static ix_status look_at_all(gridder *g)
{
    size_t nboxes = (size_t)g->d[0].n * (size_t)g->d[1].n, k = 0;

    if (nboxes > MOST_BOXES)
        return too_fine(g);
    IX_SCRATCH(g->ctx, g->pole, nboxes);
    forget(&g->d[0]);
    forget(&g->d[1]);
    g->slope[0] = g->slope[1] = 0;
    for (int i = 0; i < g->d[0].n; i++) {
        IX_TRY(ix__poll(g->ctx));
        restrict_row(g, &g->d[0].p[i]);
        for (int j = 0; j < g->d[1].n; j++)
            g->pole[k++] = look(g, &g->d[0].p[i], &g->d[1].p[j]);
    }
    return IX_OK;
}

/* --- pieces ------------------------------------------------------------- */

static ix_status first_pieces(gridder *g, int d)
{
    pieces *l = &g->d[d];

    IX_SCRATCH(g->ctx, l->p, g->nspans[d]);
    l->n = g->nspans[d];
    for (int s = 0; s < l->n; s++)
        l->p[s] = (piece){.span = s, .b = 1};
    return IX_OK;
}

/* Piece q as 2^q->split equal ones; returns how many. */
static int put_parts(const piece *q, piece *out)
{
    int n = 1 << q->split;

    for (int i = 0; i < n; i++)
        out[i] = (piece){.span = q->span,
                         .depth = q->depth + q->split,
                         .a = q->a + (q->b - q->a) * i / n,
                         .b = q->a + (q->b - q->a) * (i + 1) / n};
    return n;
}

/* *more: some piece was split. */
static ix_status split(gridder *g, pieces *l, bool *more)
{
    size_t total = 0;
    piece *p;
    int k = 0;

    for (int i = 0; i < l->n; i++)
        total += (size_t)1 << l->p[i].split;
    if (total == (size_t)l->n)
        return IX_OK;
    if (total > MOST_BOXES)
        return too_fine(g);
    *more = true;
    IX_SCRATCH(g->ctx, p, total);
    for (int i = 0; i < l->n; i++)
        k += put_parts(&l->p[i], p + k);
    *l = (pieces){k, p};
    return IX_OK;
}

static ix_status find_pieces(gridder *g)
{
    bool more = true;

    IX_TRY(first_pieces(g, 0));
    IX_TRY(first_pieces(g, 1));
    while (more) {
        more = false;
        IX_TRY(look_at_all(g));
        IX_TRY(split(g, &g->d[0], &more));
        IX_TRY(split(g, &g->d[1], &more));
    }
    return IX_OK;
}

/* --- samples ------------------------------------------------------------ */

/* Bernstein values at t: out[order]; exact at 0 and 1. */
static void basis_at(int order, double t, double *out)
{
    out[0] = 1;
    for (int k = 1; k < order; k++) {
        out[k] = t * out[k - 1];
        for (int i = k - 1; i > 0; i--)
            out[i] = (1 - t) * out[i] + t * out[i - 1];
        out[0] *= 1 - t;
    }
}

static bool jumps(const gridder *g, int d, int s)
{
    return s > 0 && g->c->sp[d].cont[s - 1] < 0;
}

/* A direction that needs less than half of the tolerance in one step leaves the
 * rest to the other. */
static void share_tolerance(gridder *g)
{
    double need[2] = {0, 0}, all = 8 * g->tol;

    for (int d = 0; d < 2; d++)
        for (int i = 0; i < g->d[d].n; i++) {
            const piece *p = &g->d[d].p[i];

            need[d] = fmax(need[d], p->e / ((p->b - p->a) * (p->b - p->a)));
        }
    g->budget[0] = g->budget[1] = all / 2;
    for (int d = 0; d < 2; d++)
        if (need[d] < all / 2) {
            g->budget[d] = need[d] * (1 + 1e-9); /* whatever the rounding */
            g->budget[1 - d] = all - g->budget[d];
            return;
        }
}

/* The longest step in a piece, by its span's parameter. */
static double longest(const gridder *g, int d, const piece *p)
{
    return p->e > 0 ? (p->b - p->a) * sqrt(g->budget[d] / p->e) : 1;
}

/* Equal parts of a piece, p->e being the square of their number. */
static double even_step(const pieces *l, int *i, double t)
{
    const piece *p = &l->p[*i];
    double n = sqrt(p->e), k = floor((t - p->a) / (p->b - p->a) * n + .5) + 1;

    if (k < n)
        return p->a + (p->b - p->a) * (k / n);
    ++*i;
    return p->b;
}

/* The sample after t, which lies in piece *i; both are moved on. Steps may
 * cross from piece to piece, but not at poles. */
static double step(const gridder *g, int d, int *i, double t)
{
    const pieces *l = &g->d[d];
    double reach = HUGE_VAL;
    int k = *i;

    if (g->steps)
        return even_step(l, i, t);
    for (;; k++) {
        const piece *p = &l->p[k], *next = p + 1;
        bool last = k + 1 == l->n || next->span != p->span;

        reach = fmin(reach, t + longest(g, d, p));
        if (reach < p->b && reach > t)
            break;
        if (last || p->pole || next->pole || t + longest(g, d, next) <= p->b) {
            reach = p->b;
            k++;
            break;
        }
    }
    *i = k;
    return reach;
}

static double global_at(const gridder *g, int d, int span, double t)
{
    const double *br = d < g->c->m->ndirs ? g->c->sp[d].breaks + span : NULL;

    return !br ? t : t == 1 ? br[1] : br[0] + (br[1] - br[0]) * t;
}

static ix_status room_for_samples(gridder *g, int d, ix__tess_dir *out)
{
    double total = 1;

    for (int i = 0; i < g->d[d].n; i++)
        total += 2 + (g->d[d].p[i].b - g->d[d].p[i].a) /
                         longest(g, d, &g->d[d].p[i]);
    total += g->nspans[d];
    if (!(total * g->order[d] <= (double)IX__TESS_MOST))
        return IX_FAIL(g->ctx, IX_EUNABLE,
                       "the tolerance %g would need %.3g samples", g->tol,
                       total);
    out->nspans = g->nspans[d];
    IX_SCRATCH(g->ctx, out->t, (size_t)total);
    IX_SCRATCH(g->ctx, out->joined, (size_t)total);
    IX_SCRATCH(g->ctx, out->owner, (size_t)total);
    IX_SCRATCH(g->ctx, out->first, out->nspans);
    IX_SCRATCH(g->ctx, out->last, out->nspans);
    IX_SCRATCH(g->ctx, out->basis,
               ((size_t)total + (size_t)out->nspans) * (size_t)g->order[d]);
    return IX_OK;
}

/* Sample k of span s, at t of it. */
static void put_sample(const gridder *g, int d, ix__tess_dir *out, int s, int k,
                       double t)
{
    out->t[k] = global_at(g, d, s, t);
    basis_at(g->order[d], t,
             out->basis + (size_t)(k + s) * (size_t)g->order[d]);
}

static ix_status put_samples(gridder *g, int d, ix__tess_dir *out)
{
    int k = -1, i = 0;

    IX_TRY(room_for_samples(g, d, out));
    while (i < g->d[d].n) {
        int s = g->d[d].p[i].span;

        k += s == 0 || jumps(g, d, s);
        if (jumps(g, d, s))
            out->joined[k - 1] = false;
        out->first[s] = k;
        put_sample(g, d, out, s, k, 0);
        for (double t = 0; t < 1; k++) {
            out->joined[k] = true;
            out->owner[k] = i;
            t = step(g, d, &i, t);
            put_sample(g, d, out, s, k + 1, t);
        }
        out->last[s] = k;
    }
    out->nsamples = k + 1;
    return IX_OK;
}

/* The direction that a curve lacks: one sample. */
static ix_status put_single(gridder *g, ix__tess_dir *out)
{
    IX_TRY(room_for_samples(g, 1, out));
    put_sample(g, 1, out, 0, 0, 0);
    out->first[0] = out->last[0] = 0;
    out->nsamples = 1;
    return IX_OK;
}

/* --- points ------------------------------------------------------------- */

/* net double[o1][stride] summed by the basis values of both directions. */
static double value_at(const gridder *g, const double *net, size_t stride,
                       const double *bu, const double *bv)
{
    double sum = 0;

    for (int j = 0; j < g->order[1]; j++) {
        const double *row = net + (size_t)j * stride;
        double x = 0;

        if (bv[j] == 0)
            continue;
        for (int i = 0; i < g->order[0]; i++)
            x += bu[i] * row[i];
        sum += bv[j] * x;
    }
    return sum;
}

static void put_point(const gridder *g, const double *net, const double *bu,
                      const double *bv, double *p)
{
    const ix_mv *m = g->c->m;
    size_t stride = (size_t)g->nspans[0] * (size_t)g->order[0];
    double w = m->rational ? value_at(g, net, stride, bu, bv) : 1;

    for (int c = 0; c < 3; c++)
        p[c] = c < g->box.ncoords
                   ? value_at(g, net + (size_t)(c + m->rational) * g->c->axis,
                              stride, bu, bv) /
                         w
                   : 0;
}

/* All samples of the patch at spans s0, s1. */
static void put_patch(const gridder *g, ix__tess_grid *out, int s0, int s1)
{
    const ix__tess_dir *u = &out->d[0], *v = &out->d[1];
    size_t o0 = (size_t)g->order[0], o1 = (size_t)g->order[1];
    const double *net = g->c->coefs +
                        (size_t)s1 * o1 * (size_t)g->nspans[0] * o0 +
                        (size_t)s0 * o0;

    for (int j = v->first[s1]; j <= v->last[s1]; j++)
        for (int i = u->first[s0]; i <= u->last[s0]; i++)
            put_point(g, net, u->basis + (size_t)(i + s0) * o0,
                      v->basis + (size_t)(j + s1) * o1,
                      out->xyz +
                          3 * ((size_t)j * (size_t)u->nsamples + (size_t)i));
}

static ix_status put_points(gridder *g, ix__tess_grid *out)
{
    size_t n0 = (size_t)out->d[0].nsamples, n1 = (size_t)out->d[1].nsamples;

    out->nverts = n0 * n1;
    if (out->nverts > IX__TESS_MOST)
        return IX_FAIL(g->ctx, IX_EUNABLE,
                       "the tolerance %g would need %zu points; the most is "
                       "%zu",
                       g->tol, out->nverts, IX__TESS_MOST);
    IX_SCRATCH(g->ctx, out->xyz, 3 * out->nverts);
    for (int s1 = 0; s1 < g->nspans[1]; s1++) {
        IX_TRY(ix__poll(g->ctx));
        for (int s0 = 0; s0 < g->nspans[0]; s0++)
            put_patch(g, out, s0, s1);
    }
    return IX_OK;
}

static ix_status put_cells(gridder *g, ix__tess_grid *out)
{
    const ix__tess_dir *u = &out->d[0], *v = &out->d[1];
    int n0 = u->nsamples - 1;
    int n1 = v->nsamples > 1 ? v->nsamples - 1 : 1;
    size_t k = 0;

    IX_SCRATCH(g->ctx, out->cell, (size_t)n0 * (size_t)n1);
    for (int j = 0; j < n1; j++)
        for (int i = 0; i < n0; i++, k++) {
            bool flat = v->nsamples == 1;
            bool there = u->joined[i] && (flat || v->joined[j]);
            bool pole = there &&
                        g->pole[(size_t)u->owner[i] * (size_t)g->d[1].n +
                                (size_t)(flat ? 0 : v->owner[j])];

            out->cell[k] = there && !pole;
            out->nleft += pole;
        }
    return IX_OK;
}

/* --- all of it ---------------------------------------------------------- */

static ix_status prepare(gridder *g, const ix__bernstein *c)
{
    const ix_mv *m = c->m;
    size_t plane, row;
    double wmax = 0;

    for (int d = 0; d < 2; d++) {
        g->order[d] = d < m->ndirs ? m->dirs[d].order : 1;
        g->nspans[d] = d < m->ndirs ? c->sp[d].nspans : 1;
    }
    plane = (size_t)g->order[0] * (size_t)g->order[1] * (size_t)m->naxes;
    if (__builtin_mul_overflow(plane, (size_t)g->nspans[1], &row))
        return IX_FAIL(g->ctx, IX_ENOMEM, "%d spans", g->nspans[1]);
    IX_SCRATCH(g->ctx, g->row, row);
    g->box = (ix__tess_box){.o = {g->order[0], g->order[1]},
                            .naxes = m->naxes,
                            .ncoords = m->ncoords < 3 ? m->ncoords : 3,
                            .rational = m->rational};
    IX_SCRATCH(g->ctx, g->box.net, plane);
    if (m->rational)
        IX_SCRATCH(g->ctx, g->box.work, ix__tess_work(&g->box));
    if (ix_mv_has_poles(m)) {
        for (size_t i = 0; i < m->npts; i++)
            wmax = fmax(wmax, fabs(m->pts[i]));
        g->least = ldexp(wmax, -POLE_DEPTH);
    }
    return IX_OK;
}

/* Steps of equal length, as many as the domain's share of each span asks for;
 * straight spans of polynomial curves need only one. The need of a piece is
 * that of such a step. */
static void share_steps(gridder *g)
{
    const ix_mv *m = g->c->m;

    for (int d = 0; d < m->ndirs; d++) {
        const double *br = g->c->sp[d].breaks;
        double all = br[g->nspans[d]] - br[0];

        g->budget[d] = 1;
        for (int i = 0; i < g->d[d].n; i++) {
            piece *p = &g->d[d].p[i];
            double part = (br[p->span + 1] - br[p->span]) / all * (p->b - p->a);
            double n = fmax(ceil(part * g->steps[d] - 1e-9), 1);

            if (m->ndirs == 1 && g->order[d] <= 2 && !m->rational)
                n = 1;
            p->e = n * n;
        }
    }
}

static ix_status make_grid(gridder *g, ix__tess_grid *out)
{
    IX_TRY(prepare(g, g->c));
    IX_TRY(find_pieces(g));
    if (g->steps)
        share_steps(g);
    else
        share_tolerance(g);
    IX_TRY(put_samples(g, 0, &out->d[0]));
    if (g->c->m->ndirs > 1)
        IX_TRY(put_samples(g, 1, &out->d[1]));
    else
        IX_TRY(put_single(g, &out->d[1]));
    IX_TRY(put_points(g, out));
    IX_TRY(put_cells(g, out));
    out->slope[0] = g->slope[0];
    out->slope[1] = g->slope[1];
    return IX_OK;
}

static ix_status grid_of(gridder *g, const ix_mv *m, ix__tess_grid *out)
{
    ix__bernstein c;
    ix_status st;
    ix_mv *cur;

    *out = (ix__tess_grid){0};
    IX_TRY(ix__mv_no_power(g->ctx, m, &cur));
    g->c = &c;
    st = ix__bernstein_of(g->ctx, cur, &c);
    if (st == IX_OK)
        st = make_grid(g, out);
    ix_mv_unref(g->ctx, cur);
    return st;
}

ix_status ix__tess_grid_of(ix_ctx *ctx, const ix_mv *m, double tol,
                           ix__tess_grid *out)
{
    gridder g = {.ctx = ctx, .tol = tol};

    if (!(tol > 0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    return grid_of(&g, m, out);
}

ix_status ix__tess_grid_even(ix_ctx *ctx, const ix_mv *m, const int *steps,
                             ix__tess_grid *out)
{
    gridder g = {.ctx = ctx, .tol = HUGE_VAL, .steps = steps};

    for (int d = 0; d < m->ndirs; d++)
        if (steps[d] < 1)
            return IX_FAIL(ctx, IX_EARG, "%d steps", steps[d]);
    return grid_of(&g, m, out);
}
