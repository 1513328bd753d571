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
    return (size_t)((win->first[d] + q) % win->m->dirs[d].length) *
           win->stride[d];
}

/* The point with the largest weight. */
static size_t heaviest(const ix__window *win)
{
    size_t at = 0;

    for (int d = 0; d < win->m->ndirs; d++) {
        int best = 0;

        for (int q = 1; q < win->m->dirs[d].order; q++)
            if (fabs(win->w[d][q]) > fabs(win->w[d][best]))
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
        for (int q = 0; q < o; q++)
            sum += w[q] * (p[first + q] - ref);
        return sum;
    }
    for (int q = 0; q < o; q++)
        sum += w[q] * (p[(first + q) % n] - ref);
    return sum;
}

/* The same of the whole window: rows of direction 0, the others counted. */
static double sum_all(const ix__window *win, const double *p, double ref)
{
    const ix_mv *m = win->m;
    int q[IX_MAX_DIRS] = {0}, d;
    double sum = 0;

    if (m->ndirs == 1)
        return sum_row(win, p, ref);
    do {
        const double *row = p;
        double w = 1;

        for (d = 1; d < m->ndirs; d++) {
            row += offset(win, d, q[d]);
            w *= win->w[d][q[d]];
        }
        sum += w * sum_row(win, row, ref);
        for (d = 1; d < m->ndirs && ++q[d] == m->dirs[d].order; d++)
            q[d] = 0;
    } while (d < m->ndirs);
    return sum;
}

void ix__window_sum(const ix__window *win, double *out)
{
    bool known = !isnan(win->total);
    size_t at = known ? heaviest(win) : 0;

    for (int a = 0; a < win->m->naxes; a++) {
        const double *p = ix_mv_axis(win->m, a);

        if (known)
            out[a] = win->total * p[at] + sum_all(win, p, p[at]);
        else
            out[a] = sum_all(win, p, 0);
    }
}
