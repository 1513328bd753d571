/* Decomposition into spans and back, on random directions. */
#include <limits.h>
#include <string.h>

#include "bsp/basis.h"
#include "bsp/spans.h"
#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(1)

/* Value at t of Bernstein coefficients c[(degree + 1)][stride]. */
static double bernstein(int degree, const double *c, size_t stride, double a,
                        double b, double t)
{
    ix_dir bez = {IX_BEZIER, degree + 1, degree + 1, false, NULL};
    double w[IX_MAX_ORDER], sum = 0;

    ix__basis_derive(&bez, 0, (t - a) / (b - a), 0, w);
    for (int i = 0; i <= degree; i++)
        sum += w[i] * c[(size_t)i * stride];
    return sum;
}

static size_t rows_before(const ix_mv *m, int dir)
{
    size_t s = 1;

    for (int d = 0; d < dir; d++)
        s *= (size_t)ix_mv_length(m, d);
    return s;
}

/* Law: on every span, the Bernstein form has the values of the B-spline. */
static void check_extract(const ix_dir *dir, const ix_spans *sp,
                          const double *in, const size_t shape[2])
{
    size_t outer = shape[0], inner = shape[1];
    size_t n = (size_t)sp->nspans * (size_t)dir->order;
    double *out, w[IX_MAX_ORDER];

    out = ix__scratch(ctx, outer * n * inner, sizeof *out);
    assert_non_null(out);
    ASSERT_OK(ctx, ix__spans_extract(ctx, dir, sp, outer, inner, in, out));
    for (int trial = 0; trial < 20; trial++) {
        int j = ix_rng_int(&rng, 0, sp->nspans - 1), first;
        size_t o = (size_t)ix_rng_int(&rng, 0, (int)outer - 1);
        size_t i = (size_t)ix_rng_int(&rng, 0, (int)inner - 1);
        double a = sp->breaks[j], b = sp->breaks[j + 1], want = 0, got;
        double t = ix_rng_range(&rng, a, b);

        first = ix__basis_first(dir, t);
        ix__basis_derive(dir, first, t, 0, w);
        for (int q = 0; q < dir->order; q++)
            want += w[q] * in[(o * (size_t)dir->length +
                               (size_t)((first + q) % dir->length)) *
                                  inner +
                              i];
        got = bernstein(dir->order - 1,
                        out + (o * n + (size_t)(j * dir->order)) * inner + i,
                        inner, a, b, t);
        /* both are convex combinations of points in [-1, 3] */
        ASSERT_CLOSE(got, want, 1e-14 * dir->order);
    }
}

/* A break in the middle of the domain that the direction does not have. */
static ix_spans one_break(const ix_spans *sp, double *mid)
{
    static const int smooth = INT_MAX;

    mid[0] = sp->breaks[0];
    mid[2] = sp->breaks[sp->nspans];
    mid[1] = mid[0] + (mid[2] - mid[0]) * ix_rng_range(&rng, 0.1, 0.9);
    return (ix_spans){0, 2, mid, &smooth};
}

static void extract_has_the_same_values(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL);
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        ix_dir d = ix_mv_dir(m, dir);
        size_t inner = rows_before(m, dir);
        size_t all = ix_mv_npts(m) * (size_t)ix_mv_naxes(m);
        size_t shape[2] = {all / inner / (size_t)d.length, inner};
        ix_mark mk = ix__scratch_mark(ctx);
        ix_spans sp, more, both;
        double mid[3];

        ASSERT_OK(ctx, ix__spans_of(ctx, &d, &sp));
        check_extract(&d, &sp, ix_mv_axis(m, 0), shape);
        more = one_break(&sp, mid);
        ASSERT_OK(ctx, ix__spans_union(ctx, &sp, &more, 7, &both));
        check_extract(&d, &both, ix_mv_axis(m, 0), shape);
        ix__scratch_release(ctx, mk);
        ix_mv_unref(ctx, m);
    }
}

