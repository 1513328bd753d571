/* iso_curvature.c - see the header. */
#include "geom/iso_curvature.h"

#include "geom/vec3.h"
#include "mv/mv.h"

/* -e_i.H e_j / |g| in the basis e of the tangent plane. */
static void curvatures(ix__level_point *p, const double e[2][3], double len)
{
    double s[2][2], mean, diff, root, angle;

    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            s[i][j] = 0;
            for (int r = 0; r < 9; r++)
                s[i][j] -= e[i][r / 3] * p->hessian[r] * e[j][r % 3] / len;
        }
    mean = (s[0][0] + s[1][1]) / 2;
    diff = (s[0][0] - s[1][1]) / 2;
    root = hypot(diff, s[0][1]);
    angle = atan2(s[0][1], diff) / 2;
    p->k[0] = mean + root;
    p->k[1] = mean - root;
    for (int c = 0; c < 3; c++) {
        p->dir[0][c] = cos(angle) * e[0][c] + sin(angle) * e[1][c];
        p->dir[1][c] = cos(angle) * e[1][c] - sin(angle) * e[0][c];
    }
}

ix_status ix__level_curvature(ix_ctx *ctx, const ix_mv *f, const double t[3],
                              ix__level_point *out)
{
    double n[3], e[2][3], len;

    *out = (ix__level_point){.regular = false};
    if (f->ndirs != 3 || f->ncoords != 1 || f->rational)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates%s; a polynomial "
                       "scalar trivariate is wanted",
                       f->ndirs, f->ncoords, f->rational ? ", rational" : "");
    for (int i = 0; i < 3; i++) {
        int k[3] = {i == 0, i == 1, i == 2};

        IX_TRY(ix_mv_partial(ctx, f, t, k, &out->gradient[i]));
        for (int j = 0; j < 3; j++) {
            int kk[3] = {k[0], k[1], k[2]};

            kk[j]++;
            IX_TRY(ix_mv_partial(ctx, f, t, kk, &out->hessian[3 * i + j]));
        }
    }
    len = ix__unit3(out->gradient, n);
    out->regular = len > 0;
    if (!out->regular)
        return IX_OK;
    ix__perp3(n, e[0]);
    ix__cross3(n, e[0], e[1]);
    curvatures(out, (const double(*)[3])e, len);
    return IX_OK;
}
