/* Standard knot vectors, nodes, spans of a direction. */
#include <math.h>
#include <string.h>

#include "bsp/knots.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(8)

/* spec/model 3.3 in its own words: first knot, step, domain [0, 1]. */
static void standard_vectors(void **state)
{
    static const struct {
        ix_kv_kind kind;
        int order, length, n;
        double knots[12];
    } want[] = {
        {IX_KV_OPEN, 3, 5, 8, {0, 0, 0, 1 / 3.0, 2 / 3.0, 1, 1, 1}},
        {IX_KV_OPEN, 1, 2, 3, {0, 0.5, 1}},
        {IX_KV_FLOAT, 3, 4, 7, {-1, -0.5, 0, 0.5, 1, 1.5, 2}},
        {IX_KV_PERIODIC,
         3,
         4,
         9,
         {-0.5, -0.25, 0, 0.25, 0.5, 0.75, 1, 1.25, 1.5}},
        {IX_KV_DISC_OPEN,
         3,
         7,
         10,
         {0, 0, 0, 1 / 3.0, 1 / 3.0, 2 / 3.0, 2 / 3.0, 1, 1, 1}},
    };

    (void)state;
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        double k[12];
        ix_dir dir = {IX_BSPLINE, want[i].order, want[i].length,
                      want[i].kind == IX_KV_PERIODIC, k};

        assert_int_equal(ix_knots_count(&dir), want[i].n);
        ASSERT_OK(ctx, ix_knots_make(ctx, want[i].kind, want[i].order,
                                     want[i].length, k));
        for (int j = 0; j < want[i].n; j++)
            assert_true(k[j] == want[i].knots[j]);
    }
}

static void errors(void **state)
{
    double k[8];

    (void)state;
    assert_int_equal(ix_knots_make(ctx, IX_KV_OPEN, 0, 3, k), IX_EARG);
    assert_int_equal(ix_knots_make(ctx, IX_KV_OPEN, 4, 3, k), IX_EARG);
    assert_int_equal(ix_knots_make(ctx, IX_KV_PERIODIC, 4, 0, k), IX_EARG);
    assert_int_equal(ix_knots_make(ctx, IX_KV_DISC_OPEN, 3, 4, k), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "order - 1 = 2"));
    assert_int_equal(ix_knots_make(ctx, (ix_kv_kind)9, 2, 2, k), IX_EARG);
}

/* Law: with control values equal to the nodes of its clamped knots a spline is
 * the identity. */
static void nodes_are_the_identity(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 1,
                      .rational = -1,
                      .min_order = 2,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_JUMPS};

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *id;
        ix_dir dir = ix_mv_dir(m, 0);
        double nodes[64], t, v;

        ix_knots_nodes(&dir, nodes);
        ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, nodes, &id));
        ix_mv_randparam(&rng, id, &t);
        ASSERT_OK(ctx, ix_mv_eval(ctx, id, &t, &v));
        ASSERT_CLOSE(v, t, 1e-14);
        ix_mv_unref(ctx, id);
        ix_mv_unref(ctx, m);
    }
}

/* Law: the span holds its parameter and is not empty. */
static void spans_hold_parameters(void **state)
{
    ix_rand_opts o = {.ndirs = 1, .max_knots = 20, .kinds = IX_RAND_BSPLINES};

    (void)state;
    for (int k = 0; k < 200; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        ix_dir dir = ix_mv_dir(m, 0);
        double t, dom[2];
        int mu;

        ix_mv_randparam(&rng, m, &t);
        ix_mv_domain(m, 0, dom);
        mu = ix__dir_span(&dir, t);
        assert_true(dir.knots[mu] < dir.knots[mu + 1]);
        assert_true(dir.knots[mu] <= t);
        assert_true(t < dir.knots[mu + 1] || t == dom[1]);
        assert_true(mu >= dir.order - 1 && mu < ix__dir_npoints(&dir));
        ix_mv_unref(ctx, m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(standard_vectors),
        cmocka_unit_test(errors),
        cmocka_unit_test(nodes_are_the_identity),
        cmocka_unit_test(spans_hold_parameters),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
