/* contact.h - planes, motions and rays that touch several surfaces, as systems
 * in the parameters of all of them. Surfaces are Bezier or B-spline with at
 * most 3 coordinates; else IX_EARG. IX_EDOMAIN: a condition holds everywhere
 * (two planes, say). Where normals vanish or surfaces share a patch there are
 * solutions that are not isolated: complete is false. */
#ifndef GEOM_CONTACT_H
#define GEOM_CONTACT_H

#include "iritx/solve.h"

/* Planes that touch two surfaces: curves (u1, v1, u2, v2);
 * S1_u.N2 = S1_v.N2 = (S1 - S2).N2 = 0. */
ix_status ix__srf_bitangents(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             double tol, ix_solution_curves *out) IX_MUST_CHECK;

/* Planes that touch three surfaces: (u1, v1, u2, v2, u3, v3). */
ix_status ix__srf_tritangents(ix_ctx *ctx, const ix_mv *const s[3],
                              ix_solutions *out) IX_MUST_CHECK;

/* Where a touches b moved by mov(t) and scaled before by scl(t) (either may be
 * NULL): (u1, v1, u2, v2, t), t in the domain of the one given.
 * Err IX_EARG neither given, or no curves, or their domains differ. */
ix_status ix__srf_contacts(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           const ix_mv *mov, const ix_mv *scl,
                           ix_solutions *out) IX_MUST_CHECK;

/* Lines through points of s along its normals (dir NULL) or along dir that
 * touch the surface check: curves (u, v, r, t); that the point is on the
 * positive side is not looked at. Err IX_EARG dir is 0. */
ix_status ix__srf_access(ix_ctx *ctx, const ix_mv *s, const double *dir,
                         const ix_mv *check, double tol,
                         ix_solution_curves *out) IX_MUST_CHECK;

/* Feet of the perpendiculars from a curve's points to a surface:
 * (C - S).S_u = (C - S).S_v = 0, curves (t, u, v). */
ix_status ix__crv_srf_feet(ix_ctx *ctx, const ix_mv *c, const ix_mv *s,
                           double tol, ix_solution_curves *out) IX_MUST_CHECK;

#endif
