/* randmv.h - random multivariates for tests, biased to awkward shapes. */
#ifndef HARNESS_RANDMV_H
#define HARNESS_RANDMV_H

#include "harness/test.h"
#include "iritx/mv.h"

/* A context, random numbers and the functions that make and end them, for a
 * test file: pass setup and teardown to cmocka_run_group_tests. */
#define IX_TEST_FIXTURE(seed)         \
    static ix_ctx *ctx;               \
    static ix_rng rng;                \
                                      \
    static int setup(void **state)    \
    {                                 \
        (void)state;                  \
        ctx = ix_ctx_new(NULL, NULL); \
        rng = ix_rng_new(seed);       \
        return ctx ? 0 : -1;          \
    }                                 \
                                      \
    static int teardown(void **state) \
    {                                 \
        (void)state;                  \
        ix_ctx_free(ctx);             \
        return 0;                     \
    }

/* Kinds of directions that may be drawn. */
enum {
    IX_RAND_BEZIER = 1,
    IX_RAND_OPEN = 2,
    IX_RAND_FLOAT = 4,
    IX_RAND_PERIODIC = 8,
    IX_RAND_POWER = 16,
    IX_RAND_JUMPS = 32, /* B-splines may have knots of full multiplicity */
    IX_RAND_BSPLINES = 2 + 4 + 8 + 32,
    IX_RAND_ALL = 63
};

/* Zero fields: the default in brackets. */
typedef struct {
    int ndirs;      /* [1 .. 3] */
    int ncoords;    /* [1 .. 4] */
    int rational;   /* 1 yes, -1 no [either]; weights in [0.3, 3] */
    unsigned kinds; /* [IX_RAND_ALL without IX_RAND_POWER] */
    int min_order;  /* [1] */
    int max_order;  /* [6] */
    int max_knots;  /* interior knots of a direction [6]; -1: none */
    bool unit;      /* every domain is [0, 1] */
} ix_rand_opts;

/* A new multivariate with points in [-1, 1] (power: coefficients); never
 * NULL. o may be NULL. */
ix_mv *ix_mv_randtest(ix_ctx *ctx, ix_rng *r, const ix_rand_opts *o);

/* A random parameter of each direction's domain: t[ndirs]; often at a knot or
 * at an end of the domain. */
void ix_mv_randparam(ix_rng *r, const ix_mv *m, double *t);

/* Asserts that a and b have the same homogeneous values at random parameters
 * of a's domain, relative to the largest control value of a. */
void ix_mv_assert_same(ix_ctx *ctx, ix_rng *r, const ix_mv *a, const ix_mv *b,
                       double tol);

#endif
