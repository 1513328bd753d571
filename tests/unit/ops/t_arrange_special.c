/* Curves of an arrangement cut at inflections and extrema: the tangents and
 * curvatures at the cuts are those. */
#include "base/ctx.h"
#include "iritx/arrange.h"
#include "iritx/ops_crv.h"
#include "unit/geom/geomtest.h"

/* Curvature and tangent at the ends of edge e, by differences of derivatives.
 */
static void at_end(gt *t, const ix_arrangement *a, int e, double d[2][2])
{
    double dom[2], v[6];

    ix_mv_domain(a->edge[e].crv, 0, dom);
    ASSERT_OK(t->ctx, ix_mv_curve_derivs(t->ctx, a->edge[e].crv, dom[1], 2, v));
    memcpy(d[0], v + 2, sizeof d[0]);
    memcpy(d[1], v + 4, sizeof d[1]);
}

static ix_arrangement *one(gt *t, const ix_mv *c)
{
    ix_arrangement *a;

    ASSERT_OK(t->ctx, ix_arrangement_new(t->ctx, 1, &c, 1e-6, &a));
    return a;
}

static void cuts_are_special(void **state)
{
    const double pts[8] = {0, 3, -2, 1, 0, 1, 1.5, 0};
    const double wave[8] = {0, 1, 2, 3, 0, 2, -2, 0};
    gt t = gt_begin(1);
    ix_mv *c = gt_curve(&t, 4, 4, NULL, 2, false, pts);
    ix_mv *w = gt_curve(&t, 4, 4, NULL, 2, false, wave);
    double d[2][2];
    ix_arrangement *a;

    (void)state;
    for (int axis = 0; axis < 2; axis++) {
        a = one(&t, c);
        ASSERT_OK(t.ctx, ix_arrangement_split_special(t.ctx, a,
                                                      axis ? IX_ARR_Y_EXTREMES
                                                           : IX_ARR_X_EXTREMES,
                                                      1e-9));
        assert_int_equal(a->nedges, axis ? 2 : 3);
        for (int e = 0; e + 1 < a->nedges; e++) {
            at_end(&t, a, e, d);
            assert_true(fabs(d[0][axis]) < 1e-12);
        }
        ix_arrangement_free(t.ctx, a);
    }
    a = one(&t, w);
    ASSERT_OK(t.ctx,
              ix_arrangement_split_special(t.ctx, a, IX_ARR_INFLECTIONS, 1e-9));
    assert_int_equal(a->nedges, 2);
    at_end(&t, a, 0, d);
    assert_true(fabs(d[0][0] * d[1][1] - d[0][1] * d[1][0]) < 1e-11);
    ASSERT_OK(t.ctx,
              ix_arrangement_split_special(t.ctx, a, IX_ARR_CURVATURE, 1e-9));
    assert_int_equal(a->nedges, 4); /* one on each arc, by symmetry */
    assert_int_equal(ix_arrangement_split_special(t.ctx, a, 16, 0), IX_EARG);
    assert_int_equal(ix_arrangement_split_special(t.ctx, a, 1, NAN), IX_EARG);
    ix_arrangement_free(t.ctx, a);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, w);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double wave[8] = {0, 1, 2, 3, 0, 2, -2, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 4, .length = 4};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, wave, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_mv *in = f->in[0];
    ix_arrangement *a;
    ix_status st;

    IX_TRY(ix_arrangement_new(ctx, 1, &in, 1e-6, &a));
    st = ix_arrangement_split_special(ctx, a, 15, 1e-9);
    if (st == IX_OK)
        *out = ix_mv_ref(a->edge[0].crv);
    ix_arrangement_free(ctx, a);
    return st;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cuts_are_special),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
