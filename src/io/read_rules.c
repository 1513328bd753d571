/* read_rules.c - planes and normals that a file leaves out or gives with any
 * length, weights that deserve a warning. Nothing changes what a writer of ours
 * has written. */
#include "io/read_rules.h"

#include <math.h>
#include <string.h>

bool ix__poly_unit(double *v, int n)
{
    double s = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    double x = v[0] / s, y = v[1] / s, z = v[2] / s;
    double len = s * sqrt(x * x + y * y + z * z);

    if (!(s > 0) || !isfinite(len))
        return false;
    if (fabs(len - 1) <= 4 * 0x1p-52)
        return true;
    for (int k = 0; k < n; k++)
        v[k] /= len;
    return isfinite(v[n - 1]);
}

void ix__poly_complete(ix_polygon *pg)
{
    if (pg->kind != IX_POLYGON)
        return;
    if (!pg->has_plane)
        pg->has_plane = ix__polygon_plane(pg, pg->plane);
    for (int i = 0; pg->has_plane && i < pg->n; i++) {
        if (pg->v[i].has_normal)
            continue;
        memcpy(pg->v[i].normal, pg->plane, sizeof pg->v[i].normal);
        pg->v[i].has_normal = true;
    }
}

bool ix__signs_change(const ix_mv *m, double range[2])
{
    const double *w = ix_mv_weights(m);

    range[0] = HUGE_VAL;
    range[1] = -HUGE_VAL;
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        if (ix_mv_dir(m, d).basis == IX_POWER)
            return false;
    for (size_t i = 0; w && i < ix_mv_npts(m); i++) {
        range[0] = fmin(range[0], w[i]);
        range[1] = fmax(range[1], w[i]);
    }
    return range[0] < 0 && range[1] > 0;
}
