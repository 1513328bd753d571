/* num_parse.c - decimal text to the nearest double, whatever the locale.
 *
 * The first 19 digits times a 64-bit power of ten bracket the number so
 * tightly that both ends round to the same double, but for one case in some
 * hundreds; then a comparison of big integers decides (the idea of Eisel and
 * of Lemire 2021, "Number parsing at a gigabyte per second", with the exact
 * bracket in place of the case analysis). */
#include <string.h>

#include "iritx/base.h"

#include "base/num_impl.h"

#define DIGITS     19  /* that always fit a word */
#define BIG_DIGITS 770 /* beyond them a digit counts only as "not zero" */
#define FAR        (1LL << 60) /* exponents saturate here */

/* The number w 10^q, or w 10^q < number < (w + 1) 10^q if cut. */
typedef struct {
    uint64_t w;
    long long q;
    bool cut;
    const char *digits, *end; /* of the text's digits, a dot among them */
    long long last;           /* exponent of the last digit of the text */
} decimal;

static bool is_digit(char c)
{
    return (unsigned char)(c - '0') < 10;
}

static const char *read_digits(const char *s, const char *end, uint64_t *w)
{
    uint64_t v = *w;

    for (; s < end && is_digit(*s); s++)
        v = 10 * v + (uint64_t)(*s - '0');
    *w = v;
    return s;
}

/* The exponent part at s, or nothing (then s is returned and *e = 0). */
static const char *read_exponent(const char *s, const char *end, long long *e)
{
    const char *p = s + 1;
    bool neg = p < end && *p == '-';

    *e = 0;
    if (s >= end || (*s != 'e' && *s != 'E'))
        return s;
    if (p < end && (*p == '-' || *p == '+'))
        p++;
    if (p >= end || !is_digit(*p))
        return s;
    for (; p < end && is_digit(*p); p++)
        if (*e < FAR / 16)
            *e = 10 * *e + (*p - '0');
    if (neg)
        *e = -*e;
    return p;
}

/* More digits than a word holds: keep the first DIGITS that count. */
static void cut_digits(decimal *d)
{
    const char *p = d->digits;
    int n = 0;

    while (p < d->end && (*p == '0' || *p == '.'))
        p++;
    d->digits = p;
    d->w = 0;
    for (; p < d->end && n < DIGITS; p++)
        if (*p != '.') {
            d->w = 10 * d->w + (uint64_t)(*p - '0');
            n++;
        }
    d->q = d->last;
    for (; p < d->end; p++)
        if (*p != '.') {
            d->q++;
            d->cut |= *p != '0';
        }
}

static const char *scan(const char *s, const char *end, decimal *d)
{
    const char *dot;
    long long e;

    *d = (decimal){.digits = s};
    dot = s = read_digits(s, end, &d->w);
    if (s < end && *s == '.')
        s = read_digits(s + 1, end, &d->w);
    d->end = s;
    if (s - d->digits - (s > dot) < 1)
        return NULL;
    s = read_exponent(s, end, &e);
    d->last = d->q = e - (d->end > dot ? d->end - dot - 1 : 0);
    if (d->end - d->digits > DIGITS)
        cut_digits(d);
    return s;
}

/* m 2^e, m > 0, rounded to nearest, ties to even, as the bits of a double. */
static uint64_t round_bits(uint64_t m, int e)
{
    int lz = __builtin_clzll(m), top = e + 63 - lz, shift = 11;
    uint64_t half, rest;

    if (top > 1023)
        return 0x7ff0000000000000u;
    m <<= lz;
    if (top < -1022)
        shift += -1022 - top;
    if (shift > 64)
        return 0;
    half = (uint64_t)1 << (shift - 1);
    rest = m & (half | (half - 1));
    m = shift == 64 ? 0 : m >> shift;
    m += rest > half || (rest == half && (m & 1));
    return top < -1022 ? m : ((uint64_t)(top + 1022) << 52) + m;
}

/* The text's digits as an integer; returns the exponent of its last one. */
static long long big_digits(const decimal *d, ix_big *b)
{
    long long e = d->last;
    int n = 0;
    bool rest = false;

    ix__big_set(b, 0);
    for (const char *p = d->digits; p < d->end; p++) {
        if (*p == '.')
            continue;
        if (n < BIG_DIGITS) {
            ix__big_mul_add(b, 10, (uint64_t)(*p - '0'));
            n += b->n > 0;
        } else {
            rest |= *p != '0';
            e++;
        }
    }
    if (rest) {
        ix__big_mul_add(b, 10, 1);
        e--;
    }
    return e;
}

/* The number lies between two neighbouring doubles, low and the next: which
 * is nearer? Both the number and the midpoint become integers. */
static uint64_t decide(const decimal *d, uint64_t low)
{
    ix_big num, mid;
    int e, q, cmp, shift;
    uint64_t m = ix__num_split(low, &e);

    q = (int)big_digits(d, &num);
    ix__big_set(&mid, 2 * m + 1);
    if (q >= 0)
        ix__big_mul_pow5(&num, q);
    else
        ix__big_mul_pow5(&mid, -q);
    shift = q - (e - 1);
    if (shift >= 0)
        ix__big_shift(&num, shift);
    else
        ix__big_shift(&mid, -shift);
    cmp = ix__big_cmp(&num, &mid);
    return low + (cmp > 0 || (cmp == 0 && (low & 1)));
}

static uint64_t to_bits(const decimal *d)
{
    int q, lz, e;
    uint64_t hi, top, low, high;

    if (d->w == 0 || d->q < IX_POW10_MIN)
        return 0;
    if (d->q > 308)
        return 0x7ff0000000000000u;
    q = (int)d->q;
    lz = __builtin_clzll(d->w);
    hi = ix__pow10[q - IX_POW10_MIN][0];
    /* The number is in [top, top + 2) 2^e, or, cut with its 2^(63-4) < w, in
     * [top, top + 18) 2^e. One bit is given up to keep clear of overflow. */
    top = (uint64_t)(((ix_u128)(d->w << lz) * hi) >> 65);
    e = ix__log2_pow10(q) - 127 - lz + 129;
    low = round_bits(top, e);
    high = round_bits(top + (d->cut ? 10 : 2), e);
    return low == high ? low : decide(d, low);
}

/* Both factors and so their product or quotient, rounded once, are exact:
 * Clinger 1990, "How to read floating point numbers accurately". */
static bool easy(const decimal *d, double *out)
{
    static const double p[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    if (d->cut || d->w > (uint64_t)1 << 53 || d->q < -22 || d->q > 22)
        return false;
    *out = d->q < 0 ? (double)d->w / p[-d->q] : (double)d->w * p[d->q];
    return true;
}

const char *ix_num_parse(const char *s, const char *end, double *out)
{
    bool neg = s < end && *s == '-';
    uint64_t bits;
    decimal d;

    s = scan(s + (neg || (s < end && *s == '+')), end, &d);
    if (!s)
        return NULL;
    if (!easy(&d, out)) {
        bits = to_bits(&d);
        memcpy(out, &bits, sizeof *out);
    }
    if (neg)
        *out = -*out;
    return s;
}
