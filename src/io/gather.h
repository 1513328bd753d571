/* gather.h - parts that come one after the other, while their number is not
 * known; in scratch memory. */
#ifndef IO_GATHER_H
#define IO_GATHER_H

#include "object/object.h"

/* An array that grows: room for one more item of size bytes behind n. items is
 * the address of its pointer. */
ix_status ix__gather(ix_ctx *ctx, int n, int *cap, size_t size,
                     void *items) IX_MUST_CHECK;

/* A trimmed surface. Holds references until ix__trimming_drop. */
typedef struct {
    const ix_mv *srf;
    int nloops, loop_cap, nsegs, seg_cap;
    int *size;       /* segments of each loop */
    ix_trimseg *seg; /* of all loops */
} ix__trimming;

/* An empty segment more, valid until the next one. */
ix_status ix__trimming_seg(ix_ctx *ctx, ix__trimming *t,
                           ix_trimseg **s) IX_MUST_CHECK;
/* The segments from first on are a loop. */
ix_status ix__trimming_loop(ix_ctx *ctx, ix__trimming *t,
                            int first) IX_MUST_CHECK;
/* The references move to *out. */
ix_status ix__trimming_make(ix_ctx *ctx, ix__trimming *t,
                            ix_trimsrf **out) IX_MUST_CHECK;
void ix__trimming_drop(ix_ctx *ctx, ix__trimming *t);

#endif
