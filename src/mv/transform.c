/* transform.c - a 4 x 4 matrix for row vectors applied to control points. */
#include "mv/mv.h"

#include <string.h>

/* h = (x, y, z, w) M for one control point. */
static void apply(const double mat[16], const double p[4], double h[4])
{
    for (int j = 0; j < 4; j++)
        h[j] = p[0] * mat[j] + p[1] * mat[4 + j] + p[2] * mat[8 + j] +
               p[3] * mat[12 + j];
}

ix_status ix_mv_transform(ix_ctx *ctx, const ix_mv *m, const double mat[16],
                          ix_mv **out)
{
    bool affine = mat[3] == 0 && mat[7] == 0 && mat[11] == 0;
    bool rational = m->rational || !affine;
    int nc = m->ncoords < 3 ? m->ncoords : 3;
    size_t n = m->npts, shift;
    ix_mv *r;

    *out = NULL;
    if (affine && mat[15] == 0)
        return IX_FAIL(ctx, IX_EARG,
                       "the matrix sends every point to infinity");
    IX_TRY(ix_mv_coerce(ctx, m, m->ncoords, rational, &r));
    if (r == m) { /* a copy of its own */
        ix_mv_unref(ctx, r);
        IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->ncoords, rational, &r));
        memcpy(r->pts, m->pts, n * (size_t)m->naxes * sizeof *r->pts);
    }
    shift = rational ? n : 0;
    for (size_t i = 0; i < n; i++) {
        double p[4] = {0, 0, 0, rational ? r->pts[i] : ix__mv_one(m, i)}, h[4];

        for (int c = 0; c < nc; c++)
            p[c] = r->pts[shift + (size_t)c * n + i];
        apply(mat, p, h);
        for (int c = 0; c < nc; c++)
            r->pts[shift + (size_t)c * n + i] = rational ? h[c]
                                                         : h[c] / mat[15];
        if (rational)
            r->pts[i] = h[3];
    }
    *out = r;
    return IX_OK;
}
