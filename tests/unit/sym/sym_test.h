/* sym_test.h - values that laws compare, and a context for each test. */
#ifndef TESTS_SYM_TEST_H
#define TESTS_SYM_TEST_H

#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"
#include "harness/test.h"
#include "iritx/sym.h"

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
