/* outer_mv.c - equations in the parameters of two freeforms. */
#include "geom/outer_mv.h"

#include <string.h>

ix_status ix__outer_difference(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                               int k, ix_mv **out)
{
    const double *xa = k < a->ncoords ? ix_mv_coord(a, k) : NULL;
    const double *xb = k < b->ncoords ? ix_mv_coord(b, k) : NULL;
    const double *wa = ix_mv_weights(a), *wb = ix_mv_weights(b);
    ix_dir dirs[IX_MAX_DIRS];
    int n = a->ndirs + b->ndirs;
    ix_mv *m;

    if (n > IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG, "%d and %d directions", a->ndirs,
                       b->ndirs);
    memcpy(dirs, a->dirs, (size_t)a->ndirs * sizeof *dirs);
    memcpy(dirs + a->ndirs, b->dirs, (size_t)b->ndirs * sizeof *dirs);
    IX_TRY(ix__mv_check_dirs(ctx, n, dirs, 1));
    IX_TRY(ix__mv_alloc(ctx, n, dirs, 1, false, &m));
    for (size_t j = 0; j < b->npts; j++)
        for (size_t i = 0; i < a->npts; i++)
            m->pts[i + j * a->npts] = (xa ? xa[i] : 0) * (wb ? wb[j] : 1) -
                                      (xb ? xb[j] : 0) * (wa ? wa[i] : 1);
    *out = m;
    return IX_OK;
}

ix_status ix__affine_field(ix_ctx *ctx, const ix_mv *m, const double v[4],
                           ix_mv **out)
{
    const double *w = ix_mv_weights(m);
    int n = m->ncoords < 3 ? m->ncoords : 3;
    ix_mv *f;

    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, 1, false, &f));
    for (size_t i = 0; i < m->npts; i++) {
        double s = v[3] * (w ? w[i] : 1);

        for (int k = 0; k < n; k++)
            s += v[k] * ix_mv_coord(m, k)[i];
        f->pts[i] = s;
    }
    *out = f;
    return IX_OK;
}
