/* t_algebra.c - products, sums and their relatives against values. */
#include "sym_test.h"

typedef ix_status (*binary)(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            const ix_sym_opts *o, ix_mv **out);

typedef enum { ADD, SUB, MUL, SCALE, DOT, CROSS, DIV } op;

static const binary function[] = {ix_sym_add,   ix_sym_sub, ix_sym_mul,
                                  ix_sym_scale, ix_sym_dot, ix_sym_cross,
                                  ix_sym_div};

/* What the operation does to values; returns the number of coordinates. */
static int expected(op f, int na, int nb, const double *a, const double *b,
                    double *x)
{
    int n = na > nb ? na : nb;

    x[0] = 0;
    switch (f) {
    case ADD:
    case SUB:
    case MUL:
        for (int i = 0; i < n; i++)
            x[i] = f == ADD   ? a[i] + b[i]
                   : f == SUB ? a[i] - b[i]
                              : a[i] * b[i];
        return n;
    case SCALE:
    case DIV:
        for (int i = 0; i < na; i++)
            x[i] = f == SCALE ? a[i] * b[0] : a[i] / b[0];
        return na;
    case DOT:
        for (int i = 0; i < n; i++)
            x[0] += a[i] * b[i];
        return 1;
    default:
        x[0] = a[1] * b[2] - a[2] * b[1];
        x[1] = a[2] * b[0] - a[0] * b[2];
        x[2] = a[0] * b[1] - a[1] * b[0];
        return 3;
    }
}

/* Law: the value of the result is the operation on values, whatever orders,
 * knots, coordinates, weights, number of directions and threads.
 * Tolerance: a few hundred ulp of numbers of size 1 (quotients: of 1/b). */
static void values_follow(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(21);

    for (int round = 0; round < 240; round++) {
        op f = (op)(round % 7);
        bool scalar = f == SCALE || f == DIV;
        ix_rand_opts s = {.ndirs = 1 + round / 7 % 3,
                          .kinds = round % 2 ? IX_RAND_ALL : IX_RAND_BSPLINES,
                          .max_order = 4,
                          .max_knots = 4,
                          .unit = true};
        double t[3], va[IX_MAX_COORDS], vb[IX_MAX_COORDS], got[IX_MAX_COORDS],
            want[IX_MAX_COORDS];
        ix_mv *a, *b, *c;
        int n;

        s.ncoords = ix_rng_int(&r, 1, 3);
        s.rational = ix_rng_int(&r, 0, 1) ? 1 : -1;
        a = ix_mv_randtest(w->ctx, &r, &s);
        s.ncoords = scalar ? 1 : ix_rng_int(&r, 1, 3);
        s.rational = ix_rng_int(&r, 0, 1) ? 1 : -1;
        b = ix_mv_randtest(w->ctx, &r, &s);
        ASSERT_OK(w->ctx, function[f](w->ctx, a, b, NULL, &c));
        for (int k = 0; k < 5; k++) {
            double tol = 1e-12;

            rand_param(&r, c, t);
            value_at(w->ctx, a, t, va);
            value_at(w->ctx, b, t, vb);
            if (f == DIV && fabs(vb[0]) < 0.01)
                continue;
            value_at(w->ctx, c, t, got);
            n = expected(f, ix_mv_ncoords(a), ix_mv_ncoords(b), va, vb, want);
            assert_int_equal(ix_mv_ncoords(c), n);
            for (int i = 0; i < n; i++)
                ASSERT_CLOSE(got[i], want[i], tol);
        }
        ix_mv_unref(w->ctx, a);
        ix_mv_unref(w->ctx, b);
        ix_mv_unref(w->ctx, c);
    }
}

/* Law: (a b) has order ka + kb - 1 and, at each knot, the smaller continuity
 * of both; Bezier stays Bezier. */
