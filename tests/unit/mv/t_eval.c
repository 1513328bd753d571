/* Values, derivatives and blossoms, each against another way of getting them.
 */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"

IX_TEST_FIXTURE(3)

/* --- another evaluator: the recursive definition of B-splines ------------- */

static double power(double t, int k)
{
    return k ? t * power(t, k - 1) : 1;
}

/* B(i, order)(t) by Cox and de Boor, right-continuous but at the end hi. */
static double basis(const double *k, int i, int order, double t, double hi)
{
    double l, r;

    if (order == 1)
        return t >= hi ? k[i] < hi && k[i + 1] >= hi
                       : k[i] <= t && t < k[i + 1];
    l = k[i + order - 1] - k[i];
    r = k[i + order] - k[i + 1];
    l = l > 0 ? (t - k[i]) / l * basis(k, i, order - 1, t, hi) : 0;
    r = r > 0 ? (k[i + order] - t) / r * basis(k, i + 1, order - 1, t, hi) : 0;
    return l + r;
}

/* Weight of stored point i of a direction by the definition. */
static double weight(const ix_mv *m, int d, int i, double t)
{
    ix_dir dir = ix_mv_dir(m, d);
    double dom[2], sum = 0, bez[64];
    int n = dir.length + (dir.periodic ? dir.order - 1 : 0);

    ix_mv_domain(m, d, dom);
    if (dir.basis == IX_POWER)
        return power(t, i);
    if (dir.basis == IX_BEZIER) {
        for (int k = 0; k < 2 * dir.order; k++)
            bez[k] = k >= dir.order;
        return basis(bez, i, dir.order, t, 1);
    }
    for (int k = i; k < n; k += dir.length)
        sum += basis(dir.knots, k, dir.order, t, dom[1]);
    return sum;
}

static double value(const ix_mv *m, int axis, const double *t)
{
    double sum = 0;

    for (size_t p = 0; p < ix_mv_npts(m); p++) {
        double w = 1;
        size_t rest = p;

        for (int d = 0; d < ix_mv_ndirs(m); d++) {
            size_t n = (size_t)ix_mv_length(m, d);

            w *= weight(m, d, (int)(rest % n), t[d]);
            rest /= n;
        }
        sum += w * ix_mv_axis(m, axis)[p];
    }
    return sum;
}

static void values_follow_the_definition(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_ALL, .max_order = 4, .max_knots = 2};

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        double t[IX_MAX_DIRS], v[IX_MAX_COORDS + 1];

        for (int i = 0; i < 4; i++) {
            ix_mv_randparam(&rng, m, t);
            ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, v));
            for (int a = 0; a < ix_mv_naxes(m); a++)
                ASSERT_CLOSE(v[a], value(m, a, t), 2e-14);
        }
        ix_mv_unref(ctx, m);
    }
}

/* Law: a constant stays exactly that, and derivatives of it are 0. */
static void constants_are_exact(void **state)
{
    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *c;
        ix_dir dirs[IX_MAX_DIRS];
        double *pts = malloc(ix_mv_npts(m) * sizeof *pts), v, t[IX_MAX_DIRS];
        int one[IX_MAX_DIRS] = {1};

        assert_non_null(pts);
        for (size_t i = 0; i < ix_mv_npts(m); i++)
            pts[i] = 0.1;
        for (int d = 0; d < ix_mv_ndirs(m); d++)
            dirs[d] = ix_mv_dir(m, d);
        ASSERT_OK(ctx, ix_mv_new(ctx, ix_mv_ndirs(m), dirs, 1, false, pts, &c));
        ix_mv_randparam(&rng, m, t);
        ASSERT_OK(ctx, ix_mv_eval(ctx, c, t, &v));
        assert_true(v == 0.1);
        ASSERT_OK(ctx, ix_mv_partial(ctx, c, t, one, &v));
        assert_true(v == 0);
        free(pts);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, m);
    }
}

/* Law: derivatives are the limits of difference quotients; the first from
 * values, the second from the first. */
static void derivatives_follow_differences(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_BEZIER | IX_RAND_POWER, .max_order = 5};
    const double h = 1e-5;

    (void)state;
    for (int n = 0; n < 60; n++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        int d = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1);
        double lo[19], hi[19], der[19], t[IX_MAX_DIRS];

        for (int i = 0; i < ix_mv_ndirs(m); i++)
            t[i] = ix_rng_range(&rng, 0.1, 0.9);
        for (int order = 1; order < 3; order++) {
            int k[IX_MAX_DIRS] = {0};

            k[d] = order;
            ASSERT_OK(ctx, ix_mv_partial(ctx, m, t, k, der));
            k[d]--;
            t[d] -= h;
            ASSERT_OK(ctx, ix_mv_partial(ctx, m, t, k, lo));
            t[d] += 2 * h;
            ASSERT_OK(ctx, ix_mv_partial(ctx, m, t, k, hi));
            t[d] -= h;
            /* h^2 of truncation, third derivatives below 10^3 */
            for (int a = 0; a < ix_mv_naxes(m); a++)
                ASSERT_CLOSE(der[a], (hi[a] - lo[a]) / (2 * h), 1e-6);
        }
        ix_mv_unref(ctx, m);
    }
}

