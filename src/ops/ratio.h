/* ratio.h - rational functions as a straightforward system
 * computes them: quotient rule, cross-multiplied sums, no common factor ever
 * removed. This is what the degree forms naive and irit are made of; their
 * degrees come out of this arithmetic. */
#ifndef OPS_RATIO_H
#define OPS_RATIO_H

#include "ops/curve.h"
#include "sym/frac.h"

/* A piecewise rational function has one degree: numerators and denominator are
 * elevated to the larger of both. Does nothing to polynomials. */
ix_status ix__ratio_even(ix_ctx *ctx, ix_frac *f) IX_MUST_CHECK;
/* The curve itself. */
ix_frac ix__ratio_of(const ix_curve *c);
/* A fraction made of a curve. */
typedef ix_status (*ix__curve_frac)(ix_ctx *ctx, const ix_curve *c,
                                    ix_frac *out);
/* For ix__curve_forms: weight and numerators of the fraction that the
 * ix__curve_frac in arg makes. */
ix_status ix__ratio_forms(ix_ctx *ctx, const ix_curve *c, void *arg,
                          ix_form *out) IX_MUST_CHECK;
/* The derivative in direction dir, (X'W - XW') / W^2 of degree 2d in every
 * direction; the derivative of a polynomial. */
ix_status ix__ratio_partial(ix_ctx *ctx, const ix_frac *f, int dir,
                            ix_frac *out) IX_MUST_CHECK;
/* That of a function of one parameter. */
ix_status ix__ratio_derive(ix_ctx *ctx, const ix_frac *f,
                           ix_frac *out) IX_MUST_CHECK;

typedef ix_status (*ix__form_product)(ix_ctx *ctx, const ix_form *a,
                                      const ix_form *b, ix_form *out);
/* Any product of the numerators (ix__form_mul, _dot, _cross, ix__turn) over
 * the product of the denominators. */
ix_status ix__ratio_product(ix_ctx *ctx, ix__form_product product,
                            const ix_frac *a, const ix_frac *b,
                            ix_frac *out) IX_MUST_CHECK;
/* a over the scalar b. */
ix_status ix__ratio_over(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                         ix_frac *out) IX_MUST_CHECK;
/* a + sign b; a polynomial numerator counts as over 1. */
ix_status ix__ratio_add(ix_ctx *ctx, const ix_frac *a, int sign,
                        const ix_frac *b, ix_frac *out) IX_MUST_CHECK;

/* Both over one denominator, the product of theirs (1 if there is none). */
ix_status ix__ratio_common(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                           ix_form *xa, ix_form *xb, ix_form *w) IX_MUST_CHECK;
/* The same, but terms that have one weight, which are those of a determinant,
 * keep it: a straightforward system notices that, and nothing else. */
ix_status ix__ratio_sum(ix_ctx *ctx, const ix_frac *a, int sign,
                        const ix_frac *b, ix_frac *out) IX_MUST_CHECK;
/* True if both have one weight, up to rounding. */
bool ix__ratio_alike(const ix_frac *a, const ix_frac *b);

/* det(a, b) of rows 0 and 1. */
ix_status ix__form_det2(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                        ix_form *out) IX_MUST_CHECK;
/* The scalar a times b turned by +90 degrees: (-a b_1, a b_0). */
ix_status ix__form_turned(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                          ix_form *out) IX_MUST_CHECK;

#endif
