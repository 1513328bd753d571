/* form_mul.c - products. With one direction the rows lie span by span as the
 * kernel wants them. With more, the coefficients of one patch (one span in
 * each direction) are gathered at the strides of the product's patch, where
 * the tensor product is again a convolution of two rows. */
#include <assert.h>
#include <string.h>

#include "base/threads.h"
#include "bern/bern.h"
#include "sym/form_impl.h"

/* Chunks of patches, each with its own room; enough for any pool. */
#define MAX_CHUNKS 64
#define CHUNK_NS   20000.0

/* One form's patches: where the k-th coefficient of a patch stands, counted
 * from its first, and where it goes in a patch of the product. */
typedef struct {
    const ix_form *f;
    size_t count;   /* coefficients of a patch */
    size_t *gather; /* [count]; NULL: there is one patch, the k-th is k */
    int *place;     /* [count], increasing */
} patch_map;

typedef struct {
    patch_map a, b, out;
    ix_form *res;
    const ix_form_term *terms;
    const int *first; /* [rows of res + 1] */
    bool add;         /* to what is there */
    bool swapped;     /* a and b, against the terms */
    int span_len;     /* of a placed patch of b */
    size_t npatches;  /* of one row */
    size_t nchunks;
    size_t room; /* doubles for one chunk */
    double *work;
} product;

/* Item i of all: chunk c of the patches [lo, hi) of a row. */
typedef struct {
    size_t row, lo, hi;
    double *work;
} chunk;

static chunk chunk_of(const product *w, size_t i)
{
    size_t c = i % w->nchunks;

    return (chunk){i / w->nchunks, w->npatches * c / w->nchunks,
                   w->npatches * (c + 1) / w->nchunks, w->work + i * w->room};
}

/* How term k of a row meets what is there. */
static ix__into into_of(const product *w, const chunk *c, int k)
{
    if (!w->add && k == w->first[c->row] && w->terms[k].sign > 0)
        return IX__SET;
    return w->terms[k].sign > 0 ? IX__ADD : IX__SUB;
}

/* Whether zeros must come first: no term, or the first one is subtracted. */
static bool starts_empty(const product *w, const chunk *c)
{
    int k = w->first[c->row];

    return !w->add && (k == w->first[c->row + 1] || !(w->terms[k].sign > 0));
}

/* --- one direction -------------------------------------------------------- */

static void mul_spans(void *arg, size_t begin, size_t end)
{
    const product *w = arg;
    const ix_form *a = w->a.f, *b = w->b.f;
    int p = a->dirs[0].degree, q = b->dirs[0].degree;

    for (size_t i = begin; i < end; i++) {
        chunk c = chunk_of(w, i);
        double *out = w->res->c + c.row * w->res->n +
                      c.lo * (size_t)(p + q + 1);

        if (starts_empty(w, &c))
            memset(out, 0, (c.hi - c.lo) * (size_t)(p + q + 1) * sizeof *out);
        for (int k = w->first[c.row]; k < w->first[c.row + 1]; k++) {
            size_t ra = (size_t)w->terms[k].a, rb = (size_t)w->terms[k].b;

            ix__bern_conv_spans(c.hi - c.lo, p,
                                a->c + ra * a->n + c.lo * (size_t)(p + 1), q,
                                b->c + rb * b->n + c.lo * (size_t)(q + 1),
                                into_of(w, &c, k), c.work, out);
        }
    }
}

/* --- more directions ------------------------------------------------------ */

/* Offset of a patch's first coefficient. */
static size_t patch_base(const ix_form *f, size_t patch)
{
    size_t base = 0, stride = 1;

    for (int i = 0; i < f->ndirs; i++) {
        const ix_spans *sp = &f->dirs[i];
        size_t s = patch % (size_t)sp->nspans;

        patch /= (size_t)sp->nspans;
        base += s * ((size_t)sp->degree + 1) * stride;
        stride *= ix__spans_size(sp);
    }
    return base;
}

