/* srf_fit.c - surfaces and trivariates through layers (skinning), and near
 * surfaces. */
#include "iritx/geom_srf.h"

#include <math.h>
#include <string.h>

#include "geom/fit_rows.h"
#include "geom/parts.h"

/* --- skinning ---------------------------------------------------------- */

/* Point i of the n layers of m, its last direction, projected:
 * double[ncoords][n]. */
static void column(const ix_mv *m, size_t n, size_t i, double *pts)
{
    size_t layer = m->npts / n;

    for (int c = 0; c < m->ncoords; c++)
        for (size_t k = 0; k < n; k++) {
            double w = m->rational ? ix_mv_weights(m)[k * layer + i] : 1;

            *pts++ = ix_mv_coord(m, c)[k * layer + i] / (w != 0 ? w : 1);
        }
}

/* Parameters of the layers: the mean of those of the columns of control
 * points, without columns that are one point (Piegl, Tiller 1997, 10.3). */
static ix_status layer_params(ix_ctx *ctx, const ix_mv *m, ix_param how, int n,
                              double *tau)
{
    size_t layer = m->npts / (size_t)n, used = 0;
    double *pts, *one;

    IX_SCRATCH(ctx, pts, (size_t)m->ncoords * (size_t)n);
    IX_SCRATCH(ctx, one, n);
    memset(tau, 0, (size_t)n * sizeof *tau);
    for (size_t i = 0; i < layer; i++) {
        ix_status st;

        column(m, (size_t)n, i, pts);
        st = ix_params(ctx, how, n, m->ncoords, pts, one);
        if (st == IX_EDOMAIN)
            continue;
        IX_TRY(st);
        used++;
        for (int k = 0; k < n; k++)
            tau[k] += one[k];
    }
    if (used == 0)
        return IX_FAIL(ctx, IX_EDOMAIN, "all %d layers are the same", n);
    for (int k = 0; k < n; k++)
        tau[k] = k == n - 1 ? 1 : tau[k] / (double)used;
    return IX_OK;
}

/* The knots of the new direction and the parameters tau of the layers. */
static ix_status skin_dir(ix_ctx *ctx, const ix_mv *m, ix_kv_kind kv,
                          ix_param how, ix_dir *dir, double *tau)
{
    int n = dir->length;
    double *knots;

    IX_SCRATCH(ctx, knots, ix_knots_count(dir));
    dir->knots = knots;
    if (kv == IX_KV_PERIODIC)
        for (int k = 0; k < n; k++)
            tau[k] = (double)k / n;
    else
        IX_TRY(layer_params(ctx, m, how, n, tau));
    if (kv == IX_KV_OPEN)
        return ix_params_knots(ctx, dir->order, n, n, tau, knots);
    return ix_knots_make(ctx, kv, dir->order, n, knots);
}

/* m: the layers, compatible, along its last direction. */
static ix_status skin(ix_ctx *ctx, const ix_mv *m, int order, ix_kv_kind kv,
                      ix_param how, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS], *last = &dirs[m->ndirs - 1];
    size_t total = (size_t)m->naxes * m->npts;
    double *tau, *pts;
    ix__fit f;

    memcpy(dirs, m->dirs, (size_t)m->ndirs * sizeof *dirs);
    *last = (ix_dir){.basis = IX_BSPLINE,
                     .order = order,
                     .length = last->length,
                     .periodic = kv == IX_KV_PERIODIC};
    IX_SCRATCH(ctx, tau, last->length);
    IX_TRY(skin_dir(ctx, m, kv, how, last, tau));
    f = (ix__fit){last, last->length, tau, (size_t)m->naxes,
                  m->npts / (size_t)last->length};
    IX_SCRATCH(ctx, pts, total);
    IX_TRY(ix__fit_rows(ctx, &f, m->pts, pts));
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, dirs, m->ncoords, m->rational, out));
    memcpy((*out)->pts, pts, total * sizeof *pts);
    return IX_OK;
}

static ix_status skin_layers(ix_ctx *ctx, int n, const ix_mv *const *layers,
                             int order, ix_kv_kind kv, ix_param how,
                             ix_mv *t[2], ix_mv **out)
{
    IX_TRY(ix_srf_layers(ctx, n, layers, 2, IX_KV_OPEN, &t[0]));
    IX_TRY(ix_mv_to_bspline(ctx, t[0], &t[1]));
    return skin(ctx, t[1], order, kv, how, out);
}

