/* The numerical tools below curves: quadrature, eigenvalues, paths. */
#include "geom/quad.h"

#include "geom/eigen.h"
#include "geom/gauss.h"
#include "geom/path.h"
#include "harness/randmv.h"

/* Law: n nodes integrate powers up to 2 n - 1; weights add up to 1. */
static void gauss_is_exact(void **state)
{
    double x[64], w[64];

    (void)state;
    for (int n = 1; n <= 64; n++) {
        ix__gauss(n, x, w);
        for (int k = 0; k < 2 * n && k < 40; k++) {
            double s = 0;

            for (int i = 0; i < n; i++)
                s += w[i] * pow(x[i], k);
            ASSERT_CLOSE(s * (k + 1), 1, 1e-13);
        }
        for (int i = 1; i < n; i++)
            assert_true(x[i] > x[i - 1]);
    }
}

static void root(void *arg, double t, double *f)
{
    f[0] = sqrt(fabs(t - *(double *)arg));
    f[1] = t * f[0];
}

/* Law: also integrands with kinks come out to the tolerance. */
static void kinks_are_closed_in_upon(void **state)
{
    (void)state;
    for (int k = 1; k < 10; k++) {
        double at = k / 10.0, out[2], a = at, b = 1 - at;
        double want = 2.0 / 3 * (pow(a, 1.5) + pow(b, 1.5));

        ix__quad(root, &at, 2, 0, 1, 1e-12, out);
        ASSERT_CLOSE(out[0], want, 1e-11);
        want = at * want + 0.4 * (pow(b, 2.5) - pow(a, 2.5));
        ASSERT_CLOSE(out[1], want, 1e-11);
    }
}

/* Noise of 1e-9, different at every t: as from far away. */
static void noisy(void *arg, double t, double *f)
{
    (*(int *)arg)++;
    f[0] = 1 + 1e-9 * sin(1e9 * t * t);
}

/* A tolerance below the noise ends, in bounded work, within the noise. */
static void noise_ends(void **state)
{
    double out[1];
    int calls = 0;

    (void)state;
    ix__quad(noisy, &calls, 1, 0, 1, 1e-13, out);
    ASSERT_CLOSE(out[0], 1, 1e-9);
    assert_true(calls < 1000000);
}

/* Law: A v = lambda v, the vectors orthonormal, the values falling. */
static void eigenvectors(void **state)
{
    ix_rng r = ix_rng_new(121);

    (void)state;
    for (int trial = 0; trial < 100; trial++) {
        int n = ix_rng_int(&r, 1, 8);
        double a[64], b[64], val[8], vec[64];

        for (int i = 0; i < n; i++)
            for (int j = 0; j <= i; j++)
                a[i * n + j] = a[j * n + i] = b[i * n + j] = b[j * n + i] =
                    trial % 4 ? ix_rng_range(&r, -1, 1) : i == j;
        ix__eigen_symmetric(n, b, val, vec);
        for (int k = 0; k < n; k++) {
            assert_true(k == 0 || val[k] <= val[k - 1]);
            for (int i = 0; i < n; i++) {
                double s = 0, dot = 0;

                for (int j = 0; j < n; j++) {
                    s += a[i * n + j] * vec[k * n + j];
                    dot += vec[i * n + j] * vec[k * n + j];
                }
                ASSERT_CLOSE(s, val[k] * vec[k * n + i], 1e-13);
                ASSERT_CLOSE(dot, i == k, 1e-13);
            }
        }
    }
}

/* Law: a path has the curve's values and derivatives on all its spans. */
static void paths_follow_curves(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(122);
    ix_rand_opts o = {.ndirs = 1, .kinds = IX_RAND_ALL};

    (void)state;
    for (int k = 0; k < 200; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &r, &o);
        ix_mark mk = ix__scratch_mark(ctx);
        double t, want[4 * 4], got[4 * 4], scale = 1, h;
        ix_path p;
        int span;

        ASSERT_OK(ctx, ix__path_new(ctx, m, &p));
        if (ix__path_no_poles(ctx, &p) == IX_OK) {
            t = ix_rng_range(&r, p.breaks[0], p.breaks[p.nspans]);
            span = ix__path_span(&p, t);
            assert_true(p.breaks[span] <= t && t <= p.breaks[span + 1]);
            h = p.breaks[span + 1] - p.breaks[span];
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, m, t, 3, want));
            ix__path_derivs(&p, span, t, 3, got);
            for (int j = 0; j <= 3; j++) {
                for (int c = 0; c < p.ncoords; c++)
                    /* in units of the span; weights down to 0.3 */
                    ASSERT_CLOSE(got[j * p.ncoords + c] * scale,
                                 want[j * p.ncoords + c] * scale, 1e-8);
                scale *= h;
            }
        }
        ix__scratch_release(ctx, mk);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gauss_is_exact),
        cmocka_unit_test(kinks_are_closed_in_upon),
        cmocka_unit_test(noise_ends),
        cmocka_unit_test(eigenvectors),
        cmocka_unit_test(paths_follow_curves),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
