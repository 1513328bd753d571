/* ops_srf.h - differential geometry of surfaces; duals and orthotomics.
 *
 * S is a surface of 2 or 3 coordinates, polynomial or rational, any basis,
 * any continuity (results have jumps where second derivatives have them);
 * borrowed. n = S_v x S_u, not normalised. Degrees are those of IX_FORM_MINIMAL
 * for input of degree d in a direction (polynomial / rational); there are no
 * published ones, so IX_FORM_PUBLISHED is the same. IX_FORM_NAIVE computes the
 * formulas with fractions by the quotient rule (degrees: docs/ops); numerators
 * of rational surfaces are then rational. IX_FORM_IRIT does the same with C0
 * joins and the few steps that IRIT 11 does otherwise.
 *
 * Common errors, not repeated below:
 *   IX_EARG    not a surface, not 2 or 3 coordinates
 *   IX_EDOMAIN the normal vanishes identically; all weights are zero; a number
 *              overflows
 *   IX_EUNABLE an order above IX_MAX_ORDER
 * rep (may be NULL) gets the largest deviation from the value by derivatives
 * on a 5 x 5 grid, relative to the largest value or what the size of the
 * surface makes of one. */
#ifndef IRITX_OPS_SRF_H
#define IRITX_OPS_SRF_H

#include "iritx/geom.h"
#include "iritx/ops.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- fundamental forms and curvature
 * ------------------------------------------ */

/* The fundamental form k = 1, 2, 3: coefficients 11, 12, 22 as scalars.
 *
 *   1  G_ij = S_i.S_j
 *   2  L_ij = S_ij.n, times |n| what is usual
 *   3  m_i.m_j, m = n / |n|
 *
 * Out   out[3]  E1 for polynomial input and k < 3, else P1; new references
 * Err   IX_EARG k */
ix_status ix_srf_forms(ix_ctx *ctx, const ix_mv *s, int k, const ix_op_opts *o,
                       ix_mv *out[3]) IX_MUST_CHECK;

/* The Gauss curvature K, P1: degree 8d-4 / 12d-8. numerator: only k with K =
 * w^4 k / |n w^3|^4, scaled so that its largest control value is 1 or -1, E1:
 * 6d-5 / 8d-8 (naive and irit: P1 for rational input). A surface that is
 * developable within rounding gives exactly 0. */
ix_status ix_srf_gauss(ix_ctx *ctx, const ix_mv *s, bool numerator,
                       const ix_op_opts *o, ix_report *rep,
                       ix_mv **out) IX_MUST_CHECK;

/* The squared mean curvature H^2, P1 (H itself is not rational): degree 12d-6 /
 * 18d-12. numerator: G11 L22 + G22 L11 - 2 G12 L12 (times a power of w),
 * scaled as above, E1: 5d-3 / 8d-6. */
ix_status ix_srf_mean(ix_ctx *ctx, const ix_mv *s, bool numerator,
                      const ix_op_opts *o, ix_report *rep,
                      ix_mv **out) IX_MUST_CHECK;

typedef enum {
    IX_SRF_ALONG_U, /* squared normal curvature of the curves v = const */
    IX_SRF_ALONG_V, /* of the curves u = const */
    IX_SRF_TOTAL    /* k1^2 + k2^2 */
} ix_srf_curvature_kind;
/* A square of curvature, P1. TOTAL 12d-6 / 18d-12, ALONG_U 8d-6 / 14d-12 in u
 * and 8d-2 / 14d-4 in v. */
ix_status ix_srf_curvature(ix_ctx *ctx, const ix_mv *s,
                           ix_srf_curvature_kind kind, const ix_op_opts *o,
                           ix_report *rep, ix_mv **out) IX_MUST_CHECK;

/* --- centres
 * ------------------------------------------------------------------ */

/* The mean evolute S + n / (2 H |n|), H the mean curvature for that normal, P3:
 * degree 6d-3 / 9d-6. Poles where H = 0.
 * Err   IX_EDOMAIN H is zero everywhere: a plane or minimal surface */
