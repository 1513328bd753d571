/* curves_alloc.c - the one block of ix_solution_curves. */
#include "solve/curves_alloc.h"

ix_status ix__solution_curves_alloc(ix_ctx *ctx, size_t numbers, size_t curves,
                                    size_t singular, ix_solution_curves *out,
                                    double **x)
{
    unsigned char *p;

    *x = NULL;
    out->bytes = numbers * sizeof **x + curves * sizeof *out->curve +
                 singular * (sizeof *out->singular + sizeof *out->arcs);
    if (out->bytes == 0)
        return IX_OK;
    p = ix__alloc(ctx, out->bytes);
    if (!p) {
        out->bytes = 0;
        return IX_ENOMEM;
    }
    out->singular = (void *)p;
    p += singular * sizeof *out->singular;
    *x = (void *)p;
    p += numbers * sizeof **x;
    out->curve = (void *)p;
    p += curves * sizeof *out->curve;
    out->arcs = (void *)p;
    return IX_OK;
}

void ix_solution_curves_free(ix_ctx *ctx, ix_solution_curves *c)
{
    /* the block starts with the first of its parts that is not empty */
    if (c->bytes)
        ix__free(ctx, c->singular, c->bytes);
    *c = (ix_solution_curves){.unknowns = 0};
}
