/* Points of R^n equally far from n + 1 objects: the definition by feet found
 * anew, Newton's method from many starts as the other way to find them all,
 * spheres through points, Apollonius. */
#include <string.h>

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/distance.h"
#include "iritx/ops_mbisect.h"
#include "solve/small.h"

IX_TEST_FIXTURE(8801)

static ix_mv *bezier(int ndirs, int order, int nc, const double *pts)
{
    const ix_dir d[2] = {{IX_BEZIER, order, order, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, d, nc, false, pts, &m));
    return m;
}

static ix_mv *rand_mv(int ndirs, int order, int nc)
{
    double p[5 * 8];
    int n = ndirs == 2 ? 2 * order : order;

    for (int i = 0; i < n * nc; i++)
        p[i] = ix_rng_range(&rng, -1, 1);
    return bezier(ndirs, order, nc, p);
}

static double distance(int n, const double *a, const double *b)
{
    double s = 0;

    for (int i = 0; i < n; i++)
        s += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(s);
}

/* Distances equal, and least or stationary: by differences of 1e-5 of the
 * squared distance, whose second derivatives are below 20 here. */
static void check(int n, const ix_mv *const *m, const double *q,
                  const ix_centre *c)
{
    for (int i = 0; i < n; i++) {
        double x[5];

        if (!m[i]) {
            ASSERT_CLOSE(distance(n - 1, c->x, q + i * (n - 1)), c->radius,
                         1e-7 * (1 + c->radius));
            continue;
        }
        ASSERT_OK(ctx, ix_mv_point(ctx, m[i], c->t[i], x));
        ASSERT_CLOSE(distance(n - 1, c->x, x), c->radius,
                     1e-6 * (1 + c->radius));
        for (int k = 0; k < ix_mv_ndirs(m[i]); k++) {
            double t[2] = {c->t[i][0], c->t[i][1]},
                   h = t[k] > 0.5 ? -1e-5 : 1e-5, d;

            t[k] += h;
            ASSERT_OK(ctx, ix_mv_point(ctx, m[i], t, x));
            d = distance(n - 1, c->x, x);
            if (!(fabs(d * d - c->radius * c->radius) <=
                  1e-8 * (1 + c->radius) * (1 + c->radius)))
                fail_msg("object %d: slope %g at distance %g", i,
                         (d * d - c->radius * c->radius) / h, c->radius);
        }
    }
}

/* --- all of them, by Newton's method ---------------------------------------
 *
 * Lines of R^3 in the unknowns s_i: with unit directions u_i the feet are the
 * projections of x, so that the distances are functions of x alone:
 * f_i(x) = |x - p_i|^2 - (u_i.(x - p_i))^2, f_i = f_0 for i = 1, 2, 3. */

typedef struct {
    double p[3], u[3];
} line;

static double squared(const line *l, const double x[3], double grad[3])
{
    double e[3], a;

    ix__sub3(x, l->p, e);
    a = ix__dot3(e, l->u);
    ix__axpy3(e, -a, l->u, e);
    for (int k = 0; k < 3; k++)
        grad[k] = 2 * e[k];
    return ix__dot3(e, e);
}

static bool newton(const line *l, double x[3])
{
    for (int it = 0; it < 60; it++) {
        double g[4][3], f[4], move = 0;
        ix__mat j = {{0}}, inv;

        for (int i = 0; i < 4; i++)
            f[i] = squared(&l[i], x, g[i]);
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 3; k++)
                j[i][k] = g[i + 1][k] - g[0][k];
        if (!ix__small_invert(3, j, inv))
            return false;
        for (int i = 0; i < 3; i++) {
            double d = 0;

            for (int k = 0; k < 3; k++)
                d += inv[i][k] * (f[k + 1] - f[0]);
            x[i] -= d;
            move = fmax(move, fabs(d));
        }
        if (move < 1e-13)
            return true;
        if (!(move < 100))
            return false;
    }
    return false;
}

