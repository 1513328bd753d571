/* mv_moebius.c - Moebius transformation of one parameter of a rational map.
 *
 * On the domain scaled to [0, 1] the old parameter is t = c s / r(s) with
 * r(s) = 1 + (c - 1) s. The homogeneous control point whose blossom arguments
 * are t_1 .. t_d gets the factor r(s_1) ... r(s_d) (Lee, Lucian 1991). */
#include <math.h>

#include "geom/parts.h"
#include "iritx/geom_srf.h"

/* The new knot s in [0, 1] of the old one t, and the factor r(s). */
static double new_knot(double c, double t, double *r)
{
    double q = c + (1 - c) * t;

    *r = c / q;
    return t / q;
}

/* s[i], r[i] for all knots of an open direction, or the two of a Bezier one
 * repeated order times. */
static void map_knots(const ix_dir *dir, double c, double *s, double *r)
{
    int n = dir->order + dir->length;
    double lo = 0, hi = 1;

    if (dir->basis == IX_BSPLINE) {
        lo = dir->knots[dir->order - 1];
        hi = dir->knots[dir->length];
    }
    for (int i = 0; i < n; i++) {
        double t = dir->basis == IX_BSPLINE ? (dir->knots[i] - lo) / (hi - lo)
                                            : i >= dir->order;

        s[i] = lo + (hi - lo) * new_knot(c, t, &r[i]);
    }
}

static void scale_layers(ix_mv *m, const ix_mv *from, int dir, const double *r)
{
    size_t stride = ix__mv_stride(m, dir);
    size_t length = (size_t)m->dirs[dir].length;
    int degree = m->dirs[dir].order - 1;

    for (size_t i = 0; i < length; i++) {
        double f = 1;

        for (int j = 1; j <= degree; j++)
            f *= r[i + (size_t)j];
        for (size_t k = 0; k < (size_t)m->naxes * m->npts; k += length * stride)
            for (size_t q = k + i * stride; q < k + (i + 1) * stride; q++)
                m->pts[q] = f * from->pts[q];
    }
}

/* c such that the end weights of the first row get the wanted ratio. */
static ix_status find_c(ix_ctx *ctx, const ix_mv *m, int dir, double ratio,
                        double *c)
{
    size_t last = ix__mv_stride(m, dir) * (size_t)(m->dirs[dir].length - 1);
    double w0 = m->pts[0], w1 = m->pts[last];

    if (!(w0 * w1 > 0))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "end weights %g and %g: no Moebius map makes their "
                       "ratio positive",
                       w0, w1);
    if (ratio == 0)
        ratio = 1;
    *c = pow(ratio * w0 / w1, 1.0 / (m->dirs[dir].order - 1));
    return IX_OK;
}

static ix_status moebius(ix_ctx *ctx, const ix_mv *m, int dir, double ratio,
                         ix_mv *t[3], ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    double c, *s, *r;

    IX_TRY(ix__mv_plain(ctx, m, &t[0]));
    IX_TRY(ix_mv_to_open(ctx, t[0], &t[1]));
    IX_TRY(ix_mv_coerce(ctx, t[1], m->ncoords, true, &t[2]));
    m = t[2];
    IX_TRY(find_c(ctx, m, dir, ratio, &c));
    for (int d = 0; d < m->ndirs; d++)
        dirs[d] = m->dirs[d];
    IX_SCRATCH(ctx, s, dirs[dir].order + dirs[dir].length);
    IX_SCRATCH(ctx, r, dirs[dir].order + dirs[dir].length);
    map_knots(&m->dirs[dir], c, s, r);
    if (dirs[dir].basis == IX_BSPLINE)
        dirs[dir].knots = s;
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, dirs, m->ncoords, true, out));
    scale_layers(*out, m, dir, r);
    return IX_OK;
}

ix_status ix_mv_moebius(ix_ctx *ctx, const ix_mv *m, int dir, double ratio,
                        ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *t[3] = {NULL};
    ix_status st;

    *out = NULL;
    if (dir < 0 || dir >= m->ndirs)
        return IX_FAIL(ctx, IX_EARG, "direction %d of %d", dir, m->ndirs);
    if (m->dirs[dir].order < 2)
        return IX_FAIL(ctx, IX_EARG, "direction %d is constant", dir);
    if (!(ratio >= 0 && isfinite(ratio)))
        return IX_FAIL(ctx, IX_EARG, "the ratio of weights is %g, not positive",
                       ratio);
    st = moebius(ctx, m, dir, ratio, t, out);
    ix__mv_unref_all(ctx, t, 3);
    ix__scratch_release(ctx, mk);
    return st;
}
