/* form_roots.h - the roots of a univariate form that an operator has computed,
 * without storing it first. */
#ifndef SOLVE_FORM_ROOTS_H
#define SOLVE_FORM_ROOTS_H

#include "iritx/solve.h"
#include "sym/form.h"

/* Roots of row 0 of f (one direction). scale[nspans] bounds, span by span, the
 * size of the terms that f is a sum of (NULL: f's own coefficients): the error
 * of a coefficient is taken as 8 roundings of that for each degree. *roots in
 * scratch. */
ix_status ix__form_roots(ix_ctx *ctx, const ix_form *f, const double *scale,
                         ix_root **roots, int *n) IX_MUST_CHECK;

/* Largest |Bernstein coefficient| over all rows, span by span: out[nspans]. */
ix_status ix__form_sizes(ix_ctx *ctx, const ix_form *f,
                         double *out) IX_MUST_CHECK;

#endif
