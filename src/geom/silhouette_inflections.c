/* silhouette_inflections.c - where a silhouette runs along the view. */
#include "geom/unit_solve.h"
#include "iritx/contour.h"

static ix_status check(ix_ctx *ctx, const ix_mv *s)
{
    if (s->ndirs != 2 || s->ncoords > 3 || s->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "surface of at most 3 is wanted",
                       s->ndirs, s->ncoords);
    return IX_OK;
}

/* With N = S_u x S_v the view is a S_u + b S_v where <N, view> = 0, a and b
 * being <view, S_v x N> and <view, N x S_u> over N^2; along it that function
 * changes by -II(view, view). */
ix_status ix_silhouette_inflections(ix_ctx *ctx, const ix_mv *s,
                                    const double view[3], ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = 100000};
    ix_pool q = {.ctx = ctx};
    const ix_mv *m, *f[2] = {NULL};
    double dom[2][2];

    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, s));
    if (!(view[0] * view[0] + view[1] * view[1] + view[2] * view[2] > 0))
        return IX_FAIL(ctx, IX_EARG, "a view direction of length 0");
    for (int d = 0; d < 2; d++)
        ix_mv_domain(s, d, dom[d]);
    m = ix__pool_unit(&q, s);
    if (m) {
        ix__vec x = ix__vec_of(&q, m), t[2], n;
        const ix_mv *a, *b;

        for (int d = 0; d < 2; d++)
            t[d] = ix__vec_tangent(&q, x, d);
        n = ix__vec_cross(&q, t[0], t[1]);
        f[0] = ix__vec_dot_const(&q, n, view);
        a = ix__vec_dot_const(&q, ix__vec_cross(&q, t[1], n), view);
        b = ix__vec_dot_const(&q, ix__vec_cross(&q, n, t[0]), view);
        if (f[0])
            f[1] = ix__sum0(&q, ix__prod0(&q, a, ix__pool_derive(&q, f[0], 0)),
                            ix__prod0(&q, b, ix__pool_derive(&q, f[0], 1)));
    }
    return ix__unit_solve(&q, 2, f, (const double(*)[2])dom, &o, out);
}
