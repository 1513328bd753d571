/* geomtest.h - what the tests of surface constructors share: points of maps
 * by plain evaluation, random parameters, and the loop that fails every
 * allocation of a constructor in turn. */
#ifndef UNIT_GEOM_GEOMTEST_H
#define UNIT_GEOM_GEOMTEST_H

#include <string.h>

#include "harness/build_case.h"
#include "harness/randmv.h"

enum { ROUNDS = 60 };

/* Values agree within this much of their size: a few hundred roundings of
 * convex combinations of numbers of size 1, with weights down to 0.3. */
#define TOL 1e-11

/* What a test file needs in each test. */
typedef struct {
    ix_ctx *ctx;
    ix_rng r;
} gt;

static inline gt gt_begin(uint64_t seed)
{
    gt t = {ix_ctx_new(NULL, NULL), ix_rng_new(seed)};

    assert_non_null(t.ctx);
    print_message("seed %llu\n", (unsigned long long)t.r.s);
    return t;
}

static inline void gt_end(gt *t)
{
    ix_ctx_free(t->ctx);
}

static inline ix_mv *gt_random(gt *t, int ndirs, int ncoords, int rational,
                               unsigned kinds, int min_order)
{
    ix_rand_opts o = {.ndirs = ndirs,
                      .ncoords = ncoords,
                      .rational = rational,
                      .kinds = kinds,
                      .min_order = min_order,
                      .max_order = 5,
                      .max_knots = 4};

    return ix_mv_randtest(t->ctx, &t->r, &o);
}

/* A curve from its control points double[axes][n]; knots NULL: Bezier. */
static inline ix_mv *gt_curve(gt *t, int order, int n, const double *knots,
                              int ncoords, bool rational, const double *pts)
{
    ix_dir d = {knots ? IX_BSPLINE : IX_BEZIER, order, n, false, knots};
    ix_mv *m = NULL;

    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 1, &d, ncoords, rational, pts, &m));
    return m;
}

/* Projected point, padded with zeros to 3 coordinates. */
static inline void gt_point(gt *t, const ix_mv *m, const double *at,
                            double p[IX_MAX_COORDS])
{
    memset(p, 0, IX_MAX_COORDS * sizeof *p);
    ASSERT_OK(t->ctx, ix_mv_point(t->ctx, m, at, p));
}

/* A random parameter strictly inside the domain of direction d. */
static inline double gt_param(gt *t, const ix_mv *m, int d)
{
    double dom[2];

    ix_mv_domain(m, d, dom);
    return ix_rng_range(&t->r, dom[0], dom[1]);
}

/* t of a's direction mapped affinely to b's direction 0. */
static inline double gt_map(const ix_mv *a, int da, const ix_mv *b, double t)
{
    double p[2], q[2];

    ix_mv_domain(a, da, p);
    ix_mv_domain(b, 0, q);
    return q[0] + (q[1] - q[0]) * ((t - p[0]) / (p[1] - p[0]));
}

static inline void gt_same(const double *p, const double *q, int n, double tol)
{
    for (int i = 0; i < n; i++)
        ASSERT_CLOSE(p[i], q[i], tol);
}

#endif
