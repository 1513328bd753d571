/* Functions on the solver when they are interrupted or run out of memory. */
#define _POSIX_C_SOURCE 200809L
#include "session.h"

#define SYSTEM                                                    \
    "x = mbezier(list(2, 1), list(ctlpt(E1, -1), ctlpt(E1, 1)));" \
    "y = mbezier(list(1, 2), list(ctlpt(E1, -1), ctlpt(E1, 1)));" \
    "h = mbezier(list(1, 1), list(ctlpt(E1, 0.3)));"              \
    "f = symbprod(x, symbdiff(symbprod(x, x), h));"               \
    "g = symbprod(y, symbdiff(symbprod(y, y), h));"               \
    "circ = symbdiff(symbsum(symbprod(x, x), symbprod(y, y)), h);"

static volatile int stop;

/* Stops at the first sign of progress. */
static void stop_now(void *ud, const char *what, double part)
{
    (void)ud;
    (void)what;
    (void)part;
    stop = 1;
}

/* Calls a function by itself (the interpreter would look for interruptions
 * first): list, two or three numbers. The result, a new reference. */
static ix_obj *interrupted(session *s, const char *name, const char *list,
                           int nnums)
{
    ix_obj *argv[4] = {ix__var_find(s->in, list)};
    ix_call c = {s->in, s->ctx, 1 + nnums, argv, NULL, 0};

    for (int i = 1; i <= nnums; i++)
        argv[i] = ix__obj_number(s->ctx, 0.01);
    stop = 0;
    rewind(s->ferr);
    ix_ctx_set_cancel(s->ctx, &stop);
    ix_ctx_set_progress(s->ctx, stop_now, NULL);
    ASSERT_OK(s->ctx, ix__builtin_find(name)->fn(&c));
    ix_ctx_set_progress(s->ctx, NULL, NULL);
    ix_ctx_set_cancel(s->ctx, NULL);
    assert_int_equal(stop, 1);
    (void)fflush(s->ferr);
    assert_non_null(strstr(s->err, "(interrupted)"));
    for (int i = 1; i <= nnums; i++)
        ix__obj_unref(s->ctx, argv[i]);
    return c.result;
}

/* Nine zeros; one is in the middle, which the first box proves. */
static void t_points(void **state)
{
    session s;
    ix_obj *o;

    (void)state;
    session_open(&s, NULL);
    ASSERT_OK(s.ctx, session_run(&s, SYSTEM "l = list(f, g);"));
    assert_true(session_number(&s, "sizeof(mzero(l, 0.01, 1e-8))") == 9);
    o = interrupted(&s, "MZERO", "l", 2);
    assert_non_null(o);
    assert_true(o->u.list.n >= 1);
    ix__obj_unref(s.ctx, o);
    session_close(&s);
}

static void t_curves(void **state)
{
    static const char *const names[] = {"MZERO", "MUNIVZERO"};

    (void)state;
    for (int i = 0; i < 2; i++) { /* progress is told at once, and rarely */
        session s;

        session_open(&s, NULL);
        ASSERT_OK(s.ctx, session_run(&s, SYSTEM "l = list(circ);"));
        ix__obj_unref(s.ctx, interrupted(&s, names[i], "l", 2 + i));
        session_close(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(t_points),
                                       cmocka_unit_test(t_curves)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
