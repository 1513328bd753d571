/* conv.c - products of homogeneous forms: convolutions.
 *
 * A block of coefficients of the result stays in registers while the sum runs
 * over the first factor; the second factor stands between zeros, so no index
 * needs a test. Each coefficient adds its terms in the order of the first
 * factor, whatever the width of the vectors: the bits are the same on every
 * machine. */
#include <string.h>

#include "bern/bern.h"
#include "bern/clones.h"

/* acc[l] = sum over lo <= i < hi of a[i] b[l - i], l = 0 .. 15. */
IX__INLINE void dense16(int lo, int hi, const double *a, const double *b,
                        double *acc)
{
    ix__v4 s0 = {0}, s1 = {0}, s2 = {0}, s3 = {0};

    for (int i = lo; i < hi; i++) {
        const ix__v4 *x = ix__cvec(b - i);

        s0 += a[i] * x[0];
        s1 += a[i] * x[1];
        s2 += a[i] * x[2];
        s3 += a[i] * x[3];
    }
    ix__vec(acc)[0] = s0;
    ix__vec(acc)[1] = s1;
    ix__vec(acc)[2] = s2;
    ix__vec(acc)[3] = s3;
}

IX__INLINE void dense8(int lo, int hi, const double *a, const double *b,
                       double *acc)
{
    ix__v4 s0 = {0}, s1 = {0};

    for (int i = lo; i < hi; i++) {
        const ix__v4 *x = ix__cvec(b - i);

        s0 += a[i] * x[0];
        s1 += a[i] * x[1];
    }
    ix__vec(acc)[0] = s0;
    ix__vec(acc)[1] = s1;
}

IX__INLINE void put(int n, const double *acc, ix__into into, double *out)
{
    if (into == IX__SET)
        for (int l = 0; l < n; l++)
            out[l] = acc[l];
    else if (into == IX__ADD)
        for (int l = 0; l < n; l++)
            out[l] += acc[l];
    else
        for (int l = 0; l < n; l++)
            out[l] -= acc[l];
}

IX__INLINE int min_int(int a, int b)
{
    return a < b ? a : b;
}

/* One pair: b stands between zeros. Terms outside the window are zero. */
IX__INLINE void conv_one(int p, const double *a, int q, const double *b,
                         ix__into into, double *out)
{
    double acc[16];
    int n = p + q + 1, k = 0;

    for (; k + 16 <= n; k += 16) {
        int lo = k > q ? k - q : 0, hi = min_int(p, k + 15) + 1;

        if (into == IX__SET) {
            dense16(lo, hi, a, b + k, out + k);
        } else {
            dense16(lo, hi, a, b + k, acc);
            put(16, acc, into, out + k);
        }
    }
    if (k + 8 < n) {
        dense16(k > q ? k - q : 0, min_int(p, k + 15) + 1, a, b + k, acc);
        put(n - k, acc, into, out + k);
    } else if (k < n) {
        dense8(k > q ? k - q : 0, min_int(p, k + 7) + 1, a, b + k, acc);
        put(n - k, acc, into, out + k);
    }
}

IX__CLONES static void conv_spans(size_t n, int p, const double *a, int q,
                                  const double *b, ix__into into, double *mid,
                                  double *out)
{
    for (size_t s = 0; s < n; s++) {
        memcpy(mid, b, ((size_t)q + 1) * sizeof *mid);
        conv_one(p, a, q, mid, into, out);
        a += p + 1;
        b += q + 1;
        out += p + q + 1;
    }
}

/* Degrees known when compiled, p <= q <= SMALL: all coefficients stay in
 * registers; the terms of each in the order of a, as above. */
enum { SMALL = 6 };

IX__INLINE void conv_fixed(size_t n, const int p, const double *a, const int q,
                           const double *b, ix__into into, double *out)
{
    for (size_t s = 0; s < n; s++) {
        double acc[2 * SMALL + 1] = {0};

#pragma GCC unroll 7
        for (int i = 0; i <= p; i++)
#pragma GCC unroll 7
            for (int j = 0; j <= q; j++)
                acc[i + j] += a[i] * b[j];
        put(p + q + 1, acc, into, out);
        a += p + 1;
        b += q + 1;
        out += p + q + 1;
    }
}

#define FIXED(p, q)                           \
    case (p) * (SMALL + 1) + (q):             \
        conv_fixed(n, p, a, q, b, into, out); \
        return true

/* False if there is no such kernel. */
static bool conv_small(size_t n, int p, const double *a, int q, const double *b,
                       ix__into into, double *out)
{
    if (q > SMALL)
        return false;
    switch (p * (SMALL + 1) + q) {
        FIXED(1, 1);
        FIXED(1, 2);
        FIXED(1, 3);
        FIXED(1, 4);
        FIXED(1, 5);
        FIXED(1, 6);
        FIXED(2, 2);
        FIXED(2, 3);
        FIXED(2, 4);
        FIXED(2, 5);
        FIXED(2, 6);
        FIXED(3, 3);
        FIXED(3, 4);
        FIXED(3, 5);
        FIXED(3, 6);
        FIXED(4, 4);
        FIXED(4, 5);
        FIXED(4, 6);
        FIXED(5, 5);
        FIXED(5, 6);
        FIXED(6, 6);
    default:
        return false;
    }
}

void ix__bern_conv_spans(size_t n, int p, const double *a, int q,
                         const double *b, ix__into into, double *work,
                         double *out)
{
    int m = p > q ? p : q;

    if (p <= q ? conv_small(n, p, a, q, b, into, out)
               : conv_small(n, q, b, p, a, into, out))
        return;
    memset(work, 0, (size_t)(m + 1 + 2 * IX__BERN_PAD) * sizeof *work);
    if (p <= q)
        conv_spans(n, p, a, q, b, into, work + IX__BERN_PAD, out);
    else
        conv_spans(n, q, b, p, a, into, work + IX__BERN_PAD, out);
}

IX__CLONES void ix__bern_conv_sparse(int na, const double *a, const int *off,
                                     int nb, const double *b, int nout,
                                     double *out)
{
    int lo = 0, hi = 0;

    for (int k = 0; k < nout; k += 16) {
        ix__v4 s0 = {0}, s1 = {0}, s2 = {0}, s3 = {0};

        while (hi < na && off[hi] <= k + 15)
            hi++;
        while (lo < hi && off[lo] <= k - nb)
            lo++;
        for (int i = lo; i < hi; i++) {
            const ix__v4 *x = ix__cvec(b + (k - off[i]));

            s0 += a[i] * x[0];
            s1 += a[i] * x[1];
            s2 += a[i] * x[2];
            s3 += a[i] * x[3];
        }
        ix__vec(out + k)[0] = s0;
        ix__vec(out + k)[1] = s1;
        ix__vec(out + k)[2] = s2;
        ix__vec(out + k)[3] = s3;
    }
}
