/* march.c - the search for long pieces: first to the end of the present span;
 * if that is good, over ever more whole spans, then bisection on their number;
 * if it is not, shorter by the ratio that the order of convergence suggests. */
#include "geom/march.h"

#include <math.h>

int ix__path_span_left(const ix_path *p, double t1)
{
    int s = ix__path_span(p, t1);

    return s > 0 && p->breaks[s] >= t1 ? s - 1 : s;
}

/* By how much a piece with this error should shrink to be good; 0.95: not to
 * miss it again. */
static double shrinkage(const ix_march *m, double err)
{
    double f = isfinite(err) ? 0.95 * pow(m->tol / err, 1.0 / m->order) : 0.5;

    return f > 0.1 ? f : 0.1;
}

/* A good end inside the span (t, t1], where t1 itself is not good. */
static ix_status within(ix_ctx *ctx, const ix_march *m, double t, double err,
                        double *t1)
{
    double whole = *t1 - t;

    while (err > m->tol || isnan(err)) {
        *t1 = t + (*t1 - t) * shrinkage(m, err);
        if (!(*t1 - t > ldexp(whole, -30)))
            return IX_FAIL(ctx, IX_EUNABLE,
                           "error %g near parameter %g where %g is asked for",
                           err, t, m->tol);
        err = m->try(m->arg, t, *t1);
    }
    return IX_OK;
}

/* The furthest break that is good, between good (which is) and the end of the
 * run: doubles the number of spans, then bisects. */
static int furthest(const ix_march *m, double t, int good, int last)
{
    int step = 1, bad = last + 1;

    while (good < last && bad > last) {
        int next = good + step < last ? good + step : last;

        if (m->try(m->arg, t, m->p->breaks[next]) <= m->tol)
            good = next;
        else
            bad = next;
        step *= 2;
    }
    while (bad - good > 1) {
        int mid = good + (bad - good) / 2;

        if (m->try(m->arg, t, m->p->breaks[mid]) <= m->tol)
            good = mid;
        else
            bad = mid;
    }
    return good;
}

/* From break `first` to break `last`, between which there is no corner. */
static ix_status run(ix_ctx *ctx, const ix_march *m, int first, int last)
{
    const double *b = m->p->breaks;
    double t = b[first];

    while (t < b[last]) {
        int s = ix__path_span(m->p, t);
        double t1 = b[s + 1], err = m->try(m->arg, t, t1);

        IX_TRY(ix__poll(ctx));
        if (err <= m->tol)
            t1 = b[furthest(m, t, s + 1, last)];
        else
            IX_TRY(within(ctx, m, t, err, &t1));
        IX_TRY(m->keep(ctx, m->arg, t, t1));
        t = t1;
    }
    return IX_OK;
}

ix_status ix__march(ix_ctx *ctx, const ix_march *m)
{
    for (int s = 0; s < m->p->nspans;) {
        int corner = ix__path_corner(m->p, s + 1);

        IX_TRY(run(ctx, m, s, corner));
        s = corner;
    }
    return IX_OK;
}
