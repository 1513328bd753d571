/* Points whose distances add up: the distances and the normals are measured
 * at every vertex of the locus. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

/* (P - C(t)).C'(t) relative to its factors, and |P - C(t)|. */
static double off_normal(ix_ctx *ctx, const ix_mv *c, double t, const double *p,
                         double *dist)
{
    double d[2][3] = {{0}}, v[2];
    int nc = ix_mv_ncoords(c);
    double all[6];

    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, all));
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < 2; k++)
            d[j][k] = all[j * nc + k];
    v[0] = p[0] - d[0][0];
    v[1] = p[1] - d[0][1];
    *dist = hypot(v[0], v[1]);
    return (v[0] * d[1][0] + v[1] * d[1][1]) /
           (hypot(d[1][0], d[1][1]) * (1 + *dist));
}

/* Law: P is on the normals at both feet, and the distances add up. */
static void distances_add_up(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(111);
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 2,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN,
                      .min_order = 2,
                      .max_order = 3,
                      .max_knots = 1};
    int found = 0;

    (void)state;
    for (int k = 0; k < 4; k++) {
        ix_mv *a, *b, *moved;
        const double sum = 4;
        size_t at = 0;
        ix_lines uv, xy;

        o.rational = k % 2 ? 1 : -1;
        a = ix_mv_randtest(ctx, &r, &o);
        b = ix_mv_randtest(ctx, &r, &o);
        ASSERT_OK(ctx, ix_mv_reverse(ctx, b, 0, &moved));
        ASSERT_OK(ctx, ix_conic_locus(ctx, a, moved, sum, false, 1e-2, &uv));
        ASSERT_OK(ctx, ix_conic_locus(ctx, a, moved, sum, true, 1e-2, &xy));
        assert_int_equal(uv.n, xy.n);
        for (int i = 0; i < uv.n; i++)
            for (int j = 0; j < uv.count[i]; j++, at++) {
                double d[2];

                found++;
                assert_int_equal(uv.count[i], xy.count[i]);
                /* far points amplify the feet's rounding */
                assert_true(fabs(off_normal(ctx, a, uv.pt[at][0], xy.pt[at],
                                            &d[0])) < 1e-9);
                assert_true(fabs(off_normal(ctx, moved, uv.pt[at][1], xy.pt[at],
                                            &d[1])) < 1e-6);
                ASSERT_CLOSE(d[0] + d[1], sum, 2e-6);
            }
        ix_lines_free(ctx, &uv);
        ix_lines_free(ctx, &xy);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, moved);
    }
    assert_true(found > 100);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c, *f;
    ix_lines l;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){0, 0, 0}, 1, &c));
    assert_int_equal(ix_conic_distance(ctx, c, c, 0, &f), IX_EARG);
    assert_null(f);
    assert_int_equal(ix_conic_locus(ctx, c, c, -1, true, 1e-3, &l), IX_EARG);
    assert_int_equal(l.n, 0);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void setup(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    ASSERT_OK(ctx, ix_arc_angles(ctx, (double[]){0, 0, 0}, 1, 0, 90, &m[0]));
    ASSERT_OK(ctx, ix_hermite(ctx, (double[]){2, 0, 0}, (double[]){2, 1, 0},
                              (double[]){0, 1, 0}, (double[]){0, 1, 0}, &m[1]));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    return ix_conic_distance(ctx, m[0], m[1], 3, &m[2]);
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

static void out_of_memory(void **state)
{
    ix_mv *m[3];
    const ix_fault_case c = {setup, run, drop, m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 30);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_add_up),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
