/* lines.c - polylines in one block: vertices, then the counts. */
#include "geom/lines.h"

void ix_lines_free(ix_ctx *ctx, ix_lines *l)
{
    ix__free(ctx, l->pt, l->bytes);
    *l = (ix_lines){0};
}

ix_status ix__lines_new(ix_ctx *ctx, size_t points, ix_lines *out)
{
    size_t bytes = points * (3 * sizeof(double) + sizeof(int));
    char *block = points ? ix__alloc(ctx, bytes) : NULL;

    *out = (ix_lines){0};
    if (!points)
        return IX_OK;
    if (!block)
        return IX_ENOMEM;
    out->pt = (double(*)[3])(void *)block;
    out->count = (int *)(void *)(out->pt + points);
    out->bytes = bytes;
    return IX_OK;
}
