/* Every public operation of mv.h with each of its allocations failing in turn:
 * IX_ENOMEM, nothing made, nothing lost, inputs as they were. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "mv/mv.h"

typedef struct fault_state fault_state;
typedef ix_status (*operation)(ix_ctx *ctx, fault_state *s);

struct fault_state {
    operation op;
    unsigned kinds;
    ix_mv *a, *b, *copy; /* copy: equal to a */
    ix_mv *out[2];
    ix_mv_pieces pieces;
};

static ix_status to_bspline(ix_ctx *c, fault_state *s)
{
    return ix_mv_to_bspline(c, s->a, s->out);
}

static ix_status to_float(ix_ctx *c, fault_state *s)
{
    return ix_mv_to_float(c, s->a, s->out);
}

static ix_status to_open(ix_ctx *c, fault_state *s)
{
    return ix_mv_to_open(c, s->a, s->out);
}

static ix_status to_power(ix_ctx *c, fault_state *s)
{
    return ix_mv_bezier_to_power(c, s->a, s->out);
}

static ix_status from_power(ix_ctx *c, fault_state *s)
{
    return ix_mv_power_to_bezier(c, s->a, s->out);
}

static ix_status to_bezier(ix_ctx *c, fault_state *s)
{
    return ix_mv_to_bezier(c, s->a, &s->pieces);
}

static ix_status insert_knots(ix_ctx *c, fault_state *s)
{
    double dom[2], t[2];

    ix_mv_domain(s->a, 0, dom);
    t[0] = t[1] = 0.3 * dom[0] + 0.7 * dom[1];
    return ix_mv_insert_knots(c, s->a, 0, 2, t, s->out);
}

static ix_status set_knots(ix_ctx *c, fault_state *s)
{
    double k[64];

    for (int i = 0; i < 64; i++)
        k[i] = i;
    return ix_mv_set_knots(
        c, s->a, 0, ix_mv_length(s->a, 0) + ix_mv_order(s->a, 0), k, s->out);
}

static ix_status raise(ix_ctx *c, fault_state *s)
{
    return ix_mv_raise(c, s->a, 1, ix_mv_order(s->a, 1) + 2, s->out);
}

static ix_status reduce(ix_ctx *c, fault_state *s)
{
    double err;

    return ix_mv_reduce(c, s->a, 0, ix_mv_order(s->a, 0) - 1, &err, s->out);
}

static ix_status remove_knots(ix_ctx *c, fault_state *s)
{
    return ix_mv_remove_knots(c, s->a, 0, 0.5, s->out);
}

static ix_status region(ix_ctx *c, fault_state *s)
{
    double dom[2];

    ix_mv_domain(s->a, 1, dom);
    return ix_mv_region(c, s->a, 1, dom[1], 0.5 * (dom[0] + dom[1]), s->out);
}

static ix_status split(ix_ctx *c, fault_state *s)
{
    double dom[2];

    ix_mv_domain(s->a, 0, dom);
    return ix_mv_split(c, s->a, 0, 0.5 * (dom[0] + dom[1]), s->out);
}

static ix_status reverse(ix_ctx *c, fault_state *s)
{
    return ix_mv_reverse(c, s->a, 0, s->out);
}

static ix_status swap_dirs(ix_ctx *c, fault_state *s)
{
    return ix_mv_swap_dirs(c, s->a, 0, 1, s->out);
}

static ix_status reparam(ix_ctx *c, fault_state *s)
{
    return ix_mv_reparam(c, s->a, 1, -3, 7, s->out);
}

static ix_status coerce(ix_ctx *c, fault_state *s)
{
    return ix_mv_coerce(c, s->a, 5, false, s->out);
}

static ix_status merge(ix_ctx *c, fault_state *s)
{
    return ix_mv_merge(c, s->a, s->b, 0, IX_JOIN_BRIDGE, s->out);
}

static ix_status compatible(ix_ctx *c, fault_state *s)
{
    return ix_mv_compatible(c, s->a, s->b, IX_SAME_ALL, s->out, s->out + 1);
}

static ix_status promote(ix_ctx *c, fault_state *s)
{
    return ix_mv_promote(c, s->a, 4, 1, s->out);
}

static ix_status insert_dir(ix_ctx *c, fault_state *s)
{
    return ix_mv_insert_dir(c, s->a, 1, s->out);
}

static ix_status fix(ix_ctx *c, fault_state *s)
{
    double dom[2];

    ix_mv_domain(s->a, 0, dom);
    return ix_mv_fix(c, s->a, 0, dom[0], s->out);
}

static ix_status layer(ix_ctx *c, fault_state *s)
{
    return ix_mv_layer(c, s->a, 1, 0, s->out);
}

static ix_status stack(ix_ctx *c, fault_state *s)
{
    const ix_mv *in[] = {s->a, s->b};
    const double knots[] = {0, 0, 1, 1};
    const ix_dir dir = {IX_BSPLINE, 2, 2, false, knots};

    return ix_mv_stack(c, 2, in, &dir, s->out);
}

