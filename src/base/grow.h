/* grow.h - arrays in scratch memory that grow. */
#ifndef BASE_GROW_H
#define BASE_GROW_H

#include "base/ctx.h"

/* A copy of old with room for twice as many items, at least 64, *cap of which
 * used are set; NULL and a message on failure. */
void *ix__scratch_grow(ix_ctx *ctx, const void *old, int used, int *cap,
                       size_t size) IX_MUST_CHECK;

/* Room for one item more in p, of which used of cap are taken, or return
 * IX_ENOMEM. */
#define IX_GROW(ctx, p, used, cap)                                           \
    do {                                                                     \
        if ((used) == (cap)) {                                               \
            (p) = ix__scratch_grow((ctx), (p), (used), &(cap), sizeof *(p)); \
            if (!(p))                                                        \
                return IX_ENOMEM;                                            \
        }                                                                    \
    } while (0)

#endif
