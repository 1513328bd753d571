/* ruled_rulings.c - see the header. The surface is sampled so finely that the
 * points between the ends of every candidate are samples too. */
#include "geom/ruled_rulings.h"

#include <math.h>

#include "geom/monotone.h"
#include "geom/vec3.h"

/* Points of the surface: row k at the fraction k / fine between the sides, each
 * of fine (n - 1) + 1 points. */
typedef struct {
    int n, fine;
    const double (*p)[3];
} table;

static const double *at(const table *s, int row, int i)
{
    return s->p[(size_t)row * (size_t)(s->fine * (s->n - 1) + 1) + (size_t)i];
}

/* Minus the mean squared distance of the surface from the ruling (i, j). */
static double worth(const void *arg, int i, int j)
{
    const table *s = arg;
    const double *a = at(s, 0, s->fine * i), *b = at(s, s->fine, s->fine * j);
    double e[3] = {0, 0, 0}, d[3], sum = 0;

    ix__sub3(b, a, d);
    ix__unit3(d, e);
    for (int k = 1; k < s->fine; k++) {
        ix__sub3(at(s, k, (s->fine - k) * i + k * j), a, d);
        ix__axpy3(d, -ix__dot3(d, e), e, d);
        sum += ix__dot3(d, d);
    }
    return -sum / (s->fine - 1);
}

static void even(const ix_mv *s, int dir, int n, double *t)
{
    double dom[2];

    ix_mv_domain(s, dir, dom);
    for (int i = 0; i < n; i++)
        t[i] = i == n - 1 ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / (n - 1);
}

static ix_status sample(ix_ctx *ctx, const ix_mv *s, table *out)
{
    int count[2] = {out->fine * (out->n - 1) + 1, out->fine + 1};
    size_t n = (size_t)count[0] * (size_t)count[1];
    double *t[2], *axes, (*p)[3];

    for (int d = 0; d < 2; d++) {
        IX_SCRATCH(ctx, t[d], count[d]);
        even(s, d, count[d], t[d]);
    }
    IX_SCRATCH(ctx, axes, n * (size_t)s->naxes);
    IX_SCRATCH(ctx, p, n);
    IX_TRY(ix_mv_eval_grid(ctx, s, count, (const double *const *)t, axes));
    for (size_t i = 0; i < n; i++) {
        double w = s->rational ? axes[i] : 1;

        for (int c = 0; c < 3; c++)
            p[i][c] = c < s->ncoords
                          ? axes[(size_t)(c + s->rational) * n + i] / w
                          : 0;
        if (!isfinite(p[i][0] + p[i][1] + p[i][2]))
            return IX_FAIL(ctx, IX_EDOMAIN, "the surface has a pole");
    }
    out->p = (const double(*)[3])p;
    return IX_OK;
}

/* lean[k] = j - i of the way where i + j = lo + k, linear over steps of both.
 */
static void leans(int n, const int *i, const int *j, double *lean)
{
    int lo = i[0] + j[0];

    for (int k = 0; k < n; k++) {
        int at = i[k] + j[k] - lo;

        lean[at] = j[k] - i[k];
        if (k > 0 && i[k] + j[k] - i[k - 1] - j[k - 1] == 2)
            lean[at - 1] = (lean[at - 2] + lean[at]) / 2;
    }
}

/* The way freed of its steps: leans are means over up to w neighbours on each
 * side, fewer at the ends, which stay. A mean changes no faster than what it is
 * of, so that no rulings cross. Place i has the parameter u0 + i step. */
static void smooth(int w, int lo, int n, const double *lean, double u0,
                   double step, ix__rulings *out)
{
    out->n = n;
    for (int k = 0; k < n; k++) {
        int m = k < n - 1 - k ? k : n - 1 - k;
        double sum = 0, mid = lo + k;

        m = m < w ? m : w;
        for (int q = k - m; q <= k + m; q++)
            sum += lean[q] / (2 * m + 1);
        out->t[k] = u0 + step * (mid - sum) / 2;
        out->r[k] = u0 + step * (mid + sum) / 2;
    }
}

ix_status ix__rulings_find(ix_ctx *ctx, const ix_mv *s, int samples, int slack,
                           int fine, ix__rulings *out)
{
    table tab = {samples, fine, NULL};
    ix__monotone m = {worth, &tab, samples, slack};
    int *i, *j, end[2], n, lo;
    double *work, dom[2];
    char *from;

    IX_TRY(sample(ctx, s, &tab));
    IX_SCRATCH(ctx, work, 4 * samples);
    IX_SCRATCH(ctx, from, (size_t)samples * (size_t)samples);
    (void)ix__monotone_best(&m, work, from, end);
    IX_SCRATCH(ctx, i, 2 * samples);
    IX_SCRATCH(ctx, j, 2 * samples);
    n = ix__monotone_trace(samples, from, end, i, j);
    lo = i[0] + j[0];
    leans(n, i, j, work);
    n = end[0] + end[1] - lo + 1;
    IX_SCRATCH(ctx, out->t, n);
    IX_SCRATCH(ctx, out->r, n);
    ix_mv_domain(s, 0, dom);
    smooth(samples / 4, lo, n, work, dom[0], (dom[1] - dom[0]) / (samples - 1),
           out);
    return IX_OK;
}

/* Where ruling k passes at the fraction v. */
static double place(const ix__rulings *g, int k, double v)
{
    return (1 - v) * g->t[k] + v * g->r[k];
}

double ix__rulings_over(const ix__rulings *g, double u, double v)
{
    int lo = 0, hi = g->n - 1;
    double a, b, x;

    while (hi - lo > 1) {
        int mid = (lo + hi) / 2;

        if (place(g, mid, v) <= u)
            lo = mid;
        else
            hi = mid;
    }
    a = place(g, lo, v);
    b = place(g, hi, v);
    x = b > a ? fmin(1, fmax(0, (u - a) / (b - a))) : 0;
    return (1 - x) * place(g, lo, 0.5) + x * place(g, hi, 0.5);
}
