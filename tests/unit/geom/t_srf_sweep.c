/* t_srf_sweep.c - swept surfaces. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

static ix_mv *circle(gt *t, double radius)
{
    const double k[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    const double h = sqrt(0.5);
    double pts[27] = {1,  h, 1, h, 1, h, 1, h, 1, 1,  h,  0,  -h, -1,
                      -h, 0, h, 1, 0, h, 1, h, 0, -h, -1, -h, 0};

    for (int i = 9; i < 27; i++)
        pts[i] *= radius;
    return gt_curve(t, 3, 9, k, 2, true, pts);
}

/* A curve whose tangent turns by less than half a turn. */
static ix_mv *axis(gt *t, bool rational)
{
    double pts[16], *x = pts + 4;

    for (int i = 0; i < 4; i++) {
        pts[i] = rational ? ix_rng_range(&t->r, 0.5, 2) : 1;
        x[i] = pts[i] * (i + ix_rng_range(&t->r, -0.2, 0.2));
        x[4 + i] = pts[i] * ix_rng_range(&t->r, -0.5, 0.5);
        x[8 + i] = pts[i] * ix_rng_range(&t->r, -0.5, 0.5);
    }
    return gt_curve(t, 4, 4, NULL, 3, rational, rational ? pts : x);
}

/* Law: a section that is the single point (x, 0, z) at x = z = 0 gives the
 * axis itself, whatever the frame and scale. */
static void test_centre_line(void **state)
{
    static const ix_frame frames[2] = {IX_FRAME_MINIMAL, IX_FRAME_VECTOR};
    gt t = gt_begin(51);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false,
                            (double[4]){-1, 1, 2, -2});
        ix_mv *a = axis(&t, k % 2), *s = NULL;
        const ix_mv *secs[1] = {c};
        ix_sweep w = {.nsections = 1,
                      .sections = secs,
                      .axis = a,
                      .factor = 0.7,
                      .frame = frames[k / 2 % 2],
                      .vec = {0, 0, 1},
                      .refine = k % 5};
        double uv[2], p[IX_MAX_COORDS], q[IX_MAX_COORDS];

        ASSERT_OK(t.ctx, ix_srf_sweep(t.ctx, &w, &s));
        uv[0] = 0.5; /* the section passes the origin here */
        uv[1] = gt_param(&t, s, 1);
        gt_point(&t, s, uv, p);
        gt_point(&t, a, &uv[1], q);
        gt_same(p, q, 3, TOL);
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: along a straight axis the sweep is exact: a circle of radius scale(v)
 * in the plane across the axis; sections are not turned when it is Z. */
static void test_straight(void **state)
{
    const double grow[4] = {0, 1, 1, 3};
    gt t = gt_begin(52);
    ix_mv *c = circle(&t, 1), *scale, *s = NULL, *a;
    const ix_mv *secs[1] = {c};
    double d[3] = {2, -1, 2}; /* length 3 */

    (void)state;
    scale = gt_curve(&t, 2, 2, NULL, 2, false, grow);
    for (int k = 0; k < 2; k++) {
        ix_sweep w = {.nsections = 1,
                      .sections = secs,
                      .factor = 1,
                      .scale = scale,
                      .refine = 2};

        if (k)
            memcpy(d, (double[3]){0, 0, 3}, sizeof d);
        a = gt_curve(&t, 2, 2, NULL, 3, false,
                     (double[6]){1, 1 + d[0], 1, 1 + d[1], 1, 1 + d[2]});
        w.axis = a;
        ASSERT_OK(t.ctx, ix_srf_sweep(t.ctx, &w, &s));
        for (int i = 0; i < ROUNDS; i++) {
            double uv[2] = {gt_param(&t, s, 0), ix_rng_unit(&t.r)};
            double p[IX_MAX_COORDS], q[IX_MAX_COORDS], r[3], along = 0, len = 0;

            gt_point(&t, s, uv, p);
            for (int j = 0; j < 3; j++) {
                r[j] = p[j] - 1 - uv[1] * d[j];
                along += r[j] * d[j] / 3;
                len += r[j] * r[j];
            }
            ASSERT_CLOSE(along, 0, 1e-13);
            ASSERT_CLOSE(sqrt(len), 1 + 2 * uv[1], 1e-12);
            gt_point(&t, c, uv, q);
            if (k) {
                ASSERT_CLOSE(r[0], q[0] * (1 + 2 * uv[1]), 1e-12);
                ASSERT_CLOSE(r[1], q[1] * (1 + 2 * uv[1]), 1e-12);
            }
        }
        ix_mv_unref(t.ctx, a);
        ix_mv_unref(t.ctx, s);
    }
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, scale);
    gt_end(&t);
}

