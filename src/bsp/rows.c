/* rows.c - linear maps of one direction whose rows are short. */
#include "bsp/rows.h"

#include <math.h>
#include <string.h>

#include "base/threads.h"
#include "bsp/basis.h"
#include "bsp/weigh.h"

ix_status ix__rows_alloc(ix_ctx *ctx, int nrows, int width, ix_rows *out)
{
    size_t n;

    if (__builtin_mul_overflow((size_t)nrows, (size_t)width, &n))
        return IX_FAIL(ctx, IX_ENOMEM, "%d rows of %d weights", nrows, width);
    *out = (ix_rows){.nrows = nrows, .width = width, .affine = true};
    IX_SCRATCH(ctx, out->first, nrows);
    IX_SCRATCH(ctx, out->heavy, nrows);
    IX_SCRATCH(ctx, out->w, n);
    return IX_OK;
}

void ix__rows_weigh(ix_rows *b)
{
    for (int i = 0; i < b->nrows; i++) {
        const double *w = b->w + (size_t)i * (size_t)b->width;
        int best = 0;

        for (int q = 1; q < b->width; q++)
            if (fabs(w[q]) > fabs(w[best]))
                best = q;
        b->heavy[i] = best;
    }
}

/* True if the d arguments are consecutive knots of the span mu's window; then
 * w is the single 1 that selects the point which they belong to. */
static bool selects_point(const double *knots, int mu, int d,
                          const double *args, double *w)
{
    int last = mu, run = 0, j;

    if (d == 0) {
        w[0] = 1;
        return true;
    }
    while (run < d && args[run] == args[0])
        run++;
    while (last < mu + d && knots[last + 1] <= args[0])
        last++;
    while (last > mu - d && knots[last] > args[0])
        last--;
    j = last - run; /* arguments should be knots[j + 1 .. j + d] */
    if (j < mu - d || j > mu ||
        memcmp(knots + j + 1, args, (size_t)d * sizeof *args) != 0)
        return false;
    for (int q = 0; q <= d; q++)
        w[q] = q == j - (mu - d);
    return true;
}

ix_status ix__rows_refine(ix_ctx *ctx, const ix_dir *dir, int length,
                          const double *knots, ix_rows *out)
{
    int d = dir->order - 1, mu = d, end = ix__dir_npoints(dir);
    const double *t = dir->knots;

    IX_TRY(ix__rows_alloc(ctx, length, d + 1, out));
    while (t[end - 1] >= t[end]) /* the last span of the domain is not empty */
        end--;
    for (int i = 0; i < length; i++) {
        double *w = out->w + (size_t)i * (size_t)(d + 1);

        while (mu < end - 1 && t[mu + 1] <= knots[i])
            mu++;
        while (t[mu] >= t[mu + 1])
            mu++;
        out->first[i] = mu - d;
        if (!selects_point(t, mu, d, knots + i + 1, w))
            ix__blossom_weights(t, mu, d, knots + i + 1, w);
    }
    ix__rows_weigh(out);
    return IX_OK;
}

ix_status ix__rows_sample(ix_ctx *ctx, const ix_dir *dir, int n,
                          const double *t, ix_rows *out)
{
    IX_TRY(ix__rows_alloc(ctx, n, dir->order, out));
    out->affine = dir->basis != IX_POWER;
    for (int i = 0; i < n; i++) {
        out->first[i] = ix__basis_first(dir, t[i]);
        ix__basis_derive(dir, out->first[i], t[i], 0,
                         out->w + (size_t)i * (size_t)dir->order);
    }
    ix__rows_weigh(out);
    return IX_OK;
}

/* Row j of raising has the weights C(from, i) C(up, j - i) / C(to, j): a
 * hypergeometric distribution. They are built outwards from the largest, so
 * that nothing overflows, and then divided by their sum. */
static void raise_row(int from, int up, int j, double *w)
{
    int lo = j > up ? j - up : 0, hi = j < from ? j : from;
    int top = (int)((double)(from + 1) * (j + 1) / (from + up + 2));
    double sum = 1;

    top = top < lo ? lo : top > hi ? hi : top;
    for (int i = 0; i <= from; i++)
        w[i] = 0;
    w[top] = 1;
    for (int i = top; i < hi; i++) {
        w[i + 1] = w[i] * ((double)(from - i) * (j - i)) /
                   ((double)(i + 1) * (up - j + i + 1));
        sum += w[i + 1];
    }
    for (int i = top; i > lo; i--) {
        w[i - 1] = w[i] * ((double)i * (up - j + i)) /
                   ((double)(from - i + 1) * (j - i + 1));
        sum += w[i - 1];
    }
    for (int i = lo; i <= hi; i++)
        w[i] /= sum;
}

