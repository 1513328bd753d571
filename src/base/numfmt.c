/* numfmt.c - printf-style conversions, exact and independent of the locale.
 * A number becomes decimal digits first: the few that are wanted if 128 bits
 * decide their rounding, else all of them (767 at most), and rounding is then
 * a matter of looking at them, ties to even as in C. */
#include "base/numfmt.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "base/num_impl.h"

#define TEXT_MAX (309 + 2 + IX_NUMFMT_MAX_WIDTH) /* "%.1024f" of 1e308 */

/* 0.d1 d2 d3 ... times 10^point; digits beyond n are 0. n = 0: zero. */
typedef struct {
    char dig[800];
    int n, point;
} expansion;

typedef struct {
    char text[TEXT_MAX + 16];
    size_t n;
} body;

static bool flag(const ix_numfmt *f, char c)
{
    return strchr(f->flags, c) != NULL;
}

static bool is_in(char c, const char *set)
{
    return c != '\0' && strchr(set, c) != NULL;
}

static const char *read_count(const char *s, int *out)
{
    int v = 0;

    for (; *s >= '0' && *s <= '9'; s++)
        if (v <= IX_NUMFMT_MAX_WIDTH)
            v = 10 * v + (*s - '0');
    *out = v;
    return s;
}

const char *ix__numfmt_parse(const char *s, ix_numfmt *out)
{
    size_t nf = 0;

    *out = (ix_numfmt){.precision = -1};
    if (*s++ != '%')
        return NULL;
    for (; is_in(*s, "-+ #0"); s++)
        if (!flag(out, *s))
            out->flags[nf++] = *s;
    s = read_count(s, &out->width);
    if (*s == '.')
        s = read_count(s + 1, &out->precision);
    while (is_in(*s, "hlLq"))
        s++;
    out->conv = *s;
    if (!((*s >= 'a' && *s <= 'z') || (*s >= 'A' && *s <= 'Z')))
        return NULL;
    if (out->width > IX_NUMFMT_MAX_WIDTH ||
        out->precision > IX_NUMFMT_MAX_WIDTH)
        return NULL;
    return s + 1;
}

/* Digits of b in the given base, at least min of them; b is used up. */
static int big_to_text(ix_big *b, unsigned base, const char *letters, int min,
                       char *out)
{
    const int per = base == 10 ? 19 : base == 8 ? 20 : 15; /* in one word */
    uint64_t chunk = 1;
    int n = 0;

    for (int i = 0; i < per; i++)
        chunk *= base;
    while (b->n > 0) {
        uint64_t r = ix__big_div(b, chunk);

        for (int i = 0; i < per; i++, r /= base)
            out[n++] = letters[r % base];
    }
    while (n > min && out[n - 1] == '0')
        n--;
    while (n < min)
        out[n++] = '0';
    for (int i = 0; i < n / 2; i++) {
        char t = out[i];

        out[i] = out[n - 1 - i];
        out[n - 1 - i] = t;
    }
    return n;
}

/* All digits of a finite v >= 0. */
static void expand(double v, expansion *x)
{
    uint64_t bits, m;
    ix_big b;
    int e;

    memcpy(&bits, &v, sizeof bits);
    m = ix__num_split(bits, &e);
    x->n = 0;
    x->point = 1;
    if (m == 0)
        return;
    for (; e < 0 && !(m & 1); e++)
        m >>= 1;
    ix__big_set(&b, m);
    if (e >= 0)
        ix__big_shift(&b, e);
    else
        ix__big_mul_pow5(&b, -e);
    x->n = big_to_text(&b, 10, "0123456789", 1, x->dig);
    x->point = x->n + (e < 0 ? e : 0);
}

/* v 10^k rounded to an integer below 2^60; false if that needs more bits. */
static bool scale_and_round(double v, int k, uint64_t *out)
{
    uint64_t bits, m, part;
    ix_u128 p, rest, half;
    int e, lz, shift;

    if (k < IX_POW10_MIN || k > IX_POW10_MAX)
        return false;
    memcpy(&bits, &v, sizeof bits);
    m = ix__num_split(bits, &e);
    if (m == 0)
        return false;
    lz = __builtin_clzll(m);
    /* v 10^k is in [p, p + 2^65) / 2^shift. */
    p = (ix_u128)(m << lz) * ix__pow10[k - IX_POW10_MIN][0];
    shift = 63 + lz - e - ix__log2_pow10(k);
    if (shift < 68 || shift > 127)
        return false;
    part = (uint64_t)(p >> shift);
    rest = p - ((ix_u128)part << shift);
    half = (ix_u128)1 << (shift - 1);
    if (rest <= half && half - rest <= (ix_u128)1 << 65)
        return false;
    *out = part + (rest > half);
    return true;
}

