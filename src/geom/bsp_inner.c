/* bsp_inner.c - inner products of B-spline basis functions. On a span both
 * functions are polynomials, so Gauss-Legendre with half of their degrees'
 * sum, rounded up, is exact. */
#include "base/ctx.h"
#include "geom/gauss.h"
#include "iritx/geom_srf.h"

/* One basis function: order o, support knots k[0 .. o]. */
typedef struct {
    int order;
    const double *k;
    double *tri; /* [order], work */
} basis_fn;

/* Value at x inside the span [k[span], k[span + 1]), 0 <= span < order, by the
 * recurrence of Cox and de Boor; 0 / 0 counts as 0. */
static double basis_value(const basis_fn *f, int span, double x)
{
    const double *k = f->k;
    double *n = f->tri;

    for (int i = 0; i < f->order; i++)
        n[i] = i == span;
    for (int p = 1; p < f->order; p++)
        for (int i = 0; i + p < f->order; i++) {
            double a = k[i + p] - k[i], b = k[i + p + 1] - k[i + 1];

            n[i] = (a > 0 ? (x - k[i]) / a * n[i] : 0) +
                   (b > 0 ? (k[i + p + 1] - x) / b * n[i + 1] : 0);
        }
    return n[0];
}

typedef struct {
    int n;
    double *x, *w;
} quadrature;

/* Over the span [a, b] that is span sf of f and sg of g. */
static double span_integral(const quadrature *g, const basis_fn f[2],
                            const int span[2], double a, double b)
{
    double sum = 0;

    for (int i = 0; i < g->n; i++) {
        double x = a + (b - a) * g->x[i];

        sum += g->w[i] * basis_value(&f[0], span[0], x) *
               basis_value(&f[1], span[1], x);
    }
    return (b - a) * sum;
}

static ix_status check(ix_ctx *ctx, int nknots, const int order[2],
                       const int index[2])
{
    for (int e = 0; e < 2; e++) {
        if (order[e] < 1 || order[e] >= nknots)
            return IX_FAIL(ctx, IX_EARG, "order %d on %d knots", order[e],
                           nknots);
        if (index[e] < 0 || index[e] >= nknots - order[e])
            return IX_FAIL(ctx, IX_EARG, "basis function %d of %d of order %d",
                           index[e], nknots - order[e], order[e]);
    }
    return IX_OK;
}

/* The knots of dir as an array. */
static ix_status knots_of(ix_ctx *ctx, const ix_dir *dir, const double **knots,
                          int *n)
{
    double *k;

    if (dir->basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "a power basis has no knots");
    if (dir->basis == IX_BSPLINE) {
        *knots = dir->knots;
        *n = ix_knots_count(dir);
        return IX_OK;
    }
    *n = 2 * dir->order;
    IX_SCRATCH(ctx, k, *n);
    for (int i = 0; i < *n; i++)
        k[i] = i >= dir->order;
    *knots = k;
    return IX_OK;
}

static ix_status inner(ix_ctx *ctx, const ix_dir *dir, const int order[2],
                       const int index[2], double *out)
{
    /* Degree order[0] + order[1] - 2 <= 2 n - 1. */
    quadrature g = {.n = (order[0] + order[1]) / 2};
    const double *knots;
    basis_fn f[2];
    int n;

    IX_TRY(knots_of(ctx, dir, &knots, &n));
    IX_TRY(check(ctx, n, order, index));
    IX_SCRATCH(ctx, g.x, g.n);
    IX_SCRATCH(ctx, g.w, g.n);
    ix__gauss(g.n, g.x, g.w);
    for (int e = 0; e < 2; e++) {
        f[e] = (basis_fn){.order = order[e], .k = knots + index[e]};
        IX_SCRATCH(ctx, f[e].tri, order[e]);
    }
    *out = 0;
    for (int k = index[0]; k < index[0] + order[0]; k++)
        if (k >= index[1] && k < index[1] + order[1] && knots[k + 1] > knots[k])
            *out += span_integral(&g, f,
                                  (const int[2]){k - index[0], k - index[1]},
                                  knots[k], knots[k + 1]);
    return IX_OK;
}

ix_status ix_bsp_inner(ix_ctx *ctx, const ix_dir *dir, const int order[2],
                       const int index[2], double *out)
{
    *out = 0;
    if (order[0] > IX_MAX_ORDER || order[1] > IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EARG, "orders %d and %d, at most %d", order[0],
                       order[1], IX_MAX_ORDER);
    IX_RETURN_SCOPED(ctx, inner(ctx, dir, order, index, out));
}
