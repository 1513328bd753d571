/* Zeros of piecewise functions: knots, jumps, vanishing spans, levels. */
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/solve.h"

static ix_mv *bspline(ix_ctx *ctx, int order, int n, const double *knots,
                      const double *pts)
{
    ix_dir d = {
        .basis = IX_BSPLINE, .order = order, .length = n, .knots = knots};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 1, false, pts, &m));
    return m;
}

static void find(ix_ctx *ctx, const ix_mv *m, ix_root **r, int *n)
{
    ASSERT_OK(ctx, ix_roots(ctx, m, 0, NULL, r, n));
}

static void done(ix_ctx *ctx, ix_mv *m, ix_root *r, int n)
{
    ix_roots_free(ctx, r, n);
    ix_mv_unref(ctx, m);
}

/* A broken line through zero at a knot, inside a span and at both ends. */
static void broken_line(void **state)
{
    const double kv[] = {0, 0, 1, 2, 3, 4, 4}, p[] = {0, 1, 0, -1, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = bspline(ctx, 2, 5, kv, p);
    ix_root *r;
    int n;

    (void)state;
    find(ctx, m, &r, &n);
    assert_int_equal(n, 3);
    for (int i = 0; i < 3; i++) {
        ASSERT_CLOSE(r[i].t, 2.0 * i, 0);
        assert_int_equal(r[i].kind, IX_ROOT_SIMPLE);
    }
    assert_int_equal(r[1].before, 1);
    assert_int_equal(r[1].after, -1);
    done(ctx, m, r, n);
    ix_ctx_free(ctx);
}

/* Touching from above at a knot: |t - 1|. */
static void touch_at_knot(void **state)
{
    const double kv[] = {0, 0, 1, 2, 2}, p[] = {1, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = bspline(ctx, 2, 3, kv, p);
    ix_root *r;
    int n;

    (void)state;
    find(ctx, m, &r, &n);
    assert_int_equal(n, 1);
    assert_int_equal(r[0].kind, IX_ROOT_EVEN);
    assert_int_equal(r[0].count, 2);
    ASSERT_CLOSE(r[0].t, 1, 0);
    done(ctx, m, r, n);
    ix_ctx_free(ctx);
}

/* A step from 1 to -1 at t = 1, without a zero. */
static void jump(void **state)
{
    const double kv[] = {0, 0, 1, 1, 2, 2}, p[] = {2, 1, -1, -2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = bspline(ctx, 2, 4, kv, p);
    ix_root *r;
    int n;

    (void)state;
    find(ctx, m, &r, &n);
    assert_int_equal(n, 1);
    assert_int_equal(r[0].kind, IX_ROOT_JUMP);
    ASSERT_CLOSE(r[0].t, 1, 0);
    done(ctx, m, r, n);
    ix_ctx_free(ctx);
}

/* Zero on [1, 3]; the two spans are one interval. */
static void vanishing_spans(void **state)
{
    const double kv[] = {0, 0, 1, 2, 3, 4, 4}, p[] = {1, 0, 0, 0, -1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = bspline(ctx, 2, 5, kv, p);
    ix_root *r;
    int n;

    (void)state;
    find(ctx, m, &r, &n);
    assert_int_equal(n, 1);
    assert_int_equal(r[0].kind, IX_ROOT_INTERVAL);
    ASSERT_CLOSE(r[0].lo, 1, 0);
    ASSERT_CLOSE(r[0].hi, 3, 0);
    assert_int_equal(r[0].before, 1);
    assert_int_equal(r[0].after, -1);
    done(ctx, m, r, n);
    ix_ctx_free(ctx);
}

/* A cubic with simple knots and a root exactly at one of them: it is found
 * once. Law: shifting the function by a level moves the roots, none is lost:
 * every root's value is zero and the signs alternate. */
static void levels(void **state)
{
    const double kv[] = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
    const double p[] = {-1, 2, -3, 1, 2, -2, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = bspline(ctx, 4, 7, kv, p);
    double at = 2, v;

    (void)state;
    ASSERT_OK(ctx, ix_mv_eval(ctx, m, &at, &v));
    for (int k = -10; k <= 10; k++) {
        ix_root_opts o = {.lo = 1, .hi = 0, .level = v + k * 0.1};
        ix_root *r;
        int n, knot = 0;

        ASSERT_OK(ctx, ix_roots(ctx, m, 0, &o, &r, &n));
        for (int i = 0; i < n; i++) {
            double f;

            ASSERT_OK(ctx, ix_mv_eval(ctx, m, &r[i].t, &f));
            ASSERT_CLOSE(f, o.level, 1e-13);
            assert_true(i == 0 || r[i].before == r[i - 1].after);
            knot += fabs(r[i].t - 2) < 1e-9;
        }
        if (k == 0)
            assert_int_equal(knot, 1);
        ix_roots_free(ctx, r, n);
    }
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

static void interval_of_interest(void **state)
{
    const double kv[] = {0, 0, 1, 2, 3, 4, 4}, p[] = {0, 1, 0, -1, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = bspline(ctx, 2, 5, kv, p);
    ix_root_opts o = {.lo = 1.5, .hi = 3};
    ix_root *r;
    int n;

    (void)state;
    ASSERT_OK(ctx, ix_roots(ctx, m, 0, &o, &r, &n));
    assert_int_equal(n, 1);
    ASSERT_CLOSE(r[0].t, 2, 0);
    done(ctx, m, r, n);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_POWER, .order = 2, .length = 2}};
    const double p[4] = {1, 2, 3, 4};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_root *r;
    ix_mv *m;
    int n;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 1, false, p, &m));
    assert_int_equal(ix_roots(ctx, m, 1, NULL, &r, &n), IX_EARG);
    assert_int_equal(ix_roots(ctx, m, -1, NULL, &r, &n), IX_EARG);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d + 1, 1, false, p, &m));
    assert_int_equal(ix_roots(ctx, m, 0, NULL, &r, &n), IX_EARG);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, (ix_dir[]){d[0], d[0]}, 1, false, p, &m));
    assert_int_equal(ix_roots(ctx, m, 0, NULL, &r, &n), IX_EARG);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *m;
    ix_root *r;
    int n;
} oom;

static void oom_setup(ix_ctx *ctx, void *state)
{
    const double kv[] = {0, 0, 0, 1, 2, 2, 2}, p[] = {1, -1, 1, -1};

    ((oom *)state)->m = bspline(ctx, 3, 4, kv, p);
}

static ix_status oom_run(ix_ctx *ctx, void *state)
{
    oom *o = state;

    return ix_roots(ctx, o->m, 0, NULL, &o->r, &o->n);
}

static void oom_teardown(ix_ctx *ctx, void *state)
{
    oom *o = state;

    ix_roots_free(ctx, o->r, o->n);
    ix_mv_unref(ctx, o->m);
}

static void out_of_memory(void **state)
{
    oom o = {0};
    ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) >= 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(broken_line), cmocka_unit_test(touch_at_knot),
        cmocka_unit_test(jump),        cmocka_unit_test(vanishing_spans),
        cmocka_unit_test(levels),      cmocka_unit_test(interval_of_interest),
        cmocka_unit_test(errors),      cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
