/* tv_fold.c - the Jacobian determinant of a trivariate, and where it vanishes.
 */
#include <math.h>

#include "geom/iso_surface.h"
#include "geom/parts.h"
#include "geom/pool.h"
#include "iritx/geom_srf.h"
#include "mv/mv.h"

static ix_status check(ix_ctx *ctx, const ix_mv *t)
{
    if (t->ndirs != 3 || t->ncoords != 3 || ix__mv_has_basis(t, IX_POWER))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "trivariate of 3 coordinates is wanted",
                       t->ndirs, t->ncoords);
    return IX_OK;
}

/* The axes of m, weight first, as coordinates of a polynomial. */
static const ix_mv *homogeneous(ix_pool *q, const ix_mv *m)
{
    const ix_mv *axis[4];

    for (int k = 0; k < 4; k++)
        axis[k] = ix__pool_axis(q, m, k);
    if (q->st != IX_OK)
        return NULL;
    return ix__pool_made(
        q, ix_mv_join_scalars(q->ctx, 4, axis, false, ix__pool_room(q)));
}

/* Rows T_u, T_v, T_w; of a rational one P, P_u, P_v, P_w with P = (w, w T):
 * w^4 times that. */
ix_status ix_tv_jacobian(ix_ctx *ctx, const ix_mv *t, ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    const ix_mv *row[4], *m = t, *det = NULL;
    int n = 0;

    *out = NULL;
    IX_TRY(check(ctx, t));
    if (t->rational)
        row[n++] = m = homogeneous(&q, t);
    for (int d = 0; d < 3; d++)
        row[n++] = ix__pool_derive(&q, m, d);
    if (q.st == IX_OK)
        det = ix__pool_made(&q,
                            ix_sym_det(ctx, n, row, NULL, ix__pool_room(&q)));
    return ix__pool_give(&q, det, out);
}

/* The points of t at the vertices, in place. */
static ix_status onto(ix_ctx *ctx, const ix_mv *t, ix_lines *l)
{
    size_t at = 0;

    for (int i = 0; i < l->n; i++)
        for (int k = 0; k < l->count[i]; k++, at++) {
            double x[3];

            IX_TRY(ix_mv_point(ctx, t, l->pt[at], x));
            for (int c = 0; c < 3; c++)
                l->pt[at][c] = x[c];
        }
    return IX_OK;
}

static double largest(const ix_mv *m)
{
    double big = 0;

    for (size_t i = 0; i < m->npts; i++)
        big = fmax(big, fabs(m->pts[i]));
    return big;
}

/* Some hundred roundings of what the determinant could be. */
#define NOISE 1e-13

/* |T_u| |T_v| |T_w| at most, by the steps of the control points. */
static ix_status size_of(ix_ctx *ctx, const ix_mv *t, double *out)
{
    *out = 1;
    for (int d = 0; d < 3; d++) {
        ix_mv *e;

        IX_TRY(ix_sym_derive_axes(ctx, t, d, &e));
        *out *= largest(e);
        ix_mv_unref(ctx, e);
    }
    return IX_OK;
}

static ix_status fold(ix_ctx *ctx, const ix_mv *t, const ix_mv *det,
                      const int cells[3], bool euclid, ix_lines *out)
{
    double size;

    IX_TRY(size_of(ctx, t, &size));
    if (!(largest(det) > NOISE * size))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the Jacobian determinant is zero everywhere: the "
                       "trivariate is flat");
    IX_TRY(ix__iso_surface(ctx, det, cells, out));
    return euclid ? onto(ctx, t, out) : IX_OK;
}

ix_status ix_tv_fold(ix_ctx *ctx, const ix_mv *t, const int cells[3],
                     bool euclid, ix_lines *out)
{
    ix_status st;
    ix_mv *det;

    *out = (ix_lines){.n = 0};
    IX_TRY(ix_tv_jacobian(ctx, t, &det));
    st = fold(ctx, t, det, cells, euclid, out);
    ix_mv_unref(ctx, det);
    if (st != IX_OK)
        ix_lines_free(ctx, out);
    return st;
}
