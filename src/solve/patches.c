/* patches.c - equations decomposed into Bernstein patches.
 *
 * All equations share the union of their breakpoints and the largest degree in
 * each direction; each is scaled to size 1. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "bsp/rows.h"
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

/* [outer][n][inner] of B-spline coefficients to Bernstein ones of sp's degree
 * in direction d. *steps counts roundings; a Bezier direction of that degree is
 * taken as it is. */
static ix_status decompose_dir(ix_ctx *ctx, const ix_dir *d, const ix_spans *sp,
                               size_t outer, size_t inner, const double **in,
                               double *steps)
{
    ix_spans own = *sp;
    size_t len, spans = (size_t)own.nspans;
    double *c;

    own.degree = d->order - 1;
    len = spans * (size_t)d->order;
    if (d->basis != IX_BEZIER || own.nspans > 1) {
        IX_SCRATCH(ctx, c, outer * len * inner);
        IX_TRY(ix__spans_extract(ctx, d, &own, outer, inner, *in, c));
        *in = c;
        *steps += 4.0 * d->order;
    }
    if (own.degree < sp->degree) {
        ix_rows up;

        IX_SCRATCH(ctx, c, outer * spans * ((size_t)sp->degree + 1) * inner);
        IX_TRY(ix__rows_raise(ctx, own.degree, sp->degree, &up));
        ix__rows_apply(ctx, &up, d->order, outer * spans, inner, *in, c);
        *in = c;
        *steps += 4.0 * (sp->degree + 1);
    }
    return IX_OK;
}

/* One axis of f on the common spans. */
static ix_status decompose(ix_ctx *ctx, const ix_mv *f, int axis,
                           const ix_spans *sp, double **out, double *steps)
{
    const double *in = ix_mv_axis(f, axis);
    size_t inner = 1;

    *steps = 0;
    for (int j = 0; j < f->ndirs; j++) {
        size_t outer = 1;

        for (int k = j + 1; k < f->ndirs; k++)
            outer *= (size_t)f->dirs[k].length;
        IX_TRY(
            decompose_dir(ctx, &f->dirs[j], &sp[j], outer, inner, &in, steps));
        inner *= (size_t)sp[j].nspans * ((size_t)sp[j].degree + 1);
    }
    IX_SCRATCH(ctx, *out, inner);
    memcpy(*out, in, inner * sizeof **out);
    return IX_OK;
}

/* Scales by a power of 2, which is exact, to size 1/2 .. 1 ("at most zero":
 * with the other sign), unless small coefficients become denormal. */
static void normalise(ix__patches *p, int i, ix_relation rel, double steps)
{
    double lo, hi, f, *c = p->c[i];
    int e;

    ix__tensor_range(&p->whole, c, &lo, &hi);
    (void)frexp(fmax(-lo, hi), &e);
    f = ldexp(rel == IX_AT_MOST_ZERO ? -1 : 1, -e / 2);
    for (size_t t = 0; t < p->whole.size; t++) /* 2^-e itself may overflow */
        c[t] = c[t] * f * ldexp(1, -e - -e / 2);
    p->err[i] = steps * UNIT + DBL_MIN;
}

ix_status ix__patches_make(ix_ctx *ctx, int neq, const ix_equation *eq,
                           ix__patches *p)
{
    int n = eq[0].f->ndirs, at = 0, dims[IX_MAX_UNKNOWNS];
    double steps;

    for (int j = 0; j < n; j++) {
        IX_TRY(common_spans(ctx, neq, eq, j, &p->sp[j]));
        dims[j] = p->sp[j].nspans * (p->sp[j].degree + 1);
    }
    ix__shape_init(&p->whole, n, dims);
    for (int pass = 0; pass < 2; pass++) /* equalities first */
        for (int i = 0; i < neq; i++) {
            if ((eq[i].rel != IX_EQUAL_ZERO) != pass)
                continue;
            IX_TRY(
                decompose(ctx, eq[i].f, eq[i].axis, p->sp, &p->c[at], &steps));
            normalise(p, at++, eq[i].rel, steps);
        }
    return IX_OK;
}

/* Copies patch idx[] of every equation into b. */
void ix__patches_take(const ix__patches *p, const ix__shape *h, int nall,
                      const int *idx, ix__box *b)
{
    const ix__shape *w = &p->whole;
    size_t from = 0;

    b->cuts = b->fresh = 0;
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

bool ix__patches_joined(const ix__patches *p, const ix__shape *h, int neq,
                        const int *idx, int j)
{
    const ix__shape *w = &p->whole;
    size_t from = 0;

    if (idx[j] + 1 >= p->sp[j].nspans)
        return false;
    for (int k = 0; k < h->n; k++)
        from += (size_t)(idx[k] * h->dims[k]) * w->stride[k];
    from += (size_t)(h->dims[j] - 1) * w->stride[j]; /* the upper layer */
    for (size_t t = 0; t < h->size; t++) {
        size_t at = from, rest = t;
        bool layer = true;

        for (int k = 0; k < h->n; k++) {
            at += rest % (size_t)h->dims[k] * w->stride[k] * (k != j);
            layer &= k != j || rest % (size_t)h->dims[k] == 0;
            rest /= (size_t)h->dims[k];
        }
        for (int i = 0; layer && i < neq; i++)
            if (!(fabs(p->c[i][at] - p->c[i][at + w->stride[j]]) <=
                  2 * p->err[i]))
                return false;
    }
    return true;
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
