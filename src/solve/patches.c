/* patches.c - equations decomposed into Bernstein patches.
 *
 * All equations share the union of their breakpoints and the largest degree in
 * each direction; each is scaled to size 1. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "mv/mv.h"
#include "solve/patches.h"

#define UNIT       (DBL_EPSILON / 2)
#define DOMAIN_EPS 1e-5 /* domains agree within it, as for all algebra */

/* --- arguments
 * ----------------------------------------------------------------- */

static ix_status check_equation(ix_ctx *ctx, const ix_equation *e, int i,
                                const ix_mv *first)
{
    if (e->f->ndirs != first->ndirs)
        return IX_FAIL(ctx, IX_EARG,
                       "equation %d has %d unknowns, the first has %d", i + 1,
                       e->f->ndirs, first->ndirs);
    if (e->axis < 0 || e->axis >= e->f->naxes)
        return IX_FAIL(ctx, IX_EARG, "equation %d: axis %d of %d", i + 1,
                       e->axis, e->f->naxes);
    for (int j = 0; j < first->ndirs; j++) {
        double a[2], b[2], tol;

        ix_mv_domain(first, j, a);
        ix_mv_domain(e->f, j, b);
        tol = DOMAIN_EPS * (a[1] - a[0]);
        if (e->f->dirs[j].basis == IX_POWER)
            return IX_FAIL(ctx, IX_EARG,
                           "equation %d is in power basis: convert to Bezier",
                           i + 1);
        if (!(fabs(a[0] - b[0]) <= tol && fabs(a[1] - b[1]) <= tol))
            return IX_FAIL(ctx, IX_EARG,
                           "equation %d: domain [%g, %g] in direction %d, the "
                           "first has [%g, %g]",
                           i + 1, b[0], b[1], j, a[0], a[1]);
    }
    return IX_OK;
}

ix_status ix__patches_check(ix_ctx *ctx, int neq, const ix_equation *eq,
                            int missing)
{
    int n = neq > 0 ? eq[0].f->ndirs : 0, zero = 0;

    if (neq < 1 || neq > IX__MAX_EQS)
        return IX_FAIL(ctx, IX_EARG, "%d relations; 1 to %d are possible", neq,
                       IX__MAX_EQS);
    if (n > IX_MAX_UNKNOWNS)
        return IX_FAIL(ctx, IX_EARG, "%d unknowns; at most %d are possible", n,
                       IX_MAX_UNKNOWNS);
    for (int i = 0; i < neq; i++) {
        IX_TRY(check_equation(ctx, &eq[i], i, eq[0].f));
        zero += eq[i].rel == IX_EQUAL_ZERO;
    }
    if (zero < n - missing)
        return IX_FAIL(ctx, IX_EARG, "%d equations for %d unknowns; %d wanted",
                       zero, n, n - missing);
    return IX_OK;
}

/* --- decomposition
 * ---------------------------------------------------------------- */

static ix_status common_spans(ix_ctx *ctx, int neq, const ix_equation *eq,
                              int j, ix_spans *sp)
{
    IX_TRY(ix__spans_of(ctx, &eq[0].f->dirs[j], sp));
    for (int i = 1; i < neq; i++) {
        ix_spans own;
        int d = eq[i].f->dirs[j].order - 1;

        IX_TRY(ix__spans_of(ctx, &eq[i].f->dirs[j], &own));
        IX_TRY(ix__spans_union(ctx, sp, &own, d > sp->degree ? d : sp->degree,
                               sp));
    }
    return IX_OK;
}

/* Degree d to e > d along the middle of [outer][spans (d+1)][inner], one
 * degree at a time: c'_k = (k c_{k-1} + (d+1-k) c_k) / (d+1). */
static void elevate_line(const double *c, int d, int e, size_t inner,
                         double *out)
{
    memcpy(out, c, (size_t)(d + 1) * inner * sizeof *out);
    for (int m = d + 1; m <= e; m++)
        for (int k = m; k >= 0; k--) {
            double f = (double)k / m, g = 1 - f;
            double *o = out + (size_t)k * inner;

            for (size_t i = 0; i < inner; i++)
                o[i] = (k > 0 ? f * o[i - inner] : 0) + (k < m ? g * o[i] : 0);
        }
}

static void elevate(const double *c, size_t lines, int d, int e, size_t inner,
                    double *out)
{
    for (size_t l = 0; l < lines; l++)
        elevate_line(c + l * (size_t)(d + 1) * inner, d, e, inner,
                     out + l * (size_t)(e + 1) * inner);
}

