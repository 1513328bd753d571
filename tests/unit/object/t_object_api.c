/* The public face of objects: what is put in comes out; wrong types are told.
 */
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/object.h"

static ix_mv *segment(ix_ctx *ctx)
{
    const ix_dir line = {.basis = IX_BEZIER, .order = 2, .length = 2};
    const double pts[2] = {0, 1};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &line, 1, false, pts, &m));
    return m;
}

static void test_values(void **state)
{
    const double p[3] = {1, 2, 3};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *list = ix_obj_list(ctx);
    double xyz[3];

    (void)state;
    ASSERT_OK(ctx, ix_obj_list_add(ctx, list, ix_obj_number(ctx, 7)));
    ASSERT_OK(ctx, ix_obj_list_add(ctx, list, ix_obj_string(ctx, "text")));
    ASSERT_OK(ctx, ix_obj_list_add(ctx, list, ix_obj_point(ctx, p)));
    ASSERT_OK(ctx, ix_obj_list_add(ctx, list, ix_obj_vector(ctx, p)));
    ASSERT_OK(ctx,
              ix_obj_list_add(ctx, list, ix_obj_freeform(ctx, segment(ctx))));
    assert_int_equal(ix_obj_list_size(list), 5);
    assert_true(ix_obj_num(ix_obj_list_item(list, 0)) == 7);
    assert_string_equal(ix_obj_str(ix_obj_list_item(list, 1)), "text");
    assert_true(ix_obj_xyz(ix_obj_list_item(list, 2), xyz) && xyz[2] == 3);
    assert_true(ix_obj_xyz(ix_obj_list_item(list, 3), xyz) && xyz[0] == 1);
    assert_int_equal(ix_obj_type_of(ix_obj_list_item(list, 4)), IX_OBJ_CURVE);
    assert_int_equal(ix_obj_mv_count(ix_obj_list_item(list, 4)), 1);
    assert_int_equal(ix_mv_ndirs(ix_obj_mv(ix_obj_list_item(list, 4), 0)), 1);
    ASSERT_OK(ctx, ix_obj_set_name(ctx, list, "all"));
    assert_string_equal(ix_obj_name(list), "ALL");
    ASSERT_OK(ctx, ix_obj_set_attr(ctx, list, "rgb", "1,2,3"));
    ix_obj_unref(ctx, list);
    ix_ctx_free(ctx);
}

static void test_other_types(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *list = ix_obj_list(ctx), *n = ix_obj_number(ctx, 1);
    double xyz[3];

    (void)state;
    assert_true(isnan(ix_obj_num(list)));
    assert_null(ix_obj_str(n));
    assert_false(ix_obj_xyz(n, xyz));
    assert_int_equal(ix_obj_list_size(n), 0);
    assert_null(ix_obj_list_item(list, 0));
    assert_null(ix_obj_list_item(list, -1));
    assert_null(ix_obj_mv(n, 0));
    assert_string_equal(ix_obj_name(n), "");
    assert_int_equal(ix_obj_list_add(ctx, n, ix_obj_number(ctx, 2)), IX_EARG);
    assert_int_equal(ix_obj_list_add(ctx, list, NULL), IX_ENOMEM);
    assert_int_equal(ix_obj_list_add(ctx, list, ix_obj_ref(list)), IX_EARG);
    ix_obj_unref(ctx, n);
    ix_obj_unref(ctx, list);
    ix_ctx_free(ctx);
}

static void no_setup(ix_ctx *ctx, void *state)
{
    (void)ctx, (void)state;
}

static ix_status make(ix_ctx *ctx, void *state)
{
    ix_obj *list = ix_obj_list(ctx);
    ix_status st = ix_obj_list_add(ctx, list, ix_obj_string(ctx, "a"));

    (void)state;
    if (st == IX_OK)
        st = ix_obj_set_name(ctx, list, "N");
    if (st == IX_OK)
        st = ix_obj_set_attr(ctx, list, "a", "b");
    ix_obj_unref(ctx, list);
    return st;
}

static void test_faults(void **state)
{
    const ix_fault_case c = {no_setup, make, no_setup, NULL};

    (void)state;
    assert_true(ix_fault_run(&c) > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_other_types),
        cmocka_unit_test(test_faults),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
