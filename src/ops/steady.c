/* steady.c - the direction that is farthest from a right angle to a field. */
#include "ops/steady.h"

#include "geom/vec3.h"

enum { MAX_SAMPLES = 64, PER_SPAN = 8 };

/* Least |cosine| between n and the unit vectors v[m][3]. */
static double least_cosine(const double n[3], int m, double (*v)[3])
{
    double least = 1.0;

    for (int i = 0; i < m; i++)
        least = fmin(least, fabs(ix__dot3(n, v[i])));
    return least;
}

/* Unit vectors along v at parameters in range, away from its ends; their
 * number. */
static int sample(const ix_form *v, const double range[2], double (*out)[3])
{
    int n = 2 * PER_SPAN * v->dirs[0].nspans, m = 0;

    n = n < MAX_SAMPLES ? n : MAX_SAMPLES;
    for (int i = 0; i < n; i++) {
        double t = range[0] + (range[1] - range[0]) * (i + 0.5) / n;

        ix__form_eval(v, &t, out[m]);
        if (ix__unit3(out[m], out[m]) > 0)
            m++;
    }
    return m;
}

double ix__steady_normal(const ix_form *v, const double range[2], double n[3])
{
    double u[MAX_SAMPLES][3], sum[3] = {0, 0, 0}, best;
    int m = sample(v, range, u);

    n[0] = n[1] = 0.0;
    n[2] = 1.0;
    if (m == 0)
        return 1.0;
    for (int i = 0; i < m; i++)
        ix__axpy3(sum, ix__dot3(sum, u[i]) < 0 ? -1.0 : 1.0, u[i], sum);
    (void)ix__unit3(sum, n);
    best = least_cosine(n, m, u);
    /* the mean serves unless the field turns far */
    for (int i = 0; best < 0.5 && i < m; i++) {
        double cosine = least_cosine(u[i], m, u);

        if (!(cosine > best))
            continue;
        best = cosine;
        for (int k = 0; k < 3; k++)
            n[k] = u[i][k];
    }
    return best;
}
