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
#define MAX_CHUNKS 256
#define CHUNK_NS   20000.0

/* One form's patches: where the k-th coefficient of a patch stands, counted
 * from its first, and where it goes in a patch of the product. */
typedef struct {
    const ix_form *f;
    size_t count;   /* coefficients of a patch */
    size_t *gather; /* [count] */
    int *place;     /* [count], increasing */
} patch_map;

typedef struct {
    patch_map a, b, out;
    ix_form *res;
    ix__into into;
    int span_len;    /* of a placed patch of b */
    size_t npatches; /* of one row */
    size_t nchunks;
    size_t room; /* doubles for one chunk */
    double *work;
} product;

/* --- one direction ---------------------------------------------------------
 */

static void mul_spans(void *arg, size_t begin, size_t end)
{
    const product *w = arg;
    const ix_form *a = w->a.f, *b = w->b.f;
    int p = a->dirs[0].degree, q = b->dirs[0].degree;
    size_t ns = (size_t)a->dirs[0].nspans;

    for (size_t i = begin; i < end; i++) {
        size_t row = i / w->nchunks, c = i % w->nchunks;
        size_t lo = ns * c / w->nchunks, hi = ns * (c + 1) / w->nchunks;
        size_t ra = a->nrows > 1 ? row : 0, rb = b->nrows > 1 ? row : 0;

        ix__bern_conv_spans(hi - lo, p, a->c + ra * a->n + lo * (size_t)(p + 1),
                            q, b->c + rb * b->n + lo * (size_t)(q + 1), w->into,
                            w->work + i * w->room,
                            w->res->c + row * w->res->n +
                                lo * (size_t)(p + q + 1));
    }
}

/* --- more directions --------------------------------------------------------
 */

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

static void mul_patch(const product *w, size_t row, size_t patch, double *work)
{
    const ix_form *a = w->a.f, *b = w->b.f;
    const double *pa = a->c + (a->nrows > 1 ? row : 0) * a->n;
    const double *pb = b->c + (b->nrows > 1 ? row : 0) * b->n;
    double *po = w->res->c + row * w->res->n + patch_base(w->res, patch);
    double *va = work, *vb = va + w->a.count + IX__BERN_PAD;
    double *vo = vb + w->span_len + IX__BERN_PAD;

    pa += patch_base(a, patch);
    pb += patch_base(b, patch);
    for (size_t k = 0; k < w->a.count; k++)
        va[k] = pa[w->a.gather[k]];
    for (size_t k = 0; k < w->b.count; k++)
        vb[w->b.place[k]] = pb[w->b.gather[k]];
    ix__bern_conv_sparse((int)w->a.count, va, w->a.place, w->span_len, vb,
                         (int)w->out.count, vo);
    if (w->into == IX__SET)
        for (size_t k = 0; k < w->out.count; k++)
            po[w->out.gather[k]] = vo[k];
    else if (w->into == IX__ADD)
        for (size_t k = 0; k < w->out.count; k++)
            po[w->out.gather[k]] += vo[k];
    else
        for (size_t k = 0; k < w->out.count; k++)
            po[w->out.gather[k]] -= vo[k];
}

static void mul_patches(void *arg, size_t begin, size_t end)
{
    const product *w = arg;

    for (size_t i = begin; i < end; i++) {
        size_t row = i / w->nchunks, c = i % w->nchunks;
        size_t lo = w->npatches * c / w->nchunks;
        size_t hi = w->npatches * (c + 1) / w->nchunks;

        memset(w->work + i * w->room, 0, w->room * sizeof *w->work);
        for (size_t p = lo; p < hi; p++)
            mul_patch(w, row, p, w->work + i * w->room);
    }
}

/* Fills the tables of f for patches whose direction i has stride stride[i] in
 * the product. */
static ix_status map_patch(ix_ctx *ctx, const ix_form *f, const size_t *stride,
                           patch_map *m)
{
    m->f = f;
    m->count = 1;
    for (int i = 0; i < f->ndirs; i++)
        m->count *= (size_t)f->dirs[i].degree + 1;
    if (m->count > INT_MAX / 2)
        return IX_FAIL(ctx, IX_ENOMEM, "a patch of %zu coefficients", m->count);
    IX_SCRATCH(ctx, m->gather, m->count);
    IX_SCRATCH(ctx, m->place, m->count);
    for (size_t k = 0; k < m->count; k++) {
        size_t rest = k, from = 0, to = 0, step = 1;

        for (int i = 0; i < f->ndirs; i++) {
            size_t n = (size_t)f->dirs[i].degree + 1, j = rest % n;

            rest /= n;
            from += j * step;
            to += j * stride[i];
            step *= ix__spans_size(&f->dirs[i]);
        }
        m->gather[k] = from;
        m->place[k] = (int)to;
    }
    return IX_OK;
}