ix_status ix__rows_raise(ix_ctx *ctx, int from, int to, ix_rows *out)
{
    IX_TRY(ix__rows_alloc(ctx, to + 1, from + 1, out));
    for (int j = 0; j <= to; j++) {
        out->first[j] = 0;
        raise_row(from, to - from, j, out->w + (size_t)j * (size_t)(from + 1));
    }
    ix__rows_weigh(out);
    return IX_OK;
}

/* Mean over k of the blossom at the n = d + 1 arguments without the k-th; the
 * window is that of span mu. args[d] and part[d + 1] are room. */
static void mean_blossom(const double *knots, int mu, int n, const double *tau,
                         double *args, double *part, double *w)
{
    memset(w, 0, (size_t)n * sizeof *w);
    for (int k = 0, run; k < n; k += run) {
        for (run = 1; k + run < n && tau[k + run] == tau[k];)
            run++;
        memcpy(args, tau, (size_t)k * sizeof *args);
        memcpy(args + k, tau + k + 1, (size_t)(n - 1 - k) * sizeof *args);
        ix__blossom_weights(knots, mu, n - 1, args, part);
        for (int q = 0; q < n; q++)
            w[q] += part[q] * run / n;
    }
}

ix_status ix__rows_raise_one(ix_ctx *ctx, const ix_dir *dir, int length,
                             const double *knots, ix_rows *out)
{
    int o = dir->order, mu = o - 1, end = dir->length;
    const double *t = dir->knots;
    double *args, *part;

    IX_TRY(ix__rows_alloc(ctx, length, o, out));
    IX_SCRATCH(ctx, args, o);
    IX_SCRATCH(ctx, part, o);
    for (int i = 0; i < length; i++) {
        while (mu < end - 1 && t[mu + 1] <= knots[i])
            mu++;
        out->first[i] = mu - (o - 1);
        mean_blossom(t, mu, o, knots + i + 1, args, part,
                     out->w + (size_t)i * (size_t)o);
    }
    ix__rows_weigh(out);
    return IX_OK;
}

/* --- application -------------------------------------------------------- */

typedef struct {
    const ix_rows *b;
    int n;
    size_t outer, inner;
    const double *in;
    double *out;
} job;

/* Row i where its points run over the end: one after another. */
static void combine_wrapped(const job *jb, size_t i, const double *in,
                            double *out)
{
    const ix_rows *b = jb->b;
    const double *w = b->w + i * (size_t)b->width;
    int first = b->first[i];
    size_t inner = jb->inner, ref = (size_t)((first + b->heavy[i]) % jb->n);

    for (size_t l = 0; l < inner; l++) {
        double r = b->affine ? in[ref * inner + l] : 0, sum = 0;

        for (int q = 0; q < b->width; q++)
            sum += w[q] * (in[(size_t)((first + q) % jb->n) * inner + l] - r);
        out[l] = r + sum;
    }
}

/* Row i of single numbers. */
static double combine_one(const ix_rows *b, size_t i, const double *in)
{
    const double *w = b->w + i * (size_t)b->width, *p = in + b->first[i];
    double ref = b->affine ? p[b->heavy[i]] : 0, sum = 0;

    for (int q = 0; q < b->width; q++)
        sum += w[q] * (p[q] - ref);
    return ref + sum;
}

/* Row i as p[heavy] + sum of w[q] (p[q] - p[heavy]), so that a constant stays
 * exactly what it is. */
static void combine(const job *jb, size_t i, const double *in, double *out)
{
    const ix_rows *b = jb->b;
    const double *w = b->w + i * (size_t)b->width, *p;

    if (b->first[i] + b->width > jb->n) {
        combine_wrapped(jb, i, in, out);
        return;
    }
    if (jb->inner == 1) {
        *out = combine_one(b, i, in);
        return;
    }
    p = in + (size_t)b->first[i] * jb->inner;
    ix__weigh(jb->inner, b->width, w, p,
              b->affine ? p + (size_t)b->heavy[i] * jb->inner : NULL, out);
}

static void apply_items(void *arg, size_t begin, size_t end)
{
    const job *jb = arg;
    size_t rows = (size_t)jb->b->nrows, i = begin % rows;
    const double *in = jb->in + begin / rows * (size_t)jb->n * jb->inner;

    for (size_t k = begin; k < end; k++) {
        combine(jb, i, in, jb->out + k * jb->inner);
        if (++i == rows) {
            i = 0;
            in += (size_t)jb->n * jb->inner;
        }
    }
}

void ix__rows_apply(ix_ctx *ctx, const ix_rows *b, int n, size_t outer,
                    size_t inner, const double *in, double *out)
{
    job jb = {b, n, outer, inner, in, out};

    ix__parallel(ctx, outer * (size_t)b->nrows,
                 5 + 1.5 * (double)b->width * (double)inner, apply_items, &jb);
}