ix_status ix_srf_evolute(ix_ctx *ctx, const ix_mv *s, const ix_op_opts *o,
                         ix_report *rep, ix_mv **out) IX_MUST_CHECK;

/* S + n / (kn |n|), kn the normal curvature of the isoparametric curves along
 * dir (0: u varies), P3: degree 4d-3 / 7d-6 in direction dir, 4d-1 / 7d-2 in
 * the other. Err IX_EARG dir; IX_EDOMAIN kn is zero everywhere */
ix_status ix_srf_focal(ix_ctx *ctx, const ix_mv *s, int dir,
                       const ix_op_opts *o, ix_report *rep,
                       ix_mv **out) IX_MUST_CHECK;

/* --- special curves and points
 * -------------------------------------------------- */

/* Where K = 0, in the parameters of S; tol as in ix_curves_opts. Freed with
 * ix_solution_curves_free. Err IX_EDOMAIN K is zero everywhere. */
ix_status ix_srf_parabolic(ix_ctx *ctx, const ix_mv *s, double tol,
                           ix_solution_curves *out) IX_MUST_CHECK;

/* Where all normal curvatures agree, in the parameters of S: the second form is
 * a multiple of the first, two equations that are regular at a generic umbilic,
 * so that it is certified. Freed with ix_solutions_free.
 * Err   IX_EDOMAIN every point is one: a plane or sphere */
ix_status ix_srf_umbilics(ix_ctx *ctx, const ix_mv *s, const ix_solve_opts *o,
                          ix_solutions *out) IX_MUST_CHECK;

/* Flecnodal curves: where a tangent line meets S four times at least (along an
 * asymptotic direction it meets it three times). Curves of (u, v, a, b): the
 * line's direction is a S_u + b S_v, a^2 + b^2 = 1; it does not jump along a
 * curve and may come back with the other sign where a loop is closed. tol as in
 * ix_curves_opts, of each Bezier patch. Plane and ruled patches, where such
 * lines are everywhere, are left out. Freed with ix_solution_curves_free.
 * Err   IX_EARG    not 3 coordinates; power basis
 *       IX_EDOMAIN all patches are plane or ruled
 * Num   vertices are on the curve to rounding; every curve is found (see
 *       ix_solve_curves), unless complete says that the search was stopped
 * Src   docs/ops/srf_lines.md; Salmon 1882, art. 588; Petitjean, Ponce &
 *       Kriegman 1992 */
ix_status ix_srf_flecnodal(ix_ctx *ctx, const ix_mv *s, double tol,
                           ix_solution_curves *out) IX_MUST_CHECK;
/* Where a tangent line meets S five times at least, isolated points of
 * flecnodal curves: solutions (u, v, a, b) as above, freed with
 * ix_solutions_free. Err as above. */
ix_status ix_srf_flecnodal_points(ix_ctx *ctx, const ix_mv *s,
                                  ix_solutions *out) IX_MUST_CHECK;

/* Directions of view (parallel rays) along which the outline of a transparent
 * surface changes by what happens at one of its points: curves on the unit
 * sphere, each with its antipode. They are part of the boundaries of the aspect
 * graph's cells; the other part, events of two and three points that lie one
 * behind the other, is not among them.
 *
 *   parabolic    asymptotic directions of parabolic points: lips, beak-to-beak
 *   swallowtail  directions of flecnodal curves
 *
 * tol: distance of the polylines from the curves on the sphere, and as in
 * ix_curves_opts; 0: 1e-4. Freed with ix_aspects_free.
 * Err   IX_EARG    not 3 coordinates; power basis
 *       IX_EDOMAIN a developable or ruled surface
 * Num   vertices are directions at points of the curve, to rounding; where the
 *       surface has no normal, or is flat, curves are cut
 * Src   Koenderink & van Doorn 1976; Kergosien 1981; Petitjean, Ponce &
 *       Kriegman 1992 */
