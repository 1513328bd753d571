/* matrix.h - 4 x 4 matrices that act on row vectors.
 *
 * double[16], row-major: [x y z 1] M, translation in the last row, so the left
 * factor of a product is applied first. Angles are degrees unless a name says
 * otherwise. Functions with an output may be given one of their inputs. */
#ifndef GEOM_MATRIX_H
#define GEOM_MATRIX_H

#include "base/ctx.h"

void ix__mat_identity(double m[16]);
void ix__mat_translate(const double v[3], double m[16]);
void ix__mat_scale(const double v[3], double m[16]);
/* Right-handed rotation about x, y, z (axis 0, 1, 2). */
void ix__mat_rotate(int axis, double deg, double m[16]);
void ix__mat_mul(const double a[16], const double b[16], double out[16]);
/* Sine and cosine of degrees: the angle is reduced exactly, so multiples of
 * 90 give 0 and +-1. NaN for infinities. */
void ix__sincos_deg(double deg, double *s, double *c);

/* out = M^-1 by elimination with full pivoting. False (out untouched) if M is
 * singular: a pivot below 16 eps times the largest entry left of its column
 * and row scaling, or not finite. */
bool ix__mat_inverse(const double m[16], double out[16]);
double ix__mat_det(const double m[16]);
/* The point [p 1] M, divided by its last coordinate; false if that is 0. */
bool ix__mat_point(const double p[3], const double m[16], double out[3]);

/* Rotations by a direction; lengths do not matter. Err IX_EARG: a direction
 * of length zero (or not finite). */
ix_status ix__mat_rotate_about(ix_ctx *ctx, const double axis[3], double deg,
                               double m[16]) IX_MUST_CHECK;
/* The least rotation that takes direction a to direction b; half a turn, when
 * they are opposite, goes about an axis perpendicular to a. */
ix_status ix__mat_turn(ix_ctx *ctx, const double a[3], const double b[3],
                       double m[16]) IX_MUST_CHECK;
/* Takes +z to dir, and x to the part of dir2 perpendicular to it. Err IX_EARG
 * also if the two are parallel. */
ix_status ix__mat_frame(ix_ctx *ctx, const double dir[3], const double dir2[3],
                        double m[16]) IX_MUST_CHECK;

/* Projection onto the plane A x + B y + C z + D = 0 from the homogeneous eye
 * (x, y, z, w): w = 0 is parallel along (x, y, z). Points p with weight 1:
 *
 *   p' = p - (p.n) / (eye.n) eye,   n = (A, B, C, D)
 *
 * Err IX_EDOMAIN the eye lies in the plane. */
ix_status ix__mat_project(ix_ctx *ctx, const double plane[4],
                          const double eye[4], double m[16]) IX_MUST_CHECK;
/* Mirror at a plane, wherever it lies. Err IX_EARG normal of length zero. */
ix_status ix__mat_reflect(ix_ctx *ctx, const double plane[4],
                          double m[16]) IX_MUST_CHECK;
/* The rigid map of an eye at pos that looks along dir: pos goes to the
 * origin, dir to -z, the part of up perpendicular to dir to +y. */
ix_status ix__mat_view(ix_ctx *ctx, const double pos[3], const double dir[3],
                       const double up[3], double m[16]) IX_MUST_CHECK;
/* The affine map that takes the triangle p to the equilateral triangle
 * (-h, -1/2), (h, -1/2), (0, 1), h = sqrt(3)/2, and its unit normal to +z.
 * Err IX_EDOMAIN the points are on one line. */
ix_status ix__mat_equilateral(ix_ctx *ctx, double p[3][3],
                              double m[16]) IX_MUST_CHECK;

/* M = R S T, or S R T when only the rows of its linear part are orthogonal:
 * S diagonal scale, R rotation, T translation. A mirroring M gives an odd
 * number of negative scales, chosen so that R turns least.
 * Err IX_EDOMAIN M has shear or perspective, or a scale is zero; the message
 * has the angle. Num: columns count as orthogonal within 1e-4, so matrices
 * written with 5 digits pass. */
typedef struct {
    double scale[3], trans[3], rot[16];
} ix__mat_parts;
ix_status ix__mat_decompose(ix_ctx *ctx, const double m[16],
                            ix__mat_parts *out) IX_MUST_CHECK;
/* M = Rx(a) Ry(b) Rz(c) S T with uniform S: v = a, b, c in radians, scale,
 * translation x, y, z. Err as above, and scales that differ. */
ix_status ix__mat_to_euler(ix_ctx *ctx, const double m[16],
                           double v[7]) IX_MUST_CHECK;
void ix__mat_from_euler(const double v[7], double m[16]);

#endif
