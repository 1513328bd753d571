/* Pieces and arcs against dense samples of the curve: the tolerance holds, the
 * pieces join, known curves come back exactly. */
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/geom.h"

static const double origin[3] = {0, 0, 0};

/* Distance of p from the piece's nearest point, by search and refinement. */
static double nearest(ix_ctx *ctx, const ix_mv *m, const double *p)
{
    double best = HUGE_VAL, at = 0, q[18], width = 1.0 / 32;

    for (int round = 0; round < 8; round++) {
        double from = at, step = width / (round ? 4 : 1);

        for (int i = round ? -4 : 0; i <= (round ? 4 : 32); i++) {
            double t = fmin(1, fmax(0, from + i * step)), d = 0;

            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, q));
            for (int c = 0; c < ix_mv_ncoords(m); c++)
                d = hypot(d, p[c] - q[c]);
            if (d < best) {
                best = d;
                at = t;
            }
        }
        width = round ? step : width;
    }
    return best;
}

/* Laws: intervals cover the domain in order, pieces meet where the curve is
 * continuous, every sample of the curve is within tol of its piece. */
static void check_pieces(ix_ctx *ctx, const ix_mv *c, const ix_crvs *ps,
                         double tol, bool same_parameter)
{
    double dom[2], p[18], q[18];
    int nc = ix_mv_ncoords(c);

    ix_mv_domain(c, 0, dom);
    assert_true(ps->n > 0 && ps->t[0] == dom[0] &&
                ps->t[2 * ps->n - 1] == dom[1]);
    for (int k = 0; k < ps->n; k++) {
        double a = ps->t[2 * k], b = ps->t[2 * k + 1];

        assert_true(a < b && (k == 0 || a == ps->t[2 * k - 1]));
        for (int i = 0; i <= 12; i++) {
            double u = fmin(i / 12.0, 1 - 1e-12), t = a + (b - a) * u, d = 0;

            ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, p));
            if (same_parameter) {
                ASSERT_OK(ctx, ix_mv_point(ctx, ps->crv[k], &u, q));
                for (int x = 0; x < nc; x++)
                    d = hypot(d, p[x] - q[x]);
            } else {
                d = nearest(ctx, ps->crv[k], p);
            }
            assert_true(d <= tol * (1 + 1e-6));
        }
    }
}

