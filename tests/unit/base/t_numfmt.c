/* Printf-style conversions: the C library's output (in the C locale) for
 * every format and number, and the bounds of a format. */
#include "base/numfmt.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "harness/test.h"

#pragma GCC diagnostic ignored "-Wformat-nonliteral" /* that is the test */

static uint64_t seed = 4711;

static ix_numfmt parsed(const char *s)
{
    ix_numfmt f;
    const char *end = ix__numfmt_parse(s, &f);

    if (!end || *end)
        fail_msg("format \"%s\" not read to its end", s);
    return f;
}

static void assert_put(const char *fmt, double v, const char *expected)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_numfmt f = parsed(fmt);
    ix_buf b;

    ix__buf_init(&b, ctx);
    ix__numfmt_put(&b, &f, v);
    ASSERT_OK(ctx, ix__buf_check(&b));
    if (strcmp(b.data ? b.data : "", expected) != 0)
        fail_msg("%s of %.17g: \"%s\", expected \"%s\" (seed %llu)", fmt, v,
                 b.data ? b.data : "", expected, (unsigned long long)seed);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

/* "%", some flags, width, precision into s; returns its length. */
static int random_spec(ix_rng *r, char *s)
{
    int n = 0;

    s[n++] = '%';
    for (int k = 0; k < 5; k++)
        if (ix_rng_int(r, 0, 3) == 0)
            s[n++] = "-+ #0"[k];
    if (ix_rng_int(r, 0, 1))
        n += sprintf(s + n, "%d", ix_rng_int(r, 1, 40));
    if (ix_rng_int(r, 0, 1))
        n += sprintf(s + n, ".%d",
                     ix_rng_int(r, 0, ix_rng_int(r, 0, 19) ? 20 : 400));
    return n;
}

static double random_value(ix_rng *r)
{
    static const double special[] = {0,   -0.0, 0.5,  1.5,  2.5,
                                     9.5, 0.05, 1e15, 1e22, 5e-324};
    uint64_t x = ix_rng_next(r);
    double v;

    switch (ix_rng_int(r, 0, 5)) {
    case 0:
        return ix_rng_int(r, -1000, 1000);
    case 1:
        return ix_rng_int(r, -10000, 10000) / 16.0; /* many ties */
    case 2:
        return ix_rng_int(r, 0, 1000000) / 1e3;
    case 3:
        return ldexp(ix_rng_int(r, 0, 1023), ix_rng_int(r, -20, 20));
    case 4:
        return special[ix_rng_int(r, 0, 9)];
    default:
        memcpy(&v, &x, sizeof v);
        return isfinite(v) ? v : HUGE_VAL;
    }
}

static void test_reals_like_printf(void **state)
{
    ix_rng r = ix_rng_new(seed);

    (void)state;
    for (int i = 0; i < 30000; i++) {
        char spec[64], expected[2048];
        int n = random_spec(&r, spec);
        double v = random_value(&r);

        spec[n] = "eEfFgG"[ix_rng_int(&r, 0, 5)];
        spec[n + 1] = '\0';
        if (strchr(spec, '#') && strchr("gG", spec[n]))
            continue; /* glibc drops a zero of "%#.2g" of 99.5 */
        snprintf(expected, sizeof expected, spec, v);
        assert_put(spec, v, expected);
    }
}

static void test_integers_like_printf(void **state)
{
    ix_rng r = ix_rng_new(seed + 1);

    (void)state;
    for (int i = 0; i < 30000; i++) {
        char spec[64], longspec[64], expected[2048];
        int n = random_spec(&r, spec);
        double v = trunc(ldexp(ix_rng_unit(&r), ix_rng_int(&r, 0, 31)));

        v = ix_rng_int(&r, 0, 1) ? -v : v;
        spec[n] = "diuoxX"[ix_rng_int(&r, 0, 5)];
        spec[n + 1] = '\0';
        snprintf(expected, sizeof expected, spec, (int)v);
        if (v >= INT_MIN)
            assert_put(spec, v, expected);
        v *= 4194304.0 * 1024;
        snprintf(longspec, sizeof longspec, "%.*sl%c", n, spec, spec[n]);
        snprintf(expected, sizeof expected, longspec, (long)v);
        if (fabs(v) > 0x1p31 && fabs(v) < 0x1p62)
            assert_put(longspec, v, expected);
    }
}

static void test_beyond_printf(void **state)
{
    (void)state;
    assert_put("%d", -3.99, "-3");
    assert_put("%d", -0.5, "0");
    assert_put("%d", 1e22, "10000000000000000000000");
    assert_put("%x", 0x1p70, "400000000000000000");
    assert_put("%u", -1, "4294967295");
    assert_put("%05d", (double)NAN, "  nan");
    assert_put("%G", -HUGE_VAL, "-INF");
    assert_put("%+08.3lf", HUGE_VAL, "    +inf");
}

static void test_caps(void **state)
{
    static const char *const bad[] = {"",
                                      "d",
                                      "%",
                                      "%5",
                                      "%*d",
                                      "%1025d",
                                      "%.1025f",
                                      "%99999999999999999999d",
                                      "%.99999999999999999999e",
                                      "%-",
                                      "%5.*f",
                                      "%$d",
                                      "%1$d",
                                      "% ",
                                      "%%"};
    ix_numfmt f;

    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (ix__numfmt_parse(bad[i], &f))
            fail_msg("\"%s\" was accepted", bad[i]);
    f = parsed("%--++ -#0 0001024.1024hhllLqf");
    assert_int_equal(f.width, 1024);
    assert_int_equal(f.precision, 1024);
    assert_string_equal(f.flags, "-+ #0");
    assert_int_equal(f.conv, 'f');
    f = parsed("%.v");
    assert_int_equal(f.precision, 0);
    assert_int_equal(f.conv, 'v');
}

/* The longest there is: all digits of the largest number and 1024 more. */
static void test_longest(void **state)
{
    char expected[2048];

    (void)state;
    snprintf(expected, sizeof expected, "%.1024f", -1.7976931348623157e308);
    assert_put("%.1024f", -1.7976931348623157e308, expected);
    snprintf(expected, sizeof expected, "%-#1024.1024e|", 5e-324);
    expected[strlen(expected) - 1] = '\0';
    assert_put("%-#1024.1024e", 5e-324, expected);
}

static void test_strings(void **state)
{
    static const struct {
        const char *fmt, *s, *expected;
    } c[] = {{"%s", "abc", "abc"},        {"%6s", "abc", "   abc"},
             {"%-6s", "abc", "abc   "},   {"%.2s", "abc", "ab"},
             {"%06.1s", "abc", "     a"}, {"%.0s", "abc", ""}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        ix_numfmt f = parsed(c[i].fmt);
        ix_buf b;

        ix__buf_init(&b, ctx);
        ix__buf_puts(&b, ">");
        ix__numfmt_puts(&b, &f, c[i].s);
        assert_string_equal(b.data + 1, c[i].expected);
        ix__buf_free(&b);
    }
    assert_put("%s", -0.1, "-0.1");
    assert_put("%8s", 1e-7, "   1e-07");
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reals_like_printf),
        cmocka_unit_test(test_integers_like_printf),
        cmocka_unit_test(test_beyond_printf),
        cmocka_unit_test(test_caps),
        cmocka_unit_test(test_longest),
        cmocka_unit_test(test_strings)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
