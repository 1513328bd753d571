/* Point types, single axes, single points, matrices, boxes, equality. */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(41)

/* spec/model 4: 2 x 2 points P2 to E2, E1 and P3. */
static void coerced(void **state)
{
    const ix_dir dirs[2] = {{IX_BEZIER, 2, 2, false, NULL},
                            {IX_BEZIER, 2, 2, false, NULL}};
    const double p2[] = {1, 2, 0, 0.5, 0, 1, 2, 3, 1, 0, 2, 1};
    const double e2[] = {0, 0.5, 2e14, 6, 1, 0, 2e14, 2};
    ix_mv *m, *a, *b;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 2, true, p2, &m));
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 2, false, &a));
    for (int i = 0; i < 8; i++)
        ASSERT_CLOSE(ix_mv_axis(a, 0)[i], e2[i], 1e-15);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 3, true, &b));
    assert_memory_equal(ix_mv_axis(b, 0), p2, sizeof p2);
    for (int i = 0; i < 4; i++)
        assert_true(ix_mv_coord(b, 2)[i] == 0);
    ix_mv_unref(ctx, b);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, a, 1, true, &b));
    for (int i = 0; i < 4; i++)
        assert_true(ix_mv_weights(b)[i] == 1 &&
                    ix_mv_coord(b, 0)[i] == ix_mv_coord(a, 0)[i]);
    ix_mv_unref(ctx, b);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 2, true, &b));
    assert_ptr_equal(b, m);
    ix_mv_unref(ctx, b);
    assert_int_equal(ix_mv_coerce(ctx, m, 0, true, &b), IX_EARG);
    assert_int_equal(ix_mv_coerce(ctx, m, 19, true, &b), IX_EARG);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, m);
}

/* Law: the axes of a multivariate, joined, are it. */
static void scalars_join(void **state)
{
    ix_rand_opts poly = {.ncoords = 2, .rational = -1};

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_rand_opts o = {.kinds = k % 2 ? IX_RAND_BSPLINES : IX_RAND_BEZIER};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;
        const ix_mv *axis[19];
        int n = ix_mv_naxes(m);

        for (int a = 0; a < n; a++) {
            ix_mv *s;

            ASSERT_OK(ctx, ix_mv_scalar(ctx, m, a, &s));
            axis[a] = s;
        }
        ASSERT_OK(ctx, ix_mv_join_scalars(ctx, n, axis, ix_mv_rational(m), &r));
        assert_true(ix_mv_equal(m, r, 0));
        ix_mv_unref(ctx, r);
        assert_int_equal(ix_mv_scalar(ctx, m, n, &r), IX_EARG);
        for (int a = 0; a < n; a++)
            ix_mv_unref(ctx, axis[a]);
        ix_mv_unref(ctx, m);
    }
    {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &poly), *r;
        const ix_mv *two[] = {m, m};

        assert_int_equal(ix_mv_join_scalars(ctx, 2, two, true, &r), IX_EARG);
        assert_int_equal(ix_mv_join_scalars(ctx, 1, two, true, &r), IX_EARG);
        ix_mv_unref(ctx, m);
    }
}

static void point_replaced(void **state)
{
    ix_rand_opts o = {.ncoords = 2, .rational = 1};
    const double p[] = {2, 3, 4}, bad[] = {1, (double)NAN, 1};
    ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;
    size_t n = ix_mv_npts(m);

    (void)state;
    ASSERT_OK(ctx, ix_mv_set_point(ctx, m, n - 1, p, &r));
    for (int a = 0; a < 3; a++) {
        assert_true(ix_mv_axis(r, a)[n - 1] == p[a]);
        assert_memory_equal(ix_mv_axis(r, a), ix_mv_axis(m, a),
                            (n - 1) * sizeof(double));
    }
    ix_mv_unref(ctx, r);
    assert_int_equal(ix_mv_set_point(ctx, m, n, p, &r), IX_EARG);
    assert_int_equal(ix_mv_set_point(ctx, m, 0, bad, &r), IX_EARG);
    ix_mv_unref(ctx, m);
}

