/* knots.c - knot vectors of one direction. */
#include "bsp/knots.h"

#include <float.h>
#include <math.h>

double ix__knots_ulp4(int n, const double *knots)
{
    return 4 * DBL_EPSILON * fmax(fabs(knots[0]), fabs(knots[n - 1]));
}

int ix_knots_count(const ix_dir *dir)
{
    if (dir->basis != IX_BSPLINE)
        return 0;
    return dir->length + (dir->periodic ? 2 * dir->order - 1 : dir->order);
}

int ix__dir_npoints(const ix_dir *dir)
{
    return dir->length + (dir->periodic ? dir->order - 1 : 0);
}

void ix__dir_domain(const ix_dir *dir, double dom[2])
{
    dom[0] = 0;
    dom[1] = 1;
    if (dir->basis == IX_BSPLINE) {
        dom[0] = dir->knots[dir->order - 1];
        dom[1] = dir->knots[ix__dir_npoints(dir)];
    }
}

int ix__dir_span(const ix_dir *dir, double t)
{
    const double *knots = dir->knots;
    int lo = dir->order - 1, hi = ix__dir_npoints(dir);

    if (t >= knots[hi]) { /* the last non-empty span */
        while (knots[hi - 1] >= knots[hi])
            hi--;
        return hi - 1;
    }
    while (hi - lo > 1) { /* knots[lo] <= t < knots[hi] */
        int mid = lo + (hi - lo) / 2;

        if (t < knots[mid])
            hi = mid;
        else
            lo = mid;
    }
    while (knots[lo] >= knots[lo + 1]) /* only if t is below the domain */
        lo++;
    return lo;
}

ix_status ix__dir_knots(ix_ctx *ctx, const ix_dir *dir, const double **knots)
{
    double *kv;

    *knots = dir->knots;
    if (dir->basis == IX_BSPLINE)
        return IX_OK;
    IX_SCRATCH(ctx, kv, 2 * (size_t)dir->order);
    for (int i = 0; i < dir->order; i++) {
        kv[i] = 0;
        kv[dir->order + i] = 1;
    }
    *knots = kv;
    return IX_OK;
}

bool ix__dir_is_open(const ix_dir *dir)
{
    const double *k = dir->knots;
    int o = dir->order, n = dir->length;

    if (dir->basis != IX_BSPLINE)
        return true;
    return !dir->periodic && k[0] == k[o - 1] && k[n] == k[n + o - 1];
}

/* The domain [0, 1] cut into pieces of one length; knot i of the float
 * vector is (i - (order - 1)) / pieces. */
static void knots_even(int order, int n, int pieces, double *knots)
{
    for (int i = 0; i < n; i++)
        knots[i] = (double)(i - (order - 1)) / pieces;
}

/* Open knots with (length - order) / mult distinct interior ones. */
static void knots_open(int order, int length, int mult, double *knots)
{
    int pieces = (length - order) / mult + 1;

    for (int i = 0; i < order; i++) {
        knots[i] = 0;
        knots[length + i] = 1;
    }
    for (int i = order; i < length; i++) {
        int piece = (i - order) / mult + 1;

        knots[i] = (double)piece / pieces;
    }
}

ix_status ix_knots_make(ix_ctx *ctx, ix_kv_kind kind, int order, int length,
                        double *knots)
{
    if (order < 1 || order > IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EARG, "order %d is not in 1 .. %d", order,
                       IX_MAX_ORDER);
    if (length < (kind == IX_KV_PERIODIC ? 1 : order))
        return IX_FAIL(ctx, IX_EARG, "%d control points for order %d", length,
                       order);
    switch (kind) {
    case IX_KV_OPEN:
        knots_open(order, length, 1, knots);
        return IX_OK;
    case IX_KV_FLOAT:
        knots_even(order, length + order, length - order + 1, knots);
        return IX_OK;
    case IX_KV_PERIODIC:
        knots_even(order, length + 2 * order - 1, length, knots);
        return IX_OK;
    case IX_KV_DISC_OPEN:
        if (length > order &&
            (order == 1 || (length - order) % (order - 1) != 0))
            return IX_FAIL(ctx, IX_EARG,
                           "discontinuous knots: order - 1 = %d does not "
                           "divide length - order = %d",
                           order - 1, length - order);
        knots_open(order, length, order > 1 ? order - 1 : 1, knots);
        return IX_OK;
    }
    return IX_FAIL(ctx, IX_EARG, "knot vector kind %d is unknown", (int)kind);
}

/* Mean of order - 1 knots after knot i; the span's middle for order 1. */
static double node(const ix_dir *dir, int i)
{
    const double *t = dir->knots;
    int d = dir->order - 1;
    double sum = 0;

    if (d == 0)
        return 0.5 * (t[i] + t[i + 1]);
    for (int j = 1; j <= d; j++)
        sum += t[i + j];
    return sum / d;
}

void ix_knots_nodes(const ix_dir *dir, double *nodes)
{
    double dom[2];
    int d = dir->order - 1;

    ix__dir_domain(dir, dom);
    for (int i = 0; i < dir->length; i++) {
        if (dir->basis == IX_BSPLINE)
            nodes[i] = fmin(fmax(node(dir, i), dom[0]), dom[1]);
        else
            nodes[i] = d > 0 ? (double)i / d : 0.5;
    }
}
