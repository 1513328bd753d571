/* num_impl.h - what reading and printing of numbers share: powers of ten and
 * unsigned integers of a fixed size, large enough for every exact decision
 * about a double. */
#ifndef BASE_NUM_IMPL_H
#define BASE_NUM_IMPL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

__extension__ typedef unsigned __int128 ix_u128;

/* 10^k for IX_POW10_MIN <= k <= IX_POW10_MAX as a 128-bit number g (high word
 * first) with 2^127 <= g and 10^k = (g - f) 2^(ix__log2_pow10(k) - 127),
 * 0 <= f < 1; f = 0 exactly for 0 <= k <= IX_POW10_EXACT. */
#define IX_POW10_MIN   (-343)
#define IX_POW10_MAX   324
#define IX_POW10_EXACT 55
extern const uint64_t ix__pow10[IX_POW10_MAX - IX_POW10_MIN + 1][2];

/* floor(log2(10^k)), |k| < 1234. */
static inline int ix__log2_pow10(int k)
{
    return (k * 1741647) >> 19;
}

/* sum of w[i] 2^(64 i), i < n, the leading word not 0. No operation here gets
 * numbers beyond 2700 bits: 771 digits times 2^20, or 54 bits times 5^1095. */
#define IX_BIG_WORDS 64
typedef struct {
    int n;
    uint64_t w[IX_BIG_WORDS];
} ix_big;

void ix__big_set(ix_big *b, uint64_t v);
void ix__big_mul_add(ix_big *b, uint64_t mul, uint64_t add);
void ix__big_mul_pow5(ix_big *b, int k);
void ix__big_shift(ix_big *b, int bits);           /* times 2^bits */
uint64_t ix__big_div(ix_big *b, uint64_t d);       /* quotient; the remainder */
int ix__big_cmp(const ix_big *a, const ix_big *b); /* -1, 0, 1 */

/* Decimal digits of v, at least one, at most 20; returns their number. */
int ix__num_digits(uint64_t v, char *out);

/* A finite v > 0 as m 2^e with the least m such that e >= -1074. */
static inline uint64_t ix__num_split(uint64_t bits, int *e)
{
    uint64_t m = bits & 0xfffffffffffffu;
    int field = (int)(bits >> 52 & 0x7ff);

    *e = field ? field - 1075 : -1074;
    return field ? m | 0x10000000000000u : m;
}

#endif
