/* crvs.c - a counted row of curves in one block: references, then intervals. */
#include "geom/crvs.h"

#include "mv/mv.h"

static size_t block_size(int n)
{
    return (size_t)n * (sizeof(ix_mv *) + 2 * sizeof(double));
}

ix_status ix__crvs_new(ix_ctx *ctx, int n, ix_crvs *out)
{
    char *block = n ? ix__alloc(ctx, block_size(n)) : NULL;

    *out = (ix_crvs){0};
    if (!n)
        return IX_OK;
    if (!block)
        return IX_ENOMEM;
    out->t = (double *)(void *)block;
    out->crv = (ix_mv **)(void *)(out->t + 2 * (size_t)n);
    out->n = n;
    for (int i = 0; i < n; i++) {
        out->crv[i] = NULL;
        out->t[2 * i] = out->t[2 * i + 1] = 0;
    }
    return IX_OK;
}

void ix_crvs_free(ix_ctx *ctx, ix_crvs *c)
{
    for (int i = 0; i < c->n; i++)
        ix_mv_unref(ctx, c->crv[i]);
    ix__free(ctx, c->t, block_size(c->n));
    *c = (ix_crvs){0};
}

ix_status ix__check_planar(ix_ctx *ctx, const ix_mv *c)
{
    bool power = c->dirs[0].basis == IX_POWER;

    if (c->ndirs != 1 || c->ncoords < 2 || power)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates%s; a planar Bezier "
                       "or B-spline curve is wanted",
                       c->ndirs, c->ncoords, power ? ", power basis" : "");
    return IX_OK;
}
