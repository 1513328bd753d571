/* join_scalars.c - one multivariate from scalar ones. */
#include <string.h>

#include "mv/mv.h"

static ix_status join(ix_ctx *ctx, int naxes, ix_mv *const *s, bool rational,
                      ix_mv **out)
{
    const ix_mv *m = s[0];

    IX_TRY(
        ix__mv_alloc(ctx, m->ndirs, m->dirs, naxes - rational, rational, out));
    for (int a = 0; a < naxes; a++)
        memcpy((*out)->pts + (size_t)a * m->npts, s[a]->pts,
               m->npts * sizeof *m->pts);
    return IX_OK;
}

ix_status ix_mv_join_scalars(ix_ctx *ctx, int naxes,
                             const ix_mv *const *scalars, bool rational,
                             ix_mv **out)
{
    ix_mv *same[IX_MAX_COORDS + 1];
    ix_status st;

    *out = NULL;
    if (naxes < 1 + rational || naxes > IX_MAX_COORDS + rational)
        return IX_FAIL(ctx, IX_EARG, "%d scalars for %s points", naxes,
                       rational ? "rational" : "polynomial");
    for (int a = 0; a < naxes; a++)
        if (scalars[a]->naxes != 1)
            return IX_FAIL(ctx, IX_EARG, "scalar %d has %d axes", a,
                           scalars[a]->naxes);
    IX_TRY(ix__mv_compatible_all(ctx, naxes, scalars, IX_SAME_ALL, same));
    st = join(ctx, naxes, same, rational, out);
    for (int a = 0; a < naxes; a++)
        ix_mv_unref(ctx, same[a]);
    return st;
}
