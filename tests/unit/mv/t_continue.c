/* t_continue.c - B-splines beyond their domain. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "mv/mv.h"

static ix_mv *spline(ix_ctx *ctx, ix_rng *r, int ndirs)
{
    const ix_rand_opts o = {.ndirs = ndirs,
                            .ncoords = 2,
                            .rational = 0,
                            .kinds = IX_RAND_OPEN,
                            .min_order = 1,
                            .max_order = 5,
                            .max_knots = 4};

    return ix_mv_randtest(ctx, r, &o);
}

/* Law: inside nothing changes; outside the derivatives at the end, all of them,
 * go on: the k-th ones at a place beyond follow from Taylor's formula. */
static void goes_on(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(21);

    (void)state;
    print_message("seed %llu\n", (unsigned long long)r.s);
    for (int k = 0; k < 60; k++) {
        ix_mv *m = spline(ctx, &r, 1), *c;
        double dom[2], to[2], p[3], q[3];
        int na = ix_mv_naxes(m);

        ix_mv_domain(m, 0, dom);
        to[0] = dom[0] - (k % 3 ? 0.3 : 0);
        to[1] = dom[1] + (k % 4 ? 0.2 : 0);
        ASSERT_OK(ctx, ix__mv_continue(ctx, m, 0, to, &c));
        for (int i = 0; i < 10; i++) {
            double t = ix_rng_range(&r, dom[0], dom[1]);

            ASSERT_OK(ctx, ix_mv_eval(ctx, m, &t, p));
            ASSERT_OK(ctx, ix_mv_eval(ctx, c, &t, q));
            for (int a = 0; a < na; a++)
                ASSERT_CLOSE(p[a], q[a], 1e-9);
        }
        for (int e = 0; e < 2; e++) {
            double sum[3] = {0}, h = to[e] - dom[e], f = 1;

            for (int d = 0; d < ix_mv_order(m, 0); d++) {
                ASSERT_OK(ctx, ix_mv_partial(ctx, m, &dom[e], &d, p));
                for (int a = 0; a < na; a++)
                    sum[a] += f * p[a];
                f *= h / (d + 1);
            }
            ASSERT_OK(ctx, ix_mv_eval(ctx, c, &to[e], q));
            for (int a = 0; a < na; a++) /* spans down to 0.03: (0.3/0.03)^4 */
                ASSERT_CLOSE(sum[a], q[a], 1e-9 * fmax(1, fabs(q[a])));
        }
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *m, *out;
} fault;

static void setup(ix_ctx *ctx, void *state)
{
    ix_rng r = ix_rng_new(22);
    fault *f = state;

    f->out = NULL;
    f->m = spline(ctx, &r, 2);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    fault *f = state;
    double dom[2];

    ix_mv_domain(f->m, 1, dom);
    return ix__mv_continue(ctx, f->m, 1,
                           (const double[2]){dom[0] - 1, dom[1] + 1}, &f->out);
}

static void teardown(ix_ctx *ctx, void *state)
{
    fault *f = state;

    ix_mv_unref(ctx, f->m);
    ix_mv_unref(ctx, f->out);
}

static void out_of_memory(void **state)
{
    fault f;
    const ix_fault_case c = {setup, run, teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
