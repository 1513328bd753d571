/* sphere_bisector.c - bisectors on the unit sphere: directions.
 *
 * A point P of the sphere is equally far from the points Q and C if P.(Q - C) =
 * 0, and C is the foot of a great circle through P if P.C' = 0. */
#include <limits.h>

#include "iritx/ops_bisect.h"
#include "ops/pt_crv.h"

/* (Q - C) x C' as points of the plane z = 1: weight and z are one. */
static ix_status point_curve(ix_ctx *ctx, const ix_mv *crv, const double q[3],
                             const ix_op_opts *o, ix_mv **out)
{
    ix_sym_opts so = {o ? o->max_cont : INT_MAX, 0};
    ix_form n, z, all;
    const ix_form *parts[2] = {&z, &n};
    double big, size, sum = 0.0;
    ix_pt_crv c;

    IX_TRY(ix__pt_crv_load(ctx, crv, IX__CURVE_SPACE, q, 0.5, true, &c));
    IX_TRY(ix__pt_crv_ruling(ctx, &c, &n));
    z = ix__form_rows(&n, 2, 1);
    IX_TRY(ix__form_bound(ctx, &z, &big));
    IX_TRY(ix__form_bound(ctx, &n, &size));
    if (!(big > 1e-12 * size))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the bisector is at infinity in the plane z = 1: its "
                       "directions have z below %.3g of their length",
                       big / size);
    IX_TRY(ix__form_join(ctx, 2, parts, &all));
    for (size_t i = 0; i < all.n; i++)
        sum += all.c[i];
    ix__form_times(&all, sum < 0.0 ? -1.0 : 1.0);
    return ix__form_store(ctx, &all, true, &so, out);
}

ix_status ix_sphere_bisector_point(ix_ctx *ctx, const ix_mv *crv,
                                   const double q[3], const ix_op_opts *o,
                                   ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, point_curve(ctx, crv, q, o, out));
}