typedef struct {
    ix_lines parabolic, swallowtail;
    bool complete; /* false: a search was stopped, see ix_curves_opts */
} ix_aspects;
ix_status ix_srf_aspects(ix_ctx *ctx, const ix_mv *s, double tol,
                         ix_aspects *out) IX_MUST_CHECK;
void ix_aspects_free(ix_ctx *ctx, ix_aspects *a);

/* Where the radial curvature is zero: the normal curvature in the direction of
 * w, the projection of view (parallel rays) on the tangent plane. Curves of (u,
 * v, a, b), w along a S_u + b S_v, a^2 + b^2 = 1; where the view is along the
 * normal (many curves may meet there) the direction is that of the vertex
 * before. tol as in ix_curves_opts. Freed with ix_solution_curves_free.
 * Err   IX_EARG    view is 0
 *       IX_EDOMAIN it is zero everywhere
 * Src   Koenderink 1984; DeCarlo, Finkelstein, Rusinkiewicz & Santella 2003 */
ix_status ix_srf_radial(ix_ctx *ctx, const ix_mv *s, const double view[3],
                        double tol, ix_solution_curves *out) IX_MUST_CHECK;
/* A scalar field over the parameters of S, polynomial: a positive multiple of
 * the radial curvature for the normal n. Err as above, but none where it is
 * zero everywhere. */
ix_status ix_srf_radial_field(ix_ctx *ctx, const ix_mv *s, const double view[3],
                              ix_mv **out) IX_MUST_CHECK;

/* Principal curvatures k[0] >= k[1] with respect to n, and their directions:
 * ab[i] with ab[i][0] S_u + ab[i][1] S_v = dir[i] of length 1. At an umbilic
 * the first direction is that of S_u.
 * Err   IX_EDOMAIN (u, v) outside, a pole, no normal there */
typedef struct {
    double k[2], ab[2][2], dir[2][3];
} ix_principal;
ix_status ix_srf_principal(ix_ctx *ctx, const ix_mv *s, double u, double v,
                           ix_principal *out) IX_MUST_CHECK;

/* Directions of normal curvature 0: *n = 2, 1 (parabolic) or 0; at a flat point
 * 0. ab, dir as above; k is 0. Err as above. */
ix_status ix_srf_asymptotic(ix_ctx *ctx, const ix_mv *s, double u, double v,
                            int *n, ix_principal *out) IX_MUST_CHECK;

/* --- duals
 * ---------------------------------------------------------------------- */

/* The dual of a planar curve or a surface: the point (A, B) / C for the tangent
 * line A x + B y + C = 0, (A, B, C) / D for the tangent plane. The dual of the
 * dual is the original.
 *
 * In    m     curve: coordinates after the second are not looked at
 * Out   *out  curve P2 (P3 with z = 0 for 3 coordinates), degree 2d-2 / 2d-2
 *             (naive 2d-1 / 5d, irit 2d-1 / 3d); surface P3, 3d-2 / 3d-2 (3d-1
 *             / 9d, 3d-1 / 5d). Tangents through the origin are poles
 * Err   IX_EARG    neither curve nor surface, one coordinate
 *       IX_EDOMAIN all tangents pass through the origin; the curve is a point
 */
ix_status ix_duality(ix_ctx *ctx, const ix_mv *m, const ix_op_opts *o,
                     ix_mv **out) IX_MUST_CHECK;

/* The k-orthotomic of a curve or surface with respect to p: P + k times the way
 * to the foot of its perpendicular on the tangent. k = 2: mirror images of p in
 * the tangents, k = 1: the pedal.
 *
 * In    p     [3]; of a curve the first two count
 * Out   *out  curve: 2 or 3 coordinates as m, 3d-3 / 4d-4 (naive and irit 3d-2
 * / 9d); surface: P3, 5d-3 / 6d-4 (5d-2 / 17d) Err   as above, for the point p
 * in place of the origin without the poles */
ix_status ix_orthotomic(ix_ctx *ctx, const ix_mv *m, const double p[3],
                        double k, const ix_op_opts *o,
                        ix_mv **out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
