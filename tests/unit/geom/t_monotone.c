/* t_monotone.c - the best way through a table of pairs against all ways. */
#include <string.h>

#include "geom/monotone.h"
#include "harness/test.h"

enum { N = 5 };

static double value(const void *arg, int i, int j)
{
    return ((const double *)arg)[i * N + j];
}

/* The best sum from (i, j) on, all ways tried. */
static double all_ways(const double *v, int slack, int i, int j)
{
    bool end = i >= N - 1 - slack && j >= N - 1 - slack;
    double best = end ? 0 : -HUGE_VAL;

    for (int s = 1; s < 4; s++) {
        int a = i + (s & 1), b = j + (s >> 1);

        if (a < N && b < N)
            best = fmax(best,
                        (v[i * N + j] + v[a * N + b]) / 2 * (s == 3 ? 1 : 0.5) +
                            all_ways(v, slack, a, b));
    }
    return best;
}

/* Law: the sum is the best of all ways; the way found has this sum, neither
 * index falls, and it begins and ends where it may. */
static void best_of_all(void **state)
{
    ix_rng r = ix_rng_new(11);

    (void)state;
    print_message("seed %llu\n", (unsigned long long)r.s);
    for (int k = 0; k < 60; k++) {
        int slack = k % 3, i[2 * N], j[2 * N], end[2], n;
        double v[N * N], work[4 * N], best, want = -HUGE_VAL, sum = 0;
        const ix__monotone m = {value, v, N, slack};
        char from[N * N];

        for (int q = 0; q < N * N; q++)
            v[q] = ix_rng_range(&r, k % 2 ? -1 : 0, k % 2 ? 0 : 1);
        best = ix__monotone_best(&m, work, from, end);
        for (int a = 0; a <= slack; a++)
            for (int b = 0; b <= slack; b++)
                want = fmax(want, all_ways(v, slack, a, b));
        ASSERT_CLOSE(best, want, 1e-14);
        n = ix__monotone_trace(N, from, end, i, j);
        assert_true(i[0] <= slack && j[0] <= slack);
        assert_true(i[n - 1] >= N - 1 - slack && j[n - 1] >= N - 1 - slack);
        for (int q = 1; q < n; q++) {
            int di = i[q] - i[q - 1], dj = j[q] - j[q - 1];

            assert_true((di == 0 || di == 1) && (dj == 0 || dj == 1));
            sum += (v[i[q] * N + j[q]] + v[i[q - 1] * N + j[q - 1]]) / 4 *
                   (di + dj);
        }
        ASSERT_CLOSE(sum, best, 1e-14);
    }
}

/* A pair that may not be used stops every way through it. */
static void barred(void **state)
{
    const ix__monotone m = {value, (double[N * N]){-HUGE_VAL}, N, 0};
    double work[4 * N];
    int end[2];

    (void)state;
    assert_true(isinf(ix__monotone_best(&m, work, NULL, end)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(best_of_all),
        cmocka_unit_test(barred),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
