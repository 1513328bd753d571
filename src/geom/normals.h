/* normals.h - what can be asked of a field of normals itself: three
 * coordinates, whose lengths do not matter. */
#ifndef GEOM_NORMALS_H
#define GEOM_NORMALS_H

#include "mv/mv.h"

/* Err IX_EARG unless s is a surface of three coordinates. */
ix_status ix__check_space_surface(ix_ctx *ctx, const ix_mv *s) IX_MUST_CHECK;

/* A cone that holds all its directions, as ix_srf_normal_cone. Err IX_EDOMAIN
 * it vanishes. */
ix_status ix__normals_cone(ix_ctx *ctx, const ix_mv *field, double axis[3],
                           double *half_angle) IX_MUST_CHECK;
/* As ix_isocline_field; view a unit vector. */
ix_status ix__normals_isocline(ix_ctx *ctx, const ix_mv *field,
                               const double view[3], double theta,
                               ix_mv **out) IX_MUST_CHECK;

#endif
