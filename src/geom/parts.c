/* parts.c - small steps shared by the surface constructors. Inputs are never
 * changed; every result is a new reference. */
#include "geom/parts.h"

#include <string.h>

void ix__mv_unref_all(ix_ctx *ctx, ix_mv *const *t, int n)
{
    for (int i = 0; i < n; i++)
        ix_mv_unref(ctx, t[i]);
}

bool ix__mv_has_basis(const ix_mv *m, ix_basis b)
{
    for (int d = 0; d < m->ndirs; d++)
        if (m->dirs[d].basis == b)
            return true;
    return false;
}

ix_status ix__mv_plain(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    bool bspline = ix__mv_has_basis(m, IX_BSPLINE);

    if (bspline &&
        (ix__mv_has_basis(m, IX_BEZIER) || ix__mv_has_basis(m, IX_POWER)))
        return ix_mv_to_bspline(ctx, m, out);
    if (ix__mv_has_basis(m, IX_POWER))
        return ix_mv_power_to_bezier(ctx, m, out);
    *out = ix_mv_ref(m);
    return IX_OK;
}

ix_status ix__mv_plain2(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_mv **pa,
                        ix_mv **pb)
{
    if (ix__mv_has_basis(a, IX_BSPLINE) || ix__mv_has_basis(b, IX_BSPLINE)) {
        IX_TRY(ix_mv_to_bspline(ctx, a, pa));
        return ix_mv_to_bspline(ctx, b, pb);
    }
    IX_TRY(ix__mv_plain(ctx, a, pa));
    return ix__mv_plain(ctx, b, pb);
}

ix_status ix__mv_relabel(ix_ctx *ctx, const ix_mv *m, bool rational,
                         ix_mv **out)
{
    if (m->rational == rational) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->naxes - (rational ? 1 : 0),
                        rational, out));
    memcpy((*out)->pts, m->pts, (size_t)m->naxes * m->npts * sizeof *m->pts);
    return IX_OK;
}

ix_dir ix__dir_constant(bool bezier, const double dom[2])
{
    if (bezier)
        return (ix_dir){.basis = IX_BEZIER, .order = 1, .length = 1};
    return (ix_dir){.basis = IX_BSPLINE, .order = 1, .length = 1, .knots = dom};
}

ix_dir ix__dir_linear(bool bezier)
{
    static const double knots[4] = {0, 0, 1, 1};

    if (bezier)
        return (ix_dir){.basis = IX_BEZIER, .order = 2, .length = 2};
    return (ix_dir){
        .basis = IX_BSPLINE, .order = 2, .length = 2, .knots = knots};
}

/* m with constant directions over the domains of other before or after its
 * own; as those have one control point, the points stay as they are. */
static ix_status widen(ix_ctx *ctx, const ix_mv *m, const ix_mv *other,
                       bool before, ix_mv **out)
{
    bool bezier = !ix__mv_has_basis(m, IX_BSPLINE);
    int own = before ? other->ndirs : 0, add = before ? 0 : m->ndirs;
    ix_dir dirs[IX_MAX_DIRS];
    double dom[IX_MAX_DIRS][2];

    memcpy(dirs + own, m->dirs, (size_t)m->ndirs * sizeof *dirs);
    for (int d = 0; d < other->ndirs; d++) {
        ix_mv_domain(other, d, dom[d]);
        dirs[add + d] = ix__dir_constant(bezier, dom[d]);
    }
    IX_TRY(ix__mv_alloc(ctx, m->ndirs + other->ndirs, dirs, m->ncoords,
                        m->rational, out));
    memcpy((*out)->pts, m->pts, (size_t)m->naxes * m->npts * sizeof *m->pts);
    return IX_OK;
}

static ix_status check_dirs_sum(ix_ctx *ctx, const ix_mv *a, const ix_mv *b)
{
    if (a->ndirs + b->ndirs > IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG,
                       "%d and %d directions, at most %d together", a->ndirs,
                       b->ndirs, IX_MAX_DIRS);
    return IX_OK;
}

ix_status ix__mv_product_domain(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                ix_mv **pa, ix_mv **pb)
{
    IX_TRY(check_dirs_sum(ctx, a, b));
    IX_TRY(widen(ctx, a, b, false, pa));
    return widen(ctx, b, a, true, pb);
}

ix_status ix__mv_outer_alloc(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             int ncoords, bool rational, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];

    IX_TRY(check_dirs_sum(ctx, a, b));
    if (b->npts > SIZE_MAX / 64 / a->npts)
        return IX_FAIL(ctx, IX_ENOMEM, "%zu by %zu control points", a->npts,
                       b->npts);
    memcpy(dirs, a->dirs, (size_t)a->ndirs * sizeof *dirs);
    memcpy(dirs + a->ndirs, b->dirs, (size_t)b->ndirs * sizeof *dirs);
    return ix__mv_alloc(ctx, a->ndirs + b->ndirs, dirs, ncoords, rational, out);
}

void ix__outer_add(size_t na, const double *a, size_t nb, const double *b,
                   double f, double *out)
{
    for (size_t j = 0; j < nb; j++, out += na) {
        double fb = b ? f * b[j] : f;

        for (size_t i = 0; i < na; i++)
            out[i] += a ? fb * a[i] : fb;
    }
}

const double *ix__mv_coord_or_null(const ix_mv *m, int c)
{
    return c < m->ncoords ? ix_mv_coord(m, c) : NULL;
}
