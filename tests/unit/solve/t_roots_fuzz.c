/* Piecewise functions with jumps, vanishing spans and roots at the ends of
 * spans, rational ones with a level, and orders up to 200, against counts in
 * integers: Sturm sequences by FLINT, for high orders Descartes' rule with
 * exact subdivision. No disagreement is allowed. */
#include <string.h>

#include "harness/randmv.h"
#include "iritx/solve.h"

IX_TEST_FIXTURE(20261123)

#ifdef IX_HAVE_FLINT
#include <flint/fmpz.h>
#include <flint/fmpz_poly.h>

/* Distinct roots in (0, 1) of integer Bernstein coefficients, by Sturm on
 * x = t / (1 - t); -1 if not squarefree there. Not for zero polynomials. */
static long sturm(int d, const long *b)
{
    slong neg = 0, pos = 0;
    fmpz_poly_t p;
    fmpz_t c;

    fmpz_poly_init(p);
    fmpz_init(c);
    for (int i = 0; i <= d; i++) {
        fmpz_bin_uiui(c, (ulong)d, (ulong)i);
        fmpz_mul_si(c, c, b[i]);
        fmpz_poly_set_coeff_fmpz(p, i, c);
    }
    while (fmpz_is_zero(p->coeffs))
        fmpz_poly_shift_right(p, p, 1);
    if (!fmpz_poly_is_squarefree(p))
        pos = -1;
    else if (p->length > 1)
        _fmpz_poly_num_real_roots_sturm(&neg, &pos, p->coeffs, p->length);
    fmpz_poly_clear(p);
    fmpz_clear(c);
    return pos;
}

#define MAX_SPANS 6
#define MAX_D     7

typedef struct {
    int d, spans;
    long b[MAX_SPANS][MAX_D + 1];
    int zero[MAX_SPANS]; /* the span vanishes */
} pieces;

typedef struct {
    long points, jumps, intervals;
} tally;

static int sign_at(const pieces *p, int span, int right)
{
    for (int i = 0; i <= p->d; i++) {
        long v = p->b[span][right ? p->d - i : i];

        if (v)
            return v > 0 ? 1 : -1;
    }
    return 0;
}

/* What the definition says at the breakpoint before span k >= 1. */
static void at_break(const pieces *p, int k, tally *t)
{
    int left = p->b[k - 1][p->d] == 0, right = p->b[k][0] == 0;

    if (p->zero[k] || p->zero[k - 1])
        return; /* belongs to the interval */
    if (left && right)
        t->points++;
    else if (sign_at(p, k - 1, 1) != sign_at(p, k, 0))
        t->jumps++;
    else
        t->points += left || right;
}

/* False if some span has a multiple root. */
static bool exact(const pieces *p, tally *t)
{
    *t = (tally){0, 0, 0};
    for (int k = 0; k < p->spans; k++) {
        long own = p->zero[k] ? 0 : sturm(p->d, p->b[k]);

        if (own < 0)
            return false;
        t->points += own;
        t->intervals += p->zero[k] && !(k > 0 && p->zero[k - 1]);
        if (k > 0)
            at_break(p, k, t);
    }
    t->points += !p->zero[0] && p->b[0][0] == 0;
    t->points += !p->zero[p->spans - 1] && p->b[p->spans - 1][p->d] == 0;
    return true;
}

static void draw(pieces *p, int round)
{
    int size = 1 << ix_rng_int(&rng, 1, 12);

    p->d = ix_rng_int(&rng, 1, MAX_D);
    p->spans = ix_rng_int(&rng, 1, MAX_SPANS);
    for (int k = 0; k < p->spans; k++) {
        int from = 0, to = p->d;

        if (round % 3 == 0) { /* zeros of any multiplicity at the ends */
            from = ix_rng_int(&rng, 0, 2);
            to -= ix_rng_int(&rng, 0, 2);
        }
        p->zero[k] = 1;
        for (int i = 0; i <= p->d; i++) {
            p->b[k][i] = i < from || i > to ? 0 : ix_rng_int(&rng, -size, size);
            p->zero[k] &= p->b[k][i] == 0;
        }
        if (round % 5 == 0 && ix_rng_int(&rng, 0, 2) == 0) {
            memset(p->b[k], 0, sizeof p->b[k]);
            p->zero[k] = 1;
        }
    }
}

/* As a B-spline whose knots all have full multiplicity. With weights w the
 * numerator is b + level w, so that b is what is left of it at the level. */
static ix_mv *spline(const pieces *p, int level)
{
    double knots[(MAX_SPANS + 1) * (MAX_D + 1)];
    double pts[2 * MAX_SPANS * (MAX_D + 1)];
    int m = p->d + 1, n = p->spans * m;
    ix_dir dir = {.basis = IX_BSPLINE, .order = m, .length = n, .knots = knots};
    double *x = level ? pts + n : pts;
    ix_mv *mv;

    for (int i = 0; i < n + m; i++)
        knots[i] = i / m;
    for (int i = 0; i < n; i++) {
        double w = level ? ix_rng_int(&rng, 1, 5) : 0;

        if (level)
            pts[i] = w;
        x[i] = (double)p->b[i / m][i % m] + level * w;
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, level != 0, pts, &mv));
    return mv;
}