/* Law: refinement makes a tube of radius 0.1: the distance of its points from
 * the axis point of the same parameter tends to 0.1, across the axis. */
static void test_tube(void **state)
{
    gt t = gt_begin(53);
    ix_mv *c = circle(&t, 0.1), *a = axis(&t, false), *s = NULL;
    const ix_mv *secs[1] = {c};

    (void)state;
    for (int refine = 5; refine <= 80; refine *= 4) {
        ix_sweep w = {.nsections = 1,
                      .sections = secs,
                      .axis = a,
                      .factor = 1,
                      .refine = refine};
        double worst = 0;

        ASSERT_OK(t.ctx, ix_srf_sweep(t.ctx, &w, &s));
        for (int i = 0; i < ROUNDS; i++) {
            double uv[2] = {gt_param(&t, s, 0), ix_rng_unit(&t.r)};
            double p[IX_MAX_COORDS], d[6], along = 0, len = 0, speed = 0;

            gt_point(&t, s, uv, p);
            ASSERT_OK(t.ctx, ix_mv_curve_derivs(t.ctx, a, uv[1], 1, d));
            for (int j = 0; j < 3; j++) {
                along += (p[j] - d[j]) * d[3 + j];
                len += (p[j] - d[j]) * (p[j] - d[j]);
                speed += d[3 + j] * d[3 + j];
            }
            worst = fmax(worst, fabs(sqrt(len) - 0.1));
            worst = fmax(worst, fabs(along) / sqrt(speed));
        }
        /* Second order in the knot distance 1 / refine. */
        assert_true(worst < 0.2 / (refine * refine) + 1e-3 / refine);
        ix_mv_unref(t.ctx, s);
    }
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, a);
    gt_end(&t);
}

/* Law: the minimal frame comes back to itself on a planar closed loop, and
 * does not turn about a planar axis: the section's direction orthogonal to
 * the plane stays so. */
static void test_planar(void **state)
{
    gt t = gt_begin(54);
    ix_mv *a = circle(&t, 3), *s = NULL;
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){0, 1, 0, 0});
    const ix_mv *secs[1] = {c};
    /* The circle starts along +Y: Z goes to Y, X stays X, so X is across. */
    ix_sweep w = {
        .nsections = 1, .sections = secs, .axis = a, .factor = 1, .refine = 10};
    double uv[2] = {1, 0}, p[IX_MAX_COORDS], q[IX_MAX_COORDS];

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_sweep(t.ctx, &w, &s));
    gt_point(&t, s, uv, p);
    uv[1] = 4;
    gt_point(&t, s, uv, q);
    gt_same(p, q, 3, 1e-7); /* fourth order in the step of the frames */
    for (int i = 0; i < ROUNDS; i++) {
        uv[1] = gt_param(&t, s, 1);
        gt_point(&t, s, uv, p);
        ASSERT_CLOSE(p[2], 0, 1e-7);
    }
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, a);
    gt_end(&t);
}

/* Law: a binormal, fixed or as a field, is the section's Y axis; several
 * sections are met at the ends. */
