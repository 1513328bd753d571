/* Morphing: ends of the sequence, invariance of similar curves, sizes. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

static ix_mv *polyline(ix_ctx *ctx, int n, const double *xy)
{
    double knots[64];
    const ix_dir d = {
        .basis = IX_BSPLINE, .order = 2, .length = n, .knots = knots};
    ix_mv *m;

    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, 2, n, knots));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, xy, &m));
    return m;
}

static double length(ix_ctx *ctx, const ix_mv *m)
{
    double s;

    ASSERT_OK(ctx, ix_length(ctx, m, NULL, &s));
    return s;
}

/* Law: whatever the method, the sequence goes from c1 to c2 in even steps. */
static void ends_are_the_curves(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(71);
    ix_rand_opts o = {
        .ndirs = 1, .kinds = IX_RAND_BEZIER | IX_RAND_OPEN, .min_order = 2};

    (void)state;
    for (int k = 0; k < 50; k++) {
        ix_mv *a, *b, *t[2];
        ix_morph_how how = {
            .levels = k % 5 == 4, .by_length = k % 2, .follow = k % 4 > 1};
        ix_crvs s;

        o.ncoords = 1 + k % 3;
        o.rational = how.levels ? -1 : 0;
        a = ix_mv_randtest(ctx, &r, &o);
        b = ix_mv_randtest(ctx, &r, &o);
        ASSERT_OK(ctx, ix_mv_compatible(ctx, a, b, IX_SAME_ALL, &t[0], &t[1]));
        ASSERT_OK(ctx, ix_morph(ctx, t[0], t[1], how, 0.25, &s));
        assert_int_equal(s.n, 5);
        for (int i = 0; i < 2; i++) {
            double dom[2], x, p[3], q[3];

            ix_mv_domain(t[i], 0, dom);
            for (int j = 0; j <= 10; j++) {
                x = dom[0] + (dom[1] - dom[0]) * j / 10;
                ASSERT_OK(ctx, ix_mv_point(ctx, t[i], &x, p));
                ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[4 * i], &x, q));
                for (int c = 0; c < o.ncoords; c++)
                    ASSERT_CLOSE(p[c], q[c], 1e-10);
            }
        }
        ix_crvs_free(ctx, &s);
        for (int i = 0; i < 2; i++)
            ix_mv_unref(ctx, t[i]);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    ix_ctx_free(ctx);
}

/* Law: between a polygon and its copy turned by 120 degrees all curves are
 * congruent (a convex blend would shrink them to half). */
static void turning_keeps_the_shape(void **state)
{
    static const double xy[10] = {0, 3, 4, 1, -1, 0, 0, 2, 3, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double turned[10], c = -0.5, s = sqrt(0.75);
    ix_mv *a, *b;

    (void)state;
    for (int i = 0; i < 5; i++) {
        turned[i] = c * xy[i] - s * xy[5 + i];
        turned[5 + i] = s * xy[i] + c * xy[5 + i];
    }
    a = polyline(ctx, 5, xy);
    b = polyline(ctx, 5, turned);
    for (int how = 0; how < 4; how++) {
        ix_crvs seq;

        ASSERT_OK(ctx, ix_morph(ctx, a, b,
                                (ix_morph_how){.by_length = how & 1,
                                               .follow = how & 2},
                                0.2, &seq));
        for (int i = 0; i < seq.n; i++) {
            const double *x = ix_mv_coord(seq.crv[i], 0),
                         *y = ix_mv_coord(seq.crv[i], 1);

            if (how & 1)
                ASSERT_CLOSE(length(ctx, seq.crv[i]), length(ctx, a), 1e-12);
            for (int j = 1; how & 1 && j < 5; j++)
                ASSERT_CLOSE(hypot(x[j] - x[0], y[j] - y[0]),
                             hypot(xy[j] - xy[0], xy[5 + j] - xy[5]), 1e-12);
        }
        ix_crvs_free(ctx, &seq);
    }
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

/* Law: closed polygons stay closed. */
static void closed_stays_closed(void **state)
{
    static const double a_xy[10] = {0, 2, 2, 0, 0, 0, 0, 1, 1, 0};
    static const double b_xy[10] = {0, -1, -2, -1, 0, 0, 1, 0, -1, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = polyline(ctx, 5, a_xy), *b = polyline(ctx, 5, b_xy);
    ix_crvs s;

    (void)state;
    ASSERT_OK(ctx,
              ix_morph(ctx, a, b, (ix_morph_how){.by_length = true}, 0.1, &s));
    assert_int_equal(s.n, 11);
    for (int i = 0; i < s.n; i++)
        for (int c = 0; c < 2; c++)
            ASSERT_CLOSE(ix_mv_coord(s.crv[i], c)[0],
                         ix_mv_coord(s.crv[i], c)[4], 1e-14);
    ix_crvs_free(ctx, &s);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    static const double xy[8] = {0, 1, 2, 3, 0, 1, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = polyline(ctx, 4, xy), *b = polyline(ctx, 3, xy);
    const ix_morph_how how = {.levels = false};
    ix_crvs s;

    (void)state;
    assert_int_equal(ix_morph(ctx, a, b, how, 0.5, &s), IX_EARG);
    assert_int_equal(ix_morph(ctx, a, a, how, 0, &s), IX_EARG);
    assert_int_equal(ix_morph(ctx, a, a, how, 2, &s), IX_EARG);
    assert_int_equal(s.n, 0);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){0, 0, 0}, 1, &a));
    assert_int_equal(
        ix_morph(ctx, a, a, (ix_morph_how){.levels = true}, 0.5, &s), IX_EARG);
    ix_mv_unref(ctx, a);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *c;
    ix_crvs s[2];
} state_t;

static void setup(ix_ctx *ctx, void *state)
{
    ASSERT_OK(ctx,
              ix_pcircle(ctx, (double[]){0, 0, 0}, 1, &((state_t *)state)->c));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    state_t *s = state;
    ix_status st = ix_morph(ctx, s->c, s->c, (ix_morph_how){0}, 1, &s->s[0]);

    s->s[1] = (ix_crvs){0};
    if (st == IX_OK)
        st = ix_morph(ctx, s->c, s->c, (ix_morph_how){.levels = true}, 1,
                      &s->s[1]);
    return st;
}

static void drop(ix_ctx *ctx, void *state)
{
    state_t *s = state;

    ix_mv_unref(ctx, s->c);
    ix_crvs_free(ctx, &s->s[0]);
    ix_crvs_free(ctx, &s->s[1]);
}

static void out_of_memory(void **state)
{
    state_t s;
    const ix_fault_case c = {setup, run, drop, &s};

    (void)state;
    assert_true(ix_fault_run(&c) >= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_the_curves),
        cmocka_unit_test(turning_keeps_the_shape),
        cmocka_unit_test(closed_stays_closed),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