ix_status ix_srf_skin(ix_ctx *ctx, int n, const ix_mv *const *layers, int order,
                      ix_kv_kind kv, ix_param how, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *t[2] = {NULL};
    ix_status st;

    *out = NULL;
    if (order < 2 || order > n)
        return IX_FAIL(ctx, IX_EARG,
                       "order %d across %d layers is not in 2 .. "
                       "%d",
                       order, n, n);
    if (kv == IX_KV_DISC_OPEN)
        return IX_FAIL(ctx, IX_EARG, "discontinuous knots cannot interpolate");
    st = skin_layers(ctx, n, layers, order, kv, how, t, out);
    ix__mv_unref_all(ctx, t, 2);
    ix__scratch_release(ctx, mk);
    return st;
}

/* --- surfaces ---------------------------------------------------------- */

enum { SAMPLES_PER_POINT = 4 };

/* Samples double[ncoords][count[0] * count[1]] of the projected surface. */
static ix_status sample(ix_ctx *ctx, const ix_mv *s, const int count[2],
                        double *pts)
{
    size_t n = (size_t)count[0] * (size_t)count[1];
    double dom[2][2], uv[2], p[IX_MAX_COORDS];

    for (int d = 0; d < 2; d++)
        ix_mv_domain(s, d, dom[d]);
    for (size_t i = 0; i < n; i++) {
        size_t k[2] = {i % (size_t)count[0], i / (size_t)count[0]};

        for (int d = 0; d < 2; d++) {
            double x = (double)k[d] / (count[d] - 1);

            uv[d] = (1 - x) * dom[d][0] + x * dom[d][1];
        }
        IX_TRY(ix_mv_point(ctx, s, uv, p));
        for (size_t c = 0; c < (size_t)s->ncoords; c++)
            pts[c * n + i] = p[c];
    }
    return IX_OK;
}

static double largest_distance(size_t n, int ncoords, const double *a,
                               const double *b)
{
    double worst = 0;

    for (size_t i = 0; i < n; i++) {
        double sum = 0;

        for (size_t c = 0; c < (size_t)ncoords; c++)
            sum += (a[c * n + i] - b[c * n + i]) *
                   (a[c * n + i] - b[c * n + i]);
        worst = fmax(worst, sum);
    }
    return sqrt(worst);
}

/* t[0]: the fit on [0, 1]^2. */
static ix_status fit_surface(ix_ctx *ctx, const ix_mv *s, const int order[2],
                             const int size[2], double *err, ix_mv *t[2],
                             ix_mv **out)
{
    int count[2] = {SAMPLES_PER_POINT * size[0], SAMPLES_PER_POINT * size[1]};
    size_t n = (size_t)count[0] * (size_t)count[1];
    double *pts, *got, dom[2][2];

    IX_SCRATCH(ctx, pts, (size_t)s->ncoords * n);
    IX_SCRATCH(ctx, got, (size_t)s->ncoords * n);
    IX_TRY(sample(ctx, s, count, pts));
    IX_TRY(ix_srf_fit_grid(ctx, count, s->ncoords, false, pts, order, size,
                           &t[0]));
    IX_TRY(sample(ctx, t[0], count, got));
    *err = largest_distance(n, s->ncoords, pts, got);
    for (int d = 0; d < 2; d++)
        ix_mv_domain(s, d, dom[d]);
    IX_TRY(ix_mv_reparam(ctx, t[0], 0, dom[0][0], dom[0][1], &t[1]));
    return ix_mv_reparam(ctx, t[1], 1, dom[1][0], dom[1][1], out);
}

ix_status ix_srf_fit_surface(ix_ctx *ctx, const ix_mv *srf, const int order[2],
                             const int size[2], double *err, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *t[2] = {NULL};
    ix_status st;
    int n[2];

    *out = NULL;
    if (srf->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG, "%d directions, not a surface",
                       srf->ndirs);
    for (int d = 0; d < 2; d++)
        n[d] = size[d] ? size[d] : srf->dirs[d].length;
    IX_TRY(ix__fit_check(ctx, 2, NULL, order, n));
    st = fit_surface(ctx, srf, order, n, err, t, out);
    ix__mv_unref_all(ctx, t, 2);
    ix__scratch_release(ctx, mk);
    return st;
}
