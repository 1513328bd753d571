/* Matching: a curve with itself, with a copy that runs unevenly, with a closed
 * copy that begins elsewhere. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"
#include "iritx/sym.h"

static ix_mv *bezier(ix_ctx *ctx, int order, int ncoords, const double *pts)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = order, .length = order};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, ncoords, false, pts, &m));
    return m;
}

static double apart(ix_ctx *ctx, const ix_mv *a, const ix_mv *b)
{
    double dom[2], worst = 0, p[3], q[3];

    ix_mv_domain(a, 0, dom);
    for (int i = 0; i <= 40; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * i / 40, d = 0;

        ASSERT_OK(ctx, ix_mv_point(ctx, a, &t, p));
        ASSERT_OK(ctx, ix_mv_point(ctx, b, &t, q));
        for (int c = 0; c < ix_mv_ncoords(a); c++)
            d = hypot(d, p[c] - q[c]);
        worst = fmax(worst, d);
    }
    return worst;
}

/* Law: whatever the norm, a curve matches itself by the identity, and a copy
 * that runs unevenly is brought back to within the sampling. */
static void copies_match(void **state)
{
    static const double arch[8] = {0, 1, 3, 4, 0, 3, 3, 0};
    static const double slow[3] = {0, 0.1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = bezier(ctx, 4, 2, arch), *f = bezier(ctx, 3, 1, slow), *u, *m;

    (void)state;
    ASSERT_OK(ctx, ix_sym_compose(ctx, c, f, &u));
    for (int norm = 1; norm <= 4; norm++) {
        ix_match_opts o = {.samples = 100,
                           .length = 20,
                           .order = 3,
                           .norm = (ix_match_norm)norm,
                           .allow_negative = true};
        double worth;

        ASSERT_OK(ctx, ix_match(ctx, c, c, &o, &worth, &m));
        ASSERT_CLOSE(worth, 1, 1e-12);
        assert_true(apart(ctx, c, m) < 1e-12);
        ix_mv_unref(ctx, m);
        if (norm == IX_MATCH_BISECT) /* mirrored tangents: another pairing */
            continue;
        ASSERT_OK(ctx, ix_match(ctx, c, u, &o, &worth, &m));
        assert_true(worth > 0.98);
        /* steps of 1/99 where u is fastest: 1.9 length 6 / 99 */
        assert_true(apart(ctx, c, m) < 0.12);
        ix_mv_unref(ctx, m);
    }
    ix_mv_unref(ctx, u);
    ix_mv_unref(ctx, f);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Law: a closed curve that begins elsewhere is turned back. */
static void seams_are_found(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_match_opts o = {.samples = 101,
                       .length = 20,
                       .order = 2,
                       .rotate = true,
                       .norm = IX_MATCH_MORPH};
    ix_mv *c, *half[2], *moved, *m;
    double worth;

    (void)state;
    ASSERT_OK(ctx, ix_pcircle(ctx, (double[]){0, 0, 0}, 1, &c));
    ASSERT_OK(ctx, ix_mv_split(ctx, c, 0, 1.4, half));
    ASSERT_OK(ctx,
              ix_mv_merge(ctx, half[1], half[0], 0, IX_JOIN_SHARED, &moved));
    ASSERT_OK(ctx, ix_match(ctx, c, moved, &o, &worth, &m));
    assert_true(worth > 0.999);
    assert_true(apart(ctx, c, m) < 0.1); /* a sample is 0.06 */
    ix_mv_unref(ctx, m);
    o.rotate = false;
    o.allow_negative = true;
    ASSERT_OK(ctx, ix_match(ctx, c, moved, &o, &worth, &m));
    assert_true(worth < 0.95);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, half[0]);
    ix_mv_unref(ctx, half[1]);
    ix_mv_unref(ctx, moved);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void errors(void **state)
{
    static const double line[4] = {0, 1, 0, 0}, back[4] = {1, 0, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = bezier(ctx, 2, 2, line), *b = bezier(ctx, 2, 2, back), *m;
    ix_match_opts o = {
        .samples = 10, .length = 5, .order = 2, .norm = IX_MATCH_MORPH};

    (void)state;
    assert_int_equal(ix_match(ctx, a, b, &o, NULL, &m), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "negative"));
    o.length = 11;
    assert_int_equal(ix_match(ctx, a, a, &o, NULL, &m), IX_EARG);
    o.length = 5;
    o.order = 1;
    assert_int_equal(ix_match(ctx, a, a, &o, NULL, &m), IX_EARG);
    o.order = 2;
    o.samples = 5000;
    assert_int_equal(ix_match(ctx, a, a, &o, NULL, &m), IX_EARG);
    o.samples = 10;
    o.norm = (ix_match_norm)9;
    assert_int_equal(ix_match(ctx, a, a, &o, NULL, &m), IX_EARG);
    assert_null(m);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

static void setup(ix_ctx *ctx, void *state)
{
    ASSERT_OK(ctx, ix_pcircle(ctx, (double[]){0, 0, 0}, 1, (ix_mv **)state));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    const ix_match_opts o = {.samples = 8,
                             .length = 4,
                             .order = 2,
                             .rotate = true,
                             .norm = IX_MATCH_WALK};
    ix_mv **m = state;

    return ix_match(ctx, m[0], m[0], &o, NULL, &m[1]);
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;

    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
}

static void out_of_memory(void **state)
{
    ix_mv *m[2];
    const ix_fault_case c = {setup, run, drop, m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(copies_match),
        cmocka_unit_test(seams_are_found),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
