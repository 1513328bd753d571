/* Roots of splines and of polynomials with planted multiple roots, against
 * exact counts in integers (Sturm, by FLINT) and known places. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "harness/randmv.h"
#include "iritx/solve.h"
#include "solve/poly_roots.h"

#ifdef IX_HAVE_FLINT
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>
#endif

IX_TEST_FIXTURE(20260719)

/* --- planted roots: exact coefficients by integers ------------------------ */

/* Scaled Bernstein coefficients, integers, of the product of
 * ((den - num) t - num (1 - t))^m, roots num / den; returns the degree. */
static int planted(int n, const int *num, int den, const int *mult, double *c)
{
    int d = 0;

    c[0] = 1;
    for (int k = 0; k < n; k++)
        for (int e = 0; e < mult[k]; e++, d++)
            for (int i = d + 1; i >= 0; i--)
                c[i] = (i <= d ? -num[k] * c[i] : 0) +
                       (i > 0 ? (den - num[k]) * c[i - 1] : 0);
    return d;
}

static double binomial(int n, int k)
{
    double r = 1;

    for (int i = 1; i <= k; i++)
        r = r * (n - k + i) / i;
    return r;
}

/* Law: each planted root is enclosed by exactly one result, whose count is
 * its multiplicity (or of its parity, where rounding of the coefficients to
 * Bernstein form has split it), and the counts add up to the degree. */
static void planted_roots(void **state)
{
    long simple = 0, multiple = 0;

    (void)state;
    for (int round = 0; round < 3000; round++) {
        int num[6], mult[6], n = ix_rng_int(&rng, 1, 4), at = 0, d, sum = 0;
        double c[32], band = 0;
        ix__poly_roots r;
        ix_mark mk = ix__scratch_mark(ctx);

        for (int k = 0; k < n; k++) {
            at += ix_rng_int(&rng, 1, 4);
            num[k] = at; /* of 17 */
            mult[k] = ix_rng_int(&rng, 0, 2) ? 1 : ix_rng_int(&rng, 2, 3);
        }
        d = planted(n, num, 17, mult, c);
        for (int i = 0; i <= d; i++) {
            c[i] /= binomial(d, i);
            band = fmax(band, fabs(c[i]) * DBL_EPSILON / 2);
        }
        ASSERT_OK(ctx, ix__poly_roots_find(ctx, d, c, band, &r));
        for (int k = 0; k < n; k++) {
            double lead = pow(17, mult[k]);
            int hits = 0;

            for (int i = 0; i < n; i++)
                if (i != k)
                    lead *= pow(abs(num[k] - num[i]), mult[i]);
            for (int i = 0; i < r.n; i++) {
                double t = num[k] / 17.0;

                if (t < r.root[i].lo - DBL_EPSILON ||
                    t > r.root[i].hi + DBL_EPSILON)
                    continue;
                hits++;
                if (mult[k] == 1)
                    assert_int_equal(r.root[i].count, 1);
                assert_int_equal(r.root[i].count % 2, mult[k] % 2);
                assert_true(r.root[i].count >= mult[k]);
                /* |p| <= K band there, where p ~ lead (t - t_k)^m; the band
                 * grows with each of the splits, 1e4 in all */
                if (!(r.root[i].hi - r.root[i].lo <
                      pow(1e4 * band / lead, 1.0 / mult[k])))
                    fail_msg("round %d: root %d/17 of multiplicity %d (degree "
                             "%d) in a box of %g, count %d",
                             round, num[k], mult[k], d,
                             r.root[i].hi - r.root[i].lo, r.root[i].count);
            }
            if (hits != 1)
                fail_msg("round %d: root %d/17 of multiplicity %d in %d "
                         "results",
                         round, num[k], mult[k], hits);
            simple += mult[k] == 1;
            multiple += mult[k] > 1;
        }
        for (int i = 0; i < r.n; i++)
            sum += r.root[i].count;
        assert_int_equal(sum, d);
        ix__scratch_release(ctx, mk);
    }
    print_message("# %ld simple and %ld multiple roots found\n", simple,
                  multiple);
}

/* --- splines ----------------------------------------------------------------
 */

#ifdef IX_HAVE_FLINT

/* Distinct roots in the open interval (0, 1) of the Bernstein form b with
 * rational coefficients, by Sturm on x = t / (1 - t); -1 if not squarefree. */
