/* t_mv_fit.c - freeforms of any number of directions through data: the data are
 * met, polynomials come back. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

/* A polynomial of degrees (2, 1, 2) in (u, v, w) with two coordinates. */
static void poly212(const double t[3], double out[2])
{
    double u = t[0], v = t[1], w = t[2];

    out[0] = 1 + u - 2 * u * u * w + v * u * w * w;
    out[1] = 3 * v - u * v * w + u * u * v - w * w;
}

/* Law: the value at node (i, j, k) is control point (i, j, k) of the data, on
 * the same knots, whatever their kind (not with a knot as often as the order).
 */
static void nodes_are_met(void **state)
{
    const int zero[3] = {0, 0, 0};
    gt t = gt_begin(31);

    (void)state;
    for (int round = 0; round < 24; round++) {
        int nd = 1 + round % 3;
        const ix_rand_opts o = {.ndirs = nd,
                                .ncoords = 2,
                                .rational = 0,
                                .kinds = IX_RAND_BEZIER | IX_RAND_OPEN,
                                .min_order = 2,
                                .max_order = 4,
                                .max_knots = 2};
        ix_mv *m = ix_mv_randtest(t.ctx, &t.r, &o), *f = NULL;
        ix_status st = ix_mv_fit_nodes(t.ctx, m, zero, zero, &f);
        double *node[3], p[3];

        if (st == IX_EDOMAIN) { /* two nodes in one */
            ix_mv_unref(t.ctx, m);
            continue;
        }
        ASSERT_OK(t.ctx, st);
        for (int d = 0; d < nd; d++) {
            ix_dir dir = ix_mv_dir(m, d);

            node[d] = test_malloc((size_t)dir.length * sizeof(double));
            ix_knots_nodes(&dir, node[d]);
            assert_int_equal(ix_mv_order(f, d), dir.order);
            assert_int_equal(ix_mv_length(f, d), dir.length);
        }
        for (size_t i = 0; i < ix_mv_npts(m); i++) {
            size_t left = i;
            double at[3];

            for (int d = 0; d < nd; d++) {
                at[d] = node[d][left % (size_t)ix_mv_length(m, d)];
                left /= (size_t)ix_mv_length(m, d);
            }
            ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, f, at, p));
            for (int a = 0; a < ix_mv_naxes(m); a++)
                ASSERT_CLOSE(p[a], ix_mv_axis(m, a)[i], 1e-10);
        }
        for (int d = 0; d < nd; d++)
            test_free(node[d]);
        ix_mv_unref(t.ctx, f);
        ix_mv_unref(t.ctx, m);
    }
    gt_end(&t);
}

/* Law: data on a line in each direction come back as that line with fewer
 * control points: the nodes of the data are the abscissae. */
static void fewer_at_nodes(void **state)
{
    const double kv[11] = {2, 2, 2, 2, 2.5, 3, 4.5, 5, 5, 5, 5};
    const ix_dir dir = {IX_BSPLINE, 4, 7, false, kv};
    const int order[1] = {3}, size[1] = {4};
    gt t = gt_begin(32);
    double node[7], val[7], p[IX_MAX_COORDS];
    ix_mv *m, *f;

    (void)state;
    ix_knots_nodes(&dir, node);
    for (int i = 0; i < 7; i++)
        val[i] = 3 * node[i] * node[i] - node[i] + 1; /* a parabola */
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 1, &dir, 1, false, val, &m));
    ASSERT_OK(t.ctx, ix_mv_fit_nodes(t.ctx, m, order, size, &f));
    assert_int_equal(ix_mv_length(f, 0), 4);
    assert_int_equal(ix_mv_order(f, 0), 3);
    for (int i = 0; i < 20; i++) {
        double at = ix_rng_range(&t.r, 2, 5);

        gt_point(&t, f, &at, p);
        ASSERT_CLOSE(p[0], 3 * at * at - at + 1, 1e-11);
    }
    ix_mv_unref(t.ctx, f);
    ix_mv_unref(t.ctx, m);
    gt_end(&t);
}

