/* t_belt.c - belts, circles in triangles, registration: closedness, errors and
 * memory; the laws are in tests/script/planar. */
#include "base/ctx.h"
#include "geom/belt.h"

#include "base/ctx.h"

#include "geom/pack_triangle.h"
#include "geom/register.h"
#include "geomtest.h"

/* Law: piece after piece begins where the one before ends, in its direction. */
static void test_closed(void **state)
{
    const double p[4][3] = {{0, 0, 1}, {5, 1, -0.5}, {6, 6, 1.5}, {1, 5, -1}};
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < 3; k++) {
        ix_crvs b;

        ASSERT_OK(t.ctx, ix__belt(t.ctx, 4, p, 0.1 * (k - 1), &b));
        assert_int_equal(b.n, 8);
        for (int i = 0; i < b.n; i++) {
            const ix_mv *c = b.crv[i], *d = b.crv[(i + 1) % b.n];
            double x[IX_MAX_COORDS], y[IX_MAX_COORDS], s[3], e[3], dc[2], dd[2];

            ix_mv_domain(c, 0, dc);
            ix_mv_domain(d, 0, dd);
            gt_point(&t, c, &dc[1], x);
            gt_point(&t, d, &dd[0], y);
            gt_same(x, y, 2, 1e-12);
            ASSERT_OK(t.ctx, ix_tangent(t.ctx, c, dc[1], true, s));
            ASSERT_OK(t.ctx, ix_tangent(t.ctx, d, dd[0], true, e));
            gt_same(s, e, 2, 1e-11);
        }
        ix_crvs_free(t.ctx, &b);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    const double p[2][3] = {{0, 0, 1}, {0, 1, -1}},
                 flat[3][2] = {{0, 0}, {1, 1}, {2, 2}};
    gt t = gt_begin(2);
    double mat[16], err;
    ix_crvs b;
    ix__disc(*three)[3], (*six)[6];
    int n;

    (void)state;
    assert_int_equal(ix__belt(t.ctx, 1, p, 0, &b), IX_EARG);
    assert_int_equal(ix__belt(t.ctx, 2, p, 0, &b), IX_EDOMAIN);
    assert_int_equal(ix__belt(t.ctx, 2, p, -1, &b), IX_EARG);
    assert_int_equal(ix__pack_three(t.ctx, flat, true, &n, &three), IX_EDOMAIN);
    assert_int_equal(ix__pack_six(t.ctx, flat, &n, &six), IX_EDOMAIN);
    assert_int_equal(ix__register(t.ctx, 2, p, 2, p, NULL, 5, 0, mat, &err),
                     IX_EARG);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    (void)ctx;
    (void)f;
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double p[3][3] = {{0, 0, 1}, {5, 1, -0.5}, {2, 6, 1}};
    const double tri[3][2] = {{0, 0}, {3, 0}, {0, 2}};
    ix_mark mk = ix__scratch_mark(ctx);
    double mat[16], err;
    ix__disc(*three)[3];
    ix_status st;
    ix_crvs b;
    int n;

    (void)f;
    IX_TRY(ix__register(ctx, 3, p, 3, p, NULL, 3, 0, mat, &err));
    st = ix__pack_three(ctx, tri, true, &n, &three);
    ix__scratch_release(ctx, mk);
    IX_TRY(st);
    IX_TRY(ix__belt(ctx, 3, p, 0, &b));
    *out = ix_mv_ref(b.crv[0]);
    ix_crvs_free(ctx, &b);
    return IX_OK;
}

static void test_memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_closed),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
