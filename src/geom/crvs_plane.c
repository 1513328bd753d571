/* crvs_plane.c - the plane that curves lie in. */
#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"
#include "iritx/arrange.h"
#include "mv/mv.h"

/* All projected control points, z = 0 where there is none. */
static ix_status points_of(ix_ctx *ctx, int n, const ix_mv *const *crv,
                           int *count, double (**out)[3])
{
    size_t total = 0, at = 0;

    for (int i = 0; i < n; i++)
        total += crv[i]->npts;
    IX_SCRATCH_ZERO(ctx, *out, total);
    for (int i = 0; i < n; i++)
        for (size_t k = 0; k < crv[i]->npts; k++, at++)
            for (int c = 0; c < 3 && c < crv[i]->ncoords; c++) {
                double w = crv[i]->rational ? ix_mv_weights(crv[i])[k] : 1;

                (*out)[at][c] = ix_mv_coord(crv[i], c)[k] / w;
            }
    *count = (int)total;
    return IX_OK;
}

/* Farthest of the points from z = 0 after the motion. */
static double farthest(int n, double (*p)[3], const double m[16])
{
    double worst = 0, q[3];

    for (int i = 0; i < n; i++) {
        if (!ix__mat_point(p[i], m, q))
            return HUGE_VAL;
        worst = fmax(worst, fabs(q[2]));
    }
    return worst;
}

/* A plane z = h if that will do: its motion is a shift. */
static bool level(int n, double (*p)[3], double tol, double m[16])
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    const double up[3] = {0, 0, 0};

    ix__mat_translate(up, m);
    for (int i = 0; i < n; i++) {
        lo = fmin(lo, p[i][2]);
        hi = fmax(hi, p[i][2]);
    }
    if (n)
        m[14] = -(lo + hi) / 2;
    return n == 0 || hi - lo <= 2 * tol;
}

static ix_status plane(ix_ctx *ctx, int n, const ix_mv *const *crv, double tol,
                       double m[16])
{
    const double z[3] = {0, 0, 1};
    double(*p)[3], f[4], dist, shift[16], worst;
    const double(*first)[3];
    int count;

    IX_TRY(points_of(ctx, n, crv, &count, &p));
    if (level(count, p, tol, m))
        return IX_OK;
    first = (const double(*)[3])p;
    IX_TRY(ix_fit_plane(ctx, count, first[0], f, &dist));
    IX_TRY(ix__mat_turn(ctx, f, z, m));
    ix__mat_translate((const double[3]){0, 0, f[3]}, shift);
    ix__mat_mul(m, shift, m);
    worst = farthest(count, p, m);
    if (!(worst <= tol))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curves are up to %g away from the nearest plane; "
                       "the tolerance is %g",
                       worst, tol);
    return IX_OK;
}

ix_status ix_crvs_plane(ix_ctx *ctx, int n, const ix_mv *const *crv, double tol,
                        double to_xy[16])
{
    for (int i = 0; i < n; i++)
        if (crv[i]->ndirs != 1 || ix_mv_has_poles(crv[i]))
            return IX_FAIL(ctx, crv[i]->ndirs != 1 ? IX_EARG : IX_EDOMAIN,
                           "curve %d has %d directions, or poles", i + 1,
                           crv[i]->ndirs);
    if (!(tol >= 0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    IX_RETURN_SCOPED(ctx, plane(ctx, n, crv, tol, to_xy));
}