static ix_status map_patches(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                             product *w)
{
    size_t stride[IX_MAX_DIRS], s = 1;

    for (int i = 0; i < a->ndirs; i++) {
        stride[i] = s;
        s *= (size_t)w->res->dirs[i].degree + 1;
    }
    IX_TRY(map_patch(ctx, w->res, stride, &w->out));
    IX_TRY(map_patch(ctx, a, stride, &w->a));
    IX_TRY(map_patch(ctx, b, stride, &w->b));
    if (w->b.count < w->a.count) { /* the dense factor is the larger one */
        patch_map t = w->a;

        w->a = w->b;
        w->b = t;
    }
    w->span_len = w->b.place[w->b.count - 1] + 1;
    w->room = w->a.count + (size_t)w->span_len + 3 * IX__BERN_PAD +
              (w->out.count + 15) / 16 * 16;
    return IX_OK;
}

/* --- both --------------------------------------------------------------------
 */

static size_t chunks_of(size_t n, double ns)
{
    double c = (double)n * ns / CHUNK_NS;

    if (c > MAX_CHUNKS)
        c = MAX_CHUNKS;
    return c < 2.0 ? 1 : (size_t)c < n ? (size_t)c : n;
}

/* res (=, +=, -=) a b; res has the degrees of the product. */
static ix_status multiply(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                          ix__into into, ix_form *res)
{
    product w = {.res = res, .into = into, .npatches = 1};
    double ns = 1.0; /* of one patch: a third of its products, and some */
    size_t items;

    assert(a->nrows == res->nrows || a->nrows == 1);
    assert(b->nrows == res->nrows || b->nrows == 1);
    for (int i = 0; i < a->ndirs; i++) {
        w.npatches *= (size_t)a->dirs[i].nspans;
        ns *= (a->dirs[i].degree + 1.0) * (b->dirs[i].degree + 1.0);
    }
    ns = ns / 3 + 10;
    w.nchunks = chunks_of(w.npatches, ns);
    items = w.nchunks * (size_t)res->nrows;
    if (a->ndirs == 1) {
        int p = a->dirs[0].degree, q = b->dirs[0].degree;

        w.a.f = a;
        w.b.f = b;
        w.room = (size_t)(p > q ? p : q) + 1 + 2 * IX__BERN_PAD;
    } else {
        IX_TRY(map_patches(ctx, a, b, &w));
    }
    IX_SCRATCH(ctx, w.work, items * w.room);
    ix__parallel(ctx, items, ns * (double)w.npatches / (double)w.nchunks,
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

ix_status ix__form_mul(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out)
{
    ix_spans dirs[IX_MAX_DIRS];
    ix_form r;

    IX_TRY(product_dirs(ctx, a, b, dirs));
    IX_TRY(ix__form_alloc(ctx, a->ndirs, dirs,
                          a->nrows > b->nrows ? a->nrows : b->nrows, &r));
    r.bezier = a->bezier & b->bezier;
    r.exp = a->exp + b->exp;
    IX_TRY(multiply(ctx, a, b, IX__SET, &r));
    *out = r;
    return IX_OK;
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
    ix_form t, sum;

    IX_TRY(product_dirs(ctx, a, b, dirs));
    if (!fits(dirs, a->exp + b->exp, acc)) {
        IX_TRY(ix__form_mul(ctx, a, b, &t));
        IX_TRY(ix__form_add(ctx, acc, sign, &t, &sum));
        *acc = sum;
        return IX_OK;
    }
    IX_TRY(multiply(ctx, a, b, sign > 0 ? IX__ADD : IX__SUB, acc));
    acc->bezier &= a->bezier & b->bezier;
    return ix__form_narrow(ctx, dirs, acc);
}

ix_status ix__form_power(ix_ctx *ctx, const ix_form *f, int k, ix_form *out)
{
    static const double one[IX_MAX_COORDS + 1] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
                                                  1, 1, 1, 1, 1, 1, 1, 1, 1};
    ix_form base = *f;
    bool any = false;

    for (; k > 0; k >>= 1) {
        if (k & 1) {
            if (any)
                IX_TRY(ix__form_mul(ctx, out, &base, out));
            else
                *out = base;
            any = true;
        }
        if (k > 1)
            IX_TRY(ix__form_mul(ctx, &base, &base, &base));
    }
    if (!any)
        return ix__form_constant(ctx, f, f->nrows, one, out);
    return IX_OK;
}
