/* gauss.c - nodes by Newton's method on the Legendre recurrence, from the
 * starting values of Abramowitz and Stegun 22.16.6; pairs are symmetric. */
#include "geom/gauss.h"

#include <math.h>

#include "geom/angle.h"

/* P_n(x) and its derivative. */
static double legendre(int n, double x, double *slope)
{
    double p0 = 1, p1 = x;

    for (int k = 2; k <= n; k++) {
        double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;

        p0 = p1;
        p1 = p2;
    }
    *slope = n * (p0 - x * p1) / ((1 - x) * (1 + x));
    return p1;
}

void ix__gauss(int n, double *x, double *w)
{
    for (int i = 0; i < (n + 1) / 2; i++) {
        double z = cos(IX__PI * (i + 0.75) / (n + 0.5)), slope = 1, step = 1;

        for (int it = 0; it < 20 && fabs(step) > 1e-16; it++) {
            double p = legendre(n, z, &slope);

            step = p / slope;
            z -= step;
        }
        if (2 * i + 1 == n)
            z = 0; /* the middle one */
        (void)legendre(n, z, &slope);
        x[i] = (1 - z) / 2;
        x[n - 1 - i] = (1 + z) / 2;
        w[i] = w[n - 1 - i] = 1 / ((1 - z) * (1 + z) * slope * slope);
    }
}
