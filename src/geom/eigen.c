/* eigen.c - cyclic Jacobi iteration; ends when a sweep finds nothing to turn,
 * which takes five to ten sweeps at any size. */
#include "geom/eigen.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* Rows p, q of m[.][n] turned by (c, s). */
static void turn_rows(int n, double *m, int p, int q, double c, double s)
{
    for (int i = 0; i < n; i++) {
        double x = m[p * n + i], y = m[q * n + i];

        m[p * n + i] = c * x - s * y;
        m[q * n + i] = s * x + c * y;
    }
}

/* Makes a[p][q] zero by a turn of the plane p, q. */
static void turn(int n, double *a, double *v, int p, int q)
{
    double theta = (a[q * n + q] - a[p * n + p]) / (2 * a[p * n + q]);
    double t = copysign(1, theta) / (fabs(theta) + hypot(1, theta));
    double c = 1 / hypot(1, t), s = t * c;

    turn_rows(n, a, p, q, c, s);
    for (int i = 0; i < n; i++) {
        double x = a[i * n + p], y = a[i * n + q];

        a[i * n + p] = c * x - s * y;
        a[i * n + q] = s * x + c * y;
    }
    a[p * n + q] = a[q * n + p] = 0;
    turn_rows(n, v, p, q, c, s);
}

static bool sweep(int n, double *a, double *v)
{
    bool turned = false;

    for (int p = 0; p < n; p++)
        for (int q = p + 1; q < n; q++) {
            double off = fabs(a[p * n + q]);

            if (off > DBL_EPSILON * 0.25 *
                          sqrt(fabs(a[p * n + p]) * fabs(a[q * n + q])) &&
                off > DBL_MIN) {
                turn(n, a, v, p, q);
                turned = true;
            }
        }
    return turned;
}

static void sort(int n, double *w, double *v)
{
    for (int i = 0; i < n; i++) {
        int top = i;

        for (int j = i + 1; j < n; j++)
            if (w[j] > w[top])
                top = j;
        for (int k = 0; top != i && k < n; k++) {
            double x = v[i * n + k];

            v[i * n + k] = v[top * n + k];
            v[top * n + k] = x;
        }
        if (top != i) {
            double x = w[i];

            w[i] = w[top];
            w[top] = x;
        }
    }
}

static void orient(int n, double *v)
{
    int top = 0;

    for (int k = 1; k < n; k++) /* 1 + 1e-12: ties go to the first */
        if (fabs(v[k]) > fabs(v[top]) * (1 + 1e-12))
            top = k;
    if (v[top] < 0)
        for (int k = 0; k < n; k++)
            v[k] = -v[k];
}

void ix__eigen_symmetric(int n, double *a, double *values, double *vectors)
{
    for (int i = 0; i < n * n; i++)
        vectors[i] = i % (n + 1) == 0;
    for (int round = 0; round < 64 && sweep(n, a, vectors); round++)
        continue;
    for (int i = 0; i < n; i++)
        values[i] = a[i * n + i];
    sort(n, values, vectors);
    for (int i = 0; i < n; i++)
        orient(n, vectors + i * n);
}
