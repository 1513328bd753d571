/* weigh.c - a weighted sum of neighbouring rows. Sums go over q in order for
 * every l, however many lanes are taken at once. */
#include "bsp/weigh.h"

#include "bern/clones.h"

static double one(size_t inner, int n, const double *w, const double *in,
                  double ref)
{
    double sum = 0;

    for (int q = 0; q < n; q++)
        sum += w[q] * (in[(size_t)q * inner] - ref);
    return ref + sum;
}

/* Eight lanes at a time: the sums of two vectors run side by side. */
IX__CLONES static void lanes(size_t inner, int n, const double *w,
                             const double *in, const double *ref, double *out)
{
    for (size_t l = 0; l + 8 <= inner; l += 8) {
        ix__v4 a = {0}, b = {0}, ra = *ix__cvec(ref + l);
        ix__v4 rb = *ix__cvec(ref + l + 4);

        for (int q = 0; q < n; q++) {
            const double *p = in + (size_t)q * inner + l;

            a += w[q] * (*ix__cvec(p) - ra);
            b += w[q] * (*ix__cvec(p + 4) - rb);
        }
        *ix__vec(out + l) = ra + a;
        *ix__vec(out + l + 4) = rb + b;
    }
}

IX__CLONES static void plain_lanes(size_t inner, int n, const double *w,
                                   const double *in, double *out)
{
    for (size_t l = 0; l + 8 <= inner; l += 8) {
        ix__v4 a = {0}, b = {0};

        for (int q = 0; q < n; q++) {
            const double *p = in + (size_t)q * inner + l;

            a += w[q] * *ix__cvec(p);
            b += w[q] * *ix__cvec(p + 4);
        }
        *ix__vec(out + l) = a;
        *ix__vec(out + l + 4) = b;
    }
}

void ix__weigh(size_t inner, int n, const double *w, const double *in,
               const double *ref, double *out)
{
    size_t l = inner / 8 * 8;

    if (inner == 1) {
        *out = one(1, n, w, in, ref ? *ref : 0);
        return;
    }
    if (l > 0 && ref)
        lanes(inner, n, w, in, ref, out);
    else if (l > 0)
        plain_lanes(inner, n, w, in, out);
    for (; l < inner; l++)
        out[l] = one(inner, n, w, in + l, ref ? ref[l] : 0);
}