static void degree_and_continuity(void **state)
{
    sym_world *w = *state;
    double ka[] = {0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1};
    double kb[] = {0, 0, 0, 0.25, 0.5, 1, 1, 1};
    double pts[] = {1, 2, 0, 1, 5, 3};
    ix_dir da = {IX_BSPLINE, 4, 6, false, ka},
           db = {IX_BSPLINE, 3, 5, false, kb};
    ix_dir bz = {IX_BEZIER, 6, 6, false, NULL};
    ix_mv *a, *b, *c;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &da, 1, false, pts, &a));
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &db, 1, false, pts, &b));
    ASSERT_OK(w->ctx, ix_sym_mul(w->ctx, a, b, NULL, &c));
    assert_int_equal(ix_mv_order(c, 0), 6);
    assert_int_equal(multiplicity_of(c, 0, 0.25), 4); /* C1 */
    assert_int_equal(multiplicity_of(c, 0, 0.5), 4);  /* both C1 */
    assert_int_equal(ix_mv_length(c, 0), 14);
    ix_mv_unref(w->ctx, c);
    ASSERT_OK(w->ctx, ix_sym_mul(w->ctx, a, b, &(ix_sym_opts){0, 0}, &c));
    assert_int_equal(multiplicity_of(c, 0, 0.25), 5); /* C0 */
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, a);
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &bz, 1, false, pts, &a));
    ASSERT_OK(w->ctx, ix_sym_mul(w->ctx, a, a, NULL, &c));
    assert_int_equal(ix_mv_dir(c, 0).basis, IX_BEZIER);
    assert_int_equal(ix_mv_order(c, 0), 11);
    ix_mv_unref(w->ctx, c);
    ASSERT_OK(w->ctx, ix_sym_mul(w->ctx, a, b, NULL, &c));
    assert_int_equal(ix_mv_dir(c, 0).basis, IX_BSPLINE);
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, a);
    ix_mv_unref(w->ctx, b);
}

/* Equal weights keep the degree, within 1e-5; what is written alike keeps its
 * (float) knots; E and P meet by the rules of fractions. */
static void sums_keep_what_they_can(void **state)
{
    sym_world *w = *state;
    double kv[] = {-2, -1, 0, 1, 2, 3}, a[] = {1, 2, 3, 4, 5, 6};
    double b[] = {1, 2.000001, 3, 7, 8, 9}, c[] = {1, 2.1, 3, 7, 8, 9};
    ix_dir fl = {IX_BSPLINE, 3, 3, false, kv};
    ix_dir bz = {IX_BEZIER, 3, 3, false, NULL};
    const double *second[] = {b, c};
    ix_mv *x, *y, *s;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &fl, 2, false, a, &x));
    ASSERT_OK(w->ctx, ix_sym_sub(w->ctx, x, x, NULL, &s));
    assert_true(ix_mv_dir(s, 0).knots[0] == -2);
    assert_true(ix_mv_coord(s, 1)[2] == 0);
    ix_mv_unref(w->ctx, x);
    ix_mv_unref(w->ctx, s);
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &bz, 1, true, a, &x));
    for (int i = 0; i < 2; i++) {
        ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &bz, 1, true, second[i], &y));
        ASSERT_OK(w->ctx, ix_sym_add(w->ctx, x, y, NULL, &s));
        assert_int_equal(ix_mv_order(s, 0), i == 0 ? 3 : 5);
        ix_mv_unref(w->ctx, y);
        ix_mv_unref(w->ctx, s);
    }
    ix_mv_unref(w->ctx, x);
}

