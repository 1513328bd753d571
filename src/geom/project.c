/* project.c - least squares with one row per quadrature node: the rows'
 * normal equations are the Gram matrix, but are never formed. */
#include "geom/project.h"

#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/gauss.h"

typedef struct {
    const ix_path *p;
    const ix_dir *dir;
    ix_project_opts o;
    int nrhs;
    ix_band band;
    double *w;                       /* [order] basis values */
    double first[IX_MAX_COORDS + 1]; /* the ends, if kept */
    double last[IX_MAX_COORDS + 1];
} projection;

static void value(const projection *pr, int span, double t, double *out)
{
    if (pr->o.homogeneous)
        ix__path_axes(pr->p, span, t, 0, out);
    else
        ix__path_derivs(pr->p, span, t, 0, out);
}

/* The row of one node; the columns of kept ends go to the right side. */
static void add_node(projection *pr, int span, double t, double weight)
{
    double rhs[IX_MAX_COORDS + 1], f = sqrt(weight), *w = pr->w;
    int k = pr->dir->order, n = pr->dir->length;
    int first = ix__basis_first(pr->dir, t), skip = 0;

    ix__basis_derive(pr->dir, first, t, 0, w);
    value(pr, span, t, rhs);
    for (int c = 0; c < pr->nrhs; c++)
        rhs[c] *= f;
    for (int i = 0; i < k; i++)
        w[i] *= f;
    if (pr->o.keep_ends) {
        for (int c = 0; c < pr->nrhs; c++) {
            rhs[c] -= first == 0 ? w[0] * pr->first[c] : 0;
            rhs[c] -= first + k == n ? w[k - 1] * pr->last[c] : 0;
        }
        skip = first == 0;
        k -= skip + (first + k == n);
        first += skip - 1;
    }
    ix__band_add(&pr->band, first % pr->band.n, k, w + skip, rhs);
}

static ix_status add_rows(ix_ctx *ctx, projection *pr)
{
    ix_spans sp, own = {.degree = pr->p->degree,
                        .nspans = pr->p->nspans,
                        .breaks = pr->p->breaks,
                        .cont = pr->p->cont};
    ix_spans all;
    int k = pr->dir->order, d = pr->p->degree + 1, m = (k + d) / 2 + 1;
    double *x, *w;

    m = m > k ? m : k;
    m += pr->p->rational && !pr->o.homogeneous ? 8 : 0;
    IX_SCRATCH(ctx, x, m);
    IX_SCRATCH(ctx, w, m);
    ix__gauss(m, x, w);
    IX_TRY(ix__spans_of(ctx, pr->dir, &sp));
    IX_TRY(ix__spans_union(ctx, &own, &sp, 0, &all));
    for (int s = 0; s < all.nspans; s++) {
        double a = all.breaks[s], h = all.breaks[s + 1] - a;
        int span = ix__path_span(pr->p, a + h / 2);

        for (int g = 0; g < m; g++)
            add_node(pr, span, a + h * x[g], h * w[g]);
    }
    return IX_OK;
}

ix_status ix__project(ix_ctx *ctx, const ix_path *p, const ix_dir *dir,
                      ix_project_opts o, double *coef)
{
    projection pr = {.p = p, .dir = dir, .o = o};
    int n = dir->length, k = dir->order, m;
    double *x;

    pr.o.keep_ends = o.keep_ends && !dir->periodic && k > 1;
    pr.nrhs = o.homogeneous ? p->naxes : p->ncoords;
    m = pr.o.keep_ends ? n - 2 : n;
    IX_SCRATCH(ctx, pr.w, k);
    IX_SCRATCH(ctx, x, (size_t)n * (size_t)pr.nrhs);
    if (pr.o.keep_ends) {
        value(&pr, 0, p->breaks[0], pr.first);
        value(&pr, p->nspans - 1, p->breaks[p->nspans], pr.last);
    }
    if (m > 0) {
        IX_TRY(ix__band_new(ctx, m, k, dir->periodic, pr.nrhs, &pr.band));
        IX_TRY(add_rows(ctx, &pr));
        IX_TRY(ix__band_solve(ctx, &pr.band, x));
    }
    for (int c = 0; c < pr.nrhs; c++) {
        double *row = coef + (size_t)c * (size_t)n;

        if (m > 0)
            memcpy(row + (n - m) / 2, x + (size_t)c * (size_t)m,
                   (size_t)m * sizeof *row);
        if (pr.o.keep_ends) {
            row[0] = pr.first[c];
            row[n - 1] = pr.last[c];
        }
    }
    return IX_OK;
}

ix_status ix__path_distance(ix_ctx *ctx, const ix_path *p, const ix_path *q,
                            double *dist)
{
    ix_spans a = {.nspans = p->nspans, .breaks = p->breaks, .cont = p->cont};
    ix_spans b = {.nspans = q->nspans, .breaks = q->breaks, .cont = q->cont};
    ix_spans all;
    double x[IX_MAX_COORDS], y[IX_MAX_COORDS];

    *dist = 0;
    IX_TRY(ix__spans_union(ctx, &a, &b, 0, &all));
    for (int s = 0; s < all.nspans; s++) {
        double t0 = all.breaks[s], h = all.breaks[s + 1] - t0;
        int sp = ix__path_span(p, t0 + h / 2),
            sq = ix__path_span(q, t0 + h / 2);

        for (int i = 0; i <= 16; i++) {
            double sum = 0;

            ix__path_derivs(p, sp, t0 + h * i / 16, 0, x);
            ix__path_derivs(q, sq, t0 + h * i / 16, 0, y);
            for (int c = 0; c < p->ncoords; c++)
                sum = hypot(sum, x[c] - y[c]);
            *dist = fmax(*dist, sum);
        }
    }
    return IX_OK;
}
