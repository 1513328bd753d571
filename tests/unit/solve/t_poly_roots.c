/* Roots of one Bernstein polynomial against exact counts and known answers. */
#include "solve/poly_roots.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"

#ifdef IX_HAVE_FLINT
#include <flint/fmpz_poly.h>
#endif

static double binomial(int n, int k)
{
    double r = 1;

    for (int i = 1; i <= k; i++)
        r = r * (n - k + i) / i;
    return r;
}

/* Bernstein coefficients of the product of (t - r_i), exact in long double
 * for few roots; n roots. */
static void from_roots(int n, const double *r, double *b)
{
    long double c[64] = {1}; /* scaled Bernstein, degree grows */

    for (int k = 0; k < n; k++) {
        long double p0 = -(long double)r[k], p1 = 1 - (long double)r[k];

        for (int i = k + 1; i >= 0; i--)
            c[i] = (i <= k ? c[i] * p0 : 0) + (i > 0 ? c[i - 1] * p1 : 0);
    }
    for (int i = 0; i <= n; i++)
        b[i] = (double)(c[i] / (long double)binomial(n, i));
}

static double value(int d, const double *b, double t)
{
    double w[256];

    memcpy(w, b, ((size_t)d + 1) * sizeof *w);
    for (int k = 1; k <= d; k++)
        for (int i = 0; i <= d - k; i++)
            w[i] = (1 - t) * w[i] + t * w[i + 1];
    return w[0];
}

static int total(const ix__poly_roots *r)
{
    int n = 0;

    for (int i = 0; i < r->n; i++)
        n += r->root[i].count;
    return n;
}

#ifdef IX_HAVE_FLINT
/* Positive roots of sum C(d,i) b_i x^i, x = t / (1 - t): the distinct roots in
 * (0, 1), counted by Sturm's theorem in integers; -1 if not squarefree. */
static long exact_count(int d, const int *b)
{
    fmpz_poly_t p;
    fmpz_t c;
    slong neg = 0, pos = 0;

    fmpz_poly_init(p);
    fmpz_init(c);
    for (int i = 0; i <= d; i++) {
        fmpz_bin_uiui(c, (ulong)d, (ulong)i);
        fmpz_mul_si(c, c, b[i]);
        fmpz_poly_set_coeff_fmpz(p, i, c);
    }
    while (!fmpz_poly_is_zero(p) && fmpz_is_zero(p->coeffs))
        fmpz_poly_shift_right(p, p, 1); /* the root 0 is counted elsewhere */
    if (fmpz_poly_is_zero(p) || !fmpz_poly_is_squarefree(p))
        pos = -1;
    else if (p->length > 1)
        _fmpz_poly_num_real_roots_sturm(&neg, &pos, p->coeffs, p->length);
    fmpz_clear(c);
    fmpz_poly_clear(p);
    return pos;
}

/* Law: the number of roots is the exact one, each enclosed by opposite signs,
 * over thousands of random integer polynomials. */
static void counts_are_exact(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(20240501);
    long verified = 0;

    (void)state;
    for (int round = 0; round < 4000; round++) {
        int d = ix_rng_int(&g, 1, 24), size = 1 << ix_rng_int(&g, 1, 16);
        int bi[32];
        double b[32];
        ix__poly_roots r;
        ix_mark mk = ix__scratch_mark(ctx);
        long want;

        for (int i = 0; i <= d; i++)
            b[i] = bi[i] = ix_rng_int(&g, -size, size);
        want = exact_count(d, bi);
        if (want < 0)
            continue;
        ASSERT_OK(ctx, ix__poly_roots_find(ctx, d, b, 0, &r));
        if (total(&r) != want) {
            for (int i = 0; i <= d; i++)
                print_message("# b[%d] = %g\n", i, b[i]);
            fail_msg("round %d degree %d: %d roots, exactly %ld", round, d,
                     total(&r), want);
        }
        for (int i = 0; i < r.n; i++) {
            assert_true(r.root[i].lo <= r.root[i].s);
            assert_true(r.root[i].s <= r.root[i].hi);
            assert_true(r.root[i].hi - r.root[i].lo < 1e-7);
            assert_true(i == 0 || r.root[i - 1].hi <= r.root[i].lo);
        }
        verified += want;
        ix__scratch_release(ctx, mk);
    }
    print_message("# %ld roots verified against Sturm counts\n", verified);
    ix_ctx_free(ctx);
}
#endif

/* n roots at the given places, simple, found to within tol. */
static void expect_simple(int n, const double *r, double tol)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix__poly_roots f;
    double b[64];

    from_roots(n, r, b);
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, n, b, 0, &f));
    assert_int_equal(f.n, n);
    for (int i = 0; i < n; i++) {
        assert_int_equal(f.root[i].count, 1);
        ASSERT_CLOSE(f.root[i].s, r[i], tol);
    }
    ix_ctx_free(ctx);
}

/* Wilkinson's polynomial on [0, 1]: roots k / 21. Condition of the middle
 * roots in Bernstein form is about 1e5. */
static void wilkinson(void **state)
{
    double r[20];

    (void)state;
    for (int i = 0; i < 20; i++)
        r[i] = (i + 1) / 21.0;
    expect_simple(20, r, 1e-9);
}

/* Chebyshev of degree 30, mapped to [0, 1]; coefficients grow like 1e10. */
static void chebyshev(void **state)
{
    double r[30];

    (void)state;
    for (int i = 0; i < 30; i++)
        r[29 - i] = 0.5 + 0.5 * cos((2 * i + 1) * acos(-1.0) / 60);
    expect_simple(30, r, 1e-8);
}

/* Two roots 1e-12 apart (coefficients rounded to double move them by about
 * 1e-16 / 1e-12 = 1e-4 of the gap). */