static void pieces_hold_their_tolerance(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(51);
    ix_rand_opts o = {.ndirs = 1, .max_knots = 4};

    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_mv *c = ix_mv_randtest(ctx, &r, &o);
        double tol = pow(10, -1 - k % 5), err;
        int order = 3 + k % 2;
        ix_crvs ps;

        ASSERT_OK(ctx, ix_fit_pieces(ctx, c, order, tol, 0, &err, &ps));
        assert_true(err <= tol);
        check_pieces(ctx, c, &ps, tol, true);
        for (int i = 0; i < ps.n; i++) {
            assert_int_equal(ix_mv_order(ps.crv[i], 0), order);
            assert_false(ix_mv_rational(ps.crv[i]));
        }
        ix_crvs_free(ctx, &ps);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* Law: pieces become no more numerous than the order of convergence asks. */
static void pieces_converge(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_crvs ps;
    int n[2];
    ix_mv *c;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, origin, 1, &c));
    for (int order = 3; order <= 4; order++) {
        for (int i = 0; i < 2; i++) {
            ASSERT_OK(ctx, ix_fit_pieces(ctx, c, order, i ? 1e-8 : 1e-4, 0,
                                         NULL, &ps));
            n[i] = ps.n;
            ix_crvs_free(ctx, &ps);
        }
        /* 1e4^(1/3) = 21.5, 1e4^(1/4) = 10 */
        assert_true(n[1] <= n[0] * (order == 3 ? 25 : 12));
    }
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Law: knots do not cut pieces: as many as for the curve itself. */
static void knots_do_not_cut(void **state)
{
    enum { N = 300 };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double pts[2 * N];
    const ix_interpolate_opts o = {.order = 4};
    ix_mv *c;
    ix_crvs ps;

    (void)state;
    for (int i = 0; i < N; i++) {
        double a = 6.283185307179586 * i / (N - 1);

        pts[i] = cos(a);
        pts[N + i] = sin(a);
    }
    ASSERT_OK(ctx, ix_interpolate(ctx, N, 2, false, pts, &o, NULL, &c));
    ASSERT_OK(ctx, ix_fit_pieces(ctx, c, 4, 1e-3, 0, NULL, &ps));
    /* cubic Hermite on h radians errs by h^4 / 384: h = 0.79, 8 and a rest */
    assert_true(ps.n <= 9);
    check_pieces(ctx, c, &ps, 1e-3, true);
    ix_crvs_free(ctx, &ps);
    ASSERT_OK(ctx, ix_biarcs(ctx, c, 1e-4, 170, NULL, &ps));
    assert_true(ps.n <= 8); /* it is a circle within 1e-8 */
    check_pieces(ctx, c, &ps, 1e-4, false);
    ix_crvs_free(ctx, &ps);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Law: corners stay: the pieces end there. */
static void corners_cut(void **state)
{
    static const double knots[7] = {0, 0, 1, 2, 3, 4, 4};
    static const double pts[10] = {0, 1, 1, 0, 0, 0, 0, 1, 1, 0};
    const ix_dir d = {
        .basis = IX_BSPLINE, .order = 2, .length = 5, .knots = knots};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c;
    ix_crvs ps;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &c));
    for (int k = 0; k < 2; k++) {
        if (k)
            ASSERT_OK(ctx, ix_biarcs(ctx, c, 100, 170, NULL, &ps));
        else
            ASSERT_OK(ctx, ix_fit_pieces(ctx, c, 3, 100, 0, NULL, &ps));
        assert_int_equal(ps.n, 4);
        check_pieces(ctx, c, &ps, 1e-5, false); /* as fine as it searches */
        ix_crvs_free(ctx, &ps);
    }
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void exact_and_limited(void **state)
{
    static const double pts[6] = {0, 1, 3, 0, 2, 0};
    const ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double all, len, err;
    ix_mv *c;
    ix_crvs ps;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &c));
    ASSERT_OK(ctx, ix_fit_pieces(ctx, c, 3, 1e-12, 0, &err, &ps));
    assert_int_equal(ps.n, 1);
    assert_true(ix_mv_equal(ps.crv[0], c, 1e-15));
    ix_crvs_free(ctx, &ps);
    ASSERT_OK(ctx, ix_length(ctx, c, NULL, &all));
    ASSERT_OK(ctx, ix_fit_pieces(ctx, c, 4, 1e-3, all / 6.5, &err, &ps));
    assert_int_equal(ps.n, 7);
    for (int i = 0; i < ps.n; i++) {
        ASSERT_OK(ctx, ix_length(ctx, ps.crv[i], NULL, &len));
        assert_true(len <= all / 6.5);
    }
    check_pieces(ctx, c, &ps, 1e-12, true);
    ix_crvs_free(ctx, &ps);
    assert_int_equal(ix_fit_pieces(ctx, c, 5, 1e-3, 0, NULL, &ps), IX_EARG);
    assert_int_equal(ix_fit_pieces(ctx, c, 3, 0, 0, NULL, &ps), IX_EARG);
    assert_int_equal(ix_fit_pieces(ctx, c, 3, (double)NAN, 0, NULL, &ps),
                     IX_EARG);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Tangent at an end of a quadratic arc, homogeneous points. */
static void end_tangent(const ix_mv *m, bool end, double out[2])
{
    const double *w = ix_mv_weights(m);
    double len;

    for (int c = 0; c < 2; c++) {
        const double *x = ix_mv_coord(m, c);

        out[c] = end ? x[2] / w[2] - x[1] / w[1] : x[1] / w[1] - x[0] / w[0];
    }
    len = hypot(out[0], out[1]);
    out[0] /= len;
    out[1] /= len;
}

/* Laws: within tol; every piece is a circular arc within the angle; pieces of
 * a smooth curve join smoothly. */