/* Every Err line, and that nothing is made then. */
static void errors_are_told(void **state)
{
    sym_world *w = *state;
    double p[24] = {0}, one[2] = {1, 2};
    ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                   {IX_BEZIER, 2, 2, false, NULL}};
    ix_dir far = {IX_BSPLINE, 2, 2, false, (double[]){0, 0, 1.1, 1.1}};
    ix_dir near = {IX_BSPLINE, 2, 2, false,
                   (double[]){0, 0, 1.000001, 1.000001}};
    ix_mv *crv, *srf, *four, *s1, *s2, *zero, *out;
    ix_ctx *c = w->ctx;

    ASSERT_OK(c, ix_mv_new(c, 1, d, 3, false, p, &crv));
    ASSERT_OK(c, ix_mv_new(c, 2, d, 3, false, p, &srf));
    ASSERT_OK(c, ix_mv_new(c, 1, d, 4, false, p, &four));
    ASSERT_OK(c, ix_mv_new(c, 1, d, 1, false, p, &zero));
    ASSERT_OK(c, ix_mv_new(c, 1, &far, 1, false, one, &s1));
    ASSERT_OK(c, ix_mv_new(c, 1, &near, 1, false, one, &s2));
    assert_int_equal(ix_sym_add(c, crv, srf, NULL, &out), IX_EARG);
    assert_null(out);
    assert_int_equal(ix_sym_mul(c, crv, s1, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_scale(c, crv, four, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_cross(c, crv, four, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_triple(c, crv, crv, four, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_div(c, crv, four, NULL, &out), IX_EARG);
    assert_int_equal(ix_sym_div(c, crv, zero, NULL, &out), IX_EDOMAIN);
    assert_int_equal(ix_sym_invert(c, zero, &out), IX_EDOMAIN);
    assert_int_equal(ix_sym_invert(c, crv, &out), IX_EARG);
    assert_null(out);
    ASSERT_OK(c, ix_sym_scale(c, crv, s2, NULL, &out));
    ix_mv_unref(c, out);
    ix_mv_unref(c, crv);
    ix_mv_unref(c, srf);
    ix_mv_unref(c, four);
    ix_mv_unref(c, zero);
    ix_mv_unref(c, s1);
    ix_mv_unref(c, s2);
}

/* Law: 1 / (1 / a) = a, dot with a vector = the sum, knots and all kept. */
static void point_by_point(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(22);
    double v[2] = {2, -3};

    for (int round = 0; round < 20; round++) {
        ix_rand_opts s = {.ncoords = 1, .max_order = 4};
        ix_mv *a = ix_mv_randtest(w->ctx, &r, &s), *b, *c;

        ASSERT_OK(w->ctx, ix_sym_invert(w->ctx, a, &b));
        ASSERT_OK(w->ctx, ix_sym_invert(w->ctx, b, &c));
        for (size_t i = 0; i < ix_mv_npts(a); i++)
            assert_true(ix_mv_coord(c, 0)[i] == ix_mv_coord(a, 0)[i]);
        ix_mv_unref(w->ctx, a);
        ix_mv_unref(w->ctx, b);
        ix_mv_unref(w->ctx, c);
        s.ncoords = 2;
        a = ix_mv_randtest(w->ctx, &r, &s);
        ASSERT_OK(w->ctx, ix_sym_dot_vector(w->ctx, a, v, &b));
        assert_true(ix_mv_rational(b) == ix_mv_rational(a));
        for (size_t i = 0; i < ix_mv_npts(a); i++)
            assert_true(ix_mv_coord(b, 0)[i] ==
                        2 * ix_mv_coord(a, 0)[i] - 3 * ix_mv_coord(a, 1)[i]);
        ix_mv_unref(w->ctx, a);
        ix_mv_unref(w->ctx, b);
    }
}

/* Degree 400 times degree 600 does not overflow: (1 + x)^n at x in [0, 1],
 * values up to 2^n scaled to 1. Tolerance: 1000 ulp. */
static void high_degrees(void **state)
{
    sym_world *w = *state;
    double p[601], t = 0.3, x;
    ix_dir d = {IX_BEZIER, 401, 401, false, NULL};
    ix_mv *a, *b, *c;

    for (int i = 0; i <= 600; i++)
        p[i] = 1e9 * (i % 2 ? -1 : 1); /* wild control points */
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 1, false, p, &a));
    for (int i = 0; i <= 600; i++)
        p[i] = 1e9;
    d.order = d.length = 601;
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 1, false, p, &b));
    ASSERT_OK(w->ctx, ix_sym_mul(w->ctx, b, b, NULL, &c) == IX_EUNABLE
                          ? IX_OK
                          : IX_EARG);
    ASSERT_OK(w->ctx, ix_sym_mul(w->ctx, a, b, NULL, &c));
    assert_int_equal(ix_mv_order(c, 0), 1001);
    ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, c, &t, &x));
    ASSERT_CLOSE(x / 1e18, pow(0.4, 400), 1e-12);
    ASSERT_CLOSE(ix_mv_coord(c, 0)[0] / 1e18, 1, 1e-13);
    ASSERT_CLOSE(ix_mv_coord(c, 0)[1000] / 1e18, 1, 1e-13);
    ix_mv_unref(w->ctx, a);
    ix_mv_unref(w->ctx, b);
    ix_mv_unref(w->ctx, c);
}

