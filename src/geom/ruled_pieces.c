/* ruled_pieces.c - see the header (Elber 1995: model fabrication using surface
 * layout projection). */
#include "geom/ruled_pieces.h"

#include "geom/gap.h"
#include "geom/halve.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

enum { PIECE_TEMPS = 4 };

static ix_status ruled(ix_ctx *ctx, const ix_mv *s, int dir, double a, double b,
                       ix_mv *t[2], ix_mv **out)
{
    IX_TRY(ix_mv_fix(ctx, s, dir, a, &t[0]));
    IX_TRY(ix_mv_fix(ctx, s, dir, b, &t[1]));
    return ix_srf_ruled(ctx, t[0], t[1], out);
}

ix_status ix__ruled_piece(ix_ctx *ctx, const ix_mv *s, int dir, double a,
                          double b, ix_mv **out)
{
    ix_mv *t[2] = {NULL};
    ix_status st;

    *out = NULL;
    st = ruled(ctx, s, dir, a, b, t, out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

/* s over [a, b], t[3], and that piece, t[2], with the same parameters. */
static ix_status both(ix_ctx *ctx, const ix_mv *s, int dir, double a, double b,
                      ix_mv *t[PIECE_TEMPS])
{
    IX_TRY(ix__ruled_piece(ctx, s, dir, a, b, &t[0]));
    IX_TRY(ix_mv_reparam(ctx, t[0], 1, a, b, &t[1]));
    if (dir == 0)
        IX_TRY(ix_mv_swap_dirs(ctx, t[1], 0, 1, &t[2]));
    else
        t[2] = ix_mv_ref(t[1]);
    return ix_mv_region(ctx, s, dir, a, b, &t[3]);
}

/* A bound of the distance. */
static ix_status error_of(ix_ctx *ctx, const ix_mv *s, int dir, double a,
                          double b, double *err)
{
    ix_mv *t[PIECE_TEMPS] = {NULL};
    ix_status st = both(ctx, s, dir, a, b, t);

    if (st == IX_OK)
        st = ix__gap_bound(ctx, t[3], t[2], err);
    ix__mv_unref_all(ctx, t, PIECE_TEMPS);
    return st;
}

ix_status ix__ruled_pieces(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                           int *n, double **cut)
{
    ix__halving h = {error_of, NULL, dir, eps, false, "the ruled surface"};
    ix_status st;
    ix_mv *b;

    *n = 0;
    if (s->ndirs != 2 || s->ncoords > 3 || ix__mv_has_basis(s, IX_POWER))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "surface of at most 3 coordinates is wanted",
                       s->ndirs, s->ncoords);
    if (!(eps > 0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g; it must be positive",
                       eps);
    IX_TRY(ix_mv_to_bspline(ctx, s, &b));
    h.s = b;
    st = ix__halve(ctx, &h, n, cut);
    ix_mv_unref(ctx, b);
    if (st == IX_OK)
        (*n)--; /* of pieces */
    return st;
}

/* The point at distances da from a and db from b, to the right of the way from
 * a to b. */
static void third(const double a[2], const double b[2], double da, double db,
                  double out[2])
{
    double e[2] = {b[0] - a[0], b[1] - a[1]}, len = hypot(e[0], e[1]), x, y;

    if (!(len > 0)) {
        out[0] = a[0] + da;
        out[1] = a[1];
        return;
    }
    x = (da * da - db * db + len * len) / (2 * len);
    y = sqrt(fmax(da * da - x * x, 0));
    out[0] = a[0] + (x * e[0] + y * e[1]) / len;
    out[1] = a[1] + (x * e[1] - y * e[0]) / len;
}

void ix__strip_flat(int n, const double (*p)[3], const double (*q)[3],
                    double (*pf)[2], double (*qf)[2])
{
    pf[0][0] = pf[0][1] = qf[0][0] = 0;
    qf[0][1] = ix__dist3(p[0], q[0]);
    for (int i = 0; i + 1 < n; i++) {
        third(pf[i], qf[i], ix__dist3(p[i], p[i + 1]),
              ix__dist3(q[i], p[i + 1]), pf[i + 1]);
        third(pf[i + 1], qf[i], ix__dist3(p[i + 1], q[i + 1]),
              ix__dist3(q[i], q[i + 1]), qf[i + 1]);
    }
}
