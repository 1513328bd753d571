/* distance_bounds.c - |x|^2 / w^2 lies between the least and the largest ratio
 * of the Bernstein coefficients of |x|^2 and w^2, as w^2 > 0. */
#include "geom/distance_bounds.h"

#include <float.h>
#include <math.h>

#include "solve/form_roots.h"

/* Coefficients of the parts in a row of a form. */
typedef struct {
    int n[2];       /* parts */
    size_t dims[2]; /* coefficients of a part */
    size_t stride;  /* from one row of the grid to the next */
} grid;

static grid grid_of(const ix_form *f)
{
    grid g = {.n = {1, 1}, .dims = {1, 1}};

    for (int j = 0; j < f->ndirs; j++) {
        g.n[j] = f->dirs[j].nspans;
        g.dims[j] = (size_t)f->dirs[j].degree + 1;
    }
    g.stride = (size_t)g.n[0] * g.dims[0];
    return g;
}

static size_t start_of(const grid *g, int part)
{
    return (size_t)(part / g->n[0]) * g->dims[1] * g->stride +
           (size_t)(part % g->n[0]) * g->dims[0];
}

/* Least or largest of the ratios of a part. */
static double extreme(const grid *g, int part, const double *num,
                      const double *den, bool farthest)
{
    double best = farthest ? 0 : HUGE_VAL;

    for (size_t j = 0; j < g->dims[1]; j++) {
        size_t from = start_of(g, part) + j * g->stride;

        for (size_t i = from; i < from + g->dims[0]; i++) {
            double v = den ? num[i] / den[i] : num[i];

            if (den && !(den[i] > 0))
                return farthest ? HUGE_VAL : 0;
            if (farthest ? v > best : v < best)
                best = v;
        }
    }
    return best;
}

/* The distances at the corners of a part are coefficients. */
static void offer_corners(const grid *g, int part, const double *num,
                          const double *den, bool farthest,
                          ix__distance_bounds *b)
{
    for (int high = 0; high < 4; high++) {
        size_t at = start_of(g, part) + (high & 1 ? g->dims[0] - 1 : 0) +
                    (high & 2 ? (g->dims[1] - 1) * g->stride : 0);
        double v = den ? num[at] / den[at] : num[at];

        if ((den && !(den[at] > 0)) ||
            !(b->part < 0 || (farthest ? v > b->best : v < b->best)))
            continue;
        b->best = v;
        b->part = part;
        b->high = high;
    }
}

static double largest(const double *v, size_t n)
{
    double m = 0;

    for (size_t i = 0; i < n; i++)
        m = fabs(v[i]) > m ? fabs(v[i]) : m;
    return m;
}

ix_status ix__distance_bounds_of(ix_ctx *ctx, const ix_form *x,
                                 const ix_form *w, bool farthest,
                                 ix__distance_bounds *out)
{
    const double *num, *den = NULL;
    ix_form d, ww;
    grid g;

    IX_TRY(ix__form_dot(ctx, x, x, &d));
    IX_TRY(ix__form_bernstein(ctx, &d, &num));
    if (w) {
        IX_TRY(ix__form_mul(ctx, w, w, &ww));
        IX_TRY(ix__form_bernstein(ctx, &ww, &den));
    }
    g = grid_of(&d);
    *out = (ix__distance_bounds){.n = g.n[0] * g.n[1], .part = -1};
    out->best = farthest ? 0 : HUGE_VAL;
    IX_SCRATCH(ctx, out->d, out->n);
    for (int i = 0; i < out->n; i++) {
        out->d[i] = extreme(&g, i, num, den, farthest);
        offer_corners(&g, i, num, den, farthest, out);
    }
    /* a coefficient is a sum of products, 8 roundings for each degree */
    out->slack = 4 * DBL_EPSILON * (double)(g.dims[0] + g.dims[1]) *
                 (den ? fmax(largest(num, d.n), out->best) : largest(num, d.n));
    return IX_OK;
}
