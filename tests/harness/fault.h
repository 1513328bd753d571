/* fault.h - an allocator that fails at the n-th request and counts blocks,
 * and the loop that fails every allocation of an operation in turn. */
#ifndef HARNESS_FAULT_H
#define HARNESS_FAULT_H

#include "iritx/base.h"

typedef struct {
    long live, calls, fail_at; /* fail_at < 0: never */
} ix_fault;

void *ix_fault_alloc(void *ud, void *p, size_t old_size, size_t size);

/* One operation under test. setup makes the inputs (never failed), run is
 * failed at each of its allocations in turn and must return IX_ENOMEM with
 * nothing made, or IX_OK; teardown releases inputs and result. After each
 * round no block may be left. Returns the number of failures provoked. */
typedef struct {
    void (*setup)(ix_ctx *ctx, void *state);
    ix_status (*run)(ix_ctx *ctx, void *state);
    void (*teardown)(ix_ctx *ctx, void *state);
    void *state;
} ix_fault_case;
long ix_fault_run(const ix_fault_case *c);

#endif
