/* t_chain_segments.c - segments of rings and open lines, shuffled and turned,
 * come back as these lines. */
#include <string.h>

#include "geom/chain_segments.h"
#include "harness/fault.h"
#include "harness/test.h"

enum { N = 40 }; /* 20 of a ring, 10 each of two lines that meet a third */

static void point(int line, int i, double p[3])
{
    double a = 2 * 3.14159265358979 * (i % 20) / 20;

    p[0] = line ? i : cos(a);
    p[1] = line ? 10.0 * line : sin(a);
    p[2] = line ? 0 : 5;
}

static void segments(ix_rng *r, double (*seg)[2][3])
{
    for (int s = 0; s < N; s++) {
        int line = s < 20 ? 0 : s < 30 ? 1 : 2, i = s < 20 ? s : s % 10;
        int turn = ix_rng_int(r, 0, 1);

        point(line, i, seg[s][turn]);
        point(line, i + 1, seg[s][1 - turn]);
    }
    for (int s = N - 1; s > 0; s--) {
        int k = ix_rng_int(r, 0, s);
        double t[2][3];

        memcpy(t, seg[s], sizeof t);
        memcpy(seg[s], seg[k], sizeof t);
        memcpy(seg[k], t, sizeof t);
    }
}

/* Law: two open lines of 11 points and a closed one of 21, neighbours as made;
 * ends apart by rounding are one. */
static void lines_come_back(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(91);

    (void)state;
    print_message("seed %llu\n", (unsigned long long)r.s);
    for (int round = 0; round < 10; round++) {
        double seg[N][2][3];
        int at = 0, closed = 0, open = 0;
        ix_lines l;

        segments(&r, seg);
        for (int k = 0; k < 6 * N; k++)
            seg[k / 6][k / 3 % 2][k % 3] += ix_rng_range(&r, -1, 1) * 1e-14;
        ASSERT_OK(ctx,
                  ix__chain_segments(ctx, N, (const double(*)[2][3])seg, &l));
        assert_int_equal(l.n, 3);
        for (int k = 0; k < l.n; k++) {
            const double(*p)[3] = (const double(*)[3])l.pt + at;
            bool ring = p[0][2] > 1;
            double step = ring ? 2 * sin(3.14159265358979 / 20) : 1;

            assert_int_equal(l.count[k], ring ? 21 : 11);
            for (int i = 1; i < l.count[k]; i++)
                ASSERT_CLOSE(
                    hypot(p[i][0] - p[i - 1][0], p[i][1] - p[i - 1][1]), step,
                    1e-12);
            if (ring)
                ASSERT_CLOSE(p[0][0], p[20][0], 1e-12);
            else
                ASSERT_CLOSE(fabs(p[10][0] - p[0][0]), 10, 1e-12);
            closed += ring;
            open += !ring;
            at += l.count[k];
        }
        assert_int_equal(closed, 1);
        assert_int_equal(open, 2);
        ix_lines_free(ctx, &l);
    }
    ix_ctx_free(ctx);
}

/* Three segments that meet in one place stay three; none give none. */
static void forks_end_lines(void **state)
{
    static const double star[4][2][3] = {{{0, 0, 0}, {1, 0, 0}},
                                         {{0, 0, 0}, {0, 1, 0}},
                                         {{0, 0, 1}, {0, 0, 0}},
                                         {{0.5, 0, 0}, {0.5, 0, 0}}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix__chain_segments(ctx, 4, star, &l));
    assert_int_equal(l.n, 3);
    ix_lines_free(ctx, &l);
    ASSERT_OK(ctx, ix__chain_segments(ctx, 0, star, &l));
    assert_int_equal(l.n, 0);
    ix_ctx_free(ctx);
}

static void nothing(ix_ctx *ctx, void *state)
{
    (void)ctx;
    (void)state;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    static const double two[2][2][3] = {{{0, 0, 0}, {1, 0, 0}},
                                        {{1, 0, 0}, {1, 1, 0}}};
    ix_lines l;

    (void)state;
    IX_TRY(ix__chain_segments(ctx, 2, two, &l));
    assert_int_equal(l.count[0], 3);
    ix_lines_free(ctx, &l);
    return IX_OK;
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
        cmocka_unit_test(lines_come_back),
        cmocka_unit_test(forks_end_lines),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