/* Composes what was extracted of direction dir and compares, tolerance tol. */
static void round_trip(const ix_mv *m, int dir, double tol)
{
    ix_dir d = ix_mv_dir(m, dir), back;
    size_t inner = rows_before(m, dir);
    size_t n = ix_mv_npts(m) * (size_t)ix_mv_naxes(m);
    size_t outer = n / inner / (size_t)d.length;
    ix_mark mk = ix__scratch_mark(ctx);
    double *bern, *got;
    ix_spans sp;

    ASSERT_OK(ctx, ix__spans_of(ctx, &d, &sp));
    bern = ix__scratch(ctx,
                       outer * inner * (size_t)(sp.nspans * (sp.degree + 1)),
                       sizeof *bern);
    got = ix__scratch(ctx, n, sizeof *got);
    assert_true(bern && got);
    ASSERT_OK(ctx, ix__spans_extract(ctx, &d, &sp, outer, inner,
                                     ix_mv_axis(m, 0), bern));
    ASSERT_OK(ctx, ix__spans_target(ctx, &sp, INT_MAX, true, &back));
    assert_int_equal(back.basis, d.basis);
    assert_int_equal(back.length, d.length);
    for (int i = 0; i < ix_knots_count(&d); i++)
        assert_true(back.knots[i] == d.knots[i]);
    ASSERT_OK(ctx, ix__spans_compose(ctx, &sp, &back, outer, inner, bern, got));
    for (size_t i = 0; i < n; i++)
        ASSERT_CLOSE(got[i], ix_mv_axis(m, 0)[i], tol);
    ix__scratch_release(ctx, mk);
}

/* Law: composing what was extracted gives the coefficients of the open
 * B-spline back. */
static void compose_undoes_extract(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_JUMPS};

    (void)state;
    for (int k = 0; k < 300; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);

        /* order <= 6, spans within a factor 15: up to 16^4 ulp */
        round_trip(m, ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1), 1e-10);
        ix_mv_unref(ctx, m);
    }
}

/* High order with joints of low continuity, as chains of products have them:
 * nearly all blossom arguments are at ends of spans. */
static void high_order_compose(void **state)
{
    enum { ORDER = 400, DISTINCT = 4 };
    static double knots[(DISTINCT + 2) * ORDER], pts[(DISTINCT + 1) * ORDER];
    ix_dir dir = {IX_BSPLINE, ORDER, 0, false, knots};
    int n = 0;
    ix_mv *m;

    (void)state;
    for (int j = 0; j <= DISTINCT + 1; j++) {
        int mult = j % (DISTINCT + 1) ? ORDER - 1 - ix_rng_int(&rng, 0, 3)
                                      : ORDER;

        for (int i = 0; i < mult; i++)
            knots[n++] = j * j;
    }
    dir.length = n - ORDER;
    for (int i = 0; i < dir.length; i++)
        pts[i] = ix_rng_range(&rng, -1, 1);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    round_trip(m, 0, 1e-10); /* up to two arguments, 9 times a span away */
    ix_mv_unref(ctx, m);
}

/* High order and simple knots: a single span would multiply errors by 10^21,
 * the basis itself only by about (pi/2)^24 = 5 10^4. */
static void smooth_high_order_compose(void **state)
{
    double knots[24 + 54], pts[54];
    const ix_dir dir = {IX_BSPLINE, 24, 54, false, knots};
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, 24, 54, knots));
    for (int i = 0; i < 54; i++)
        pts[i] = ix_rng_range(&rng, -1, 1);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    round_trip(m, 0, 1e-10);
    ix_mv_unref(ctx, m);
}

/* Composition takes the long span next to a very short one: the short one
 * would multiply rounding errors by 10^9. */
static void compose_avoids_short_spans(void **state)
{
    const double knots[] = {0, 0, 0, 0, 1e-9, 1, 2, 2, 2, 2};
    const double pts[] = {1, -1, 0.5, 2, 1, -0.5};
    const ix_dir dir = {IX_BSPLINE, 4, 6, false, knots};
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    round_trip(m, 0, 1e-14);
    ix_mv_unref(ctx, m);
}