/* Law: the rational quarter circle has constant distance and its derivatives
 * turn with the point. */
static void derivatives_of_a_circle(void **state)
{
    const double s = sqrt(0.5);
    const double pts[] = {1, s, 1, 1, s, 0, 0, s, 1};
    const ix_dir dir = {IX_BEZIER, 3, 3, false, NULL};
    double c[3][2], zero[8][2];
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, true, pts, &m));
    for (double t = 0; t <= 1; t += 0.125) {
        double speed2, along;

        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, m, t, 2, &c[0][0]));
        ASSERT_CLOSE(hypot(c[0][0], c[0][1]), 1, 4e-16);
        ASSERT_CLOSE(c[0][0] * c[1][0] + c[0][1] * c[1][1], 0, 1e-15);
        speed2 = c[1][0] * c[1][0] + c[1][1] * c[1][1];
        along = c[0][0] * c[2][0] + c[0][1] * c[2][1];
        ASSERT_CLOSE(along, -speed2, 1e-14);
    }
    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, m, 0.3, 7, &zero[0][0]));
    ix_mv_unref(ctx, m);
}

/* Law: equal arguments give the value; consecutive knots the control point. */
static void blossoms(void **state)
{
    ix_rand_opts o = {
        .ndirs = 1, .min_order = 2, .kinds = IX_RAND_BEZIER | IX_RAND_OPEN};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        ix_dir dir = ix_mv_dir(m, 0);
        double t, args[8], v[19], b[19];
        const double *all[] = {args};
        int i = ix_rng_int(&rng, 0, dir.length - 1);

        ix_mv_randparam(&rng, m, &t);
        for (int j = 0; j < 8; j++)
            args[j] = t;
        ASSERT_OK(ctx, ix_mv_eval(ctx, m, &t, v));
        ASSERT_OK(ctx, ix_mv_blossom(ctx, m, all, b));
        for (int a = 0; a < ix_mv_naxes(m); a++)
            ASSERT_CLOSE(v[a], b[a], 1e-14);
        if (dir.basis == IX_BSPLINE) {
            all[0] = dir.knots + i + 1;
            ASSERT_OK(ctx, ix_mv_blossom(ctx, m, all, b));
            for (int a = 0; a < ix_mv_naxes(m); a++)
                ASSERT_CLOSE(b[a], ix_mv_axis(m, a)[i], 1e-11);
        }
        ix_mv_unref(ctx, m);
    }
}

/* --- many points -----------------------------------------------------------
 */

static void many_like_one(ix_mv *m, size_t n, double tol)
{
    size_t nd = (size_t)ix_mv_ndirs(m), na = (size_t)ix_mv_naxes(m);
    size_t nc = (size_t)ix_mv_ncoords(m);
    double *t = malloc(nd * n * sizeof *t), *out = malloc(na * n * sizeof *out);
    double *pts = malloc(nc * n * sizeof *pts), v[19], x[IX_MAX_DIRS];

    assert_true(t && out && pts);
    for (size_t i = 0; i < n; i++) {
        ix_mv_randparam(&rng, m, x);
        for (size_t d = 0; d < nd; d++)
            t[d * n + i] = x[d];
    }
    ASSERT_OK(ctx, ix_mv_eval_many(ctx, m, n, t, out));
    ASSERT_OK(ctx, ix_mv_point_many(ctx, m, n, t, pts));
    for (size_t i = 0; i < n; i++) {
        for (size_t d = 0; d < nd; d++)
            x[d] = t[d * n + i];
        ASSERT_OK(ctx, ix_mv_eval(ctx, m, x, v));
        for (size_t a = 0; a < na; a++)
            ASSERT_CLOSE(out[a * n + i], v[a], tol);
        ASSERT_OK(ctx, ix_mv_point(ctx, m, x, v));
        for (size_t c = 0; c < nc; c++)
            ASSERT_CLOSE(pts[c * n + i], v[c], 10 * tol);
    }
    free(t);
    free(out);
    free(pts);
}

static void many_points(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_ALL, .max_order = 5};

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *m;

        o.ncoords = k % 4 ? 0 : ix_rng_int(&rng, 1, 18);
        m = ix_mv_randtest(ctx, &rng, &o);
        many_like_one(m, 3, 1e-14);
        many_like_one(m, (size_t)ix_rng_int(&rng, 300, 900), 1e-14);
        ix_mv_unref(ctx, m);
    }
}