/* Law: the centres over four segments are those of Newton's method from 1000
 * starts whose feet are on the segments, and no others. */
static void four_lines(void **state)
{
    int total = 0;

    (void)state;
    for (int round = 0; round < 6; round++) {
        const ix_mv *m[4];
        ix_mv *own[4];
        line l[4];
        double len[4], all[64][3];
        ix_centre *c;
        bool complete;
        int n, found = 0;

        for (int i = 0; i < 4; i++) {
            double p[6], a[3], b[3];

            for (int k = 0; k < 3; k++) {
                a[k] = ix_rng_range(&rng, -1, 1);
                b[k] = ix_rng_range(&rng, -1, 1);
            }
            for (int k = 0; k < 3; k++) { /* longer than the middle part */
                p[2 * k] = l[i].p[k] = a[k] - 2 * (b[k] - a[k]);
                p[2 * k + 1] = b[k] + 2 * (b[k] - a[k]);
                l[i].u[k] = b[k] - a[k];
            }
            len[i] = 5 * ix__unit3(l[i].u, l[i].u);
            m[i] = own[i] = bezier(1, 2, 3, p);
        }
        for (int s = 0; s < 1000; s++) {
            double x[3];
            bool ok = true;

            for (int k = 0; k < 3; k++)
                x[k] = ix_rng_range(&rng, -3, 3);
            if (!newton(l, x))
                continue;
            for (int i = 0; i < 4; i++) {
                double e[3], a;

                ix__sub3(x, l[i].p, e);
                a = ix__dot3(e, l[i].u);
                ok = ok && a >= 0 && a <= len[i];
            }
            for (int i = 0; i < found; i++)
                ok = ok && ix__dist3(x, all[i]) > 1e-6;
            if (ok)
                memcpy(all[found++], x, sizeof x);
        }
        ASSERT_OK(ctx,
                  ix_equidistant_centres(ctx, 4, m, NULL, &c, &n, &complete));
        assert_true(complete);
        if (n != found)
            fail_msg("round %d: %d centres, %d by Newton", round, n, found);
        for (int i = 0; i < n; i++) {
            double best = HUGE_VAL;

            for (int k = 0; k < found; k++)
                best = fmin(best, ix__dist3(c[i].x, all[k]));
            assert_true(best <= 1e-8 * (1 + c[i].radius));
            check(4, m, NULL, &c[i]);
        }
        total += n;
        ix_centres_free(ctx, c, n);
        for (int i = 0; i < 4; i++)
            ix_mv_unref(ctx, own[i]);
    }
    assert_true(total > 6);
}

/* Law: each centre fulfils the definition; points, curves, surfaces in any
 * order, in R^2 to R^5. */
static void definition_holds(void **state)
{
    static const char *const kinds[] = {
        "ccc", "pcc", "ppc", "ppcc", "ppsc", "ppps", "ccpp", "pppcc", "pppppc"};
    int total = 0;

    (void)state;
    for (int i = 0; i < 9; i++)
        for (int round = 0; round < 3; round++) {
            int n = (int)strlen(kinds[i]), count;
            const ix_mv *m[6] = {NULL};
            double q[6 * 5];
            ix_centre *c;
            bool complete;

            for (int k = 0; k < n; k++) {
                char kind = kinds[i][(k + round) % n];

                if (kind != 'p')
                    m[k] = rand_mv(kind == 's' ? 2 : 1, kind == 's' ? 2 : 3,
                                   n - 1);
                for (int j = 0; j < n - 1; j++)
                    q[k * (n - 1) + j] = ix_rng_range(&rng, -1, 1);
            }
            ASSERT_OK(ctx, ix_equidistant_centres(ctx, n, m, q, &c, &count,
                                                  &complete));
            for (int k = 0; k < count; k++)
                check(n, m, q, &c[k]);
            total += count;
            ix_centres_free(ctx, c, count);
            for (int k = 0; k < n; k++)
                ix_mv_unref(ctx, m[k]);
        }
    assert_true(total >= 20);
}

