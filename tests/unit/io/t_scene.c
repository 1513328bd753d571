/* Scenes: sampled curves lie on them, hidden points are told, styles pass on.
 */
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "io/scene.h"

static ix_obj *read_text(ix_ctx *ctx, const char *text)
{
    ix_obj *o;

    ASSERT_OK(ctx, ix__itd_read(ctx, "test", text, strlen(text), &o));
    return o;
}

#define ARC                                                               \
    "[CURVE BEZIER 3 P2 [1 3 0] [0.70710678118654757 2.1213203435596424 " \
    "2.1213203435596424] [1 0 3]]"

/* A quarter circle of radius 3: every vertex has that radius, steps are small,
 * colour and width come from the list that holds it. */
static void arc(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, "[OBJECT [RGB \"255,0,0\"] [dwidth 4] L [OBJECT "
                               "A " ARC "] [OBJECT [color 1] B " ARC "]]");
    const ix_scene_opts opts = {.net = true, .knots = true};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_scene s;

    (void)state;
    ASSERT_OK(ctx, ix__scene_build(ctx, o, &opts, &s));
    assert_int_equal(s.npaths, 4); /* two arcs, two nets; no inner knots */
    assert_true(ix__scene_is_plane(&s));
    for (size_t i = 0; i < s.npaths; i++) {
        const ix_path *p = &s.path[i];

        if (p->kind != IX_PATH_LINE)
            continue;
        assert_true(p->n > 50);
        for (size_t k = 0; k < p->n; k++)
            ASSERT_CLOSE(hypot(s.pts[p->first + k][0], s.pts[p->first + k][1]),
                         3, 1e-14);
        ASSERT_CLOSE(p->width, 4, 0);
    }
    ASSERT_CLOSE(s.path[0].rgb[0], 1, 0);
    assert_true(s.path[2].rgb[2] > s.path[2].rgb[0]); /* its own blue */
    ASSERT_CLOSE(s.box[1], 3, 1e-15);
    ix__scratch_release(ctx, mk);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* A hyperbola's pole breaks the path; nothing infinite is in it. */
static void pole(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, "[OBJECT H [CURVE BEZIER 2 P1 [1 1] [-1 1]]]");
    const ix_scene_opts opts = {.net = false};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_scene s;

    (void)state;
    ASSERT_OK(ctx, ix__scene_build(ctx, o, &opts, &s));
    assert_int_equal(s.npaths, 2);
    for (size_t i = 0; i < s.npts; i++)
        assert_true(isfinite(s.pts[i][0]));
    ix__scratch_release(ctx, mk);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

static void hidden(void **state)
{
    const double p[3] = {10, 10, 5}, q[3] = {90, 10, 5}, r[3] = {10, 90, 5};
    const double rgb[3] = {1, 1, 1};
    const double behind[3] = {30, 30, 1}, before[3] = {30, 30, 9},
                 beside[3] = {80, 80, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mark mk = ix__scratch_mark(ctx);
    ix_raster b;

    (void)state;
    ASSERT_OK(ctx, ix__raster_new(ctx, 100, 100, &b));
    ix__raster_triangle(&b, p, q, r, rgb);
    assert_true(ix__raster_hides(&b, behind, 0.1));
    assert_false(ix__raster_hides(&b, before, 0.1));
    assert_false(ix__raster_hides(&b, beside, 0.1));
    ix__scratch_release(ctx, mk);
    ix_ctx_free(ctx);
}

/* Each named view is a rotation. */
static void views(void **state)
{
    const char *names[] = {"top",   "bottom", "front", "back",
                           "right", "left",   "iso"};
    double m[16];

    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        double det;

        assert_true(ix__view_named(names[i], m));
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) {
                double dot = 0;

                for (int k = 0; k < 3; k++)
                    dot += m[4 * a + k] * m[4 * b + k];
                ASSERT_CLOSE(dot, a == b, 1e-15);
            }
        det = m[0] * (m[5] * m[10] - m[6] * m[9]) -
              m[1] * (m[4] * m[10] - m[6] * m[8]) +
              m[2] * (m[4] * m[9] - m[5] * m[8]);
        ASSERT_CLOSE(det, 1, 1e-15);
    }
    assert_false(ix__view_named("up", m));
}

static void fault_setup(ix_ctx *ctx, void *state)
{
    *(ix_obj **)state = read_text(
        ctx, "[OBJECT S [SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 "
             "1]]]");
}

static ix_status fault_run(ix_ctx *ctx, void *state)
{
    const ix_scene_opts opts = {.net = true, .mesh = true};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_scene s;
    ix_status st = ix__scene_build(ctx, *(ix_obj **)state, &opts, &s);

    ix__scratch_release(ctx, mk);
    return st;
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    ix__obj_unref(ctx, *(ix_obj **)state);
}

static void out_of_memory(void **state)
{
    ix_obj *o = NULL;
    const ix_fault_case c = {fault_setup, fault_run, fault_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 5);
}

#define PLATE                                                                 \
    "[OBJECT P [TRIMSRF [SURFACE BEZIER 2 2 E3 [0 0 0][4 0 0][0 4 0][4 4 0]]" \
    "[TRIMCRV [TRIMCRVSEG [CURVE BSPLINE 5 2 E2 [KV 0 0 1 2 3 4 4]"           \
    "[0 0][1 0][1 1][0 1][0 0]]]][TRIMCRV [TRIMCRVSEG [CURVE BSPLINE 5 2 E2"  \
    "[KV 0 0 1 2 3 4 4][.3 .3][.7 .3][.7 .8][.3 .8][.3 .3]]]]]]"

/* A plate of 16 with a hole of 1.6 by 2: nothing is inside the hole, triangles
 * cover the rest, the lines of both loops are there. */
static void trimmed(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = read_text(ctx, PLATE);
    const ix_scene_opts opts = {.mesh = true};
    ix_mark mk = ix__scratch_mark(ctx);
    double area = 0;
    int loops = 0;
    ix_scene s;

    (void)state;
    ASSERT_OK(ctx, ix__scene_build(ctx, o, &opts, &s));
    for (size_t i = 0; i < s.npaths; i++) {
        const ix_path *p = &s.path[i];

        loops += p->kind == IX_PATH_LINE;
        for (size_t k = 0; k + 1 < p->n; k++) {
            const double *a = s.pts[p->first + k], *b = a + 3;
            double x = (a[0] + b[0]) / 2, y = (a[1] + b[1]) / 2;

            assert_false(x > 1.2001 && x < 2.7999 && y > 1.2001 && y < 3.1999);
        }
    }
    for (size_t i = 0; i < s.ntris; i++) {
        const double *a = s.pts[s.tri[i].v[0]], *b = s.pts[s.tri[i].v[1]];
        const double *c = s.pts[s.tri[i].v[2]];

        area += ((b[0] - a[0]) * (c[1] - a[1]) -
                 (b[1] - a[1]) * (c[0] - a[0])) /
                2;
    }
    assert_int_equal(loops, 2);
    ASSERT_CLOSE(area, 16 - 1.6 * 2, 1e-7);
    ix__scratch_release(ctx, mk);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arc),     cmocka_unit_test(pole),
        cmocka_unit_test(hidden),  cmocka_unit_test(views),
        cmocka_unit_test(trimmed), cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
