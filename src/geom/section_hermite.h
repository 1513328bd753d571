/* section_hermite.h - Hermite surfaces across which a planar section runs. */
#ifndef GEOM_SECTION_HERMITE_H
#define GEOM_SECTION_HERMITE_H

#include "geom/vecs.h"

/* Functions of the parameter v along the surface in [0, 1], but the section of
 * the parameter u across it: coordinates x, y. */
typedef struct {
    ix__vec b[2], t[2]; /* position and derivative at the ends */
    ix__vec section, normal;
} ix__section_hermite;

/* H((1 + x(u)) / 2, v) + y(u) normal(v), H the cubic Hermite surface of b, t:
 * polynomial unless something has a weight. A weight that two of b, t, normal
 * have in common is not multiplied. Releases the pool. */
ix_status ix__section_hermite_make(ix_pool *q, const ix__section_hermite *h,
                                   ix_mv **out) IX_MUST_CHECK;

/* Err IX_EARG unless the section, a curve, goes from (-1, 0) to (1, 0) within
 * 1e-5. */
ix_status ix__section_check(ix_ctx *ctx, const ix_mv *section) IX_MUST_CHECK;

/* The same of the curves c[6] = {b0, b1, t0, t1, section, normal}, over
 * [0, 1]^2. Its ends are tangent to b_i', t_i where y' = 0. Err IX_EARG a curve
 * of more than 3 coordinates, the section; IX_EDOMAIN poles. */
ix_status ix__srf_section_hermite(ix_ctx *ctx, const ix_mv *const c[6],
                                  ix_mv **out) IX_MUST_CHECK;

#endif