/* The product of one term on one patch, left in the returned part of work. */
static const double *mul_term(const product *w, const ix_form_term *t,
                              size_t patch, double *work)
{
    const ix_form *a = w->a.f, *b = w->b.f;
    size_t ra = (size_t)(w->swapped ? t->b : t->a);
    size_t rb = (size_t)(w->swapped ? t->a : t->b);
    const double *pa = a->c + ra * a->n + patch_base(a, patch);
    const double *pb = b->c + rb * b->n + patch_base(b, patch);
    double *va = work, *vb = va + w->a.count + IX__BERN_PAD;
    double *vo = vb + w->span_len + IX__BERN_PAD;

    for (size_t k = 0; w->a.gather && k < w->a.count; k++)
        va[k] = pa[w->a.gather[k]];
    for (size_t k = 0; k < w->b.count; k++)
        vb[w->b.place[k]] = pb[w->b.gather ? w->b.gather[k] : k];
    ix__bern_conv_sparse((int)w->a.count, w->a.gather ? va : pa, w->a.place,
                         w->span_len, vb, (int)w->out.count, vo);
    return vo;
}

static void scatter(const patch_map *m, const double *v, ix__into into,
                    double *out)
{
    const double sign = into == IX__SUB ? -1.0 : 1.0;

    if (!m->gather && into == IX__SET)
        memcpy(out, v, m->count * sizeof *out);
    else if (!m->gather)
        for (size_t k = 0; k < m->count; k++)
            out[k] += sign * v[k];
    else if (into == IX__SET)
        for (size_t k = 0; k < m->count; k++)
            out[m->gather[k]] = v[k];
    else
        for (size_t k = 0; k < m->count; k++)
            out[m->gather[k]] += sign * v[k];
}

static void zero_patch(const patch_map *m, double *out)
{
    for (size_t k = 0; k < m->count; k++)
        out[m->gather ? m->gather[k] : k] = 0.0;
}

static void mul_patches(void *arg, size_t begin, size_t end)
{
    const product *w = arg;

    for (size_t i = begin; i < end; i++) {
        chunk c = chunk_of(w, i);

        /* what is between and around the placed coefficients of b */
        memset(c.work + w->a.count, 0,
               ((size_t)w->span_len + 2 * IX__BERN_PAD) * sizeof *c.work);
        for (size_t p = c.lo; p < c.hi; p++) {
            double *out = w->res->c + c.row * w->res->n + patch_base(w->res, p);

            if (starts_empty(w, &c))
                zero_patch(&w->out, out);
            for (int k = w->first[c.row]; k < w->first[c.row + 1]; k++)
                scatter(&w->out, mul_term(w, &w->terms[k], p, c.work),
                        into_of(w, &c, k), out);
        }
    }
}

/* The next coefficient of a patch, at[ndirs] its place in each direction. */
static void advance(const ix_form *f, const size_t *stride, int *at,
                    size_t *from, size_t *to)
{
    size_t step = 1;

    for (int i = 0; i < f->ndirs; i++) {
        int d = f->dirs[i].degree;

        if (at[i] < d) {
            at[i]++;
            *from += step;
            *to += stride[i];
            return;
        }
        *from -= (size_t)d * step;
        *to -= (size_t)d * stride[i];
        at[i] = 0;
        step *= ix__spans_size(&f->dirs[i]);
    }
}

/* Fills the tables of f for patches whose direction i has stride stride[i] in
 * the product: gather but for a single patch, place for a factor. */
static ix_status map_patch(ix_ctx *ctx, const ix_form *f, const size_t *stride,
                           bool single, bool factor, patch_map *m)
{
    size_t from = 0, to = 0;
    int at[IX_MAX_DIRS] = {0};

    m->f = f;
    m->count = 1;
    for (int i = 0; i < f->ndirs; i++)
        m->count *= (size_t)f->dirs[i].degree + 1;
    if (m->count > INT_MAX / 2)
        return IX_FAIL(ctx, IX_ENOMEM, "a patch of %zu coefficients", m->count);
    m->gather = NULL;
    m->place = NULL;
    if (!single)
        IX_SCRATCH(ctx, m->gather, m->count);
    if (factor)
        IX_SCRATCH(ctx, m->place, m->count);
    for (size_t k = 0; (m->gather || factor) && k < m->count; k++) {
        if (m->gather)
            m->gather[k] = from;
        if (factor)
            m->place[k] = (int)to;
        advance(f, stride, at, &from, &to);
    }
    return IX_OK;
}

