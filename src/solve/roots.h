/* roots.h - the roots of a piecewise polynomial given span by span; what the
 * operators call with a field they have just computed. */
#ifndef SOLVE_ROOTS_H
#define SOLVE_ROOTS_H

#include "bsp/spans.h"
#include "iritx/solve.h"

/* b[nspans][degree + 1] Bernstein coefficients on sp; band[nspans] bounds
 * their absolute error span by span (a field of a straight span is zero
 * within its band: it is reported as an interval). *roots in scratch. */
ix_status ix__spans_roots(ix_ctx *ctx, const ix_spans *sp, const double *b,
                          const double *band, ix_root **roots,
                          int *n) IX_MUST_CHECK;

#endif
