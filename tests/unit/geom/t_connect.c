/* t_connect.c - samples of curves, shuffled, come back in their order. */
#include <string.h>

#include "geom/connect.h"
#include "harness/fault.h"
#include "harness/test.h"

enum { N = 120, DIM = 4 };

/* Uneven samples of an ellipse (tags 0 .. N/2 - 1) and of a helix below it
 * (N/2 .. N - 1), in shuffled order: tag[i] of point i. */
static void samples(ix_rng *r, double (*p)[DIM], int *tag)
{
    for (int i = 0; i < N; i++)
        tag[i] = i;
    for (int i = N - 1; i > 0; i--) {
        int k = ix_rng_int(r, 0, i), t = tag[i];

        tag[i] = tag[k];
        tag[k] = t;
    }
    for (int i = 0; i < N; i++) {
        bool first = tag[i] < N / 2;
        double a = 2 * 3.14159265358979 *
                   (tag[i] % (N / 2) + 0.3 * sin(7.0 * tag[i])) / (N / 2);

        p[i][0] = 3 * cos(a);
        p[i][1] = 2 * sin(a);
        p[i][2] = first ? 0 : -2 - 0.2 * a;
        p[i][3] = first ? 1 : sin(a);
    }
}

/* Law: both curves are found, each in the order of its samples (cyclic and
 * closed for the ellipse), whatever the order of the points was. */
static void curves_come_back(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(51);

    (void)state;
    print_message("seed %llu\n", (unsigned long long)r.s);
    for (int round = 0; round < 10; round++) {
        double p[N][DIM];
        ix_mark mk = ix__scratch_mark(ctx);
        int tag[N], at = 0;
        ix__chains ch;

        samples(&r, p, tag);
        /* gaps are at most 1.6 / 60 turns of radius 3 */
        ASSERT_OK(ctx, ix__connect(ctx, N, DIM, p[0], 0.6, &ch));
        assert_int_equal(ch.n, 2);
        for (int k = 0; k < 2; k++) {
            bool first = tag[ch.point[at]] < N / 2;

            assert_int_equal(ch.count[k], N / 2);
            assert_int_equal(ch.closed[k], first);
            for (int i = 1; i < N / 2; i++) {
                int step = tag[ch.point[at + i]] - tag[ch.point[at + i - 1]];

                if (first)
                    step %= N / 2 - 2; /* N/2 - 1 around the seam is 1 back */
                assert_true(step == 1 || step == -1);
            }
            assert_true(ch.point[at] < ch.point[at + N / 2 - 1]);
            at += N / 2;
        }
        ix__scratch_release(ctx, mk);
    }
    ix_ctx_free(ctx);
}

static void few_points(void **state)
{
    const double line[5] = {0, 2.5, 1, 2, 9};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix__chains ch;

    (void)state;
    ASSERT_OK(ctx, ix__connect(ctx, 0, 3, line, 1, &ch));
    assert_int_equal(ch.n, 0);
    ASSERT_OK(ctx, ix__connect(ctx, 5, 1, line, 1, &ch));
    assert_int_equal(ch.n, 2); /* 0 1 2 2.5, and 9 */
    assert_int_equal(ch.count[0], 4);
    assert_int_equal(ch.point[1], 2);
    assert_int_equal(ch.point[2], 3);
    assert_int_equal(ch.point[3], 1);
    assert_false(ch.closed[0]);
    assert_int_equal(ch.count[1], 1);
    ASSERT_OK(ctx, ix__connect(ctx, 5, 1, line, 0.4, &ch));
    assert_int_equal(ch.n, 5);
    ASSERT_OK(ctx, ix__connect(ctx, 4, 1, line, 100, &ch));
    assert_int_equal(ch.n, 1); /* the ends are too far apart to be joined */
    assert_false(ch.closed[0]);
    ix_ctx_free(ctx);
}

static void nothing(ix_ctx *ctx, void *state)
{
    (void)ctx;
    (void)state;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    const double line[4] = {0, 1, 2, 3};
    ix__chains ch;

    (void)state;
    IX_RETURN_SCOPED(ctx, ix__connect(ctx, 4, 1, line, 1, &ch));
}

static void out_of_memory(void **state)
{
    const ix_fault_case c = {nothing, run, nothing, NULL};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_come_back),
        cmocka_unit_test(few_points),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