static void test_binormal_sections(void **state)
{
    gt t = gt_begin(55);
    ix_mv *a = gt_curve(&t, 2, 2, NULL, 3, false,
                        (double[6]){0, 2, 0, 0, 0, 0});
    ix_mv *c1 = gt_curve(&t, 2, 2, NULL, 2, false, (double[4]){0, 0, 0, 1});
    ix_mv *c2 = gt_curve(&t, 3, 3, NULL, 2, false,
                         (double[6]){0, 0, 0, 1, 2, 3});
    ix_mv *f = gt_curve(&t, 2, 2, NULL, 3, false,
                        (double[6]){0, 0, 0, 1, 1, 0});
    const ix_mv *secs[2] = {c1, c2};
    ix_sweep w = {.nsections = 2,
                  .sections = secs,
                  .axis = a,
                  .factor = 1,
                  .frame = IX_FRAME_VECTOR,
                  .vec = {0, 1, 1},
                  .refine = 3};
    double uv[2] = {1, 0}, p[IX_MAX_COORDS];
    ix_mv *s = NULL;

    (void)state;
    ASSERT_OK(t.ctx, ix_srf_sweep(t.ctx, &w, &s));
    gt_point(&t, s, uv, p);
    gt_same(p, (double[3]){0, sqrt(0.5), sqrt(0.5)}, 3, 1e-14);
    uv[1] = 1;
    gt_point(&t, s, uv, p);
    gt_same(p, (double[3]){2, 3 * sqrt(0.5), 3 * sqrt(0.5)}, 3, 1e-13);
    ix_mv_unref(t.ctx, s);
    w.frame = IX_FRAME_CURVE;
    w.field = f;
    ASSERT_OK(t.ctx, ix_srf_sweep(t.ctx, &w, &s));
    gt_point(&t, s, (double[2]){1, 0}, p);
    gt_same(p, (double[3]){0, 0, 1}, 3, 1e-14);
    gt_point(&t, s, (double[2]){1, 1}, p);
    gt_same(p, (double[3]){2, 3, 0}, 3, 1e-13);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, a);
    ix_mv_unref(t.ctx, f);
    ix_mv_unref(t.ctx, c1);
    ix_mv_unref(t.ctx, c2);
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(56);
    ix_mv *c = circle(&t, 1), *s = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 2);
    ix_mv *a = gt_curve(&t, 2, 2, NULL, 3, false,
                        (double[6]){0, 2, 0, 0, 0, 0});
    ix_mv *p = gt_curve(&t, 2, 2, NULL, 1, false, (double[2]){5, 5}), *out;
    const ix_mv *secs[1] = {c}, *bad[1] = {s};
    const ix_sweep good = {.nsections = 1,
                           .sections = secs,
                           .axis = a,
                           .factor = 1,
                           .frame = IX_FRAME_VECTOR,
                           .vec = {0, 0, 1}};
    ix_sweep w = good;

    (void)state;
    w.nsections = 0;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EARG);
    w = good;
    w.sections = bad;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EARG);
    w = good;
    w.axis = s;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EARG);
    w = good;
    w.axis = p;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EDOMAIN);
    w = good;
    memcpy(w.vec, (double[3]){3, 0, 0}, sizeof w.vec);
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EDOMAIN);
    w = good;
    w.scale = s;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EARG);
    w = good;
    w.refine = -1;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EARG);
    w = good;
    w.frame = IX_FRAME_CURVE;
    w.field = s;
    assert_int_equal(ix_srf_sweep(t.ctx, &w, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, a);
    ix_mv_unref(t.ctx, p);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(57)};

    f->in[0] = circle(&t, 1);
    f->in[1] = axis(&t, true);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_mv *secs[1] = {f->in[0]};
    const ix_sweep w = {.nsections = 1,
                        .sections = secs,
                        .axis = f->in[1],
                        .factor = 1,
                        .frame = IX_FRAME_CURVE,
                        .field = f->in[1],
                        .scale = f->in[1],
                        .refine = 1};

    /* Any curve serves as a field here: it is not along its own tangent. */
    return ix_srf_sweep(ctx, &w, out);
}

static void test_no_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_centre_line),
                                       cmocka_unit_test(test_straight),
                                       cmocka_unit_test(test_tube),
                                       cmocka_unit_test(test_planar),
                                       cmocka_unit_test(test_binormal_sections),
                                       cmocka_unit_test(test_errors),
                                       cmocka_unit_test(test_no_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
