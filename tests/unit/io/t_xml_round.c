#define _POSIX_C_SOURCE 200809L
/* XML files: what is written reads back the same, for random objects, for the
 * sample files and for what text files cannot hold; every allocation may fail.
 * libxml2's own memory is not the context's: its failures are provoked apart.
 */
#include <libxml/parser.h>
#include <stdlib.h>
#include <string.h>

#include "harness/rand_obj.h"
#include "harness/round.h"

static const ix_codec codec = {ix__xml_write, ix__xml_read};

static void test_random(void **state)
{
    (void)state;
    ix_round_random(&codec);
}

static void test_each_type(void **state)
{
    (void)state;
    ix_round_each_type(&codec);
}

static void test_samples(void **state)
{
    (void)state;
    ix_round_samples(&codec);
}

static void test_faults(void **state)
{
    (void)state;
    ix_round_faults(&codec);
}

/* --- what text files do not hold --------------------------------------- */

/* o is consumed. */
static void check_and_drop(ix_ctx *ctx, ix_obj *o)
{
    assert_non_null(o);
    ix_round_check(&codec, ctx, o);
    ix__obj_unref(ctx, o);
}

/* Empty lists, undefined values, a string of any bytes or any length, names of
 * any bytes, integers and reals that are told apart. */
static void test_more_than_text(void **state)
{
    static const char bytes[] = "nul \0 and \x01, not UTF-8: \xff";
    static const char *const names[] = {"a\xff", "new\nline", "\x01", "<&\">",
                                        ""};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *list = ix__obj_list(ctx), *o = ix__obj_undef(ctx);
    size_t n = 3000001;
    char *s = malloc(n + 1);

    (void)state;
    ASSERT_OK(ctx, ix__obj_append(ctx, list, o));
    ix__obj_unref(ctx, o);
    check_and_drop(ctx, ix__obj_list(ctx));
    check_and_drop(ctx, ix__obj_string(ctx, bytes, sizeof bytes));
    check_and_drop(ctx, ix__obj_string(ctx, "  \r\n ]]> ", 10));
    check_and_drop(ctx, ix__obj_string(ctx, "", 0));
    assert_non_null(s);
    for (size_t i = 0; i + 1 < n; i += 2)
        memcpy(s + i, "\xc3\xa9", 2);
    s[n - 1] = 'x';
    check_and_drop(ctx, ix__obj_string(ctx, s, n));
    free(s);
    for (int i = 0; i < 5; i++)
        ASSERT_OK(ctx, ix__attr_set_int(ctx, &list->attrs, names[i], i));
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &list->attrs, "least", INT64_MIN));
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &list->attrs, "most", INT64_MAX));
    ASSERT_OK(ctx, ix__attr_set_real(ctx, &list->attrs, "two", 2));
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &list->attrs, "text", "2"));
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &list->attrs, "bytes", "\x02\xfe"));
    check_and_drop(ctx, list);
    ix_ctx_free(ctx);
}

/* Directions of different kinds, 18 coordinates. */
static void test_mixed_directions(void **state)
{
    static const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const ix_dir dirs[3] = {{IX_BEZIER, 2, 2, false, NULL},
                            {IX_BSPLINE, 3, 3, true, knots},
                            {IX_POWER, 2, 2, false, NULL}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double pts[19 * 12];
    ix_mv *m;

    (void)state;
    for (int i = 0; i < 19 * 12; i++)
        pts[i] = 1 + i / 7.0;
    ASSERT_OK(ctx, ix_mv_new(ctx, 3, dirs, 18, true, pts, &m));
    check_and_drop(ctx, ix__obj_mv(ctx, IX_OBJ_TRIVAR, m));
    ix_ctx_free(ctx);
}

/* More rows than stand in one element. */
static void test_many_points(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double pts[2 * 3000], knots[3004];
    const ix_dir dir = {IX_BSPLINE, 4, 3000, false, knots};
    ix_poly *p = ix__poly_new(ctx, 1);
    ix_mv *m;

    (void)state;
    for (int i = 0; i < 3004; i++)
        knots[i] = i / 3.0;
    for (int i = 0; i < 6000; i++)
        pts[i] = sin(i);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, pts, &m));
    check_and_drop(ctx, ix__obj_mv(ctx, IX_OBJ_CURVE, m));
    assert_non_null(p);
    p->poly[0].kind = IX_POLYLINE;
    ASSERT_OK(ctx, ix__poly_vertices(ctx, &p->poly[0], 2048));
    for (int i = 0; i < 2048; i++)
        p->poly[0].v[i].p[i % 3] = pts[i];
    check_and_drop(ctx, ix__obj_poly(ctx, p));
    ix_ctx_free(ctx);
}

/* --- the memory of libxml2 ---------------------------------------------- */

/* Only a program may do so, not a library: the hooks are global. */
static long xml_calls, xml_fail_at;

static bool xml_fails(void)
{
    return xml_calls++ == xml_fail_at;
}

static void *xml_malloc(size_t n)
{
    return xml_fails() ? NULL : malloc(n);
}

static void *xml_realloc(void *p, size_t n)
{
    return xml_fails() ? NULL : realloc(p, n);
}

static char *xml_strdup(const char *s)
{
    return xml_fails() ? NULL : strdup(s);
}

/* Each request of libxml2 fails in turn: no memory is reported, or the value
 * is complete (some of its requests are for its own convenience). */
static void test_libxml2_faults(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(12);
    ix_obj *in = ix_rand_obj_of(ctx, &r, IX_OBJ_SURFACE, 2), *out;
    ix_buf b;
    long failed = 0;

    (void)state;
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, ix__xml_write(&b, in));
    for (xml_fail_at = 0;; xml_fail_at++) {
        ix_status st;

        xml_calls = 0;
        st = ix__xml_read(ctx, "faults", b.data, b.len, &out);
        if (st != IX_OK && st != IX_ENOMEM)
            fail_msg("request %ld: %s", xml_fail_at, ix_ctx_message(ctx));
        failed += st == IX_ENOMEM;
        assert_true((st == IX_OK) == (out != NULL));
        ix__obj_unref(ctx, out);
        if (xml_calls <= xml_fail_at)
            break;
    }
    xml_fail_at = -1;
    assert_true(failed > 10);
    ix__obj_unref(ctx, in);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random),
                                       cmocka_unit_test(test_each_type),
                                       cmocka_unit_test(test_samples),
                                       cmocka_unit_test(test_more_than_text),
                                       cmocka_unit_test(test_mixed_directions),
                                       cmocka_unit_test(test_many_points),
                                       cmocka_unit_test(test_faults),
                                       cmocka_unit_test(test_libxml2_faults)};

    xml_fail_at = -1;
    if (xmlMemSetup(free, xml_malloc, xml_realloc, xml_strdup) != 0)
        return 1;

    return cmocka_run_group_tests(tests, NULL, NULL);
}
