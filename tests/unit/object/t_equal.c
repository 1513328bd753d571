/* Equality: reflexive, follows the value, takes eps, works on shared lists. */
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/io.h"

static bool equal(ix_ctx *ctx, const ix_obj *a, const ix_obj *b, double eps)
{
    bool yes;

    ASSERT_OK(ctx, ix__obj_equal(ctx, a, b, eps, &yes));
    return yes;
}

/* A second object from the same text, all its boxes and geometry new. */
static ix_obj *twin(ix_ctx *ctx, const ix_obj *o)
{
    const ix_write_opts file = {.file = true};
    ix_obj *t;
    ix_buf b;

    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, ix__itd_write(&b, o, &file, 0));
    ASSERT_OK(ctx, ix__itd_read(ctx, "twin", b.data, b.len, &t));
    ix__buf_free(&b);
    return t;
}

/* Law: o = o, o = its twin; names and attributes do not count. Two random
 * objects of one type differ, in practice always. */
static void test_laws(void **state)
{
    ix_rng r = ix_rng_new(61);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    int differ = 0;

    (void)state;
    for (int i = 0; i < 300; i++) {
        ix_obj *o = ix_rand_obj(ctx, &r, 2), *t = twin(ctx, o);
        ix_obj *other = ix_rand_obj_of(ctx, &r, o->type, 2);

        assert_true(equal(ctx, o, o, 0));
        assert_true(equal(ctx, o, t, 0));
        ASSERT_OK(ctx, ix__obj_set_name(ctx, t, "other"));
        ix__attr_free_all(ctx, &t->attrs);
        assert_true(equal(ctx, t, o, 0));
        differ += !equal(ctx, o, other, 0);
        ix__obj_unref(ctx, o);
        ix__obj_unref(ctx, t);
        ix__obj_unref(ctx, other);
    }
    assert_true(differ > 270);
    ix_ctx_free(ctx);
}

static void test_eps(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *a = ix__obj_number(ctx, 1), *b = ix__obj_number(ctx, 1 + 0x1p-10);
    ix_obj *p = ix__obj_plane(ctx, (double[]){1, 2, 3, 4});
    ix_obj *q = ix__obj_plane(ctx, (double[]){-1, -2, -3, -4});
    ix_obj *n = ix__obj_number(ctx, (double)NAN),
           *m = ix__obj_number(ctx, (double)NAN);

    (void)state;
    assert_false(equal(ctx, a, b, 0x1p-10)); /* must be closer than eps */
    assert_true(equal(ctx, a, b, 0x1.1p-10));
    assert_true(equal(ctx, p, q, 0));
    assert_false(equal(ctx, n, m, 1));
    assert_int_equal(ix__obj_equal(ctx, a, p, 0, &(bool){0}), IX_EARG);
    assert_non_null(
        strstr(ix_ctx_message(ctx), "Numeric cannot be compared with Plane"));
    ix__obj_unref(ctx, a);
    ix__obj_unref(ctx, b);
    ix__obj_unref(ctx, p);
    ix__obj_unref(ctx, q);
    ix__obj_unref(ctx, n);
    ix__obj_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Lists count over the length of the left one. */
static void test_list_length(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *a = ix__obj_list(ctx), *b = ix__obj_list(ctx);
    ix_obj *n = ix__obj_number(ctx, 1), *s = ix__obj_string(ctx, "1", 1);

    (void)state;
    ASSERT_OK(ctx, ix__obj_append(ctx, b, n));
    assert_true(equal(ctx, a, b, 0));
    assert_false(equal(ctx, b, a, 0));
    ASSERT_OK(ctx, ix__obj_append(ctx, a, s));
    assert_false(equal(ctx, a, b, 0)); /* elements of different types */
    ix__obj_unref(ctx, a);
    ix__obj_unref(ctx, b);
    ix__obj_unref(ctx, n);
    ix__obj_unref(ctx, s);
    ix_ctx_free(ctx);
}

static ix_obj *doubled(ix_ctx *ctx, double v, int levels)
{
    ix_obj *o = ix__obj_number(ctx, v);

    for (int i = 0; i < levels; i++) {
        ix_obj *l = ix__obj_list(ctx);

        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
        o = l;
    }
    return o;
}

/* Two objects of 2^200 paths each; cycles end as well. */
static void test_shared(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *a = doubled(ctx, 1, 200), *b = doubled(ctx, 1, 200);
    ix_obj *c = doubled(ctx, 2, 200), *l = ix__obj_list(ctx);
    ix_obj *m = ix__obj_list(ctx);

    (void)state;
    assert_true(equal(ctx, a, b, 0));
    assert_false(equal(ctx, a, c, 0));
    ix__obj_unref(ctx, a);
    ix__obj_unref(ctx, b);
    ix__obj_unref(ctx, c);
    ASSERT_OK(ctx, ix__obj_append(ctx, l, l));
    ASSERT_OK(ctx, ix__obj_append(ctx, m, m));
    assert_true(equal(ctx, l, m, 0));
    l->u.list.n = m->u.list.n = 0; /* cut the cycles */
    l->refs = m->refs = 1;
    ix__obj_unref(ctx, l);
    ix__obj_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* --- memory ----------------------------------------------------------- */

static void setup(ix_ctx *ctx, void *state)
{
    ix_obj **o = state;

    o[0] = doubled(ctx, 1, 200);
    o[1] = doubled(ctx, 1, 200);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    ix_obj **o = state;
    bool yes = false;
    ix_status st = ix__obj_equal(ctx, o[0], o[1], 0, &yes);

    assert_true(st != IX_OK || yes);
    return st;
}

static void teardown(ix_ctx *ctx, void *state)
{
    ix_obj **o = state;

    ix__obj_unref(ctx, o[0]);
    ix__obj_unref(ctx, o[1]);
}

static void test_faults(void **state)
{
    ix_obj *o[2];
    ix_fault_case c = {setup, run, teardown, o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_laws), cmocka_unit_test(test_eps),
        cmocka_unit_test(test_list_length), cmocka_unit_test(test_shared),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
