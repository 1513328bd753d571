/* inner.c - the inner function of a composition: whether it stays in the
 * domain of the outer one, and where it passes its breaks. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "bern/bern.h"
#include "sym/compose_impl.h"

/* How far g may leave f's domain, as a part of its length (spec/model 9.1). */
#define DOMAIN_TOL 1e-5
/* Refinement of g in search of a point outside ends at this size. */
#define MAX_SEARCH 500000

/* x_i + factor w of g in direction i of f, as a form of one row. */
static ix_status offset(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                        double sx, double sw, ix_form *out)
{
    IX_TRY(ix__form_copy(ctx, x, out));
    for (size_t k = 0; k < out->n; k++)
        out->c[k] = sx * x->c[k] + sw * w->c[k];
    return IX_OK;
}

/* --- staying in the domain ------------------------------------------------ */

/* Smallest coefficient, and the smallest value at corners of patches. */
static ix_status lowest(ix_ctx *ctx, const ix_form *f, double *coef,
                        double *corner)
{
    const double *b;

    IX_TRY(ix__form_bernstein(ctx, f, &b));
    *coef = *corner = b[0];
    for (size_t k = 0; k < f->n; k++) {
        size_t rest = k;
        bool at = true;

        for (int i = 0; i < f->ndirs; i++) {
            size_t n = (size_t)f->dirs[i].degree + 1, j;

            j = rest % ix__spans_size(&f->dirs[i]) % n;
            rest /= ix__spans_size(&f->dirs[i]);
            at &= j == 0 || j == n - 1;
        }
        *coef = b[k] < *coef ? b[k] : *coef;
        *corner = at && b[k] < *corner ? b[k] : *corner;
    }
    return IX_OK;
}

/* Every span of every direction halved. */
static ix_status halve(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    *out = *f;
    for (int i = 0; i < f->ndirs; i++) {
        const ix_spans *sp = &f->dirs[i];
        ix_spans fine = {sp->degree, 2 * sp->nspans, NULL, NULL};
        double *br;

        IX_SCRATCH(ctx, br, 2 * (size_t)sp->nspans + 1);
        for (int j = 0; j < sp->nspans; j++) {
            br[2 * j] = sp->breaks[j];
            br[2 * j + 1] = sp->breaks[j] / 2 + sp->breaks[j + 1] / 2;
        }
        br[2 * sp->nspans] = sp->breaks[sp->nspans];
        fine.breaks = br;
        IX_TRY(ix__form_refine(ctx, out, i, &fine, out));
    }
    return IX_OK;
}

/* A polynomial form that should not be negative: finer and finer, until its
 * coefficients tell that it is not or a value tells that it is. What is left
 * open at the end is smaller than can be seen. */
static ix_status check_positive(ix_ctx *ctx, const ix_form *f, int dir,
                                const ix_spans *sp)
{
    ix_form fine = *f;
    double coef, corner;

    for (;;) {
        IX_TRY(lowest(ctx, &fine, &coef, &corner));
        if (coef >= 0.0)
            return IX_OK;
        if (corner < 0.0)
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "coordinate %d of the inner function leaves the "
                           "domain [%g, %g] of direction %d",
                           dir + 1, sp->breaks[0], sp->breaks[sp->nspans], dir);
        if (fine.n > MAX_SEARCH)
            return IX_OK;
        IX_TRY(halve(ctx, &fine, &fine));
    }
}

ix_status ix__inner_check(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                          int dir, const ix_spans *sp)
{
    double lo = sp->breaks[0], hi = sp->breaks[sp->nspans];
    double tol = DOMAIN_TOL * (hi - lo), s = w->c[0] > 0.0 ? 1.0 : -1.0;
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;
    ix_form f;

    st = offset(ctx, x, w, s, -s * (lo - tol), &f);
    if (st == IX_OK)
        st = check_positive(ctx, &f, dir, sp);
    if (st == IX_OK)
        st = offset(ctx, x, w, -s, s * (hi + tol), &f);
    if (st == IX_OK)
        st = check_positive(ctx, &f, dir, sp);
    ix__scratch_release(ctx, mk);
    return st;
}

