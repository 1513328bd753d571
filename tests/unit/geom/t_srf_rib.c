/* t_srf_rib.c - ribs on surfaces: contact measured on the surface itself, a
 * plane in closed form, Hermite surfaces with weights by their definition. */
#include "geom/section_hermite.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* A section that begins and ends horizontally. */
static ix_mv *bump(gt *t)
{
    static const double pts[10] = {-1, -0.3, 0, 0.3, 1, 0, 0, 2, 0, 0};

    return gt_curve(t, 5, 5, NULL, 2, false, pts);
}

static ix_mv *hill(gt *t)
{
    static const double pts[27] = {0, 1,   2, 0, 1, 2, 0,   1, 2,
                                   0, 0,   0, 1, 1, 1, 2,   2, 2,
                                   0, 0.5, 0, 0, 1, 0, 0.2, 0, 0.7};
    const ix_dir d[2] = {{IX_BEZIER, 3, 3, false, NULL},
                         {IX_BEZIER, 3, 3, false, NULL}};
    ix_mv *m = NULL;

    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, false, pts, &m));
    return m;
}

static ix_mv *sphere(gt *t)
{
    static const double h = 0.70710678118654752;
    static const double pts[4][5] = {
        {1, h, 1, h, 1}, {0, h, 1, h, 0}, {0, 0, 0, 0, 0}, {-1, -h, 0, h, 1}};
    static const double kv[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    ix_mv *c = gt_curve(t, 3, 5, kv, 3, true, pts[0]), *m = NULL;

    ASSERT_OK(t->ctx, ix_srf_revolve(t->ctx, c, IX_TURN_RATIONAL, &m));
    ix_mv_unref(t->ctx, c);
    return m;
}

/* Law: both borders lie on the surface, normals there are the surface's, and
 * the borders are the width apart (to the first order in it). */
static void contact(void **state)
{
    static const double p0[6] = {0.2, 0.8, 0.7, 0.2, 0.3, 0.8};
    static const double p1[6] = {0.2, 1.8, 2.7, 0.6, 1, 0.8};
    gt t = gt_begin(61);

    (void)state;
    for (int k = 0; k < 2; k++) {
        ix_mv *s = k ? sphere(&t) : hill(&t), *g = bump(&t), *r;
        ix_mv *path = gt_curve(&t, 3, 3, NULL, 2, false, k ? p1 : p0);
        const ix_rib o = {.path = path,
                          .section = g,
                          .tan_scale = 1.3,
                          .width = 0.1,
                          .height = 0.2};

        ASSERT_OK(t.ctx, ix_srf_rib(t.ctx, s, &o, &r));
        for (int i = 0; i <= 5; i++) {
            double e[2][IX_MAX_COORDS], far = 0;

            for (int side = 0; side < 2; side++) {
                double at[2] = {side, i / 5.0}, uv[2], d, n[3], m[3];

                gt_point(&t, r, at, e[side]);
                ASSERT_OK(t.ctx,
                          ix_srf_nearest(t.ctx, s, e[side], false, uv, &d));
                assert_true(d <= 1e-10);
                ASSERT_OK(t.ctx, ix_srf_normal(t.ctx, s, uv[0], uv[1], n));
                ASSERT_OK(t.ctx, ix_srf_normal(t.ctx, r, at[0], at[1], m));
                /* uv are known to the square root of rounding */
                ASSERT_CLOSE(fabs(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]), 1,
                             1e-9);
            }
            for (int c = 0; c < 3; c++)
                far += (e[0][c] - e[1][c]) * (e[0][c] - e[1][c]);
            ASSERT_CLOSE(sqrt(far), 0.1, 0.005);
        }
        ix_mv_unref(t.ctx, r);
        ix_mv_unref(t.ctx, path);
        ix_mv_unref(t.ctx, g);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* Law: in a plane z = 0, S = (2 u, v), along v = 1/2, with the width 0.1 (1 +
 * t) and the height 0.3 t: (2 u(t), 1/2 + x w / 2, -y h), as S_v x S_u = -2 z.
 */
static void plane(void **state)
{
    static const double flat[12] = {0, 2, 0, 2, 0, 0, 1, 1, 0, 0, 0, 0};
    static const double line[4] = {0.1, 0.9, 0.5, 0.5}, grow[2] = {1, 2};
    static const double rise[4] = {7, 7, 0, 1}; /* its y counts */
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    gt t = gt_begin(62);
    ix_mv *s, *g = bump(&t), *path = gt_curve(&t, 2, 2, NULL, 2, false, line);
    ix_mv *w = gt_curve(&t, 2, 2, NULL, 1, false, grow);
    ix_mv *h = gt_curve(&t, 2, 2, NULL, 2, false, rise), *r;
    const ix_rib o = {.path = path,
                      .section = g,
                      .tan_scale = 1,
                      .width = 0.1,
                      .height = 0.3,
                      .width_crv = w,
                      .height_crv = h};

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, flat, &s));
    ASSERT_OK(t.ctx, ix_srf_rib(t.ctx, s, &o, &r));
    for (int i = 0; i < 20; i++) {
        double at[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)};
        double p[IX_MAX_COORDS], x[IX_MAX_COORDS];

        gt_point(&t, r, at, p);
        gt_point(&t, g, at, x);
        ASSERT_CLOSE(p[0], 2 * (0.1 + 0.8 * at[1]), 1e-12);
        ASSERT_CLOSE(p[1], 0.5 + x[0] * 0.05 * (1 + at[1]), 1e-12);
        ASSERT_CLOSE(p[2], -x[1] * 0.3 * at[1], 1e-12);
    }
    /* straight borders: degree 2 of the bilinear surface along the line */
    assert_int_equal(ix_mv_order(r, 1), 3);
    ix_mv_unref(t.ctx, r);
    ix_mv_unref(t.ctx, h);
    ix_mv_unref(t.ctx, w);
    ix_mv_unref(t.ctx, path);
    ix_mv_unref(t.ctx, g);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