static ix_status map_patches(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                             product *w)
{
    size_t stride[IX_MAX_DIRS], s = 1;
    bool single = w->npatches == 1;

    for (int i = 0; i < a->ndirs; i++) {
        stride[i] = s;
        s *= (size_t)w->res->dirs[i].degree + 1;
    }
    IX_TRY(map_patch(ctx, w->res, stride, single, false, &w->out));
    IX_TRY(map_patch(ctx, a, stride, single, true, &w->a));
    IX_TRY(map_patch(ctx, b, stride, single, true, &w->b));
    if (w->b.count < w->a.count) { /* the dense factor is the larger one */
        patch_map t = w->a;

        w->a = w->b;
        w->b = t;
        w->swapped = true;
    }
    w->span_len = w->b.place[w->b.count - 1] + 1;
    w->room = w->a.count + (size_t)w->span_len + 3 * IX__BERN_PAD +
              (w->out.count + 15) / 16 * 16;
    return IX_OK;
}

/* --- any number ----------------------------------------------------------- */

/* Cost of one term on one patch in nanoseconds: a third of its products, and
 * some. */
static double patch_cost(const ix_form *a, const ix_form *b)
{
    double ns = 1.0;

    for (int i = 0; i < a->ndirs; i++)
        ns *= (a->dirs[i].degree + 1) * (b->dirs[i].degree + 1);
    return ns * (1.0 / 3) + 10;
}

/* Chunks of a row whose n patches cost ns each. */
static size_t chunks_of(size_t n, double ns)
{
    double c = (double)n * ns * (1.0 / CHUNK_NS);

    if (c > MAX_CHUNKS)
        c = MAX_CHUNKS;
    return c < 2.0 ? 1 : (size_t)c < n ? (size_t)c : n;
}

/* The terms of each row: terms[first[r]] .. terms[first[r + 1] - 1]. */
static ix_status index_terms(ix_ctx *ctx, int nrows, int nterms,
                             const ix_form_term *terms, const int **out)
{
    static const int single[2] = {0, 1};
    int *first, k = 0;

    *out = single;
    if (nrows == 1 && nterms == 1)
        return IX_OK;
    IX_SCRATCH(ctx, first, nrows + 1);
    for (int r = 0; r <= nrows; r++) {
        while (k < nterms && terms[k].row < r)
            k++;
        first[r] = k;
    }
    *out = first;
    return IX_OK;
}

/* The rows of res, of the product's degrees, from terms sorted by row. */
static ix_status multiply(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                          int nterms, const ix_form_term *terms, bool add,
                          ix_form *res)
{
    product w = {.res = res, .terms = terms, .add = add, .npatches = 1};
    int p = a->dirs[0].degree, q = b->dirs[0].degree;
    double ns = patch_cost(a, b) * nterms; /* a patch of all rows */
    size_t items;

    for (int i = 0; i < a->ndirs; i++)
        w.npatches *= (size_t)a->dirs[i].nspans;
    w.nchunks = w.npatches > 1 ? chunks_of(w.npatches, ns) : 1;
    items = w.nchunks * (size_t)res->nrows;
    IX_TRY(index_terms(ctx, res->nrows, nterms, terms, &w.first));
    w.a.f = a;
    w.b.f = b;
    w.room = (size_t)(p > q ? p : q) + 1 + 2 * IX__BERN_PAD;
    if (a->ndirs > 1)
        IX_TRY(map_patches(ctx, a, b, &w));
    IX_SCRATCH(ctx, w.work, items * w.room);
    ix__parallel(ctx, items, ns * (double)w.npatches / (double)items,
                 a->ndirs == 1 ? mul_spans : mul_patches, &w);
    return ix__poll(ctx);
}

