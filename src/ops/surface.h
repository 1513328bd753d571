/* surface.h - a surface in its frame and the forms that its differential
 * geometry is made of.
 *
 * For S = p / w of degrees (d, e), indices u and v partial derivatives:
 *
 *   tangents  t_i = p_i w - p w_i           S_i = t_i / w^2
 *   plane     (m, c) = minors of the rows   m.X + c = 0 is the tangent plane,
 *             P, P_v, P_u, P = (p, w)       S_v x S_u = m / w^3
 *   first     g_ij = t_i.t_j                G_ij = g_ij / w^4
 *   second    b_ij = (m, c).P_ij            S_ij.(S_v x S_u) = b_ij / w^4
 *
 * and, for w = 1, the same with affine rows. Then, with M = |m|^2,
 *
 *   det G = M / w^6          K  = w^4 k / M^2,       k = b_11 b_22 - b_12^2
 *   2 H = w h / M^(3/2),     h  = g_11 b_22 + g_22 b_11 - 2 g_12 b_12
 *
 * None of these numerators has a factor w in general: det(g) has w^2, which is
 * why M is used in its place. All are in the lowest degree: leading
 * coefficients that cancel by algebra are taken out (docs/ops/srf_curvature).
 *
 *             polynomial             rational
 *   m         2d-1, 2e-1             3d-2, 3e-2
 *   b_11      3d-4, 3e-1             4d-6, 4e-2
 *   b_12      3d-3, 3e-3             4d-4, 4e-4
 *   k         6d-5, 6e-5             8d-8, 8e-8
 *   h         5d-3, 5e-3             8d-6, 8e-6 */
#ifndef OPS_SURFACE_H
#define OPS_SURFACE_H

#include "bern/bern.h"
#include "iritx/ops_srf.h"
#include "sym/form.h"

typedef struct {
    ix_frame frame;
    bool rational, centred;
    int degree[2];
    ix_form p, w; /* 3 rows; 1 row (constant 1 if polynomial) */
    ix_form hom;  /* p, w: 4 rows */
    ix_form t[2], plane, m, mm;
    ix_form g[3], b[3]; /* 11, 12, 22 */
    double band;        /* relative error of a product of the above */
} ix_surface;

/* Err IX_EARG not a surface with 2 or 3 coordinates; IX_EDOMAIN the normal
 * vanishes identically. Fills all but g and b. */
ix_status ix__surface_load(ix_ctx *ctx, const ix_mv *s,
                           ix_surface *out) IX_MUST_CHECK;
/* All but mm, with the point at[3] (may be NULL) as the origin if it is within
 * twice the box of the surface: then centred is set. */
ix_status ix__surface_load_plane(ix_ctx *ctx, const ix_mv *s, const double *at,
                                 ix_surface *out) IX_MUST_CHECK;
/* g and b; forms that are zero within their error become exactly zero. */
ix_status ix__surface_forms(ix_ctx *ctx, ix_surface *s) IX_MUST_CHECK;
ix_status ix__surface_k(ix_ctx *ctx, const ix_surface *s,
                        ix_form *k) IX_MUST_CHECK;
ix_status ix__surface_h(ix_ctx *ctx, const ix_surface *s,
                        ix_form *h) IX_MUST_CHECK;
/* t_v b_11 - t_u b_12 and t_v b_12 - t_u b_22: m x m_u and m x m_v up to their
 * sign, so that the third form is their products over M^2. */
ix_status ix__surface_gauss_map(ix_ctx *ctx, const ix_surface *s,
                                ix_form out[2]) IX_MUST_CHECK;
bool ix__form_is_zero(const ix_form *f);
void ix__form_clear(ix_form *f);

/* --- results ---------------------------------------------------------------
 */

/* x (over den unless NULL) times 2^exp as a multivariate; weights largest in
 * [1/2, 1), mostly positive. */
typedef struct {
    const ix_form *den, *x;
    int exp;
    const ix_frame *place; /* NULL, or: x is a place of this frame */
} ix__field;
ix_status ix__field_store(ix_ctx *ctx, const ix__field *f, const ix_op_opts *o,
                          ix_mv **out) IX_MUST_CHECK;

/* --- points ------------------------------------------------------------------
 */

/* Derivatives of the projected surface, by the quotient rule. */
typedef struct {
    double s[3], su[3], sv[3], suu[3], suv[3], svv[3];
    double n[3];       /* S_v x S_u */
    double g[3], b[3]; /* G_ij, and S_ij.n with n of length 1 */
} ix_srf_jet;
/* Err IX_EDOMAIN outside, at a pole, no normal. */
ix_status ix__srf_jet(ix_ctx *ctx, const ix_mv *s, double u, double v,
                      ix_srf_jet *out) IX_MUST_CHECK;

/* What a result should be at a point: value[ncoords], by derivatives; NaN
 * where it is not defined. */
typedef void (*ix__srf_value)(const ix_srf_jet *j, int which, double *value);
/* The residual of a report: largest deviation of out from fn on a 5 x 5 grid,
 * relative to the largest value, or 1 / size^2 of the surface (scalars: squares
 * of curvatures), or its size (places). */
ix_status ix__srf_measure(ix_ctx *ctx, const ix_mv *s, const ix_mv *out,
                          ix__srf_value fn, int which, const ix_op_opts *o,
                          ix_report *rep) IX_MUST_CHECK;

#endif
