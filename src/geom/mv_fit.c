/* mv_fit.c - freeforms of any number of directions through grids and scattered
 * points, or nearest to them. Grids are fitted one direction after the other:
 * the least squares solution of a tensor product is that of its factors. */
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/fit_rows.h"
#include "geom/parts.h"
#include "iritx/geom_srf.h"

/* --- grids ------------------------------------------------------------- */

/* Data at parameters in each direction. */
typedef struct {
    int ndirs, count[IX_MAX_DIRS];
    double *tau[IX_MAX_DIRS];
    int ncoords;
    bool rational;
    const double *pts; /* double[axes][product of counts] */
} grid;

/* Direction after direction; the numbers alternate between two arrays. */
static ix_status fit_dirs(ix_ctx *ctx, const grid *g, const ix_dir *dirs,
                          ix_mv **out)
{
    size_t outer = (size_t)g->ncoords + g->rational, inner = 1, most;
    const double *from = g->pts;
    double *to[2];

    for (int d = 0; d < g->ndirs; d++)
        outer *= (size_t)g->count[d];
    most = outer; /* sizes are at most counts */
    for (int k = 0; k < 2; k++)
        IX_SCRATCH(ctx, to[k], most);
    for (int d = 0; d < g->ndirs; d++) {
        ix__fit f = {&dirs[d], g->count[d], g->tau[d], 0, inner};

        outer /= (size_t)g->count[d];
        f.outer = outer;
        IX_TRY(ix__fit_rows(ctx, &f, from, to[d % 2]));
        from = to[d % 2];
        inner *= (size_t)dirs[d].length;
    }
    return ix_mv_new(ctx, g->ndirs, dirs, g->ncoords, g->rational, from, out);
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

static ix_status fit_grid(ix_ctx *ctx, grid *g, const int *order,
                          const int *size, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];

    for (int d = 0; d < g->ndirs; d++)
        IX_TRY(uniform_dir(ctx, g->count[d], order[d], size[d], &dirs[d],
                           &g->tau[d]));
    return fit_dirs(ctx, g, dirs, out);
}

static ix_status check_ndirs(ix_ctx *ctx, int ndirs)
{
    if (ndirs < 1 || ndirs > IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG, "%d directions; 1 .. %d are possible",
                       ndirs, IX_MAX_DIRS);
    return IX_OK;
}

ix_status ix_mv_fit_grid(ix_ctx *ctx, int ndirs, const int *count, int ncoords,
                         bool rational, const double *pts, const int *order,
                         const int *size, ix_mv **out)
{
    grid g = {
        .ndirs = ndirs, .ncoords = ncoords, .rational = rational, .pts = pts};
    int n[IX_MAX_DIRS];

    *out = NULL;
    IX_TRY(check_ndirs(ctx, ndirs));
    memcpy(g.count, count, (size_t)ndirs * sizeof *count);
    for (int d = 0; d < ndirs; d++)
        n[d] = size[d] ? size[d] : count[d];
    IX_TRY(ix__fit_check(ctx, ndirs, count, order, n));
    IX_RETURN_SCOPED(ctx, fit_grid(ctx, &g, order, n, out));
}

ix_status ix_srf_fit_grid(ix_ctx *ctx, const int count[2], int ncoords,
                          bool rational, const double *pts, const int order[2],
                          const int size[2], ix_mv **out)
{
    return ix_mv_fit_grid(ctx, 2, count, ncoords, rational, pts, order, size,
                          out);
}

/* --- control points as data -------------------------------------------- */

/* A new open direction of the given order and size for data at the nodes tau,
 * over the domain of old. */
