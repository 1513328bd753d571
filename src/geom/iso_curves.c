/* iso_curves.c - see the header. */
#include "geom/iso_curves.h"

#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/sym.h"

#define DEPTH 12 /* halvings */

/* A bound of |S(., a) - S(., b)|. */
static ix_status gap_of(ix_ctx *ctx, const ix_mv *s, int dir, double a,
                        double b, double *gap)
{
    double lo[IX_MAX_COORDS] = {0}, hi[IX_MAX_COORDS] = {0}, far[3];
    ix_mv *t[3] = {NULL};
    ix_status st = ix_mv_fix(ctx, s, dir, a, &t[0]);

    if (st == IX_OK)
        st = ix_mv_fix(ctx, s, dir, b, &t[1]);
    if (st == IX_OK)
        st = ix_sym_sub(ctx, t[0], t[1], NULL, &t[2]);
    if (st == IX_OK)
        st = ix_mv_bbox(ctx, t[2], lo, hi);
    for (int k = 0; k < 3; k++)
        far[k] = fmax(-lo[k], hi[k]);
    *gap = ix__len3(far);
    ix__mv_unref_all(ctx, t, 3);
    return st;
}

static ix_status halve(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                       double a, double b, int depth, int *n, double *t)
{
    double gap, m = (a + b) / 2;

    IX_TRY(gap_of(ctx, s, dir, a, b, &gap));
    /* both ends may be one curve: look at the middle at least once */
    if (gap <= eps && depth < DEPTH) {
        t[(*n)++] = b;
        return IX_OK;
    }
    if (depth == 0)
        return IX_FAIL(ctx, IX_EUNABLE,
                       "curves at %g and %g are still %g apart; %g is wanted",
                       a, b, gap, eps);
    IX_TRY(halve(ctx, s, dir, eps, a, m, depth - 1, n, t));
    return halve(ctx, s, dir, eps, m, b, depth - 1, n, t);
}

ix_status ix__iso_params(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                         int *n, double **t)
{
    double dom[2];

    *n = 0;
    if (s->ndirs != 2 || s->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a surface of at most "
                       "3 is wanted",
                       s->ndirs, s->ncoords);
    if (!(eps > 0))
        return IX_FAIL(ctx, IX_EARG, "a distance of %g; it must be positive",
                       eps);
    IX_SCRATCH(ctx, *t, (1 << DEPTH) + 1);
    ix_mv_domain(s, dir, dom);
    (*t)[(*n)++] = dom[0];
    return halve(ctx, s, dir, eps, dom[0], dom[1], DEPTH, n, *t);
}
