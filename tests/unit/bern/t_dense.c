/* Small dense matrices: factors multiply back, least squares are orthogonal,
 * singular vectors are what they claim. */
#include <string.h>

#include "bern/dense.h"
#include "harness/test.h"

enum { M = 9, N = 6 };

static void random_matrix(ix_rng *r, double *a)
{
    for (int i = 0; i < M * N; i++)
        a[i] = ix_rng_range(r, -1, 1);
}

/* y = A x. */
static void apply(const double *a, const double *x, double *y)
{
    for (int i = 0; i < M; i++) {
        y[i] = 0;
        for (int j = 0; j < N; j++)
            y[i] += a[j * M + i] * x[j];
    }
}

/* Law: the residual of the least squares solution is orthogonal to all
 * columns. Tolerance: random matrices, condition about 10. */
static void least_squares(void **state)
{
    ix_rng r = ix_rng_new(95);
    double a[M * N], qr[M * N], tau[N], b[M], x[M], y[M];

    (void)state;
    for (int round = 0; round < 20; round++) {
        random_matrix(&r, a);
        memcpy(qr, a, sizeof a);
        for (int i = 0; i < M; i++)
            x[i] = b[i] = ix_rng_range(&r, -1, 1);
        ix__dense_qr(M, N, qr, tau);
        ix__dense_apply(M, N, qr, tau, x);
        assert_true(ix__dense_solve(M, N, qr, x));
        apply(a, x, y);
        for (int j = 0; j < N; j++) {
            double s = 0;

            for (int i = 0; i < M; i++)
                s += a[j * M + i] * (b[i] - y[i]);
            ASSERT_CLOSE(s, 0, 1e-13);
        }
    }
}

/* Law: A v_k = s_k u_k with orthonormal v, orthogonal u, s decreasing; the
 * smallest one agrees with inverse iteration; a vanishing column is seen. */
static void singular_values(void **state)
{
    ix_rng r = ix_rng_new(96);
    double a[M * N], u[M * N], s[N], v[N * N], y[M], tau[N];

    (void)state;
    for (int round = 0; round < 20; round++) {
        random_matrix(&r, a);
        memcpy(u, a, sizeof a);
        ix__dense_singular(M, N, u, s, v);
        for (int k = 0; k < N; k++) {
            apply(a, v + k * N, y);
            for (int i = 0; i < M; i++)
                ASSERT_CLOSE(y[i], u[k * M + i], 1e-13);
            assert_true(k == 0 || s[k] <= s[k - 1]);
            for (int l = 0; l <= k; l++) {
                double p = 0, q = 0;

                for (int i = 0; i < N; i++)
                    p += v[k * N + i] * v[l * N + i];
                for (int i = 0; i < M; i++)
                    q += u[k * M + i] * u[l * M + i];
                ASSERT_CLOSE(p, k == l, 1e-13);
                ASSERT_CLOSE(q, k == l ? s[k] * s[k] : 0, 1e-13);
            }
        }
        ix__dense_qr(M, N, a, tau);
        assert_true(fabs(ix__dense_smallest(M, N, a, y) / s[N - 1] - 1) < 0.2);
    }
    memset(a, 0, M * sizeof *a);
    memcpy(u, a, sizeof a);
    ix__dense_qr(M, N, a, tau);
    assert_true(ix__dense_smallest(M, N, a, y) < 1e-15);
    ix__dense_singular(M, N, u, s, v);
    assert_true(s[N - 1] < 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(least_squares),
        cmocka_unit_test(singular_values),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
