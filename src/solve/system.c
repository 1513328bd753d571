/* system.c - n equations in n unknowns on piecewise domains.
 *
 * The equations are decomposed once into Bernstein patches of common degrees
 * on the union of all breakpoints, scaled to size 1, and every patch is
 * searched (system_search.c). */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "bsp/spans.h"
#include "mv/mv.h"
#include "solve/system_impl.h"

#define UNIT       (DBL_EPSILON / 2)
#define MAX_EQS    (3 * IX_MAX_UNKNOWNS)
#define DOMAIN_EPS 1e-5 /* domains agree within it, as for all algebra */

typedef struct {
    ix_spans sp[IX_MAX_UNKNOWNS]; /* common breakpoints and degrees */
    ix__shape whole;              /* of one decomposed equation */
    double *c[MAX_EQS];           /* decomposed equations */
    double err[MAX_EQS];
} patches;

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

static ix_status check(ix_ctx *ctx, int neq, const ix_equation *eq)
{
    int n = neq > 0 ? eq[0].f->ndirs : 0, zero = 0;

    if (neq < 1 || neq > MAX_EQS)
        return IX_FAIL(ctx, IX_EARG, "%d relations; 1 to %d are possible", neq,
                       MAX_EQS);
    if (n > IX_MAX_UNKNOWNS)
        return IX_FAIL(ctx, IX_EARG, "%d unknowns; at most %d are possible", n,
                       IX_MAX_UNKNOWNS);
    for (int i = 0; i < neq; i++) {
        IX_TRY(check_equation(ctx, &eq[i], i, eq[0].f));
        zero += eq[i].rel == IX_EQUAL_ZERO;
    }
    if (zero < n)
        return IX_FAIL(ctx, IX_EARG, "%d equations for %d unknowns", zero, n);
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
        double *c, *e;

        own.degree = f->dirs[j].order - 1;
        for (int k = j + 1; k < f->ndirs; k++)
            outer *= (size_t)f->dirs[k].length;
        len = (size_t)own.nspans * ((size_t)own.degree + 1);
        IX_SCRATCH(ctx, c, outer * len * inner);
        IX_TRY(ix__spans_extract(ctx, &f->dirs[j], &own, outer, inner, in, c));
        if (own.degree < sp[j].degree) {
            len = (size_t)own.nspans * ((size_t)sp[j].degree + 1);
            IX_SCRATCH(ctx, e, outer * len * inner);
            elevate(c, outer * (size_t)own.nspans, own.degree, sp[j].degree,
                    inner, e);
            c = e;
        }
        in = c;
        inner *= len;
    }
    IX_SCRATCH(ctx, *out, inner);
    memcpy(*out, in, inner * sizeof **out);
    return IX_OK;
}

/* Scales to size 1 (or -1 for "at most zero"); the error of the decomposition
 * is below 4 roundings for each order step. */
static void normalise(patches *p, int i, ix_relation rel)
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

static ix_status make_patches(ix_ctx *ctx, int neq, const ix_equation *eq,
                              patches *p)
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
static void take_patch(const patches *p, const ix__system *s, const int *idx,
                       ix__box *b)
{
    const ix__shape *w = &p->whole, *h = &s->shape;
    size_t from = 0;

    for (int j = 0; j < s->n; j++) {
        from += (size_t)(idx[j] * h->dims[j]) * w->stride[j];
        b->lo[j] = p->sp[j].breaks[idx[j]];
        b->hi[j] = p->sp[j].breaks[idx[j] + 1];
    }
    for (int i = 0; i < s->nall; i++) {
        double *to = b->c + (size_t)i * h->size;

        b->err[i] = p->err[i];
        for (size_t t = 0; t < h->size; t += (size_t)h->dims[0]) {
            size_t at = from, rest = t / (size_t)h->dims[0];

            for (int j = 1; j < s->n; j++) {
                at += rest % (size_t)h->dims[j] * w->stride[j];
                rest /= (size_t)h->dims[j];
            }
            memcpy(to + t, p->c[i] + at, (size_t)h->dims[0] * sizeof *to);
        }
    }
}

