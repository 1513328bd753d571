/* small.c - linear algebra on matrices of at most 6 x 6. */
#include "solve/small.h"

#include <math.h>
#include <string.h>

#define SINGULAR 1e-9 /* of the largest pivot; see the header */

static void swap_rows(int n, ix__mat a, int i, int k)
{
    for (int j = 0; j < n; j++) {
        double t = a[i][j];

        a[i][j] = a[k][j];
        a[k][j] = t;
    }
}

static int pivot_row(int n, ix__mat a, int c)
{
    int best = c;

    for (int i = c + 1; i < n; i++)
        if (fabs(a[i][c]) > fabs(a[best][c]))
            best = i;
    return best;
}

static void eliminate(int n, ix__mat a, ix__mat inv, int c)
{
    double p = 1 / a[c][c];

    for (int j = 0; j < n; j++) {
        a[c][j] *= p;
        inv[c][j] *= p;
    }
    for (int i = 0; i < n; i++) {
        double f = a[i][c];

        if (i == c || f == 0)
            continue;
        for (int j = 0; j < n; j++) {
            a[i][j] -= f * a[c][j];
            inv[i][j] -= f * inv[c][j];
        }
    }
}

/* The same in closed form for two rows: with rows scaled to size 1, the pivots
 * are the larger entry of the first column and the determinant over it. */
static bool invert_two(ix__mat a, ix__mat inv)
{
    double m0 = fmax(fabs(a[0][0]), fabs(a[0][1]));
    double m1 = fmax(fabs(a[1][0]), fabs(a[1][1])), p, det, d;

    if (!(m0 > 0 && m1 > 0))
        return false;
    det = a[0][0] / m0 * (a[1][1] / m1) - a[0][1] / m0 * (a[1][0] / m1);
    p = fmax(fabs(a[0][0] / m0), fabs(a[1][0] / m1));
    d = fabs(det) / p;
    if (!(fmin(p, d) > SINGULAR * fmax(p, d)))
        return false;
    inv[0][0] = a[1][1] / m1 / det / m0;
    inv[0][1] = -a[0][1] / m0 / det / m1;
    inv[1][0] = -a[1][0] / m1 / det / m0;
    inv[1][1] = a[0][0] / m0 / det / m1;
    return true;
}

bool ix__small_invert(int n, ix__mat a, ix__mat inv)
{
    double largest = 0, smallest = HUGE_VAL;
    ix__mat w;

    if (n == 2)
        return invert_two(a, inv);
    memcpy(w, a, (size_t)n * sizeof *w);
    memset(inv, 0, (size_t)n * sizeof *w);
    for (int i = 0; i < n; i++) {
        double m = 0;

        for (int j = 0; j < n; j++)
            m = fmax(m, fabs(w[i][j]));
        if (!(m > 0))
            return false;
        inv[i][i] = 1 / m;
        for (int j = 0; j < n; j++)
            w[i][j] /= m;
    }
    for (int c = 0; c < n; c++) {
        int r = pivot_row(n, w, c);
        double p = fabs(w[r][c]);

        largest = fmax(largest, p);
        smallest = fmin(smallest, p);
        if (!(smallest > SINGULAR * largest))
            return false;
        swap_rows(n, w, r, c);
        swap_rows(n, inv, r, c);
        eliminate(n, w, inv, c);
    }
    return true;
}

/* Rotates rows i and k of w (and of u) so that they become orthogonal. */
static bool rotate(int n, ix__mat w, ix__mat u, int i, int k)
{
    double a = 0, b = 0, g = 0, z, t, c, s;

    for (int j = 0; j < n; j++) {
        a += w[i][j] * w[i][j];
        b += w[k][j] * w[k][j];
        g += w[i][j] * w[k][j];
    }
    if (!(fabs(g) > 1e-15 * sqrt(a * b)))
        return false;
    z = (b - a) / (2 * g);
    t = (z >= 0 ? 1 : -1) / (fabs(z) + sqrt(1 + z * z));
    c = 1 / sqrt(1 + t * t);
    s = c * t;
    for (int j = 0; j < n; j++) {
        double x = w[i][j], y = w[k][j], p = u[i][j], q = u[k][j];

        w[i][j] = c * x - s * y;
        w[k][j] = s * x + c * y;
        u[i][j] = c * p - s * q;
        u[k][j] = s * p + c * q;
    }
    return true;
}

void ix__small_left_vectors(int n, ix__mat a, ix__mat u)
{
    ix__mat w;
    bool again = true;

    memcpy(w, a, sizeof w);
    memset(u, 0, sizeof(ix__mat));
    for (int i = 0; i < n; i++)
        u[i][i] = 1;
    for (int sweep = 0; again && sweep < 30; sweep++) {
        again = false;
        for (int i = 0; i < n; i++)
            for (int k = i + 1; k < n; k++)
                again |= rotate(n, w, u, i, k);
    }
}
