/* combine.c - linear combinations of rows: where sums of products of factors
 * in different variables become a grid. */
#include "bern/bern.h"
#include "bern/clones.h"

IX__CLONES void ix__bern_combine(size_t n, int k, const double *f,
                                 const double *const *x, double *out)
{
    size_t i = 0;

    for (; i + 8 <= n; i += 8) {
        ix__v4 s0 = {0}, s1 = {0};

        for (int j = 0; j < k; j++) {
            const ix__v4 *y = ix__cvec(x[j] + i);

            s0 += f[j] * y[0];
            s1 += f[j] * y[1];
        }
        ix__vec(out + i)[0] = s0;
        ix__vec(out + i)[1] = s1;
    }
    for (; i < n; i++) {
        double s = 0.0;

        for (int j = 0; j < k; j++)
            s += f[j] * x[j][i];
        out[i] = s;
    }
}