/* Law: transforming the object transforms its points, also in perspective. */
static void transformed(void **state)
{
    (void)state;
    for (int k = 0; k < 80; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *r;
        int nc = ix_mv_ncoords(m), k3 = nc < 3 ? nc : 3;
        double mat[16], t[8], v[19], w[19], x[4] = {0, 0, 0, 1}, y[4] = {0};

        for (int i = 0; i < 16; i++)
            mat[i] = ix_rng_range(&rng, -1, 1);
        mat[3] *= 0.1 * (k % 2);
        mat[7] *= 0.1 * (k % 2);
        mat[11] *= 0.1 * (k % 2);
        mat[15] = 2;
        ASSERT_OK(ctx, ix_mv_transform(ctx, m, mat, &r));
        assert_true(ix_mv_rational(r) || (k % 2 == 0 && !ix_mv_rational(m)));
        ix_mv_randparam(&rng, m, t);
        ASSERT_OK(ctx, ix_mv_point(ctx, m, t, v));
        ASSERT_OK(ctx, ix_mv_point(ctx, r, t, w));
        memcpy(x, v, (size_t)k3 * sizeof *x);
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++)
                y[j] += x[i] * mat[4 * i + j];
        for (int c = 0; c < k3; c++)
            ASSERT_CLOSE(w[c], y[c] / y[3], 1e-13);
        ix_mv_unref(ctx, r);
        ix_mv_unref(ctx, m);
    }
}

static void boxes(void **state)
{
    const ix_dir dir = {IX_BEZIER, 2, 2, false, NULL};
    const double signs[] = {1, -1, 1, 1}, zero[] = {1, 0, 1, 1};
    const double neg[] = {-1, -2, 2, 6, 1, 1};
    double lo[18], hi[18];
    ix_mv *m;

    (void)state;
    for (int k = 0; k < 40; k++) {
        double t[8], v[18];

        m = ix_mv_randtest(ctx, &rng, NULL);
        assert_false(ix_mv_has_poles(m));
        ASSERT_OK(ctx, ix_mv_bbox(ctx, m, lo, hi));
        ix_mv_randparam(&rng, m, t);
        ASSERT_OK(ctx, ix_mv_point(ctx, m, t, v));
        for (int c = 0; c < ix_mv_ncoords(m); c++)
            assert_true(lo[c] - 1e-14 <= v[c] && v[c] <= hi[c] + 1e-14);
        ix_mv_unref(ctx, m);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, signs, &m));
    assert_true(ix_mv_has_poles(m));
    assert_int_equal(ix_mv_bbox(ctx, m, lo, hi), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, zero, &m));
    assert_true(ix_mv_has_poles(m));
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, true, neg, &m));
    assert_false(ix_mv_has_poles(m));
    ASSERT_OK(ctx, ix_mv_bbox(ctx, m, lo, hi));
    assert_true(lo[0] == -3 && hi[0] == -2 && lo[1] == -1 && hi[1] == -0.5);
    ix_mv_unref(ctx, m);
}

static void equality(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 2,
                      .rational = -1,
                      .kinds = IX_RAND_OPEN,
                      .min_order = 2};
    ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r;
    double p[2];

    (void)state;
    assert_true(ix_mv_equal(m, m, 0));
    p[0] = ix_mv_axis(m, 0)[0] + 1e-6;
    p[1] = ix_mv_axis(m, 1)[0];
    ASSERT_OK(ctx, ix_mv_set_point(ctx, m, 0, p, &r));
    assert_true(ix_mv_equal(m, r, 2e-6));
    assert_false(ix_mv_equal(m, r, 5e-7));
    ix_mv_unref(ctx, r);
    ASSERT_OK(ctx, ix_mv_coerce(ctx, m, 2, true, &r));
    assert_false(ix_mv_equal(m, r, 1e9));
    ix_mv_unref(ctx, r);
    ASSERT_OK(ctx, ix_mv_reparam(ctx, m, 0, 100, 200, &r));
    assert_false(ix_mv_equal(m, r, 1));
    ix_mv_unref(ctx, r);
    ix_mv_unref(ctx, m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coerced),        cmocka_unit_test(scalars_join),
        cmocka_unit_test(point_replaced), cmocka_unit_test(transformed),
        cmocka_unit_test(boxes),          cmocka_unit_test(equality),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
