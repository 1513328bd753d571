/* t_similar.c - similarity of freeforms in the XY plane. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* Law: a turned, scaled, moved copy is found with its map; any other change
 * is not. */
static void test_similar(void **state)
{
    gt t = gt_begin(123);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *a = gt_random(&t, 1 + k % 2, 2 + k % 2, 0,
                             IX_RAND_BEZIER | IX_RAND_OPEN, 2);
        double s = ix_rng_range(&t.r, 0.2, 3), w = ix_rng_range(&t.r, -3, 3);
        double d[2] = {ix_rng_range(&t.r, -2, 2), ix_rng_range(&t.r, -2, 2)};
        const double mat[16] = {
            s * cos(w), s * sin(w), 0, 0, -s * sin(w), s * cos(w), 0, 0,
            0,          0,          1, 0, d[0],        d[1],       0, 1};
        const double skew[16] = {1, 0, 0, 0, 0.5, 1, 0, 0,
                                 0, 0, 1, 0, 0,   0, 0, 1};
        ix_mv *b = NULL, *c = NULL;
        ix_similarity m;
        bool found;

        ASSERT_OK(t.ctx, ix_mv_transform(t.ctx, a, mat, &b));
        ASSERT_OK(t.ctx, ix_similar(t.ctx, a, b, 1e-9, &found, &m));
        assert_true(found);
        gt_same(m.shift, d, 2, 1e-10);
        ASSERT_CLOSE(m.scale, s, 1e-10);
        ASSERT_CLOSE(m.degrees, w * 180 / 3.14159265358979323846, 1e-8);
        ASSERT_OK(t.ctx, ix_mv_transform(t.ctx, a, skew, &c));
        ASSERT_OK(t.ctx, ix_similar(t.ctx, a, c, 1e-9, &found, &m));
        assert_true(!found || ix_mv_npts(a) == 2);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
        ix_mv_unref(t.ctx, c);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(124);
    ix_mv *p = gt_curve(&t, 2, 2, NULL, 1, false, (double[2]){5, 5});
    ix_mv *z = gt_curve(&t, 2, 2, NULL, 2, true, (double[6]){0, 1, 1, 2, 3, 4});
    ix_mv *one = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){1, 1, 2, 2});
    ix_similarity s;
    bool found;

    (void)state;
    assert_int_equal(ix_similar(t.ctx, p, p, 1e-9, &found, &s), IX_EARG);
    assert_int_equal(ix_similar(t.ctx, z, z, 1e-9, &found, &s), IX_EDOMAIN);
    ASSERT_OK(t.ctx, ix_similar(t.ctx, one, one, 1e-9, &found, &s));
    assert_false(found);
    ix_mv_unref(t.ctx, p);
    ix_mv_unref(t.ctx, z);
    ix_mv_unref(t.ctx, one);
    gt_end(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_similar),
                                       cmocka_unit_test(test_errors)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
