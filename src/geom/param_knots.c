/* param_knots.c - knots for given parameters. Two rules: averages of the
 * parameters stretched to the whole interval, as long as the interpolation
 * problem stays well conditioned with them, else de Boor's averages. */
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "iritx/geom.h"

/* Largest amplification of data, in the maximum norm, up to which the first
 * rule is kept. It grows exponentially with the number of points (cubic,
 * uniform: 6 for 8 points, 40 for 17, 1e7 for 92), that of the second rule
 * hardly at all. */
#define MAX_AMPLIFICATION 50

/* tau at the fractional index x. */
static double at_index(int m, const double *tau, double x)
{
    int i = (int)x;

    if (i >= m - 1)
        return tau[m - 1];
    return tau[i] + (x - i) * (tau[i + 1] - tau[i]);
}

static double average(const double *t, int n)
{
    double s = 0;

    for (int i = 0; i < n; i++)
        s += t[i] / n;
    return s;
}

static void clamp_ends(int order, int length, double *knots)
{
    for (int i = 0; i < order; i++) {
        knots[i] = 0;
        knots[length + i] = 1;
    }
}

/* Averages of order - 1 parameters, the first mapped to 0, the last to 1. */
static void stretched(int order, int length, const double *tau, double *knots)
{
    double lo = average(tau, order - 1);
    double hi = average(tau + length - order + 1, order - 1);

    clamp_ends(order, length, knots);
    for (int i = 1; i <= length - order; i++)
        knots[order - 1 + i] = (average(tau + i, order - 1) - lo) / (hi - lo);
}

/* de Boor 1978, XIII (9); for order 1 the steps lie between parameters. */
static void de_boor(int order, int length, const double *tau, double *knots)
{
    clamp_ends(order, length, knots);
    for (int i = 1; i <= length - order; i++)
        knots[order - 1 + i] = order > 1 ? average(tau + i, order - 1)
                                         : (tau[i - 1] + tau[i]) / 2;
}

/* Norm of the inverse of the collocation matrix, infinity if it is singular.
 * The matrix is totally positive (Karlin 1968), so the signs of its inverse
 * alternate and the norm is attained for alternating data. */
static ix_status inverse_norm(ix_ctx *ctx, const ix_dir *dir, const double *tau,
                              double *norm)
{
    int n = dir->length;
    ix_band band;
    double *w, *x;
    ix_status st;

    *norm = 0;
    IX_SCRATCH(ctx, w, dir->order);
    IX_SCRATCH(ctx, x, n);
    IX_TRY(ix__band_new(ctx, n, dir->order, false, 1, &band));
    for (int i = 0; i < n; i++) {
        int first = ix__basis_first(dir, tau[i]);
        double sign = i % 2 ? -1 : 1;

        ix__basis_derive(dir, first, tau[i], 0, w);
        ix__band_add(&band, first, dir->order, w, &sign);
    }
    st = ix__band_solve(ctx, &band, x);
    for (int i = 0; st == IX_OK && i < n; i++)
        *norm = fmax(*norm, fabs(x[i]));
    if (st == IX_EDOMAIN)
        *norm = HUGE_VAL;
    return st == IX_EDOMAIN ? IX_OK : st;
}

static ix_status choose(ix_ctx *ctx, int order, int length, const double *tau,
                        double *knots)
{
    ix_dir dir = {
        .basis = IX_BSPLINE, .order = order, .length = length, .knots = knots};
    double norm = HUGE_VAL;

    if (order > 1 && tau[0] < tau[length - 1]) {
        stretched(order, length, tau, knots);
        IX_TRY(inverse_norm(ctx, &dir, tau, &norm));
    }
    if (!(norm <= MAX_AMPLIFICATION))
        de_boor(order, length, tau, knots);
    return IX_OK;
}

static ix_status resample(ix_ctx *ctx, int length, int m, const double *tau,
                          const double **out)
{
    double *t;

    *out = tau;
    if (length == m)
        return IX_OK;
    IX_SCRATCH(ctx, t, length);
    for (int i = 0; i < length; i++)
        t[i] = length > 1 ? at_index(m, tau, (double)i * (m - 1) / (length - 1))
                          : tau[0];
    *out = t;
    return IX_OK;
}

ix_status ix_params_knots(ix_ctx *ctx, int order, int length, int m,
                          const double *tau, double *knots)
{
    ix_mark mk = ix__scratch_mark(ctx);
    const double *t;
    ix_status st;

    if (order < 1 || length < order || m < length)
        return IX_FAIL(ctx, IX_EARG,
                       "order %d, %d control points, %d parameters", order,
                       length, m);
    st = resample(ctx, length, m, tau, &t);
    if (st == IX_OK)
        st = choose(ctx, order, length, t, knots);
    ix__scratch_release(ctx, mk);
    return st;
}
