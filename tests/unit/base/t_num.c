/* Numbers as text: printing is the shortest that reads back, reading is to
 * nearest even; the laws are checked against each other, against the C
 * library and against exact midpoints. */
#include <float.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "harness/test.h"

static uint64_t seed = 20240607;

static double from_bits(uint64_t bits)
{
    double v;

    memcpy(&v, &bits, sizeof v);
    return v;
}

static uint64_t to_bits(double v)
{
    uint64_t bits;

    memcpy(&bits, &v, sizeof bits);
    return bits;
}

/* Reads all of s[n]; fails the test if something is left. */
static double read_all(const char *s, size_t n)
{
    double v = -77;

    if (ix_num_parse(s, s + n, &v) != s + n)
        fail_msg("not read to its end: %.60s", s);
    return v;
}

static double read_text(const char *s)
{
    return read_all(s, strlen(s));
}

/* Numbers of all sizes, of daily sizes, and with few bits, in turn. */
static double random_double(ix_rng *r, int i)
{
    uint64_t x = ix_rng_next(r);

    if (i % 3 == 1)
        x = (x & 0x800fffffffffffffu) | (uint64_t)ix_rng_int(r, 990, 1050)
                                            << 52;
    if (i % 3 == 2)
        x &= ~(uint64_t)0 << ix_rng_int(r, 0, 51);
    return isfinite(from_bits(x)) ? from_bits(x) : 1.0;
}

/* Law: parse(format(v)) has the bits of v. */
static void test_round_trip(void **state)
{
    ix_rng r = ix_rng_new(seed);

    (void)state;
    for (int i = 0; i < 1000000; i++) {
        char text[IX_NUM_MAX];
        double v = random_double(&r, i), w;
        int n = ix_num_format(v, text);
        const char *end = ix_num_parse(text, text + n, &w);

        if (n >= IX_NUM_MAX || end != text + n || to_bits(w) != to_bits(v))
            fail_msg("%.17g became \"%s\" (seed %llu)", v, text,
                     (unsigned long long)seed);
    }
}

static int significant(const char *text, char *digits)
{
    int n = 0;

    for (; *text && *text != 'e'; text++)
        if (*text >= '0' && *text <= '9' && (n > 0 || *text != '0'))
            digits[n++] = *text;
    while (n > 0 && digits[n - 1] == '0')
        n--;
    digits[n] = '\0';
    return n;
}

/* Law: one digit less does not read back, and with as many digits the C
 * library prints the same ones (it prints the nearest decimal; at a power of
 * two the nearest may lie outside the interval, so those are left out). */
static void test_shortest(void **state)
{
    ix_rng r = ix_rng_new(seed + 1);

    (void)state;
    for (int i = 0; i < 20000; i++) {
        char text[IX_NUM_MAX], mine[IX_NUM_MAX], theirs[64], other[64];
        double v = random_double(&r, i);
        int n, e;

        if (frexp(fabs(v), &e) == 0.5)
            continue;
        ix_num_format(v, text);
        n = significant(text, mine);
        snprintf(other, sizeof other, "%.*e", n > 0 ? n - 1 : 0, v);
        significant(other, theirs);
        if (strcmp(mine, theirs) != 0)
            fail_msg("%s but %s (seed %llu)", text, other,
                     (unsigned long long)seed);
        snprintf(other, sizeof other, "%.*e", n - 2, v);
        if (n > 1 && read_text(other) == v)
            fail_msg("%s is not the shortest (seed %llu)", text,
                     (unsigned long long)seed);
    }
}

