/* basis.c - basis values, derivatives and blossom weights of a window.
 *
 * The triangle of de Boor and Cox, transposed, with one argument a level
 * (Cohen, Lyche, Riesenfeld 1980, the Oslo algorithm): every level is a
 * convex combination when the arguments are in order. The weights add up to 1
 * up to rounding; sums take differences from one point, so that constants and
 * end points are exact all the same. */
#include "bsp/basis.h"

/* Argument of level r is args[(r - 1) * step]. */
static inline void spline_triangle(const double *knots, int mu, int d,
                                   const double *args, int step, double *w)
{
    w[0] = 1;
    for (int r = 1; r <= d; r++) {
        const double *lo = knots + mu + 1 - r, *hi = knots + mu + 1;
        double x = args[(r - 1) * step], saved = 0;

        for (int q = 0; q < r; q++) {
            double v = w[q] / (hi[q] - lo[q]);

            w[q] = saved + (hi[q] - x) * v;
            saved = (x - lo[q]) * v;
        }
        w[r] = saved;
    }
}

/* The same with every lo = 0 and hi = 1. */
static inline void bezier_triangle(int d, const double *args, int step,
                                   double *w)
{
    w[0] = 1;
    for (int r = 1; r <= d; r++) {
        double x = args[(r - 1) * step], saved = 0;

        for (int q = 0; q < r; q++) {
            double v = w[q];

            w[q] = saved + (1 - x) * v;
            saved = x * v;
        }
        w[r] = saved;
    }
}

void ix__blossom_weights(const double *knots, int mu, int d, const double *args,
                         double *w)
{
    spline_triangle(knots, mu, d, args, 1, w);
}

/* k-th derivative of 1, t, t^2, ... */
static void power_weights(int order, double t, int k, double *w)
{
    double p = 1;

    for (int i = 0; i < order; i++) {
        double f = 1;

        for (int j = 0; j < k; j++)
            f *= i - j;
        w[i] = i < k ? 0 : f * p;
        if (i >= k)
            p *= t;
    }
}

int ix__basis_first(const ix_dir *dir, double t)
{
    if (dir->basis != IX_BSPLINE)
        return 0;
    return ix__dir_span(dir, t) - (dir->order - 1);
}

void ix__basis_blossom(const ix_dir *dir, int first, const double *args,
                       double *w)
{
    int d = dir->order - 1;

    if (dir->basis == IX_BSPLINE)
        ix__blossom_weights(dir->knots, first + d, d, args, w);
    else
        bezier_triangle(d, args, 1, w);
}

/* Weights of degree e over differences become weights of degree e + 1 over
 * points: the derivative's control point q is (e + 1) / gap times the
 * difference of points q + 1 and q. */
static void undo_difference(const ix_dir *dir, int mu, int e, double *w)
{
    double carry = 0;

    for (int q = 0; q <= e; q++) {
        double gap = 1, v;

        if (dir->basis == IX_BSPLINE)
            gap = dir->knots[mu + 1 + q] - dir->knots[mu - e + q];
        v = w[q] * (e + 1) / gap;
        w[q] = carry - v;
        carry = v;
    }
    w[e + 1] = carry;
}

void ix__basis_derive(const ix_dir *dir, int first, double t, int k, double *w)
{
    int d = dir->order - 1, mu = first + d;

    if (dir->basis == IX_POWER) {
        power_weights(dir->order, t, k, w);
        return;
    }
    if (k > d) {
        for (int i = 0; i <= d; i++)
            w[i] = 0;
        return;
    }
    if (dir->basis == IX_BSPLINE)
        spline_triangle(dir->knots, mu, d - k, &t, 0, w);
    else
        bezier_triangle(d - k, &t, 0, w);
    for (int e = d - k; e < d; e++)
        undo_difference(dir, mu, e, w);
}

/* One level of the triangle: weights of degree r - 1 become those of degree
 * r. */
static void next_level(const ix_dir *dir, int mu, int r, double t, double *w)
{
    double saved = 0;

    for (int q = 0; q < r; q++) {
        double v = w[q];

        if (dir->basis == IX_BSPLINE) {
            double lo = dir->knots[mu + 1 - r + q], hi = dir->knots[mu + 1 + q];

            v /= hi - lo;
            w[q] = saved + (hi - t) * v;
            saved = (t - lo) * v;
        } else {
            w[q] = saved + (1 - t) * v;
            saved = t * v;
        }
    }
    w[r] = saved;
}

void ix__basis_derivs(const ix_dir *dir, int first, double t, int k, double *w)
{
    int order = dir->order, d = order - 1, mu = first + d;

    for (int i = 0; i < (k + 1) * order; i++)
        w[i] = 0;
    w[0] = 1;
    for (int r = 1; r <= d; r++) {
        if (r - 1 >= d - k) /* that of degree d - i goes on as derivative i */
            for (int q = 0; q < r; q++)
                w[(d - r + 1) * order + q] = w[q];
        next_level(dir, mu, r, t, w);
    }
    for (int i = 1; i <= k && i <= d; i++)
        for (int e = d - i; e < d; e++)
            undo_difference(dir, mu, e, w + i * order);
}