/* Law: grids are met; scattered points on a polynomial give the polynomial. */
static void three_directions(void **state)
{
    enum { N = 150 };
    const int count[3] = {4, 3, 5}, zero[3] = {0, 0, 0};
    const int order[3] = {3, 2, 3}, size[3] = {4, 3, 3};
    gt t = gt_begin(33);
    double pts[2][60], par[3][N], val[2][N], p[IX_MAX_COORDS], q[2], at[3];
    ix_mv *f;

    (void)state;
    for (int i = 0; i < 120; i++)
        pts[i / 60][i % 60] = ix_rng_range(&t.r, -1, 1);
    ASSERT_OK(t.ctx, ix_mv_fit_grid(t.ctx, 3, count, 2, false, pts[0], order,
                                    zero, &f));
    for (int k = 0; k < 60; k++) {
        at[0] = k % 4 / 3.0;
        at[1] = k / 4 % 3 / 2.0;
        at[2] = k / 12 / 4.0;
        gt_point(&t, f, at, p);
        for (int c = 0; c < 2; c++)
            ASSERT_CLOSE(p[c], pts[c][k], 1e-11);
    }
    ix_mv_unref(t.ctx, f);
    for (int i = 0; i < N; i++) {
        for (int d = 0; d < 3; d++)
            par[d][i] = at[d] = ix_rng_unit(&t.r);
        poly212(at, q);
        val[0][i] = q[0];
        val[1][i] = q[1];
    }
    ASSERT_OK(t.ctx,
              ix_mv_fit_points(t.ctx, &(ix_cloud){3, N, par[0], 2, val[0]},
                               order, size, &f));
    for (int i = 0; i < 20; i++) {
        for (int d = 0; d < 3; d++)
            at[d] = ix_rng_unit(&t.r);
        gt_point(&t, f, at, p);
        poly212(at, q);
        gt_same(p, q, 2, 1e-9); /* 150 points for 36 unknowns */
    }
    ix_mv_unref(t.ctx, f);
    gt_end(&t);
}

static void errors(void **state)
{
    const double pts[8] = {0, 1, 2, 3, 4, 5, 6, 7}, t3[3] = {0.5, 0.5, 1.5};
    const double twice[6] = {0, 0, 1, 1, 2, 2};
    const int two[3] = {2, 2, 2}, three[3] = {3, 3, 3}, zero[3] = {0, 0, 0};
    const int many[3] = {40, 40, 40};
    const ix_dir jump = {IX_BSPLINE, 2, 4, false, twice};
    gt t = gt_begin(34);
    ix_mv *m, *f, *out;

    (void)state;
    assert_int_equal(
        ix_mv_fit_grid(t.ctx, 3, two, 1, false, pts, three, zero, &out),
        IX_EARG);
    assert_int_equal(
        ix_mv_fit_grid(t.ctx, 17, two, 1, false, pts, two, zero, &out),
        IX_EARG);
    assert_int_equal(
        ix_mv_fit_points(t.ctx, &(ix_cloud){3, 1, t3, 1, pts}, two, two, &out),
        IX_EARG);
    assert_int_equal(ix_mv_fit_points(t.ctx, &(ix_cloud){3, 1, pts, 1, pts},
                                      two, many, &out),
                     IX_EARG);
    assert_int_equal(
        ix_mv_fit_points(t.ctx, &(ix_cloud){2, 1, t3, 1, pts}, two, two, &out),
        IX_EDOMAIN);
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 1, &jump, 1, false, pts, &m));
    assert_int_equal(ix_mv_fit_nodes(t.ctx, m, zero, zero, &out), IX_EDOMAIN);
    assert_int_equal(ix_mv_fit_nodes(t.ctx, m, three, two, &out), IX_EARG);
    ix_mv_unref(t.ctx, m);
    m = gt_random(&t, 1, 1, 0, IX_RAND_PERIODIC, 3);
    ASSERT_OK(t.ctx, ix_mv_to_float(t.ctx, m, &f));
    assert_int_equal(ix_mv_fit_nodes(t.ctx, f, two, zero, &out), IX_EARG);
    assert_null(out);
    ix_mv_unref(t.ctx, f);
    ix_mv_unref(t.ctx, m);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    gt t = {ctx, ix_rng_new(35)};

    f->in[0] = gt_random(&t, 3, 1, 0, IX_RAND_BEZIER, 3);
}

static ix_status build_nodes(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    return ix_mv_fit_nodes(ctx, f->in[0], (const int[3]){2, 0, 0},
                           (const int[3]){2, 0, 0}, out);
}

static ix_status build_points(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double t[8] = {0, 1, 0, 1, 0, 0, 1, 1}, v[4] = {1, 2, 3, 4};
    const int two[2] = {2, 2};

    (void)f;
    return ix_mv_fit_points(ctx, &(ix_cloud){2, 4, t, 1, v}, two, two, out);
}

static void out_of_memory(void **state)
{
    ix_build_case f = {.make = make, .build = build_nodes};

    (void)state;
    ix_build_faults(&f);
    f.build = build_points;
    ix_build_faults(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_are_met),    cmocka_unit_test(fewer_at_nodes),
        cmocka_unit_test(three_directions), cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