/* n + 1 points of R^n have one sphere; on a line none. Three circles of the
 * plane have the eight of Apollonius, as ix_skeleton_points has them. */
static void points_and_circles(void **state)
{
    const ix_mv *m[6] = {NULL};
    double q[30];
    ix_centre *c;
    bool complete;
    int n;

    (void)state;
    for (int k = 3; k <= 6; k++) {
        for (int i = 0; i < k * (k - 1); i++)
            q[i] = ix_rng_range(&rng, -1, 1);
        ASSERT_OK(ctx, ix_equidistant_centres(ctx, k, m, q, &c, &n, &complete));
        assert_int_equal(n, 1);
        check(k, m, q, c);
        ix_centres_free(ctx, c, n);
    }
    for (int i = 0; i < 6; i++)
        q[i] = i / 2;
    ASSERT_OK(ctx, ix_equidistant_centres(ctx, 3, m, q, &c, &n, &complete));
    assert_int_equal(n, 0);
    for (int i = 0; i < 3; i++) {
        const double at[3] = {i - 1.0, i == 1 ? 1.3 : 0.1 * i, 0};
        ix_mv *circle, *flat;

        ASSERT_OK(ctx, ix_circle(ctx, at, 0.3 + 0.05 * i, &circle));
        ASSERT_OK(ctx, ix_mv_coerce(ctx, circle, 2, true, &flat));
        m[i] = flat;
        ix_mv_unref(ctx, circle);
    }
    ASSERT_OK(ctx, ix_equidistant_centres(ctx, 3, m, q, &c, &n, &complete));
    assert_true(complete);
    assert_int_equal(n, 8);
    ix_centres_free(ctx, c, n);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, m[i]);
}

static void expect(int n, const ix_mv *const *m, const char *text)
{
    ix_centre *c;
    bool complete;
    int count;

    assert_int_equal(
        ix_equidistant_centres(ctx, n, m, NULL, &c, &count, &complete),
        IX_EARG);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

static void refused(void **state)
{
    ix_mv *c = rand_mv(1, 3, 2), *s = rand_mv(2, 2, 3);
    const ix_mv *curves[3] = {c, c, s}, *many[4] = {s, s, s, s};

    (void)state;
    expect(2, curves, "2 objects are not 3 .. 6");
    expect(7, curves, "7 objects are not 3 .. 6");
    expect(3, curves, "object 3 has 2 directions and 3 coordinates");
    expect(4, many, "8 parameters of all objects");
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s);
}

typedef struct {
    ix_mv *m[2];
    ix_centre *c;
    int n;
} operands;

static void make(ix_ctx *own, void *state)
{
    static const double p[2][6] = {{-1, 0, 1, 0.5, 0, 0.6}, {-1, 1, -1, -0.5}};
    const ix_dir d[2] = {{IX_BEZIER, 3, 3, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    operands *o = state;

    for (int i = 0; i < 2; i++)
        ASSERT_OK(own, ix_mv_new(own, 1, &d[i], 2, false, p[i], &o->m[i]));
    o->c = NULL;
    o->n = 0;
}

static ix_status call(ix_ctx *own, void *state)
{
    static const double q[6] = {0, 0, 0, 0, 0.2, 0.1};
    operands *o = state;
    const ix_mv *m[3] = {o->m[0], o->m[1], NULL};
    bool complete;

    return ix_equidistant_centres(own, 3, m, q, &o->c, &o->n, &complete);
}

static void release(ix_ctx *own, void *state)
{
    operands *o = state;

    ix_mv_unref(own, o->m[0]);
    ix_mv_unref(own, o->m[1]);
    ix_centres_free(own, o->c, o->n);
}

static void memory_may_fail(void **state)
{
    operands o = {.c = NULL};
    ix_fault_case c = {make, call, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_lines),
        cmocka_unit_test(definition_holds),
        cmocka_unit_test(points_and_circles),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
