/* srf_fit.c - surfaces through curves, grids and scattered points, or nearest
 * to them. Grids are fitted one direction after the other: the least squares
 * solution of a tensor product is that of its factors. */
#include "iritx/geom_srf.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/parts.h"

/* --- one direction ----------------------------------------------------- */

/* Rows of data double[outer][n][inner] at parameters tau to control points
 * out[outer][dir->length][inner]. */
typedef struct {
    const ix_dir *dir;
    int n;
    const double *tau;
    size_t outer, inner;
} fit;

static ix_status add_rows(ix_ctx *ctx, const fit *f, const double *data,
                          ix_band *b)
{
    double *w, *rhs;

    IX_SCRATCH(ctx, w, f->dir->order);
    IX_SCRATCH(ctx, rhs, f->outer * f->inner);
    for (int k = 0; k < f->n; k++) {
        int first = ix__basis_first(f->dir, f->tau[k]);

        ix__basis_derive(f->dir, first, f->tau[k], 0, w);
        for (size_t o = 0; o < f->outer; o++)
            memcpy(rhs + o * f->inner,
                   data + (o * (size_t)f->n + (size_t)k) * f->inner,
                   f->inner * sizeof *rhs);
        ix__band_add(b, first % f->dir->length, f->dir->order, w, rhs);
    }
    return IX_OK;
}

static ix_status fit_rows(ix_ctx *ctx, const fit *f, const double *data,
                          double *out)
{
    size_t n = (size_t)f->dir->length, nrhs = f->outer * f->inner;
    ix_band b;
    double *x;

    if (nrhs > INT_MAX)
        return IX_FAIL(ctx, IX_EARG, "%zu numbers in a row are too many", nrhs);
    IX_TRY(ix__band_new(ctx, (int)n, f->dir->order, f->dir->periodic, (int)nrhs,
                        &b));
    IX_TRY(add_rows(ctx, f, data, &b));
    IX_SCRATCH(ctx, x, nrhs * n);
    IX_TRY(ix__band_solve(ctx, &b, x));
    for (size_t o = 0; o < f->outer; o++)
        for (size_t j = 0; j < n; j++)
            for (size_t i = 0; i < f->inner; i++)
                out[(o * n + j) * f->inner + i] = x[(o * f->inner + i) * n + j];
    return IX_OK;
}

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
    fit f;

    memcpy(dirs, m->dirs, (size_t)m->ndirs * sizeof *dirs);
    *last = (ix_dir){.basis = IX_BSPLINE,
                     .order = order,
                     .length = last->length,
                     .periodic = kv == IX_KV_PERIODIC};
    IX_SCRATCH(ctx, tau, last->length);
    IX_TRY(skin_dir(ctx, m, kv, how, last, tau));
    f = (fit){last, last->length, tau, (size_t)m->naxes,
              m->npts / (size_t)last->length};
    IX_SCRATCH(ctx, pts, total);
    IX_TRY(fit_rows(ctx, &f, m->pts, pts));
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

/* --- grids ------------------------------------------------------------- */

static ix_status check_sizes(ix_ctx *ctx, const int count[2],
                             const int order[2], const int size[2])
{
    for (int d = 0; d < 2; d++)
        if (order[d] < 1 || order[d] > IX_MAX_ORDER || size[d] < order[d] ||
            (count && size[d] > count[d]))
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d: order %d <= control points %d <= "
                           "data %d is not so",
                           d + 1, order[d], size[d],
                           count ? count[d] : size[d]);
    return IX_OK;
}

/* Uniform parameters of n data points, and the knots that suit them. */
static ix_status uniform_dir(ix_ctx *ctx, int n, int order, int size,
                             ix_dir *dir, double **tau)
{
    double *knots;

    *dir = (ix_dir){.basis = IX_BSPLINE, .order = order, .length = size};
    IX_SCRATCH(ctx, *tau, n);
    for (int k = 0; k < n; k++)
        (*tau)[k] = n > 1 ? (double)k / (n - 1) : 0;
    IX_SCRATCH(ctx, knots, ix_knots_count(dir));
    dir->knots = knots;
    return ix_params_knots(ctx, order, size, n, *tau, knots);
}

static ix_status fit_grid(ix_ctx *ctx, const int count[2], int ncoords,
                          bool rational, const double *pts, const int order[2],
                          const int size[2], ix_mv **out)
{
    size_t axes = (size_t)ncoords + rational;
    double *tau[2], *half, *full;
    ix_dir dirs[2];
    fit f;

    for (int d = 0; d < 2; d++)
        IX_TRY(
            uniform_dir(ctx, count[d], order[d], size[d], &dirs[d], &tau[d]));
    IX_SCRATCH(ctx, half, axes * (size_t)size[0] * (size_t)count[1]);
    IX_SCRATCH(ctx, full, axes * (size_t)size[0] * (size_t)size[1]);
    f = (fit){&dirs[0], count[0], tau[0], axes * (size_t)count[1], 1};
    IX_TRY(fit_rows(ctx, &f, pts, half));
    f = (fit){&dirs[1], count[1], tau[1], axes, (size_t)size[0]};
    IX_TRY(fit_rows(ctx, &f, half, full));
    return ix_mv_new(ctx, 2, dirs, ncoords, rational, full, out);
}

