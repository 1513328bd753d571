/* window.c - weighted sums over the points that count at one parameter. */
#include "mv/window.h"

#include <math.h>

ix_status ix__window_init(ix_ctx *ctx, const ix_mv *m, ix__window *win)
{
    size_t stride = 1;

    win->m = m;
    win->total = 1;
    for (int d = 0; d < m->ndirs; d++) {
        win->stride[d] = stride;
        stride *= (size_t)m->dirs[d].length;
        IX_SCRATCH(ctx, win->w[d], m->dirs[d].order);
    }
    return IX_OK;
}

/* Offset of the window's point q in direction d. */
static size_t offset(const ix__window *win, int d, int q)
{
    int n = win->m->dirs[d].length, i = win->first[d] + q;

    return (size_t)(i < n ? i : i % n) * win->stride[d];
}

/* The point with the largest weight. */
static size_t heaviest(const ix__window *win)
{
    size_t at = 0;

    for (int d = 0; d < win->m->ndirs; d++) {
        const double *w = win->w[d];
        int best = 0;

        for (int q = 1; q < win->m->dirs[d].order; q++)
            if (fabs(w[q]) > fabs(w[best]))
                best = q;
        at += offset(win, d, best);
    }
    return at;
}

/* Sum of w[q] (p[q] - ref) along direction 0, points starting at p. */
static double sum_row(const ix__window *win, const double *p, double ref)
{
    const ix_dir *dir = win->m->dirs;
    const double *w = win->w[0];
    int first = win->first[0], o = dir->order, n = dir->length;
    double sum = 0;

    if (first + o <= n) {
        p += first;
        for (int q = 0; q < o; q++)
            sum += w[q] * (p[q] - ref);
        return sum;
    }
    for (int q = 0; q < o; q++)
        sum += w[q] * (p[(first + q) % n] - ref);
    return sum;
}

/* A curve whose window does not wrap: out[axes] in one go. */
static void sum_curve(const ix__window *win, double *out)
{
    const ix_mv *m = win->m;
    const double *w = win->w[0], *p = m->pts + win->first[0];
    size_t heavy = heaviest(win) - (size_t)win->first[0];
    int o = m->dirs[0].order;

    for (int a = 0; a < m->naxes; a++, p += m->npts) {
        double ref = p[heavy], sum = 0;

        for (int q = 0; q < o; q++)
            sum += w[q] * (p[q] - ref);
        out[a] = win->total * ref + sum;
    }
}

/* sum[axes] += the rows of the window, all directions but 0 counted in q. */
static void sum_rows(const ix__window *win, const double *ref, double *sum)
{
    const ix_mv *m = win->m;
    int q[IX_MAX_DIRS] = {0}, d;

    do {
        const double *row = m->pts;
        double w = 1;

        for (d = 1; d < m->ndirs; d++) {
            row += offset(win, d, q[d]);
            w *= win->w[d][q[d]];
        }
        for (int a = 0; a < m->naxes; a++, row += m->npts)
            sum[a] += w * sum_row(win, row, ref[a]);
        for (d = 1; d < m->ndirs && ++q[d] == m->dirs[d].order; d++)
            q[d] = 0;
    } while (d < m->ndirs);
}

/* The sum over any window; differences from one point unless the total of the
 * weights is not known. */
static void sum_window(const ix__window *win, double *out)
{
    const ix_mv *m = win->m;
    double ref[IX_MAX_COORDS + 1] = {0}, sum[IX_MAX_COORDS + 1] = {0};

    if (!isnan(win->total)) {
        const double *p = m->pts + heaviest(win);

        for (int a = 0; a < m->naxes; a++, p += m->npts)
            ref[a] = *p;
    }
    sum_rows(win, ref, sum);
    for (int a = 0; a < m->naxes; a++)
        out[a] = isnan(win->total) ? sum[a] : win->total * ref[a] + sum[a];
}

void ix__window_sum(const ix__window *win, double *out)
{
    const ix_dir *dir = win->m->dirs;

    if (win->m->ndirs == 1 && !isnan(win->total) &&
        win->first[0] + dir->order <= dir->length)
        sum_curve(win, out);
    else
        sum_window(win, out);
}
