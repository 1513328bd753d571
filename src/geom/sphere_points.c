/* sphere_points.c - even point sets on the unit sphere: the Fibonacci lattice
 * for any count, rings of latitude for a given spacing. */
#include "geom/sphere_points.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

void ix__sphere_points(int n, double (*out)[3])
{
    const double golden = 0.61803398874989484820; /* (sqrt 5 - 1) / 2 */

    for (int i = 0; i < n; i++) {
        double z = (n - 1.0 - 2.0 * i) / n, r = sqrt((1 - z) * (1 + z));
        double turn = fmod(i * golden, 1.0) * 2 * PI;

        out[i][0] = r * cos(turn);
        out[i][1] = r * sin(turn);
        out[i][2] = z;
    }
}

/* Points on the ring at polar angle t. */
static int ring_count(double t, double spacing)
{
    return t > 0 ? (int)fmax(3, ceil(2 * PI * sin(t) / spacing)) : 1;
}

ix_status ix__hemisphere_points(ix_ctx *ctx, double spacing, int *n,
                                double (**out)[3])
{
    int rings, count = 0;
    double(*p)[3];

    if (!(spacing >= 1e-3 && spacing <= PI)) /* 1e-3: 6 million points */
        return IX_FAIL(ctx, IX_EARG, "spacing %g is not in [0.001, pi]",
                       spacing);
    rings = (int)ceil(PI / 2 / spacing);
    for (int k = 0; k <= rings; k++)
        count += ring_count(PI / 2 * k / rings, spacing);
    IX_SCRATCH(ctx, p, count);
    *n = count;
    *out = p;
    for (int k = 0; k <= rings; k++) {
        double t = PI / 2 * k / rings;
        int m = ring_count(t, spacing);

        for (int i = 0; i < m; i++, p++) {
            (*p)[0] = sin(t) * cos(2 * PI * i / m);
            (*p)[1] = sin(t) * sin(2 * PI * i / m);
            (*p)[2] = k == rings ? 0 : cos(t);
        }
    }
    return IX_OK;
}
