/* Parts of surfaces that directions see, against the normals themselves at
 * random places. */
#include <math.h>

#include "base/ctx.h"
#include "geom/vec3.h"
#include "geomtest.h"
#include "iritx/contour.h"
#include "iritx/geom_srf.h"

/* Unit normal S_v x S_u from plain derivatives; false at poles. */
static bool normal_at(gt *t, const ix_mv *s, const double uv[2], double n[3])
{
    double h = 1e-6, a[2][IX_MAX_COORDS], b[2][IX_MAX_COORDS], du[3], dv[3];

    for (int e = 0; e < 2; e++) {
        double p[2] = {uv[0] + (e ? h : -h), uv[1]};
        double q[2] = {uv[0], uv[1] + (e ? h : -h)};

        gt_point(t, s, p, a[e]);
        gt_point(t, s, q, b[e]);
    }
    ix__sub3(a[1], a[0], du);
    ix__sub3(b[1], b[0], dv);
    ix__cross3(dv, du, n);
    return ix__unit3(n, n) > 1e-20;
}

/* Parity of a ray to the right; *near is set beside a side of the border. */
static bool inside(const ix_lines *l, const double uv[2], bool *near)
{
    double(*p)[3] = l->pt;
    bool in = false;

    for (int i = 0; i < l->n; p += l->count[i], i++)
        for (int k = 0; k + 1 < l->count[i]; k++) {
            const double *a = p[k], *b = p[k + 1];
            double dx = b[0] - a[0], dy = b[1] - a[1];
            double s = fmax(
                0, fmin(1, ((uv[0] - a[0]) * dx + (uv[1] - a[1]) * dy) /
                               (dx * dx + dy * dy)));

            *near = *near ||
                    hypot(a[0] + s * dx - uv[0], a[1] + s * dy - uv[1]) < 0.01;
            if ((a[1] > uv[1]) != (b[1] > uv[1]) &&
                uv[0] < a[0] + (uv[1] - a[1]) * dx / dy)
                in = !in;
        }
    return in;
}

/* Law: each place is in a region; in a region means that the normal is within
 * the angle; and all places of that kind are in some region of the direction.
 */
static int check_regions(gt *t, const ix_mv *s, double angle,
                         const ix_view_regions *r)
{
    double dom[2][2], most = cos(angle);
    int tested = 0;

    for (int k = 0; k < 2; k++)
        ix_mv_domain(s, k, dom[k]);
    for (int i = 0; i < 120; i++) {
        double uv[2], n[3];
        bool covered = false, any_near = false;

        for (int k = 0; k < 2; k++)
            uv[k] = ix_rng_range(&t->r, dom[k][0] + 1e-3, dom[k][1] - 1e-3);
        if (!normal_at(t, s, uv, n))
            continue;
        for (int j = 0; j < r->n;) {
            const double *dir = r->region[j].dir;
            bool in = false, near = false;
            double c = ix__dot3(n, dir);

            for (; j < r->n && memcmp(dir, r->region[j].dir, 24) == 0; j++)
                in = inside(&r->region[j].border, uv, &near) || in;
            covered = covered || in;
            any_near = any_near || near;
            if (!near && in != (c > most))
                fail_msg("at (%g, %g) cosine %g, limit %g, in %d", uv[0], uv[1],
                         c, most, in);
            tested += !near;
        }
        assert_true(covered || any_near);
    }
    return tested;
}

static ix_mv *wavy(gt *t)
{
    const double kv[8] = {0, 0, 0, 0.4, 1, 1, 1, 0};
    const ix_dir d[2] = {
        {IX_BSPLINE, 3, 4, false, kv},
        {.basis = IX_BSPLINE, .order = 3, .length = 4, .knots = kv}};
    double p[48];
    ix_mv *m;

    for (int i = 0; i < 16; i++) {
        p[i] = i % 4 + ix_rng_range(&t->r, -0.2, 0.2);
        p[i + 16] = i / 4 + ix_rng_range(&t->r, -0.2, 0.2);
        p[i + 32] = ix_rng_range(&t->r, -0.6, 0.6);
    }
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, false, p, &m));
    return m;
}

static void random_surfaces(void **state)
{
    gt t = gt_begin(1);
    int tested = 0;

    (void)state;
    for (int k = 0; k < 4; k++) {
        ix_mv *s = wavy(&t);
        double angle = 0.35 + 0.2 * k;
        ix_view_regions r;

        ASSERT_OK(t.ctx,
                  ix_srf_view_regions(t.ctx, s, 1 + 2 * k, angle, 1e-3, &r));
        assert_true(r.n > 0 && r.n < 40);
        tested += check_regions(&t, s, angle, &r);
        ix_view_regions_free(t.ctx, &r);
        ix_mv_unref(t.ctx, s);
    }
    assert_true(tested > 500);
    gt_end(&t);
}

