/* second_order.c - one equation freed of its second-order terms by the others.
 *
 * Where the Jacobian is singular, a constant combination of the equations has
 * no gradient, but on a box of size h it is still of size h^2, although on the
 * curve that the other equations define it may be h^3 or less: the box cannot
 * follow a curve that is not parallel to its edges. Subtracting the other
 * equations times linear functions removes those terms. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "solve/system_impl.h"

#define UNIT (DBL_EPSILON / 2)

/* Mean of the second derivative of c by x_j and x_k. */
static double mean_second(const ix__shape *s, const double *c, int j, int k)
{
    size_t a = s->stride[j], b = s->stride[k];
    int da = s->dims[j] - 1, db = s->dims[k] - 1;
    double sum = 0;
    size_t n = 0;

    for (size_t i = 0; i < s->size; i++) {
        int ij = (int)(i / a) % (da + 1), ik = (int)(i / b) % (db + 1);

        if (j == k ? ij + 2 > da : ij == da || ik == db)
            continue;
        sum += c[i + a + b] - c[i + a] - c[i + b] + c[i];
        n++;
    }
    return n == 0 ? 0 : sum / (double)n * da * (j == k ? da - 1 : db);
}

static double dot(int n, const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Gradients l[k] of the multipliers: with unit gradients e_k of length s_k,
 * l_k = (H e_k - 1/2 sum_l (e_l H e_k) e_l) / s_k cancels all of the matrix H
 * of second derivatives but its part along the null vector. False: some s_k is
 * as small as the weak one. */
static bool multipliers(int n, const ix__combined *g, int weak, ix__mat grad,
                        ix__mat l)
{
    ix__mat h, e;
    double len[IX_MAX_UNKNOWNS], least = 0;

    for (int j = 0; j < n; j++)
        for (int k = j; k < n; k++)
            h[j][k] = h[k][j] = mean_second(&g[weak].shape, g[weak].c, j, k);
    least = 4 * sqrt(dot(n, grad[weak], grad[weak]));
    for (int k = 0; k < n; k++) {
        len[k] = sqrt(dot(n, grad[k], grad[k]));
        if (k == weak)
            continue;
        if (!(len[k] > least))
            return false;
        for (int j = 0; j < n; j++)
            e[k][j] = grad[k][j] / len[k];
    }
    for (int k = 0; k < n; k++) {
        double he[IX_MAX_UNKNOWNS];

        memset(l[k], 0, sizeof l[k]);
        if (k == weak)
            continue;
        for (int j = 0; j < n; j++)
            he[j] = l[k][j] = dot(n, h[j], e[k]);
        for (int i = 0; i < n; i++)
            for (int j = 0; i != weak && j < n; j++)
                l[k][j] -= 0.5 * dot(n, e[i], he) * e[i][j];
        for (int j = 0; j < n; j++)
            l[k][j] /= len[k];
    }
    return true;
}

/* out (one row more in direction j) = f (x_j - 1/2), or f if not times. */
static void raise(const ix__shape *s, int j, bool times, const double *f,
                  double *out)
{
    size_t inner = s->stride[j], m = (size_t)s->dims[j];
    double sign = times ? -0.5 : 1, half = times ? 0.5 : 1;

    for (size_t o = 0; o < s->size / (inner * m); o++)
        for (size_t k = 0; k <= m; k++) {
            double up = half * (double)k / (double)m;
            double down = sign * (double)(m - k) / (double)m;
            const double *p = f + (o * m + k) * inner;
            double *q = out + (o * (m + 1) + k) * inner;

            for (size_t i = 0; i < inner; i++)
                q[i] = (k > 0 ? up * p[i - inner] : 0) +
                       (k < m ? down * p[i] : 0);
        }
}

/* f (or f (x_j - 1/2)) with one degree more everywhere, in `to` of two. */
static double *raise_all(ix__shape s, int j, const double *f, double *a,
                         double *b)
{
    for (int d = 0; d < s.n; d++) {
        int dims[IX_MAX_UNKNOWNS];
        double *t = a;

        raise(&s, d, d == j, f, a);
        f = a;
        a = b;
        b = t;
        memcpy(dims, s.dims, sizeof dims);
        dims[d]++;
        ix__shape_init(&s, s.n, dims);
    }
    return b;
}

/* sum l[k][j] g_k; the error and size of the sum are added to *err and *mag. */
static void mix(int n, const ix__combined *g, ix__mat l, int j, double *out,
                double *err, double *mag)
{
    memset(out, 0, g[0].shape.size * sizeof *out);
    for (int k = 0; k < n; k++) {
        double w = l[k][j];

        for (size_t t = 0; w != 0 && t < g[k].shape.size; t++)
            out[t] += w * g[k].c[t];
        *err += 0.5 * fabs(w) * g[k].err;
        *mag += 0.5 * fabs(w) * g[k].mag;
    }
}

void ix__second_order(int n, const ix__combined *g, int weak, ix__mat grad,
                      double *work, ix__combined *out)
{
    const ix__shape *s = &g[0].shape;
    int dims[IX_MAX_UNKNOWNS] = {0};
    double *first, lo, hi;
    ix__mat l;

    for (int j = 0; j < n; j++)
        dims[j] = s->dims[j] + 1;
    ix__shape_init(&out->shape, n, dims);
    out->err = g[weak].err;
    out->mag = g[weak].mag;
    memset(l, 0, sizeof l);
    if (!multipliers(n, g, weak, grad, l))
        memset(l, 0, sizeof l);
    first = raise_all(*s, -1, g[weak].c, work, work + out->shape.size);
    memcpy(out->c, first, out->shape.size * sizeof *first);
    for (int j = 0; j < n; j++) {
        double *a = work, *b = work + out->shape.size, *sum = b;
        double *p;

        mix(n, g, l, j, sum, &out->err, &out->mag);
        p = raise_all(*s, j, sum, a, b);
        for (size_t t = 0; t < out->shape.size; t++)
            out->c[t] -= p[t];
    }
    /* products and sums, 3 roundings in each elevation, the n + 1 terms */
    out->err += (6 * n + 4) * UNIT * out->mag;
    ix__tensor_range(&out->shape, out->c, &lo, &hi);
    out->mag = ix__larger(-lo, hi);
}
