/* num_format.c - a double as the shortest decimal text that reads back as
 * the same double, and of those the nearest to it. The method is Schubfach:
 * Giulietti 2020, "The Schubfach way to render doubles". */
#include <string.h>

#include "iritx/base.h"

#include "base/num_impl.h"

/* digits 10^exp */
typedef struct {
    uint64_t digits;
    int exp;
} decimal;

/* c g / 2^128 for the power g[2], rounded to odd: the last bit also tells
 * whether anything not 0 was dropped. */
static uint64_t scaled(const uint64_t g[2], uint64_t c)
{
    ix_u128 y = (ix_u128)g[0] * c + (uint64_t)(((ix_u128)g[1] * c) >> 64);

    return (uint64_t)(y >> 64) | ((uint64_t)y > 1);
}

/* Of the two neighbours s and s + 1, in units that leave 4 vb for the number
 * itself: the one that lies in [lower, upper] or, if both do, the nearer. */
static uint64_t nearer(uint64_t s, uint64_t vb, uint64_t lower, uint64_t upper)
{
    bool s_in = lower <= 4 * s, next_in = 4 * s + 4 <= upper;
    uint64_t mid = 4 * s + 2;

    if (s_in != next_in)
        return s + next_in;
    return s + (vb > mid || (vb == mid && (s & 1)));
}

/* Numbers that round to m 2^e, in units of 10^k / 4 with 10^k not longer than
 * that interval: lower .. upper, ends included if m is even. */
static decimal shortest(uint64_t m, int e, bool narrow_below)
{
    int k = (e * 1262611 - (narrow_below ? 524031 : 0)) >> 22;
    const uint64_t *g = ix__pow10[-k - IX_POW10_MIN];
    int h = e + ix__log2_pow10(-k) + 1;
    uint64_t vb = scaled(g, (4 * m) << h), odd = m & 1;
    uint64_t lower = scaled(g, (4 * m - 2 + narrow_below) << h) + odd;
    uint64_t upper = scaled(g, (4 * m + 2) << h) - odd;
    uint64_t s = vb / 4, tens = s / 10;

    if (s >= 10) {
        bool in = lower <= 40 * tens, next_in = 40 * tens + 40 <= upper;

        if (in != next_in)
            return (decimal){tens + next_in, k + 1};
    }
    return (decimal){nearer(s, vb, lower, upper), k};
}

static decimal to_decimal(uint64_t bits)
{
    int e;
    uint64_t m = ix__num_split(bits, &e);
    decimal d;

    if (e <= 0 && e > -53 && (m & (((uint64_t)1 << -e) - 1)) == 0)
        d = (decimal){m >> -e, 0}; /* an integer */
    else
        d = shortest(m, e, m == (uint64_t)1 << 52 && e > -1074);
    while (d.digits % 10 == 0) {
        d.digits /= 10;
        d.exp++;
    }
    return d;
}

int ix__num_digits(uint64_t v, char *out)
{
    char tmp[20];
    int n = 0;

    do
        tmp[n++] = (char)('0' + v % 10);
    while ((v /= 10) > 0);
    for (int i = 0; i < n; i++)
        out[i] = tmp[n - 1 - i];
    return n;
}

static char *put_text(char *p, const char *s, size_t n)
{
    return (char *)memcpy(p, s, n) + n;
}

/* d.ddde-05: at least two digits of exponent, as in C. */
static char *put_scientific(char *p, const char *dig, int n, int point)
{
    int e = point - 1;

    *p++ = dig[0];
    if (n > 1) {
        *p++ = '.';
        p = put_text(p, dig + 1, (size_t)n - 1);
    }
    *p++ = 'e';
    *p++ = e < 0 ? '-' : '+';
    e = e < 0 ? -e : e;
    if (e < 10)
        *p++ = '0';
    return p + ix__num_digits((uint64_t)e, p);
}

/* The decimal point stands behind dig[point - 1]. */
static char *put_plain(char *p, const char *dig, int n, int point)
{
    if (point <= 0) {
        p = put_text(p, "0.0000", 2 + (size_t)-point);
        return put_text(p, dig, (size_t)n);
    }
    if (point >= n) {
        p = put_text(p, dig, (size_t)n);
        memset(p, '0', (size_t)(point - n));
        return p + (point - n);
    }
    p = put_text(p, dig, (size_t)point);
    *p++ = '.';
    return put_text(p, dig + point, (size_t)(n - point));
}

static char *put_positive(char *p, uint64_t bits)
{
    decimal d = to_decimal(bits);
    char dig[20];
    int n = ix__num_digits(d.digits, dig), point = n + d.exp;

    if (point < -3 || point > 17)
        return put_scientific(p, dig, n, point);
    return put_plain(p, dig, n, point);
}

int ix_num_format(double v, char *buf)
{
    char *p = buf;
    uint64_t bits;

    memcpy(&bits, &v, sizeof bits);
    if (bits >> 63 && v == v)
        *p++ = '-';
    bits &= ~((uint64_t)1 << 63);
    if (v != v)
        p = put_text(p, "nan", 3);
    else if (bits == 0x7ff0000000000000u)
        p = put_text(p, "inf", 3);
    else if (bits == 0)
        *p++ = '0';
    else
        p = put_positive(p, bits);
    *p = '\0';
    return (int)(p - buf);
}
