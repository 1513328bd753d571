/* Initial value problems with events, against closed forms. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "solve/ode.h"

IX_TEST_FIXTURE(55)

/* y'' = -y; events: y falls through 0, y' falls through -1/2. */
static bool swing(void *ud, double t, const double *y, double *dy)
{
    (void)ud;
    (void)t;
    dy[0] = y[1];
    dy[1] = -y[0];
    return true;
}

static void crossings(void *ud, double t, const double *y, double *g)
{
    (void)ud;
    (void)t;
    g[0] = y[0];
    g[1] = y[1] + 0.5;
}

/* y' = y^2, not to be evaluated above 10. */
static bool burst(void *ud, double t, const double *y, double *dy)
{
    (void)ud;
    (void)t;
    dy[0] = y[0] * y[0];
    return y[0] < 10;
}

/* Law: both methods give the cosine, to about their tolerances, and end exactly
 * where they are to. */
static void accuracy(void **state)
{
    (void)state;
    for (int check = 0; check < 2; check++)
        for (int e = 6; e <= 12; e += 3) {
            const double tol = pow(10, -e);
            const ix__ode_problem p = {
                .n = 2, .f = swing, .tol = tol, .check = check};
            double t = 0, y[2] = {1, 0};
            ix__ode_result r;
            ix__ode *o;
            int event;

            ASSERT_OK(ctx, ix__ode_open(ctx, &p, &o));
            ASSERT_OK(ctx, ix__ode_start(o, 0, y, 3));
            ASSERT_OK(ctx, ix__ode_run(o, &t, y, &event, &r));
            assert_int_equal(r, IX_ODE_END);
            assert_true(t == 3);
            /* ten steps' errors at least may add up */
            ASSERT_CLOSE(y[0], cos(3.0), 20 * tol);
            ASSERT_CLOSE(y[1], -sin(3.0), 20 * tol);
            ix__ode_close(o);
        }
}

/* Law: events are exact, not interpolated; the first of two counts; one that is
 * at zero at the start and falls happens at once, one that rises does not. */
static void events(void **state)
{
    const ix__ode_problem p = {
        .n = 2, .nevents = 2, .f = swing, .g = crossings, .tol = 1e-13};
    const double pi = acos(-1.0);
    double t = 0, y[2] = {1, 0};
    ix__ode_result r;
    ix__ode *o;
    int event;

    (void)state;
    ASSERT_OK(ctx, ix__ode_open(ctx, &p, &o));
    ASSERT_OK(ctx, ix__ode_start(o, 0, y, 9));
    ASSERT_OK(ctx, ix__ode_run(o, &t, y, &event, &r));
    assert_int_equal(r, IX_ODE_EVENT);
    assert_int_equal(event, 1);
    ASSERT_CLOSE(t, pi / 6, 1e-13);
    ASSERT_CLOSE(y[0], cos(pi / 6), 1e-13);
    t = 0;
    y[0] = 0;
    y[1] = -1;
    ASSERT_OK(ctx, ix__ode_start(o, 0, y, 9));
    ASSERT_OK(ctx, ix__ode_run(o, &t, y, &event, &r));
    assert_int_equal(event, 0);
    assert_true(r == IX_ODE_EVENT && t == 0);
    y[1] = 1; /* sin t: y' = -1/2 at 2 pi / 3 */
    ASSERT_OK(ctx, ix__ode_start(o, 0, y, 9));
    ASSERT_OK(ctx, ix__ode_run(o, &t, y, &event, &r));
    assert_int_equal(event, 1);
    ASSERT_CLOSE(t, 2 * pi / 3, 1e-13);
    ix__ode_close(o);
}

/* A right side that cannot be evaluated: as near to it as steps can get. */
static void stuck(void **state)
{
    const ix__ode_problem p = {.n = 1, .f = burst, .tol = 1e-10};
    double t = 0, y[1] = {1};
    ix__ode_result r;
    ix__ode *o;
    int event;

    (void)state;
    ASSERT_OK(ctx, ix__ode_open(ctx, &p, &o));
    assert_int_equal(ix__ode_start(o, 1, y, 1), IX_EARG);
    ASSERT_OK(ctx, ix__ode_start(o, 0, y, 2));
    ASSERT_OK(ctx, ix__ode_run(o, &t, y, &event, &r));
    assert_int_equal(r, IX_ODE_STUCK);
    ASSERT_CLOSE(t, 0.9, 1e-6); /* 1 / (1 - t) = 10 */
    assert_true(y[0] < 10);
    ix__ode_close(o);
}

static void nothing(ix_ctx *cx, void *state)
{
    (void)cx;
    *(ix__ode **)state = NULL;
}

static ix_status open_one(ix_ctx *cx, void *state)
{
    const ix__ode_problem p = {.n = 2, .f = swing, .tol = 1e-6};

    return ix__ode_open(cx, &p, state);
}

static void close_one(ix_ctx *cx, void *state)
{
    (void)cx;
    ix__ode_close(*(ix__ode **)state);
}

static void faults(void **state)
{
    ix__ode *o;
    const ix_fault_case f = {nothing, open_one, close_one, &o};

    (void)state;
    assert_true(ix_fault_run(&f) >= 1);
}

/* Without SUNDIALS there is only the message. */
static void left_out(void **state)
{
    const ix__ode_problem p = {.n = 2, .f = swing, .tol = 1e-6};
    ix__ode *o;

    (void)state;
    assert_int_equal(ix__ode_open(ctx, &p, &o), IX_EUNABLE);
    assert_non_null(strstr(ix_ctx_message(ctx), "WITH_SUNDIALS=0"));
    assert_null(o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accuracy),
        cmocka_unit_test(events),
        cmocka_unit_test(stuck),
        cmocka_unit_test(faults),
    };
    const struct CMUnitTest none[] = {cmocka_unit_test(left_out)};

#ifdef IX_NO_SUNDIALS
    (void)tests;
    return cmocka_run_group_tests(none, setup, teardown);
#else
    (void)none;
    return cmocka_run_group_tests(tests, setup, teardown);
#endif
}
