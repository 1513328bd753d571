/* Decomposition into spans and back, on random directions. */
#include <limits.h>
#include <string.h>

#include "bsp/basis.h"
#include "bsp/spans.h"
#include "harness/fault.h"
#include "harness/randmv.h"

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
static void check_extract(ix_ctx *ctx, ix_rng *r, const ix_dir *dir,
                          const ix_spans *sp, const double *in,
                          const size_t shape[2])
{
    size_t outer = shape[0], inner = shape[1];
    size_t n = (size_t)sp->nspans * (size_t)dir->order;
    double *out, w[IX_MAX_ORDER];

    out = ix__scratch(ctx, outer * n * inner, sizeof *out);
    assert_non_null(out);
    ASSERT_OK(ctx, ix__spans_extract(ctx, dir, sp, outer, inner, in, out));
    for (int trial = 0; trial < 20; trial++) {
        int j = ix_rng_int(r, 0, sp->nspans - 1), first;
        size_t o = (size_t)ix_rng_int(r, 0, (int)outer - 1);
        size_t i = (size_t)ix_rng_int(r, 0, (int)inner - 1);
        double a = sp->breaks[j], b = sp->breaks[j + 1], want = 0, got;
        double t = ix_rng_range(r, a, b);

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

static void extract_has_the_same_values(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(1);

    (void)state;
    for (int k = 0; k < 300; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &r, NULL);
        int dir = ix_rng_int(&r, 0, ix_mv_ndirs(m) - 1);
        ix_dir d = ix_mv_dir(m, dir);
        size_t inner = rows_before(m, dir);
        size_t shape[2] = {ix_mv_npts(m) * (size_t)ix_mv_naxes(m) / inner /
                               (size_t)d.length,
                           inner};
        ix_mark mk = ix__scratch_mark(ctx);
        ix_spans sp, more, both;
        double mid[3];
        int c = INT_MAX;

        ASSERT_OK(ctx, ix__spans_of(ctx, &d, &sp));
        check_extract(ctx, &r, &d, &sp, ix_mv_axis(m, 0), shape);
        mid[0] = sp.breaks[0];
        mid[2] = sp.breaks[sp.nspans];
        mid[1] = mid[0] + (mid[2] - mid[0]) * ix_rng_range(&r, 0.1, 0.9);
        more = (ix_spans){0, 2, mid, &c};
        ASSERT_OK(ctx, ix__spans_union(ctx, &sp, &more, 7, &both));
        check_extract(ctx, &r, &d, &both, ix_mv_axis(m, 0), shape);
        ix__scratch_release(ctx, mk);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Law: composing what was extracted gives the coefficients of the open
 * B-spline back. */
static void compose_undoes_extract(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(2);
    ix_rand_opts o = {.ndirs = 2,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_JUMPS};

    (void)state;
    for (int k = 0; k < 300; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &r, &o);
        ix_dir d = ix_mv_dir(m, 1), back;
        size_t inner = (size_t)ix_mv_length(m, 0);
        size_t outer = (size_t)ix_mv_naxes(m);
        size_t n = outer * ix_mv_npts(m);
        ix_mark mk = ix__scratch_mark(ctx);
        double *bern, *got;
        ix_spans sp;

        ASSERT_OK(ctx, ix__spans_of(ctx, &d, &sp));
        bern = ix__scratch(
            ctx, outer * inner * (size_t)(sp.nspans * (sp.degree + 1)),
            sizeof *bern);
        got = ix__scratch(ctx, n, sizeof *got);
        ASSERT_OK(ctx, ix__spans_extract(ctx, &d, &sp, outer, inner,
                                         ix_mv_axis(m, 0), bern));
        ASSERT_OK(ctx, ix__spans_target(ctx, &sp, INT_MAX, true, &back));
        assert_int_equal(back.basis, d.basis);
        assert_int_equal(back.length, d.length);
        for (int i = 0; i < ix_knots_count(&d); i++)
            assert_true(back.knots[i] == d.knots[i]);
        ASSERT_OK(ctx,
                  ix__spans_compose(ctx, &sp, &back, outer, inner, bern, got));
        /* order <= 6, spans within a factor 15: amplification up to 16^4 */
        for (size_t i = 0; i < n; i++)
            ASSERT_CLOSE(got[i], ix_mv_axis(m, 0)[i], 1e-10);
        ix__scratch_release(ctx, mk);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extract_has_the_same_values),
        cmocka_unit_test(compose_undoes_extract),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
