/* dense.c - small dense matrices by columns: Householder QR, one-sided
 * Jacobi. Sizes here are at most a few hundred. */
#include "bern/dense.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static double dot(int n, const double *x, const double *y)
{
    double s = 0.0;

    for (int i = 0; i < n; i++)
        s += x[i] * y[i];
    return s;
}

static void add_multiple(int n, double f, const double *x, double *y)
{
    for (int i = 0; i < n; i++)
        y[i] += f * x[i];
}

/* --- QR ------------------------------------------------------------------- */

/* Turns x[n] into a reflector that maps it to (beta, 0, ..); returns tau. */
static double reflector(int n, double *x)
{
    double norm = sqrt(dot(n, x, x)), beta, v0;

    if (norm == 0.0)
        return 0.0;
    beta = x[0] > 0.0 ? -norm : norm;
    v0 = x[0] - beta;
    for (int i = 1; i < n; i++)
        x[i] /= v0;
    x[0] = beta;
    return -v0 / beta;
}

/* y -= tau v (v.y), v_0 = 1. */
static void reflect(int n, const double *v, double tau, double *y)
{
    double s = tau * (y[0] + dot(n - 1, v + 1, y + 1));

    y[0] -= s;
    add_multiple(n - 1, -s, v + 1, y + 1);
}

void ix__dense_qr(int m, int n, double *a, double *tau)
{
    for (int k = 0; k < n; k++) {
        double *x = a + (size_t)k * (size_t)m + k;

        tau[k] = reflector(m - k, x);
        for (int j = k + 1; j < n; j++)
            reflect(m - k, x, tau[k], a + (size_t)j * (size_t)m + k);
    }
}

void ix__dense_apply(int m, int n, const double *a, const double *tau,
                     double *b)
{
    for (int k = 0; k < n; k++)
        reflect(m - k, a + (size_t)k * (size_t)m + k, tau[k], b + k);
}

int ix__dense_solve(int m, int n, const double *a, double *b)
{
    for (int k = n - 1; k >= 0; k--) {
        const double *col = a + (size_t)k * (size_t)m;

        if (col[k] == 0.0)
            return 0;
        b[k] /= col[k];
        add_multiple(k, -b[k], col, b);
    }
    return 1;
}

/* R' y = x in place. */
static int solve_transposed(int m, int n, const double *a, double *x)
{
    for (int k = 0; k < n; k++) {
        const double *col = a + (size_t)k * (size_t)m;

        if (col[k] == 0.0)
            return 0;
        x[k] = (x[k] - dot(k, col, x)) / col[k];
    }
    return 1;
}

double ix__dense_smallest(int m, int n, const double *a, double *x)
{
    double s = HUGE_VAL;

    for (int i = 0; i < n; i++)
        x[i] = 1.0 + 0.37 * (i % 3); /* any vector that is not special */
    for (int round = 0; round < 4; round++) {
        double norm = sqrt(dot(n, x, x));

        if (!(norm > 0.0 && norm < DBL_MAX))
            return 0.0;
        for (int i = 0; i < n; i++)
            x[i] /= norm;
        if (!solve_transposed(m, n, a, x) || !ix__dense_solve(m, n, a, x))
            return 0.0;
        s = 1.0 / sqrt(sqrt(dot(n, x, x)));
    }
    return s;
}

/* --- singular values ------------------------------------------------------ */

/* Makes columns x and y orthogonal, rotating p and q alike; returns whether
 * they were not. */
static int rotate(int m, double *x, double *y, int n, double *p, double *q)
{
    double a = dot(m, x, x), b = dot(m, y, y), c = dot(m, x, y), z, t, cs, sn;

    if (!(fabs(c) > DBL_EPSILON * sqrt(a) * sqrt(b)))
        return 0;
    z = (b - a) / (2.0 * c);
    t = (z > 0.0 ? 1.0 : -1.0) / (fabs(z) + sqrt(1.0 + z * z));
    cs = 1.0 / sqrt(1.0 + t * t);
    sn = cs * t;
    for (int i = 0; i < m; i++) {
        double u = x[i];

        x[i] = cs * u - sn * y[i];
        y[i] = sn * u + cs * y[i];
    }
    for (int i = 0; i < n; i++) {
        double u = p[i];

        p[i] = cs * u - sn * q[i];
        q[i] = sn * u + cs * q[i];
    }
    return 1;
}

static void swap(int n, double *x, double *y)
{
    for (int i = 0; i < n; i++) {
        double t = x[i];

        x[i] = y[i];
        y[i] = t;
    }
}

void ix__dense_singular(int m, int n, double *a, double *s, double *v)
{
    size_t lm = (size_t)m, ln = (size_t)n;
    int again = 1;

    memset(v, 0, ln * ln * sizeof *v);
    for (size_t i = 0; i < ln; i++)
        v[i * ln + i] = 1.0;
    for (int sweep = 0; sweep < 60 && again; sweep++) {
        again = 0;
        for (size_t i = 0; i + 1 < ln; i++)
            for (size_t j = i + 1; j < ln; j++)
                again |= rotate(m, a + i * lm, a + j * lm, n, v + i * ln,
                                v + j * ln);
    }
    for (size_t i = 0; i < ln; i++)
        s[i] = sqrt(dot(m, a + i * lm, a + i * lm));
    for (size_t i = 0; i + 1 < ln; i++) {
        size_t top = i;

        for (size_t j = i + 1; j < ln; j++)
            top = s[j] > s[top] ? j : top;
        if (top == i)
            continue;
        swap(1, s + i, s + top);
        swap(m, a + i * lm, a + top * lm);
        swap(n, v + i * ln, v + top * ln);
    }
}
