/* eval.c - values and partial derivatives at one parameter: basis weights of
 * each direction, then the sum over the window of points that count. */
#include <math.h>

#include "bsp/basis.h"
#include "mv/mv.h"

typedef struct {
    const ix_mv *m;
    size_t stride[IX_MAX_DIRS];
    int first[IX_MAX_DIRS]; /* first point of the window, before wrapping */
    double *w[IX_MAX_DIRS]; /* weights of the window, [order] */
} window;

/* Bezier curves and surfaces (also as B-splines of one span) extrapolate. */
static bool extrapolates(const ix_mv *m, const ix_dir *dir)
{
    if (m->ndirs > 2)
        return false;
    return dir->basis != IX_BSPLINE ||
           (dir->length == dir->order && ix__dir_is_open(dir));
}

ix_status ix__mv_param(ix_ctx *ctx, const ix_mv *m, int d, double *t)
{
    double dom[2], slack;

    if (isfinite(*t) && extrapolates(m, m->dirs + d))
        return IX_OK;
    ix__dir_domain(m->dirs + d, dom);
    slack = 1e-5 * (dom[1] - dom[0]); /* spec/model 6 */
    if (!(*t >= dom[0] - slack && *t <= dom[1] + slack))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "parameter %.17g of direction %d is outside the domain "
                       "[%.17g, %.17g]",
                       *t, d, dom[0], dom[1]);
    *t = fmin(fmax(*t, dom[0]), dom[1]);
    return IX_OK;
}

static ix_status window_init(ix_ctx *ctx, const ix_mv *m, window *win)
{
    size_t stride = 1;

    win->m = m;
    for (int d = 0; d < m->ndirs; d++) {
        win->stride[d] = stride;
        stride *= (size_t)m->dirs[d].length;
        IX_SCRATCH(ctx, win->w[d], m->dirs[d].order);
    }
    return IX_OK;
}

/* Sum along direction 0, points starting at p. */
static double sum_row(const window *win, const double *p)
{
    const ix_dir *dir = win->m->dirs;
    const double *w = win->w[0];
    int first = win->first[0], o = dir->order, n = dir->length;
    double sum = 0;

    if (first + o <= n) {
        for (int q = 0; q < o; q++)
            sum += w[q] * p[first + q];
        return sum;
    }
    for (int q = 0; q < o; q++)
        sum += w[q] * p[(first + q) % n];
    return sum;
}

/* Sum of one axis over the window: rows of direction 0, the others counted. */
static double sum_window(const window *win, const double *p)
{
    const ix_mv *m = win->m;
    int q[IX_MAX_DIRS] = {0}, d;
    double sum = 0;

    if (m->ndirs == 1)
        return sum_row(win, p);
    do {
        const double *row = p;
        double w = 1;

        for (d = 1; d < m->ndirs; d++) {
            int i = (win->first[d] + q[d]) % m->dirs[d].length;

            row += (size_t)i * win->stride[d];
            w *= win->w[d][q[d]];
        }
        sum += w * sum_row(win, row);
        for (d = 1; d < m->ndirs && ++q[d] == m->dirs[d].order; d++)
            q[d] = 0;
    } while (d < m->ndirs);
    return sum;
}

static void sum_axes(const window *win, double *out)
{
    for (int a = 0; a < win->m->naxes; a++)
        out[a] = sum_window(win, ix_mv_axis(win->m, a));
}

static ix_status partial(ix_ctx *ctx, const ix_mv *m, const double *t,
                         const int *k, double *out)
{
    window win;

    IX_TRY(window_init(ctx, m, &win));
    for (int d = 0; d < m->ndirs; d++) {
        double x = t[d];

        IX_TRY(ix__mv_param(ctx, m, d, &x));
        win.first[d] = ix__basis_first(m->dirs + d, x);
        ix__basis_derive(m->dirs + d, win.first[d], x, k[d], win.w[d]);
    }
    sum_axes(&win, out);
    return IX_OK;
}

ix_status ix_mv_partial(ix_ctx *ctx, const ix_mv *m, const double *t,
                        const int *k, double *out)
{
    ix_mark mk;
    ix_status st;

    for (int d = 0; d < m->ndirs; d++)
        if (k[d] < 0)
            return IX_FAIL(ctx, IX_EARG, "derivative %d in direction %d", k[d],
                           d);
    mk = ix__scratch_mark(ctx);
    st = partial(ctx, m, t, k, out);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_mv_eval(ix_ctx *ctx, const ix_mv *m, const double *t, double *out)
{
    static const int value[IX_MAX_DIRS];

    return ix_mv_partial(ctx, m, t, value, out);
}

/* Divides the coordinates by the weight: h[axes] to out[ncoords]. */
static ix_status project(ix_ctx *ctx, const ix_mv *m, const double *h,
                         double *out)
{
    for (int c = 0; c < m->ncoords; c++) {
        out[c] = m->rational ? h[c + 1] / h[0] : h[c];
        if (!isfinite(out[c]))
            return IX_FAIL(ctx, IX_EDOMAIN, "pole: weight %g, coordinate %d %g",
                           m->rational ? h[0] : 1.0, c, h[c + m->rational]);
    }
    return IX_OK;
}

ix_status ix_mv_point(ix_ctx *ctx, const ix_mv *m, const double *t, double *out)
{
    double h[IX_MAX_COORDS + 1];

    IX_TRY(ix_mv_eval(ctx, m, t, h));
    return project(ctx, m, h, out);
}