static bool next_patch(const patches *p, int n, int *idx)
{
    for (int j = 0; j < n; j++) {
        if (++idx[j] < p->sp[j].nspans)
            return true;
        idx[j] = 0;
    }
    return false;
}

/* --- results
 * -------------------------------------------------------------------------- */

static void residuals(const patches *p, const ix__system *s, ix_solution *r,
                      ix__box *b, double *work)
{
    int idx[IX_MAX_UNKNOWNS];
    double x[IX_MAX_UNKNOWNS];

    for (int j = 0; j < s->n; j++) {
        const double *br = p->sp[j].breaks;

        idx[j] = 0;
        while (idx[j] + 1 < p->sp[j].nspans && r->x[j] >= br[idx[j] + 1])
            idx[j]++;
        x[j] = (r->x[j] - br[idx[j]]) / (br[idx[j] + 1] - br[idx[j]]);
    }
    take_patch(p, s, idx, b);
    r->residual = 0;
    for (int i = 0; i < s->neq; i++)
        r->residual = fmax(
            r->residual,
            fabs(ix__tensor_value(&s->shape, b->c + (size_t)i * s->shape.size,
                                  x, work)));
}

static ix_status give(ix_ctx *ctx, const ix__found *f, const ix__system *s,
                      ix_solutions *out)
{
    size_t bytes = (size_t)f->n * sizeof *out->sol;

    out->unknowns = s->n;
    out->boxes = s->boxes;
    out->complete = s->boxes < s->max_boxes;
    if (f->n == 0)
        return IX_OK;
    out->sol = ix__alloc(ctx, bytes);
    if (!out->sol)
        return IX_ENOMEM;
    memcpy(out->sol, f->sol, bytes);
    out->n = f->n;
    out->bytes = bytes;
    return IX_OK;
}

static void set_up(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_solve_opts *o, const patches *p, ix__system *s)
{
    int dims[IX_MAX_UNKNOWNS];

    *s = (ix__system){.ctx = ctx, .n = eq[0].f->ndirs, .nall = neq};
    s->cell = o && o->cell > 0 ? o->cell : 1e-7;
    s->max_boxes = o && o->max_boxes ? o->max_boxes : 10000000;
    for (int i = 0; i < neq; i++)
        s->neq += eq[i].rel == IX_EQUAL_ZERO;
    for (int j = 0; j < s->n; j++) {
        dims[j] = p->sp[j].degree + 1;
        s->edge[j] = p->sp[j].breaks[p->sp[j].nspans] - p->sp[j].breaks[0];
    }
    ix__shape_init(&s->shape, s->n, dims);
}

static ix_status solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                       const ix_solve_opts *o, ix_solutions *out)
{
    int idx[IX_MAX_UNKNOWNS] = {0};
    ix__found found = {.ctx = ctx};
    double *work;
    patches p;
    ix__system s;
    ix__box b;

    IX_TRY(check(ctx, neq, eq));
    IX_TRY(make_patches(ctx, neq, eq, &p));
    set_up(ctx, neq, eq, o, &p, &s);
    IX_SCRATCH(ctx, b.c, (size_t)neq * s.shape.size);
    IX_SCRATCH(ctx, work, 2 * s.shape.size);
    do {
        take_patch(&p, &s, idx, &b);
        IX_TRY(ix__system_search(&s, &b, &found));
    } while (next_patch(&p, s.n, idx) && s.boxes < s.max_boxes);
    IX_TRY(ix__found_merge(&found, s.n, s.edge));
    for (int i = 0; i < found.n; i++)
        residuals(&p, &s, &found.sol[i], &b, work);
    return give(ctx, &found, &s, out);
}

ix_status ix_solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_solve_opts *o, ix_solutions *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = (ix_solutions){.n = 0};
    st = solve(ctx, neq, eq, o, out);
    ix__scratch_release(ctx, mk);
    return st;
}

void ix_solutions_free(ix_ctx *ctx, ix_solutions *s)
{
    if (s->sol)
        ix__free(ctx, s->sol, s->bytes);
    *s = (ix_solutions){.n = 0};
}