ix_status ix_srf_fit_grid(ix_ctx *ctx, const int count[2], int ncoords,
                          bool rational, const double *pts, const int order[2],
                          const int size[2], ix_mv **out)
{
    int n[2] = {size[0] ? size[0] : count[0], size[1] ? size[1] : count[1]};
    *out = NULL;
    IX_TRY(check_sizes(ctx, count, order, n));
    IX_RETURN_SCOPED(
        ctx, fit_grid(ctx, count, ncoords, rational, pts, order, n, out));
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
    IX_TRY(fit_grid(ctx, count, s->ncoords, false, pts, order, size, &t[0]));
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
    IX_TRY(check_sizes(ctx, NULL, order, n));
    st = fit_surface(ctx, srf, order, n, err, t, out);
    ix__mv_unref_all(ctx, t, 2);
    ix__scratch_release(ctx, mk);
    return st;
}

/* --- scattered points -------------------------------------------------- */

/* Uniform open directions of the given orders and sizes. */
static ix_status open_dirs(ix_ctx *ctx, const int order[2], const int size[2],
                           ix_dir dirs[2])
{
    for (int d = 0; d < 2; d++) {
        double *knots;

        dirs[d] = (ix_dir){
            .basis = IX_BSPLINE, .order = order[d], .length = size[d]};
        IX_SCRATCH(ctx, knots, ix_knots_count(&dirs[d]));
        IX_TRY(ix_knots_make(ctx, IX_KV_OPEN, order[d], size[d], knots));
        dirs[d].knots = knots;
    }
    return IX_OK;
}

/* The row of one point: products of basis values, zeros between the rows of
 * the mesh. coef has the band's width. */
static void point_row(const ix_dir dirs[2], const double uv[2], double *w[2],
                      int width, double *coef, int *first)
{
    int at[2];

    for (int d = 0; d < 2; d++) {
        at[d] = ix__basis_first(&dirs[d], uv[d]);
        ix__basis_derive(&dirs[d], at[d], uv[d], 0, w[d]);
    }
    memset(coef, 0, (size_t)width * sizeof *coef);
    for (int j = 0; j < dirs[1].order; j++)
        for (int i = 0; i < dirs[0].order; i++)
            coef[j * dirs[0].length + i] = w[0][i] * w[1][j];
    *first = at[1] * dirs[0].length + at[0];
}

static ix_status fit_points(ix_ctx *ctx, int n, const double *uv, int ncoords,
                            const double *values, const ix_dir dirs[2],
                            ix_mv **out)
{
    int width = (dirs[1].order - 1) * dirs[0].length + dirs[0].order, first;
    int unknowns = dirs[0].length * dirs[1].length;
    double *w[2], *coef, *rhs, *pts;
    ix_band b;

    for (int d = 0; d < 2; d++)
        IX_SCRATCH(ctx, w[d], dirs[d].order);
    IX_SCRATCH(ctx, coef, width);
    IX_SCRATCH(ctx, rhs, ncoords);
    IX_TRY(ix__band_new(ctx, unknowns, width, false, ncoords, &b));
    for (int i = 0; i < n; i++) {
        IX_TRY(ix__poll(ctx));
        point_row(dirs, (const double[2]){uv[i], uv[n + i]}, w, width, coef,
                  &first);
        for (int c = 0; c < ncoords; c++)
            rhs[c] = values[(size_t)c * (size_t)n + (size_t)i];
        ix__band_add(&b, first, width, coef, rhs);
    }
    IX_SCRATCH(ctx, pts, (size_t)ncoords * (size_t)unknowns);
    IX_TRY(ix__band_solve(ctx, &b, pts));
    return ix_mv_new(ctx, 2, dirs, ncoords, false, pts, out);
}

ix_status ix_srf_fit_points(ix_ctx *ctx, int n, const double *uv, int ncoords,
                            const double *values, const int order[2],
                            const int size[2], ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_dir dirs[2];
    ix_status st;

    *out = NULL;
    IX_TRY(check_sizes(ctx, NULL, order, size));
    if (size[0] > 10000 / size[1])
        return IX_FAIL(ctx, IX_EARG,
                       "%d by %d control points are more than "
                       "10000",
                       size[0], size[1]);
    for (int i = 0; i < 2 * n; i++)
        if (!(uv[i] >= 0 && uv[i] <= 1))
            return IX_FAIL(ctx, IX_EARG,
                           "parameter %c of point %d is %g, outside [0, 1]",
                           i < n ? 'u' : 'v', i % n + 1, uv[i]);
    st = open_dirs(ctx, order, size, dirs);
    if (st == IX_OK)
        st = fit_points(ctx, n, uv, ncoords, values, dirs, out);
    ix__scratch_release(ctx, mk);
    return st;
}