static ix_status product_dirs(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                              ix_spans *dirs)
{
    IX_TRY(ix__form_meet(ctx, a, b, dirs));
    for (int i = 0; i < a->ndirs; i++)
        dirs[i].degree += b->dirs[i].degree;
    return IX_OK;
}

ix_status ix__form_bilinear(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                            int nrows, int nterms, const ix_form_term *terms,
                            ix_form *out)
{
    ix_spans dirs[IX_MAX_DIRS];
    ix_form r;

    IX_TRY(product_dirs(ctx, a, b, dirs));
    IX_TRY(ix__form_alloc(ctx, a->ndirs, dirs, nrows, &r));
    r.bezier = a->bezier & b->bezier;
    r.exp = a->exp + b->exp;
    IX_TRY(multiply(ctx, a, b, nterms, terms, false, &r));
    *out = r;
    return IX_OK;
}

/* Row r of the one times row r of the other, or its only row. */
static ix_status row_terms(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                           int sign, int *n, const ix_form_term **out)
{
    static const ix_form_term one[2] = {{0, 0, 0, 1}, {0, 0, 0, -1}};
    ix_form_term *t;

    *n = a->nrows > b->nrows ? a->nrows : b->nrows;
    assert(a->nrows == *n || a->nrows == 1);
    assert(b->nrows == *n || b->nrows == 1);
    *out = &one[sign < 0];
    if (*n == 1)
        return IX_OK;
    IX_SCRATCH(ctx, t, *n);
    for (int r = 0; r < *n; r++)
        t[r] = (ix_form_term){r, a->nrows > 1 ? r : 0, b->nrows > 1 ? r : 0,
                              sign};
    *out = t;
    return IX_OK;
}

ix_status ix__form_mul(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out)
{
    const ix_form_term *t;
    int n;

    IX_TRY(row_terms(ctx, a, b, 1, &n, &t));
    return ix__form_bilinear(ctx, a, b, n, n, t, out);
}

/* Whether a product with these directions can be added where it is. */
static bool fits(const ix_spans *dirs, int exp, const ix_form *acc)
{
    for (int i = 0; i < acc->ndirs; i++)
        if (dirs[i].degree != acc->dirs[i].degree)
            return false;
    return exp == acc->exp;
}

ix_status ix__form_mul_add(ix_ctx *ctx, const ix_form *a, int sign,
                           const ix_form *b, ix_form *acc)
{
    ix_spans dirs[IX_MAX_DIRS];
    const ix_form_term *terms;
    ix_form t, sum;
    int n;

    IX_TRY(product_dirs(ctx, a, b, dirs));
    if (!fits(dirs, a->exp + b->exp, acc)) {
        IX_TRY(ix__form_mul(ctx, a, b, &t));
        IX_TRY(ix__form_add(ctx, acc, sign, &t, &sum));
        *acc = sum;
        return IX_OK;
    }
    IX_TRY(row_terms(ctx, a, b, sign, &n, &terms));
    IX_TRY(multiply(ctx, a, b, n, terms, true, acc));
    acc->bezier &= a->bezier & b->bezier;
    return ix__form_narrow(ctx, dirs, acc);
}

static ix_status all_ones(ix_ctx *ctx, const ix_form *like, ix_form *out)
{
    double *one;

    IX_SCRATCH(ctx, one, like->nrows);
    for (int r = 0; r < like->nrows; r++)
        one[r] = 1.0;
    return ix__form_constant(ctx, like, like->nrows, one, out);
}

ix_status ix__form_power(ix_ctx *ctx, const ix_form *f, int k, ix_form *out)
{
    ix_form base = *f;
    bool any = false;

    if (k == 0)
        return all_ones(ctx, f, out);
    for (; k > 0; k >>= 1) {
        if ((k & 1) && any)
            IX_TRY(ix__form_mul(ctx, out, &base, out));
        if ((k & 1) && !any)
            *out = base;
        any |= k & 1;
        if (k > 1)
            IX_TRY(ix__form_mul(ctx, &base, &base, &base));
    }
    return IX_OK;
}
