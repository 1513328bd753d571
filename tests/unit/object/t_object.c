/* Boxes: counting, reuse, copying, assignment, lists, names, memory. */
#include "object/object.h"

#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"

static bool same(ix_ctx *ctx, const ix_obj *a, const ix_obj *b)
{
    bool equal;

    if (a->type != b->type)
        return false;
    ASSERT_OK(ctx, ix__obj_equal(ctx, a, b, 0, &equal));
    return equal;
}

/* Law: a copy has the same type, value, name and attribute names; the list's
 * elements are the same boxes; changing the copy changes nothing else. */
static void test_copy(void **state)
{
    ix_rng r = ix_rng_new(11);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int t = IX_OBJ_UNDEF; t <= IX_OBJ_MULTIVAR; t++) {
        ix_obj *o = ix_rand_obj_of(ctx, &r, (ix_obj_type)t, 2);
        ix_obj *c = ix__obj_copy(ctx, o);
        const ix_attr *a = o->attrs, *b = c->attrs;

        assert_true(same(ctx, o, c));
        assert_int_equal(c->refs, 1);
        assert_true(!o->name == !c->name);
        if (o->name)
            assert_string_equal(o->name, c->name);
        for (; a && b; a = a->next, b = b->next)
            assert_string_equal(a->name, b->name);
        assert_true(!a && !b);
        if (t == IX_OBJ_LIST)
            assert_ptr_equal(o->u.list.item[0], c->u.list.item[0]);
        ix__obj_unref(ctx, o);
        ix__obj_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Law: assignment gives value and attributes, keeps the name and the box, so
 * that lists that hold it see the new value; from any type to any type. */
static void test_assign(void **state)
{
    ix_rng r = ix_rng_new(12);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 200; i++) {
        ix_obj *dst = ix_rand_obj(ctx, &r, 1), *src = ix_rand_obj(ctx, &r, 2);
        ix_obj *list = ix__obj_list(ctx);

        ASSERT_OK(ctx, ix__obj_append(ctx, list, dst));
        ASSERT_OK(ctx, ix__obj_set_name(ctx, dst, "mine"));
        ASSERT_OK(ctx, ix__obj_assign(ctx, dst, src));
        assert_true(same(ctx, list->u.list.item[0], src));
        assert_string_equal(dst->name, "MINE");
        assert_int_equal(dst->refs, 2);
        ASSERT_OK(ctx, ix__obj_assign(ctx, dst, dst));
        assert_true(same(ctx, dst, src));
        ix__obj_unref(ctx, src);
        ix__obj_unref(ctx, dst);
        ix__obj_unref(ctx, list);
    }
    ix_ctx_free(ctx);
}

/* l = element of l: the old list goes while its element is being read. */
static void test_assign_own_element(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *l = ix__obj_list(ctx), *s = ix__obj_string(ctx, "abc", 3);

    (void)state;
    ASSERT_OK(ctx, ix__obj_append(ctx, l, s));
    ix__obj_unref(ctx, s);
    ASSERT_OK(ctx, ix__obj_assign(ctx, l, l->u.list.item[0]));
    assert_int_equal(l->type, IX_OBJ_STRING);
    assert_string_equal(l->u.str.s, "abc");
    ix__obj_unref(ctx, l);
    ix_ctx_free(ctx);
}

/* Law: a moved value is the same whether it was shared or not. */
static void test_move(void **state)
{
    ix_rng r = ix_rng_new(13);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 100; i++) {
        ix_obj *dst = ix_rand_obj(ctx, &r, 1), *src = ix_rand_obj(ctx, &r, 1);
        ix_obj *copy = ix__obj_copy(ctx, src);

        if (i % 2)
            (void)ix__obj_ref(src);
        ASSERT_OK(ctx, ix__obj_move(ctx, dst, src));
        assert_true(same(ctx, dst, copy));
        if (i % 2)
            ix__obj_unref(ctx, src);
        ix__obj_unref(ctx, dst);
        ix__obj_unref(ctx, copy);
    }
    ix_ctx_free(ctx);
}

/* --- depth and reuse -------------------------------------------------- */

/* Lists and object attributes nested 100000 deep are released
 * and searched without the C stack. */
