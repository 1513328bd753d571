/* contract.c - whether a preconditioned system contracts on a box.
 *
 * A coefficient of a derivative of degree d is d times the difference of two
 * coefficients: its error is at most 2 d (err + u mag). The entries of m J are
 * sums of n products, which commit at most (n + 3) roundings relative to the
 * sum of their sizes. */
#include "solve/contract.h"

#include <float.h>
#include <math.h>

#define UNIT (DBL_EPSILON / 2)

/* Bounds of one row of I - m J; their sum. */
static double row_bound(int n, const double *w, ix__mat low, ix__mat high,
                        ix__mat slack, int i, double *d)
{
    double row = 0;

    for (int j = 0; j < n; j++) {
        double a = i == j, c = i == j, err = 0;

        for (int k = 0; k < n; k++) {
            double p = w[k] * low[k][j], q = w[k] * high[k][j];

            a -= p > q ? p : q;
            c -= p > q ? q : p;
            err += fabs(w[k]) * slack[k][j];
        }
        d[j] = (ix__larger(fabs(a), fabs(c)) + err) * (1 + 4 * UNIT);
        row += d[j];
    }
    return row;
}

double ix__contraction(const ix__shape *s, int n, const int *dir,
                       const double *f, const double *err, const double *mag,
                       ix__mat m, ix__mat d)
{
    ix__mat low, high, slack;
    double worst = 0;

    for (int k = 0; k < n; k++)
        for (int j = 0; j < n; j++) {
            ix__tensor_slope_range(s, f + (size_t)k * s->size, dir[j],
                                   &low[k][j], &high[k][j]);
            slack[k][j] = 2 * (s->dims[dir[j]] - 1) * (err[k] + UNIT * mag[k]) +
                          (n + 3) * UNIT * ix__larger(-low[k][j], high[k][j]);
        }
    for (int i = 0; i < n; i++)
        worst = ix__larger(worst,
                           row_bound(n, m[i], low, high, slack, i, d[i]));
    return worst * (1 + IX_MAX_UNKNOWNS * UNIT);
}
