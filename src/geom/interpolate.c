/* interpolate.c - B-splines through points or near them (least squares), and
 * near curves. The parameters fix the system's rows, the knots its columns. */
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/project.h"
#include "iritx/geom.h"
#include "mv/mv.h"

/* Counts that fit each other; size 0 becomes n. */
static ix_status check_counts(ix_ctx *ctx, int n, const ix_interpolate_opts *o,
                              int *size)
{
    int nk;

    *size = o->size ? o->size : n;
    if (!(o->order >= 1 && o->order <= IX_MAX_ORDER))
        return IX_FAIL(ctx, IX_EARG, "order %d", o->order);
    if (!(o->order <= *size && *size <= n))
        return IX_FAIL(ctx, IX_EARG,
                       "order %d <= control points %d <= data points %d is not "
                       "so",
                       o->order, *size, n);
    if (o->params && o->nparams != n)
        return IX_FAIL(ctx, IX_EARG, "%d parameters for %d points", o->nparams,
                       n);
    nk = *size + o->order + (o->periodic ? o->order - 1 : 0);
    if (o->knots && o->nknots != nk)
        return IX_FAIL(ctx, IX_EARG,
                       "%d knots for %d control points of order %d: want %d",
                       o->nknots, *size, o->order, nk);
    return IX_OK;
}

/* Given parameters copied, checked against the domain of dir. */
static ix_status given_params(ix_ctx *ctx, const ix_interpolate_opts *o,
                              const ix_dir *dir, int n, double *tau)
{
    double dom[2], slack;

    ix__dir_domain(dir, dom);
    slack = 1e-5 * (dom[1] - dom[0]); /* as evaluation has it */
    for (int i = 0; i < n; i++) {
        double t = o->params[i];

        if (!(t >= dom[0] - slack && t <= dom[1] + slack))
            return IX_FAIL(ctx, IX_EARG,
                           "parameter %d, %g, is outside the knots' domain "
                           "[%g, %g]",
                           i, t, dom[0], dom[1]);
        if (i > 0 && !(t >= o->params[i - 1]))
            return IX_FAIL(ctx, IX_EARG, "parameter %d, %g, is below %g", i, t,
                           o->params[i - 1]);
        tau[i] = fmax(dom[0], fmin(dom[1], t));
    }
    return IX_OK;
}

/* The direction and the parameters tau[n]; knots in scratch. */
static ix_status layout(ix_ctx *ctx, int n, int ncoords, const double *pts,
                        const ix_interpolate_opts *o, ix_dir *dir, double *tau)
{
    double *knots;
    int size;

    IX_TRY(check_counts(ctx, n, o, &size));
    *dir = (ix_dir){.basis = IX_BSPLINE,
                    .order = o->order,
                    .length = size,
                    .periodic = o->periodic};
    IX_SCRATCH(ctx, knots, ix_knots_count(dir));
    dir->knots = o->knots ? o->knots : knots;
    if (o->knots)
        IX_TRY(ix__mv_check_dirs(ctx, 1, dir, ncoords));
    for (int i = 0; o->periodic && i < n; i++)
        tau[i] = (double)i / n;
    if (!o->periodic && !o->params && n > 1)
        IX_TRY(ix_params(ctx, o->param, n, ncoords, pts, tau));
    if (n == 1)
        tau[0] = 0;
    if (!o->knots && o->periodic)
        IX_TRY(ix_knots_make(ctx, IX_KV_PERIODIC, o->order, size, knots));
    if (o->params)
        IX_TRY(given_params(ctx, o, dir, n, tau));
    if (!o->knots && !o->periodic)
        IX_TRY(ix_params_knots(ctx, o->order, size, n, tau, knots));
    return IX_OK;
}

static ix_status solve(ix_ctx *ctx, const ix_dir *dir, int n, int naxes,
                       const double *tau, const double *pts, ix_band *band,
                       double *x)
{
    double *w, rhs[IX_MAX_COORDS + 1];
    ix_status st;

    IX_SCRATCH(ctx, w, dir->order);
    IX_TRY(
        ix__band_new(ctx, dir->length, dir->order, dir->periodic, naxes, band));
    for (int i = 0; i < n; i++) {
        int first = ix__basis_first(dir, tau[i]);

        ix__basis_derive(dir, first, tau[i], 0, w);
        for (int a = 0; a < naxes; a++)
            rhs[a] = pts[(size_t)a * (size_t)n + (size_t)i];
        ix__band_add(band, first % dir->length, dir->order, w, rhs);
    }
    st = ix__band_solve(ctx, band, x);
    if (st == IX_EDOMAIN)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "failed to interpolate: %d points do not determine %d "
                       "control points of order %d%s; another order or size "
                       "may do",
                       n, dir->length, dir->order,
                       dir->periodic ? " (periodic)" : "");
    return st;
}

