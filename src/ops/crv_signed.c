/* crv_signed.c - signed curvature of planar curves as a function, and curves
 * from such functions.
 *
 * The function takes samples as the control values of a B-spline: it is smooth
 * and close, no interpolation. A curve is found from its curvature kappa(s), s
 * the arc length: theta = integral of kappa exactly, then position = integral
 * of (cos theta, sin theta) by Gauss' rule, as C1 cubics through exact
 * directions. */
#include <math.h>
#include <string.h>

#include "iritx/ops_crv.h"
#include "mv/mv.h"

enum { MAX_PIECES = 1000000 };

/* --- from a curve ----------------------------------------------------------
 */

static ix_status signed_at(ix_ctx *ctx, const ix_mv *crv, double t, double *out)
{
    double d[3 * IX_MAX_COORDS], speed;
    int nc = ix_mv_ncoords(crv);
    const double *v = d + nc, *a = d + 2 * nc;

    IX_TRY(ix_mv_curve_derivs(ctx, crv, t, 2, d));
    speed = hypot(v[0], v[1]);
    if (!(speed > 0))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no curvature at %g: the derivative vanishes", t);
    *out = (v[0] / speed * a[1] - v[1] / speed * a[0]) / speed / speed;
    return IX_OK;
}

/* Arc lengths from the start to n uniform parameters. */
static ix_status lengths(ix_ctx *ctx, const ix_mv *crv, const double dom[2],
                         int n, double *s)
{
    s[0] = 0.0;
    for (int i = 1; i < n; i++) {
        double r[2] = {dom[0] + (dom[1] - dom[0]) * (i - 1) / (n - 1),
                       dom[0] + (dom[1] - dom[0]) * i / (n - 1)};

        IX_TRY(ix_length(ctx, crv, r, &s[i]));
        s[i] += s[i - 1];
    }
    return IX_OK;
}

/* Open knots: uniform over dom, or averages of s (as nodes want them). */
static void place_knots(int n, int order, const double dom[2], const double *s,
                        double *kv)
{
    double lo = s ? s[0] : dom[0], hi = s ? s[n - 1] : dom[1];

    for (int i = 0; i < order; i++) {
        kv[i] = lo;
        kv[n + i] = hi;
    }
    for (int i = order; i < n; i++) {
        double sum = 0.0;

        for (int k = 1; s && k < order; k++)
            sum += s[i - order + k];
        kv[i] = s ? sum / (order - 1)
                  : lo + (hi - lo) * (i - order + 1) / (n - order + 1);
    }
}

static ix_status sample(ix_ctx *ctx, const ix_mv *crv, int n, int order,
                        bool arclen, ix_mv **out)
{
    double dom[2], *v, *kv, *s = NULL;
    ix_dir dir = {IX_BSPLINE, order, n, false, NULL};

    ix_mv_domain(crv, 0, dom);
    IX_SCRATCH(ctx, v, n);
    IX_SCRATCH(ctx, kv, n + order);
    for (int i = 0; i < n; i++) {
        double u = (double)i / (n - 1);

        IX_TRY(signed_at(ctx, crv, dom[0] * (1 - u) + dom[1] * u, &v[i]));
    }
    if (arclen) {
        IX_SCRATCH(ctx, s, n);
        IX_TRY(lengths(ctx, crv, dom, n, s));
    }
    place_knots(n, order, dom, s, kv);
    dir.knots = kv;
    return ix_mv_new(ctx, 1, &dir, 1, false, v, out);
}

ix_status ix_curvature_function(ix_ctx *ctx, const ix_mv *crv, int n, int order,
                                bool arclen, ix_mv **out)
{
    *out = NULL;
    if (crv->ndirs != 1 || crv->ncoords < 2 || crv->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, %d coordinates: a planar curve is "
                       "needed",
                       crv->ndirs, crv->ncoords);
    if (order < 2 || n < order || n > MAX_PIECES)
        return IX_FAIL(ctx, IX_EARG,
                       "%d samples for order %d: at least that many, an order "
                       "of at least 2, at most %d samples",
                       n, order, (int)MAX_PIECES);
    IX_RETURN_SCOPED(ctx, sample(ctx, crv, n, order, arclen, out));
}

