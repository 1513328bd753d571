/* random.h - the pseudo-random numbers of scripts. */
#ifndef BASE_RANDOM_H
#define BASE_RANDOM_H

#include <stdint.h>

/* Uniform in [0, 1): splitmix64 (Steele, Lea, Flood 2014). The state is a
 * counter, any seed is good, the sequence the same on every machine. */
static inline double ix__random_unit(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-53;
}

#endif
