/* t_cone_envelope.c - envelopes of cones, isoparametric curves, level surfaces:
 * errors and memory; the laws are in tests/script. */
#include "geom/cone_envelope.h"

#include "geom/iso_curvature.h"
#include "geom/iso_curves.h"
#include "geomtest.h"

static void test_errors(void **state)
{
    const double at[3] = {0.5, 0.5, 0.5};
    gt t = gt_begin(1);
    ix_mv *s = gt_random(&t, 2, 3, 0, IX_RAND_BEZIER, 3);
    ix_mv *c = gt_random(&t, 1, 2, 0, IX_RAND_BEZIER, 3), *out, *right;
    ix__level_point p;
    double *u;
    int n;

    (void)state;
    assert_int_equal(ix__cone_envelope(t.ctx, s, 1, 0.1, &out, &right),
                     IX_EARG);
    assert_int_equal(ix__cone_envelope(t.ctx, c, -1, 0.1, &out, &right),
                     IX_EARG);
    assert_int_equal(ix__cone_envelope(t.ctx, c, 1, 0, &out, &right), IX_EARG);
    assert_null(out);
    assert_null(right);
    assert_int_equal(ix__iso_params(t.ctx, c, 0, 1, &n, &u), IX_EARG);
    assert_int_equal(ix__iso_params(t.ctx, s, 0, NAN, &n, &u), IX_EARG);
    assert_int_equal(ix__iso_params(t.ctx, s, 0, 1e-9, &n, &u), IX_EUNABLE);
    assert_int_equal(ix__level_curvature(t.ctx, s, at, &p), IX_EARG);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double line[4] = {0, 4, 0, 1},
                 square[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0};
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 2, false, line, &f->in[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, square, &f->in[1]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_mv *right;
    double *t;
    int n;

    IX_TRY(ix__iso_params(ctx, f->in[1], 0, 0.6, &n, &t));
    return ix__cone_envelope(ctx, f->in[0], 1, 0.1, out, &right);
}

static void test_memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
