/* sym.h - exact algebra on multivariates.
 *
 * Binary operations make the operands compatible first (point type, kind of
 * basis, breakpoints); their domains must agree within 1e-5 of their length,
 * else IX_EARG. Rational operands follow the rules of fractions. The result
 * has the least degree and the highest continuity that the formula itself
 * guarantees: at a breakpoint where the operands are C^c the result of order
 * K gets a knot of multiplicity K - 1 - c (none if c >= K - 1). Bezier
 * operands give a Bezier result; float and periodic ones an open result.
 *
 * Operands are borrowed, results are new references, NULL unless IX_OK. Errors
 * of every function: IX_EARG numbers of directions that differ, IX_EDOMAIN a
 * coefficient of the result is beyond the range of doubles, IX_EUNABLE an
 * order above IX_MAX_ORDER. Large work is shared out to the context's threads;
 * the bits do not depend on their number. */
#ifndef IRITX_SYM_H
#define IRITX_SYM_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Options of the algebra; NULL stands for the defaults {INT_MAX, 0}. */
typedef struct {
    int max_cont; /* cut the continuity of results: 0 gives C0 joins, as IRIT's
                     BspProdMethod 0; INT_MAX keeps what is guaranteed */
    int reserved;
} ix_sym_opts;

/* a + b, a - b. Rational with different weights: common denominator; weights
 * that agree within 1e-5 of the largest are taken to be equal, a's are kept,
 * and a remark says so if they differ by more than rounding. Operands written
 * alike are added point by point and keep their knots. */
ix_status ix_sym_add(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
ix_status ix_sym_sub(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* Coordinate by coordinate product (weights too). */
ix_status ix_sym_mul(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* Every coordinate of a times the scalar s. Err IX_EARG s has more. */
ix_status ix_sym_scale(ix_ctx *ctx, const ix_mv *a, const ix_mv *s,
                       const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* Scalar product; E1 or P1. */
ix_status ix_sym_dot(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* Scalar product with a constant vector v[ncoords of a] (exact, same knots). */
ix_status ix_sym_dot_vector(ix_ctx *ctx, const ix_mv *a, const double *v,
                            ix_mv **out) IX_MUST_CHECK;
/* Vector product, always 3 coordinates; missing coordinates are 0. Err
 * IX_EARG more than 3 coordinates. */
ix_status ix_sym_cross(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                       const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* det(a, b, c) of three vector multivariates with 3 coordinates. Err IX_EARG
 * other numbers of coordinates. */
ix_status ix_sym_triple(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        const ix_mv *c, const ix_sym_opts *o,
                        ix_mv **out) IX_MUST_CHECK;
/* Determinant of n rows, each a polynomial multivariate with n coordinates;
 * sub-minors are shared, so that n = 6 costs 186 products. Err IX_EARG a row
 * is rational or has other coordinates. */
ix_status ix_sym_det(ix_ctx *ctx, int n, const ix_mv *const *rows,
                     const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* The n+1 signed maximal minors of n polynomial rows with n+1 coordinates:
 * (-1)^j det(rows without column j); orthogonal to every row. Err as above. */
ix_status ix_sym_minors(ix_ctx *ctx, int n, const ix_mv *const *rows,
                        const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* Each coordinate of a over the scalar b (a rational result). Err IX_EARG b
 * has more coordinates; IX_EDOMAIN b is zero everywhere. */
ix_status ix_sym_div(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* 1 / a of a scalar, same knots. Err as ix_sym_div. */
ix_status ix_sym_invert(ix_ctx *ctx, const ix_mv *a, ix_mv **out) IX_MUST_CHECK;

/* d/dt in one direction. Polynomials stay in their basis, float ones float
 * (periodic ones become float). Rational: the true derivative
 * (X'W - XW')/W^2, degree 2d for degree d as the quotient rule gives it.
 * Order 1 gives zeros of order 1. */
ix_status ix_sym_derive(ix_ctx *ctx, const ix_mv *a, int dir,
                        const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;
/* Every axis including the weight differentiated by itself. */
ix_status ix_sym_derive_axes(ix_ctx *ctx, const ix_mv *a, int dir,
                             ix_mv **out) IX_MUST_CHECK;
/* Integral from the lower end, first control value 0; polynomial only. */
ix_status ix_sym_integrate(ix_ctx *ctx, const ix_mv *a, int dir,
                           ix_mv **out) IX_MUST_CHECK;

/* f(g1, g2, ...): g holds one scalar coordinate for each direction of f (more
 * are ignored). Degrees: (sum of f's degrees) times g's. f's breakpoints are
 * pulled back for univariate g by splitting g where it crosses them.
 * Err IX_EDOMAIN g leaves f's domain by more than 1e-5 of its length;
 * IX_EARG more than one direction in g and interior knots in f. */
ix_status ix_sym_compose(ix_ctx *ctx, const ix_mv *f, const ix_mv *g,
                         ix_mv **out) IX_MUST_CHECK;

/* What a reduction did. */
typedef struct {
    double change; /* largest relative change of a control value */
    int degrees;   /* by how much all degrees together went down */
    int factors;   /* degree of the common factor divided out */
} ix_reduce_report;
/* The same map in lower degree where that is possible within tol (relative to
 * the largest control value, of weights and of coordinates apart; 0 means
 * 1e-12): vanishing leading coefficients dropped, a factor in one direction
 * that all numerators and the weight have in common divided out (looked for
 * up to degree 160 in that direction), knots that
 * are not needed removed. Every step is checked by undoing it. If there is
 * nothing to do the result is a itself. rep may be NULL. Err IX_EARG tol < 0.
 */
ix_status ix_sym_reduce(ix_ctx *ctx, const ix_mv *a, double tol,
                        ix_reduce_report *rep, ix_mv **out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
