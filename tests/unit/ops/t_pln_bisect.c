/* Bisectors of coplanar curves cut out of bisector surfaces: against circles,
 * and how fast the error falls. */
#include "crv_test.h"
#include "harness/fault.h"
#include "iritx/ops_plane.h"

static void two_circles(ix_ctx *ctx, ix_mv **a, ix_mv **b)
{
    const double o[3] = {0, 0, 0}, p[3] = {3, 0.5, 0};

    ASSERT_OK(ctx, ix_circle(ctx, o, 1, a));
    ASSERT_OK(ctx, ix_circle(ctx, p, 0.5, b));
}

/* Largest deviation of |x - c1| +- 1 from |x - c2| +- 1/2, of the best signs,
 * for points not farther than 4. */
static double deviation(const ix_lines *l)
{
    double worst = 0;
    int n = 0;

    for (int i = 0; i < l->n; i++)
        for (int j = 0; j < l->count[i]; j++, n++) {
            double d = hypot(l->pt[n][0], l->pt[n][1]), best = INFINITY;
            double e = hypot(l->pt[n][0] - 3, l->pt[n][1] - 0.5);

            if (d > 4)
                continue;
            for (int s = -1; s <= 1; s += 2)
                for (int q = -1; q <= 1; q += 2)
                    best = fmin(best, fabs(fabs(d + s) - fabs(e + 0.5 * q)));
            worst = fmax(worst, best);
        }
    return worst;
}

/* Lifting is exact whatever the distance; tilting by twice the angle deviates
 * four times as much. */
static void errors_of_both(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a, *b;
    double dev[2], err;
    ix_lines l;

    (void)state;
    two_circles(ctx, &a, &b);
    ASSERT_OK(ctx, ix_pln_bisect(ctx, a, b, 0.75, true, 1e-3, &l, &err));
    assert_true(l.n >= 1 && l.pt[0][2] == 0);
    if (!(deviation(&l) <= 1e-9))
        fail_msg("lifted: %g", deviation(&l));
    assert_true(err <= 1e-2); /* ten times the tolerance: domains of 4 */
    ix_lines_free(ctx, &l);
    for (int i = 0; i < 2; i++) {
        ASSERT_OK(ctx, ix_pln_bisect(ctx, a, b, 2 << i, false, 1e-4, &l, NULL));
        assert_true(l.n >= 1);
        dev[i] = deviation(&l);
        ix_lines_free(ctx, &l);
    }
    if (!(dev[0] > 1e-5 && dev[1] / dev[0] > 3 && dev[1] / dev[0] < 5))
        fail_msg("tilted: %g, %g", dev[0], dev[1]);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

static void refused(void **state)
{
    static const double pts[4] = {0, 1, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = make_crv(ctx, 2, 2, NULL, false, 2, pts);
    ix_mv *e1 = make_crv(ctx, 2, 2, NULL, false, 1, pts);
    ix_lines l;

    (void)state;
    assert_int_equal(ix_pln_bisect(ctx, a, a, 0, true, 0, &l, NULL), IX_EARG);
    assert_int_equal(ix_pln_bisect(ctx, a, a, NAN, true, 0, &l, NULL), IX_EARG);
    assert_int_equal(ix_pln_bisect(ctx, a, a, 90, false, 0, &l, NULL), IX_EARG);
    assert_int_equal(ix_pln_bisect(ctx, a, a, 1, true, -1, &l, NULL), IX_EARG);
    assert_int_equal(ix_pln_bisect(ctx, a, e1, 1, true, 0, &l, NULL), IX_EARG);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, e1);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *a, *b;
    ix_lines l;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    static const double p[4] = {0, 1, 0, 0}, q[4] = {0, 1, 1, 2};
    fault_state *s = state;

    *s = (fault_state){.a = make_crv(ctx, 2, 2, NULL, false, 2, p),
                       .b = make_crv(ctx, 2, 2, NULL, false, 2, q)};
}

static ix_status fault_call(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    double err;

    return ix_pln_bisect(ctx, s->a, s->b, 0.5, true, 0.1, &s->l, &err);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix_lines_free(ctx, &s->l);
    ix_mv_unref(ctx, s->a);
    ix_mv_unref(ctx, s->b);
    *s = (fault_state){0};
}

static void no_memory(void **state)
{
    fault_state s = {0};
    ix_fault_case c = {fault_setup, fault_call, fault_teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_both),
        cmocka_unit_test(refused),
        cmocka_unit_test(no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
