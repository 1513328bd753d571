/* crossings.c - where a polynomial changes sign: intervals are halved until
 * their coefficients change sign at most once (Descartes' rule in Bernstein
 * form), then the bracket is closed. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"

/* Halvings after which an interval is as short as doubles tell apart. */
enum { DEEPEST = 52 };

/* de Casteljau's rule; w has room for d + 1. */
static double value(int d, const double *b, double t, double *w)
{
    memcpy(w, b, (size_t)(d + 1) * sizeof *w);
    for (int r = d; r > 0; r--)
        for (int k = 0; k < r; k++)
            w[k] = (1.0 - t) * w[k] + t * w[k + 1];
    return w[0];
}

/* The sign change between lo and hi, from below if rising. */
static double close_in(int d, const double *b, double lo, double hi,
                       bool rising, double *w)
{
    for (;;) {
        double mid = lo + (hi - lo) / 2;

        if (!(mid > lo && mid < hi))
            return mid;
        if ((value(d, b, mid, w) < 0.0) == rising)
            lo = mid;
        else
            hi = mid;
    }
}

/* The decided coefficients at both ends: 1 they rise through zero, -1 they
 * fall, 0 same signs. */
static int direction(int d, const double *c, double band)
{
    int i = 0, j = d;

    while (i < j && !(fabs(c[i]) > band))
        i++;
    while (j > i && !(fabs(c[j]) > band))
        j--;
    if (i == j || (c[i] > 0.0) == (c[j] > 0.0))
        return 0;
    return c[j] > 0.0 ? 1 : -1;
}

/* Where to cut: the middle, unless it is a zero, which would be lost. */
static double cut_at(int d, const double *b, double lo, double hi, double band,
                     double *w)
{
    static const double part[] = {0.5, 0.4375, 0.59375, 0.328125};

    for (int i = 0; i < 4; i++) {
        double t = lo + part[i] * (hi - lo);

        if (fabs(value(d, b, t, w)) > band)
            return t;
    }
    return lo + (hi - lo) / 2;
}

int ix__bern_crossings(int d, const double *b, double band, double *work,
                       double *out)
{
    struct {
        double lo, hi;
    } stack[DEEPEST + 2];
    double *c = work, *w = work + d + 1;
    int top = 0, n = 0;

    stack[top].lo = 0.0;
    stack[top++].hi = 1.0;
    while (top > 0 && n < d) {
        double lo = stack[--top].lo, hi = stack[top].hi, mid;
        int v, dir;

        ix__bern_restrict(d, lo, hi, 1, b, c);
        v = ix__bern_variations(d + 1, c, band, NULL);
        dir = v > 0 ? direction(d, c, band) : 0;
        if (v == 1 || (v > 1 && top >= DEEPEST)) {
            if (dir != 0)
                out[n++] = close_in(d, b, lo, hi, dir > 0, w);
            continue;
        }
        if (v == 0)
            continue;
        mid = cut_at(d, b, lo, hi, band, w);
        stack[top].lo = mid; /* the left part is looked at first */
        stack[top++].hi = hi;
        stack[top].lo = lo;
        stack[top++].hi = mid;
    }
    return n;
}
