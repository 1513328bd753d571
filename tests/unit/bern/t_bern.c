/* Kernels on raw arrays: binomials, products, partials, restriction. */
#include "bern/bern.h"
#include "harness/test.h"

#include <stdlib.h>
#include <string.h>

enum { MAXD = 40 };

static void random_row(ix_rng *r, int n, double *x)
{
    for (int i = 0; i < n; i++)
        x[i] = ix_rng_range(r, -1, 1);
}

/* The definition: sum c_k u^k v^(d-k). */
static double form_value(int d, const double *c, double u, double v)
{
    double s = 0;

    for (int k = 0; k <= d; k++)
        s += c[k] * pow(u, k) * pow(v, d - k);
    return s;
}

/* Law: C(d,k) = C(d-1,k-1) + C(d-1,k), C(d,0) = C(d,d) = 1, row sums 2^d.
 * Tolerance: each entry is within one ulp. */
static void binomials_obey_pascal(void **state)
{
    double a[1024], b[1024];

    (void)state;
    for (int d = 1; d < 1024; d += d < 80 ? 1 : 59) {
        const double *lo = ix__binom(d - 1, a), *hi = ix__binom(d, b);
        double sum = hi[0] * ldexp(1, -d);

        assert_true(hi[0] == 1 && hi[d] == 1);
        for (int k = 1; k <= d; k++) {
            double next = k < d ? lo[k] : 0;

            ASSERT_CLOSE(hi[k] / (lo[k - 1] + next), 1, 4.5e-16);
            sum += ldexp(hi[k], -d);
        }
        ASSERT_CLOSE(sum, 1, 1e-15);
    }
}

/* Law: (a b)(u, v) = a(u, v) b(u, v), spans by spans, set, added, subtracted.
 * Tolerance: 2 (p + q) ulp of sum |a||b|. */
static void products_multiply_values(void **state)
{
    ix_rng r = ix_rng_new(11);
    double *a = malloc(8 * 3 * (MAXD + 1)), *b = malloc(8 * 3 * (MAXD + 1));
    double *o = malloc(8 * 3 * (2 * MAXD + 1)), w[MAXD + 64];

    (void)state;
    for (int round = 0; round < 200; round++) {
        int p = ix_rng_int(&r, 0, round < 100 ? 5 : MAXD);
        int q = ix_rng_int(&r, 0, round % 2 ? 5 : MAXD), d = p + q;
        double u = ix_rng_unit(&r);

        random_row(&r, 3 * (p + 1), a);
        random_row(&r, 3 * (q + 1), b);
        ix__bern_conv_spans(3, p, a, q, b, IX__SET, w, o);
        ix__bern_conv_spans(3, p, a, q, b, IX__ADD, w, o);
        ix__bern_conv_spans(3, p, a, q, b, IX__ADD, w, o);
        ix__bern_conv_spans(3, p, a, q, b, IX__SUB, w, o);
        for (int s = 0; s < 3; s++)
            ASSERT_CLOSE(form_value(d, o + s * (d + 1), u, 1 - u),
                         2 * form_value(p, a + s * (p + 1), u, 1 - u) *
                             form_value(q, b + s * (q + 1), u, 1 - u),
                         1e-14);
    }
    free(a);
    free(b);
    free(o);
}

/* Law: at the strides of the result, a product of tensors is one convolution.
 * Compared with the double sum over both indices. */
