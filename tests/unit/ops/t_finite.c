/* Finite parts of rational multivariates: no pole in any, all of what is far
 * from a pole covered, the domains kept. */
#include <string.h>

#include "crv_test.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8401)

/* 1 / (t - 1/3): a pole inside. */
static ix_mv *hyperbola(ix_ctx *own)
{
    const double pts[6] = {-1.0 / 3, 2.0 / 3, 0, 2.0 / 3 - 1.0 / 3, 1, 1};
    ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    ix_mv *m = NULL;

    if (ix_mv_new(own, 1, &d, 2, true, pts, &m) != IX_OK)
        return NULL;
    return m;
}

/* Law: a part is where it was, its weights have one sign, its points are within
 * reach; with more halvings more is covered, never the pole. */
static void a_pole_is_left_out(void **state)
{
    ix_mv *m = hyperbola(ctx);
    double before = 0;

    (void)state;
    for (int depth = 0; depth <= 12; depth += 3) {
        ix_mv_pieces p;
        double covered = 0;

        ASSERT_OK(ctx, ix_finite_pieces(ctx, m, depth, 0, &p));
        for (size_t i = 0; i < p.count; i++) {
            double dom[2], t = 0.5 * (p.lo[i] + p.hi[i]), x[3], y[3];

            ix_mv_domain(p.piece[i], 0, dom);
            assert_true(dom[0] == p.lo[i] && dom[1] == p.hi[i]);
            assert_false(p.lo[i] <= 1.0 / 3 && 1.0 / 3 <= p.hi[i]);
            assert_false(ix_mv_has_poles(p.piece[i]));
            ASSERT_OK(ctx, ix_mv_point(ctx, p.piece[i], &t, x));
            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, y));
            ASSERT_CLOSE(x[0], y[0], 1e-13);
            covered += p.hi[i] - p.lo[i];
        }
        assert_true(covered >= before);
        assert_true(covered >= 1 - 1.0 / (1 << depth));
        before = covered;
        ix_mv_pieces_free(ctx, &p);
    }
    ix_mv_unref(ctx, m);
}

/* Law: with a reach, no part has a point beyond it, and points well within it
 * and away from poles are covered. A bisector surface. */
static void reach_bounds_the_parts(void **state)
{
    crv_kind k = {2, 3, false, 0, 0, 0};
    size_t inside = 0;

    (void)state;
    for (int i = 0; i < 5; i++) {
        ix_mv *a = rand_crv(ctx, &rng, &k), *b = rand_crv(ctx, &rng, &k), *s;
        ix_mv_pieces p;

        ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, NULL, &s));
        ASSERT_OK(ctx, ix_finite_pieces(ctx, s, 10, 5.0, &p));
        for (size_t j = 0; j < p.count; j++)
            for (int h = 0; h < 9; h++) {
                double t[2], x[3];

                for (size_t q = 0; q < 2; q++)
                    t[q] = p.lo[2 * j + q] +
                           (p.hi[2 * j + q] - p.lo[2 * j + q]) *
                               (q ? h / 3 : h % 3) / 2.0;
                ASSERT_OK(ctx, ix_mv_point(ctx, p.piece[j], t, x));
                for (int c = 0; c < 3; c++)
                    assert_true(fabs(x[c]) <= 5.0 * (1 + 1e-12));
            }
        inside += p.count;
        ix_mv_pieces_free(ctx, &p);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, s);
    }
    assert_true(inside > 5);
}

static void refused(void **state)
{
    ix_mv *m = hyperbola(ctx);
    ix_mv_pieces p;

    (void)state;
    assert_int_equal(ix_finite_pieces(ctx, m, 13, 0, &p), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "depth of 13"));
    assert_int_equal(ix_finite_pieces(ctx, m, 3, NAN, &p), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "reach of nan"));
    assert_true(p.count == 0);
    ix_mv_unref(ctx, m);
}

typedef struct {
    ix_mv *m;
    ix_mv_pieces p;
} operands;

static void make(ix_ctx *own, void *state)
{
    operands *o = state;

    *o = (operands){.m = hyperbola(own)};
}

static ix_status call(ix_ctx *own, void *state)
{
    operands *o = state;

    return ix_finite_pieces(own, o->m, 4, 10.0, &o->p);
}

static void release(ix_ctx *own, void *state)
{
    operands *o = state;

    ix_mv_unref(own, o->m);
    ix_mv_pieces_free(own, &o->p);
}

static void memory_may_fail(void **state)
{
    operands o;
    ix_fault_case c = {make, call, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pole_is_left_out),
        cmocka_unit_test(reach_bounds_the_parts),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
