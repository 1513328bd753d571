/* ratio_sector.c - the points whose distances from two curves have a constant
 * ratio: not rational, so interpolated to a tolerance.
 *
 * Over each pair of feet both normal planes meet in a line B = P + x u, and
 *
 *   |B - C1|^2 = k^2 |B - C2|^2,   k = alpha / (1 - alpha),
 *
 * is a quadratic equation for x: two sheets. */
#include <math.h>

#include "geom/crvs.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "iritx/ops_bisect.h"
#include "mv/mv.h"

enum { START = 17, MOST = 257, ORDER = 4 };

typedef struct {
    const ix_mv *c[2];
    double k, dom[2][2];
} sector;

/* Foot and unit tangent at u in [0, 1] of the domain. */
static ix_status foot_of(ix_ctx *ctx, const sector *s, int i, double u,
                         double x[3], double t[3])
{
    double d[2 * IX_MAX_COORDS],
        at = s->dom[i][0] + u * (s->dom[i][1] - s->dom[i][0]);
    int nc = ix_mv_ncoords(s->c[i]);

    IX_TRY(ix_mv_curve_derivs(ctx, s->c[i], at, 1, d));
    for (int k = 0; k < 3; k++) {
        x[k] = k < nc ? d[k] : 0.0;
        t[k] = k < nc ? d[nc + k] : 0.0;
    }
    if (!(ix__unit3(t, t) > 0))
        return IX_FAIL(ctx, IX_EDOMAIN, "curve %d has no tangent at %g", i + 1,
                       at);
    return IX_OK;
}

/* The point of both normal planes next to p, and the direction u of their line;
 * false if they are parallel (sine 1e-9). */
static bool line_of(double x[2][3], double t[2][3], double p[3], double u[3])
{
    double a[3], b[3], h[2], sine;

    ix__cross3(t[0], t[1], u);
    sine = ix__unit3(u, u);
    if (!(sine > 1e-9))
        return false;
    for (int i = 0; i < 2; i++)
        h[i] = ix__dot3(t[i], x[i]);
    ix__cross3(t[1], u, a);
    ix__cross3(u, t[0], b);
    for (int k = 0; k < 3; k++)
        p[k] = (h[0] * a[k] + h[1] * b[k]) / sine;
    return true;
}

/* Both solutions of a x^2 + 2 b x + c = 0, by sheet; false if not real. */
static bool roots_of(double a, double b, double c, double x[2])
{
    double disc = b * b - a * c, q;

    if (!(disc >= 0.0))
        return false;
    q = b >= 0.0 ? -b - sqrt(disc) : -b + sqrt(disc);
    x[b >= 0.0 ? 0 : 1] = q / a;
    x[b >= 0.0 ? 1 : 0] = q == 0.0 ? 0.0 : c / q;
    return true;
}

/* Points of both sheets over (v[0], v[1]). */
static ix_status points_at(ix_ctx *ctx, const sector *s, const double v[2],
                           double out[2][3])
{
    double x[2][3], t[2][3], p[3], u[3], r[2][3], k2 = s->k * s->k, root[2];
    bool ok;

    for (int i = 0; i < 2; i++)
        IX_TRY(foot_of(ctx, s, i, v[i], x[i], t[i]));
    ok = line_of(x, t, p, u);
    for (int i = 0; i < 2; i++)
        ix__sub3(p, x[i], r[i]);
    ok = ok && roots_of(1.0 - k2, ix__dot3(u, r[0]) - k2 * ix__dot3(u, r[1]),
                        ix__dot3(r[0], r[0]) - k2 * ix__dot3(r[1], r[1]), root);
    if (!ok)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no point with this ratio over the parameters (%g, %g)",
                       s->dom[0][0] + v[0] * (s->dom[0][1] - s->dom[0][0]),
                       s->dom[1][0] + v[1] * (s->dom[1][1] - s->dom[1][0]));
    for (int i = 0; i < 2; i++)
        ix__axpy3(p, root[i], u, out[i]);
    return IX_OK;
}

/* n x n points of both sheets, double[2][3][n n]. */
static ix_status sample(ix_ctx *ctx, const sector *s, int n, double **out)
{
    size_t total = (size_t)n * (size_t)n;

    IX_SCRATCH(ctx, *out, 6 * total);
    for (size_t i = 0; i < total; i++) {
        double v[2] = {(double)(i % (size_t)n) / (n - 1),
                       (double)(i / (size_t)n) / (n - 1)},
               x[2][3];

        IX_TRY(points_at(ctx, s, v, x));
        for (size_t k = 0; k < 6; k++)
            (*out)[k * total + i] = x[k / 3][k % 3];
    }
    return ix__poll(ctx);
}