static void sparse_product_is_tensor_product(void **state)
{
    ix_rng r = ix_rng_new(12);

    (void)state;
    for (int round = 0; round < 50; round++) {
        int p[2] = {ix_rng_int(&r, 0, 4), ix_rng_int(&r, 0, 4)};
        int q[2] = {ix_rng_int(&r, 0, 4), ix_rng_int(&r, 0, 4)};
        int w = p[0] + q[0] + 1, n = w * (p[1] + q[1] + 1), off[25], na = 0;
        double a[25], b[128] = {0}, out[96], want[96] = {0};
        double *mid = b + IX__BERN_PAD;

        for (int j = 0; j <= p[1]; j++)
            for (int i = 0; i <= p[0]; i++) {
                off[na] = j * w + i;
                a[na++] = ix_rng_range(&r, -1, 1);
            }
        for (int j = 0; j <= q[1]; j++)
            for (int i = 0; i <= q[0]; i++)
                mid[j * w + i] = ix_rng_range(&r, -1, 1);
        for (int k = 0; k < na; k++)
            for (int i = 0; i < q[1] * w + q[0] + 1; i++)
                want[off[k] + i] += a[k] * mid[i];
        ix__bern_conv_sparse(na, a, off, q[1] * w + q[0] + 1, mid, n, out);
        for (int i = 0; i < n; i++)
            ASSERT_CLOSE(out[i], want[i], 1e-15);
    }
}

/* Value of column i of a block of three. */
static double column(int d, const double *block, int i, double u)
{
    double c[2 * MAXD + 2] = {0};

    for (int k = 0; k <= d; k++)
        c[k] = block[k * 3 + i];
    ASSERT_CLOSE(ix__bern_value(d, c, u, 1 - u), form_value(d, c, u, 1 - u),
                 1e-12);
    return form_value(d, c, u, 1 - u);
}

/* Laws, in blocks of several columns: elevation keeps values; Euler's
 * u F_u + v F_v = d F; derivative = F_u - F_v; its integral gives F back. */
static void calculus_of_forms(void **state)
{
    ix_rng r = ix_rng_new(13);
    double a[99], e[99], x[99], y[99], g[99], f[99], row[33], row1[33];
    double start[3];

    (void)state;
    for (int round = 0; round < 50; round++) {
        int d = ix_rng_int(&r, 1, 12), up = ix_rng_int(&r, 0, 12);
        double u = ix_rng_unit(&r), v = 1 - u;

        random_row(&r, (d + 1) * 3, a);
        ix__bern_elevate(d, up, ix__binom(up, row), 3, a, e);
        ix__bern_partial_u(d, 1, 3, a, x);
        ix__bern_partial_v(d, 1, 3, a, y);
        ix__bern_derive(d, 1, 3, a, g);
        memcpy(start, a, sizeof start);
        ix__bern_integrate(d - 1, 1, ix__binom(d - 1, row), ix__binom(d, row1),
                           3, g, start, f);
        for (int i = 0; i < 3; i++) {
            double va = column(d, a, i, u), vx = column(d - 1, x, i, u);
            double vy = column(d - 1, y, i, u), vg = column(d - 1, g, i, u);

            ASSERT_CLOSE(column(d + up, e, i, u), va, 1e-13);
            ASSERT_CLOSE(u * vx + v * vy, d * va, 1e-12);
            ASSERT_CLOSE(vg, vx - vy, 1e-12);
            ASSERT_CLOSE(column(d, f, i, u), va, 1e-12);
            ASSERT_CLOSE(start[i], a[d * 3 + i], 1e-12);
        }
    }
}

/* Law: a restricted polynomial has the old values at mapped parameters, also
 * outside [0, 1]. */
static void restriction_keeps_values(void **state)
{
    ix_rng r = ix_rng_new(14);
    double b[60], c[60], scaled[60], row[20];

    (void)state;
    for (int round = 0; round < 100; round++) {
        int d = ix_rng_int(&r, 0, 12);
        double lo = ix_rng_range(&r, -0.2, 1), hi = ix_rng_range(&r, lo, 1.2);
        double u = ix_rng_unit(&r), t = lo + u * (hi - lo);

        if (round % 10 == 0)
            lo = 0, t = u * hi;
        if (round % 10 == 1)
            hi = 1, t = lo + u * (1 - lo);
        random_row(&r, (d + 1) * 3, b);
        ix__bern_restrict(d, lo, hi, 3, b, c);
        ix__bern_scale(1, d, 3, ix__binom(d, row), b, scaled);
        ix__bern_scale(1, d, 3, ix__binom(d, row), c, c);
        for (int i = 0; i < 3; i++)
            ASSERT_CLOSE(column(d, c, i, u), column(d, scaled, i, t), 1e-11);
        ix__bern_unscale(1, d, 3, ix__binom(d, row), scaled, scaled);
        for (int i = 0; i < (d + 1) * 3; i++)
            ASSERT_CLOSE(scaled[i], b[i], 1e-15);
    }
}

