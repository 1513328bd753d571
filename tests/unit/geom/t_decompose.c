/* Compositions of random polynomials are taken apart and put together again;
 * what is no composition gives nothing. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"
#include "iritx/sym.h"

static ix_mv *random_bezier(ix_ctx *ctx, ix_rng *r, int order, int ncoords,
                            bool rational, bool in_unit)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = order, .length = order};
    double pts[4 * 16];
    ix_mv *m;

    for (int i = 0; i < order * (ncoords + rational); i++)
        pts[i] = ix_rng_range(r, in_unit ? 0 : -1, 1);
    for (int i = 0; rational && i < order; i++)
        pts[i] = ix_rng_range(r, 0.5, 2);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, ncoords, rational, pts, &m));
    return m;
}

/* Law: f(g(t)) = c(t), for planted compositions of all kinds. */
static void finds_planted(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(101);

    (void)state;
    for (int k = 0; k < 80; k++) {
        ix_mv *f = random_bezier(ctx, &r, ix_rng_int(&r, 3, 5), 1 + k % 3,
                                 k % 2, false);
        ix_mv *g = random_bezier(ctx, &r, ix_rng_int(&r, 3, 4), 1, false, true);
        ix_mv *c, *a, *b, *back, *moved;

        ASSERT_OK(ctx, ix_sym_compose(ctx, f, g, &c));
        if (k % 4 == 3) { /* on another domain */
            ASSERT_OK(ctx, ix_mv_reparam(ctx, c, 0, 2, 5, &moved));
            ix_mv_unref(ctx, c);
            c = moved;
        }
        ASSERT_OK(ctx, ix_decompose(ctx, c, &a, &b));
        assert_non_null(a);
        assert_non_null(b);
        assert_true(ix_mv_order(a, 0) > 2 && ix_mv_order(b, 0) > 2);
        assert_int_equal(ix_mv_ncoords(b), 1);
        ASSERT_OK(ctx, ix_sym_compose(ctx, a, b, &back));
        for (int i = 0; i <= 20; i++) {
            double dom[2], t, p[4], q[4];

            ix_mv_domain(c, 0, dom);
            t = dom[0] + (dom[1] - dom[0]) * i / 20;
            ASSERT_OK(ctx, ix_mv_eval(ctx, c, &t, p));
            ASSERT_OK(ctx, ix_mv_eval(ctx, back, &t, q));
            for (int x = 0; x < ix_mv_naxes(c); x++)
                ASSERT_CLOSE(p[x], q[x], 1e-9); /* as stated */
        }
        ix_mv_unref(ctx, back);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, g);
    }
    ix_ctx_free(ctx);
}

/* Random curves of degree 4 and 6 are no compositions; prime degrees never. */
static void refuses_others(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(102);

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *c = random_bezier(ctx, &r, 4 + k % 4, 2, false, false), *f, *g;

        ASSERT_OK(ctx, ix_decompose(ctx, c, &f, &g));
        assert_null(f);
        assert_null(g);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c, *f, *g;

    (void)state;
    ASSERT_OK(ctx, ix_pcircle(ctx, (double[]){0, 0, 0}, 1, &c));
    assert_int_equal(ix_decompose(ctx, c, &f, &g), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "inner knots"));
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void setup(ix_ctx *ctx, void *state)
{
    ix_rng r = ix_rng_new(7);
    ix_mv *f = random_bezier(ctx, &r, 3, 2, false, false);
    ix_mv *g = random_bezier(ctx, &r, 3, 1, false, true);

    ASSERT_OK(ctx, ix_sym_compose(ctx, f, g, (ix_mv **)state));
    ix_mv_unref(ctx, f);
    ix_mv_unref(ctx, g);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    return ix_decompose(ctx, m[0], &m[1], &m[2]);
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

static void out_of_memory(void **state)
{
    ix_mv *m[3];
    const ix_fault_case c = {setup, run, drop, m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_planted),
        cmocka_unit_test(refuses_others),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
