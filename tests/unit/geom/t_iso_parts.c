/* t_iso_parts.c - partial isoparametric curves: at every parameter along them
 * neighbours are near, and a curve is only where the ones around it are not. */
#include "base/ctx.h"
#include "geom/iso_curves.h"
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* Squared distance of S at u = a and u = b, at v. */
static double gap(gt *t, const ix_mv *s, double a, double b, double v)
{
    double p[IX_MAX_COORDS], q[IX_MAX_COORDS], sum = 0;

    gt_point(t, s, (const double[2]){a, v}, p);
    gt_point(t, s, (const double[2]){b, v}, q);
    for (int k = 0; k < 3; k++)
        sum += (p[k] - q[k]) * (p[k] - q[k]);
    return sqrt(sum);
}

/* Laws: the curves that pass v are, neighbour from neighbour, within eps at v;
 * none of the later ones (level 2 and above) is in the middle of two that were
 * near enough. */
static void neighbours_are_near(void **state)
{
    const double eps = 0.15;
    gt t = gt_begin(95);

    (void)state;
    for (int k = 0; k < 6; k++) {
        ix_mv *s = gt_random(&t, 2, 3, 0, IX_RAND_BEZIER | IX_RAND_OPEN, 2);
        ix_mark mk = ix__scratch_mark(t.ctx);
        ix__iso_part *p;
        double dom[2], u[2];
        int n;

        ASSERT_OK(t.ctx, ix__iso_parts(t.ctx, s, 0, eps, &n, &p));
        ix_mv_domain(s, 1, dom);
        ix_mv_domain(s, 0, u);
        for (int i = 0; i < 40; i++) {
            double v = ix_rng_range(&t.r, dom[0], dom[1]);
            int last = -1;

            for (int j = 0; j < n; j++) {
                double h = (u[1] - u[0]) / pow(2, p[j].level);

                if (!(p[j].range[0] <= v && v <= p[j].range[1]))
                    continue;
                if (last >= 0)
                    assert_true(gap(&t, s, p[last].t, p[j].t, v) <=
                                eps * (1 + 1e-9));
                if (p[j].level > 1)
                    assert_true(gap(&t, s, p[j].t - h, p[j].t + h, v) >=
                                eps * (1 - 1e-6));
                last = j;
            }
            assert_true(last >= 0 && p[last].t == u[1]);
        }
        ix__scratch_release(t.ctx, mk);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

static void errors(void **state)
{
    gt t = gt_begin(96);
    ix_mv *c = gt_random(&t, 1, 3, 0, IX_RAND_BEZIER, 2);
    ix_mv *s = gt_random(&t, 2, 3, 0, IX_RAND_BEZIER, 2);
    ix__iso_part *p;
    int n;

    (void)state;
    assert_int_equal(ix__iso_parts(t.ctx, c, 0, 0.1, &n, &p), IX_EARG);
    assert_int_equal(ix__iso_parts(t.ctx, s, 0, 0, &n, &p), IX_EARG);
    assert_int_equal(ix__iso_parts(t.ctx, s, 0, (double)NAN, &n, &p), IX_EARG);
    assert_int_equal(ix__iso_parts(t.ctx, s, 0, 1e-9, &n, &p), IX_EUNABLE);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

typedef struct {
    ix_mv *s;
} fault;

static void setup(ix_ctx *ctx, void *state)
{
    gt t = {ctx, ix_rng_new(97)};

    ((fault *)state)->s = gt_random(&t, 2, 3, 1, IX_RAND_BEZIER, 3);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    ix__iso_part *p;
    int n;

    IX_RETURN_SCOPED(ctx,
                     ix__iso_parts(ctx, ((fault *)state)->s, 1, 0.5, &n, &p));
}

static void teardown(ix_ctx *ctx, void *state)
{
    ix_mv_unref(ctx, ((fault *)state)->s);
}

static void out_of_memory(void **state)
{
    fault f;
    const ix_fault_case c = {setup, run, teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(neighbours_are_near),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