/* --- cutting a curve g at the breaks of f --------------------------------- */

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Where x - brk w changes sign inside its spans, appended to cuts. */
static ix_status crossings(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                           double brk, double *cuts, int *n)
{
    const ix_spans *sp = &x->dirs[0];
    int d = sp->degree;
    double *work, *u, band;
    const double *b;
    ix_form f;

    IX_TRY(offset(ctx, x, w, 1.0, -brk, &f));
    IX_TRY(ix__form_bernstein(ctx, &f, &b));
    IX_SCRATCH(ctx, work, 2 * (d + 1));
    IX_SCRATCH(ctx, u, d + 1);
    IX_TRY(ix__form_bound(ctx, x, &band)); /* rounding of the evaluation */
    band *= 4.0 * (d + 1) * DBL_EPSILON;
    for (int j = 0; j < sp->nspans; j++) {
        double h = sp->breaks[j + 1] - sp->breaks[j];
        int m = ix__bern_crossings(d, b + (size_t)j * (size_t)(d + 1), band,
                                   work, u);

        for (int i = 0; i < m; i++)
            cuts[(*n)++] = sp->breaks[j] + u[i] * h;
    }
    return IX_OK;
}

/* All cuts in all directions, sorted; room for every root there can be. */
static ix_status find_cuts(ix_ctx *ctx, const ix_form *f, const ix_form *x,
                           const ix_form *w, double **out, int *n)
{
    const ix_spans *sp = &x->dirs[0];
    size_t room = 1;

    for (int i = 0; i < f->ndirs; i++)
        room += (size_t)(f->dirs[i].nspans - 1) * (size_t)sp->nspans *
                (size_t)sp->degree;
    IX_SCRATCH(ctx, *out, room);
    *n = 0;
    for (int i = 0; i < f->ndirs; i++) {
        ix_form xi = ix__form_rows(x, i, 1);

        for (int k = 1; k < f->dirs[i].nspans; k++)
            IX_TRY(crossings(ctx, &xi, w, f->dirs[i].breaks[k], *out, n));
    }
    if (*n > 1)
        qsort(*out, (size_t)*n, sizeof **out, by_value);
    return IX_OK;
}

/* Breaks of g and cuts together. A cut within rounding of a break, or of the
 * cut before it, is left out: the value in the middle of a span tells where
 * it lies. */
static ix_status merge_cuts(ix_ctx *ctx, const ix_spans *g, const double *cuts,
                            int n, ix_spans *out)
{
    double *br, tol = 16.0 * DBL_EPSILON *
                      fmax(fabs(g->breaks[0]), fabs(g->breaks[g->nspans]));
    int m = 0, i = 0;

    IX_SCRATCH(ctx, br, (size_t)g->nspans + (size_t)n + 1);
    br[0] = g->breaks[0];
    for (int j = 1; j <= g->nspans; j++) {
        for (; i < n && cuts[i] < g->breaks[j]; i++)
            if (cuts[i] - br[m] > tol && g->breaks[j] - cuts[i] > tol)
                br[++m] = cuts[i];
        br[++m] = g->breaks[j];
    }
    *out = (ix_spans){g->degree, m, br, NULL};
    return IX_OK;
}

ix_status ix__inner_cut(ix_ctx *ctx, const ix_form *f, const ix_form *x,
                        const ix_form *w, ix_form *g)
{
    ix_spans fine;
    double *cuts;
    int n;

    IX_TRY(find_cuts(ctx, f, x, w, &cuts, &n));
    if (n == 0)
        return IX_OK;
    IX_TRY(merge_cuts(ctx, &g->dirs[0], cuts, n, &fine));
    return ix__form_refine(ctx, g, 0, &fine, g);
}
