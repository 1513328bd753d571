/* test.c - random numbers and closeness for tests. */
#include "harness/test.h"

#include <stdlib.h>

ix_rng ix_rng_new(uint64_t seed)
{
    const char *s = getenv("IX_TEST_SEED");

    if (s)
        seed = strtoull(s, NULL, 0);
    return (ix_rng){seed};
}

/* splitmix64 (Steele, Lea, Flood 2014): any seed is good. */
uint64_t ix_rng_next(ix_rng *r)
{
    uint64_t z = (r->s += 0x9e3779b97f4a7c15u);

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double ix_rng_unit(ix_rng *r)
{
    return (double)(ix_rng_next(r) >> 11) * 0x1p-53;
}

double ix_rng_range(ix_rng *r, double lo, double hi)
{
    return lo + (hi - lo) * ix_rng_unit(r);
}

int ix_rng_int(ix_rng *r, int lo, int hi)
{
    return lo + (int)(ix_rng_next(r) % (uint64_t)(hi - lo + 1));
}

int ix_close(double a, double b, double tol)
{
    double s = fmax(1.0, fmax(fabs(a), fabs(b)));

    return fabs(a - b) <= tol * s;
}