static void arcs_hold_their_tolerance(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(52);
    ix_rand_opts o = {.ndirs = 1,
                      .ncoords = 2,
                      .kinds = IX_RAND_BEZIER | IX_RAND_OPEN | IX_RAND_PERIODIC,
                      .min_order = 3,
                      .max_order = 5,
                      .max_knots = 3};

    (void)state;
    for (int k = 0; k < 12; k++) {
        ix_mv *c = ix_mv_randtest(ctx, &r, &o);
        double tol = pow(10, -1 - k % 4), angle = k % 2 ? 170 : 30, err;
        ix_crvs ps;

        ASSERT_OK(ctx, ix_biarcs(ctx, c, tol, angle, &err, &ps));
        assert_true(err <= tol);
        check_pieces(ctx, c, &ps, tol, false);
        for (int i = 0; i < ps.n; i++) {
            const double *w = ix_mv_weights(ps.crv[i]);
            double center[3], a[2], b[2];

            assert_true(w[0] == 1 && w[2] == 1 && w[1] <= 1 + 1e-15);
            assert_true(w[1] >= cos(angle / 2 * 0.017453292519943295) - 1e-12);
            if (ix_arc_center(ps.crv[i], center)) {
                double rad[2], t[2] = {0, 0.37}, p[2];

                for (int j = 0; j < 2; j++) {
                    ASSERT_OK(ctx, ix_mv_point(ctx, ps.crv[i], &t[j], p));
                    rad[j] = hypot(p[0] - center[0], p[1] - center[1]);
                }
                ASSERT_CLOSE(rad[0] / rad[1], 1, 1e-9);
            }
            if (i == 0 || ps.t[2 * i] != ps.t[2 * i - 1])
                continue;
            end_tangent(ps.crv[i - 1], true, a);
            end_tangent(ps.crv[i], false, b);
            /* at a knot of low continuity there may be a corner */
            if (ix_mv_dir(c, 0).basis == IX_BEZIER && w[1] < 1)
                assert_true(a[0] * b[0] + a[1] * b[1] > 1 - 1e-6);
        }
        ix_crvs_free(ctx, &ps);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

static void known_arcs(void **state)
{
    static const double line[6] = {0, 1, 0, 2, 5, 5};
    static const double cusp[8] = {0, 2, -1, 1, 0, 1, 1, 0};
    const ix_dir two = {.basis = IX_BEZIER, .order = 2, .length = 2};
    const ix_dir four = {.basis = IX_BEZIER, .order = 4, .length = 4};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double center[3];
    ix_mv *c;
    ix_crvs ps;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, (double[]){1, 2, 3}, 2, &c));
    ASSERT_OK(ctx, ix_biarcs(ctx, c, 1e-9, 100, NULL, &ps));
    assert_int_equal(ps.n, 4); /* the circle's own quarters */
    for (int i = 0; i < 4; i++) {
        assert_true(ix_arc_center(ps.crv[i], center));
        ASSERT_CLOSE(center[0], 1, 1e-12);
        ASSERT_CLOSE(center[1], 2, 1e-12);
        ASSERT_CLOSE(center[2], 3, 1e-12);
    }
    ix_crvs_free(ctx, &ps);
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &two, 3, false, line, &c));
    ASSERT_OK(ctx, ix_biarcs(ctx, c, 1e-9, 100, NULL, &ps));
    assert_int_equal(ps.n, 1);
    assert_false(ix_arc_center(ps.crv[0], center));
    ix_crvs_free(ctx, &ps);
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &four, 2, false, cusp, &c));
    ASSERT_OK(ctx, ix_biarcs(ctx, c, 1e-3, 90, NULL, &ps));
    check_pieces(ctx, c, &ps, 1e-3, false);
    ix_crvs_free(ctx, &ps);
    assert_int_equal(ix_biarcs(ctx, c, -1, 90, NULL, &ps), IX_EARG);
    assert_int_equal(ix_biarcs(ctx, c, 1e-3, 0, NULL, &ps), IX_EARG);
    ix_mv_unref(ctx, c);
    ASSERT_OK(ctx, ix_hermite(ctx, origin, (double[]){1, 1, 1},
                              (double[]){1, 0, 0}, (double[]){0, 1, 0}, &c));
    assert_int_equal(ix_biarcs(ctx, c, 1e-3, 90, NULL, &ps), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "z = const"));
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

static void setup(ix_ctx *ctx, void *state)
{
    ASSERT_OK(ctx, ix_pcircle(ctx, origin, 1, (ix_mv **)state));
}

static ix_crvs made[2];

static ix_status run(ix_ctx *ctx, void *state)
{
    ix_mv **m = state;
    ix_status st = ix_fit_pieces(ctx, *m, 3, 0.05, 0, NULL, &made[0]);

    made[1] = (ix_crvs){0};
    if (st == IX_OK)
        st = ix_biarcs(ctx, *m, 0.05, 90, NULL, &made[1]);
    return st;
}

static void drop(ix_ctx *ctx, void *state)
{
    ix_mv_unref(ctx, *(ix_mv **)state);
    ix_crvs_free(ctx, &made[0]);
    ix_crvs_free(ctx, &made[1]);
}

static void out_of_memory(void **state)
{
    ix_mv *m;
    const ix_fault_case c = {setup, run, drop, &m};

    (void)state;
    assert_true(ix_fault_run(&c) >= 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_hold_their_tolerance),
        cmocka_unit_test(pieces_converge),
        cmocka_unit_test(knots_do_not_cut),
        cmocka_unit_test(corners_cut),
        cmocka_unit_test(exact_and_limited),
        cmocka_unit_test(arcs_hold_their_tolerance),
        cmocka_unit_test(known_arcs),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
