/* crv_overlap.c - whether two curves run along each other.
 *
 * An overlap of two piecewise curves ends at an end of one of them, or where
 * one of them has a break. So every break of either curve that lies on the
 * other is a candidate; between neighbouring candidates the curves coincide
 * or they do not, which is seen at more places than two curves of their
 * degrees can have in common (Bezout), 64 at most. */
#include <math.h>
#include <stdlib.h>

#include "bsp/spans.h"
#include "iritx/distance.h"
#include "mv/mv.h"

typedef struct {
    ix_ctx *ctx;
    const ix_mv *a, *b;
    double eps;
    int places;
    int n;
    double (*t)[2]; /* candidates: parameters on a and on b */
} pairs;

static ix_status nearest_on(const pairs *p, const ix_mv *from, double t,
                            const ix_mv *to, double *r, double *d)
{
    double x[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(p->ctx, from, &t, x));
    return ix_crv_nearest(p->ctx, to, x, NULL, false, r, d);
}

/* Both ends of `from` and its breaks, where they lie on `to`. */
static ix_status candidates(pairs *p, const ix_mv *from, const ix_mv *to,
                            const ix_spans *sp, bool swap)
{
    for (int i = 0; i <= sp->nspans; i++) {
        double r, d, t = sp->breaks[i];

        IX_TRY(nearest_on(p, from, t, to, &r, &d));
        if (!(d <= p->eps))
            continue;
        p->t[p->n][swap] = t;
        p->t[p->n++][!swap] = r;
    }
    return IX_OK;
}

static int by_first(const void *x, const void *y)
{
    const double *a = x, *b = y;

    return a[0] < b[0] ? -1 : a[0] > b[0];
}

/* A part of a that stays within eps of its start is a point in common, not a
 * run: nearest points of one place are known that well only. */
static ix_status is_point(const pairs *p, double t0, double t1, bool *out)
{
    double x[IX_MAX_COORDS] = {0}, y[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(p->ctx, p->a, &t0, x));
    *out = true;
    for (int i = 1; *out && i <= p->places; i++) {
        double t = t0 + (t1 - t0) * i / p->places, d = 0;

        IX_TRY(ix_mv_point(p->ctx, p->a, &t, y));
        for (int c = 0; c < p->a->ncoords; c++)
            d = hypot(d, y[c] - x[c]);
        *out = d <= p->eps;
    }
    return IX_OK;
}

static ix_status coincide(const pairs *p, double t0, double t1, bool *out)
{
    bool point;

    IX_TRY(is_point(p, t0, t1, &point));
    *out = !point;
    for (int i = 1; *out && i < p->places; i++) {
        double r, d;

        IX_TRY(
            nearest_on(p, p->a, t0 + (t1 - t0) * i / p->places, p->b, &r, &d));
        *out = d <= p->eps;
    }
    return IX_OK;
}

/* Of b: where the overlap begins and ends, from a little inside, as a closed
 * curve passes its seam twice. */
static ix_status ends_on_b(const pairs *p, ix_overlap *o)
{
    double dom[2], len = o->a[1] - o->a[0], d;

    ix_mv_domain(p->b, 0, dom);
    for (int e = 0; e < 2; e++) {
        double t = e ? o->a[1] - len / 256 : o->a[0] + len / 256, r, at;

        IX_TRY(nearest_on(p, p->a, t, p->b, &r, &d));
        IX_TRY(nearest_on(p, p->a, o->a[e], p->b, &at, &d));
        if (fabs(at - r) > (dom[1] - dom[0]) / 2) /* the other end of b */
            at = at - dom[0] < dom[1] - at ? dom[1] : dom[0];
        o->b[e] = at;
    }
    return IX_OK;
}

static bool whole(const ix_mv *m, const double range[2])
{
    double dom[2], lo = fmin(range[0], range[1]), hi = fmax(range[0], range[1]);
    double tie;

    ix_mv_domain(m, 0, dom);
    tie = 1e-6 * (dom[1] - dom[0]);
    return lo - dom[0] <= tie && dom[1] - hi <= tie;
}

/* The longest run of coinciding intervals on a. */
static ix_status longest(const pairs *p, ix_overlap *out)
{
    double from = 0, best = 0, dom[2];
    bool open = false, same;

    ix_mv_domain(p->a, 0, dom);
    for (int i = 0; i + 1 < p->n; i++) {
        double t0 = p->t[i][0], t1 = p->t[i + 1][0];

        if (!(t1 - t0 > 1e-9 * (dom[1] - dom[0])))
            continue;
        IX_TRY(coincide(p, t0, t1, &same));
        if (same && !open)
            from = t0;
        open = same;
        if (same && t1 - from > best) {
            best = t1 - from;
            out->a[0] = from;
            out->a[1] = t1;
        }
    }
    if (!(best > 0))
        return IX_OK;
    IX_TRY(ends_on_b(p, out));
    out->relation = whole(p->a, out->a) && whole(p->b, out->b)
                        ? IX_CRVS_SAME
                        : IX_CRVS_OVERLAP;
    return IX_OK;
}

static ix_status compare(pairs *p, ix_overlap *out)
{
    ix_spans sp[2];
    long common;

    IX_TRY(ix__spans_of(p->ctx, &p->a->dirs[0], &sp[0]));
    IX_TRY(ix__spans_of(p->ctx, &p->b->dirs[0], &sp[1]));
    common = (long)sp[0].degree * sp[1].degree;
    p->places = common < 63 ? (int)common + 2 : 65;
    IX_SCRATCH(p->ctx, p->t, sp[0].nspans + sp[1].nspans + 2);
    IX_TRY(candidates(p, p->a, p->b, &sp[0], false));
    IX_TRY(candidates(p, p->b, p->a, &sp[1], true));
    qsort(p->t, (size_t)p->n, sizeof *p->t, by_first);
    return longest(p, out);
}

ix_status ix_crv_overlap(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                         double eps, ix_overlap *out)
{
    pairs p = {.ctx = ctx, .a = a, .b = b, .eps = eps};

    *out = (ix_overlap){.relation = IX_CRVS_DISTINCT};
    if (a->ndirs != 1 || b->ndirs != 1 || a->dirs[0].basis == IX_POWER ||
        b->dirs[0].basis == IX_POWER || !(eps >= 0))
        return IX_FAIL(ctx, IX_EARG,
                       "%d and %d directions, tolerance %g; two Bezier or "
                       "B-spline curves and a tolerance are wanted",
                       a->ndirs, b->ndirs, eps);
    IX_RETURN_SCOPED(ctx, compare(&p, out));
}
