/* t_font.c - the font against its own symmetries: letters that are half turns
 * of themselves or of each other; every stroke inside its box. */
#include "geom/font.h"

#include <string.h>

#include "geomtest.h"

static ix_crvs glyph(gt *t, int ch)
{
    ix_crvs g;

    ASSERT_OK(t->ctx, ix__glyph(t->ctx, ch, &g));
    return g;
}

/* Is there a stroke of g, either way, at the points that c turned has? */
static bool has_turned(gt *t, const ix_crvs *g, const ix_mv *c, double w,
                       double h)
{
    for (int i = 0; i < g->n; i++)
        for (int rev = 0; rev < 2; rev++) {
            bool same = true;

            for (int k = 0; same && k <= 8; k++) {
                double p[IX_MAX_COORDS], q[IX_MAX_COORDS], u = k / 8.0;
                double v = rev ? 1 - u : u;

                gt_point(t, c, &u, p);
                gt_point(t, g->crv[i], &v, q);
                same = fabs(w - p[0] - q[0]) < TOL &&
                       fabs(h - p[1] - q[1]) < TOL;
            }
            if (same)
                return true;
        }
    return false;
}

/* The half turn about (w/2, h/2) takes glyph a to glyph b. */
static void turns_into(gt *t, int a, int b, double h)
{
    ix_crvs ga = glyph(t, a), gb = glyph(t, b);
    double w = ix__glyph_width(a);

    assert_int_equal(ga.n, gb.n);
    for (int i = 0; i < ga.n; i++)
        if (!has_turned(t, &gb, ga.crv[i], w, h))
            fail_msg("stroke %d of %c", i, a);
    ix_crvs_free(t->ctx, &ga);
    ix_crvs_free(t->ctx, &gb);
}

static void test_half_turns(void **state)
{
    static const char self[] = "HNXZ", pair[] = "69", small[] = "bqdpnu";
    gt t = gt_begin(1);

    (void)state;
    for (const char *s = self; *s; s++)
        turns_into(&t, *s, *s, 1);
    turns_into(&t, 'S', 'S', 1);
    turns_into(&t, 'I', 'I', 1);
    turns_into(&t, pair[0], pair[1], 1);
    for (int i = 0; i < 4; i += 2)
        turns_into(&t, small[i], small[i + 1], 2.0 / 3);
    turns_into(&t, 'n', 'u', 2.0 / 3);
    gt_end(&t);
}

/* Law: inside [0, width] x [-1/3, 7/6], touching x = 0 and x = width; capitals
 * and digits reach from 0 to 1. */
static void test_boxes(void **state)
{
    gt t = gt_begin(2);

    (void)state;
    for (int ch = 33; ch < 127; ch++) {
        double box[4] = {9, -9, 9, -9};
        ix_crvs g = glyph(&t, ch);
        bool capital = (ch >= 'A' && ch <= 'Z') || (ch >= '0' && ch <= '9');

        assert_true(g.n > 0);
        for (int i = 0; i < g.n; i++) {
            double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

            ASSERT_OK(t.ctx, ix_mv_bbox(t.ctx, g.crv[i], lo, hi));
            box[0] = fmin(box[0], lo[0]);
            box[1] = fmax(box[1], hi[0]);
            box[2] = fmin(box[2], lo[1]);
            box[3] = fmax(box[3], hi[1]);
        }
        ASSERT_CLOSE(box[0], 0, TOL);
        ASSERT_CLOSE(box[1], ix__glyph_width(ch), TOL);
        assert_true(box[2] >= -IX__FONT_DEPTH - TOL && box[3] <= 7.0 / 6 + TOL);
        if (capital) {
            ASSERT_CLOSE(box[2], 0, TOL);
            ASSERT_CLOSE(box[3], 1, TOL);
        }
        ix_crvs_free(t.ctx, &g);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(3);
    ix_crvs g = glyph(&t, ' ');

    (void)state;
    assert_int_equal(g.n, 0);
    ix_crvs_free(t.ctx, &g);
    assert_int_equal(ix__glyph(t.ctx, 31, &g), IX_EARG);
    assert_int_equal(ix__glyph(t.ctx, 127, &g), IX_EARG);
    ASSERT_CLOSE(ix__glyph_width(127), -1, 0);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    (void)ctx;
    (void)f;
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_crvs g;

    (void)f;
    IX_TRY(ix__glyph(ctx, 'B', &g));
    *out = ix_mv_ref(g.crv[0]);
    ix_crvs_free(ctx, &g);
    return IX_OK;
}

static void test_memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_half_turns),
        cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
