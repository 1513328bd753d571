/* iso_curves.c - see the header. */
#include "geom/iso_curves.h"

#include "geom/gap.h"
#include "geom/halve.h"
#include "geom/parts.h"

/* A bound of |S(., a) - S(., b)|. */
static ix_status gap_of(ix_ctx *ctx, const ix_mv *s, int dir, double a,
                        double b, double *gap)
{
    ix_mv *t[2] = {NULL};
    ix_status st = ix_mv_fix(ctx, s, dir, a, &t[0]);

    if (st == IX_OK)
        st = ix_mv_fix(ctx, s, dir, b, &t[1]);
    if (st == IX_OK)
        st = ix__gap_bound(ctx, t[0], t[1], gap);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

ix_status ix__iso_check(ix_ctx *ctx, const ix_mv *s, double eps)
{
    if (s->ndirs != 2 || s->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a surface of at most "
                       "3 is wanted",
                       s->ndirs, s->ncoords);
    if (!(eps > 0))
        return IX_FAIL(ctx, IX_EARG, "a distance of %g; it must be positive",
                       eps);
    return IX_OK;
}

ix_status ix__iso_params(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                         int *n, double **t)
{
    /* both ends of a closed surface are one curve */
    const ix__halving h = {gap_of, s, dir, eps, true, "the next curve"};

    *n = 0;
    IX_TRY(ix__iso_check(ctx, s, eps));
    return ix__halve(ctx, &h, n, t);
}
