/* outer.c - sums of products of functions of different variables: each factor
 * is composed once, the grid is written once. */
#include "sym/outer.h"

#include <math.h>
#include <string.h>

#include "base/threads.h"
#include "bern/bern.h"

typedef struct {
    const ix_outer *f;
    const double *u, *v; /* control points of the factors, row by row */
    size_t nu, nv;       /* points of a row */
    const int *first;    /* [nrows + 1]: terms of each row */
    const double **urow; /* [nterms]: row of u */
    const double **vrow; /* [nterms]: row of v */
    double *out;
} grid;

enum { MAX_TERMS = 64 }; /* combined at a time */

/* Line i % nv of row i / nv. */
static void write_line(const grid *g, size_t i)
{
    size_t row = i / g->nv, j = i % g->nv;
    int k = g->first[row], end = g->first[row + 1], n = 0;
    double f[MAX_TERMS + 1], *line = g->out + i * g->nu;
    const double *x[MAX_TERMS + 1];

    if (k == end)
        memset(line, 0, g->nu * sizeof *line);
    while (k < end) {
        for (; k < end && n < MAX_TERMS; k++, n++) {
            f[n] = g->f->terms[k].coef * g->vrow[k][j];
            x[n] = g->urow[k];
        }
        ix__bern_combine(g->nu, n, f, x, line);
        f[0] = 1.0; /* what is there goes on as the first term */
        x[0] = line;
        n = 1;
    }
}

static void write_lines(void *arg, size_t begin, size_t end)
{
    for (size_t i = begin; i < end; i++)
        write_line(arg, i);
}

/* Largest of each row of a factor, then of the products. */
static ix_status term_sizes(ix_ctx *ctx, const grid *g, double *size)
{
    double *u, *v;

    IX_SCRATCH(ctx, u, g->f->u->nrows);
    IX_SCRATCH(ctx, v, g->f->v->nrows);
    for (int i = 0; i < g->f->u->nrows; i++)
        u[i] = ix__bern_largest(g->nu, g->u + (size_t)i * g->nu);
    for (int i = 0; i < g->f->v->nrows; i++)
        v[i] = ix__bern_largest(g->nv, g->v + (size_t)i * g->nv);
    memset(size, 0, (size_t)g->f->nrows * sizeof *size);
    for (int k = 0; k < g->f->nterms; k++) {
        const ix_outer_term *t = &g->f->terms[k];

        size[t->row] += fabs(t->coef) * u[t->u] * v[t->v];
    }
    return IX_OK;
}

static ix_status index_terms(ix_ctx *ctx, grid *g)
{
    const ix_outer *f = g->f;
    int *first, k = 0;

    IX_SCRATCH(ctx, first, f->nrows + 1);
    IX_SCRATCH(ctx, g->urow, f->nterms);
    IX_SCRATCH(ctx, g->vrow, f->nterms);
    for (int r = 0; r <= f->nrows; r++) {
        first[r] = k;
        for (; k < f->nterms && f->terms[k].row == r; k++) {
            g->urow[k] = g->u + (size_t)f->terms[k].u * g->nu;
            g->vrow[k] = g->v + (size_t)f->terms[k].v * g->nv;
        }
    }
    g->first = first;
    return IX_OK;
}

static size_t points_of(int n, const ix_dir *dirs)
{
    size_t p = 1;

    for (int i = 0; i < n; i++)
        p *= (size_t)dirs[i].length;
    return p;
}

ix_status ix__outer_dirs(ix_ctx *ctx, const ix_outer *f, const ix_sym_opts *o,
                         ix_dir *dirs)
{
    IX_TRY(ix__form_dirs(ctx, f->u, o, dirs));
    return ix__form_dirs(ctx, f->v, o, dirs + f->u->ndirs);
}

ix_status ix__outer_points(ix_ctx *ctx, const ix_outer *f, const ix_dir *dirs,
                           double *pts, double *size)
{
    grid g = {.f = f, .out = pts};
    int nu = f->u->ndirs;

    IX_TRY(ix__form_points(ctx, f->u, dirs, &g.u));
    IX_TRY(ix__form_points(ctx, f->v, dirs + nu, &g.v));
    g.nu = points_of(nu, dirs);
    g.nv = points_of(f->v->ndirs, dirs + nu);
    IX_TRY(index_terms(ctx, &g));
    ix__parallel(ctx, (size_t)f->nrows * g.nv,
                 10.0 + 0.2 * (double)g.nu * f->nterms / f->nrows, write_lines,
                 &g);
    if (size)
        IX_TRY(term_sizes(ctx, &g, size));
    return ix__poll(ctx);
}

ix_status ix__outer_eval(ix_ctx *ctx, const ix_outer *f, const double *s,
                         const double *t, double *out)
{
    double *u, *v;

    IX_SCRATCH(ctx, u, f->u->nrows);
    IX_SCRATCH(ctx, v, f->v->nrows);
    ix__form_eval(f->u, s, u);
    ix__form_eval(f->v, t, v);
    memset(out, 0, (size_t)f->nrows * sizeof *out);
    for (int k = 0; k < f->nterms; k++) {
        const ix_outer_term *e = &f->terms[k];

        out[e->row] += e->coef * u[e->u] * v[e->v];
    }
    return IX_OK;
}
