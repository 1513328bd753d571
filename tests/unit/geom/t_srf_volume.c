/* t_srf_volume.c - volumes and moments of surfaces. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

#define PI 3.14159265358979323846

/* Laws: the field's upper corner is the integral; moving the surface by d
 * along z adds d times the area below (first kind). */
static void test_field(void **state)
{
    gt t = gt_begin(111);

    (void)state;
    for (int k = 0; k < 20; k++) {
        ix_mv *s = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER | IX_RAND_OPEN, 2);
        ix_volume v = {.origin = k % 4 == 0,
                       .power = {k % 3 == 1, k % 3 == 2, k % 3}};
        double a, b, dom[2], at[2];
        ix_mv *f = NULL;

        ASSERT_OK(t.ctx, ix_srf_volume(t.ctx, s, &v, &a));
        ASSERT_OK(t.ctx, ix_srf_volume_field(t.ctx, s, &v, &f));
        for (int d = 0; d < 2; d++) {
            ix_mv_domain(f, d, dom);
            at[d] = dom[1];
        }
        ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, f, at, &b));
        ASSERT_CLOSE(a, b, 1e-11);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, f);
    }
    gt_end(&t);
}

/* The unit sphere moved by d: a half circle turned about Z. */
static ix_mv *sphere(gt *t, const double d[3])
{
    const double k[8] = {0, 0, 0, 1, 1, 2, 2, 2}, h = sqrt(0.5);
    const double pts[20] = {1, h, 1, h, 1, 0, h, 1, h,  0,
                            0, 0, 0, 0, 0, 1, h, 0, -h, -1};
    const double mat[16] = {1, 0, 0, 0, 0,    1,    0,    0,
                            0, 0, 1, 0, d[0], d[1], d[2], 1};
    ix_mv *c = gt_curve(t, 3, 5, k, 3, true, pts), *s = NULL, *m = NULL;

    ASSERT_OK(t->ctx, ix_srf_revolve(t->ctx, c, IX_TURN_RATIONAL, &s));
    ASSERT_OK(t->ctx, ix_mv_transform(t->ctx, s, mat, &m));
    ix_mv_unref(t->ctx, c);
    ix_mv_unref(t->ctx, s);
    return m;
}

/* Law: volume, first and second moments of a ball, wherever it is, by both
 * kinds of integrals, up to one sign. */
static void test_ball(void **state)
{
    const double d[3] = {1, -2, 3}, vol = 4 * PI / 3;
    gt t = gt_begin(112);
    ix_mv *s = sphere(&t, d);
    double a, sign;

    (void)state;
    ASSERT_OK(t.ctx,
              ix_srf_volume(t.ctx, s, &(ix_volume){.origin = false}, &a));
    sign = a < 0 ? -1 : 1;
    ASSERT_CLOSE(sign * a, vol, 1e-12);
    ASSERT_OK(t.ctx, ix_srf_volume(t.ctx, s, &(ix_volume){.origin = true}, &a));
    ASSERT_CLOSE(sign * a, vol, 1e-12);
    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++) {
            ix_volume v = {.origin = false};

            v.power[k]++;
            if (l == 0) {
                ASSERT_OK(t.ctx, ix_srf_volume(t.ctx, s, &v, &a));
                ASSERT_CLOSE(sign * a, vol * d[k], 1e-11);
            }
            v.power[l]++;
            ASSERT_OK(t.ctx, ix_srf_volume(t.ctx, s, &v, &a));
            ASSERT_CLOSE(sign * a, vol * (d[k] * d[l] + (k == l ? 0.2 : 0)),
                         1e-11);
        }
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void test_errors(void **state)
{
    const double d[3] = {0, 0, 0};
    const ix_volume v = {.origin = true}, bad = {.power = {0, 3, 0}};
    gt t = gt_begin(113);
    ix_mv *c = gt_random(&t, 1, 3, -1, IX_RAND_BEZIER, 2), *s = sphere(&t, d);
    ix_mv *out;
    double a;

    (void)state;
    assert_int_equal(ix_srf_volume(t.ctx, c, &v, &a), IX_EARG);
    assert_int_equal(ix_srf_volume(t.ctx, s, &bad, &a), IX_EARG);
    assert_int_equal(ix_srf_volume_field(t.ctx, s, &v, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(114)};

    f->in[0] = gt_random(&t, 2, 3, -1, IX_RAND_OPEN, 2);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_volume v = {.power = {1, 0, 1}};
    double a;
    ix_status st = ix_srf_volume(ctx, f->in[0], &v, &a);

    return st == IX_OK ? ix_srf_volume_field(ctx, f->in[0], &v, out) : st;
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_field), cmocka_unit_test(test_ball),
        cmocka_unit_test(test_errors), cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
