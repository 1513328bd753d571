/* trim_place.c - parameters of a surface as integers, so that what lies on a
 * line of the grid does so exactly, and cells can be triangulated without
 * rounding. */
#include <math.h>

#include "mv/cdt.h"
#include "mv/tess_impl.h"

/* A cell has 2^30 places: rounding of parameters and of the roots that put
 * samples onto the grid's lines is below one of them, if a cell is more than
 * 1e-6 of the domain. */
enum { NEAR = 8, OUTSIDE = 16 };

int64_t ix__tess_snap(int64_t x)
{
    int64_t r = x & (IX__CDT_SIDE - 1);

    if (r <= NEAR)
        return x - r;
    return r >= IX__CDT_SIDE - NEAR ? x - r + IX__CDT_SIDE : x;
}

/* The interval of t; the first and the last go on outside. */
static int interval(const ix__tess_dir *d, double t)
{
    int lo = 0, hi = d->nsamples - 1;

    while (hi - lo > 1) {
        int mid = lo + (hi - lo) / 2;

        if (d->t[mid] <= t)
            lo = mid;
        else
            hi = mid;
    }
    return lo;
}

int64_t ix__tess_place(const ix__tess_dir *d, double t)
{
    int i = interval(d, t);
    double f = (t - d->t[i]) / (d->t[i + 1] - d->t[i]);

    f = fmin(fmax(f, -OUTSIDE), OUTSIDE);
    return ix__tess_snap((int64_t)i * IX__CDT_SIDE +
                         (int64_t)llrint(f * IX__CDT_SIDE));
}

double ix__tess_param(const ix__tess_dir *d, int64_t x)
{
    int i = (int)(x >> IX__CDT_BITS);
    double f = (double)(x & (IX__CDT_SIDE - 1)) / IX__CDT_SIDE;

    return f > 0 ? d->t[i] + f * (d->t[i + 1] - d->t[i]) : d->t[i];
}

void ix__trim_place(const ix__tess_grid *g, const double uv[2], int64_t x[2])
{
    for (int d = 0; d < 2; d++)
        x[d] = ix__tess_place(&g->d[d], uv[d]);
}

bool ix__trim_on_line(int64_t x)
{
    return x % IX__CDT_SIDE == 0;
}
