/* Products, sums and their relatives against values, point by point. */
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
        rand_shape s = {.ndirs = 1 + round / 7 % 3,
                        .kind = RAND_BSPLINE,
                        .max_order = 4,
                        .spans = 4};
        double t[3], va[IX_MAX_COORDS], vb[IX_MAX_COORDS], got[IX_MAX_COORDS],
            want[IX_MAX_COORDS];
        ix_mv *a, *b, *c;
        int n;

        s.ncoords = ix_rng_int(&r, 1, 3);
        s.rational = ix_rng_int(&r, 0, 1);
        a = rand_mv(w->ctx, &r, &s);
        s.ncoords = scalar ? 1 : ix_rng_int(&r, 1, 3);
        s.rational = ix_rng_int(&r, 0, 1);
        b = rand_mv(w->ctx, &r, &s);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(values_follow, world_open, world_close),
        cmocka_unit_test_setup_teardown(degree_and_continuity, world_open,
                                        world_close),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
