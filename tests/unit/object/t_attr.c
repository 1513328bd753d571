/* Attributes: order, replacement, case, what is copied, memory. */
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "object/object.h"

static void expect_names(const ix_attr *a, const char *expected)
{
    char names[200] = "";

    for (; a; a = a->next) {
        strcat(names, a->name);
        strcat(names, " ");
    }
    assert_string_equal(names, expected);
}

static void test_order(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_attr *a = NULL;

    (void)state;
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &a, "Count", 5));
    ASSERT_OK(ctx, ix__attr_set_real(ctx, &a, "len", 2.5));
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &a, "s", "x"));
    expect_names(a, "s len Count ");
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &a, "LEN", "new"));
    expect_names(a, "s len Count "); /* in place, first spelling */
    assert_int_equal(ix__attr_find(a, "Len")->type, IX_ATTR_STRING);
    assert_string_equal(ix__attr_find(a, "Len")->s, "new");
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &a, "s", 1));
    assert_null(ix__attr_find(a, "s")->s);
    ix__attr_first_to_last(&a);
    expect_names(a, "len Count s ");
    ix__attr_remove(ctx, &a, "COUNT");
    ix__attr_remove(ctx, &a, "absent");
    expect_names(a, "len s ");
    ix__attr_free_all(ctx, &a);
    assert_null(a);
    ix__attr_first_to_last(&a);
    assert_null(ix__attr_find(a, "len"));
    ix_ctx_free(ctx);
}

/* The value may come from the attribute that it replaces. */
static void test_own_value(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 1);
    ix_attr *a = NULL;

    (void)state;
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &a, "s", "abc"));
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &a, a->name, a->s + 1));
    assert_string_equal(a->s, "bc");
    ASSERT_OK(ctx, ix__attr_set_obj(ctx, &a, "s", o));
    ix__obj_unref(ctx, o);
    ASSERT_OK(ctx, ix__attr_set_obj(ctx, &a, "s", a->obj));
    assert_int_equal(a->obj->refs, 1);
    ix__attr_free_all(ctx, &a);
    ix_ctx_free(ctx);
}

static void test_copy(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_attr *a = NULL, *b = NULL;

    (void)state;
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &a, "x", 1));
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &a, "_hidden", 2));
    ASSERT_OK(ctx, ix__attr_set_real(ctx, &a, "y", 3));
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &b, "old", 4));
    ASSERT_OK(ctx, ix__attr_copy_all(ctx, a, &b));
    expect_names(b, "y x ");
    assert_true(b->r == 3);
    ix__attr_free_all(ctx, &a);
    ix__attr_free_all(ctx, &b);
    ix_ctx_free(ctx);
}

static void test_names(void **state)
{
    (void)state;
    assert_int_equal(ix__name_cmp("GeomType", "geomtype"), 0);
    assert_true(ix__name_cmp("a", "B") < 0 && ix__name_cmp("ab", "A") > 0);
    assert_true(ix__name_cmp("", "a") < 0);
    /* only ASCII has cases: no locale turns one of these into the other */
    assert_true(ix__name_cmp("\xc3\xa9", "\xc3\x89") != 0);
}

/* --- memory ----------------------------------------------------------- */

typedef struct {
    ix_attr *a, *b;
    ix_obj *o;
} fault_state;

static void setup(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    *s = (fault_state){.o = ix__obj_number(ctx, 1)};
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &s->b, "old", 4));
}

static ix_status run(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_status st;

    IX_TRY(ix__attr_set_int(ctx, &s->a, "i", 1));
    IX_TRY(ix__attr_set_real(ctx, &s->a, "r", 1));
    IX_TRY(ix__attr_set_obj(ctx, &s->a, "o", s->o));
    st = ix__attr_set_string(ctx, &s->a, "i", "replaces");
    assert_int_equal(ix__attr_find(s->a, "i")->type,
                     st == IX_OK ? IX_ATTR_STRING : IX_ATTR_INT);
    IX_TRY(st);
    st = ix__attr_copy_all(ctx, s->a, &s->b);
    expect_names(s->b, st == IX_OK ? "o r i " : "old ");
    return st;
}

static void teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix__attr_free_all(ctx, &s->a);
    ix__attr_free_all(ctx, &s->b);
    assert_int_equal(s->o->refs, 1);
    ix__obj_unref(ctx, s->o);
}

static void test_faults(void **state)
{
    fault_state s;
    ix_fault_case c = {setup, run, teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_order), cmocka_unit_test(test_own_value),
        cmocka_unit_test(test_copy), cmocka_unit_test(test_names),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
