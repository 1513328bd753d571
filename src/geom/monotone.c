/* monotone.c - see the header. A row of the table at a time; only the steps are
 * kept. */
#include "geom/monotone.h"

#include <math.h>
#include <string.h>

/* Sums and values of the present row and of the one before. */
typedef struct {
    double *row, *val, *last, *lastval;
} rows;

/* The best way to (i, j), whose value is v. */
static char best_step(const ix__monotone *m, const rows *r, int i, int j,
                      double v, double *top)
{
    bool start = i <= m->slack && j <= m->slack;
    char step = 0;

    *top = start && v > -HUGE_VAL ? 0 : -HUGE_VAL;
    if (i && j && r->last[j - 1] + (r->lastval[j - 1] + v) / 2 > *top) {
        *top = r->last[j - 1] + (r->lastval[j - 1] + v) / 2;
        step = 3;
    }
    if (i && r->last[j] + (r->lastval[j] + v) / 4 > *top) {
        *top = r->last[j] + (r->lastval[j] + v) / 4;
        step = 1;
    }
    if (j && r->row[j - 1] + (r->val[j - 1] + v) / 4 > *top) {
        *top = r->row[j - 1] + (r->val[j - 1] + v) / 4;
        step = 2;
    }
    return step;
}

double ix__monotone_best(const ix__monotone *m, double *work, char *from,
                         int end[2])
{
    int n = m->n;
    rows r = {work, work + n, work + 2 * n, work + 3 * n};
    double best = -HUGE_VAL;

    end[0] = end[1] = n - 1;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            double v = m->value(m->arg, i, j);
            char step = best_step(m, &r, i, j, v, &r.row[j]);

            r.val[j] = v;
            if (from)
                from[(size_t)i * (size_t)n + (size_t)j] = step;
            if (i >= n - 1 - m->slack && j >= n - 1 - m->slack &&
                r.row[j] >= best) {
                best = r.row[j];
                end[0] = i;
                end[1] = j;
            }
        }
        memcpy(r.last, r.row, (size_t)n * sizeof *r.last);
        memcpy(r.lastval, r.val, (size_t)n * sizeof *r.lastval);
    }
    return best;
}

int ix__monotone_trace(int n, const char *from, const int end[2], int *i,
                       int *j)
{
    int a = end[0], b = end[1], total = 1;

    for (;; total++) {
        char step = from[(size_t)a * (size_t)n + (size_t)b];

        if (step == 0)
            break;
        a -= step & 1;
        b -= step >> 1;
    }
    a = end[0];
    b = end[1];
    for (int m = total - 1; m >= 0; m--) {
        char step = from[(size_t)a * (size_t)n + (size_t)b];

        i[m] = a;
        j[m] = b;
        a -= step & 1;
        b -= step >> 1;
    }
    return total;
}
