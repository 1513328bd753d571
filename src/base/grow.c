/* grow.c - see the header. */
#include "base/grow.h"

#include <limits.h>
#include <string.h>

void *ix__scratch_grow(ix_ctx *ctx, const void *old, int used, int *cap,
                       size_t size)
{
    int more = *cap > INT_MAX / 2 ? INT_MAX : *cap > 32 ? 2 * *cap : 64;
    void *p;

    if (more == used) {
        (void)IX_FAIL(ctx, IX_ENOMEM, "%d items", used);
        return NULL;
    }
    p = ix__scratch(ctx, (size_t)more, size);
    if (!p)
        return NULL;
    if (used)
        memcpy(p, old, (size_t)used * size);
    *cap = more;
    return p;
}
