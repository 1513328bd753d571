/* Composition: values of f at values of g, degrees, cuts at knots, errors. */
#include "sym_test.h"

/* g with coordinates in f's domain: control points in [lo, hi]. */
static ix_mv *inner_function(ix_ctx *ctx, ix_rng *r, const ix_rand_opts *s,
                             double lo, double hi)
{
    ix_mv *g = ix_mv_randtest(ctx, r, s), *h;
    double p[IX_MAX_COORDS + 1];

    for (size_t i = 0; i < ix_mv_npts(g); i++) {
        double w = ix_mv_rational(g) ? ix_mv_weights(g)[i] : 1;

        p[0] = w;
        for (int k = 0; k < s->ncoords; k++)
            p[k + ix_mv_rational(g)] = w * ix_rng_range(r, lo, hi);
        ASSERT_OK(ctx, ix_mv_set_point(ctx, g, i, p, &h));
        ix_mv_unref(ctx, g);
        g = h;
    }
    return g;
}

static void compare(ix_ctx *ctx, ix_rng *r, const ix_mv *f, const ix_mv *g,
                    const ix_mv *c, double tol)
{
    for (int k = 0; k < 8; k++) {
        double t[4], u[IX_MAX_COORDS], want[IX_MAX_COORDS], got[IX_MAX_COORDS];

        rand_param(r, g, t);
        value_at(ctx, g, t, u);
        value_at(ctx, f, u, want);
        value_at(ctx, c, t, got);
        for (int i = 0; i < ix_mv_ncoords(f); i++)
            ASSERT_CLOSE(got[i], want[i], tol);
    }
}

/* Law: c(t) = f(g(t)) for Bezier f of 1 to 3 directions and g of 1 or 2; the
 * degree is (sum of f's) times g's. Tolerance: a few hundred ulp. */
static void values_of_values(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(41);

    for (int round = 0; round < 60; round++) {
        int nf = 1 + round % 3, ng = 1 + round / 3 % 2, total = 0;
        ix_rand_opts sf = {.ndirs = nf,
                           .ncoords = 2,
                           .rational = round & 1 ? 1 : -1,
                           .kinds = IX_RAND_BEZIER,
                           .max_order = 4};
        ix_rand_opts sg = {.ndirs = ng,
                           .ncoords = nf + (round & 1),
                           .rational = round & 2 ? 1 : -1,
                           .kinds = round & 4 ? IX_RAND_BEZIER
                                              : IX_RAND_BSPLINES,
                           .max_order = 3,
                           .max_knots = 3};
        ix_mv *f = ix_mv_randtest(w->ctx, &r, &sf), *c;
        ix_mv *g = inner_function(w->ctx, &r, &sg, 0, 1);

        ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
        for (int i = 0; i < nf; i++)
            total += ix_mv_order(f, i) - 1;
        for (int i = 0; i < ng; i++)
            assert_int_equal(ix_mv_order(c, i),
                             total * (ix_mv_order(g, i) - 1) + 1);
        assert_int_equal(ix_mv_dir(c, 0).basis, ix_mv_dir(g, 0).basis);
        compare(w->ctx, &r, f, g, c, 1e-12);
        ix_mv_unref(w->ctx, f);
        ix_mv_unref(w->ctx, g);
        ix_mv_unref(w->ctx, c);
    }
}

/* Law: the same for B-spline f, where the curve g runs through its knots,
 * in one and two directions. */
static void cuts_at_knots(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(42);

    for (int round = 0; round < 40; round++) {
        int nf = 1 + round % 2;
        ix_rand_opts sf = {.ndirs = nf,
                           .ncoords = 2,
                           .rational = round & 1 ? 1 : -1,
                           .kinds = IX_RAND_BSPLINES,
                           .max_order = 4,
                           .unit = true};
        ix_rand_opts sg = {.ndirs = 1,
                           .ncoords = nf,
                           .rational = round & 2 ? 1 : -1,
                           .kinds = round & 4 ? IX_RAND_BEZIER
                                              : IX_RAND_BSPLINES,
                           .max_order = 4,
                           .max_knots = 3};
        ix_mv *f = ix_mv_randtest(w->ctx, &r, &sf), *c;
        ix_mv *g = inner_function(w->ctx, &r, &sg, 0, 1);

        ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
        compare(w->ctx, &r, f, g, c, 1e-11);
        ix_mv_unref(w->ctx, f);
        ix_mv_unref(w->ctx, g);
        ix_mv_unref(w->ctx, c);
    }
}

static ix_mv *scalar_curve(ix_ctx *ctx, int n, const double *pts)
{
    ix_dir d = {IX_BEZIER, n, n, false, NULL};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 1, false, pts, &m));
    return m;
}

/* A cubic with a simple knot at 1 (C2), g = 2t and then a parabola that only
 * touches 1: the cut keeps C2, the touch makes none. */