static void test_style(void **state)
{
    static const struct {
        double v;
        const char *text;
    } c[] = {{0.0, "0"},
             {-0.0, "-0"},
             {0.1, "0.1"},
             {-2.5, "-2.5"},
             {100, "100"},
             {123.456, "123.456"},
             {0.0001, "0.0001"},
             {0.00001234, "1.234e-05"},
             {1e-7, "1e-07"},
             {1e16, "10000000000000000"},
             {1e17, "1e+17"},
             {123456789012345680.0, "1.2345678901234568e+17"},
             {9007199254740992.0, "9007199254740992"},
             {5e-324, "5e-324"},
             {DBL_MIN, "2.2250738585072014e-308"},
             {-DBL_MAX, "-1.7976931348623157e+308"},
             {9.5367431640625e-07, "9.5367431640625e-07"},
             {2e-44, "2e-44"},
             {HUGE_VAL, "inf"},
             {-HUGE_VAL, "-inf"},
             {(double)NAN, "nan"}};

    (void)state;
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        char text[IX_NUM_MAX];

        assert_int_equal(ix_num_format(c[i].v, text), strlen(c[i].text));
        assert_string_equal(text, c[i].text);
    }
}

/* Any digits, dot and exponent, against the C library. */
static void test_reads_like_strtod(void **state)
{
    ix_rng r = ix_rng_new(seed + 2);

    (void)state;
    for (int i = 0; i < 100000; i++) {
        char s[80];
        int n = ix_rng_int(&r, 1, 45), dot = ix_rng_int(&r, 0, n), k = 0;

        for (int j = 0; j < n; j++) {
            if (j == dot)
                s[k++] = '.';
            s[k++] = (char)('0' + ix_rng_int(&r, 0, i % 5 ? 9 : 1));
        }
        snprintf(s + k, sizeof s - (size_t)k, "e%d", ix_rng_int(&r, -370, 330));
        if (to_bits(read_text(s)) != to_bits(strtod(s, NULL)))
            fail_msg("\"%s\" read as %.17g (seed %llu)", s, read_text(s),
                     (unsigned long long)seed);
    }
}

/* digits + 1 or - 1 in the last place before the exponent. */
static void nudge(char *s, int by)
{
    char *p = strchr(s, 'e') - 1;
    char from = by > 0 ? '9' : '0', to = by > 0 ? '0' : '9';

    for (; *p == from || *p == '.'; p--)
        if (*p != '.')
            *p = to;
    *p = (char)(*p + by);
}

/* Law: the exact midpoint of two neighbours (all its digits) reads as the
 * even one, and a last digit more or less as the upper or the lower one. */
static void test_midpoints(void **state)
{
    ix_rng r = ix_rng_new(seed + 3);

    (void)state;
#if LDBL_MANT_DIG < 54 || LDBL_MIN_EXP > -1100
    skip(); /* midpoints are not representable here */
#endif
    for (int i = 0; i < 3000; i++) {
        uint64_t b = to_bits(fabs(random_double(&r, i % 2 ? 1 : 0)));
        long double mid;
        char s[1200];

        if (i % 4 == 0)
            b &= 0xfffffffffffffu; /* subnormal */
        if (i % 32 == 0)
            b |= 0xfffffffffffffu; /* the next one has another exponent */
        mid = ((long double)from_bits(b) + (long double)from_bits(b + 1)) / 2;
        snprintf(s, sizeof s, "%.800Le", mid);
        assert_int_equal(to_bits(read_text(s)), b + (b & 1));
        nudge(s, 1);
        assert_int_equal(to_bits(read_text(s)), b + 1);
        nudge(s, -1);
        nudge(s, -1);
        assert_int_equal(to_bits(read_text(s)), b);
    }
}

static void test_hard_cases(void **state)
{
    static const char *const text[] = {
        "9007199254740993",
        "9007199254740993.0000000000000000000000000001",
        "9007199254740992.9999999999999999999999999999",
        "9007199254740995",
        "2.2250738585072011e-308",
        "2.2250738585072012e-308",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "4.9406564584124654e-324",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "179769313486231580793e289",
        "1e23",
        "8.5e22",
        "6.9294956446009195e15",
        "3.7455744005952583e15",
        "1.000000000000000111022302462515654",
        "0.500000000000000166533453694",
        "104308485241983990666713401708072175773165034278682682111762292935936",
        "1e-400",
        "1e400",
        "0e400",
        "-1e-400",
        "00000000000000000000000000001",
        "0.000000000000000000000000000000000000000000000000000000000000001e62"};

    (void)state;
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        if (to_bits(read_text(text[i])) != to_bits(strtod(text[i], NULL)))
            fail_msg("\"%s\" read as %.17g", text[i], read_text(text[i]));
}