/* --- to a curve ------------------------------------------------------------
 */

/* Adds the integral of (cos theta, sin theta) over [a, b] to p; five nodes are
 * exact to the order 10 of the length. */
static ix_status advance(ix_ctx *ctx, const ix_mv *theta, double a, double b,
                         double p[2])
{
    static const double x[5] = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                0.5384693101056831, 0.9061798459386640};
    static const double w[5] = {0.2369268850561891, 0.4786286704993665,
                                0.5688888888888889, 0.4786286704993665,
                                0.2369268850561891};

    for (int i = 0; i < 5; i++) {
        double t = (a + b) / 2 + x[i] * (b - a) / 2, f = w[i] * (b - a) / 2, v;

        IX_TRY(ix_mv_eval(ctx, theta, &t, &v));
        p[0] += f * cos(v);
        p[1] += f * sin(v);
    }
    return IX_OK;
}

/* Control points of C1 cubics over n equal pieces: double[2][2 n + 2]. */
static ix_status walk(ix_ctx *ctx, const ix_mv *theta, const double dom[2],
                      int n, bool closed, double *pts)
{
    double h = (dom[1] - dom[0]) / n, p[2] = {0, 0};
    size_t len = 2 * (size_t)n + 2;

    for (int i = 0; i <= n; i++) {
        double t = i == n ? dom[1] : dom[0] + i * h, v;
        double d[2];

        IX_TRY(ix_mv_eval(ctx, theta, &t, &v));
        d[0] = cos(v) * h / 3;
        d[1] = sin(v) * h / 3;
        if (i > 0)
            IX_TRY(advance(ctx, theta, t - h, t, p));
        for (size_t k = 0; k < 2; k++) {
            double *x = pts + k * len + 2 * (size_t)i;

            x[0] = i == 0 ? p[k] : p[k] - d[k];
            x[1] = i == n ? p[k] : p[k] + d[k];
        }
    }
    for (size_t k = 0; k < 2; k++) /* the gap, spread evenly */
        for (size_t i = 0; closed && i < len; i++)
            pts[k * len + i] -= p[k] * (double)i / (double)(len - 1);
    return IX_OK;
}

static ix_status reconstruct(ix_ctx *ctx, const ix_mv *theta, int n,
                             bool closed, ix_mv **out)
{
    ix_dir dir = {IX_BSPLINE, 4, 2 * n + 2, false, NULL};
    double dom[2], *kv, *pts;

    ix_mv_domain(theta, 0, dom);
    IX_SCRATCH(ctx, kv, 2 * (size_t)n + 6);
    IX_SCRATCH(ctx, pts, 2 * (2 * (size_t)n + 2));
    IX_TRY(walk(ctx, theta, dom, n, closed, pts));
    for (int i = 0; i < 2 * n + 6; i++) {
        int k = i < 4 ? 0 : i >= 2 * n + 2 ? n : (i - 2) / 2;

        kv[i] = k == n ? dom[1] : dom[0] + k * ((dom[1] - dom[0]) / n);
    }
    dir.knots = kv;
    return ix_mv_new(ctx, 1, &dir, 2, false, pts, out);
}

ix_status ix_curve_of_curvature(ix_ctx *ctx, const ix_mv *k, int n, bool closed,
                                ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *theta;
    ix_status st;

    *out = NULL;
    if (k->ndirs != 1 || k->ncoords != 1 || k->rational)
        return IX_FAIL(ctx, IX_EARG,
                       "a polynomial function of one parameter is needed");
    if (n < 1 || n > MAX_PIECES)
        return IX_FAIL(ctx, IX_EARG, "%d pieces are not in 1 .. %d", n,
                       (int)MAX_PIECES);
    IX_TRY(ix_sym_integrate(ctx, k, 0, &theta));
    st = reconstruct(ctx, theta, n, closed, out);
    ix_mv_unref(ctx, theta);
    ix__scratch_release(ctx, mk);
    return st;
}