/* One axis of f on the common spans; *steps counts roundings. */
static ix_status decompose(ix_ctx *ctx, const ix_mv *f, int axis,
                           const ix_spans *sp, double **out)
{
    const double *in = ix_mv_axis(f, axis);
    size_t inner = 1;

    for (int j = 0; j < f->ndirs; j++) {
        ix_spans own = sp[j];
        size_t outer = 1, len;
        const double *line = in;
        double *c, *e;

        own.degree = f->dirs[j].order - 1;
        for (int k = j + 1; k < f->ndirs; k++)
            outer *= (size_t)f->dirs[k].length;
        len = (size_t)own.nspans * ((size_t)own.degree + 1);
        if (f->dirs[j].basis != IX_BEZIER || own.nspans > 1) {
            IX_SCRATCH(ctx, c, outer * len * inner);
            IX_TRY(
                ix__spans_extract(ctx, &f->dirs[j], &own, outer, inner, in, c));
            line = c;
        }
        if (own.degree < sp[j].degree) {
            len = (size_t)own.nspans * ((size_t)sp[j].degree + 1);
            IX_SCRATCH(ctx, e, outer * len * inner);
            elevate(line, outer * (size_t)own.nspans, own.degree, sp[j].degree,
                    inner, e);
            line = e;
        }
        in = line;
        inner *= len;
    }
    IX_SCRATCH(ctx, *out, inner);
    memcpy(*out, in, inner * sizeof **out);
    return IX_OK;
}

/* Scales to size 1 (or -1 for "at most zero"); the error of the decomposition
 * is below 4 roundings for each order step. */
static void normalise(ix__patches *p, int i, ix_relation rel)
{
    double lo, hi, m, steps = 0, *c = p->c[i];

    ix__tensor_range(&p->whole, c, &lo, &hi);
    m = fmax(-lo, hi);
    if (!(m > 0))
        m = 1;
    for (size_t t = 0; t < p->whole.size; t++)
        c[t] *= (rel == IX_AT_MOST_ZERO ? -1 : 1) / m;
    for (int j = 0; j < p->whole.n; j++)
        steps += 4.0 * (p->sp[j].degree + 1);
    p->err[i] = steps * UNIT;
}

ix_status ix__patches_make(ix_ctx *ctx, int neq, const ix_equation *eq,
                           ix__patches *p)
{
    int n = eq[0].f->ndirs, at = 0, dims[IX_MAX_UNKNOWNS];

    for (int j = 0; j < n; j++) {
        IX_TRY(common_spans(ctx, neq, eq, j, &p->sp[j]));
        dims[j] = p->sp[j].nspans * (p->sp[j].degree + 1);
    }
    ix__shape_init(&p->whole, n, dims);
    for (int pass = 0; pass < 2; pass++) /* equalities first */
        for (int i = 0; i < neq; i++) {
            if ((eq[i].rel != IX_EQUAL_ZERO) != pass)
                continue;
            IX_TRY(decompose(ctx, eq[i].f, eq[i].axis, p->sp, &p->c[at]));
            normalise(p, at++, eq[i].rel);
        }
    return IX_OK;
}

/* Copies patch idx[] of every equation into b. */
void ix__patches_take(const ix__patches *p, const ix__shape *h, int nall,
                      const int *idx, ix__box *b)
{
    const ix__shape *w = &p->whole;
    size_t from = 0;

    for (int j = 0; j < h->n; j++) {
        from += (size_t)(idx[j] * h->dims[j]) * w->stride[j];
        b->lo[j] = p->sp[j].breaks[idx[j]];
        b->hi[j] = p->sp[j].breaks[idx[j] + 1];
    }
    for (int i = 0; i < nall; i++) {
        double *to = b->c + (size_t)i * h->size;

        b->err[i] = p->err[i];
        for (size_t t = 0; t < h->size; t += (size_t)h->dims[0]) {
            size_t at = from, rest = t / (size_t)h->dims[0];

            for (int j = 1; j < h->n; j++) {
                at += rest % (size_t)h->dims[j] * w->stride[j];
                rest /= (size_t)h->dims[j];
            }
            memcpy(to + t, p->c[i] + at, (size_t)h->dims[0] * sizeof *to);
        }
    }
}

bool ix__patches_next(const ix__patches *p, int n, int *idx)
{
    for (int j = 0; j < n; j++) {
        if (++idx[j] < p->sp[j].nspans)
            return true;
        idx[j] = 0;
    }
    return false;
}

void ix__patches_shape(const ix__patches *p, ix__shape *s, double *edge)
{
    int dims[IX_MAX_UNKNOWNS];

    for (int j = 0; j < p->whole.n; j++) {
        dims[j] = p->sp[j].degree + 1;
        edge[j] = p->sp[j].breaks[p->sp[j].nspans] - p->sp[j].breaks[0];
    }
    ix__shape_init(s, p->whole.n, dims);
}
