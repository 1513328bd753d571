/* gap.c - see the header. */
#include "geom/gap.h"

#include "geom/vec3.h"
#include "geom/vecs.h"

/* (x_a w_b - x_b w_a, w_a w_b), without coordinates that both lack. */
static const ix_mv *fraction(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    ix__vec u = ix__vec_of(q, a), v = ix__vec_of(q, b);
    ix__vec d = ix__vec_between(q, u, v);
    const ix_mv *axis[4];
    int n = 1;

    axis[0] = u.w && v.w ? ix__pool_mul(q, u.w, v.w) : u.w ? u.w : v.w;
    for (int k = 0; k < 3; k++)
        if (d.x[k])
            axis[n++] = d.x[k];
    if (q->st != IX_OK)
        return NULL;
    return ix__pool_made(
        q, ix_mv_join_scalars(q->ctx, n, axis, true, ix__pool_room(q)));
}

ix_status ix__gap_bound(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        double *out)
{
    double lo[IX_MAX_COORDS] = {0}, hi[IX_MAX_COORDS] = {0}, far[3];
    ix_pool q = {.ctx = ctx};
    const ix_mv *d;
    ix_status st;

    d = a->rational || b->rational ? fraction(&q, a, b)
                                   : ix__pool_sub(&q, a, b);
    st = q.st;
    if (st == IX_OK)
        st = ix_mv_bbox(ctx, d, lo, hi);
    ix__pool_free(&q);
    for (int k = 0; k < 3; k++)
        far[k] = fmax(-lo[k], hi[k]);
    *out = ix__len3(far);
    return st;
}
