/* prim.h - primitives as surfaces, and the bisectors that do not reduce to a
 * point and something. */
#ifndef OPS_PRIM_H
#define OPS_PRIM_H

#include "iritx/ops_prim.h"

/* Right-handed axes with z along p->dir (unit vectors). */
typedef struct {
    double x[3], y[3], z[3];
} ix_prim_axes;
/* Err IX_EARG no direction. */
ix_status ix__prim_axes(ix_ctx *ctx, const ix_prim *p,
                        ix_prim_axes *out) IX_MUST_CHECK;
/* A surface of revolution (planes: a square), as far as size. */
ix_status ix__prim_surface(ix_ctx *ctx, const ix_prim *p, double size,
                           ix_mv **out) IX_MUST_CHECK;

/* The cone of the points with equal angles to the half line from apex along u
 * and the cone around n with half the angle (degrees): both nappes. */
ix_status ix__prim_apex(ix_ctx *ctx, const double apex[3], const double n[3],
                        double degrees, const double u[3], double size,
                        ix_mv *out[2]) IX_MUST_CHECK;
/* Cylinders and cones: equal distances from tangent planes, over [0, 1]^2. */
ix_status ix__prim_tangents(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                            ix_mv **out) IX_MUST_CHECK;

#endif