static void set_expansion(expansion *x, uint64_t v, int k)
{
    x->n = ix__num_digits(v, x->dig);
    x->point = x->n - k;
}

/* The first digits of v > 0, rounded there; n is that number, or one more
 * with a zero at the end. */
static bool quick_digits(double v, int digits, expansion *x)
{
    uint64_t part, limit = 1;
    int k;

    if (!(v > 0) || digits > 17)
        return false;
    k = digits - 1 - (int)floor(log10(v)); /* or one more */
    for (int i = 0; i < digits; i++)
        limit *= 10;
    if (!scale_and_round(v, k, &part))
        return false;
    if (part > limit && !scale_and_round(v, --k, &part))
        return false;
    if (part < limit / 10)
        return false;
    set_expansion(x, part, k);
    return true;
}

static bool quick_decimals(double v, int decimals, expansion *x)
{
    uint64_t part;

    if (!scale_and_round(v, decimals, &part))
        return false;
    set_expansion(x, part, decimals);
    return true;
}

/* Rounds to the first keep digits (none if keep <= 0). */
static void round_to(expansion *x, int keep)
{
    bool up, more = false;
    int i;

    if (keep >= x->n)
        return;
    if (keep < 0) {
        x->n = 0;
        return;
    }
    for (i = keep + 1; i < x->n; i++)
        more |= x->dig[i] != '0';
    up = x->dig[keep] > '5' ||
         (x->dig[keep] == '5' && (more || (keep && (x->dig[keep - 1] & 1))));
    x->n = keep;
    if (!up)
        return;
    for (i = keep - 1; i >= 0 && x->dig[i] == '9'; i--)
        x->dig[i] = '0';
    if (i >= 0) {
        x->dig[i]++;
        return;
    }
    x->dig[0] = '1'; /* 999 became 1000 */
    x->n = 1;
    x->point++;
}

static void put(body *t, char c)
{
    t->text[t->n++] = c;
}

static void put_range(body *t, const expansion *x, int from, int to)
{
    for (int i = from; i < to; i++)
        put(t, i >= 0 && i < x->n ? x->dig[i] : '0');
}

static void put_plain(body *t, const expansion *x, int prec, bool dot)
{
    if (x->point <= 0)
        put(t, '0');
    put_range(t, x, 0, x->point);
    if (prec > 0 || dot)
        put(t, '.');
    put_range(t, x, x->point, x->point + prec);
}

static void put_scientific(body *t, const expansion *x, int prec, bool dot,
                           char letter)
{
    int e = x->n > 0 ? x->point - 1 : 0;

    put_range(t, x, 0, 1);
    if (prec > 0 || dot)
        put(t, '.');
    put_range(t, x, 1, 1 + prec);
    put(t, letter);
    put(t, e < 0 ? '-' : '+');
    e = e < 0 ? -e : e;
    if (e >= 100)
        put(t, (char)('0' + e / 100));
    put(t, (char)('0' + e / 10 % 10));
    put(t, (char)('0' + e % 10));
}

/* %g of a number rounded to that many digits: the shorter look; zeros at the
 * end are dropped unless "#" is set. */
static void put_general(body *t, expansion *x, int digits, bool alt,
                        char letter)
{
    int shown;

    while (x->n > 1 && x->dig[x->n - 1] == '0')
        x->n--;
    shown = alt ? digits : x->n;
    if (x->point - 1 < -4 || x->point - 1 >= digits)
        put_scientific(t, x, shown - 1, alt, letter);
    else
        put_plain(t, x, shown > x->point ? shown - x->point : 0, alt);
}

static void real_body(body *t, const ix_numfmt *f, double v)
{
    int prec = f->precision < 0 ? 6 : f->precision;
    bool alt = flag(f, '#');
    expansion x;

    if (is_in(f->conv, "fF")) {
        if (!quick_decimals(v, prec, &x))
            expand(v, &x);
        round_to(&x, x.point + prec);
        put_plain(t, &x, prec, alt);
        return;
    }
    prec = is_in(f->conv, "eE") ? prec + 1 : prec ? prec : 1;
    if (!quick_digits(v, prec, &x))
        expand(v, &x);
    round_to(&x, prec);
    if (is_in(f->conv, "eE"))
        put_scientific(t, &x, prec - 1, alt, f->conv);
    else
        put_general(t, &x, prec, alt, f->conv == 'G' ? 'E' : 'e');
}

