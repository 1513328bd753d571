/* Making multivariates: what is refused, with which words; what is read back.
 */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(1)

/* A curve in one coordinate with points 1, 2, 3, ..., expected to be refused
 * with a message that holds the given words. */
static void refused(const ix_dir *dir, const char *words)
{
    double pts[16];
    ix_mv *m = (ix_mv *)pts;

    for (int i = 0; i < 16; i++)
        pts[i] = i + 1;
    assert_int_equal(ix_mv_new(ctx, 1, dir, 1, false, pts, &m), IX_EARG);
    assert_null(m);
    if (!strstr(ix_ctx_message(ctx), words))
        fail_msg("\"%s\" is not in \"%s\"", words, ix_ctx_message(ctx));
}

#define CURVE(o, n, ...) \
    (&(ix_dir){IX_BSPLINE, (o), (n), false, (const double[]){__VA_ARGS__}})

static void bad_directions(void **state)
{
    (void)state;
    refused(&(ix_dir){IX_BEZIER, 0, 0, false, NULL}, "order 0");
    refused(&(ix_dir){IX_BEZIER, 1025, 1025, false, NULL}, "order 1025");
    refused(&(ix_dir){IX_BEZIER, 3, 4, false, NULL}, "4 points");
    refused(&(ix_dir){IX_POWER, 3, 3, true, NULL}, "periodic");
    refused(CURVE(3, 2, 0, 0, 0, 1, 1), "2 points for order 3");
    refused(CURVE(3, 3, 0, 0, 0, (double)NAN, 1, 1), "knot 3 is nan");
    refused(CURVE(3, 3, 0, 0, 0, 1, 1, HUGE_VAL), "knot 5 is inf");
    refused(CURVE(3, 4, 0, 0, 0, 2, 1, 3, 3), "knot 4 = 1 is below knot 3 = 2");
    refused(CURVE(2, 6, 0, 0, 1, 1, 1, 2, 3, 3), "knot 4 = 1 occurs more");
    refused(CURVE(2, 3, 0, 0, 0, 1, 1), "knot 2 = 0 occurs more");
    refused(CURVE(2, 2, -1, 1, 1, 2), "no usable length");
    refused(CURVE(2, 2, -1, -1e308, 1.7e308, 1.7e308), "below");
}

static void bad_shapes(void **state)
{
    const ix_dir dir = {IX_BEZIER, 2, 2, false, NULL};
    ix_dir many[16];
    const double pts[40] = {0};
    const double nan_pts[] = {0, (double)NAN}, flat[] = {0, 0, 1, 1};
    const double none[] = {0, 1, 0, 1};
    ix_mv *m;

    (void)state;
    for (int i = 0; i < 16; i++)
        many[i] = (ix_dir){IX_BEZIER, 1024, 1024, false, NULL};
    assert_int_equal(ix_mv_new(ctx, 0, &dir, 1, false, pts, &m), IX_EARG);
    assert_int_equal(ix_mv_new(ctx, 17, many, 1, false, pts, &m), IX_EARG);
    assert_int_equal(ix_mv_new(ctx, 16, many, 1, false, pts, &m), IX_EARG);
    assert_int_equal(ix_mv_new(ctx, 1, &dir, 0, false, pts, &m), IX_EARG);
    assert_int_equal(ix_mv_new(ctx, 1, &dir, 19, false, pts, &m), IX_EARG);
    assert_int_equal(ix_mv_new(ctx, 1, &dir, 1, false, nan_pts, &m), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "point 1"));
    assert_int_equal(ix_mv_new(ctx, 1, &dir, 1, true, flat, &m), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "weights are zero"));
    assert_int_equal(ix_mv_new(ctx, 1, &dir, 1, true, none, &m), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "point 0"));
}

static void near_knots_become_equal(void **state)
{
    const double e = 2 * 0x1p-52;
    const double knots[] = {0, 0.1 + 0.2 - 0.3, 0, 1, 1 + e, 2, 2, 2 - e};
    const double pts[] = {1, 2, 3, 4, 5};
    ix_dir dir = {IX_BSPLINE, 3, 5, false, knots};
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    dir = ix_mv_dir(m, 0);
    assert_true(dir.knots[1] == 0 && dir.knots[2] == 0);
    assert_true(dir.knots[4] == dir.knots[3] && dir.knots[7] == dir.knots[5]);
    ix_mv_unref(ctx, m);
}

static void reads_back(void **state)
{
    const double knots[] = {0, 0, 1, 2, 2};
    const ix_dir dirs[] = {{IX_BSPLINE, 2, 3, false, knots},
                           {IX_BEZIER, 2, 2, false, NULL}};
    double pts[18], dom[2];
    ix_mv *m;

    (void)state;
    for (int i = 0; i < 18; i++)
        pts[i] = i + 1;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 2, true, pts, &m));
    assert_int_equal(ix_mv_ndirs(m), 2);
    assert_int_equal(ix_mv_order(m, 0), 2);
    assert_int_equal(ix_mv_length(m, 0), 3);
    assert_int_equal(ix_mv_nknots(m, 0), 5);
    assert_int_equal(ix_mv_nknots(m, 1), 0);
    assert_int_equal(ix_mv_ncoords(m), 2);
    assert_int_equal(ix_mv_naxes(m), 3);
    assert_int_equal(ix_mv_npts(m), 6);
    assert_true(ix_mv_rational(m));
    assert_true(ix_mv_weights(m) == ix_mv_axis(m, 0));
    assert_true(ix_mv_coord(m, 1) == ix_mv_axis(m, 2));
    assert_true(ix_mv_coord(m, 1)[5] == 18);
    assert_int_equal((uintptr_t)ix_mv_axis(m, 0) % 64, 0);
    ix_mv_domain(m, 0, dom);
    assert_true(dom[0] == 0 && dom[1] == 2);
    ix_mv_domain(m, 1, dom);
    assert_true(dom[0] == 0 && dom[1] == 1);
    assert_true(ix_mv_ref(m) == m);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, NULL);
}

static ix_status make(ix_ctx *c, void *state)
{
    const ix_dir dir = {IX_BEZIER, 2, 2, false, NULL};
    const double pts[] = {1, 2};

    return ix_mv_new(c, 1, &dir, 1, false, pts, state);
}

static void drop(ix_ctx *c, void *state)
{
    ix_mv_unref(c, *(ix_mv **)state);
}

static void out_of_memory(void **state)
{
    ix_mv *m = NULL;

    (void)state;
    assert_int_equal(ix_fault_run(&(ix_fault_case){
                         .run = make, .teardown = drop, .state = &m}),
                     1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_directions),          cmocka_unit_test(bad_shapes),
        cmocka_unit_test(near_knots_become_equal), cmocka_unit_test(reads_back),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