/* Law: the bits do not depend on the number of threads. */
static void threads_change_no_bit(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(23);
    ix_rand_opts s = {.ndirs = 2,
                      .ncoords = 3,
                      .rational = 1,
                      .kinds = IX_RAND_OPEN,
                      .min_order = 5,
                      .max_order = 5,
                      .max_knots = 40,
                      .unit = true};
    ix_mv *a = ix_mv_randtest(w->ctx, &r, &s), *c[2];
    size_t bytes;

    for (int i = 0; i < 2; i++) {
        ix_ctx_set_threads(w->ctx, 1 + 3 * i);
        ASSERT_OK(w->ctx, ix_sym_cross(w->ctx, a, a, NULL, &c[i]));
    }
    bytes = ix_mv_npts(c[0]) * (size_t)ix_mv_naxes(c[0]) * sizeof(double);
    assert_memory_equal(ix_mv_axis(c[0], 0), ix_mv_axis(c[1], 0), bytes);
    ix_ctx_set_threads(w->ctx, 1);
    ix_mv_unref(w->ctx, a);
    ix_mv_unref(w->ctx, c[0]);
    ix_mv_unref(w->ctx, c[1]);
}

typedef struct {
    op f;
    ix_mv *a, *b, *out;
} operands;

static void make(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_rng r = ix_rng_new(24);
    ix_rand_opts s = {.ndirs = 2,
                      .ncoords = 3,
                      .rational = 1,
                      .kinds = IX_RAND_BSPLINES | IX_RAND_POWER,
                      .max_order = 3,
                      .max_knots = 3,
                      .unit = true};

    o->a = ix_mv_randtest(ctx, &r, &s);
    s.ncoords = o->f == SCALE || o->f == DIV ? 1 : 3;
    o->b = ix_mv_randtest(ctx, &r, &s);
    o->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_status st = function[o->f](ctx, o->a, o->b, NULL, &o->out);

    assert_true((st == IX_OK) == (o->out != NULL));
    return st;
}

static void release(ix_ctx *ctx, void *state)
{
    operands *o = state;

    ix_mv_unref(ctx, o->a);
    ix_mv_unref(ctx, o->b);
    ix_mv_unref(ctx, o->out);
}

static void memory_may_fail(void **state)
{
    operands o;
    ix_fault_case c = {make, run, release, &o};

    (void)state;
    for (o.f = ADD; o.f <= DIV; o.f++)
        assert_true(ix_fault_run(&c) > 0);
}

/* The operations of other shapes: with a vector, of one operand, of three. */
static ix_status run_dot_vector(ix_ctx *ctx, void *state)
{
    const double v[3] = {1, -2, 0.5};
    operands *o = state;

    return ix_sym_dot_vector(ctx, o->a, v, &o->out);
}

static ix_status run_invert(ix_ctx *ctx, void *state)
{
    operands *o = state;

    return ix_sym_invert(ctx, o->b, &o->out); /* DIV makes b a scalar */
}

static ix_status run_triple(ix_ctx *ctx, void *state)
{
    operands *o = state;

    return ix_sym_triple(ctx, o->a, o->b, o->a, NULL, &o->out);
}

static void memory_may_fail_elsewhere(void **state)
{
    operands o = {.f = ADD};
    ix_fault_case c = {make, run_dot_vector, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
    c.run = run_triple;
    assert_true(ix_fault_run(&c) > 0);
    o.f = DIV;
    c.run = run_invert;
    assert_true(ix_fault_run(&c) > 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, world_open, world_close)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(values_follow),
        TEST(degree_and_continuity),
        TEST(sums_keep_what_they_can),
        TEST(errors_are_told),
        TEST(point_by_point),
        TEST(high_degrees),
        TEST(threads_change_no_bit),
        cmocka_unit_test(memory_may_fail),
        cmocka_unit_test(memory_may_fail_elsewhere),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
