/* planar_spans.c - which spans of two planar curves come close: both are
 * halved together, as long as the boxes of the parts meet. */
#include "geom/planar_spans.h"

#include <float.h>
#include <math.h>

#include "base/grow.h"
#include "mv/mv.h"

/* Relative to the size of the curve: what its coefficients and the comparison
 * of boxes and lines may have rounded, with room. */
#define SLACK 1e-14

/* --- spans
 * ------------------------------------------------------------------------- */

/* One axis less `shift` times the weight, span by span. */
static ix_status load_axis(ix_ctx *ctx, const ix_mv *c, const double *axis,
                           double shift, ix__planar_spans *s, double **out)
{
    const double *w = ix_mv_weights(c);
    const ix_dir *d = &c->dirs[0];
    double *moved;

    IX_SCRATCH(ctx, moved, c->npts);
    for (size_t i = 0; i < c->npts; i++)
        moved[i] = axis[i] - shift * (w ? w[i] : 1);
    if (d->basis == IX_BEZIER) {
        *out = moved;
        return IX_OK;
    }
    s->steps = 4.0 * d->order;
    IX_SCRATCH(ctx, *out, (size_t)s->sp.nspans * (size_t)d->order);
    return ix__spans_extract(ctx, d, &s->sp, 1, 1, moved, *out);
}

static double largest(const double *v, size_t n)
{
    double m = 0;

    for (size_t i = 0; i < n; i++)
        m = fmax(m, fabs(v[i]));
    return m;
}

/* --- boxes
 * ------------------------------------------------------------------------- */

/* Control point i of a span, *sound false where it bounds nothing. */
static inline void point(const ix__planar_spans *s, size_t i, double p[2],
                         bool *sound)
{
    double w = s->w ? s->w[i] : 1;

    *sound &= w > 0;
    p[0] = s->x[0][i] / w;
    p[1] = s->x[1][i] / w;
}

static ix__rect unite(const ix__rect *a, const ix__rect *b)
{
    ix__rect r;

    for (int k = 0; k < 2; k++) {
        r.lo[k] = fmin(a->lo[k], b->lo[k]);
        r.hi[k] = fmax(a->hi[k], b->hi[k]);
    }
    return r;
}

static const ix__rect nothing = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
static const ix__rect all = {{-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL}};

static ix__rect box_of_span(const ix__planar_spans *s, int span)
{
    size_t m = (size_t)s->sp.degree + 1, from = (size_t)span * m;
    ix__rect r = nothing;
    bool sound = true;

    for (size_t i = from; i < from + m; i++) {
        double p[2];

        point(s, i, p, &sound);
        for (int k = 0; k < 2; k++) {
            r.lo[k] = p[k] < r.lo[k] ? p[k] : r.lo[k];
            r.hi[k] = p[k] > r.hi[k] ? p[k] : r.hi[k];
        }
    }
    return sound ? r : all;
}

static ix_status make_tree(ix_ctx *ctx, ix__planar_spans *s)
{
    for (s->leaves = 1; s->leaves < s->sp.nspans;)
        s->leaves *= 2;
    IX_SCRATCH(ctx, s->tree, 2 * (size_t)s->leaves);
    for (int i = 0; i < s->leaves; i++)
        s->tree[s->leaves + i] = i < s->sp.nspans ? box_of_span(s, i) : nothing;
    for (int n = s->leaves - 1; n > 0; n--)
        s->tree[n] = unite(&s->tree[2 * n], &s->tree[2 * n + 1]);
    return IX_OK;
}

static ix_status load(ix_ctx *ctx, const ix_mv *c, const double *shift,
                      ix__planar_spans *s)
{
    size_t n;

    *s = (ix__planar_spans){.wsize = 1};
    IX_TRY(ix__spans_of(ctx, &c->dirs[0], &s->sp));
    n = (size_t)s->sp.nspans * ((size_t)s->sp.degree + 1);
    for (int k = 0; k < 2; k++) {
        IX_TRY(load_axis(ctx, c, ix_mv_coord(c, k), shift[k], s, &s->x[k]));
        s->size[k] = largest(s->x[k], n);
    }
    if (c->rational) {
        IX_TRY(load_axis(ctx, c, ix_mv_weights(c), 0, s, &s->w));
        s->wsize = largest(s->w, n);
    }
    return make_tree(ctx, s);
}