static void continuity_is_pulled_back(void **state)
{
    sym_world *w = *state;
    double kv[] = {0, 0, 0, 0, 1, 2, 2, 2, 2}, p[] = {1, 3, -2, 5, 0};
    ix_dir d = {IX_BSPLINE, 4, 5, false, kv};
    ix_mv *f, *g, *c;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 1, false, p, &f));
    g = scalar_curve(w->ctx, 2, (double[]){0, 2});
    ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
    assert_int_equal(ix_mv_length(c, 0), 5);
    assert_int_equal(multiplicity_of(c, 0, 0.5), 1);
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, g);
    g = scalar_curve(w->ctx, 3, (double[]){0.5, 1.5, 0.5});
    ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
    assert_int_equal(ix_mv_length(c, 0), 7); /* one span of degree 6 */
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, g);
    ix_mv_unref(w->ctx, f);
}

/* Numbers of the reference cases crv-compose, crv-compose-reverse, which are
 * printed with 15 digits. */
static void reference_points(void **state)
{
    sym_world *w = *state;
    double p[] = {0, 1, 3, 0, 2, 0};
    double want[] = {0, 0.2, 0.626666666666667, 1.4, 3,
                     0, 0.4, 1.09333333333333,  1.6, 0};
    ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    ix_mv *f, *g, *c;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 2, false, p, &f));
    g = scalar_curve(w->ctx, 3, (double[]){0, 0.2, 1});
    ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
    assert_int_equal(ix_mv_npts(c), 5);
    for (int i = 0; i < 10; i++)
        ASSERT_CLOSE(ix_mv_axis(c, i / 5)[i % 5], want[i], 1e-14);
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, g);
    g = scalar_curve(w->ctx, 2, (double[]){1, 0});
    ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
    for (int i = 0; i < 3; i++)
        ASSERT_CLOSE(ix_mv_coord(c, 0)[i], p[2 - i], 2e-15);
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, g);
    ix_mv_unref(w->ctx, f);
}

static void errors_are_told(void **state)
{
    sym_world *w = *state;
    double kv[] = {0, 0, 1, 2, 2}, p[] = {0, 1, 0, 1};
    ix_dir d = {IX_BSPLINE, 2, 3, false, kv};
    ix_dir sq[2] = {{IX_BEZIER, 2, 2, false, NULL},
                    {IX_BEZIER, 2, 2, false, NULL}};
    ix_mv *f, *g, *s, *c;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 1, false, p, &f));
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 2, sq, 1, false, p, &s));
    /* control points outside, values inside: no error */
    g = scalar_curve(w->ctx, 3, (double[]){1, -0.9, 1});
    ASSERT_OK(w->ctx, ix_sym_compose(w->ctx, f, g, &c));
    ix_mv_unref(w->ctx, c);
    ix_mv_unref(w->ctx, g);
    g = scalar_curve(w->ctx, 3, (double[]){1, -1.1, 1});
    assert_int_equal(ix_sym_compose(w->ctx, f, g, &c), IX_EDOMAIN);
    assert_null(c);
    assert_int_equal(ix_sym_compose(w->ctx, s, g, &c), IX_EARG);
    ix_mv_unref(w->ctx, g);
    assert_int_equal(ix_sym_compose(w->ctx, f, s, &c), IX_EARG);
    g = scalar_curve(w->ctx, 2, (double[]){0, 2.1});
    assert_int_equal(ix_sym_compose(w->ctx, f, g, &c), IX_EDOMAIN);
    ix_mv_unref(w->ctx, g);
    ix_mv_unref(w->ctx, f);
    ix_mv_unref(w->ctx, s);
}

typedef struct {
    ix_mv *f, *g, *out;
} operands;

static void make_operands(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_rng r = ix_rng_new(43);
    ix_rand_opts s = {.ndirs = 2,
                      .ncoords = 2,
                      .rational = 1,
                      .kinds = IX_RAND_OPEN,
                      .min_order = 3,
                      .max_order = 4,
                      .max_knots = 4,
                      .unit = true};

    o->f = ix_mv_randtest(ctx, &r, &s);
    s.ndirs = 1;
    o->g = inner_function(ctx, &r, &s, 0, 1);
    o->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_status st = ix_sym_compose(ctx, o->f, o->g, &o->out);

    assert_true((st == IX_OK) == (o->out != NULL));
    return st;
}

static void release(ix_ctx *ctx, void *state)
{
    operands *o = state;

    ix_mv_unref(ctx, o->f);
    ix_mv_unref(ctx, o->g);
    ix_mv_unref(ctx, o->out);
}

static void memory_may_fail(void **state)
{
    operands o;
    ix_fault_case c = {make_operands, run, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, world_open, world_close)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(values_of_values),          TEST(cuts_at_knots),
        TEST(continuity_is_pulled_back), TEST(reference_points),
        TEST(errors_are_told),           cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
