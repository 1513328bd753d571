/* curves_alloc.h - making ix_solution_curves. */
#ifndef SOLVE_CURVES_ALLOC_H
#define SOLVE_CURVES_ALLOC_H

#include "base/ctx.h"
#include "iritx/solve.h"

/* One block for so many numbers, curves and singular points, which
 * ix_solution_curves_free releases: *x, out->curve, out->singular and out->arcs
 * point into it, unset; no counts are set but bytes (0: nothing was asked for).
 */
ix_status ix__solution_curves_alloc(ix_ctx *ctx, size_t numbers, size_t curves,
                                    size_t singular, ix_solution_curves *out,
                                    double **x) IX_MUST_CHECK;

#endif