/* A million digits are read, not stored; exponents cannot overflow. */
static void test_very_long(void **state)
{
    enum { N = 1000000 };
    char *s = malloc(2 * N + 64);

    (void)state;
    assert_non_null(s);
    memset(s, '9', N);
    assert_true(read_all(s, N) == HUGE_VAL);
    strcpy(s + N, "e-999999");
    assert_true(read_text(s) == 10.0);
    strcpy(s + N, "e-99999999999999999999999999");
    assert_true(read_text(s) == 0.0);
    strcpy(s, "0.");
    memset(s + 2, '0', N);
    strcpy(s + 2 + N, "1e1000001");
    assert_true(read_text(s) == 1.0);
    strcpy(s + 2 + N, "1e999999999999999999999999999");
    assert_true(read_text(s) == HUGE_VAL);
    free(s);
}

static void expect_rest(const char *s, const char *rest, double v)
{
    double w = -77;
    const char *p = ix_num_parse(s, s + strlen(s), &w);

    assert_non_null(p);
    assert_string_equal(p, rest);
    assert_true(w == v);
}

static void test_grammar(void **state)
{
    static const char *const none[] = {"",    ".",    "-",   "+.",  "e5",
                                       "--1", " 1",   "nan", "inf", "x",
                                       ".e3", "-e10", "+-2", ",5"};
    double v;

    (void)state;
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_null(ix_num_parse(none[i], none[i] + strlen(none[i]), &v));
    expect_rest("1.", "", 1);
    expect_rest("+.5]", "]", 0.5);
    expect_rest("-2.5E+1 3", " 3", -25);
    expect_rest("1e", "e", 1);
    expect_rest("1e+", "e+", 1);
    expect_rest("1e-x", "e-x", 1);
    expect_rest("1,5", ",5", 1);
    expect_rest("1.2.3", ".3", 1.2);
    expect_rest("0x10", "x10", 0);
}

/* Law: nothing is read beyond end, wherever it falls. */
static void test_end(void **state)
{
    const char all[] = "-12.5e+3";
    static const double v[] = {-1, -12, -12, -12.5, -12.5, -12.5, -12500};

    (void)state;
    for (size_t n = 2; n < sizeof all; n++) {
        char *s = malloc(n); /* the sanitizer watches its end */
        double w;

        memcpy(s, all, n);
        assert_non_null(ix_num_parse(s, s + n, &w));
        assert_true(w == v[n - 2]);
        free(s);
    }
}

/* A locale with a decimal comma, if there is one on this machine. */
static void test_comma_locale(void **state)
{
    static const char *const names[] = {
        "de_DE.UTF-8", "de_DE.utf8",  "de_DE",      "fr_FR.UTF-8",
        "fr_FR.utf8",  "pl_PL.UTF-8", "tr_TR.UTF-8"};
    const char *set = NULL;
    char text[IX_NUM_MAX];

    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names && !set; i++)
        set = setlocale(LC_ALL, names[i]);
    if (!set)
        skip();
    snprintf(text, sizeof text, "%g", 1.5);
    assert_string_equal(text, "1,5");
    ix_num_format(1.5, text);
    assert_string_equal(text, "1.5");
    assert_true(read_text("-0.25e1") == -2.5);
    expect_rest("1,5", ",5", 1);
    setlocale(LC_ALL, "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_round_trip),
                                       cmocka_unit_test(test_shortest),
                                       cmocka_unit_test(test_style),
                                       cmocka_unit_test(test_reads_like_strtod),
                                       cmocka_unit_test(test_midpoints),
                                       cmocka_unit_test(test_hard_cases),
                                       cmocka_unit_test(test_very_long),
                                       cmocka_unit_test(test_grammar),
                                       cmocka_unit_test(test_end),
                                       cmocka_unit_test(test_comma_locale)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