/* Data at the clamped ends are control points; say so exactly. */
static void set_ends(const ix_dir *dir, int n, int naxes, const double *tau,
                     const double *pts, double *x)
{
    size_t last = (size_t)n - 1;
    int k = dir->order;

    if (n != dir->length || dir->periodic || k < 2)
        return;
    for (size_t a = 0; a < (size_t)naxes; a++) {
        if (dir->knots[0] == tau[0] && dir->knots[k - 1] == tau[0])
            x[a * (size_t)n] = pts[a * (size_t)n];
        if (dir->knots[n] == tau[last] && dir->knots[n + k - 1] == tau[last])
            x[a * (size_t)n + last] = pts[a * (size_t)n + last];
    }
}

static ix_status interp(ix_ctx *ctx, int n, int ncoords, bool rational,
                        const double *pts, const ix_interpolate_opts *o,
                        double *res, ix_mv **out)
{
    int naxes = ncoords + (rational ? 1 : 0);
    ix_band band;
    ix_dir dir;
    double *tau, *x, sum = 0;

    IX_SCRATCH(ctx, tau, n);
    IX_TRY(layout(ctx, n, ncoords, pts + (rational ? (size_t)n : 0), o, &dir,
                  tau));
    IX_SCRATCH(ctx, x, (size_t)naxes * (size_t)dir.length);
    IX_TRY(solve(ctx, &dir, n, naxes, tau, pts, &band, x));
    set_ends(&dir, n, naxes, tau, pts, x);
    for (int a = 0; a < naxes; a++)
        sum += band.rest[a];
    if (res)
        *res = sqrt(sum / n);
    return ix_mv_new(ctx, 1, &dir, ncoords, rational, x, out);
}

ix_status ix_interpolate(ix_ctx *ctx, int n, int ncoords, bool rational,
                         const double *pts, const ix_interpolate_opts *o,
                         double *res, ix_mv **out)
{
    *out = NULL;
    if (n < 1 || ncoords < 1 || ncoords > IX_MAX_COORDS)
        return IX_FAIL(ctx, IX_EARG, "%d points of %d coordinates", n, ncoords);
    for (size_t i = 0; i < (size_t)n * (size_t)(ncoords + (rational ? 1 : 0));
         i++)
        if (!isfinite(pts[i]))
            return IX_FAIL(ctx, IX_EARG, "point %zu has a coordinate %g",
                           i % (size_t)n, pts[i]);
    IX_RETURN_SCOPED(ctx, interp(ctx, n, ncoords, rational, pts, o, res, out));
}

/* --- curves as data --------------------------------------------------------
 */

/* Uniform knots over the curve's domain, unless o has some. */
static ix_status curve_layout(ix_ctx *ctx, const ix_mv *crv,
                              const ix_interpolate_opts *o, ix_dir *dir)
{
    double *knots, dom[2], own[2];
    int size = o->size ? o->size : ix_mv_length(crv, 0), nk;

    *dir = (ix_dir){.basis = IX_BSPLINE,
                    .order = o->order,
                    .length = size,
                    .periodic = o->periodic};
    if (!(o->order >= 1 && o->order <= size && o->order <= IX_MAX_ORDER))
        return IX_FAIL(ctx, IX_EARG, "order %d with %d control points",
                       o->order, size);
    nk = ix_knots_count(dir);
    if (o->knots && o->nknots != nk)
        return IX_FAIL(ctx, IX_EARG, "%d knots: want %d", o->nknots, nk);
    IX_SCRATCH(ctx, knots, nk);
    dir->knots = knots;
    if (o->knots)
        memcpy(knots, o->knots, (size_t)nk * sizeof *knots);
    else
        IX_TRY(ix_knots_make(ctx, o->periodic ? IX_KV_PERIODIC : IX_KV_OPEN,
                             o->order, size, knots));
    IX_TRY(ix__mv_check_dirs(ctx, 1, dir, ix_mv_ncoords(crv)));
    ix_mv_domain(crv, 0, dom);
    ix__dir_domain(dir, own);
    for (int i = 0; i < nk; i++)
        knots[i] = knots[i] == own[1]
                       ? dom[1]
                       : dom[0] + (knots[i] - own[0]) / (own[1] - own[0]) *
                                      (dom[1] - dom[0]);
    return IX_OK;
}

static ix_status fit_curve(ix_ctx *ctx, const ix_mv *crv,
                           const ix_interpolate_opts *o, double *err,
                           ix_mv **out)
{
    ix_path p, q;
    ix_dir dir;
    double *coef;
    ix_status st;
    ix_mv *m = NULL;

    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__path_no_poles(ctx, &p));
    IX_TRY(curve_layout(ctx, crv, o, &dir));
    IX_SCRATCH(ctx, coef, (size_t)p.ncoords * (size_t)dir.length);
    IX_TRY(
        ix__project(ctx, &p, &dir, (ix_project_opts){.keep_ends = true}, coef));
    IX_TRY(ix_mv_new(ctx, 1, &dir, p.ncoords, false, coef, &m));
    st = ix__path_new(ctx, m, &q);
    if (st == IX_OK)
        st = ix__path_distance(ctx, &p, &q, err);
    if (st == IX_OK)
        *out = m;
    else
        ix_mv_unref(ctx, m);
    return st;
}

ix_status ix_fit_curve(ix_ctx *ctx, const ix_mv *crv,
                       const ix_interpolate_opts *o, double *err, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, fit_curve(ctx, crv, o, err, out));
}
