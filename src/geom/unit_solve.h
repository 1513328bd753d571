/* unit_solve.h - systems in the parameters of several freeforms, each brought
 * to [0, 1] first, where constant directions have their domain. */
#ifndef GEOM_UNIT_SOLVE_H
#define GEOM_UNIT_SOLVE_H

#include "geom/vecs.h"
#include "iritx/solve.h"

/* m, not in power basis, with all domains [0, 1]. */
const ix_mv *ix__pool_unit(ix_pool *q, const ix_mv *m);
/* The linear function from dom[0] to dom[1] over unknown `at` of n. */
const ix_mv *ix__pool_linear(ix_pool *q, const double dom[2], int n, int at);

/* All solutions of f[neq] = 0 (NULL ones hold everywhere: IX_EDOMAIN) in the
 * domains dom[unknowns]; more equations than unknowns are checks. Releases the
 * pool, whatever happened to it before. */
ix_status ix__unit_solve(ix_pool *q, int neq, const ix_mv *const *f,
                         const double (*dom)[2], const ix_solve_opts *o,
                         ix_solutions *out) IX_MUST_CHECK;

/* The same for unknowns - 1 equations: curves; their vertices are in dom, what
 * is singular stays in [0, 1]. */
ix_status ix__unit_curves(ix_pool *q, int neq, const ix_mv *const *f,
                          const double (*dom)[2], const ix_curves_opts *o,
                          ix_solution_curves *out) IX_MUST_CHECK;

#endif
