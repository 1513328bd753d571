/* test.h - what every unit test includes: cmocka, random numbers, closeness. */
#ifndef HARNESS_TEST_H
#define HARNESS_TEST_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "iritx/base.h"

/* A small generator with a printed seed (IX_TEST_SEED overrides it). */
typedef struct {
    uint64_t s;
} ix_rng;
ix_rng ix_rng_new(uint64_t seed);
uint64_t ix_rng_next(ix_rng *r);
double ix_rng_unit(ix_rng *r); /* [0, 1) */
double ix_rng_range(ix_rng *r, double lo, double hi);
int ix_rng_int(ix_rng *r, int lo, int hi); /* both included */

/* |a - b| <= tol * max(1, |a|, |b|); false on NaN. */
int ix_close(double a, double b, double tol);

#define ASSERT_OK(ctx, expr)                                      \
    do {                                                          \
        ix_status ix_st_ = (expr);                                \
        if (ix_st_ != IX_OK)                                      \
            fail_msg("%s: %s: %s", #expr, ix_status_name(ix_st_), \
                     ix_ctx_message(ctx));                        \
    } while (0)
#define ASSERT_CLOSE(a, b, tol)                                             \
    do {                                                                    \
        double ix_a_ = (a), ix_b_ = (b);                                    \
        if (!ix_close(ix_a_, ix_b_, (tol)))                                 \
            fail_msg("%s = %.17g, %s = %.17g, tolerance %g", #a, ix_a_, #b, \
                     ix_b_, (double)(tol));                                 \
    } while (0)

#endif