/* Law: H((1 + x) / 2) + y n by its definition, whatever has weights. */
static void weights(void **state)
{
    static const double round[3][3] = {{1, 0.6, 1}, {-1, 0, 1}, {0, 1, 0}};
    gt t = gt_begin(63);

    (void)state;
    for (int k = 0; k < 16; k++) {
        ix_mv *c[6], *r;

        for (int i = 0; i < 6; i++)
            c[i] = gt_random(&t, 1, 3, 0, IX_RAND_BEZIER, 2);
        ix_mv_unref(t.ctx, c[4]);
        c[4] = gt_curve(&t, 3, 3, NULL, 2, k % 2 == 0,
                        round[0] + (k % 2 ? 3 : 0));
        if (k % 4 > 1) { /* weights in common */
            ix_mv_unref(t.ctx, c[2]);
            c[2] = ix_mv_ref(c[0]);
        }
        ASSERT_OK(t.ctx,
                  ix__srf_section_hermite(t.ctx, (const ix_mv *const *)c, &r));
        for (int i = 0; i < 5; i++) {
            double at[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)};
            double p[IX_MAX_COORDS], q[6][IX_MAX_COORDS], x;

            gt_point(&t, r, at, p);
            for (int j = 0; j < 6; j++)
                gt_point(&t, c[j], j == 4 ? at : at + 1, q[j]);
            x = (1 + q[4][0]) / 2;
            for (int j = 0; j < 3; j++)
                ASSERT_CLOSE(p[j],
                             q[0][j] * (1 - x) * (1 - x) * (1 + 2 * x) +
                                 q[1][j] * x * x * (3 - 2 * x) +
                                 q[2][j] * x * (1 - x) * (1 - x) -
                                 q[3][j] * x * x * (1 - x) + q[4][1] * q[5][j],
                             1e-10);
        }
        ix_mv_unref(t.ctx, r);
        for (int i = 0; i < 6; i++)
            ix_mv_unref(t.ctx, c[i]);
    }
    gt_end(&t);
}

static void errors(void **state)
{
    static const double straight[4] = {0.2, 0.8, 0.5, 0.5};
    static const double beyond[4] = {0.2, 1.8, 0.5, 0.5};
    static const double edge[4] = {0.2, 0.8, 0.01, 0.01};
    static const double bent[6] = {0.2, 0.5, 0.8, 0.2, 0.8, 0.2};
    static const double kv[5] = {0, 0, 1, 2, 2};
    gt t = gt_begin(64);
    ix_mv *s = hill(&t), *g = bump(&t), *out;
    ix_mv *line = gt_curve(&t, 2, 2, NULL, 2, false, straight);
    ix_mv *far = gt_curve(&t, 2, 2, NULL, 2, false, beyond);
    ix_mv *near = gt_curve(&t, 2, 2, NULL, 2, false, edge);
    ix_mv *knee = gt_curve(&t, 2, 3, kv, 2, false, bent);
    ix_mv *one = gt_curve(&t, 2, 2, NULL, 1, false, straight);
    const ix_rib good = {.path = line,
                         .section = g,
                         .tan_scale = 1,
                         .width = 0.1,
                         .height = 0.1};
    ix_rib o = good;

    (void)state;
    assert_int_equal(ix_srf_rib(t.ctx, g, &o, &out), IX_EARG);
    o.path = s;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EARG);
    o.path = one;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EARG);
    o.path = far;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EDOMAIN);
    o.path = near;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EDOMAIN);
    o.path = knee;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EDOMAIN);
    o = good;
    o.section = line;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EARG);
    o = good;
    o.tan_scale = 0;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EARG);
    o = good;
    o.width = 0;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EARG);
    o.width = NAN;
    assert_int_equal(ix_srf_rib(t.ctx, s, &o, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, one);
    ix_mv_unref(t.ctx, knee);
    ix_mv_unref(t.ctx, near);
    ix_mv_unref(t.ctx, far);
    ix_mv_unref(t.ctx, line);
    ix_mv_unref(t.ctx, g);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    static const double flat[15] = {1, 1, 1, 1, 0, 1, 0, 1, 0, 0, 1.2, 1, 0, 0};
    static const double line[4] = {0.3, 0.7, 0.5, 0.5};
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    gt t = {ctx, ix_rng_new(65)};

    f->in[0] = bump(&t);
    f->in[1] = gt_curve(&t, 2, 2, NULL, 2, false, line);
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 2, true, flat, &f->in[2]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_rib o = {.path = f->in[1],
                      .section = f->in[0],
                      .tan_scale = 1,
                      .width = 0.1,
                      .height = 0.1};

    return ix_srf_rib(ctx, f->in[2], &o, out);
}

static void out_of_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build};

    (void)state;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contact),       cmocka_unit_test(plane),
        cmocka_unit_test(weights),       cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
