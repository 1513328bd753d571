/* transform_impl.h - what the parts of ix__obj_transform share. Matrices are
 * double[16], row-major, for row vectors, translation in the last row. */
#ifndef OBJECT_TRANSFORM_IMPL_H
#define OBJECT_TRANSFORM_IMPL_H

#include "object/object.h"

void ix__row_times(const double p[4], const double mat[16], double h[4]);
bool ix__is_affine(const double mat[16]); /* no perspective */
/* [p 1] M over its last coordinate; out may be p. Err IX_EDOMAIN it is 0. */
ix_status ix__move_point(ix_ctx *ctx, const double p[3], const double mat[16],
                         double out[3]) IX_MUST_CHECK;

/* New references, NULL on failure. */
ix_status ix__move_poly(ix_ctx *ctx, const ix_poly *p, const double mat[16],
                        ix_poly **out) IX_MUST_CHECK;
/* One geometry of an object of that type (ix__seq_item). */
ix_status ix__move_item(ix_ctx *ctx, ix_obj_type type, const void *item,
                        const double mat[16], const void **out) IX_MUST_CHECK;
void ix__move_ctlpt(const ix_ctlpt *p, const double mat[16], ix_ctlpt *out);

#endif