/* A half sphere with its pole, polynomial: r = sin-like profile turned by
 * quadratic arcs; the field of normals vanishes along an edge. */
static ix_mv *cap(gt *t)
{
    const double x[3] = {1, 1, 0}, y[3] = {0, 1, 1}, r[3] = {0, 1, 1};
    const double z[3] = {1, 1, 0};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};
    double p[27];
    ix_mv *m;

    for (int i = 0; i < 9; i++) {
        p[i] = x[i % 3] * r[i / 3];
        p[i + 9] = y[i % 3] * r[i / 3];
        p[i + 18] = z[i / 3];
    }
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, false, p, &m));
    return m;
}

static void a_pole(void **state)
{
    gt t = gt_begin(2);
    ix_mv *s = cap(&t);
    ix_view_regions r;

    (void)state;
    for (int k = 0; k < 2; k++) {
        double angle = k ? acos(0) : 0.5;

        ASSERT_OK(t.ctx, ix_srf_view_regions(t.ctx, s, 3, angle, 1e-3, &r));
        if (k) /* all of it from one direction */
            assert_int_equal(r.n, 1);
        assert_true(check_regions(&t, s, angle, &r) > 50);
        ix_view_regions_free(t.ctx, &r);
    }
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

/* A rational tube whose normals jump in length at knots of u. */
static void a_tube(void **state)
{
    const double w = 0.70710678118654752, ku[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double x[5] = {1, 1, 0, -1, -1}, y[5] = {0, 1, 1, 1, 0};
    const ix_dir d[2] = {{IX_BSPLINE, 3, 5, false, ku},
                         {.basis = IX_BSPLINE,
                          .order = 2,
                          .length = 2,
                          .knots = (double[]){0, 0, 1, 1}}};
    double p[40];
    gt t = gt_begin(4);
    ix_view_regions r;
    ix_mv *s;

    (void)state;
    for (int i = 0; i < 10; i++) {
        double wt = i % 5 % 2 ? w : 1;

        p[i] = wt;
        p[i + 10] = wt * x[i % 5] * (i < 5 ? 1 : 1.5);
        p[i + 20] = wt * y[i % 5] * (i < 5 ? 1 : 1.5);
        p[i + 30] = wt * (i < 5 ? 0 : 2);
    }
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, true, p, &s));
    for (int k = 0; k < 3; k++) {
        double angle = k == 2 ? acos(0) : 0.4 + 0.4 * k;

        ASSERT_OK(t.ctx, ix_srf_view_regions(t.ctx, s, 4, angle, 1e-3, &r));
        assert_true(check_regions(&t, s, angle, &r) > 50);
        ix_view_regions_free(t.ctx, &r);
    }
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void errors(void **state)
{
    const double line[4] = {0, 1, 0, 1},
                 flat[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0};
    const double point[12] = {0};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, line), *s, *p, *k = cap(&t);
    ix_view_regions r;

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, flat, &s));
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 3, false, point, &p));
    assert_int_equal(ix_srf_view_regions(t.ctx, c, 3, 1, 0, &r), IX_EARG);
    assert_int_equal(ix_srf_view_regions(t.ctx, s, 0, 1, 0, &r), IX_EARG);
    assert_int_equal(ix_srf_view_regions(t.ctx, s, 3, NAN, 0, &r), IX_EARG);
    assert_int_equal(ix_srf_view_regions(t.ctx, p, 3, 1, 0, &r), IX_EDOMAIN);
    assert_int_equal(ix_srf_view_regions(t.ctx, k, 3, 2e-3, 0, &r), IX_EUNABLE);
    assert_int_equal(r.n, 0);
    ASSERT_OK(t.ctx, ix_srf_view_regions(t.ctx, s, 3, 0.1, 0, &r));
    assert_int_equal(r.n, 1); /* a plane: one direction, all of it */
    ASSERT_CLOSE(fabs(r.region[0].dir[2]), 1, 1e-12);
    ix_view_regions_free(t.ctx, &r);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, p);
    ix_mv_unref(t.ctx, k);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_view_regions r;

    IX_TRY(ix_srf_view_regions(ctx, f->in[0], 1, 0.9, 0.1, &r));
    ix_view_regions_free(ctx, &r);
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
        cmocka_unit_test(random_surfaces), cmocka_unit_test(a_pole),
        cmocka_unit_test(a_tube),          cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
