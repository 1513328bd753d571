/* crv_test.h - random curves and small things that the tests of curve
 * operators share. */
#ifndef UNIT_OPS_CRV_TEST_H
#define UNIT_OPS_CRV_TEST_H

#include "harness/test.h"
#include "iritx/ops_crv.h"

/* What a random curve is to be; zero fields: planar polynomial Bezier of unit
 * size around the origin. */
typedef struct {
    int degree, ncoords;
    bool rational;
    int spans;       /* 0: Bezier; else a B-spline with that many spans */
    double at, size; /* distance from the origin in each coordinate; 0: 1 */
} crv_kind;

static inline ix_mv *make_crv(ix_ctx *ctx, int order, int n,
                              const double *knots, bool rational, int nc,
                              const double *pts)
{
    ix_dir d = {knots ? IX_BSPLINE : IX_BEZIER, order, n, false, knots};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, nc, rational, pts, &m));
    return m;
}

/* One control point of unit size, a part u along the curve. */
typedef void (*crv_point_fn)(ix_rng *r, const crv_kind *k, double u, double *x);

static inline ix_mv *crv_of(ix_ctx *ctx, ix_rng *r, const crv_kind *k,
                            crv_point_fn point, const double weights[2])
{
    double kv[64], pts[4 * 40], size = k->size > 0 ? k->size : 1, x[3];
    int d = k->degree, n = d + (k->spans > 0 ? k->spans : 1);
    int nc = k->ncoords ? k->ncoords : 2;

    for (int i = 0; i < n + d + 1; i++)
        kv[i] = i <= d ? 0 : i >= n ? k->spans : i - d + 0.2;
    for (int i = 0; i < n; i++) {
        double w = k->rational ? ix_rng_range(r, weights[0], weights[1]) : 1;
        double *p = pts + (k->rational ? n : 0);

        pts[i] = w;
        point(r, k, (double)i / (n - 1), x);
        for (int j = 0; j < nc; j++)
            p[j * n + i] = w * (size * x[j] + k->at);
    }
    return make_crv(ctx, d + 1, n, k->spans ? kv : NULL, k->rational, nc, pts);
}

static inline void anywhere(ix_rng *r, const crv_kind *k, double u, double *x)
{
    (void)u;
    for (int j = 0; j < (k->ncoords ? k->ncoords : 2); j++)
        x[j] = ix_rng_range(r, -1, 1);
}

static inline void near_helix(ix_rng *r, const crv_kind *k, double u, double *x)
{
    double angle = (k->spans > 1 ? 1.2 * k->spans : 2.4) * u;
    const double at[3] = {cos(angle), sin(angle), 0.5 * angle};

    for (int j = 0; j < 3; j++)
        x[j] = at[j] + ix_rng_range(r, -0.01, 0.01);
}

static inline ix_mv *rand_crv(ix_ctx *ctx, ix_rng *r, const crv_kind *k)
{
    static const double weights[2] = {0.5, 2};

    return crv_of(ctx, r, k, anywhere, weights);
}

/* Near an arc of a helix: no cusps, inflections, or points without torsion, so
 * that all its values are well conditioned. */
static inline ix_mv *gentle_crv(ix_ctx *ctx, ix_rng *r, const crv_kind *k)
{
    static const double weights[2] = {0.9, 1.2};

    return crv_of(ctx, r, k, near_helix, weights);
}

static inline int degree_of(const ix_mv *m, int dir)
{
    return ix_mv_order(m, dir) - 1;
}

/* The larger of a formal degree and 0: a negative one means zero. */
static inline int at_least_0(int d)
{
    return d > 0 ? d : 0;
}

#endif