/* The magnitude of an integer v; negative ones of unsigned conversions wrap
 * at 32 bits, or at 64 if they need more, as C's int and long do. */
static void int_value(double *v, bool is_signed, ix_big *b)
{
    double a = fabs(*v);
    uint64_t bits;
    int e;

    memcpy(&bits, &a, sizeof bits);
    ix__big_set(b, ix__num_split(bits, &e));
    if (e >= 0)
        ix__big_shift(b, e);
    else
        ix__big_set(b, (uint64_t)a);
    if (is_signed || *v >= 0 || b->n > 1)
        return;
    ix__big_set(b, a <= 0x1p31 ? (uint32_t)-b->w[0] : -b->w[0]);
    *v = a;
}

static const char *int_body(body *t, const ix_numfmt *f, double *v)
{
    bool upper = f->conv == 'X', hex = upper || f->conv == 'x';
    unsigned base = hex ? 16 : f->conv == 'o' ? 8 : 10;
    int min = f->precision < 0 ? 1 : f->precision;
    ix_big b;
    bool zero;

    *v = trunc(*v);
    int_value(v, base == 10 && f->conv != 'u', &b);
    zero = b.n == 0;
    t->n = (size_t)big_to_text(&b, base,
                               upper ? "0123456789ABCDEF" : "0123456789abcdef",
                               min, t->text);
    if (base == 8 && flag(f, '#'))
        return t->n > 0 && t->text[0] == '0' ? "" : "0";
    if (zero || base != 16 || !flag(f, '#'))
        return "";
    return upper ? "0X" : "0x";
}

static const char *sign_of(const ix_numfmt *f, double v)
{
    if (signbit(v) && v == v)
        return "-";
    if (is_in(f->conv, "uoxX"))
        return "";
    return flag(f, '+') ? "+" : flag(f, ' ') ? " " : "";
}

/* sign prefix text, padded to the width: on the right, on the left, or with
 * zeros between prefix and text. */
static void put_padded(ix_buf *b, const ix_numfmt *f, const char *sign,
                       const char *prefix, const char *text, size_t n,
                       bool zeros)
{
    size_t len = strlen(sign) + strlen(prefix) + n;
    size_t pad = len < (size_t)f->width ? (size_t)f->width - len : 0;
    bool left = flag(f, '-');

    zeros = zeros && !left && flag(f, '0');
    ix__buf_fill(b, ' ', left || zeros ? 0 : pad);
    ix__buf_puts(b, sign);
    ix__buf_puts(b, prefix);
    ix__buf_fill(b, '0', zeros ? pad : 0);
    ix__buf_add(b, text, n);
    ix__buf_fill(b, ' ', left ? pad : 0);
}

static void put_special(ix_buf *b, const ix_numfmt *f, double v)
{
    bool upper = is_in(f->conv, "EFGX");
    const char *text = v != v ? (upper ? "NAN" : "nan")
                              : (upper ? "INF" : "inf");

    put_padded(b, f, sign_of(f, v), "", text, 3, false);
}

void ix__numfmt_put(ix_buf *b, const ix_numfmt *f, double v)
{
    const char *prefix = "";
    bool integer = is_in(f->conv, "diuoxX"), zeros = true;
    body t;

    t.n = 0;
    if (!isfinite(v)) {
        put_special(b, f, v);
        return;
    }
    if (integer) {
        prefix = int_body(&t, f, &v);
        zeros = f->precision < 0;
        v = v == 0 ? 0 : v; /* -0.5 is 0, not -0 */
    } else if (f->conv == 's') {
        t.n = (size_t)ix_num_format(fabs(v), t.text);
    } else {
        real_body(&t, f, fabs(v));
    }
    put_padded(b, f, sign_of(f, v), prefix, t.text, t.n, zeros);
}

void ix__numfmt_puts(ix_buf *b, const ix_numfmt *f, const char *s)
{
    size_t n = strlen(s);

    if (f->precision >= 0 && n > (size_t)f->precision)
        n = (size_t)f->precision;
    put_padded(b, f, "", "", s, n, false);
}