/* Law: combining rows is the sum term by term; any length. */
static void combination_sums(void **state)
{
    ix_rng r = ix_rng_new(15);
    double x[3][21], f[3] = {2, -1, 0.5}, out[21];
    const double *rows[3] = {x[0], x[1], x[2]};

    (void)state;
    for (int i = 0; i < 3; i++)
        random_row(&r, 21, x[i]);
    for (size_t n = 0; n <= 21; n++) {
        ix__bern_combine(n, 3, f, rows, out);
        for (size_t i = 0; i < n; i++)
            assert_true(out[i] == 2 * x[0][i] - x[1][i] + 0.5 * x[2][i]);
    }
}

/* Zeros count as nothing; numbers inside the band are undecided. */
static void variations_are_counted(void **state)
{
    const double c[] = {1, 0, -2, -1e-9, 1e-9, 3, 4, -1};
    bool undecided;

    (void)state;
    assert_int_equal(ix__bern_variations(8, c, 0, NULL), 3);
    assert_int_equal(ix__bern_variations(8, c, 1e-8, &undecided), 3);
    assert_true(undecided);
    assert_int_equal(ix__bern_variations(3, c + 5, 0, &undecided), 1);
    assert_false(undecided);
}

/* Largest and finite, whatever the length and the place. */
static void rows_are_measured(void **state)
{
    double x[21];

    (void)state;
    for (size_t n = 1; n <= 21; n++)
        for (size_t at = 0; at < n; at++) {
            for (size_t i = 0; i < n; i++)
                x[i] = i % 2 ? 1 : -1;
            x[at] = -7;
            assert_true(ix__bern_largest(n, x) == 7);
            assert_true(ix__bern_finite(n, x));
            x[at] = -HUGE_VAL;
            assert_true(ix__bern_largest(n, x) == HUGE_VAL);
            assert_false(ix__bern_finite(n, x));
            x[at] = nan("");
            assert_true(ix__bern_largest(n, x) == (n > 1));
            assert_false(ix__bern_finite(n, x));
        }
    assert_true(ix__bern_largest(0, x) == 0);
}

/* Law: sum a_k u^k at the parameters of the Bernstein coefficients. */
static void power_to_bernstein(void **state)
{
    ix_rng r = ix_rng_new(16);
    double a[30], p[30], row[10];

    (void)state;
    for (int d = 0; d < 10; d++) {
        double u = ix_rng_unit(&r);

        random_row(&r, (d + 1) * 3, a);
        memcpy(p, a, sizeof p);
        ix__bern_from_power(d, 3, a);
        ix__bern_scale(1, d, 3, ix__binom(d, row), a, a);
        for (int i = 0; i < 3; i++) {
            double s = 0;

            for (int k = d; k >= 0; k--)
                s = s * u + p[k * 3 + i];
            ASSERT_CLOSE(column(d, a, i, u), s, 1e-13);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(binomials_obey_pascal),
        cmocka_unit_test(products_multiply_values),
        cmocka_unit_test(sparse_product_is_tensor_product),
        cmocka_unit_test(calculus_of_forms),
        cmocka_unit_test(restriction_keeps_values),
        cmocka_unit_test(combination_sums),
        cmocka_unit_test(variations_are_counted),
        cmocka_unit_test(rows_are_measured),
        cmocka_unit_test(power_to_bernstein),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
