/* Multiresolution: the details add up, and are orthogonal to everything
 * coarser. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

static double value(ix_ctx *ctx, const ix_mv *m, double t, int c)
{
    double p[18];

    ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, p));
    return p[c];
}

/* Integral of the product of coordinate c of two curves: 3-point Gauss
 * on n even parts of every span of a, whose knots contain those of b. */
static double product(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int c)
{
    ix_dir d = ix_mv_dir(a, 0);
    double sum = 0;
    const int n = 48;

    for (int i = d.order - 1; i < d.length; i++) {
        double lo = d.knots[i], h = (d.knots[i + 1] - lo) / n;

        for (int j = 0; h > 0 && j < n; j++) { /* 3-point Gauss */
            double mid = lo + h * (j + 0.5), e = h / 2 * 0.77459666924148338;

            for (int g = -1; g <= 1; g++)
                sum += h / 18 * (g ? 5 : 8) * value(ctx, a, mid + g * e, c) *
                       value(ctx, b, mid + g * e, c);
        }
    }
    return sum;
}

static void check_sum(ix_ctx *ctx, const ix_mv *c, const ix_crvs *l)
{
    double dom[2];

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i <= 40; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * i / 40, sum = 0;

        for (int k = 0; k < l->n; k++)
            sum += value(ctx, l->crv[k], t, 0);
        ASSERT_CLOSE(sum, value(ctx, c, t, 0), 1e-11);
    }
}

/* Laws: the sum is the curve; each detail is orthogonal to all before it. */
static void details_are_orthogonal(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(61);
    ix_rand_opts o = {.ndirs = 1, .rational = -1, .max_order = 4};

    (void)state;
    for (int k = 0; k < 24; k++) {
        ix_mv *c = ix_mv_randtest(ctx, &r, &o);
        ix_multires how = {.keep_jumps = k & 1, .wavelets = k & 2};
        ix_crvs l;

        ASSERT_OK(ctx, ix_multires_split(ctx, c, how, &l));
        check_sum(ctx, c, &l);
        for (int i = 1; i < l.n; i++)
            for (int j = 0; j < i; j++)
                /* degree 6 by a rule of degree 5 on 48 parts: below 1e-10 */
                assert_true(fabs(product(ctx, l.crv[i], l.crv[j], 0)) < 1e-8);
        if (!how.keep_jumps) /* the coarsest one is a polynomial */
            assert_int_equal(ix_mv_length(l.crv[0], 0),
                             ix_mv_order(l.crv[0], 0));
        ix_crvs_free(ctx, &l);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Law: a wavelet is orthogonal to any curve without its knot. */
static void wavelets(void **state)
{
    static const double kv[13] = {0, 0, 0, 0, 1, 1.5, 2, 4, 4, 5, 5, 5, 5};
    static const double coarse_kv[12] = {0, 0, 0, 0, 1, 1.5, 4, 4, 5, 5, 5, 5};
    const ix_dir d = {
        .basis = IX_BSPLINE, .order = 4, .length = 9, .knots = kv};
    const ix_dir dc = {
        .basis = IX_BSPLINE, .order = 4, .length = 8, .knots = coarse_kv};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double pts[9] = {0}, top = 0;
    ix_mv *c, *w, *g;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 1, false, pts, &c));
    ASSERT_OK(ctx, ix_multires_wavelet(ctx, c, 6, &w));
    for (int i = 0; i < 9; i++)
        top = fmax(top, fabs(ix_mv_coord(w, 0)[i]));
    ASSERT_CLOSE(top, 1, 0);
    for (int i = 0; i < 8; i++) {
        pts[i] = 1;
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dc, 1, false, pts, &g));
        assert_true(fabs(product(ctx, w, g, 0)) < 1e-8);
        ix_mv_unref(ctx, g);
        pts[i] = 0;
    }
    assert_true(product(ctx, w, w, 0) > 1e-3);
    ix_mv_unref(ctx, w);
    assert_int_equal(ix_multires_wavelet(ctx, c, 3, &w), IX_EARG);
    assert_int_equal(ix_multires_wavelet(ctx, c, 9, &w), IX_EARG);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void rational_is_refused(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_crvs l;
    ix_mv *c, *w;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){0, 0, 0}, 1, &c));
    assert_int_equal(ix_multires_split(ctx, c, (ix_multires){0}, &l), IX_EARG);
    assert_int_equal(l.n, 0);
    assert_int_equal(ix_multires_wavelet(ctx, c, 4, &w), IX_EARG);
    assert_null(w);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *c, *w;
    ix_crvs l;
} state_t;

static void setup(ix_ctx *ctx, void *state)
{
    ASSERT_OK(ctx,
              ix_pcircle(ctx, (double[]){0, 0, 0}, 1, &((state_t *)state)->c));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    state_t *s = state;
    ix_status st = ix_multires_split(ctx, s->c, (ix_multires){0}, &s->l);

    s->w = NULL;
    if (st == IX_OK)
        st = ix_multires_wavelet(ctx, s->c, 5, &s->w);
    return st;
}

static void drop(ix_ctx *ctx, void *state)
{
    state_t *s = state;

    ix_crvs_free(ctx, &s->l);
    ix_mv_unref(ctx, s->c);
    ix_mv_unref(ctx, s->w);
}

static void out_of_memory(void **state)
{
    state_t s;
    const ix_fault_case c = {setup, run, drop, &s};

    (void)state;
    assert_true(ix_fault_run(&c) >= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(details_are_orthogonal),
        cmocka_unit_test(wavelets),
        cmocka_unit_test(rational_is_refused),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
