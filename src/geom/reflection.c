/* reflection.c - see the header (Klass 1980; Maekawa 1998 for circles). */
#include "geom/reflection.h"

#include "geom/outer_mv.h"
#include "geom/vec3.h"
#include "geom/vecs.h"
#include "iritx/geom_srf.h"

/* R, and <N,N> in *nn. */
static ix__vec mirrored(ix_pool *q, const ix_mv *srf, const double v[3],
                        const ix_mv **nn)
{
    const ix_mv *along,
        *n = ix__pool_made(q,
                           ix_srf_normal_field(q->ctx, srf, ix__pool_room(q)));
    ix__vec f, r = {{NULL}, NULL};

    *nn = NULL;
    if (!n)
        return r;
    f = ix__vec_of(q, n);
    along = ix__vec_dot_const(q, f, v);
    f.w = NULL;
    *nn = ix__vec_dot(q, f, f);
    if (along)
        along = ix__pool_scale(q, along, -2);
    for (int k = 0; k < 3; k++) {
        const ix_mv *direct = NULL;

        if (*nn && (v[k] < 0 || v[k] > 0))
            direct = ix__pool_scale(q, *nn, v[k]);
        r.x[k] = ix__sum0(q, direct, ix__prod0(q, along, f.x[k]));
    }
    return r;
}

static ix_status give(ix_pool *q, const ix_mv *f, ix_mv **out)
{
    if (q->st == IX_OK && !f)
        q->st = IX_FAIL(q->ctx, IX_EDOMAIN, "all of the surface shows it");
    return ix__pool_give(q, f, out);
}

ix_status ix__reflected_line(ix_ctx *ctx, const ix_mv *srf,
                             const double view[3], const double p[3],
                             const double dir[3], ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    const ix_mv *nn, *sum = NULL;
    double v[3], d[3], plane[4];
    ix__vec r;

    *out = NULL;
    IX_TRY(ix__direction(ctx, "the direction of view", view, v));
    IX_TRY(ix__direction(ctx, "the line's direction", dir, d));
    r = mirrored(&q, srf, v, &nn);
    /* <R, d x (p - S)>: row k of d x . as an affine function of S */
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        const ix_mv *a = NULL;

        plane[k] = 0;
        plane[i] = d[j];
        plane[j] = -d[i];
        plane[3] = d[i] * p[j] - d[j] * p[i];
        if (q.st == IX_OK)
            a = ix__pool_made(
                &q, ix__affine_field(ctx, srf, plane, ix__pool_room(&q)));
        sum = ix__sum0(&q, sum, ix__prod0(&q, r.x[k], a));
    }
    return give(&q, sum, out);
}

ix_status ix__reflected_circle(ix_ctx *ctx, const ix_mv *srf,
                               const double view[3], const double axis[3],
                               double angle, ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    const ix_mv *nn, *f;
    double v[3], a[3], co = cos(angle);
    ix__vec r;

    *out = NULL;
    IX_TRY(ix__direction(ctx, "the direction of view", view, v));
    IX_TRY(ix__direction(ctx, "the circles' axis", axis, a));
    r = mirrored(&q, srf, v, &nn);
    f = ix__vec_dot_const(&q, r, a);
    if (nn && (co < 0 || co > 0))
        f = ix__diff0(&q, f, ix__pool_scale(&q, nn, co));
    return give(&q, f, out);
}