static void test_deep(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 1), *x = o, *other = ix__obj_undef(ctx);

    (void)state;
    for (int i = 0; i < 100000; i++) {
        ix_obj *l = ix__obj_list(ctx);

        if (i % 2)
            ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        else
            ASSERT_OK(ctx, ix__attr_set_obj(ctx, &l->attrs, "in", o));
        ix__obj_unref(ctx, o);
        o = l;
    }
    assert_true(ix__obj_contains(o, x));
    assert_false(ix__obj_contains(o, other));
    ix__obj_unref(ctx, o);
    ix__obj_unref(ctx, other);
    ix_ctx_free(ctx);
}

/* 2^60 paths lead to x; each box is looked at once. */
static void test_contains_shared(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *x = ix__obj_number(ctx, 1), *o = ix__obj_ref(x);
    ix_obj *other = ix__obj_number(ctx, 1);

    (void)state;
    assert_true(ix__obj_contains(x, x));
    for (int i = 0; i < 60; i++) {
        ix_obj *l = ix__obj_list(ctx);

        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
        o = l;
        assert_true(ix__obj_contains(o, x));
        assert_false(ix__obj_contains(o, other));
    }
    ix__obj_unref(ctx, o);
    ix__obj_unref(ctx, x);
    ix__obj_unref(ctx, other);
    ix_ctx_free(ctx);
}

/* A number made where one was dropped costs no allocation (but in the build
 * that hunts for use after release). */
static void test_reuse(void **state)
{
    ix_fault f = {.fail_at = -1};
    ix_ctx *ctx = ix_ctx_new(ix_fault_alloc, &f);
    long calls;

    (void)state;
    ix__obj_unref(ctx, ix__obj_number(ctx, 1));
    calls = f.calls;
    for (int i = 0; i < 1000; i++) {
        ix_obj *o = ix__obj_number(ctx, i);

        assert_true(o->u.num == i);
        assert_null(o->name);
        assert_null(o->attrs);
        ix__obj_unref(ctx, o);
    }
#ifdef IX_HARDTEST
    assert_int_equal(f.calls, calls + 1000);
#else
    assert_int_equal(f.calls, calls);
#endif
    ix_ctx_free(ctx);
    assert_int_equal(f.live, 0);
}

/* --- names, types ----------------------------------------------------- */

static void test_names(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_number(ctx, 1);

    (void)state;
    ASSERT_OK(ctx, ix__obj_set_name(ctx, o, "aBc_1"));
    assert_string_equal(o->name, "ABC_1");
    ASSERT_OK(ctx, ix__obj_set_name(ctx, o, "none"));
    assert_null(o->name);
    ASSERT_OK(ctx, ix__obj_set_name(ctx, o, ""));
    assert_null(o->name);
    ASSERT_OK(ctx, ix__obj_set_name(ctx, o, NULL));
    assert_null(o->name);
    ix__obj_unref(ctx, o);
    assert_string_equal(ix__obj_type_name(IX_OBJ_NUMBER), "Numeric");
    assert_string_equal(ix__obj_type_name(IX_OBJ_LIST), "Object List");
    assert_string_equal(ix__obj_type_name(IX_OBJ_TRISRF), "Triangular Surface");
    assert_string_equal(ix__obj_type_name(IX_OBJ_MULTIVAR), "Multivariate");
    assert_string_equal(ix__obj_type_name((ix_obj_type)99), "?");
    ix_ctx_free(ctx);
}

