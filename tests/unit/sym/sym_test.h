/* sym_test.h - random multivariates and the values that laws compare. */
#ifndef TESTS_SYM_TEST_H
#define TESTS_SYM_TEST_H

#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/sym.h"

enum { RAND_BEZIER, RAND_BSPLINE, RAND_ANY };

/* What a random multivariate looks like. */
typedef struct {
    int ndirs, ncoords;
    bool rational;
    int kind;      /* RAND_... */
    int max_order; /* orders 1 (or min_order) .. max_order */
    int min_order;
    int spans;   /* at most, in each direction */
    bool smooth; /* interior knots at least C0 */
} rand_shape;

/* Knots on [0, 2]: open, interior ones random, of random multiplicity. */
static inline int rand_knots(ix_rng *r, const rand_shape *s, int order,
                             double *kv)
{
    int n = 0, spans = ix_rng_int(r, 1, s->spans);

    for (int i = 0; i < order; i++)
        kv[n++] = 0.0;
    for (int j = 1; j < spans; j++) {
        double t = 2.0 * (j + ix_rng_range(r, -0.4, 0.4)) / spans;
        int top = s->smooth && order > 1 ? order - 1 : order;
        int m = ix_rng_int(r, 0, 2) ? 1 : ix_rng_int(r, 1, top);

        if (j % 2) /* breaks that operands share */
            t = 2.0 * j / spans;
        for (int i = 0; i < m; i++)
            kv[n++] = t;
    }
    for (int i = 0; i < order; i++)
        kv[n++] = 2.0;
    return n;
}

static inline ix_mv *rand_mv(ix_ctx *ctx, ix_rng *r, const rand_shape *s)
{
    static double kv[4][512], pts[200000];
    ix_dir dirs[4];
    size_t n = 1;
    int axes = s->ncoords + s->rational;
    bool bezier = s->kind == RAND_BEZIER ||
                  (s->kind == RAND_ANY && ix_rng_int(r, 0, 1));
    ix_mv *m;

    for (int d = 0; d < s->ndirs; d++) {
        int order = ix_rng_int(r, s->min_order > 0 ? s->min_order : 1,
                               s->max_order);
        int nk = rand_knots(r, s, order, kv[d]);

        dirs[d] = bezier
                      ? (ix_dir){IX_BEZIER, order, order, false, NULL}
                      : (ix_dir){IX_BSPLINE, order, nk - order, false, kv[d]};
        n *= (size_t)dirs[d].length;
    }
    for (size_t i = 0; i < n * (size_t)axes; i++)
        pts[i] = s->rational && i < n ? ix_rng_range(r, 0.5, 2.0)
                                      : ix_rng_range(r, -1.0, 1.0);
    ASSERT_OK(ctx,
              ix_mv_new(ctx, s->ndirs, dirs, s->ncoords, s->rational, pts, &m));
    return m;
}

/* A parameter inside the domain, never at a break (breaks are random). */
static inline void rand_param(ix_rng *r, const ix_mv *m, double *t)
{
    for (int d = 0; d < ix_mv_ndirs(m); d++) {
        double dom[2];

        ix_mv_domain(m, d, dom);
        t[d] = ix_rng_range(r, dom[0], dom[1]);
    }
}

/* Projected value, all other coordinates 0. */
static inline void value_at(ix_ctx *ctx, const ix_mv *m, const double *t,
                            double *x)
{
    memset(x, 0, IX_MAX_COORDS * sizeof *x);
    ASSERT_OK(ctx, ix_mv_point(ctx, m, t, x));
}

/* One context for a test file; every object made in a test is released. */
typedef struct {
    ix_ctx *ctx;
    ix_fault mem;
} sym_world;

static inline int world_open(void **state)
{
    static sym_world w;

    w.mem = (ix_fault){.fail_at = -1};
    w.ctx = ix_ctx_new(ix_fault_alloc, &w.mem);
    *state = &w;
    return w.ctx == NULL;
}

static inline int world_close(void **state)
{
    sym_world *w = *state;

    ix_ctx_free(w->ctx);
    return w->mem.live != 0;
}

/* The order of the result in a direction and its interior multiplicities. */
static inline int multiplicity_of(const ix_mv *m, int dir, double t)
{
    ix_dir d = ix_mv_dir(m, dir);
    int n = 0;

    for (int i = 0; i < ix_mv_nknots(m, dir); i++)
        n += fabs(d.knots[i] - t) < 1e-12;
    return n;
}

#endif