static ix_status scalars(ix_ctx *c, fault_state *s)
{
    const ix_mv *both[2];
    ix_mv *x, *y;
    ix_status st;

    IX_TRY(ix_mv_scalar(c, s->a, 0, &x));
    st = ix_mv_scalar(c, s->b, 1, &y);
    if (st == IX_OK) {
        both[0] = x;
        both[1] = y;
        st = ix_mv_join_scalars(c, 2, both, true, s->out);
        ix_mv_unref(c, y);
    }
    ix_mv_unref(c, x);
    return st;
}

static ix_status set_point(ix_ctx *c, fault_state *s)
{
    const double p[] = {1, 2, 3};

    return ix_mv_set_point(c, s->a, 1, p, s->out);
}

static ix_status transform(ix_ctx *c, fault_state *s)
{
    const double mat[16] = {1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1};

    return ix_mv_transform(c, s->a, mat, s->out);
}

static ix_status add_point(ix_ctx *c, fault_state *s)
{
    const double p[] = {1, 2, 3};
    ix_mv *curve;
    ix_status st;

    IX_TRY(ix_mv_layer(c, s->a, 1, 0, &curve));
    st = ix_mv_add_point(c, curve, p, true, s->out);
    ix_mv_unref(c, curve);
    return st;
}

static ix_status blossom(ix_ctx *c, fault_state *s)
{
    const double x[8] = {0};
    const double *args[] = {x, x};
    double v[3];

    return ix_mv_blossom(c, s->a, args, v);
}

static void setup(ix_ctx *c, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(31);
    ix_rand_opts o = {.ndirs = 2,
                      .ncoords = 2,
                      .rational = 1,
                      .min_order = 3,
                      .max_order = 4,
                      .kinds = s->kinds};

    s->a = ix_mv_randtest(c, &r, &o);
    s->b = ix_mv_randtest(c, &r, &o);
    r = ix_rng_new(31);
    s->copy = ix_mv_randtest(c, &r, &o);
    s->out[0] = s->out[1] = NULL;
    s->pieces = (ix_mv_pieces){0};
}

static ix_status run(ix_ctx *c, void *state)
{
    fault_state *s = state;
    ix_status st = s->op(c, s);

    if (st != IX_OK) {
        assert_null(s->out[0]);
        assert_null(s->out[1]);
        assert_int_equal(s->pieces.count, 0);
    }
    return st;
}

static void teardown(ix_ctx *c, void *state)
{
    fault_state *s = state;

    ix_mv_unref(c, s->out[0]);
    ix_mv_unref(c, s->out[1]);
    ix_mv_pieces_free(c, &s->pieces);
    assert_int_equal(s->a->refs, 1);
    assert_int_equal(s->b->refs, 1);
    assert_true(ix_mv_equal(s->a, s->copy, 0));
    ix_mv_unref(c, s->a);
    ix_mv_unref(c, s->b);
    ix_mv_unref(c, s->copy);
}

static const struct {
    operation op;
    unsigned kinds;
} operations[] = {
    {to_bspline, IX_RAND_BEZIER},   {to_bspline, IX_RAND_POWER},
    {to_float, IX_RAND_PERIODIC},   {to_open, IX_RAND_PERIODIC | IX_RAND_FLOAT},
    {to_power, IX_RAND_BEZIER},     {from_power, IX_RAND_POWER},
    {to_bezier, IX_RAND_BSPLINES},  {to_bezier, IX_RAND_POWER},
    {insert_knots, IX_RAND_BEZIER}, {insert_knots, IX_RAND_PERIODIC},
    {set_knots, IX_RAND_BEZIER},    {raise, IX_RAND_BEZIER},
    {raise, IX_RAND_BSPLINES},      {reduce, IX_RAND_BEZIER},
    {reduce, IX_RAND_OPEN},         {remove_knots, IX_RAND_OPEN},
    {remove_knots, IX_RAND_FLOAT},  {region, IX_RAND_BEZIER},
    {region, IX_RAND_BSPLINES},     {split, IX_RAND_BEZIER},
    {split, IX_RAND_BSPLINES},      {reverse, IX_RAND_PERIODIC},
    {swap_dirs, IX_RAND_BSPLINES},  {reparam, IX_RAND_BEZIER},
    {reparam, IX_RAND_OPEN},        {coerce, IX_RAND_BEZIER},
    {merge, IX_RAND_BEZIER},        {merge, IX_RAND_PERIODIC},
    {compatible, IX_RAND_BSPLINES}, {compatible, IX_RAND_ALL},
    {promote, IX_RAND_BEZIER},      {promote, IX_RAND_OPEN},
    {insert_dir, IX_RAND_OPEN},     {fix, IX_RAND_PERIODIC},
    {layer, IX_RAND_BEZIER},        {stack, IX_RAND_BEZIER},
    {stack, IX_RAND_OPEN},          {scalars, IX_RAND_OPEN},
    {set_point, IX_RAND_BEZIER},    {transform, IX_RAND_BEZIER},
    {add_point, IX_RAND_BEZIER},    {add_point, IX_RAND_PERIODIC},
    {blossom, IX_RAND_BEZIER},
};

static void every_allocation_fails(void **state)
{
    long failures = 0;

    (void)state;
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++) {
        static fault_state s;

        s.op = operations[i].op;
        s.kinds = operations[i].kinds;
        failures += ix_fault_run(&(ix_fault_case){setup, run, teardown, &s});
    }
    assert_true(failures > 60);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_fails),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
