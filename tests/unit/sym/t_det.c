/* Determinants and minors against elimination on values. */
#include "sym_test.h"

enum { MOST = 6 };

/* By elimination with pivots. */
static double det(int n, double a[MOST][MOST])
{
    double d = 1;

    for (int k = 0; k < n; k++) {
        int p = k;

        for (int i = k; i < n; i++)
            p = fabs(a[i][k]) > fabs(a[p][k]) ? i : p;
        d *= p == k ? a[p][k] : -a[p][k];
        for (int j = 0; j < n; j++) {
            double t = a[p][j];

            a[p][j] = a[k][j];
            a[k][j] = t;
        }
        for (int i = k + 1; i < n; i++)
            for (int j = n - 1; j >= k; j--)
                a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    }
    return d;
}

static void make_rows(ix_ctx *ctx, ix_rng *r, int n, int cols, int ndirs,
                      ix_mv **rows)
{
    ix_rand_opts s = {.ndirs = ndirs,
                      .ncoords = cols,
                      .rational = -1,
                      .max_order = 3,
                      .max_knots = 2,
                      .unit = true};

    for (int i = 0; i < n; i++)
        rows[i] = ix_mv_randtest(ctx, r, &s);
}

/* Law: the value of the determinant is the determinant of values, the order
 * is that of the product of all rows. Tolerance: sums of 720 products. */
static void determinants(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(71);

    for (int round = 0; round < 30; round++) {
        int n = 1 + round % MOST, total = 1;
        ix_mv *rows[MOST], *d;
        double t[2], a[MOST][MOST], got;

        make_rows(w->ctx, &r, n, n, 1 + round % 2, rows);
        ASSERT_OK(w->ctx,
                  ix_sym_det(w->ctx, n, (const ix_mv *const *)rows, NULL, &d));
        rand_param(&r, d, t);
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, d, t, &got));
        for (int i = 0; i < n; i++) {
            ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, rows[i], t, a[i]));
            total += ix_mv_order(rows[i], 0) - 1;
            ix_mv_unref(w->ctx, rows[i]);
        }
        ASSERT_CLOSE(got, det(n, a), 1e-12);
        assert_int_equal(ix_mv_order(d, 0), total);
        ix_mv_unref(w->ctx, d);
    }
}

/* Law: the minors are orthogonal to every row, and the determinant with one
 * more row is its scalar product with them. */
static void minors(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(72);

    for (int round = 0; round < 30; round++) {
        int n = 1 + round % (MOST - 1);
        ix_mv *rows[MOST], *m;
        double t[2], v[MOST], a[MOST][MOST], dot = 0;

        make_rows(w->ctx, &r, n, n + 1, 1 + round % 2, rows);
        ASSERT_OK(w->ctx, ix_sym_minors(w->ctx, n, (const ix_mv *const *)rows,
                                        NULL, &m));
        assert_int_equal(ix_mv_ncoords(m), n + 1);
        rand_param(&r, m, t);
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, m, t, v));
        for (int i = 0; i < n; i++) {
            double s = 0;

            ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, rows[i], t, a[i + 1]));
            for (int j = 0; j <= n; j++)
                s += v[j] * a[i + 1][j];
            ASSERT_CLOSE(s, 0, 1e-12);
            ix_mv_unref(w->ctx, rows[i]);
        }
        for (int j = 0; j <= n; j++) {
            a[0][j] = ix_rng_range(&r, -1, 1);
            dot += a[0][j] * v[j];
        }
        ASSERT_CLOSE(dot, det(n + 1, a), 1e-12);
        ix_mv_unref(w->ctx, m);
    }
}

static void errors_are_told(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(73);
    ix_rand_opts s = {.ndirs = 1, .ncoords = 2, .rational = 1, .unit = true};
    ix_mv *q = ix_mv_randtest(w->ctx, &r, &s), *rows[2], *out;
    const ix_mv *bad[2];

    make_rows(w->ctx, &r, 2, 2, 1, rows);
    bad[0] = rows[0];
    bad[1] = q;
    assert_int_equal(ix_sym_det(w->ctx, 2, bad, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_det(w->ctx, 1, bad, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_det(w->ctx, 0, bad, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_minors(w->ctx, 2, bad, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_minors(w->ctx, IX_MAX_COORDS, bad, NULL, &out),
                     IX_EARG);
    assert_null(out);
    ix_mv_unref(w->ctx, q);
    ix_mv_unref(w->ctx, rows[0]);
    ix_mv_unref(w->ctx, rows[1]);
}

typedef struct {
    ix_mv *rows[3], *out;
    bool minors;
} operands;

static void make(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_rng r = ix_rng_new(74);

    make_rows(ctx, &r, 3, 3 + o->minors, 2, o->rows);
    o->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_status st = o->minors
                       ? ix_sym_minors(ctx, 3, (const ix_mv *const *)o->rows,
                                       NULL, &o->out)
                       : ix_sym_det(ctx, 3, (const ix_mv *const *)o->rows, NULL,
                                    &o->out);

    assert_true((st == IX_OK) == (o->out != NULL));
    return st;
}

static void release(ix_ctx *ctx, void *state)
{
    operands *o = state;

    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, o->rows[i]);
    ix_mv_unref(ctx, o->out);
}

static void memory_may_fail(void **state)
{
    operands o = {.minors = false};
    ix_fault_case c = {make, run, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
    o.minors = true;
    assert_true(ix_fault_run(&c) > 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, world_open, world_close)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(determinants),
        TEST(minors),
        TEST(errors_are_told),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