ix_status ix__planar_spans_of(ix_ctx *ctx, const ix_mv *const c[2],
                              ix__planar_spans out[2])
{
    double w = c[0]->rational ? ix_mv_weights(c[0])[0] : 1, shift[2] = {0, 0};

    if (w > 0 &&
        (c[0]->dirs[0].basis != IX_BEZIER || c[1]->dirs[0].basis != IX_BEZIER))
        for (int k = 0; k < 2; k++)
            shift[k] = ix_mv_coord(c[0], k)[0] / w;
    IX_TRY(load(ctx, c[0], shift, &out[0]));
    return load(ctx, c[1], shift, &out[1]);
}

/* --- pairs
 * ------------------------------------------------------------------------- */

typedef struct {
    ix_ctx *ctx;
    const ix__planar_spans *a, *b;
    double slack;
    ix__span_pair *pair;
    int n, cap;
} search;

static bool meet(const search *s, const ix__rect *a, const ix__rect *b)
{
    for (int k = 0; k < 2; k++)
        if (!(a->lo[k] <= b->hi[k] + s->slack &&
              b->lo[k] <= a->hi[k] + s->slack))
            return false;
    return true;
}

/* The range of a span's control points along d, seen from o; everything where
 * a weight is not positive. */
static void along(const ix__planar_spans *s, int span, const double *o,
                  const double *d, double *lo, double *hi)
{
    size_t m = (size_t)s->sp.degree + 1, from = (size_t)span * m;
    bool sound = true;

    *lo = HUGE_VAL;
    *hi = -HUGE_VAL;
    for (size_t i = from; i < from + m; i++) {
        double p[2], v;

        point(s, i, p, &sound);
        v = (p[0] - o[0]) * d[0] + (p[1] - o[1]) * d[1];
        *lo = v < *lo ? v : *lo;
        *hi = v > *hi ? v : *hi;
    }
    if (!sound) {
        *lo = -HUGE_VAL;
        *hi = HUGE_VAL;
    }
}

/* Whether a line along the chord of span i of a separates it from j of b. */
static bool separated(const search *s, const ix__planar_spans *a, int i,
                      const ix__planar_spans *b, int j)
{
    size_t from = (size_t)i * ((size_t)a->sp.degree + 1);
    double p[2], q[2], d[2], len, range[4];
    bool sound = true;

    point(a, from, p, &sound);
    point(a, from + (size_t)a->sp.degree, q, &sound);
    d[0] = p[1] - q[1];
    d[1] = q[0] - p[0];
    len = fabs(d[0]) + fabs(d[1]);
    if (!sound || !(len > 0))
        return false;
    along(a, i, p, d, &range[0], &range[1]);
    along(b, j, p, d, &range[2], &range[3]);
    return range[1] + s->slack * len < range[2] ||
           range[3] + s->slack * len < range[0];
}

static ix_status add(search *s, int i, int j)
{
    IX_GROW(s->ctx, s->pair, s->n, s->cap);
    s->pair[s->n++] = (ix__span_pair){i, j};
    return IX_OK;
}

/* Nodes of both trees, of which that with more spans is halved: the depth is
 * at most that of both, below 64. */
static ix_status descend(search *s, int na, int nb)
{
    bool leaf_a = na >= s->a->leaves, leaf_b = nb >= s->b->leaves;
    bool first;

    if (!meet(s, &s->a->tree[na], &s->b->tree[nb]))
        return IX_OK;
    if (leaf_a && leaf_b) {
        int i = na - s->a->leaves, j = nb - s->b->leaves;

        return separated(s, s->a, i, s->b, j) || separated(s, s->b, j, s->a, i)
                   ? IX_OK
                   : add(s, i, j);
    }
    first = leaf_b || (!leaf_a && na <= nb);
    for (int h = 0; h < 2; h++)
        IX_TRY(first ? descend(s, 2 * na + h, nb) : descend(s, na, 2 * nb + h));
    return IX_OK;
}

ix_status ix__span_pairs(ix_ctx *ctx, const ix__planar_spans *a,
                         const ix__planar_spans *b, const ix__span_pair **out,
                         int *n)
{
    search s = {.ctx = ctx, .a = a, .b = b};

    for (int k = 0; k < 2; k++) {
        const ix__rect *r = &a->tree[1], *q = &b->tree[1];

        s.slack = fmax(s.slack, fmax(fabs(r->lo[k]), fabs(r->hi[k])));
        s.slack = fmax(s.slack, fmax(fabs(q->lo[k]), fabs(q->hi[k])));
    }
    s.slack = s.slack * SLACK + DBL_MIN;
    IX_TRY(descend(&s, 1, 1));
    *out = s.pair;
    *n = s.n;
    return IX_OK;
}