static void breaks_and_continuity(void **state)
{
    const double ka[] = {0, 0, 0, 0, 1, 1, 2, 3, 3, 3, 3};
    const double kb[] = {-1, 0, 1 + 1e-16, 2.5, 3, 4};
    const ix_dir a = {IX_BSPLINE, 4, 7, false, ka};
    const ix_dir b = {IX_BSPLINE, 2, 4, false, kb};
    const double breaks[] = {0, 1, 2, 2.5, 3};
    const int cont[] = {0, 2, 0};
    const double open[] = {0, 0, 0, 0, 1, 1, 1, 2, 2.5, 2.5, 2.5, 3, 3, 3, 3};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_spans sa, sb, both;
    ix_dir t;

    (void)state;
    ASSERT_OK(ctx, ix__spans_of(ctx, &a, &sa));
    ASSERT_OK(ctx, ix__spans_of(ctx, &b, &sb));
    assert_int_equal(sa.nspans, 3);
    assert_true(sa.cont[0] == 1 && sa.cont[1] == 2 && sb.cont[0] == 0);
    ASSERT_OK(ctx, ix__spans_union(ctx, &sa, &sb, 3, &both));
    assert_int_equal(both.nspans, 4);
    assert_memory_equal(both.breaks, breaks, sizeof breaks);
    assert_memory_equal(both.cont, cont, sizeof cont);
    ASSERT_OK(ctx, ix__spans_target(ctx, &both, INT_MAX, true, &t));
    assert_int_equal(t.length, 11);
    assert_memory_equal(t.knots, open, sizeof open);
    ASSERT_OK(ctx, ix__spans_target(ctx, &both, 0, true, &t));
    assert_int_equal(t.length, 13); /* C0: multiplicity 3 everywhere */
    both.degree = 2;                /* continuity 2 of degree 2: no knot at 2 */
    ASSERT_OK(ctx, ix__spans_target(ctx, &both, INT_MAX, true, &t));
    assert_int_equal(t.length, 7);
    ix__scratch_release(ctx, mk);
}

/* Breaks at which nothing is known to jump stay where they are. */
static void union_of_smooth_breaks(void **state)
{
    const double ba[] = {0, 1, 4}, bb[] = {0, 2, 4};
    const double breaks[] = {0, 1, 2, 4};
    const int smooth[] = {INT_MAX};
    const ix_spans a = {3, 2, ba, smooth}, b = {3, 2, bb, smooth};
    const ix_spans none = {3, 1, (const double[]){0, 4}, smooth};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_spans both;

    (void)state;
    ASSERT_OK(ctx, ix__spans_union(ctx, &a, &b, 3, &both));
    assert_int_equal(both.nspans, 3);
    assert_memory_equal(both.breaks, breaks, sizeof breaks);
    ASSERT_OK(ctx, ix__spans_union(ctx, &a, &none, 3, &both));
    assert_int_equal(both.nspans, 2);
    assert_memory_equal(both.breaks, ba, sizeof ba);
    ix__scratch_release(ctx, mk);
}

static void power_is_refused(void **state)
{
    const ix_dir p = {IX_POWER, 2, 2, false, NULL};
    double x[2] = {0};
    ix_spans sp;

    (void)state;
    assert_int_equal(ix__spans_of(ctx, &p, &sp), IX_EARG);
    assert_int_equal(ix__spans_extract(ctx, &p, &sp, 1, 1, x, x), IX_EARG);
}

/* Extraction, composition and fit with every allocation failing. */
static ix_status chain(ix_ctx *c, void *state)
{
    const double knots[] = {0, 0, 0, 1, 2, 3, 3, 3}, pts[] = {1, 2, 4, 3, 0};
    const ix_dir d = {IX_BSPLINE, 3, 5, false, knots};
    double bern[9], out[9], err;
    ix_mark mk = ix__scratch_mark(c);
    ix_spans sp;
    ix_dir t;
    ix_status st = ix__spans_of(c, &d, &sp);

    (void)state;
    if (st == IX_OK)
        st = ix__spans_extract(c, &d, &sp, 1, 1, pts, bern);
    if (st == IX_OK)
        st = ix__spans_target(c, &sp, INT_MAX, false, &t);
    if (st == IX_OK)
        st = ix__spans_compose(c, &sp, &t, 1, 1, bern, out);
    if (st == IX_OK)
        st = ix__spans_fit(c, &sp, &t, 1, 1, bern, out, &err);
    ix__scratch_release(c, mk);
    return st;
}

static void out_of_memory(void **state)
{
    (void)state;
    assert_true(ix_fault_run(&(ix_fault_case){.run = chain}) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extract_has_the_same_values),
        cmocka_unit_test(compose_undoes_extract),
        cmocka_unit_test(high_order_compose),
        cmocka_unit_test(smooth_high_order_compose),
        cmocka_unit_test(compose_avoids_short_spans),
        cmocka_unit_test(breaks_and_continuity),
        cmocka_unit_test(union_of_smooth_breaks),
        cmocka_unit_test(power_is_refused),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