static void many_points_of_many_directions(void **state)
{
    ix_rand_opts o = {.ndirs = 6,
                      .max_order = 3,
                      .max_knots = 1,
                      .ncoords = 18,
                      .rational = 1};

    (void)state;
    for (int k = 0; k < 3; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);

        many_like_one(m, 40, 2e-14);
        ix_mv_unref(ctx, m);
    }
}

static void many_points_of_high_order(void **state)
{
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 1,
                      .rational = -1,
                      .min_order = 400,
                      .max_order = 400,
                      .max_knots = 1,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN};

    (void)state;
    for (int k = 0; k < 2; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);

        many_like_one(m, 55, 4e-13); /* 2 d ulp */
        ix_mv_unref(ctx, m);
    }
}

/* Very uneven knots: many spans in one bucket of the table. */
static void many_points_uneven(void **state)
{
    double knots[104], pts[100], x = 1;
    ix_dir dir = {IX_BSPLINE, 4, 100, false, knots};
    ix_mv *m;

    (void)state;
    for (int i = 0; i < 100; i++)
        pts[i] = ix_rng_unit(&rng);
    for (int i = 103; i >= 0; i--) {
        x *= i < 100 ? 0.7 : 1;
        knots[i] = i < 4 ? 0 : x;
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    many_like_one(m, 2000, 1e-14);
    ix_mv_unref(ctx, m);
}

/* Law: the bits do not depend on the number of threads. */
static void threads_do_not_matter(void **state)
{
    enum { N = 60000 };
    ix_rand_opts o = {.ndirs = 2,
                      .ncoords = 3,
                      .rational = 1,
                      .min_order = 3,
                      .unit = true,
                      .kinds = IX_RAND_OPEN};
    ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
    double *t = malloc(2 * N * sizeof *t), *one = malloc(3 * N * sizeof *one);
    double *two = malloc(3 * N * sizeof *two);

    (void)state;
    assert_true(t && one && two);
    for (int i = 0; i < 2 * N; i++)
        t[i] = ix_rng_unit(&rng);
    ix_ctx_set_threads(ctx, 1);
    ASSERT_OK(ctx, ix_mv_point_many(ctx, m, N, t, one));
    ix_ctx_set_threads(ctx, 4);
    ASSERT_OK(ctx, ix_mv_point_many(ctx, m, N, t, two));
    ix_ctx_set_threads(ctx, 0);
    assert_memory_equal(one, two, 3 * N * sizeof *one);
    free(t);
    free(one);
    free(two);
    ix_mv_unref(ctx, m);
}

static void grid(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_ALL};

    (void)state;
    for (int k = 0; k < 30; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        int nd = ix_mv_ndirs(m), counts[IX_MAX_DIRS], q[IX_MAX_DIRS] = {0};
        double t[3][8], x[IX_MAX_DIRS], out[19 * 512], v[19];
        const double *axes[3] = {t[0], t[1], t[2]};
        size_t n = 1;

        for (int d = 0; d < nd; d++) {
            counts[d] = ix_rng_int(&rng, 1, 8);
            n *= (size_t)counts[d];
        }
        for (int i = 0; i < 8; i++) {
            ix_mv_randparam(&rng, m, x);
            for (int d = 0; d < nd; d++)
                t[d][i] = x[d];
        }
        ASSERT_OK(ctx, ix_mv_eval_grid(ctx, m, counts, axes, out));
        for (size_t i = 0; i < n; i++) {
            for (int d = 0; d < nd; d++)
                x[d] = t[d][q[d]];
            ASSERT_OK(ctx, ix_mv_eval(ctx, m, x, v));
            for (int a = 0; a < ix_mv_naxes(m); a++)
                ASSERT_CLOSE(out[(size_t)a * n + i], v[a], 4e-15 * 6);
            for (int d = 0; d < nd && ++q[d] == counts[d]; d++)
                q[d] = 0;
        }
        ix_mv_unref(ctx, m);
    }
}

/* --- conventions and errors ------------------------------------------------
 */

static void ends_and_knots(void **state)
{
    const double knots[] = {0, 0, 1, 1, 3, 3}, pts[] = {0, 1, 5, 6};
    const ix_dir dir = {IX_BSPLINE, 2, 4, false, knots};
    const double t[] = {0, 1, 3, 3.00001}, want[] = {0, 5, 6, 6};
    double v;
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, false, pts, &m));
    for (int i = 0; i < 4; i++) {
        ASSERT_OK(ctx, ix_mv_eval(ctx, m, t + i, &v));
        assert_true(v == want[i]); /* right-continuous; the end exactly */
    }
    ix_mv_unref(ctx, m);
}

