/* halve.c - see the header. */
#include "geom/halve.h"

#include "base/ctx.h"

static ix_status halve(ix_ctx *ctx, const ix__halving *h, double a, double b,
                       int depth, int *n, double *t)
{
    double gap, m = (a + b) / 2;

    IX_TRY(h->gap(ctx, h->s, h->dir, a, b, &gap));
    if (gap <= h->eps && !(h->look_inside && depth == IX__HALVINGS)) {
        t[(*n)++] = b;
        return IX_OK;
    }
    if (depth == 0)
        return IX_FAIL(ctx, IX_EUNABLE,
                       "between %g and %g, %s is still %g away; %g is wanted",
                       a, b, h->what, gap, h->eps);
    IX_TRY(halve(ctx, h, a, m, depth - 1, n, t));
    return halve(ctx, h, m, b, depth - 1, n, t);
}

ix_status ix__halve(ix_ctx *ctx, const ix__halving *h, int *n, double **t)
{
    double dom[2];

    *n = 0;
    IX_SCRATCH(ctx, *t, (1 << IX__HALVINGS) + 1);
    ix_mv_domain(h->s, h->dir, dom);
    (*t)[(*n)++] = dom[0];
    return halve(ctx, h, dom[0], dom[1], IX__HALVINGS, n, *t);
}
