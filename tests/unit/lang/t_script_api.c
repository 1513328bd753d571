/* The public face of scripts and files: variables go in and out, errors come
 * back as a status, files by their suffix. */
#define _POSIX_C_SOURCE 200809L
#include <string.h>
#include <unistd.h>

#include "harness/test.h"
#include "iritx/file.h"
#include "iritx/script.h"

static void test_variables(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *two = ix_obj_number(ctx, 2);
    ix_script *s;

    (void)state;
    ASSERT_OK(ctx, ix_script_new(ctx, &s));
    ASSERT_OK(ctx, ix_script_set(s, "two", two));
    ASSERT_OK(ctx, ix_script_run(s, "t", "x = two * 21; two = 3;"));
    assert_true(ix_obj_num(ix_script_get(s, "X")) == 42);
    assert_true(ix_obj_num(two) == 2); /* the script has a copy */
    ASSERT_OK(ctx, ix_script_run(s, "t", "x = x + two;"));
    assert_true(ix_obj_num(ix_script_get(s, "x")) == 45);
    assert_null(ix_script_get(s, "nothing"));
    ix_script_free(s);
    ix_script_free(NULL);
    ix_obj_unref(ctx, two);
    ix_ctx_free(ctx);
}

static void test_safe(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    int saved = dup(2), null;
    ix_script *s;

    (void)state;
    ASSERT_OK(ctx, ix_script_new(ctx, &s));
    null = dup2(saved, 2) == 2 ? close(2) : -1; /* messages are not wanted */
    assert_int_not_equal(ix_script_run(s, "t", "system(\"true\");"), IX_OK);
    assert_int_not_equal(ix_script_run(s, "t", "loadext(\"x.so\");"), IX_OK);
    assert_int_not_equal(ix_script_run(s, "t", "evolute(1);"), IX_OK);
    assert_int_not_equal(ix_script_run_file(s, "nowhere.irt"), IX_OK);
    assert_int_equal(null, 0);
    assert_int_equal(dup2(saved, 2), 2);
    (void)close(saved);
    ix_script_free(s);
    ix_ctx_free(ctx);
}

static void test_files(void **state)
{
    const char *const names[] = {"build/t_api.itd", "build/t_api.ibd.gz",
                                 "build/t_api.xml"};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *n = ix_obj_number(ctx, 0.1), *o;

    (void)state;
    for (int i = 0; i < 3; i++) {
        ASSERT_OK(ctx, ix_save(ctx, names[i], n, 0));
        ASSERT_OK(ctx, ix_load(ctx, names[i], &o));
        assert_true(ix_obj_num(o) == 0.1);
        ix_obj_unref(ctx, o);
        (void)unlink(names[i]);
    }
    assert_int_equal(ix_load(ctx, "build/nowhere.itd", &o), IX_EIO);
    assert_null(o);
    assert_int_equal(ix_save(ctx, "build/a.nc", n, 0), IX_EARG);
    ix_obj_unref(ctx, n);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_variables),
        cmocka_unit_test(test_safe),
        cmocka_unit_test(test_files),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
