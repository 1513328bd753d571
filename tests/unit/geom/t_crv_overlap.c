/* Overlaps of curves: parts of one curve are recognised in another, however
 * they are parametrised; curves that only cross are distinct. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/distance.h"
#include "iritx/geom.h"

static ix_mv *part(gt *t, const ix_mv *c, double a, double b)
{
    ix_mv *bsp, *cut, *out;

    ASSERT_OK(t->ctx, ix_mv_to_bspline(t->ctx, c, &bsp));
    ASSERT_OK(t->ctx, ix_mv_region(t->ctx, bsp, 0, a, b, &cut));
    ASSERT_OK(t->ctx, ix_mv_reparam(t->ctx, cut, 0, 2, 5, &out));
    ix_mv_unref(t->ctx, bsp);
    ix_mv_unref(t->ctx, cut);
    return out;
}

/* A graph over x, so that no part lies on another. */
static ix_mv *graph(gt *t, int n)
{
    double p[16];

    for (int i = 0; i < n; i++) {
        p[i] = i;
        p[n + i] = ix_rng_range(&t->r, -2, 2);
    }
    return gt_curve(t, n, n, NULL, 2, false, p);
}

/* Law: of [a, b] and [c, d], both parts of one curve, the overlap is [max(a,
 * c), min(b, d)], in the parameters of each. */
static void parts_overlap(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *g = graph(&t, 3 + k % 4), *a, *b, *r;
        double x[4], lo, hi, want[2], got[2];
        bool back = k % 2;
        ix_overlap o;

        x[0] = ix_rng_range(&t.r, 0, 0.4);
        x[1] = ix_rng_range(&t.r, 0.6, 1);
        x[2] = k % 3 ? ix_rng_range(&t.r, 0, 0.4) : x[0];
        x[3] = k % 3 ? ix_rng_range(&t.r, 0.6, 1) : x[1];
        a = part(&t, g, x[0], x[1]);
        b = part(&t, g, x[2], x[3]);
        if (back) {
            ASSERT_OK(t.ctx, ix_mv_reverse(t.ctx, b, 0, &r));
            ix_mv_unref(t.ctx, b);
            b = r;
        }
        ASSERT_OK(t.ctx, ix_crv_overlap(t.ctx, a, b, 1e-7, &o));
        lo = fmax(x[0], x[2]);
        hi = fmin(x[1], x[3]);
        assert_int_equal(o.relation, k % 3 ? IX_CRVS_OVERLAP : IX_CRVS_SAME);
        ASSERT_CLOSE(o.a[0], 2 + 3 * (lo - x[0]) / (x[1] - x[0]), 1e-6);
        ASSERT_CLOSE(o.a[1], 2 + 3 * (hi - x[0]) / (x[1] - x[0]), 1e-6);
        want[0] = 2 + 3 * (lo - x[2]) / (x[3] - x[2]);
        want[1] = 2 + 3 * (hi - x[2]) / (x[3] - x[2]);
        for (int e = 0; e < 2; e++)
            got[e] = back ? 7 - o.b[e] : o.b[e];
        gt_same(got, want, 2, 1e-6);
        ix_mv_unref(t.ctx, g);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
    }
    gt_end(&t);
}

static void others_do_not(void **state)
{
    gt t = gt_begin(2);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *a = graph(&t, 4), *b = graph(&t, 4);
        ix_overlap o;

        ASSERT_OK(t.ctx, ix_crv_overlap(t.ctx, a, b, 1e-6, &o));
        assert_int_equal(o.relation, IX_CRVS_DISTINCT);
        assert_true(o.a[0] == 0 && o.a[1] == 0 && o.b[0] == 0 && o.b[1] == 0);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, b);
    }
    gt_end(&t);
}

/* A circle and its upper half, which ends at no break of the seam's side. */
static void closed_curves(void **state)
{
    const double zero[3] = {0, 0, 0};
    gt t = gt_begin(3);
    ix_mv *c, *half;
    ix_overlap o;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_mv_region(t.ctx, c, 0, 2.5, 4, &half));
    ASSERT_OK(t.ctx, ix_crv_overlap(t.ctx, c, c, 1e-9, &o));
    assert_int_equal(o.relation, IX_CRVS_SAME);
    gt_same(o.b, (double[]){0, 4}, 2, 1e-9);
    ASSERT_OK(t.ctx, ix_crv_overlap(t.ctx, half, c, 1e-9, &o));
    assert_int_equal(o.relation, IX_CRVS_OVERLAP);
    gt_same(o.a, (double[]){2.5, 4}, 2, 1e-9);
    gt_same(o.b, (double[]){2.5, 4}, 2, 1e-9);
    assert_int_equal(ix_crv_overlap(t.ctx, c, c, -1, &o), IX_EARG);
    assert_int_equal(ix_crv_overlap(t.ctx, c, c, NAN, &o), IX_EARG);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, half);
    gt_end(&t);
}

/* A circle whose seam touches a line: both of its ends are there, and nearest
 * points on the line are known to half the digits, but that is no length. */
static void seam_touches(void **state)
{
    const double center[3] = {0.6, 0.5, 0}, side[4] = {1, 1, 0, 1};
    gt t = gt_begin(5);
    ix_mv *line = gt_curve(&t, 2, 2, NULL, 2, false, side), *c, *flat;
    ix_overlap o;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, center, 0.4, &c));
    ASSERT_OK(t.ctx, ix_mv_coerce(t.ctx, c, 2, true, &flat));
    ASSERT_OK(t.ctx, ix_crv_overlap(t.ctx, line, flat, 1e-7, &o));
    assert_int_equal(o.relation, IX_CRVS_DISTINCT);
    ASSERT_OK(t.ctx, ix_crv_overlap(t.ctx, flat, line, 1e-7, &o));
    assert_int_equal(o.relation, IX_CRVS_DISTINCT);
    ix_mv_unref(t.ctx, flat);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, line);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {0, 1, 2, 0, 2, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_overlap o;

    IX_TRY(ix_crv_overlap(ctx, f->in[0], f->in[0], 1e-6, &o));
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_overlap), cmocka_unit_test(others_do_not),
        cmocka_unit_test(closed_curves), cmocka_unit_test(seam_touches),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
