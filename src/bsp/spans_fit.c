/* spans_fit.c - the nearest spline with fewer degrees of freedom: banded
 * least squares, span after span, with a bound of what changed. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/knots.h"
#include "bsp/rows.h"
#include "bsp/spans.h"

typedef struct {
    const ix_spans *sp;
    const ix_dir *dir;
    const double *knots;
    size_t outer, inner, lanes;
    const double *in;
    int fixed;      /* 1 if the first and the last point are given, else 0 */
    ix_rows raise;  /* dir's degree to sp's */
    double *ext;    /* [order][order] */
    double *matrix; /* [degree + 1][order] */
    double *rhs;    /* [lanes] */
    double *ends;   /* [2][lanes] */
    ix_band band;
} fit;

/* Coefficient i of span j in every lane. */
static void coefficients(const fit *f, int j, int i, double *out)
{
    size_t n = (size_t)f->sp->nspans * (size_t)(f->sp->degree + 1);
    size_t at = (size_t)j * (size_t)(f->sp->degree + 1) + (size_t)i;

    for (size_t o = 0; o < f->outer; o++)
        memcpy(out + o * f->inner, f->in + (o * n + at) * f->inner,
               f->inner * sizeof *out);
}

/* Span j's coefficients of sp's degree as combinations of dir's points. */
static void span_matrix(fit *f, int j, int mu)
{
    int o = f->dir->order;

    ix__span_matrix(f->knots, mu, o - 1, f->sp->breaks + j, f->ext);
    for (int i = 0; i <= f->sp->degree; i++) {
        const double *w = f->raise.w + (size_t)i * (size_t)o;
        double *row = f->matrix + (size_t)i * (size_t)o;

        memset(row, 0, (size_t)o * sizeof *row);
        for (int q = 0; q < o; q++)
            for (int l = 0; w[q] != 0 && l < o; l++)
                row[l] += w[q] * f->ext[q * o + l];
    }
}

/* The equation of coefficient i of span j; row[order] from point first. Given
 * points go to the right-hand side. */
static void add_equation(fit *f, int j, int i, int first)
{
    int o = f->dir->order, n = f->dir->length, skip = 0, m = o;
    const double *row = f->matrix + (size_t)i * (size_t)o;

    coefficients(f, j, i, f->rhs);
    if (f->fixed && first == 0) {
        for (size_t l = 0; l < f->lanes; l++)
            f->rhs[l] -= row[0] * f->ends[l];
        skip = 1;
    }
    if (f->fixed && first + o == n) {
        for (size_t l = 0; l < f->lanes; l++)
            f->rhs[l] -= row[o - 1] * f->ends[f->lanes + l];
        m--;
    }
    if (m > skip)
        ix__band_add(&f->band, first + skip - f->fixed, m - skip, row + skip,
                     f->rhs);
}

static ix_status prepare(ix_ctx *ctx, fit *f)
{
    size_t o = (size_t)f->dir->order;
    int unknowns, last = f->sp->nspans - 1;

    f->fixed = f->dir->order > 1;
    unknowns = f->dir->length - 2 * f->fixed;
    f->lanes = f->outer * f->inner;
    if (f->lanes > INT_MAX)
        return IX_FAIL(ctx, IX_ENOMEM, "%zu right-hand sides", f->lanes);
    IX_TRY(ix__dir_knots(ctx, f->dir, &f->knots));
    IX_TRY(ix__rows_raise(ctx, f->dir->order - 1, f->sp->degree, &f->raise));
    IX_SCRATCH(ctx, f->ext, o * o);
    IX_SCRATCH(ctx, f->matrix, o * (size_t)(f->sp->degree + 1));
    IX_SCRATCH(ctx, f->rhs, f->lanes);
    IX_SCRATCH(ctx, f->ends, 2 * f->lanes);
    coefficients(f, 0, 0, f->ends);
    coefficients(f, last, f->sp->degree, f->ends + f->lanes);
    return ix__band_new(ctx, unknowns, f->dir->order, false, (int)f->lanes,
                        &f->band);
}

/* Point i of dir in every lane. */
static void put_point(const fit *f, int i, const double *v, size_t step,
                      double *out)
{
    size_t n = (size_t)f->dir->length;

    for (size_t o = 0; o < f->outer; o++)
        for (size_t l = 0; l < f->inner; l++)
            out[(o * n + (size_t)i) * f->inner + l] =
                v[(o * f->inner + l) * step];
}

static ix_status solve(ix_ctx *ctx, fit *f, double *out)
{
    size_t unknowns = (size_t)f->band.n;
    int n = f->dir->length;
    double *x;

    IX_SCRATCH(ctx, x, unknowns * f->lanes);
    if (unknowns > 0 && ix__band_solve(ctx, &f->band, x) != IX_OK)
        return IX_FAIL(ctx, IX_EUNABLE,
                       "fitting order %d to order %d is too badly conditioned",
                       f->dir->order, f->sp->degree + 1);
    for (int i = f->fixed; i < n - f->fixed; i++)
        put_point(f, i, x + (i - f->fixed), unknowns, out);
    if (f->fixed) {
        put_point(f, 0, f->ends, 1, out);
        put_point(f, n - 1, f->ends + f->lanes, 1, out);
    }
    return IX_OK;
}

/* Largest difference of Bernstein coefficients, for each outer index. */
static ix_status measure(ix_ctx *ctx, const fit *f, const double *out,
                         double *err)
{
    size_t pieces = f->outer * (size_t)f->sp->nspans;
    size_t low = (size_t)f->dir->order * f->inner;
    size_t high = (size_t)(f->sp->degree + 1) * f->inner;
    size_t each = (size_t)f->sp->nspans * high;
    double *bern, *more;

    IX_SCRATCH(ctx, bern, pieces * low);
    IX_SCRATCH(ctx, more, pieces * high);
    IX_TRY(
        ix__spans_extract(ctx, f->dir, f->sp, f->outer, f->inner, out, bern));
    ix__rows_apply(ctx, &f->raise, f->dir->order, pieces, f->inner, bern, more);
    for (size_t o = 0; o < f->outer; o++) {
        err[o] = 0;
        for (size_t i = o * each; i < (o + 1) * each; i++)
            err[o] = fmax(err[o], fabs(more[i] - f->in[i]));
    }
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, fit *f, double *out, double *err)
{
    int mu = f->dir->order - 1;

    IX_TRY(prepare(ctx, f));
    for (int j = 0; j < f->sp->nspans && f->band.n > 0; j++) {
        while (f->knots[mu + 1] <= f->sp->breaks[j])
            mu++;
        span_matrix(f, j, mu);
        for (int i = 0; i <= f->sp->degree; i++)
            add_equation(f, j, i, mu - (f->dir->order - 1));
    }
    IX_TRY(solve(ctx, f, out));
    return measure(ctx, f, out, err);
}

ix_status ix__spans_fit(ix_ctx *ctx, const ix_spans *sp, const ix_dir *dir,
                        size_t outer, size_t inner, const double *in,
                        double *out, double *err)
{
    fit f = {.sp = sp, .dir = dir, .outer = outer, .inner = inner, .in = in};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = run(ctx, &f, out, err);

    ix__scratch_release(ctx, mk);
    return st;
}
