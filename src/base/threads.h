/* threads.h - sharing out independent pieces of work.
 *
 * Workers run kernels only: no allocation, no messages, no reference counts.
 * The pieces do not depend on the number of threads, so neither do the bits
 * of the result. */
#ifndef BASE_THREADS_H
#define BASE_THREADS_H

#include "base/ctx.h"

/* Handles the items begin <= i < end; writes only what belongs to them. */
typedef void (*ix__work_fn)(void *arg, size_t begin, size_t end);

/* Calls fn so that every item of 0 .. n-1 is handled exactly once. item_ns is
 * a rough cost of one item in nanoseconds: below about 50 us in total all is
 * done by the caller. Cannot fail: without threads the caller does all. */
void ix__parallel(ix_ctx *ctx, size_t n, double item_ns, ix__work_fn fn,
                  void *arg);

/* Ends the workers; called when the context is freed. */
void ix__pool_stop(ix_ctx *ctx);

#endif
