/* Reduction: what was raised, multiplied or refined comes back; what is
 * already lowest stays; the map never changes. */
#include "iritx/ops.h"
#include "sym_test.h"

/* Every axis of m (weight too) times the scalar polynomial h. */
static ix_mv *times(ix_ctx *ctx, const ix_mv *m, const ix_mv *h)
{
    const ix_mv *axes[IX_MAX_COORDS + 1];
    ix_mv *out, *t, *a;
    int n = ix_mv_naxes(m);

    for (int i = 0; i < n; i++) {
        ASSERT_OK(ctx, ix_mv_scalar(ctx, m, i, &a));
        ASSERT_OK(ctx, ix_sym_mul(ctx, a, h, NULL, &t));
        ix_mv_unref(ctx, a);
        axes[i] = t;
    }
    ASSERT_OK(ctx, ix_mv_join_scalars(ctx, n, axes, ix_mv_rational(m), &out));
    for (int i = 0; i < n; i++)
        ix_mv_unref(ctx, axes[i]);
    return out;
}

static void same_map(ix_ctx *ctx, ix_rng *r, const ix_mv *a, const ix_mv *b,
                     double tol)
{
    for (int k = 0; k < 8; k++) {
        double t[4], x[IX_MAX_COORDS], y[IX_MAX_COORDS];

        rand_param(r, a, t);
        value_at(ctx, a, t, x);
        value_at(ctx, b, t, y);
        for (int i = 0; i < ix_mv_ncoords(a); i++)
            ASSERT_CLOSE(x[i], y[i], tol);
    }
}

static int degrees_of(const ix_mv *m)
{
    int n = 0;

    for (int i = 0; i < ix_mv_ndirs(m); i++)
        n += ix_mv_order(m, i) - 1;
    return n;
}

/* Law: m times a polynomial h in one direction has the same map and reduces to
 * the degrees of m; the report says how far. h has no zero in the domain in
 * half of the rounds. Tolerance: the report's bound, amplified by 1/w. */
static void factors_are_found(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(51);

    for (int round = 0; round < 40; round++) {
        int nd = 1 + round % 2, dh = ix_rng_int(&r, 1, 4);
        ix_rand_opts s = {.ndirs = nd,
                          .ncoords = 2,
                          .rational = 1,
                          .kinds = round & 4 ? IX_RAND_OPEN : IX_RAND_BEZIER,
                          .min_order = 2,
                          .max_order = 5,
                          .max_knots = 3};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *h, *mh, *back;
        double pts[5], dom[2];
        ix_dir one[2] = {{IX_BSPLINE, 1, 1, false, NULL},
                         {IX_BSPLINE, 1, 1, false, NULL}};
        double ends[2][10];
        ix_reduce_report rep;

        for (int i = 0; i < nd; i++) {
            bool here = i == nd - 1;

            ix_mv_domain(m, i, dom);
            one[i].order = one[i].length = here ? dh + 1 : 1;
            for (int k = 0; k < 2 * one[i].order; k++)
                ends[i][k] = dom[k >= one[i].order];
            one[i].knots = ends[i];
            if (!(round & 4))
                one[i].basis = IX_BEZIER;
        }
        for (int k = 0; k <= dh; k++)
            pts[k] = round & 8 ? ix_rng_range(&r, -1, 1)
                               : ix_rng_range(&r, 0.5, 1.5);
        ASSERT_OK(w->ctx, ix_mv_new(w->ctx, nd, one, 1, false, pts, &h));
        mh = times(w->ctx, m, h);
        ASSERT_OK(w->ctx, ix_sym_reduce(w->ctx, mh, 1e-10, &rep, &back));
        assert_int_equal(degrees_of(mh), degrees_of(m) + dh);
        if (degrees_of(back) != degrees_of(m))
            fail_msg("round %d: degrees %d, %d expected (h %d, change %g)",
                     round, degrees_of(back), degrees_of(m), dh, rep.change);
        assert_int_equal(rep.degrees, dh);
        assert_true(rep.change <= 1e-10);
        assert_int_equal(ix_mv_npts(back), ix_mv_npts(m));
        same_map(w->ctx, &r, m, back, 1e-6);
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, h);
        ix_mv_unref(w->ctx, mh);
        ix_mv_unref(w->ctx, back);
    }
}

