/* roots.c - the roots of a piecewise polynomial in one unknown.
 *
 * Every span is solved by itself in its open interior; what happens at the
 * breakpoints is decided from the multiplicities and signs on both sides. A
 * root is thus found once, wherever it lies. */
#include "solve/roots.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "mv/mv.h"
#include "solve/poly_roots.h"

typedef struct {
    ix_root *root;
    int n;
    bool open;  /* the last root is an interval that may still grow */
    int zeros;  /* multiplicity at the right end of the last span */
    int sign;   /* sign just left of it; 0: no span yet, or it vanishes */
    double pad; /* half-width of the enclosure of a root at that end */
} walk;

static void add(walk *w, ix_root_kind kind, double t, double pad, int count,
                int before, int after)
{
    w->root[w->n++] = (ix_root){.kind = kind,
                                .t = t,
                                .lo = t - pad,
                                .hi = t + pad,
                                .count = count,
                                .before = before,
                                .after = after};
}

/* How far from a root of multiplicity m at an end of the span the true ones
 * may be: with m coefficients inside the band, the next one leads, and u with
 * C(d,m) |b_m| u^m <= 4 band bounds them. */
static double end_pad(int d, const double *b, double band, double len, int m,
                      bool right)
{
    double lead = 1;

    if (band == 0 || m == 0)
        return 0;
    if (m > d)
        return len;
    for (int k = 1; k <= m; k++)
        lead *= (double)(d - k + 1) / k;
    lead *= fabs(b[right ? d - m : m]);
    return fmin(pow(4 * band / lead, 1.0 / m), 1) * len;
}

static ix_root_kind kind_of(int mult, int before, int after)
{
    if (before && before == after)
        return IX_ROOT_EVEN;
    return mult == 1 ? IX_ROOT_SIMPLE : IX_ROOT_CLUSTER;
}

/* The breakpoint between two spans that do not vanish, or the domain's start
 * (w->sign == 0). */
static void at_break(walk *w, const ix__poly_roots *r, double x, double pad)
{
    int mult = r->zeros0;

    if (w->sign && w->zeros < mult)
        mult = w->zeros;
    if (mult > 0) {
        ix_root_kind k = kind_of(mult, w->sign, r->sign0);

        if (k == IX_ROOT_EVEN && mult % 2 == 1)
            mult++;
        add(w, k, x, fmax(pad, w->pad), mult, w->sign, r->sign0);
    } else if (w->sign && w->sign != r->sign0) {
        add(w, IX_ROOT_JUMP, x, 0, 0, w->sign, r->sign0);
    } else if (w->sign && (w->zeros > 0 || r->zeros0 > 0)) {
        add(w, IX_ROOT_EVEN, x, 0, 2, w->sign, r->sign0);
    }
}

static void inside(walk *w, const ix__poly_roots *r, double x0, double len)
{
    int sign = r->sign0;

    for (int i = 0; i < r->n; i++) {
        const ix__poly_root *p = &r->root[i];
        int after = p->count % 2 ? -sign : sign;
        ix_root *q = &w->root[w->n];

        add(w, p->count == 1 ? IX_ROOT_SIMPLE : kind_of(p->count, sign, after),
            x0 + p->s * len, 0, p->count, sign, after);
        q->lo = nextafter(fmin(x0 + p->lo * len, q->t), -HUGE_VAL);
        q->hi = nextafter(fmax(x0 + p->hi * len, q->t), HUGE_VAL);
        sign = after;
    }
}

/* A span on which the function is zero. */
static void vanishing(walk *w, double x0, double x1)
{
    if (w->open) {
        w->root[w->n - 1].hi = x1;
        return;
    }
    add(w, IX_ROOT_INTERVAL, x0, 0, 0, w->sign, 0);
    w->root[w->n - 1].hi = x1;
    w->open = true;
}

