/* lift.h - curves lifted to spheres.
 *
 * The lift of a rational curve P = (p, w), p in m coordinates, is
 * L = (w p, w^2, |p|^2), m + 2 rows of degree 2d: the sphere a.x + b + e|x|^2
 * = 0 meets the curve where L.(a, b, e) = 0. Contact is linear in L and its
 * partials. For polynomial curves (w = 1) the affine rows p, 1, |p|^2 of
 * degrees d, 0, 2d give lower degrees. */
#ifndef OPS_LIFT_H
#define OPS_LIFT_H

#include "sym/form.h"

/* The rational lift of a form with rows w, p (rational) or p. */
ix_status ix__lift(ix_ctx *ctx, const ix_form *f, bool rational,
                   ix_form *out) IX_MUST_CHECK;

/* The ten 2 x 2 minors of the lift of a space curve and its derivative, in the
 * order of ix__lift_minor. Degree 3d - 1 for polynomial curves (minors of L,
 * h0 L'), 4d - 2 for rational ones (minors of L_U, L_V); continuity one less
 * than the curve's. */
ix_status ix__lift_tangents(ix_ctx *ctx, const ix_form *f, bool rational,
                            ix_form *out) IX_MUST_CHECK;

/* Of a rational curve those of L and h0 L', in their formal degree 4d - 1: the
 * minors above (times -1 / 2d) before their leading terms are seen to cancel.
 */
ix_status ix__lift_formal(ix_ctx *ctx, const ix_form *f,
                          ix_form *out) IX_MUST_CHECK;

/* The minor on columns i < j of (x, y, z, 1, q): its row among yz zx xy x1 y1
 * z1 xq yq zq 1q, and the sign that it has there. */
int ix__lift_minor(int i, int j, int *sign);

/* The ten minors (rows 0 .. 9 of m) of the curve moved by a, in place: x + a,
 * q + 2 a.x + |a|^2. Sums without cancellation: minors that were computed next
 * to the curve keep their relative accuracy however far it is moved. */
void ix__lift_move(ix_form *m, const double a[3]);

#endif