static long sturm(int d, const fmpq *b)
{
    fmpq_poly_t q;
    fmpz_poly_t p;
    fmpq_t v;
    fmpz_t c;
    slong neg = 0, pos = 0;

    fmpq_poly_init(q);
    fmpz_poly_init(p);
    fmpq_init(v);
    fmpz_init(c);
    for (int i = 0; i <= d; i++) {
        fmpz_bin_uiui(c, (ulong)d, (ulong)i);
        fmpq_mul_fmpz(v, b + i, c);
        fmpq_poly_set_coeff_fmpq(q, i, v);
    }
    fmpq_poly_get_numerator(p, q);
    while (!fmpz_poly_is_zero(p) && fmpz_is_zero(p->coeffs))
        fmpz_poly_shift_right(p, p, 1);
    if (fmpz_poly_is_zero(p) || !fmpz_poly_is_squarefree(p))
        pos = -1;
    else if (p->length > 1)
        _fmpz_poly_num_real_roots_sturm(&neg, &pos, p->coeffs, p->length);
    fmpq_poly_clear(q);
    fmpz_poly_clear(p);
    fmpq_clear(v);
    fmpz_clear(c);
    return pos;
}

/* The Bernstein coefficients of the span [k, k + 1] of a uniform spline of
 * degree d with integer points, by blossoming in rationals (de Boor). */
static void span_exact(int d, int k, const int *knots, const int *pts, fmpq *b)
{
    fmpq w[8], x, y;

    for (int i = 0; i <= d; i++)
        fmpq_init(w + i);
    fmpq_init(&x);
    fmpq_init(&y);
    for (int i = 0; i <= d; i++) { /* i arguments at the right end */
        int at = d;

        while (knots[at + 1] <= k)
            at++;
        for (int j = 0; j <= d; j++)
            fmpq_set_si(w + j, pts[at - d + j], 1);
        for (int step = 1; step <= d; step++) {
            int u = step <= i ? k + 1 : k;

            for (int j = 0; j <= d - step; j++) {
                int lo = knots[at - d + step + j], hi = knots[at + 1 + j];

                fmpq_set_si(&x, hi - u, (ulong)(hi - lo));
                fmpq_mul(&x, &x, w + j);
                fmpq_set_si(&y, u - lo, (ulong)(hi - lo));
                fmpq_mul(&y, &y, w + j + 1);
                fmpq_add(w + j, &x, &y);
            }
        }
        fmpq_set(b + i, w);
    }
    for (int i = 0; i <= d; i++)
        fmpq_clear(w + i);
    fmpq_clear(&x);
    fmpq_clear(&y);
}

/* Exact number of zeros of the spline: in the spans, and at the knots where
 * the value is exactly zero; -1 if some span is not squarefree. */
static long spline_count(int d, int spans, const int *knots, const int *pts)
{
    long all = 0;
    fmpq b[8];

    for (int i = 0; i <= d; i++)
        fmpq_init(b + i);
    for (int k = 0; k < spans && all >= 0; k++) {
        long own;

        span_exact(d, k, knots, pts, b);
        own = sturm(d, b);
        all = own < 0 ? -1 : all + own + fmpq_is_zero(b);
        if (all >= 0 && k == spans - 1)
            all += fmpq_is_zero(b + d);
    }
    for (int i = 0; i <= d; i++)
        fmpq_clear(b + i);
    return all;
}

/* Law: a spline with integer points and knots has exactly the zeros that
 * integers say, each reported once, simple, with its signs. */
static void splines_are_exact(void **state)
{
    long verified = 0;

    (void)state;
    for (int round = 0; round < 1500; round++) {
        int d = ix_rng_int(&rng, 1, 5), spans = ix_rng_int(&rng, 1, 8);
        int n = spans + d, kv[32], pts[16], size = 1 << ix_rng_int(&rng, 1, 9);
        double knots[32], p[16];
        ix_dir dir = {
            .basis = IX_BSPLINE, .order = d + 1, .length = n, .knots = knots};
        ix_root *r;
        ix_mv *m;
        long want;
        int got, found = 0;

        for (int i = 0; i <= n + d; i++) {
            kv[i] = i <= d ? 0 : i >= n ? spans : i - d;
            knots[i] = kv[i];
        }
        for (int i = 0; i < n; i++)
            p[i] = pts[i] = ix_rng_int(&rng, -size, size);
        want = spline_count(d, spans, kv, pts);
        if (want < 0)
            continue;
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, p, &m));
        ASSERT_OK(ctx, ix_roots(ctx, m, 0, NULL, &r, &got));
        for (int i = 0; i < got; i++) {
            assert_true(r[i].lo <= r[i].t && r[i].t <= r[i].hi);
            assert_true(i == 0 || r[i - 1].hi <= r[i].lo);
            /* a touch at a knot is one zero; no other kind can occur here */
            found += r[i].kind == IX_ROOT_EVEN || r[i].count >= 1;
        }
        if (found != want) {
            for (int i = 0; i < n; i++)
                print_message("# p[%d] = %d\n", i, pts[i]);
            fail_msg("round %d, degree %d, %d spans: %d zeros, exactly %ld",
                     round, d, spans, found, want);
        }
        verified += want;
        ix_roots_free(ctx, r, got);
        ix_mv_unref(ctx, m);
    }
    print_message("# %ld zeros of splines verified\n", verified);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
#ifdef IX_HAVE_FLINT
        cmocka_unit_test(splines_are_exact),
#endif
        cmocka_unit_test(planted_roots)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