static void count(const ix_root *r, int n, tally *t)
{
    *t = (tally){0, 0, 0};
    for (int i = 0; i < n; i++) {
        assert_true(r[i].lo <= r[i].t && r[i].t <= r[i].hi);
        assert_true(i == 0 || r[i - 1].t <= r[i].t);
        t->jumps += r[i].kind == IX_ROOT_JUMP;
        t->intervals += r[i].kind == IX_ROOT_INTERVAL;
        t->points += r[i].kind != IX_ROOT_JUMP && r[i].kind != IX_ROOT_INTERVAL;
    }
}

/* Law: points, jumps and intervals are those that integers give. */
static void pieces_are_exact(void **state)
{
    long all = 0;

    (void)state;
    for (int round = 0; round < 4000; round++) {
        int level = round % 2 ? ix_rng_int(&rng, -3, 3) : 0, n;
        ix_root_opts o = {.lo = 1, .hi = 0, .level = level};
        tally want, got;
        ix_root *r;
        pieces p;
        ix_mv *m;

        draw(&p, round);
        if (!exact(&p, &want))
            continue;
        m = spline(&p, level);
        ASSERT_OK(ctx, ix_roots(ctx, m, level != 0, &o, &r, &n));
        count(r, n, &got);
        if (memcmp(&want, &got, sizeof want) != 0)
            fail_msg("round %d, degree %d, %d spans, level %d: %ld points, %ld "
                     "jumps, %ld intervals; exactly %ld, %ld, %ld",
                     round, p.d, p.spans, level, got.points, got.jumps,
                     got.intervals, want.points, want.jumps, want.intervals);
        all += want.points + want.jumps + want.intervals;
        ix_roots_free(ctx, r, n);
        ix_mv_unref(ctx, m);
    }
    print_message("# %ld points, jumps and intervals verified\n", all);
    assert_true(all > 10000);
}

/* --- high orders ----------------------------------------------------------
 */

static int exact_variations(int d, const fmpz *b)
{
    int last = 0, n = 0;

    for (int i = 0; i <= d; i++) {
        int s = fmpz_sgn(b + i);

        n += s && last && s != last;
        last = s ? s : last;
    }
    return n;
}

/* Roots in (0, 1) by Descartes' rule and halving in integers (coefficients
 * doubled with each layer instead of divided); -1 beyond the depth. */
static long descartes(int d, const fmpz *b, int depth)
{
    int v = exact_variations(d, b);
    long left, right;
    fmpz *l, *r;

    if (v <= 1)
        return v;
    if (depth == 0)
        return -1;
    l = _fmpz_vec_init(d + 1);
    r = _fmpz_vec_init(d + 1);
    _fmpz_vec_set(r, b, d + 1);
    for (int k = 0; k <= d; k++) {
        fmpz_mul_2exp(l + k, r, (ulong)(d - k));
        for (int i = 0; i < d - k; i++)
            fmpz_add(r + i, r + i, r + i + 1);
    }
    for (int k = 0; k <= d; k++) /* r[k] was last doubled d - k times */
        fmpz_mul_2exp(r + k, r + k, (ulong)k);
    left = descartes(d, l, depth - 1);
    right = descartes(d, r, depth - 1);
    if (left >= 0 && right >= 0)
        left += right + fmpz_is_zero(r);
    else
        left = -1;
    _fmpz_vec_clear(l, d + 1);
    _fmpz_vec_clear(r, d + 1);
    return left;
}

/* Integer coefficients with few changes of sign, so that exact counting is
 * quick, and zeros at the ends now and then. */
static int few_changes(int d, double *x, fmpz *b)
{
    int sign = 1, ends = 0;

    for (int i = 0; i <= d; i++) {
        int v = ix_rng_int(&rng, 1, 1 << 20);

        if (ix_rng_int(&rng, 0, d / 6) == 0)
            sign = -sign;
        if ((i == 0 || i == d) && ix_rng_int(&rng, 0, 3) == 0) {
            v = 0;
            ends++;
        }
        x[i] = sign * v;
        fmpz_set_si(b + i, sign * v);
    }
    return ends;
}

/* Law: Bezier curves of orders up to 200 have the zeros that integers give. */
static void high_orders(void **state)
{
    long all = 0;

    (void)state;
    for (int round = 0; round < 60; round++) {
        int d = round < 4 ? 199 : ix_rng_int(&rng, 20, 90), n, ends;
        ix_dir dir = {.basis = IX_BEZIER, .order = d + 1, .length = d + 1};
        double x[200];
        fmpz *b = _fmpz_vec_init(d + 1);
        ix_root *r;
        tally got;
        long want;
        ix_mv *m;

        ends = few_changes(d, x, b);
        want = descartes(d, b, 12);
        _fmpz_vec_clear(b, d + 1);
        if (want < 0)
            continue;
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, x, &m));
        ASSERT_OK(ctx, ix_roots(ctx, m, 0, NULL, &r, &n));
        count(r, n, &got);
        if (got.points != want + ends || n != got.points)
            fail_msg("round %d, degree %d: %ld zeros, exactly %ld", round, d,
                     got.points, want + ends);
        all += want + ends;
        ix_roots_free(ctx, r, n);
        ix_mv_unref(ctx, m);
    }
    print_message("# %ld zeros of high order verified\n", all);
    assert_true(all > 100);
}
#endif

int main(void)
{
#ifdef IX_HAVE_FLINT
    const struct CMUnitTest tests[] = {cmocka_unit_test(pieces_are_exact),
                                       cmocka_unit_test(high_orders)};

    return cmocka_run_group_tests(tests, setup, teardown);
#else
    return (void)rng, (void)setup, (void)teardown, 0;
#endif
}
