/* tasks.h - the input of the tasks on which iritx is timed against other
 * libraries, the same numbers for all of them. Plain C and C++, no library. */
#ifndef BENCH_PEERS_TASKS_H
#define BENCH_PEERS_TASKS_H

#include <math.h>
#include <stdlib.h>

#define TASK_DEGREE 3
#define TASK_FIT    1000 /* control points of the fitted curve */
#define TASK_TOL    1e-4 /* of contours, in the unit of the surface */

/* The sizes of each task: control points of a curve, or of each direction of a
 * surface; points to fit. Each doubles, so that growth can be seen. */
static const int task_meet_n[] = {8, 16, 32, 64, 128, 256};
static const int task_crv_n[] = {16, 32, 64, 1024};
static const int task_srf_n[] = {8, 16, 32};
static const int task_fit_n[] = {10000, 20000, 40000};
#define TASK_COUNT(a) ((int)(sizeof(a) / sizeof *(a)))

/* Open uniform knots 0 .. n - 3 of a cubic with n control points, [n + 4]. */
static inline void task_knots(int n, double *kv)
{
    for (int i = 0; i < n + TASK_DEGREE + 1; i++) {
        int k = i - TASK_DEGREE;

        kv[i] = k < 0 ? 0 : k > n - TASK_DEGREE ? n - TASK_DEGREE : k;
    }
}

/* Two planar waves that cross about n / 2 times; x[n], y[n]. */
static inline void task_meet_curve(int which, int n, double *x, double *y)
{
    for (int i = 0; i < n; i++) {
        x[i] = which ? i + 0.3 * sin(2.0 * i) : i;
        y[i] = which ? 0.8 * sin(0.9 * i + 1) : sin(1.7 * i);
    }
}

/* A space curve that winds around the point below. */
static inline void task_curve(int n, double *x, double *y, double *z)
{
    for (int i = 0; i < n; i++) {
        double a = 12.0 * i / n;

        x[i] = (2 + sin(5 * a)) * cos(a);
        y[i] = (2 + cos(3 * a)) * sin(a);
        z[i] = 0.1 * a;
    }
}
static const double task_point[3] = {0.4, 0.3, 0.5};

/* A surface over [0, 1]^2 with hills, [n * n], u fastest. */
static inline void task_surface(int n, double *x, double *y, double *z)
{
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            int k = j * n + i;

            x[k] = i / (n - 1.0);
            y[k] = j / (n - 1.0);
            z[k] = 0.2 * sin(9 * x[k]) * cos(7 * y[k]) + 0.1 * x[k];
        }
}
static const double task_point_srf[3] = {0.55, 0.4, 0.6};
static const double task_level = 0.08; /* of z */

/* n points of a closed curve in space with some noise. */
static inline void task_cloud(int n, double *x, double *y, double *z)
{
    unsigned seed = 1;

    for (int i = 0; i < n; i++) {
        double a = 100.0 * i / n;

        x[i] = (10 + sin(3 * a)) * cos(a);
        y[i] = (10 + cos(2 * a)) * sin(a);
        seed = seed * 1664525u + 1013904223u;
        z[i] = a + 1e-3 * (seed / 4294967296.0 - 0.5);
    }
}

#endif
