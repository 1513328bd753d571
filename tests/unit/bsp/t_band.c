/* Banded least squares against the definition: the residual is orthogonal to
 * every column, and planted solutions come back. */
#include "bsp/band.h"

#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"

typedef struct {
    int rows, n, width;
    bool periodic;
    double *a; /* [rows][n] dense copy */
    double *y; /* [rows][2] */
    ix_band band;
} problem;

/* Random rows that cover all unknowns, in the order of their first one. */
static void fill(ix_ctx *ctx, ix_rng *r, problem *p)
{
    double coef[16];

    p->a = ix__scratch_zero(ctx, (size_t)(p->rows * p->n), sizeof *p->a);
    p->y = ix__scratch(ctx, (size_t)p->rows * 2, sizeof *p->y);
    ASSERT_OK(ctx, ix__band_new(ctx, p->n, p->width, p->periodic, 2, &p->band));
    for (int i = 0; i < p->rows; i++) {
        int last = p->periodic ? p->n - 1 : p->n - p->width;
        int first = (int)((double)i / p->rows * (last + 1));

        for (int k = 0; k < p->width; k++) {
            coef[k] = ix_rng_range(r, -1, 1) + (k == i % p->width ? 3 : 0);
            p->a[i * p->n + (first + k) % p->n] += coef[k];
        }
        for (int k = 0; k < 2; k++)
            p->y[2 * i + k] = ix_rng_range(r, -1, 1);
        ix__band_add(&p->band, first, p->width, coef, p->y + 2 * i);
    }
}

static problem draw(ix_rng *r)
{
    problem p = {.width = ix_rng_int(r, 1, 6)};

    p.n = p.width + ix_rng_int(r, 0, 20);
    p.rows = p.n * ix_rng_int(r, 2, 4);
    p.periodic = ix_rng_int(r, 0, 1);
    if (p.periodic && ix_rng_int(r, 0, 3) == 0)
        p.n = 1 + ix_rng_int(r, 0, p.width); /* rows that wrap twice */
    return p;
}

/* Law: A^T (y - A x) = 0, and |y - A x|^2 is what `rest` says. */
static void residual_is_orthogonal(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(11);

    (void)state;
    for (int trial = 0; trial < 200; trial++) {
        ix_mark mk = ix__scratch_mark(ctx);
        problem p = draw(&r);
        double *x, *res;

        fill(ctx, &r, &p);
        x = ix__scratch(ctx, (size_t)p.n * 2, sizeof *x);
        res = ix__scratch(ctx, (size_t)p.rows, sizeof *res);
        ASSERT_OK(ctx, ix__band_solve(ctx, &p.band, x));
        for (int k = 0; k < 2; k++) {
            double sum = 0;

            for (int i = 0; i < p.rows; i++) {
                res[i] = p.y[2 * i + k];
                for (int j = 0; j < p.n; j++)
                    res[i] -= p.a[i * p.n + j] * x[k * p.n + j];
                sum += res[i] * res[i];
            }
            ASSERT_CLOSE(sum, p.band.rest[k], 1e-12);
            for (int j = 0; j < p.n; j++) {
                double dot = 0;

                for (int i = 0; i < p.rows; i++)
                    dot += p.a[i * p.n + j] * res[i];
                /* rows * eps * entries up to 4 * condition below 1e3 */
                ASSERT_CLOSE(dot, 0, 1e-11);
            }
        }
        ix__scratch_release(ctx, mk);
    }
    ix_ctx_free(ctx);
}

/* Law: the order in which rows come does not matter. */
static void any_order_of_rows(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double fwd[5], back[5], rhs;
    ix_band f, b;

    (void)state;
    ASSERT_OK(ctx, ix__band_new(ctx, 5, 2, false, 1, &f));
    ASSERT_OK(ctx, ix__band_new(ctx, 5, 2, false, 1, &b));
    for (int i = 0; i < 8; i++) {
        double c[2] = {2 + 0.1 * i, 1}, d[2];
        int other = 7 - i;

        rhs = i * i;
        ix__band_add(&f, i / 2, 2, c, &rhs);
        d[0] = 2 + 0.1 * other;
        d[1] = 1;
        rhs = other * other;
        ix__band_add(&b, other / 2, 2, d, &rhs);
    }
    ASSERT_OK(ctx, ix__band_solve(ctx, &f, fwd));
    ASSERT_OK(ctx, ix__band_solve(ctx, &b, back));
    for (int i = 0; i < 5; i++)
        ASSERT_CLOSE(fwd[i], back[i], 1e-11);
    ix_ctx_free(ctx);
}

static void singular_is_refused(void **state)
{
    const double coef[3] = {1, 2, 1}, rhs = 1;
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double x[4];
    ix_band b;

    (void)state;
    ASSERT_OK(ctx, ix__band_new(ctx, 4, 3, false, 1, &b));
    ix__band_add(&b, 0, 3, coef, &rhs);
    ix__band_add(&b, 1, 3, coef, &rhs);
    ix__band_add(&b, 1, 3, coef, &rhs);
    ix__band_add(&b, 1, 3, coef, &rhs);
    assert_int_equal(ix__band_solve(ctx, &b, x), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "singular"));
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(residual_is_orthogonal),
        cmocka_unit_test(any_order_of_rows),
        cmocka_unit_test(singular_is_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
