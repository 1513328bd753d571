/* Ruled surfaces of constant slope along isoclines, against normals and angles
 * computed from points. */
#include "geom/vec3.h"
#include "geomtest.h"
#include "harness/fault.h"
#include "iritx/contour.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "mv/mv.h"

/* A regular surface with hills: control points near a grid, their heights at
 * random. */
static ix_mv *hills(gt *t, bool rational)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 4, .length = 4},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};
    double pts[4 * 12];
    int r = rational;
    ix_mv *m;

    for (int i = 0; i < 12; i++) {
        double w = rational ? ix_rng_range(&t->r, 0.7, 1.5) : 1;

        if (rational)
            pts[i] = w;
        pts[r * 12 + i] = w * (i % 4 + ix_rng_range(&t->r, -0.2, 0.2));
        pts[(r + 1) * 12 + i] = w * (i / 4 + ix_rng_range(&t->r, -0.2, 0.2));
        pts[(r + 2) * 12 + i] = w * ix_rng_range(&t->r, -2, 2);
    }
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 2, d, 3, rational, pts, &m));
    return m;
}

/* |cos| of the angle between the normal at the foot of p and v. */
static double cosine_at(gt *t, const ix_mv *s, const double *p, const double *v,
                        double *n)
{
    double uv[2], d;

    ASSERT_OK(t->ctx, ix_srf_nearest(t->ctx, s, p, false, uv, &d));
    ASSERT_OK(t->ctx, ix_srf_normal(t->ctx, s, uv[0], uv[1], n));
    return fabs(ix__dot3(n, v));
}

/* Law: rulings are tangent to the surface, have the slope, end at a level of
 * the control points, and start into the part that is asked for. */
static void check(gt *t, const ix_mv *s, const double *v, double theta,
                  bool below, const double *foot, const double *end,
                  const double *level, int *sides)
{
    double r[3], n[3], step[3], len, at, h;

    ix__sub3(end, foot, r);
    len = ix__unit3(r, r);
    at = cosine_at(t, s, foot, v, n);
    ASSERT_CLOSE(at, fabs(cos(theta)), 1e-9);
    ASSERT_CLOSE(ix__dot3(r, n), 0, 1e-9);
    ASSERT_CLOSE(fabs(ix__dot3(r, v)), sin(theta), 1e-9);
    h = ix__dot3(end, v);
    ASSERT_CLOSE(fmin(fabs(h - level[0]), fabs(h - level[1])), 0, 1e-12);
    assert_true(len > 0);
    ix__axpy3(foot, 1e-4, r, step);
    at = cosine_at(t, s, step, v, n) - fabs(cos(theta));
    if (fabs(at) < 2e-5) /* along the isocline, or at the boundary */
        return;
    assert_true((at > 0) == below);
    (*sides)++;
}

static void rulings(void **state)
{
    gt t = gt_begin(71);
    int sides = 0;

    (void)state;
    for (int k = 0; k < 16; k++) {
        ix_mv *s = hills(&t, k % 3 == 0);
        double v[3], theta = ix_rng_range(&t.r, 0.3, 1.5);
        double level[2] = {HUGE_VAL, -HUGE_VAL};
        const double(*p)[3];
        ix_lines l;

        for (int c = 0; c < 3; c++)
            v[c] = ix_rng_range(&t.r, -1, 1);
        ix__unit3(v, v);
        for (size_t i = 0; i < s->npts; i++) {
            double w = s->rational ? ix_mv_weights(s)[i] : 1, h = 0;

            for (int c = 0; c < 3; c++)
                h += ix_mv_coord(s, c)[i] / w * v[c];
            level[0] = fmin(level[0], h);
            level[1] = fmax(level[1], h);
        }
        ASSERT_OK(t.ctx,
                  ix_isocline_drafts(t.ctx, s, v, theta, k % 2, 1e-2, &l));
        p = (const double(*)[3])l.pt;
        for (int i = 0; i < l.n; p += 2 * l.count[i], i += 2) {
            assert_int_equal(l.count[i], l.count[i + 1]);
            for (int j = 0; j < l.count[i]; j += 1 + l.count[i] / 3)
                check(&t, s, v, theta, k % 2, p[j], p[j + l.count[i]], level,
                      &sides);
        }
        ix_lines_free(t.ctx, &l);
        ix_mv_unref(t.ctx, s);
    }
    assert_true(sides > 20);
    gt_end(&t);
}

static void refused(void **state)
{
    const double v[3] = {0, 0, 1}, none[3] = {0, 0, 0};
    gt t = gt_begin(72);
    ix_mv *s = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 3);
    ix_lines l;

    (void)state;
    assert_int_equal(ix_isocline_drafts(t.ctx, s, v, 0, true, 0, &l), IX_EARG);
    assert_int_equal(ix_isocline_drafts(t.ctx, s, none, 1, true, 0, &l),
                     IX_EARG);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

typedef struct {
    ix_mv *s;
    ix_lines l;
} oom;

static void oom_setup(ix_ctx *ctx, void *state)
{
    ix_rng g = ix_rng_new(5);
    const ix_rand_opts o = {.ndirs = 2,
                            .ncoords = 3,
                            .rational = -1,
                            .kinds = IX_RAND_BEZIER,
                            .min_order = 3,
                            .max_order = 3};

    ((oom *)state)->s = ix_mv_randtest(ctx, &g, &o);
}

static ix_status oom_run(ix_ctx *ctx, void *state)
{
    const double v[3] = {0, 0, 1};
    oom *o = state;

    return ix_isocline_drafts(ctx, o->s, v, 0.7, true, 1e-1, &o->l);
}

static void oom_teardown(ix_ctx *ctx, void *state)
{
    ix_lines_free(ctx, &((oom *)state)->l);
    ix_mv_unref(ctx, ((oom *)state)->s);
}

static void out_of_memory(void **state)
{
    oom o = {NULL, {0}};
    ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) >= 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rulings),
        cmocka_unit_test(refused),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
