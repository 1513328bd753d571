/* num_big.c - unsigned integers of up to 4096 bits, for the few decisions
 * about decimal numbers that 128 bits leave open. */
#include <assert.h>
#include <string.h>

#include "base/num_impl.h"

void ix__big_set(ix_big *b, uint64_t v)
{
    b->n = v != 0;
    b->w[0] = v;
}

void ix__big_mul_add(ix_big *b, uint64_t mul, uint64_t add)
{
    uint64_t carry = add;

    for (int i = 0; i < b->n; i++) {
        ix_u128 t = (ix_u128)b->w[i] * mul + carry;

        b->w[i] = (uint64_t)t;
        carry = (uint64_t)(t >> 64);
    }
    if (carry) {
        assert(b->n < IX_BIG_WORDS);
        b->w[b->n++] = carry;
    }
}

void ix__big_mul_pow5(ix_big *b, int k)
{
    const uint64_t pow27 = 7450580596923828125u; /* 5^27 */
    uint64_t rest = 1;

    for (; k >= 27; k -= 27)
        ix__big_mul_add(b, pow27, 0);
    for (; k > 0; k--)
        rest *= 5;
    ix__big_mul_add(b, rest, 0);
}

void ix__big_shift(ix_big *b, int bits)
{
    int words = bits / 64;

    ix__big_mul_add(b, (uint64_t)1 << bits % 64, 0);
    if (b->n == 0 || words == 0)
        return;
    assert(b->n + words <= IX_BIG_WORDS);
    memmove(b->w + words, b->w, (size_t)b->n * sizeof *b->w);
    memset(b->w, 0, (size_t)words * sizeof *b->w);
    b->n += words;
}

uint64_t ix__big_div(ix_big *b, uint64_t d)
{
    ix_u128 rest = 0;

    for (int i = b->n - 1; i >= 0; i--) {
        rest = rest << 64 | b->w[i];
        b->w[i] = (uint64_t)(rest / d);
        rest %= d;
    }
    while (b->n > 0 && b->w[b->n - 1] == 0)
        b->n--;
    return (uint64_t)rest;
}

int ix__big_cmp(const ix_big *a, const ix_big *b)
{
    if (a->n != b->n)
        return a->n < b->n ? -1 : 1;
    for (int i = a->n - 1; i >= 0; i--)
        if (a->w[i] != b->w[i])
            return a->w[i] < b->w[i] ? -1 : 1;
    return 0;
}
