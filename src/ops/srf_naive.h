/* srf_naive.h - the differential geometry of a surface as a straightforward
 * system computes it: derivatives by the quotient rule, products and sums of
 * fractions, common factors and vanishing leading terms left in. Degrees come
 * out of this arithmetic (docs/ops/srf_curvature). */
#ifndef OPS_SRF_NAIVE_H
#define OPS_SRF_NAIVE_H

#include "ops/ratio.h"
#include "ops/surface.h"

/* S, n = S_v x S_u, G_ij = S_i.S_j and L_ij = S_ij.n for 11, 12, 22. A
 * coefficient that is zero by the error bounds of the surface's forms is zero
 * here, too. */
typedef struct {
    const ix_surface *of;
    bool irit; /* what IRIT 11 does otherwise: fractions get one degree before
                  a sum, quotients of fractions with one weight lose it */
    ix_frac s, n, g[3], l[3];
} ix_srf_naive;
/* of is kept; its forms must have been filled in (ix__surface_forms). */
ix_status ix__naive_surface(ix_ctx *ctx, const ix_surface *of, bool irit,
                            ix_srf_naive *out) IX_MUST_CHECK;

/* True for the degree forms naive and irit. */
bool ix__naive_wanted(const ix_op_opts *o);

/* Scalars, in the frame of the surface. */
typedef ix_status (*ix__naive_fn)(ix_ctx *ctx, const ix_srf_naive *s,
                                  ix_frac *out);
ix_status ix__naive_k(ix_ctx *ctx, const ix_srf_naive *s,
                      ix_frac *out) IX_MUST_CHECK; /* L11 L22 - L12^2 */
ix_status ix__naive_h(ix_ctx *ctx, const ix_srf_naive *s, ix_frac *out)
    IX_MUST_CHECK; /* G11 L22 + G22 L11 - 2 G12 L12 */
ix_status ix__naive_gauss(ix_ctx *ctx, const ix_srf_naive *s,
                          ix_frac *out) IX_MUST_CHECK;
ix_status ix__naive_mean_sqr(ix_ctx *ctx, const ix_srf_naive *s,
                             ix_frac *out) IX_MUST_CHECK;
ix_status ix__naive_along_u(ix_ctx *ctx, const ix_srf_naive *s,
                            ix_frac *out) IX_MUST_CHECK;
ix_status ix__naive_along_v(ix_ctx *ctx, const ix_srf_naive *s,
                            ix_frac *out) IX_MUST_CHECK;
ix_status ix__naive_total(ix_ctx *ctx, const ix_srf_naive *s,
                          ix_frac *out) IX_MUST_CHECK;
/* The coefficients of the third form. */
ix_status ix__naive_third(ix_ctx *ctx, const ix_srf_naive *s,
                          ix_frac out[3]) IX_MUST_CHECK;

/* Places: S + n |G| / h and S + n G_ii / L_ii. */
ix_status ix__naive_evolute(ix_ctx *ctx, const ix_srf_naive *s,
                            ix_frac *out) IX_MUST_CHECK;
ix_status ix__naive_focal(ix_ctx *ctx, const ix_srf_naive *s, int dir,
                          ix_frac *out) IX_MUST_CHECK;

#endif