/* Distance from the sheets half way between the nodes. */
static ix_status error_of(ix_ctx *ctx, const sector *s, int n,
                          ix_mv *const srf[2], double *worst)
{
    *worst = 0.0;
    for (int i = 0; i < (n - 1) * (n - 1); i++) {
        double v[2] = {(i % (n - 1) + 0.5) / (n - 1),
                       (i / (n - 1) + 0.5) / (n - 1)},
               x[2][3], y[3];

        IX_TRY(points_at(ctx, s, v, x));
        for (int k = 0; k < 2; k++) {
            IX_TRY(ix_mv_point(ctx, srf[k], v, y));
            *worst = fmax(*worst, ix__dist3(x[k], y));
        }
    }
    return IX_OK;
}

static ix_status interpolate(ix_ctx *ctx, int n, const double *pts,
                             ix_mv *srf[2])
{
    const int count[2] = {n, n}, order[2] = {ORDER, ORDER};
    size_t total = (size_t)n * (size_t)n;

    for (size_t k = 0; k < 2; k++)
        IX_TRY(ix_srf_fit_grid(ctx, count, 3, false, pts + 3 * k * total, order,
                               count, &srf[k]));
    return IX_OK;
}

/* Grids of twice as many steps until the error is within tol. */
static ix_status refine(ix_ctx *ctx, const sector *s, double tol, ix_mv *srf[2],
                        double *err)
{
    for (int n = START; n <= MOST; n = 2 * n - 1) {
        ix_mark mk = ix__scratch_mark(ctx);
        double *pts;
        ix_status st = sample(ctx, s, n, &pts);

        if (st == IX_OK)
            st = interpolate(ctx, n, pts, srf);
        ix__scratch_release(ctx, mk);
        if (st == IX_OK)
            st = error_of(ctx, s, n, srf, err);
        if (st != IX_OK || *err <= tol)
            return st;
        for (int k = 0; k < 2; k++) {
            ix_mv_unref(ctx, srf[k]);
            srf[k] = NULL;
        }
    }
    return IX_FAIL(ctx, IX_EUNABLE,
                   "%d x %d points leave an error of %.3g, above %g", MOST,
                   MOST, *err, tol);
}

/* Over the domains of the curves; takes over srf. */
static ix_status deliver(ix_ctx *ctx, const sector *s, ix_mv *srf[2],
                         ix_crvs *out)
{
    ix_status st = ix__crvs_new(ctx, 2, out);

    for (int i = 0; i < 2; i++) {
        ix_mv *half = NULL;

        if (st == IX_OK)
            st = ix_mv_reparam(ctx, srf[i], 0, s->dom[0][0], s->dom[0][1],
                               &half);
        if (st == IX_OK)
            st = ix_mv_reparam(ctx, half, 1, s->dom[1][0], s->dom[1][1],
                               &out->crv[i]);
        ix_mv_unref(ctx, half);
    }
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    return st;
}

static ix_status run(ix_ctx *ctx, const sector *s, double tol, double *err,
                     ix_crvs *out)
{
    ix_mv *srf[2] = {NULL, NULL};
    ix_status st = refine(ctx, s, tol, srf, err);

    if (st == IX_OK)
        st = deliver(ctx, s, srf, out);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(ctx, srf[i]);
    return st;
}

ix_status ix_ratio_sector(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                          double alpha, double tol, double *err, ix_crvs *out)
{
    sector s = {.c = {c1, c2}, .k = alpha / (1.0 - alpha)};
    double worst;

    *out = (ix_crvs){.n = 0};
    if (!(alpha > 0.0 && alpha < 1.0) || alpha == 0.5)
        return IX_FAIL(ctx, IX_EARG,
                       "a ratio of %g: between 0 and 1, not 0.5 (the bisector) "
                       "is needed",
                       alpha);
    if (!(tol > 0.0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    for (int i = 0; i < 2; i++) {
        if (s.c[i]->ndirs != 1 || s.c[i]->ncoords < 2 || s.c[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: a "
                           "curve with 2 or 3 is needed",
                           i + 1, s.c[i]->ndirs, s.c[i]->ncoords);
        ix_mv_domain(s.c[i], 0, s.dom[i]);
    }
    IX_RETURN_SCOPED(ctx, run(ctx, &s, tol, err ? err : &worst, out));
}
