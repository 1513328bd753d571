/* common.c - points and curves that all equations share. */
#include "solve/common.h"

#include <math.h>
#include <string.h>

#include "solve/small.h"

#define VANISHES 1e-12 /* of the tensors' size 1: some 1000 roundings */
#define WEAK     1e-6  /* of the longest gradient: dependent */
#define STEPS    12

static double dot(int n, const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Equations and gradients at x, rotated until the gradients w[n] are
 * orthogonal; *weak the shortest one's row. */
static void rotated(const ix__shape *s, const double *f, const double *x,
                    double *v, ix__mat w, int *weak, double *work)
{
    double value[IX_MAX_UNKNOWNS];
    int n = s->n;
    ix__mat jac, u;

    for (int i = 0; i < n; i++) {
        value[i] = ix__tensor_value(s, f + (size_t)i * s->size, x, work);
        ix__tensor_gradient(s, f + (size_t)i * s->size, x, jac[i], work);
    }
    ix__small_left_vectors(n, jac, u);
    *weak = 0;
    for (int i = 0; i < n; i++) {
        v[i] = dot(n, u[i], value);
        for (int j = 0; j < n; j++) {
            w[i][j] = 0;
            for (int k = 0; k < n; k++)
                w[i][j] += u[i][k] * jac[k][j];
        }
        if (dot(n, w[i], w[i]) < dot(n, w[*weak], w[*weak]))
            *weak = i;
    }
}

/* One Newton step of least length by all equations but the weak one. The
 * largest value before it, more than VANISHES if the weak gradient is not
 * dependent on the others; infinity if another one is weak too. */
static double step(const ix__shape *s, const double *f, double *x, ix__mat w,
                   int *weak, double *work)
{
    double v[IX_MAX_UNKNOWNS], size = 0, longest = 0;

    rotated(s, f, x, v, w, weak, work);
    for (int i = 0; i < s->n; i++) {
        longest = ix__larger(longest, dot(s->n, w[i], w[i]));
        size = ix__larger(size, fabs(v[i]));
    }
    for (int i = 0; i < s->n; i++) {
        double len = dot(s->n, w[i], w[i]);

        if (i == *weak)
            continue;
        if (!(len > WEAK * WEAK * longest))
            return HUGE_VAL;
        for (int j = 0; j < s->n; j++)
            x[j] -= v[i] / len * w[i][j];
    }
    if (dot(s->n, w[*weak], w[*weak]) > WEAK * WEAK * longest)
        size = ix__larger(size, 2 * VANISHES);
    return size;
}

static bool settle(const ix__shape *s, const double *f, double *x, ix__mat w,
                   int *weak, double *work)
{
    for (int it = 0; it < STEPS; it++) {
        double size = step(s, f, x, w, weak, work);

        for (int j = 0; j < s->n; j++)
            if (!(x[j] >= -0.5 && x[j] <= 1.5))
                return false;
        if (size <= VANISHES)
            return true;
    }
    return false;
}

bool ix__common_point(const ix__shape *s, const double *f, double *x,
                      double *work)
{
    ix__mat w;
    int weak;

    return settle(s, f, x, w, &weak, work);
}

/* The unit vector that is orthogonal to all w but the weak one: what these
 * leave of the unit vector of which they leave most. */
static void null_vector(int n, ix__mat w, int weak, double *t)
{
    double best = 0;

    for (int j = 0; j < n; j++) {
        double e[IX_MAX_UNKNOWNS] = {0}, len;

        e[j] = 1;
        for (int i = 0; i < n; i++) {
            double part = w[i][j] / dot(n, w[i], w[i]);

            for (int k = 0; i != weak && k < n; k++)
                e[k] -= part * w[i][k];
        }
        len = sqrt(dot(n, e, e));
        for (int k = 0; len > best && k < n; k++)
            t[k] = e[k] / len;
        best = ix__larger(best, len);
    }
}

bool ix__common_curve(const ix__shape *s, const double *f, const double *x,
                      double *work)
{
    static const double steps[] = {0x1p-4, -0x1p-4, 0x1p-6, -0x1p-6};
    double at[IX_MAX_UNKNOWNS], t[IX_MAX_UNKNOWNS] = {0};
    int weak, tried = 0;
    ix__mat w;

    memcpy(at, x, (size_t)s->n * sizeof *at);
    if (!settle(s, f, at, w, &weak, work))
        return false;
    null_vector(s->n, w, weak, t);
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
        double y[IX_MAX_UNKNOWNS], away = 0;
        bool in = true;

        for (int j = 0; j < s->n; j++) {
            y[j] = at[j] + steps[k] * t[j];
            in &= y[j] >= 0 && y[j] <= 1;
        }
        if (!in)
            continue;
        if (!settle(s, f, y, w, &weak, work))
            return false;
        for (int j = 0; j < s->n; j++)
            away += (y[j] - at[j]) * t[j];
        if (!(fabs(away) > 0.5 * fabs(steps[k])))
            return false;
        tried++;
    }
    return tried >= 2;
}