static ix_status node_dir(ix_ctx *ctx, const ix_dir *old, int order, int size,
                          const double *tau, ix_dir *out)
{
    int n = old->length;
    double dom[2], *unit, *knots;

    if (old->basis == IX_BSPLINE && !ix__dir_is_open(old))
        return IX_FAIL(ctx, IX_EARG,
                       "order and length can change in open directions only");
    ix__dir_domain(old, dom);
    IX_SCRATCH(ctx, unit, n);
    IX_SCRATCH(ctx, knots, order + size);
    for (int k = 0; k < n; k++)
        unit[k] = (tau[k] - dom[0]) / (dom[1] - dom[0]);
    IX_TRY(ix_params_knots(ctx, order, size, n, unit, knots));
    for (int k = 0; k < order + size; k++)
        knots[k] = k < size ? dom[0] + knots[k] * (dom[1] - dom[0]) : dom[1];
    *out = (ix_dir){IX_BSPLINE, order, size, false, knots};
    return IX_OK;
}

static ix_status fit_nodes(ix_ctx *ctx, const ix_mv *m, const int *order,
                           const int *size, ix_mv **out)
{
    grid g = {.ndirs = m->ndirs,
              .ncoords = m->ncoords,
              .rational = m->rational,
              .pts = m->pts};
    ix_dir dirs[IX_MAX_DIRS];

    for (int d = 0; d < m->ndirs; d++) {
        g.count[d] = m->dirs[d].length;
        IX_SCRATCH(ctx, g.tau[d], g.count[d]);
        ix_knots_nodes(&m->dirs[d], g.tau[d]);
        dirs[d] = m->dirs[d];
        if (order[d] != dirs[d].order || size[d] != dirs[d].length)
            IX_TRY(node_dir(ctx, &m->dirs[d], order[d], size[d], g.tau[d],
                            &dirs[d]));
    }
    return fit_dirs(ctx, &g, dirs, out);
}

ix_status ix_mv_fit_nodes(ix_ctx *ctx, const ix_mv *m, const int *order,
                          const int *size, ix_mv **out)
{
    int n[IX_MAX_DIRS] = {0}, o[IX_MAX_DIRS] = {0}, count[IX_MAX_DIRS] = {0};
    bool same = true;
    ix_mark mk;
    ix_status st;
    ix_mv *in[2] = {NULL};

    *out = NULL;
    for (int d = 0; d < m->ndirs; d++) {
        count[d] = m->dirs[d].length;
        n[d] = size[d] ? size[d] : count[d];
        o[d] = order[d] ? order[d] : m->dirs[d].order;
        same = same && n[d] == count[d] && o[d] == m->dirs[d].order;
    }
    IX_TRY(ix__fit_check(ctx, m->ndirs, count, o, n));
    mk = ix__scratch_mark(ctx);
    st = ix__mv_plain(ctx, m, &in[0]);
    if (st == IX_OK && !same)
        st = ix_mv_to_bspline(ctx, in[0], &in[1]);
    if (st == IX_OK)
        st = fit_nodes(ctx, same ? in[0] : in[1], o, n, out);
    ix__mv_unref_all(ctx, in, 2);
    ix__scratch_release(ctx, mk);
    return st;
}

/* --- scattered points -------------------------------------------------- */

/* Uniform open directions of the given orders and sizes. */
static ix_status open_dirs(ix_ctx *ctx, int ndirs, const int *order,
                           const int *size, ix_dir *dirs)
{
    for (int d = 0; d < ndirs; d++) {
        double *knots;

        dirs[d] = (ix_dir){
            .basis = IX_BSPLINE, .order = order[d], .length = size[d]};
        IX_SCRATCH(ctx, knots, ix_knots_count(&dirs[d]));
        IX_TRY(ix_knots_make(ctx, IX_KV_OPEN, order[d], size[d], knots));
        dirs[d].knots = knots;
    }
    return IX_OK;
}

/* The system of all points: products of basis values, zeros between the rows
 * of the mesh. */
typedef struct {
    int ndirs, width;
    const ix_dir *dirs;
    double *w[IX_MAX_DIRS], *coef, *rhs;
    ix_band b;
} system;

static ix_status system_new(ix_ctx *ctx, int ndirs, const ix_dir *dirs,
                            int ncoords, system *out)
{
    int unknowns = 1;

    *out = (system){.ndirs = ndirs, .width = 1, .dirs = dirs};
    for (int d = 0; d < ndirs; d++) {
        IX_SCRATCH(ctx, out->w[d], dirs[d].order);
        out->width += (dirs[d].order - 1) * unknowns;
        unknowns *= dirs[d].length;
    }
    IX_SCRATCH(ctx, out->coef, out->width);
    IX_SCRATCH(ctx, out->rhs, ncoords);
    return ix__band_new(ctx, unknowns, out->width, false, ncoords, &out->b);
}

