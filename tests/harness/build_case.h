/* build_case.h - constructors of one result under failing allocations. */
#ifndef HARNESS_BUILD_CASE_H
#define HARNESS_BUILD_CASE_H

#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/mv.h"

/* A constructor of one result from up to four inputs, which the test's own
 * make function provides. */
typedef struct ix_build_case ix_build_case;
struct ix_build_case {
    ix_mv *in[4], *out;
    void (*make)(ix_ctx *ctx, ix_build_case *f);
    ix_status (*build)(ix_ctx *ctx, const ix_build_case *f, ix_mv **out);
};

static inline void build_setup(ix_ctx *ctx, void *state)
{
    ix_build_case *f = state;

    memset(f->in, 0, sizeof f->in);
    f->out = NULL;
    f->make(ctx, f);
}

static inline ix_status build_run(ix_ctx *ctx, void *state)
{
    ix_build_case *f = state;
    ix_status st = f->build(ctx, f, &f->out);

    assert_true((st == IX_OK) == (f->out != NULL));
    return st;
}

static inline void build_end(ix_ctx *ctx, void *state)
{
    ix_build_case *f = state;

    for (int i = 0; i < 4; i++)
        ix_mv_unref(ctx, f->in[i]);
    ix_mv_unref(ctx, f->out);
}

static inline void ix_build_faults(ix_build_case *f)
{
    const ix_fault_case c = {build_setup, build_run, build_end, f};

    assert_true(ix_fault_run(&c) > 0);
}

#endif
