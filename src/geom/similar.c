/* similar.c - is one freeform the image of another under a similarity of the
 * XY plane? With x + i y = z the map is z' = t + q z, linear in t and q, so
 * the nearest one is a least squares solution in closed form. */
#include <complex.h>
#include <math.h>

#include "iritx/geom_srf.h"
#include "mv/mv.h"

typedef double complex cplx;

/* Position of control point i, and its z coordinate. */
static cplx position(const ix_mv *m, size_t i, double *z)
{
    double w = m->rational ? ix_mv_weights(m)[i] : 1;

    *z = m->ncoords > 2 ? ix_mv_coord(m, 2)[i] / w : 0;
    return ix_mv_coord(m, 0)[i] / w + ix_mv_coord(m, 1)[i] / w * (cplx)I;
}

static bool same_shape(const ix_mv *a, const ix_mv *b)
{
    bool same = a->ndirs == b->ndirs && a->ncoords == b->ncoords &&
                a->rational == b->rational;

    for (int d = 0; same && d < a->ndirs; d++)
        same = a->dirs[d].basis == b->dirs[d].basis &&
               a->dirs[d].order == b->dirs[d].order &&
               a->dirs[d].length == b->dirs[d].length &&
               a->dirs[d].periodic == b->dirs[d].periodic;
    return same;
}

/* Knots as fractions of the domains, weights as fractions of the first. */
static bool same_knots_weights(const ix_mv *a, const ix_mv *b, double eps)
{
    for (int d = 0; d < a->ndirs; d++) {
        double p[2], q[2];

        ix_mv_domain(a, d, p);
        ix_mv_domain(b, d, q);
        for (int i = 0; i < ix_knots_count(&a->dirs[d]); i++)
            if (!(fabs((a->dirs[d].knots[i] - p[0]) / (p[1] - p[0]) -
                       (b->dirs[d].knots[i] - q[0]) / (q[1] - q[0])) <= eps))
                return false;
    }
    for (size_t i = 0; a->rational && i < a->npts; i++)
        if (!(fabs(a->pts[i] / a->pts[0] - b->pts[i] / b->pts[0]) <= eps))
            return false;
    return true;
}

/* The map t + q z nearest to a -> b; false if a's points are all one. */
static bool nearest(const ix_mv *a, const ix_mv *b, cplx *t, cplx *q)
{
    cplx ma = 0, mb = 0, num = 0;
    double den = 0, z, size = 0;

    for (size_t i = 0; i < a->npts; i++) {
        ma += position(a, i, &z) / (double)a->npts;
        mb += position(b, i, &z) / (double)a->npts;
    }
    for (size_t i = 0; i < a->npts; i++) {
        cplx d = position(a, i, &z) - ma;

        num += conj(d) * (position(b, i, &z) - mb);
        den += creal(d) * creal(d) + cimag(d) * cimag(d);
        size = fmax(size, cabs(position(a, i, &z)));
    }
    /* Rounding alone leaves about 1e-16 of the size of each difference. */
    if (!(den > 1e-28 * size * size))
        return false;
    *q = num / den;
    *t = mb - *q * ma;
    return true;
}

static bool fits(const ix_mv *a, const ix_mv *b, cplx t, cplx q, double eps)
{
    for (size_t i = 0; i < a->npts; i++) {
        double za, zb;
        cplx d = t + q * position(a, i, &za) - position(b, i, &zb);

        if (!(cabs(d) <= eps && fabs(za - zb) <= eps))
            return false;
    }
    return true;
}

ix_status ix_similar(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, double eps,
                     bool *found, ix_similarity *out)
{
    const double degree = 3.14159265358979323846 / 180;
    const ix_mv *const ab[2] = {a, b};
    cplx t, q;

    *found = false;
    for (int k = 0; k < 2; k++) {
        if (ab[k]->ncoords < 2)
            return IX_FAIL(ctx, IX_EARG, "one coordinate, no plane");
        for (size_t i = 0; ab[k]->rational && i < ab[k]->npts; i++)
            if (ab[k]->pts[i] == 0)
                return IX_FAIL(ctx, IX_EDOMAIN, "weight %zu is 0", i + 1);
    }
    if (!same_shape(a, b) || !same_knots_weights(a, b, eps) ||
        !nearest(a, b, &t, &q) || !fits(a, b, t, q, eps))
        return IX_OK;
    *found = true;
    *out = (ix_similarity){{creal(t), cimag(t)}, cabs(q), carg(q) / degree};
    return IX_OK;
}
