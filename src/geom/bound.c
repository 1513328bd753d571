/* bound.c - products and bounds of single Bernstein polynomials. */
#include "geom/bound.h"

#include <math.h>
#include <string.h>

#include "bern/bern.h"

size_t ix__bernstein_work(int d)
{
    return 5 * (size_t)d + 4 * IX__BERN_PAD + 16;
}

void ix__path_restrict(const ix_path *p, int span, double t0, double t1,
                       double *out)
{
    size_t m = (size_t)p->degree + 1;
    const double *c = p->coef + (size_t)span * (size_t)p->naxes * m;
    double a = p->breaks[span], h = p->breaks[span + 1] - a;

    for (int i = 0; i < p->naxes; i++, c += m, out += m) {
        ix__bernstein_restrict(p->degree, (t0 - a) / h, (t1 - a) / h, c, out);
    }
}

void ix__bernstein_restrict(int d, double a, double b, const double *c,
                            double *out)
{
    if (a == 0 && b == 1)
        memmove(out, c, ((size_t)d + 1) * sizeof *c);
    else
        ix__bern_restrict(d, a, b, 1, c, out);
}

void ix__bernstein_mul(int p, const double *a, int q, const double *b,
                       double *work, double *out)
{
    double *sa = work, *sb = sa + p + 1, *row = sb + q + 1;
    double *pad = row + p + q + 1;

    ix__bern_scale(1, p, 1, ix__binom(p, row), a, sa);
    ix__bern_scale(1, q, 1, ix__binom(q, row), b, sb);
    ix__bern_conv_spans(1, p, sa, q, sb, IX__SET, pad, out);
    ix__bern_unscale(1, p + q, 1, ix__binom(p + q, row), out, out);
}

void ix__bernstein_raise(int d, const double *a, int e, double *work,
                         double *out)
{
    double *sa = work, *row = sa + d + 1;

    ix__bern_scale(1, d, 1, ix__binom(d, row), a, sa);
    ix__bern_elevate(d, e, ix__binom(e, row), 1, sa, out);
    ix__bern_unscale(1, d + e, 1, ix__binom(d + e, row), out, out);
}

double ix__bernstein_max(int n, int d, const double *c, double *work)
{
    enum { PARTS = 8 };
    size_t m = (size_t)d + 1;
    double top = 0;

    for (int k = 0; k < PARTS; k++) {
        for (int i = 0; i < n; i++)
            ix__bern_restrict(d, (double)k / PARTS, (k + 1.0) / PARTS, 1,
                              c + (size_t)i * m, work + (size_t)i * m);
        for (size_t j = 0; j < m; j++) {
            double s = 0;

            for (size_t i = 0; i < (size_t)n; i++)
                s += work[i * m + j] * work[i * m + j];
            if (s > top || isnan(s)) /* NaN stays: nothing is above it */
                top = s;
        }
    }
    return sqrt(top);
}