static void bezier_extrapolates(void **state)
{
    const double pts[] = {0, 1, 3, 0, 1, 0};
    const ix_dir dir = {IX_BEZIER, 3, 3, false, NULL};
    double t[2] = {1.5, -0.5}, v[2];
    ix_mv *m, *b;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, pts, &m));
    ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
    ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, v));
    assert_true(v[0] == 5.25 && v[1] == -1.5);
    ASSERT_OK(ctx, ix_mv_eval(ctx, b, t + 1, v));
    assert_true(v[0] == -0.75 && v[1] == -1.5);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, m);
}

static void errors(void **state)
{
    const double knots[] = {0, 0, 1, 2, 2}, pts[] = {0, 1, 2, 1, -1, 1};
    const ix_dir dir = {IX_BSPLINE, 2, 3, false, knots};
    double v[2], outside = 2.1, many[100], grid_t = -1, pole = 0.5;
    const double *axes[] = {&grid_t};
    int k = -1, count = 1, none = 0;
    ix_mv *m;

    (void)state;
    for (int i = 0; i < 100; i++)
        many[i] = i == 77 ? (double)NAN : 1;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, pts, &m));
    assert_int_equal(ix_mv_eval(ctx, m, &outside, v), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "2.1"));
    assert_int_equal(ix_mv_eval(ctx, m, many + 77, v), IX_EDOMAIN);
    assert_int_equal(ix_mv_partial(ctx, m, many, &k, v), IX_EARG);
    assert_int_equal(ix_mv_eval_many(ctx, m, 100, many, v), IX_EDOMAIN);
    assert_int_equal(ix_mv_eval_grid(ctx, m, &count, axes, v), IX_EDOMAIN);
    assert_int_equal(ix_mv_eval_grid(ctx, m, &none, axes, v), IX_EARG);
    assert_int_equal(ix_mv_curve_derivs(ctx, m, 0.5, -1, v), IX_EARG);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true,
                             (double[]){-1, 1, 1, 1, 1, 1}, &m));
    assert_int_equal(ix_mv_point(ctx, m, &pole, v), IX_EDOMAIN);
    assert_int_equal(ix_mv_curve_derivs(ctx, m, 0.5, 0, v), IX_EDOMAIN);
    ix_mv_unref(ctx, m);
}

/* Values with every allocation failing. */
typedef struct {
    ix_mv *m;
    double t[2 * 600], out[4 * 600];
} fault_state;

static void fault_setup(ix_ctx *c, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(5);
    ix_rand_opts o = {.ndirs = 2,
                      .ncoords = 3,
                      .rational = 1,
                      .min_order = 3,
                      .kinds = IX_RAND_OPEN};

    s->m = ix_mv_randtest(c, &r, &o);
    for (int i = 0; i < 600; i++)
        ix_mv_randparam(&r, s->m, s->t + 2 * i);
    for (int d = 0; d < 2; d++) { /* any value inside both domains will do */
        double dom[2];

        ix_mv_domain(s->m, d, dom);
        for (int i = 0; i < 600; i++)
            s->t[d * 600 + i] = dom[0] + (dom[1] - dom[0]) * i / 600;
    }
}

static ix_status fault_many(ix_ctx *c, void *state)
{
    fault_state *s = state;

    return ix_mv_point_many(c, s->m, 600, s->t, s->out);
}

static ix_status fault_grid(ix_ctx *c, void *state)
{
    fault_state *s = state;
    const double *axes[] = {s->t, s->t + 600};
    int counts[] = {20, 20};

    return ix_mv_eval_grid(c, s->m, counts, axes, s->out);
}

static ix_status fault_one(ix_ctx *c, void *state)
{
    fault_state *s = state;
    double t[2] = {s->t[5], s->t[605]};

    return ix_mv_point(c, s->m, t, s->out);
}

static void fault_teardown(ix_ctx *c, void *state)
{
    ix_mv_unref(c, ((fault_state *)state)->m);
}

static void out_of_memory(void **state)
{
    static fault_state s;
    ix_status (*const run[])(ix_ctx *, void *) = {fault_many, fault_grid,
                                                  fault_one};

    (void)state;
    for (int i = 0; i < 3; i++)
        ix_fault_run(&(ix_fault_case){fault_setup, run[i], fault_teardown, &s});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_follow_the_definition),
        cmocka_unit_test(constants_are_exact),
        cmocka_unit_test(derivatives_follow_differences),
        cmocka_unit_test(derivatives_of_a_circle),
        cmocka_unit_test(blossoms),
        cmocka_unit_test(many_points),
        cmocka_unit_test(many_points_of_many_directions),
        cmocka_unit_test(many_points_of_high_order),
        cmocka_unit_test(many_points_uneven),
        cmocka_unit_test(threads_do_not_matter),
        cmocka_unit_test(grid),
        cmocka_unit_test(ends_and_knots),
        cmocka_unit_test(bezier_extrapolates),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