static void take_span(walk *w, const ix__poly_roots *r, int d, const double *b,
                      double band, const double x[2])
{
    double len = x[1] - x[0];

    if (r->vanishes) {
        vanishing(w, x[0], x[1]);
        w->sign = 0;
        w->zeros = 0;
        return;
    }
    if (w->open)
        w->root[w->n - 1].after = r->sign0;
    else
        at_break(w, r, x[0], end_pad(d, b, band, len, r->zeros0, false));
    w->open = false;
    inside(w, r, x[0], len);
    w->sign = r->sign1;
    w->zeros = r->zeros1;
    w->pad = end_pad(d, b, band, len, r->zeros1, true);
}

ix_status ix__spans_roots(ix_ctx *ctx, const ix_spans *sp, const double *b,
                          const double *band, ix_root **roots, int *n)
{
    walk w = {.n = 0};
    int d = sp->degree;
    size_t room;

    *roots = NULL;
    *n = 0;
    if (__builtin_mul_overflow((size_t)sp->nspans, (size_t)d + 1, &room) ||
        room > INT_MAX - 2)
        return IX_FAIL(ctx, IX_ENOMEM, "%d spans of degree %d", sp->nspans, d);
    IX_SCRATCH(ctx, w.root, room + 2);
    for (int j = 0; j < sp->nspans; j++) {
        const double *bj = b + (size_t)j * ((size_t)d + 1);
        ix_mark mk = ix__scratch_mark(ctx);
        ix__poly_roots r;
        ix_status st = ix__poly_roots_find(ctx, d, bj, band[j], &r);

        if (st == IX_OK)
            take_span(&w, &r, d, bj, band[j], sp->breaks + j);
        ix__scratch_release(ctx, mk);
        IX_TRY(st);
    }
    if (w.sign && w.zeros > 0)
        add(&w, kind_of(w.zeros, 0, 0), sp->breaks[sp->nspans], w.pad, w.zeros,
            w.sign, 0);
    *roots = w.root;
    *n = w.n;
    return IX_OK;
}

/* Bernstein coefficients of one axis; those of a Bezier curve are its own. */
static ix_status take(ix_ctx *ctx, const ix_mv *f, const ix_spans *sp,
                      const double *axis, double *b)
{
    if (f->dirs[0].basis != IX_BEZIER)
        return ix__spans_extract(ctx, &f->dirs[0], sp, 1, 1, axis, b);
    memcpy(b, axis, ((size_t)sp->degree + 1) * sizeof *b);
    return IX_OK;
}

/* Bernstein coefficients of the axis (minus level times the weight). */
static ix_status coefficients(ix_ctx *ctx, const ix_mv *f, int axis,
                              double level, const ix_spans *sp, double *b)
{
    size_t n = (size_t)sp->nspans * ((size_t)sp->degree + 1);
    double *w;

    IX_TRY(take(ctx, f, sp, ix_mv_axis(f, axis), b));
    if (level == 0)
        return IX_OK;
    if (!f->rational) {
        for (size_t i = 0; i < n; i++)
            b[i] -= level;
        return IX_OK;
    }
    IX_SCRATCH(ctx, w, n);
    IX_TRY(take(ctx, f, sp, ix_mv_weights(f), w));
    for (size_t i = 0; i < n; i++)
        b[i] -= level * w[i];
    return IX_OK;
}

/* The decomposition of a B-spline commits about 4 roundings for each of order
 * steps; a Bezier direction is taken as it is. */
static void bands(const ix_mv *f, const ix_spans *sp, const double *b,
                  const ix_root_opts *o, double *band)
{
    size_t m = (size_t)sp->degree + 1;
    double all = 0;

    for (size_t i = 0; i < (size_t)sp->nspans * m; i++)
        all = fmax(all, fabs(b[i]));
    for (int j = 0; j < sp->nspans; j++) {
        double own = 0;

        for (size_t i = 0; i < m; i++)
            own = fmax(own, fabs(b[(size_t)j * m + i]));
        if (f->dirs[0].basis == IX_BEZIER)
            own = 0;
        band[j] = 2 * DBL_EPSILON * (double)m * own + o->error * all;
        if (o->level != 0)
            band[j] += DBL_EPSILON * (fabs(o->level) + own);
    }
}