/* The row of the point at t[d * n]; its first unknown. */
static int point_row(const system *s, const double *t, size_t n)
{
    size_t total = 1;
    int first = 0, stride = 1;

    for (int d = 0; d < s->ndirs; d++) {
        double x = t[(size_t)d * n];
        int at = ix__basis_first(&s->dirs[d], x);

        ix__basis_derive(&s->dirs[d], at, x, 0, s->w[d]);
        first += at * stride;
        stride *= s->dirs[d].length;
        total *= (size_t)s->dirs[d].order;
    }
    memset(s->coef, 0, (size_t)s->width * sizeof *s->coef);
    for (size_t k = 0; k < total; k++) {
        size_t left = k, place = 0, step = 1;
        double v = 1;

        for (int d = 0; d < s->ndirs; d++) {
            size_t o = (size_t)s->dirs[d].order;

            v *= s->w[d][left % o];
            place += left % o * step;
            left /= o;
            step *= (size_t)s->dirs[d].length;
        }
        s->coef[place] = v;
    }
    return first;
}

static ix_status fit_points(ix_ctx *ctx, const ix_cloud *c, const int *order,
                            const int *size, ix_mv **out)
{
    size_t n = (size_t)c->n;
    ix_dir dirs[IX_MAX_DIRS];
    double *pts;
    system s;

    IX_TRY(open_dirs(ctx, c->ndirs, order, size, dirs));
    IX_TRY(system_new(ctx, c->ndirs, dirs, c->ncoords, &s));
    for (size_t i = 0; i < n; i++) {
        int first = point_row(&s, c->params + i, n);

        IX_TRY(ix__poll(ctx));
        for (size_t k = 0; k < (size_t)c->ncoords; k++)
            s.rhs[k] = c->values[k * n + i];
        ix__band_add(&s.b, first, s.width, s.coef, s.rhs);
    }
    IX_SCRATCH(ctx, pts, (size_t)c->ncoords * (size_t)s.b.n);
    IX_TRY(ix__band_solve(ctx, &s.b, pts));
    return ix_mv_new(ctx, c->ndirs, dirs, c->ncoords, false, pts, out);
}

static ix_status check_cloud(ix_ctx *ctx, const ix_cloud *c, const int *size)
{
    const int most = 10000;
    double unknowns = 1;

    for (int d = 0; d < c->ndirs; d++)
        unknowns *= size[d];
    if (unknowns > most)
        return IX_FAIL(ctx, IX_EARG, "%.0f control points are more than %d",
                       unknowns, most);
    for (int d = 0; d < c->ndirs; d++)
        for (int i = 0; i < c->n; i++) {
            double t = c->params[(size_t)d * (size_t)c->n + (size_t)i];

            if (!(t >= 0 && t <= 1))
                return IX_FAIL(ctx, IX_EARG,
                               "parameter %d of point %d is %g, outside "
                               "[0, 1]",
                               d + 1, i + 1, t);
        }
    return IX_OK;
}

ix_status ix_mv_fit_points(ix_ctx *ctx, const ix_cloud *c, const int *order,
                           const int *size, ix_mv **out)
{
    *out = NULL;
    IX_TRY(check_ndirs(ctx, c->ndirs));
    IX_TRY(ix__fit_check(ctx, c->ndirs, NULL, order, size));
    IX_TRY(check_cloud(ctx, c, size));
    IX_RETURN_SCOPED(ctx, fit_points(ctx, c, order, size, out));
}

ix_status ix_srf_fit_points(ix_ctx *ctx, int n, const double *uv, int ncoords,
                            const double *values, const int order[2],
                            const int size[2], ix_mv **out)
{
    const ix_cloud c = {2, n, uv, ncoords, values};

    return ix_mv_fit_points(ctx, &c, order, size, out);
}
