/* tri_eval.c - triangular Bezier patches: value and derivative. A point with
 * powers (n-1-i-j, i, j) of (u, v, w) has index i after all rows below j. */
#include <math.h>
#include <string.h>

#include "base/ctx.h"
#include "iritx/geom_srf.h"

static size_t row_start(int order, int j)
{
    return (size_t)j * (size_t)(2 * order - j + 1) / 2;
}

static size_t count(int order)
{
    return (size_t)order * (size_t)(order + 1) / 2;
}

/* One step of de Casteljau in place: order o becomes o - 1. The three corners
 * of the small triangle (i, j) are (i, j), (i+1, j), (i, j+1). */
static void casteljau_step(int o, const double b[3], double *p)
{
    size_t next = 0;

    for (int j = 0; j + 1 < o; j++)
        for (int i = 0; i + j + 1 < o; i++, next++) {
            size_t at = row_start(o, j) + (size_t)i;
            size_t up = row_start(o, j + 1) + (size_t)i;

            p[next] = b[0] * p[at] + b[1] * p[at + 1] + b[2] * p[up];
        }
}

ix_status ix_tri_eval(ix_ctx *ctx, int order, int naxes, const double *pts,
                      const double uvw[3], double *out)
{
    double sum = uvw[0] + uvw[1] + uvw[2], *p;
    ix_mark mk;

    if (order < 1 || order > IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EARG, "order %d of a triangular patch", order);
    if (!(fabs(sum - 1) <= 1e-5)) /* the reference's tolerance of domains */
        return IX_FAIL(ctx, IX_EDOMAIN, "u + v + w = %.15g, not 1", sum);
    mk = ix__scratch_mark(ctx);
    p = ix__scratch(ctx, count(order), sizeof *p);
    if (!p)
        return IX_ENOMEM;
    for (int k = 0; k < naxes; k++) {
        memcpy(p, pts + (size_t)k * count(order), count(order) * sizeof *p);
        for (int o = order; o > 1; o--)
            casteljau_step(o, uvw, p);
        out[k] = p[0];
    }
    ix__scratch_release(ctx, mk);
    return IX_OK;
}

/* Control point i of the curve is the blossom of n - 1 - i times one end of it
 * and i times the other. */
static ix_status iso(ix_ctx *ctx, int order, int naxes, int dir, double t,
                     const double *pts, double *out)
{
    double end[2][3], *p;

    for (int e = 0; e < 2; e++) {
        end[e][dir] = t;
        end[e][dir == 0 ? 1 : 0] = e ? 0 : 1 - t;
        end[e][dir == 2 ? 1 : 2] = e ? 1 - t : 0;
    }
    IX_SCRATCH(ctx, p, count(order));
    for (int k = 0; k < naxes; k++)
        for (int i = 0; i < order; i++) {
            memcpy(p, pts + (size_t)k * count(order), count(order) * sizeof *p);
            for (int o = order; o > 1; o--)
                casteljau_step(o, end[order - o < i], p);
            out[k * order + i] = p[0];
        }
    return IX_OK;
}

ix_status ix_tri_iso(ix_ctx *ctx, int order, int naxes, int dir, double t,
                     const double *pts, double *out)
{
    if (order < 1 || order > IX_MAX_ORDER || dir < 0 || dir > 2)
        return IX_FAIL(ctx, IX_EARG,
                       "order %d, direction %d of a triangular patch", order,
                       dir);
    if (!(t >= 0 && t <= 1))
        return IX_FAIL(ctx, IX_EDOMAIN, "parameter %g is outside [0, 1]", t);
    IX_RETURN_SCOPED(ctx, iso(ctx, order, naxes, dir, t, pts, out));
}

/* Differences of two of the three corners of every small triangle. */
void ix_tri_derive(int order, int naxes, int dir, const double *pts,
                   double *out)
{
    /* The weights of the corners u, v, w. */
    static const int diff[3][3] = {{1, 0, -1}, {0, 1, -1}, {-1, 0, 1}};
    const int *f = diff[dir];

    if (order == 1) {
        memset(out, 0, (size_t)naxes * sizeof *out);
        return;
    }
    for (int k = 0; k < naxes; k++, pts += count(order))
        for (int j = 0; j + 1 < order; j++)
            for (int i = 0; i + j + 1 < order; i++) {
                size_t at = row_start(order, j) + (size_t)i;
                size_t up = row_start(order, j + 1) + (size_t)i;

                *out++ = (order - 1) *
                         (f[0] * pts[at] + f[1] * pts[at + 1] + f[2] * pts[up]);
            }
}
