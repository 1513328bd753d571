/* belt.c - see the header. With signed radii s and the tangent's left normal n,
 * a pulley's centre is its tangent point + s n, so (c2 - c1).n = s2 - s1. */
#include "geom/belt.h"

#include <math.h>

#include "geom/angle.h"
#include "geom/crvs.h"

static ix_status left_normal(ix_ctx *ctx, const double *a, const double *b,
                             int i, double n[2])
{
    double d[2] = {b[0] - a[0], b[1] - a[1]}, s = b[2] - a[2];
    double dd = d[0] * d[0] + d[1] * d[1], along;

    if (!(dd > s * s))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no tangent goes from pulley %d to the next one: they "
                       "are %g apart, %g is needed",
                       i + 1, sqrt(dd), fabs(s));
    along = sqrt(dd - s * s);
    n[0] = (s * d[0] - along * d[1]) / dd;
    n[1] = (s * d[1] + along * d[0]) / dd;
    return IX_OK;
}

/* The arc of a pulley between two normals, the way it turns. */
static ix_status arc(ix_ctx *ctx, const double *p, const double in[2],
                     const double out[2], ix_mv **crv)
{
    double turn = p[2] > 0 ? 1 : -1;
    const double center[3] = {p[0], p[1], 0};
    /* points are centre - s n */
    double a = atan2(-turn * in[1], -turn * in[0]);
    double b = atan2(-turn * out[1], -turn * out[0]);
    double way = fmod(turn * (b - a) + 4 * IX__PI, 2 * IX__PI);
    ix_mv *m;
    ix_status st;

    if (turn > 0)
        return ix_arc_angles(ctx, center, p[2], IX__DEG(a), IX__DEG(a + way),
                             crv);
    IX_TRY(ix_arc_angles(ctx, center, -p[2], IX__DEG(a - way), IX__DEG(a), &m));
    st = ix_mv_reverse(ctx, m, 0, crv);
    ix_mv_unref(ctx, m);
    return st;
}

static ix_status line(ix_ctx *ctx, const double *a, const double *b,
                      const double n[2], ix_mv **crv)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    double pts[6] = {1, 1};

    for (int c = 0; c < 2; c++) {
        pts[2 + 2 * c] = a[c] - a[2] * n[c];
        pts[3 + 2 * c] = b[c] - b[2] * n[c];
    }
    return ix_mv_new(ctx, 1, &d, 2, true, pts, crv);
}

static ix_status flat_arc(ix_ctx *ctx, const double *p, const double in[2],
                          const double out[2], ix_mv **crv)
{
    ix_mv *m;
    ix_status st;

    IX_TRY(arc(ctx, p, in, out, &m));
    st = ix_mv_coerce(ctx, m, 2, true, crv);
    ix_mv_unref(ctx, m);
    return st;
}

static ix_status belt(ix_ctx *ctx, int n, const double (*pulley)[3],
                      double grow, ix_crvs *out)
{
    double(*p)[3], (*nrm)[2];

    IX_SCRATCH(ctx, p, n);
    IX_SCRATCH(ctx, nrm, n);
    for (int i = 0; i < n; i++) {
        p[i][0] = pulley[i][0];
        p[i][1] = pulley[i][1];
        p[i][2] = pulley[i][2] + grow;
        if (!(p[i][2] * pulley[i][2] > 0))
            return IX_FAIL(ctx, IX_EARG, "pulley %d of radius %g leaves no arc",
                           i + 1, pulley[i][2]);
    }
    for (int i = 0; i < n; i++)
        IX_TRY(left_normal(ctx, p[i], p[(i + 1) % n], i, nrm[i]));
    IX_TRY(ix__crvs_new(ctx, 2 * n, out));
    for (int i = 0; i < n; i++) {
        IX_TRY(flat_arc(ctx, p[i], nrm[(i + n - 1) % n], nrm[i],
                        &out->crv[2 * i]));
        IX_TRY(line(ctx, p[i], p[(i + 1) % n], nrm[i], &out->crv[2 * i + 1]));
    }
    return IX_OK;
}

ix_status ix__belt(ix_ctx *ctx, int n, const double (*pulley)[3], double grow,
                   ix_crvs *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = (ix_crvs){0};
    if (n < 2)
        return IX_FAIL(ctx, IX_EARG, "%d pulleys; a belt needs two", n);
    st = belt(ctx, n, pulley, grow, out);
    ix__scratch_release(ctx, mk);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    return st;
}
