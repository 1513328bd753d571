/* The tangent sheet of a planar curve against its definition. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/kernel.h"

static double cross_at(gt *t, const ix_mv *c, double u, const double *p,
                       double gamma)
{
    double x[IX_MAX_COORDS], d[3], cs = cos(gamma), sn = sin(gamma);

    gt_point(t, c, &u, x);
    ASSERT_OK(t->ctx, ix_tangent(t->ctx, c, u, false, d));
    return (x[0] - p[0]) * (sn * d[0] + cs * d[1]) -
           (x[1] - p[1]) * (cs * d[0] - sn * d[1]);
}

/* Law: F(x, y, t) = (C - p) x R C', times w^3 if rational. */
static void the_field_is_its_definition(void **state)
{
    gt t = gt_begin(1);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c = gt_random(&t, 1, 2, k % 2 ? 1 : -1,
                             IX_RAND_BEZIER | IX_RAND_OPEN, 3),
              *f;
        double gamma = ix_rng_range(&t.r, -1, 1), lo[2], hi[2], v, w = 1;
        double at[3], p[2], x[3];

        ASSERT_OK(t.ctx, ix_crv_kernel_field(t.ctx, c, gamma, lo, hi, &f));
        at[0] = ix_rng_unit(&t.r);
        at[1] = ix_rng_unit(&t.r);
        at[2] = gt_param(&t, c, 0);
        for (int i = 0; i < 2; i++)
            p[i] = lo[i] + at[i] * (hi[i] - lo[i]);
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, f, at, &v));
        if (ix_mv_rational(c)) {
            ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, c, &at[2], x));
            w = x[0] * x[0] * x[0];
        }
        ASSERT_CLOSE(v, w * cross_at(&t, c, at[2], p, gamma), 1e-9);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, f);
    }
    gt_end(&t);
}

/* Law: every vertex of the sheet is on its tangent line; of a circle no vertex
 * is inside, as its kernel is all of it, and the envelope is the circle. */
static void the_sheet_leaves_the_kernel_free(void **state)
{
    const double zero[3] = {0, 0, 0};
    gt t = gt_begin(2);
    ix_solution_curves s;
    double lo[2], hi[2];
    ix_lines l;
    ix_mv *c, *f;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 1, &c));
    ASSERT_OK(t.ctx, ix_crv_kernel_sheet(t.ctx, c, 0, 6, &l));
    assert_int_equal(l.n, 4 * 5);
    for (int i = 0; i < 4 * l.n; i++) {
        assert_true(fabs(cross_at(&t, c, l.pt[i][2], l.pt[i], 0)) < 1e-12);
        assert_true(hypot(l.pt[i][0], l.pt[i][1]) >= 1);
    }
    ix_lines_free(t.ctx, &l);
    ASSERT_OK(t.ctx, ix_crv_kernel_field(t.ctx, c, 0, lo, hi, &f));
    ASSERT_OK(t.ctx, ix_crv_kernel_envelope(t.ctx, c, 0, 1e-3, &s));
    assert_true(s.ncurves > 0);
    for (int i = 0; i < s.ncurves; i++)
        for (int k = 0; k < s.curve[i].n; k++) {
            const double *x = s.curve[i].x + 3 * k;

            ASSERT_CLOSE(hypot(lo[0] + x[0] * (hi[0] - lo[0]),
                               lo[1] + x[1] * (hi[1] - lo[1])),
                         1, 1e-9);
        }
    ix_solution_curves_free(t.ctx, &s);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, f);
    gt_end(&t);
}

static void the_surface_is_its_definition(void **state)
{
    const double pts[6] = {0, 1, 2, 0, 2, 0};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 3, 3, NULL, 2, false, pts), *s;
    double gamma = 0.3, g = tan(gamma);

    (void)state;
    ASSERT_OK(t.ctx, ix_crv_kernel_surface(t.ctx, c, gamma, 2, &s));
    for (int i = 0; i <= 20; i++) {
        double at[2] = {i / 20.0, 1 - i / 20.0}, r = 4 * at[1] - 2, d[3];
        double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

        gt_point(&t, c, at, p);
        gt_point(&t, s, at, q);
        ASSERT_OK(t.ctx, ix_tangent(t.ctx, c, at[0], false, d));
        ASSERT_CLOSE(q[0], p[0] + r * (d[0] + g * d[1]), 1e-13);
        ASSERT_CLOSE(q[1], p[1] + r * (d[1] - g * d[0]), 1e-13);
        ASSERT_CLOSE(q[2], g, 1e-15);
    }
    ix_mv_unref(t.ctx, s);
    assert_int_equal(ix_crv_kernel_surface(t.ctx, c, 0, 0, &s), IX_EARG);
    assert_int_equal(ix_crv_kernel_surface(t.ctx, c, acos(0), 1, &s), IX_EARG);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

static void errors(void **state)
{
    const double line[2] = {0, 1}, pole[6] = {1, -1, 0, -1, 0, 0};
    gt t = gt_begin(4);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 1, false, line), *f;
    ix_mv *p = gt_curve(&t, 2, 2, NULL, 2, true, pole);
    double lo[2], hi[2];
    ix_lines l;

    (void)state;
    assert_int_equal(ix_crv_kernel_field(t.ctx, c, 0, lo, hi, &f), IX_EARG);
    assert_int_equal(ix_crv_kernel_field(t.ctx, p, 0, lo, hi, &f), IX_EDOMAIN);
    assert_int_equal(ix_crv_kernel_sheet(t.ctx, c, 0, 4, &l), IX_EARG);
    assert_int_equal(ix_crv_kernel_sheet(t.ctx, p, 0, 1, &l), IX_EARG);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, p);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[9] = {1, 2, 1, 0, 2, 2, 0, 4, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, true, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    double lo[2], hi[2];
    ix_lines l;

    IX_TRY(ix_crv_kernel_sheet(ctx, f->in[0], 0, 3, &l));
    ix_lines_free(ctx, &l);
    IX_TRY(ix_crv_kernel_surface(ctx, f->in[0], 0.1, 1, out));
    ix_mv_unref(ctx, *out);
    *out = NULL;
    return ix_crv_kernel_field(ctx, f->in[0], 0.1, lo, hi, out);
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_field_is_its_definition),
        cmocka_unit_test(the_sheet_leaves_the_kernel_free),
        cmocka_unit_test(the_surface_is_its_definition),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