/* Keeps the roots that meet [lo, hi]; the kept ones move to out. */
static int clip(ix_root *r, int n, double lo, double hi, ix_root *out)
{
    int k = 0;

    for (int i = 0; i < n; i++)
        if (r[i].hi >= lo && r[i].lo <= hi) {
            out[k] = r[i];
            if (r[i].kind == IX_ROOT_INTERVAL) {
                out[k].lo = fmax(out[k].lo, lo);
                out[k].hi = fmin(out[k].hi, hi);
                out[k].t = fmax(out[k].t, lo);
            }
            k++;
        }
    return k;
}

/* The roots that meet [o->lo, o->hi] (none: all), in memory of their own. */
static ix_status keep(ix_ctx *ctx, ix_root *all, int count,
                      const ix_root_opts *o, ix_root **roots, int *n)
{
    ix_root *kept;

    if (o->lo <= o->hi)
        count = clip(all, count, o->lo, o->hi, all);
    if (count == 0)
        return IX_OK;
    kept = ix__alloc(ctx, (size_t)count * sizeof *kept);
    if (!kept)
        return IX_ENOMEM;
    memcpy(kept, all, (size_t)count * sizeof *kept);
    *roots = kept;
    *n = count;
    return IX_OK;
}

/* A Bezier curve as it is: its coefficients are exact. */
static ix_status find_bezier(ix_ctx *ctx, const ix_mv *f, int axis,
                             const ix_root_opts *o, ix_root **roots, int *n)
{
    static const double unit[2] = {0, 1};
    const ix_spans sp = {
        .degree = f->dirs[0].order - 1, .nspans = 1, .breaks = unit};
    const double *b = ix_mv_axis(f, axis);
    double band = 0;
    ix_root *all;
    int count;

    for (int i = 0; o->error > 0 && i <= sp.degree; i++)
        band = fmax(band, o->error * fabs(b[i]));
    IX_TRY(ix__spans_roots(ctx, &sp, b, &band, &all, &count));
    return keep(ctx, all, count, o, roots, n);
}

static ix_status find(ix_ctx *ctx, const ix_mv *f, int axis,
                      const ix_root_opts *o, ix_root **roots, int *n)
{
    double *b, *band;
    ix_root *all;
    ix_spans sp;
    int count;

    if (f->dirs[0].basis == IX_BEZIER && o->level == 0)
        return find_bezier(ctx, f, axis, o, roots, n);
    IX_TRY(ix__spans_of(ctx, &f->dirs[0], &sp));
    IX_SCRATCH(ctx, b, (size_t)sp.nspans * ((size_t)sp.degree + 1));
    IX_SCRATCH(ctx, band, sp.nspans);
    IX_TRY(coefficients(ctx, f, axis, o->level, &sp, b));
    bands(f, &sp, b, o, band);
    IX_TRY(ix__spans_roots(ctx, &sp, b, band, &all, &count));
    return keep(ctx, all, count, o, roots, n);
}

ix_status ix_roots(ix_ctx *ctx, const ix_mv *f, int axis, const ix_root_opts *o,
                   ix_root **roots, int *n)
{
    static const ix_root_opts whole = {.lo = 1, .hi = 0};
    ix_mark mk;
    ix_status st;

    *roots = NULL;
    *n = 0;
    if (f->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "zeros of a function of %d parameters",
                       f->ndirs);
    if (f->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "power basis: convert to Bezier first");
    if (axis < 0 || axis >= f->naxes)
        return IX_FAIL(ctx, IX_EARG, "axis %d of a curve with %d axes", axis,
                       f->naxes);
    mk = ix__scratch_mark(ctx);
    st = find(ctx, f, axis, o ? o : &whole, roots, n);
    ix__scratch_release(ctx, mk);
    return st;
}

void ix_roots_free(ix_ctx *ctx, ix_root *roots, int n)
{
    if (roots)
        ix__free(ctx, roots, (size_t)n * sizeof *roots);
}
