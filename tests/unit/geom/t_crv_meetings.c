/* Points that two curves share: curves that are made to meet, touch and miss,
 * at any size and place; circles; a shared part. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/distance.h"
#include "iritx/geom.h"

IX_TEST_FIXTURE(4711)

static ix_mv *bezier(int n, bool rational, const double *pts)
{
    const ix_dir d = {IX_BEZIER, n, n, false, NULL};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, rational, pts, &m));
    return m;
}

static ix_mv *rand_curve(int n, bool rational)
{
    double p[4 * 8];

    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(&rng, 0.5, 2) : 1;

        p[i] = w;
        for (int k = 0; k < 3; k++)
            p[(k + rational) * n + i] = w * ix_rng_range(&rng, -1, 1);
    }
    return bezier(n, rational, p);
}

/* m moved by v; m is released. */
static ix_mv *moved(ix_mv *m, const double v[3], double size)
{
    double mat[16] = {size, 0, 0,    0, 0,    size, 0,    0,
                      0,    0, size, 0, v[0], v[1], v[2], 1};
    ix_mv *out;

    ASSERT_OK(ctx, ix_mv_transform(ctx, m, mat, &out));
    ix_mv_unref(ctx, m);
    return out;
}

static int with(const ix_meetings *m, double t, double r, double tol)
{
    int n = 0;

    for (int i = 0; i < m->n; i++)
        n += fabs(m->at[i].t[0] - t) <= tol && fabs(m->at[i].t[1] - r) <= tol;
    return n;
}

/* Law: a curve moved so that its point at r is that of the other at t meets it
 * there (1e-12 of the domain by rounding, over the sine of their angle, 0.02 at
 * least here); moved on by 1e-9 across both tangents it does not. At 2^20 the
 * coordinates are rounded to 2^-33, so that 1e-6 and 1e-7 are asked for. */
static void made_to_meet(void **state)
{
    (void)state;
    for (int i = 0; i < 60; i++) {
        double size = i % 3 == 1 ? 1e-6 : 1, far = i % 3 == 2 ? 1 << 20 : 0;
        double t = i % 5 ? ix_rng_unit(&rng) : i % 2, r = ix_rng_unit(&rng);
        double shift[3] = {far, -far, far / 2}, p[6], q[6], e[3], u[3], v[3];
        double tol = far > 0 ? 1e-6 : 1e-10;
        ix_mv *a = moved(rand_curve(2 + i % 4, i & 1), shift, size),
              *b = moved(rand_curve(3 + i % 2, i & 2), shift, size);
        ix_meetings m;

        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, a, t, 1, p));
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, b, r, 1, q));
        ix__sub3(p, q, e);
        b = moved(b, e, 1);
        (void)ix__unit3(p + 3, u);
        (void)ix__unit3(q + 3, v);
        ix__cross3(u, v, e);
        if (ix__unit3(e, e) < 0.02) {
            ix_mv_unref(ctx, a);
            ix_mv_unref(ctx, b);
            continue;
        }
        ASSERT_OK(ctx, ix_crv_meetings(ctx, a, b, &m));
        assert_true(m.complete);
        if (with(&m, t, r, tol) != 1)
            fail_msg("case %d: %d meetings, not at (%g, %g)", i, m.n, t, r);
        for (int k = 0; k < m.n; k++)
            assert_true(m.at[k].gap <= m.eps);
        ix_meetings_free(ctx, &m);
        for (int k = 0; k < 3; k++)
            e[k] *= (far > 0 ? 1e-7 : 1e-9) * size;
        b = moved(b, e, 1);
        ASSERT_OK(ctx, ix_crv_meetings(ctx, b, a, &m));
        assert_int_equal(with(&m, r, t, 1e-6), 0);
        ix_meetings_free(ctx, &m);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
}

/* (s, s^k, 0) against (t, 0, t^2): contact of order k - 1 at 0; the parameter
 * is known to the k-th root of 1e-15. */