static void test_freeforms(void **state)
{
    static const ix_obj_type types[] = {IX_OBJ_CURVE, IX_OBJ_SURFACE,
                                        IX_OBJ_TRIVAR, IX_OBJ_MULTIVAR};
    ix_rng r = ix_rng_new(14);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int d = 1; d <= 4; d++) {
        ix_mv *m = ix_rand_mv(ctx, &r, d);
        ix_obj *o;

        assert_int_equal(ix__obj_type_of_mv(m), types[d - 1]);
        o = ix__obj_mv(ctx, types[d - 1], m);
        assert_true(ix__obj_is_freeform(o));
        assert_ptr_equal(ix__obj_first_mv(o), m);
        assert_int_equal(ix__seq_count(o), 1);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* Newell's plane: of a square far from the origin; none of a line. */
static void test_polygon_plane(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_poly *p = ix__poly_new(ctx, 1);
    double plane[4];

    (void)state;
    ASSERT_OK(ctx, ix__poly_vertices(ctx, p->poly, 4));
    for (int i = 0; i < 4; i++) {
        p->poly->v[i].p[0] = 1e6 + (i == 1 || i == 2);
        p->poly->v[i].p[1] = i > 1;
        p->poly->v[i].p[2] = 5;
    }
    assert_true(ix__polygon_plane(p->poly, plane));
    assert_true(plane[0] == 0 && plane[1] == 0 && plane[2] == 1);
    ASSERT_CLOSE(plane[3], -5, 1e-15);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            p->poly->v[i].p[k] = 0.1 * i * (k + 1);
    assert_false(ix__polygon_plane(p->poly, plane));
    ix__poly_unref(ctx, p);
    ix_ctx_free(ctx);
}

/* --- memory ----------------------------------------------------------- */

typedef struct {
    ix_obj_type type;
    ix_obj *src, *dst, *copy;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(20 + (uint64_t)s->type);

    s->src = ix_rand_obj_of(ctx, &r, s->type, 2);
    s->dst = ix_rand_obj_of(ctx, &r, IX_OBJ_STRING, 1);
    s->copy = NULL;
    assert_non_null(s->src);
    assert_non_null(s->dst);
    ASSERT_OK(ctx,
              ix__attr_set_string(ctx, &s->src->attrs, "more", "attributes"));
}

static ix_status fault_copy(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    s->copy = ix__obj_copy(ctx, s->src);
    return s->copy ? IX_OK : IX_ENOMEM;
}

/* On failure the old value is there. */
static ix_status fault_assign(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_status st = ix__obj_assign(ctx, s->dst, s->src);

    assert_int_equal(s->dst->type, st == IX_OK ? s->type : IX_OBJ_STRING);
    return st;
}

static ix_status fault_append(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    s->copy = ix__obj_list(ctx);
    if (!s->copy)
        return IX_ENOMEM;
    for (int i = 0; i < 20; i++)
        IX_TRY(ix__obj_append(ctx, s->copy, s->src));
    return ix__obj_set_name(ctx, s->copy, "name");
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix__obj_unref(ctx, s->src);
    ix__obj_unref(ctx, s->dst);
    ix__obj_unref(ctx, s->copy);
}

static void test_faults(void **state)
{
    (void)state;
    for (int t = IX_OBJ_UNDEF; t <= IX_OBJ_MULTIVAR; t++) {
        fault_state s = {.type = (ix_obj_type)t};
        ix_fault_case c = {fault_setup, fault_copy, fault_teardown, &s};

        assert_true(ix_fault_run(&c) > 0);
        c.run = fault_assign;
        assert_true(ix_fault_run(&c) > 0);
        c.run = fault_append;
        assert_true(ix_fault_run(&c) > 0);
    }
}

static void fault_make_setup(ix_ctx *ctx, void *state)
{
    (void)ctx;
    ((fault_state *)state)->copy = NULL;
}

static ix_status fault_make(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(40 + (uint64_t)s->type);

    s->src = s->dst = NULL;
    s->copy = ix_rand_obj_of(ctx, &r, s->type, 2);
    return s->copy ? IX_OK : IX_ENOMEM;
}

static void test_make_faults(void **state)
{
    (void)state;
    for (int t = IX_OBJ_UNDEF; t <= IX_OBJ_MULTIVAR; t++) {
        fault_state s = {.type = (ix_obj_type)t};
        ix_fault_case c = {fault_make_setup, fault_make, fault_teardown, &s};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_copy),
        cmocka_unit_test(test_assign),
        cmocka_unit_test(test_assign_own_element),
        cmocka_unit_test(test_move),
        cmocka_unit_test(test_deep),
        cmocka_unit_test(test_contains_shared),
        cmocka_unit_test(test_reuse),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_freeforms),
        cmocka_unit_test(test_polygon_plane),
        cmocka_unit_test(test_faults),
        cmocka_unit_test(test_make_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
