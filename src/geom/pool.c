/* pool.c - intermediate results of formulas, released together. */
#include "geom/pool.h"

#include "geom/parts.h"
#include "sym/form.h"

enum { CAPACITY = sizeof((ix_pool *)0)->mv / sizeof(ix_mv *) };

void ix__pool_free(ix_pool *q)
{
    ix__mv_unref_all(q->ctx, q->mv, q->n);
    q->n = 0;
}

ix_status ix__pool_give(ix_pool *q, const ix_mv *f, ix_mv **out)
{
    *out = q->st == IX_OK ? ix_mv_ref(f) : NULL;
    ix__pool_free(q);
    return q->st;
}

ix_mv **ix__pool_room(ix_pool *q)
{
    return &q->mv[q->n];
}

const ix_mv *ix__pool_made(ix_pool *q, ix_status st)
{
    q->st = st;
    if (st != IX_OK)
        return NULL;
    /* two places stay free for functions that make a pair */
    if (q->n + 3 > CAPACITY)
        q->st = IX_FAIL(q->ctx, IX_EUNABLE, "a formula of %d terms", q->n);
    return q->mv[q->n++];
}

typedef ix_status (*binary_fn)(ix_ctx *, const ix_mv *, const ix_mv *,
                               const ix_sym_opts *, ix_mv **);

static const ix_mv *apply(ix_pool *q, binary_fn fn, const ix_mv *a,
                          const ix_mv *b)
{
    if (q->st != IX_OK)
        return NULL;
    return ix__pool_made(q, fn(q->ctx, a, b, NULL, ix__pool_room(q)));
}

const ix_mv *ix__pool_mul(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return apply(q, ix_sym_mul, a, b);
}

const ix_mv *ix__pool_add(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return apply(q, ix_sym_add, a, b);
}

const ix_mv *ix__pool_sub(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return apply(q, ix_sym_sub, a, b);
}

const ix_mv *ix__pool_scale(ix_pool *q, const ix_mv *a, double f)
{
    if (q->st != IX_OK)
        return NULL;
    return ix__pool_made(q, ix_sym_dot_vector(q->ctx, a, &f, ix__pool_room(q)));
}

const ix_mv *ix__pool_derive(ix_pool *q, const ix_mv *a, int dir)
{
    if (q->st != IX_OK)
        return NULL;
    return ix__pool_made(q,
                         ix_sym_derive(q->ctx, a, dir, NULL, ix__pool_room(q)));
}

static ix_status wronskian(ix_ctx *ctx, const ix_mv *a, const ix_mv *w, int dir,
                           ix_mv **out)
{
    const ix_mv *both[2] = {a, w};
    ix_form f[2], j;
    int d;

    IX_TRY(ix__forms_load(ctx, 2, both, NULL, f));
    d = f[0].dirs[dir].degree;
    IX_TRY(ix__form_jacobian(ctx, &f[0], &f[1], dir, &j));
    if (d > 0)
        ix__form_times(&j, 1 / (d * ix__spans_mean(&f[0].dirs[dir])));
    return ix__form_store(ctx, &j, false, NULL, out);
}

const ix_mv *ix__pool_wronskian(ix_pool *q, const ix_mv *a, const ix_mv *w,
                                int dir)
{
    ix_mark mk;
    ix_status st;

    if (q->st != IX_OK)
        return NULL;
    mk = ix__scratch_mark(q->ctx);
    st = wronskian(q->ctx, a, w, dir, ix__pool_room(q));
    ix__scratch_release(q->ctx, mk);
    return ix__pool_made(q, st);
}

const ix_mv *ix__pool_axis(ix_pool *q, const ix_mv *m, int k)
{
    if (q->st != IX_OK)
        return NULL;
    return ix__pool_made(q, ix_mv_scalar(q->ctx, m, k, ix__pool_room(q)));
}

const ix_mv *ix__pool_promote(ix_pool *q, const ix_mv *f, int n, int start)
{
    if (q->st != IX_OK)
        return NULL;
    if (f->ndirs == n)
        return f;
    return ix__pool_made(q,
                         ix_mv_promote(q->ctx, f, n, start, ix__pool_room(q)));
}
