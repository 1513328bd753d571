/* Kernels of surfaces, against the definition: which random points are behind
 * all tangent planes of a dense sample. */
#include <math.h>

#include "base/ctx.h"
#include "geom/vec3.h"
#include "geomtest.h"
#include "iritx/geom_srf.h"
#include "iritx/kernel.h"

/* A surface of revolution about z of a meridian (r, z) of n points, r = 0 at
 * its ends; bent: every other meridian is pushed in. */
static ix_mv *vase(gt *t, int n, const double *r, const double *z, double bent)
{
    const double kv[13] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6};
    double pts[3 * 9 * 12], kz[16];
    ix_dir d[2] = {{IX_BSPLINE, 4, 9, false, kv},
                   {IX_BSPLINE, 3, n, false, kz}};
    ix_mv *m;

    ASSERT_OK(t->ctx, ix_knots_make(t->ctx, IX_KV_OPEN, 3, n, kz));
    for (int j = 0; j < n; j++)
        for (int i = 0; i < 9; i++) {
            double a = 2 * 3.14159265358979 * (i % 8) / 8;
            double f = r[j] * (i % 2 ? bent : 1);
            size_t at = (size_t)(i + 9 * j);

            pts[at] = f * cos(a);
            pts[at + 9 * (size_t)n] = f * sin(a);
            pts[at + 18 * (size_t)n] = z[j];
        }
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, false, pts, &m));
    return m;
}

enum { SIDE = 73 }; /* 72 steps: twice and more those of the function */
typedef struct {
    double at[SIDE * SIDE][3], normal[SIDE * SIDE][3];
} planes;

/* Points and S_u x S_v at even parameters, the border's too: the seam of a vase
 * is an edge. */
static void all_planes(gt *t, const ix_mv *s, planes *w)
{
    double du[2], dv[2];

    ix_mv_domain(s, 0, du);
    ix_mv_domain(s, 1, dv);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double uv[2] = {du[0] + (du[1] - du[0]) * (i % SIDE) / (SIDE - 1),
                        dv[0] + (dv[1] - dv[0]) * (i / SIDE) / (SIDE - 1)};
        double a[3], b[3], x[IX_MAX_COORDS], *m = w->normal[i];

        ASSERT_OK(t->ctx, ix_mv_partial(t->ctx, s, uv, (int[]){1, 0}, a));
        ASSERT_OK(t->ctx, ix_mv_partial(t->ctx, s, uv, (int[]){0, 1}, b));
        gt_point(t, s, uv, x);
        memcpy(w->at[i], x, sizeof w->at[i]);
        ix__cross3(a, b, m);
        if (!(ix__unit3(m, m) > 1e-9))
            memset(m, 0, 3 * sizeof *m);
    }
}

/* How far p is in front of them; out is 1 or -1 as S_u x S_v leads out or in.
 */
static double in_front(const planes *w, double out, const double p[3])
{
    double worst = -HUGE_VAL;

    for (int i = 0; i < SIDE * SIDE; i++) {
        double d[3];

        ix__sub3(p, w->at[i], d);
        if (ix__dot3(w->normal[i], w->normal[i]) > 0)
            worst = fmax(worst, out * ix__dot3(d, w->normal[i]));
    }
    return worst;
}

/* How far p is in front of the faces. */
static double outside(const ix_lines *l, const double p[3])
{
    double worst = -HUGE_VAL;
    double(*v)[3] = l->pt;

    for (int f = 0; f < l->n; v += l->count[f], f++) {
        double m[3] = {0}, d[3];

        for (int i = 1; i + 1 < l->count[f]; i++) {
            double a[3], b[3], c[3];

            ix__sub3(v[i], v[0], a);
            ix__sub3(v[i + 1], v[0], b);
            ix__cross3(a, b, c);
            ix__axpy3(m, 1, c, m);
        }
        ix__unit3(m, m);
        ix__sub3(p, v[0], d);
        worst = fmax(worst, ix__dot3(d, m));
    }
    return worst;
}

/* Law: what is inside the polyhedron is behind all planes to its error, what is
 * behind all planes is inside the polyhedron; both to what 72 steps leave open:
 * the planes turn by some 0.1 from one to the next. */
