/* poly_expr.h - polynomials written as text. */
#ifndef LANG_POLY_EXPR_H
#define LANG_POLY_EXPR_H

#include "mv/mv.h"

/* A polynomial in the letters A, B, C, ... (directions 0, 1, 2, ...; either
 * case) as a scalar multivariate in the monomial basis.
 *
 *   sum    = ["+" | "-"] term {("+" | "-") term}
 *   term   = power {("*" | "/") power}
 *   power  = atom ["^" whole number]
 *   atom   = number | letter | "(" sum ")"
 *
 * In    ndirs   1 .. IX_MAX_DIRS; letters beyond are errors
 * Out   *out    power basis, order = degree + 1 in each direction
 * Err   IX_EARG the text is no such polynomial (the message tells the column
 *               and what stands there), a divisor is not a constant or is 0,
 *               a degree above 1000, more than 1e6 coefficients */
ix_status ix__poly_expr(ix_ctx *ctx, int ndirs, const char *text,
                        ix_mv **out) IX_MUST_CHECK;

#endif
