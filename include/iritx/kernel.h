/* kernel.h - from where the whole of a closed planar curve, or of a closed
 * surface, is seen.
 *
 * A point p is in the kernel of the region inside C if it is on the inner side
 * of every tangent line; the lines themselves are the zero set of
 *
 *   F(x, y, t) = (C(t) - (x, y)) x R C'(t)
 *
 * R turning by gamma (0 for the kernel itself): the projection of F = 0 to the
 * plane covers the complement of the kernel. */
#ifndef IRITX_KERNEL_H
#define IRITX_KERNEL_H

#include "iritx/geom.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* F as a scalar of three directions: x and y linear on [0, 1] over the curve's
 * box enlarged by 1 on all sides (lo, hi: its corners), t on the curve's
 * domain. Polynomial; of a rational curve the numerator.
 *
 * In    gamma  radians
 * Err   IX_EARG not a curve of two or more coordinates, power basis;
 *       IX_EDOMAIN poles */
ix_status ix_crv_kernel_field(ix_ctx *ctx, const ix_mv *crv, double gamma,
                              double lo[2], double hi[2],
                              ix_mv **out) IX_MUST_CHECK;

/* F = 0 as quadrangles between `lines` tangent lines, even in t on each span
 * and cut to the box: four vertices (x, y, t) each, on F = 0. Lines that miss
 * the box make none. Err as above, lines < 2. */
ix_status ix_crv_kernel_sheet(ix_ctx *ctx, const ix_mv *crv, double gamma,
                              int lines, ix_lines *out) IX_MUST_CHECK;

/* Where F = dF/dt = 0, the envelope of the lines: solution curves (x, y, t) in
 * the directions of F; tol as in ix_curves_opts. */
ix_status ix_crv_kernel_envelope(ix_ctx *ctx, const ix_mv *crv, double gamma,
                                 double tol,
                                 ix_solution_curves *out) IX_MUST_CHECK;

/* The surface C(t) + r (C'(t) + g J C'(t)), J a quarter turn clockwise, g = tan
 * gamma, -extent <= r <= extent, at the height |g|. Err also IX_EARG extent not
 * positive, gamma a right angle. */
ix_status ix_crv_kernel_surface(ix_ctx *ctx, const ix_mv *crv, double gamma,
                                double extent, ix_mv **out) IX_MUST_CHECK;

/* The kernel of a closed surface, the points that are behind all of its tangent
 * planes and so see all of it from inside, as a convex polyhedron that holds
 * it: the surface's box, cut by tangent planes at `samples` even parameters of
 * each patch and direction, ends included.
 *
 * In    srf     in space; that it is closed is taken for granted: the sign of
 *               its volume tells where inside is
 *       samples 1 .. 1000
 *       skip    of the planes every skip-th in both directions cut first; the
 *               others then meet a small polyhedron. The result is the same
 * Out   *out    its faces, counter-clockwise from outside; none if no point is
 *               behind all planes: then there is no kernel
 *       *error  farthest that a vertex is in front of a tangent plane in the
 *               middle between samples; falls with the square of the step
 * Err   IX_EARG not such a surface, power basis, counts; IX_EDOMAIN poles */
ix_status ix_srf_kernel(ix_ctx *ctx, const ix_mv *srf, int samples, int skip,
                        double *error, ix_lines *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