static int check_kernel(gt *t, const ix_mv *s, double out)
{
    ix_lines l, again;
    double error, other, edges = 0;
    static planes w;
    int inside = 0;

    all_planes(t, s, &w);

    ASSERT_OK(t->ctx, ix_srf_kernel(t->ctx, s, 6, 3, &error, &l));
    for (int i = 0; i < 150; i++) {
        double p[3], lo[3], hi[3], d, f;

        ASSERT_OK(t->ctx, ix_mv_bbox(t->ctx, s, lo, hi));
        for (int k = 0; k < 3; k++)
            p[k] = ix_rng_range(&t->r, lo[k], hi[k]);
        d = l.n ? outside(&l, p) : 1;
        f = in_front(&w, out, p);
        if (d <= 0)
            assert_true(f <= error + 0.03);
        if (f <= -0.03)
            assert_true(d <= 1e-9);
        inside += d <= 0;
    }
    ASSERT_OK(t->ctx, ix_srf_kernel(t->ctx, s, 6, 1, &other, &again));
    ASSERT_CLOSE(error, other, 1e-8);
    for (int f = 0; f < l.n; f++)
        edges += l.count[f] / 2.0;
    assert_true(l.n == 0 || edges >= 1.5 * l.n);
    ix_lines_free(t->ctx, &l);
    ix_lines_free(t->ctx, &again);
    return inside;
}

static void as_defined(void **state)
{
    const double r[7] = {0, 1, 1.2, 0.8, 1.2, 1, 0};
    const double waists[10] = {0, 1, 1, 0.1, 1, 1, 0.1, 1, 1, 0};
    const double zs[10] = {-3, -3, -2, -1.5, -1, 1, 1.5, 2, 3, 3};
    const double z[7] = {-2, -2, -1, 0, 1, 2, 2};
    static planes w;
    gt t = gt_begin(1);
    int inside = 0;

    (void)state;
    for (int k = 0; k < 3; k++) {
        ix_mv *s = vase(&t, 7, r, z, 1 - 0.15 * k), *back;
        double mid[3] = {0, 0, 0}, out;

        all_planes(&t, s, &w);
        out = in_front(&w, 1, mid) < 0 ? 1 : -1;
        inside += check_kernel(&t, s, out);
        ASSERT_OK(t.ctx, ix_mv_reverse(t.ctx, s, 0, &back));
        inside += check_kernel(&t, back, -out);
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, back);
    }
    assert_true(inside > 60);
    {
        ix_mv *s = vase(&t, 10, waists, zs, 1);
        double error;
        ix_lines l;

        ASSERT_OK(t.ctx, ix_srf_kernel(t.ctx, s, 6, 3, &error, &l));
        assert_int_equal(l.n, 0); /* two waists: no kernel */
        ix_lines_free(t.ctx, &l);
        ix_mv_unref(t.ctx, s);
    }
    gt_end(&t);
}

/* A ball is its own kernel: the polyhedron around it shrinks to it as the
 * square of the step. */
static void a_ball(void **state)
{
    const double r[5] = {0, 1, 1, 1, 0}, z[5] = {-1, -1, 0, 1, 1};
    gt t = gt_begin(2);
    ix_mv *s = vase(&t, 5, r, z, 1);
    double error[2];

    (void)state;
    for (int k = 0; k < 2; k++) {
        ix_lines l;

        ASSERT_OK(t.ctx, ix_srf_kernel(t.ctx, s, 4 << k, 2, &error[k], &l));
        assert_true(l.n > 20);
        ix_lines_free(t.ctx, &l);
    }
    assert_true(error[0] < 0.1);
    assert_true(error[1] < 0.35 * error[0]);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void errors(void **state)
{
    const double line[4] = {0, 1, 0, 1}, r[5] = {0, 1, 1, 1, 0};
    const double z[5] = {-1, -1, 0, 1, 1};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, line);
    ix_mv *s = vase(&t, 5, r, z, 1);
    double error;
    ix_lines l;

    (void)state;
    assert_int_equal(ix_srf_kernel(t.ctx, c, 4, 1, &error, &l), IX_EARG);
    assert_int_equal(ix_srf_kernel(t.ctx, s, 0, 1, &error, &l), IX_EARG);
    assert_int_equal(ix_srf_kernel(t.ctx, s, 4, 0, &error, &l), IX_EARG);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0.1, 0.2, 0};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    double error;
    ix_lines l;

    IX_TRY(ix_srf_kernel(ctx, f->in[0], 3, 2, &error, &l));
    ix_lines_free(ctx, &l);
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
        cmocka_unit_test(as_defined),
        cmocka_unit_test(a_ball),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