/* Law: raising orders and inserting knots is undone. */
static void raised_and_refined_comes_back(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(52);

    for (int round = 0; round < 30; round++) {
        ix_rand_opts s = {.ndirs = 1 + round % 2,
                          .ncoords = 2,
                          .rational = round & 2 ? 1 : -1,
                          .kinds = IX_RAND_OPEN,
                          .min_order = 2,
                          .max_order = 4,
                          .max_knots = 3,
                          .unit = true};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *up, *fine, *back;
        double knots[3] = {0.15, 0.35, 0.85};
        ix_reduce_report rep;

        ASSERT_OK(w->ctx,
                  ix_mv_raise(w->ctx, m, 0, ix_mv_order(m, 0) + 2, &up));
        ASSERT_OK(w->ctx, ix_mv_insert_knots(w->ctx, up, 0, 3, knots, &fine));
        ASSERT_OK(w->ctx, ix_sym_reduce(w->ctx, fine, 0, &rep, &back));
        assert_int_equal(degrees_of(back), degrees_of(m));
        assert_int_equal(ix_mv_npts(back), ix_mv_npts(m));
        assert_int_equal(rep.degrees, 2);
        assert_true(rep.change <= 1e-12);
        same_map(w->ctx, &r, m, back, 1e-11);
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, up);
        ix_mv_unref(w->ctx, fine);
        ix_mv_unref(w->ctx, back);
    }
}

/* What is already lowest is returned itself; a constant rational curve
 * becomes a point of order 1; bad tolerances are refused. */
static void extremes(void **state)
{
    sym_world *w = *state;
    double pts[] = {1, 2, 5, 3, 3, 6, 15, 9, -2, -4, -10, -6};
    double other[] = {1, 2, 5, 3, 3, 1, 15, 9, -2, -4, -1, -6};
    ix_dir d = {IX_BEZIER, 4, 4, false, NULL};
    ix_reduce_report rep;
    ix_mv *m, *out;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 2, true, other, &m));
    ASSERT_OK(w->ctx, ix_sym_reduce(w->ctx, m, 0, &rep, &out));
    assert_ptr_equal(m, out);
    assert_true(rep.degrees == 0 && rep.factors == 0 && rep.change == 0);
    ix_mv_unref(w->ctx, out);
    assert_int_equal(ix_sym_reduce(w->ctx, m, -1, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_reduce(w->ctx, m, (double)NAN, NULL, &out),
                     IX_EARG);
    assert_null(out);
    ix_mv_unref(w->ctx, m);
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 2, true, pts, &m));
    ASSERT_OK(w->ctx, ix_sym_reduce(w->ctx, m, 0, &rep, &out));
    assert_int_equal(ix_mv_order(out, 0), 1);
    assert_int_equal(rep.factors, 3);
    ASSERT_CLOSE(ix_mv_coord(out, 0)[0] / ix_mv_weights(out)[0], 3, 1e-14);
    ASSERT_CLOSE(ix_mv_coord(out, 1)[0] / ix_mv_weights(out)[0], -2, 1e-14);
    ix_mv_unref(w->ctx, out);
    ix_mv_unref(w->ctx, m);
}

/* The bisector of a circle and its axis has degree (2, 2). */
static void circle_and_axis(void **state)
{
    sym_world *w = *state;
    double q[] = {1, 1, 2, 1, 1, 0, 0, 1, 2, 0, 0, 0}; /* a quarter */
    double axis[] = {0, 0, 0, 0, -1, 1};
    ix_dir d = {IX_BEZIER, 3, 3, false, NULL},
           e = {IX_BEZIER, 2, 2, false, NULL};
    ix_mv *c, *l, *s, *out;
    ix_reduce_report rep;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 3, true, q, &c));
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &e, 3, false, axis, &l));
    ASSERT_OK(w->ctx, ix_cbisector3d(w->ctx, c, l, NULL, NULL, &s));
    ASSERT_OK(w->ctx, ix_sym_reduce(w->ctx, s, 0, &rep, &out));
    assert_int_equal(ix_mv_order(s, 0), 7);
    assert_int_equal(ix_mv_order(out, 0), 3);
    assert_int_equal(ix_mv_order(out, 1), 3);
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, l);
    ix_mv_unref(w->ctx, s);
    ix_mv_unref(w->ctx, out);
}

typedef struct {
    ix_mv *m, *out;
} operand;

static void make(ix_ctx *ctx, void *state)
{
    operand *o = state;
    double kv[] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    double pts[21];
    ix_dir d = {IX_BSPLINE, 4, 7, false, kv};

    for (int i = 0; i < 21; i++)
        pts[i] = (i % 7 + 1) * (1 + i / 7);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, true, pts, &o->m));
    o->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    operand *o = state;
    ix_status st = ix_sym_reduce(ctx, o->m, 0, NULL, &o->out);

    assert_true((st == IX_OK) == (o->out != NULL));
    return st;
}

static void release(ix_ctx *ctx, void *state)
{
    operand *o = state;

    ix_mv_unref(ctx, o->m);
    ix_mv_unref(ctx, o->out);
}

static void memory_may_fail(void **state)
{
    operand o;
    ix_fault_case c = {make, run, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, world_open, world_close)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(factors_are_found),
        TEST(raised_and_refined_comes_back),
        TEST(extremes),
        TEST(circle_and_axis),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