static void close_pair(void **state)
{
    double r[3] = {0.25, 0.7, 0.7 + 1e-6};

    (void)state;
    expect_simple(3, r, 1e-9);
}

/* Mignotte's x^n - 2 (a x - 1)^2: two roots within 2 a^-(n+2)/2 of 1/a. Both
 * are found, or they are one cluster of two where the rounding of the
 * coefficients decides; never one, never three. */
static void mignotte(void **state)
{
    const double a = 8;

    (void)state;
    for (int n = 3; n <= 21; n += 3) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);
        ix__poly_roots f;
        double b[32];

        for (int i = 0; i <= n; i++) {
            /* x = sum (i/n) B_i, x^2 = sum i (i-1) / (n (n-1)) B_i */
            double x = (double)i / n, xx = i * (i - 1.0) / (n * (n - 1.0));

            b[i] = -2 * (a * a * xx - 2 * a * x + 1) + (i == n);
        }
        /* the coefficients are rounded: about 300 units of 1e-16 */
        ASSERT_OK(ctx, ix__poly_roots_find(ctx, n, b, 3e-14, &f));
        assert_int_equal(total(&f), 2);
        for (int i = 0; i < f.n; i++)
            ASSERT_CLOSE(f.root[i].s, 1 / a, 2 * pow(a, -(n + 2) / 2.0) + 1e-8);
        ix_ctx_free(ctx);
    }
}

/* (t - 0.5)^2 (t - 0.125) with exact coefficients: a touching zero. */
static void double_root(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double r[3] = {0.125, 0.5, 0.5};
    ix__poly_roots f;
    double b[4];

    (void)state;
    /* scaled coefficients of exact dyadic numbers, times 3 to stay exact */
    from_roots(3, r, b);
    for (int i = 0; i < 4; i++)
        b[i] = nearbyint(b[i] * 3 * 64) / 64;
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, 3, b, 0, &f));
    assert_int_equal(f.n, 2);
    assert_int_equal(f.root[0].count, 1);
    assert_int_equal(f.root[1].count, 2);
    ASSERT_CLOSE(f.root[1].s, 0.5, 1e-15);
    ix_ctx_free(ctx);
}

/* (t - 0.3)^3: the coefficients are rounded, so three roots lie within about
 * (1e-16)^(1/3) of 0.3; they are one, two or three reports but three roots. */
static void triple_root(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double r[3] = {0.3, 0.3, 0.3};
    ix__poly_roots f;
    double b[4];

    (void)state;
    from_roots(3, r, b);
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, 3, b, 2 * DBL_EPSILON, &f));
    assert_int_equal(f.n, 1);
    assert_int_equal(f.root[0].count, 3);
    ASSERT_CLOSE(f.root[0].s, 0.3, 1e-5);
    ix_ctx_free(ctx);
}

static void roots_at_ends(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double b[] = {0, 0, 1, -1, 0}; /* u^2 and v^1 divide it */
    ix__poly_roots f;

    (void)state;
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, 4, b, 0, &f));
    assert_int_equal(f.zeros0, 2);
    assert_int_equal(f.zeros1, 1);
    assert_int_equal(f.sign0, 1);
    assert_int_equal(f.sign1, -1);
    assert_int_equal(f.n, 1);
    /* 6 u v - 4 u u = 0 for t = 3/5 */
    ASSERT_CLOSE(f.root[0].s, 0.6, 1e-15);
    ix_ctx_free(ctx);
}

static void vanishing(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double b[] = {0, 1e-17, -1e-18};
    ix__poly_roots f;

    (void)state;
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, 2, b, 1e-16, &f));
    assert_true(f.vanishes);
    assert_int_equal(f.n, 0);
    ix_ctx_free(ctx);
}

/* Degree 200: the roots of the coefficients' sign pattern are stable under a
 * reversal of the parameter. */
static void high_order(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng g = ix_rng_new(7);
    double b[201], c[201];
    ix__poly_roots f, h;

    (void)state;
    for (int i = 0; i <= 200; i++)
        b[i] = c[200 - i] = ix_rng_range(&g, -1, 1);
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, 200, b, 0, &f));
    ASSERT_OK(ctx, ix__poly_roots_find(ctx, 200, c, 0, &h));
    assert_true(f.n > 0);
    assert_int_equal(f.n, h.n);
    for (int i = 0; i < f.n; i++) {
        ASSERT_CLOSE(f.root[i].s, 1 - h.root[f.n - 1 - i].s, 1e-12);
        assert_true(value(200, b, f.root[i].lo) * value(200, b, f.root[i].hi) <=
                    0);
    }
    ix_ctx_free(ctx);
}

static ix_status run_once(ix_ctx *ctx, void *state)
{
    const double b[] = {1, -2, 3, -2, 1};
    ix_mark mk = ix__scratch_mark(ctx);
    ix__poly_roots f;
    ix_status st = ix__poly_roots_find(ctx, 4, b, 0, &f);

    (void)state;
    ix__scratch_release(ctx, mk);
    return st;
}

static void out_of_memory(void **state)
{
    ix_fault_case c = {.run = run_once};

    (void)state;
    assert_true(ix_fault_run(&c) >= 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
#ifdef IX_HAVE_FLINT
        cmocka_unit_test(counts_are_exact),
#endif
        cmocka_unit_test(wilkinson),        cmocka_unit_test(chebyshev),
        cmocka_unit_test(close_pair),       cmocka_unit_test(mignotte),
        cmocka_unit_test(double_root),      cmocka_unit_test(triple_root),
        cmocka_unit_test(roots_at_ends),    cmocka_unit_test(vanishing),
        cmocka_unit_test(high_order),       cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
