/* ret_solutions.h - what the solver found as results of functions. */
#ifndef LANG_RET_SOLUTIONS_H
#define LANG_RET_SOLUTIONS_H

#include "iritx/solve.h"
#include "lang/builtin.h"

/* Unless complete, says so. */
void ix__remark_open(ix_call *c, bool complete, size_t boxes);

/* Unknowns first .. first + count - 1 of a solution curve; on m, if given,
 * their point (count is m's directions). */
typedef struct {
    int unknowns, first, count;
    const ix_mv *m;
} ix__unknowns;

/* Whether a solution (of a curve: a vertex in the middle) is wanted. */
typedef ix_status (*ix__keep_solution)(ix_call *c, const double *x, bool *out);

/* Adds one as a curve of order 2. */
ix_status ix__add_solution_curve(ix_call *c, const ix_solution_curve *k,
                                 ix__unknowns v, ix_obj *list) IX_MUST_CHECK;
/* A list of all, v.unknowns is set here; keep may be NULL. Releases them. */
ix_status ix__ret_curves(ix_call *c, ix_solution_curves *s, ix__unknowns v,
                         ix__keep_solution keep) IX_MUST_CHECK;
/* A list of control points. Releases the solutions. */
ix_status ix__ret_points(ix_call *c, ix_solutions *s,
                         ix__keep_solution keep) IX_MUST_CHECK;

#endif