static void touching(void **state)
{
    (void)state;
    for (int k = 2; k <= 4; k++) {
        double a[15] = {0}, b[9] = {-1, 0, 1, 0, 0, 0, 1, -1, 1};
        double tol = pow(1e-14, 1.0 / k);
        ix_meetings m;
        ix_mv *x, *y;

        for (int i = 0; i <= k; i++) { /* s in [-1, 1]: u = (s + 1) / 2 */
            a[i] = -1 + 2.0 * i / k;
            a[k + 1 + i] = i & 1 ? -1 : 1; /* (2u - 1)^k, up to a sign */
        }
        x = bezier(k + 1, false, a);
        y = bezier(3, false, b);
        ASSERT_OK(ctx, ix_crv_meetings(ctx, x, y, &m));
        assert_true(m.complete);
        assert_int_equal(m.n, 1);
        ASSERT_CLOSE(m.at[0].t[0], 0.5, tol);
        ASSERT_CLOSE(m.at[0].t[1], 0.5, tol);
        assert_true(m.at[0].sine <= 10 * tol);
        ix_meetings_free(ctx, &m);
        ix_mv_unref(ctx, x);
        ix_mv_unref(ctx, y);
    }
}

/* The unit circles of two planes meet in two points, of which one is the seam
 * of both; moved along their common line by 1 in one more, or none. */
static void circles(void **state)
{
    static const double zero[3] = {0, 0, 0};
    const double upright[16] = {1, 0,  0, 0, 0, 0, 1, 0,
                                0, -1, 0, 0, 0, 0, 0, 1};
    const struct {
        double x;
        int n;
    } c[] = {{0, 5}, {1, 0}, {2, 2}, {-2, 2}, {2.1, 0}};
    ix_mv *flat, *turned;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, zero, 1, &flat));
    ASSERT_OK(ctx, ix_mv_transform(ctx, flat, upright, &turned));
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        const double v[3] = {c[i].x, 0, 0};
        ix_mv *other = moved(ix_mv_ref(turned), v, 1);
        ix_meetings m;

        ASSERT_OK(ctx, ix_crv_meetings(ctx, flat, other, &m));
        if (m.n != c[i].n)
            fail_msg("%g: %d meetings", c[i].x, m.n);
        ix_meetings_free(ctx, &m);
        ix_mv_unref(ctx, other);
    }
    ix_mv_unref(ctx, flat);
    ix_mv_unref(ctx, turned);
}

/* Parts of one curve run along each other: the search says so and stops. */
static void along(void **state)
{
    ix_mv *c = rand_curve(4, true), *a, *b, *s = NULL;
    ix_meetings m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_region(ctx, c, 0, 0, 0.6, &a));
    ASSERT_OK(ctx, ix_mv_region(ctx, c, 0, 0.3, 1, &b));
    ASSERT_OK(ctx, ix_crv_meetings(ctx, a, b, &m));
    assert_false(m.complete);
    ix_meetings_free(ctx, &m);
    ASSERT_OK(ctx, ix_mv_promote(ctx, a, 2, 0, &s));
    assert_int_equal(ix_crv_meetings(ctx, a, s, &m), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "operand 2 has 2 directions"));
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s);
}

typedef struct {
    ix_mv *a;
    ix_meetings m;
} operands;

static void make(ix_ctx *own, void *state)
{
    static const double p[9] = {-1, 0, 1, 0, 0, 0, 1, -1, 1};
    const ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    operands *o = state;

    ASSERT_OK(own, ix_mv_new(own, 1, &d, 3, false, p, &o->a));
    o->m = (ix_meetings){.n = 0};
}

static ix_status call(ix_ctx *own, void *state)
{
    operands *o = state;
    static const double turn[16] = {0, 1, 0, 0, 1, 0, 0, 0,
                                    0, 0, 1, 0, 0, 0, 0, 1};
    ix_mv *b;
    ix_status st;

    IX_TRY(ix_mv_transform(own, o->a, turn, &b));
    st = ix_crv_meetings(own, o->a, b, &o->m);
    ix_mv_unref(own, b);
    return st;
}

static void release(ix_ctx *own, void *state)
{
    operands *o = state;

    ix_mv_unref(own, o->a);
    ix_meetings_free(own, &o->m);
}

static void memory_may_fail(void **state)
{
    operands o = {.m = {.n = 0}};
    ix_fault_case c = {make, call, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(made_to_meet),    cmocka_unit_test(touching),
        cmocka_unit_test(circles),         cmocka_unit_test(along),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
